/* SPDX-License-Identifier: MIT
 *
 * The public functions that give the cells of cellular noise. They check the arguments, make the
 * plan and call the active kernel table.
 */
#include <string.h>

#include "../dispatch/dispatch.h"
#include "../dispatch/fpmode.h"
#include "../plan/kept.h"
#include "../plan/plan.h"
#include "../plan/suprema.h"
#include "scarp.h"

_Static_assert(sizeof(struct scarp_cells) == 16 * sizeof(float *) &&
                   sizeof(uint32_t *) == sizeof(float *),
               "struct scarp_cells has 16 pointers");

/* The arrays of `out` as a list. No other place knows them by name. */
static const struct scarp_cell_arrays *arrays_of(const struct scarp_cells *out)
{
#define AT(output, member) (offsetof(struct scarp_cells, member) == (output) * sizeof(float *))
    _Static_assert(AT(CELLS_F1, f1) && AT(CELLS_F2, f2) && AT(CELLS_ID, id) && AT(CELLS_X, x) &&
                       AT(CELLS_Y, y) && AT(CELLS_Z, z) && AT(CELLS_DX1, dx1) &&
                       AT(CELLS_DY1, dy1) && AT(CELLS_DZ1, dz1) && AT(CELLS_DX2, dx2) &&
                       AT(CELLS_DY2, dy2) && AT(CELLS_DZ2, dz2),
                   "the enumerators of outputs.h are in the order of struct scarp_cells");
#undef AT
    return (const struct scarp_cell_arrays *)out;
}

/* Whether something is asked for that does not exist: what is along z in 2D, reserved members. */
static int asks_too_much(const struct scarp_cells *out, int dimensions)
{
    for (size_t i = 0; i < sizeof out->spare / sizeof out->spare[0]; i++) {
        if (out->spare[i] != NULL) {
            return 1;
        }
    }
    return dimensions == 2 && (out->z != NULL || out->dz1 != NULL || out->dz2 != NULL);
}

/* How often the lattice of an octave repeats. */
static enum scarp_repeat repeat_of_octave(const struct scarp_octave *o, int dimensions)
{
    int repeats = 0, powers = 1;
    for (int i = 0; i < dimensions; i++) {
        repeats |= o->last[i] != UINT32_MAX;
        powers &= (o->last[i] & (o->last[i] + 1)) == 0;
    }
    return !repeats ? SCARP_REPEAT_NEVER : powers ? SCARP_REPEAT_POWERS : SCARP_REPEAT_ANY;
}

/* What the points of a call are. */
struct cell_points {
    size_t count;
    const void *position[3];
    int dimensions, doubles;
};

/* Makes the plan, and of it that of the first octave alone; then runs the kernel. This is out of
   line for the same reason as run() in scarp.c. */
static __attribute__((noinline)) enum scarp_status run(const struct scarp_kernels *kernels,
                                                       const struct scarp_noise *noise,
                                                       const struct cell_points *points,
                                                       const struct scarp_cells *out)
{
    const struct scarp_kind values = {.dimensions = points->dimensions};
    struct scarp_call_plan plan;
    struct scarp_octave space[SCARP_MAX_OCTAVES];
    const enum scarp_status status = scarp_plan_call(&plan, space, noise, values);
    if (status != SCARP_OK) {
        return status;
    }
    if (plan.warps.depth > 0) {
        const struct scarp_warps warps = plan.warps;
        scarp_plan_level(&plan, &warps, values, 0, 0);
    }
    struct scarp_octave first = plan.octave[0];
    /* The lattice is made of cells, whatever the basis is. */
    first.jitter = scarp_stray(noise);
    first.stretch = 1.0;
    plan.basis = SCARP_CELL_F1;
    plan.octave = &first;
    plan.repeat = repeat_of_octave(&first, points->dimensions);
    kernels->cells(&plan, points->count, points->position, arrays_of(out), points->dimensions,
                   points->doubles);
    return SCARP_OK;
}

static enum scarp_status find_cells(const struct scarp_noise *noise,
                                    const struct cell_points *points, const struct scarp_cells *out)
{
    if (points->count == 0) {
        return SCARP_OK;
    }
    if (noise == NULL || out == NULL) {
        return SCARP_ERROR_NULL;
    }
    for (int i = 0; i < points->dimensions; i++) {
        if (points->position[i] == NULL) {
            return SCARP_ERROR_NULL;
        }
    }
    if (points->count > PTRDIFF_MAX / (points->doubles ? sizeof(double) : sizeof(float))) {
        return SCARP_ERROR_SIZE;
    }
    if (asks_too_much(out, points->dimensions)) {
        return SCARP_ERROR_UNSUPPORTED;
    }
    const struct fpmode caller = fpmode_enter();
    const enum scarp_status status = run(scarp_dispatch_for(points->count), noise, points, out);
    fpmode_leave(caller);
    return status;
}

enum scarp_status scarp_cells2(const struct scarp_noise *noise, size_t count, const float *x,
                               const float *y, const struct scarp_cells *out)
{
    const struct cell_points points = {count, {x, y, NULL}, 2, 0};
    return find_cells(noise, &points, out);
}

enum scarp_status scarp_cells3(const struct scarp_noise *noise, size_t count, const float *x,
                               const float *y, const float *z, const struct scarp_cells *out)
{
    const struct cell_points points = {count, {x, y, z}, 3, 0};
    return find_cells(noise, &points, out);
}

enum scarp_status scarp_cells2_f64(const struct scarp_noise *noise, size_t count, const double *x,
                                   const double *y, const struct scarp_cells *out)
{
    const struct cell_points points = {count, {x, y, NULL}, 2, 1};
    return find_cells(noise, &points, out);
}

enum scarp_status scarp_cells3_f64(const struct scarp_noise *noise, size_t count, const double *x,
                                   const double *y, const double *z, const struct scarp_cells *out)
{
    const struct cell_points points = {count, {x, y, z}, 3, 1};
    return find_cells(noise, &points, out);
}
