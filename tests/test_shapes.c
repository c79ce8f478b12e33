/* SPDX-License-Identifier: MIT
 *
 * Usage: test_shapes
 *
 * scarp_divide, scarp_sqrt, scarp_sine, scarp_pulse, scarp_curve and scarp_slope: values and
 * derivatives against double, the same bits for any length and in place, NaN, and errors, after
 * which nothing is written.
 */
#include "../src/plan/functions.h"
#include "check.h"

#define COUNT 700
#define ARRAYS 11

/* The functions that are plain C */
#define OPERATOR(NAME, name, FORM, COMPUTED, ...) IF_PLAIN_##COMPUTED(NAME, )
#define FUNCTION(...) OPERATOR(__VA_ARGS__)
enum shape {
#include "../src/plan/functions.def"
    CURVE,
    SHAPES
};

#define OPERATOR(NAME, name, FORM, COMPUTED, ...) IF_PLAIN_##COMPUTED("scarp_" #name, )
static const char *const names[SHAPES] = {
#define FUNCTION(...) OPERATOR(__VA_ARGS__)
#include "../src/plan/functions.def"
    "scarp_curve"};

#define KNOTS 5
static const float knot_x[KNOTS] = {-1.0f, -0.5f, 0.0f, 0.75f, 1.5f};
static const float knot_value[KNOTS] = {2.0f, -1.0f, -1.5f, 3.0f, 3.5f};

/* f and its derivatives with respect to a and b, in double */
struct partials {
    double f, fa, fb, faa, fab, fbb;
};

static double curve_slope(int k)
{
    if (k == 0 || k == KNOTS - 1) {
        return 0.0;
    }
    const double l =
        ((double)knot_value[k] - knot_value[k - 1]) / ((double)knot_x[k] - knot_x[k - 1]);
    const double r =
        ((double)knot_value[k + 1] - knot_value[k]) / ((double)knot_x[k + 1] - knot_x[k]);
    return l * r > 0.0 ? 2.0 * l * r / (l + r) : 0.0;
}

static struct partials curve_at(double x)
{
    struct partials p = {0};
    int k = 0;
    if (x <= knot_x[0] || x >= knot_x[KNOTS - 1]) {
        p.f = (double)knot_value[x <= knot_x[0] ? 0 : KNOTS - 1];
        return p;
    }
    while (x >= knot_x[k + 1]) {
        k++;
    }
    const double w = (double)knot_x[k + 1] - knot_x[k], t = (x - knot_x[k]) / w;
    const double y0 = knot_value[k], y1 = knot_value[k + 1];
    const double s0 = curve_slope(k) * w, s1 = curve_slope(k + 1) * w;
    const double c = 3.0 * (y1 - y0) - 2.0 * s0 - s1, d = s0 + s1 - 2.0 * (y1 - y0);
    p.f = y0 + t * s0 + t * t * c + t * t * t * d;
    p.fa = (s0 + 2.0 * t * c + 3.0 * t * t * d) / w;
    p.faa = (2.0 * c + 6.0 * t * d) / (w * w);
    return p;
}

