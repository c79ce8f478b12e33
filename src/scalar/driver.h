/* SPDX-License-Identifier: MIT
 *
 * Reference: the sum of the octaves at one point.
 */
#ifndef SCARP_SCALAR_DRIVER_H
#define SCARP_SCALAR_DRIVER_H

#include "erosion.h"

/* What goes from octave to octave. */
struct state {
    struct outputs weight; /* ridged, hybrid */
    struct slopes slopes;  /* erosion */
    float by_phase[3];     /* erosion: the derivative of the slopes d by the phase */
};

/* The derivative of an octave of the basis by the phase, with its gradient in its own axes; 0 where
   it is not asked for. */
static struct outputs turning_of(const struct scarp_call_plan *plan, int k,
                                 const struct location *at, int dimensions)
{
    const struct scarp_octave *const o = &plan->octave[k];
    const float slope = scarpi_phase_slope(o, k);
    if (!plan->dphase) {
        return (struct outputs){{0.0f}};
    }
    const struct outputs turning = basis_turning(plan, o, at, dimensions);
    return scaled_outputs(&turning, slope, slope, slope);
}

/* Octave k, as it is added to the sum. */
static struct outputs octave_at(const struct scarp_call_plan *plan, int k, const struct point *x,
                                int dimensions, struct state *state)
{
    const struct scarp_octave *const o = &plan->octave[k];
    const int turned = is_turned(plan, k);
    const struct location at = location_of(plan, k, x, dimensions);
    const struct outputs turning = turning_of(plan, k, &at, dimensions);
    struct outputs basis = basis_at(plan, o, &at, dimensions);
    basis.of[DPHASE] = turning.of[VALUE];
    struct outputs n = in_input(o, turned, &basis, dimensions);
    float slope = o->weight;
    switch (plan->fractal) {
    case SCARP_FBM: return n;
    case SCARP_TURBULENCE: n = magnitude_of(&n); break;
    case SCARP_RIDGED: n = ridge(&state->weight, &n); break;
    case SCARP_PINGPONG:
        n = pingpong(&n, plan->sharpness);
        slope = o->weight * (2.0f * plan->sharpness);
        break;
    case SCARP_HYBRID: n = hybrid(&state->weight, &n, plan->sharpness, o->share); break;
    case SCARP_EROSION:
        basis = scaled_outputs(&basis, o->amplitude, o->amplitude, o->amplitude);
        n = erode(&state->slopes, plan->erosion, o, turned, &basis, dimensions);
        n.of[DPHASE] = erode_turning(&state->slopes, state->by_phase, plan->erosion,
                                     basis.of[VALUE], &turning, dimensions);
        break;
    case SCARP_SWISS:
    case SCARP_JORDAN: break; /* bend.h */
    }
    n.of[DPHASE] *= slope;
    return scaled_outputs(&n, o->weight, slope, slope);
}

static struct outputs sum_octaves(const struct scarp_call_plan *plan, const struct point *x,
                                  int dimensions)
{
    struct state state = {.weight = {{[VALUE] = 1.0f}}};
    struct outputs sum = octave_at(plan, 0, x, dimensions, &state);
    for (int k = 1; k < plan->octaves; k++) {
        const struct outputs s = octave_at(plan, k, x, dimensions, &state);
        for (int i = 0; i < OUTPUTS; i++) {
            sum.of[i] += s.of[i];
        }
    }
    return sum;
}

#endif
