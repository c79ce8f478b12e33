/* SPDX-License-Identifier: MIT
 *
 * Why descriptions are refused: each row of src/plan/refusals.h is reached, with its status, its
 * member and its text, and members of warps have their paths.
 */
#include "../src/plan/refusals.h"
#include "../src/plan/traits.h"

#include "check.h"

#define ROW(name, status, member, text) {SCARP_ERROR_##status, member, text},
static const struct {
    enum scarp_status status;
    const char *member, *text;
} rows[] = {SCARP_REFUSALS(ROW)};
#undef ROW
#define ROWS (sizeof rows / sizeof *rows)

static int seen[ROWS];

static int same(const char *a, const char *b)
{
    return a == b || (a != NULL && b != NULL && strcmp(a, b) == 0);
}

static const char *shown(const char *text)
{
    return text != NULL ? text : "nothing";
}

/* Marks the row that a call names, without the warps on the way. */
static void see(enum scarp_status status, const char *member, const char *text)
{
    int found = 0;
    for (size_t i = 0; i < ROWS; i++) {
        if (rows[i].status == status && same(rows[i].text, text) &&
            strcmp(rows[i].member, member != NULL ? member : "") == 0) {
            seen[i] = found = 1;
        }
    }
    CHECK(found, "%d, %s: %s: no such row", (int)status, shown(member), shown(text));
}

/* A fault of a noise, and what is to be said of it. */
struct bad_noise {
    struct scarp_noise noise;
    enum scarp_status status;
    const char *member, *text;
    int dimensions; /* 0: 2 */
};

#define SIXTEENTHS "outside [1/16, 16]"
#define LAST "more than 2^30 cells in the last octave"

static const struct bad_noise bad[] = {
    {{.basis = (enum scarp_basis)99}, SCARP_ERROR_ENUM, "basis", "there is no such basis", 0},
    {{.fade = (enum scarp_fade)99}, SCARP_ERROR_ENUM, "fade", "there is no such fade", 0},
    {{.fractal = (enum scarp_fractal) - 1},
     SCARP_ERROR_ENUM,
     "fractal",
     "there is no such fractal",
     0},
    {{.frequency = -1.0}, SCARP_ERROR_PARAMETER, "frequency", "outside [2^-32, 2^48]", 0},
    {{.frequency = (double)NAN}, SCARP_ERROR_PARAMETER, "frequency", "outside [2^-32, 2^48]", 0},
    {{.octaves = 33.0f}, SCARP_ERROR_PARAMETER, "octaves", "outside (0, 32]", 0},
    {{.lacunarity = 17.0f}, SCARP_ERROR_PARAMETER, "lacunarity", SIXTEENTHS, 0},
    {{.gain = 0.01f}, SCARP_ERROR_PARAMETER, "gain", SIXTEENTHS, 0},
    {{.amplitude = -0x1p25f},
     SCARP_ERROR_PARAMETER,
     "amplitude",
     "its magnitude is outside [2^-24, 2^24]",
     0},
    {{.erosion = -1.0f}, SCARP_ERROR_PARAMETER, "erosion", "outside [2^-24, 2^24]", 0},
    {{.fractal = SCARP_JORDAN, .erosion = NAN},
     SCARP_ERROR_PARAMETER,
     "erosion",
     "outside [2^-24, 2^24]",
     0},
    {{.fractal = SCARP_JORDAN, .erosion = 2.0f},
     SCARP_ERROR_PARAMETER,
     "erosion",
     "this fractal takes 1 at most",
     0},
    {{.phase = INFINITY}, SCARP_ERROR_PARAMETER, "phase", "not finite", 0},
    {{.jitter = 2.0f}, SCARP_ERROR_PARAMETER, "jitter", "outside (0, 1]", 0},
    {{.sharpness = 0x1p25f}, SCARP_ERROR_PARAMETER, "sharpness", "outside [2^-24, 2^24]", 0},
    {{.fractal = SCARP_PINGPONG, .sharpness = 0x1p9f},
     SCARP_ERROR_PARAMETER,
     "sharpness",
     "outside [2^-8, 2^8]",
     0},
    {{.octaves = 4.0f, .of_octaves = 3.0f},
     SCARP_ERROR_PARAMETER,
     "of_octaves",
     "below octaves",
     0},
    {{.of_octaves = 33.0f}, SCARP_ERROR_PARAMETER, "of_octaves", "outside [octaves, 32]", 0},
    {{.of_octaves = NAN}, SCARP_ERROR_PARAMETER, "of_octaves", "outside [octaves, 32]", 0},
    {{.frequency = 0x1p40, .octaves = 10.0f},
     SCARP_ERROR_PARAMETER,
     "octaves",
     "the frequency of the last octave is outside [2^-32, 2^48]",
     0},
    {{.spare = {[3] = 1}}, SCARP_ERROR_UNSUPPORTED, "spare", "a reserved member is not 0", 0},
    {{.basis = SCARP_VALUE, .phase = 1.0f},
     SCARP_ERROR_UNSUPPORTED,
     "phase",
     "only gradient noise has a phase",
     0},
    {{.octaves = 2.0f, .lacunarity = 2.5f, .period = {4}},
     SCARP_ERROR_PARAMETER,
     "lacunarity",
     "not a whole number, which octaves with a period need",
     0},
    {{.period = {0x80000000u}}, SCARP_ERROR_PARAMETER, "period[0]", LAST, 0},
    {{.octaves = 9.0f, .period = {4, 1u << 29}}, SCARP_ERROR_PARAMETER, "period[1]", LAST, 0},
    {{.octaves = 9.0f, .period = {0, 0, 1u << 29}}, SCARP_ERROR_PARAMETER, "period[2]", LAST, 3},
    {{.rotate = 1, .octaves = 2.0f, .period = {4}},
     SCARP_ERROR_UNSUPPORTED,
     "rotate",
     "turned axes cannot repeat",
     0},
    {{.basis = SCARP_SIMPLEX, .period = {4, 4}},
     SCARP_ERROR_UNSUPPORTED,
     "period[1]",
     "simplex noise repeats along x only in 2D; a slice of 3D, with periods, repeats along both",
     0},
};
#define BAD (sizeof bad / sizeof *bad)

