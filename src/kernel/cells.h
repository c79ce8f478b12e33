/* SPDX-License-Identifier: MIT
 *
 * What scarp_cells2 and its like give: the features that are nearest to points.
 */
#ifndef SCARP_KERNEL_CELLS_H
#define SCARP_KERNEL_CELLS_H

#include "../dispatch/kernels.h"
#include "basis/cells.h"

/* How many blocks are located at once. */
#define CELLS_BLOCKS 16

/* What all points of a call share; `unit` is a cell in units of input. */
struct cells_call {
    const struct scarp_octave *octave;
    const struct scarp_cell_arrays *out;
    double unit;
    int doubles;
};

/* Which of the outputs from `first` on, one per axis, are asked for. */
VEC_INLINE int asks_for(const struct cells_call *call, int first, int dimensions)
{
    int asked = 0;
    for (int i = first; i < first + dimensions; i++) {
        asked |= call->out->array[i] != NULL;
    }
    return asked;
}

/* Where the nearest feature is along an axis: x - d, in the precision of the coordinates x, which
   are at `x`. */
VEC_INLINE vf feature_position(const struct cells_call *call, const void *x, vf d)
{
    if (!call->doubles) {
        return vf_load((const float *)x) - d * vf_set((float)call->unit);
    }
    const vd unit = vd_set(call->unit);
    return vf_from_vd(vd_load((const double *)x) - vd_from_low(d) * unit,
                      vd_load((const double *)x + VEC_LANES / 2) - vd_from_high(d) * unit);
}

VEC_INLINE void cells_gradient(vf *to, vf square, const vf d[3], int dimensions)
{
    const struct variant v = {SCARP_CELL_F1, dimensions, 1, 0};
    const struct sample s = distance_to(square, d, v);
    to[0] = s.dx;
    to[1] = s.dy;
    if (dimensions == 3) {
        to[2] = s.dz;
    }
}

/* Searches at a block, whose coordinates are at `x`, and puts what is asked for into its arrays,
   from point `first` on: `count` points, of which the arrays of coordinates may have more. */
VEC_INLINE void cells_block(const struct cells_call *call, const vf *location,
                            const void *const x[3], size_t first, size_t count,
                            struct search search)
{
    const struct found found = cells_search(location, call->octave, search);
    const vf unit = vf_set((float)call->unit);
    vf of[CELLS_OUTPUTS];
    for (int i = 0; i < CELLS_OUTPUTS; i++) {
        of[i] = vf_set(0.0f);
    }
    of[CELLS_F1] = vf_sqrt(found.s[0]) * unit;
    if (search.cells) { /* the id of a NaN is 0 */
        const vm is_number = vm_less(found.s[0], vf_set(FAR_AWAY));
        of[CELLS_ID] = (vf)vm_keep(is_number, (vu)found.hash * FEATURE_ID);
    }
    if (search.steps) {
        for (int i = 0; i < search.dimensions; i++) {
            of[CELLS_X + i] = feature_position(call, x[i], found.d[0][i]);
        }
        if (asks_for(call, CELLS_DX1, search.dimensions)) {
            cells_gradient(of + CELLS_DX1, found.s[0], found.d[0], search.dimensions);
        }
    }
    if (search.second) {
        of[CELLS_F2] = vf_sqrt(found.s[1]) * unit;
        if (asks_for(call, CELLS_DX2, search.dimensions)) {
            cells_gradient(of + CELLS_DX2, found.s[1], found.d[1], search.dimensions);
        }
    }
    const int outputs = search.second ? CELLS_OUTPUTS : search.steps ? CELLS_DX2 : CELLS_F2;
    VEC_ROLLED_LOOP
    for (int i = 0; i < outputs; i++) {
        float *const array = call->out->array[i];
        if (array != NULL && count == VEC_LANES) {
            vf_store(array + first, of[i]);
        } else if (array != NULL) {
            vf_store_partial(array + first, of[i], count);
        }
    }
}

/* Searches at `count` points from `first` on, at most CELLS_BLOCKS whole blocks, or at less than
   one. Outputs may be where coordinates are: those of a block are read before anything is written
   there. */
