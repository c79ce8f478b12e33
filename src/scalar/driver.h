/* SPDX-License-Identifier: MIT
 *
 * Reference: the sum of the octaves at one point.
 */
#ifndef SCARP_SCALAR_DRIVER_H
#define SCARP_SCALAR_DRIVER_H

#include "positions.h"

#include "../formulas/basis.h"
#include "../formulas/octaves.h"

WHOLE struct sample basis_at2(const struct scarp_call_plan *plan, int k, const struct location *at)
{
    return basis_at(octave_of(plan, k, 2), level_of(plan), *at, 2);
}

WHOLE struct sample basis_at3(const struct scarp_call_plan *plan, int k, const struct location *at)
{
    return basis_at(octave_of(plan, k, 3), level_of(plan), *at, 3);
}

/* The derivative of octave k of the basis with respect to the phase, with its gradient in its own
   axes: noise is linear in its gradients. */
static inline struct sample turning_at(const struct scarp_call_plan *plan, int k,
                                       const struct location *at, int dimensions)
{
    const float slope = scarpi_phase_slope(&plan->octave[k], k);
    struct scarp_octave turned = plan->octave[k];
    struct scarp_call_plan of = *plan;
    scarpi_phase_derivative(turned.turn, plan->octave[k].turn);
    of.octave = &turned;
    const struct sample s = dimensions == 2 ? basis_at2(&of, 0, at) : basis_at3(&of, 0, at);
    return scaled(s, slope, slope, slope);
}

/* Adds what an octave adds to the derivative with respect to the phase, which is a sum of its own,
   as if that were the derivative along x. */
static inline struct state with_turning(struct state state, struct octave o, struct level l,
                                        struct sample basis, struct sample turning, int dimensions)
{
    const float value = o.amplitude * basis.value;
    const struct sample n = along_phase(value, turning.value);
    struct state s = state;
    if (l.fractal != SCARP_EROSION) {
        return with_noise(state, o, l, false, n, dimensions);
    }
    s.slopes.d = add3(state.slopes.d, mul3(o.amplitude, basis.gradient));
    s.slopes.jacobian.x.x += turning.gradient.x;
    s.slopes.jacobian.y.x += turning.gradient.y;
    s.slopes.jacobian.z.x += turning.gradient.z;
    const struct sample term = eroded(s.slopes, l.erosion, value, n.gradient, dimensions);
    s.sum.gradient.x += o.weight * term.gradient.x;
    return s;
}

/* What octave 0 adds to: -0, which leaves the bits of every number as they are. Sums of fractals
   that bend begin with 0. */
static inline struct state first_state(const struct scarp_call_plan *plan)
{
    const vec3 none = {-0.0f, -0.0f, -0.0f};
    struct state state = no_octaves();
    if (!fractal_bends(plan->fractal)) {
        state.sum = sample_of(-0.0f, none, none, none);
    }
    return state;
}

/* The same of fBm without a derivative with respect to the phase, which needs no state. */
WHOLE struct sampled sum_fbm(const struct scarp_call_plan *plan, const struct point *x,
                             int dimensions)
{
    struct sampled s = {first_state(plan).sum, 0.0f};
    for (int k = 0; k < plan->octaves; k++) {
        const struct octave o = octave_of(plan, k, dimensions);
        const struct location at = location_at(plan, k, x, dimensions);
        const struct sample basis =
            dimensions == 2 ? basis_at2(plan, k, &at) : basis_at3(plan, k, &at);
        s.s = sum_of(s.s, in_input(o, is_turned(plan, k), basis, dimensions));
    }
    return s;
}

WHOLE struct sampled sum_octaves(const struct scarp_call_plan *plan, const struct point *x,
                                 int dimensions)
{
    if (plan->fractal == SCARP_FBM && !plan->dphase) {
        return sum_fbm(plan, x, dimensions);
    }
    const struct level l = level_of(plan);
    struct state sum = first_state(plan), by_phase = sum;
    for (int k = 0; k < plan->octaves; k++) {
        const struct octave o = octave_of(plan, k, dimensions);
        const int turned = is_turned(plan, k);
        struct location at;
        if (fractal_bends(plan->fractal) && k > 0) {
            struct point y = *x;
            y.f32 = bent(sum, o, (uint)k, x->f32);
            y.displaced = 1;
            at = location_at(plan, k, &y, dimensions);
        } else {
            at = location_at(plan, k, x, dimensions);
        }
        const struct sample basis =
            dimensions == 2 ? basis_at2(plan, k, &at) : basis_at3(plan, k, &at);
        sum = with_basis(sum, o, l, k == 0, turned, basis, dimensions);
        if (plan->dphase) {
            const struct sample turning = turning_at(plan, k, &at, dimensions);
            by_phase = with_turning(by_phase, o, l, basis, turning, dimensions);
        }
    }
    return (struct sampled){sum.sum, by_phase.sum.gradient.x};
}

#endif
