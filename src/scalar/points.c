/* SPDX-License-Identifier: MIT
 *
 * The scalar kernels: the reference that every other instruction set must equal bit for bit, and
 * the fallback where none other can run. One point at a time, in plain C; shares nothing with
 * src/kernel.
 */
#include <math.h>

#include "../kernels.h"
#include "fractal.h"

#define NOINLINE __attribute__((noinline))

SCALAR_INLINE void put(float *array, size_t i, float value)
{
    if (array != NULL) {
        array[i] = value;
    }
}

SCALAR_INLINE void store(const struct scarp_samples *out, size_t i, const struct sample *s,
                         int dimensions, int order)
{
    put(out->value, i, s->value);
    if (order >= 1) {
        put(out->dx, i, s->dx);
        put(out->dy, i, s->dy);
        if (dimensions == 3) {
            put(out->dz, i, s->dz);
        }
    }
    if (order >= 2) {
        put(out->dxx, i, s->dxx);
        put(out->dxy, i, s->dxy);
        put(out->dyy, i, s->dyy);
        if (dimensions == 3) {
            put(out->dxz, i, s->dxz);
            put(out->dyz, i, s->dyz);
            put(out->dzz, i, s->dzz);
        }
    }
}

/* Everything from `fractal` on is a constant where this is inlined. */
SCALAR_INLINE void points_of(const struct scarp_plan *plan, size_t count,
                             const void *const position[3], const struct scarp_samples *out,
                             enum scarp_fractal fractal, enum scarp_basis basis, int dimensions,
                             int order, int doubles)
{
    for (size_t i = 0; i < count; i++) {
        struct point x;
        for (int d = 0; d < dimensions; d++) {
            if (doubles) {
                x.f64[d] = ((const double *)position[d])[i];
            } else {
                x.f32[d] = ((const float *)position[d])[i];
            }
        }
        const struct sample sum = fractal == SCARP_FBM
                                      ? fbm(plan, &x, basis, dimensions, order, doubles)
                                      : shaped(plan, &x, dimensions, order, doubles);
        store(out, i, &sum, dimensions, order);
    }
}

/* `fractal` stands for all but SCARP_FBM if it is another. */
SCALAR_INLINE void points_by_order(const struct scarp_plan *plan, size_t count,
                                   const void *const position[3], const struct scarp_samples *out,
                                   enum scarp_fractal fractal, enum scarp_basis basis,
                                   int dimensions, int doubles)
{
    switch (plan->order) {
    case 0: points_of(plan, count, position, out, fractal, basis, dimensions, 0, doubles); break;
    case 1: points_of(plan, count, position, out, fractal, basis, dimensions, 1, doubles); break;
    default: points_of(plan, count, position, out, fractal, basis, dimensions, 2, doubles); break;
    }
}

/* Out of line, so that it is there once for floats and doubles. */
static NOINLINE void shaped_points2(const struct scarp_plan *plan, size_t count,
                                    const void *const position[3], const struct scarp_samples *out,
                                    int doubles)
{
    points_by_order(plan, count, position, out, SCARP_EROSION, plan->basis, 2, doubles);
}

static NOINLINE void shaped_points3(const struct scarp_plan *plan, size_t count,
                                    const void *const position[3], const struct scarp_samples *out,
                                    int doubles)
{
    points_by_order(plan, count, position, out, SCARP_EROSION, plan->basis, 3, doubles);
}

SCALAR_INLINE void points(const struct scarp_plan *plan, size_t count,
                          const void *const position[3], const struct scarp_samples *out,
                          int dimensions, int doubles)
{
    if (plan->fractal != SCARP_FBM) {
        (dimensions == 2 ? shaped_points2 : shaped_points3)(plan, count, position, out, doubles);
    } else if (plan->basis == SCARP_GRADIENT) {
        points_by_order(plan, count, position, out, SCARP_FBM, SCARP_GRADIENT, dimensions, doubles);
    } else {
        points_by_order(plan, count, position, out, SCARP_FBM, SCARP_VALUE, dimensions, doubles);
    }
}

static void points2_f32(const struct scarp_plan *plan, size_t count, const void *const position[3],
                        const struct scarp_samples *out)
{
    points(plan, count, position, out, 2, 0);
}

static void points3_f32(const struct scarp_plan *plan, size_t count, const void *const position[3],
                        const struct scarp_samples *out)
{
    points(plan, count, position, out, 3, 0);
}

