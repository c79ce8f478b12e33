/* SPDX-License-Identifier: MIT
 *
 * The public functions that serve shaders: the constants of a noise as a uniform buffer, and the
 * answers that a shader must give.
 */
#include <stddef.h>
#include <string.h>

#include "../dispatch/dispatch.h"
#include "../dispatch/fpmode.h"
#include "../formulas/answers.h"
#include "../plan/octave.h"
#include "../plan/outputs.h"
#include "../plan/refusals.h"
#include "run.h"
#include "scarp.h"
#include "shaders.h"

#define AT(type, member, bytes) (offsetof(struct scarp_gpu_##type, member) == (bytes))

/* The layout is that of std140, and the shaders declare it once more. */
_Static_assert(AT(octave, frequency, 12) && AT(octave, weight, 16) && AT(octave, last, 32) &&
                   AT(octave, turn, 48) && AT(octave, jacobian, 64) && AT(octave, gradient, 112) &&
                   sizeof(struct scarp_gpu_octave) == 160,
               "struct scarp_gpu_octave has 10 vectors of 16 bytes");
_Static_assert(AT(level, rotate, 16) && AT(level, erosion, 32) &&
                   sizeof(struct scarp_gpu_level) == 48,
               "struct scarp_gpu_level has 3 vectors of 16 bytes");
_Static_assert(AT(plan, level, 16) && AT(plan, octave, 256) &&
                   sizeof(struct scarp_gpu_plan) == 5376,
               "struct scarp_gpu_plan has 336 vectors of 16 bytes");
_Static_assert(sizeof((struct scarp_gpu_plan *)0)->level / sizeof(struct scarp_gpu_level) ==
                       1 + SCARP_MAX_WARPS &&
                   sizeof((struct scarp_gpu_plan *)0)->octave / sizeof(struct scarp_gpu_octave) ==
                       SCARP_MAX_OCTAVES,
               "there is room for all levels, and for as many octaves as a plan has");

_Static_assert(sizeof(struct scarp_gpu_octave) == sizeof(struct octave) &&
                   sizeof(struct scarp_gpu_level) == sizeof(struct level),
               "the formulas have the octaves and levels of scarp.h");

static void set_octave(struct scarp_gpu_octave *to, const struct scarp_call_plan *plan, int k,
                       int dimensions)
{
    struct octave o = octave_of(plan, k, dimensions);
    if (basis_has(plan->basis, BASIS_CELLS)) {
        o.inverse = (float)(1.0 / plan->octave[k].frequency64);
    }
    memcpy(to, &o, sizeof *to);
}

/* Writes what the components of a level share. */
static void set_level(struct scarp_gpu_level *to, const struct scarp_call_plan *plan, int first)
{
    struct level l = level_of(plan);
    l.octaves = (uint32_t)plan->octaves;
    l.rotate = plan->rotate != 0;
    l.first = (uint32_t)first;
    memcpy(to, &l, sizeof *to);
}

float scarpi_shader_unit(double frequency)
{
    const double exact = 0x1p-8 / frequency;
    uint64_t bits;
    double power;
    memcpy(&bits, &exact, sizeof bits);
    bits = (bits + (UINT64_C(1) << 51)) & ~((UINT64_C(1) << 52) - 1);
    memcpy(&power, &bits, sizeof power);
    return (float)power;
}

int scarpi_shader_levels(const struct scarp_call_plan *plan, int dimensions,
                         struct scarp_gpu_level *level, struct scarp_gpu_octave *octave, int first)
{
    const int depth = plan->warps.depth;
    const int has_levels = depth > 0 || plan->warps.vector;
    int count = 0;
    for (int i = 0; i <= depth; i++) {
        int sets = 1;
        for (int c = 0; c < sets; c++) {
            const struct scarp_call_plan component =
                has_levels ? scarpi_component_plan(plan, i, c) : *plan;
            if ((i > 0 || plan->warps.vector) && !components_share_lattice(component.basis)) {
                sets = dimensions;
            }
            if (c == 0 && level != NULL) {
                set_level(&level[i], &component, first + count);
            }
            for (int k = 0; k < component.octaves && octave != NULL; k++) {
                set_octave(&octave[count + k], &component, k, dimensions);
            }
            count += component.octaves;
        }
    }
    return count;
}

static void set_plan(struct scarp_gpu_plan *to, const struct scarp_call_plan *plan, int dimensions)
{
    const int has_levels = plan->warps.depth > 0 || plan->warps.vector;
    const struct scarp_call_plan noise = has_levels ? scarpi_component_plan(plan, 0, 0) : *plan;
    memset(to, 0, sizeof *to);
    to->depth = (uint32_t)plan->warps.depth;
    to->dimensions = (uint32_t)dimensions;
    to->unit = scarpi_shader_unit(noise.octave[0].frequency64);
    (void)scarpi_shader_levels(plan, dimensions, to->level, to->octave, 0);
}

/* Where a plan goes, if anywhere, and whether it has room there. */
struct filling {
    struct scarp_gpu_plan *to;
    int dimensions, *fits;
};

static void run(const struct scarp_call_plan *plan, const void *opaque)
{
    const struct filling *const filling = opaque;
    *filling->fits = (plan->warps.depth == 0 && !plan->warps.vector) ||
                     plan->warps.levels->octaves <= SCARP_MAX_OCTAVES;
    if (*filling->fits && filling->to != NULL) {
        set_plan(filling->to, plan, filling->dimensions);
    }
}

