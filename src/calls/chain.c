/* SPDX-License-Identifier: MIT
 *
 * The public functions of the chain rule over samples. They check the arguments, compute what
 * depends only on numbers and call the active kernel table.
 */
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include "../dispatch/dispatch.h"
#include "../dispatch/fpmode.h"
#include "chain.h"
#include "run.h"
#include "scarp.h"

#define SCALE_MIN 0x1p-60f
#define SCALE_MAX 0x1p60f
#define RISER_MIN 0x1p-20f

#define AT(struct_, type, i, member) (offsetof(struct struct_, member) == (i) * sizeof(type *))
_Static_assert(AT(scarp_samples, float, DXX, dxx) && AT(scarp_samples, float, DZZ, dzz) &&
                   AT(scarp_samples, float, DPHASE, dphase),
               "the enumerators of outputs.h are in the order of struct scarp_samples");
_Static_assert(AT(scarp_partials, float, PARTIAL_F, f) &&
                   AT(scarp_partials, float, PARTIAL_A, fa) &&
                   AT(scarp_partials, float, PARTIAL_B, fb) &&
                   AT(scarp_partials, float, PARTIAL_AA, faa) &&
                   AT(scarp_partials, float, PARTIAL_AB, fab) &&
                   AT(scarp_partials, float, PARTIAL_BB, fbb) &&
                   sizeof(struct scarp_partials) == 8 * sizeof(float *),
               "struct scarp_partials has 8 pointers in the order of chain.h");
#undef AT

/* The arguments of a call, as they came. */
struct arguments {
    enum scarp_chain_function function;
    int inputs;
    const struct scarp_samples *in[CHAIN_INPUTS], *out;
    const struct scarp_partials *partials;
    float number[3];
};

static int is_linear(enum scarp_chain_function function)
{
    return function == CHAIN_AFFINE || function == CHAIN_ADD;
}

static int takes_partials(enum scarp_chain_function function)
{
    return function == CHAIN_APPLY1 || function == CHAIN_APPLY2;
}

static int order_of(int output)
{
    return output == VALUE ? 0 : output < DXX || output == DPHASE ? 1 : 2;
}

/* Which members of each input the outputs need, a bit for each. */
static unsigned members_needed(const struct arguments *call)
{
    enum { OF_X = 1 << DX, OF_Y = 1 << DY, OF_Z = 1 << DZ };
    static const unsigned char lower[OUTPUTS] = {
        [DXX] = OF_X, [DXY] = OF_X | OF_Y, [DXZ] = OF_X | OF_Z,
        [DYY] = OF_Y, [DYZ] = OF_Y | OF_Z, [DZZ] = OF_Z};
    const struct scarp_outputs *const out = (const struct scarp_outputs *)call->out;
    unsigned same = 0, first = 0;
    for (int m = 0; m < OUTPUTS; m++) {
        if (out->array[m] != NULL) {
            same |= 1u << m;
            first |= lower[m];
        }
    }
    if (is_linear(call->function)) {
        return same;
    }
    return takes_partials(call->function) ? (same | first) & ~(1u << VALUE)
                                          : same | first | 1u << VALUE;
}

/* Likewise which partial derivatives. */
static unsigned partials_needed(const struct arguments *call)
{
    static const unsigned of_one[3] = {1u << PARTIAL_F, 1u << PARTIAL_A,
                                       1u << PARTIAL_A | 1u << PARTIAL_AA};
    static const unsigned of_two[3] = {1u << PARTIAL_F, 1u << PARTIAL_A | 1u << PARTIAL_B,
                                       ((1u << PARTIALS) - 1) & ~(1u << PARTIAL_F)};
    const struct scarp_outputs *const out = (const struct scarp_outputs *)call->out;
    unsigned needed = 0;
    for (int m = 0; takes_partials(call->function) && m < OUTPUTS; m++) {
        if (out->array[m] != NULL) {
            needed |= (call->function == CHAIN_APPLY1 ? of_one : of_two)[order_of(m)];
        }
    }
    return needed;
}

/* Fills in the arrays that are needed. Returns 0 if one is not there. */
static int take_arrays(struct scarp_chain *to, const struct arguments *call)
{
    const unsigned members = members_needed(call), partials = partials_needed(call);
    int missing = 0;
    memset(to, 0, sizeof *to);
    to->function = call->function;
    memcpy(to->out, call->out, sizeof to->out);
    for (int k = 0; k < call->inputs; k++) {
        const struct scarp_outputs *const in = (const struct scarp_outputs *)call->in[k];
        for (int m = 0; m < OUTPUTS; m++) {
            to->in[k][m] = (members >> m & 1) != 0 ? in->array[m] : NULL;
            missing |= (members >> m & 1) != 0 && in->array[m] == NULL;
        }
    }
    for (int i = 0; i < PARTIALS; i++) {
        const struct scarp_partial_arrays *const given =
            (const struct scarp_partial_arrays *)call->partials;
        to->partial[i] = (partials >> i & 1) != 0 ? given->array[i] : NULL;
        missing |= (partials >> i & 1) != 0 && given->array[i] == NULL;
    }
    return !missing;
}

