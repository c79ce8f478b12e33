/* SPDX-License-Identifier: MIT
 *
 * The settings and inputs that test_bits.c and test_golden.c run through. All inputs come from
 * integers, so they are the same on every compiler.
 */
#ifndef SCARP_TESTS_CASES_H
#define SCARP_TESTS_CASES_H

#include "check.h"

#define CASES_OUTPUTS 10

/* The kinds of coordinates. */
enum cases_class {
    CASES_NEAR,    /* within +-64 cells: most bits in the fraction */
    CASES_FAR,     /* within +-2^20 */
    CASES_LATTICE, /* integers and their neighbours */
    CASES_TINY,    /* denormals to 2^-20, both signs */
    CASES_HUGE,    /* around and beyond 2^23, 2^24, 2^31, up to 2^62 */
    CASES_SPECIAL, /* zeros, infinities, NaN, the largest float, mixed with ordinary points */
    CASES_CLASSES
};

struct cases_points {
    size_t count;
    float *f[3];
    double *d[3];
};

static inline float cases_bits_float(uint32_t bits)
{
    float value;
    memcpy(&value, &bits, sizeof value);
    return value;
}

static inline float cases_special(uint64_t random)
{
    static const uint32_t bits[] = {0x00000000u, 0x80000000u, 0x7f800000u, 0xff800000u,
                                    0x7fc00000u, 0x7f7fffffu, 0xff7fffffu, 0x00000001u,
                                    0x4f000000u, 0xcf000000u, 0x4effffffu, 0x3f7fffffu};
    const unsigned count = (unsigned)(sizeof bits / sizeof bits[0]);
    return cases_bits_float(bits[random % count]);
}

/* A power of two times a 24-bit integer, exponent uniform in [lowest, highest]. */
static inline float cases_scaled(uint64_t *state, int lowest, int highest)
{
    const uint64_t r = check_random(state);
    const int exponent = lowest + (int)(r % (uint64_t)(highest - lowest + 1));
    const float mantissa = (float)(1 + (int)(r >> 41)) * 0x1p-23f;
    const float value = ldexpf(mantissa, exponent);
    return (r >> 40 & 1) != 0 ? -value : value;
}

static inline double cases_coordinate(enum cases_class class, uint64_t *state)
{
    const uint64_t r = check_random(state);
    switch (class) {
    case CASES_NEAR: return (double)check_random_float(state, 64.0f);
    case CASES_FAR: return check_random_double(state, 0x1p20);
    case CASES_LATTICE: {
        const float cell = (float)((int)(r >> 50) - (1 << 13));
        const int step = (int)(r % 3) - 1;
        return (double)(step == 0 ? cell : nextafterf(cell, step > 0 ? 1e9f : -1e9f));
    }
    case CASES_TINY: return (double)cases_scaled(state, -148, -20);
    case CASES_HUGE: return (double)cases_scaled(state, 20, 62);
    default:
        return r % 4 == 0 ? (double)cases_special(check_random(state))
                          : (double)check_random_float(state, 64.0f);
    }
}

/* `count` points of a class, as doubles and, rounded, as floats. Freed by the end of the program.
 */
static inline struct cases_points cases_make(enum cases_class class, size_t count)
{
    struct cases_points points = {.count = count};
    uint64_t state = 1000 + (uint64_t) class;
    for (int axis = 0; axis < 3; axis++) {
        points.f[axis] = malloc(count * sizeof(float));
        points.d[axis] = malloc(count * sizeof(double));
        if (points.f[axis] == NULL || points.d[axis] == NULL) {
            printf("out of memory\n");
            exit(EXIT_FAILURE);
        }
    }
    for (size_t i = 0; i < count; i++) {
        for (int axis = 0; axis < 3; axis++) {
            points.d[axis][i] = cases_coordinate(class, &state);
            points.f[axis][i] = (float)points.d[axis][i];
        }
    }
    return points;
}

static inline void cases_free(struct cases_points *points)
{
    for (int axis = 0; axis < 3; axis++) {
        free(points->f[axis]);
        free(points->d[axis]);
    }
}

/* One call: the noise, what is asked, and of which function. */
struct cases_call {
    struct scarp_noise noise;
    int dimensions, order, doubles;
};

