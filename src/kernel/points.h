/* SPDX-License-Identifier: MIT
 *
 * Points: blocks of VEC_LANES of them, all octaves of a block in registers. Included by table.h.
 *
 * points_run is written once and instantiated for every combination of dimensions, basis, highest
 * derivative and precision of the coordinates, so that nothing which was not asked for is computed.
 * Fade and turned axes are branches on constants of the call.
 */
#ifndef SCARP_KERNEL_POINTS_H
#define SCARP_KERNEL_POINTS_H

#include <string.h>

#include "../kernels.h"
#include "fractal.h"
#include "gradient.h"
#include "value.h"

VEC_INLINE void load_doubles(const void *array, size_t i, vd *low, vd *high)
{
    const double *const p = (const double *)array + i;
    *low = vd_load(p);
    *high = vd_load(p + VEC_LANES / 2);
}

VEC_INLINE struct block load_block(const void *const position[3], size_t i, int dimensions,
                                   int doubles)
{
    struct block b;
    if (doubles) {
        load_doubles(position[0], i, &b.x0, &b.x1);
        load_doubles(position[1], i, &b.y0, &b.y1);
        if (dimensions == 3) {
            load_doubles(position[2], i, &b.z0, &b.z1);
        }
    } else {
        b.x = vf_load((const float *)position[0] + i);
        b.y = vf_load((const float *)position[1] + i);
        if (dimensions == 3) {
            b.z = vf_load((const float *)position[2] + i);
        }
    }
    return b;
}

VEC_INLINE void store_wanted(float *array, size_t i, vf v)
{
    if (array != NULL) {
        vf_store(array + i, v);
    }
}

VEC_INLINE void store_block(const struct scarp_samples *out, size_t i, const struct sample *s,
                            int dimensions, int order)
{
    store_wanted(out->value, i, s->value);
    if (order >= 1) {
        store_wanted(out->dx, i, s->dx);
        store_wanted(out->dy, i, s->dy);
        if (dimensions == 3) {
            store_wanted(out->dz, i, s->dz);
        }
    }
    if (order >= 2) {
        store_wanted(out->dxx, i, s->dxx);
        store_wanted(out->dxy, i, s->dxy);
        store_wanted(out->dyy, i, s->dyy);
        if (dimensions == 3) {
            store_wanted(out->dxz, i, s->dxz);
            store_wanted(out->dyz, i, s->dyz);
            store_wanted(out->dzz, i, s->dzz);
        }
    }
}

VEC_INLINE struct sample basis_at(const struct scarp_octave *o, const struct place *p,
                                  enum scarp_fade fade_kind, enum scarp_basis basis, int dimensions,
                                  int order)
{
    if (basis == SCARP_GRADIENT) {
        return dimensions == 2 ? gradient2(o, p, fade_kind, order)
                               : gradient3(o, p, fade_kind, order);
    }
    return dimensions == 2 ? value2(o, p, fade_kind, order) : value3(o, p, fade_kind, order);
}

/* sum += octave. `turned` says whether the octave's axes are. */
VEC_INLINE void add_octave(struct sample *sum, const struct scarp_plan *plan, int k, int turned,
                           const struct block *b, int dimensions, enum scarp_basis basis, int order,
                           int doubles)
{
    const struct scarp_octave *const o = &plan->octave[k];
    const struct place p = turned ? place_turned(o, b, dimensions, doubles)
                                  : place_straight(o, b, dimensions, doubles);
    const struct sample n = basis_at(o, &p, plan->fade, basis, dimensions, order);
    sum->value += vf_set(o->amplitude) * n.value;
    if (turned) {
        add_turned(sum, o, &n, dimensions, order);
    } else {
        add_straight(sum, o, &n, dimensions, order);
    }
}

/*
 * `count` is a multiple of VEC_LANES. The first octave is never turned. It stands outside the loop
 * because that lets the sum of a single octave stay in registers: 10 to 20 % on every ISA.
 */
