/* SPDX-License-Identifier: MIT
 *
 * Says what the sum of hybrid noise can be. octaves.c divides by its highest; check.c tells
 * its range.
 */
#ifndef SCARP_HYBRID_H
#define SCARP_HYBRID_H

struct scarp_interval {
    double lowest, highest;
};

/*
 * The head-room for rounding in hybrid noise. |n_k| has its own, so it is at most 1, or at most the
 * `reach` with a phase, in float arithmetic too. What is computed with it keeps the relative error:
 * an octave takes u = v (n + sharpness), two roundings, and the next weight, the rounded share
 * times u, two more. Ends of intervals are products of ends, and rounding is monotone; so each end
 * of u_k is off by at most 4 k + 2 roundings, and a_k u_k by two more. The sum adds 31, of numbers
 * whose own errors these are. With 32 octaves, 159 roundings of 2^-24 make 9.5e-6 of each part,
 * which is less than 2^-16 = 1.5e-5. (Parts that are subnormal are off by more, but so small
 * besides the first one, of at least 2^-31, that the difference is room for them: weights that have
 * become small with shares below 1 stay small.)
 */
#define SCARP_HYBRID_ROUNDING 0x1p-16
#define SCARP_HYBRID_HEADROOM (1.0 - SCARP_HYBRID_ROUNDING)

/*
 * Where gain^0 u_0 + gain^1 u_1 + ..., the last one times the fraction of `octaves`, lies if every
 * n_k is in [-reach, reach]. An interval for each u_k follows from that of the weight before it.
 * The highest is reached where every n_k is `reach`. The lowest has room for roundings: each part
 * that it is the sum of is lower by SCARP_HYBRID_ROUNDING of its magnitude. So it is 0 exactly, and
 * no sum is below 0, where the sharpness is `reach`, and positive where the sharpness is more.
 */
struct scarp_interval scarpi_hybrid_interval(double sharpness, double gain, double octaves,
                                             double reach);

/*
 * The range of the noise whose amplitudes are those of octaves[1] octaves, of which octaves[0] are
 * summed, in units of the amplitude. Fewer octaves lack what is positive in the lowest of all.
 */
struct scarp_interval scarpi_hybrid_range(double sharpness, double gain, const double octaves[2],
                                          double reach);

#endif