/* Every combination of dimensions, basis, fade, order and precision: of fBm with one octave, with
   several, and with turned axes, which come with a fractional number of octaves, odd ratios and a
   negative amplitude; of each other fractal with several octaves or turned axes by turns. Erosion
   has no order 2; it has its order 1 twice. */
#define CASES_KINDS 6
#define CASES_CALLS (2 * 2 * 2 * 3 * 2 * CASES_KINDS)

static inline void cases_turn(struct scarp_noise *noise)
{
    noise->rotate = 1;
    noise->octaves = 4.25f;
    noise->frequency = 1.25;
    noise->lacunarity = 1.875f;
    noise->gain = 0.625f;
    noise->amplitude = -3.5f;
}

static inline struct cases_call cases_call(int index)
{
    struct cases_call call;
    memset(&call, 0, sizeof call);
    call.dimensions = 2 + index % 2;
    call.noise.basis = (enum scarp_basis)(index / 2 % 2);
    call.noise.fade = (enum scarp_fade)(index / 4 % 2);
    call.order = index / 8 % 3;
    call.doubles = index / 24 % 2;
    const int kind = index / 48;
    call.noise.seed = (uint64_t)(unsigned)index * UINT64_C(0x123456789abcdef1);
    if (kind == 2) {
        cases_turn(&call.noise);
    } else if (kind != 0) {
        call.noise.octaves = 5.0f;
        call.noise.frequency = 0.375;
    }
    if (kind > 2) {
        call.noise.fractal = (enum scarp_fractal)(SCARP_TURBULENCE + kind - 3);
        call.noise.erosion = 0.75f;
        if ((index / 2 + index / 4 + index / 8 + kind) % 2 != 0) {
            cases_turn(&call.noise);
        }
        if (call.noise.fractal == SCARP_EROSION && call.order == 2) {
            call.order = 1;
        }
    }
    return call;
}

/* The outputs that a call computes, in `arrays`; the others NULL. */
static inline struct scarp_samples cases_outputs(const struct cases_call *call,
                                                 float *const *arrays)
{
    static const int order_of[CASES_OUTPUTS] = {0, 1, 1, 1, 2, 2, 2, 2, 2, 2};
    static const int along_z[CASES_OUTPUTS] = {0, 0, 0, 1, 0, 0, 1, 0, 1, 1};
    float *wanted[CASES_OUTPUTS];
    for (int m = 0; m < CASES_OUTPUTS; m++) {
        const int there = order_of[m] <= call->order && !(call->dimensions == 2 && along_z[m]);
        wanted[m] = there ? arrays[m] : NULL;
    }
    const struct scarp_samples out = {.value = wanted[0],
                                      .dx = wanted[1],
                                      .dy = wanted[2],
                                      .dz = wanted[3],
                                      .dxx = wanted[4],
                                      .dxy = wanted[5],
                                      .dxz = wanted[6],
                                      .dyy = wanted[7],
                                      .dyz = wanted[8],
                                      .dzz = wanted[9]};
    return out;
}

static inline enum scarp_status cases_run(const struct cases_call *call,
                                          const struct cases_points *points, size_t first,
                                          size_t count, const struct scarp_samples *out)
{
    const float *const *const f = (const float *const *)points->f;
    const double *const *const d = (const double *const *)points->d;
    if (call->dimensions == 2) {
        return call->doubles
                   ? scarp_sample2_f64(&call->noise, count, d[0] + first, d[1] + first, out)
                   : scarp_sample2(&call->noise, count, f[0] + first, f[1] + first, out);
    }
    return call->doubles
               ? scarp_sample3_f64(&call->noise, count, d[0] + first, d[1] + first, d[2] + first,
                                   out)
               : scarp_sample3(&call->noise, count, f[0] + first, f[1] + first, f[2] + first, out);
}

/* The bits of a float, all NaNs alike. */
static inline uint32_t cases_float_bits(float value)
{
    uint32_t bits;
    memcpy(&bits, &value, sizeof bits);
    return (bits & 0x7fffffffu) > 0x7f800000u ? 0x7fc00000u : bits;
}

#endif
