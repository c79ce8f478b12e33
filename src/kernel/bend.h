/* SPDX-License-Identifier: MIT
 *
 * The fractals that bend, whose octaves look at y = x + w S, where S is what the slopes of the
 * octaves before add up to: Swiss and Jordan noise (de Carpentier 2012). Each octave is computed as
 * noise of its own at the positions of a chunk of points; a pass then adds it up and moves S on.
 * The reference is formulas/bend.h.
 */
#ifndef SCARP_KERNEL_BEND_H
#define SCARP_KERNEL_BEND_H

#include "chunk.h"
#include "points.h"

/* A matrix by columns; z is unset in 2D. */
struct matrix {
    struct vector x, y, z;
};

/* The state that goes from octave to octave at a block: the noise, the sum S of slopes with its
   Jacobian with respect to x, and how much of the octaves is left (Swiss), with derivatives. In
   memory, the noise comes first, as a stored sample, then the others in this order, without unset
   members. */
struct bend {
    struct sample sum;
    struct vector s;
    vf left;
    struct vector left_by;
    struct matrix jacobian;
};

VEC_INLINE size_t bend_size(int dimensions, int order)
{
    const size_t n = (size_t)dimensions;
    return order == 0 ? n + 2 : (1 + n) + n + (1 + n) + n * n;
}

VEC_INLINE struct vector vector_load(const vf **from, int dimensions)
{
    const struct vector v = vector_at(*from, dimensions);
    *from += dimensions;
    return v;
}

VEC_INLINE void vector_store(vf **to, const struct vector *v, int dimensions)
{
    (*to)[0] = v->x;
    (*to)[1] = v->y;
    if (dimensions == 3) {
        (*to)[2] = v->z;
    }
    *to += dimensions;
}

VEC_INLINE struct bend bend_load(const vf *from, struct variant v)
{
    struct bend b;
    b.sum = sample_load(from, v);
    from += sample_size(v.dimensions, v.order);
    b.s = vector_load(&from, v.dimensions);
    b.left = *from++;
    if (v.order > 0) {
        b.left_by = vector_load(&from, v.dimensions);
        b.jacobian.x = vector_load(&from, v.dimensions);
        b.jacobian.y = vector_load(&from, v.dimensions);
        if (v.dimensions == 3) {
            b.jacobian.z = vector_load(&from, v.dimensions);
        }
    }
    return b;
}

VEC_INLINE void bend_store(vf *to, const struct bend *b, struct variant v)
{
    sample_store(to, &b->sum, v);
    to += sample_size(v.dimensions, v.order);
    vector_store(&to, &b->s, v.dimensions);
    *to++ = b->left;
    if (v.order > 0) {
        vector_store(&to, &b->left_by, v.dimensions);
        vector_store(&to, &b->jacobian.x, v.dimensions);
        vector_store(&to, &b->jacobian.y, v.dimensions);
        if (v.dimensions == 3) {
            vector_store(&to, &b->jacobian.z, v.dimensions);
        }
    }
}

/* What a pass needs: the octave's noise, with one order more than is asked for, and its numbers. */
struct bending {
    const struct scarp_outputs *noise;
    vf *state;
    float *by[3]; /* of doubles: how far positions are displaced */
    size_t blocks;
    struct bend_octave octave;
    float erosion;
    int is_first;
};

VEC_INLINE struct vector vector_times(struct vector v, vf a, int dimensions)
{
    v.x *= a;
    v.y *= a;
    if (dimensions == 3) {
        v.z *= a;
    }
    return v;
}

VEC_INLINE struct vector gradient_of(const struct sample *s, int dimensions)
{
    struct vector g = {.x = s->dx, .y = s->dy};
    if (dimensions == 3) {
        g.z = s->dz;
    }
    return g;
}

/* v_j + w (column j of the Jacobian of S) . v */
VEC_INLINE vf bent_along(vf vj, const struct vector *column, struct vector v, vf reach,
                         int dimensions)
{
    return vj + reach * dot(*column, v, dimensions);
}

/* A^T v with A = I + w (Jacobian of S). */
VEC_INLINE struct vector bent_vector(const struct bend *b, struct vector v, vf reach,
                                     int dimensions)
{
    struct vector r;
    r.x = bent_along(v.x, &b->jacobian.x, v, reach, dimensions);
    r.y = bent_along(v.y, &b->jacobian.y, v, reach, dimensions);
    if (dimensions == 3) {
        r.z = bent_along(v.z, &b->jacobian.z, v, reach, dimensions);
    }
    return r;
}

/* Adds the derivatives along one axis of factor * slope to a column of the Jacobian of S. `by` is
   the derivative of the factor, `second` that of the slope. */
