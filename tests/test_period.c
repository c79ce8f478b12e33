/* SPDX-License-Identifier: MIT
 *
 * Noise with periods repeats, to the bit: value, gradient and Hessian, at points, at double points
 * and on grids, of either sign, near the origin and across 2^31 and 2^40 cells; and the checks.
 *
 *     test_period ISA
 */
#include "check.h"
#include "outputs.h"

#define POINTS 277

static struct outputs here, there, other;

/* Coordinates: cells times 64ths, whose fractions survive a shift in either precision. */
static double base[3][POINTS];
static float moved32[3][POINTS], base32[3][POINTS];
static double moved64[3][POINTS];

static const uint32_t periods[] = {1, 2, 3, 7, 289, 1 << 16, 1000003, 1 << 30};
#define PERIODS (sizeof periods / sizeof periods[0])

static void make_points(double span)
{
    uint64_t state = 5;
    for (int axis = 0; axis < 3; axis++) {
        for (size_t i = 0; i < POINTS; i++) {
            base[axis][i] = floor(check_random_double(&state, span) * 64.0) / 64.0;
        }
    }
}

/* The noise with a shift of `cells` along `axis` equals that without, or does not. */
static void compare_shifted(const struct scarp_noise *noise, enum function f, int axis,
                            double cells, int equal, const char *what)
{
    const unsigned wanted = outputs_of(noise, f);
    const struct inputs in[2] = {
        {{base32[0], base32[1], base32[2]}, {base[0], base[1], base[2]}},
        {{moved32[0], moved32[1], moved32[2]}, {moved64[0], moved64[1], moved64[2]}}};
    for (int d = 0; d < 3; d++) {
        for (size_t i = 0; i < POINTS; i++) {
            moved64[d][i] = base[d][i] + (d == axis ? cells : 0.0);
            base32[d][i] = (float)base[d][i];
            moved32[d][i] = (float)moved64[d][i];
        }
    }
    const struct scarp_samples out[2] = {outputs_subset(&here, wanted),
                                         outputs_subset(&there, wanted)};
    for (int i = 0; i < 2; i++) {
        CHECK(function_call(f, noise, POINTS, &in[i], &out[i]) == SCARP_OK, "%s", what);
    }
    int member = 0;
    size_t index = 0;
    const int same = outputs_equal(&here, &there, wanted, POINTS, &member, &index);
    CHECK(same == equal, "%s, basis %d, function %d, axis %d, %g cells away: %s[%zu] %s", what,
          (int)noise->basis, (int)f, axis, cells, output_names[member], index,
          equal ? "differs" : "is the same, as all else");
}

/* Whether noise of that basis can have a period along an axis. */
static int has_axis(const struct scarp_noise *noise, enum function f, int axis)
{
    struct scarp_noise fitted = {.basis = noise->basis, .period = {1, 1, 1}};
    fit_noise(&fitted, function_dimensions(f));
    return axis < function_dimensions(f) && fitted.period[axis] != 0;
}

/* Single octaves, whose positions are the coordinates. Floats have fractions up to 2^18 cells. */
static void test_octave(void)
{
    static const double shifts[] = {1, -1, 2, 1000};
    for (size_t p = 0; p < PERIODS; p++) {
        for (int axis = 0; axis < 3; axis++) {
            struct scarp_noise noise = {.seed = p};
            noise.period[axis] = periods[p];
            const double period = (double)periods[p];
            for (int i = 0; i < FUNCTIONS * count_names(basis_name); i++) {
                const int f = i % FUNCTIONS;
                noise.basis = (enum scarp_basis)(i / FUNCTIONS);
                if (!has_axis(&noise, (enum function)f, axis)) {
                    continue;
                }
                for (size_t s = 0; s < sizeof shifts / sizeof shifts[0]; s++) {
                    const double cells = shifts[s] * period;
                    if (function_doubles((enum function)f) || fabs(cells) < 0x1p17) {
                        make_points(1000.0);
                        compare_shifted(&noise, (enum function)f, axis, cells, 1, "octave");
                        compare_shifted(&noise, (enum function)f, axis, cells + 1.0,
                                        periods[p] == 1, "one cell more");
                    }
                    /* The offset of octave 0 has 24 bits, for which doubles have room. */
                    noise.offset_first = 1;
                    if (function_doubles((enum function)f) && fabs(cells) < 0x1p26) {
                        compare_shifted(&noise, (enum function)f, axis, cells, 1, "first");
                    }
                    noise.offset_first = 0;
                }
            }
        }
    }
}

