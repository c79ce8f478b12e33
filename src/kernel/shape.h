/* SPDX-License-Identifier: MIT
 *
 * The last pass over a chunk of points for the fractals beside fBm: an octave's noise, shaped as
 * its fractal asks for, is added to rows of sums, and what goes from octave to octave is moved on.
 * Included by fractal.h; the reference is scalar/shape.h, and scarp.h has the formulas.
 */
#ifndef SCARP_KERNEL_SHAPE_H
#define SCARP_KERNEL_SHAPE_H

#include "turn.h"

/* What goes from octave to octave. */
union state {
    struct rows weight; /* ridged: v_k with its derivatives */
    struct {
        vf d[3][CHUNK_BLOCKS];           /* erosion: the sum of the gradients */
        vf jacobian[3][3][CHUNK_BLOCKS]; /* of d, with respect to the input */
    } slopes;
};

/* to = from + a_k times the shaped octave. `n` has the octave's noise, over 1 as supremum, its
   derivatives with respect to the input; for erosion those in the octave's own axes. */
typedef void shape_pass(const struct scarp_plan *plan, const struct scarp_octave *octave,
                        enum axes axes, size_t blocks, const struct rows *n, union state *state,
                        const struct scarp_samples *from, const struct scarp_samples *to);

/* a where mask is all ones, b where it is 0. */
VEC_INLINE vf either(vu mask, vf a, vf b)
{
    return (vf)(((vu)a & mask) | ((vu)b & ~mask));
}

/* The sign of n, and ones where it is not 0: see with_sign. */
struct sign {
    vu bit, mask;
};

VEC_INLINE struct sign sign_of(vf n)
{
    const struct sign s = {(vu)n & vu_set(0x80000000u), (vu)(n != vf_set(0.0f))};
    return s;
}

/* sign(n) a, and 0 where n is 0. */
VEC_INLINE vf with_sign(vf a, struct sign s)
{
    return (vf)(((vu)a ^ s.bit) & s.mask);
}

/* |n| at a block of points. */
VEC_INLINE struct sample magnitude(const struct rows *n, size_t b, int dimensions, int order)
{
    const struct sign s = sign_of(n->row[VALUE][b]);
    struct sample m;
    m.value = with_sign(n->row[VALUE][b], s);
    if (order >= 1) {
        m.dx = with_sign(n->row[DX][b], s);
        m.dy = with_sign(n->row[DY][b], s);
        if (dimensions == 3) {
            m.dz = with_sign(n->row[DZ][b], s);
        }
    }
    if (order >= 2) {
        m.dxx = with_sign(n->row[DXX][b], s);
        m.dxy = with_sign(n->row[DXY][b], s);
        m.dyy = with_sign(n->row[DYY][b], s);
        if (dimensions == 3) {
            m.dxz = with_sign(n->row[DXZ][b], s);
            m.dyz = with_sign(n->row[DYZ][b], s);
            m.dzz = with_sign(n->row[DZZ][b], s);
        }
    }
    return m;
}

VEC_INLINE void turbulence_run(const struct scarp_octave *octave, size_t blocks,
                               const struct rows *n, const struct scarp_samples *from_rows,
                               const struct scarp_samples *to_rows, int dimensions, int order)
{
    const struct weights weights = {octave->weight, octave->weight, octave->weight};
    const struct scarp_samples from = rows_of(from_rows), to = *to_rows;
    for (size_t b = 0; b < blocks; b++) {
        const struct sample m = magnitude(n, b, dimensions, order);
        add_sample(&to, from_rows == NULL, &from, b, &m, &weights, dimensions, order);
    }
}

/* First and second derivative of v r^2, r = 1 - m, along i and along i and j. */
VEC_INLINE vf ridge_first(vf v, vf r, vf wi, vf mi)
{
    return r * r * wi - 2.0f * v * r * mi;
}

