/* SPDX-License-Identifier: MIT
 *
 * The answers of the self-test for shaders: they are what their definition says, which is computed
 * here from the results of sample calls, with every kernel set.
 *
 *     test_gpu_answers ISA
 */
#include "check.h"

#include "../src/formulas/lattice.h"

#define POISON 0xa5

/* The test points, their outputs and hashes, as the header and the shaders have them. */
struct points {
    float x[3][SCARP_GPU_ANSWERS];
    float of[10][SCARP_GPU_ANSWERS];
    uint32_t hash[SCARP_GPU_ANSWERS];
};

static struct points points;

/* How often outputs were what the hash must not depend on. */
static long small_ones, negative_zeros;

static uint32_t bits_for_hash(float output)
{
    uint32_t bits;
    memcpy(&bits, &output, sizeof bits);
    negative_zeros += bits == 0x80000000u;
    small_ones += output != 0.0f && fabsf(output) < 0x1p-120f;
    return fabsf(output) < 0x1p-120f ? 0 : bits;
}

/* Computes them for a noise. */
static enum scarp_status points_compute(const struct scarp_noise *noise, int dimensions, int order)
{
    static const int planar[] = {0, 1, 2, 4, 5, 7}; /* of value dx dy dz dxx dxy dxz dyy dyz dzz */
    static const int ends[2][3] = {{1, 3, 6}, {1, 4, 10}};
    const uvec3 key = {0, 0, 0};
    const int count = ends[dimensions - 2][order];
    struct scarp_samples out = {0};
    float **const list = (float **)&out;
    struct scarp_gpu_plan plan;
    enum scarp_status status = scarp_gpu_plan_make(noise, dimensions, &plan, NULL);
    for (int i = 0; i < count; i++) {
        list[dimensions == 2 ? planar[i] : i] = points.of[i];
    }
    for (uint32_t i = 0; i < 3 * SCARP_GPU_ANSWERS; i++) {
        const int c = (int)(hash2(key, i / 3, i % 3) >> 12) - 524288;
        points.x[i % 3][i / 3] = (float)c * plan.unit;
    }
    status =
        dimensions == 2
            ? scarp_sample2(noise, SCARP_GPU_ANSWERS, points.x[0], points.x[1], &out)
            : scarp_sample3(noise, SCARP_GPU_ANSWERS, points.x[0], points.x[1], points.x[2], &out);
    for (int i = 0; i < SCARP_GPU_ANSWERS; i++) {
        uint32_t h = 0;
        for (int j = 0; j < count; j++) {
            h = ((h << 5 | h >> 27) ^ bits_for_hash(points.of[j][i])) * 0x9e3779b9u;
        }
        points.hash[i] = h;
    }
    return status;
}

/* FNV-1a of all answers. */
static uint64_t answers_checksum(const uint32_t *answer)
{
    uint64_t hash = FNV_BASIS;
    for (int i = 0; i < SCARP_GPU_ANSWERS; i++) {
        hash = (hash ^ answer[i]) * UINT64_C(0x100000001b3);
    }
    return hash;
}

static uint64_t answers_of(const struct scarp_noise *noise, int dimensions, int order)
{
    static uint32_t answer[SCARP_GPU_ANSWERS + 1];
    memset(answer, POISON, sizeof answer);
    CHECK(scarp_gpu_answers(noise, dimensions, order, answer) == SCARP_OK, "order %d", order);
    CHECK(answer[SCARP_GPU_ANSWERS] == 0x01010101u * POISON, "one answer more was written");
    return answers_checksum(answer);
}

static const struct scarp_noise flowing = {
    .octaves = 2.0f, .seed = 5, .phase = -1.3f, .frequency = 0.3, .amplitude = 0.2f};

/* Answers are what their definition says, the same with this kernel set as with the scalar one, and
   different for different orders and seeds. */
