/* SPDX-License-Identifier: MIT
 *
 * The settings and inputs that test_bits.c and test_golden.c run through. All inputs come from
 * integers, so they are the same on every compiler. Every case has a name, such as
 * "2d/gradient/quintic/o1/f64/fbm/near", which seeds its noise, and the name of a class seeds the
 * points: whatever is added to one of the lists leaves the other cases as they are.
 */
#ifndef SCARP_TESTS_CASES_H
#define SCARP_TESTS_CASES_H

#include "outputs.h"

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

static const char *const class_names[CASES_CLASSES] = {"near", "far",  "lattice",
                                                       "tiny", "huge", "special"};

struct cases_points {
    size_t count;
    float *f[3];
    double *d[3];
};

static inline float cases_special(uint64_t random)
{
    static const uint32_t bits[] = {0x00000000u, 0x80000000u, 0x7f800000u, 0xff800000u,
                                    0x7fc00000u, 0x7f7fffffu, 0xff7fffffu, 0x00000001u,
                                    0x4f000000u, 0xcf000000u, 0x4effffffu, 0x3f7fffffu};
    const unsigned count = (unsigned)(sizeof bits / sizeof bits[0]);
    return float_of_bits(bits[random % count]);
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

/* Makes `count` points of a class, as doubles and, rounded, as floats. */
static inline struct cases_points cases_make(enum cases_class class, size_t count)
{
    struct cases_points points = {.count = count};
    uint64_t state = fnv_text(class_names[class]);
    for (int axis = 0; axis < 3; axis++) {
        points.f[axis] = check_allocate(count * sizeof(float));
        points.d[axis] = check_allocate(count * sizeof(double));
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

/* The points from number `first` on. */
static inline struct inputs cases_inputs(const struct cases_points *points, size_t first)
{
    const struct inputs in = {{points->f[0] + first, points->f[1] + first, points->f[2] + first},
                              {points->d[0] + first, points->d[1] + first, points->d[2] + first}};
    return in;
}

/* One case: the noise, the function, and the outputs that it is asked for. */
struct cases_call {
    char name[80];
    char group[80]; /* the same without order and precision: what golden.txt has a line for */
    struct scarp_noise noise;
    enum function function;
    unsigned wanted; /* outputs, by bits */
};

/* Each fractal runs with several octaves, and with turned axes, which come with a fractional number
   of octaves, odd ratios and a negative amplitude. fBm also runs with one octave, which is the
   basis alone, and with periods, which shapes do not see. Gradient noise flows, with straight and
   with turned axes, but for the cubic fade, which does not see gradients.

   Noise with warps runs with few fractals and bases, since warps do the same with all; fractals
   that bend run with gradient noise, since their octaves are noise of one octave, and a little with
   value noise.

   With the offset of octave 0, fBm runs with one octave, with any periods and with warps that have
   it, too. Turned axes, which come with a phase, also run with the other fractals of gradient
   noise.

   Bases that do not blend corners run with one fade. What the fractals make of them is the same for
   all, so that cellular noise runs with fBm alone but for a sharp and a smooth distance. */
enum cases_octaves {
    CASES_OCTAVE,
    CASES_OCTAVES,
    CASES_TURNED,
    CASES_POWERS,  /* periods that are powers of two, and an axis without one */
    CASES_PERIODS, /* any periods, and an axis without one */
    CASES_FLOW,    /* a phase, and the derivative with respect to it */
    CASES_FLOW_TURNED,
    CASES_WARPED,       /* one warp, and a phase */
    CASES_WARPED_TWICE, /* two, whose octaves are more than one plan has room for */
    CASES_FIRST,        /* these have the offset of octave 0: one octave */
    CASES_FIRST_TURNED,
    CASES_FIRST_PERIODS,
    CASES_FIRST_WARPED,
    CASES_SETTINGS
};

static const char *const setting_names[CASES_SETTINGS] = {"",
                                                          "-octaves",
                                                          "-turned",
                                                          "-powers",
                                                          "-periods",
                                                          "-flow",
                                                          "-flow-turned",
                                                          "-warped",
                                                          "-warped-twice",
                                                          "-first",
                                                          "-first-turned",
                                                          "-first-periods",
                                                          "-first-warped"};

/* The warps: the second one has the third one. The last one has the offset of octave 0. */
static const struct scarp_noise cases_warps[4] = {
    {.seed = 5, .rotate = 1, .octaves = 2.0f, .frequency = 0.7, .amplitude = 0.75f},
    {.seed = 6,
     .octaves = 4.0f,
     .of_octaves = 4.5f,
     .frequency = 0.3,
     .lacunarity = 1.5f,
     .amplitude = -1.5f,
     .warp = &cases_warps[2]},
    {.seed = 7,
     .basis = SCARP_VALUE,
     .rotate = 1,
     .octaves = 3.0f,
     .frequency = 0.6,
     .lacunarity = 1.25f,
     .gain = 0.8f},
    {.seed = 8, .rotate = 1, .octaves = 2.0f, .frequency = 0.7, .offset_first = 1},
};

/* Sets what goes with the offset of octave 0. */
static inline void cases_set_first(struct scarp_noise *noise, enum cases_octaves setting)
{
    noise->offset_first = setting >= CASES_FIRST;
    if (setting == CASES_FIRST_TURNED) {
        noise->rotate = 1;
        noise->octaves = 2.5f;
        noise->frequency = 0.625;
        noise->phase = noise->basis == SCARP_GRADIENT ? 0.4f : 0.0f;
    } else if (setting == CASES_FIRST_PERIODS) {
        noise->octaves = 2.0f;
        noise->period[0] = 49;
        noise->period[1] = 8;
    } else if (setting == CASES_FIRST_WARPED) {
        noise->octaves = 2.0f;
        noise->warp = &cases_warps[3];
    }
}

static inline void cases_set(struct scarp_noise *noise, enum cases_octaves setting)
{
    if (setting == CASES_OCTAVES) {
        noise->octaves = 5.0f;
        noise->frequency = 0.375;
    } else if (setting == CASES_TURNED) {
        noise->rotate = 1;
        noise->octaves = 4.25f;
        noise->frequency = 1.25;
        noise->lacunarity = 1.875f;
        noise->gain = 0.625f;
        noise->amplitude = -3.5f;
        noise->jitter = 0.75f; /* of cells */
        if (fractal_row(noise->fractal)->sharpness != 0.0f) {
            noise->sharpness = 1.25f;
            noise->of_octaves = 6.5f;
        }
    } else if (setting == CASES_POWERS) {
        noise->octaves = 3.0f;
        noise->period[0] = 1;
        noise->period[1] = 64;
    } else if (setting == CASES_PERIODS) {
        noise->octaves = 2.5f;
        noise->lacunarity = 3.0f;
        noise->period[0] = 49; /* 49 * (1 / 49) is not 1 */
        noise->period[1] = 7;  /* nor is 21 in floats */
        noise->period[2] = 1000003;
    } else if (setting == CASES_FLOW) {
        noise->octaves = 3.0f;
        noise->phase = 0.3f;
    } else if (setting == CASES_FLOW_TURNED) {
        noise->rotate = 1;
        noise->octaves = 2.5f;
        noise->phase = -1.71f;
    } else if (setting == CASES_WARPED) {
        noise->octaves = 2.0f;
        noise->phase = 0.3f;
        noise->warp = &cases_warps[0];
    } else if (setting == CASES_WARPED_TWICE) {
        noise->octaves = 19.0f; /* and those of the warps: 33 in 2D */
        noise->lacunarity = 1.25f;
        noise->gain = 0.75f;
        noise->warp = &cases_warps[1];
    }
    cases_set_first(noise, setting);
}

/* Whether these outputs are worth a case: of cellular noise all at once, and the value alone in one
   octave and with any periods. */
static inline int cases_has_order(const struct scarp_noise *noise, int order,
                                  enum cases_octaves setting)
{
    const int all = noise_order(noise);
    return blends_corners(noise->basis) || noise->basis == SCARP_SIMPLEX || order == all ||
           setting == CASES_OCTAVE || setting == CASES_FIRST ||
           (order == 0 && setting == CASES_PERIODS);
}

/* Whether there are warped cases of this noise: the second warp of one alone. */
static inline int cases_has_warped(const struct scarp_noise *noise, enum cases_octaves setting)
{
    const int twice = setting == CASES_WARPED_TWICE;
    const int value = noise->basis == SCARP_VALUE && noise->fractal == SCARP_FBM;
    const int gradient = noise->basis == SCARP_GRADIENT &&
                         (noise->fractal == SCARP_FBM || noise->fractal == SCARP_RIDGED);
    return noise->fade == SCARP_QUINTIC &&
           (twice ? gradient && noise->fractal == SCARP_FBM : gradient || value);
}

/* Whether a fractal that bends is a case of the noise's basis. */
static inline int cases_has_bends(const struct scarp_noise *noise, enum cases_octaves setting)
{
    return noise->fade == SCARP_QUINTIC &&
           (setting == CASES_TURNED ? blends_corners(noise->basis)
                                    : noise->basis == SCARP_GRADIENT && setting != CASES_FLOW);
}

/* Whether a fractal with this setting is a case of the noise's basis and fade. */
static inline int cases_has(const struct scarp_noise *noise, enum cases_octaves setting)
{
    const int for_fbm = setting == CASES_OCTAVE || setting == CASES_POWERS ||
                        setting == CASES_PERIODS || setting == CASES_FIRST ||
                        setting == CASES_FIRST_PERIODS ||
                        (setting == CASES_FIRST_TURNED && noise->basis != SCARP_GRADIENT);
    const int flows =
        setting == CASES_FLOW || setting == CASES_FLOW_TURNED || setting == CASES_FIRST_TURNED;
    const int shaped = fractal_bends(noise->fractal)
                           ? cases_has_bends(noise, setting)
                           : basis_smooth(noise->basis) || noise->basis == SCARP_CELL_F1;
    if (setting == CASES_WARPED || setting == CASES_WARPED_TWICE || setting == CASES_FIRST_WARPED) {
        return cases_has_warped(noise, setting);
    }
    return (noise->fractal == SCARP_FBM || (!for_fbm && shaped)) &&
           (noise->fade == SCARP_QUINTIC || (!flows && blends_corners(noise->basis)));
}

/* Takes the last digit, base `radix`, off a number. */
static inline int cases_digit(int *number, int radix)
{
    const int digit = *number % radix;
    *number /= radix;
    return digit;
}

/* Makes case `number` of a class. Returns 1, or 0 if that number is no case, or -1 if there are no
   more. The numbers serve only to go through all cases. */
static inline int cases_make_call(struct cases_call *call, enum cases_class class, int number)
{
    memset(call, 0, sizeof *call);
    struct scarp_noise *const noise = &call->noise;
    const int function = cases_digit(&number, FUNCTIONS);
    const int order = cases_digit(&number, ORDERS);
    const int setting = cases_digit(&number, CASES_SETTINGS);
    noise->basis = (enum scarp_basis)cases_digit(&number, count_names(basis_name));
    noise->fade = (enum scarp_fade)cases_digit(&number, count_names(fade_name));
    noise->fractal = (enum scarp_fractal)cases_digit(&number, count_names(fractal_name));
    noise->erosion = fractal_row(noise->fractal)->most_erosion != 0.0f ? 0.75f : 0.0f;
    call->function = (enum function)function;
    const int dimensions = function_dimensions(call->function);
    call->wanted = outputs_up_to(order, dimensions);
    if (number > 0) {
        return -1;
    }
    const int flows = setting == CASES_FLOW || setting == CASES_FLOW_TURNED;
    if (flows || setting == CASES_WARPED) {
        call->wanted |= OUTPUTS_PHASE & outputs_of(noise, call->function);
    }
    if ((flows && noise->basis != SCARP_GRADIENT) ||
        !cases_has(noise, (enum cases_octaves)setting) ||
        !cases_has_order(noise, order, (enum cases_octaves)setting) ||
        (call->wanted & ~outputs_of(noise, call->function)) != 0) {
        return 0;
    }
    const char *const basis = basis_name((int)noise->basis);
    const char *const fade = fade_name((int)noise->fade);
    const char *const fractal = fractal_name((int)noise->fractal);
    snprintf(call->name, sizeof call->name, "%dd/%s/%s/o%d/%s/%s%s/%s", dimensions, basis, fade,
             order, function_doubles(call->function) ? "f64" : "f32", fractal,
             setting_names[setting], class_names[class]);
    snprintf(call->group, sizeof call->group, "%dd/%s/%s/%s%s/%s", dimensions, basis, fade, fractal,
             setting_names[setting], class_names[class]);
    noise->seed = fnv_text(call->name);
    cases_set(noise, (enum cases_octaves)setting);
    fit_noise(noise, dimensions);
    return 1;
}

/* `for (int n = 0; cases_next(&call, class, &n);)` goes through all cases of a class. */
static inline int cases_next(struct cases_call *call, enum cases_class class, int *number)
{
    int made = 0;
    while (made == 0) {
        made = cases_make_call(call, class, (*number)++);
    }
    return made > 0;
}

/* Makes the call for `count` points from `first` on. It must not fail. */
static inline void cases_run(const struct cases_call *call, const struct cases_points *points,
                             size_t first, size_t count, const struct outputs *o)
{
    const struct inputs in = cases_inputs(points, first);
    const struct scarp_samples out = outputs_subset(o, call->wanted);
    const enum scarp_status status = function_call(call->function, &call->noise, count, &in, &out);
    CHECK(status == SCARP_OK, "%s: %s", call->name, scarp_status_text(status));
}

#endif
