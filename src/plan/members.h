/* SPDX-License-Identifier: MIT
 *
 * The numbers of struct scarp_noise and of struct scarp_gullies: the only table of their defaults
 * and intervals, with a row for each. Plans, checks and recipes are made of it. The comments of
 * scarp.h say the same, which src/bindings/interface.py --check compares; bindings and the program
 * have theirs from there.
 */
#ifndef SCARP_MEMBERS_H
#define SCARP_MEMBERS_H

#include <float.h>

/*
 * NUMBER(X, member, refusal, default, lowest, highest, why it is refused, least, most, text)
 *
 * 0 stands for the default, so it is in every interval. `refusal` is the name of its row in
 * refusals.h. `least` and `most` are the interval of a slider, and `text` what it does, for the
 * arguments of recipes, which have these members in this order.
 *
 * OTHER(X, member, default, least, most, text) has a check elsewhere, or none.
 *
 * While every f_k and the amplitude lie within these bounds, a_k f_k^2 times the largest second
 * derivative (below 2^6 for every basis, per cell squared) stays under 2^127. So no outputs
 * overflow but Hessians of ridged noise, which multiply gradients of octaves, and those of the
 * distances of cellular noise, which are up to 2^40 at features. The constants of the octaves that
 * matter stay normal floats, also in value noise, where they carry 2^-31.
 */
#define SCARP_NOISE_MEMBERS(NUMBER, OTHER, X)                                                      \
    NUMBER(X, frequency, FREQUENCY, 1.0, 0x1p-32, 0x1p48, "outside [2^-32, 2^48]", 0.0001, 1.0,    \
           "cells of the first octave per unit")                                                   \
    OTHER(X, seed, 0.0, 0.0, 1000.0, "a whole number, beside the seed of the world")               \
    NUMBER(X, octaves, OCTAVES, 1.0, 0.0, 32.0, "outside (0, 32]", 1.0, 12.0,                      \
           "how many octaves are summed; a fraction fades in")                                     \
    NUMBER(X, of_octaves, OF_OCTAVES, 0.0, 0.0, 32.0, "outside [octaves, 32]", 0.0, 12.0,          \
           "amplitudes are those of so many octaves")                                              \
    NUMBER(X, lacunarity, LACUNARITY, 2.0, 0x1p-4, 16.0, "outside [1/16, 16]", 1.5, 3.0,           \
           "frequency ratio between octaves")                                                      \
    NUMBER(X, gain, GAIN, 0.5, 0x1p-4, 16.0, "outside [1/16, 16]", 0.1, 0.9,                       \
           "amplitude ratio between octaves")                                                      \
    NUMBER(X, amplitude, AMPLITUDE, 1.0, 0x1p-24, 0x1p24,                                          \
           "its magnitude is outside [2^-24, 2^24]", 0.1, 200.0, "scales the noise")               \
    NUMBER(X, erosion, EROSION, 1.0, 0x1p-24, 0x1p24, "outside [2^-24, 2^24]", 0.1, 4.0,           \
           "how much slopes damp octaves")                                                         \
    NUMBER(X, phase, PHASE, 0.0, -FLT_MAX, FLT_MAX, "not finite", 0.0, 1.0,                        \
           "turns of the lattice's gradients")                                                     \
    NUMBER(X, jitter, JITTER, 1.0, 0.0, 1.0, "outside (0, 1]", 0.1, 1.0, "how far features stray") \
    NUMBER(X, sharpness, SHARPNESS, 0.0, 0x1p-24, 0x1p24, "outside [2^-24, 2^24]", 0.1, 4.0,       \
           "of some fractals, which have a default each")

/* NARROW(X, member, refusal, lowest, highest, why it is refused): of fractals with such traits */
#define SCARP_NARROW_MEMBERS(NARROW, X)                                                            \
    NARROW(X, erosion, EROSION_SHARE, 0x1p-24, 1.0, "this fractal takes 1 at most")                \
    NARROW(X, sharpness, SHARPNESS_USED, 0x1p-8, 0x1p8, "outside [2^-8, 2^8]")