static void points2_f64(const struct scarp_plan *plan, size_t count, const void *const position[3],
                        const struct scarp_samples *out)
{
    points(plan, count, position, out, 2, 1);
}

static void points3_f64(const struct scarp_plan *plan, size_t count, const void *const position[3],
                        const struct scarp_samples *out)
{
    points(plan, count, position, out, 3, 1);
}

/* Samples made at a time: their coordinates are on the stack. */
#define GRID_SAMPLES 64

static double coordinate(const struct scarp_grid *grid, int axis, size_t index)
{
    return grid->origin[axis] + (double)(grid->first[axis] + (int64_t)index) * grid->step[axis];
}

static float *moved(float *array, size_t by)
{
    return array == NULL ? NULL : array + by;
}

static struct scarp_samples samples_from(const struct scarp_samples *out, size_t first)
{
    const struct scarp_samples rows = {
        .value = moved(out->value, first),
        .dx = moved(out->dx, first),
        .dy = moved(out->dy, first),
        .dz = moved(out->dz, first),
        .dxx = moved(out->dxx, first),
        .dxy = moved(out->dxy, first),
        .dxz = moved(out->dxz, first),
        .dyy = moved(out->dyy, first),
        .dyz = moved(out->dyz, first),
        .dzz = moved(out->dzz, first),
    };
    return rows;
}

/* Row j of slice k, whose outputs begin at `out`. */
static void grid_row(const struct scarp_plan *plan, const struct scarp_grid *grid, size_t j,
                     size_t k, const struct scarp_samples *out, int dimensions)
{
    double x[GRID_SAMPLES], y[GRID_SAMPLES], z[GRID_SAMPLES];
    const void *const position[3] = {x, y, z};
    for (size_t first = 0; first < grid->count[0]; first += GRID_SAMPLES) {
        const size_t left = grid->count[0] - first;
        const size_t count = left < GRID_SAMPLES ? left : GRID_SAMPLES;
        for (size_t i = 0; i < count; i++) {
            x[i] = coordinate(grid, 0, first + i);
            y[i] = coordinate(grid, 1, j);
            z[i] = dimensions == 3 ? coordinate(grid, 2, k) : 0.0;
        }
        const struct scarp_samples samples = samples_from(out, first);
        (dimensions == 2 ? points2_f64 : points3_f64)(plan, count, position, &samples);
    }
}

static void grid2(const struct scarp_plan *plan, const struct scarp_grid *grid,
                  const struct scarp_samples *out)
{
    for (size_t j = 0; j < grid->count[1]; j++) {
        const struct scarp_samples row = samples_from(out, j * grid->row_stride);
        grid_row(plan, grid, j, 0, &row, 2);
    }
}

static void grid3(const struct scarp_plan *plan, const struct scarp_grid *grid,
                  const struct scarp_samples *out)
{
    for (size_t k = 0; k < grid->count[2]; k++) {
        for (size_t j = 0; j < grid->count[1]; j++) {
            const struct scarp_samples row =
                samples_from(out, k * grid->slice_stride + j * grid->row_stride);
            grid_row(plan, grid, j, k, &row, 3);
        }
    }
}

/* n = (-s dx, -s dy, 1) / length. The products of floats are exact in double and their squares do
   not overflow. 1 / length is length / length^2, so that infinite inputs give NaN. */
static void normals(size_t count, const float *dx, const float *dy, float height_scale, float *nx,
                    float *ny, float *nz)
{
    const double s = -(double)height_scale;
    for (size_t i = 0; i < count; i++) {
        const double x = s * (double)dx[i];
        const double y = s * (double)dy[i];
        const double squares = x * x + y * y + 1.0;
        const double inverse = sqrt(squares) / squares;
        if (nx != NULL) {
            nx[i] = (float)(x * inverse);
        }
        if (ny != NULL) {
            ny[i] = (float)(y * inverse);
        }
        if (nz != NULL) {
            nz[i] = (float)inverse;
        }
    }
}

const struct scarp_kernels scarp_kernels_scalar = {
    .isa = SCARP_ISA_SCALAR,
    .points2_f32 = points2_f32,
    .points2_f64 = points2_f64,
    .points3_f32 = points3_f32,
    .points3_f64 = points3_f64,
    .grid2 = grid2,
    .grid3 = grid3,
    .normals = normals,
};