VEC_INLINE void add_column(struct vector *column, vf by, const struct vector *slope, vf product,
                           const struct vector *second, int dimensions)
{
    column->x += by * slope->x + product * second->x;
    column->y += by * slope->y + product * second->y;
    if (dimensions == 3) {
        column->z += by * slope->z + product * second->z;
    }
}

/* Adds product times the slope g / f of the octave n to S, with its derivatives; `by` are those of
   the product. */
VEC_INLINE void add_slope(struct bend *b, const struct bending *at, const struct sample *n,
                          vf product, struct vector by, struct variant v)
{
    const int d = v.dimensions;
    const vf inverse = vf_set(at->octave.inverse), reach = vf_set(at->octave.reach);
    const struct vector slope = vector_times(gradient_of(n, d), inverse, d);
    if (v.order > 0) {
        /* rows of H A / f: by symmetry their components are its columns, too */
        struct vector hx = {.x = n->dxx, .y = n->dxy}, hy = {.x = n->dxy, .y = n->dyy};
        struct vector x, y, z; /* columns */
        if (d == 3) {
            hx.z = n->dxz;
            hy.z = n->dyz;
            const struct vector hz = {n->dxz, n->dyz, n->dzz};
            const struct vector rz = vector_times(bent_vector(b, hz, reach, d), inverse, d);
            x.z = rz.x;
            y.z = rz.y;
            z.z = rz.z;
        }
        const struct vector rx = vector_times(bent_vector(b, hx, reach, d), inverse, d);
        const struct vector ry = vector_times(bent_vector(b, hy, reach, d), inverse, d);
        x.x = rx.x;
        x.y = ry.x;
        y.x = rx.y;
        y.y = ry.y;
        add_column(&b->jacobian.x, by.x, &slope, product, &x, d);
        add_column(&b->jacobian.y, by.y, &slope, product, &y, d);
        if (d == 3) {
            z.x = rx.z;
            z.y = ry.z;
            add_column(&b->jacobian.z, by.z, &slope, product, &z, d);
        }
    }
    b->s.x += product * slope.x;
    b->s.y += product * slope.y;
    if (d == 3) {
        b->s.z += product * slope.z;
    }
}

/* Swiss noise along an axis: adds the derivative of a u w to the sum, and returns that of
   -share u n; nj, uj are those of n and u. */
VEC_INLINE vf swiss_along(vf *sum, const struct bending *at, const struct bend *b, vf n, vf nj,
                          vf uj)
{
    const vf zero = vf_set(0.0f);
    const struct sign sign = sign_of(n);
    const vf rest = 1.0f - with_sign(n, sign);
    const vu below = (vu)(rest < zero);
    const vf w = either(below, zero, rest), wj = either(below, zero, with_sign(nj, sign));
    const vf share = vf_set(at->octave.weight * at->octave.inverse_weight);
    *sum += vf_set(at->octave.weight) * (w * uj - b->left * wj);
    return -share * (uj * n + b->left * nj);
}

/* The next derivative of u along an axis: that of u times the sum, which is less than 1 there. */
VEC_INLINE vf left_along(vu less, vf sum, vf sum_j, vf u, vf uj, vf inverse_weight)
{
    return either(less, sum * uj + u * (sum_j * inverse_weight), uj);
}

VEC_INLINE void swiss(struct bend *b, const struct bending *at, const struct sample *n,
                      struct vector nx, struct variant v)
{
    const vf zero = vf_set(0.0f), u = b->left, inverse_weight = vf_set(at->octave.inverse_weight);
    const vf share = vf_set(at->octave.weight * at->octave.inverse_weight);
    const vf rest = 1.0f - with_sign(n->value, sign_of(n->value));
    const vf w = either((vu)(rest < zero), zero, rest);
    struct vector by = nx;
    if (v.order > 0) {
        by.x = swiss_along(&b->sum.dx, at, b, n->value, nx.x, b->left_by.x);
        by.y = swiss_along(&b->sum.dy, at, b, n->value, nx.y, b->left_by.y);
        if (v.dimensions == 3) {
            by.z = swiss_along(&b->sum.dz, at, b, n->value, nx.z, b->left_by.z);
        }
    }
    b->sum.value += vf_set(at->octave.weight) * (u * w);
    add_slope(b, at, n, -share * (u * n->value), by, v);
    const vf sum = b->sum.value * inverse_weight;
    const vu less = (vu)(sum < vf_set(1.0f));
    struct vector *const l = &b->left_by;
    if (v.order > 0) {
        l->x = left_along(less, sum, b->sum.dx, u, l->x, inverse_weight);
        l->y = left_along(less, sum, b->sum.dy, u, l->y, inverse_weight);
        if (v.dimensions == 3) {
            l->z = left_along(less, sum, b->sum.dz, u, l->z, inverse_weight);
        }
    }
    b->left = either(less, u * sum, u);
}

