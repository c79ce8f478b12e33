/* SPDX-License-Identifier: MIT
 *
 * Why descriptions are refused. Checks give a row of the one table, and calls return what is
 * there: a status, the member at fault, and the reason.
 */
#ifndef SCARP_REFUSALS_H
#define SCARP_REFUSALS_H

#include "members.h"
#include "scarp.h"

#define SCARP_REFUSED_NUMBER(X, member, refusal, standard, lowest, highest, told, ...)             \
    X(refusal, PARAMETER, #member, told)
#define SCARP_REFUSED_NARROW(X, member, refusal, lowest, highest, told)                            \
    X(refusal, PARAMETER, #member, told)

/* X(name, status, member, text). An empty member: no member is at fault. Texts are clauses about
   the member, without a full stop. Rows of the three axes are together, in their order. */
#define SCARP_REFUSALS(X)                                                                          \
    X(POINTER, NULL, "", "a required pointer is NULL")                                             \
    X(BASIS, ENUM, "basis", "there is no such basis")                                              \
    X(FADE, ENUM, "fade", "there is no such fade")                                                 \
    X(FRACTAL, ENUM, "fractal", "there is no such fractal")                                        \
    SCARP_NOISE_MEMBERS(SCARP_REFUSED_NUMBER, SCARP_NO_MEMBER, X)                                  \
    SCARP_NARROW_MEMBERS(SCARP_REFUSED_NARROW, X)                                                  \
    X(OF_OCTAVES_LOW, PARAMETER, "of_octaves", "below octaves")                                    \
    X(LAST_FREQUENCY, PARAMETER, "octaves",                                                        \
      "the frequency of the last octave is outside [2^-32, 2^48]")                                 \
    X(SPARE, UNSUPPORTED, "spare", "a reserved member is not 0")                                   \
    X(PHASE_BASIS, UNSUPPORTED, "phase", "only gradient noise has a phase")                        \
    X(DIMENSIONS, PARAMETER, "", "dimensions are neither 2 nor 3")                                 \
    X(LACUNARITY_PERIOD, PARAMETER, "lacunarity",                                                  \
      "not a whole number, which octaves with a period need")                                      \
    X(PERIOD_X, PARAMETER, "period[0]", "more than 2^30 cells in the last octave")                 \
    X(PERIOD_Y, PARAMETER, "period[1]", "more than 2^30 cells in the last octave")                 \
    X(PERIOD_Z, PARAMETER, "period[2]", "more than 2^30 cells in the last octave")                 \
    X(ROTATE, UNSUPPORTED, "rotate", "turned axes cannot repeat")                                  \
    X(PERIOD_SIMPLEX, UNSUPPORTED, "period[1]",                                                    \
      "simplex noise repeats along x only in 2D; a slice of 3D, with periods, repeats along both") \
    X(WARP, UNSUPPORTED, "warp", "there are more than four warps")                                 \
    X(ORDER, PARAMETER, "", "the order of derivatives is not 0, 1 or 2")                           \
    X(HESSIAN, UNSUPPORTED, "fractal", "this fractal has no Hessian")                              \
    X(DPHASE_FRACTAL, UNSUPPORTED, "fractal", "this fractal has no dphase")                        \
    X(DPHASE_BASIS, UNSUPPORTED, "basis", "only gradient noise has dphase")                        \
    X(GPU_OCTAVES, UNSUPPORTED, "octaves", "more than 32 in all components")                       \
    X(GPU_WARP, UNSUPPORTED, "warp", "more than 32 octaves in the noise and its warps")            \
    SCARP_GULLIES_MEMBERS(SCARP_REFUSED_NUMBER, SCARP_NO_MEMBER, X)                                \
    X(HIGH_LOW, PARAMETER, "high", "less than 2^-10 above low")                                    \
    X(CELLS_X, PARAMETER, "period[0]", "times cells, not a whole number up to 2^30")               \
    X(CELLS_Y, PARAMETER, "period[1]", "times cells, not a whole number up to 2^30")               \
    X(FREQUENCY_CELLS, PARAMETER, "frequency", "times cells, outside [2^-32, 2^48]")               \
    X(ORIGIN_X, PARAMETER, "origin[0]", "not finite")                                              \
    X(ORIGIN_Y, PARAMETER, "origin[1]", "not finite")                                              \
    X(ORIGIN_Z, PARAMETER, "origin[2]", "not finite")                                              \
    X(STEP_X, PARAMETER, "step[0]", "not finite")                                                  \
    X(STEP_Y, PARAMETER, "step[1]", "not finite")                                                  \
    X(STEP_Z, PARAMETER, "step[2]", "not finite")                                                  \
    X(FIRST_X, PARAMETER, "first[0]", "outside [-2^53, 2^53]")                                     \
    X(FIRST_Y, PARAMETER, "first[1]", "outside [-2^53, 2^53]")                                     \
    X(FIRST_Z, PARAMETER, "first[2]", "outside [-2^53, 2^53]")                                     \
    X(COUNT_X, PARAMETER, "count[0]", "the last index is above 2^53")                              \
    X(COUNT_Y, PARAMETER, "count[1]", "the last index is above 2^53")                              \
    X(COUNT_Z, PARAMETER, "count[2]", "the last index is above 2^53")                              \
    X(ROW_STRIDE, PARAMETER, "row_stride", "shorter than a row")                                   \
    X(SLICE_STRIDE, PARAMETER, "slice_stride", "shorter than a slice")                             \
    X(SIZE, SIZE, "", "the arrays would exceed the address space")

#define REFUSED(name, status, member, text) REFUSED_##name,
enum scarp_refusal { REFUSED_NOT, SCARP_REFUSALS(REFUSED) REFUSALS };
#undef REFUSED

/* What is wrong with a description. */
struct scarp_fault {
    enum scarp_refusal why; /* REFUSED_NOT: nothing is */
    int warp; /* how many warps deep the member is: 0 in the noise itself. Where nothing is wrong,
                 this is any number up to SCARP_MAX_WARPS. */
};

/* Gives the reason, or NULL if nothing is wrong. *member, if `member` is there, becomes the path of
   the member, such as "warp.octaves", or NULL if none is at fault. */
const char *scarpi_fault_told(struct scarp_fault fault, const char **member);

/* Gives the status, and the same member. */
enum scarp_status scarpi_fault_status(struct scarp_fault fault, const char **member);

/* Makes the checks of scarp_noise_check, for all calls. In check.c. */
struct scarp_fault scarpi_plan_check(const struct scarp_noise *noise, int dimensions);

#endif
