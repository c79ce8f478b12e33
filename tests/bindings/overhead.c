/* SPDX-License-Identifier: MIT
 *
 * Times calls from C, in nanoseconds: what Overhead.cs times from C#. The fastest of 21 rounds
 * counts. It is no test: cmake --build build --target bindings_overhead
 */
#include <scarp.h>
#include <stdio.h>
#include <stdlib.h>
#include <time.h>

static float x[4096], y[4096], value[1 << 20];

static double now(void)
{
    struct timespec t;
    timespec_get(&t, TIME_UTC);
    return (double)t.tv_sec * 1e9 + (double)t.tv_nsec;
}

static void need(enum scarp_status status)
{
    if (status != SCARP_OK) {
        fprintf(stderr, "%s\n", scarp_status_text(status));
        exit(EXIT_FAILURE);
    }
}

static void tell(const char *name, const struct scarp_noise *noise, int calls, size_t count)
{
    const struct scarp_samples to = {.value = value};
    const struct scarp_grid grid = {.step = {0.01, 0.01}, .count = {1024, 1024}};
    double best = 1e18;
    for (int round = 0; round < 21; round++) {
        const double start = now();
        for (int i = 0; i < calls; i++) {
            const int at = count == 1 ? i & 4095 : 0;
            need(count == 0 ? scarp_grid2(noise, &grid, &to)
                            : scarp_sample2(noise, count, x + at, y + at, &to));
        }
        const double each = (now() - start) / calls;
        best = each < best ? each : best;
    }
    printf("%s %.0f\n", name, best);
}

int main(void)
{
    static struct scarp_plan plan;
    const struct scarp_noise noise = {.octaves = 4};
    struct scarp_noise planned = noise;
    need(scarp_plan_make(&planned, 2, &plan));
    planned.plan = &plan;
    for (int i = 0; i < 4096; i++) {
        x[i] = (float)i * 0.37f;
        y[i] = (float)i * 0.73f;
    }
    tell("1 point, no plan", &noise, 20000, 1);
    tell("1 point, plan", &planned, 20000, 1);
    tell("4096 points", &planned, 50, 4096);
    tell("grid of 1024 x 1024", &planned, 1, 0);
    return EXIT_SUCCESS;
}