VEC_INLINE void jordan(struct bend *b, const struct bending *at, const struct sample *n,
                       struct vector nx, struct variant v)
{
    const vf square = n->value * n->value, weight = vf_set(at->octave.weight);
    const vf p = 1.0f / (1.0f + dot(b->s, b->s, v.dimensions));
    const vf q = at->is_first ? vf_set(1.0f) : 1.0f - vf_set(at->erosion) * p;
    const vf damping = at->is_first ? vf_set(0.0f) : vf_set(2.0f * at->erosion) * (p * p) * square;
#define ALONG(axis, nj)                                                                            \
    weight *(damping * dot(b->jacobian.axis, b->s, v.dimensions) + 2.0f * q * (n->value * nj))
    if (v.order > 0) {
        b->sum.dx += ALONG(x, nx.x);
        b->sum.dy += ALONG(y, nx.y);
        if (v.dimensions == 3) {
            b->sum.dz += ALONG(z, nx.z);
        }
    }
#undef ALONG
    b->sum.value += weight * (q * square);
    add_slope(b, at, n, n->value, nx, v);
}

VEC_INLINE void bend_run(const struct bending *at, enum scarp_fractal fractal, struct variant v)
{
    const struct variant noise = {v.basis, v.dimensions, v.order + 1, 0};
    const struct bending numbers = *at;
    for (size_t i = 0; i < at->blocks; i++) {
        vf *const stored = numbers.state + i * bend_size(v.dimensions, v.order);
        struct bend b = bend_load(stored, v);
        const struct sample n = sample_at(numbers.noise, i * VEC_LANES, noise);
        struct vector nx =
            gradient_of(&n, v.dimensions); /* with respect to x, where it is needed */
        if (v.order > 0) {
            nx = bent_vector(&b, nx, vf_set(numbers.octave.reach), v.dimensions);
        }
        if (fractal == SCARP_SWISS) {
            swiss(&b, &numbers, &n, nx, v);
        } else {
            jordan(&b, &numbers, &n, nx, v);
        }
        bend_store(stored, &b, v);
    }
}

typedef void bend_pass(const struct bending *at);

#define BEND_PASS(name, fractal, dimensions, order)                                                \
    static void name(const struct bending *at)                                                     \
    {                                                                                              \
        const struct variant v = {SCARP_GRADIENT, dimensions, order, 0};                           \
        bend_run(at, fractal, v);                                                                  \
    }
BEND_PASS(swiss2_order0, SCARP_SWISS, 2, 0)
BEND_PASS(swiss2_order1, SCARP_SWISS, 2, 1)
BEND_PASS(swiss3_order0, SCARP_SWISS, 3, 0)
BEND_PASS(swiss3_order1, SCARP_SWISS, 3, 1)
BEND_PASS(jordan2_order0, SCARP_JORDAN, 2, 0)
BEND_PASS(jordan2_order1, SCARP_JORDAN, 2, 1)
BEND_PASS(jordan3_order0, SCARP_JORDAN, 3, 0)
BEND_PASS(jordan3_order1, SCARP_JORDAN, 3, 1)
#undef BEND_PASS

/* By [fractal is Jordan noise][dimensions - 2][order]. */
static bend_pass *const bend_passes[2][2][2] = {
    {{swiss2_order0, swiss2_order1}, {swiss3_order0, swiss3_order1}},
    {{jordan2_order0, jordan2_order1}, {jordan3_order0, jordan3_order1}},
};

/* Bends the positions of a chunk: floats themselves, or how far doubles are displaced, which is
   `by` without bending. */
static void bend_positions(const struct chunked *w, const struct bending *at,
                           const float *const by[3], int order)
{
    const size_t size = bend_size(w->f.dimensions, order);
    const size_t s = sample_size(w->f.dimensions, order);
    for (int i = 0; i < w->f.dimensions; i++) {
        const vf *from = at->state + s + i;
        for (size_t b = 0; b < at->blocks; b++, from += size) {
            const vf bent = vf_set(at->octave.reach) * *from;
            if (w->f.layout == FLOATS) {
                displace(w, i, b * VEC_LANES, bent);
            } else {
                const vf d = by[i] != NULL ? vf_load(by[i] + b * VEC_LANES) : vf_set(0.0f);
                vf_store(at->by[i] + b * VEC_LANES, d + bent);
            }
        }
    }
}

/* Nothing is added up yet, and all is left. */
static void bend_begin(const struct bending *at, int dimensions, int order)
{
    const size_t size = bend_size(dimensions, order);
    const size_t left = sample_size(dimensions, order) + (size_t)dimensions;
    for (size_t b = 0; b < at->blocks; b++) {
        vf *const stored = at->state + b * size;
        for (size_t i = 0; i < size; i++) {
            stored[i] = vf_set(0.0f);
        }
        stored[left] = vf_set(1.0f);
    }
}