VEC_INLINE vf ridge_second(vf v, vf r, vf wi, vf wj, vf wij, vf mi, vf mj, vf mij)
{
    return (r * r * wij - 2.0f * r * (wi * mj + wj * mi)) +
           (2.0f * v * (mi * mj) - 2.0f * v * r * mij);
}

VEC_INLINE struct sample ridge(const struct rows *weight, const struct sample *m, size_t b,
                               int dimensions, int order)
{
    const vf(*const w)[CHUNK_BLOCKS] = weight->row;
    const vf v = w[VALUE][b];
    const vf r = 1.0f - m->value;
    struct sample s;
    s.value = v * (r * r);
    if (order >= 1) {
        const vf vx = w[DX][b], vy = w[DY][b];
        s.dx = ridge_first(v, r, vx, m->dx);
        s.dy = ridge_first(v, r, vy, m->dy);
        if (dimensions == 3) {
            s.dz = ridge_first(v, r, w[DZ][b], m->dz);
        }
        if (order >= 2) {
            s.dxx = ridge_second(v, r, vx, vx, w[DXX][b], m->dx, m->dx, m->dxx);
            s.dxy = ridge_second(v, r, vx, vy, w[DXY][b], m->dx, m->dy, m->dxy);
            s.dyy = ridge_second(v, r, vy, vy, w[DYY][b], m->dy, m->dy, m->dyy);
            if (dimensions == 3) {
                const vf vz = w[DZ][b];
                s.dxz = ridge_second(v, r, vx, vz, w[DXZ][b], m->dx, m->dz, m->dxz);
                s.dyz = ridge_second(v, r, vy, vz, w[DYZ][b], m->dy, m->dz, m->dyz);
                s.dzz = ridge_second(v, r, vz, vz, w[DZZ][b], m->dz, m->dz, m->dzz);
            }
        }
    }
    return s;
}

/* The next weight: 2 s, but 1 where that is more. */
VEC_INLINE void ridge_weight(struct rows *weight, const struct sample *s, size_t b, int dimensions,
                             int order)
{
    const vf v = 2.0f * s->value;
    const vu less = (vu)(v < vf_set(1.0f));
    const vf zero = vf_set(0.0f);
    weight->row[VALUE][b] = either(less, v, vf_set(1.0f));
    if (order >= 1) {
        weight->row[DX][b] = either(less, 2.0f * s->dx, zero);
        weight->row[DY][b] = either(less, 2.0f * s->dy, zero);
        if (dimensions == 3) {
            weight->row[DZ][b] = either(less, 2.0f * s->dz, zero);
        }
    }
    if (order >= 2) {
        weight->row[DXX][b] = either(less, 2.0f * s->dxx, zero);
        weight->row[DXY][b] = either(less, 2.0f * s->dxy, zero);
        weight->row[DYY][b] = either(less, 2.0f * s->dyy, zero);
        if (dimensions == 3) {
            weight->row[DXZ][b] = either(less, 2.0f * s->dxz, zero);
            weight->row[DYZ][b] = either(less, 2.0f * s->dyz, zero);
            weight->row[DZZ][b] = either(less, 2.0f * s->dzz, zero);
        }
    }
}

VEC_INLINE void ridged_run(const struct scarp_octave *octave, size_t blocks, const struct rows *n,
                           union state *state, const struct scarp_samples *from_rows,
                           const struct scarp_samples *to_rows, int dimensions, int order)
{
    const struct weights weights = {octave->weight, octave->weight, octave->weight};
    const struct scarp_samples from = rows_of(from_rows), to = *to_rows;
    for (size_t b = 0; b < blocks; b++) {
        const struct sample m = magnitude(n, b, dimensions, order);
        const struct sample s = ridge(&state->weight, &m, b, dimensions, order);
        ridge_weight(&state->weight, &s, b, dimensions, order);
        add_sample(&to, from_rows == NULL, &from, b, &s, &weights, dimensions, order);
    }
}

