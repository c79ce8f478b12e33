/* SPDX-License-Identifier: MIT
 *
 * Declares the type of a kernel table, and the table of each instruction set. dispatch.c chooses
 * the active one; public functions call through it.
 */
#ifndef SCARP_KERNELS_H
#define SCARP_KERNELS_H

#include "../plan/call.h"
#include "../plan/chain.h"
#include "../plan/gully.h"
#include "../plan/outputs.h"
#include "isas.h"

/* Evaluates `count` > 0 points. `position` holds one array per dimension, floats or doubles as the
   table's member says; outputs in `out` above plan->order, and along z in 2D, are NULL. */
typedef void scarpi_points_fn(const struct scarp_call_plan *plan, size_t count,
                              const void *const position[3], const struct scarp_outputs *out);

/* Evaluates a grid without a count of 0, whose strides are filled in; `out` is as above. */
typedef void scarpi_grid_fn(const struct scarp_call_plan *plan, const struct scarp_grid *grid,
                            const struct scarp_outputs *out);

/* The kernel of scarp_normals, for `count` > 0: computes nx, ny, nz from the slopes dx, dy. */
typedef void scarpi_normals_fn(size_t count, const float *const slope[2], float height_scale,
                               float *const normal[3]);

/* The kernel of scarp_cells2 and its like, for `count` > 0 points, with octave 0 of the plan.
   `doubles` says what `position` has; arrays along z are NULL in 2D. */
typedef void scarpi_cells_fn(const struct scarp_call_plan *plan, size_t count,
                             const void *const position[3], const struct scarp_cell_arrays *out,
                             int dimensions, int doubles);

/* Computes the outputs of a function of samples, one or more, at `count` > 0 points. */
typedef void scarpi_chain_fn(const struct scarp_chain *call, size_t count);

/* The kernel of scarp_vector2 and its like, for `count` > 0 points, with the plan of vector noise.
   `out` has the outputs of each component, which are as above. */
typedef void scarpi_components_fn(const struct scarp_call_plan *plan, size_t count,
                                  const void *const position[3],
                                  const struct scarp_outputs *const out[3], int dimensions,
                                  int doubles);

/* The kernel of scarp_curl2 and its like, for `count` > 0 points, with the plan of potentials.
   `doubles` says what `position` has; arrays along z are NULL in 2D, the Jacobian where the plan's
   order is 1. */
typedef void scarpi_curl_fn(const struct scarp_call_plan *plan, size_t count,
                            const void *const position[3], const struct scarp_flow_arrays *out,
                            int dimensions, int doubles);

/* Computes gullies of at least one point; `plan` is that of their lattice. */
typedef void scarpi_gullies_fn(const struct scarp_gully_call *call,
                               const struct scarp_call_plan *plan);

/* Says whether the compiler kept to the operations of the kernels (exact.h). */
typedef int scarpi_exact_fn(void);

struct scarp_kernels {
    enum scarp_isa isa;
    scarpi_exact_fn *is_exact;
    /* Serves calls of at most `narrower_most` points in less time; NULL, 0: no other table does. */
    const struct scarp_kernels *narrower;
    size_t narrower_most;
    scarpi_points_fn *points2_f32, *points2_f64;
    scarpi_points_fn *points3_f32, *points3_f64;
    scarpi_grid_fn *grid2, *grid3;
    scarpi_normals_fn *normals;
    scarpi_cells_fn *cells;
    scarpi_chain_fn *chain;
    scarpi_components_fn *components;
    scarpi_curl_fn *curl;
    scarpi_gullies_fn *gullies;
};

/* Declared everywhere, defined where isas.h says so. */
#define SCARP_DECLARE(ISA, table, name, here)                                                      \
    extern const struct scarp_kernels scarpi_kernels_##table;
SCARP_ISA_LIST(SCARP_DECLARE)
#undef SCARP_DECLARE

#endif