/* Doubles cross 2^31 and 2^40 cells, where the number of a cell no longer fits into 32 bits. Shifts
   are the multiples of the period next to them. */
static void test_far(void)
{
    static const double far[] = {0x1p31, -0x1p31, 0x1p32, 0x1p40, -0x1p40, 0x1p43};
    for (size_t p = 0; p < PERIODS; p++) {
        for (size_t i = 0; i < sizeof far / sizeof far[0]; i++) {
            struct scarp_noise noise = {.seed = 8, .basis = (enum scarp_basis)((i + p) % 8)};
            const double period = (double)periods[p];
            const double cells = floor(far[i] / period) * period;
            for (int axis = 0; axis < 3; axis++) {
                noise.period[axis] = periods[p];
                make_points(20.0);
                compare_shifted(&noise, SAMPLE3_F64, axis, cells, 1, "far");
                if (noise.basis == SCARP_SIMPLEX) {
                    fit_noise(&noise, 2); /* period[1] */
                }
                if (has_axis(&noise, SAMPLE2_F64, axis)) {
                    compare_shifted(&noise, SAMPLE2_F64, axis, cells, 1, "far");
                }
            }
        }
    }
}

/* Floats have cells up to 2^31, without fractions from 2^23 on: at half steps, if any, the noise is
   that of the cell's remainder. */
static void test_far_floats(void)
{
    uint64_t state = 6;
    for (size_t p = 0; p < PERIODS; p++) {
        /* On rows of triangles no position is an integer. */
        struct scarp_noise noise = {.seed = 9, .basis = p % 2 == 0 ? SCARP_VALUE : SCARP_CELL_EDGE};
        noise.period[0] = noise.period[1] = periods[p];
        for (size_t i = 0; i < POINTS; i++) {
            const double span = i % 4 == 0 ? 0x1p31 : i % 4 == 1 ? 0x1p24 : 0x1p22;
            for (int d = 0; d < 2; d++) {
                base32[d][i] = floorf((float)check_random_double(&state, span));
                const int64_t remainder = (int64_t)base32[d][i] % (int64_t)periods[p];
                base[d][i] = (double)remainder;
            }
        }
        base32[0][3] = -0x1p31f; /* and the last cells before and behind 2^22 */
        base[0][3] = (double)(-(INT64_C(1) << 31) % (int64_t)periods[p]);
        for (size_t i = 4; i < 16; i++) {
            base32[0][i] = (i % 2 == 0 ? 1.0f : -1.0f) * (0x1p22f + (float)i - 10.0f);
            base[0][i] = (double)((int64_t)base32[0][i] % (int64_t)periods[p]);
        }
        const struct inputs in = {{base32[0], base32[1], NULL}, {base[0], base[1], NULL}};
        const struct scarp_samples out[2] = {{.value = here.array[0]}, {.value = there.array[0]}};
        CHECK(function_call(SAMPLE2, &noise, POINTS, &in, &out[0]) == SCARP_OK, "floats");
        CHECK(function_call(SAMPLE2_F64, &noise, POINTS, &in, &out[1]) == SCARP_OK, "doubles");
        const size_t i = first_difference(here.array[0], there.array[0], POINTS);
        CHECK(i == POINTS, "period %u: point %zu, (%g, %g), differs from its remainder", periods[p],
              i, (double)base32[0][i], (double)base32[1][i]);
    }
}

/* Several octaves: each repeats, so the sum does. Their offsets are multiples of 2^-24, so double
   positions are exact. */
