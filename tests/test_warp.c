/* SPDX-License-Identifier: MIT
 *
 * Rebuilds noise with warps from calls without one, scarp_vector2 and its like for the warps, as
 * the text of scarp.h says: of floats, values and dphase to the bit, gradients and Hessians through
 * the Jacobian in double; of doubles, whose displacements are added to fractions, values but for
 * rounding. Periods, also far from the origin, coordinates that are not finite, calls in place,
 * what a warp changes nothing of. (test_grid.c has grids of it,
 * test_warp_exact.c compares gradients with differences, test_warp_api.c has errors and plans.)
 * Argument: the instruction set.
 */
#include <float.h>

#include "fractal.h"

/* A sample, and the same with all terms taken positive: the unit of its rounding errors. */
struct rebuilt {
    struct oracle_sample n, size;
};

/* Positions of a block, and what noise is there. */
struct places {
    enum function function;
    int dimensions;
    struct block *at;
};

static struct rebuilt rebuilt_of(const struct block *block, const struct scarp_noise *noise,
                                 enum function f, size_t i)
{
    struct rebuilt r = {.n = block_result(block, noise, f, i)};
    for (int a = 0; a < 3; a++) {
        r.size.gradient[a] = fabs(r.n.gradient[a]);
        for (int b = 0; b < 3; b++) {
            r.size.hessian[a][b] = fabs(r.n.hessian[a][b]);
        }
    }
    return r;
}

/* J^T g and J^T H J + sum_m g_m H_m, with J = I + (gradients of d). */
static void compose(struct oracle_sample *to, const struct oracle_sample *n,
                    const struct oracle_sample d[3], int dimensions)
{
    double j[3][3] = {{0.0}};
    for (int i = 0; i < 9 && i / 3 < dimensions; i++) {
        j[i / 3][i % 3] = d[i / 3].gradient[i % 3] + (i / 3 == i % 3 ? 1.0 : 0.0);
    }
    to->value = n->value;
    to->phase = n->phase;
    for (int a = 0; a < dimensions; a++) {
        to->gradient[a] = 0.0;
        for (int m = 0; m < dimensions; m++) {
            to->gradient[a] += j[m][a] * n->gradient[m];
        }
        for (int b = 0; b < dimensions; b++) {
            to->hessian[a][b] = 0.0;
            for (int m = 0; m < dimensions; m++) {
                to->hessian[a][b] += n->gradient[m] * d[m].hessian[a][b];
                for (int l = 0; l < dimensions; l++) {
                    to->hessian[a][b] += j[m][a] * n->hessian[m][l] * j[l][b];
                }
            }
        }
    }
}

/* Displaces point i of x to that of y: floats in float, doubles in double. */
static void displace(struct block *y, const struct block *x, int axis, size_t i, double d)
{
    const float moved = x->f[axis][i] + (float)d; /* d is a float */
    y->f[axis][i] = moved;
    y->d[axis][i] = x->d[axis][i] + d;
}

/* Displaces x by d to y. */
static void displace_all(struct block *y, const struct places *x, struct rebuilt *const d[3])
{
    for (int axis = 0; axis < x->dimensions; axis++) {
        for (size_t i = 0; i < BLOCK; i++) {
            displace(y, x->at, axis, i, d[axis][i].n.value);
        }
    }
}

/* Turns samples with respect to x + d into samples with respect to x. */
static void compose_all(struct rebuilt *out, struct rebuilt *const d[3], int dimensions)
{
    for (size_t i = 0; i < BLOCK; i++) {
        struct oracle_sample n[3] = {{.value = 0.0}}, size[3] = {{.value = 0.0}};
        struct rebuilt composed = {.n = {.value = 0.0}};
        for (int axis = 0; axis < dimensions; axis++) {
            n[axis] = d[axis][i].n;
            size[axis] = d[axis][i].size;
        }
        compose(&composed.n, &out[i].n, n, dimensions);
        compose(&composed.size, &out[i].size, size, dimensions);
        out[i] = composed;
    }
}

