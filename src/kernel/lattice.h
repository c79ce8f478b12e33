/* SPDX-License-Identifier: MIT
 *
 * First pass over a chunk of points (see points.h): where they lie on the lattice of an octave, and
 * the hashes of the corners of their cells. Written over the lane types of simd/vec.h. The
 * reference is scalar/lattice.h and `place_*` in scalar/axes.h.
 */
#ifndef SCARP_KERNEL_LATTICE_H
#define SCARP_KERNEL_LATTICE_H

#include "../plan.h"

/* Blocks and points per chunk. Large enough that the cost of a pass is spread thin: with 8 blocks
   AVX-512 loses 6 to 12 %. One octave of value and gradient in 3D touches 11 rows
   here and 4 of results: 30 KiB with AVX-512, 15 KiB with AVX2. */
#define CHUNK_BLOCKS 32
#define CHUNK_POINTS (CHUNK_BLOCKS * VEC_LANES)

/* A chunk on the lattice of one octave: the position inside the cell, in [0, 1] (rounding can reach
   1), and the hashes of the corners. In 2D z and every second hash are unused. */
struct lattice {
    vf x[CHUNK_BLOCKS], y[CHUNK_BLOCKS], z[CHUNK_BLOCKS];
    vu hash[2][2][2][CHUNK_BLOCKS]; /* [x][y][z] */
};

/* A row of coordinates, floats or doubles. */
typedef void lattice_pass(struct lattice *lattice, const struct scarp_octave *octave, size_t blocks,
                          const void *const position[3]);

/* Lower corner of the cell modulo 2^32, and position inside, along one axis. */
struct split {
    vu cell;
    vf t;
};

VEC_INLINE struct split split_f32(vf p)
{
    const vf lower = vf_floor(p);
    const struct split s = {vu_from_vf(lower), p - lower};
    return s;
}

/* The sum with 1.5 * 2^52 has the floor, modulo 2^32, in its low bits. */
VEC_INLINE struct split split_f64(vd p0, vd p1)
{
    const vd lower0 = vd_floor(p0);
    const vd lower1 = vd_floor(p1);
    const struct split s = {vu_low_bits(lower0 + 0x1.8p52, lower1 + 0x1.8p52),
                            vf_from_vd(p0 - lower0, p1 - lower1)};
    return s;
}

VEC_INLINE vf load_f32(const void *row, size_t block)
{
    return vf_load((const float *)row + block * VEC_LANES);
}

VEC_INLINE vd load_f64(const void *row, size_t block, int half)
{
    return vd_load((const double *)row + block * VEC_LANES + half * (VEC_LANES / 2));
}

/* How an octave's axes lie: p = f x (octave 0: adding its offset of 0 would cost 3 to 5 % of a
   single octave), p = f x + o, p = J x + o. */
enum axes { AXES_FIRST, AXES_STRAIGHT, AXES_TURNED, AXES_KINDS };

/* Axis i of p = f x + o. */
VEC_INLINE struct split straight(const struct scarp_octave *o, int i, const void *const position[3],
                                 size_t block, int doubles, enum axes axes)
{
    if (doubles) {
        const vd f = vd_set(o->frequency64);
        const vd offset = vd_set(o->offset64[i]);
        const vd p0 = f * load_f64(position[i], block, 0);
        const vd p1 = f * load_f64(position[i], block, 1);
        return axes == AXES_FIRST ? split_f64(p0, p1) : split_f64(p0 + offset, p1 + offset);
    }
    const vf p = vf_set(o->frequency) * load_f32(position[i], block);
    return axes == AXES_FIRST ? split_f32(p) : split_f32(p + vf_set(o->offset[i]));
}

/* Axis i of p = J x + o. */
VEC_INLINE vd turned_f64(const struct scarp_octave *o, int i, const void *const position[3],
                         size_t block, int half, int dimensions)
{
    const double *const j = o->jacobian64[i];
    vd p = vd_set(j[0]) * load_f64(position[0], block, half) +
           vd_set(j[1]) * load_f64(position[1], block, half);
    if (dimensions == 3) {
        p += vd_set(j[2]) * load_f64(position[2], block, half);
    }
    return p + vd_set(o->offset64[i]);
}

VEC_INLINE struct split turned(const struct scarp_octave *o, int i, const void *const position[3],
                               size_t block, int doubles, int dimensions)
{
    if (doubles) {
        return split_f64(turned_f64(o, i, position, block, 0, dimensions),
                         turned_f64(o, i, position, block, 1, dimensions));
    }
    const float *const j = o->jacobian[i];
    vf p =
        vf_set(j[0]) * load_f32(position[0], block) + vf_set(j[1]) * load_f32(position[1], block);
    if (dimensions == 3) {
        p += vf_set(j[2]) * load_f32(position[2], block);
    }
    return split_f32(p + vf_set(o->offset[i]));
}

/*
 * The lattice hash: every axis mixed by itself, then h (h + k) of h = x ^ (y ^ z). In this order
 * because the corners of a cell share the mixed axes (2 per axis) and, in 3D, y ^ z (4). Only the
 * top bits are used. See scalar/lattice.h for why it is this one.
 */
#define HASH_X 0x1a2012f5u
#define HASH_Y 0x14e84743u
#define HASH_Z 0xec1d7da1u
#define HASH_K 0x9e3779b9u

/* Both lattice coordinates of a cell along one axis, mixed. */
struct axis {
    vu h0, h1;
};

