/* SPDX-License-Identifier: MIT
 *
 * The peer "by hand": the recipes as programs write them that know no recipes, by the same calls of
 * scarp. Work goes through in chunks of 1,024 points, and grids in pieces of 64 columns, as
 * recipes do; results lie in the caller's arrays at the end.
 */
#include <stdlib.h>
#include <string.h>

#include "peer.h"
#include "recipes.h"

enum { CHUNK = 1024, COLUMNS = 64, REGISTERS = 6, MEMBERS = 4 };

struct hand {
    void (*compute)(struct hand *hand);
    /* Of the chunk: */
    int dimensions, has_gradient, is_double;
    size_t count;
    const void *x[3];
    const struct scarp_grid *grid; /* NULL: points */
    float memory[REGISTERS][MEMBERS][CHUNK];
};

/* Number `i` of the registers; the result is in number 0. */
static struct scarp_samples in(struct hand *h, int i)
{
    struct scarp_samples s = {.value = h->memory[i][0]};
    if (h->has_gradient) {
        s.dx = h->memory[i][1];
        s.dy = h->memory[i][2];
        s.dz = h->dimensions == 3 ? h->memory[i][3] : NULL;
    }
    return s;
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

static void sample(struct hand *h, const struct scarp_noise *noise, int to)
{
    const struct scarp_samples out = in(h, to);
    if (h->grid != NULL) {
        (void)(h->dimensions == 2 ? scarp_grid2(noise, h->grid, &out)
                                  : scarp_grid3(noise, h->grid, &out));
    } else if (h->is_double) {
        scarp_sample2_f64(noise, h->count, h->x[0], h->x[1], &out);
    } else {
        scarp_sample2(noise, h->count, h->x[0], h->x[1], &out);
    }
}

static void affine(struct hand *h, int a, float scale, float offset)
{
    const struct scarp_samples s = in(h, a);
    scarp_affine(h->count, &s, scale, offset, &s);
}

static void add(struct hand *h, int a, int b)
{
    const struct scarp_samples s = in(h, a), t = in(h, b);
    scarp_add(h->count, &s, &t, &s);
}

static void multiply(struct hand *h, int a, int b)
{
    const struct scarp_samples s = in(h, a), t = in(h, b);
    scarp_multiply(h->count, &s, &t, &s);
}

static void smoothstep(struct hand *h, int a, float lo, float hi)
{
    const struct scarp_samples s = in(h, a);
    scarp_smoothstep(h->count, &s, lo, hi, &s);
}

static void curve(struct hand *h, int a, size_t knots, const float *x, const float *y, int to)
{
    const struct scarp_samples s = in(h, a), t = in(h, to);
    scarp_curve(h->count, &s, knots, x, y, &t);
}

/* slope . x + offset of a row of points, in double; `x` has the coordinates of points. */
static void ramp_of_points(struct hand *h, const double slope[3], double offset, float *to)
{
    for (size_t i = 0; i < h->count; i++) {
        to[i] = (float)(slope[0] * ((const double *)h->x[0])[i] +
                        slope[1] * ((const double *)h->x[1])[i] + offset);
    }
}

static double coordinate(const struct scarp_grid *g, int d, size_t i)
{
    return g->origin[d] + (double)(g->first[d] + (int64_t)i) * g->step[d];
}

static void ramp_of_grid(const struct scarp_grid *g, const double slope[3], double offset,
                         float *to)
{
    for (size_t k = 0; k < g->count[2]; k++) {
        for (size_t j = 0; j < g->count[1]; j++) {
            const double row =
                slope[1] * coordinate(g, 1, j) + slope[2] * coordinate(g, 2, k) + offset;
            for (size_t i = 0; i < g->count[0]; i++) {
                *to++ = (float)(slope[0] * coordinate(g, 0, i) + row);
            }
        }
    }
}

/* A linear field */
static void ramp(struct hand *h, const double slope[3], double offset, int to)
{
    const struct scarp_samples out = in(h, to);
    float *const arrays[3] = {out.dx, out.dy, out.dz};
    if (h->grid != NULL) {
        ramp_of_grid(h->grid, slope, offset, out.value);
    } else {
        ramp_of_points(h, slope, offset, out.value);
    }
    for (int d = 0; d < 3; d++) {
        for (size_t i = 0; arrays[d] != NULL && i < h->count; i++) {
            arrays[d][i] = (float)slope[d];
        }
    }
}

static void fade(struct hand *h)
{
    const struct scarp_noise soft = {.offset_first = 1, .frequency = 1 / 400.0, .octaves = 6};
    const struct scarp_noise hard = {
        .offset_first = 1, .frequency = 1 / 250.0, .octaves = 8, .seed = seed(1)};
    const struct scarp_noise where = {
        .offset_first = 1, .frequency = 1 / 900.0, .octaves = 3, .seed = seed(2)};
    const struct scarp_samples a = in(h, 0), b = in(h, 1), m = in(h, 2);
    sample(h, &where, 2);
    smoothstep(h, 2, -0.2f, 0.2f);
    sample(h, &hard, 1);
    sample(h, &soft, 0);
    scarp_mix(h->count, &a, &b, &m, &a);
    affine(h, 0, 100, 0);
}

static void alps(struct hand *h)
{
    const struct scarp_noise bend = {
        .offset_first = 1, .frequency = 0.0035, .octaves = 5, .amplitude = 75};
    const struct scarp_noise ridges = {.offset_first = 1,
                                       .fractal = SCARP_SWISS,
                                       .rotate = 1,
                                       .frequency = 0.005,
                                       .octaves = 9,
                                       .gain = 0.45f,
                                       .warp = &bend};
    const struct scarp_noise ground = {.offset_first = 1,
                                       .fractal = SCARP_HYBRID,
                                       .rotate = 1,
                                       .frequency = 0.0016,
                                       .octaves = 8,
                                       .gain = 0.42f,
                                       .amplitude = 1.4f};
    const struct scarp_noise high = {
        .offset_first = 1, .rotate = 1, .frequency = 0.0016, .octaves = 3};
    sample(h, &high, 1);
    smoothstep(h, 1, -0.5f, 0.25f);
    sample(h, &ridges, 0);
    multiply(h, 0, 1);
    sample(h, &ground, 1);
    add(h, 0, 1);
    affine(h, 0, 110, 0);
}

static void overworld(struct hand *h)
{
    static const float shelf_x[] = {-1, -0.45f, -0.2f, -0.1f, 0.05f, 0.3f, 0.7f};
    static const float shelf_y[] = {-60, -55, -18, 2, 8, 30, 60};
    static const float rugged_x[] = {-0.7f, -0.3f, 0, 0.4f}, rugged_y[] = {1, 0.6f, 0.2f, 0.05f};
    const struct scarp_noise drift = {
        .offset_first = 1, .frequency = 1 / 600.0, .octaves = 3, .amplitude = 120, .seed = seed(1)};
    const struct scarp_noise continents = {.offset_first = 1,
                                           .frequency = 1 / 2400.0,
                                           .octaves = 6,
                                           .rotate = 1,
                                           .seed = seed(2),
                                           .warp = &drift};
    const struct scarp_noise erosion = {.offset_first = 1,
                                        .frequency = 1 / 1500.0,
                                        .octaves = 4,
                                        .rotate = 1,
                                        .seed = seed(3),
                                        .warp = &drift};
    const struct scarp_noise weird = {
        .offset_first = 1, .frequency = 1 / 700.0, .octaves = 5, .rotate = 1, .seed = seed(4)};
    const struct scarp_noise rough = {.offset_first = 1,
                                      .fractal = SCARP_RIDGED,
                                      .frequency = 1 / 260.0,
                                      .octaves = 6,
                                      .rotate = 1,
                                      .gain = 0.45f,
                                      .seed = seed(5)};
    const struct scarp_noise bumps = {
        .offset_first = 1, .frequency = 1 / 40.0, .octaves = 3, .seed = seed(6)};
    const struct scarp_samples peaks = in(h, 3);
    sample(h, &continents, 1);
    curve(h, 1, 7, shelf_x, shelf_y, 0);
    smoothstep(h, 1, -0.12f, 0.3f);
    sample(h, &erosion, 2);
    curve(h, 2, 4, rugged_x, rugged_y, 2);
    multiply(h, 1, 2);
    sample(h, &weird, 3);
    scarp_abs(h->count, &peaks, &peaks);
    affine(h, 3, 3, -2);
    scarp_abs(h->count, &peaks, &peaks);
    affine(h, 3, -70, 70);
    sample(h, &rough, 2);
    affine(h, 2, 90, 0);
    add(h, 3, 2);
    multiply(h, 1, 3);
    sample(h, &bumps, 2);
    affine(h, 2, 6, 0);
    add(h, 0, 2);
    add(h, 0, 1);
}

static void marble(struct hand *h)
{
    const struct scarp_noise rough = {.offset_first = 1,
                                      .fractal = SCARP_TURBULENCE,
                                      .frequency = 1 / 0.7,
                                      .octaves = 6,
                                      .seed = seed(1)};
    const double coarse[3] = {0.9063077870366499, 0.42261826174069944, 0};
    const double fine[3] = {0.6427876096865394, -0.766044443118978, 0};
    const struct scarp_samples a = in(h, 0), b = in(h, 1), r = in(h, 2), s = in(h, 3);
    sample(h, &rough, 2);
    ramp(h, coarse, 0, 0);
    affine(h, 0, 5, 0);
    scarp_affine(h->count, &r, 1.8f, 0, &s);
    add(h, 0, 3);
    scarp_sine(h->count, &a, &a);
    affine(h, 0, 1, 1);
    affine(h, 0, 0.5f, 0);
    affine(h, 0, -1, 1);
    scarp_multiply(h->count, &a, &a, &s);
    multiply(h, 0, 3);
    ramp(h, fine, 0, 1);
    affine(h, 1, 20, 0);
    affine(h, 2, 3.6f, 0);
    add(h, 1, 2);
    scarp_sine(h->count, &b, &b);
    affine(h, 1, 1, 1);
    affine(h, 1, 0.5f, 0);
    affine(h, 1, 0.2f, 0);
    affine(h, 1, 1, 0.8f);
    multiply(h, 0, 1);
    affine(h, 0, -1, 1);
}

/* A noise of the plane, the same in all slices of a piece. */
static void sample_flat(struct hand *h, const struct scarp_noise *noise, int to)
{
    const struct scarp_samples out = in(h, to);
    struct scarp_samples plane = out;
    const size_t slice = h->grid->count[0] * h->grid->count[1];
    float *const arrays[3] = {out.value, out.dx, out.dy};
    plane.dz = NULL;
    scarp_grid2(noise, h->grid, &plane);
    for (int i = 0; i < 3; i++) {
        for (size_t k = slice; arrays[i] != NULL && k < h->count; k += slice) {
            memcpy(arrays[i] + k, arrays[i], slice * sizeof(float));
        }
    }
    if (out.dz != NULL) {
        memset(out.dz, 0, h->count * sizeof(float));
    }
}

static void cloud(struct hand *h)
{
    static const float x[] = {0, 0.15f, 0.6f, 1}, y[] = {0, 1, 0.8f, 0};
    static const double up[3] = {0, 0, 1 / 1200.0};
    const struct scarp_noise drift = {
        .offset_first = 1, .frequency = 1 / 900.0, .octaves = 2, .amplitude = 150, .seed = seed(1)};
    const struct scarp_noise shape = {
        .offset_first = 1, .frequency = 1 / 1400.0, .octaves = 5, .seed = seed(2), .warp = &drift};
    const struct scarp_noise puffs = {.offset_first = 1,
                                      .basis = SCARP_CELL_F1,
                                      .frequency = 1 / 300.0,
                                      .octaves = 3,
                                      .seed = seed(3)};
    const struct scarp_noise weather = {
        .offset_first = 1, .frequency = 1 / 6000.0, .octaves = 3, .seed = seed(4)};
    const struct scarp_samples a = in(h, 0), b = in(h, 1);
    ramp(h, up, -1, 2);
    curve(h, 2, 4, x, y, 2);
    sample(h, &shape, 0);
    sample_flat(h, &weather, 1);
    affine(h, 1, 0.5f, 0.3f);
    add(h, 0, 1);
    multiply(h, 0, 2);
    sample(h, &puffs, 1);
    affine(h, 1, 0.2f, -0.2f);
    add(h, 0, 1);
    affine(h, 1, 0, 0);
    scarp_smooth_max(h->count, &a, &b, 0.05f, &a);
}

static void *hand_open(const struct bench_work *work, enum scarp_isa isa)
{
    static const struct {
        const char *title;
        void (*compute)(struct hand *);
    } all[] = {{"fade", fade},
               {"alps", alps},
               {"overworld", overworld},
               {"marble", marble},
               {"cloud", cloud}};
    const int is_recipe = work->layout == BENCH_RECIPE || work->layout == BENCH_RECIPE_GRID;
    struct hand *const h = is_recipe && scarp_isa_supported(isa) ? calloc(1, sizeof *h) : NULL;
    for (size_t i = 0; h != NULL && i < sizeof all / sizeof all[0]; i++) {
        if (strcmp(work->title, all[i].title) == 0) {
            h->compute = all[i].compute;
        }
    }
    if (h == NULL || h->compute == NULL) {
        free(h);
        return NULL;
    }
    h->dimensions = work->dimensions;
    return h;
}

static float *member(const struct scarp_samples *out, int i)
{
    return i == 0 ? out->value : i == 1 ? out->dx : i == 2 ? out->dy : out->dz;
}

static void run_points(struct hand *h, const struct bench_work *work, const void *const x[3],
                       const struct scarp_samples *out)
{
    const size_t bytes = work->f64 ? sizeof(double) : sizeof(float);
    h->grid = NULL;
    h->is_double = work->f64;
    for (size_t at = 0; at < work->points; at += CHUNK) {
        h->count = work->points - at < CHUNK ? work->points - at : CHUNK;
        for (int d = 0; d < work->dimensions; d++) {
            h->x[d] = (const char *)x[d] + at * bytes;
        }
        h->compute(h);
        for (int i = 0; i < MEMBERS; i++) {
            if (member(out, i) != NULL) {
                memcpy(member(out, i) + at, h->memory[0][i], h->count * sizeof(float));
            }
        }
    }
}

/* A piece that begins at a column, a row and a slice. */
static void run_piece(struct hand *h, const struct scarp_grid *whole,
                      const struct scarp_grid *piece, const struct scarp_samples *out)
{
    h->grid = piece;
    h->count = piece->count[0] * piece->count[1] * piece->count[2];
    h->compute(h);
    for (int i = 0; i < MEMBERS; i++) {
        const float *from = h->memory[0][i];
        for (size_t row = 0; member(out, i) != NULL && row < piece->count[1] * piece->count[2];
             row++) {
            const size_t y = (size_t)piece->first[1] + row % piece->count[1];
            const size_t z = (size_t)piece->first[2] + row / piece->count[1];
            memcpy(member(out, i) + (z * whole->count[1] + y) * whole->count[0] +
                       (size_t)piece->first[0],
                   from, piece->count[0] * sizeof *from);
            from += piece->count[0];
        }
    }
}

static size_t least(size_t a, size_t b)
{
    return a < b ? a : b;
}

static void hand_recipe(void *state, const struct bench_work *work, const void *const x[3],
                        const struct scarp_samples *out)
{
    struct hand *const h = state;
    h->has_gradient = out->dx != NULL;
    if (work->layout == BENCH_RECIPE) {
        run_points(h, work, x, out);
        return;
    }
    const struct scarp_grid whole = bench_work_grid(work);
    const size_t rows = work->dimensions == 3 ? 4 : CHUNK / COLUMNS;
    const size_t slices = work->dimensions == 3 ? CHUNK / COLUMNS / 4 : 1;
    struct scarp_grid piece = whole;
    for (size_t k = 0; k < whole.count[2]; k += slices) {
        for (size_t j = 0; j < whole.count[1]; j += rows) {
            for (size_t i = 0; i < whole.count[0]; i += COLUMNS) {
                const size_t from[3] = {i, j, k}, most[3] = {COLUMNS, rows, slices};
                for (int d = 0; d < 3; d++) {
                    piece.first[d] = (int64_t)from[d];
                    piece.count[d] = least(whole.count[d] - from[d], most[d]);
                }
                run_piece(h, &whole, &piece, out);
            }
        }
    }
}

const struct bench_peer bench_peer_hand = {
    .library = "by hand", .open = hand_open, .close = free, .recipe = hand_recipe};
