/* SPDX-License-Identifier: MIT
 *
 * Signal handlers remember the signal, and make sure that no call waits for ever.
 */
#include "shared/interrupt.h"

#include <signal.h>
#include <stdatomic.h>
#include <stddef.h>
#ifdef _WIN32
#include <windows.h>
#else
#include <unistd.h>
#endif

#include "shared/error.h"

static atomic_int requested; /* number of the signal; all threads look at it */
static atomic_bool has_failed;

#ifdef _WIN32
static HANDLE first_thread;

#define ALARM 1000 /* milliseconds */

/* Ends a write of the first thread that waits, as often as there is one. */
static DWORD WINAPI end_waits(void *unused)
{
    (void)unused;
    while (requested != 0) {
        Sleep(ALARM);
        CancelSynchronousIo(first_thread);
    }
    return 0;
}

/* The system calls this in a thread of its own: for Ctrl-C and Ctrl-Break, of which the second one
   ends the program at once, and when the console is closed or the user logs off. Then the program
   is ended as soon as this returns. */
static BOOL WINAPI remember(DWORD event)
{
    const bool is_key = event == CTRL_C_EVENT || event == CTRL_BREAK_EVENT;
    if (atomic_exchange(&requested, SIGINT) != 0 && is_key) {
        return FALSE;
    }
    const HANDLE thread = CreateThread(NULL, 0, end_waits, NULL, 0, NULL);
    if (thread != NULL) {
        CloseHandle(thread);
    }
    if (!is_key) {
        Sleep(INFINITE);
    }
    return TRUE;
}

void interrupt_install(void)
{
    const HANDLE process = GetCurrentProcess();
    if (DuplicateHandle(process, GetCurrentThread(), process, &first_thread, 0, FALSE,
                        DUPLICATE_SAME_ACCESS)) {
        SetConsoleCtrlHandler(remember, TRUE);
    }
}

void interrupt_end(void)
{
    if (requested != 0) {
        ExitProcess((UINT)CONTROL_C_EXIT); /* as the system does it */
    }
}
#else
static volatile sig_atomic_t ignores_alarm; /* asked to, when the program was started */

/* The signal may come just before a write that then waits for ever: an alarm ends that wait, and
   sets the next one, for whatever waits after it. */
static void remember(int number)
{
    if (requested == 0 && !(number == SIGALRM && ignores_alarm)) {
        requested = number;
    }
    if (requested != 0) {
        alarm(1);
    }
}

static bool is_ignored(int number)
{
    struct sigaction action;
    return sigaction(number, NULL, &action) == 0 && action.sa_handler == SIG_IGN;
}

/* A write that waits, into a pipe for instance, must not be taken up again: no SA_RESTART. */
static void handle(int number)
{
    struct sigaction action = {.sa_handler = remember};
    sigemptyset(&action.sa_mask);
    sigaction(number, &action, NULL);
}

/* What is ignored already, as by nohup, stays so. */
static void watch(int number)
{
    if (!is_ignored(number)) {
        handle(number);
    }
}

/* Alarms are needed whatever became of them; they are no request to stop if they were ignored. */
static void watch_alarm(void)
{
    sigset_t alarms;
    ignores_alarm = is_ignored(SIGALRM);
    handle(SIGALRM);
    sigemptyset(&alarms);
    sigaddset(&alarms, SIGALRM);
    sigprocmask(SIG_UNBLOCK, &alarms, NULL);
}

void interrupt_install(void)
{
    watch(SIGINT);
    watch(SIGTERM);
    /* Batch systems send the last three before they kill: at the end of what a job may take. */
    static const int more[] = {SIGHUP, SIGQUIT, SIGUSR1, SIGUSR2, SIGXCPU};
    for (size_t i = 0; i < sizeof more / sizeof more[0]; i++) {
        watch(more[i]);
    }
    watch_alarm();
#ifdef SIGPIPE
    signal(SIGPIPE, SIG_IGN);
#endif
#ifdef SIGXFSZ
    signal(SIGXFSZ, SIG_IGN);
#endif
}

void interrupt_end(void)
{
    if (requested != 0) {
        signal(requested, SIG_DFL);
        raise(requested);
    }
}
#endif

bool interrupted(void)
{
    return requested != 0 || has_failed;
}

void interrupt_unless(bool is_done)
{
    if (!is_done && !atomic_exchange(&has_failed, true)) {
        cli_error("the library refused a call that it must not refuse; please report this");
    }
}
