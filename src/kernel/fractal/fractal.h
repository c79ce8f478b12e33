/* SPDX-License-Identifier: MIT
 *
 * Stage 3, the fractal: what it makes of the noise of each octave. fBm with straight axes needs
 * none: the basis is added to the sums as it is.
 *
 * A fractal is a file with its pass (turn.h has the type) and a line in `fractals`.
 */
#ifndef SCARP_KERNEL_FRACTAL_H
#define SCARP_KERNEL_FRACTAL_H

#include "phase.h"

struct fractal {
    fractal_pass *pass[2][3]; /* by [dimensions - 2][order]; NULL: the noise is added as it is */
    phase_pass *phase[2];     /* by [dimensions - 2] */
    int extra_order;          /* derivatives of the basis that it needs beyond those asked for */
    int octave_axes;          /* whether they are in the octave's own axes, times the amplitude */
};

#define FOLD                                                                                       \
    {                                                                                              \
        .pass = {{fold2_order0, fold2_order1, fold2_order2},                                       \
                 {fold3_order0, fold3_order1, fold3_order2}},                                      \
        .phase = {                                                                                 \
            fold_phase,                                                                            \
            fold_phase                                                                             \
        }                                                                                          \
    }
#define WEIGHTED                                                                                   \
    {                                                                                              \
        .pass = {{weighted2_order0, weighted2_order1, weighted2_order2},                           \
                 {weighted3_order0, weighted3_order1, weighted3_order2}},                          \
        .phase = {                                                                                 \
            weighted_phase,                                                                        \
            weighted_phase                                                                         \
        }                                                                                          \
    }

static const struct fractal fractals[] = {
    [SCARP_FBM] = {.extra_order = 0},
    [SCARP_TURBULENCE] = FOLD,
    [SCARP_RIDGED] = WEIGHTED,
    [SCARP_EROSION] = {.pass = {{erosion2_order0, erosion2_order1, NULL},
                                {erosion3_order0, erosion3_order1, NULL}},
                       .phase = {erosion2_phase, erosion3_phase},
                       .extra_order = 1,
                       .octave_axes = 1},
    [SCARP_PINGPONG] = FOLD,
    [SCARP_HYBRID] = WEIGHTED,
};

#undef FOLD
#undef WEIGHTED

/* Vectors of state for a block. */
static size_t state_size(const struct scarp_call_plan *plan, int dimensions)
{
    switch (plan->fractal) {
    case SCARP_RIDGED:
    case SCARP_HYBRID: return sample_size(dimensions, plan->order);
    case SCARP_EROSION: return erosion_size(dimensions, plan->order, plan->rotate);
    default: return 0;
    }
}

/* What the first octave finds: weights of 1 for ridged and hybrid noise, no slopes for erosion. */
static void state_begin(const struct scarp_call_plan *plan, vf *state, size_t size, size_t blocks)
{
    const vf first = vf_set(plan->fractal == SCARP_EROSION ? 0.0f : 1.0f);
    for (vf *const end = state + blocks * size; state < end; state += size) {
        state[0] = first;
        for (size_t i = 1; i < size; i++) {
            state[i] = vf_set(0.0f);
        }
    }
}

#endif
