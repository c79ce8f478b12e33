/* SPDX-License-Identifier: MIT
 *
 * The source of the shaders, compiled as C, against the library: the same bits, but for the sign of
 * 0, of every basis, fractal, and way that octaves can be made. So a shader that differs from the
 * library is translated wrongly, or its driver is at fault. The inverse and the root, which shaders
 * approximate and correct, are compared over all mantissas.
 */
#include "../src/plan/traits.h"
#include "check.h"
#include "scarp.h"

static int estimate_error; /* of inverses and roots, in units in the last place */
#define SCARP_GPU_ERROR estimate_error
#include "../src/gpu/noise.h"

enum { POINTS = 48 };

_Static_assert(sizeof(struct plan) == sizeof(struct scarp_gpu_plan),
               "the shaders' plan has the members of the library's");

/* What is made of a noise before it is sampled. */
enum variant { STRAIGHT, TURNED, PERIODS, POWERS, FLOWING, WARPED, WARPED_TWICE, VARIANTS };
static const char *const variant_names[VARIANTS] = {"straight", "turned", "periods",     "powers",
                                                    "flowing",  "warped", "warped twice"};

struct warps {
    struct scarp_noise first, second;
};

/* A noise of one to eight octaves; with a warp, of few. */
static struct scarp_noise noise_of(unsigned basis, unsigned fractal, enum variant variant,
                                   struct warps *warps, uint64_t *random)
{
    const float octaves = (float)(1 + check_random(random) % (variant < WARPED ? 8 : 3));
    struct scarp_noise noise = {
        .basis = (enum scarp_basis)basis,
        .fractal = (enum scarp_fractal)fractal,
        .fade = (enum scarp_fade)(check_random(random) % 2),
        .rotate = variant == TURNED || variant >= WARPED,
        .seed = check_random(random),
        .frequency =
            check_random(random) % 2 != 0 ? 0.5 : 0.25 + (double)check_random_float(random, 0.2f),
        .octaves = octaves - (check_random(random) % 2 != 0 ? 0.25f : 0.0f),
        .lacunarity = 2.0f + check_random_float(random, 0.5f),
        .gain = 0.6f + check_random_float(random, 0.2f),
        .amplitude = 2.0f + check_random_float(random, 1.0f),
        .jitter = check_random(random) % 2 != 0 ? 0.7f : 0.0f,
    };
    noise.offset_first = noise.seed >> 40 & 1;
    if (variant == PERIODS || variant == POWERS) {
        noise.lacunarity = 2.0f;
        noise.period[0] = variant == POWERS ? 8 : 7;
        noise.period[1] = basis == SCARP_SIMPLEX ? 0 : variant == POWERS ? 16 : 5;
        noise.period[2] = variant == POWERS ? 4 : 3;
    }
    if (variant == FLOWING && basis == SCARP_GRADIENT) {
        noise.phase = 0.5f + check_random_float(random, 3.0f);
    }
    if (variant >= WARPED) {
        warps->first =
            noise_of((unsigned)(check_random(random) % SCARP_BASES),
                     (unsigned)(check_random(random) % SCARP_FRACTALS), TURNED, NULL, random);
        warps->first.octaves = variant == WARPED ? 3.0f : 1.5f;
        noise.warp = &warps->first;
    }
    if (variant == WARPED_TWICE) {
        warps->second = noise_of(SCARP_GRADIENT, SCARP_FBM, FLOWING, NULL, random);
        warps->second.octaves = 2.0f;
        warps->first.warp = &warps->second;
    }
    return noise;
}

/* Whether the library has a Hessian of the noise. */
static int has_hessian(const struct scarp_noise *noise)
{
    for (; noise != NULL; noise = noise->warp) {
        if (fractal_has(noise->fractal, FRACTAL_SLOPES)) {
            return 0;
        }
    }
    return 1;
}

/* The outputs of the shaders, in the order of struct scarp_samples. */
static void outputs_of(float of[10], const struct sample *s)
{
    const float all[10] = {s->value,   s->gradient.x, s->gradient.y, s->gradient.z, s->diagonal.x,
                           s->mixed.x, s->mixed.y,    s->diagonal.y, s->mixed.z,    s->diagonal.z};
    memcpy(of, all, sizeof all);
}

/* Equal bits, or both 0. */
static int same(float a, float b)
{
    return memcmp(&a, &b, sizeof a) == 0 || (a == 0.0f && b == 0.0f);
}

static float coordinate(uint64_t *random, int i)
{
    return i % 16 == 15 ? check_random_float(random, 1e20f)
           : i % 4 == 0 ? (float)((int)(check_random(random) % 65) - 32) * 0.5f
           : i % 4 == 1 ? check_random_float(random, 40000.0f)
                        : check_random_float(random, 100.0f);
}

