/* SPDX-License-Identifier: MIT
 *
 * The scalar kernels: the reference that every other kernel set must equal bit for bit. It takes
 * one point at a time, in plain C, is written to be read and not to be fast, and shares nothing
 * with src/kernel.
 */
#include <math.h>

#include "../dispatch/exact.h"
#include "../dispatch/kernels.h"
#include "chain.h"
#include "gullies.h"
#include "warp.h"

#include "../formulas/curl.h"

static void put3(float to[3], vec3 v)
{
    to[0] = v.x;
    to[1] = v.y;
    to[2] = v.z;
}

static struct point point_at(const void *const position[3], size_t i, int dimensions, int doubles)
{
    struct point x = {.doubles = doubles};
    if (doubles) {
        for (int d = 0; d < dimensions; d++) {
            x.f64[d] = ((const double *)position[d])[i];
        }
        return x;
    }
    x.f32.x = ((const float *)position[0])[i];
    x.f32.y = ((const float *)position[1])[i];
    if (dimensions == 3) {
        x.f32.z = ((const float *)position[2])[i];
    }
    return x;
}

static void points(const struct scarp_call_plan *plan, size_t count, const void *const position[3],
                   const struct scarp_outputs *out, int dimensions, int doubles)
{
    for (size_t i = 0; i < count; i++) {
        const struct point x = point_at(position, i, dimensions, doubles);
        const struct sampled sum = sample_at(plan, &x, dimensions);
        put(out->array, i, &sum);
    }
}

static void points2_f32(const struct scarp_call_plan *plan, size_t count,
                        const void *const position[3], const struct scarp_outputs *out)
{
    points(plan, count, position, out, 2, 0);
}

static void points2_f64(const struct scarp_call_plan *plan, size_t count,
                        const void *const position[3], const struct scarp_outputs *out)
{
    points(plan, count, position, out, 2, 1);
}

static void points3_f32(const struct scarp_call_plan *plan, size_t count,
                        const void *const position[3], const struct scarp_outputs *out)
{
    points(plan, count, position, out, 3, 0);
}

static void points3_f64(const struct scarp_call_plan *plan, size_t count,
                        const void *const position[3], const struct scarp_outputs *out)
{
    points(plan, count, position, out, 3, 1);
}

static double coordinate(const struct scarp_grid *grid, int axis, size_t index)
{
    return grid->origin[axis] + (double)(grid->first[axis] + (int64_t)index) * grid->step[axis];
}

static void grid2(const struct scarp_call_plan *plan, const struct scarp_grid *grid,
                  const struct scarp_outputs *out)
{
    struct point x = {.doubles = 1};
    for (size_t j = 0; j < grid->count[1]; j++) {
        x.f64[1] = coordinate(grid, 1, j);
        for (size_t i = 0; i < grid->count[0]; i++) {
            x.f64[0] = coordinate(grid, 0, i);
            const struct sampled sum = sample_at(plan, &x, 2);
            put(out->array, j * grid->row_stride + i, &sum);
        }
    }
}

static void grid3(const struct scarp_call_plan *plan, const struct scarp_grid *grid,
                  const struct scarp_outputs *out)
{
    struct point x = {.doubles = 1};
    for (size_t k = 0; k < grid->count[2]; k++) {
        x.f64[2] = coordinate(grid, 2, k);
        for (size_t j = 0; j < grid->count[1]; j++) {
            x.f64[1] = coordinate(grid, 1, j);
            for (size_t i = 0; i < grid->count[0]; i++) {
                x.f64[0] = coordinate(grid, 0, i);
                const struct sampled sum = sample_at(plan, &x, 3);
                put(out->array, k * grid->slice_stride + j * grid->row_stride + i, &sum);
            }
        }
    }
}

/* n = (-s dx, -s dy, 1) / length. The products of floats are exact in double and their squares do
   not overflow. 1 / length is length / length^2, so that infinite inputs give NaN. */
static void normals(size_t count, const float *const slope[2], float height_scale,
                    float *const normal[3])
{
    const double s = -(double)height_scale;
    for (size_t i = 0; i < count; i++) {
        const double x = s * (double)slope[0][i];
        const double y = s * (double)slope[1][i];
        const double squares = x * x + y * y + 1.0;
        const double inverse = sqrt(squares) / squares;
        const double n[3] = {x * inverse, y * inverse, inverse};
        for (int axis = 0; axis < 3; axis++) {
            if (normal[axis] != NULL) {
                normal[axis][i] = (float)n[axis];
            }
        }
    }
}

