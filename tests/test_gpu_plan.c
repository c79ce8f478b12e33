/* SPDX-License-Identifier: MIT
 *
 * What the library gives to shaders: the layout of struct scarp_gpu_plan, its members against the
 * constants of the plans that the kernels compute with, and what is refused. (test_gpu_answers.c
 * has the answers of the self-test, gpu/ the shaders.)
 */
#include "check.h"

#include "../src/plan/octaves.h"
#include "../src/plan/parameters.h"
#include "../src/plan/phase.h"

#define POISON 0xa5

#define LAYOUT(type, member, bytes)                                                                \
    CHECK(offsetof(struct type, member) == (bytes), #type "." #member " is at %zu",                \
          offsetof(struct type, member))

/* The offsets that the shaders read from. */
static void test_layout(void)
{
    LAYOUT(scarp_gpu_octave, key, 0);
    LAYOUT(scarp_gpu_octave, frequency, 12);
    LAYOUT(scarp_gpu_octave, weight, 16);
    LAYOUT(scarp_gpu_octave, amplitude, 20);
    LAYOUT(scarp_gpu_octave, slope, 24);
    LAYOUT(scarp_gpu_octave, curvature, 28);
    LAYOUT(scarp_gpu_octave, last, 32);
    LAYOUT(scarp_gpu_octave, share, 44);
    LAYOUT(scarp_gpu_octave, turn, 48);
    LAYOUT(scarp_gpu_octave, jacobian, 64);
    LAYOUT(scarp_gpu_octave, gradient, 112);
    LAYOUT(scarp_gpu_level, basis, 0);
    LAYOUT(scarp_gpu_level, fade, 4);
    LAYOUT(scarp_gpu_level, fractal, 8);
    LAYOUT(scarp_gpu_level, octaves, 12);
    LAYOUT(scarp_gpu_level, rotate, 16);
    LAYOUT(scarp_gpu_level, flows, 20);
    LAYOUT(scarp_gpu_level, first, 24);
    LAYOUT(scarp_gpu_level, spare0, 28);
    LAYOUT(scarp_gpu_level, erosion, 32);
    LAYOUT(scarp_gpu_level, sharpness, 36);
    LAYOUT(scarp_gpu_level, inverse_weight, 40);
    LAYOUT(scarp_gpu_level, spare1, 44);
    LAYOUT(scarp_gpu_plan, depth, 0);
    LAYOUT(scarp_gpu_plan, dimensions, 4);
    LAYOUT(scarp_gpu_plan, zero, 8);
    LAYOUT(scarp_gpu_plan, unit, 12);
    LAYOUT(scarp_gpu_plan, level, 16);
    LAYOUT(scarp_gpu_plan, octave, 256);
    CHECK(sizeof(struct scarp_gpu_octave) == 160 && sizeof(struct scarp_gpu_level) == 48,
          "%zu and %zu bytes", sizeof(struct scarp_gpu_octave), sizeof(struct scarp_gpu_level));
    CHECK(sizeof(struct scarp_gpu_plan) == 5376, "%zu bytes", sizeof(struct scarp_gpu_plan));
    CHECK(3 * sizeof(struct scarp_gpu_plan) <= 16384, "three plans do not fit into 16 KiB");
}

/* The plan of a noise that must have one. */
static struct scarp_gpu_plan plan_of(const struct scarp_noise *noise, int dimensions)
{
    struct scarp_gpu_plan plan;
    const char *member = "";
    memset(&plan, POISON, sizeof plan);
    const enum scarp_status status = scarp_gpu_plan_make(noise, dimensions, &plan, &member);
    CHECK(status == SCARP_OK && member == NULL, "status %d, %s", (int)status, member);
    return plan;
}

/* 1 / a, within floats. */
static float inverse_within(float a)
{
    const double inverse = 1.0 / (double)a, most = 0x1.fffffep127;
    return (float)(inverse > most ? most : inverse < -most ? -most : inverse);
}