static void compare(const struct scarp_noise *noise, int dimensions, uint64_t *random,
                    const char *variant)
{
    struct scarp_gpu_plan gpu;
    static struct plan plan; /* scarp_plan keeps pointing to it */
    const char *member = NULL;
    float x[3][POINTS], of[10][POINTS];
    const int last = has_hessian(noise) ? 10 : 4;
    struct scarp_samples out = {
        .value = of[0], .dx = of[1], .dy = of[2], .dz = dimensions == 3 ? of[3] : NULL};
    float **const second = &out.dxx;
    for (int i = 4; i < last; i++) {
        const int along_z = i == 6 || i == 8 || i == 9;
        second[i - 4] = dimensions == 3 || !along_z ? of[i] : NULL;
    }
    for (int i = 0; i < POINTS; i++) {
        for (int axis = 0; axis < 3; axis++) {
            x[axis][i] = coordinate(random, i);
        }
    }
    CHECK(scarp_gpu_plan_make(noise, dimensions, &gpu, &member) == SCARP_OK, "%s", member);
    memcpy(&plan, &gpu, sizeof plan);
    scarp_plan = &plan;
    CHECK((dimensions == 2 ? scarp_sample2(noise, POINTS, x[0], x[1], &out)
                           : scarp_sample3(noise, POINTS, x[0], x[1], x[2], &out)) == SCARP_OK,
          "sampled");
    for (int i = 0; i < POINTS; i++) {
        float shader[10];
        const struct sample s =
            dimensions == 2 ? sample2(0, x[0][i], x[1][i]) : sample3(0, x[0][i], x[1][i], x[2][i]);
        outputs_of(shader, &s);
        for (int output = 0; output < last; output++) {
            if (output < 4 ? output < 3 || dimensions == 3 : second[output - 4] != NULL) {
                CHECK(same(shader[output], of[output][i]),
                      "%dD %s %s %s, output %d at (%a, %a, %a): shader %a, library %a", dimensions,
                      scarp_basis_name(noise->basis), scarp_fractal_name(noise->fractal), variant,
                      output, (double)x[0][i], (double)x[1][i], (double)x[2][i],
                      (double)shader[output], (double)of[output][i]);
            }
        }
    }
}

static void compare_noises(int rounds)
{
    uint64_t random = 17;
    for (int round = 0; round < rounds; round++) {
        for (unsigned basis = 0; scarp_basis_name((enum scarp_basis)basis) != NULL; basis++) {
            for (unsigned fractal = 0; scarp_fractal_name((enum scarp_fractal)fractal) != NULL;
                 fractal++) {
                for (int variant = 0; variant < VARIANTS; variant++) {
                    struct warps warps;
                    const struct scarp_noise noise =
                        noise_of(basis, fractal, (enum variant)variant, &warps, &random);
                    compare(&noise, 2, &random, variant_names[variant]);
                    compare(&noise, 3, &random, variant_names[variant]);
                }
            }
        }
    }
}

/* The self-test of shaders, which hashes the same outputs as scarp_gpu_answers. */
static void compare_answers(void)
{
    static uint32_t answers[SCARP_GPU_ANSWERS];
    struct scarp_noise noise = {.frequency = 0.01, .octaves = 3.0f, .rotate = 1};
    for (int dimensions = 2; dimensions <= 3; dimensions++) {
        for (int order = 0; order <= 2; order++) {
            struct scarp_gpu_plan gpu;
            static struct plan plan; /* scarp_plan keeps pointing to it */
            CHECK(scarp_gpu_plan_make(&noise, dimensions, &gpu, NULL) == SCARP_OK &&
                      scarp_gpu_answers(&noise, dimensions, order, answers) == SCARP_OK,
                  "answered");
            memcpy(&plan, &gpu, sizeof plan);
            scarp_plan = &plan;
            for (uint i = 0; i < SCARP_GPU_ANSWERS; i++) {
                const uint answer =
                    dimensions == 2 ? answer2(0, (uint)order, i) : answer3(0, (uint)order, i);
                CHECK(answer == answers[i], "%dD, order %d, answer %u", dimensions, order, i);
            }
        }
    }
}

/* All mantissas with a step, at exponents from one end to the other. */
static void compare_rounding(uint32_t step)
{
    for (estimate_error = -8; estimate_error <= 8; estimate_error += 2) {
        for (uint32_t m = 0; m < 1u << 23; m += step) {
            const uint32_t exponent = 1 + m % 252;
            const float x = float_of_bits(exponent << 23 | m);
            CHECK(inverse(x) == 1.0f / x, "1 / %a, off by %d: %a", (double)x, estimate_error,
                  (double)inverse(x));
            CHECK(root(x) == sqrtf(x), "root of %a, off by %d: %a", (double)x, estimate_error,
                  (double)root(x));
        }
    }
    estimate_error = 0;
    CHECK(root(0.0f) == 0.0f && inverse(0x1p126f) == 0.0f, "the ends");
}

int main(int argc, char **argv)
{
    const int few = argc > 1; /* what runs slowly looks at fewer */
    (void)argv;
    compare_noises(few ? 1 : 3);
    compare_answers();
    compare_rounding(few ? 101 : 1);
    return check_done();
}