static int reserved_in_use(const struct arguments *call)
{
    int used = spare_in_use(call->out);
    for (int k = 0; k < call->inputs; k++) {
        used |= spare_in_use(call->in[k]);
    }
    return used || (call->partials != NULL &&
                    (call->partials->spare[0] != NULL || call->partials->spare[1] != NULL));
}

/* The difference of a finite number from itself is 0. */
static int is_finite(float number)
{
    return number - number == 0.0f;
}

static int is_scale(float number)
{
    return number >= SCALE_MIN && number <= SCALE_MAX;
}

/*
 * What becomes of the numbers of functions that have some. 0: one is outside of its interval.
 */

/* Any finite numbers, as they are */
static int take_finite(float to[CHAIN_NUMBERS], const float given[3])
{
    memcpy(to, given, 3 * sizeof *given);
    return is_finite(given[0]) && is_finite(given[1]) && is_finite(given[2]);
}

static int take_clamp(float to[CHAIN_NUMBERS], const float given[3])
{
    return take_finite(to, given) && given[0] <= given[1];
}

static int take_smooth_min(float to[CHAIN_NUMBERS], const float given[3])
{
    const float k = given[0];
    if (!is_scale(k)) {
        return 0;
    }
    to[CHAIN_INVERSE] = 1.0f / k;
    to[CHAIN_DEPTH] = k / 6.0f;
    to[CHAIN_BEND] = -to[CHAIN_INVERSE];
    return 1;
}

static int take_smooth_max(float to[CHAIN_NUMBERS], const float given[3])
{
    const int good = take_smooth_min(to, given);
    to[CHAIN_DEPTH] = -to[CHAIN_DEPTH];
    to[CHAIN_BEND] = -to[CHAIN_BEND];
    return good;
}

static int take_smooth_abs(float to[CHAIN_NUMBERS], const float given[3])
{
    to[CHAIN_ROUND] = given[0];
    to[CHAIN_ROUND2] = given[0] * given[0];
    return is_scale(given[0]);
}

static int take_terrace(float to[CHAIN_NUMBERS], const float given[3])
{
    const float steps = given[0], riser = given[1], strength = given[2];
    if (!is_scale(steps) || !(riser >= RISER_MIN && riser <= 1.0f) ||
        !(strength >= 0.0f && strength <= 1.0f)) {
        return 0;
    }
    to[CHAIN_STEPS] = steps;
    to[CHAIN_HEIGHT] = 1.0f / steps;
    to[CHAIN_STEEP] = 1.0f / riser;
    to[CHAIN_STRENGTH] = strength;
    return 1;
}

static int take_smoothstep(float to[CHAIN_NUMBERS], const float given[3])
{
    const float lo = given[0], hi = given[1], width = hi - lo;
    if (!is_finite(lo) || !is_finite(hi) || (!is_scale(width) && !is_scale(-width))) {
        return 0;
    }
    to[CHAIN_LO] = lo;
    to[CHAIN_HI] = hi;
    to[CHAIN_INVERSE] = 1.0f / width;
    return 1;
}

int scarpi_chain_numbers(enum scarp_chain_function function, const float given[3],
                         float to[CHAIN_NUMBERS])
{
#define TAKE(NAME, take)                                                                           \
    case CHAIN_##NAME:                                                                             \
        return take_##take(to, given);
#define OPERATOR(NAME, name, FORM, COMPUTED, take, ...) IF_NUMBERS_##FORM(TAKE(NAME, take))
#define FUNCTION(...) OPERATOR(__VA_ARGS__)
    switch (function) {
#include "../plan/functions.def"
    default: return 1;
    }
}

static int asks_for_something(const struct scarp_chain *call)
{
    uintptr_t bits = 0;
    for (int m = 0; m < OUTPUTS; m++) {
        bits |= (uintptr_t)call->out[m];
    }
    return bits != 0;
}

/* Whether nothing is asked for but values, and no reserved member of the outputs is in use. */
static int asks_for_values(const struct scarp_samples *out)
{
    const struct scarp_request kind = scarpi_request_of_samples(3, out);
    return kind.order == 0 && !kind.dphase && out->value != NULL;
}

/* Makes a call for values only, as most calls of recipes at few points are. `in` and `f`, of partial
   derivatives, are NULL where the function does not read them. */
static void make_values(struct scarp_chain *to, enum scarp_chain_function function,
                        const float *const in[CHAIN_INPUTS], const float *f, float *out)
{
    to->function = function;
    to->has_values_only = 1;
    memset(to->number, 0, sizeof to->number);
    for (int k = 0; k < CHAIN_INPUTS; k++) {
        to->in[k][VALUE] = in[k];
    }
    to->partial[PARTIAL_F] = f;
    to->out[VALUE] = out;
}

/* take_arrays() for values only */
static int take_values(struct scarp_chain *to, const struct arguments *call)
{
    const int is_given = takes_partials(call->function);
    const float *in[CHAIN_INPUTS] = {NULL}, *const f = is_given ? call->partials->f : NULL;
    int missing = is_given && f == NULL;
    for (int k = 0; k < call->inputs && !is_given; k++) {
        in[k] = call->in[k]->value;
        missing |= in[k] == NULL;
    }
    make_values(to, call->function, in, f, call->out->value);
    return !missing;
}

