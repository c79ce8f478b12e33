/* SPDX-License-Identifier: MIT
 *
 * Erosion-like noise (Quilez 2008): the sum of a_k q_k n_k with q_k = 1 / (1 + erosion d_k . d_k),
 * d_k being the sum of the gradients up to octave k, each in its own axes. Its state is d with,
 * from order 1 on, its Jacobian with respect to the input. The reference is in formulas/fractal.h.
 */
#ifndef SCARP_KERNEL_FRACTAL_EROSION_H
#define SCARP_KERNEL_FRACTAL_EROSION_H

#include "hybrid.h"

/* How an octave is eroded. Where no octave has turned axes, the Jacobian of d is symmetric, and
   only its upper triangle is kept. */
enum erosion_kind { ERODE_STRAIGHT, ERODE_FIRST, ERODE_TURNED };

/* At a block: d, then its Jacobian by rows. */
static size_t erosion_size(int dimensions, int order, int rotates)
{
    const size_t n = (size_t)dimensions;
    return order == 0 ? n : n + (rotates ? n * n : n * (n + 1) / 2);
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
    enum erosion_kind kind;
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
        dj.z = e->jacobian[6 + j] + to_input(e->octave, e->kind == ERODE_TURNED, j, hz, 3);
        e->jacobian[6 + j] = dj.z;
    }
    dj.x = e->jacobian[j] + to_input(e->octave, e->kind == ERODE_TURNED, j, hx, dimensions);
    dj.y = e->jacobian[dimensions + j] +
           to_input(e->octave, e->kind == ERODE_TURNED, j, hy, dimensions);
    e->jacobian[j] = dj.x;
    e->jacobian[dimensions + j] = dj.y;
    return e->q * to_input(e->octave, e->kind == ERODE_TURNED, j, g, dimensions) -
           e->damping * dot(dj, e->d, dimensions);
}

/* Moves a component of a symmetric Jacobian on, h being that of the octave's Hessian. */
VEC_INLINE vf erode_next(const struct eroded *e, int component, vf h)
{
    return e->jacobian[component] += vf_set(e->octave->frequency) * h;
}

/* Sets the derivatives of q_k n_k where the Jacobian is symmetric. */
VEC_INLINE void erode_straight(const struct eroded *e, struct sample *s, int dimensions)
{
    const struct sample *const n = &e->n;
    const vf f = vf_set(e->octave->frequency);
    const vf xx = erode_next(e, 0, n->dxx), xy = erode_next(e, 1, n->dxy);
    const vf yy = erode_next(e, 2, n->dyy);
    struct vector x = {.x = xx, .y = xy}, y = {.x = xy, .y = yy};
    if (dimensions == 3) {
        const vf xz = erode_next(e, 3, n->dxz), yz = erode_next(e, 4, n->dyz);
        const struct vector z = {xz, yz, erode_next(e, 5, n->dzz)};
        x.z = xz;
        y.z = yz;
        s->dz = e->q * (f * n->dz) - e->damping * dot(z, e->d, dimensions);
    }
    s->dx = e->q * (f * n->dx) - e->damping * dot(x, e->d, dimensions);
    s->dy = e->q * (f * n->dy) - e->damping * dot(y, e->d, dimensions);
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
        if (e->kind == ERODE_STRAIGHT) {
            erode_straight(e, &s, v.dimensions);
            return s;
        }
        s.dx = erode_along(e, 0, v.dimensions);
        s.dy = erode_along(e, 1, v.dimensions);
        if (v.dimensions == 3) {
            s.dz = erode_along(e, 2, 3);
        }
    }
    return s;
}

VEC_INLINE void erosion_run(const struct shaping *shaping, const struct outputs *outputs,
                            enum put put, struct variant v, enum erosion_kind kind)
{
    const struct extent extent = shaping->extent;
    const vf *noise = shaping->noise;
    vf *state = shaping->state;
    struct outputs to;
    outputs_copy(&to, outputs, v);
    const struct variant basis = {v.basis, v.dimensions, v.order + 1, 0};
    const struct scarp_octave octave = *shaping->octave;
    const struct weights weights = {{octave.weight, octave.weight, octave.weight}};
    const float erosion = shaping->plan->erosion;
    for (size_t r = 0; r < extent.rows; r++) {
        size_t to_at = 0;
        for (size_t b = 0; b < extent.blocks; b++) {
            struct eroded e = {.octave = &octave, .kind = kind};
            e.n = sample_load(noise, basis);
            const struct sample s = erode(&e, state, erosion, v);
            add_sample(&to, to_at, &weights, &s, v, put);
            to_at += to.block;
            noise += sample_size(v.dimensions, v.order + 1);
            state += erosion_size(v.dimensions, v.order, kind != ERODE_STRAIGHT);
        }
        outputs_next_row(&to, v);
    }
}

#define EROSION_PASS(name, dimensions, order)                                                      \
    static void name(const struct shaping *shaping, const struct outputs *to, enum put put)        \
    {                                                                                              \
        const struct variant v = {SCARP_GRADIENT, dimensions, order, 0};                           \
        if (order == 0 || !shaping->plan->rotate) { /* axes do not matter to values */             \
            erosion_run(shaping, to, put, v, ERODE_STRAIGHT);                                      \
        } else if (shaping->axes == AXES_TURNED) {                                                 \
            erosion_run(shaping, to, put, v, ERODE_TURNED);                                        \
        } else {                                                                                   \
            erosion_run(shaping, to, put, v, ERODE_FIRST);                                         \
        }                                                                                          \
    }

EROSION_PASS(erosion2_order0, 2, 0)
EROSION_PASS(erosion2_order1, 2, 1)
EROSION_PASS(erosion3_order0, 3, 0)
EROSION_PASS(erosion3_order1, 3, 1)

#undef EROSION_PASS

#endif
