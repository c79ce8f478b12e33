/* SPDX-License-Identifier: MIT
 *
 * A crew of threads that do one piece of work together. If the system refuses a thread, the others
 * do its work: the caller's own is always there. Without POSIX threads it is the only one. Signals
 * go to the caller's thread.
 */
#ifndef SCARP_CLI_CREW_H
#define SCARP_CLI_CREW_H

#include <stddef.h>

#define THREADS_MAX 1024

struct crew;

/* How many processors this process may use: 1 to THREADS_MAX, and 1 without POSIX threads. */
size_t crew_processors(void);

/* A crew of at most `most` threads, the caller's included. Workers are started when there is work
   for them. NULL without memory. */
struct crew *crew_open(size_t most);

size_t crew_most(const struct crew *crew);

/* How many threads worked at a time, at most, so far */
size_t crew_size(const struct crew *crew);

/* Calls `work` in as many of `count` threads as can be had, in each with `context` and a number of
   its own below `count`, which in the caller's thread is 0. Returns when all calls have. */
void crew_run(struct crew *crew, size_t count, void (*work)(void *context, size_t number),
              void *context);

/* For `work`: counts tasks from 0. No two calls get the same one until the next meeting. */
size_t crew_next(struct crew *crew);

/* For `work`: waits until all threads are here. One of them then calls `alone` with the context of
   the work while the others wait on, and tasks are counted from 0 again. */
void crew_meet(struct crew *crew, void (*alone)(void *context));

/* Calls `work` with `context` while the caller does what comes next, in one more thread, or at once
   where none can be had. Waits for the call before, if that still goes on. `work` must end by
   itself: signals do not reach it. */
void crew_start_aside(struct crew *crew, void (*work)(void *context), void *context);

/* Returns when that call has. */
void crew_wait_aside(struct crew *crew);

/* Ends the threads, after what is done aside. NULL does nothing. */
void crew_close(struct crew *crew);

#endif
