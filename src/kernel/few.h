/* SPDX-License-Identifier: MIT
 *
 * Evaluates few points, and the remainder of many. One block at a time goes through all stages and
 * all octaves in registers. Passes over tiles (driver.h) do more per second, but take longer to
 * begin than a block takes here.
 *
 * There are three passes: values of a single octave, without any loop; values of fBm with straight
 * axes; and everything else but Hessians, gradients of erosion, periods and flow. Those take the
 * passes over tiles.
 */
#ifndef SCARP_KERNEL_FEW_H
#define SCARP_KERNEL_FEW_H

#include "driver.h"

/* The most blocks that take less time here than in passes: with 4, values of eight octaves take 5
   to 15 % more, and only gradients in SSE4.1 take less, by 10 %. */
#define FEW_BLOCKS 2

/* The highest derivative that is served. A set that a narrower one relieves of few points may have
   less. */
#ifndef FEW_ORDER
#define FEW_ORDER 1
#endif

/* The coordinates of a block along all axes: floats, or doubles in two halves. The member that is
   not used has the same bits. */
struct few_block {
    vf f32[3];
    vd low[3], high[3];
};

/* Loads `count` coordinates, at most a block. Where they are less, some are repeated: lanes without
   a point raise no floating-point exception of their own, and nothing beyond the arrays is read. */
VEC_INLINE vf few_load_f32(const float *x, size_t count)
{
    return count == VEC_LANES ? vf_load(x) : vf_load_partial(x, count);
}

VEC_INLINE void few_load_f64(const double *x, size_t count, vd *low, vd *high)
{
    if (count <= VEC_LANES / 2) {
        *low = vd_load_partial(x, count);
        *high = *low;
    } else {
        *low = vd_load(x);
        *high = vd_load_partial(x + VEC_LANES / 2, count - VEC_LANES / 2);
    }
}

/* Fills x in. gcc would copy a result through memory. */
VEC_INLINE void few_load(struct few_block *x, const void *const position[3], size_t first,
                         size_t count, struct frame f)
{
    for (int d = 0; d < f.dimensions; d++) {
        if (f.layout == DOUBLES) {
            few_load_f64((const double *)position[d] + first, count, &x->low[d], &x->high[d]);
            x->f32[d] = (vf)x->low[d];
        } else {
            x->f32[d] = few_load_f32((const float *)position[d] + first, count);
            x->low[d] = x->high[d] = (vd)x->f32[d];
        }
    }
}

/* Shared by the passes of a small set. */
static __attribute__((noinline)) void few_load_shared(struct few_block *x,
                                                      const void *const position[3], size_t first,
                                                      size_t count, struct frame f)
{
    few_load(x, position, first, count, f);
}

/* The cell and the fraction of a block along one axis of an octave. */
VEC_INLINE struct split few_split(const struct scarp_octave *o, int axis, const struct few_block *x,
                                  struct frame f)
{
    const int is_turned = f.axes == AXES_TURNED;
    if (f.layout == FLOATS) {
        return split_f32(is_turned ? turned_f32(o, axis, x->f32, f)
                                   : straight_f32(o, axis, x->f32[axis], f));
    }
    return is_turned ? split_turned_f64(o, axis, 1.0, x->low, x->high, f)
                     : split_f64(straight_f64(o, axis, x->low[axis], f),
                                 straight_f64(o, axis, x->high[axis], f));
}

/* The basis of an octave at a block. */
VEC_INLINE struct sample few_basis(const struct scarp_octave *o, enum scarp_fade fade,
                                   const struct few_block *x, struct frame f, struct variant v)
{
    vf lattice[LATTICE_SIZE3];
    struct split s[3];
    for (int d = 0; d < f.dimensions; d++) {
        s[d] = few_split(o, d, x, f);
    }
    const struct mixed m = lattice_put_fractions(lattice, o, s, AXES_STRAIGHT, f.dimensions);
    lattice_put_corners(lattice, &m, f.dimensions, corner_form_of(v.basis));
    return basis_sample(lattice, fade, NULL, v);
}

/* What goes from octave to octave: the weight of ridged and hybrid noise, the slope d of erosion.
 */
struct few_state {
    struct sample weight;
    vf d[3];
};

/* Returns what the fractal adds for the octave n, which is in the axes of the input and has its
   amplitude. The order of v is 1 for erosion, whose n is in the axes of the octave. */
