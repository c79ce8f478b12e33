/* SPDX-License-Identifier: MIT
 *
 * What the functions of samples compute: values against their formulas in double, derivatives
 * against central differences of these along polynomials that have the inputs' derivatives; what is
 * promised at seams, of ranges, and of numbers that are not finite. (test_chain_zero.c has products
 * by 0.)
 *
 *     test_chain_rule ISA
 */
#include "chain.h"

#define POINTS 1000
#define AXES 4 /* x, y, z and the phase */

/* Numbers of the cases */
#define CHAIN_K chain_kinds[CHAIN_smooth_min].number[0]
#define CHAIN_LO chain_kinds[CHAIN_clamp].number[0]
#define CHAIN_HI chain_kinds[CHAIN_clamp].number[1]
#define CHAIN_STEPS chain_kinds[CHAIN_terrace].number[0]
#define CHAIN_RISER chain_kinds[CHAIN_terrace].number[1]
#define CHAIN_STRENGTH_WEAK chain_kinds[CHAIN_terrace_weak].number[2]

static float in[CHAIN_INPUTS][OUTPUTS][POINTS];
static float partials[CHAIN_PARTIALS][POINTS];
static struct outputs out;

/* Calls f for all points, with all outputs. */
static void call_all(enum chain f)
{
    const struct scarp_samples inputs[CHAIN_INPUTS] = {chain_samples(in[0][0], POINTS),
                                                       chain_samples(in[1][0], POINTS),
                                                       chain_samples(in[2][0], POINTS)};
    const struct scarp_partials p = {partials[0], partials[1], partials[2], partials[3],
                                     partials[4], partials[5], {NULL}};
    const struct scarp_samples all = outputs_subset(&out, (1u << OUTPUTS) - 1);
    CHECK(chain_call(f, POINTS, inputs, &p, &all) == SCARP_OK, "%s", chain_kinds[f].name);
}

static double step_of(double t)
{
    t = t < 0.0 ? 0.0 : t > 1.0 ? 1.0 : t;
    return ((6.0 * t - 15.0) * t + 10.0) * t * t * t;
}

static double smooth_min(double a, double b, double k)
{
    const double h = 1.0 - fabs(a - b) / k;
    return fmin(a, b) - (h > 0.0 ? h * h * h * k / 6.0 : 0.0);
}

static double terrace(double v, double steps, double riser, double strength)
{
    const double t = v * steps, whole = floor(t), u = t - whole;
    const double s = step_of((u - 0.5) / riser + 0.5);
    return (whole + u + strength * (s - u)) / steps;
}

static double smoothstep(double v, double lo, double hi)
{
    return step_of((v - lo) / (hi - lo));
}

/* The functions as scarp.h defines them. Those of apply1 and apply2 are chosen here. */
static double formula(enum chain f, double a, double b, double m)
{
    const double k[3] = {(double)chain_kinds[f].number[0], (double)chain_kinds[f].number[1],
                         (double)chain_kinds[f].number[2]};
#define CASE(name, function, COMPUTED, FORM, kinds, numbers, value, ...)                           \
    case CHAIN_##name: return value;
    switch (f) {
#include CHAIN_TABLE
    case CHAIN_apply1: return a * a * a - 2.0 * a;
    default: return a * a * b + b * b * b;
    }
}

/* Fills in the partial derivatives of the latter two. */
static void give_partials(enum chain f)
{
    for (int p = 0; p < POINTS; p++) {
        const double a = (double)in[0][0][p], b = (double)in[1][0][p];
        const int one = f == CHAIN_apply1;
        const double of[CHAIN_PARTIALS] = {formula(f, a, b, 0.0),
                                           one ? 3.0 * a * a - 2.0 : 2.0 * a * b,
                                           a * a + 3.0 * b * b,
                                           one ? 6.0 * a : 2.0 * b,
                                           2.0 * a,
                                           6.0 * b};
        for (int i = 0; i < CHAIN_PARTIALS; i++) {
            partials[i][p] = (float)of[i];
        }
    }
}

/* The input at a place next to point p: the polynomial that has its value and derivatives. */
static double germ(int input, int p, const double at[AXES])
{
    double sum = (double)in[input][0][p] + (double)in[input][OUTPUT_dphase][p] * at[3];
    for (int m = OUTPUT_dx; m <= OUTPUT_dzz; m++) {
        const int i = output_kinds[m].axes[0], j = output_kinds[m].axes[1];
        const double factor = output_kinds[m].order == 1 ? at[i]
                              : i == j                   ? 0.5 * at[i] * at[j]
                                                         : at[i] * at[j];
        sum += (double)in[input][m][p] * factor;
    }
    return sum;
}

