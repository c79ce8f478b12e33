/* SPDX-License-Identifier: MIT
 *
 * Samples coordinates at the edges of their formats: NaN, infinities, signed zeros, denormals, the
 * powers of two where floats lose their fraction and cells wrap, positions that overflow.
 *
 * The scalar kernels are compared with the oracle, the others with the scalar ones.
 *
 *     test_special ISA [STRIDE]    takes each STRIDE-th pair of numbers only; a prime above 5
 */
#include <float.h>

#include "fractal.h"

#define PICKS 8192 /* points: the square of SPECIALS_MAX at least */
#define SPECIALS_MAX 90

static float f32[3][PICKS];
static double f64[3][PICKS];
static const struct inputs in = {{f32[0], f32[1], f32[2]}, {f64[0], f64[1], f64[2]}};
static struct outputs scalar, tested;
static int points; /* in use, PICKS at most */

/* These come with their neighbours, and with both signs. */
static const double edges[] = {1.0, 0x1p23, 0x1p24, 0x1p31, 0x1p32, 0x1p51, 0x1p52, 0x1p53, 0x1p62};
static const double plain[] = {0.0, 0x1p-140, 0x1p-126, 0x1p-64,      0x1p-31, 0x1p-25, 0x1p-24,
                               0.5, 1.5,      3.25,     0x1p22 + 0.5, 1e30,    0x1p126};

static double next(double x, int doubles, double towards)
{
    return doubles ? nextafter(x, towards) : (double)nextafterf((float)x, (float)towards);
}

/* All special numbers of a format. Those of float are doubles that floats hold. */
static int specials(double *list, int doubles)
{
    int n = 0;
    for (size_t i = 0; i < sizeof edges / sizeof edges[0]; i++) {
        list[n++] = edges[i];
        list[n++] = next(edges[i], doubles, 0.0);
        list[n++] = next(edges[i], doubles, (double)FLT_MAX);
    }
    for (size_t i = 0; i < sizeof plain / sizeof plain[0]; i++) {
        list[n++] = plain[i];
    }
    list[n++] = doubles ? 0x1p-1074 : 0x1p-149;
    list[n++] = doubles ? DBL_MAX : (double)FLT_MAX;
    list[n++] = doubles ? 1e300 : 1e38;
    list[n++] = (double)INFINITY;
    list[n++] = (double)NAN;
    for (int i = 0; i < n; i++) {
        list[n + i] = -list[i];
    }
    return 2 * n;
}

/* Makes all pairs of special numbers in x and y, and random ones in z. */
static void make_points(int stride)
{
    double list[2][SPECIALS_MAX];
    uint64_t state = 1;
    const int n = specials(list[0], 0), m = specials(list[1], 1);
    CHECK(n == m && n <= SPECIALS_MAX && n * n <= PICKS, "%d and %d numbers", n, m);
    points = PICKS / stride;
    for (int j = 0; j < points; j++) {
        const int i = j * stride;
        const int pick[3] = {i % n, i / n % n, (int)(check_random(&state) % (unsigned)n)};
        for (int d = 0; d < 3; d++) {
            f32[d][j] = (float)list[0][pick[d]];
            f64[d][j] = list[1][pick[d]];
        }
    }
}

#define BLENDS 32 /* noises that blend corners */
#define NOISES 64

/* Noise `i` of NOISES: bases and fades with every kind of frequency, octaves and axes. */
static struct scarp_noise noise_make(int i)
{
    /* What edges say of F1 and F2, they say of their difference. */
    static const enum scarp_basis own[] = {SCARP_SIMPLEX, SCARP_CELL_EDGE, SCARP_CELL_SOFT,
                                           SCARP_CELL_VALUE};
    static const struct scarp_noise kinds[BLENDS / 4] = {
        {.octaves = 1.0f},
        {.octaves = 1.0f, .frequency = 0x1p-32},
        {.octaves = 3.5f, .frequency = 0.75},
        {.octaves = 5.0f, .frequency = 0x1p40, .lacunarity = 3.0f},
        {.octaves = 4.0f, .frequency = 1.5, .rotate = 1},
        {.octaves = 3.0f, .frequency = 0x1p30, .rotate = 1},
        {.octaves = 9.0f, .frequency = 1.0, .lacunarity = 16.0f, .amplitude = -100.0f},
        {.octaves = 3.0f, .frequency = 0.5, .phase = 0.7f},
    };
    struct scarp_noise noise = kinds[i % BLENDS / 4];
    noise.seed = (uint64_t)i;
    if (i >= BLENDS) {
        noise.basis = own[i % 4];
        noise.phase = 0.0f;
        return noise;
    }
    noise.basis = (enum scarp_basis)(i & 1);
    noise.phase = noise.basis == SCARP_GRADIENT ? noise.phase : 0.0f;
    if (noise.phase != 0.0f) { /* of each basis and fade there is one */
        noise.fractal = noise.fade == SCARP_CUBIC ? SCARP_RIDGED : SCARP_EROSION;
    }
    noise.fade = (enum scarp_fade)(i >> 1 & 1);
    return noise;
}

