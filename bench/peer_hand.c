/* SPDX-License-Identifier: MIT
 *
 * The peer "by hand": the ways of taking points through the recipes of hand_recipes.c. Which is the
 * fastest depends on the recipe, the grid and the caches, so all are tried before anything is
 * measured.
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "arrays.h"
#include "bench.h"
#include "hand.h"
#include "peer.h"
#include "recipes.h"

enum { PIECE = 1024, COLUMNS = 64, MEMBERS = 4, WAYS = 8 };

#define TRIAL_SECONDS 0.1 /* for all ways together */
#define TRIALS 7

/* Arrays begin with a cache line, each at another place of a page. */
#define LINE 16 /* floats */
#define PAD (5 * LINE)

static size_t least(size_t a, size_t b)
{
    return a < b ? a : b;
}

/* How much of a workload goes through the recipe at once: points are columns. */
struct cut {
    size_t count[3];
};

static struct cut whole_of(const struct bench_work *work)
{
    struct cut whole = {{work->points, 1, 1}};
    if (work->layout == BENCH_RECIPE_GRID) {
        memcpy(whole.count, work->grid, sizeof whole.count);
    }
    return whole;
}

/* Whole rows, and if all rows fit in, whole slices, or else points; of at most so many points if
   that is possible. */
static struct cut band_of(const struct bench_work *work, size_t points)
{
    struct cut c = whole_of(work);
    if (work->layout == BENCH_RECIPE) {
        c.count[0] = least(c.count[0], points);
        return c;
    }
    const size_t rows = points / c.count[0], slices = rows / c.count[1];
    c.count[1] = least(c.count[1], rows > 0 ? rows : 1);
    c.count[2] = least(c.count[2], slices > 0 ? slices : 1);
    return c;
}

static struct cut piece_of(const struct bench_work *work)
{
    struct cut c = whole_of(work);
    const size_t most[3] = {COLUMNS, work->dimensions == 3 ? 4 : PIECE / COLUMNS,
                            work->dimensions == 3 ? PIECE / COLUMNS / 4 : 1};
    for (int d = 0; d < 3; d++) {
        c.count[d] = least(c.count[d], most[d]);
    }
    return c;
}

/* Finds way number `way`, among those that differ; *points is about how many go through at once.
   Returns 0 if there are no more. */
static int find_cut(const struct bench_work *work, int way, struct cut *cut, size_t *points)
{
    static const size_t bands[] = {1024, 4096, 16384, 65536};
    const struct cut whole = whole_of(work);
    struct cut last = whole;
    *cut = whole;
    *points = work->points;
    if (way-- == 0) {
        return 1;
    }
    for (size_t i = 0; i < sizeof bands / sizeof bands[0]; i++) {
        *cut = band_of(work, bands[i]);
        *points = bands[i];
        const int is_new = memcmp(cut, &whole, sizeof *cut) != 0 &&
                           (i == 0 || memcmp(cut, &last, sizeof *cut) != 0);
        last = *cut;
        if (is_new && way-- == 0) {
            return 1;
        }
    }
    *cut = piece_of(work);
    *points = PIECE;
    return way == 0 && work->layout == BENCH_RECIPE_GRID && cut->count[0] < whole.count[0];
}

int bench_hand_way(const struct bench_work *work, int way, char *name, size_t size)
{
    struct cut cut;
    size_t points;
    if (!find_cut(work, way, &cut, &points)) {
        return 0;
    }
    if (way == 0) {
        snprintf(name, size, "whole");
    } else {
        const int is_piece = work->layout == BENCH_RECIPE_GRID && cut.count[0] < work->grid[0];
        snprintf(name, size, "%s of %zu",
                 is_piece                            ? "pieces"
                 : work->layout == BENCH_RECIPE_GRID ? "bands"
                                                     : "chunks",
                 points);
    }
    return 1;
}

static size_t stride_of(size_t points)
{
    return (points + LINE - 1) / LINE * LINE + PAD;
}

/* Samples whose arrays begin at `start` */
static struct scarp_samples samples_at(float *start, size_t stride, int has_gradient, int in_space)
{
    struct scarp_samples s = {.value = start};
    if (has_gradient) {
        s.dx = start + stride;
        s.dy = start + 2 * stride;
        s.dz = in_space ? start + 3 * stride : NULL;
    }
    return s;
}

static size_t points_of(const struct cut *cut)
{
    return cut->count[0] * cut->count[1] * cut->count[2];
}

/* What is computed of the plane is computed for the whole grid, or for the points at hand. */
static size_t plane_points_of(const struct bench_work *work, const struct cut *cut)
{
    return work->layout == BENCH_RECIPE_GRID ? work->grid[0] * work->grid[1] : points_of(cut);
}

static size_t floats_for(const struct hand *h, const struct bench_work *work, const struct cut *cut)
{
    return ((size_t)h->recipe->registers * stride_of(points_of(cut)) +
            HAND_PLANES * stride_of(plane_points_of(work, cut))) *
           MEMBERS;
}