VEC_INLINE struct sample few_fractal(struct few_state *state, const struct scarp_call_plan *plan,
                                     const struct scarp_octave *o, const struct sample *n,
                                     struct variant v)
{
    struct sample s = *n;
    struct fold fold;
    float slope = o->weight;
    switch (plan->fractal) {
    case SCARP_FBM: return s;
    case SCARP_TURBULENCE:
    case SCARP_PINGPONG:
        fold = fold_of(plan, n->value);
        s = folded(n, &fold, v);
        slope = fold_weight(plan, slope);
        break;
    case SCARP_RIDGED:
    case SCARP_HYBRID:
        s = weighted(o, n, &state->weight, plan->sharpness, plan->fractal == SCARP_HYBRID, v);
        break;
    case SCARP_EROSION:
        if (v.order == 1) {
            const struct variant value = {v.basis, v.dimensions, 0, 0};
            struct eroded e = {.n = *n};
            s.value = erode(&e, state->d, plan->erosion, value).value;
        }
        break;
    case SCARP_SWISS:
    case SCARP_JORDAN: break; /* bend.h */
    }
#define WEIGH(i, member, rank) s.member *= vf_set(rank == 0 ? o->weight : slope)
    EACH_OUTPUT(v, WEIGH);
#undef WEIGH
    return s;
}

/* Adds up the octaves at a block; see add_shaped() of driver.h. The sum begins with -0, which
   changes nothing that it is added to. */
VEC_INLINE struct sample few_sum(const struct scarp_call_plan *plan, const struct few_block *x,
                                 struct frame f, struct variant v)
{
    const int octave_axes = plan->fractal == SCARP_EROSION;
    struct few_state state = {.d = {vf_set(0.0f), vf_set(0.0f), vf_set(0.0f)}};
    struct sample sum;
#define BEGIN(i, member, rank)                                                                     \
    sum.member = vf_set(-0.0f), state.weight.member = vf_set(rank == 0 ? 1.0f : 0.0f)
#define TIMES(i, member, rank) n.member *= vf_set(factor[rank])
#define ADD(i, member, rank) sum.member += s.member
    EACH_OUTPUT(v, BEGIN);
    for (int k = 0; k < plan->octaves; k++) {
        const struct scarp_octave *const o = &plan->octave[k];
        const int is_turned = k + plan->first > 0 && plan->rotate;
        f.axes = is_turned ? AXES_TURNED : AXES_STRAIGHT;
        struct sample n = few_basis(o, plan->fade, x, f, v);
        if (v.order > 0 && is_turned && !octave_axes) {
            n = turned(o, &n, v);
        } else {
            const float factor[3] = {o->amplitude, octave_axes ? o->amplitude : o->slope,
                                     o->curvature};
            EACH_OUTPUT(v, TIMES);
        }
        const struct sample s = few_fractal(&state, plan, o, &n, v);
        EACH_OUTPUT(v, ADD);
    }
#undef BEGIN
#undef TIMES
#undef ADD
    return sum;
}

VEC_INLINE void few_put(const struct scarp_outputs *out, size_t first, size_t count,
                        const struct sample *sum, struct variant v)
{
#define PUT(i, member, rank)                                                                       \
    do {                                                                                           \
        if (out->array[i] != NULL && count == VEC_LANES) {                                         \
            vf_store(out->array[i] + first, sum->member);                                          \
        } else if (out->array[i] != NULL) {                                                        \
            vf_store_partial(out->array[i] + first, sum->member, count);                           \
        }                                                                                          \
    } while (0)
    EACH_OUTPUT(v, PUT);
#undef PUT
}

/* The points from `first` to before `end` of some arrays. */
struct few_points {
    const void *const *position;
    size_t first, end;
    enum layout layout;
};

VEC_INLINE void few_any(const struct scarp_call_plan *plan, const struct few_points *points,
                        const struct scarp_outputs *out, struct variant v)
{
    const struct frame f = {points->layout, AXES_STRAIGHT, v.dimensions};
    size_t first = points->first;
    do {
        const size_t count = least(points->end - first, VEC_LANES);
        struct few_block x;
        if (VEC_SMALL) {
            few_load_shared(&x, points->position, first, count, f);
        } else {
            few_load(&x, points->position, first, count, f);
        }
        const struct sample sum = few_sum(plan, &x, f, v);
        few_put(out, first, count, &sum, v);
        first += count;
    } while (first < points->end);
}

/* Computes the values of a single octave at a block of floats, or at less. With no loop to keep
   constants for, there is nothing to spill: one point takes a quarter less time. */