static void call(enum function f, const struct scarp_noise *noise, size_t count,
                 const struct inputs *at, const struct outputs *o)
{
    const struct scarp_samples out = outputs_subset(o, outputs_of(noise, f));
    const enum scarp_status status = function_call(f, noise, count, at, &out);
    CHECK(status == SCARP_OK, "%s: %s", function_names[f], scarp_status_text(status));
}

/* Whether all positions of point i are finite: 1 or 0, or -1 where turned axes hide the answer. */
static int finite_positions(enum function f, const struct scarp_noise *noise, int i)
{
    const int rows = noise->basis == SCARP_SIMPLEX && function_dimensions(f) == 2;
    int small = 1;
    for (int d = 0; d < function_dimensions(f); d++) {
        const double x = function_doubles(f) ? f64[d][i] : (double)f32[d][i];
        const double stretch = rows && d == 1 ? 1.1547005383792515 : 1.0; /* 2 / sqrt(3) */
        double frequency = noise->frequency == 0.0 ? 1.0 : noise->frequency;
        if (!isfinite(x)) {
            return 0;
        }
        for (float k = 0.0f; k < noise->octaves; k += 1.0f) {
            const float position = (float)frequency * f32[d][i] * (float)stretch;
            const double position64 = frequency * x * stretch;
            if (!(function_doubles(f) ? isfinite(position64) : isfinite(position))) {
                small = noise->rotate != 0 ? -1 : 0;
            }
            frequency *= noise->lacunarity == 0.0f ? 2.0 : (double)noise->lacunarity;
        }
        if (noise->rotate != 0 && fabs(x) > (function_doubles(f) ? 1e280 : 1e18)) {
            small = -1;
        }
        if (small == 0) {
            return 0;
        }
    }
    return small;
}

/* Either every output of a point is NaN, or none is; scarp.h says when. */
static void expect_nan_rule(enum function f, const struct scarp_noise *noise)
{
    for (int i = 0; i < points; i++) {
        int expected = finite_positions(f, noise, i);
        for (int m = 0; m < OUTPUTS; m++) {
            const float *const got = tested.array[m] + i;
            if ((outputs_of(noise, f) >> m & 1) == 0) {
                continue;
            }
            if (expected < 0) {
                expected = !is_nan_bits(got); /* the others must agree */
            }
            CHECK(expected ? is_finite_bits(got) : is_nan_bits(got),
                  "%s, frequency %a: %s at (%a, %a, %a) is %a", function_names[f], noise->frequency,
                  output_names[m], function_doubles(f) ? f64[0][i] : (double)f32[0][i],
                  function_doubles(f) ? f64[1][i] : (double)f32[1][i],
                  function_doubles(f) ? f64[2][i] : (double)f32[2][i], (double)*got);
        }
    }
}

/* Whether a position of point x in double precision is so far out that low bits of its cell are
   lost, where the oracle does not follow. */
static int beyond_cells(const struct oracle *oracle, const double x[3])
{
    const double limit = oracle->basis == SCARP_SIMPLEX ? 0x1p51 / 1.2 : 0x1p51; /* of rows */
    for (int k = 0; k < oracle->octaves; k++) {
        for (int i = 0; i < oracle->dimensions; i++) {
            double size = 1.0;
            for (int j = 0; j < oracle->dimensions; j++) {
                size += fabs(oracle->octave[k].of.axes[i][j] * x[j]);
            }
            if (size >= limit) {
                return 1;
            }
        }
    }
    return 0;
}

/* Whether the result of point i is that of the oracle, within the bounds of test_accuracy.c. */
static void compare_point(enum function f, const struct scarp_noise *noise,
                          const struct oracle *oracle, const double x[3], int i)
{
    static const double bounds[ORDERS] = {7e-7, 2e-6, 8e-6}, steep[ORDERS] = {7e-7, 4e-6, 3e-5};
    const enum oracle_rounding rounding = function_doubles(f) ? ORACLE_F64 : ORACLE_F32;
    struct oracle_sample expected;
    struct oracle_creases creases;
    double error[ORDERS];
    oracle_evaluate_creased(oracle, rounding, x, &expected, &creases);
    const struct oracle_sample got = outputs_sample(&tested, noise, f, (size_t)i);
    difference(&got, &expected, error);
    const int jumps = !basis_smooth(noise->basis) && creases.border < 5e-5;
    for (int order = 0; order < ORDERS; order++) {
        if (jumps && (order > 0 || noise->basis == SCARP_CELL_VALUE)) {
            continue;
        }
        const double e = error[order] * pow(creases.nearest, order);
        const double bound = blends_corners(noise->basis) ? bounds[order] : steep[order];
        CHECK(e <= bound * fractal_unit(oracle, order),
              "%s, %s, frequency %a: derivative %d at (%a, %a, %a) is off by %g", function_names[f],
              basis_name((int)noise->basis), noise->frequency, order, x[0], x[1], x[2],
              error[order]);
    }
}

