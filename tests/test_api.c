/* SPDX-License-Identifier: MIT
 *
 * The promises of scarp.h about arguments: errors, defaults, subsets of outputs, seeds. Reserved
 * members, fractals, normals, names and the choice of instruction set are in api_*.h.
 *
 *     test_api ISA
 */
#include <errno.h>
#include <float.h>
#include <limits.h>

#include "api_bases.h"
#include "api_fractal.h"
#include "api_isa.h"
#include "api_names.h"
#include "api_normals.h"
#include "api_reserved.h"
#include "chain.h"

#define POINTS 37 /* two blocks of 16 and a tail */

static float xf[3][POINTS];
static double xd[3][POINTS];
static const struct inputs in = {{xf[0], xf[1], xf[2]}, {xd[0], xd[1], xd[2]}};
static struct outputs one, two;

static void make_inputs(void)
{
    uint64_t state = 1;
    for (int i = 0; i < POINTS; i++) {
        for (int d = 0; d < 3; d++) {
            xf[d][i] = check_random_float(&state, 64.0f);
            xd[d][i] = check_random_double(&state, 0x1p40);
        }
    }
    one = outputs_make(POINTS);
    two = outputs_make(POINTS);
}

/* Checks that every function refuses the noise with `expected`, that `member` is said to be at
   fault, and that nothing is written. */
static void expect_refused(const struct scarp_noise *noise, enum scarp_status expected,
                           const char *member, const char *what)
{
    const int known =
        basis_name((int)noise->basis) != NULL && fractal_name((int)noise->fractal) != NULL;
    outputs_poison(&one);
    for (int f = 0; f < FUNCTIONS; f++) {
        const unsigned wanted = known ? outputs_of(noise, (enum function)f)
                                      : outputs_up_to(1, function_dimensions((enum function)f));
        const struct scarp_samples out = outputs_subset(&one, wanted);
        const enum scarp_status status = function_call((enum function)f, noise, POINTS, &in, &out);
        CHECK(status == expected, "%s, %s: %s", function_names[f], what, scarp_status_text(status));
        CHECK(function_call((enum function)f, noise, 0, &in, &out) == SCARP_OK,
              "%s, %s: count 0 looks at nothing", function_names[f], what);
    }
    CHECK(outputs_untouched(&one, ~0u), "%s: outputs were written", what);
    for (int dimensions = 2; dimensions <= 3; dimensions++) {
        float bounds[2] = {7.0f, 8.0f};
        const enum scarp_status status = scarp_range(noise, dimensions, &bounds[0], &bounds[1]);
        CHECK(status == expected, "scarp_range, %s: %s", what, scarp_status_text(status));
        CHECK(bounds[0] == 7.0f && bounds[1] == 8.0f, "scarp_range, %s: wrote", what);
        expect_member(noise, dimensions, expected, member);
    }
}

static void expect_accepted(const struct scarp_noise *noise, const char *what)
{
    for (int f = 0; f < FUNCTIONS; f++) {
        outputs_poison(&one);
        const unsigned mask = outputs_of(noise, (enum function)f);
        const struct scarp_samples out = outputs_subset(&one, mask);
        const enum scarp_status status = function_call((enum function)f, noise, POINTS, &in, &out);
        CHECK(status == SCARP_OK, "%s, %s: %s", function_names[f], what, scarp_status_text(status));
        for (int m = 0; m < OUTPUTS; m++) {
            for (int i = 0; i < POINTS && (mask >> m & 1) != 0; i++) {
                CHECK(is_finite_bits(one.array[m] + i), "%s, %s: %s is not finite",
                      function_names[f], what, output_names[m]);
            }
        }
    }
    float lowest, highest;
    CHECK(scarp_range(noise, 2, &lowest, &highest) == SCARP_OK, "scarp_range, %s", what);
    expect_member(noise, 2, SCARP_OK, NULL);
}

