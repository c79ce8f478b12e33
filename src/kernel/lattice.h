/* SPDX-License-Identifier: MIT
 *
 * Stage 2 of bases on a lattice: the hashes of the corners of each point's cell. The reference is
 * formulas/lattice.h, which says why the hash is this one.
 */
#ifndef SCARP_KERNEL_LATTICE_H
#define SCARP_KERNEL_LATTICE_H

#include "positions.h"

/* What a pass stores of the corners of each point's cell for the pass of the basis: their hashes,
   by [x][y] or [x][y][z]; or, to be hashed there, the two lattice coordinates along each axis,
   mixed (struct axis). The latter suits value noise, which has little else to do: it takes 6 to 14
   % less time so. Gradient noise takes up to 10 % more (Zen 5). */
enum corner_form { CORNERS_HASHED, CORNERS_MIXED, CORNER_FORMS };

static enum corner_form corner_form_of(enum scarp_basis basis)
{
    return basis == SCARP_VALUE ? CORNERS_MIXED : CORNERS_HASHED;
}

/* Vectors of a block of points on the lattice: the fractions, and what is stored of the
   corners, of which hashes are the most. All are vf, as all of the scratch space is. */
#define LATTICE_SIZE2 (2 + 4)
#define LATTICE_SIZE3 (3 + 8)

static size_t lattice_size(int dimensions)
{
    return dimensions == 2 ? LATTICE_SIZE2 : LATTICE_SIZE3;
}

/* Puts the blocks of a row of points at `lattice`. */
typedef void lattice_pass(vf *lattice, const struct scarp_octave *octave, size_t blocks,
                          const struct positions *at);

/*
 * The lattice hash: every axis is mixed by itself, and the hash is h (h + k) with h = x ^ (y ^ z).
 * The corners of a cell share the mixed axes (2 per axis) and, in 3D, the four y ^ z. The top bits
 * matter most.
 */
#define HASH_X 0x1a2012f5u
#define HASH_Y 0x14e84743u
#define HASH_Z 0xec1d7da1u
#define HASH_K 0x9e3779b9u

/* The two lattice coordinates of a cell along one axis, mixed. */
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

VEC_INLINE vu hash_of(vu h)
{
    return h * (h + vu_set(HASH_K));
}

/* The hash of a corner: `yz` is only y in 2D. */
VEC_INLINE vu hash_corner(vu x, vu yz)
{
    return hash_of(x ^ yz);
}

VEC_INLINE vu hash_corner3(vu x, vu y, vu z)
{
    return hash_of(vu_xor3(x, y, z));
}

/* The mixed axes of a block of cells, of which z is unset in 2D. */
struct mixed {
    struct axis axis[3];
};

VEC_INLINE struct mixed mix_axes(const struct scarp_octave *o, const vu cell[3], enum axes axes,
                                 int dimensions)
{
    struct mixed m;
    for (int i = 0; i < dimensions; i++) {
        m.axis[i] = hash_axis(cell[i], o, i, axes);
    }
    return m;
}

/* Loads an axis that is stored mixed. */
VEC_INLINE struct axis axis_of(const vf *lattice, int i, int dimensions)
{
    const struct axis axis = {(vu)lattice[dimensions + 2 * i], (vu)lattice[dimensions + 2 * i + 1]};
    return axis;
}

/* Stores the corners of a block of cells behind its fractions. (corners_of() makes
   the same hashes for the pass of a basis. If both shared a function with loops, gradient noise in
   2D would lose 17 % of its speed with AVX2 and gcc 12.) */
VEC_INLINE void lattice_put_corners(vf *lattice, const struct mixed *m, int dimensions,
                                    enum corner_form form)
{
    const struct axis x = m->axis[0], y = m->axis[1];
    vf *const to = lattice + dimensions;
    if (form == CORNERS_MIXED) {
        for (int i = 0; i < dimensions; i++) {
            to[2 * i] = (vf)m->axis[i].h0;
            to[2 * i + 1] = (vf)m->axis[i].h1;
        }
    } else if (dimensions == 2) {
        to[0] = (vf)hash_corner(x.h0, y.h0);
        to[1] = (vf)hash_corner(x.h0, y.h1);
        to[2] = (vf)hash_corner(x.h1, y.h0);
        to[3] = (vf)hash_corner(x.h1, y.h1);
    } else {
        const struct axis z = m->axis[2];
        for (int side = 0; side < 2; side++) {
            const vu h = side == 0 ? x.h0 : x.h1;
            to[4 * side] = (vf)hash_corner3(h, y.h0, z.h0);
            to[4 * side + 1] = (vf)hash_corner3(h, y.h0, z.h1);
            to[4 * side + 2] = (vf)hash_corner3(h, y.h1, z.h0);
            to[4 * side + 3] = (vf)hash_corner3(h, y.h1, z.h1);
        }
    }
}

/* Stores where the positions of a block lie inside their cells, and returns the hashes along the
   axes. The caller stores the corners, which are made of these. In 2D, at[2] is unset. */