/* Compares one call with the oracle. Returns how many points the oracle could check, of cells,
   where it is slow, four times as many as it did. */
static int compare_with_oracle(enum function f, const struct scarp_noise *noise)
{
    const int step = noise->basis >= SCARP_CELL_F1 ? 4 : 1;
    struct oracle oracle;
    int compared = 0;
    oracle_make(&oracle, noise, function_dimensions(f));
    for (int i = 0; i < points; i += step) {
        double x[3];
        for (int d = 0; d < 3; d++) {
            x[d] = function_doubles(f) ? f64[d][i] : (double)f32[d][i];
        }
        if (finite_positions(f, noise, i) != 1 ||
            (function_doubles(f) && beyond_cells(&oracle, x))) {
            continue;
        }
        compare_point(f, noise, &oracle, x, i);
        compared += step;
    }
    return compared;
}

/* Compares the scalar kernels with the oracle. */
static void test_against_oracle(void)
{
    for (int i = 0; i < FUNCTIONS * NOISES; i++) {
        const enum function f = (enum function)(i / NOISES);
        const struct scarp_noise noise = noise_make(i % NOISES);
        call(f, &noise, (size_t)points, &in, &tested);
        expect_nan_rule(f, &noise);
        const int compared = compare_with_oracle(f, &noise);
        CHECK(compared > points / 64, "%s, noise %d: only %d points were compared",
              function_names[f], i % NOISES, compared);
    }
}

static void test_against_scalar(enum scarp_isa isa)
{
    for (int n = 0; n < NOISES; n++) {
        const struct scarp_noise noise = noise_make(n);
        for (int i = 0; i < FUNCTIONS; i++) {
            const enum function f = (enum function)i;
            int member = 0;
            size_t at = 0;
            scarp_isa_select(SCARP_ISA_SCALAR);
            call(f, &noise, (size_t)points, &in, &scalar);
            scarp_isa_select(isa);
            call(f, &noise, (size_t)points, &in, &tested);
            CHECK(outputs_equal(&scalar, &tested, outputs_of(&noise, f), (size_t)points, &member,
                                &at),
                  "%s, noise %d: %s[%zu] is %a, scalar has %a", function_names[f], n,
                  output_names[member], at, (double)tested.array[member][at],
                  (double)scalar.array[member][at]);
            expect_nan_rule(f, &noise);
        }
    }
}

#define NEIGHBOURS 67 /* four blocks of 16 and a tail */

/* A number that is not finite in any lane and axis changes no other point. */
static void test_neighbours(void)
{
    static const double odd[] = {(double)NAN, (double)INFINITY, (double)-INFINITY, (double)FLT_MAX};
    static float x32[3][NEIGHBOURS];
    static double x64[3][NEIGHBOURS];
    const struct inputs block = {{x32[0], x32[1], x32[2]}, {x64[0], x64[1], x64[2]}};
    uint64_t state = 2;
    for (int i = 0; i < 3 * NEIGHBOURS; i++) {
        x32[i % 3][i / 3] = check_random_float(&state, 1024.0f);
        x64[i % 3][i / 3] = check_random_double(&state, 0x1p20);
    }
    for (int i = 0; i < FUNCTIONS * NOISES; i += 3) {
        const enum function f = (enum function)(i / NOISES);
        const struct scarp_noise noise = noise_make(i % NOISES);
        call(f, &noise, NEIGHBOURS, &block, &scalar);
        for (int lane = 0; lane < NEIGHBOURS; lane++) {
            const int d = (lane + i) % function_dimensions(f);
            const float before32 = x32[d][lane];
            const double before64 = x64[d][lane];
            x32[d][lane] = (float)odd[(lane + i / 3) % 4];
            x64[d][lane] = odd[(lane + i / 3) % 4];
            call(f, &noise, NEIGHBOURS, &block, &tested);
            x32[d][lane] = before32;
            x64[d][lane] = before64;
            for (int m = 0; m < OUTPUTS; m++) {
                tested.array[m][lane] = scalar.array[m][lane];
            }
            int member = 0;
            size_t at = 0;
            CHECK(outputs_equal(&scalar, &tested, outputs_of(&noise, f), NEIGHBOURS, &member, &at),
                  "%s, noise %d: point %d disturbed %s[%zu]", function_names[f], i % NOISES, lane,
                  output_names[member], at);
        }
    }
}

