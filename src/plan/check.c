/* SPDX-License-Identifier: MIT
 *
 * Checks the description of a noise.
 */
#include "refusals.h"

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

/* Compares as unsigned, since a caller may put any number into an enumeration. */
static enum scarp_refusal refused_word(const struct scarp_noise *noise)
{
    return (unsigned)noise->basis >= SCARP_BASES        ? REFUSED_BASIS
           : (unsigned)noise->fade >= SCARP_FADES       ? REFUSED_FADE
           : (unsigned)noise->fractal >= SCARP_FRACTALS ? REFUSED_FRACTAL
                                                        : REFUSED_NOT;
}

/* f_k is monotone in k, so the last one decides. As a function of its own, this loop is in
   registers: inlined, gcc 12 moves the frequency to an integer register and back in each turn. */
static __attribute__((noinline)) int last_frequency_valid(double frequency, double lacunarity,
                                                          int octaves)
{
    for (int k = 1; k < octaves; k++) {
        frequency *= lacunarity;
    }
    return within(frequency, noise_bounds.frequency);
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
           : basis_axes_with_period(noise->basis, dimensions) == 1 && noise->period[1] != 0
               ? REFUSED_PERIOD_SIMPLEX
               : REFUSED_NOT;
}

/* Some fractals narrow the interval of erosion. */
static int erosion_valid(const struct scarp_noise *noise, double erosion)
{
    const int is_share = fractal_row(noise->fractal)->most_erosion == 1.0f;
    return within(erosion, is_share ? noise_bounds.EROSION_SHARE : noise_bounds.erosion);
}

static enum scarp_refusal refused_erosion(double erosion)
{
    return within(erosion, noise_bounds.erosion) ? REFUSED_EROSION_SHARE : REFUSED_EROSION;
}

/* Fractals that have a sharpness narrow its interval. */
static int sharpness_used(const struct scarp_noise *noise)
{
    return fractal_row(noise->fractal)->sharpness != 0.0f;
}

static int sharpness_valid(const struct scarp_noise *noise, double sharpness)
{
    return sharpness_used(noise) ? within(sharpness, noise_bounds.SHARPNESS_USED)
                                 : sharpness == 0.0 || within(sharpness, noise_bounds.sharpness);
}

static enum scarp_refusal refused_sharpness(const struct scarp_noise *noise)
{
    return sharpness_used(noise) ? REFUSED_SHARPNESS_USED : REFUSED_SHARPNESS;
}

static int of_octaves_valid(const struct parameters *p)
{
    return p->of_octaves >= p->octaves && within(p->of_octaves, noise_bounds.of_octaves);
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
    return !within(p->frequency, noise_bounds.frequency)     ? REFUSED_FREQUENCY
           : !within(p->octaves, noise_bounds.octaves)       ? REFUSED_OCTAVES
           : !within(p->lacunarity, noise_bounds.lacunarity) ? REFUSED_LACUNARITY
           : !within(p->gain, noise_bounds.gain)             ? REFUSED_GAIN
           : !within(magnitude, noise_bounds.amplitude)      ? REFUSED_AMPLITUDE
           : !erosion_valid(noise, p->erosion)               ? refused_erosion(p->erosion)
           : !within(p->phase, noise_bounds.phase)           ? REFUSED_PHASE
           : !within(p->jitter, noise_bounds.jitter)         ? REFUSED_JITTER
           : !sharpness_valid(noise, p->sharpness)           ? refused_sharpness(noise)
           : !of_octaves_valid(p)                            ? refused_of_octaves(p)
           : !frequencies_valid(p)                           ? REFUSED_LAST_FREQUENCY
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
    enum scarp_refusal why = refused_word(noise);
    if (why != REFUSED_NOT) {
        return why;
    }
    const struct parameters p = parameters_of(noise);
    why = refused_number(noise, &p);
    return why != REFUSED_NOT                                              ? why
           : reserved_in_use(noise)                                        ? REFUSED_SPARE
           : noise->phase != 0.0f && !basis_has(noise->basis, BASIS_FLOWS) ? REFUSED_PHASE_BASIS
           : dimensions != 2 && dimensions != 3                            ? REFUSED_DIMENSIONS
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
