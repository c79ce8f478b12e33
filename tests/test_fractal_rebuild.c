/* SPDX-License-Identifier: MIT
 *
 * Rebuilds every fractal but those that bend (test_bend.c) from single-octave calls as the text of
 * scarp.h says, in double: seeds, offsets, turns, weights, and the formulas for value, gradient and
 * Hessian. Nothing of the oracle comes in but for the layout of a sample: this is what a reader of
 * the header could write. Argument: the number of points per case.
 */
#include "fractal.h"
#include "octaves.h"

#define OCTAVES 5 /* at most */

/* Points where some |n_k|, |2 s_k - 1| or their like is below this may lie on the other side of a
 * crease. */
#define CREASE 1e-5

static int dimensions;

/* Component i of J_k x + o_k. Where axes are turned, it is the sum of two parts, each of which is
   rounded to a multiple of 2^-24 (scarp.h, "Rounding"). */
static double rebuild_position(const struct octave *octave, const struct block *from, int i,
                               size_t at)
{
    const double *const j = octave->axes[i];
    const double first = j[0] * from->d[0][at];
    double rest = j[1] * from->d[1][at] + (dimensions == 3 ? j[2] * from->d[2][at] : 0.0);
    rest += octave->offset[i];
    return octave->turned ? rint(first * 0x1p24) * 0x1p-24 + rint(rest * 0x1p24) * 0x1p-24
                          : first + rest;
}

/* Samples octave k at J_k x + o_k, for all points of `from`, and divides by 1 - 2^-17. The n_k of
   hybrid noise have that factor, too. */
static void sample_octave(const struct block *from, struct block *to,
                          const struct scarp_noise *noise, const struct octave *octave,
                          struct oracle_sample n[BLOCK])
{
    const enum function f = dimensions == 2 ? SAMPLE2_F64 : SAMPLE3_F64;
    const struct scarp_noise single = {
        .basis = noise->basis, .fade = noise->fade, .seed = octave->seed};
    for (size_t i = 0; i < BLOCK; i++) {
        for (int row = 0; row < dimensions; row++) {
            to->d[row][i] = rebuild_position(octave, from, row, i);
        }
    }
    const double divisor = noise->fractal == SCARP_HYBRID ? 1.0 : 1.0 - 0x1p-17;
    block_sample(to, &single, f, BLOCK);
    for (size_t i = 0; i < BLOCK; i++) {
        n[i] = block_result(to, &single, f, i);
        n[i].value /= divisor;
        for (int a = 0; a < 3; a++) {
            n[i].gradient[a] /= divisor;
            for (int b = 0; b < 3; b++) {
                n[i].hessian[a][b] /= divisor;
            }
        }
    }
}

/* The derivatives of n_k with respect to x: G_k = J_k^T g_k and J_k^T H_k J_k. */
static struct oracle_sample in_input(const struct octave *octave, const struct oracle_sample *n)
{
    struct oracle_sample s = {.value = n->value};
    for (int i = 0; i < 81; i++) {
        const int a = i / 27, b = i / 9 % 3, l = i / 3 % 3, m = i % 3;
        s.hessian[a][b] += octave->axes[l][a] * n->hessian[l][m] * octave->axes[m][b];
        if (b == 0 && m == 0) {
            s.gradient[a] += octave->axes[l][a] * n->gradient[l];
        }
    }
    return s;
}

/* The sums of fBm and turbulence: sum a_k n_k, sum a_k |n_k|. */
static struct oracle_sample plain_sum(int count, const struct octave octave[OCTAVES],
                                      const struct oracle_sample n[OCTAVES], int magnitudes)
{
    struct oracle_sample sum = {.value = 0.0};
    for (int k = 0; k < count; k++) {
        const struct oracle_sample s = in_input(&octave[k], &n[k]);
        const double a = magnitudes && s.value < 0.0 ? -octave[k].weight : octave[k].weight;
        sum.value += a * s.value;
        for (int i = 0; i < 9; i++) {
            sum.hessian[i / 3][i % 3] += a * s.hessian[i / 3][i % 3];
        }
        for (int i = 0; i < 3; i++) {
            sum.gradient[i] += a * s.gradient[i];
        }
    }
    return sum;
}

