/* SPDX-License-Identifier: MIT
 *
 * Reference, stage 2: one octave of noise with gradient and Hessian, in units of cells. Included by
 * turn.h, and by tests.
 */
#ifndef SCARP_SCALAR_BASIS_H
#define SCARP_SCALAR_BASIS_H

#include "cells.h"
#include "gradient.h"
#include "simplex.h"
#include "value.h"

/* `turn` is how far gradients are turned; NULL: they are at rest. */
static inline struct sample turned_basis_at(const struct scarp_call_plan *plan,
                                            const struct scarp_octave *o, const struct place *p,
                                            const float *turn, int dimensions)
{
    const uint32_t *const x = p->cell[0];
    const struct turning lattice = {o->key, turn};
    struct column l, r;
    switch (plan->basis) { /* no default: a compiler warns of a basis that is missing */
    case SCARP_GRADIENT:
        l = gradient_column(lattice, x[0], p, plan->fade, dimensions);
        r = gradient_column(lattice, x[1], p, plan->fade, dimensions);
        break;
    case SCARP_VALUE:
        l = value_column(o->key, x[0], p, plan->fade, dimensions);
        r = value_column(o->key, x[1], p, plan->fade, dimensions);
        break;
    case SCARP_SIMPLEX: return simplex_at(o, p, dimensions);
    case SCARP_CELL_F1:
    case SCARP_CELL_F2:
    case SCARP_CELL_EDGE:
    case SCARP_CELL_SOFT:
    case SCARP_CELL_VALUE: return cells_at(plan->basis, o, p, dimensions);
    }
    return join(&l, &r, p->t[0], fade(plan->fade, p->t[0]));
}

static inline struct sample basis_at(const struct scarp_call_plan *plan,
                                     const struct scarp_octave *o, const struct place *p,
                                     int dimensions)
{
    return turned_basis_at(plan, o, p, plan->flows ? o->turn : NULL, dimensions);
}

/* The derivative of the basis by the angle of the phase, with derivatives of its own: noise is
   linear in its gradients. */
static inline struct sample basis_turning(const struct scarp_call_plan *plan,
                                          const struct scarp_octave *o, const struct place *p,
                                          int dimensions)
{
    float derivative[4];
    scarp_phase_derivative(derivative, o->turn);
    return turned_basis_at(plan, o, p, derivative, dimensions);
}

#endif
