/* SPDX-License-Identifier: MIT
 *
 * Functions of samples, with any samples; and normals.
 */
#include "../../src/plan/functions.h"
#include "../outputs.h"

#include "arguments.h"

#define OPERATOR(NAME, ...) NAME,
#define FUNCTION(NAME, ...) NAME,
enum function_of_samples {
#include "../../src/plan/functions.def"
    APPLY1,
    APPLY2,
    NORMALS,
    CHAIN_FUNCTIONS
};

#define PARTIALS 6
#define NUMBERS (FUZZ_ROOM - 64)

struct arguments {
    enum function_of_samples function;
    float number[3];
    size_t knots;
    float knot[2][SCARP_CURVE_KNOTS + 1];
    float *in[3][OUTPUTS], *partial[PARTIALS];
};

static struct scarp_samples samples_at(float *const in[OUTPUTS], size_t first)
{
    float *pointers[FUZZ_MEMBERS] = {NULL};
    for (int m = 0; m < OUTPUTS; m++) {
        pointers[m] = in[m] != NULL ? in[m] + first : NULL;
    }
    return *FUZZ_AS(scarp_samples, pointers);
}

static enum scarp_status make(const struct fuzz_call *call, size_t first, size_t count,
                              float *const pointers[FUZZ_OUTPUTS])
{
    const struct arguments *const a = call->arguments;
    const struct scarp_samples s = samples_at(a->in[0], first), b = samples_at(a->in[1], first),
                               m = samples_at(a->in[2], first);
    const struct scarp_samples *const out = FUZZ_AS(scarp_samples, pointers);
    const float *p[PARTIALS];
    for (int i = 0; i < PARTIALS; i++) {
        p[i] = a->partial[i] != NULL ? a->partial[i] + first : NULL;
    }
    const struct scarp_partials partials = {p[0], p[1], p[2], p[3], p[4], p[5], {NULL}};
    const struct scarp_samples *const in[3] = {&s, &b, &m};
#define FORM_CURVE(function, count, in, k, out)                                                    \
    function(count, (in)[0], a->knots, a->knot[0], a->knot[1], out)
#define OPERATOR(NAME, name, FORM, ...)                                                            \
    case NAME:                                                                                     \
        return FORM_##FORM(scarp_##name, count, in, a->number, out);
#define FUNCTION(...) OPERATOR(__VA_ARGS__)
    switch (a->function) {
#include "../../src/plan/functions.def"
    case APPLY1: return scarp_apply1(count, &s, &partials, out);
    case APPLY2: return scarp_apply2(count, &s, &b, &partials, out);
    default:
        return scarp_normals(count, s.dx, s.dy, a->number[0], pointers[0], pointers[1],
                             pointers[2]);
    }
}

/* Numbers between -2 and 2, some of them in all arrays of an input alike, or wild ones. */
static void draw_inputs(struct draw *d, struct arguments *a, int wild)
{
    static float memory[3 * OUTPUTS + PARTIALS][FUZZ_ROOM];
    uint64_t state = draw_bits(d, 4);
    float strange[4];
    for (int i = 0; i < 4; i++) {
        strange[i] = wild ? (float)draw_wild(d) : (float)draw_between(d, -1.0, 1.0);
    }
    for (size_t row = 0; row < sizeof memory / sizeof memory[0]; row++) {
        for (size_t i = 0; i < FUZZ_ROOM; i++) {
            state = state * UINT64_C(6364136223846793005) + 1442695040888963407;
            const uint32_t r = (uint32_t)(state >> 33);
            memory[row][i] = r % 32 < 4 ? strange[r % 32] : (float)((double)r * 0x1p-29 - 2.0);
        }
    }
    for (int k = 0; k < 3; k++) {
        for (int m = 0; m < OUTPUTS; m++) {
            a->in[k][m] = wild && draw_rarely(d, 64) ? NULL : memory[k * OUTPUTS + m];
        }
    }
    for (int i = 0; i < PARTIALS; i++) {
        a->partial[i] = wild && draw_rarely(d, 64) ? NULL : memory[3 * OUTPUTS + i];
    }
}

/* Numbers that the function takes, unless `wild` */
static void draw_numbers(struct draw *d, struct arguments *a, int wild)
{
    const int is_clamp = a->function == CLAMP || a->function == AFFINE;
    for (int i = 0; i < 3; i++) {
        a->number[i] = wild && draw_rarely(d, 4)         ? (float)draw_wild(d)
                       : is_clamp                        ? (float)draw_between(d, -2.0, 2.0)
                       : a->function == SMOOTHSTEP       ? (float)draw_between(d, -2.0, 2.0)
                       : a->function == TERRACE && i > 0 ? (float)draw_scale(d, 0x1p-20, 1.0)
                                                         : (float)draw_scale(d, 0x1p-6, 0x1p6);
    }
    if (a->function == CLAMP && a->number[0] > a->number[1] && !wild) {
        const float lo = a->number[1];
        a->number[1] = a->number[0];
        a->number[0] = lo;
    }
    a->knots = a->function == CURVE ? draw_below(d, SCARP_CURVE_KNOTS + 2) : 0;
    float x = -2.0f;
    for (size_t k = 0; k < a->knots && k <= SCARP_CURVE_KNOTS; k++) {
        x += (float)draw_scale(d, 0x1p-8, 0.5);
        a->knot[0][k] = wild && draw_rarely(d, 8) ? (float)draw_wild(d) : x;
        a->knot[1][k] =
            wild && draw_rarely(d, 8) ? (float)draw_wild(d) : (float)draw_between(d, -2.0, 2.0);
    }
}

