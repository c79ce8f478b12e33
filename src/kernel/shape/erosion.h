/* SPDX-License-Identifier: MIT
 *
 * Erosion-like noise (Quilez 2008): the sum of a_k q_k n_k with q_k = 1 / (1 + erosion d_k . d_k),
 * d_k being the sum of the gradients up to octave k, each in its own axes. Its state is d with,
 * from order 1 on, its Jacobian with respect to the input. Included by shape.h; the reference is
 * scalar/erosion.h.
 */
#ifndef SCARP_KERNEL_SHAPE_EROSION_H
#define SCARP_KERNEL_SHAPE_EROSION_H

#include "ridged.h"

/* At a block: d, then its Jacobian by rows. */
static size_t erosion_size(int dimensions, int order)
{
    return (size_t)dimensions * (order == 0 ? 1 : 1 + (size_t)dimensions);
}

VEC_INLINE struct vector vector_at(const vf *v, int dimensions)
{
    struct vector vector = {.x = v[0], .y = v[1]};
    if (dimensions == 3) {
        vector.z = v[2];
    }
    return vector;
}

VEC_INLINE vf dot(struct vector a, struct vector b, int dimensions)
{
    const vf d = a.x * b.x + a.y * b.y;
    return dimensions == 3 ? d + a.z * b.z : d;
}

/* Component j of J^T v, v being a gradient in the octave's axes. */
VEC_INLINE vf to_input(const struct scarp_octave *o, int is_turned, int j, struct vector v,
                       int dimensions)
{
    if (is_turned) {
        return column_dot(o->jacobian, j, v, dimensions);
    }
    return vf_set(o->frequency) * (j == 0 ? v.x : j == 1 ? v.y : v.z);
}

/* The octave at a block of points. */
struct eroded {
    const struct scarp_octave *octave;
    struct sample n; /* with one order more than is asked for */
    struct vector d; /* with this octave */
    vf q, damping;   /* q_k and 2 erosion n q_k^2 */
    vf *jacobian;    /* of d, without this octave */
    int turned;
};

/* The derivative of q_k n_k along x_j; moves column j of the Jacobian on. */
VEC_INLINE vf erode_along(const struct eroded *e, int j, int dimensions)
{
    const struct sample *const n = &e->n;
    struct vector g = {.x = n->dx, .y = n->dy};
    struct vector hx = {.x = n->dxx, .y = n->dxy};
    struct vector hy = {.x = n->dxy, .y = n->dyy};
    struct vector dj;
    if (dimensions == 3) {
        g.z = n->dz;
        hx.z = n->dxz;
        hy.z = n->dyz;
        const struct vector hz = {n->dxz, n->dyz, n->dzz};
        dj.z = e->jacobian[6 + j] + to_input(e->octave, e->turned, j, hz, 3);
        e->jacobian[6 + j] = dj.z;
    }
    dj.x = e->jacobian[j] + to_input(e->octave, e->turned, j, hx, dimensions);
    dj.y = e->jacobian[dimensions + j] + to_input(e->octave, e->turned, j, hy, dimensions);
    e->jacobian[j] = dj.x;
    e->jacobian[dimensions + j] = dj.y;
    return e->q * to_input(e->octave, e->turned, j, g, dimensions) -
           e->damping * dot(dj, e->d, dimensions);
}

VEC_INLINE struct sample erode(struct eroded *e, vf *d, float erosion, struct variant v)
{
    const struct sample *const n = &e->n;
    e->d = vector_at(d, v.dimensions);
    e->d.x += n->dx;
    e->d.y += n->dy;
    d[0] = e->d.x;
    d[1] = e->d.y;
    if (v.dimensions == 3) {
        e->d.z += n->dz;
        d[2] = e->d.z;
    }
    e->q = 1.0f / (1.0f + vf_set(erosion) * dot(e->d, e->d, v.dimensions));
    struct sample s;
    s.value = e->q * n->value;
    if (v.order >= 1) {
        e->jacobian = d + v.dimensions;
        e->damping = vf_set(2.0f * erosion) * n->value * (e->q * e->q);
        s.dx = erode_along(e, 0, v.dimensions);
        s.dy = erode_along(e, 1, v.dimensions);
        if (v.dimensions == 3) {
            s.dz = erode_along(e, 2, 3);
        }
    }
    return s;
}

VEC_INLINE void erosion_run(const struct shaping *shaping, const struct outputs *outputs,
                            enum put put, struct variant v, int is_turned)
{
    const struct extent extent = shaping->extent;
    const vf *noise = shaping->noise;
    vf *state = shaping->state;
    struct outputs to;
    outputs_copy(&to, outputs, v);
    const struct variant basis = {v.basis, v.dimensions, v.order + 1};
    const struct scarp_octave octave = *shaping->octave;
    const struct weights weights = {{octave.weight, octave.weight, octave.weight}};
    const float erosion = shaping->plan->erosion;
    for (size_t r = 0; r < extent.rows; r++) {
        size_t to_at = 0;
        for (size_t b = 0; b < extent.blocks; b++) {
            struct eroded e = {.octave = &octave, .turned = is_turned};
            e.n = sample_load(noise, basis);
            const struct sample s = erode(&e, state, erosion, v);
            add_sample(&to, to_at, &weights, &s, v, put);
            to_at += to.block;
            noise += sample_size(v.dimensions, v.order + 1);
            state += erosion_size(v.dimensions, v.order);
        }
        outputs_next_row(&to, v);
    }
}

#define EROSION_PASS(name, dimensions, order)                                                      \
    static void name(const struct shaping *shaping, const struct outputs *to, enum put put)        \
    {                                                                                              \
        const struct variant v = {SCARP_GRADIENT, dimensions, order};                              \
        if (shaping->axes == AXES_TURNED) {                                                        \
            erosion_run(shaping, to, put, v, 1);                                                   \
        } else {                                                                                   \
            erosion_run(shaping, to, put, v, 0);                                                   \
        }                                                                                          \
    }

EROSION_PASS(erosion2_order0, 2, 0)
EROSION_PASS(erosion2_order1, 2, 1)
EROSION_PASS(erosion3_order0, 3, 0)
EROSION_PASS(erosion3_order1, 3, 1)

#undef EROSION_PASS

#endif