/* Samples the components of a noise without its warp. */
static void sample_vector(const struct scarp_noise *noise, const struct places *x,
                          struct rebuilt *const out[3])
{
    struct block *const of[3] = {block_make(), block_make(), block_make()};
    struct scarp_samples samples[3];
    const struct inputs in = {{x->at->f[0], x->at->f[1], x->at->f[2]},
                              {x->at->d[0], x->at->d[1], x->at->d[2]}};
    for (int axis = 0; axis < 3; axis++) {
        samples[axis] = outputs_subset(&of[axis]->out, outputs_of(noise, x->function));
    }
    const enum scarp_status status = vector_call(x->function, noise, BLOCK, &in, samples);
    CHECK(status == SCARP_OK, "%s", scarp_status_text(status));
    for (int axis = 0; axis < x->dimensions; axis++) {
        for (size_t i = 0; i < BLOCK; i++) {
            out[axis][i] = rebuilt_of(of[axis], noise, x->function, i);
        }
    }
    for (int axis = 0; axis < 3; axis++) {
        block_free(of[axis]);
    }
}

static void vector_free(struct rebuilt *const d[3])
{
    for (int axis = 0; axis < 3; axis++) {
        free(d[axis]);
    }
}

/* Makes room for components, and rebuilds those of a noise with its warps. */
static void rebuild_vector(const struct scarp_noise *noise, const struct places *x,
                           struct rebuilt *out[3])
{
    struct scarp_noise plain = *noise;
    plain.warp = NULL;
    for (int axis = 0; axis < 3; axis++) {
        out[axis] = check_allocate(BLOCK * sizeof *out[axis]);
    }
    if (noise->warp == NULL) {
        sample_vector(noise, x, out);
        return;
    }
    struct block *const y = block_make();
    const struct places at = {x->function, x->dimensions, y};
    struct rebuilt *d[3];
    rebuild_vector(noise->warp, x, d);
    displace_all(y, x, d);
    sample_vector(&plain, &at, out);
    for (int axis = 0; axis < x->dimensions; axis++) {
        compose_all(out[axis], d, x->dimensions);
    }
    vector_free(d);
    block_free(y);
}

/* Samples a noise, with its warps, by calls without any. */
static void sample_rebuilt(const struct scarp_noise *noise, const struct places *x,
                           struct rebuilt *out)
{
    struct scarp_noise plain = *noise;
    plain.warp = NULL;
    struct block *const y = block_make();
    struct rebuilt *d[3];
    rebuild_vector(noise->warp, x, d);
    displace_all(y, x, d);
    block_sample(y, &plain, x->function, BLOCK);
    for (size_t i = 0; i < BLOCK; i++) {
        out[i] = rebuilt_of(y, &plain, x->function, i);
    }
    compose_all(out, d, x->dimensions);
    vector_free(d);
    block_free(y);
}

static int depth_of(const struct scarp_noise *noise)
{
    int depth = 0;
    while ((noise = noise->warp) != NULL) {
        depth++;
    }
    return depth;
}

/* Errors of gradient and Hessian in units of the sizes' last places, for each level. */
static double worst[2];

static void compare_point(const struct scarp_noise *noise, const struct oracle_sample *n,
                          const struct rebuilt *expected, const char *what)
{
    const double unit = 0x1p-24 * depth_of(noise);
    CHECK(n->value == expected->n.value, "%s: value %.9g, not %.9g", what, n->value,
          expected->n.value);
    CHECK(n->phase == expected->n.phase, "%s: dphase %.9g, not %.9g", what, n->phase,
          expected->n.phase);
    for (int a = 0; a < 3; a++) {
        const double off = fabs(n->gradient[a] - expected->n.gradient[a]);
        worst[0] = larger(worst[0], off > 0.0 ? off / (unit * expected->size.gradient[a]) : 0.0);
        for (int b = 0; b < 3 && noise_order(noise) == 2; b++) {
            const double second = fabs(n->hessian[a][b] - expected->n.hessian[a][b]);
            worst[1] = larger(worst[1],
                              second > 0.0 ? second / (unit * expected->size.hessian[a][b]) : 0.0);
        }
    }
}

/* How many values of doubles were compared, and how many are off by more than rounding of steep
   noise. Some may be: on both sides of a jump. */
static int compared, off;

static void compare_double(const struct oracle_sample *n, const struct rebuilt *expected)
{
    compared++;
    off += !(fabs(n->value - expected->n.value) <= 2e-5);
}

