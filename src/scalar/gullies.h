/* SPDX-License-Identifier: MIT
 *
 * Reference: gullies at one point.
 */
#ifndef SCARP_SCALAR_GULLIES_H
#define SCARP_SCALAR_GULLIES_H

#include "../plan/gully.h"
#include "driver.h"

#include "../formulas/gullies.h"

static inline struct gully_shape gully_shape_of(const struct scarp_gully_plan *g)
{
    const struct gully_shape shape = {g->low,   g->steepness, g->slope2, g->slope2_low, g->lowered,
                                      g->round, g->round2,    g->fall,   g->branch};
    return shape;
}

static inline struct gully_octave gully_octave_of(const struct scarp_gully_octave *o)
{
    const struct gully_octave octave = {o->weight,
                                        o->keep,
                                        {o->waves[0], o->waves[1]},
                                        {o->angles[0], o->angles[1]},
                                        {o->cells[0], o->cells[1]},
                                        o->stretch};
    return octave;
}

/* The base at element i, in units of the call. */
static inline struct gully_base gully_base_at(const struct scarp_gully_call *call, size_t i)
{
    static const unsigned char order[BASE_INPUTS] = {0, 1, 1, 2, 2, 2};
    float of[BASE_INPUTS];
    for (int k = 0; k < BASE_INPUTS; k++) {
        of[k] = call->base[k] != NULL ? call->base[k][i] * call->gullies->of_base[order[k]] : 0.0f;
    }
    const struct gully_base base = {of[BASE_VALUE], of[BASE_DX],  of[BASE_DY],
                                    of[BASE_DXX],   of[BASE_DXY], of[BASE_DYY]};
    return base;
}

/* Element i of the arrays, which lies at x. */
WHOLE void gullies_at(const struct scarp_gully_call *call, const struct scarp_call_plan *plan,
                      size_t i, const struct point *x)
{
    const struct scarp_gully_plan *const g = call->gullies;
    const struct gully_shape shape = gully_shape_of(g);
    struct gully state = gully_begin(shape, gully_base_at(call, i));
    for (int k = 0; k < plan->octaves; k++) {
        const struct octave o = octave_of(plan, k, 2);
        const struct location at = location_at(plan, k, x, 2);
        state = gully_octave_at(shape, gully_octave_of(&g->octave[k]),
                                lattice_of(o, level_of(plan)), at, state);
    }
    const float displacement[3] = {g->of_sum[0] * state.sum.value, g->of_sum[1] * state.sum.d.x,
                                   g->of_sum[1] * state.sum.d.y};
    float of[ERODED_OUTPUTS];
    for (int k = 0; k < 3; k++) {
        of[ERODED_VALUE + k] = call->base[BASE_VALUE + k][i] + displacement[k];
        of[ERODED_DISPLACEMENT + k] = displacement[k];
    }
    for (int output = 0; output < ERODED_OUTPUTS; output++) {
        if (call->out[output] != NULL) {
            call->out[output][i] = of[output];
        }
    }
}

#endif
