/* SPDX-License-Identifier: MIT
 *
 * Evaluates few points, and the remainder of many: a block at a time goes through all stages and
 * all octaves in registers. Passes over whole parts (driver.h) do more per second, but what they
 * need to begin takes longer than a block. Included by points.h.
 *
 * It serves the value and the gradient of fBm with straight axes; all else takes the passes.
 */
#ifndef SCARP_KERNEL_FEW_H
#define SCARP_KERNEL_FEW_H

#include "../names.h"
#include "driver.h"

/* The most blocks that take less time here than in passes: with 4, eight octaves take up to
   11 % more (AVX-512), one octave as long. */
#define FEW_BLOCKS 2

/* The highest derivative that is served. A set that a narrower one relieves of few points may have
   less. */
#ifndef FEW_ORDER
#define FEW_ORDER 1
#endif

/* The coordinates of a block, which stay in registers. */
union few_block {
    vf f32;
    vd f64[2];
};

/* Loads the coordinates of `count` points, at most a block. Where they are less, some are repeated:
   lanes without a point raise no floating-point exception of their own, and nothing beyond the
   arrays is read. */
VEC_INLINE union few_block few_load_f32(const float *x, size_t count)
{
    const union few_block block = {.f32 = count == VEC_LANES ? vf_load(x) : vf_load_part(x, count)};
    return block;
}

VEC_INLINE union few_block few_load_f64(const double *x, size_t count)
{
    union few_block block;
    if (count <= VEC_LANES / 2) {
        block.f64[0] = vd_load_part(x, count);
        block.f64[1] = block.f64[0];
    } else {
        block.f64[0] = vd_load(x);
        block.f64[1] = vd_load_part(x + VEC_LANES / 2, count - VEC_LANES / 2);
    }
    return block;
}

/* Adds up the octaves at a block. The sum begins with -0, which changes nothing that it is added
   to. Octave 0 has the offset 0, so that it may be added too. */
VEC_INLINE struct sample few_sum(const struct scarp_call_plan *plan, const struct positions *at,
                                 struct frame f, struct variant v)
{
    struct sample sum;
#define BEGIN(i, member, rank) sum.member = vf_set(-0.0f)
#define ADD(i, member, rank) sum.member += vf_set(factor[rank]) * n.member
    EACH_OUTPUT(v, BEGIN);
    const struct scarp_octave *o = plan->octave;
    for (const struct scarp_octave *const end = o + plan->octaves; o < end; o++) {
        const float factor[3] = {o->amplitude, o->slope, o->curvature};
        struct lattice3 lattice; /* or struct lattice2, which is smaller */
        lattice_run((vf *)&lattice, o, 1, at, f);
        const struct sample n = basis_sample((const vf *)&lattice, plan->fade, v);
        EACH_OUTPUT(v, ADD);
    }
#undef BEGIN
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
            vf_store_part(out->array[i] + first, sum->member, count);                              \
        }                                                                                          \
    } while (0)
    EACH_OUTPUT(v, PUT);
#undef PUT
}

/* Computes the points from `first` to before `end`, whose coordinates are doubles or floats. */
typedef void few_pass(const struct scarp_call_plan *plan, const void *const position[3],
                      const struct scarp_outputs *out, size_t first, size_t end, int doubles);

VEC_INLINE void few_run(const struct scarp_call_plan *plan, const void *const position[3],
                        const struct scarp_outputs *out, size_t first, size_t end, int doubles,
                        struct variant v)
{
    const struct frame f = {doubles ? DOUBLES : FLOATS, AXES_STRAIGHT, v.dimensions};
    while (first < end) {
        const size_t count = least(end - first, VEC_LANES);
        union few_block x[3];
        struct positions at;
        for (int d = 0; d < v.dimensions; d++) {
            x[d] = doubles ? few_load_f64((const double *)position[d] + first, count)
                           : few_load_f32((const float *)position[d] + first, count);
            at.array[d] = &x[d];
        }
        const struct sample sum = few_sum(plan, &at, f, v);
        few_put(out, first, count, &sum, v);
        first += count;
    }
}

/* Values have a pass for floats and one for doubles: `is_double` is a constant. With gradients, the
   choice is made for each block. */
#define FEW_PASS(name, basis, dimensions, order, is_double)                                        \
    static void name(const struct scarp_call_plan *plan, const void *const position[3],            \
                     const struct scarp_outputs *out, size_t first, size_t end, int doubles)       \
    {                                                                                              \
        const struct variant v = {basis, dimensions, order};                                       \
        (void)doubles;                                                                             \
        few_run(plan, position, out, first, end, is_double, v);                                    \
    }
#define FEW_VALUES(name, basis)                                                                    \
    FEW_PASS(name##2_few_f32, basis, 2, 0, 0)                                                      \
    FEW_PASS(name##2_few_f64, basis, 2, 0, 1)                                                      \
    FEW_PASS(name##3_few_f32, basis, 3, 0, 0)                                                      \
    FEW_PASS(name##3_few_f64, basis, 3, 0, 1)
#if FEW_ORDER == 0
#define FEW_PASSES(name, basis) FEW_VALUES(name, basis)
#define FEW_NAMES(name)                                                                            \
    {                                                                                              \
        {name##2_few_f32, name##2_few_f64}, {name##3_few_f32, name##3_few_f64},                    \
    }
#else
#define FEW_PASSES(name, basis)                                                                    \
    FEW_VALUES(name, basis)                                                                        \
    FEW_PASS(name##2_few_gradient, basis, 2, 1, doubles)                                           \
    FEW_PASS(name##3_few_gradient, basis, 3, 1, doubles)
#define FEW_NAMES(name)                                                                            \
    {                                                                                              \
        {name##2_few_f32, name##2_few_f64, name##2_few_gradient},                                  \
            {name##3_few_f32, name##3_few_f64, name##3_few_gradient},                              \
    }
#endif

FEW_PASSES(gradient, SCARP_GRADIENT)
FEW_PASSES(value, SCARP_VALUE)

/* By [basis][dimensions - 2]: for values at floats and at doubles, and for gradients. */
static few_pass *const few_passes[][2][2 + FEW_ORDER] = {
    [SCARP_GRADIENT] = FEW_NAMES(gradient),
    [SCARP_VALUE] = FEW_NAMES(value),
};

_Static_assert(sizeof few_passes / sizeof few_passes[0] == SCARP_BASES, "each basis has its lines");

#undef FEW_PASS
#undef FEW_VALUES
#undef FEW_PASSES
#undef FEW_NAMES

/* The pass that serves a call with few points, or NULL. */
static few_pass *few_pass_of(const struct scarp_call_plan *plan, int dimensions, enum layout layout)
{
    const int pass = plan->order > 0 ? 2 : layout == DOUBLES;
    return plan->fractal == SCARP_FBM && !plan->rotate && plan->order <= FEW_ORDER &&
                   plan->repeat == SCARP_REPEAT_NEVER
               ? few_passes[plan->basis][dimensions - 2][pass]
               : NULL;
}

#endif
