/* SPDX-License-Identifier: MIT
 *
 * How each workload is run, by scarp and by its peers. All read the same points and write to the
 * same arrays, on the thread that calls.
 */
#include "subject.h"

#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "differences.h"
#include "recipes.h"

/* Keeps the compiler from dropping work whose result nobody reads. */
static volatile uint32_t consumed;

static int is_recipe(const struct bench_work *work)
{
    return work->layout == BENCH_RECIPE || work->layout == BENCH_RECIPE_GRID;
}

static int make_scarp(struct bench_subject *subject, const struct bench_work *work)
{
    subject->noise = bench_work_noise(work);
    if (!scarp_isa_supported(subject->isa)) {
        return 0;
    }
    if (is_recipe(work)) {
        subject->state = bench_recipe_make(work, subject->scratch);
        return subject->state != NULL;
    }
    if (work->points <= BENCH_FEW_POINTS) {
        struct scarp_plan *const plan = malloc(sizeof *plan);
        if (plan != NULL && scarp_plan_make(&subject->noise, work->dimensions, plan) == SCARP_OK) {
            subject->noise.plan = plan;
        }
        subject->state = plan;
        return subject->noise.plan != NULL;
    }
    return 1;
}

/* The nearest that a peer has to a workload with a title: without turned axes, which none has; fBm
   instead of later fractals; a plane in space where it knows nothing else. */
static int make_nearest(struct bench_subject *subject, const struct bench_work *work)
{
    struct bench_work nearest = *work;
    if (work->output != BENCH_VALUE) {
        return 0;
    }
    nearest.turned = 0;
    nearest.fractal = work->fractal >= SCARP_EROSION ? SCARP_FBM : work->fractal;
    for (int d = 2; d <= 3 && subject->state == NULL; d++) {
        nearest.dimensions = d;
        subject->state = subject->peer->open(&nearest, subject->isa);
    }
    const char *const differences[] = {nearest.fractal != work->fractal ? "fBm" : "",
                                       work->turned ? "axes not turned" : "",
                                       nearest.dimensions != work->dimensions ? "in 3D" : ""};
    for (int i = 0; i < 3; i++) {
        const size_t length = strlen(subject->note);
        snprintf(subject->note + length, sizeof subject->note - length, "%s%s",
                 length > 0 && differences[i][0] != '\0' ? ", " : "", differences[i]);
    }
    return subject->state != NULL;
}

/* Peers do what all libraries agree on, and those fractals that they know. Their gradient comes
   from differences, where points can be moved. */
static int make_peer(struct bench_subject *subject, const struct bench_work *work)
{
    const struct bench_peer *const peer = subject->peer;
    if (is_recipe(work)) {
        subject->state = peer->recipe != NULL ? peer->open(work, subject->isa) : NULL;
        return subject->state != NULL;
    }
    if (work->title != NULL) {
        return make_nearest(subject, work);
    }
    if (work->layout == BENCH_GULLIES && peer->gullies != NULL && !work->turned && !work->f64) {
        subject->state = peer->open(work, subject->isa);
        return subject->state != NULL;
    }
    if (work->layout >= BENCH_NORMALS || work->fade != SCARP_QUINTIC || work->turned || work->f64) {
        return 0;
    }
    if ((work->period != 0 && work->layout != BENCH_GRID) || work->phase != 0.0f) {
        return 0;
    }
    if (work->layout == BENCH_GRID) {
        if (peer->grid == NULL || work->output != BENCH_VALUE || work->as_points ||
            work->request == BENCH_BY_NAME) {
            return 0;
        }
    } else if (work->output != BENCH_VALUE && work->output != BENCH_PLUS_GRADIENT) {
        return 0;
    }
    subject->state = peer->open(work, subject->isa);
    return subject->state != NULL;
}

int bench_subject_make(struct bench_subject *subject, const struct bench_work *work,
                       const struct bench_peer *peer, enum scarp_isa isa, size_t scratch)
{
    *subject = (struct bench_subject){.work = *work, .peer = peer, .isa = isa, .scratch = scratch};
    return peer == NULL ? make_scarp(subject, work) : make_peer(subject, work);
}