/* What is OTHER here has the interval that a noise has. */
#define SCARP_GULLIES_MEMBERS(NUMBER, OTHER, X)                                                    \
    OTHER(X, frequency, 1.0, 0.0001, 0.1, "cells of the base per unit")                            \
    OTHER(X, seed, 0.0, 0.0, 1000.0, "a whole number, beside the seed of the world")               \
    NUMBER(X, amplitude, GULLIES_AMPLITUDE, 1.0, 0x1p-24, 0x1p24, "outside [2^-24, 2^24]", 1.0,    \
           1000.0, "of the base: half its height")                                                 \
    OTHER(X, octaves, 5.0, 1.0, 8.0, "how often gullies branch")                                   \
    OTHER(X, of_octaves, 0.0, 0.0, 8.0, "weights are those of so many octaves")                    \
    OTHER(X, lacunarity, 2.0, 1.5, 3.0, "frequency ratio between octaves")                         \
    OTHER(X, gain, 0.45, 0.2, 0.7, "weight ratio between octaves")                                 \
    NUMBER(X, depth, DEPTH, 0.25, 0x1p-24, 0x1p10, "outside [2^-24, 2^10]", 0.01, 1.0,             \
           "how far the base is displaced, in amplitudes")                                         \
    NUMBER(X, cells, CELLS, 3.0, 0x1p-6, 0x1p6, "outside [2^-6, 2^6]", 1.0, 8.0,                   \
           "cells of the first gullies per cell of the base")                                      \
    NUMBER(X, slope, SLOPE, 1.125, 0x1p-5, 0x1p5, "outside [2^-5, 2^5]", 0.25, 4.0,                \
           "where gullies of crests have half their depth")                                        \
    NUMBER(X, slope_low, SLOPE_LOW, 1.75, 0x1p-5, 0x1p5, "outside [2^-5, 2^5]", 0.25, 4.0,         \
           "the same of floors")                                                                   \
    NUMBER(X, low, LOW, -1.0, -0x1p10, 0x1p10, "outside [-2^10, 2^10]", -2.0, 2.0,                 \
           "the height of floors, in amplitudes")                                                  \
    NUMBER(X, high, HIGH, 1.0, -0x1p10, 0x1p10, "outside [-2^10, 2^10]", -2.0, 2.0,                \
           "the height of crests, in amplitudes")                                                  \
    NUMBER(X, floor, FLOOR, 0.5, -1.0, 1.0, "outside [-1, 1]", -1.0, 1.0, "how far floors sink")   \
    NUMBER(X, stripes, STRIPES, 1.5, 0x1p-10, 8.0, "outside [2^-10, 8]", 0.5, 4.0,                 \
           "gullies per cell")                                                                     \
    NUMBER(X, branch, BRANCH, 0.8, 0x1p-24, 8.0, "outside [2^-24, 8]", 0.1, 2.0,                   \
           "how far octaves turn those after them")                                                \
    NUMBER(X, round, ROUND, 0.15, 0x1p-8, 0x1p8, "outside [2^-8, 2^8]", 0.02, 1.0, "of crests")    \
    NUMBER(X, keep, KEEP, 1.0, 0x1p-24, 1.0, "outside [2^-24, 1]", 0.1, 1.0,                       \
           "how much crests and floors are spared")

/* Rows of members that are not wanted */
#define SCARP_NO_MEMBER(...)

struct scarp_bounds {
    double standard, lowest, highest;
};

#define DECLARE(X, member, ...) struct scarp_bounds member;
#define SET(X, member, refusal, standard, lowest, highest, ...)                                    \
    .member = {standard, lowest, highest},
#define DECLARE_NARROW(X, member, refusal, ...) struct scarp_bounds refusal;
#define SET_NARROW(X, member, refusal, lowest, highest, ...) .refusal = {0.0, lowest, highest},
static const struct {
    SCARP_NOISE_MEMBERS(DECLARE, SCARP_NO_MEMBER, )
    SCARP_NARROW_MEMBERS(DECLARE_NARROW, )
} noise_bounds = {SCARP_NOISE_MEMBERS(SET, SCARP_NO_MEMBER, ) SCARP_NARROW_MEMBERS(SET_NARROW, )};
static const struct {
    SCARP_GULLIES_MEMBERS(DECLARE, SCARP_NO_MEMBER, )
} gullies_bounds = {SCARP_GULLIES_MEMBERS(SET, SCARP_NO_MEMBER, )};
#define DECLARE_OTHER(X, member, ...) double member;
#define SET_OTHER(X, member, standard, ...) .member = (standard),
static const struct {
    SCARP_GULLIES_MEMBERS(SCARP_NO_MEMBER, DECLARE_OTHER, )
} gullies_standard = {SCARP_GULLIES_MEMBERS(SCARP_NO_MEMBER, SET_OTHER, )};
#undef DECLARE
#undef SET
#undef DECLARE_OTHER
#undef SET_OTHER
#undef DECLARE_NARROW
#undef SET_NARROW

/* A NaN is not within. */
static inline int within(double value, struct scarp_bounds bounds)
{
    return value >= bounds.lowest && value <= bounds.highest;
}

static inline double value_or(double value, double standard)
{
    return value == 0.0 ? standard : value;
}

#endif
