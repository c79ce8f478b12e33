/* SPDX-License-Identifier: MIT
 *
 * Reference, stage 2: one octave of noise with gradient and Hessian, in units of cells.
 */
#ifndef SCARP_SCALAR_BASIS_H
#define SCARP_SCALAR_BASIS_H

#include "../plan/outputs.h"
#include "positions.h"

/* What the formulas leave to C */
#include "directions.h"
#include "numbers.h"

#include "../formulas/cells.h"
#include "../formulas/gradient.h"
#include "../formulas/simplex.h"
#include "../formulas/value.h"

/* A basis, or a sum of octaves, at one point. In 2D the outputs along z are not used. */
struct outputs {
    float of[OUTPUTS];
};

static inline struct outputs outputs_of(struct sample s)
{
    const struct outputs outputs = {{
        [VALUE] = s.value,
        [DX] = s.gradient.x,
        [DY] = s.gradient.y,
        [DZ] = s.gradient.z,
        [DXX] = s.diagonal.x,
        [DXY] = s.mixed.x,
        [DXZ] = s.mixed.y,
        [DYY] = s.diagonal.y,
        [DYZ] = s.mixed.z,
        [DZZ] = s.diagonal.z,
    }};
    return outputs;
}

/* `turn` is how far gradients are turned; NULL: they are at rest. */
static inline struct lattice lattice_of(const struct scarp_octave *o, const float *turn,
                                        int component)
{
    struct lattice l = {
        .key = {o->key[0], o->key[1], o->key[2]},
        .last = {o->last[0], o->last[1], o->last[2]},
        .flows = turn != NULL,
        .jitter = o->jitter,
        .middle = o->middle,
        .component = (uint)component,
    };
    if (turn != NULL) {
        l.turn = (vec4){turn[0], turn[1], turn[2], turn[3]};
    }
    return l;
}

static inline struct sample formula_at(const struct scarp_call_plan *plan, struct lattice l,
                                       const struct location *p, int dimensions)
{
    struct sample s = constant(0.0f);
    switch (plan->basis) { /* no default: a compiler warns of a basis that is missing */
    case SCARP_GRADIENT: s = gradient_at(l, plan->fade, *p, dimensions); break;
    case SCARP_VALUE: s = value_at(l, plan->fade, *p, dimensions); break;
    case SCARP_SIMPLEX: s = simplex_at(l, *p, dimensions); break;
    case SCARP_CELL_F1:
    case SCARP_CELL_F2:
    case SCARP_CELL_EDGE:
    case SCARP_CELL_SOFT:
    case SCARP_CELL_VALUE: s = cells_at(l, plan->basis, *p, dimensions); break;
    }
    return s;
}

/* All formulas become part of these two functions. They take structures by value, which calls would
   put into memory: at -O2 gradient and value noise would take a tenth more time. */
#define FLATTEN __attribute__((flatten))

static inline FLATTEN struct outputs turned_basis_at2(const struct scarp_call_plan *plan,
                                                      const struct scarp_octave *o,
                                                      const struct location *p, const float *turn)
{
    return outputs_of(formula_at(plan, lattice_of(o, turn, plan->component), p, 2));
}

static inline FLATTEN struct outputs turned_basis_at3(const struct scarp_call_plan *plan,
                                                      const struct scarp_octave *o,
                                                      const struct location *p, const float *turn)
{
    return outputs_of(formula_at(plan, lattice_of(o, turn, plan->component), p, 3));
}

static inline struct outputs turned_basis_at(const struct scarp_call_plan *plan,
                                             const struct scarp_octave *o, const struct location *p,
                                             const float *turn, int dimensions)
{
    return dimensions == 2 ? turned_basis_at2(plan, o, p, turn)
                           : turned_basis_at3(plan, o, p, turn);
}

static inline struct outputs basis_at(const struct scarp_call_plan *plan,
                                      const struct scarp_octave *o, const struct location *p,
                                      int dimensions)
{
    return turned_basis_at(plan, o, p, plan->flows ? o->turn : NULL, dimensions);
}

/* The derivative of the basis by the angle of the phase, with derivatives of its own: noise is
   linear in its gradients. */
static inline struct outputs basis_turning(const struct scarp_call_plan *plan,
                                           const struct scarp_octave *o, const struct location *p,
                                           int dimensions)
{
    float derivative[4];
    scarpi_phase_derivative(derivative, o->turn);
    return turned_basis_at(plan, o, p, derivative, dimensions);
}

#endif