static double composed(enum chain f, int p, const double at[AXES])
{
    return formula(f, germ(0, p, at), germ(1, p, at), germ(2, p, at));
}

/* Adds up f at places that are `step` off along axes i and j (or i alone), with the signs of a
   central difference. */
static double differences(enum chain f, int p, int i, int j, double step)
{
    double sum = 0.0;
    for (int k = 0; k < 4; k++) {
        const double to_i = k % 2 == 0 ? 1.0 : -1.0, to_j = k < 2 ? 1.0 : -1.0;
        double at[AXES] = {0};
        at[i] += to_i * step;
        if (j >= 0) {
            at[j] += to_j * step;
        }
        sum += composed(f, p, at) * (j >= 0 ? to_i * to_j : 0.5 * to_i);
    }
    return sum / (j >= 0 ? 4.0 * step * step : 2.0 * step);
}

/* Where f is not smooth enough for differences: at creases, and at seams of second derivatives. */
static int near_seam(enum chain f, int p)
{
    const double a = (double)in[0][0][p], b = (double)in[1][0][p];
    const double k[3] = {(double)chain_kinds[f].number[0], (double)chain_kinds[f].number[1],
                         (double)chain_kinds[f].number[2]};
#define NEAR 0.01
#define CASE(name, function, COMPUTED, FORM, kinds, numbers, value, seam, ...)                     \
    case CHAIN_##name: return seam;
    (void)b;
    switch (f) {
#include CHAIN_TABLE
    default: return 0;
    }
}

static void test_formula(enum chain f)
{
    static double expected[POINTS];
    give_partials(f);
    call_all(f);
    for (int m = 0; m < OUTPUTS; m++) {
        const int order = output_kinds[m].order;
        const int i = m == OUTPUT_dphase ? 3 : output_kinds[m].axes[0];
        double largest = 0.0;
        int compared = 0;
        for (int p = 0; p < POINTS; p++) {
            const double here[AXES] = {0};
            expected[p] = order == 0 ? composed(f, p, here)
                                     : differences(f, p, i, output_kinds[m].axes[1],
                                                   order == 1 ? 0x1p-15 : 0x1p-13);
            largest = near_seam(f, p) ? largest : larger(largest, fabs(expected[p]));
        }
        for (int p = 0; p < POINTS; p++) {
            const double off = fabs((double)out.array[m][p] - expected[p]);
            const double most = largest * (order == 0 ? 1e-6 : order == 1 ? 3e-5 : 1e-4);
            if (order == 0 || !near_seam(f, p)) {
                CHECK(off <= most, "%s: %s of a = %a, b = %a is %g, not %g", chain_kinds[f].name,
                      output_names[m], (double)in[0][0][p], (double)in[1][0][p],
                      (double)out.array[m][p], expected[p]);
                compared++;
            }
        }
        CHECK(compared > POINTS / 2, "%s: %d points compared", chain_kinds[f].name, compared);
    }
}

/* Makes inputs of one variable: a runs from `from` in equal steps, b is 0. So dx is the derivative
   with respect to a, and dxx the second one. */
static void make_sweep(float from, float step)
{
    memset(in, 0, sizeof in);
    for (int p = 0; p < POINTS; p++) {
        in[0][0][p] = from + (float)p * step;
        in[0][OUTPUT_dx][p] = 1.0f;
    }
}

/* No output jumps: they change by no more than their derivatives allow. `third` bounds the third
   derivative. */
static void test_no_jump(enum chain f, float from, double third)
{
    const float step = 0x1p-9f;
    double second = 0.0;
    make_sweep(from, step);
    call_all(f);
    for (int p = 0; p < POINTS; p++) {
        second = larger(second, fabs((double)out.array[OUTPUT_dxx][p]));
    }
    for (int p = 1; p < POINTS; p++) {
        const double d1 = (double)out.array[OUTPUT_dx][p] - (double)out.array[OUTPUT_dx][p - 1];
        const double d2 = (double)out.array[OUTPUT_dxx][p] - (double)out.array[OUTPUT_dxx][p - 1];
        CHECK(fabs(d1) <= second * 1.001 * (double)step + 1e-5, "%s at %g: dx jumps by %g",
              chain_kinds[f].name, (double)in[0][0][p], d1);
        CHECK(fabs(d2) <= third * 1.001 * (double)step + 1e-4, "%s at %g: dxx jumps by %g",
              chain_kinds[f].name, (double)in[0][0][p], d2);
    }
    CHECK(second > 0.1, "%s is straight", chain_kinds[f].name);
}

