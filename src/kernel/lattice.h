/* SPDX-License-Identifier: MIT
 *
 * Stage 2 of bases on a lattice: the hashes of the corners of each point's cell. Included by
 * basis/columns.h; the reference is scalar/lattice.h, which tells why the hash is this one.
 */
#ifndef SCARP_KERNEL_LATTICE_H
#define SCARP_KERNEL_LATTICE_H

#include "positions.h"

/* A block of points on the lattice: the place inside the cell, and the bits of the corners' hashes
   by [x][y] or [x][y][z]. All are vf, as all of the scratch space is. */
struct lattice2 {
    vf t[2];
    vf hash[2][2];
};

struct lattice3 {
    vf t[3];
    vf hash[2][2][2];
};

/* Puts the blocks of a row of points, as struct lattice2 or lattice3, at `lattice`. */
typedef void lattice_pass(vf *lattice, const struct scarp_octave *octave, size_t blocks,
                          const struct positions *at);

static size_t lattice_size(int dimensions)
{
    return (dimensions == 2 ? sizeof(struct lattice2) : sizeof(struct lattice3)) / sizeof(vf);
}

/*
 * The lattice hash: every axis is mixed by itself, and the hash is h (h + k) with h = x ^ (y ^ z).
 * The corners of a cell share the mixed axes (2 per axis) and, in 3D, the four y ^ z. The top bits
 * matter most.
 */
#define HASH_X 0x1a2012f5u
#define HASH_Y 0x14e84743u
#define HASH_Z 0xec1d7da1u
#define HASH_K 0x9e3779b9u

/* Both lattice coordinates of a cell along one axis, mixed. */
struct axis {
    vu h0, h1;
};

static const uint32_t hash_multiplier[3] = {HASH_X, HASH_Y, HASH_Z};

/* `i` is the number of the axis. After the last cell of a period comes cell 0. */
VEC_INLINE struct axis hash_axis(vu cell, const struct scarp_octave *o, int i, enum axes axes)
{
    const uint32_t multiplier = hash_multiplier[i];
    const vu a0 = cell * vu_set(multiplier) + vu_set(o->key[i]);
    vu a1 = a0 + vu_set(multiplier);
    if (axes_repeat(axes)) {
        const uint32_t period = o->last[i] + 1;
        a1 -= (vu)(cell == vu_set(o->last[i])) & vu_set(period * multiplier);
    }
    const struct axis axis = {vu_turn8(a0), vu_turn8(a1)};
    return axis;
}

/* What the columns of a cell share of the 3D hash, by [y][z]. */
struct corners_yz {
    vu h[2][2];
};

VEC_INLINE struct corners_yz hash_yz(struct axis y, struct axis z)
{
    const struct corners_yz c = {{{y.h0 ^ z.h0, y.h0 ^ z.h1}, {y.h1 ^ z.h0, y.h1 ^ z.h1}}};
    return c;
}

/* The hash of a corner: `yz` is y alone in 2D. */
VEC_INLINE vu hash_corner(vu x, vu yz)
{
    const vu h = x ^ yz;
    return h * (h + vu_set(HASH_K));
}

/* Puts the hashes of the corners of a block of cells, of which z is unset in 2D. */
VEC_INLINE void lattice_put_hashes(vf *lattice, const struct scarp_octave *o, const vu cell[3],
                                   enum axes axes, int dimensions)
{
    const struct axis hx = hash_axis(cell[0], o, 0, axes);
    const struct axis hy = hash_axis(cell[1], o, 1, axes);
    if (dimensions == 2) {
        struct lattice2 *const l = (struct lattice2 *)lattice;
        l->hash[0][0] = (vf)hash_corner(hx.h0, hy.h0);
        l->hash[0][1] = (vf)hash_corner(hx.h0, hy.h1);
        l->hash[1][0] = (vf)hash_corner(hx.h1, hy.h0);
        l->hash[1][1] = (vf)hash_corner(hx.h1, hy.h1);
    } else {
        struct lattice3 *const l = (struct lattice3 *)lattice;
        const struct corners_yz yz = hash_yz(hy, hash_axis(cell[2], o, 2, axes));
        l->hash[0][0][0] = (vf)hash_corner(hx.h0, yz.h[0][0]);
        l->hash[0][0][1] = (vf)hash_corner(hx.h0, yz.h[0][1]);
        l->hash[0][1][0] = (vf)hash_corner(hx.h0, yz.h[1][0]);
        l->hash[0][1][1] = (vf)hash_corner(hx.h0, yz.h[1][1]);
        l->hash[1][0][0] = (vf)hash_corner(hx.h1, yz.h[0][0]);
        l->hash[1][0][1] = (vf)hash_corner(hx.h1, yz.h[0][1]);
        l->hash[1][1][0] = (vf)hash_corner(hx.h1, yz.h[1][0]);
        l->hash[1][1][1] = (vf)hash_corner(hx.h1, yz.h[1][1]);
    }
}