enum field {
    FREQUENCY,
    OCTAVES,
    LACUNARITY,
    GAIN,
    AMPLITUDE,
    EROSION,
    JITTER,
    SHARPNESS,
    OF_OCTAVES,
    FIELDS
};

static const char *const field_names[FIELDS] = {"frequency", "octaves",   "lacunarity",
                                                "gain",      "amplitude", "erosion",
                                                "jitter",    "sharpness", "of_octaves"};

static void set_field(struct scarp_noise *noise, enum field field, double value)
{
    switch (field) {
    case FREQUENCY: noise->frequency = value; break;
    case OCTAVES: noise->octaves = (float)value; break;
    case LACUNARITY: noise->lacunarity = (float)value; break;
    case GAIN: noise->gain = (float)value; break;
    case AMPLITUDE: noise->amplitude = (float)value; break;
    case EROSION: noise->erosion = (float)value; break;
    case JITTER: noise->jitter = (float)value; break;
    case SHARPNESS: noise->sharpness = (float)value; break;
    default: noise->of_octaves = (float)value; break;
    }
}

/* Whether the fractal narrows the interval of a member. */
static int is_narrow(enum field field, enum scarp_fractal fractal)
{
    const struct fractal_traits *const row = fractal_row(fractal);
    return field == SHARPNESS ? row->sharpness != 0.0f
                              : field == EROSION && row->most_erosion == 1.0f;
}

/* Tries a value with every fractal, and with every basis: `erosion` and its like are checked even
   where they are not used. */
static void try_field(enum field field, double value, enum scarp_status expected)
{
    const int last = count_names(fractal_name) - 1;
    for (int i = SCARP_FBM; i < last + count_names(basis_name); i++) {
        const int fractal = i > last ? SCARP_FBM : i;
        const int basis = i > last ? i - last : SCARP_GRADIENT;
        if (is_narrow(field, (enum scarp_fractal)fractal)) {
            continue; /* test_narrow_intervals has theirs */
        }
        struct scarp_noise noise = {.fractal = (enum scarp_fractal)fractal,
                                    .basis = (enum scarp_basis)basis};
        char what[64];
        set_field(&noise, field, value);
        snprintf(what, sizeof what, "fractal %d, basis %d, %s = %a", fractal, basis,
                 field_names[field], value);
        if (expected == SCARP_OK) {
            expect_accepted(&noise, what);
        } else {
            expect_refused(&noise, expected, field_names[field], what);
        }
    }
}

/* Tries values of a member whose interval some fractals narrow: four good ones, then six bad
   ones. */
static void test_narrow(enum field field, const float values[10])
{
    for (enum scarp_fractal fractal = 0; scarp_fractal_name(fractal) != NULL; fractal++) {
        for (int i = 0; i < 10 && is_narrow(field, fractal); i++) {
            struct scarp_noise noise = {.fractal = fractal};
            set_field(&noise, field, (double)values[i]);
            if (i < 4) {
                expect_accepted(&noise, scarp_fractal_name(fractal));
            } else {
                expect_refused(&noise, SCARP_ERROR_PARAMETER, field_names[field],
                               scarp_fractal_name(fractal));
            }
        }
    }
}

static void test_narrow_intervals(void)
{
    static const float sharpness[10] = {0x1p-8f,       0.7f,  0x1p8f, -0.0f,    0x1.fffffep-9f,
                                        0x1.000002p8f, -1.0f, NAN,    INFINITY, 0x1p-149f};
    static const float erosion[10] = {0x1p-24f,      0.7f,  1.0f, -0.0f,    0x1.fffffep-25f,
                                      0x1.000002p0f, -1.0f, NAN,  INFINITY, 0x1p-149f};
    test_narrow(SHARPNESS, sharpness);
    test_narrow(EROSION, erosion);
}

/* The neighbour of `end` in the type of the field, away from or towards `middle`. */
static double beside(enum field field, double end, double middle, int outside)
{
    const double target = outside ? 2.0 * end - middle : middle;
    return field == FREQUENCY ? nextafter(end, target)
                              : (double)nextafterf((float)end, (float)target);
}

