/* SPDX-License-Identifier: MIT
 *
 * The public functions that give the cells of cellular noise.
 */
#include "../plan/suprema.h"
#include "run.h"
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
static int asks_too_much(const void *arrays, int dimensions)
{
    const struct scarp_cells *const out = arrays;
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

static struct scarp_request request_of(const void *out, int dimensions)
{
    (void)out;
    return (struct scarp_request){.dimensions = dimensions};
}

/* Runs the kernel with a plan of the first octave only. */
static void run(const struct scarp_call_plan *plan, const void *opaque)
{
    const struct scarp_arguments *const call = opaque;
    struct scarp_octave first =
        plan->warps.depth > 0 ? *scarpi_component_plan(plan, 0, 0).octave : *plan->octave;
    /* The lattice is made of cells, whatever the basis is. */
    first.jitter = scarpi_stray(call->noise);
    first.stretch = 1.0;
    const struct scarp_call_plan cells = {
        .basis = SCARP_CELL_F1,
        .octaves = 1,
        .repeat = repeat_of_octave(&first, call->at->dimensions),
        .octave = &first,
    };
    call->kernels->cells(&cells, call->at->count, call->at->position, arrays_of(call->out),
                         call->at->dimensions, call->at->doubles);
}

static const struct scarp_computation cells_computation = {asks_too_much, request_of, run};

enum scarp_status scarp_cells2(const struct scarp_noise *noise, size_t count, const float *x,
                               const float *y, const struct scarp_cells *out)
{
    const struct scarp_at at = {count, {x, y, NULL}, 2, 0};
    return scarpi_run_at_points(&cells_computation, noise, &at, out);
}

enum scarp_status scarp_cells3(const struct scarp_noise *noise, size_t count, const float *x,
                               const float *y, const float *z, const struct scarp_cells *out)
{
    const struct scarp_at at = {count, {x, y, z}, 3, 0};
    return scarpi_run_at_points(&cells_computation, noise, &at, out);
}

enum scarp_status scarp_cells2_f64(const struct scarp_noise *noise, size_t count, const double *x,
                                   const double *y, const struct scarp_cells *out)
{
    const struct scarp_at at = {count, {x, y, NULL}, 2, 1};
    return scarpi_run_at_points(&cells_computation, noise, &at, out);
}

enum scarp_status scarp_cells3_f64(const struct scarp_noise *noise, size_t count, const double *x,
                                   const double *y, const double *z, const struct scarp_cells *out)
{
    const struct scarp_at at = {count, {x, y, z}, 3, 1};
    return scarpi_run_at_points(&cells_computation, noise, &at, out);
}
