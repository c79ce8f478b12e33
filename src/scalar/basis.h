/* SPDX-License-Identifier: MIT
 *
 * Reference, stage 2: one octave of noise with gradient and Hessian, in units of cells. Included by
 * turn.h, and by tests.
 */
#ifndef SCARP_SCALAR_BASIS_H
#define SCARP_SCALAR_BASIS_H

#include "gradient.h"
#include "value.h"

static inline struct sample basis_at(const struct scarp_call_plan *plan,
                                     const struct scarp_octave *o, const struct place *p,
                                     int dimensions)
{
    const uint32_t *const x = p->cell[0];
    struct column l, r;
    switch (plan->basis) { /* no default: a compiler warns of a basis that is missing */
    case SCARP_GRADIENT:
        l = gradient_column(o->key, x[0], p, plan->fade, dimensions);
        r = gradient_column(o->key, x[1], p, plan->fade, dimensions);
        break;
    case SCARP_VALUE:
        l = value_column(o->key, x[0], p, plan->fade, dimensions);
        r = value_column(o->key, x[1], p, plan->fade, dimensions);
        break;
    }
    return join(&l, &r, p->t[0], fade(plan->fade, p->t[0]));
}

#endif