/* What octave k must be, member by member. Its constants are `o`; `first` is octave 0. */
static struct scarp_gpu_octave octave_expected(const struct scarp_noise *noise, int dimensions,
                                               const struct scarp_octave *first, int k)
{
    const struct scarp_octave *const o = first + k;
    struct scarp_gpu_octave e = {.key = {o->key[0], o->key[1], o->key[2]},
                                 .frequency = o->frequency,
                                 .weight = o->weight,
                                 .amplitude = o->amplitude,
                                 .slope = o->slope,
                                 .curvature = o->curvature,
                                 .last = {o->last[0], o->last[1], 0xffffffffu},
                                 .share = o->share};
    if (dimensions == 3) {
        e.last[2] = o->last[2];
    }
    if (noise->phase != 0.0f) {
        memcpy(e.turn, o->turn, sizeof e.turn);
    } else if (!blends_corners(noise->basis)) {
        e.turn[0] = o->jitter;
        e.turn[1] = o->middle;
        e.turn[2] = (float)o->stretch;
    }
    for (int i = 0; i < dimensions; i++) {
        e.jacobian[i][3] = (float)o->offset[i];
        for (int j = 0; j < dimensions && noise->rotate != 0 && k > 0; j++) {
            e.jacobian[i][j] = o->jacobian[i][j];
            e.gradient[i][j] = o->gradient[i][j];
        }
    }
    const double sharpness = parameters_of(noise).sharpness;
    if (fractal_bends(noise->fractal) || basis_has(noise->basis, BASIS_CELLS)) {
        e.gradient[0][3] = (float)(1.0 / o->frequency64);
    }
    if (fractal_bends(noise->fractal)) {
        const int swiss = noise->fractal == SCARP_SWISS;
        e.gradient[1][3] = (float)(sharpness / (swiss ? first : o)->frequency64);
    }
    return e;
}

static struct scarp_gpu_level level_expected(const struct scarp_noise *noise, uint32_t octaves,
                                             const struct scarp_octave *first)
{
    const struct parameters p = parameters_of(noise);
    const int bends = fractal_bends(noise->fractal);
    const int shaped = fractal_row(noise->fractal)->sharpness != 0.0f;
    const struct scarp_gpu_level e = {.basis = (uint32_t)noise->basis,
                                      .fade = (uint32_t)noise->fade,
                                      .fractal = (uint32_t)noise->fractal,
                                      .octaves = octaves,
                                      .rotate = noise->rotate != 0 && octaves > 1,
                                      .flows = noise->phase != 0.0f,
                                      .erosion = (float)p.erosion,
                                      .sharpness = shaped ? (float)p.sharpness : 0.0f,
                                      .inverse_weight =
                                          bends ? inverse_within(first->weight) : 0.0f};
    return e;
}

/* Compares words, so that zeros count that no test names. `what` is a level or an octave. */
static void compare_words(const void *a, const void *b, size_t size, const char *name,
                          const char *what, int number)
{
    uint32_t x, y;
    for (size_t at = 0; at < size; at += sizeof x) {
        memcpy(&x, (const char *)a + at, sizeof x);
        memcpy(&y, (const char *)b + at, sizeof y);
        CHECK(x == y, "%s, %s %d, byte %zu: %08x, not %08x", name, what, number, at, (unsigned)x,
              (unsigned)y);
    }
}

/* Compares the plan of a noise, whose octaves number `octaves`, from level to level with what
   octaves.c and phase.c make. */