/* Has memory for a way. Returns 0 without. */
static int reserve(struct hand *h, const struct bench_work *work, const struct cut *cut)
{
    const size_t floats = floats_for(h, work, cut);
    if (h->floats < floats) {
        free(h->memory);
        h->memory = bench_array_make(floats, sizeof *h->memory);
        h->floats = h->memory != NULL ? floats : 0;
    }
    return h->memory != NULL;
}

static void divide(struct hand *h, const struct bench_work *work, const struct cut *cut)
{
    const size_t stride = stride_of(points_of(cut));
    const size_t plane_stride = stride_of(plane_points_of(work, cut));
    float *at = h->memory;
    for (int i = 0; i < h->recipe->registers; i++, at += MEMBERS * stride) {
        h->own[i] = samples_at(at, stride, h->has_gradient, work->dimensions == 3);
    }
    for (int i = 0; i < HAND_PLANES; i++, at += MEMBERS * plane_stride) {
        h->plane[i] = samples_at(at, plane_stride, h->has_gradient, 0);
    }
}

static float *member(const struct scarp_samples *out, int i)
{
    return i == 0 ? out->value : i == 1 ? out->dx : i == 2 ? out->dy : out->dz;
}

/* The arrays of the caller from number `from` on */
static struct scarp_samples behind(const struct scarp_samples *out, size_t from)
{
    return (struct scarp_samples){.value = out->value + from,
                                  .dx = out->dx != NULL ? out->dx + from : NULL,
                                  .dy = out->dy != NULL ? out->dy + from : NULL,
                                  .dz = out->dz != NULL ? out->dz + from : NULL};
}

/* Computes what depends on x and y alone, for the points that there are. */
static void run_plane(struct hand *h)
{
    memcpy(h->at, h->plane, sizeof h->plane);
    h->dimensions = 2;
    h->recipe->compute_plane(h);
}

/* Results lie in the caller's arrays without having been copied. */
static void run_points(struct hand *h, const struct bench_work *work, const struct cut *cut,
                       const void *const x[3], const struct scarp_samples *out)
{
    const size_t bytes = work->f64 ? sizeof(double) : sizeof(float);
    h->grid = NULL;
    h->is_double = work->f64;
    for (size_t from = 0; from < work->points; from += cut->count[0]) {
        h->count = least(work->points - from, cut->count[0]);
        for (int d = 0; d < work->dimensions; d++) {
            h->x[d] = (const char *)x[d] + from * bytes;
        }
        if (h->recipe->compute_plane != NULL) {
            run_plane(h);
        }
        memcpy(h->at, h->own, sizeof h->at);
        h->at[0] = behind(out, from);
        h->dimensions = work->dimensions;
        h->recipe->compute(h);
    }
}

/* A part of a grid. The caller's rows are not next to each other in pieces, so these are copied. */
static void run_part(struct hand *h, const struct scarp_grid *whole, const struct scarp_grid *part,
                     const struct scarp_samples *out)
{
    const size_t width = part->count[0], rows = part->count[1] * part->count[2];
    const int is_band = width == whole->count[0];
    const size_t from =
        ((size_t)part->first[2] * whole->count[1] + (size_t)part->first[1]) * whole->count[0] +
        (size_t)part->first[0];
    h->grid = part;
    h->count = width * rows;
    memcpy(h->at, h->own, sizeof h->at);
    if (is_band) {
        h->at[0] = behind(out, from);
    }
    h->recipe->compute(h);
    for (int i = 0; i < MEMBERS && !is_band; i++) {
        const float *source = member(&h->own[0], i);
        for (size_t row = 0; source != NULL && row < rows; row++, source += width) {
            const size_t y = row % part->count[1], z = row / part->count[1];
            memcpy(member(out, i) + from + (z * whole->count[1] + y) * whole->count[0], source,
                   width * sizeof *source);
        }
    }
}

static void run_grid(struct hand *h, const struct bench_work *work, const struct cut *cut,
                     const struct scarp_samples *out)
{
    const struct scarp_grid whole = bench_work_grid(work);
    struct scarp_grid part = whole;
    if (h->recipe->compute_plane != NULL) {
        h->grid = &whole;
        h->count = whole.count[0] * whole.count[1];
        h->plane_width = whole.count[0];
        run_plane(h);
    }
    h->dimensions = work->dimensions;
    for (size_t k = 0; k < whole.count[2]; k += cut->count[2]) {
        for (size_t j = 0; j < whole.count[1]; j += cut->count[1]) {
            for (size_t i = 0; i < whole.count[0]; i += cut->count[0]) {
                const size_t from[3] = {i, j, k};
                for (int d = 0; d < 3; d++) {
                    part.first[d] = (int64_t)from[d];
                    part.count[d] = least(whole.count[d] - from[d], cut->count[d]);
                }
                run_part(h, &whole, &part, out);
            }
        }
    }
}