/*
 * Ridged: s = v r^2 with r = 1 - |n|, whose derivatives along i and j, with m = |n|, are
 *     s_i  = v_i r^2 - 2 v r m_i
 *     s_ij = v_ij r^2 - 2 r (v_i m_j + v_j m_i) + 2 v (m_i m_j - r m_ij).
 */
static struct oracle_sample ridged_sum(int count, const struct octave octave[OCTAVES],
                                       const struct oracle_sample n[OCTAVES])
{
    struct oracle_sample sum = {.value = 0.0}, v = {.value = 1.0};
    for (int k = 0; k < count; k++) {
        const struct oracle_sample p = in_input(&octave[k], &n[k]);
        const double sign = p.value > 0.0 ? 1.0 : p.value < 0.0 ? -1.0 : 0.0;
        const double r = 1.0 - fabs(p.value), a = octave[k].weight;
        const double s = v.value * r * r;
        const double twice = 2.0 * s < 1.0 ? 2.0 : 0.0;
        struct oracle_sample next = {.value = twice > 0.0 ? 2.0 * s : 1.0};
        sum.value += a * s;
        for (int i = 0; i < 3; i++) {
            const double mi = sign * p.gradient[i];
            const double si = v.gradient[i] * r * r - 2.0 * v.value * r * mi;
            sum.gradient[i] += a * si;
            next.gradient[i] = twice * si;
            for (int j = 0; j < 3; j++) {
                const double mj = sign * p.gradient[j], mij = sign * p.hessian[i][j];
                const double sij = v.hessian[i][j] * r * r -
                                   2.0 * r * (v.gradient[i] * mj + v.gradient[j] * mi) +
                                   2.0 * v.value * (mi * mj - r * mij);
                sum.hessian[i][j] += a * sij;
                next.hessian[i][j] = twice * sij;
            }
        }
        v = next;
    }
    return sum;
}

/* Erosion: gradient = sum_k a_k (q_k G_k - 2 erosion n_k q_k^2 D_k^T d_k). */
static struct oracle_sample erosion_sum(int count, const struct octave octave[OCTAVES],
                                        const struct oracle_sample n[OCTAVES], double erosion)
{
    struct oracle_sample sum = {.value = 0.0};
    double d[3] = {0.0, 0.0, 0.0}, jacobian[3][3] = {{0.0}};
    for (int k = 0; k < count; k++) {
        const struct oracle_sample p = in_input(&octave[k], &n[k]);
        double squares = 0.0;
        for (int i = 0; i < 3; i++) {
            d[i] += n[k].gradient[i];
            squares += d[i] * d[i];
            for (int j = 0; j < 9; j++) {
                jacobian[i][j / 3] += n[k].hessian[i][j % 3] * octave[k].axes[j % 3][j / 3];
            }
        }
        const double q = 1.0 / (1.0 + erosion * squares);
        sum.value += octave[k].weight * q * n[k].value;
        for (int j = 0; j < 3; j++) {
            const double steeper =
                jacobian[0][j] * d[0] + jacobian[1][j] * d[1] + jacobian[2][j] * d[2];
            sum.gradient[j] += octave[k].weight *
                               (q * p.gradient[j] - 2.0 * erosion * n[k].value * q * q * steeper);
        }
    }
    return sum;
}

/* Ping-pong: t = (n + 1) sharpness folded to [-1, 1]; derivatives +-2 sharpness times those of n.
 */
static struct oracle_sample pingpong_sum(int count, const struct octave octave[OCTAVES],
                                         const struct oracle_sample n[OCTAVES], double sharpness)
{
    struct oracle_sample sum = {.value = 0.0};
    for (int k = 0; k < count; k++) {
        const struct oracle_sample p = in_input(&octave[k], &n[k]);
        const double t = (p.value + 1.0) * sharpness, whole = floor(t);
        const int rises = fmod(whole, 2.0) == 0.0;
        const double fold = rises ? t - whole : 1.0 - (t - whole);
        const double slope = octave[k].weight * (rises ? 2.0 : -2.0) * sharpness;
        sum.value += octave[k].weight * (2.0 * fold - 1.0);
        for (int i = 0; i < 9; i++) {
            sum.hessian[i / 3][i % 3] += slope * p.hessian[i / 3][i % 3];
        }
        for (int i = 0; i < 3; i++) {
            sum.gradient[i] += slope * p.gradient[i];
        }
    }
    return sum;
}

