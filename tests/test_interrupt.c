/* SPDX-License-Identifier: MIT
 *
 * The program's signal handlers (src/cli/shared/interrupt.c): a signal that comes just before a
 * call that would wait for ever ends that call, whatever became of alarms before the program was
 * started. A call that fails though it cannot stops the program, too.
 */
#include <errno.h>
#include <signal.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#include "check.h"
#include "shared/interrupt.h"

#define PATIENCE 20 /* seconds */

static void default_alarms(void)
{
    signal(SIGALRM, SIG_DFL);
}

static void ignore_alarms(void)
{
    signal(SIGALRM, SIG_IGN);
}

static void block_alarms(void)
{
    sigset_t alarms;
    sigemptyset(&alarms);
    sigaddset(&alarms, SIGALRM);
    sigprocmask(SIG_BLOCK, &alarms, NULL);
}

/* The process calls `prepare`, then waits twice for a pipe that nobody writes to. */
static void late_signal(void (*prepare)(void))
{
    int ends[2];
    char byte;
    prepare();
    interrupt_install();
    if (pipe(ends) != 0 || interrupted()) {
        _exit(1);
    }
    raise(SIGINT);
    for (int i = 0; i < 2; i++) {
        if (read(ends[0], &byte, 1) >= 0 || errno != EINTR || !interrupted()) {
            _exit(2);
        }
    }
    interrupt_end();
    _exit(3);
}

/* Runs late_signal in a process. Returns its wait status, or -1 if it has to be killed. */
static int run(void (*prepare)(void))
{
    const pid_t child = fork();
    if (child == 0) {
        late_signal(prepare);
    }
    const struct timespec pause = {.tv_nsec = 10000000};
    for (int i = 0; child > 0 && i < PATIENCE * 100; i++) {
        int status;
        if (waitpid(child, &status, WNOHANG) == child) {
            return status;
        }
        nanosleep(&pause, NULL);
    }
    if (child > 0) {
        kill(child, SIGKILL);
        waitpid(child, NULL, 0);
    }
    return -1;
}

int main(void)
{
    static void (*const prepare[])(void) = {default_alarms, ignore_alarms, block_alarms};
    for (int i = 0; i < 3; i++) {
        const int status = run(prepare[i]);
        CHECK(status != -1 && WIFSIGNALED(status) && WTERMSIG(status) == SIGINT,
              "preparation %d: status %d", i, status);
    }
    interrupt_unless(true);
    CHECK(!interrupted(), "nothing has failed yet");
    interrupt_unless(false);
    CHECK(interrupted(), "a call has failed");
    return check_done();
}
