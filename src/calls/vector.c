/* SPDX-License-Identifier: MIT
 *
 * The public functions that give the components of vector noise.
 */
#include "run.h"
#include "scarp.h"

/* Whether something is asked for that does not exist, of any component. */
static int asks_too_much(const void *samples, int dimensions)
{
    const struct scarp_samples *const out = samples;
    int too_much = 0;
    for (int i = 0; i < dimensions; i++) {
        too_much |= scarpi_request_of_samples(dimensions, &out[i]).order == SCARP_UNSUPPORTED_ORDER;
    }
    return too_much;
}

/* What is asked for of any component, which all get. */
static struct scarp_request request_of(const void *samples, int dimensions)
{
    const struct scarp_samples *const out = samples;
    struct scarp_request request = {.dimensions = dimensions, .vector = 1};
    for (int i = 0; i < dimensions; i++) {
        const struct scarp_request of = scarpi_request_of_samples(dimensions, &out[i]);
        request.order = of.order > request.order ? of.order : request.order;
        request.dphase |= of.dphase;
    }
    return request;
}

static void run(const struct scarp_call_plan *plan, const void *opaque)
{
    const struct scarp_arguments *const call = opaque;
    const struct scarp_samples *const samples = call->out;
    const struct scarp_outputs *out[3] = {NULL, NULL, NULL};
    for (int i = 0; i < call->at->dimensions; i++) {
        out[i] = scarpi_outputs_of(&samples[i]);
    }
    call->kernels->components(plan, call->at->count, call->at->position, out, call->at->dimensions,
                              call->at->doubles);
}

static const struct scarp_computation vector_computation = {asks_too_much, request_of, run};

enum scarp_status scarp_vector2(const struct scarp_noise *noise, size_t count, const float *x,
                                const float *y, const struct scarp_samples out[2])
{
    const struct scarp_at at = {count, {x, y, NULL}, 2, 0};
    return scarpi_run_at_points(&vector_computation, noise, &at, out);
}

enum scarp_status scarp_vector3(const struct scarp_noise *noise, size_t count, const float *x,
                                const float *y, const float *z, const struct scarp_samples out[3])
{
    const struct scarp_at at = {count, {x, y, z}, 3, 0};
    return scarpi_run_at_points(&vector_computation, noise, &at, out);
}

enum scarp_status scarp_vector2_f64(const struct scarp_noise *noise, size_t count, const double *x,
                                    const double *y, const struct scarp_samples out[2])
{
    const struct scarp_at at = {count, {x, y, NULL}, 2, 1};
    return scarpi_run_at_points(&vector_computation, noise, &at, out);
}

enum scarp_status scarp_vector3_f64(const struct scarp_noise *noise, size_t count, const double *x,
                                    const double *y, const double *z,
                                    const struct scarp_samples out[3])
{
    const struct scarp_at at = {count, {x, y, z}, 3, 1};
    return scarpi_run_at_points(&vector_computation, noise, &at, out);
}
