/* SPDX-License-Identifier: MIT
 *
 * Swiss and Jordan noise: their defaults, their ranges, what they repeat, what they do not support,
 * and their plans. (test_fractal.c compares them with the oracle.) Argument: the instruction set.
 */
#include "../src/plan/kept.h"
#include "fractal.h"

static int dimensions;

/* 0 in sharpness and erosion means the defaults of the fractal. */
static void check_defaults(struct block *x, struct block *y, enum scarp_fractal fractal)
{
    const enum function f = dimensions == 2 ? SAMPLE2 : SAMPLE3;
    const float sharpness = fractal_row(fractal)->sharpness;
    struct scarp_noise noise = {.fractal = fractal, .octaves = 3.0f}, given = noise;
    int member = 0;
    size_t index = 0;
    uint64_t random = 1;
    block_random(x, &random, 64.0f);
    given.sharpness = sharpness;
    given.erosion = 1.0f;
    block_sample(x, &noise, f, BLOCK);
    memcpy(y->f, x->f, sizeof y->f);
    block_sample(y, &given, f, BLOCK);
    CHECK(outputs_equal(&x->out, &y->out, outputs_of(&noise, f), BLOCK, &member, &index),
          "%s: other defaults", fractal_name((int)fractal));
    given.sharpness = 2.0f * sharpness;
    block_sample(y, &given, f, BLOCK);
    CHECK(!outputs_equal(&x->out, &y->out, 1, BLOCK, &member, &index), "sharpness is ignored");
    given.sharpness = sharpness;
    given.erosion = 0.5f;
    block_sample(y, &given, f, BLOCK);
    CHECK(outputs_equal(&x->out, &y->out, 1, BLOCK, &member, &index) ==
              (fractal_row(fractal)->most_erosion == 0.0f),
          "%s: erosion", fractal_name((int)fractal));
}

/* Values lie between 0 and the amplitude, and scarp_range says so; with a phase, those of Jordan
   noise reach as far as the square of an octave does. */
static void check_range(struct block *block, enum scarp_fractal fractal, int i)
{
    static const double reach[2][2] = {{1.0169038, 1.0162356}, {1.1100620, 1.1037150}};
    const float a = i % 2 == 0 ? 2.5f : -0.7f;
    const struct scarp_noise noise = {.fractal = fractal,
                                      .basis = (enum scarp_basis)(i / 2 % count_names(basis_name)),
                                      .fade = (enum scarp_fade)(i / 32 % 2),
                                      .amplitude = a,
                                      .octaves = i % 3 == 0 ? 1.0f : 4.5f,
                                      .erosion = i % 5 == 0 ? 0x1p-24f : 0.0f,
                                      .sharpness = i % 7 == 0 ? 64.0f : 0.0f,
                                      .phase = i / 2 % 8 == 0 ? 0.37f : 0.0f};
    const double far = reach[dimensions - 2][noise.fade];
    const double square =
        noise.phase != 0.0f && fractal_row(fractal)->range == RANGE_SQUARE ? far * far : 1.0;
    float range[2] = {7.0f, -7.0f};
    uint64_t random = 1;
    CHECK(scarp_range(&noise, dimensions, &range[0], &range[1]) == SCARP_OK, "refused");
    const double end = (double)(a < 0.0f ? range[0] : range[1]) / (double)a;
    CHECK((a < 0.0f ? range[1] : range[0]) == 0.0f && fabs(end - square) <= 1e-6,
          "%s, phase %g: the range is %g to %g", fractal_name((int)fractal), (double)noise.phase,
          (double)range[0], (double)range[1]);
    block_random(block, &random, 64.0f);
    for (size_t k = 0; k < BLOCK; k += 3) { /* on the lattice */
        for (int axis = 0; axis < 3; axis++) {
            block->d[axis][k] = floor(block->d[axis][k]);
        }
    }
    block_sample(block, &noise, dimensions == 2 ? SAMPLE2_F64 : SAMPLE3_F64, BLOCK);
    for (size_t k = 0; k < BLOCK; k++) {
        const double v = (double)block->out.array[0][k] / (double)a;
        CHECK(v >= 0.0 && v <= square, "%s, %s: %.9g of the amplitude", fractal_name((int)fractal),
              basis_name((int)noise.basis), v);
    }
}

/* Values are numbers within the range even where a_0 is too small for floats, or 0. */
static void check_tiny_weight(struct block *block, enum scarp_fractal fractal)
{
    const float amplitude = fractal == SCARP_SWISS ? -0x1p-24f : 0x1p-24f;
    const struct scarp_noise noises[] = {
        {.octaves = 30.0f, .lacunarity = 1.0f, .gain = 16.0f},
        {.octaves = 1e-40f, .of_octaves = 1.0f},
        {.octaves = 1e-40f, .of_octaves = 2.0f, .gain = 16.0f},
    };
    uint64_t random = 1;
    block_random(block, &random, 64.0f);
    for (size_t i = 0; i < sizeof noises / sizeof noises[0]; i++) {
        struct scarp_noise noise = noises[i];
        noise.fractal = fractal;
        noise.amplitude = amplitude;
        block_sample(block, &noise, dimensions == 2 ? SAMPLE2_F64 : SAMPLE3_F64, BLOCK);
        for (size_t k = 0; k < BLOCK; k++) {
            const float v = block->out.array[0][k] / amplitude;
            CHECK(v >= 0.0f && v <= 1.0f, "%s, noise %zu: %.9g of the amplitude",
                  fractal_name((int)fractal), i, (double)v);
        }
    }
}

