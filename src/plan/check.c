/* SPDX-License-Identifier: MIT
 *
 * Checks the description of a noise.
 */
#include "check.h"

#include <stddef.h>
#include <string.h>

#include "parameters.h"

/* The layout is the binary interface, the same for every compiler; only pointers differ in size.
   plan_kept() relies on it. */
_Static_assert(offsetof(struct scarp_noise, erosion) == 48 &&
                   offsetof(struct scarp_noise, phase) == 52 &&
                   offsetof(struct scarp_noise, jitter) == 56 &&
                   offsetof(struct scarp_noise, sharpness) == 60 &&
                   offsetof(struct scarp_noise, period) == 64 &&
                   offsetof(struct scarp_noise, of_octaves) == 76 &&
                   offsetof(struct scarp_noise, warp) == 80 &&
                   offsetof(struct scarp_noise, plan) == 80 + sizeof(void *) &&
                   offsetof(struct scarp_noise, spare) == 80 + 2 * sizeof(void *) &&
                   sizeof(struct scarp_noise) == 192,
               "struct scarp_noise has 192 bytes without padding");
_Static_assert(sizeof((struct scarp_noise *)NULL)->spare >= 8, "some bytes stay spare");

/* While every f_k and the amplitude lie within these bounds, a_k f_k^2 times the largest second
   derivative (below 2^6 for every basis, per cell squared) stays under 2^127. So no outputs
   overflow but Hessians of ridged noise, which multiply gradients of octaves, and those of the
   distances of cellular noise, which are up to 2^40 at features. The constants of the
   octaves that matter stay normal floats, also in value noise, where they carry 2^-31. */
#define FREQUENCY_MIN 0x1p-32
#define FREQUENCY_MAX 0x1p48
#define RATIO_MIN 0.0625
#define RATIO_MAX 16.0
#define AMPLITUDE_MIN 0x1p-24
#define AMPLITUDE_MAX 0x1p24
#define EROSION_MIN 0x1p-24
#define EROSION_MAX 0x1p24
#define SHARPNESS_MIN 0x1p-24
#define SHARPNESS_MAX 0x1p24
#define SHARPNESS_USED_MIN 0x1p-8
#define SHARPNESS_USED_MAX 0x1p8

/* A NaN is not within. */
static int within(double value, double lowest, double highest)
{
    return value >= lowest && value <= highest;
}

/* Compares as unsigned, since a caller may put any number into an enumeration. */
static const char *unknown_member(const struct scarp_noise *noise)
{
    return (unsigned)noise->basis >= SCARP_BASES        ? "basis"
           : (unsigned)noise->fade >= SCARP_FADES       ? "fade"
           : (unsigned)noise->fractal >= SCARP_FRACTALS ? "fractal"
                                                        : NULL;
}

/* f_k is monotone in k, so the last one decides. */
static int last_frequency_valid(const struct parameters *p)
{
    double frequency = p->frequency;
    for (int k = 1; k < octave_count((float)p->octaves); k++) {
        frequency *= p->lacunarity;
    }
    return within(frequency, FREQUENCY_MIN, FREQUENCY_MAX);
}

static const char *const period_names[3] = {"period[0]", "period[1]", "period[2]"};

/* Whether a period of a noise of `octaves` octaves is at most PERIOD_MAX in each of them. */
static int period_valid(double period, double lacunarity, int octaves)
{
    for (int k = 1; k < octaves && period <= PERIOD_MAX; k++) {
        period *= lacunarity;
    }
    return period <= PERIOD_MAX;
}

/* What makes the noise's periods impossible. `p` is valid. */
static const char *period_member(const struct scarp_noise *noise, const struct parameters *p,
                                 int dimensions)
{
    const int octaves = octave_count((float)p->octaves);
    for (int i = 0; i < dimensions; i++) {
        if (noise->period[i] == 0) {
            continue;
        }
        if (octaves > 1 && p->lacunarity != (double)(int)p->lacunarity) {
            return "lacunarity";
        }
        if (!period_valid((double)noise->period[i], p->lacunarity, octaves)) {
            return period_names[i];
        }
    }
    return NULL;
}

/* Fractals that have a sharpness narrow its interval. */
static int sharpness_valid(const struct scarp_noise *noise, double sharpness)
{
    const int used = noise->fractal >= SCARP_PINGPONG;
    return used ? within(sharpness, SHARPNESS_USED_MIN, SHARPNESS_USED_MAX)
                : within(sharpness, SHARPNESS_MIN, SHARPNESS_MAX);
}

