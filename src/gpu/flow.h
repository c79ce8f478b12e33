/* SPDX-License-Identifier: MIT
 *
 * Shaders: cells and velocities of a plan.
 */
#ifndef SCARP_GPU_FLOW_H
#define SCARP_GPU_FLOW_H

#include "noise.h"

#include "../formulas/curl.h"

/* What scarp_cells2 and scarp_cells3 give: distances to the nearest feature and to the second,
   their gradients, and the place of the nearest. */
struct cells {
    uint id;
    float f1;
    float f2;
    vec3 d1;
    vec3 d2;
    vec3 place;
};

/* The cells around a point x, which lies at p in octave o; `unit` is the length of a cell. */
static inline struct cells cells_around(struct octave o, struct location p, float unit, vec3 x,
                                        int dimensions)
{
    struct lattice l = {.key = o.key, .last = o.last};
    l.jitter = o.turn.x;
    const struct nearest n = nearest_at(l, p, dimensions);
    const struct sample first = distance_to(n.first);
    const struct sample second = distance_to(n.second);
    struct cells c;
    c.id = n.first.hash * FEATURE_ID;
    c.f1 = first.value * unit;
    c.f2 = second.value * unit;
    c.d1 = first.gradient;
    c.d2 = second.gradient;
    c.place = sub3(x, mul3(unit, n.first.d));
    return c;
}

static inline struct cells cells_in(uint plan, vec3 x, int dimensions)
{
    const struct octave o = octave_of(plan, 0u);
    const struct location p = location_of(o, SCARP_CELL_F1, false, x, dimensions);
    return cells_around(o, p, o.inverse, x, dimensions);
}

/* The cells of a noise whose basis is cellular. */
static inline struct cells cells2(uint plan, float x, float y)
{
    return cells_in(plan, vec3_of(x, y, 0.0f), 2);
}

static inline struct cells cells3(uint plan, float x, float y, float z)
{
    return cells_in(plan, vec3_of(x, y, z), 3);
}

/* What scarp_curl2 gives; nothing along z. */
static inline struct flow curl2(uint plan, float x, float y)
{
    return curl_in_plane(sample2(plan, x, y));
}

/* What scarp_curl3 gives, of a plan by scarp_gpu_vector_plan_make. */
static inline struct flow curl3(uint plan, float x, float y, float z)
{
    return curl_in_space(vector3(plan, x, y, z));
}

#endif