/* Hybrid: u = v r with r = n + sharpness, and v' = gain^k u, which is 1 or -1 beyond these. */
static struct oracle_sample hybrid_sum(const struct scarp_noise *noise, int count,
                                       const struct octave octave[OCTAVES],
                                       const struct oracle_sample n[OCTAVES])
{
    struct oracle_sample sum = {.value = 0.0}, v = {.value = 1.0};
    for (int k = 0; k < count; k++) {
        const struct oracle_sample p = in_input(&octave[k], &n[k]);
        const double r = p.value + (double)noise->sharpness, w = pow((double)noise->gain, k);
        const double u = v.value * r, a = octave[k].weight;
        const double part = fabs(w * u) < 1.0 ? w : 0.0;
        struct oracle_sample next = {.value = part > 0.0 ? w * u : u < 0.0 ? -1.0 : 1.0};
        sum.value += a * u;
        for (int i = 0; i < 3; i++) {
            const double ui = v.gradient[i] * r + v.value * p.gradient[i];
            sum.gradient[i] += a * ui;
            next.gradient[i] = part * ui;
            for (int j = 0; j < 3; j++) {
                const double uij = v.hessian[i][j] * r + v.value * p.hessian[i][j] +
                                   v.gradient[i] * p.gradient[j] + v.gradient[j] * p.gradient[i];
                sum.hessian[i][j] += a * uij;
                next.hessian[i][j] = part * uij;
            }
        }
        v = next;
    }
    return sum;
}

static struct oracle_sample rebuilt_sum(const struct scarp_noise *noise, int count,
                                        const struct octave octave[OCTAVES],
                                        const struct oracle_sample n[OCTAVES])
{
    switch (noise->fractal) {
    case SCARP_RIDGED: return ridged_sum(count, octave, n);
    case SCARP_PINGPONG: return pingpong_sum(count, octave, n, (double)noise->sharpness);
    case SCARP_HYBRID: return hybrid_sum(noise, count, octave, n);
    case SCARP_EROSION: return erosion_sum(count, octave, n, (double)noise->erosion);
    default: return plain_sum(count, octave, n, noise->fractal == SCARP_TURBULENCE);
    }
}

/* Whether the point is clear of the creases of its fractal. */
static int is_clear(const struct scarp_noise *noise, int count,
                    const struct oracle_sample n[OCTAVES])
{
    const double sharpness = (double)noise->sharpness;
    double v = 1.0, weight = 1.0;
    for (int k = 0; k < count; k++) {
        const double t = (n[k].value + 1.0) * sharpness;
        const double u = weight * pow((double)noise->gain, k) * (n[k].value + sharpness);
        if (noise->fractal == SCARP_PINGPONG && fabs(t - floor(t + 0.5)) < CREASE * sharpness) {
            return 0;
        }
        if (noise->fractal == SCARP_HYBRID && fabs(fabs(u) - 1.0) < CREASE) {
            return 0;
        }
        weight = fmax(fmin(u, 1.0), -1.0);
        const double r = 1.0 - fabs(n[k].value), s = v * r * r;
        if (noise->fractal == SCARP_TURBULENCE && 1.0 - r < CREASE) {
            return 0;
        }
        if (noise->fractal == SCARP_RIDGED && (1.0 - r < CREASE || fabs(2.0 * s - 1.0) < CREASE)) {
            return 0;
        }
        v = fmin(2.0 * s, 1.0);
    }
    return 1;
}

/*
 * Bounds by [fractal][order], in units of sum |a_k| f_k^order: about three times what was measured.
 * Each octave is rounded on both sides, and the sums on one.
 */
static const double bounds[][3] = {
    [SCARP_FBM] = {4e-7, 9e-7, 4e-6},          [SCARP_TURBULENCE] = {4.2e-7, 7e-7, 4.3e-6},
    [SCARP_RIDGED] = {6e-7, 2.5e-6, 2.1e-5},   [SCARP_EROSION] = {3.2e-7, 1.5e-6, 0.0},
    [SCARP_PINGPONG] = {9e-7, 1.7e-6, 1.1e-5}, [SCARP_HYBRID] = {1.1e-6, 1.1e-6, 2.5e-6},
};