static void test_octaves(void)
{
    for (int octaves = 1; octaves <= 8; octaves++) {
        for (int lacunarity = 1; lacunarity <= 4; lacunarity++) {
            for (int fractal = 0; fractal < count_names(fractal_name); fractal++) {
                struct scarp_noise noise = {.basis = (enum scarp_basis)((octaves + lacunarity) % 8),
                                            .seed = (uint64_t)octaves,
                                            .octaves = (float)octaves - 0.25f * (octaves > 1),
                                            .lacunarity = (float)lacunarity,
                                            .fractal = (enum scarp_fractal)fractal,
                                            .period = {5, 16, 289},
                                            .offset_first = (uint32_t)fractal % 2};
                /* Bent positions are rounded: test_bend.c takes these. */
                for (int axis = 0; axis < 3 && !fractal_bends(noise.fractal); axis++) {
                    const double period = (double)noise.period[axis];
                    make_points(100.0);
                    compare_shifted(&noise, SAMPLE3_F64, axis, -3.0 * period, 1, "octaves");
                    compare_shifted(&noise, SAMPLE3_F64, axis, period - 1.0, 0, "octaves");
                }
            }
        }
    }
}

/* An axis without a period never repeats, whatever the others do. */
static void test_other_axes(void)
{
    struct scarp_noise noise = {.period = {4, 0, 12}};
    make_points(50.0);
    compare_shifted(&noise, SAMPLE3_F64, 1, 4.0, 0, "no period");
    compare_shifted(&noise, SAMPLE3_F64, 1, 12.0, 0, "no period");
    const unsigned wanted = outputs_of(&noise, SAMPLE2_F64);
    const struct inputs in = {.d = {base[0], base[1], NULL}};
    const struct scarp_samples out[2] = {outputs_subset(&here, wanted),
                                         outputs_subset(&there, wanted)};
    CHECK(function_call(SAMPLE2_F64, &noise, POINTS, &in, &out[0]) == SCARP_OK, "2D");
    noise.period[2] = 0xffffffffu;
    CHECK(function_call(SAMPLE2_F64, &noise, POINTS, &in, &out[1]) == SCARP_OK, "2D ignores z");
    int member = 0;
    size_t index = 0;
    CHECK(outputs_equal(&here, &there, wanted, POINTS, &member, &index), "2D ignores period[2]");
}

/* The noise of 0 to before P is that without a period, but for the cells at its end. */
static void test_first_period(void)
{
    for (size_t p = 0; p < PERIODS; p++) {
        const struct scarp_noise plain = {.seed = 3};
        struct scarp_noise noise = plain;
        noise.period[0] = noise.period[1] = noise.period[2] = periods[p];
        uint64_t state = 7;
        const double inside = (double)periods[p] - 1.0;
        for (int axis = 0; axis < 3; axis++) {
            for (size_t i = 0; i < POINTS; i++) {
                base[axis][i] = fabs(check_random_double(&state, inside));
            }
        }
        const unsigned wanted = outputs_of(&noise, SAMPLE3_F64);
        const struct inputs in = {.d = {base[0], base[1], base[2]}};
        const struct scarp_samples out[2] = {outputs_subset(&here, wanted),
                                             outputs_subset(&there, wanted)};
        CHECK(function_call(SAMPLE3_F64, &plain, POINTS, &in, &out[0]) == SCARP_OK, "plain");
        CHECK(function_call(SAMPLE3_F64, &noise, POINTS, &in, &out[1]) == SCARP_OK, "period");
        int member = 0;
        size_t index = 0;
        CHECK(periods[p] < 3 || outputs_equal(&here, &there, wanted, POINTS, &member, &index),
              "period %u: %s[%zu] differs inside", periods[p], output_names[member], index);
    }
}

/* A tile of a grid, and its neighbour to the left above. */
static void test_grid(void)
{
    struct scarp_noise noise = {.octaves = 4.0f, .frequency = 1.0 / 16.0, .period = {10, 6, 0}};
    struct scarp_grid grid = {.step = {1, 1, 1}, .count = {160, 96, 1}};
    const size_t samples = 160 * 96;
    struct outputs a = outputs_make(samples), b = outputs_make(samples);
    for (int i = 0; i < 6 + count_names(basis_name) - SCARP_SIMPLEX; i++) {
        noise.fractal = (enum scarp_fractal)(i % 6);
        noise.basis = i < 6 ? SCARP_GRADIENT : (enum scarp_basis)(SCARP_SIMPLEX + i - 6);
        noise.offset_first = i % 2 == 0;
        fit_noise(&noise, 2);
        const unsigned wanted = outputs_of(&noise, SAMPLE2_F64);
        const struct scarp_samples out[2] = {outputs_subset(&a, wanted),
                                             outputs_subset(&b, wanted)};
        grid.first[0] = grid.first[1] = 0;
        CHECK(scarp_grid2(&noise, &grid, &out[0]) == SCARP_OK, "tile");
        grid.first[0] = -160;
        grid.first[1] = noise.period[1] != 0 ? -96 : 0;
        CHECK(scarp_grid2(&noise, &grid, &out[1]) == SCARP_OK, "its neighbour");
        int member = 0;
        size_t index = 0;
        CHECK(outputs_equal(&a, &b, wanted, samples, &member, &index), "%s, %s: %s[%zu] differs",
              basis_name((int)noise.basis), fractal_name((int)noise.fractal), output_names[member],
              index);
        noise.period[1] = 6;
    }
    outputs_free(&a);
    outputs_free(&b);
}