VEC_INLINE struct axis hash_axis(vu cell, uint32_t multiplier, uint32_t key)
{
    const vu a0 = cell * vu_set(multiplier) + vu_set(key);
    const vu a1 = a0 + vu_set(multiplier);
    const struct axis axis = {vu_turn8(a0), vu_turn8(a1)};
    return axis;
}

/* What the columns of a cell share of the 3D hash, by [y][z]. */
struct corners_yz {
    vu h00, h01, h10, h11;
};

VEC_INLINE struct corners_yz hash_yz(struct axis y, struct axis z)
{
    const struct corners_yz c = {y.h0 ^ z.h0, y.h0 ^ z.h1, y.h1 ^ z.h0, y.h1 ^ z.h1};
    return c;
}

/* The hash of a corner: `yz` is y alone in 2D. */
VEC_INLINE vu hash_corner(vu x, vu yz)
{
    const vu h = x ^ yz;
    return h * (h + vu_set(HASH_K));
}

VEC_INLINE struct split split_axis(const struct scarp_octave *o, int i,
                                   const void *const position[3], size_t block, int dimensions,
                                   int doubles, enum axes axes)
{
    return axes == AXES_TURNED ? turned(o, i, position, block, doubles, dimensions)
                               : straight(o, i, position, block, doubles, axes);
}

VEC_INLINE void lattice_run(struct lattice *lattice, const struct scarp_octave *octave,
                            size_t blocks, const void *const position[3], int dimensions,
                            int doubles, enum axes axes)
{
    const struct scarp_octave o = *octave; /* a copy: nothing that is stored can alias it */
    for (size_t b = 0; b < blocks; b++) {
        const struct split x = split_axis(&o, 0, position, b, dimensions, doubles, axes);
        const struct split y = split_axis(&o, 1, position, b, dimensions, doubles, axes);
        const struct axis hx = hash_axis(x.cell, HASH_X, o.key[0]);
        const struct axis hy = hash_axis(y.cell, HASH_Y, o.key[1]);
        lattice->x[b] = x.t;
        lattice->y[b] = y.t;
        if (dimensions == 2) {
            lattice->hash[0][0][0][b] = hash_corner(hx.h0, hy.h0);
            lattice->hash[0][1][0][b] = hash_corner(hx.h0, hy.h1);
            lattice->hash[1][0][0][b] = hash_corner(hx.h1, hy.h0);
            lattice->hash[1][1][0][b] = hash_corner(hx.h1, hy.h1);
        } else {
            const struct split z = split_axis(&o, 2, position, b, dimensions, doubles, axes);
            const struct corners_yz yz = hash_yz(hy, hash_axis(z.cell, HASH_Z, o.key[2]));
            lattice->z[b] = z.t;
            lattice->hash[0][0][0][b] = hash_corner(hx.h0, yz.h00);
            lattice->hash[0][0][1][b] = hash_corner(hx.h0, yz.h01);
            lattice->hash[0][1][0][b] = hash_corner(hx.h0, yz.h10);
            lattice->hash[0][1][1][b] = hash_corner(hx.h0, yz.h11);
            lattice->hash[1][0][0][b] = hash_corner(hx.h1, yz.h00);
            lattice->hash[1][0][1][b] = hash_corner(hx.h1, yz.h01);
            lattice->hash[1][1][0][b] = hash_corner(hx.h1, yz.h10);
            lattice->hash[1][1][1][b] = hash_corner(hx.h1, yz.h11);
        }
    }
}

#define LATTICE_PASS(name, dimensions, doubles, axes)                                              \
    static void name(struct lattice *lattice, const struct scarp_octave *octave, size_t blocks,    \
                     const void *const position[3])                                                \
    {                                                                                              \
        lattice_run(lattice, octave, blocks, position, dimensions, doubles, axes);                 \
    }

LATTICE_PASS(lattice2_f32_first, 2, 0, AXES_FIRST)
LATTICE_PASS(lattice2_f32_straight, 2, 0, AXES_STRAIGHT)
LATTICE_PASS(lattice2_f32_turned, 2, 0, AXES_TURNED)
LATTICE_PASS(lattice2_f64_first, 2, 1, AXES_FIRST)
LATTICE_PASS(lattice2_f64_straight, 2, 1, AXES_STRAIGHT)
LATTICE_PASS(lattice2_f64_turned, 2, 1, AXES_TURNED)
LATTICE_PASS(lattice3_f32_first, 3, 0, AXES_FIRST)
LATTICE_PASS(lattice3_f32_straight, 3, 0, AXES_STRAIGHT)
LATTICE_PASS(lattice3_f32_turned, 3, 0, AXES_TURNED)
LATTICE_PASS(lattice3_f64_first, 3, 1, AXES_FIRST)
LATTICE_PASS(lattice3_f64_straight, 3, 1, AXES_STRAIGHT)
LATTICE_PASS(lattice3_f64_turned, 3, 1, AXES_TURNED)

#undef LATTICE_PASS

/* By [dimensions - 2][doubles][axes]. */
static lattice_pass *const lattice_passes[2][2][AXES_KINDS] = {
    {{lattice2_f32_first, lattice2_f32_straight, lattice2_f32_turned},
     {lattice2_f64_first, lattice2_f64_straight, lattice2_f64_turned}},
    {{lattice3_f32_first, lattice3_f32_straight, lattice3_f32_turned},
     {lattice3_f64_first, lattice3_f64_straight, lattice3_f64_turned}},
};

#endif
