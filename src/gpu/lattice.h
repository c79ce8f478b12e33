/* SPDX-License-Identifier: MIT
 *
 * Shaders: where a point lies in the frame of an octave, and what the lattice draws there; as
 * scalar/positions.h and scalar/lattice.h. Included by corners.h.
 */
#ifndef SCARP_GPU_LATTICE_H
#define SCARP_GPU_LATTICE_H

#include "numbers.h"

#define HASH_X 0x1a2012f5u
#define HASH_Y 0x14e84743u
#define HASH_Z 0xec1d7da1u
#define HASH_K 0x9e3779b9u

static inline uint hash_axis(uint i, uint multiplier, uint key)
{
    const uint h = i * multiplier + key;
    return (h >> 8u) | (h << 24u);
}

static inline uint hash2(uvec3 key, uint x, uint y)
{
    const uint h = hash_axis(x, HASH_X, key.x) ^ hash_axis(y, HASH_Y, key.y);
    return h * (h + HASH_K);
}

static inline uint joined3(uvec3 key, uint x, uint y, uint z)
{
    return hash_axis(x, HASH_X, key.x) ^ hash_axis(y, HASH_Y, key.y) ^ hash_axis(z, HASH_Z, key.z);
}

static inline uint hash3(uvec3 key, uint x, uint y, uint z)
{
    const uint h = joined3(key, x, y, z);
    return h * (h + HASH_K);
}

/* The hash as a signed number, rounded to float: only the addition rounds. */
static inline float lattice_value(uint hash)
{
    const float high = (float)((int)hash >> 16u) * 65536.0f;
    return high + (float)(hash & 0xffffu);
}

/* The cells after and before one along an axis, within the period whose last cell is `last`. */
static inline uint cell_after(uint last, uint cell)
{
    return cell == last ? 0u : cell + 1u;
}

static inline uint cell_before(uint last, uint cell)
{
    return cell == 0u ? last : cell - 1u;
}

/* The cell that is `steps` further, -2 to 2. */
static inline uint cell_beside(uint last, uint cell, int steps)
{
    uint c = cell;
    if (steps > 0) {
        c = cell_after(last, c);
    }
    if (steps > 1) {
        c = cell_after(last, c);
    }
    if (steps < 0) {
        c = cell_before(last, c);
    }
    if (steps < -1) {
        c = cell_before(last, c);
    }
    return c;
}

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

/* A point of one octave. */
struct place {
    uvec3 cell;
    uvec3 next;
    vec3 t;
};

/* Along each axis p = J x + o, where axes are turned, else p = f x + o. */
static inline vec3 position_of(struct octave o, bool turned, vec3 x, int dimensions)
{
    vec3 p = mul3(o.frequency, x);
    if (turned) {
        p = times(rows_of(o.jacobian_x, o.jacobian_y, o.jacobian_z), x, dimensions);
    }
    return add3(p, vec3_of(o.offset_x, o.offset_y, o.offset_z));
}

/* Along y, triangles of simplex noise count their rows. */
static inline struct place place_of(struct octave o, uint basis, bool turned, vec3 x,
                                    int dimensions)
{
    vec3 p = position_of(o, turned, x, dimensions);
    if (basis == SIMPLEX && dimensions == 2) {
        p.y = p.y * o.turn.z;
    }
    const struct split sx = split(p.x, o.last.x);
    const struct split sy = split(p.y, o.last.y);
    struct place at;
    at.t = vec3_of(sx.t, sy.t, 0.0f);
    at.cell.x = sx.cell;
    at.cell.y = sy.cell;
    at.cell.z = 0u;
    at.next.x = cell_after(o.last.x, sx.cell);
    at.next.y = cell_after(o.last.y, sy.cell);
    at.next.z = 0u;
    if (dimensions == 3) {
        const struct split sz = split(p.z, o.last.z);
        at.t.z = sz.t;
        at.cell.z = sz.cell;
        at.next.z = cell_after(o.last.z, sz.cell);
    }
    return at;
}

#endif
