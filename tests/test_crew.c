/* SPDX-License-Identifier: MIT
 *
 * The program's crew of threads (src/cli/shared/crew.c): whichever threads the system refuses, all
 * work is done, each task once, and nobody leaves a meeting before all are there. It also runs
 * under ThreadSanitizer.
 */
#define _GNU_SOURCE /* as crew.c has it */

#include <errno.h>
#include <pthread.h>

/* The system refuses a thread when `starts_left` is 0. */
static int starts_left;
static int start_or_refuse(pthread_t *thread, const pthread_attr_t *attributes,
                           void *(*start)(void *), void *argument)
{
    if (starts_left == 0) {
        return EAGAIN;
    }
    starts_left--;
    return pthread_create(thread, attributes, start, argument);
}

#define pthread_create start_or_refuse
#include "../src/cli/shared/crew.c"
#undef pthread_create

#include "../src/cli/shared/bounds.h"
#include "check.h"

#define MOST 9
#define MEETINGS 20
#define TASKS 50
#define STACK_USED STACK_NEEDED

struct job {
    struct crew *crew;
    size_t expected;                 /* threads */
    atomic_int calls[MOST];          /* of `work`, by number */
    atomic_int tasks[TASKS];         /* how often each was done since the last meeting */
    atomic_int wrong_meetings;       /* threads that left one too early or too late */
    atomic_int wrong_signals, wrong; /* what else went wrong */
    atomic_size_t arrived;
    int meetings; /* written by one thread while all others wait */
};

static void at_meeting(void *context)
{
    struct job *const job = context;
    if (atomic_exchange(&job->arrived, 0) != job->expected) {
        atomic_fetch_add(&job->wrong_meetings, 1);
    }
    for (int i = 0; i < TASKS; i++) {
        if (atomic_exchange(&job->tasks[i], 0) != 1) {
            atomic_fetch_add(&job->wrong, 1);
        }
    }
    job->meetings++;
}

static int is_blocked(int number)
{
    sigset_t blocked;
    pthread_sigmask(SIG_BLOCK, NULL, &blocked);
    return sigismember(&blocked, number);
}

static void use_stack(void)
{
    volatile char bytes[STACK_USED];
    for (size_t i = STACK_USED; i > 0; i -= 1024) {
        bytes[i - 1] = 0;
    }
    (void)bytes;
}

static void work(void *context, size_t number)
{
    struct job *const job = context;
    atomic_fetch_add(&job->calls[number], 1);
    use_stack();
    const int is_worker = number != 0;
    if (is_blocked(SIGTERM) != is_worker || is_blocked(SIGALRM) != is_worker ||
        is_blocked(SIGUSR1) != is_worker || is_blocked(SIGSEGV)) {
        atomic_fetch_add(&job->wrong_signals, 1);
    }
    for (int i = 0; i < MEETINGS; i++) {
        for (size_t n; (n = crew_next(job->crew)) < TASKS;) {
            atomic_fetch_add(&job->tasks[n], 1);
        }
        atomic_fetch_add(&job->arrived, 1);
        crew_meet(job->crew, at_meeting);
        if (job->meetings != i + 1) {
            atomic_fetch_add(&job->wrong_meetings, 1);
        }
    }
}

/* Asks for `count` threads, and checks the work of the `expected` ones that there are. */
static void run(struct crew *crew, size_t count, size_t expected)
{
    struct job job = {.crew = crew, .expected = expected};
    crew_run(crew, count, work, &job);
    for (size_t i = 0; i < MOST; i++) {
        const int calls = atomic_load(&job.calls[i]);
        CHECK(calls == (i < expected ? 1 : 0), "%zu of %zu threads: number %zu was called %d times",
              expected, count, i, calls);
    }
    CHECK(job.meetings == MEETINGS, "%d meetings", job.meetings);
    CHECK(atomic_load(&job.wrong_meetings) == 0, "%d threads", atomic_load(&job.wrong_meetings));
    CHECK(atomic_load(&job.wrong_signals) == 0, "%d threads", atomic_load(&job.wrong_signals));
    CHECK(atomic_load(&job.wrong) == 0, "%d tasks", atomic_load(&job.wrong));
}