static void compare_plan(const struct scarp_noise *noise, int dimensions, const char *name)
{
    static const struct scarp_gpu_octave no_octave;
    static const struct scarp_gpu_level no_level;
    const struct scarp_gpu_plan plan = plan_of(noise, dimensions);
    int level = 0, count = 0;
    for (const struct scarp_noise *n = noise; n != NULL; n = n->warp, level++) {
        const float o = n->octaves == 0.0f ? 1.0f : n->octaves;
        const int shares = blends_corners(n->basis);
        const int octaves = (int)ceilf(o), components = level == 0 || shares ? 1 : dimensions;
        for (int i = 0; i < components; i++) {
            struct scarp_octave space[SCARP_MAX_OCTAVES];
            struct scarp_noise of_component = *n;
            of_component.warp = NULL;
            of_component.seed = level == 0 ? n->seed : scarpi_component_seed(n->seed, i);
            scarpi_octaves_make(space, &of_component, dimensions);
            if (n->phase != 0.0f) {
                scarpi_phase_set(space, octaves, n->phase);
            }
            if (i == 0) {
                struct scarp_gpu_level e = level_expected(n, (uint32_t)octaves, space);
                e.first = (uint32_t)count;
                compare_words(&plan.level[level], &e, sizeof e, name, "level", level);
            }
            for (int k = 0; k < octaves; k++, count++) {
                const struct scarp_gpu_octave e = octave_expected(n, dimensions, space, k);
                compare_words(&plan.octave[count], &e, sizeof e, name, "octave", count);
            }
        }
    }
    CHECK(plan.depth == (uint32_t)level - 1 && plan.dimensions == (uint32_t)dimensions &&
              plan.zero == 0,
          "%s: depth %u, dimensions %u, zero %u", name, (unsigned)plan.depth,
          (unsigned)plan.dimensions, (unsigned)plan.zero);
    for (; level < 5; level++) {
        compare_words(&plan.level[level], &no_level, sizeof no_level, name, "level", level);
    }
    for (; count < 32; count++) {
        compare_words(&plan.octave[count], &no_octave, sizeof no_octave, name, "octave", count);
    }
}

static const struct scarp_noise flowing = {
    .octaves = 2.0f, .seed = 5, .phase = -1.3f, .frequency = 0.3, .amplitude = 0.2f};
static const struct scarp_noise bending = {.fractal = SCARP_JORDAN,
                                           .octaves = 3.0f,
                                           .seed = 6,
                                           .rotate = 1,
                                           .erosion = 0.5f,
                                           .warp = &flowing};

/* All bases and fractals, straight and turned; then what else a noise can have. */
static void test_plans(void)
{
    const int fractals = count_names(fractal_name), bases = count_names(basis_name);
    for (int i = 0; i < 2 * bases * fractals; i++) {
        const struct scarp_noise noise = {.basis = (enum scarp_basis)(i / 2 / fractals),
                                          .fractal = (enum scarp_fractal)(i / 2 % fractals),
                                          .fade = (enum scarp_fade)(i % 3 % 2),
                                          .rotate = 7 * ((uint32_t)i % 2),
                                          .seed = (uint64_t)i,
                                          .frequency = 0.7,
                                          .octaves = 3.5f,
                                          .lacunarity = 1.9f,
                                          .gain = 0.6f,
                                          .amplitude = -2.0f,
                                          .erosion = i % 5 == 0 ? 0.3f : 0.0f,
                                          .jitter = i % 7 == 0 ? 0.8f : 0.0f,
                                          .sharpness = i % 3 == 0 ? 0.0f : 1.7f,
                                          .offset_first = (uint32_t)i / 2 % 2};
        char name[80];
        snprintf(name, sizeof name, "%s %s", scarp_basis_name(noise.basis),
                 scarp_fractal_name(noise.fractal));
        compare_plan(&noise, 2, name);
        compare_plan(&noise, 3, name);
    }
    const struct scarp_noise others[] = {
        {0},
        {.octaves = 32.0f, .gain = 16.0f, .amplitude = 0x1p-24f, .fractal = SCARP_SWISS},
        {.octaves = 3.0f, .period = {5, 0, 9}},
        {.octaves = 2.0f, .period = {0, 7, 1u << 29}, .basis = SCARP_CELL_EDGE},
        {.octaves = 4.0f, .phase = 0.3f, .fade = SCARP_CUBIC, .of_octaves = 7.5f},
        {.octaves = 1.0f, .rotate = 1, .offset_first = 7},
        {.octaves = 2.0f, .warp = &flowing},
        {.basis = SCARP_SIMPLEX, .octaves = 2.5f, .warp = &bending},
        {.fractal = SCARP_SWISS,
         .octaves = 2.0f,
         .frequency = 3.0,
         .phase = 0.1f,
         .warp = &bending},
    };
    for (size_t i = 0; i < sizeof others / sizeof others[0]; i++) {
        char name[20];
        snprintf(name, sizeof name, "noise %zu", i);
        compare_plan(&others[i], 2, name);
        compare_plan(&others[i], 3, name);
    }
}

