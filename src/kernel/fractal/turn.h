/* SPDX-License-Identifier: MIT
 *
 * Stage 3 of octaves with turned axes: derivatives of the basis in the octave's own frame, carried
 * through its axes. The reference is in_input() of formulas/fractal.h.
 *
 *     gradient += (a J)^T g      Hessian += (a J)^T (H J)
 */
#ifndef SCARP_KERNEL_FRACTAL_TURN_H
#define SCARP_KERNEL_FRACTAL_TURN_H

#include "../basis/basis.h"

/* An octave to be shaped: its noise as stored samples, and what goes from octave to octave,
   state_size() vectors for each block. */
struct shaping {
    const struct scarp_call_plan *plan;
    const struct scarp_octave *octave;
    enum axes axes;
    struct extent extent;
    const vf *noise;
    vf *state;
};

/* Adds the noise, shaped, to `to`, or puts it there, which may be where the noise is. */
typedef void fractal_pass(const struct shaping *shaping, const struct outputs *to, enum put put);

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
VEC_INLINE struct vector hessian_times(const struct sample *n, const float jacobian[3][3], int j,
                                       int dimensions)
{
    struct vector x = {.x = n->dxx, .y = n->dxy};
    struct vector y = {.x = n->dxy, .y = n->dyy};
    struct vector product;
    if (dimensions == 3) {
        x.z = n->dxz;
        y.z = n->dyz;
        const struct vector z = {n->dxz, n->dyz, n->dzz};
        product.z = column_dot(jacobian, j, z, dimensions);
    }
    product.x = column_dot(jacobian, j, x, dimensions);
    product.y = column_dot(jacobian, j, y, dimensions);
    return product;
}

VEC_INLINE struct sample turned(const struct scarp_octave *o, const struct sample *n,
                                struct variant v)
{
    const float(*const aj)[3] = o->gradient;
    struct sample s;
    struct vector g = {.x = n->dx, .y = n->dy};
    s.value = vf_set(o->amplitude) * n->value;
    if (v.dimensions == 3) {
        g.z = n->dz;
        s.dz = column_dot(aj, 2, g, 3);
    }
    s.dx = column_dot(aj, 0, g, v.dimensions);
    s.dy = column_dot(aj, 1, g, v.dimensions);
    if (v.order >= 2) {
        const struct vector hx = hessian_times(n, o->jacobian, 0, v.dimensions);
        const struct vector hy = hessian_times(n, o->jacobian, 1, v.dimensions);
        s.dxx = column_dot(aj, 0, hx, v.dimensions);
        s.dxy = column_dot(aj, 0, hy, v.dimensions);
        s.dyy = column_dot(aj, 1, hy, v.dimensions);
        if (v.dimensions == 3) {
            const struct vector hz = hessian_times(n, o->jacobian, 2, 3);
            s.dxz = column_dot(aj, 0, hz, 3);
            s.dyz = column_dot(aj, 1, hz, 3);
            s.dzz = column_dot(aj, 2, hz, 3);
        }
    }
    return s;
}

VEC_INLINE void turn_run(const struct shaping *shaping, const struct outputs *outputs, enum put put,
                         struct variant v)
{
    const struct extent extent = shaping->extent;
    const vf *noise = shaping->noise;
    struct outputs to;
    outputs_copy(&to, outputs, v);
    const struct weights weights = {{1.0f, 1.0f, 1.0f}};
    const size_t size = sample_size(v.dimensions, v.order);
    const struct scarp_octave o = *shaping->octave;
    for (size_t r = 0; r < extent.rows; r++) {
        size_t to_at = 0;
        for (size_t b = 0; b < extent.blocks; b++) {
            const struct sample n = sample_load(noise, v);
            const struct sample s = turned(&o, &n, v);
            add_sample(&to, to_at, &weights, &s, v, put);
            to_at += to.block;
            noise += size;
        }
        outputs_next_row(&to, v);
    }
}

/* Fractals are the same for every basis, so they ignore that of the variant. */
#define TURN_PASS(name, dimensions, order)                                                         \
    static void name(const struct shaping *shaping, const struct outputs *to, enum put put)        \
    {                                                                                              \
        const struct variant v = {SCARP_GRADIENT, dimensions, order, 0};                           \
        turn_run(shaping, to, put, v);                                                             \
    }

TURN_PASS(turn2_order1, 2, 1)
TURN_PASS(turn2_order2, 2, 2)
TURN_PASS(turn3_order1, 3, 1)
TURN_PASS(turn3_order2, 3, 2)

#undef TURN_PASS

/* By [dimensions - 2][order - 1]. */
static fractal_pass *const turn_passes[2][2] = {
    {turn2_order1, turn2_order2},
    {turn3_order1, turn3_order2},
};

#endif
