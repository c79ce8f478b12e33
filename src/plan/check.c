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
                   offsetof(struct scarp_noise, offset_first) == 80 + 2 * sizeof(void *) &&
                   offsetof(struct scarp_noise, spare_word) == 84 + 2 * sizeof(void *) &&
                   offsetof(struct scarp_noise, spare) == 88 + 2 * sizeof(void *) &&
                   sizeof(struct scarp_noise) == 192,
               "struct scarp_noise has 192 bytes without padding");
_Static_assert(sizeof((struct scarp_noise *)NULL)->spare >= 8 &&
                   sizeof((struct scarp_noise *)NULL)->spare % 8 == 0,
               "some bytes stay spare, in words that reserved_in_use() reads");

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

/* Compares as unsigned, since a caller may put any number into an enumeration. */
static enum scarp_refusal refused_word(const struct scarp_noise *noise)
{
    return (unsigned)noise->basis >= SCARP_BASES        ? REFUSED_BASIS
           : (unsigned)noise->fade >= SCARP_FADES       ? REFUSED_FADE
           : (unsigned)noise->fractal >= SCARP_FRACTALS ? REFUSED_FRACTAL
                                                        : REFUSED_NOT;
}

/* f_k is monotone in k, so the last one decides. This stands by itself, for a loop in registers:
   inlined, gcc 12 moves the frequency to an integer register and back in each turn. */
static __attribute__((noinline)) int last_frequency_valid(double frequency, double lacunarity,
                                                          int octaves)
{
    for (int k = 1; k < octaves; k++) {
        frequency *= lacunarity;
    }
    return within(frequency, FREQUENCY_MIN, FREQUENCY_MAX);
}

/* Whether a period of a noise of `octaves` octaves is at most PERIOD_MAX in each of them. */
static int period_valid(double period, double lacunarity, int octaves)
{
    for (int k = 1; k < octaves && period <= PERIOD_MAX; k++) {
        period *= lacunarity;
    }
    return period <= PERIOD_MAX;
}

/* What makes the noise's periods impossible. `p` is valid. */
static enum scarp_refusal refused_period(const struct scarp_noise *noise,
                                         const struct parameters *p, int dimensions)
{
    const int octaves = octave_count((float)p->octaves);
    for (int i = 0; i < dimensions; i++) {
        if (noise->period[i] == 0) {
            continue;
        }
        if (octaves > 1 && p->lacunarity != (double)(int)p->lacunarity) {
            return REFUSED_LACUNARITY_PERIOD;
        }
        if (!period_valid((double)noise->period[i], p->lacunarity, octaves)) {
            return (enum scarp_refusal)(REFUSED_PERIOD_X + i);
        }
    }
    return is_rotated(noise, octaves) ? REFUSED_ROTATE
           : noise->basis == SCARP_SIMPLEX && dimensions == 2 && noise->period[1] != 0
               ? REFUSED_PERIOD_SIMPLEX
               : REFUSED_NOT;
}

/* Jordan noise narrows the interval. */
static int erosion_valid(const struct scarp_noise *noise, double erosion)
{
    return within(erosion, EROSION_MIN, noise->fractal == SCARP_JORDAN ? 1.0 : EROSION_MAX);
}

static enum scarp_refusal refused_erosion(double erosion)
{
    return within(erosion, EROSION_MIN, EROSION_MAX) ? REFUSED_EROSION_JORDAN : REFUSED_EROSION;
}

/* Fractals that have a sharpness narrow its interval. */
static int sharpness_used(const struct scarp_noise *noise)
{
    return noise->fractal >= SCARP_PINGPONG;
}

static int sharpness_valid(const struct scarp_noise *noise, double sharpness)
{
    return sharpness_used(noise) ? within(sharpness, SHARPNESS_USED_MIN, SHARPNESS_USED_MAX)
                                 : within(sharpness, SHARPNESS_MIN, SHARPNESS_MAX);
}

