/* SPDX-License-Identifier: MIT
 *
 * Formulas: what the lattice draws at its points, and its cells.
 *
 * The hash mixes each axis by itself, because the corners of a cell share the results; exclusive or
 * joins them to h, and the hash is h (h + k). Its top bits matter most. tests/test_hash.c states
 * what is asked of it.
 *
 * A change of bit b of h moves the hash by 2^b times 2 h + k, which differs from point to point:
 * neither lines that differ in few bits nor the corners of a cell are alike. Bit 31 moves it by
 * 2^31 only: the turn puts a low bit of the products there. Because k is odd, each even number is
 * the hash of two h, so that bits 1 to 31 are uniform.
 *
 * Other hashes fail. h M makes lines alike that differ in few bits. A product of the mixed axes is
 * nearly periodic on lines where a factor happens to be special. The square of h is that of ~h + 1,
 * too, so that every line across an axis is found again in its mirror image. Shifts of some 10^5
 * cells along two axes leave sums of mixed axes as they are.
 *
 * A search among random odd numbers found the multipliers. With them, shifts along an axis that
 * move only the top four bits of h, after which indices depend on each other, are longer than 10^8
 * cells. k is 2^32 over the golden ratio. With these all statistics of tests/test_hash.c stay below
 * 4 in 2^20 points, and peaks of spectra below 19 times the mean.
 */
#ifndef SCARP_FORMULAS_LATTICE_H
#define SCARP_FORMULAS_LATTICE_H

#include "c.h"

#define HASH_X 0x1a2012f5u
#define HASH_Y 0x14e84743u
#define HASH_Z 0xec1d7da1u
#define HASH_K 0x9e3779b9u

static inline uint hash_axis(uint i, uint multiplier, uint key)
{
    const uint h = i * multiplier + key;
    return h >> 8 | h << 24;
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

/*
 * Vector noise has components that draw from one hash of each lattice point: these give the hash
 * that stands in for h in the draws of a component, 0, 1 or 2. Component 0 draws as noise with one
 * component does.
 *
 * Draws are made of the top of a hash, and so are these: the low bits of h (h + k) depend on those
 * of neighbours. In 2D, gradients are drawn by four bits, and components take four bits each. In
 * 3D, the upper half times 12 has the number of the gradient above its fraction, of which the next
 * component makes the same again. Values take all bits. There the halves change places, so that the
 * upper one moves every bit of the product. tests/hash_components.h has statistics of all pairs of
 * components.
 */
#define HASH_VALUES_1 0x9e3779b1u
#define HASH_VALUES_2 0x85ebca6bu

static inline uint component_hash2(uint hash, uint component)
{
    return hash << (4u * component);
}

static inline uint component_hash3(uint hash, uint component)
{
    const uint twelves = component == 0u ? 1u : (component == 1u ? 12u : 144u);
    return (hash >> 16) * twelves << 16;
}

static inline uint component_hash_values(uint hash, uint component)
{
    const uint turned = hash >> 16 | hash << 16;
    const uint product = turned * (component == 1u ? HASH_VALUES_1 : HASH_VALUES_2);
    return component == 0u ? hash : product;
}

/* The cells after and before one along an axis, within the period whose last cell is `last`. */
static inline uint cell_after(uint last, uint cell)
{
    return cell == last ? 0 : cell + 1;
}

static inline uint cell_before(uint last, uint cell)
{
    return cell == 0 ? last : cell - 1;
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

/* A point of one octave: along each axis the lattice points on either side, modulo 2^32 or the
   period, and the position in between, in [0, 1] (rounding can reach 1; the noise is continuous
   there). In 2D all of z is 0. */
struct location {
    uvec3 cell, next;
    vec3 t;
};

/* The lattice of an octave. */
struct lattice {
    uvec3 key;      /* of the hash */
    uvec3 last;     /* the last cell of the period along each axis; 2^32 - 1 without period */
    bool flows;     /* whether gradients are turned */
    vec4 turn;      /* how far: the cosine and sine of an angle, then of twice that */
    float jitter;   /* how far features of cellular noise stray, in units of 2^-32 cells */
    float middle;   /* what is subtracted from distances */
    uint component; /* which component of vector noise; 0 of noise that has one */
};

#endif