/* The interval that some functions promise for any number. Returns 0 for others. */
static int promised_range(const struct arguments *a, float range[2])
{
    range[0] = a->function == PULSE || a->function == SINE ? -1.0f : 0.0f;
    range[1] = 1.0f;
    switch (a->function) {
    case ABS:
    case SMOOTH_ABS:
    case SQRT:
    case SLOPE: range[1] = INFINITY; return 1;
    case SMOOTHSTEP:
    case PULSE:
    case SINE: return 1;
    case CLAMP:
        range[0] = a->number[0];
        range[1] = a->number[1];
        return 1;
    case CURVE:
        range[0] = range[1] = a->knot[1][0];
        for (size_t k = 0; k < a->knots; k++) {
            range[0] = a->knot[1][k] < range[0] ? a->knot[1][k] : range[0];
            range[1] = a->knot[1][k] > range[1] ? a->knot[1][k] : range[1];
        }
        return 1;
    default: return 0;
    }
}

/* b may be 0. */
#ifdef __GNUC__
__attribute__((no_sanitize("float-divide-by-zero")))
#endif
static float
quotient(float a, float b)
{
    return a / b;
}

static void check_values(const struct arguments *a, const struct fuzz_call *call)
{
    float range[2];
    const int is_promised = promised_range(a, range);
    for (size_t i = 0; i < call->count && (call->mask & 1) != 0; i++) {
        const float value = fuzz_result[OUTPUT_value][i];
        const float s = a->in[0][0] != NULL ? a->in[0][0][i] : 0.0f;
        const float b = a->in[1][0] != NULL ? a->in[1][0][i] : 0.0f;
        fuzz_must(!is_promised || fuzz_is_nan(value) || (value >= range[0] && value <= range[1]));
        switch (a->function) { /* written as the header has them */
        case ADD: fuzz_must(fuzz_equal(value, s + b)); break;
        case MIN: fuzz_must(fuzz_equal(value, b < s || fuzz_is_nan(b) ? b : s)); break;
        case MAX: fuzz_must(fuzz_equal(value, b > s || fuzz_is_nan(b) ? b : s)); break;
        case MULTIPLY: fuzz_must(fuzz_equal(value, s == 0.0f || b == 0.0f ? 0.0f : s * b)); break;
        case DIVIDE: fuzz_must(fuzz_equal(value, quotient(s, b))); break;
        default: break;
        }
    }
    for (size_t i = 0; a->function == NORMALS && i < call->count && (call->mask & 7) == 7; i++) {
        const double x = fuzz_result[0][i], y = fuzz_result[1][i], z = fuzz_result[2][i];
        fuzz_must(fuzz_is_nan((float)x) == fuzz_is_nan((float)z) && !(z < 0.0));
        fuzz_must(fuzz_is_nan((float)x) || fabs(x * x + y * y + z * z - 1.0) < 1e-6);
    }
}

void fuzz_chain(const uint8_t *bytes, size_t size)
{
    static struct arguments a;
    struct draw d = {bytes, size};
    a.function = (enum function_of_samples)draw_below(&d, CHAIN_FUNCTIONS);
    const int wild = draw_rarely(&d, 4);
    draw_numbers(&d, &a, wild);
    draw_inputs(&d, &a, wild);
    struct fuzz_call call = {.make = make, .arguments = &a};
    call.count = draw_rarely(&d, 4) ? (size_t)(draw_bits(&d, 2) % NUMBERS) : draw_byte(&d) % 70;
    call.mask = draw_bits(&d, 2) & (a.function == NORMALS ? 7 : (1u << OUTPUTS) - 1);
    if (a.function == SLOPE && !wild) {
        call.mask &= 15;
    }
    size_t inputs = 0;
    for (int k = 0; k < 3; k++) {
        for (int m = 0; m < OUTPUTS; m++) {
            call.inputs[inputs++] = &a.in[k][m];
        }
    }
    for (int i = 0; i < PARTIALS; i++) {
        call.inputs[inputs++] = &a.partial[i];
    }
    const enum scarp_status status = fuzz_check(&d, &call);
    /* scarp_curve with knots that are drawn may have too few. */
    fuzz_must(status == SCARP_OK || wild || a.function == SMOOTHSTEP ||
              (a.function == CURVE && (a.knots < 2 || a.knots > SCARP_CURVE_KNOTS)));
    if (status == SCARP_OK) {
        check_values(&a, &call);
    }
}