static enum scarp_refusal refused_sharpness(const struct scarp_noise *noise)
{
    return sharpness_used(noise) ? REFUSED_SHARPNESS_USED : REFUSED_SHARPNESS;
}

static enum scarp_refusal refused_of_octaves(const struct parameters *p)
{
    return p->of_octaves < p->octaves ? REFUSED_OF_OCTAVES_LOW : REFUSED_OF_OCTAVES;
}

static int frequencies_valid(const struct parameters *p)
{
    const int octaves = octave_count((float)p->octaves);
    return octaves == 1 || last_frequency_valid(p->frequency, p->lacunarity, octaves);
}

static enum scarp_refusal refused_number(const struct scarp_noise *noise,
                                         const struct parameters *p)
{
    const double magnitude = p->amplitude < 0.0 ? -p->amplitude : p->amplitude;
    return !within(p->frequency, FREQUENCY_MIN, FREQUENCY_MAX)     ? REFUSED_FREQUENCY
           : !within(p->octaves, 0.0, SCARP_MAX_OCTAVES)           ? REFUSED_OCTAVES
           : !within(p->lacunarity, RATIO_MIN, RATIO_MAX)          ? REFUSED_LACUNARITY
           : !within(p->gain, RATIO_MIN, RATIO_MAX)                ? REFUSED_GAIN
           : !within(magnitude, AMPLITUDE_MIN, AMPLITUDE_MAX)      ? REFUSED_AMPLITUDE
           : !erosion_valid(noise, p->erosion)                     ? refused_erosion(p->erosion)
           : !within((double)noise->phase, -FLT_MAX, FLT_MAX)      ? REFUSED_PHASE
           : !within(p->jitter, FLT_TRUE_MIN, 1.0)                 ? REFUSED_JITTER
           : !sharpness_valid(noise, p->sharpness)                 ? refused_sharpness(noise)
           : !within(p->of_octaves, p->octaves, SCARP_MAX_OCTAVES) ? refused_of_octaves(p)
           : !frequencies_valid(p)                                 ? REFUSED_LAST_FREQUENCY
                                                                   : REFUSED_NOT;
}

/* Whether any reserved member is not zero. Reading wide words without branches takes less time than
   reading members one by one. */
static int reserved_in_use(const struct scarp_noise *noise)
{
    uintptr_t bits = noise->spare_word;
    for (size_t i = 0; i < sizeof noise->spare; i += sizeof bits) {
        uintptr_t word;
        memcpy(&word, (const char *)noise->spare + i, sizeof word);
        bits |= word;
    }
    return bits != 0;
}

/* Makes all checks but that of the warp. */
static enum scarp_refusal refused(const struct scarp_noise *noise, int dimensions)
{
    const struct parameters p = parameters_of(noise);
    enum scarp_refusal why = refused_word(noise);
    if (why == REFUSED_NOT) {
        why = refused_number(noise, &p);
    }
    return why != REFUSED_NOT                                       ? why
           : reserved_in_use(noise)                                 ? REFUSED_SPARE
           : noise->phase != 0.0f && noise->basis != SCARP_GRADIENT ? REFUSED_PHASE_BASIS
           : dimensions != 2 && dimensions != 3                     ? REFUSED_DIMENSIONS
           : repeats(noise, dimensions) ? refused_period(noise, &p, dimensions)
                                        : REFUSED_NOT;
}

struct scarp_fault scarpi_plan_check(const struct scarp_noise *noise, int dimensions)
{
    struct scarp_fault fault = {refused(noise, dimensions), 0};
    for (noise = noise->warp; fault.why == REFUSED_NOT && noise != NULL; noise = noise->warp) {
        if (fault.warp == SCARP_MAX_WARPS) {
            fault.why = REFUSED_WARP;
        } else {
            fault.why = refused(noise, dimensions);
            fault.warp++;
        }
    }
    return fault;
}
