/* SPDX-License-Identifier: MIT
 *
 * The intervals of members, to their last number, and of the frequency of the last octave. Part of
 * tests/test_api.c.
 */
#ifndef SCARP_TESTS_API_INTERVALS_H
#define SCARP_TESTS_API_INTERVALS_H

#include <float.h>

#include "api_points.h"

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

static inline void set_field(struct scarp_noise *noise, enum field field, double value)
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
static inline int is_narrow(enum field field, enum scarp_fractal fractal)
{
    const struct fractal_traits *const row = fractal_row(fractal);
    return field == SHARPNESS ? row->sharpness != 0.0f
                              : field == EROSION && row->most_erosion == 1.0f;
}

/* Tries a value with every fractal, and with every basis: `erosion` and its like are checked even
   where they are not used. */
static inline void try_field(enum field field, double value, enum scarp_status expected)
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
static inline void test_narrow(enum field field, const float values[10])
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

static inline void test_narrow_intervals(void)
{
    static const float sharpness[10] = {0x1p-8f,       0.7f,  0x1p8f, -0.0f,    0x1.fffffep-9f,
                                        0x1.000002p8f, -1.0f, NAN,    INFINITY, 0x1p-149f};
    static const float erosion[10] = {0x1p-24f,      0.7f,  1.0f, -0.0f,    0x1.fffffep-25f,
                                      0x1.000002p0f, -1.0f, NAN,  INFINITY, 0x1p-149f};
    test_narrow(SHARPNESS, sharpness);
    test_narrow(EROSION, erosion);
}

/* The neighbour of `end` in the type of the field, away from or towards `middle`. */
static inline double beside(enum field field, double end, double middle, int outside)
{
    const double target = outside ? 2.0 * end - middle : middle;
    return field == FREQUENCY ? nextafter(end, target)
                              : (double)nextafterf((float)end, (float)target);
}

static inline void test_intervals(void)
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
static inline void test_last_frequency(void)
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

#endif