static void test_intervals(void)
{
    static const double intervals[FIELDS][2] = {
        [FREQUENCY] = {0x1p-32, 0x1p48}, [OCTAVES] = {(double)FLT_MIN, 32.0},
        [LACUNARITY] = {0.0625, 16.0},   [GAIN] = {0.0625, 16.0},
        [AMPLITUDE] = {-0x1p24, 0x1p24}, [EROSION] = {0x1p-24, 0x1p24},
        [JITTER] = {0x1p-149, 1.0},      [SHARPNESS] = {0x1p-24, 0x1p24},
        [OF_OCTAVES] = {1.0, 32.0}};
    try_field(AMPLITUDE, 0x1p-24, SCARP_OK);
    try_field(AMPLITUDE, -0x1p-24, SCARP_OK);
    try_field(AMPLITUDE, 0x1p-25, SCARP_ERROR_PARAMETER);
    try_field(AMPLITUDE, -0x1p-25, SCARP_ERROR_PARAMETER);
    for (int i = 0; i < FIELDS; i++) {
        const enum field field = (enum field)i;
        const double lowest = intervals[i][0], highest = intervals[i][1];
        try_field(field, (double)NAN, SCARP_ERROR_PARAMETER);
        try_field(field, (double)-NAN, SCARP_ERROR_PARAMETER);
        try_field(field, (double)INFINITY, SCARP_ERROR_PARAMETER);
        try_field(field, (double)-INFINITY, SCARP_ERROR_PARAMETER);
        try_field(field, beside(field, highest, lowest, 1), SCARP_ERROR_PARAMETER);
        try_field(field, -0x1p30, SCARP_ERROR_PARAMETER);
        try_field(field, -0x1p126, SCARP_ERROR_PARAMETER);
        try_field(field, 0x1p126, SCARP_ERROR_PARAMETER);
        if (field != AMPLITUDE) {
            try_field(field, -1.0, SCARP_ERROR_PARAMETER);
            try_field(field, -0x1p-100, SCARP_ERROR_PARAMETER);
        }
        if (field != OCTAVES && field != JITTER) { /* open at 0: no number is the lowest */
            try_field(field, beside(field, lowest, highest, 1), SCARP_ERROR_PARAMETER);
        }
        try_field(field, lowest, SCARP_OK);
        try_field(field, beside(field, lowest, highest, 0), SCARP_OK);
        try_field(field, highest, SCARP_OK);
        try_field(field, beside(field, highest, lowest, 0), SCARP_OK);
        try_field(field, -0.0, SCARP_OK); /* -0 means the default, as 0 does */
    }
    try_field(FREQUENCY, 0x1p-1074, SCARP_ERROR_PARAMETER);
    try_field(FREQUENCY, DBL_MAX, SCARP_ERROR_PARAMETER);
}

/* Every octave's frequency must lie in [2^-32, 2^48], not only the first. */
static void test_last_frequency(void)
{
    static const struct {
        double frequency;
        float lacunarity, octaves;
        int valid;
    } cases[] = {
        {0x1p40, 2.0f, 9.0f, 1},     {0x1p40, 2.0f, 9.001f, 0},   {0x1p40, 2.0f, 10.0f, 0},
        {0x1p-24, 0.5f, 9.0f, 1},    {0x1p-24, 0.5f, 9.001f, 0},  {0x1p-24, 0.5f, 10.0f, 0},
        {0.0, 16.0f, 13.0f, 1},      {0.0, 16.0f, 13.5f, 0},      {0.0, 0.0625f, 9.0f, 1},
        {0.0, 0.0625f, 10.0f, 0},    {0x1p48, 1.0f, 32.0f, 1},    {0x1p48, 2.0f, 1.0f, 1},
        {0x1p48, 0.0625f, 21.0f, 1}, {0x1p48, 0.0625f, 21.5f, 0}, {0x1p-32, 16.0f, 21.0f, 1},
        {0x1p-32, 16.0f, 22.0f, 0},  {0x1.8p47, 1.5f, 2.0f, 0},   {0x1p17, 0.0f, 32.0f, 1},
        {0x1p18, 0.0f, 32.0f, 0},
    };
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        for (uint32_t rotate = 0; rotate < 2; rotate++) {
            const struct scarp_noise noise = {.rotate = rotate,
                                              .frequency = cases[i].frequency,
                                              .lacunarity = cases[i].lacunarity,
                                              .octaves = cases[i].octaves};
            char what[96];
            snprintf(what, sizeof what, "frequency %a, lacunarity %g, %g octaves",
                     cases[i].frequency, (double)cases[i].lacunarity, (double)cases[i].octaves);
            if (cases[i].valid) {
                expect_accepted(&noise, what);
            } else {
                expect_refused(&noise, SCARP_ERROR_PARAMETER, "octaves", what);
            }
        }
    }
}

