/* SPDX-License-Identifier: MIT
 *
 * The public functions of the chain rule that are plain C: they compute a function and its partial
 * derivatives, some points at a time, and leave the rest to scarp_apply1 and scarp_apply2.
 */
#include "partials.h"

#include <math.h>
#include <string.h>

#include "../dispatch/dispatch.h"
#include "../dispatch/fpmode.h"
#include "../plan/functions.h"
#include "../plan/outputs.h"
#include "run.h"
#include "scarp.h"

#define POINTS 256
#define LIMIT 0x1p60f

#ifdef __GNUC__
#define DIVIDES_BY_0 __attribute__((no_sanitize("float-divide-by-zero")))
#else
#define DIVIDES_BY_0
#endif

/* The function at some points, and its derivatives. */
struct partials {
    float f[POINTS], fa[POINTS], fb[POINTS], faa[POINTS], fab[POINTS], fbb[POINTS];
};

struct curve {
    size_t knots;
    const float *x, *value;
    float slope[SCARP_CURVE_KNOTS];
};

/* How functions are computed: at `count` points, of the values a and b. */
typedef void fill_fn(size_t count, const float *a, const float *b, const struct curve *curve,
                     struct partials *to);

/* The Taylor series around the nearest multiple of a quarter */
double scarpi_sine_of_turns(double turns)
{
    const double scaled = 4.0 * turns;
    const int64_t quarters = (int64_t)(scaled < 0.0 ? scaled - 0.5 : scaled + 0.5);
    const double x = (scaled - (double)quarters) * 1.5707963267948966, square = x * x;
    const int odd = (quarters & 1) != 0;
    double sum = 1.0;
    for (int n = odd ? 18 : 19; n > 1; n -= 2) {
        sum = 1.0 - square / (double)(n * (n - 1)) * sum;
    }
    const double magnitude = odd ? sum : x * sum;
    return (quarters & 2) == 0 ? magnitude : -magnitude;
}

/* A quotient by 0 is infinite or NaN, as promised, and no mistake. */
static DIVIDES_BY_0 void fill_divide(size_t count, const float *a, const float *b,
                                     const struct curve *curve, struct partials *to)
{
    (void)curve;
    for (size_t i = 0; i < count; i++) {
        const float r = 1.0f / b[i], f = a[i] / b[i];
        to->f[i] = f;
        to->fa[i] = r;
        to->fb[i] = -(f * r);
        to->faa[i] = 0.0f;
        to->fab[i] = -(r * r);
        to->fbb[i] = 2.0f * (f * r) * r;
    }
}

static void fill_sqrt(size_t count, const float *a, const float *b, const struct curve *curve,
                      struct partials *to)
{
    (void)b;
    (void)curve;
    for (size_t i = 0; i < count; i++) {
        const float v = a[i] < 0.0f ? 0.0f : a[i]; /* NaN stays */
        const float root = sqrtf(v);
        const float slope = v == 0.0f ? 0.0f : 0.5f / root;
        to->f[i] = root;
        to->fa[i] = slope;
        to->faa[i] = v == 0.0f ? 0.0f : -(slope * (0.5f / v));
    }
}

/* All floats of 2^24 and more are whole numbers of turns. */
static void fill_sine(size_t count, const float *a, const float *b, const struct curve *curve,
                      struct partials *to)
{
    (void)b;
    (void)curve;
    for (size_t i = 0; i < count; i++) {
        const int is_small = a[i] > -0x1p24f && a[i] < 0x1p24f;
        const double turns = is_small ? (double)a[i] : 0.0;
        const float nan = a[i] - a[i]; /* 0 of finite numbers */
        const double sine = scarpi_sine_of_turns(turns),
                     cosine = scarpi_sine_of_turns(turns + 0.25);
        to->f[i] = (float)sine + nan;
        to->fa[i] = (float)(6.283185307179586 * cosine) + nan;
        to->faa[i] = (float)(-39.47841760435743 * sine) + nan;
    }
}