/* What lies a period further differs by roundings at most. */
static void check_periods(struct block *x, struct block *y, enum scarp_fractal fractal)
{
    const struct scarp_noise noise = {.fractal = fractal,
                                      .octaves = 3.5f,
                                      .lacunarity = 3.0f,
                                      .frequency = 0.5,
                                      .period = {6, 16, 289}};
    const enum function f = dimensions == 2 ? SAMPLE2_F64 : SAMPLE3_F64;
    uint64_t random = 1;
    block_random(x, &random, 64.0f);
    for (int axis = 0; axis < dimensions; axis++) {
        memcpy(y->d, x->d, sizeof y->d);
        for (size_t i = 0; i < BLOCK; i++) {
            y->d[axis][i] += (double)noise.period[axis] * -6.0;
        }
        block_sample(x, &noise, f, BLOCK);
        block_sample(y, &noise, f, BLOCK);
        for (int m = 0; m <= dimensions; m++) {
            for (size_t i = 0; i < BLOCK; i++) {
                const double off = fabs((double)x->out.array[m][i] - (double)y->out.array[m][i]);
                CHECK(off <= 1e-4, "%s[%zu] is off by %g", output_names[m], i, off);
            }
        }
    }
}

/* Second derivatives and dphase are not supported, erosion above 1 is an error where it is a share. */
static void check_refused(struct block *block, enum scarp_fractal fractal)
{
    const enum function f = dimensions == 2 ? SAMPLE2 : SAMPLE3;
    struct scarp_noise noise = {.fractal = fractal, .octaves = 2.0f, .phase = 0.3f};
    const struct inputs in = {.f = {block->f[0], block->f[1], block->f[2]}};
    const char *member = NULL;
    for (int m = 0; m < OUTPUTS; m++) {
        const struct scarp_samples out = outputs_subset(&block->out, 1u << m);
        const int has = (outputs_of(&noise, f) >> m & 1) != 0;
        outputs_poison(&block->out);
        CHECK(function_call(f, &noise, BLOCK, &in, &out) ==
                  (has ? SCARP_OK : SCARP_ERROR_UNSUPPORTED),
              "%s: %s", fractal_name((int)fractal), output_names[m]);
        CHECK(outputs_untouched(&block->out, has ? ~(1u << m) : ~0u), "%s: written",
              output_names[m]);
    }
    noise.erosion = nextafterf(1.0f, 2.0f);
    const enum scarp_status wanted =
        fractal_row(fractal)->most_erosion == 1.0f ? SCARP_ERROR_PARAMETER : SCARP_OK;
    CHECK(scarp_noise_check(&noise, dimensions, &member) == wanted &&
              (wanted == SCARP_OK || (member != NULL && strcmp(member, "erosion") == 0)),
          "%s: erosion above 1", fractal_name((int)fractal));
    noise.erosion = 1.0f;
    CHECK(scarp_noise_check(&noise, dimensions, NULL) == SCARP_OK, "erosion 1");
}

/* Calls with a plan give the same bits, and use it. */
static void check_plan(struct block *x, struct block *y, enum scarp_fractal fractal)
{
    static struct scarp_plan plan;
    struct scarp_noise noise = {.fractal = fractal, .octaves = 3.0f, .phase = 0.3f, .rotate = 1};
    int member = 0;
    size_t index = 0;
    memcpy(y->f, x->f, sizeof y->f);
    memcpy(y->d, x->d, sizeof y->d);
    for (int i = 0; i < 2; i++) {
        const enum function f = (enum function)(dimensions == 2 ? 2 * i : 2 * i + 1);
        struct scarp_noise with = noise;
        CHECK(scarp_plan_make(&noise, dimensions, &plan) == SCARP_OK, "no plan");
        with.plan = &plan;
        block_sample(x, &noise, f, BLOCK);
        block_sample(y, &with, f, BLOCK);
        CHECK(outputs_equal(&x->out, &y->out, outputs_of(&noise, f), BLOCK, &member, &index),
              "%s: the plan changes %s", fractal_name((int)fractal), output_names[member]);
        /* the constants of octave 0 and 1 */
        unsigned char *const octave = (unsigned char *)&plan + offsetof(struct kept, octave);
        for (size_t b = 0; b < 400; b++) {
            octave[b] ^= 0x10;
        }
        block_sample(y, &with, f, BLOCK);
        CHECK(!outputs_equal(&x->out, &y->out, 1, BLOCK, &member, &index), "the plan is unused");
    }
}

int main(int argc, char **argv)
{
    check_isa_argument(argc, argv);
    struct block *const x = block_make(), *const y = block_make();
    for (int i = 0; i < 2 * SCARP_FRACTALS; i++) {
        const enum scarp_fractal fractal = (enum scarp_fractal)(i / 2);
        if (!fractal_bends(fractal)) {
            continue;
        }
        dimensions = 2 + i % 2;
        check_defaults(x, y, fractal);
        check_tiny_weight(x, fractal);
        check_periods(x, y, fractal);
        check_refused(x, fractal);
        check_plan(x, y, fractal);
        for (int k = 0; k < 64; k++) {
            check_range(x, fractal, k);
        }
    }
    block_free(x);
    block_free(y);
    return check_done();
}