/* Checks what calls say of a noise. `path` is what is before the member. */
static void expect_noise(const struct scarp_noise *noise, const struct bad_noise *of,
                         const char *path)
{
    const int dimensions = of->dimensions == 0 ? 2 : of->dimensions;
    char wanted[64];
    const char *member = "not written", *checked = "not written", *shader = "not written";
    snprintf(wanted, sizeof wanted, "%s%s", path, of->member);
    const char *const text = scarp_noise_fault(noise, dimensions, 0, 0, &member);
    const char *const of_shader = scarp_gpu_plan_fault(noise, dimensions, 0, &shader);
    CHECK(same(text, of->text) && same(member, wanted), "%s: %s, not %s: %s", shown(member),
          shown(text), wanted, of->text);
    CHECK(scarp_noise_check(noise, dimensions, &checked) == of->status && same(checked, wanted),
          "check: %s, not %s", shown(checked), wanted);
    CHECK(same(of_shader, of->text) && same(shader, wanted), "shader: %s: %s", shown(shader),
          shown(of_shader));
    CHECK(same(scarp_noise_fault(noise, dimensions, 2, 1, NULL), of->text), "without a member");
    if (*path == '\0') {
        see(of->status, member, text);
    }
}

/* The same fault in the noise itself and in each of its warps. */
static void test_noises(void)
{
    static const char *const paths[] = {"", "warp.", "warp.warp.", "warp.warp.warp.",
                                        "warp.warp.warp.warp."};
    for (size_t i = 0; i < BAD; i++) {
        struct scarp_noise levels[5];
        expect_noise(&bad[i].noise, &bad[i], "");
        for (int depth = 1; depth <= 4; depth++) {
            memset(levels, 0, sizeof levels);
            for (int level = 0; level < depth; level++) {
                levels[level].warp = &levels[level + 1];
            }
            memcpy(&levels[depth], &bad[i].noise, sizeof levels[depth]);
            expect_noise(&levels[0], &bad[i], paths[depth]);
        }
    }
}