/* All floats of 2^24 and more are even. */
static void fill_pulse(size_t count, const float *a, const float *b, const struct curve *curve,
                       struct partials *to)
{
    (void)b;
    (void)curve;
    for (size_t i = 0; i < count; i++) {
        const float nan = a[i] - a[i];
        const float v = a[i] > -0x1p24f && a[i] < 0x1p24f ? a[i] : 0.0f;
        int32_t whole = (int32_t)v;
        whole -= (float)whole > v;
        const float fraction = v - (float)whole;
        const float up = 2.0f * fraction - 1.0f;
        const int odd = (whole & 1) != 0;
        to->f[i] = (odd ? -up : up) + nan;
        to->fa[i] = (fraction == 0.0f ? 0.0f : odd ? -2.0f : 2.0f) + nan;
        to->faa[i] = nan;
    }
}

static void fill_curve(size_t count, const float *a, const float *b, const struct curve *curve,
                       struct partials *to)
{
    const float *const x = curve->x, *const y = curve->value;
    (void)b;
    for (size_t i = 0; i < count; i++) {
        size_t n = 0;
        while (n + 2 < curve->knots && a[i] >= x[n + 1]) {
            n++;
        }
        const float width = x[n + 1] - x[n], inverse = 1.0f / width;
        const float t = (a[i] - x[n]) * inverse;
        const float rise = y[n + 1] - y[n];
        const float s0 = curve->slope[n] * width, s1 = curve->slope[n + 1] * width;
        const float c2 = 3.0f * rise - 2.0f * s0 - s1, c3 = s0 + s1 - 2.0f * rise;
        const float lowest = y[n] < y[n + 1] ? y[n] : y[n + 1];
        const float highest = y[n] < y[n + 1] ? y[n + 1] : y[n];
        const float v = y[n] + t * (s0 + t * (c2 + t * c3));
        const float held = v < lowest ? lowest : v > highest ? highest : v;
        const int before = a[i] <= x[0], behind = a[i] >= x[curve->knots - 1]; /* neither of NaN */
        const int level = before || behind;
        to->f[i] = before ? y[0] : behind ? y[curve->knots - 1] : held;
        to->fa[i] = level ? 0.0f : (s0 + t * (2.0f * c2 + t * (3.0f * c3))) * inverse;
        to->faa[i] = level ? 0.0f : ((2.0f * c2 + t * (6.0f * c3)) * inverse) * inverse;
    }
}

/* A point at a knot belongs to the cubic that begins there, which has the slope of the knot. */
int scarpi_curve_slopes(size_t knots, const float *x, const float *value, float *slope)
{
    for (size_t k = 0; k < knots; k++) {
        const int is_in =
            x[k] >= -LIMIT && x[k] <= LIMIT && value[k] >= -LIMIT && value[k] <= LIMIT;
        if (!is_in || (k > 0 && !(x[k] - x[k - 1] >= 1.0f / LIMIT))) {
            return 0;
        }
        slope[k] = 0.0f;
    }
    for (size_t k = 1; k + 1 < knots; k++) {
        const float s = (value[k] - value[k - 1]) / (x[k] - x[k - 1]);
        const float t = (value[k + 1] - value[k]) / (x[k + 1] - x[k]);
        const int same = (s > 0.0f && t > 0.0f) || (s < 0.0f && t < 0.0f);
        slope[k] = same ? 2.0f * (s / (s + t)) * t : 0.0f;
    }
    return 1;
}

static struct scarp_samples shifted(const struct scarp_samples *samples, size_t by)
{
    struct scarp_samples s = *samples; /* reserved members, too */
    for (int i = 0; i < OUTPUTS; i++) {
        float *const given = scarpi_outputs_of(samples)->array[i];
        float *const array = given == NULL ? NULL : given + by;
        memcpy((char *)&s + (size_t)i * sizeof array, &array, sizeof array);
    }
    return s;
}

