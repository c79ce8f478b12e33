/* SPDX-License-Identifier: MIT
 *
 * Third pass over a chunk of points, for octaves with turned axes only (see points.h): derivatives
 * of the basis in the octave's own frame, carried through its axes and added to rows of sums.
 * Included by shape.h; the reference is `turned` in scalar/fractal.h.
 *
 *     gradient += (a J)^T g      Hessian += (a J)^T (H J)
 */
#ifndef SCARP_KERNEL_TURN_H
#define SCARP_KERNEL_TURN_H

#include "octave.h"

/* to = from + raw, the derivatives in `raw` turned. */
typedef void turn_pass(const struct scarp_octave *octave, size_t blocks, const struct rows *raw,
                       const struct scarp_samples *from, const struct scarp_samples *to);

/* A vector in the octave's frame; z is unset in 2D. */
struct vector {
    vf x, y, z;
};

/* Column j of a matrix, transposed, times a vector. */
VEC_INLINE vf column_dot(const float m[3][3], int j, struct vector v, int dimensions)
{
    vf dot = vf_set(m[0][j]) * v.x + vf_set(m[1][j]) * v.y;
    if (dimensions == 3) {
        dot += vf_set(m[2][j]) * v.z;
    }
    return dot;
}

/* Column j of H J. */
VEC_INLINE struct vector hessian_times(const struct rows *raw, size_t b, const float jacobian[3][3],
                                       int j, int dimensions)
{
    struct vector x = {.x = raw->row[DXX][b], .y = raw->row[DXY][b]};
    struct vector y = {.x = raw->row[DXY][b], .y = raw->row[DYY][b]};
    struct vector product;
    if (dimensions == 3) {
        x.z = raw->row[DXZ][b];
        y.z = raw->row[DYZ][b];
        const struct vector z = {x.z, y.z, raw->row[DZZ][b]};
        product.z = column_dot(jacobian, j, z, dimensions);
    }
    product.x = column_dot(jacobian, j, x, dimensions);
    product.y = column_dot(jacobian, j, y, dimensions);
    return product;
}

VEC_INLINE void turn_run(const struct scarp_octave *octave, size_t blocks, const struct rows *raw,
                         int first, const struct scarp_samples *from,
                         const struct scarp_samples *to, int dimensions, int order)
{
    const float(*const aj)[3] = octave->gradient;
    const float(*const jacobian)[3] = octave->jacobian;
    for (size_t b = 0; b < blocks; b++) {
        add(to->value, first, from->value, b, vf_set(octave->amplitude) * raw->row[VALUE][b]);
        struct vector g = {.x = raw->row[DX][b], .y = raw->row[DY][b]};
        if (dimensions == 3) {
            g.z = raw->row[DZ][b];
            add(to->dz, first, from->dz, b, column_dot(aj, 2, g, dimensions));
        }
        add(to->dx, first, from->dx, b, column_dot(aj, 0, g, dimensions));
        add(to->dy, first, from->dy, b, column_dot(aj, 1, g, dimensions));
        if (order >= 2) {
            const struct vector hx = hessian_times(raw, b, jacobian, 0, dimensions);
            const struct vector hy = hessian_times(raw, b, jacobian, 1, dimensions);
            add(to->dxx, first, from->dxx, b, column_dot(aj, 0, hx, dimensions));
            add(to->dxy, first, from->dxy, b, column_dot(aj, 0, hy, dimensions));
            add(to->dyy, first, from->dyy, b, column_dot(aj, 1, hy, dimensions));
            if (dimensions == 3) {
                const struct vector hz = hessian_times(raw, b, jacobian, 2, dimensions);
                add(to->dxz, first, from->dxz, b, column_dot(aj, 0, hz, dimensions));
                add(to->dyz, first, from->dyz, b, column_dot(aj, 1, hz, dimensions));
                add(to->dzz, first, from->dzz, b, column_dot(aj, 2, hz, dimensions));
            }
        }
    }
}

#define TURN_PASS(name, dimensions, order)                                                         \
    static void name(const struct scarp_octave *octave, size_t blocks, const struct rows *raw,     \
                     const struct scarp_samples *from, const struct scarp_samples *to)             \
    {                                                                                              \
        const struct scarp_samples rows = rows_of(from);                                           \
        turn_run(octave, blocks, raw, from == NULL, &rows, to, dimensions, order);                 \
    }

TURN_PASS(turn2_order1, 2, 1)
TURN_PASS(turn2_order2, 2, 2)
TURN_PASS(turn3_order1, 3, 1)
TURN_PASS(turn3_order2, 3, 2)

#undef TURN_PASS

/* By [dimensions - 2][order - 1]. */
static turn_pass *const turn_passes[2][2] = {
    {turn2_order1, turn2_order2},
    {turn3_order1, turn3_order2},
};

#endif
