/* SPDX-License-Identifier: MIT
 *
 * Reference: samples with their derivatives with respect to the phase, and the arrays of a call.
 */
#ifndef SCARP_SCALAR_SAMPLE_H
#define SCARP_SCALAR_SAMPLE_H

#include <stddef.h>

#include "../plan/outputs.h"

/* What the formulas leave to C */
#include "directions.h"
#include "numbers.h"

#include "../formulas/sample.h"

/* Each of these functions has all formulas in it. They take structures by value, which calls would
   put into memory: at -O2 gradient and value noise would take a tenth more time. */
#define WHOLE static __attribute__((flatten, noinline))

/* A sample with its derivative with respect to the phase. */
struct sampled {
    struct sample s;
    float by_phase;
};

/*
 * A value with the derivative with respect to the phase, as a sample has it that along x. What the
 * formulas make of its gradient is what becomes of that derivative.
 */
static inline struct sample along_phase(float value, float by_phase)
{
    struct sample s = constant(value);
    s.gradient.x = by_phase;
    return s;
}

/* Writes element i of the arrays that are there. */
static inline void put(float *const array[OUTPUTS], size_t i, const struct sampled *o)
{
    const float of[OUTPUTS] = {
        [VALUE] = o->s.value,    [DX] = o->s.gradient.x,  [DY] = o->s.gradient.y,
        [DZ] = o->s.gradient.z,  [DXX] = o->s.diagonal.x, [DXY] = o->s.mixed.x,
        [DXZ] = o->s.mixed.y,    [DYY] = o->s.diagonal.y, [DYZ] = o->s.mixed.z,
        [DZZ] = o->s.diagonal.z, [DPHASE] = o->by_phase,
    };
    for (int output = 0; output < OUTPUTS; output++) {
        if (array[output] != NULL) {
            array[output][i] = of[output];
        }
    }
}

#endif
