/* SPDX-License-Identifier: MIT
 *
 * The fractals that bend, whose octaves look at y = x + w S, where S is what the slopes of the
 * octaves before add up to: Swiss and Jordan noise (de Carpentier 2012). Each octave is computed as
 * noise of its own at the positions of a chunk of points; a pass then adds it up and moves S on.
 * Included by points.h; the reference is scalar/bend.h.
 */
#ifndef SCARP_KERNEL_BEND_H
#define SCARP_KERNEL_BEND_H

#include "chunk.h"

/* What the passes keep at a block, as vectors: the noise as a stored sample; S; how much of the
   octaves is left (Swiss), with its gradient; and the Jacobian of S by rows. */
struct bend_state {
    size_t s, left, jacobian, size;
};

VEC_INLINE struct bend_state bend_state_of(int dimensions, int order)
{
    const size_t n = (size_t)dimensions, sum = sample_size(dimensions, order);
    const struct bend_state state = {sum, sum + n, sum + n + (order > 0 ? 1 + n : 1),
                                     sum + n + (order > 0 ? 1 + n + n * n : 1)};
    return state;
}

/* What a pass needs: the octave's noise, with one order more than is asked for, and numbers. */
struct bending {
    const struct scarp_outputs *noise;
    vf *state;
    size_t blocks;
    float inverse, weight, inverse_weight, reach, erosion; /* as in scalar/bend.h */
    int is_first;
};

/* An octave at a block, while it is added up. */
struct bend_block {
    const struct bending *at;
    struct sample n;
    vf *sum, *s, *left, *jacobian;
    struct vector by; /* the gradient of n by x */
};

VEC_INLINE vf component_of(const struct vector *v, int i)
{
    return i == 0 ? v->x : i == 1 ? v->y : v->z;
}

VEC_INLINE void set_component(struct vector *v, int i, vf a)
{
    *(i == 0 ? &v->x : i == 1 ? &v->y : &v->z) = a;
}

/* Column j of the Jacobian of S, transposed, times a vector. */
VEC_INLINE vf bend_column(const struct bend_block *b, int j, struct vector v, int dimensions)
{
    const vf *const column = b->jacobian + j;
    const vf sum = column[0] * v.x + column[dimensions] * v.y;
    return dimensions == 3 ? sum + column[2 * dimensions] * v.z : sum;
}

/* Component j of A^T v with A = I + w (Jacobian of S). */
VEC_INLINE vf bent_first(const struct bend_block *b, int j, struct vector v, int dimensions)
{
    return component_of(&v, j) + vf_set(b->at->reach) * bend_column(b, j, v, dimensions);
}

VEC_INLINE struct vector hessian_row(const struct sample *n, int m, int dimensions)
{
    struct vector row = {.x = m == 0 ? n->dxx : n->dxy, .y = m == 0 ? n->dxy : n->dyy};
    if (dimensions == 3) {
        row.x = m == 2 ? n->dxz : row.x;
        row.y = m == 2 ? n->dyz : row.y;
        row.z = m == 0 ? n->dxz : m == 1 ? n->dyz : n->dzz;
    }
    return row;
}

VEC_INLINE struct vector slope_of(const struct bend_block *b, int dimensions)
{
    const vf inverse = vf_set(b->at->inverse);
    struct vector slope = {.x = b->n.dx * inverse, .y = b->n.dy * inverse};
    if (dimensions == 3) {
        slope.z = b->n.dz * inverse;
    }
    return slope;
}

/* The derivatives by x_j of the components of the slope: H A / f. */
VEC_INLINE struct vector bent_second(const struct bend_block *b, int j, int dimensions)
{
    const vf inverse = vf_set(b->at->inverse);
    struct vector second;
    for (int m = 0; m < dimensions; m++) {
        const struct vector row = hessian_row(&b->n, m, dimensions);
        set_component(&second, m, bent_first(b, j, row, dimensions) * inverse);
    }
    return second;
}

/* Adds product times the slope to S, with its derivatives; `by` are those of the product. Column j
   of the Jacobian needs no other column, so each may be moved on before the next. */
