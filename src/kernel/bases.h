/* SPDX-License-Identifier: MIT
 *
 * The passes that each basis has.
 */
#ifndef SCARP_KERNEL_BASES_H
#define SCARP_KERNEL_BASES_H

#include "fractal/fractal.h"
#include "rows/rows.h"
#if VEC_SMALL
#include "basis/simplex_points.h"
#else
#include "rows/cells_rows.h"
#include "rows/simplex.h"
#endif

/* The passes of a basis, by [dimensions - 2][order]. */
struct basis {
    basis_pass *points[2][3];
    rows_pass *rows[2][3]; /* NULL: there is no fast path */
    int takes_unhashed;    /* whether passes take unhashed.h's locations, not lattice.h's */
    /* Vectors for the tables of a row of so many blocks, of a basis that takes unhashed
       locations. */
    size_t (*table_size)(int dimensions, size_t blocks);
};

#define PASSES(name, kind)                                                                         \
    {                                                                                              \
        {name##2_##kind##0, name##2_##kind##1, name##2_##kind##2},                                 \
            {name##3_##kind##0, name##3_##kind##1, name##3_##kind##2},                             \
    }

/* Passes that serve values, and those that serve derivatives of either order. */
#define VALUE_AND_ANY(name, kind)                                                                  \
    {                                                                                              \
        {name##2_##kind##0, name##2_##kind, name##2_##kind},                                       \
            {name##3_##kind##0, name##3_##kind, name##3_##kind},                                   \
    }
#define ANY(name, kind)                                                                            \
    {                                                                                              \
        {name##2_##kind, name##2_##kind, name##2_##kind},                                          \
            {name##3_##kind, name##3_##kind, name##3_##kind},                                      \
    }

/* A basis that takes unhashed locations. Small sets have no rows passes for such. */
#if VEC_SMALL
#define UNHASHED(points_passes, rows_passes, size)                                                 \
    {                                                                                              \
        .points = points_passes, .takes_unhashed = 1                                               \
    }
#else
#define UNHASHED(points_passes, rows_passes, size)                                                 \
    {                                                                                              \
        .points = points_passes, .rows = rows_passes, .takes_unhashed = 1, .table_size = size      \
    }
#endif
#define SIMPLEX_ROWS                                                                               \
    {                                                                                              \
        {simplex2_rows0, simplex2_rows1, simplex2_rows2},                                          \
        {                                                                                          \
            simplex3_rows0, simplex3_rows1, NULL                                                   \
        }                                                                                          \
    }
#define FLOW_ROWS                                                                                  \
    {                                                                                              \
        {flow2_rows0, flow2_rows1, NULL},                                                          \
        {                                                                                          \
            flow3_rows0, flow3_rows1, NULL                                                         \
        }                                                                                          \
    }
#define CELLS(passes, name) UNHASHED(passes(name, points), passes(name, rows), cell_tables_size)

/* The line of gradient noise that flows, after those of the bases. Its Hessians are rare and large:
   grids of them are computed as points (has_no_rows). */
enum { FLOWING = SCARP_BASES };

static const struct basis bases[] = {
    [SCARP_GRADIENT] = {.points = PASSES(gradient, points), .rows = PASSES(gradient, rows)},
    [SCARP_VALUE] = {.points = PASSES(value, points), .rows = PASSES(value, rows)},
    [SCARP_SIMPLEX] = UNHASHED(PASSES(simplex, points), SIMPLEX_ROWS, vertices_size),
    [SCARP_CELL_F1] = CELLS(VALUE_AND_ANY, nearest),
    [SCARP_CELL_F2] = CELLS(VALUE_AND_ANY, second),
    [SCARP_CELL_EDGE] = CELLS(VALUE_AND_ANY, second),
    [SCARP_CELL_SOFT] = CELLS(PASSES, soft),
    [SCARP_CELL_VALUE] = CELLS(ANY, cell),
    [FLOWING] = {.points = PASSES(flow, points), .rows = FLOW_ROWS},
};

_Static_assert(sizeof bases / sizeof bases[0] == FLOWING + 1,
               "each basis has its line, and FLOWING the last");

static const struct basis *basis_of(const struct scarp_call_plan *plan)
{
    return &bases[plan->flows ? FLOWING : plan->basis];
}

#undef PASSES
#undef VALUE_AND_ANY
#undef ANY
#undef UNHASHED
#undef CELLS
#undef SIMPLEX_ROWS
#undef FLOW_ROWS

/* Whether grids of the noise, without its warps, are computed as points: octaves that bend displace
   the next ones, and flow noise has no rows pass for Hessians. */
static int has_no_rows(const struct scarp_call_plan *plan)
{
    return fractal_bends(plan->fractal) ||
           (plan->flows && plan->order + fractals[plan->fractal].extra_order > 1);
}

#endif
