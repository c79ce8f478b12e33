/* SPDX-License-Identifier: MIT
 *
 * Walks short random lines through every basis and fractal, in 2D and 3D, and looks for jumps of
 * the value. Where a value changes most, beyond the steps next to it, the test bisects that step
 * until its ends are 2^-30 cells apart. A difference that is left is a jump. Noise jumps if, and
 * only if, the header says so under "Jumps": the test fails, too, if such noise is never seen to
 * jump.
 *
 * usage: test_continuity [lines of each case]
 */
#include "outputs.h"

#define STEPS 48    /* of a line */
#define STEP 0x1p-8 /* in cells of octave 0 */
#define HALVINGS 22 /* from STEP to 2^-30 */
#define JUMP 3e-5f  /* continuous noise of these cases changes by a seventh, by rounding */
#define MOST_LINES 4096

enum setting {
    ONE_OCTAVE,
    OCTAVES,
    CUBIC,
    PERIOD,
    PHASE,
    WARP,         /* a smooth one */
    CREASED_WARP, /* has creases, and does not jump */
    JUMPING_WARP, /* jumps by its basis */
    DEEP_WARP,    /* jumps by its own warp, whose fractal makes it jump */
    SETTINGS
};

static const char *const setting_names[SETTINGS] = {"one octave",   "octaves",      "cubic fade",
                                                    "period",       "phase",        "smooth warp",
                                                    "creased warp", "jumping warp", "deep warp"};

/* Each reaches a part of a cell. */
static const struct scarp_noise warps[SETTINGS + 1] = {
    [WARP] = {.seed = 11, .octaves = 2.0f, .amplitude = 0.25f},
    [CREASED_WARP] = {.basis = SCARP_CELL_EDGE,
                      .fractal = SCARP_TURBULENCE,
                      .seed = 12,
                      .octaves = 2.0f,
                      .amplitude = 0.25f},
    [JUMPING_WARP] = {.basis = SCARP_CELL_VALUE, .seed = 13, .amplitude = 0.25f},
    [DEEP_WARP] = {.seed = 14, .amplitude = 0.5f, .warp = &warps[SETTINGS]},
    [SETTINGS] = {.basis = SCARP_CELL_F1,
                  .fractal = SCARP_EROSION,
                  .seed = 15,
                  .octaves = 2.0f,
                  .amplitude = 0.5f},
};

/* False where there is no such noise, or none that differs from that of another setting. */
static int make_noise(enum scarp_basis basis, enum scarp_fractal fractal, enum setting setting,
                      int dimensions, struct scarp_noise *noise)
{
    *noise = (struct scarp_noise){.basis = basis, .fractal = fractal, .seed = 3};
    noise->octaves = setting == ONE_OCTAVE || setting >= WARP ? 1.0f : 2.5f;
    switch (setting) {
    case OCTAVES: noise->rotate = 1; break;
    case CUBIC: noise->fade = SCARP_CUBIC; return blends_corners(basis);
    case PERIOD:
        for (int axis = 0; axis < 3; axis++) {
            noise->period[axis] = (uint32_t)(3 + axis);
        }
        fit_noise(noise, dimensions);
        break;
    case PHASE: noise->phase = 0.3f; return basis == SCARP_GRADIENT;
    default: noise->warp = setting >= WARP ? &warps[setting] : NULL; break;
    }
    return 1;
}

/* Lines, one after the other: where each begins, and its step */
static size_t lines;
static double begin[3][MOST_LINES], way[3][MOST_LINES];
/* The ends of the step that is bisected, as parts of the whole line, and the values there */
static double low[MOST_LINES], high[MOST_LINES];
static float low_value[MOST_LINES], high_value[MOST_LINES];
static double x[3][MOST_LINES * (STEPS + 1)];
static float value[MOST_LINES * (STEPS + 1)];

static void sample(const struct scarp_noise *noise, int dimensions, size_t count)
{
    const struct scarp_samples out = {.value = value};
    const enum scarp_status status = dimensions == 2
                                         ? scarp_sample2_f64(noise, count, x[0], x[1], &out)
                                         : scarp_sample3_f64(noise, count, x[0], x[1], x[2], &out);
    CHECK(status == SCARP_OK, "%s", scarp_status_text(status));
}

static void place(size_t n, size_t line, double along)
{
    for (int axis = 0; axis < 3; axis++) {
        x[axis][n] = begin[axis][line] + along * way[axis][line];
    }
}

/* Lines begin in a few dozen cells, so that some cross the seams of periods. */
static void make_lines(void)
{
    uint64_t random = 7;
    for (size_t line = 0; line < lines; line++) {
        double length = 0.0;
        for (int axis = 0; axis < 3; axis++) {
            begin[axis][line] = check_random_double(&random, 32.0);
            way[axis][line] = check_random_double(&random, 1.0);
            length += way[axis][line] * way[axis][line];
        }
        for (int axis = 0; axis < 3; axis++) {
            way[axis][line] *= STEP / sqrt(length);
        }
    }
}

