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
 * The head-room for rounding in hybrid noise. Errors of n are multiplied into all weights behind:
 * relative to sharpness + 1 each is below 5.4e-6 (see HEADROOM in octaves.c, without the sum), and
 * the roundings of an octave are 1.8e-7. All of 32 octaves together are less than 1.8e-4, and the
 * sum 1.9e-6. That is below 2^-12 = 2.4e-4.
 */
#define SCARP_HYBRID_HEADROOM (1.0 - 0x1p-12)

/*
 * Where gain^0 u_0 + gain^1 u_1 + ..., the last one times the fraction of `octaves`, lies if every
 * n_k is in [-reach, reach]. An interval for each u_k follows from that of the weight before it.
 * The highest is reached where every n_k is `reach`; so is the lowest, where every n_k is -reach,
 * with a sharpness of at least `reach`.
 */
struct scarp_interval scarp_hybrid_interval(double sharpness, double gain, double octaves,
                                            double reach);

/*
 * The range of the noise whose amplitudes are those of octaves[1] octaves, of which octaves[0] are
 * summed, in units of the amplitude. Fewer octaves lack what is positive in the lowest of all. No
 * head-room keeps the lowest, so it has room for errors: those of n as if it reached 2^-17 further,
 * and 2^-16 for all roundings.
 */
struct scarp_interval scarp_hybrid_range(double sharpness, double gain, const double octaves[2],
                                         double reach);

#endif