static struct partials partials_at(enum shape shape, double a, double b)
{
    if (shape == DIVIDE) {
        return (struct partials){a / b, 1.0 / b,        -a / (b * b),
                                 0.0,   -1.0 / (b * b), 2.0 * a / (b * b * b)};
    }
    const double k[3] = {1.0, 1.0, 1.0};
    (void)k;
#define TURN 6.283185307179586
#define DERIVED(name, value, first, second, ...)                                                   \
    if (strcmp(names[shape], "scarp_" #name) == 0) {                                               \
        return (struct partials){.f = value, .fa = first, .faa = second};                          \
    }
#include "functions.def"
    return curve_at(a);
}

struct arrays {
    float array[ARRAYS][COUNT];
};
static struct arrays a, b, out, other;

static struct scarp_samples samples_of(struct arrays *of, size_t from)
{
    float *p[ARRAYS];
    for (int i = 0; i < ARRAYS; i++) {
        p[i] = of->array[i] + from;
    }
    const struct scarp_samples s = {p[0], p[1], p[2], p[3], p[4],  p[5],
                                    p[6], p[7], p[8], p[9], p[10], {NULL}};
    return s;
}

static enum scarp_status call(enum shape shape, size_t count, const struct scarp_samples *x,
                              const struct scarp_samples *y, const struct scarp_samples *to)
{
    const struct scarp_samples *const in[2] = {x, y};
#define CALL(NAME, name, FORM)                                                                     \
    case NAME:                                                                                     \
        return FORM_##FORM(scarp_##name, count, in, NULL, to);
#define OPERATOR(NAME, name, FORM, COMPUTED, ...) IF_PLAIN_##COMPUTED(CALL(NAME, name, FORM))
#define FUNCTION(...) OPERATOR(__VA_ARGS__)
    switch (shape) {
#include "../src/plan/functions.def"
    default: return scarp_curve(count, x, KNOTS, knot_x, knot_value, to);
    }
}

static void set_inputs(void)
{
    uint64_t state = 5;
    for (int i = 0; i < ARRAYS; i++) {
        for (int k = 0; k < COUNT; k++) {
            a.array[i][k] = (float)check_random_double(&state, 2.0);
            b.array[i][k] = (float)check_random_double(&state, 2.0);
        }
    }
}

/* Points at the knots of the curve, and close to them */
static void set_knots(void)
{
    for (int k = 0; k < KNOTS; k++) {
        a.array[0][3 * k] = knot_x[k];
        a.array[0][3 * k + 1] = nextafterf(knot_x[k], -9.0f);
        a.array[0][3 * k + 2] = nextafterf(knot_x[k], 9.0f);
    }
}

/* Members 1 to 3 and 10 are first derivatives, 4 to 9 second ones along these axes. */
static double exact(enum shape shape, int member, int k)
{
    static const int axes[ARRAYS][2] = {
        [4] = {1, 1}, [5] = {1, 2}, [6] = {1, 3}, [7] = {2, 2}, [8] = {2, 3}, [9] = {3, 3}};
    const struct partials p = partials_at(shape, (double)a.array[0][k], (double)b.array[0][k]);
    const double a_i = (double)a.array[axes[member][0]][k],
                 a_j = (double)a.array[axes[member][1]][k];
    const double b_i = (double)b.array[axes[member][0]][k],
                 b_j = (double)b.array[axes[member][1]][k];
    const double a_m = (double)a.array[member][k], b_m = (double)b.array[member][k];
    if (member == 0) {
        return p.f;
    }
    if (member < 4 || member == 10) {
        return p.fa * a_m + p.fb * b_m;
    }
    return p.fa * a_m + p.fb * b_m + p.faa * a_i * a_j + p.fab * (a_i * b_j + a_j * b_i) +
           p.fbb * b_i * b_j;
}

static void check_shape(enum shape shape)
{
    const struct scarp_samples x = samples_of(&a, 0), y = samples_of(&b, 0),
                               to = samples_of(&out, 0);
    CHECK(call(shape, COUNT, &x, &y, &to) == SCARP_OK, "%s", names[shape]);
    for (int member = 0; member < ARRAYS; member++) {
        for (int k = 0; k < COUNT; k++) {
            const struct partials p =
                partials_at(shape, (double)a.array[0][k], (double)b.array[0][k]);
            const double scale =
                fabs(p.f) + fabs(p.fa) + fabs(p.fb) + fabs(p.faa) + fabs(p.fab) + fabs(p.fbb) + 1.0;
            const double error = fabs((double)out.array[member][k] - exact(shape, member, k));
            CHECK(error <= 1e-5 * scale, "%s, member %d, %d: %g is off by %g", names[shape], member,
                  k, (double)out.array[member][k], error);
        }
    }
    /* In pieces, and in place */
    memcpy(&other, &a, sizeof other);
    for (size_t from = 0; from < COUNT; from += 37) {
        const size_t count = COUNT - from < 37 ? COUNT - from : 37;
        const struct scarp_samples piece = samples_of(&other, from), with = samples_of(&b, from);
        CHECK(call(shape, count, &piece, &with, &piece) == SCARP_OK, "%s in place", names[shape]);
    }
    CHECK(memcmp(&other, &out, sizeof out) == 0, "%s differs in pieces and in place", names[shape]);
}

static void check_special(enum shape shape)
{
    float v[4] = {NAN, 0.0f, INFINITY, 3e20f}, slope[4] = {1.0f, 1.0f, 1.0f, 1.0f}, f[4], fx[4];
    const struct scarp_samples x = {.value = v, .dx = slope}, y = {.value = slope, .dx = slope};
    const struct scarp_samples to = {.value = f, .dx = fx};
    CHECK(call(shape, 4, &x, &y, &to) == SCARP_OK, "%s", names[shape]);
    CHECK(f[0] != f[0] && fx[0] != fx[0], "%s of NaN is %g, %g", names[shape], (double)f[0],
          (double)fx[0]);
    CHECK(f[1] == f[1] && fx[1] == fx[1], "%s of 0 is %g, %g", names[shape], (double)f[1],
          (double)fx[1]);
    CHECK(f[3] == f[3], "%s of 3e20 is %g", names[shape], (double)f[3]);
    if (shape == SINE || shape == PULSE) {
        CHECK(f[2] != f[2], "%s of infinity is %g", names[shape], (double)f[2]);
        CHECK(f[3] == (shape == SINE ? 0.0f : -1.0f), "%s of 3e20 is %g", names[shape],
              (double)f[3]);
    }
}

static void check_errors(enum shape shape)
{
    struct scarp_samples x = samples_of(&a, 0), y = samples_of(&b, 0), to = samples_of(&out, 0);
    memcpy(&other, &out, sizeof out);
    struct scarp_samples none = x, reserved = to;
    none.value = NULL;
    reserved.spare[2] = out.array[0];
    CHECK(call(shape, COUNT, NULL, &y, &to) == SCARP_ERROR_NULL, "%s, a", names[shape]);
    CHECK(call(shape, COUNT, &x, &y, NULL) == SCARP_ERROR_NULL, "%s, out", names[shape]);
    CHECK(call(shape, COUNT, &none, &y, &to) == SCARP_ERROR_NULL, "%s, values", names[shape]);
    none = x;
    none.dxy = NULL;
    CHECK(call(shape, COUNT, &none, &y, &to) == SCARP_ERROR_NULL, "%s, dxy", names[shape]);
    CHECK(call(shape, COUNT, &x, &y, &reserved) == SCARP_ERROR_UNSUPPORTED, "%s, spare",
          names[shape]);
    CHECK(call(shape, SIZE_MAX / 2, &x, &y, &to) == SCARP_ERROR_SIZE, "%s, size", names[shape]);
    CHECK(call(shape, 0, NULL, NULL, NULL) == SCARP_OK, "%s of nothing", names[shape]);
    if (shape == DIVIDE) {
        const struct scarp_samples nothing = {.value = NULL};
        CHECK(call(shape, COUNT, &x, NULL, &to) == SCARP_ERROR_NULL, "%s, b", names[shape]);
        CHECK(call(shape, COUNT, &x, &nothing, &nothing) == SCARP_OK, "%s, b", names[shape]);
    }
    CHECK(memcmp(&other, &out, sizeof out) == 0, "%s wrote on an error", names[shape]);
}

static void check_knots(void)
{
    float x[SCARP_CURVE_KNOTS + 1], y[SCARP_CURVE_KNOTS + 1];
    const struct scarp_samples in = samples_of(&a, 0), to = {.value = out.array[0]};
    for (int i = 0; i <= SCARP_CURVE_KNOTS; i++) {
        x[i] = (float)i / 32.0f - 1.0f;
        y[i] = (float)(i * i % 7);
    }
    memcpy(&other, &out, sizeof out);
    CHECK(scarp_curve(COUNT, &in, 1, x, y, &to) == SCARP_ERROR_PARAMETER, "one knot");
    CHECK(scarp_curve(COUNT, &in, SCARP_CURVE_KNOTS + 1, x, y, &to) == SCARP_ERROR_PARAMETER,
          "65 knots");
    CHECK(scarp_curve(COUNT, &in, 4, NULL, y, &to) == SCARP_ERROR_NULL, "no x");
    CHECK(scarp_curve(COUNT, &in, 4, x, NULL, &to) == SCARP_ERROR_NULL, "no values");
    const float kept = x[2];
    x[2] = x[1];
    CHECK(scarp_curve(COUNT, &in, 4, x, y, &to) == SCARP_ERROR_PARAMETER, "equal x");
    x[2] = NAN;
    CHECK(scarp_curve(COUNT, &in, 4, x, y, &to) == SCARP_ERROR_PARAMETER, "NaN");
    x[2] = kept;
    y[3] = 0x1p61f;
    CHECK(scarp_curve(COUNT, &in, 4, x, y, &to) == SCARP_ERROR_PARAMETER, "a large value");
    y[3] = 2.0f;
    CHECK(memcmp(&other, &out, sizeof out) == 0, "scarp_curve wrote on an error");
    CHECK(scarp_curve(COUNT, &in, SCARP_CURVE_KNOTS, x, y, &to) == SCARP_OK, "64 knots");
    for (int k = 0; k < COUNT; k++) { /* no overshoot */
        int i = 0;
        while (i < SCARP_CURVE_KNOTS - 2 && a.array[0][k] >= x[i + 1]) {
            i++;
        }
        const float lowest = y[i] < y[i + 1] ? y[i] : y[i + 1], highest = y[i] + y[i + 1] - lowest;
        CHECK(out.array[0][k] >= lowest && out.array[0][k] <= highest, "%g is not in [%g, %g]",
              (double)out.array[0][k], (double)lowest, (double)highest);
    }
}

static void check_slope(int dimensions)
{
    struct scarp_samples x = samples_of(&a, 0);
    struct scarp_samples to = {.value = out.array[0],
                               .dx = out.array[1],
                               .dy = out.array[2],
                               .dz = dimensions == 3 ? out.array[3] : NULL};
    static const int second[3][3] = {{4, 5, 6}, {5, 7, 8}, {6, 8, 9}};
    x.dz = dimensions == 3 ? x.dz : NULL;
    x.value = NULL; /* is not read */
    CHECK(scarp_slope(COUNT, &x, &to) == SCARP_OK, "scarp_slope");
    for (int k = 0; k < COUNT; k++) {
        double square = 0.0;
        for (int i = 0; i < dimensions; i++) {
            square += (double)a.array[1 + i][k] * (double)a.array[1 + i][k];
        }
        CHECK(fabs(sqrt(square) - (double)out.array[0][k]) < 1e-6, "%d: %g", k,
              (double)out.array[0][k]);
        for (int i = 0; i < dimensions; i++) {
            double sum = 0.0;
            for (int j = 0; j < dimensions; j++) {
                sum += (double)a.array[1 + j][k] * (double)a.array[second[i][j]][k];
            }
            CHECK(fabs(sum / sqrt(square) - (double)out.array[1 + i][k]) < 3e-6, "%d, axis %d: %g",
                  k, i, (double)out.array[1 + i][k]);
        }
    }
    /* In place, where the value becomes dx */
    memcpy(&other, &a, sizeof other);
    struct scarp_samples here = samples_of(&other, 0);
    const struct scarp_samples first = {.value = other.array[1]};
    here.dz = dimensions == 3 ? here.dz : NULL;
    CHECK(scarp_slope(COUNT, &here, &first) == SCARP_OK, "in place");
    CHECK(memcmp(other.array[1], out.array[0], sizeof other.array[1]) == 0, "in place");
    struct scarp_samples wrong = to;
    wrong.dxx = out.array[4];
    CHECK(scarp_slope(COUNT, &x, &wrong) == SCARP_ERROR_UNSUPPORTED, "dxx");
    wrong = to;
    wrong.dphase = out.array[4];
    CHECK(scarp_slope(COUNT, &x, &wrong) == SCARP_ERROR_UNSUPPORTED, "dphase");
    wrong = to;
    wrong.spare[0] = out.array[4];
    CHECK(scarp_slope(COUNT, &x, &wrong) == SCARP_ERROR_UNSUPPORTED, "spare");
    x.dxy = NULL;
    CHECK(scarp_slope(COUNT, &x, &to) == SCARP_ERROR_NULL, "no dxy");
    x.dx = NULL;
    CHECK(scarp_slope(COUNT, &x, &first) == SCARP_ERROR_NULL, "no dx");
    CHECK(scarp_slope(COUNT, NULL, &first) == SCARP_ERROR_NULL, "no a");
    CHECK(scarp_slope(COUNT, &x, NULL) == SCARP_ERROR_NULL, "no out");
    CHECK(scarp_slope(0, NULL, NULL) == SCARP_OK, "nothing");
}

int main(void)
{
    set_inputs();
    for (int shape = 0; shape < SHAPES; shape++) {
        check_shape((enum shape)shape);
        check_special((enum shape)shape);
        check_errors((enum shape)shape);
    }
    set_knots();
    check_shape(CURVE);
    check_knots();
    check_slope(2);
    check_slope(3);
    return check_done();
}