void bench_subject_free(struct bench_subject *subject)
{
    if (subject->peer == NULL && is_recipe(&subject->work)) {
        bench_recipe_free(subject->state);
    } else if (subject->peer == NULL) {
        free(subject->state);
    } else if (subject->state != NULL) {
        subject->peer->close(subject->state);
    }
}

const char *bench_subject_note(const struct bench_subject *subject)
{
    const enum bench_output output = subject->work.output;
    if (subject->note[0] != '\0') {
        return subject->note;
    }
    if (output == BENCH_FORWARD_DIFFERENCES) {
        return "forward differences";
    }
    const int differences = output == BENCH_CENTRAL_DIFFERENCES ||
                            (subject->peer != NULL && output == BENCH_PLUS_GRADIENT &&
                             subject->work.layout != BENCH_GULLIES && !is_recipe(&subject->work));
    return differences ? "central differences" : "";
}

/* A bench_values_fn: scarp's values, for the differences */
static void scarp_values(const void *state, size_t count, const float *const x[3], float *value)
{
    const struct bench_subject *const subject = state;
    const struct scarp_samples out = {.value = value};
    if (subject->work.dimensions == 2) {
        scarp_sample2(&subject->noise, count, x[0], x[1], &out);
    } else {
        scarp_sample3(&subject->noise, count, x[0], x[1], x[2], &out);
    }
}

/* The outputs that the workload asks for */
static struct scarp_samples choose_outputs(const struct bench_subject *subject)
{
    float *const *const to = subject->arrays->outputs;
    const int in_space = subject->work.dimensions == 3;
    struct scarp_samples out = {.value = to[0]};
    if (subject->work.output == BENCH_PLUS_GRADIENT || subject->work.output == BENCH_PLUS_HESSIAN) {
        out.dx = to[1];
        out.dy = to[2];
        out.dz = in_space ? to[3] : NULL;
    }
    if (subject->work.output == BENCH_PLUS_HESSIAN) {
        out.dxx = to[4];
        out.dxy = to[5];
        out.dxz = in_space ? to[6] : NULL;
        out.dyy = to[7];
        out.dyz = in_space ? to[8] : NULL;
        out.dzz = in_space ? to[9] : NULL;
    }
    if (subject->work.output == BENCH_PLUS_PHASE) {
        out.dphase = to[1];
    }
    return out;
}

static enum scarp_status run_grid(const struct bench_subject *subject,
                                  const struct scarp_samples *out)
{
    const struct bench_work *const work = &subject->work;
    const struct scarp_grid grid = bench_work_grid(work);
    return work->dimensions == 2 ? scarp_grid2(&subject->noise, &grid, out)
                                 : scarp_grid3(&subject->noise, &grid, out);
}

/* The product of two samples, whose values and gradients are any arrays there are. */
static enum scarp_status run_product(const struct bench_subject *subject,
                                     const struct scarp_samples *out)
{
    float *const(*const x)[3] = subject->arrays->points;
    const struct scarp_samples a = {.value = x[0][0], .dx = x[0][1], .dy = x[0][2], .dz = x[1][0]};
    const struct scarp_samples b = {.value = x[1][1], .dx = x[1][2], .dy = x[2][0], .dz = x[2][1]};
    return scarp_multiply(subject->work.points, &a, &b, out);
}

/* Values of the components of vector noise, or velocities. */
static enum scarp_status run_vector(const struct bench_subject *subject)
{
    float *const *const x = subject->arrays->points[subject->work.pattern];
    float *const *const to = subject->arrays->outputs;
    const struct scarp_noise *const noise = &subject->noise;
    const size_t n = subject->work.points;
    const int in_space = subject->work.dimensions == 3;
    const struct scarp_samples out[3] = {{.value = to[0]}, {.value = to[1]}, {.value = to[2]}};
    const struct scarp_flow flow = {.vx = to[0], .vy = to[1], .vz = in_space ? to[2] : NULL};
    if (subject->work.layout == BENCH_VECTOR) {
        return in_space ? scarp_vector3(noise, n, x[0], x[1], x[2], out)
                        : scarp_vector2(noise, n, x[0], x[1], out);
    }
    return in_space ? scarp_curl3(noise, n, x[0], x[1], x[2], &flow)
                    : scarp_curl2(noise, n, x[0], x[1], &flow);
}

