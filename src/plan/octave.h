/* SPDX-License-Identifier: MIT
 *
 * The constants of a plan as the formulas have them: for the reference, and for shaders.
 */
#ifndef SCARP_PLAN_OCTAVE_H
#define SCARP_PLAN_OCTAVE_H

#include "../formulas/octave.h"
#include "call.h"

/* Whether an octave's axes are turned: then p = J x + o, else p = f x + o. In octave 0 o is 0;
   adding it turns -0 into 0. */
static inline int is_turned(const struct scarp_call_plan *plan, int octave)
{
    return plan->rotate && octave + plan->first > 0;
}

static inline vec3 vec3_from(const float v[3], int dimensions)
{
    return vec3_of(v[0], v[1], dimensions == 3 ? v[2] : 0.0f);
}

/* The turn of gradients that flow, or the numbers of bases that take places. */
static inline vec4 turns_of_octave(const struct scarp_call_plan *plan, const struct scarp_octave *o)
{
    vec4 turn = {0.0f, 0.0f, 0.0f, 0.0f};
    if (!blends_corners(plan->basis)) {
        turn = (vec4){o->jitter, o->middle, (float)o->stretch, 0.0f};
    } else if (plan->flows) {
        turn = (vec4){o->turn[0], o->turn[1], o->turn[2], o->turn[3]};
    }
    return turn;
}

/* Octave k of a plan. What it does not need is 0. */
static inline struct octave octave_of(const struct scarp_call_plan *plan, int k, int dimensions)
{
    const struct scarp_octave *const from = &plan->octave[k];
    const int turned = is_turned(plan, k);
    struct octave o = {
        .key = {from->key[0], from->key[1], from->key[2]},
        .last = {from->last[0], from->last[1], dimensions == 3 ? from->last[2] : UINT32_MAX},
        .frequency = from->frequency,
        .weight = from->weight,
        .amplitude = from->amplitude,
        .slope = from->slope,
        .curvature = from->curvature,
        .share = from->share,
        .turn = turns_of_octave(plan, from),
        .offset_x = (float)from->offset[0],
        .offset_y = (float)from->offset[1],
        .offset_z = dimensions == 3 ? (float)from->offset[2] : 0.0f,
    };
    if (turned) {
        o.jacobian_x = vec3_from(from->jacobian[0], dimensions);
        o.jacobian_y = vec3_from(from->jacobian[1], dimensions);
        o.gradient_x = vec3_from(from->gradient[0], dimensions);
        o.gradient_y = vec3_from(from->gradient[1], dimensions);
    }
    if (turned && dimensions == 3) {
        o.jacobian_z = vec3_from(from->jacobian[2], dimensions);
        o.gradient_z = vec3_from(from->gradient[2], dimensions);
    }
    if (fractal_bends(plan->fractal)) {
        const struct bend_octave b = bend_octave_of(plan, k);
        o.inverse = b.inverse;
        o.reach = b.reach;
    }
    return o;
}

/* What octaves share; how many there are, and where, shaders know. */
static inline struct level level_of(const struct scarp_call_plan *plan)
{
    const struct level l = {
        .basis = plan->basis,
        .fade = plan->fade,
        .fractal = plan->fractal,
        .flows = plan->flows != 0,
        .component = (uint)plan->component,
        .erosion = plan->erosion,
        .sharpness = plan->sharpness,
        .inverse_weight =
            fractal_bends(plan->fractal) ? bend_octave_of(plan, 0).inverse_weight : 0.0f,
    };
    return l;
}

#endif