/* Makes a plan of a noise, or only the checks if there is no room for a plan. */
static NOINLINE struct scarp_fault make(struct scarp_gpu_plan *to, const struct scarp_noise *noise,
                                        struct scarp_request request)
{
    int fits = 0;
    const struct filling filling = {to, request.dimensions, &fits};
    struct scarp_fault fault = scarpi_plan_check(noise, request.dimensions);
    if (fault.why == REFUSED_NOT) {
        if (scarpi_run(noise, request, run, &filling) != SCARP_OK) {
            fits = 0;
        }
        fault.warp = 0;
        fault.why = fits                  ? REFUSED_NOT
                    : noise->warp != NULL ? REFUSED_GPU_WARP
                                          : REFUSED_GPU_OCTAVES;
    }
    return fault;
}

static struct scarp_fault fault_of(struct scarp_gpu_plan *plan, const struct scarp_noise *noise,
                                   struct scarp_request request)
{
    struct scarp_fault fault = {REFUSED_POINTER, 0};
    if (noise != NULL) {
        const struct fpmode caller = fpmode_enter();
        fault = make(plan, noise, request);
        fpmode_leave(caller);
    }
    return fault;
}

static enum scarp_status make_plan(const struct scarp_noise *noise, struct scarp_request request,
                                   struct scarp_gpu_plan *plan, const char **member)
{
    if (noise != NULL && plan != NULL && scarpi_dispatch_refuses()) {
        const struct scarp_fault no_member = {REFUSED_NOT, 0};
        (void)scarpi_fault_status(no_member, member);
        return SCARP_ERROR_UNSUPPORTED;
    }
    const struct scarp_fault fault = fault_of(plan, plan == NULL ? NULL : noise, request);
    return scarpi_fault_status(fault, member);
}

enum scarp_status scarp_gpu_plan_make(const struct scarp_noise *noise, int dimensions,
                                      struct scarp_gpu_plan *plan, const char **member)
{
    return make_plan(noise, (struct scarp_request){.dimensions = dimensions}, plan, member);
}

enum scarp_status scarp_gpu_vector_plan_make(const struct scarp_noise *noise, int dimensions,
                                             struct scarp_gpu_plan *plan, const char **member)
{
    return make_plan(noise, (struct scarp_request){.dimensions = dimensions, .vector = 1}, plan,
                     member);
}

const char *scarp_gpu_plan_fault(const struct scarp_noise *noise, int dimensions, int vector,
                                 const char **member)
{
    const struct scarp_request request = {.dimensions = dimensions, .vector = vector != 0};
    return scarpi_fault_told(fault_of(NULL, noise, request), member);
}

/* Finds the unit, with the same checks. */
static NOINLINE enum scarp_status find_unit(float *unit, const struct scarp_noise *noise,
                                            int dimensions)
{
    struct scarp_gpu_plan plan;
    const struct scarp_fault fault =
        make(&plan, noise, (struct scarp_request){.dimensions = dimensions});
    *unit = fault.why == REFUSED_NOT ? plan.unit : 0.0f;
    return scarpi_fault_status(fault, NULL);
}

/* The arrays of `out` in the order of struct scarp_samples, which samples.c has an assertion for.
 */
static struct scarp_outputs *list_of(struct scarp_samples *out)
{
    return (struct scarp_outputs *)out;
}

#define CHUNK 32 /* points of a call. With more of them, the stack would be too large. */

/* Answers for a chunk of test points. Outputs take the place of the coordinates. */
static NOINLINE enum scarp_status answer_chunk(uint32_t answer[CHUNK],
                                               const struct scarp_noise *noise, int dimensions,
                                               int order, uint32_t first, float unit)
{
    const unsigned along_z = 1u << DZ | 1u << DXZ | 1u << DYZ | 1u << DZZ;
    const unsigned absent = dimensions == 2 ? along_z : 0;
    float array[DPHASE][CHUNK];
    struct scarp_samples out = {0};
    for (uint32_t i = 0; i < CHUNK; i++) {
        for (int axis = 0; axis < 3; axis++) {
            array[axis][i] = test_coordinate(unit, first + i, (uint32_t)axis);
        }
    }
    for (int i = 0; i < OUTPUTS_UP_TO(order); i++) {
        list_of(&out)->array[i] = (absent >> i & 1) == 0 ? array[i] : NULL;
    }
    const enum scarp_status status =
        dimensions == 2 ? scarp_sample2(noise, CHUNK, array[0], array[1], &out)
                        : scarp_sample3(noise, CHUNK, array[0], array[1], array[2], &out);
    for (int i = 0; status == SCARP_OK && i < CHUNK; i++) {
        answer[i] = 0;
        for (int j = 0; j < OUTPUTS_UP_TO(order); j++) {
            answer[i] = (absent >> j & 1) == 0 ? hash_with(answer[i], array[j][i]) : answer[i];
        }
    }
    return status;
}

enum scarp_status scarp_gpu_answers(const struct scarp_noise *noise, int dimensions, int order,
                                    uint32_t *answer)
{
    if (noise == NULL || answer == NULL) {
        return SCARP_ERROR_NULL;
    }
    if (scarpi_dispatch_refuses()) {
        return SCARP_ERROR_UNSUPPORTED;
    }
    float unit;
    const struct fpmode caller = fpmode_enter();
    enum scarp_status status = find_unit(&unit, noise, dimensions);
    fpmode_leave(caller);
    if (status == SCARP_OK && (order < 0 || order > 2)) {
        status = SCARP_ERROR_PARAMETER;
    }
    for (uint32_t i = 0; status == SCARP_OK && i < SCARP_GPU_ANSWERS; i += CHUNK) {
        status = answer_chunk(answer + i, noise, dimensions, order, i, unit);
    }
    return status;
}