VEC_INLINE struct mixed lattice_put_fractions(vf *lattice, const struct scarp_octave *o,
                                              const struct split at[3], enum axes axes,
                                              int dimensions)
{
    vu cell[3];
    for (int i = 0; i < dimensions; i++) {
        lattice[i] = at[i].t;
        cell[i] = at[i].cell;
    }
    return mix_axes(o, cell, axes, dimensions);
}

/* Repeats the work of lattice_run for floats on a lattice with periods: some of them are far. */
static __attribute__((noinline, cold)) void lattice_far(vf *lattice, const struct scarp_octave *o,
                                                        size_t blocks, const struct positions *at,
                                                        int dimensions, enum corner_form form)
{
    const struct frame f = {FLOATS, AXES_PERIODS, dimensions};
    for (size_t b = 0; b < blocks; b++) {
        struct split s[3];
        for (int i = 0; i < dimensions; i++) {
            s[i] = position(o, i, at, b, f);
            s[i].cell = within_far(s[i].cell, o, i);
        }
        const struct mixed m = lattice_put_fractions(lattice, o, s, AXES_PERIODS, dimensions);
        lattice_put_corners(lattice, &m, dimensions, form);
        lattice += lattice_size(dimensions);
    }
}

/* Stores where the positions of block b lie inside their cells, and returns the hashes along the
   axes. If floats on a lattice with periods are far, this sets bits of `far`. */
VEC_INLINE struct mixed lattice_block(vf *lattice, const struct scarp_octave *o, size_t b,
                                      const struct positions *at, struct frame f, vu *far)
{
    struct split s[3];
    for (int i = 0; i < f.dimensions; i++) {
        const int is_turned = f.layout != FLOATS && f.axes == AXES_TURNED;
        s[i] = is_turned ? position_turned(o, i, at, b, f) : position(o, i, at, b, f);
        if (f.layout == FLOATS && f.axes == AXES_PERIODS) {
            *far |= far_bits(s[i].cell);
            const vf lower = vf_floor(position_f32(o, i, at, b, f));
            s[i].cell = within_f32(s[i].cell, lower, o, i);
        }
    }
    return lattice_put_fractions(lattice, o, s, f.axes, f.dimensions);
}

VEC_INLINE void lattice_run(vf *lattice, const struct scarp_octave *octave, size_t blocks,
                            const struct positions *positions, struct frame f,
                            enum corner_form form)
{
    const struct scarp_octave o = *octave; /* copies: nothing that is stored can alias them */
    const struct positions at = *positions;
    vu far = vu_set(0);
    vf *to = lattice;
    for (size_t b = 0; b < blocks; b++, to += lattice_size(f.dimensions)) {
        const struct mixed m = lattice_block(to, &o, b, &at, f, &far);
        lattice_put_corners(to, &m, f.dimensions, form);
    }
    if (f.layout == FLOATS && f.axes == AXES_PERIODS && vu_any(far & vu_set(FAR_BITS))) {
        lattice_far(lattice, octave, blocks, positions, f.dimensions, form);
    }
}

/*
 * The chain from a position to its hashes is long: out-of-order windows hold only two blocks of it.
 * Two loops take a fifth less time than one: the first puts axes, the second makes hashes of them,
 * in place. With 16 lanes they take more in 3D, since vectors of 64 bytes are stored one per cycle;
 * but to make the hashes of a block after the fractions of the next takes a sixth less. (Measured
 * on Zen 5. With fewer lanes that is no gain; nor is it where positions are doubles.)
 */
#if VEC_LANES == 16
VEC_INLINE void hashes_run(vf *lattice, const struct scarp_octave *octave, size_t blocks,
                           const struct positions *positions, struct frame f)
{
    if (f.layout != FLOATS || f.axes > AXES_STRAIGHT) {
        lattice_run(lattice, octave, blocks, positions, f, CORNERS_HASHED);
        return;
    }
    const struct scarp_octave o = *octave;
    const struct positions at = *positions;
    const size_t size = lattice_size(f.dimensions);
    vu far;
    struct mixed m = lattice_block(lattice, &o, 0, &at, f, &far);
    for (size_t b = 1; b < blocks; b++, lattice += size) {
        const struct mixed next = lattice_block(lattice + size, &o, b, &at, f, &far);
        lattice_put_corners(lattice, &m, f.dimensions, CORNERS_HASHED);
        m = next;
    }
    lattice_put_corners(lattice, &m, f.dimensions, CORNERS_HASHED);
}
#else
/* Makes hashes of the axes of some blocks. */
VEC_INLINE void hash_blocks(vf *lattice, size_t blocks, int dimensions)
{
    for (size_t b = 0; b < blocks; b++, lattice += lattice_size(dimensions)) {
        struct mixed m;
        for (int i = 0; i < dimensions; i++) {
            m.axis[i] = axis_of(lattice, i, dimensions);
        }
        lattice_put_corners(lattice, &m, dimensions, CORNERS_HASHED);
    }
}