static void compare(const struct scarp_noise *noise, const char *what)
{
    struct block *const block = block_make();
    struct rebuilt *const expected = check_allocate(BLOCK * sizeof *expected);
    uint64_t random = noise->seed;
    for (int f = 0; f < FUNCTIONS; f++) {
        struct scarp_noise fitted = *noise;
        fit_noise(&fitted, function_dimensions((enum function)f));
        const struct places x = {(enum function)f, function_dimensions((enum function)f), block};
        block_random(block, &random, 64.0f);
        sample_rebuilt(&fitted, &x, expected);
        block_sample(block, &fitted, x.function, BLOCK);
        for (size_t i = 0; i < BLOCK; i++) {
            const struct oracle_sample n = block_result(block, &fitted, x.function, i);
            if (function_doubles(x.function)) {
                compare_double(&n, &expected[i]);
            } else {
                compare_point(&fitted, &n, &expected[i], what);
            }
        }
    }
    free(expected);
    block_free(block);
}

/* A product of two rounded factors, and a few sums: three or so roundings for a gradient of each
   level, eight or so for a Hessian, in the worst of cases. */
static void check_worst(const char *what)
{
    printf("%-28s gradient within %.2f, Hessian within %.2f roundings a level; %d of %d values of "
           "doubles off\n",
           what, worst[0], worst[1], off, compared);
    CHECK(worst[0] <= 5.0 && worst[1] <= 10.0, "%s: off by %g, %g roundings", what, worst[0],
          worst[1]);
    CHECK(off <= compared / 500, "%s: %d of %d values of doubles are off", what, off, compared);
    worst[0] = worst[1] = 0.0;
    compared = off = 0;
}

/* All fractals of warps by all fractals of noise, on bases in turn. */
static void test_fractals(void)
{
    const int fractals = count_names(fractal_name), bases = count_names(basis_name);
    for (int i = 0; i < fractals * fractals; i++) {
        const struct scarp_noise w = {.fractal = (enum scarp_fractal)(i / fractals),
                                      .basis = (enum scarp_basis)(i % 3),
                                      .seed = 100 + (uint64_t)i,
                                      .rotate = (uint32_t)(i / 2 % 2),
                                      .octaves = 2.5f,
                                      .frequency = 0.7,
                                      .phase = i % 3 == 0 ? 0.7f : 0.0f,
                                      .amplitude = i % 2 == 0 ? 0.8f : -2.0f,
                                      .offset_first = (uint32_t)i / 3 % 2};
        const struct scarp_noise noise = {.fractal = (enum scarp_fractal)(i % fractals),
                                          .basis = (enum scarp_basis)(i / 2 % bases),
                                          .seed = (uint64_t)i,
                                          .fade = (enum scarp_fade)(i / 5 % 2),
                                          .rotate = (uint32_t)(i % 2),
                                          .octaves = 3.0f,
                                          .phase = -0.4f,
                                          .warp = &w,
                                          .offset_first = (uint32_t)i / 4 % 2};
        char what[64];
        snprintf(what, sizeof what, "%s at %s", fractal_name(i % fractals),
                 fractal_name(i / fractals));
        compare(&noise, what);
    }
    check_worst("all fractals");
}

/* Chains of two and of four warps, and octaves of which a plan has no room for all. */
static void test_chains(void)
{
    static const struct scarp_noise w4 = {.seed = 4, .octaves = 2.0f, .basis = SCARP_VALUE},
                                    w3 = {.seed = 3,
                                          .frequency = 0.4,
                                          .rotate = 1,
                                          .octaves = 2.0f,
                                          .warp = &w4},
                                    w2 = {.seed = 2, .basis = SCARP_SIMPLEX, .warp = &w3},
                                    w1 = {.seed = 1,
                                          .amplitude = 0.5f,
                                          .octaves = 2.0f,
                                          .fractal = SCARP_TURBULENCE,
                                          .warp = &w2};
    static const struct scarp_noise two = {.octaves = 3.0f, .basis = SCARP_VALUE, .warp = &w3};
    static const struct scarp_noise four = {.octaves = 2.0f, .phase = 0.2f, .warp = &w1};
    compare(&two, "two warps");
    check_worst("two warps");
    compare(&four, "four warps");
    check_worst("four warps");
    for (int i = 0; i < 5; i++) { /* 2 (6 + 9) + i octaves in 2D, 3 (6 + 9) + i in 3D */
        const struct scarp_noise deep = {.seed = 8, .octaves = 9.0f, .lacunarity = 1.3f};
        const struct scarp_noise w = {
            .seed = 9, .octaves = 6.0f, .lacunarity = 1.3f, .rotate = 1, .warp = &deep};
        const struct scarp_noise noise = {.octaves = (float)(1 + i), .warp = &w};
        compare(&noise, "about 32 octaves");
    }
    check_worst("about 32 octaves");
    const struct scarp_noise full = {.octaves = 32.0f, .lacunarity = 1.1f, .basis = SCARP_VALUE};
    const struct scarp_noise noise = {.octaves = 32.0f, .lacunarity = 1.1f, .warp = &full};
    compare(&noise, "32 octaves each");
    check_worst("32 octaves each");
}