/* With all members at the ends of their intervals, no output overflows. */
static void test_extremes(void)
{
    for (int i = 0; i < 256; i++) {
        const struct scarp_noise noise = {.basis = (enum scarp_basis)(i & 1),
                                          .fade = (enum scarp_fade)(i >> 1 & 1),
                                          .fractal = (enum scarp_fractal)(i >> 5 & 3),
                                          .erosion = (i >> 7 & 1) != 0 ? 0x1p24f : 0x1p-24f,
                                          .rotate = (uint32_t)(i >> 2 & 1),
                                          .frequency = 0x1p48,
                                          .octaves = (i >> 3 & 1) != 0 ? 32.0f : 1.0f,
                                          .lacunarity = 1.0f,
                                          .gain = (i >> 4 & 1) != 0 ? 16.0f : 0.0625f,
                                          .amplitude = -0x1p24f};
        char what[32];
        snprintf(what, sizeof what, "extremes, case %d", i);
        expect_accepted(&noise, what);
    }
}

static void test_enumerators(void)
{
    static const int unknown[] = {2, 3, 64, 1000, 65536, INT_MAX, -1, -2, INT_MIN};
    for (size_t i = 0; i < sizeof unknown / sizeof unknown[0]; i++) {
        struct scarp_noise noise = {.basis = (enum scarp_basis)unknown[i]};
        char what[64];
        snprintf(what, sizeof what, "basis %d", unknown[i]);
        if (basis_name(unknown[i]) == NULL) {
            expect_refused(&noise, SCARP_ERROR_ENUM, "basis", what);
        }
        noise = (struct scarp_noise){.fade = (enum scarp_fade)unknown[i]};
        snprintf(what, sizeof what, "fade %d", unknown[i]);
        expect_refused(&noise, SCARP_ERROR_ENUM, "fade", what);
        if (fractal_name(unknown[i]) == NULL) {
            noise = (struct scarp_noise){.fractal = (enum scarp_fractal)unknown[i]};
            snprintf(what, sizeof what, "fractal %d", unknown[i]);
            expect_refused(&noise, SCARP_ERROR_ENUM, "fractal", what);
        }
    }
}