/* Computes octave k at a chunk, `one` being its plan. `by` is how far doubles are displaced before
   they bend; NULL: not at all. */
static void bent_noise(struct chunked *w, const struct scarp_call_plan *one,
                       const struct chunk *chunk, const struct bending *at,
                       const float *const by[3])
{
    const int doubles = w->f.layout == DOUBLES, bends = one->first > 0;
    const size_t count = at->blocks * VEC_LANES;
    const void *position[3] = {w->input[0], w->input[1], w->input[2]};
    const float *const bent[3] = {at->by[0], at->by[1], at->by[2]};
    struct moved_axis axis[3];
    struct frame f = w->f;
    if (doubles && (bends || by[0] != NULL)) {
        moved_input(axis, w, chunk, bends ? bent : by);
        f.layout = MOVED;
    }
    for (int i = 0; i < f.dimensions; i++) {
        position[i] = f.layout == MOVED ? &axis[i] : bends ? w->position[i] : w->input[i];
    }
    points_within(one, count, position, at->noise, f, w->passes);
}

/* Adds up the octaves at a chunk. */
static void bend_chunk(struct chunked *w, const struct scarp_call_plan *plan,
                       const struct chunk *chunk, struct bending *at, const float *const by[3])
{
    bend_pass *const pass =
        bend_passes[plan->fractal == SCARP_JORDAN][w->f.dimensions - 2][plan->order];
    struct scarp_call_plan one = *plan;
    one.fractal = SCARP_FBM;
    one.order++;
    one.octaves = 1;
    one.plain = blends_corners(one.basis) && one.repeat == SCARP_REPEAT_NEVER && !one.flows &&
                one.component == 0;
    at->blocks = whole_blocks(chunk_count(chunk)) / VEC_LANES;
    bend_begin(at, w->f.dimensions, plan->order);
    find_input(w, chunk);
    for (int k = 0; k < plan->octaves; k++) {
        at->octave = bend_octave_of(plan, k);
        at->is_first = k == 0;
        if (k > 0) {
            if (w->f.layout == FLOATS) {
                find_input(w, chunk);
            }
            bend_positions(w, at, by, plan->order);
        }
        one.octave = &plan->octave[k];
        one.first = k;
        bent_noise(w, &one, chunk, at, by);
        pass(at);
    }
}

/* Computes points of a fractal that bends. Where they are displaced, they are no rows of a grid. */
static __attribute__((noinline)) void bend_points(const struct scarp_call_plan *plan, size_t count,
                                                  const void *const position[3],
                                                  const struct scarp_outputs *out, struct frame f,
                                                  struct workspace work)
{
    const size_t size = sample_size(f.dimensions, plan->order + 1);
    const size_t state = bend_size(f.dimensions, plan->order);
    const void *from_position[3] = {position[0], position[1], position[2]};
    const float *displaced[3] = {NULL, NULL, NULL};
    for (int i = 0; i < f.dimensions && f.layout == MOVED; i++) {
        const struct moved_axis *const axis = position[i];
        from_position[i] = axis->x;
        displaced[i] = axis->by;
    }
    f.layout = f.layout == FLOATS ? FLOATS : DOUBLES;
    struct chunked w = {.source = {from_position, NULL}, .f = f, .keep = keep_of(f.layout, count)};
    struct scarp_outputs noise;
    struct bending at = {.noise = &noise, .erosion = plan->erosion};
    struct outputs sums;
    const size_t moves = f.layout == DOUBLES ? (size_t)f.dimensions : 0;
    float *from = chunked_begin(&w, work, size + state + moves);
    take_arrays(&noise, &from, w.most, f.dimensions, plan->order + 1);
    for (size_t i = 0; i < moves; i++) {
        at.by[i] = from;
        from += w.most;
    }
    at.state = (vf *)from;
    chunked_end(&w, work, (float *)(at.state + w.most / VEC_LANES * state));
    outputs_stored(&sums, at.state, state, f.dimensions, plan->order, 0);
    for (size_t first = 0; first < count; first += w.most) {
        const size_t here = least(count - first, w.most);
        const struct chunk chunk = {{first, 0, 0}, here, 1, here};
        const float *by[3] = {NULL, NULL, NULL};
        for (int i = 0; i < 3 && displaced[i] != NULL; i++) {
            by[i] = displaced[i] + first;
        }
        bend_chunk(&w, plan, &chunk, &at, by);
        copy_out(out, first, &sums, 0, here);
    }
}

/* Computes points of a noise without its warps. */
static void points_unwarped(const struct scarp_call_plan *plan, size_t count,
                            const void *const position[3], const struct scarp_outputs *out,
                            struct frame f, struct workspace work)
{
    if (fractal_bends(plan->fractal)) {
        bend_points(plan, count, position, out, f, work);
    } else {
        points_within(plan, count, position, out, f, work);
    }
}

#endif
