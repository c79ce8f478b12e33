/* SPDX-License-Identifier: MIT
 *
 * The public functions that give velocities.
 */
#include "run.h"
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
static int asks_too_much(const void *arrays, int dimensions)
{
    const struct scarp_flow *const out = arrays;
    for (size_t i = 0; i < sizeof out->spare / sizeof out->spare[0]; i++) {
        if (out->spare[i] != NULL) {
            return 1;
        }
    }
    return dimensions == 2 && (out->vz != NULL || out->vxz != NULL || out->vyz != NULL ||
                               out->vzx != NULL || out->vzy != NULL || out->vzz != NULL);
}

/* The derivatives of potentials that are needed: second ones for the Jacobian. In space there is a
   potential for each axis. */
static struct scarp_request request_of(const void *out, int dimensions)
{
    const struct scarp_flow_arrays *const arrays = arrays_of(out);
    struct scarp_request request = {
        .dimensions = dimensions, .order = 1, .vector = dimensions == 3};
    for (int i = FLOW_JACOBIAN; i < FLOW_OUTPUTS; i++) {
        request.order = arrays->array[i] != NULL ? 2 : request.order;
    }
    return request;
}

static void run(const struct scarp_call_plan *plan, const void *opaque)
{
    const struct scarp_arguments *const call = opaque;
    call->kernels->curl(plan, call->at->count, call->at->position, arrays_of(call->out),
                        call->at->dimensions, call->at->doubles);
}

static const struct scarp_computation flow_computation = {asks_too_much, request_of, run};

enum scarp_status scarp_curl2(const struct scarp_noise *noise, size_t count, const float *x,
                              const float *y, const struct scarp_flow *out)
{
    const struct scarp_at at = {count, {x, y, NULL}, 2, 0};
    return scarpi_run_at_points(&flow_computation, noise, &at, out);
}

enum scarp_status scarp_curl3(const struct scarp_noise *noise, size_t count, const float *x,
                              const float *y, const float *z, const struct scarp_flow *out)
{
    const struct scarp_at at = {count, {x, y, z}, 3, 0};
    return scarpi_run_at_points(&flow_computation, noise, &at, out);
}

enum scarp_status scarp_curl2_f64(const struct scarp_noise *noise, size_t count, const double *x,
                                  const double *y, const struct scarp_flow *out)
{
    const struct scarp_at at = {count, {x, y, NULL}, 2, 1};
    return scarpi_run_at_points(&flow_computation, noise, &at, out);
}

enum scarp_status scarp_curl3_f64(const struct scarp_noise *noise, size_t count, const double *x,
                                  const double *y, const double *z, const struct scarp_flow *out)
{
    const struct scarp_at at = {count, {x, y, z}, 3, 1};
    return scarpi_run_at_points(&flow_computation, noise, &at, out);
}