/*
 * With one octave of frequency 1 a float position is the coordinate itself, so float and double
 * calls agree bit for bit; and from 2^31 on, the float call looks at cell -2^31, fraction 0.
 */
static void test_float_cells(void)
{
    static double same[3][PICKS];
    const struct inputs in_cell = {{f32[0], f32[1], f32[2]}, {same[0], same[1], same[2]}};
    int beyond = 0;
    for (int d = 0; d < 3; d++) {
        for (int i = 0; i < points; i++) {
            const int outside = isfinite(f32[d][i]) && fabsf(f32[d][i]) >= 0x1p31f;
            beyond += outside;
            same[d][i] = outside ? -0x1p31 : (double)f32[d][i];
        }
    }
    CHECK(beyond > points / 4, "only %d coordinates lie beyond 2^31", beyond);
    for (int n = 0; n < 8; n++) {
        const int i = n < 4 ? n : BLENDS + n - 4;
        const struct scarp_noise noise = noise_make(i);
        for (int three = noise.basis == SCARP_SIMPLEX; three < 2; three++) { /* rows: stretched */
            const enum function f = three ? SAMPLE3 : SAMPLE2;
            int member = 0;
            size_t at = 0;
            call(f, &noise, (size_t)points, &in_cell, &scalar);
            call(three ? SAMPLE3_F64 : SAMPLE2_F64, &noise, (size_t)points, &in_cell, &tested);
            CHECK(outputs_equal(&scalar, &tested, outputs_of(&noise, f), (size_t)points, &member,
                                &at),
                  "%s, noise %d: %s at (%a, %a, %a) is %a, in cell -2^31 %a", function_names[f], i,
                  output_names[member], (double)f32[0][at], (double)f32[1][at], (double)f32[2][at],
                  (double)scalar.array[member][at], (double)tested.array[member][at]);
        }
    }
}

#define FIELD 512

/* How many points have other outputs after `shift` is added along axis d. */
static int changed_by(enum function f, const struct scarp_noise *noise, int d, double shift,
                      double x[3][FIELD])
{
    static double moved[FIELD];
    struct inputs field = {{NULL, NULL, NULL}, {x[0], x[1], x[2]}};
    const unsigned mask = function_outputs(f);
    call(f, noise, FIELD, &field, &scalar);
    for (int i = 0; i < FIELD; i++) {
        moved[i] = x[d][i] + shift;
    }
    field.d[d] = moved;
    call(f, noise, FIELD, &field, &tested);
    int changed = 0;
    for (int i = 0; i < FIELD; i++) {
        int differs = 0;
        for (int m = 0; m < OUTPUTS; m++) {
            differs |= (mask >> m & 1) != 0 &&
                       float_bits(scalar.array[m] + i) != float_bits(tested.array[m] + i);
        }
        changed += differs;
    }
    return changed;
}

/* Cells wrap modulo 2^32, and at no smaller power of two. */
static void test_period(void)
{
    static double x[3][FIELD];
    uint64_t state = 3;
    for (int i = 0; i < 3 * FIELD; i++) { /* sums with 2^33 and below stay exact */
        x[i % 3][i / 3] = (double)check_random_float(&state, 4096.0f);
    }
    const int bases = count_names(basis_name);
    for (int i = 0; i < bases * 2 * 3; i++) {
        const enum function f = i < 3 * bases ? SAMPLE2_F64 : SAMPLE3_F64;
        const struct scarp_noise noise = {.basis = (enum scarp_basis)(i % bases), .seed = 7};
        const int d = i / bases % 3;
        if (d >= function_dimensions(f) ||
            (noise.basis == SCARP_SIMPLEX && d == 1 && i < 3 * bases)) {
            continue; /* rows do not repeat after 2^32 units */
        }
        const double periods[] = {0x1p32, -0x1p32, 0x1p33, -0x3p32};
        for (int p = 0; p < 4; p++) {
            CHECK(changed_by(f, &noise, d, periods[p], x) == 0, "%s: axis %d, shift %a changes",
                  function_names[f], d, periods[p]);
        }
        for (int k = 8; k < 32; k++) {
            const int changed = changed_by(f, &noise, d, ldexp(1.0, k), x);
            CHECK(changed > FIELD * 3 / 4, "%s: axis %d, 2^%d changes only %d of %d points",
                  function_names[f], d, k, changed, FIELD);
        }
    }
}

int main(int argc, char **argv)
{
    const enum scarp_isa isa = check_select_isa(argc > 1 ? argv[1] : "scalar");
    make_points(argc > 2 ? atoi(argv[2]) : 1);
    scalar = outputs_make(PICKS);
    tested = outputs_make(PICKS);
    if (isa == SCARP_ISA_SCALAR) {
        test_against_oracle();
    } else {
        test_against_scalar(isa);
    }
    test_neighbours();
    test_float_cells();
    test_period();
    return check_done();
}
