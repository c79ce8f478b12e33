/* SPDX-License-Identifier: MIT
 *
 * The crew, with POSIX threads and without them. Workers stay until the crew is closed: a farm's
 * run has thousands of tiles, each of which takes milliseconds.
 */
#if defined(__linux__) && !defined(_GNU_SOURCE)
#define _GNU_SOURCE /* for sched_getaffinity */
#endif

#include "shared/crew.h"

#include <stdatomic.h>
#include <stdbool.h>
#include <stdlib.h>

#ifdef SCARP_CLI_THREADS
#include <limits.h>
#include <pthread.h>
#include <signal.h>
#include <unistd.h>
#ifdef __linux__
#include <sched.h>
#endif
#ifdef _WIN32
typedef int sigset_t; /* no thread gets signals there */
#endif

#include "shared/stack.h"

/* The system's own default may be too little (musl has 128 KiB) or so much that few threads can be
   had. Tables of the C library and of sanitizers take some of it. */
#define STACK_BYTES (8 * STACK_NEEDED)

struct worker {
    struct crew *crew;
    size_t number;
    size_t works; /* that were announced before it was started */
    pthread_t thread;
};
#endif

struct crew {
    size_t most; /* threads, the caller's included */
    size_t size; /* the most threads that ever worked */
    atomic_size_t next;
    void *context; /* of the work at hand */
#ifdef SCARP_CLI_THREADS
    pthread_t aside; /* while is_aside */
    bool is_aside;
    void (*aside_work)(void *context);
    void *aside_context;
    size_t started;         /* workers, whose numbers count from 1 */
    struct worker *workers; /* room for as many as there may be */
    pthread_mutex_t mutex;  /* for all that follows */
    pthread_cond_t begin;   /* `works` or `ending` has changed */
    pthread_cond_t met;     /* `meetings` has changed */
    void (*work)(void *context, size_t number);
    size_t members;  /* that do the work at hand */
    size_t works;    /* announced so far */
    size_t meetings; /* held so far */
    size_t arrived;  /* at the next one */
    bool ending;
#endif
};

size_t crew_most(const struct crew *crew)
{
    return crew->most;
}

size_t crew_size(const struct crew *crew)
{
    return crew->size;
}

size_t crew_next(struct crew *crew)
{
    return atomic_fetch_add_explicit(&crew->next, 1, memory_order_relaxed);
}

#ifdef SCARP_CLI_THREADS
size_t crew_processors(void)
{
    long count = 0;
#ifdef __linux__
    cpu_set_t sets[16]; /* one is for 1024 processors, fewer than some kernels know */
    if (sched_getaffinity(0, sizeof sets, sets) == 0) {
        count = CPU_COUNT_S(sizeof sets, sets);
    }
#endif
#ifdef _WIN32
    count = pthread_num_processors_np();
#else
    if (count < 1) {
        count = sysconf(_SC_NPROCESSORS_ONLN);
    }
#endif
    return count < 1 ? 1 : count > THREADS_MAX ? THREADS_MAX : (size_t)count;
}

struct crew *crew_open(size_t most)
{
    struct crew *const crew = malloc(sizeof *crew);
    struct worker *const workers = calloc(most, sizeof *workers);
    if (crew == NULL || workers == NULL) {
        free(crew);
        free(workers);
        return NULL;
    }
    *crew = (struct crew){.most = most,
                          .mutex = PTHREAD_MUTEX_INITIALIZER,
                          .begin = PTHREAD_COND_INITIALIZER,
                          .met = PTHREAD_COND_INITIALIZER,
                          .workers = workers};
    atomic_init(&crew->next, 0);
    return crew;
}

/* What a worker does until the crew is closed */
static void *serve(void *argument)
{
    const struct worker *const worker = argument;
    struct crew *const crew = worker->crew;
    size_t works = worker->works;
    pthread_mutex_lock(&crew->mutex);
    for (;;) {
        while (crew->works == works && !crew->ending) {
            pthread_cond_wait(&crew->begin, &crew->mutex);
        }
        if (crew->ending) {
            break;
        }
        works = crew->works;
        if (worker->number < crew->members) {
            pthread_mutex_unlock(&crew->mutex);
            crew->work(crew->context, worker->number);
            crew_meet(crew, NULL);
            pthread_mutex_lock(&crew->mutex);
        }
    }
    pthread_mutex_unlock(&crew->mutex);
    return NULL;
}

#ifdef _WIN32
static size_t least_stack(void)
{
    return 0;
}

static bool block_signals(sigset_t *before)
{
    *before = 0;
    return true;
}

static void unblock_signals(const sigset_t *before)
{
    (void)before;
}
#else
static size_t least_stack(void)
{
    const long least = sysconf(_SC_THREAD_STACK_MIN);
    return least > 0 ? (size_t)least : 0;
}

/* Blocks every signal but those that tell of a thread's own mistake. */
static bool block_signals(sigset_t *before)
{
    static const int own[] = {SIGSEGV, SIGBUS, SIGILL, SIGFPE, SIGABRT, SIGTRAP, SIGSYS};
    sigset_t blocked;
    sigfillset(&blocked);
    for (size_t i = 0; i < sizeof own / sizeof own[0]; i++) {
        sigdelset(&blocked, own[i]);
    }
    return pthread_sigmask(SIG_BLOCK, &blocked, before) == 0;
}