static void test_null(void)
{
    static const struct scarp_noise noise = {0};
    static const struct inputs none = {{NULL, NULL, NULL}, {NULL, NULL, NULL}};
    outputs_poison(&one);
    for (int i = 0; i < FUNCTIONS; i++) {
        const enum function f = (enum function)i;
        const struct scarp_samples out = outputs_subset(&one, function_outputs(f));
        const struct scarp_samples nothing = {0};
        CHECK(function_call(f, NULL, POINTS, &in, &out) == SCARP_ERROR_NULL, "%s: noise",
              function_names[f]);
        CHECK(function_call(f, &noise, POINTS, &in, NULL) == SCARP_ERROR_NULL, "%s: out",
              function_names[f]);
        CHECK(function_call(f, &noise, 1, &none, &out) == SCARP_ERROR_NULL, "%s: all inputs",
              function_names[f]);
        for (int d = 0; d < function_dimensions(f); d++) {
            struct inputs some = in;
            some.f[d] = NULL;
            some.d[d] = NULL;
            CHECK(function_call(f, &noise, POINTS, &some, &out) == SCARP_ERROR_NULL, "%s: input %d",
                  function_names[f], d);
        }
        CHECK(function_call(f, NULL, 0, &none, NULL) == SCARP_OK, "%s: count 0", function_names[f]);
        CHECK(function_call(f, &noise, POINTS, &in, &nothing) == SCARP_OK, "%s: no output",
              function_names[f]);
    }
    CHECK(outputs_untouched(&one, ~0u), "outputs were written");
    float bound = 7.0f;
    CHECK(scarp_range(NULL, 2, &bound, &bound) == SCARP_ERROR_NULL, "noise");
    CHECK(scarp_range(&noise, 2, NULL, &bound) == SCARP_ERROR_NULL, "lowest");
    CHECK(scarp_range(&noise, 2, &bound, NULL) == SCARP_ERROR_NULL, "highest");
    CHECK(bound == 7.0f, "a bound was written");
}

static void test_size(void)
{
    static const struct scarp_noise noise = {0};
    outputs_poison(&one);
    for (int i = 0; i < FUNCTIONS; i++) {
        const enum function f = (enum function)i;
        const size_t bytes = function_doubles(f) ? sizeof(double) : sizeof(float);
        const size_t counts[] = {(size_t)PTRDIFF_MAX / bytes + 1,
                                 SIZE_MAX / bytes,
                                 SIZE_MAX / bytes + 1,
                                 SIZE_MAX / 2,
                                 SIZE_MAX - 15,
                                 SIZE_MAX};
        const struct scarp_samples out = outputs_subset(&one, function_outputs(f));
        for (size_t c = 0; c < sizeof counts / sizeof counts[0]; c++) {
            CHECK(function_call(f, &noise, counts[c], &in, &out) == SCARP_ERROR_SIZE,
                  "%s: count %zu", function_names[f], counts[c]);
        }
    }
    CHECK(outputs_untouched(&one, ~0u), "outputs were written");
}

/* Whether two noises give the same bits in all outputs of all functions. */
static int same_bits(const struct scarp_noise *a, const struct scarp_noise *b)
{
    int same = 1, member;
    size_t index;
    for (int i = 0; i < FUNCTIONS; i++) {
        const enum function f = (enum function)i;
        const unsigned mask = function_outputs(f);
        const struct scarp_samples out_a = outputs_subset(&one, mask);
        const struct scarp_samples out_b = outputs_subset(&two, mask);
        CHECK(function_call(f, a, POINTS, &in, &out_a) == SCARP_OK, "%s", function_names[f]);
        CHECK(function_call(f, b, POINTS, &in, &out_b) == SCARP_OK, "%s", function_names[f]);
        same &= outputs_equal(&one, &two, mask, POINTS, &member, &index);
    }
    return same;
}

static void test_defaults(void)
{
    static const struct scarp_noise explicit_defaults = {.basis = SCARP_GRADIENT,
                                                         .fade = SCARP_QUINTIC,
                                                         .fractal = SCARP_FBM,
                                                         .frequency = 1.0,
                                                         .octaves = 1.0f,
                                                         .lacunarity = 2.0f,
                                                         .gain = 0.5f,
                                                         .amplitude = 1.0f};
    struct scarp_noise zeroed, written = explicit_defaults;
    memset(&zeroed, 0, sizeof zeroed);
    CHECK(same_bits(&zeroed, &written), "one octave");
    zeroed.octaves = written.octaves = 5.5f;
    CHECK(same_bits(&zeroed, &written), "several octaves");
    zeroed.frequency = -0.0;
    zeroed.lacunarity = zeroed.gain = zeroed.amplitude = -0.0f;
    CHECK(same_bits(&zeroed, &written), "negative zeros");
    zeroed.rotate = 1;
    CHECK(!same_bits(&zeroed, &written), "rotate does nothing");
    for (int bit = 0; bit < 32; bit++) {
        written.rotate = UINT32_C(1) << bit;
        CHECK(same_bits(&zeroed, &written), "rotate = 1 << %d", bit);
    }
}