int bench_hand_run(struct hand *h, int way, const struct bench_work *work, const void *const x[3],
                   const struct scarp_samples *out)
{
    struct cut cut;
    size_t points;
    h->has_gradient = out->dx != NULL;
    if (!find_cut(work, way, &cut, &points) || !reserve(h, work, &cut)) {
        return 0;
    }
    divide(h, work, &cut);
    if (work->layout == BENCH_RECIPE) {
        run_points(h, work, &cut, x, out);
    } else {
        run_grid(h, work, &cut, out);
    }
    return 1;
}

static uint64_t splitmix(uint64_t start, uint64_t number)
{
    uint64_t z = start + number * UINT64_C(0x9E3779B97F4A7C15);
    z = (z ^ z >> 30) * UINT64_C(0xBF58476D1CE4E5B9);
    z = (z ^ z >> 27) * UINT64_C(0x94D049BB133111EB);
    return z ^ z >> 31;
}

/* What recipes make of seed=n in the world 0 */
static uint64_t seed(uint64_t n)
{
    return n == 0 ? 0 : splitmix(splitmix(0, 1), 64 + n);
}

/* Makes the plans of the noises. Those that only bend others come last. */
static int make_plans(struct hand *h, const struct bench_work *work)
{
    const struct hand_recipe *const r = h->recipe;
    h->plans = calloc((size_t)r->noise_count, sizeof *h->plans);
    for (int i = 0; h->plans != NULL && i < r->noise_count; i++) {
        struct scarp_noise *const noise = &h->noise[i];
        const int dimensions = i < r->plane_noises ? 2 : work->dimensions;
        const enum scarp_status status =
            i < r->noise_count - r->warps ? scarp_plan_make(noise, dimensions, &h->plans[i])
                                          : scarp_vector_plan_make(noise, dimensions, &h->plans[i]);
        noise->plan = status == SCARP_OK ? &h->plans[i] : NULL;
    }
    return h->plans != NULL;
}

/* Makes the noises, which know their warps by where they are in the table. */
static int make_noises(struct hand *h, const struct bench_work *work)
{
    const struct hand_recipe *const r = h->recipe;
    for (int i = 0; i < r->noise_count; i++) {
        struct scarp_noise *const noise = &h->noise[i];
        *noise = r->noises[i];
        noise->offset_first = 1;
        noise->seed = seed(noise->seed);
        noise->warp = noise->warp != NULL ? &h->noise[noise->warp - r->noises] : NULL;
    }
    return work->points > BENCH_FEW_POINTS || make_plans(h, work);
}

static void hand_close(void *state)
{
    struct hand *const h = state;
    free(h->memory);
    free(h->plans);
    free(h);
}

static void *hand_open(const struct bench_work *work, enum scarp_isa isa)
{
    const int is_recipe = work->layout == BENCH_RECIPE || work->layout == BENCH_RECIPE_GRID;
    const struct hand_recipe *r = hand_recipes;
    while (is_recipe && r->title != NULL && strcmp(work->title, r->title) != 0) {
        r++;
    }
    if (!is_recipe || r->title == NULL || !scarp_isa_supported(isa)) {
        return NULL;
    }
    struct hand *const h = calloc(1, sizeof *h);
    if (h != NULL) {
        h->recipe = r;
    }
    if (h != NULL && !make_noises(h, work)) {
        hand_close(h);
        return NULL;
    }
    return h;
}

/* Runs all ways in turn, and takes that with the shortest time. */
static const char *hand_choose(void *state, const struct bench_work *work, const void *const x[3],
                               const struct scarp_samples *out)
{
    struct hand *const h = state;
    double shortest[WAYS], spent = 0;
    int ways = 0;
    while (bench_hand_way(work, ways, h->way_name, sizeof h->way_name)) {
        shortest[ways++] = HUGE_VAL;
    }
    for (int trial = 0; ways > 1 && (trial < 2 || (trial < TRIALS && spent < TRIAL_SECONDS));
         trial++) {
        for (int i = 0; i < ways; i++) {
            const double start = bench_seconds();
            if (!bench_hand_run(h, i, work, x, out)) {
                return NULL;
            }
            const double time = bench_seconds() - start;
            shortest[i] = time < shortest[i] ? time : shortest[i];
            spent += time;
        }
    }
    h->way = 0;
    for (int i = 1; i < ways; i++) {
        h->way = shortest[i] < shortest[h->way] ? i : h->way;
    }
    free(h->memory); /* other ways may need much more */
    h->memory = NULL;
    h->floats = 0;
    (void)bench_hand_way(work, h->way, h->way_name, sizeof h->way_name);
    return bench_hand_run(h, h->way, work, x, out) ? h->way_name : NULL;
}

static void hand_recipe(void *state, const struct bench_work *work, const void *const x[3],
                        const struct scarp_samples *out)
{
    struct hand *const h = state;
    (void)bench_hand_run(h, h->way, work, x, out);
}

const struct bench_peer bench_peer_hand = {.library = "by hand",
                                           .open = hand_open,
                                           .close = hand_close,
                                           .recipe = hand_recipe,
                                           .choose = hand_choose};