static float change(const float *v, int step)
{
    return fabsf(v[step + 1] - v[step]);
}

/* The step of a line that changes most beyond the steps before and after it */
static int suspect(const float *v)
{
    int found = 1;
    float most = -1.0f;
    for (int step = 1; step + 1 < STEPS; step++) {
        const float before = change(v, step - 1), after = change(v, step + 1);
        const float beyond = change(v, step) - (before > after ? before : after);
        if (beyond > most) {
            most = beyond;
            found = step;
        }
    }
    return found;
}

static void find_suspects(const struct scarp_noise *noise, int dimensions)
{
    for (size_t line = 0; line < lines; line++) {
        for (size_t i = 0; i <= STEPS; i++) {
            place(line * (STEPS + 1) + i, line, (double)i);
        }
    }
    sample(noise, dimensions, lines * (STEPS + 1));
    for (size_t line = 0; line < lines; line++) {
        const float *const v = value + line * (STEPS + 1);
        const int step = suspect(v);
        low[line] = (double)step;
        high[line] = (double)step + 1.0;
        low_value[line] = v[step];
        high_value[line] = v[step + 1];
    }
}

/* Keeps the half that changes more. */
static void bisect(const struct scarp_noise *noise, int dimensions)
{
    for (size_t line = 0; line < lines; line++) {
        place(line, line, 0.5 * (low[line] + high[line]));
    }
    sample(noise, dimensions, lines);
    for (size_t line = 0; line < lines; line++) {
        const double middle = 0.5 * (low[line] + high[line]);
        const float v = value[line];
        if (fabsf(v - low_value[line]) > fabsf(high_value[line] - v)) {
            high[line] = middle;
            high_value[line] = v;
        } else {
            low[line] = middle;
            low_value[line] = v;
        }
    }
}

static void test_noise(const struct scarp_noise *noise, enum setting setting, int dimensions)
{
    size_t worst = 0, jumping = 0;
    find_suspects(noise, dimensions);
    for (int i = 0; i < HALVINGS; i++) {
        bisect(noise, dimensions);
    }
    for (size_t line = 0; line < lines; line++) {
        const float left = fabsf(high_value[line] - low_value[line]);
        jumping += left > JUMP;
        worst = left > fabsf(high_value[worst] - low_value[worst]) ? line : worst;
    }
    const float most = fabsf(high_value[worst] - low_value[worst]);
    place(0, worst, low[worst]);
    CHECK((jumping > 0) == noise_jumps(noise),
          "%s, %s, %s, %dD: %zu of %zu lines jump, by %g at (%.17g, %.17g, %.17g)",
          scarp_basis_name(noise->basis), scarp_fractal_name(noise->fractal),
          setting_names[setting], dimensions, jumping, lines, (double)most, x[0][0], x[1][0],
          x[2][0]);
}

/* Erosion of one octave divides by the same number all around a feature, but at the feature, where
   the gradient is 0: no line meets these points. */
static void test_features(void)
{
    long seen = 0;
    for (uint64_t seed = 1; seed <= 64; seed++) {
        const struct scarp_noise noise = {
            .basis = SCARP_CELL_F1, .fractal = SCARP_EROSION, .seed = seed};
        double at[2][2] = {{0.5, 0.5}, {0.5, 0.5}};
        float fx, fy, f1, v[2];
        for (int i = 0; i < 2; i++) {
            scarp_cells2_f64(&noise, 1, at[0], at[1],
                             &(struct scarp_cells){.x = &fx, .y = &fy, .f1 = &f1});
            at[0][0] = (double)fx;
            at[1][0] = (double)fy;
        }
        if (f1 == 0.0f) { /* the place is no float otherwise */
            at[0][1] = at[0][0] + 0x1p-20;
            at[1][1] = at[1][0];
            scarp_sample2_f64(&noise, 2, at[0], at[1], &(struct scarp_samples){.value = v});
            CHECK(fabsf(v[0] + 1.0f) < 1e-4f && fabsf(v[1] + 1.0f / 3.0f) < 1e-4f,
                  "seed %d: %g at the feature, %g next to it", (int)seed, (double)v[0],
                  (double)v[1]);
            seen++;
        }
    }
    CHECK(seen > 0, "no feature is at a place that floats have");
}

int main(int argc, char **argv)
{
    const long wanted = argc > 1 ? strtol(argv[1], NULL, 10) : 64;
    lines = (size_t)(wanted < MOST_LINES ? wanted : MOST_LINES);
    make_lines();
    test_features();
    for (int dimensions = 2; dimensions <= 3; dimensions++) {
        for (int basis = 0; basis < count_names(basis_name); basis++) {
            for (int fractal = 0; fractal < count_names(fractal_name); fractal++) {
                for (int setting = 0; setting < SETTINGS; setting++) {
                    struct scarp_noise noise;
                    if (make_noise((enum scarp_basis)basis, (enum scarp_fractal)fractal,
                                   (enum setting)setting, dimensions, &noise)) {
                        test_noise(&noise, (enum setting)setting, dimensions);
                    }
                }
            }
        }
    }
    return check_done();
}