VEC_INLINE void add_slope(struct bend_block *b, vf product, struct vector by, struct variant v)
{
    const struct vector slope = slope_of(b, v.dimensions);
    for (int j = 0; v.order > 0 && j < v.dimensions; j++) {
        const struct vector second = bent_second(b, j, v.dimensions);
        for (int m = 0; m < v.dimensions; m++) {
            b->jacobian[m * v.dimensions + j] +=
                component_of(&by, j) * component_of(&slope, m) + product * component_of(&second, m);
        }
    }
    for (int m = 0; m < v.dimensions; m++) {
        b->s[m] += product * component_of(&slope, m);
    }
}

VEC_INLINE void swiss_block(struct bend_block *b, struct variant v)
{
    const struct bending *const at = b->at;
    const vf n = b->n.value, u = b->left[0], zero = vf_set(0.0f);
    const vf weight = vf_set(at->weight), inverse_weight = vf_set(at->inverse_weight);
    const vf share = vf_set(at->weight * at->inverse_weight);
    const struct sign sign = sign_of(n);
    const vf rest = 1.0f - with_sign(n, sign);
    const vu below = (vu)(rest < zero);
    const vf w = either(below, zero, rest);
    struct vector by;
    for (int j = 0; v.order > 0 && j < v.dimensions; j++) {
        const vf nj = component_of(&b->by, j), left = b->left[1 + j];
        const vf wj = either(below, zero, with_sign(nj, sign));
        b->sum[1 + j] += weight * (w * left - u * wj);
        set_component(&by, j, -share * (left * n + u * nj));
    }
    b->sum[0] += weight * (u * w);
    add_slope(b, -share * (u * n), by, v);
    const vf sum = b->sum[0] * inverse_weight;
    const vu less = (vu)(sum < vf_set(1.0f));
    for (int j = 0; v.order > 0 && j < v.dimensions; j++) {
        const vf left = b->left[1 + j];
        b->left[1 + j] = either(less, sum * left + u * (b->sum[1 + j] * inverse_weight), left);
    }
    b->left[0] = either(less, u * sum, u);
}

VEC_INLINE void jordan_block(struct bend_block *b, struct variant v)
{
    const struct bending *const at = b->at;
    const vf n = b->n.value, square = n * n, weight = vf_set(at->weight);
    struct vector s = vector_at(b->s, v.dimensions);
    const vf p = 1.0f / (1.0f + dot(s, s, v.dimensions));
    const vf q = at->is_first ? vf_set(1.0f) : 1.0f - vf_set(at->erosion) * p;
    const vf damping = at->is_first ? vf_set(0.0f) : vf_set(2.0f * at->erosion) * (p * p) * square;
    for (int j = 0; v.order > 0 && j < v.dimensions; j++) {
        const vf nj = component_of(&b->by, j);
        b->sum[1 + j] +=
            weight * (damping * bend_column(b, j, s, v.dimensions) + 2.0f * q * (n * nj));
    }
    b->sum[0] += weight * (q * square);
    add_slope(b, n, b->by, v);
}