static int asks_for_nothing(const struct scarp_samples *out)
{
    int asked = 0;
    for (int i = 0; i < OUTPUTS; i++) {
        asked |= scarpi_outputs_of(out)->array[i] != NULL;
    }
    return !asked;
}

/* The arguments of a call: b is NULL for functions of a. */
struct arguments {
    size_t count;
    const struct scarp_samples *a, *b, *out;
    fill_fn *fill;
    const struct curve *curve;
};

static enum scarp_status apply(const struct arguments *call, size_t at, size_t count,
                               struct partials *room)
{
    const struct scarp_samples a = shifted(call->a, at), out = shifted(call->out, at);
    const struct scarp_partials function = {.f = room->f,
                                            .fa = room->fa,
                                            .fb = room->fb,
                                            .faa = room->faa,
                                            .fab = room->fab,
                                            .fbb = room->fbb};
    if (call->b == NULL) {
        return scarp_apply1(count, &a, &function, &out);
    }
    const struct scarp_samples b = shifted(call->b, at);
    return scarp_apply2(count, &a, &b, &function, &out);
}

/* An error is one of the first points, too, before anything is written. */
static NOINLINE enum scarp_status compute(const struct arguments *call)
{
    struct partials room;
    enum scarp_status status = SCARP_OK;
    for (size_t at = 0; status == SCARP_OK && at < call->count; at += POINTS) {
        const size_t left = call->count - at, count = left < POINTS ? left : POINTS;
        if (call->fill != NULL) {
            call->fill(count, call->a->value + at, call->b != NULL ? call->b->value + at : NULL,
                       call->curve, &room);
        }
        status = apply(call, at, count, &room);
    }
    return status;
}

static enum scarp_status run(const struct arguments *call)
{
    if (call->count == 0) {
        return SCARP_OK;
    }
    if (call->a == NULL || call->out == NULL) {
        return SCARP_ERROR_NULL;
    }
    const int has_values = call->a->value != NULL && (call->b == NULL || call->b->value != NULL);
    const int is_idle = asks_for_nothing(call->out);
    if (!has_values && !is_idle) {
        return SCARP_ERROR_NULL;
    }
    if (call->count > PTRDIFF_MAX / sizeof(float)) {
        return SCARP_ERROR_SIZE;
    }
    if (scarpi_dispatch_refuses()) {
        return SCARP_ERROR_UNSUPPORTED;
    }
    struct arguments some = *call;
    if (is_idle) { /* the rest of the arguments is to be checked nevertheless */
        some.count = 1;
        some.fill = NULL;
    }
    const struct fpmode caller = fpmode_enter();
    const enum scarp_status status = compute(&some);
    fpmode_leave(caller);
    return status;
}