/* By scarp or by a peer. The base is uniform in [0, 1), as are its derivatives. What is timed does
   not depend on it. */
static enum scarp_status run_gullies(const struct bench_subject *subject)
{
    const struct bench_work *const work = &subject->work;
    const struct scarp_gullies gullies = {.octaves = (float)work->octaves,
                                          .rotate = (uint32_t)work->turned};
    float *const *const b = subject->arrays->points[BENCH_SAME_CELL];
    float *const *const to = subject->arrays->outputs;
    float *const *const x = subject->arrays->points[work->pattern];
    double *const *const w = subject->arrays->points_f64;
    const int slopes = work->output == BENCH_PLUS_GRADIENT;
    const struct scarp_samples base = {
        .value = b[0], .dx = b[1], .dy = b[2], .dxx = b[0], .dxy = b[1], .dyy = b[2]};
    const struct scarp_eroded out = {
        .value = to[0], .dx = slopes ? to[1] : NULL, .dy = slopes ? to[2] : NULL};
    if (subject->peer != NULL) {
        const float *const from[2] = {x[0], x[1]};
        subject->peer->gullies(subject->state, work->points, from, &base, &out);
        return SCARP_OK;
    }
    return work->f64 ? scarp_gullies2_f64(&gullies, work->points, w[0], w[1], &base, &out)
                     : scarp_gullies2(&gullies, work->points, x[0], x[1], &base, &out);
}

/* The coordinates of the points of a recipe */
struct recipe_points {
    const void *at[3];
};

static struct recipe_points recipe_points(const struct bench_subject *subject)
{
    struct recipe_points p;
    for (int d = 0; d < 3; d++) {
        p.at[d] = subject->work.f64 ? (const void *)subject->arrays->points_f64[d]
                                    : subject->arrays->points[subject->work.pattern][d];
    }
    return p;
}

/* By scarp or by a peer. */
static enum scarp_status run_recipe(const struct bench_subject *subject,
                                    const struct scarp_samples *out)
{
    const struct recipe_points p = recipe_points(subject);
    if (subject->peer != NULL) {
        subject->peer->recipe(subject->state, &subject->work, p.at, out);
        return SCARP_OK;
    }
    return bench_recipe_run(subject->state, &subject->work, p.at, out);
}

/* One call; `out` is made before, as callers of few points at a time do. */
static enum scarp_status run_scarp(const struct bench_subject *subject,
                                   const struct scarp_samples *out)
{
    const struct bench_work *const work = &subject->work;
    const struct scarp_noise *const noise = &subject->noise;
    const size_t n = work->points;
    float *const *const to = subject->arrays->outputs;
    float *const *const x = subject->arrays->points[work->pattern];
    double *const *const w = subject->arrays->points_f64;
    if (work->layout == BENCH_NORMALS) {
        return scarp_normals(n, x[0], x[1], 0x1p-10f, to[0], to[1], to[2]);
    }
    if (work->layout == BENCH_PRODUCT) {
        return run_product(subject, out);
    }
    if (work->layout == BENCH_VECTOR || work->layout == BENCH_CURL) {
        return run_vector(subject);
    }
    if (work->layout == BENCH_GULLIES) {
        return run_gullies(subject);
    }
    if (is_recipe(work)) {
        return run_recipe(subject, out);
    }
    if (work->as_points) {
        double *const *const at = subject->samples_at->axis;
        return work->dimensions == 2 ? scarp_sample2_f64(noise, n, at[0], at[1], out)
                                     : scarp_sample3_f64(noise, n, at[0], at[1], at[2], out);
    }
    if (work->layout == BENCH_GRID) {
        return run_grid(subject, out);
    }
    if (work->output >= BENCH_FORWARD_DIFFERENCES) {
        const float *const from[3] = {x[0], x[1], x[2]};
        const struct bench_field field = {scarp_values, subject, work->dimensions};
        bench_differences(&field, work->output == BENCH_CENTRAL_DIFFERENCES, n, from, to[0],
                          to + 1);
        return SCARP_OK;
    }
    if (work->dimensions == 2) {
        return work->f64 ? scarp_sample2_f64(noise, n, w[0], w[1], out)
                         : scarp_sample2(noise, n, x[0], x[1], out);
    }
    return work->f64 ? scarp_sample3_f64(noise, n, w[0], w[1], w[2], out)
                     : scarp_sample3(noise, n, x[0], x[1], x[2], out);
}