VEC_INLINE void few_one(const struct scarp_call_plan *plan, const struct few_points *points,
                        const struct scarp_outputs *out, struct variant v)
{
    const struct frame f = {FLOATS, AXES_STRAIGHT, v.dimensions};
    const size_t count = points->end - points->first;
    struct few_block x;
    few_load(&x, points->position, points->first, count, f);
    const struct scarp_octave *const o = plan->octave;
    struct sample n = few_basis(o, plan->fade, &x, f, v);
    n.value *= vf_set(o->amplitude);
    few_put(out, points->first, count, &n, v);
}

/* Computes the points from `first` to before `end`. */
typedef void few_pass(const struct scarp_call_plan *plan, size_t end, const void *const position[3],
                      const struct scarp_outputs *out, size_t first, enum layout layout);

#define FEW_PASS(name, run, basis, dimensions, order)                                              \
    static void name(const struct scarp_call_plan *plan, size_t end,                               \
                     const void *const position[3], const struct scarp_outputs *out, size_t first, \
                     enum layout layout)                                                           \
    {                                                                                              \
        const struct few_points points = {position, first, end, layout};                           \
        const struct variant v = {basis, dimensions, order, 0};                                    \
        run(plan, &points, out, v);                                                                \
    }

/* Which pass: for values of one octave at a block of floats, for all other values, for gradients.
   A set that serves no gradients does not serve one point either. */
enum few_kind { FEW_VALUE, FEW_GRADIENT, FEW_ONE, FEW_KINDS };

#if FEW_ORDER == 0
#define FEW_PASSES(name, basis, d) FEW_PASS(name##d##_few_value, few_any, basis, d, 0)
#define FEW_NAMES(name, d)                                                                         \
    {                                                                                              \
        [FEW_VALUE] = name##d##_few_value, [FEW_ONE] = name##d##_few_value                         \
    }
#elif VEC_SMALL
#define FEW_PASSES(name, basis, d)                                                                 \
    FEW_PASS(name##d##_few_value, few_any, basis, d, 0)                                            \
    FEW_PASS(name##d##_few_gradient, few_any, basis, d, 1)
#define FEW_NAMES(name, d)                                                                         \
    {                                                                                              \
        [FEW_VALUE] = name##d##_few_value, [FEW_GRADIENT] = name##d##_few_gradient,                \
        [FEW_ONE] = name##d##_few_value                                                            \
    }
#else
#define FEW_PASSES(name, basis, d)                                                                 \
    FEW_PASS(name##d##_few_value, few_any, basis, d, 0)                                            \
    FEW_PASS(name##d##_few_gradient, few_any, basis, d, 1)                                         \
    FEW_PASS(name##d##_few_one, few_one, basis, d, 0)
#define FEW_NAMES(name, d)                                                                         \
    {                                                                                              \
        [FEW_VALUE] = name##d##_few_value, [FEW_GRADIENT] = name##d##_few_gradient,                \
        [FEW_ONE] = name##d##_few_one                                                              \
    }
#endif

FEW_PASSES(gradient, SCARP_GRADIENT, 2)
FEW_PASSES(gradient, SCARP_GRADIENT, 3)
FEW_PASSES(value, SCARP_VALUE, 2)
FEW_PASSES(value, SCARP_VALUE, 3)

/* By [basis][dimensions - 2]. */
static few_pass *const few_passes[][2][FEW_KINDS] = {
    [SCARP_GRADIENT] = {FEW_NAMES(gradient, 2), FEW_NAMES(gradient, 3)},
    [SCARP_VALUE] = {FEW_NAMES(value, 2), FEW_NAMES(value, 3)},
};

_Static_assert(sizeof few_passes / sizeof few_passes[0] == SCARP_SIMPLEX,
               "each basis that blends corners has its lines");

#undef FEW_PASS
#undef FEW_PASSES
#undef FEW_NAMES

/* Whether the call asks for values of a plain fBm with straight axes. */
static int is_value_sum(const struct scarp_call_plan *plan)
{
    return plan->order == 0 && plan->fractal == SCARP_FBM && !plan->rotate && plan->plain;
}

/* The pass that serves `count` points; NULL if they are too many, or the call is none of a pass
   here. (table.h finds the pass of single octaves.) */
static few_pass *few_pass_of(const struct scarp_call_plan *plan, size_t count, int dimensions)
{
    const int order = plan->order + (plan->fractal == SCARP_EROSION); /* of the basis */
    return count <= FEW_BLOCKS * VEC_LANES && order <= FEW_ORDER && plan->plain
               ? few_passes[plan->basis][dimensions - 2][order]
               : NULL;
}

#endif