static void compare(struct block *at, struct block *scratch, const struct scarp_noise *noise,
                    long points, double worst[3], long *excluded)
{
    static struct oracle_sample n[OCTAVES][BLOCK];
    const enum function f = dimensions == 2 ? SAMPLE2_F64 : SAMPLE3_F64;
    struct octave octave[OCTAVES];
    const int count = octaves_make(noise, dimensions, octave);
    double unit[3] = {0.0, 0.0, 0.0};
    for (int k = 0; k < count; k++) {
        const double frequency = noise->frequency * pow((double)noise->lacunarity, k);
        unit[0] += fabs(octave[k].weight);
        unit[1] += fabs(octave[k].weight) * frequency;
        unit[2] += fabs(octave[k].weight) * frequency * frequency;
    }
    uint64_t random = noise->seed;
    for (long done = 0; done < points; done += BLOCK) {
        block_random(at, &random, 64.0f);
        block_sample(at, noise, f, BLOCK);
        for (int k = 0; k < count; k++) {
            sample_octave(at, scratch, noise, &octave[k], n[k]);
        }
        for (size_t i = 0; i < BLOCK; i++) {
            struct oracle_sample here[OCTAVES];
            double error[3];
            for (int k = 0; k < count; k++) {
                here[k] = n[k][i];
            }
            if (!is_clear(noise, count, here)) {
                ++*excluded;
                continue;
            }
            const struct oracle_sample expected = rebuilt_sum(noise, count, octave, here);
            const struct oracle_sample actual = block_result(at, noise, f, i);
            difference(&actual, &expected, error);
            for (int order = 0; order < 3; order++) {
                worst[order] = larger(worst[order], error[order] / unit[order]);
            }
        }
    }
}

/* The noise of a case. Of every four, one has octaves of a longer sum. */
static struct scarp_noise case_of(enum scarp_fractal fractal, int i)
{
    const float octaves = (i >> 3 & 1) != 0 ? 4.4f : 5.0f;
    const struct scarp_noise noise = {.basis = (enum scarp_basis)(i & 1),
                                      .fade = (enum scarp_fade)(i >> 1 & 1),
                                      .fractal = fractal,
                                      .rotate = (uint32_t)(i >> 2 & 1),
                                      .seed = 1000 + (uint64_t)i,
                                      .frequency = 0.75,
                                      .octaves = octaves,
                                      .of_octaves = i % 4 == 3 ? 7.75f : octaves,
                                      .lacunarity = 1.9f,
                                      .gain = 0.6f,
                                      .amplitude = (i & 1) != 0 ? -3.0f : 2.0f,
                                      .erosion = 0.7f,
                                      .sharpness = (i >> 2 & 1) != 0 ? 0.8f : 1.3f};
    return noise;
}

static void check_rebuilt(struct block *at, struct block *scratch, enum scarp_fractal fractal,
                          long points)
{
    double worst[3] = {0.0, 0.0, 0.0};
    long excluded = 0;
    for (int i = 0; i < 16; i++) {
        const struct scarp_noise noise = case_of(fractal, i);
        compare(at, scratch, &noise, points, worst, &excluded);
    }
    printf("%-10s %dD rebuilt: value, gradient, Hessian within %.2e  %.2e  %.2e; %ld of %ld points "
           "excluded\n",
           fractal_names[fractal], dimensions, worst[0], worst[1], worst[2], excluded, 16 * points);
    for (int order = 0; order < (fractal == SCARP_EROSION ? 2 : 3); order++) {
        CHECK(worst[order] <= bounds[fractal][order], "derivative %d: off by %g", order,
              worst[order]);
    }
    CHECK(excluded <= 16 * points / 500, "%ld points are excluded", excluded);
}

int main(int argc, char **argv)
{
    const long points = argc > 1 ? strtol(argv[1], NULL, 10) : 0;
    if (points < BLOCK || points % BLOCK != 0) {
        printf("usage: %s POINTS (a multiple of %d)\n", argv[0], BLOCK);
        return EXIT_FAILURE;
    }
    struct block *const at = block_make(), *const scratch = block_make();
    for (int i = 0; i < 12; i++) {
        dimensions = 2 + i % 2;
        check_rebuilt(at, scratch, (enum scarp_fractal)(i / 2), points);
    }
    block_free(at);
    block_free(scratch);
    return check_done();
}
