/* SPDX-License-Identifier: MIT
 *
 * Reference: noise with warps, and vector noise.
 */
#ifndef SCARP_SCALAR_WARP_H
#define SCARP_SCALAR_WARP_H

#include "driver.h"

#include "../formulas/warp.h"

/* Displaces x, which is not displaced yet. */
static struct point moved(const struct point *x, struct displaced y)
{
    struct point at = *x;
    at.displaced = 1;
    at.f32 = add3(at.f32, values_of(y));
    return at;
}

/* A component of the potentials of a plan that has warps: from the deepest one, which looks at x, to
   the noise. */
static struct sampled warped_at(const struct scarp_call_plan *plan, const struct point *x,
                                int dimensions, int component)
{
    const int depth = plan->warps.depth;
    struct displaced y = not_displaced();
    struct point at = *x;
    struct scarp_call_plan of_level;
    for (int level = depth; level > 0; level--) {
        struct sample of[3] = {constant(0.0f), constant(0.0f), constant(0.0f)};
        for (int i = 0; i < dimensions; i++) {
            of_level = scarpi_component_plan(plan, level, i);
            of[i] = sum_octaves(&of_level, &at, dimensions).s;
            if (level < depth) {
                of[i] = composed(of[i], y, dimensions);
            }
        }
        y = positions_of(displaced_of(of[0], of[1], of[2]));
        at = moved(x, y);
    }
    of_level = scarpi_component_plan(plan, 0, component);
    struct sampled s = sum_octaves(&of_level, &at, dimensions);
    s.s = composed(s.s, y, dimensions);
    return s;
}

/* The noise of a plan, or a component of its potentials, with the warps. */
static struct sampled component_at(const struct scarp_call_plan *plan, const struct point *x,
                                   int dimensions, int component)
{
    if (plan->warps.depth > 0) {
        return warped_at(plan, x, dimensions, component);
    }
    if (!plan->warps.vector) {
        return sum_octaves(plan, x, dimensions);
    }
    const struct scarp_call_plan of_component = scarpi_component_plan(plan, 0, component);
    return sum_octaves(&of_component, x, dimensions);
}

static struct sampled sample_at(const struct scarp_call_plan *plan, const struct point *x,
                                int dimensions)
{
    return component_at(plan, x, dimensions, 0);
}

#endif