/* Component j of J^T v, v being a gradient in the octave's axes. */
VEC_INLINE vf to_input(const struct scarp_octave *o, int turned, int j, struct vector v,
                       int dimensions)
{
    if (turned) {
        return column_dot(o->jacobian, j, v, dimensions);
    }
    return vf_set(o->frequency) * (j == 0 ? v.x : j == 1 ? v.y : v.z);
}

/* The gradient of an eroded octave along x_j. */
struct damped {
    vf q, damping; /* q_k and 2 erosion n q_k^2 */
    struct vector d, g;
};

VEC_INLINE vf erode_along(const struct scarp_octave *o, int turned, const struct rows *n, size_t b,
                          union state *state, const struct damped *e, int j, int dimensions)
{
    const vf(*const h)[CHUNK_BLOCKS] = n->row;
    struct vector hx = {.x = h[DXX][b], .y = h[DXY][b]};
    struct vector hy = {.x = h[DXY][b], .y = h[DYY][b]};
    if (dimensions == 3) {
        hx.z = h[DXZ][b];
        hy.z = h[DYZ][b];
    }
    const vf dx = state->slopes.jacobian[0][j][b] + to_input(o, turned, j, hx, dimensions);
    const vf dy = state->slopes.jacobian[1][j][b] + to_input(o, turned, j, hy, dimensions);
    state->slopes.jacobian[0][j][b] = dx;
    state->slopes.jacobian[1][j][b] = dy;
    vf steeper = dx * e->d.x + dy * e->d.y;
    if (dimensions == 3) {
        const struct vector hz = {h[DXZ][b], h[DYZ][b], h[DZZ][b]};
        const vf dz = state->slopes.jacobian[2][j][b] + to_input(o, turned, j, hz, dimensions);
        state->slopes.jacobian[2][j][b] = dz;
        steeper += dz * e->d.z;
    }
    return e->q * to_input(o, turned, j, e->g, dimensions) - e->damping * steeper;
}

VEC_INLINE void erosion_run(const struct scarp_plan *plan, const struct scarp_octave *octave,
                            int turned, size_t blocks, const struct rows *n, union state *state,
                            const struct scarp_samples *from_rows,
                            const struct scarp_samples *to_rows, int dimensions, int order)
{
    const struct weights weights = {octave->weight, octave->weight, octave->weight};
    const struct scarp_samples from = rows_of(from_rows), to = *to_rows;
    const vf erosion = vf_set(plan->erosion);
    const vf twice = vf_set(2.0f * plan->erosion);
    for (size_t b = 0; b < blocks; b++) {
        const vf value = n->row[VALUE][b];
        struct damped e;
        e.g.x = n->row[DX][b];
        e.g.y = n->row[DY][b];
        e.d.x = state->slopes.d[0][b] + e.g.x;
        e.d.y = state->slopes.d[1][b] + e.g.y;
        state->slopes.d[0][b] = e.d.x;
        state->slopes.d[1][b] = e.d.y;
        vf squares = e.d.x * e.d.x + e.d.y * e.d.y;
        if (dimensions == 3) {
            e.g.z = n->row[DZ][b];
            e.d.z = state->slopes.d[2][b] + e.g.z;
            state->slopes.d[2][b] = e.d.z;
            squares += e.d.z * e.d.z;
        }
        e.q = 1.0f / (1.0f + erosion * squares);
        struct sample s;
        s.value = e.q * value;
        if (order >= 1) {
            e.damping = twice * value * (e.q * e.q);
            s.dx = erode_along(octave, turned, n, b, state, &e, 0, dimensions);
            s.dy = erode_along(octave, turned, n, b, state, &e, 1, dimensions);
            if (dimensions == 3) {
                s.dz = erode_along(octave, turned, n, b, state, &e, 2, dimensions);
            }
        }
        add_sample(&to, from_rows == NULL, &from, b, &s, &weights, dimensions, order);
    }
}