/* The fifth warp is refused, whatever is in it. */
static void test_fifth(void)
{
    struct scarp_noise self = {.warp = NULL}, levels[6];
    const struct bad_noise five = {
        {.warp = NULL}, SCARP_ERROR_UNSUPPORTED, "warp", "there are more than four warps", 0};
    self.warp = &self;
    memset(levels, 0, sizeof levels);
    for (int level = 0; level < 5; level++) {
        levels[level].warp = &levels[level + 1];
    }
    levels[5].octaves = -1.0f;
    expect_noise(&self, &five, "warp.warp.warp.warp.");
    expect_noise(&levels[0], &five, "warp.warp.warp.warp.");
    see(five.status, "warp", five.text);
    const char *member = "not written";
    CHECK(scarp_noise_fault(&levels[1], 3, 2, 1, &member) != NULL &&
              same(member, "warp.warp.warp.warp.octaves"),
          "the fourth warp: %s", shown(member));
    levels[5].octaves = 1.0f;
    CHECK(scarp_noise_fault(&levels[1], 3, 2, 1, &member) == NULL && member == NULL,
          "four warps: %s", shown(member));
}

static void expect_asked(const struct scarp_noise *noise, int order, int dphase, const char *wanted,
                         const char *text)
{
    static float value[2][1], x[1] = {0.3f};
    const struct scarp_samples out = {
        .value = value[0], .dxx = order == 2 ? value[1] : NULL, .dphase = dphase ? value[1] : NULL};
    const enum scarp_status status = scarp_sample2(noise, 1, x, x, &out);
    const char *member = "not written";
    const char *const found = scarp_noise_fault(noise, 2, order, dphase, &member);
    CHECK(same(found, text) && same(member, wanted), "%s: %s, not %s: %s", shown(member),
          shown(found), shown(wanted), shown(text));
    CHECK(status == (text == NULL ? SCARP_OK : SCARP_ERROR_UNSUPPORTED), "%s: the call: %s",
          shown(text), scarp_status_text(status));
    if (text != NULL && strncmp(wanted, "warp.", 5) != 0) {
        see(status, member, found);
    }
}

/* What noises do not have; calls that ask for it refuse them. */
static void test_outputs(void)
{
    static const char hessian[] = "this fractal has no Hessian";
    static const char bends[] = "this fractal has no dphase";
    static const char basis[] = "only gradient noise has dphase";
    for (int fractal = 0; fractal_name(fractal) != NULL; fractal++) {
        const int bent = fractal_bends((enum scarp_fractal)fractal);
        const int has = !fractal_has((enum scarp_fractal)fractal, FRACTAL_SLOPES);
        const struct scarp_noise n = {.fractal = (enum scarp_fractal)fractal};
        const struct scarp_noise warped = {.warp = &n}, twice = {.warp = &warped};
        expect_asked(&n, 1, 0, NULL, NULL);
        expect_asked(&n, 2, 0, has ? NULL : "fractal", has ? NULL : hessian);
        expect_asked(&warped, 2, 0, has ? NULL : "warp.fractal", has ? NULL : hessian);
        expect_asked(&twice, 2, 1, has ? NULL : "warp.warp.fractal", has ? NULL : hessian);
        expect_asked(&n, 0, 1, bent ? "fractal" : NULL, bent ? bends : NULL);
        expect_asked(&warped, 1, 1, NULL, NULL);
    }
    for (int i = 0; basis_name(i) != NULL; i++) {
        const struct scarp_noise n = {.basis = (enum scarp_basis)i}, warped = {.warp = &n};
        expect_asked(&n, 1, 1, i == 0 ? NULL : "basis", i == 0 ? NULL : basis);
        expect_asked(&warped, 1, 1, NULL, NULL);
    }
}

static void expect_arguments(const struct scarp_noise *noise, int dimensions, int order,
                             const char *text)
{
    const char *member = "not written";
    const char *const found = scarp_noise_fault(noise, dimensions, order, 0, &member);
    CHECK(same(found, text) && member == NULL, "%s: %s, not %s", shown(member), shown(found), text);
    see(noise == NULL ? SCARP_ERROR_NULL : SCARP_ERROR_PARAMETER, member, found);
}

static void test_arguments(void)
{
    const struct scarp_noise good = {.seed = 1};
    static const char null[] = "a required pointer is NULL";
    static const char dimensions[] = "dimensions are neither 2 nor 3";
    static const char order[] = "the order of derivatives is not 0, 1 or 2";
    const char *member = "not written";
    expect_arguments(NULL, 2, 0, null);
    expect_arguments(NULL, 9, 9, null);
    expect_arguments(&good, 1, 0, dimensions);
    expect_arguments(&good, 258, 9, dimensions);
    expect_arguments(&good, 2, 3, order);
    expect_arguments(&good, 3, -1, order);
    expect_arguments(&good, 3, 65536, order); /* 0 as a short */
    CHECK(same(scarp_gpu_plan_fault(NULL, 2, 0, &member), null) && member == NULL, "no noise");
    CHECK(same(scarp_gullies_fault(NULL, &member), null) && member == NULL, "no gullies");
    CHECK(same(scarp_grid_fault(NULL, 7, &member), null) && member == NULL, "no grid");
}