/* What has no meaning changes nothing: a plan that was kept, the period along z in 2D. */
static void test_same(void)
{
    static struct scarp_plan kept;
    struct scarp_noise noise = {.octaves = 3.0f, .seed = 9, .basis = SCARP_GRADIENT};
    const struct scarp_gpu_plan expected = plan_of(&noise, 2);
    noise.period[2] = 17;
    const struct scarp_gpu_plan along_z = plan_of(&noise, 2);
    compare_words(&along_z, &expected, sizeof expected, "period[2]", "plan", 0);
    noise.period[2] = 0;
    CHECK(scarp_plan_make(&noise, 2, &kept) == SCARP_OK, "no plan");
    noise.plan = &kept;
    const struct scarp_gpu_plan of_kept = plan_of(&noise, 2);
    compare_words(&of_kept, &expected, sizeof expected, "kept", "plan", 0);
    CHECK(scarp_gpu_plan_make(&noise, 2, &(struct scarp_gpu_plan){0}, NULL) == SCARP_OK,
          "without member");
}

/* The unit is a power of two, and no other is nearer 1 / (256 frequency). */
static void test_unit(void)
{
    static const double frequencies[] = {0x1p-32, 0x1p48,    0.0,    1.0,
                                         3.0,     0.75,      1.3333, 1.3334,
                                         0.1,     0x1.8p-17, 1e-4,   0x1.fffffffffffffp9};
    for (size_t i = 0; i < sizeof frequencies / sizeof frequencies[0]; i++) {
        const struct scarp_noise noise = {.frequency = frequencies[i], .warp = &flowing};
        const double f = frequencies[i] == 0.0 ? 1.0 : frequencies[i], exact = 1.0 / (256.0 * f);
        const double unit = (double)plan_of(&noise, 2).unit, off = fabs(unit - exact);
        int exponent;
        CHECK(frexp(unit, &exponent) == 0.5, "frequency %g: %a", f, unit);
        CHECK(off <= fabs(unit / 2.0 - exact) && off <= fabs(unit * 2.0 - exact),
              "frequency %g: %a", f, unit);
    }
}

/* A noise that is refused leaves the plan, and the answers, as they were. */
static void expect_refused(const struct scarp_noise *noise, int dimensions,
                           enum scarp_status expected, const char *member)
{
    static struct scarp_gpu_plan plan, untouched;
    static uint32_t answer[SCARP_GPU_ANSWERS];
    const char *found = "";
    memset(&plan, POISON, sizeof plan);
    memset(&untouched, POISON, sizeof untouched);
    memset(answer, POISON, sizeof answer);
    const char *const name = member == NULL ? "no member" : member;
    const enum scarp_status status = scarp_gpu_plan_make(noise, dimensions, &plan, &found);
    const int same = found == member || (found != NULL && member != NULL && !strcmp(found, member));
    CHECK(status == expected && same, "%s: status %d, %s", name, (int)status, found);
    CHECK(memcmp(&plan, &untouched, sizeof plan) == 0, "%s: the plan has changed", name);
    CHECK(scarp_gpu_plan_make(noise, dimensions, &plan, NULL) == expected, "%s, member NULL", name);
    CHECK(scarp_gpu_answers(noise, dimensions, 0, answer) == expected, "%s: answers", name);
    CHECK(scarp_gpu_answers(noise, dimensions, 3, answer) == expected, "%s: order 3", name);
    for (int i = 0; i < SCARP_GPU_ANSWERS; i++) {
        CHECK(answer[i] == 0x01010101u * POISON, "%s: answer %d has changed", name, i);
    }
}

