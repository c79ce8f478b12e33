/* SPDX-License-Identifier: MIT
 *
 * Any thread may call any function at any time. Threads that start together make the very first
 * calls of a process, many processes over; then threads select instruction sets while others
 * sample. All must always get the same bits. It also runs under ThreadSanitizer.
 */
#if !defined(_WIN32)
#define _POSIX_C_SOURCE 200809L
#include <sys/wait.h>
#include <unistd.h>
#define PROCESSES 32
#else
#define PROCESSES 1 /* no fork: only this process can be a fresh one */
#endif

#include <pthread.h>
#include <sched.h>
#include <stdatomic.h>

#include "outputs.h"

#define THREADS 8
#define POINTS 45

static float x32[3][POINTS];
static double x64[3][POINTS];
static const struct inputs in = {{x32[0], x32[1], x32[2]}, {x64[0], x64[1], x64[2]}};

static struct scarp_plan plans[2]; /* which all threads share; zeros at first */
static struct scarp_recipe recipe; /* likewise; */
static uint64_t recipe_plan[2048]; /* and its plan */
static atomic_int waiting;         /* threads that have yet to arrive */
static atomic_int sampling;        /* threads that have yet to finish sampling */
static atomic_int disagreeing;     /* hashes that were not `agreed` */
static uint64_t agreed;

struct worker {
    pthread_t thread;
    int number;
    enum scarp_isa isa;
    uint64_t hash;
};

/* Waits until all threads have arrived. */
static void start_together(void)
{
    atomic_fetch_sub(&waiting, 1);
    while (atomic_load(&waiting) > 0) {
        sched_yield();
    }
}

/* Adds samples of the recipe, if there is one. */
static uint64_t sample_recipe(uint64_t hash, const struct outputs *o)
{
    const struct scarp_samples out = outputs_subset(o, OUTPUTS_ALL2 & ~OUTPUTS_PHASE);
    const struct scarp_recipe_outputs outputs = {.out = &out, .count = 1};
    const struct scarp_scratch scratch = {.plan = recipe_plan};
    if (recipe.first != 0 && scarp_recipe_sample(&recipe, POINTS, in.f[0], in.f[1], NULL, &outputs,
                                                 &scratch) != SCARP_OK) {
        atomic_fetch_add(&disagreeing, 1);
    }
    return outputs_hash(hash, o, OUTPUTS_ALL2 & ~OUTPUTS_PHASE, POINTS);
}

static uint64_t sample_all(uint64_t seed)
{
    struct outputs o = outputs_make(POINTS);
    uint64_t hash = FNV_BASIS;
    for (int i = 0; i < FUNCTIONS; i++) {
        const enum function f = (enum function)i;
        struct scarp_noise noise = {.octaves = 2.0f, .seed = seed};
        noise.plan = &plans[function_dimensions(f) - 2];
        const struct scarp_samples out = outputs_subset(&o, function_outputs(f));
        if (function_call(f, &noise, POINTS, &in, &out) != SCARP_OK) {
            atomic_fetch_add(&disagreeing, 1);
        }
        hash = outputs_hash(hash, &o, function_outputs(f), POINTS);
    }
    hash = sample_recipe(hash, &o);
    outputs_free(&o);
    return hash;
}

static void start(struct worker *workers, void *(*work)(void *))
{
    atomic_store(&waiting, THREADS);
    for (int i = 0; i < THREADS; i++) {
        workers[i].number = i;
        if (pthread_create(&workers[i].thread, NULL, work, &workers[i]) != 0) {
            printf("cannot start a thread\n");
            exit(EXIT_FAILURE);
        }
    }
}

static void join(struct worker *workers)
{
    for (int i = 0; i < THREADS; i++) {
        pthread_join(workers[i].thread, NULL);
    }
}

