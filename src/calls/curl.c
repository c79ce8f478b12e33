/* SPDX-License-Identifier: MIT
 *
 * The public functions that give velocities. They check the arguments, make the plan of the
 * potentials and call the active kernel table.
 */
#include "../dispatch/dispatch.h"
#include "../dispatch/fpmode.h"
#include "../plan/plan.h"
#include "scarp.h"

_Static_assert(sizeof(struct scarp_flow) == 16 * sizeof(float *),
               "struct scarp_flow has 16 pointers");

/* The arrays of `out` as a list. No other place knows them by name. */
static const struct scarp_flow_arrays *arrays_of(const struct scarp_flow *out)
{
#define AT(output, member) (offsetof(struct scarp_flow, member) == (output) * sizeof(float *))
#define ROW(i, x, y, z)                                                                            \
    (AT(FLOW_JACOBIAN + 3 * (i), x) && AT(FLOW_JACOBIAN + 3 * (i) + 1, y) &&                       \
     AT(FLOW_JACOBIAN + 3 * (i) + 2, z))
    _Static_assert(AT(FLOW_V, vx) && AT(FLOW_V + 1, vy) && AT(FLOW_V + 2, vz) &&
                       ROW(0, vxx, vxy, vxz) && ROW(1, vyx, vyy, vyz) && ROW(2, vzx, vzy, vzz),
                   "the enumerators of outputs.h are in the order of struct scarp_flow");
#undef ROW
#undef AT
    return (const struct scarp_flow_arrays *)out;
}

/* Whether something is asked for that does not exist: what is along z in 2D, reserved members. */
static int asks_too_much(const struct scarp_flow *out, int dimensions)
{
    for (size_t i = 0; i < sizeof out->spare / sizeof out->spare[0]; i++) {
        if (out->spare[i] != NULL) {
            return 1;
        }
    }
    return dimensions == 2 && (out->vz != NULL || out->vxz != NULL || out->vyz != NULL ||
                               out->vzx != NULL || out->vzy != NULL || out->vzz != NULL);
}

/* The derivatives of potentials that are needed: second ones for the Jacobian. */
static short order_of(const struct scarp_flow *out)
{
    const struct scarp_flow_arrays *const arrays = arrays_of(out);
    short order = 1;
    for (int i = FLOW_JACOBIAN; i < FLOW_OUTPUTS; i++) {
        order = arrays->array[i] != NULL ? 2 : order;
    }
    return order;
}

/* What the points of a call are. */
struct flow_points {
    size_t count;
    const void *position[3];
    int dimensions, doubles;
};

/* Makes the plan, and runs the kernel. This is out of line for the same reason as run() in scarp.c.
 */
static __attribute__((noinline)) enum scarp_status run(const struct scarp_kernels *kernels,
                                                       const struct scarp_noise *noise,
                                                       const struct flow_points *points,
                                                       const struct scarp_flow *out)
{
    const struct scarp_kind kind = {.dimensions = points->dimensions, .order = order_of(out)};
    struct scarp_call_plan plan;
    struct scarp_octave space[SCARP_MAX_OCTAVES];
    const enum scarp_status status = scarp_plan_potentials(&plan, space, noise, kind);
    if (status == SCARP_OK) {
        kernels->curl(&plan, points->count, points->position, arrays_of(out), points->dimensions,
                      points->doubles);
    }
    return status;
}

static __attribute__((noinline)) enum scarp_status find_flow(const struct scarp_noise *noise,
                                                             const struct flow_points *points,
                                                             const struct scarp_flow *out)
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

enum scarp_status scarp_curl2(const struct scarp_noise *noise, size_t count, const float *x,
                              const float *y, const struct scarp_flow *out)
{
    const struct flow_points points = {count, {x, y, NULL}, 2, 0};
    return find_flow(noise, &points, out);
}

enum scarp_status scarp_curl3(const struct scarp_noise *noise, size_t count, const float *x,
                              const float *y, const float *z, const struct scarp_flow *out)
{
    const struct flow_points points = {count, {x, y, z}, 3, 0};
    return find_flow(noise, &points, out);
}

enum scarp_status scarp_curl2_f64(const struct scarp_noise *noise, size_t count, const double *x,
                                  const double *y, const struct scarp_flow *out)
{
    const struct flow_points points = {count, {x, y, NULL}, 2, 1};
    return find_flow(noise, &points, out);
}

enum scarp_status scarp_curl3_f64(const struct scarp_noise *noise, size_t count, const double *x,
                                  const double *y, const double *z, const struct scarp_flow *out)
{
    const struct flow_points points = {count, {x, y, z}, 3, 1};
    return find_flow(noise, &points, out);
}