static void test_answers(enum scarp_isa isa)
{
    const struct scarp_noise noises[] = {
        {0},
        {.seed = 1},
        {.octaves = 3.0f, .rotate = 1, .frequency = 0.3, .fractal = SCARP_RIDGED},
        {.basis = SCARP_SIMPLEX, .octaves = 2.0f, .warp = &flowing},
        {.basis = SCARP_CELL_VALUE, .amplitude = -1.0f},             /* slopes are -0 */
        {.of_octaves = 32.0f, .gain = 16.0f, .amplitude = 64.0f},    /* small */
        {.of_octaves = 32.0f, .gain = 16.0f, .amplitude = 0x1p-20f}, /* all vanish */
        {.basis = SCARP_CELL_EDGE, .frequency = 100.0, .period = {5, 7}},
        {.octaves = 2.0f, .offset_first = 1},
    };
    enum { NOISES = sizeof noises / sizeof noises[0], CASES = NOISES * 6 };
    uint64_t seen[CASES];
    long differing = 0;
    for (int i = 0; i < CASES; i++) {
        const struct scarp_noise *const noise = &noises[i / 6];
        const int dimensions = 2 + i / 3 % 2, order = i % 3;
        seen[i] = answers_of(noise, dimensions, order);
        CHECK(seen[i] == answers_of(noise, dimensions, order), "case %d: differs again", i);
        CHECK(points_compute(noise, dimensions, order) == SCARP_OK, "case %d", i);
        CHECK(seen[i] == answers_checksum(points.hash), "case %d: not as defined", i);
        scarp_isa_select(SCARP_ISA_SCALAR);
        CHECK(seen[i] == answers_of(noise, dimensions, order), "case %d: other kernels", i);
        scarp_isa_select(isa);
        for (int j = 0; j < i && i / 6 != 6; j++) {
            CHECK(seen[j] != seen[i], "cases %d and %d are alike", j, i);
            differing += seen[j] != seen[i];
        }
    }
    CHECK(differing > 0 && small_ones > 1000 && negative_zeros > 1000,
          "%ld small results, %ld negative zeros", small_ones, negative_zeros);
}

/* Test points are spread evenly along each axis, and few are on lattice points. */
static void test_points(void)
{
    const struct scarp_noise noise = {0};
    CHECK(points_compute(&noise, 3, 0) == SCARP_OK, "not sampled");
    for (int axis = 0; axis < 3; axis++) {
        long quarter[4] = {0, 0, 0, 0}, whole = 0;
        for (int i = 0; i < SCARP_GPU_ANSWERS; i++) {
            const float p = points.x[axis][i], at = floorf(p / 1024.0f) + 2.0f;
            CHECK(at >= 0.0f && at < 4.0f, "point %d lies at %g", i, (double)p);
            quarter[(int)at & 3]++;
            whole += p == floorf(p);
        }
        for (int i = 0; i < 4; i++) {
            CHECK(quarter[i] > 900 && quarter[i] < 1150, "axis %d: %ld points", axis, quarter[i]);
        }
        CHECK(whole < 40, "axis %d: %ld points lie on lattice points", axis, whole);
    }
}

/* Orders that do not exist, or that the noise or a warp does not have. */
static void test_orders(void)
{
    static const struct scarp_noise erosion = {.fractal = SCARP_EROSION, .octaves = 2.0f};
    const struct scarp_noise plain = {0}, warped = {.warp = &erosion};
    uint32_t answer[SCARP_GPU_ANSWERS];
    memset(answer, POISON, sizeof answer);
    CHECK(scarp_gpu_answers(&plain, 2, -1, answer) == SCARP_ERROR_PARAMETER, "order -1");
    CHECK(scarp_gpu_answers(&plain, 2, 3, answer) == SCARP_ERROR_PARAMETER, "order 3");
    CHECK(scarp_gpu_answers(&erosion, 3, 2, answer) == SCARP_ERROR_UNSUPPORTED, "no Hessian");
    CHECK(scarp_gpu_answers(&warped, 2, 2, answer) == SCARP_ERROR_UNSUPPORTED, "no Hessian of d");
    for (int i = 0; i < SCARP_GPU_ANSWERS; i++) {
        CHECK(answer[i] == 0x01010101u * POISON, "answer %d has changed", i);
    }
    CHECK(scarp_gpu_answers(&warped, 2, 1, answer) == SCARP_OK, "order 1");
}

int main(int argc, char **argv)
{
    const enum scarp_isa isa = check_isa_argument(argc, argv);
    test_answers(isa);
    test_points();
    test_orders();
    return check_done();
}