VEC_INLINE void bend_run(const struct bending *at, enum scarp_fractal fractal, struct variant v)
{
    const struct bend_state state = bend_state_of(v.dimensions, v.order);
    const struct variant noise = {v.basis, v.dimensions, v.order + 1, 0};
    vf *of_block = at->state;
    for (size_t i = 0; i < at->blocks; i++, of_block += state.size) {
        struct bend_block b = {.at = at,
                               .sum = of_block,
                               .s = of_block + state.s,
                               .left = of_block + state.left,
                               .jacobian = of_block + state.jacobian};
        b.n = sample_at(at->noise, i * VEC_LANES, noise);
        for (int j = 0; v.order > 0 && j < v.dimensions; j++) {
            struct vector g = {.x = b.n.dx, .y = b.n.dy};
            if (v.dimensions == 3) {
                g.z = b.n.dz;
            }
            set_component(&b.by, j, bent_first(&b, j, g, v.dimensions));
        }
        if (fractal == SCARP_SWISS) {
            swiss_block(&b, v);
        } else {
            jordan_block(&b, v);
        }
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

/* Bends the positions of a chunk. */
static void bend_positions(const struct chunked *w, const struct chunk *chunk,
                           const struct bending *at, struct bend_state state)
{
    float *const by = (float *)w->spare;
    positions_of_input(w, chunk);
    for (int i = 0; i < w->f.dimensions; i++) {
        for (size_t b = 0; b < at->blocks; b++) {
            const vf s = at->state[b * state.size + state.s + (size_t)i];
            vf_store(by + b * VEC_LANES, vf_set(at->reach) * s);
        }
        displace(w->position[i], by, at->blocks * VEC_LANES, w->f.layout);
    }
}

static void points_within(const struct scarp_call_plan *plan, size_t count,
                          const void *const position[3], const struct scarp_outputs *out,
                          struct frame f, struct workspace work);

/* Adds up the octaves at a chunk. */
static void bend_chunk(const struct chunked *w, const struct scarp_call_plan *plan,
                       const struct chunk *chunk, struct bending *at)
{
    const struct bend_state state = bend_state_of(w->f.dimensions, plan->order);
    const void *const position[3] = {w->position[0], w->position[1], w->position[2]};
    bend_pass *const pass =
        bend_passes[plan->fractal == SCARP_JORDAN][w->f.dimensions - 2][plan->order];
    const struct scarp_octave *const first = &plan->octave[0];
    struct scarp_call_plan one = *plan;
    one.fractal = SCARP_FBM;
    one.order++;
    one.octaves = 1;
    at->blocks = whole_blocks(chunk_count(chunk)) / VEC_LANES;
    for (size_t i = 0; i < at->blocks * state.size; i++) {
        at->state[i] = vf_set(i % state.size == state.left ? 1.0f : 0.0f);
    }
    for (int k = 0; k < plan->octaves; k++) {
        const struct scarp_octave *const o = &plan->octave[k];
        const double f = plan->fractal == SCARP_SWISS ? first->frequency64 : o->frequency64;
        at->inverse = (float)(1.0 / o->frequency64);
        at->weight = o->weight;
        at->inverse_weight = (float)(1.0 / (double)first->weight);
        at->reach = (float)((double)plan->sharpness / f);
        at->is_first = k == 0;
        if (k == 0) {
            positions_of_input(w, chunk);
        } else {
            bend_positions(w, chunk, at, state);
        }
        one.octave = o;
        one.first = k;
        points_within(&one, at->blocks * VEC_LANES, position, at->noise, w->f, w->passes);
        pass(at);
    }
}

/* Computes points of a fractal that bends. */
static __attribute__((noinline)) void bend_points(const struct scarp_call_plan *plan, size_t count,
                                                  const void *const position[3],
                                                  const struct scarp_outputs *out, struct frame f,
                                                  struct workspace work)
{
    const size_t size = sample_size(f.dimensions, plan->order + 1);
    const struct bend_state state = bend_state_of(f.dimensions, plan->order);
    struct chunked w = {.source = {position, NULL}, .f = f};
    struct scarp_outputs noise;
    struct bending at = {.noise = &noise, .erosion = plan->erosion};
    struct outputs sums;
    float *from = chunked_begin(&w, work, size + state.size + 1);
    take_arrays(&noise, &from, w.most, f.dimensions, plan->order + 1);
    w.spare = from;
    at.state = (vf *)(from + w.most);
    chunked_end(&w, work, (float *)(at.state + w.most / VEC_LANES * state.size));
    outputs_stored(&sums, at.state, state.size, f.dimensions, plan->order, 0);
    for (size_t first = 0; first < count; first += w.most) {
        const struct chunk chunk = {{first, 0, 0}, least(count - first, w.most), 1};
        bend_chunk(&w, plan, &chunk, &at);
        copy_out(out, first, &sums, 0, chunk.columns);
    }
}

#endif
