/* SPDX-License-Identifier: MIT
 *
 * Where points lie on the lattice of an octave, and the lattice hash. Written over the lane types
 * of simd/vec.h; included by the other files of src/kernel. The reference is scalar/lattice.h.
 */
#ifndef SCARP_KERNEL_LATTICE_H
#define SCARP_KERNEL_LATTICE_H

#include "../plan.h"

/* The coordinates of a block of VEC_LANES points: float, or double in pairs. */
struct block {
    vf x, y, z;
    vd x0, x1, y0, y1, z0, z1;
};

/* A block on the lattice of one octave: the cell's lower corner modulo 2^32, and the position
   inside, in [0, 1]. */
struct place {
    vu cell_x, cell_y, cell_z;
    vf x, y, z;
};

VEC_INLINE void split_f32(vf p, vu *cell, vf *t)
{
    const vf lower = vf_floor(p);
    *cell = vu_from_vf(lower);
    *t = p - lower;
}

/* The sum with 1.5 * 2^52 has the floor, modulo 2^32, in its low bits. */
VEC_INLINE void split_f64(vd p0, vd p1, vu *cell, vf *t)
{
    const vd lower0 = vd_floor(p0);
    const vd lower1 = vd_floor(p1);
    *cell = vu_low_bits(lower0 + 0x1.8p52, lower1 + 0x1.8p52);
    *t = vf_from_vd(p0 - lower0, p1 - lower1);
}

/* p = f x + o */
VEC_INLINE struct place place_straight(const struct scarp_octave *o, const struct block *b,
                                       int dimensions, int doubles)
{
    struct place place;
    if (doubles) {
        const vd f = vd_set(o->frequency64);
        const vd ox = vd_set(o->offset64[0]), oy = vd_set(o->offset64[1]);
        split_f64(f * b->x0 + ox, f * b->x1 + ox, &place.cell_x, &place.x);
        split_f64(f * b->y0 + oy, f * b->y1 + oy, &place.cell_y, &place.y);
        if (dimensions == 3) {
            const vd oz = vd_set(o->offset64[2]);
            split_f64(f * b->z0 + oz, f * b->z1 + oz, &place.cell_z, &place.z);
        }
    } else {
        const vf f = vf_set(o->frequency);
        split_f32(f * b->x + vf_set(o->offset[0]), &place.cell_x, &place.x);
        split_f32(f * b->y + vf_set(o->offset[1]), &place.cell_y, &place.y);
        if (dimensions == 3) {
            split_f32(f * b->z + vf_set(o->offset[2]), &place.cell_z, &place.z);
        }
    }
    return place;
}

/* Row i of p = J x + o. */
VEC_INLINE vf turned_f32(const struct scarp_octave *o, int i, const struct block *b, int dimensions)
{
    const float *const j = o->jacobian[i];
    vf p = vf_set(j[0]) * b->x + vf_set(j[1]) * b->y;
    if (dimensions == 3) {
        p += vf_set(j[2]) * b->z;
    }
    return p + vf_set(o->offset[i]);
}

VEC_INLINE vd turned_f64(const struct scarp_octave *o, int i, vd x, vd y, vd z, int dimensions)
{
    const double *const j = o->jacobian64[i];
    vd p = vd_set(j[0]) * x + vd_set(j[1]) * y;
    if (dimensions == 3) {
        p += vd_set(j[2]) * z;
    }
    return p + vd_set(o->offset64[i]);
}

VEC_INLINE void split_turned(const struct scarp_octave *o, int i, const struct block *b,
                             int dimensions, int doubles, vu *cell, vf *t)
{
    if (doubles) {
        split_f64(turned_f64(o, i, b->x0, b->y0, b->z0, dimensions),
                  turned_f64(o, i, b->x1, b->y1, b->z1, dimensions), cell, t);
    } else {
        split_f32(turned_f32(o, i, b, dimensions), cell, t);
    }
}

VEC_INLINE struct place place_turned(const struct scarp_octave *o, const struct block *b,
                                     int dimensions, int doubles)
{
    struct place place;
    split_turned(o, 0, b, dimensions, doubles, &place.cell_x, &place.x);
    split_turned(o, 1, b, dimensions, doubles, &place.cell_y, &place.y);
    if (dimensions == 3) {
        split_turned(o, 2, b, dimensions, doubles, &place.cell_z, &place.z);
    }
    return place;
}

/*
 * The lattice hash: every axis mixed by itself, the axes joined by exclusive or and multiplication.
 * In this order because the corners of a cell share the mixed axes (2 per axis) and, in 3D, the
 * joined y and z (4). Only the top bits are used. See scalar/lattice.h for why it is this one.
 */
#define HASH_X 0x2bd2d699u
#define HASH_Y 0x6184ecd3u
#define HASH_Z 0xc2b2ae3du
#define HASH_YZ 0x2c1b3c6du
#define HASH_JOIN 0xa8508a35u
#define HASH_SHIFT 14

/* Both lattice coordinates of a cell along one axis, mixed. */
struct axis {
    vu h0, h1;
};

VEC_INLINE struct axis hash_axis(vu cell, uint32_t multiplier, uint32_t key)
{
    const vu a0 = cell * vu_set(multiplier) + vu_set(key);
    const vu a1 = a0 + vu_set(multiplier);
    const struct axis axis = {a0 ^ (a0 >> HASH_SHIFT), a1 ^ (a1 >> HASH_SHIFT)};
    return axis;
}

VEC_INLINE vu hash_join(vu a, vu b)
{
    return (a ^ b) * vu_set(HASH_JOIN);
}

/* What the columns of a cell share of the 3D hash, by [y][z]. */
struct corners_yz {
    vu h00, h01, h10, h11;
};

VEC_INLINE struct corners_yz hash_yz(struct axis y, struct axis z)
{
    const vu m = vu_set(HASH_YZ);
    const struct corners_yz c = {(y.h0 ^ z.h0) * m, (y.h0 ^ z.h1) * m, (y.h1 ^ z.h0) * m,
                                 (y.h1 ^ z.h1) * m};
    return c;
}

#endif
