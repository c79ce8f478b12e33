/* SPDX-License-Identifier: MIT
 *
 * Formulas: where a point lies in the frame of an octave.
 */
#ifndef SCARP_FORMULAS_POSITIONS_H
#define SCARP_FORMULAS_POSITIONS_H

#include "lattice.h"
#include "matrices.h"
#include "octave.h"
#include "signs.h"

static inline uint within_period(uint last, int cell)
{
    uint within = (uint)cell;
    if (last != 0xffffffffu) {
        const uint period = last + 1u;
        if (cell < 0) {
            within = last - (~within) % period;
        } else {
            within = within % period;
        }
    }
    return within;
}

/* A point along one axis of an octave: its cell, and where it lies inside. */
struct split {
    uint cell;
    float t;
};

static inline struct split split(float p, uint last)
{
    struct split s;
    if (magnitude(p) < 2147483648.0f) {
        const int whole = (int)p;
        const int lower = (float)whole > p ? whole - 1 : whole;
        s.cell = within_period(last, lower);
        s.t = p - (float)lower;
    } else {
        s.cell = within_period(last, (int)SIGN);
        s.t = p - p;
    }
    return s;
}

/* J x where axes are turned, else f x: how many cells of the octave x is along each axis. */
static inline vec3 cells_along(struct octave o, bool turned, vec3 x, int dimensions)
{
    vec3 p = mul3(o.frequency, x);
    if (turned) {
        p = times(rows_of(o.jacobian_x, o.jacobian_y, o.jacobian_z), x, dimensions);
    }
    return p;
}

/* Along y, triangles of simplex noise count their rows. */
static inline vec3 stretched(struct octave o, uint basis, vec3 cells, int dimensions)
{
    vec3 p = cells;
    if (basis == SCARP_SIMPLEX && dimensions == 2) {
        p.y *= o.turn.z;
    }
    return p;
}

/* Where a point lies by its splits along the axes. In 2D all of z is 0. */
static inline struct location location_in(uvec3 last, struct split x, struct split y,
                                          struct split z, int dimensions)
{
    struct location at = {
        .cell = {x.cell, y.cell, 0},
        .next = {cell_after(last.x, x.cell), cell_after(last.y, y.cell), 0},
        .t = {x.t, y.t, 0.0f},
    };
    if (dimensions == 3) {
        at.t.z = z.t;
        at.cell.z = z.cell;
        at.next.z = cell_after(last.z, z.cell);
    }
    return at;
}

/* Along each axis p = J x + o, where axes are turned, else p = f x + o. */
static inline struct location location_of(struct octave o, uint basis, bool turned, vec3 x,
                                          int dimensions)
{
    const vec3 offset = vec3_of(o.offset_x, o.offset_y, o.offset_z);
    const vec3 cells = add3(cells_along(o, turned, x, dimensions), offset);
    const vec3 p = stretched(o, basis, cells, dimensions);
    struct split z = {0, 0.0f};
    if (dimensions == 3) {
        z = split(p.z, o.last.z);
    }
    return location_in(o.last, split(p.x, o.last.x), split(p.y, o.last.y), z, dimensions);
}

#endif