/* The calls of functions.def that are plain C, by their forms */
#define DEFINE_ONE_0(name)                                                                         \
    enum scarp_status scarp_##name(size_t count, const struct scarp_samples *a,                    \
                                   const struct scarp_samples *out)                                \
    {                                                                                              \
        const struct arguments call = {.count = count, .a = a, .out = out, .fill = fill_##name};   \
        return run(&call);                                                                         \
    }
#define DEFINE_TWO_0(name)                                                                         \
    enum scarp_status scarp_##name(size_t count, const struct scarp_samples *a,                    \
                                   const struct scarp_samples *b, const struct scarp_samples *out) \
    {                                                                                              \
        const struct arguments call = {                                                            \
            .count = count, .a = a, .b = b, .out = out, .fill = fill_##name};                      \
        return count > 0 && b == NULL ? SCARP_ERROR_NULL : run(&call);                             \
    }
#define OPERATOR(NAME, name, FORM, COMPUTED, ...) IF_PLAIN_##COMPUTED(DEFINE_##FORM(name))
#define FUNCTION(...) OPERATOR(__VA_ARGS__)
#include "../plan/functions.def"

static NOINLINE int make_curve(struct curve *curve)
{
    return curve->knots >= 2 && curve->knots <= SCARP_CURVE_KNOTS &&
           scarpi_curve_slopes(curve->knots, curve->x, curve->value, curve->slope);
}

enum scarp_status scarp_curve(size_t count, const struct scarp_samples *a, size_t knots,
                              const float *x, const float *value, const struct scarp_samples *out)
{
    struct curve curve = {.knots = knots, .x = x, .value = value};
    const struct arguments call = {
        .count = count, .a = a, .out = out, .fill = fill_curve, .curve = &curve};
    if (count == 0) {
        return SCARP_OK;
    }
    if (a == NULL || out == NULL || x == NULL || value == NULL) {
        return SCARP_ERROR_NULL;
    }
    const struct fpmode caller = fpmode_enter();
    const int good = make_curve(&curve);
    fpmode_leave(caller);
    return good ? run(&call) : SCARP_ERROR_PARAMETER;
}

/* The members that are the second derivatives with respect to x, y and z along an axis */
static const unsigned char second[3][3] = {{DXX, DXY, DXZ}, {DXY, DYY, DYZ}, {DXZ, DYZ, DZZ}};

struct slope_call {
    float *gradient[3], *along[3][3]; /* along[i]: of a, along axis i */
    float *out[4];
    int dimensions;
};

/* Outputs may be where inputs are, so a point is read before it is written. */
static NOINLINE void find_slopes(const struct slope_call *call, size_t count)
{
    for (size_t n = 0; n < count; n++) {
        float g[3], square = 0.0f, result[4];
        for (int i = 0; i < call->dimensions; i++) {
            g[i] = call->gradient[i][n];
            square = i == 0 ? g[0] * g[0] : square + g[i] * g[i];
        }
        result[0] = sqrtf(square);
        for (int i = 0; i < 3; i++) {
            float sum = 0.0f;
            for (int j = 0; j < call->dimensions && call->out[i + 1] != NULL; j++) {
                sum += g[j] * call->along[i][j][n];
            }
            result[i + 1] = result[0] == 0.0f ? 0.0f : sum / result[0];
        }
        for (int i = 0; i < 4; i++) {
            if (call->out[i] != NULL) {
                call->out[i][n] = result[i];
            }
        }
    }
}

static int is_unsupported(const struct scarp_samples *a, const struct scarp_samples *out)
{
    int used = out->dphase != NULL || spare_in_use(a) || spare_in_use(out);
    for (int m = DXX; m <= DZZ; m++) {
        used |= scarpi_outputs_of(out)->array[m] != NULL;
    }
    return used;
}

enum scarp_status scarp_slope(size_t count, const struct scarp_samples *a,
                              const struct scarp_samples *out)
{
    struct slope_call call = {.dimensions = 2};
    int missing = 0;
    if (count == 0) {
        return SCARP_OK;
    }
    if (a == NULL || out == NULL) {
        return SCARP_ERROR_NULL;
    }
    call.dimensions += a->dz != NULL;
    for (int i = 0; i < 3; i++) {
        call.out[i + 1] = scarpi_outputs_of(out)->array[DX + i];
        call.gradient[i] = scarpi_outputs_of(a)->array[DX + i];
        missing |= i < call.dimensions && call.gradient[i] == NULL && !asks_for_nothing(out);
        for (int j = 0; j < call.dimensions; j++) {
            call.along[i][j] = scarpi_outputs_of(a)->array[second[i][j]];
            missing |= call.out[i + 1] != NULL && call.along[i][j] == NULL;
        }
    }
    call.out[0] = out->value;
    if (missing) {
        return SCARP_ERROR_NULL;
    }
    if (count > PTRDIFF_MAX / sizeof(float)) {
        return SCARP_ERROR_SIZE;
    }
    if (scarpi_dispatch_refuses() || is_unsupported(a, out)) {
        return SCARP_ERROR_UNSUPPORTED;
    }
    if (!asks_for_nothing(out)) {
        const struct fpmode caller = fpmode_enter();
        find_slopes(&call, count);
        fpmode_leave(caller);
    }
    return SCARP_OK;
}