static void expect(struct scarp_noise noise, int dimensions, enum scarp_status wanted,
                   const char *member)
{
    const char *found = NULL;
    const enum scarp_status status = scarp_noise_check(&noise, dimensions, &found);
    CHECK(status == wanted, "%s: %s", member != NULL ? member : "valid", scarp_status_text(status));
    CHECK((found == NULL) == (member == NULL) && (found == NULL || strcmp(found, member) == 0),
          "%s is said to be at fault, not %s", found != NULL ? found : "nothing",
          member != NULL ? member : "nothing");
    const struct scarp_samples out = {.value = other.array[0]};
    const float at[1] = {0.5f};
    CHECK((dimensions == 2 ? scarp_sample2(&noise, 1, at, at, &out)
                           : scarp_sample3(&noise, 1, at, at, at, &out)) == wanted,
          "a call disagrees");
}

static void test_checks(void)
{
    const uint32_t most = 1 << 30;
    for (uint32_t i = 0; i < 3; i++) {
        static const char *const names[] = {"period[0]", "period[1]", "period[2]"};
        struct scarp_noise noise = {0};
        noise.period[i] = most;
        expect(noise, 3, SCARP_OK, NULL);
        noise.period[i] = most + 1;
        expect(noise, 3, SCARP_ERROR_PARAMETER, names[i]);
        noise.period[i] = most / 8;
        noise.octaves = 4.0f;
        expect(noise, 3, SCARP_OK, NULL);
        noise.octaves = 4.125f;
        expect(noise, 3, SCARP_ERROR_PARAMETER, names[i]);
    }
    expect((struct scarp_noise){.period = {0, 0, most + 1}}, 2, SCARP_OK, NULL);
    expect((struct scarp_noise){.period = {1}, .lacunarity = 1.5f}, 2, SCARP_OK, NULL);
    expect((struct scarp_noise){.period = {1}, .lacunarity = 1.5f, .octaves = 2}, 2,
           SCARP_ERROR_PARAMETER, "lacunarity");
    expect((struct scarp_noise){.period = {1}, .lacunarity = 0.5f, .octaves = 2}, 2,
           SCARP_ERROR_PARAMETER, "lacunarity");
    expect((struct scarp_noise){.period = {1}, .rotate = 1}, 2, SCARP_OK, NULL);
    expect((struct scarp_noise){.period = {1}, .rotate = 1, .octaves = 2}, 2,
           SCARP_ERROR_UNSUPPORTED, "rotate");
    expect((struct scarp_noise){.period = {0, 0, 1}, .rotate = 1, .octaves = 2}, 2, SCARP_OK, NULL);
    const struct scarp_noise rows = {.period = {5, 3}, .basis = SCARP_SIMPLEX};
    expect(rows, 2, SCARP_ERROR_UNSUPPORTED, "period[1]");
    expect(rows, 3, SCARP_OK, NULL);
    expect((struct scarp_noise){.period = {5}, .basis = SCARP_SIMPLEX}, 2, SCARP_OK, NULL);
}

int main(int argc, char **argv)
{
    check_isa_argument(argc, argv);
    here = outputs_make(POINTS);
    there = outputs_make(POINTS);
    other = outputs_make(POINTS);
    test_octave();
    test_far();
    test_far_floats();
    test_octaves();
    test_other_axes();
    test_first_period();
    test_grid();
    test_checks();
    outputs_free(&here);
    outputs_free(&there);
    outputs_free(&other);
    return check_done();
}