/* Any subset of outputs gives the bits that all of them together give, and writes nothing else. A
   call for another noise comes between, so that leftovers on the stack cannot pass for results. */
static void test_subsets(void)
{
    const int bases = count_names(basis_name);
    for (int i = 0; i < 2 * bases * FUNCTIONS; i++) {
        const enum function f = (enum function)(i % FUNCTIONS);
        const int many = i / FUNCTIONS / bases;
        const struct scarp_noise noise = {.basis = (enum scarp_basis)(i / FUNCTIONS % bases),
                                          .octaves = many ? 3.25f : 0.0f,
                                          .rotate = (uint32_t)many,
                                          .seed = 99};
        const struct scarp_noise other = {.octaves = 2.0f, .seed = 98};
        const unsigned all = function_outputs(f);
        const struct scarp_samples together = outputs_subset(&two, all);
        CHECK(function_call(f, &noise, POINTS, &in, &together) == SCARP_OK, "all outputs");
        for (unsigned mask = 0; mask <= all; mask++) {
            if ((mask & ~all) != 0) {
                continue;
            }
            int member = 0;
            size_t index = 0;
            const struct scarp_samples out = outputs_subset(&one, mask);
            const struct scarp_samples between = outputs_subset(&one, all);
            CHECK(function_call(f, &other, POINTS, &in, &between) == SCARP_OK, "another noise");
            outputs_poison(&one);
            CHECK(function_call(f, &noise, POINTS, &in, &out) == SCARP_OK, "subset %#x", mask);
            CHECK(outputs_equal(&one, &two, mask, POINTS, &member, &index),
                  "%s, subset %#x: %s[%zu] differs", function_names[f], mask, output_names[member],
                  index);
            CHECK(outputs_untouched(&one, ~mask), "%s, subset %#x: others were written",
                  function_names[f], mask);
        }
    }
}

static void test_range(void)
{
    static const float amplitudes[] = {0.0f, 1.0f, -1.0f, 0.1f, -3.5f, 0x1p24f, -0x1p24f, 0x1p-24f};
    for (size_t i = 0; i < sizeof amplitudes / sizeof amplitudes[0]; i++) {
        const struct scarp_noise noise = {.amplitude = amplitudes[i], .octaves = 3.0f};
        const float expected = amplitudes[i] == 0.0f ? 1.0f : fabsf(amplitudes[i]);
        for (int dimensions = 2; dimensions <= 3; dimensions++) {
            float lowest = 0.0f, highest = 0.0f;
            CHECK(scarp_range(&noise, dimensions, &lowest, &highest) == SCARP_OK, "range");
            CHECK(lowest == -expected && highest == expected, "amplitude %a: [%a, %a]",
                  (double)amplitudes[i], (double)lowest, (double)highest);
        }
    }
    static const int wrong[] = {0, 1, 4, -2, -3, 258, INT_MAX, INT_MIN};
    static const struct scarp_noise noise = {0};
    for (size_t i = 0; i < sizeof wrong / sizeof wrong[0]; i++) {
        float bounds[2] = {7.0f, 8.0f};
        CHECK(scarp_range(&noise, wrong[i], &bounds[0], &bounds[1]) == SCARP_ERROR_PARAMETER,
              "%d dimensions", wrong[i]);
        CHECK(bounds[0] == 7.0f && bounds[1] == 8.0f, "%d dimensions: wrote", wrong[i]);
    }
}