/* A 2D grid by a peer that knows points only: what its users write, in chunks */
static void run_grid_of_points(const struct bench_subject *subject)
{
    enum { CHUNK = 256 };
    const struct bench_work *const work = &subject->work;
    const size_t width = work->grid[0];
    float position[3][CHUNK];
    const float *const from[3] = {position[0], position[1], position[2]};
    for (size_t i = 0; i < work->points; i += CHUNK) {
        const size_t count = work->points - i < CHUNK ? work->points - i : CHUNK;
        for (size_t j = 0; j < count; j++) {
            position[0][j] = work->origin[0] + work->step * (float)((i + j) % width);
            position[1][j] = work->origin[1] + work->step * (float)((i + j) / width);
            position[2][j] = work->origin[2];
        }
        subject->peer->points(subject->state, count, from, subject->arrays->outputs[0] + i);
    }
}

static void run_peer(const struct bench_subject *subject)
{
    const struct bench_work *const work = &subject->work;
    float *const *const to = subject->arrays->outputs;
    float *const *const x = subject->arrays->points[work->pattern];
    const float *const from[3] = {x[0], x[1], x[2]};
    if (is_recipe(work)) {
        const struct scarp_samples out = choose_outputs(subject);
        run_recipe(subject, &out);
    } else if (work->layout == BENCH_GULLIES) {
        run_gullies(subject);
    } else if (work->layout == BENCH_GRID && subject->peer->grid == NULL) {
        run_grid_of_points(subject);
    } else if (work->layout == BENCH_GRID) {
        subject->peer->grid(subject->state, work, to[0]);
    } else if (work->output == BENCH_PLUS_GRADIENT) {
        const struct bench_field field = {subject->peer->points, subject->state, work->dimensions};
        bench_differences(&field, 1, work->points, from, to[0], to + 1);
    } else {
        subject->peer->points(subject->state, work->points, from, to[0]);
    }
}

static void consume(const struct bench_subject *subject)
{
    uint32_t sum = 0;
    for (int i = 0; i < bench_count_outputs(&subject->work); i++) {
        uint32_t first, last;
        memcpy(&first, subject->arrays->outputs[i], sizeof first);
        memcpy(&last, subject->arrays->outputs[i] + subject->work.points - 1, sizeof last);
        sum += first ^ last;
    }
    consumed = sum;
}

enum scarp_status bench_subject_try(const struct bench_subject *subject)
{
    const struct scarp_samples out = choose_outputs(subject);
    (void)scarp_isa_select(subject->isa);
    if (subject->peer == NULL) {
        return run_scarp(subject, &out);
    }
    if (is_recipe(&subject->work) && subject->peer->choose != NULL) {
        const struct recipe_points p = recipe_points(subject);
        const char *const way = subject->peer->choose(subject->state, &subject->work, p.at, &out);
        snprintf(subject->row->way, sizeof subject->row->way, "%s", way != NULL ? way : "");
        return way != NULL ? SCARP_OK : SCARP_ERROR_SIZE;
    }
    return SCARP_OK;
}

void bench_subject_run(const struct bench_subject *subject, unsigned long iterations)
{
    (void)scarp_isa_select(subject->isa); /* a peer may be the same calls of scarp by hand */
    if (subject->peer == NULL) {
        const struct scarp_samples out = choose_outputs(subject);
        for (unsigned long i = 0; i < iterations; i++) {
            run_scarp(subject, &out);
        }
    } else {
        for (unsigned long i = 0; i < iterations; i++) {
            run_peer(subject);
        }
    }
    consume(subject);
}