VEC_INLINE void cells_blocks(const struct cells_call *call, const vf *location, size_t first,
                             size_t count, const void *const x[3], struct search search)
{
    const size_t bytes = call->doubles ? sizeof(double) : sizeof(float);
    for (size_t i = 0; i < count; i += VEC_LANES) {
        const void *at[3] = {NULL, NULL, NULL};
        for (int axis = 0; axis < search.dimensions; axis++) {
            at[axis] = (const char *)x[axis] + i * bytes;
        }
        cells_block(call, location, at, first + i, count < VEC_LANES ? count : VEC_LANES, search);
        location += unhashed_size(search.dimensions);
    }
}

typedef void cells_pass(const struct cells_call *call, const vf *location, size_t first,
                        size_t count, const void *const x[3]);

/* Passes that give only F1; all of the nearest feature; all of both. */
#define CELLS_PASS(name, dimensions, ...)                                                          \
    static void name(const struct cells_call *call, const vf *location, size_t first,              \
                     size_t count, const void *const x[3])                                         \
    {                                                                                              \
        const struct search search = {dimensions, __VA_ARGS__};                                    \
        cells_blocks(call, location, first, count, x, search);                                     \
    }

CELLS_PASS(cells2_f1, 2, 0, 0, 0)
CELLS_PASS(cells2_first, 2, 0, 1, 1)
CELLS_PASS(cells2_both, 2, 1, 1, 1)
CELLS_PASS(cells3_f1, 3, 0, 0, 0)
CELLS_PASS(cells3_first, 3, 0, 1, 1)
CELLS_PASS(cells3_both, 3, 1, 1, 1)

#undef CELLS_PASS

/* The pass that gives what is asked for; NULL if that is nothing. */
static cells_pass *cells_pass_of(const struct scarp_cell_arrays *out, int dimensions)
{
    static cells_pass *const passes[2][3] = {{cells2_f1, cells2_first, cells2_both},
                                             {cells3_f1, cells3_first, cells3_both}};
    int kind = out->array[CELLS_F1] != NULL ? 0 : -1;
    for (int i = CELLS_ID; i < CELLS_DX2; i++) {
        kind = out->array[i] != NULL ? 1 : kind;
    }
    for (int i = CELLS_DX2; i < CELLS_OUTPUTS; i++) {
        kind = out->array[i] != NULL ? 2 : kind;
    }
    kind = out->array[CELLS_F2] != NULL ? 2 : kind;
    return kind < 0 ? NULL : passes[dimensions - 2][kind];
}

static void cells(const struct scarp_call_plan *plan, size_t count, const void *const position[3],
                  const struct scarp_cell_arrays *out, int dimensions, int doubles)
{
    const struct scarp_octave *const o = plan->octave;
    const struct cells_call call = {o, out, 1.0 / o->frequency64, doubles};
    const struct frame frame = {doubles ? DOUBLES : FLOATS, axes_of(plan, 0), dimensions};
    const size_t bytes = doubles ? sizeof(double) : sizeof(float);
    cells_pass *const pass = cells_pass_of(out, dimensions);
    vf location[CELLS_BLOCKS * UNHASHED_SIZE(3)];
    for (size_t first = 0, here; pass != NULL && first < count; first += here) {
        double padded[3][VEC_LANES]; /* nothing beyond an array is touched; 0 does no harm */
        struct positions at;
        here = count - first < CELLS_BLOCKS * VEC_LANES ? count - first : CELLS_BLOCKS * VEC_LANES;
        here = here < VEC_LANES ? here : here - here % VEC_LANES;
        for (int axis = 0; axis < dimensions; axis++) {
            at.array[axis] = (const char *)position[axis] + first * bytes;
            if (here < VEC_LANES) {
                memset(padded[axis], 0, sizeof padded[axis]);
                memcpy(padded[axis], at.array[axis], here * bytes);
                at.array[axis] = padded[axis];
            }
        }
        unhashed_row(location, o, here < VEC_LANES ? 1 : here / VEC_LANES, &at, frame);
        pass(&call, location, first, here, at.array);
    }
}

#endif