/* Most values differ between the seeds: equal ones can only be chance. */
static void expect_other_field(uint64_t a, uint64_t b)
{
    /* One basis for each kind of draws. */
    static const enum scarp_basis bases[] = {SCARP_GRADIENT, SCARP_VALUE, SCARP_SIMPLEX,
                                             SCARP_CELL_F1};
    for (int i = 0; i < 4 * FUNCTIONS; i++) {
        const enum function f = (enum function)(i / 4);
        const struct scarp_noise noise_a = {.basis = bases[i % 4], .seed = a};
        const struct scarp_noise noise_b = {.basis = bases[i % 4], .seed = b};
        const struct scarp_samples out_a = outputs_subset(&one, 1);
        const struct scarp_samples out_b = outputs_subset(&two, 1);
        CHECK(function_call(f, &noise_a, POINTS, &in, &out_a) == SCARP_OK, "seed");
        CHECK(function_call(f, &noise_b, POINTS, &in, &out_b) == SCARP_OK, "seed");
        int equal = 0;
        for (int p = 0; p < POINTS; p++) {
            equal += float_bits(one.array[0] + p) == float_bits(two.array[0] + p);
        }
        /* One vertex of a triangle is all that counts in the middle of its reach. */
        CHECK(equal <= (noise_a.basis == SCARP_SIMPLEX ? 8 : 2),
              "%s: %d of %d values of seeds %#llx and %#llx are equal", function_names[f], equal,
              POINTS, (unsigned long long)a, (unsigned long long)b);
    }
}

static void test_seeds(void)
{
    uint64_t state = 2;
    for (int i = 0; i < 8; i++) {
        const uint64_t s = i == 0 ? 0 : i == 1 ? UINT64_MAX : check_random(&state);
        expect_other_field(s, s + 1);
        expect_other_field(s, s + (UINT64_C(1) << 32));
        expect_other_field(s, ~s);
        for (int bit = 0; bit < 64; bit++) {
            expect_other_field(s, s ^ UINT64_C(1) << bit);
        }
    }
}

/* No call changes errno, not even where it takes square roots of NaN or converts it. */
static void test_errno(void)
{
    static const float odd[4] = {NAN, INFINITY, -3e38f, 1e-45f};
    static const double odd64[4] = {(double)NAN, (double)-INFINITY, 1e308, 1e-320};
    const struct inputs points = {{odd, odd, odd}, {odd64, odd64, odd64}};
    const struct scarp_noise valid = {0}, invalid = {.octaves = -1.0f};
    errno = 12345;
    for (int i = 0; i < FUNCTIONS; i++) {
        const enum function f = (enum function)i;
        const struct scarp_samples out = outputs_subset(&one, function_outputs(f));
        const enum scarp_status good = function_call(f, &valid, 4, &points, &out);
        const enum scarp_status bad = function_call(f, &invalid, 4, &points, &out);
        CHECK(good == SCARP_OK && bad == SCARP_ERROR_PARAMETER && errno == 12345, "errno is %d",
              errno);
    }
    const enum scarp_status status =
        scarp_normals(4, odd, odd, -3e38f, one.array[0], one.array[1], one.array[2]);
    CHECK(status == SCARP_OK && errno == 12345, "errno is %d", errno);
    const struct scarp_samples out = outputs_subset(&one, OUTPUTS_ALL3);
    float *const x[3] = {two.array[0], two.array[1], two.array[2]};
    for (int i = 0; i < 3; i++) {
        memcpy(x[i], odd, sizeof odd);
    }
    for (int f = 0; f < CHAINS; f++) {
        CHECK(chain_call_arrays((enum chain)f, 4, x, &out) == SCARP_OK && errno == 12345,
              "errno is %d", errno);
    }
}

int main(int argc, char **argv)
{
    test_isa(); /* before anything has selected one */
    if (argc > 1) {
        check_select_isa(argv[1]);
    }
    make_inputs();
    test_intervals();
    test_narrow_intervals();
    test_last_frequency();
    test_extremes();
    test_enumerators();
    test_null();
    test_size();
    test_defaults();
    test_subsets();
    test_range();
    test_fractals(&in, POINTS, &one, &two);
    test_reserved(&in, POINTS, &one, &two);
    test_seeds();
    test_texts();
    test_names();
    test_check_order();
    test_bases(&in, POINTS, &one, &two);
    test_normals();
    test_errno();
    return check_done();
}