/* A periodic warp of periodic noise: a tile has no seam, whether the next one is near or far. */
static void test_periods(void)
{
    const struct scarp_noise e = {.seed = 3, .period = {32, 32, 32}, .frequency = 2.0};
    const struct scarp_noise w = {.seed = 2,
                                  .period = {8, 8, 8},
                                  .frequency = 0.5,
                                  .octaves = 2.0f,
                                  .lacunarity = 3.0f,
                                  .warp = &e};
    const struct scarp_noise noise = {
        .octaves = 3.0f, .period = {16, 16, 4}, .phase = 0.3f, .warp = &w};
    struct block *const here = block_make(), *const there = block_make();
    uint64_t random = 5;
    for (int i = 0; i < 2 * 3 * 2; i++) {
        const enum function f = i % 2 == 0 ? SAMPLE2_F64 : SAMPLE3_F64;
        const double tiles = i < 6 ? 1.0 : 0x1p20;
        block_random(here, &random, 8.0f);
        block_random(there, &random, 8.0f);
        for (int axis = 0; axis < 3; axis++) {
            for (size_t k = 0; k < BLOCK; k++) {
                here->d[axis][k] = floor(here->d[axis][k] * 256.0) / 256.0;
                there->d[axis][k] = here->d[axis][k] + (i / 2 % 3 == axis ? -48.0 : 16.0) * tiles;
            }
        }
        block_sample(here, &noise, f, BLOCK);
        block_sample(there, &noise, f, BLOCK);
        int member = 0;
        size_t index = 0;
        CHECK(outputs_equal(&here->out, &there->out, outputs_of(&noise, f), BLOCK, &member, &index),
              "%s: %s[%zu] does not repeat", function_names[f], output_names[member], index);
    }
    block_free(here);
    block_free(there);
}

/* Whether all outputs of point i are NaN (1), or those of a call without the other points (0). */
static void expect_nan(const struct block *got, const struct block *usual, unsigned mask, size_t i,
                       int nan, const char *what)
{
    for (int m = 0; m < OUTPUTS; m++) {
        const float *const value = &got->out.array[m][i];
        if ((mask >> m & 1) != 0) {
            CHECK(nan ? is_nan_bits(value)
                      : float_bits(value) == float_bits(&usual->out.array[m][i]),
                  "%s: %s[%zu] is %g", what, output_names[m], i, (double)*value);
        }
    }
}

/* NaN, infinities, and places where a position of the warp, or of the noise, overflows: NaN there,
   and nowhere else; likewise where octaves bend. */
static void test_not_finite(void)
{
    static const float bad[] = {NAN, INFINITY, -INFINITY, FLT_MAX, -FLT_MAX};
    const struct scarp_noise near_warp = {.seed = 2, .frequency = 0x1p-30, .amplitude = 0x1p24f};
    const struct scarp_noise far_warp = {.seed = 2, .frequency = 0x1p40, .amplitude = 0x1p24f};
    const struct scarp_noise noises[] = {
        {.octaves = 2.0f, .phase = 0.5f, .frequency = 0x1p20, .warp = &near_warp},
        {.octaves = 2.0f, .phase = 0.5f, .frequency = 0x1p-30, .warp = &far_warp},
        {.octaves = 3.0f, .fractal = SCARP_SWISS, .frequency = 0x1p20, .phase = 0.5f},
        {.octaves = 3.0f, .fractal = SCARP_JORDAN, .frequency = 0x1p20, .rotate = 1}};
    struct block *const usual = block_make(), *const got = block_make();
    for (int i = 0; i < 4 * FUNCTIONS; i++) {
        const enum function f = (enum function)(i / 4);
        const struct scarp_noise *const noise = &noises[i % 4];
        const unsigned mask = outputs_of(noise, f);
        uint64_t random = 1;
        block_random(usual, &random, 64.0f);
        memcpy(got->f, usual->f, sizeof got->f);
        memcpy(got->d, usual->d, sizeof got->d);
        for (size_t k = 0; k < BLOCK; k += 7) {
            const int axis = (int)(k / 7) % function_dimensions(f);
            got->f[axis][k] = bad[k / 7 % 5];
            got->d[axis][k] = k / 7 % 5 < 3           ? (double)bad[k / 7 % 5]
                              : bad[k / 7 % 5] > 0.0f ? DBL_MAX
                                                      : -DBL_MAX;
        }
        block_sample(usual, noise, f, BLOCK);
        block_sample(got, noise, f, BLOCK);
        for (size_t k = 0; k < BLOCK; k++) {
            expect_nan(got, usual, mask, k, k % 7 == 0, function_names[f]);
        }
    }
    block_free(usual);
    block_free(got);
}