static void test_errors(void)
{
    static const struct scarp_noise fine = {0}, bad_warp = {.octaves = 33.0f};
    static const struct scarp_noise deep = {.warp = &bending}, deeper = {.warp = &deep},
                                    deepest = {.warp = &deeper};
    const struct scarp_noise basis = {.basis = (enum scarp_basis)99};
    const struct scarp_noise gain = {.gain = 17.0f}, spare = {.spare = {1}};
    const struct scarp_noise period = {.octaves = 32.0f, .period = {0, 5}};
    const struct scarp_noise phase = {.phase = 1.0f, .basis = SCARP_VALUE};
    const struct scarp_noise warp = {.warp = &bad_warp}, warps = {.warp = &deepest};
    const char *member = "";
    struct scarp_gpu_plan plan;
    expect_refused(NULL, 2, SCARP_ERROR_NULL, NULL);
    CHECK(scarp_gpu_plan_make(&gain, 2, NULL, &member) == SCARP_ERROR_NULL && member == NULL,
          "plan NULL: %s", member);
    CHECK(scarp_gpu_plan_make(NULL, 7, NULL, NULL) == SCARP_ERROR_NULL, "all NULL");
    CHECK(scarp_gpu_answers(&fine, 2, 0, NULL) == SCARP_ERROR_NULL, "answer NULL");
    expect_refused(&basis, 2, SCARP_ERROR_ENUM, "basis");
    expect_refused(&gain, 3, SCARP_ERROR_PARAMETER, "gain");
    expect_refused(&spare, 3, SCARP_ERROR_UNSUPPORTED, "spare");
    expect_refused(&fine, 4, SCARP_ERROR_PARAMETER, NULL);
    expect_refused(&period, 2, SCARP_ERROR_PARAMETER, "period[1]");
    expect_refused(&phase, 2, SCARP_ERROR_UNSUPPORTED, "phase");
    expect_refused(&warp, 2, SCARP_ERROR_PARAMETER, "warp.octaves");
    expect_refused(&warps, 2, SCARP_ERROR_UNSUPPORTED, "warp.warp.warp.warp.warp");
    CHECK(scarp_gpu_plan_make(&deepest, 2, &plan, NULL) == SCARP_OK, "four warps");
}

/* Octaves of all levels: 32 in all fit, and no more. The components of the deep warp have octaves
   of their own. */
static void test_room(void)
{
    for (int dimensions = 2; dimensions <= 3; dimensions++) {
        for (int i = 0; i <= 1; i++) {
            const int of_deep = dimensions == 2 ? 7 : 3, of_warp = dimensions == 2 ? 5 : 4;
            const int left = 32 - dimensions * of_deep - of_warp;
            const struct scarp_noise deep = {
                .basis = SCARP_SIMPLEX, .octaves = (float)of_deep, .seed = 3, .rotate = 1};
            const struct scarp_noise warp = {.octaves = (float)of_warp - 0.5f, .warp = &deep};
            const struct scarp_noise noise = {.octaves = (float)(left + i) - 0.75f, .warp = &warp};
            if (i == 0) {
                compare_plan(&noise, dimensions, "just enough room");
            } else {
                CHECK(scarp_noise_check(&noise, dimensions, NULL) == SCARP_OK, "%d", dimensions);
                expect_refused(&noise, dimensions, SCARP_ERROR_UNSUPPORTED, "warp");
            }
        }
    }
}

int main(void)
{
    test_layout();
    test_plans();
    test_same();
    test_unit();
    test_errors();
    test_room();
    return check_done();
}