/* The first call of half of the threads is a sample call, of the others scarp_isa_active. */
static void *first_call(void *argument)
{
    struct worker *const w = argument;
    start_together();
    if (w->number % 2 == 0) {
        w->hash = sample_all(0);
        w->isa = scarp_isa_active();
    } else {
        w->isa = scarp_isa_active();
        w->hash = sample_all(0);
    }
    return NULL;
}

/* Must run in a process that has called nothing of the library yet. */
static int race_first_call(void)
{
    struct worker workers[THREADS];
    start(workers, first_call);
    join(workers);
    for (int i = 0; i < THREADS; i++) {
        CHECK(workers[i].hash == workers[0].hash, "thread %d got other bits", i);
        CHECK(workers[i].isa == scarp_isa_active(), "thread %d saw %s", i,
              scarp_isa_name(workers[i].isa));
    }
    CHECK(workers[0].hash == sample_all(0), "the threads got other bits than later calls");
    return check_failures == 0;
}

static void test_first_call(void)
{
#if defined(_WIN32)
    race_first_call();
#else
    for (int i = 0; i < PROCESSES; i++) {
        fflush(stdout);
        const pid_t child = fork();
        if (child == 0) {
            const int good = race_first_call();
            fflush(stdout);
            _exit(good ? EXIT_SUCCESS : EXIT_FAILURE);
        }
        int status = -1;
        CHECK(child > 0 && waitpid(child, &status, 0) == child, "cannot fork");
        CHECK(WIFEXITED(status) && WEXITSTATUS(status) == EXIT_SUCCESS, "process %d failed", i);
    }
#endif
}

#define ROUNDS 400

/* Two threads select, the others sample until they have done enough. */
static void *select_or_sample(void *argument)
{
    const struct worker *const w = argument;
    start_together();
    if (w->number >= 2) {
        for (int i = 0; i < ROUNDS; i++) {
            if (sample_all(1) != agreed) {
                atomic_fetch_add(&disagreeing, 1);
            }
        }
        atomic_fetch_sub(&sampling, 1);
        return NULL;
    }
    const int isas = check_isa_count();
    for (int i = w->number; atomic_load(&sampling) > 0; i++) {
        const enum scarp_isa isa = (enum scarp_isa)(i % isas);
        const enum scarp_status expected =
            isa == SCARP_ISA_NONE || scarp_isa_supported(isa) ? SCARP_OK : SCARP_ERROR_UNSUPPORTED;
        if (scarp_isa_select(isa) != expected || !scarp_isa_supported(scarp_isa_active())) {
            atomic_fetch_add(&disagreeing, 1);
        }
        sched_yield();
    }
    return NULL;
}

static void test_selecting(void)
{
    static const char text[] =
        "recipe 1\na = warp(noise(octaves=3), noise(amplitude=0.4)) * noise(value, seed=1)";
    struct worker workers[THREADS];
    CHECK(scarp_recipe_parse(text, strlen(text), &recipe, NULL, 0, NULL) == SCARP_OK, "%s", text);
    agreed = sample_all(1);
    for (int dimensions = 2; dimensions <= 3; dimensions++) {
        const struct scarp_noise noise = {.octaves = 2.0f, .seed = 1};
        CHECK(scarp_plan_make(&noise, dimensions, &plans[dimensions - 2]) == SCARP_OK, "no plan");
    }
    CHECK(scarp_recipe_plan_make(&recipe, recipe_plan, sizeof recipe_plan) == SCARP_OK, "no plan");
    CHECK(sample_all(1) == agreed, "plans give other bits");
    atomic_store(&sampling, THREADS - 2);
    start(workers, select_or_sample);
    join(workers);
    CHECK(atomic_load(&disagreeing) == 0, "%d calls failed or gave other bits",
          atomic_load(&disagreeing));
}

int main(void)
{
    uint64_t state = 1;
    for (int i = 0; i < 3 * POINTS; i++) {
        x32[i % 3][i / 3] = check_random_float(&state, 64.0f);
        x64[i % 3][i / 3] = check_random_double(&state, 0x1p20);
    }
    test_first_call();
    test_selecting();
    return check_done();
}