static __attribute__((noinline)) void hash_blocks2(vf *lattice, size_t blocks)
{
    hash_blocks(lattice, blocks, 2);
}

static __attribute__((noinline)) void hash_blocks3(vf *lattice, size_t blocks)
{
    hash_blocks(lattice, blocks, 3);
}

#endif

#define LATTICE_STORES(name, run, dimensions, layout, axes, ...)                                   \
    static void name(vf *lattice, const struct scarp_octave *octave, size_t blocks,                \
                     const struct positions *at)                                                   \
    {                                                                                              \
        const struct frame f = {layout, axes, dimensions};                                         \
        run(lattice, octave, blocks, at, __VA_ARGS__);                                             \
    }
#if VEC_LANES == 16
#define LATTICE_HASHES(name, axes_name, d, layout, axes)                                           \
    LATTICE_STORES(name, hashes_run, d, layout, axes, f)
#else
#define LATTICE_HASHES(name, axes_name, d, layout, axes)                                           \
    static void name(vf *lattice, const struct scarp_octave *octave, size_t blocks,                \
                     const struct positions *at)                                                   \
    {                                                                                              \
        axes_name(lattice, octave, blocks, at);                                                    \
        hash_blocks##d(lattice, blocks);                                                           \
    }
#endif
/* A pass that stores mixed axes, and one that stores hashes. */
#define LATTICE_PASS(axes_name, hashes_name, d, layout, axes)                                      \
    LATTICE_STORES(axes_name, lattice_run, d, layout, axes, f, CORNERS_MIXED)                      \
    LATTICE_HASHES(hashes_name, axes_name, d, layout, axes)
#define LATTICE_STRAIGHT(d, layout)                                                                \
    LATTICE_PASS(mixed_axes##d##_##layout##_first, hashed##d##_##layout##_first, d, layout,        \
                 AXES_FIRST)                                                                       \
    LATTICE_PASS(mixed_axes##d##_##layout##_straight, hashed##d##_##layout##_straight, d, layout,  \
                 AXES_STRAIGHT)
#define LATTICE_PASSES(d, layout)                                                                  \
    LATTICE_STRAIGHT(d, layout)                                                                    \
    LATTICE_PASS(mixed_axes##d##_##layout##_turned, hashed##d##_##layout##_turned, d, layout,      \
                 AXES_TURNED)                                                                      \
    LATTICE_PASS(mixed_axes##d##_##layout##_powers, hashed##d##_##layout##_powers, d, layout,      \
                 AXES_POWERS)                                                                      \
    LATTICE_PASS(mixed_axes##d##_##layout##_periods, hashed##d##_##layout##_periods, d, layout,    \
                 AXES_PERIODS)
#define STRAIGHT_NAMES(name, d, layout)                                                            \
    [AXES_FIRST] = name##d##_##layout##_first, [AXES_STRAIGHT] = name##d##_##layout##_straight
#define ANY_NAMES(name, d, layout)                                                                 \
    {                                                                                              \
        STRAIGHT_NAMES(name, d, layout), [AXES_TURNED] = name##d##_##layout##_turned,              \
                                         [AXES_POWERS] = name##d##_##layout##_powers,              \
                                         [AXES_PERIODS] = name##d##_##layout##_periods,            \
    }
#define LATTICE_NAMES(name)                                                                        \
    {                                                                                              \
        {ANY_NAMES(name, 2, FLOATS), ANY_NAMES(name, 2, DOUBLES), {STRAIGHT_NAMES(name, 2, ROW)}}, \
        {                                                                                          \
            ANY_NAMES(name, 3, FLOATS), ANY_NAMES(name, 3, DOUBLES),                               \
            {                                                                                      \
                STRAIGHT_NAMES(name, 3, ROW)                                                       \
            }                                                                                      \
        }                                                                                          \
    }

LATTICE_PASSES(2, FLOATS)
LATTICE_PASSES(2, DOUBLES)
LATTICE_STRAIGHT(2, ROW)
LATTICE_PASSES(3, FLOATS)
LATTICE_PASSES(3, DOUBLES)
LATTICE_STRAIGHT(3, ROW)

/* By [form][dimensions - 2][layout][axes]. Rows with turned axes are located by rows/turned.h,
   those with periods by rows/along.h: a basis that has periods has a rows pass. */
static lattice_pass *const lattice_passes[CORNER_FORMS][2][LAYOUTS][AXES_KINDS] = {
    [CORNERS_HASHED] = LATTICE_NAMES(hashed),
    [CORNERS_MIXED] = LATTICE_NAMES(mixed_axes),
};

#undef LATTICE_STORES
#undef LATTICE_HASHES
#undef LATTICE_PASS
#undef LATTICE_STRAIGHT
#undef LATTICE_PASSES
#undef STRAIGHT_NAMES
#undef ANY_NAMES
#undef LATTICE_NAMES

#endif