/* The largest third derivative of a function that must not jump; 0 of others */
static double third_of(enum chain f)
{
    const double k[3] = {(double)chain_kinds[f].number[0], (double)chain_kinds[f].number[1],
                         (double)chain_kinds[f].number[2]};
#define CASE(name, function, COMPUTED, FORM, kinds, numbers, value, seam, third)                   \
    case CHAIN_##name: return third;
    switch (f) {
#include CHAIN_TABLE
    default: return 0.0;
    }
}

static void test_no_jumps(void)
{
    for (int f = 0; f < CHAINS; f++) {
        if (third_of((enum chain)f) > 0.0) {
            test_no_jump((enum chain)f, -0.97f, third_of((enum chain)f));
        }
    }
}

static void make_random(float span)
{
    uint64_t state = 3;
    for (int i = 0; i < CHAIN_INPUTS * OUTPUTS * POINTS; i++) {
        const int m = i / POINTS % OUTPUTS;
        (&in[0][0][0])[i] = check_random_float(&state, m == 0 ? span : 2.0f);
    }
}

/* Outputs of `f` are those of an input, to the bit, where `which` says so: 0 or 1, or neither. */
static void expect_input(enum chain f, int p, int which)
{
    for (int m = 0; m < OUTPUTS && which >= 0; m++) {
        CHECK(out.array[m][p] == in[which][m][p], "%s: %s of %a and %a is %a", chain_kinds[f].name,
              output_names[m], (double)in[0][0][p], (double)in[1][0][p], (double)out.array[m][p]);
    }
}

/* min and max give what they chose, smooth ones too where the inputs differ by k; elsewhere these
   are beyond by k / 6 at most. */
static void test_chosen(void)
{
    make_random(1.0f);
    for (int p = 0; p < POINTS; p += 7) {
        in[1][0][p] = p % 2 == 0 ? in[0][0][p] : in[0][0][p] + CHAIN_K;
    }
    for (int i = 0; i < 4; i++) {
        const enum chain f = (enum chain)((int)CHAIN_min + i);
        const int greater = f == CHAIN_max || f == CHAIN_smooth_max;
        const int smooth = f == CHAIN_smooth_min || f == CHAIN_smooth_max;
        call_all(f);
        for (int p = 0; p < POINTS; p++) {
            const float a = in[0][0][p], b = in[1][0][p];
            const int second = greater ? b > a : b < a;
            const double chosen = (double)(second ? b : a);
            const double beyond = ((double)out.array[0][p] - chosen) * (greater ? 1.0 : -1.0);
            const int apart = fabs((double)a - (double)b) > (double)CHAIN_K * 1.000001;
            expect_input(f, p, !smooth || apart ? second : -1);
            CHECK(beyond >= 0.0 && beyond <= (double)CHAIN_K / 6.0 + 1e-7, "%s: beyond by %g",
                  chain_kinds[f].name, beyond);
        }
    }
}

/* Ranges of clamp, smoothstep and terrace. */
static void test_ranges(void)
{
    for (int n = 0; n < 400; n++) {
        make_sweep(CHAIN_LO - 0.125f + (float)n * 0x1p-9f, 0x1p-20f);
        call_all(CHAIN_clamp);
        for (int p = 0; p < POINTS; p++) {
            const float v = in[0][0][p];
            const int inside = v >= CHAIN_LO && v <= CHAIN_HI;
            CHECK(out.array[0][p] >= CHAIN_LO && out.array[0][p] <= CHAIN_HI, "clamp %a",
                  (double)v);
            CHECK(out.array[OUTPUT_dx][p] == (inside ? 1.0f : 0.0f), "slope at %a", (double)v);
        }
        call_all(CHAIN_smoothstep);
        for (int p = 0; p < POINTS; p++) {
            const float s = out.array[0][p], v = in[0][0][p];
            CHECK(s >= 0.0f && s <= 1.0f, "smoothstep is %a", (double)s);
            CHECK(v > CHAIN_LO || s == 0.0f, "smoothstep is %a below", (double)s);
            CHECK(v < CHAIN_HI || s == 1.0f, "smoothstep is %a above", (double)s);
        }
        call_all(CHAIN_terrace);
        for (int p = 0; p < POINTS; p++) {
            const float off = fabsf(out.array[0][p] - in[0][0][p]);
            CHECK(off <= 0.5f / CHAIN_STEPS, "terrace moves %a by %a", (double)in[0][0][p],
                  (double)off);
            CHECK(out.array[OUTPUT_dx][p] >= 0.0f, "terrace falls");
        }
        call_all(CHAIN_terrace_weak);
        for (int p = 0; p < POINTS; p++) {
            CHECK(out.array[OUTPUT_dx][p] >= 1.0f - CHAIN_STRENGTH_WEAK, "slope %a",
                  (double)out.array[OUTPUT_dx][p]);
        }
    }
}