/* Refuses threads from each one on, for crews of each size and work for each number of threads. */
static void test_refused(void)
{
    for (size_t most = 1; most <= MOST; most++) {
        for (size_t count = 1; count <= MOST; count++) {
            for (size_t starts = 0; starts <= MOST; starts += 1 + starts / 3) {
                struct crew *const crew = crew_open(most);
                const size_t expected = 1 + smaller(smaller(most, count) - 1, starts);
                CHECK(crew != NULL && crew_most(crew) == most && crew_size(crew) == 0, "%zu", most);
                starts_left = (int)starts;
                run(crew, count, expected);
                CHECK(crew_size(crew) == expected, "%zu of %zu", crew_size(crew), expected);
                crew_close(crew);
            }
        }
    }
}

/* The same threads work again; those that were refused may come later. */
static void test_again(void)
{
    struct crew *const crew = crew_open(MOST);
    starts_left = 2;
    run(crew, MOST, 3);
    run(crew, 2, 2);
    CHECK(crew_size(crew) == 3, "%zu", crew_size(crew));
    starts_left = MOST;
    for (size_t i = 0; i < 300; i++) {
        run(crew, 1 + i % MOST, 1 + i % MOST);
    }
    CHECK(starts_left == 3, "%d starts left", starts_left);
    CHECK(crew_size(crew) == MOST, "%zu", crew_size(crew));
    crew_close(crew);
}

struct aside {
    atomic_int calls, open;   /* the call waits until `open` is set */
    atomic_int wrong_signals; /* calls in a thread that signals reach */
    int is_here;              /* whether the call is in the caller's thread */
    pthread_t caller;
};

static void do_one_thing(void *context)
{
    struct aside *const aside = context;
    aside->is_here = pthread_equal(pthread_self(), aside->caller) != 0;
    while (!aside->is_here && !atomic_load(&aside->open)) {
        sched_yield();
    }
    if (!aside->is_here && !is_blocked(SIGTERM)) {
        atomic_fetch_add(&aside->wrong_signals, 1);
    }
    atomic_fetch_add(&aside->calls, 1);
}

/* A call goes on beside the caller, or at once where the system refuses a thread; it is over when
   the next one begins, after a wait, and when the crew is closed. */
static void test_aside(void)
{
    struct crew *crew = crew_open(1);
    struct aside aside = {.caller = pthread_self()};
    starts_left = 1;
    crew_start_aside(crew, do_one_thing, &aside);
    CHECK(atomic_load(&aside.calls) == 0, "%d calls", atomic_load(&aside.calls));
    atomic_store(&aside.open, 1);
    crew_wait_aside(crew);
    CHECK(atomic_load(&aside.calls) == 1 && !aside.is_here, "%d calls", atomic_load(&aside.calls));
    crew_start_aside(crew, do_one_thing, &aside); /* refused */
    CHECK(atomic_load(&aside.calls) == 2 && aside.is_here, "%d calls", atomic_load(&aside.calls));
    starts_left = 2;
    crew_start_aside(crew, do_one_thing, &aside);
    crew_start_aside(crew, do_one_thing, &aside);
    CHECK(atomic_load(&aside.calls) >= 3, "%d calls", atomic_load(&aside.calls));
    crew_close(crew);
    CHECK(atomic_load(&aside.calls) == 4 && starts_left == 0, "%d calls",
          atomic_load(&aside.calls));
    CHECK(atomic_load(&aside.wrong_signals) == 0, "%d calls", atomic_load(&aside.wrong_signals));
}

int main(void)
{
    const size_t processors = crew_processors();
    CHECK(processors >= 1 && processors <= THREADS_MAX, "%zu", processors);
    test_refused();
    test_again();
    test_aside();
    crew_close(NULL);
    return check_done();
}