static void unblock_signals(const sigset_t *before)
{
    pthread_sigmask(SIG_SETMASK, before, NULL);
}
#endif

/* Starts a thread, which inherits what is blocked. */
static bool start_thread(pthread_t *thread, void *(*function)(void *argument), void *argument)
{
    const size_t least = least_stack(), stack = least > STACK_BYTES ? least : STACK_BYTES;
    pthread_attr_t attributes;
    sigset_t before;
    if (pthread_attr_init(&attributes) != 0) {
        return false;
    }
    bool is_started = false;
    if (pthread_attr_setstacksize(&attributes, stack) == 0 && block_signals(&before)) {
        is_started = pthread_create(thread, &attributes, function, argument) == 0;
        unblock_signals(&before);
    }
    pthread_attr_destroy(&attributes);
    return is_started;
}

/* Starts workers until there are `wanted`, or until the system refuses one. */
static void start_workers(struct crew *crew, size_t wanted)
{
    while (crew->started < wanted) {
        struct worker *const worker = &crew->workers[crew->started];
        *worker = (struct worker){.crew = crew, .number = crew->started + 1, .works = crew->works};
        if (!start_thread(&worker->thread, serve, worker)) {
            return;
        }
        crew->started++;
    }
}

static void *do_aside(void *argument)
{
    const struct crew *const crew = argument;
    crew->aside_work(crew->aside_context);
    return NULL;
}

void crew_start_aside(struct crew *crew, void (*work)(void *context), void *context)
{
    crew_wait_aside(crew);
    crew->aside_work = work;
    crew->aside_context = context;
    crew->is_aside = start_thread(&crew->aside, do_aside, crew);
    if (!crew->is_aside) {
        work(context);
    }
}

void crew_wait_aside(struct crew *crew)
{
    if (crew->is_aside) {
        pthread_join(crew->aside, NULL);
    }
    crew->is_aside = false;
}

void crew_run(struct crew *crew, size_t count, void (*work)(void *context, size_t number),
              void *context)
{
    const size_t most = count < crew->most ? count : crew->most;
    start_workers(crew, most - 1);
    pthread_mutex_lock(&crew->mutex);
    crew->members = most <= crew->started ? most : crew->started + 1;
    crew->size = crew->size < crew->members ? crew->members : crew->size;
    crew->work = work;
    crew->context = context;
    atomic_store_explicit(&crew->next, 0, memory_order_relaxed);
    crew->works++;
    pthread_cond_broadcast(&crew->begin);
    pthread_mutex_unlock(&crew->mutex);
    work(context, 0);
    crew_meet(crew, NULL);
}

void crew_meet(struct crew *crew, void (*alone)(void *context))
{
    pthread_mutex_lock(&crew->mutex);
    const size_t meetings = crew->meetings;
    crew->arrived++;
    if (crew->arrived == crew->members) {
        crew->arrived = 0;
        atomic_store_explicit(&crew->next, 0, memory_order_relaxed);
        if (alone != NULL) {
            alone(crew->context);
        }
        crew->meetings++;
        pthread_cond_broadcast(&crew->met);
    }
    while (crew->meetings == meetings) {
        pthread_cond_wait(&crew->met, &crew->mutex);
    }
    pthread_mutex_unlock(&crew->mutex);
}

void crew_close(struct crew *crew)
{
    if (crew == NULL) {
        return;
    }
    crew_wait_aside(crew);
    pthread_mutex_lock(&crew->mutex);
    crew->ending = true;
    pthread_cond_broadcast(&crew->begin);
    pthread_mutex_unlock(&crew->mutex);
    for (size_t i = 0; i < crew->started; i++) {
        pthread_join(crew->workers[i].thread, NULL);
    }
    free(crew->workers);
    free(crew);
}
#else
size_t crew_processors(void)
{
    return 1;
}

struct crew *crew_open(size_t most)
{
    struct crew *const crew = malloc(sizeof *crew);
    if (crew != NULL) {
        *crew = (struct crew){.most = most};
        atomic_init(&crew->next, 0);
    }
    return crew;
}

void crew_run(struct crew *crew, size_t count, void (*work)(void *context, size_t number),
              void *context)
{
    (void)count;
    crew->size = 1;
    crew->context = context;
    atomic_store_explicit(&crew->next, 0, memory_order_relaxed);
    work(context, 0);
}

void crew_meet(struct crew *crew, void (*alone)(void *context))
{
    atomic_store_explicit(&crew->next, 0, memory_order_relaxed);
    if (alone != NULL) {
        alone(crew->context);
    }
}

void crew_start_aside(struct crew *crew, void (*work)(void *context), void *context)
{
    (void)crew;
    work(context);
}

void crew_wait_aside(struct crew *crew)
{
    (void)crew;
}

void crew_close(struct crew *crew)
{
    free(crew);
}
#endif