/* Puts a block of positions, of which z is unset in 2D, and the hashes of their corners. */
VEC_INLINE void lattice_put(vf *lattice, const struct scarp_octave *o, const struct split at[3],
                            enum axes axes, int dimensions)
{
    vu cell[3];
    for (int i = 0; i < dimensions; i++) {
        lattice[i] = at[i].t;
        cell[i] = at[i].cell;
    }
    lattice_put_hashes(lattice, o, cell, axes, dimensions);
}

/* Does once more what lattice_run does with periods and floats, of which some are far. */
static __attribute__((noinline, cold)) void lattice_far(vf *lattice, const struct scarp_octave *o,
                                                        size_t blocks, const struct positions *at,
                                                        int dimensions)
{
    const struct frame f = {FLOATS, AXES_PERIODS, dimensions};
    for (size_t b = 0; b < blocks; b++) {
        struct split s[3];
        for (int i = 0; i < dimensions; i++) {
            s[i] = position(o, i, at, b, f);
            s[i].cell = within_far(s[i].cell, o, i);
        }
        lattice_put(lattice + b * lattice_size(dimensions), o, s, AXES_PERIODS, dimensions);
    }
}

VEC_INLINE void lattice_run(vf *lattice, const struct scarp_octave *octave, size_t blocks,
                            const struct positions *positions, struct frame f)
{
    const struct scarp_octave o = *octave; /* copies: nothing that is stored can alias them */
    const struct positions at = *positions;
    const int reduces = f.layout == FLOATS && f.axes == AXES_PERIODS;
    vu far = vu_set(0);
    for (size_t b = 0; b < blocks; b++) {
        struct split s[3];
        for (int i = 0; i < f.dimensions; i++) {
            s[i] = position(&o, i, &at, b, f);
            if (reduces) {
                far |= far_bits(s[i].cell);
                const vf lower = vf_floor(position_f32(&o, i, &at, b, f));
                s[i].cell = within_f32(s[i].cell, lower, &o, i);
            }
        }
        lattice_put(lattice + b * lattice_size(f.dimensions), &o, s, f.axes, f.dimensions);
    }
    if (reduces && vu_any(far & vu_set(FAR_BITS))) {
        lattice_far(lattice, octave, blocks, positions, f.dimensions);
    }
}

#define LATTICE_PASS(name, dimensions, layout, axes)                                               \
    static void name(vf *lattice, const struct scarp_octave *octave, size_t blocks,                \
                     const struct positions *at)                                                   \
    {                                                                                              \
        const struct frame f = {layout, axes, dimensions};                                         \
        lattice_run(lattice, octave, blocks, at, f);                                               \
    }
#define LATTICE_STRAIGHT(dimensions, layout)                                                       \
    LATTICE_PASS(lattice##dimensions##_##layout##_first, dimensions, layout, AXES_FIRST)           \
    LATTICE_PASS(lattice##dimensions##_##layout##_straight, dimensions, layout, AXES_STRAIGHT)
#define LATTICE_PASSES(dimensions, layout)                                                         \
    LATTICE_STRAIGHT(dimensions, layout)                                                           \
    LATTICE_PASS(lattice##dimensions##_##layout##_turned, dimensions, layout, AXES_TURNED)         \
    LATTICE_PASS(lattice##dimensions##_##layout##_powers, dimensions, layout, AXES_POWERS)         \
    LATTICE_PASS(lattice##dimensions##_##layout##_periods, dimensions, layout, AXES_PERIODS)
#define STRAIGHT_NAMES(dimensions, layout)                                                         \
    [AXES_FIRST] = lattice##dimensions##_##layout##_first,                                         \
    [AXES_STRAIGHT] = lattice##dimensions##_##layout##_straight
#define LATTICE_NAMES(dimensions, layout)                                                          \
    {                                                                                              \
        STRAIGHT_NAMES(dimensions, layout),                                                        \
            [AXES_TURNED] = lattice##dimensions##_##layout##_turned,                               \
            [AXES_POWERS] = lattice##dimensions##_##layout##_powers,                               \
            [AXES_PERIODS] = lattice##dimensions##_##layout##_periods,                             \
    }

LATTICE_PASSES(2, FLOATS)
LATTICE_PASSES(2, DOUBLES)
LATTICE_STRAIGHT(2, ROW)
LATTICE_PASSES(3, FLOATS)
LATTICE_PASSES(3, DOUBLES)
LATTICE_STRAIGHT(3, ROW)

/* By [dimensions - 2][layout][axes]. Rows with turned axes are placed by rows/turned.h, those with
   periods by rows/along.h: a basis that has periods has a rows pass. */
static lattice_pass *const lattice_passes[2][LAYOUTS][AXES_KINDS] = {
    {LATTICE_NAMES(2, FLOATS), LATTICE_NAMES(2, DOUBLES), {STRAIGHT_NAMES(2, ROW)}},
    {LATTICE_NAMES(3, FLOATS), LATTICE_NAMES(3, DOUBLES), {STRAIGHT_NAMES(3, ROW)}},
};

#undef LATTICE_PASS
#undef LATTICE_STRAIGHT
#undef LATTICE_PASSES
#undef LATTICE_NAMES
#undef STRAIGHT_NAMES

#endif