static NOINLINE enum scarp_status run(const struct arguments *arguments, size_t count)
{
    struct scarp_chain call;
    const int has_values_only = asks_for_values(arguments->out);
    if (!(has_values_only ? take_values(&call, arguments) : take_arrays(&call, arguments))) {
        return SCARP_ERROR_NULL;
    }
    if (!scarpi_chain_numbers(arguments->function, arguments->number, call.number)) {
        return SCARP_ERROR_PARAMETER;
    }
    if (count > PTRDIFF_MAX / sizeof(float)) {
        return SCARP_ERROR_SIZE;
    }
    const struct scarp_kernels *const kernels = scarpi_dispatch_for(count);
    if (kernels == NULL || reserved_in_use(arguments)) {
        return SCARP_ERROR_UNSUPPORTED;
    }
    if (has_values_only || asks_for_something(&call)) {
        kernels->chain(&call, count);
    }
    return SCARP_OK;
}

enum scarp_status scarpi_chain_values(enum scarp_chain_function function, size_t count,
                                      const float *const in[CHAIN_INPUTS], const float given[3],
                                      float *out)
{
    const struct scarp_kernels *const kernels = scarpi_dispatch_for(count);
    struct scarp_chain call;
    make_values(&call, function, in, NULL, out);
    if (!scarpi_chain_numbers(function, given, call.number)) {
        return SCARP_ERROR_PARAMETER;
    }
    if (kernels == NULL) {
        return SCARP_ERROR_UNSUPPORTED;
    }
    kernels->chain(&call, count);
    return SCARP_OK;
}

static enum scarp_status apply(const struct arguments *arguments, size_t count)
{
    if (count == 0) {
        return SCARP_OK;
    }
    for (int k = 0; k < arguments->inputs; k++) {
        if (arguments->in[k] == NULL) {
            return SCARP_ERROR_NULL;
        }
    }
    if (arguments->out == NULL ||
        (takes_partials(arguments->function) && arguments->partials == NULL)) {
        return SCARP_ERROR_NULL;
    }
    const struct fpmode caller = fpmode_enter();
    const enum scarp_status status = run(arguments, count);
    fpmode_leave(caller);
    return status;
}

/* The calls of functions.def that kernels compute, by their forms */
#define COUNT size_t count
#define IN(a) const struct scarp_samples *a
#define OUT const struct scarp_samples *out
#define DEFINE(NAME, name, parameters, ...)                                                        \
    enum scarp_status scarp_##name parameters                                                      \
    {                                                                                              \
        const struct arguments call = {CHAIN_##NAME, __VA_ARGS__, .out = out};                     \
        return apply(&call, count);                                                                \
    }
#define DEFINE_ONE_0(NAME, name) DEFINE(NAME, name, (COUNT, IN(a), OUT), 1, {a})
#define DEFINE_ONE_1(NAME, name)                                                                   \
    DEFINE(NAME, name, (COUNT, IN(a), float p, OUT), 1, {a}, .number = {p})
#define DEFINE_ONE_2(NAME, name)                                                                   \
    DEFINE(NAME, name, (COUNT, IN(a), float p, float q, OUT), 1, {a}, .number = {p, q})
#define DEFINE_ONE_3(NAME, name)                                                                   \
    DEFINE(NAME, name, (COUNT, IN(a), float p, float q, float r, OUT), 1, {a}, .number = {p, q, r})
#define DEFINE_TWO_0(NAME, name) DEFINE(NAME, name, (COUNT, IN(a), IN(b), OUT), 2, {a, b})
#define DEFINE_TWO_1(NAME, name)                                                                   \
    DEFINE(NAME, name, (COUNT, IN(a), IN(b), float p, OUT), 2, {a, b}, .number = {p})
#define DEFINE_THREE_0(NAME, name)                                                                 \
    DEFINE(NAME, name, (COUNT, IN(a), IN(b), IN(m), OUT), 3, {a, b, m})

#define OPERATOR(NAME, name, FORM, COMPUTED, ...) IF_KERNEL_##COMPUTED(DEFINE_##FORM(NAME, name))
#define FUNCTION(...) OPERATOR(__VA_ARGS__)
#include "../plan/functions.def"

enum scarp_status scarp_apply1(size_t count, const struct scarp_samples *a,
                               const struct scarp_partials *function,
                               const struct scarp_samples *out)
{
    const struct arguments call = {CHAIN_APPLY1, 1, {a}, .out = out, .partials = function};
    return apply(&call, count);
}

enum scarp_status scarp_apply2(size_t count, const struct scarp_samples *a,
                               const struct scarp_samples *b, const struct scarp_partials *function,
                               const struct scarp_samples *out)
{
    const struct arguments call = {CHAIN_APPLY2, 2, {a, b}, .out = out, .partials = function};
    return apply(&call, count);
}