/* What the first octave finds: weights of 1, no slopes. */
static void state_begin(const struct scarp_plan *plan, union state *state, size_t blocks)
{
    const vf zero = vf_set(0.0f);
    if (plan->fractal == SCARP_RIDGED) {
        for (size_t b = 0; b < blocks; b++) {
            state->weight.row[VALUE][b] = vf_set(1.0f);
            for (int i = DX; i < (plan->order == 0 ? DX : plan->order == 1 ? DXX : ROWS); i++) {
                state->weight.row[i][b] = zero;
            }
        }
    } else if (plan->fractal == SCARP_EROSION) {
        for (size_t b = 0; b < blocks; b++) {
            for (int i = 0; i < 3; i++) {
                state->slopes.d[i][b] = zero;
                for (int j = 0; j < (plan->order == 0 ? 0 : 3); j++) {
                    state->slopes.jacobian[i][j][b] = zero;
                }
            }
        }
    }
}

#define SHAPE_PASS(name, call)                                                                     \
    static void name(const struct scarp_plan *plan, const struct scarp_octave *octave,             \
                     enum axes axes, size_t blocks, const struct rows *n, union state *state,      \
                     const struct scarp_samples *from, const struct scarp_samples *to)             \
    {                                                                                              \
        (void)plan;                                                                                \
        (void)axes;                                                                                \
        (void)state;                                                                               \
        call;                                                                                      \
    }
#define TURBULENCE_PASS(name, dimensions, order)                                                   \
    SHAPE_PASS(name, turbulence_run(octave, blocks, n, from, to, dimensions, order))
#define RIDGED_PASS(name, dimensions, order)                                                       \
    SHAPE_PASS(name, ridged_run(octave, blocks, n, state, from, to, dimensions, order))
#define EROSION_PASS(name, dimensions, order)                                                      \
    SHAPE_PASS(                                                                                    \
        name,                                                                                      \
        if (axes == AXES_TURNED) {                                                                 \
            erosion_run(plan, octave, 1, blocks, n, state, from, to, dimensions, order);           \
        } else { erosion_run(plan, octave, 0, blocks, n, state, from, to, dimensions, order); })

TURBULENCE_PASS(turbulence2_order0, 2, 0)
TURBULENCE_PASS(turbulence2_order1, 2, 1)
TURBULENCE_PASS(turbulence2_order2, 2, 2)
TURBULENCE_PASS(turbulence3_order0, 3, 0)
TURBULENCE_PASS(turbulence3_order1, 3, 1)
TURBULENCE_PASS(turbulence3_order2, 3, 2)
RIDGED_PASS(ridged2_order0, 2, 0)
RIDGED_PASS(ridged2_order1, 2, 1)
RIDGED_PASS(ridged2_order2, 2, 2)
RIDGED_PASS(ridged3_order0, 3, 0)
RIDGED_PASS(ridged3_order1, 3, 1)
RIDGED_PASS(ridged3_order2, 3, 2)
EROSION_PASS(erosion2_order0, 2, 0)
EROSION_PASS(erosion2_order1, 2, 1)
EROSION_PASS(erosion3_order0, 3, 0)
EROSION_PASS(erosion3_order1, 3, 1)

#undef TURBULENCE_PASS
#undef RIDGED_PASS
#undef EROSION_PASS
#undef SHAPE_PASS

/* By [fractal - 1][dimensions - 2][order]. */
static shape_pass *const shape_passes[3][2][3] = {
    {{turbulence2_order0, turbulence2_order1, turbulence2_order2},
     {turbulence3_order0, turbulence3_order1, turbulence3_order2}},
    {{ridged2_order0, ridged2_order1, ridged2_order2},
     {ridged3_order0, ridged3_order1, ridged3_order2}},
    {{erosion2_order0, erosion2_order1, NULL}, {erosion3_order0, erosion3_order1, NULL}},
};

#endif