VEC_INLINE void points_run(const struct scarp_plan *plan, size_t count,
                           const void *const position[3], const struct scarp_samples *out,
                           int dimensions, enum scarp_basis basis, int order, int doubles)
{
    const vf zero = vf_set(0.0f);
    for (size_t i = 0; i < count; i += VEC_LANES) {
        const struct block b = load_block(position, i, dimensions, doubles);
        struct sample sum = {zero, zero, zero, zero, zero, zero, zero, zero, zero, zero};
        add_octave(&sum, plan, 0, 0, &b, dimensions, basis, order, doubles);
        for (int k = 1; k < plan->octaves; k++) {
            add_octave(&sum, plan, k, plan->rotate, &b, dimensions, basis, order, doubles);
        }
        store_block(out, i, &sum, dimensions, order);
    }
}

#define POINTS(name, dimensions, basis, order, doubles)                                            \
    static void name(const struct scarp_plan *plan, size_t count, const void *const position[3],   \
                     const struct scarp_samples *out)                                              \
    {                                                                                              \
        points_run(plan, count, position, out, dimensions, basis, order, doubles);                 \
    }

/* All instances of one entry of the kernel table, by [basis][order], and the entry. */
#define POINTS_ENTRY(name, dimensions, doubles)                                                    \
    POINTS(name##_gradient_0, dimensions, SCARP_GRADIENT, 0, doubles)                              \
    POINTS(name##_gradient_1, dimensions, SCARP_GRADIENT, 1, doubles)                              \
    POINTS(name##_gradient_2, dimensions, SCARP_GRADIENT, 2, doubles)                              \
    POINTS(name##_value_0, dimensions, SCARP_VALUE, 0, doubles)                                    \
    POINTS(name##_value_1, dimensions, SCARP_VALUE, 1, doubles)                                    \
    POINTS(name##_value_2, dimensions, SCARP_VALUE, 2, doubles)                                    \
    static void name(const struct scarp_plan *plan, size_t count, const void *const position[3],   \
                     const struct scarp_samples *out)                                              \
    {                                                                                              \
        static scarp_points_fn *const instances[2][3] = {                                          \
            {name##_gradient_0, name##_gradient_1, name##_gradient_2},                             \
            {name##_value_0, name##_value_1, name##_value_2},                                      \
        };                                                                                         \
        points_all(instances[plan->basis][plan->order], plan, count, position, out, dimensions,    \
                   (doubles) ? sizeof(double) : sizeof(float));                                    \
    }

/* The last, incomplete block: through padded copies, so that nothing beyond an array is touched.
   The padding is 0, which no exception flag notices. */
static void points_tail(scarp_points_fn *run, const struct scarp_plan *plan, size_t first,
                        size_t count, const void *const position[3],
                        const struct scarp_samples *out, int dimensions, size_t bytes)
{
    float results[10][VEC_LANES];
    double padded[3][VEC_LANES] = {{0}};
    const void *inputs[3] = {NULL, NULL, NULL};
    for (int d = 0; d < dimensions; d++) {
        memcpy(padded[d], (const char *)position[d] + first * bytes, count * bytes);
        inputs[d] = padded[d];
    }
    const struct scarp_samples local = {results[0], results[1], results[2], results[3], results[4],
                                        results[5], results[6], results[7], results[8], results[9]};
    run(plan, VEC_LANES, inputs, &local);
    float *const arrays[10] = {out->value, out->dx,  out->dy,  out->dz,  out->dxx,
                               out->dxy,   out->dxz, out->dyy, out->dyz, out->dzz};
    for (int member = 0; member < 10; member++) {
        if (arrays[member] != NULL) {
            memcpy(arrays[member] + first, results[member], count * sizeof(float));
        }
    }
}

static void points_all(scarp_points_fn *run, const struct scarp_plan *plan, size_t count,
                       const void *const position[3], const struct scarp_samples *out,
                       int dimensions, size_t bytes)
{
    const size_t tail = count % VEC_LANES;
    if (count != tail) {
        run(plan, count - tail, position, out);
    }
    if (tail != 0) {
        points_tail(run, plan, count - tail, tail, position, out, dimensions, bytes);
    }
}

POINTS_ENTRY(points2_f32, 2, 0)
POINTS_ENTRY(points2_f64, 2, 1)
POINTS_ENTRY(points3_f32, 3, 0)
POINTS_ENTRY(points3_f64, 3, 1)

#undef POINTS
#undef POINTS_ENTRY

#endif