/* The largest displacement is defined everywhere. */
static void test_large_amplitude(void)
{
    const struct scarp_noise w = {.seed = 2, .octaves = 2.0f, .amplitude = -0x1p24f};
    const struct scarp_noise noise = {.octaves = 2.0f, .warp = &w};
    struct block *const block = block_make();
    uint64_t random = 1;
    block_random(block, &random, 64.0f);
    for (int f = 0; f < FUNCTIONS; f++) {
        block_sample(block, &noise, (enum function)f, BLOCK);
        for (int m = 0; m < OUTPUTS; m++) {
            for (size_t i = 0; (outputs_of(&noise, (enum function)f) >> m & 1) != 0 && i < BLOCK;
                 i++) {
                CHECK(is_finite_bits(&block->out.array[m][i]), "%s: %s[%zu]", function_names[f],
                      output_names[m], i);
            }
        }
    }
    compare(&noise, "displaced by 2^24");
    check_worst("displaced by 2^24");
    block_free(block);
}

/* Outputs may be where coordinates are. */
static void test_in_place(void)
{
    const struct scarp_noise e = {.seed = 3, .fractal = SCARP_JORDAN, .octaves = 2.0f};
    const struct scarp_noise w = {.seed = 2, .octaves = 2.0f, .warp = &e};
    const struct scarp_noise noises[] = {{.octaves = 3.0f, .warp = &w},
                                         {.octaves = 3.0f, .fractal = SCARP_SWISS},
                                         {.octaves = 3.0f, .fractal = SCARP_JORDAN, .warp = &e}};
    struct block *const block = block_make();
    for (int i = 0; i < 6; i++) {
        const struct scarp_noise *const noise = &noises[i / 2];
        const enum function f = i % 2 == 0 ? SAMPLE2 : SAMPLE3;
        uint64_t random = 1;
        block_random(block, &random, 64.0f);
        block_sample(block, noise, f, BLOCK);
        const struct scarp_samples out = {
            .value = block->f[1], .dx = block->f[0], .dy = i % 2 == 0 ? NULL : block->f[2]};
        const struct inputs in = {.f = {block->f[0], block->f[1], block->f[2]}};
        CHECK(function_call(f, noise, BLOCK, &in, &out) == SCARP_OK, "%s", function_names[f]);
        CHECK(first_difference(block->f[1], block->out.array[OUTPUT_value], BLOCK) == BLOCK &&
                  first_difference(block->f[0], block->out.array[OUTPUT_dx], BLOCK) == BLOCK,
              "%s in place, noise %d", function_names[f], i / 2);
        CHECK(i % 2 == 0 ||
                  first_difference(block->f[2], block->out.array[OUTPUT_dy], BLOCK) == BLOCK,
              "%s in place, noise %d: dy", function_names[f], i / 2);
        const struct scarp_samples value = {.value =
                                                block->f[0]}; /* which takes a way of its own */
        block_random(block, &random, 64.0f);
        block_sample(block, noise, f, BLOCK);
        CHECK(function_call(f, noise, BLOCK, &in, &value) == SCARP_OK, "%s", function_names[f]);
        CHECK(first_difference(block->f[0], block->out.array[OUTPUT_value], BLOCK) == BLOCK,
              "%s in place, noise %d: the value alone", function_names[f], i / 2);
    }
    block_free(block);
}

int main(int argc, char **argv)
{
    check_isa_argument(argc, argv);
    test_fractals();
    test_chains();
    test_periods();
    test_not_finite();
    test_large_amplitude();
    test_in_place();
    return check_done();
}