static void test_shaders(void)
{
    static const char warp_text[] = "more than 32 octaves in the noise and its warps";
    static const char octaves_text[] = "more than 32 in all components";
    static struct scarp_gpu_plan plan;
    const struct scarp_noise warp = {.octaves = 20.0f}, noise = {.octaves = 20.0f, .warp = &warp};
    const struct scarp_noise cells = {.basis = SCARP_CELL_F1, .octaves = 17.0f};
    const char *member = "not written", *made = member;
    const char *text = scarp_gpu_plan_fault(&noise, 2, 0, &member);
    enum scarp_status status = scarp_gpu_plan_make(&noise, 2, &plan, &made);
    CHECK(same(text, warp_text) && same(member, "warp") && same(made, "warp"), "%s: %s",
          shown(member), shown(text));
    see(status, made, text);
    text = scarp_gpu_plan_fault(&cells, 2, 1, &member);
    status = scarp_gpu_vector_plan_make(&cells, 2, &plan, &made);
    CHECK(same(text, octaves_text) && same(member, "octaves") && same(made, "octaves"), "%s: %s",
          shown(member), shown(text));
    see(status, made, text);
    CHECK(scarp_gpu_plan_fault(&cells, 2, 0, &member) == NULL && member == NULL, "one component");
}

static void test_gullies(void)
{
    static const char steep[] = "outside [2^-5, 2^5]", wide[] = "outside [-2^10, 2^10]";
    static const char whole[] = "times cells, not a whole number up to 2^30";
    static const struct {
        struct scarp_gullies g;
        const char *member, *text;
    } wrong[] = {
        {{.frequency = -1.0}, "frequency", "outside [2^-32, 2^48]"},
        {{.frequency = 0x1p48, .cells = 2.0f}, "frequency", "times cells, outside [2^-32, 2^48]"},
        {{.amplitude = -1.0f}, "amplitude", "outside [2^-24, 2^24]"},
        {{.octaves = 33.0f}, "octaves", "outside (0, 32]"},
        {{.octaves = 3.0f, .of_octaves = 2.0f}, "of_octaves", "below octaves"},
        {{.gain = -1.0f}, "gain", SIXTEENTHS},
        {{.depth = NAN}, "depth", "outside [2^-24, 2^10]"},
        {{.cells = 65.0f}, "cells", "outside [2^-6, 2^6]"},
        {{.slope = 33.0f}, "slope", steep},
        {{.slope_low = 0.03f}, "slope_low", steep},
        {{.low = -1025.0f}, "low", wide},
        {{.high = INFINITY}, "high", wide},
        {{.low = 1.0f}, "high", "less than 2^-10 above low"},
        {{.floor = 1.1f}, "floor", "outside [-1, 1]"},
        {{.stripes = 8.5f}, "stripes", "outside [2^-10, 8]"},
        {{.branch = -0.5f}, "branch", "outside [2^-24, 8]"},
        {{.round = 0.003f}, "round", "outside [2^-8, 2^8]"},
        {{.keep = 1.5f}, "keep", "outside [2^-24, 1]"},
        {{.period = {3, 0}, .cells = 1.5f}, "period[0]", whole},
        {{.period = {0, 0x80000000u}}, "period[1]", whole},
        {{.period = {4, 0}, .rotate = 1}, "rotate", "turned axes cannot repeat"},
        {{.spare = {[7] = 1}}, "spare", "a reserved member is not 0"},
    };
    const struct scarp_gullies good = {.seed = 1};
    const char *member = "not written", *checked = member;
    for (size_t i = 0; i < sizeof wrong / sizeof *wrong; i++) {
        const char *const text = scarp_gullies_fault(&wrong[i].g, &member);
        const enum scarp_status status = scarp_gullies_check(&wrong[i].g, &checked);
        CHECK(same(text, wrong[i].text) && same(member, wrong[i].member), "%s: %s, not %s: %s",
              shown(member), shown(text), wrong[i].member, wrong[i].text);
        CHECK(same(checked, member), "check: %s", shown(checked));
        see(status, member, text);
    }
    CHECK(scarp_gullies_fault(&good, &member) == NULL && member == NULL, "good gullies");
    CHECK(scarp_gullies_fault(&good, NULL) == NULL, "without a member");
}