/* Treads lie at multiples of 1 / steps, which keep their value, and are level. */
static void test_treads(void)
{
    make_sweep(-8.0f, 0x1p-6f);
    call_all(CHAIN_terrace);
    for (int p = 0; p < POINTS; p++) {
        const float v = in[0][0][p], t = v * CHAIN_STEPS, tread = floorf(t + 0.5f);
        if (fabsf(t - tread) < 0.5f - 0.5f * CHAIN_RISER) {
            CHECK(out.array[0][p] == tread / CHAIN_STEPS, "%a at %a", (double)out.array[0][p],
                  (double)v);
            CHECK(out.array[OUTPUT_dx][p] == 0.0f && out.array[OUTPUT_dxx][p] == 0.0f,
                  "a tread is not level at %a", (double)v);
        }
    }
}

/* sign(0) is 0. */
static void test_zeros(void)
{
    make_random(1.0f);
    for (int p = 0; p < POINTS; p += 2) {
        in[0][0][p] = p % 4 == 0 ? 0.0f : -0.0f;
    }
    call_all(CHAIN_abs);
    for (int p = 0; p < POINTS; p += 2) {
        for (int m = 0; m < OUTPUTS; m++) {
            CHECK(out.array[m][p] == 0.0f, "%s of |0| is %g", output_names[m],
                  (double)out.array[m][p]);
        }
    }
}

/* A value (or f, or fa) that is NaN makes all outputs NaN that depend on it; min and max choose it.
   No other point is affected. */
static void test_nan(enum chain f)
{
    for (int input = 0; input < chain_kinds[f].inputs; input++) {
        static float before[OUTPUTS][POINTS];
        make_random(1.0f);
        give_partials(f);
        call_all(f);
        for (int m = 0; m < OUTPUTS; m++) {
            memcpy(before[m], out.array[m], sizeof before[m]);
        }
        const int where = 37 + (int)f;
        in[input][0][where] = input % 2 == 0 ? NAN : -NAN;
        partials[input][where] = NAN;
        call_all(f);
        const int linear = f == CHAIN_affine || f == CHAIN_add;
        const int chosen = f == CHAIN_min || f == CHAIN_max;
        for (int m = 0; m < OUTPUTS; m++) {
            const float *const got = &out.array[m][where];
            /* apply1 and apply2 look at f and fa in place of values. */
            const int other = chain_kinds[f].partials && (m == 0) != (input == 0);
            CHECK(linear && m > 0   ? *got == before[m][where]
                  : chosen && m > 0 ? *got == in[input][m][where]
                  : other           ? *got == before[m][where]
                                    : is_nan_bits(got),
                  "%s: %s where input %d is NaN: %g", chain_kinds[f].name, output_names[m], input,
                  (double)*got);
            out.array[m][where] = before[m][where];
            CHECK(first_difference(out.array[m], before[m], POINTS) == POINTS,
                  "%s: a NaN spread in %s", chain_kinds[f].name, output_names[m]);
        }
    }
}

int main(int argc, char **argv)
{
    check_isa_argument(argc, argv);
    out = outputs_make(POINTS);
    for (int f = 0; f < CHAINS; f++) {
        make_random(1.0f);
        test_formula((enum chain)f);
        test_nan((enum chain)f);
    }
    test_no_jumps();
    test_chosen();
    test_ranges();
    test_treads();
    test_zeros();
    outputs_free(&out);
    return check_done();
}