static int erosion_valid(const struct scarp_noise *noise, double erosion)
{
    return within(erosion, EROSION_MIN, noise->fractal == SCARP_JORDAN ? 1.0 : EROSION_MAX);
}

static const char *outside_member(const struct scarp_noise *noise, const struct parameters *p)
{
    const double magnitude = p->amplitude < 0.0 ? -p->amplitude : p->amplitude;
    return !within(p->frequency, FREQUENCY_MIN, FREQUENCY_MAX)     ? "frequency"
           : !within(p->octaves, 0.0, SCARP_MAX_OCTAVES)           ? "octaves"
           : !within(p->lacunarity, RATIO_MIN, RATIO_MAX)          ? "lacunarity"
           : !within(p->gain, RATIO_MIN, RATIO_MAX)                ? "gain"
           : !within(magnitude, AMPLITUDE_MIN, AMPLITUDE_MAX)      ? "amplitude"
           : !erosion_valid(noise, p->erosion)                     ? "erosion"
           : !within((double)noise->phase, -FLT_MAX, FLT_MAX)      ? "phase"
           : !within(p->jitter, FLT_TRUE_MIN, 1.0)                 ? "jitter"
           : !sharpness_valid(noise, p->sharpness)                 ? "sharpness"
           : !within(p->of_octaves, p->octaves, SCARP_MAX_OCTAVES) ? "of_octaves"
           : !last_frequency_valid(p)                              ? "octaves"
                                                                   : NULL;
}

/* Whether any reserved member is not zero. Reading wide words without branches takes less time than
   reading members one by one. */
static int reserved_in_use(const struct scarp_noise *noise)
{
    enum { BYTES = sizeof noise->spare, WORD = sizeof(uintptr_t), WORDS = BYTES / WORD };
    uintptr_t words[WORDS], bits = 0;
    memcpy(words, noise->spare, BYTES);
    for (size_t i = 0; i < WORDS; i++) {
        bits |= words[i];
    }
    return bits != 0;
}

static enum scarp_status check_periods(const struct scarp_noise *noise, const struct parameters *p,
                                       int dimensions, const char **member)
{
    if ((*member = period_member(noise, p, dimensions)) != NULL) {
        return SCARP_ERROR_PARAMETER;
    }
    if (is_rotated(noise, octave_count((float)p->octaves))) {
        *member = "rotate";
        return SCARP_ERROR_UNSUPPORTED;
    }
    if (noise->basis == SCARP_SIMPLEX && dimensions == 2 && noise->period[1] != 0) {
        *member = period_names[1];
        return SCARP_ERROR_UNSUPPORTED;
    }
    return SCARP_OK;
}

/* Makes all checks but that of the warp. `p` are the parameters of the noise. */
static enum scarp_status check_one(const struct scarp_noise *noise, const struct parameters *p,
                                   int dimensions, const char **member)
{
    if ((*member = unknown_member(noise)) != NULL) {
        return SCARP_ERROR_ENUM;
    }
    if ((*member = outside_member(noise, p)) != NULL) {
        return SCARP_ERROR_PARAMETER;
    }
    if (reserved_in_use(noise)) {
        *member = "spare";
        return SCARP_ERROR_UNSUPPORTED;
    }
    if (noise->phase != 0.0f && noise->basis != SCARP_GRADIENT) {
        *member = "phase";
        return SCARP_ERROR_UNSUPPORTED;
    }
    if (dimensions != 2 && dimensions != 3) {
        return SCARP_ERROR_PARAMETER;
    }
    return repeats(noise, dimensions) ? check_periods(noise, p, dimensions, member) : SCARP_OK;
}

/* Makes all checks. */
static enum scarp_status check(const struct scarp_noise *noise, const struct parameters *p,
                               int dimensions, const char **member)
{
    enum scarp_status status = check_one(noise, p, dimensions, member);
    int depth = 0;
    for (const struct scarp_noise *w = noise->warp; status == SCARP_OK && w != NULL; w = w->warp) {
        const struct parameters of_warp = parameters_of(w);
        status = ++depth > SCARP_MAX_WARPS ? SCARP_ERROR_UNSUPPORTED
                                           : check_one(w, &of_warp, dimensions, member);
        if (status != SCARP_OK) {
            *member = "warp";
        }
    }
    return status;
}

enum scarp_status scarp_plan_check(const struct scarp_noise *noise, int dimensions,
                                   const char **member)
{
    const struct parameters p = parameters_of(noise);
    return check(noise, &p, dimensions, member);
}