/* The same of a grid, and of a call that is made on it. */
static void expect_grid(const struct scarp_grid *grid, int dimensions, const char *wanted,
                        const char *text)
{
    const struct scarp_noise noise = {.seed = 1};
    const struct scarp_samples out = {.value = NULL};
    const char *member = "not written";
    const char *const found = scarp_grid_fault(grid, dimensions, &member);
    const enum scarp_status status =
        (dimensions == 2 ? scarp_grid2 : scarp_grid3)(&noise, grid, &out);
    CHECK(same(found, text) && same(member, wanted), "%s: %s, not %s: %s", shown(member),
          shown(found), shown(wanted), shown(text));
    CHECK(same(scarp_grid_fault(grid, dimensions, NULL), text), "without a member");
    CHECK((status == SCARP_OK) == (text == NULL), "%s: the call: %s", shown(text),
          scarp_status_text(status));
    if (text != NULL) {
        see(status, member, found);
    }
}

static void test_grids(void)
{
    static const char *const origins[] = {"origin[0]", "origin[1]", "origin[2]"};
    static const char *const steps[] = {"step[0]", "step[1]", "step[2]"};
    static const char *const firsts[] = {"first[0]", "first[1]", "first[2]"};
    static const char *const counts[] = {"count[0]", "count[1]", "count[2]"};
    static const char size[] = "the arrays would exceed the address space";
    const int64_t end = INT64_C(1) << 53;
    const struct scarp_grid good = {.step = {1.0, 1.0, 1.0}, .count = {4, 3, 2}};
    struct scarp_grid g = good;
    for (int dimensions = 2; dimensions <= 3; dimensions++) {
        expect_grid(&good, dimensions, NULL, NULL);
        for (int axis = 0; axis < 3; axis++) {
            const int is_axis = axis < dimensions;
            g = good;
            g.origin[axis] = (double)INFINITY;
            expect_grid(&g, dimensions, is_axis ? origins[axis] : NULL,
                        is_axis ? "not finite" : NULL);
            g = good;
            g.step[axis] = (double)NAN;
            expect_grid(&g, dimensions, is_axis ? steps[axis] : NULL,
                        is_axis ? "not finite" : NULL);
            g = good;
            g.first[axis] = -end - 1;
            expect_grid(&g, dimensions, is_axis ? firsts[axis] : NULL,
                        is_axis ? "outside [-2^53, 2^53]" : NULL);
            g = good;
            g.first[axis] = end;
            expect_grid(&g, dimensions, is_axis ? counts[axis] : NULL,
                        is_axis ? "the last index is above 2^53" : NULL);
        }
        g = good;
        g.row_stride = 3;
        expect_grid(&g, dimensions, "row_stride", "shorter than a row");
        g = good;
        g.row_stride = SIZE_MAX / 4;
        g.count[1] = 9;
        expect_grid(&g, dimensions, NULL, size);
        g = good;
        g.spare[1] = 1;
        expect_grid(&g, dimensions, "spare", "a reserved member is not 0");
        g.count[1] = 0;
        expect_grid(&g, dimensions, NULL, NULL);
    }
    g = good;
    g.slice_stride = 11;
    expect_grid(&g, 3, "slice_stride", "shorter than a slice");
    g.slice_stride = SIZE_MAX / 4;
    expect_grid(&g, 3, NULL, size);
    const char *member = "not written";
    const char *const text = scarp_grid_fault(&good, 4, &member);
    CHECK(same(text, "dimensions are neither 2 nor 3") && member == NULL, "%s", shown(text));
}

int main(void)
{
    test_noises();
    test_fifth();
    test_outputs();
    test_arguments();
    test_shaders();
    test_gullies();
    test_grids();
    for (size_t i = 0; i < ROWS; i++) {
        CHECK(seen[i], "%s: %s: no test reaches it", rows[i].member, rows[i].text);
    }
    return check_done();
}