/* What is near x, by output. The id is there as bits. */
WHOLE void cells_near(float of[CELLS_OUTPUTS], const struct scarp_call_plan *plan,
                      const struct point *x, int dimensions)
{
    const struct octave o = octave_of(plan, 0, dimensions);
    const struct location at = location_at(plan, 0, x, dimensions);
    const struct nearest n = nearest_at(lattice_of(o, level_of(plan)), at, dimensions);
    const struct sample first = distance_to(n.first), second = distance_to(n.second);
    const double unit = 1.0 / plan->octave->frequency64;
    const vec3 d = n.first.d, of_f32 = sub3(x->f32, mul3((float)unit, d));
    const uint32_t id = n.first.s < FAR_AWAY ? n.first.hash * FEATURE_ID : 0; /* 0 of NaN */
    of[CELLS_F1] = first.value * (float)unit;
    of[CELLS_F2] = second.value * (float)unit;
    memcpy(&of[CELLS_ID], &id, sizeof id);
    put3(&of[CELLS_X], of_f32);
    put3(&of[CELLS_DX1], first.gradient);
    put3(&of[CELLS_DX2], second.gradient);
    if (x->doubles) {
        of[CELLS_X] = (float)(x->f64[0] - (double)d.x * unit);
        of[CELLS_Y] = (float)(x->f64[1] - (double)d.y * unit);
        of[CELLS_Z] = (float)(x->f64[2] - (double)d.z * unit);
    }
}

static void cells(const struct scarp_call_plan *plan, size_t count, const void *const position[3],
                  const struct scarp_cell_arrays *out, int dimensions, int doubles)
{
    for (size_t i = 0; i < count; i++) {
        const struct point x = point_at(position, i, dimensions, doubles);
        float of[CELLS_OUTPUTS];
        cells_near(of, plan, &x, dimensions);
        for (int output = 0; output < CELLS_OUTPUTS; output++) {
            if (out->array[output] != NULL) {
                memcpy(out->array[output] + i, &of[output], sizeof(float));
            }
        }
    }
}

static void chain(const struct scarp_chain *call, size_t count)
{
    struct scarp_chain whole;
    if (call->has_values_only) { /* what is not set becomes NULL */
        memset(&whole, 0, sizeof whole);
        whole.function = call->function;
        memcpy(whole.number, call->number, sizeof whole.number);
        for (int input = 0; input < CHAIN_INPUTS; input++) {
            whole.in[input][VALUE] = call->in[input][VALUE];
        }
        whole.partial[PARTIAL_F] = call->partial[PARTIAL_F];
        whole.out[VALUE] = call->out[VALUE];
        call = &whole;
    }
    for (size_t i = 0; i < count; i++) {
        chain_at(call, i);
    }
}

static void components(const struct scarp_call_plan *plan, size_t count,
                       const void *const position[3], const struct scarp_outputs *const out[3],
                       int dimensions, int doubles)
{
    for (size_t i = 0; i < count; i++) {
        const struct point x = point_at(position, i, dimensions, doubles);
        struct sampled of[3];
        /* All of them come before an output takes the place of a coordinate. */
        for (int c = 0; c < dimensions; c++) {
            of[c] = component_at(plan, &x, dimensions, c);
        }
        for (int c = 0; c < dimensions; c++) {
            put(out[c]->array, i, &of[c]);
        }
    }
}

static void curl(const struct scarp_call_plan *plan, size_t count, const void *const position[3],
                 const struct scarp_flow_arrays *out, int dimensions, int doubles)
{
    for (size_t i = 0; i < count; i++) {
        const struct point x = point_at(position, i, dimensions, doubles);
        struct displaced psi = not_displaced();
        float of[FLOW_OUTPUTS];
        psi.x = component_at(plan, &x, dimensions, 0).s;
        if (dimensions == 3) {
            psi.y = component_at(plan, &x, dimensions, 1).s;
            psi.z = component_at(plan, &x, dimensions, 2).s;
        }
        const struct flow f = dimensions == 3 ? curl_in_space(psi) : curl_in_plane(psi.x);
        put3(&of[FLOW_V], f.velocity);
        put3(&of[FLOW_JACOBIAN], f.x);
        put3(&of[FLOW_JACOBIAN + 3], f.y);
        put3(&of[FLOW_JACOBIAN + 6], f.z);
        for (int output = 0; output < FLOW_OUTPUTS; output++) {
            if (out->array[output] != NULL) {
                out->array[output][i] = of[output];
            }
        }
    }
}

static void gullies(const struct scarp_gully_call *call, const struct scarp_call_plan *plan)
{
    struct point x = {.doubles = 1};
    for (size_t i = 0; call->grid == NULL && i < call->count; i++) {
        x = point_at((const void *const[3]){call->position[0], call->position[1], NULL}, i, 2,
                     call->doubles);
        gullies_at(call, plan, i, &x);
    }
    for (size_t j = 0; call->grid != NULL && j < call->grid->count[1]; j++) {
        x.f64[1] = coordinate(call->grid, 1, j);
        for (size_t i = 0; i < call->grid->count[0]; i++) {
            x.f64[0] = coordinate(call->grid, 0, i);
            gullies_at(call, plan, j * call->grid->row_stride + i, &x);
        }
    }
}

const struct scarp_kernels scarpi_kernels_scalar = {
    .isa = SCARP_ISA_SCALAR,
    .is_exact = scarpi_is_exact,
    .points2_f32 = points2_f32,
    .points2_f64 = points2_f64,
    .points3_f32 = points3_f32,
    .points3_f64 = points3_f64,
    .grid2 = grid2,
    .grid3 = grid3,
    .normals = normals,
    .cells = cells,
    .chain = chain,
    .components = components,
    .curl = curl,
    .gullies = gullies,
};
