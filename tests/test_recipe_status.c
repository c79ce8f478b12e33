/* SPDX-License-Identifier: MIT
 *
 * Usage: test_recipe_status
 *
 * No output of a recipe is memory that nobody wrote. Results are the same whatever was in outputs,
 * in scratch memory and on the stack before. And where a call that recipes make fails, which
 * the linker (--wrap) makes each of them do in turn, recipes return its error: samples are NaN,
 * nothing is written where constants and answers go, and intervals are no narrower (but for room
 * for rounding, which is relative to finite ends).
 */
#include "../src/recipe/statuses.h"
#include "recipes.h"

#define POINTS 60
#define ARRAYS 10
#define UNIFORMS (1 << 17)

/*
 * Calls that fail
 */

static long calls, failing; /* the call that fails, counted from 1; 0: none */

static int fails(void)
{
    return ++calls == failing;
}

#define WRAP(type, failed, name, parameters, arguments)                                            \
    type __real_##name parameters;                                                                 \
    type __wrap_##name parameters;                                                                 \
    type __wrap_##name parameters                                                                  \
    {                                                                                              \
        return fails() ? failed : __real_##name arguments;                                         \
    }
#define WRAP_STATUS(name, parameters, arguments)                                                   \
    WRAP(enum scarp_status, SCARP_ERROR_ENUM, name, parameters, arguments)

#define NOISE const struct scarp_noise *n
#define SAMPLES const struct scarp_samples
#define GRID const struct scarp_grid *g
#define GULLIES const struct scarp_gullies *e

WRAP_STATUS(scarp_grid2, (NOISE, GRID, SAMPLES *to), (n, g, to))
WRAP_STATUS(scarp_grid3, (NOISE, GRID, SAMPLES *to), (n, g, to))
#define WRAP_POINTS(name, type, result)                                                            \
    WRAP_STATUS(name##2##type,                                                                     \
                (NOISE, size_t k, const COORDINATE *x, const COORDINATE *y, result to),            \
                (n, k, x, y, to))                                                                  \
    WRAP_STATUS(name##3##type,                                                                     \
                (NOISE, size_t k, const COORDINATE *x, const COORDINATE *y, const COORDINATE *z,   \
                 result to),                                                                       \
                (n, k, x, y, z, to))
#define COORDINATE float
WRAP_POINTS(scarp_sample, , SAMPLES *)
WRAP_POINTS(scarp_vector, , SAMPLES *)
WRAP_POINTS(scarp_cells, , const struct scarp_cells *)
#undef COORDINATE
#define COORDINATE double
WRAP_POINTS(scarp_sample, _f64, SAMPLES *)
WRAP_POINTS(scarp_vector, _f64, SAMPLES *)
WRAP_POINTS(scarp_cells, _f64, const struct scarp_cells *)
WRAP_STATUS(scarp_gullies2,
            (GULLIES, size_t k, const float *x, const float *y, SAMPLES *a,
             const struct scarp_eroded *to),
            (e, k, x, y, a, to))
WRAP_STATUS(scarp_gullies2_f64,
            (GULLIES, size_t k, const double *x, const double *y, SAMPLES *a,
             const struct scarp_eroded *to),
            (e, k, x, y, a, to))
WRAP_STATUS(scarp_gullies_grid2, (GULLIES, GRID, SAMPLES *a, const struct scarp_eroded *to),
            (e, g, a, to))
#define PARAMETERS_ONE_0 (size_t k, SAMPLES * a, SAMPLES * to), (k, a, to)
#define PARAMETERS_ONE_1 (size_t k, SAMPLES * a, float p, SAMPLES *to), (k, a, p, to)
#define PARAMETERS_ONE_2 (size_t k, SAMPLES * a, float p, float q, SAMPLES *to), (k, a, p, q, to)
#define PARAMETERS_ONE_3                                                                           \
    (size_t k, SAMPLES * a, float p, float q, float r, SAMPLES *to), (k, a, p, q, r, to)
#define PARAMETERS_TWO_0 (size_t k, SAMPLES * a, SAMPLES * b, SAMPLES * to), (k, a, b, to)
#define PARAMETERS_TWO_1                                                                           \
    (size_t k, SAMPLES * a, SAMPLES * b, float p, SAMPLES *to), (k, a, b, p, to)
#define PARAMETERS_THREE_0                                                                         \
    (size_t k, SAMPLES * a, SAMPLES * b, SAMPLES * m, SAMPLES * to), (k, a, b, m, to)
#define PARAMETERS_CURVE                                                                           \
    (size_t k, SAMPLES * a, size_t knots, const float *x, const float *y, SAMPLES *to),            \
        (k, a, knots, x, y, to)
#define WRAP_FORM(name, ...) WRAP_STATUS(name, __VA_ARGS__)
#define OPERATOR(NAME, name, FORM, ...) WRAP_FORM(scarp_##name, PARAMETERS_##FORM)
#define FUNCTION(...) OPERATOR(__VA_ARGS__)
#include "../src/plan/functions.def"
WRAP_STATUS(scarp_range, (NOISE, int d, float *from, float *up), (n, d, from, up))
WRAP_STATUS(scarp_gullies_range, (GULLIES, float p, float q, float *from, float *up),
            (e, p, q, from, up))
WRAP_STATUS(scarpi_run, (NOISE, struct scarp_request kind, scarpi_run_fn *f, const void *call),
            (n, kind, f, call))
WRAP(int, 0, scarpi_chain_numbers,
     (enum scarp_chain_function f, const float given[3], float to[CHAIN_NUMBERS]), (f, given, to))
WRAP_STATUS(scarpi_chain_values,
            (enum scarp_chain_function f, size_t k, const float *const in[CHAIN_INPUTS],
             const float given[3], float *to),
            (f, k, in, given, to))
WRAP(int, 0, scarpi_curve_slopes, (size_t k, const float *x, const float *y, float *to),
     (k, x, y, to))

/*
 * What is called
 */

static struct scarp_recipe recipe;
static double position[3][POINTS];
static float float_position[3][POINTS];
static uint64_t memory[1 << 14];

struct result {
    enum scarp_status status;
    float array[ARRAYS][POINTS];
};

enum how { POINTS_F64, POINTS_F32, GRID_TIGHT, GRID_STRIDES, ON_STACK, HOWS };

static const struct scarp_grid grids[2] = {
    {.origin = {-3.25, 1.5, 0.75}, .step = {0.37, 0.41, 0.83}, .count = {5, 4, 3}},
    {.origin = {-3.25, 1.5, 0.75},
     .step = {0.37, 0.41, 0.83},
     .count = {5, 3, 2},
     .row_stride = 7,
     .slice_stride = 28}};

static void set_positions(void)
{
    for (int i = 0; i < POINTS; i++) {
        position[0][i] = -3.25 + 0.37 * (double)(i % 5);
        position[1][i] = 1.5 + 0.41 * (double)(i / 5 % 4);
        position[2][i] = 0.75 + 0.83 * (double)(i / 20);
        for (int a = 0; a < 3; a++) {
            float_position[a][i] = (float)position[a][i];
        }
    }
}

static __attribute__((noinline)) void fill_stack(int byte)
{
    volatile char bytes[24576];
    for (size_t i = 0; i < sizeof bytes; i++) {
        bytes[i] = (char)byte;
    }
}

/* Samples into arrays that have a byte everywhere before, as scratch memory and stack have. */
static void sample(enum how how, int order, int is_space, int byte, struct result *to)
{
    const struct scarp_samples out = recipe_samples(to->array[0], POINTS, order, is_space);
    const struct scarp_recipe_outputs outputs = {.out = &out, .count = 1};
    const struct scarp_scratch scratch = {.memory = memory, .size = sizeof memory};
    memset(to, byte, sizeof *to);
    memset(memory, byte, sizeof memory);
    fill_stack(byte);
    if (how == GRID_TIGHT || how == GRID_STRIDES) {
        to->status = scarp_recipe_grid(&recipe, &grids[how == GRID_STRIDES], &outputs, &scratch);
    } else if (how == POINTS_F32) {
        to->status = scarp_recipe_sample(&recipe, POINTS, float_position[0], float_position[1],
                                         float_position[2], &outputs, &scratch);
    } else {
        to->status = scarp_recipe_sample_f64(&recipe, POINTS, position[0], position[1], position[2],
                                             &outputs, how == ON_STACK ? NULL : &scratch);
    }
}

/* Whether a call writes an element of an array, as there is one of each order. */
static int is_written(enum how how, int order, int is_space, int array, int element)
{
    static const signed char order_of[ARRAYS] = {0, 1, 1, 1, 2, 2, 2, 2, 2, 2};
    static const char along_z[ARRAYS] = {0, 0, 0, 1, 0, 0, 0, 1, 1, 1};
    const int slices = is_space ? 3 : 1, slices_apart = is_space ? 2 : 1;
    if (order_of[array] > order || (along_z[array] && !is_space)) {
        return 0;
    }
    return how == GRID_TIGHT ? element < 20 * slices
           : how == GRID_STRIDES
               ? element / 28 < slices_apart && element % 28 / 7 < 3 && element % 7 < 5
               : 1;
}

static uint32_t bits_of(float number)
{
    uint32_t bits;
    memcpy(&bits, &number, sizeof bits);
    return bits;
}

/* Elements that a call writes are the same in both, NaN being NaN; others have what was there. */
static void check_same(const char *name, enum how how, int order, int is_space,
                       const struct result met[2])
{
    for (int a = 0; a < ARRAYS; a++) {
        for (int i = 0; i < POINTS; i++) {
            const float x = met[0].array[a][i], y = met[1].array[a][i];
            const int is_same = bits_of(x) == bits_of(y) || (x != x && y != y);
            if (is_written(how, order, is_space, a, i) ? !is_same : is_same) {
                CHECK(0, "%s, way %d, order %d, array %d, element %d: %.9g and %.9g", name,
                      (int)how, order, a, i, (double)x, (double)y);
                return;
            }
        }
    }
    CHECK(1, "%s", name);
}

static void check_nan(const char *name, enum how how, int order, int is_space,
                      const struct result *met)
{
    for (int a = 0; a < ARRAYS; a++) {
        for (int i = 0; i < POINTS; i++) {
            const float x = met->array[a][i];
            if (is_written(how, order, is_space, a, i) ? x == x : bits_of(x) != 0x42424242u) {
                CHECK(0, "%s, way %d, order %d, call %ld fails: array %d, element %d is %.9g", name,
                      (int)how, order, failing, a, i, (double)x);
                return;
            }
        }
    }
    CHECK(1, "%s", name);
}

/* What recipes write and promise with each of the calls failing that they make. */
static void check_samples(const char *name, enum how how, int order, int is_space)
{
    static struct result met[2], spoilt;
    failing = calls = 0;
    sample(how, order, is_space, 0x42, &met[0]);
    const long all = calls;
    sample(how, order, is_space, 0xff, &met[1]);
    CHECK(met[0].status == met[1].status, "%s: %d and %d", name, (int)met[0].status,
          (int)met[1].status);
    if (met[0].status != SCARP_OK) {
        CHECK(how == ON_STACK && met[0].status == SCARP_ERROR_SIZE, "%s: %s", name,
              scarp_status_text(met[0].status));
        return;
    }
    check_same(name, how, order, is_space, met);
    for (long i = 1; i <= all; i++) {
        failing = i;
        calls = 0;
        sample(how, order, is_space, 0x42, &spoilt);
        CHECK(spoilt.status != SCARP_OK, "%s, way %d, order %d: call %ld of %ld fails unnoticed",
              name, (int)how, order, i, all);
        check_nan(name, how, order, is_space, &spoilt);
    }
    failing = 0;
}

static void check_uniforms(const char *name)
{
    static uint8_t bytes[2][UNIFORMS];
    size_t size[2] = {1, 1};
    failing = calls = 0;
    memset(bytes[0], 0x42, UNIFORMS);
    memset(bytes[1], 0xff, UNIFORMS);
    const enum scarp_status status = scarp_recipe_uniforms(&recipe, bytes[0], UNIFORMS, &size[0]);
    const long all = calls;
    CHECK(status == SCARP_OK &&
              scarp_recipe_uniforms(&recipe, bytes[1], UNIFORMS, &size[1]) == SCARP_OK &&
              size[0] == size[1] && memcmp(bytes[0], bytes[1], size[0]) == 0,
          "%s: uniforms", name);
    for (long i = 1; i <= all / 2; i++) { /* the second half fills in what the first has counted */
        failing = i;
        calls = 0;
        memset(bytes[0], 0x42, UNIFORMS);
        size[0] = 77;
        CHECK(scarp_recipe_uniforms(&recipe, bytes[0], UNIFORMS, &size[0]) != SCARP_OK,
              "%s: call %ld of %ld fails unnoticed by uniforms", name, i, all);
        int touched = size[0] != 77;
        for (size_t k = 0; k < UNIFORMS; k++) {
            touched |= bytes[0][k] != 0x42;
        }
        CHECK(!touched, "%s: call %ld of %ld fails, and uniforms are written", name, i, all);
    }
    failing = 0;
}

static void check_answers(const char *name, int order)
{
    static uint32_t answer[2][SCARP_GPU_ANSWERS];
    failing = calls = 0;
    memset(answer[1], 0x42, sizeof answer[1]);
    const enum scarp_status status = scarp_recipe_answers(&recipe, order, answer[0]);
    const long all = calls;
    if (status != SCARP_OK) { /* it needs more scratch memory than the stack has */
        CHECK(status == SCARP_ERROR_SIZE, "%s: %s", name, scarp_status_text(status));
        return;
    }
    CHECK(scarp_recipe_answers(&recipe, order, answer[1]) == SCARP_OK &&
              memcmp(answer[0], answer[1], sizeof answer[0]) == 0,
          "%s: answers", name);
    const long some[] = {1, 2, 3, 5, all / 7, all / 3, all / 2};
    for (size_t i = 0; i < sizeof some / sizeof some[0]; i++) {
        failing = some[i];
        calls = 0;
        memset(answer[1], 0x42, sizeof answer[1]);
        if (failing < 1 || failing > all / 2) {
            continue;
        }
        CHECK(scarp_recipe_answers(&recipe, order, answer[1]) != SCARP_OK,
              "%s: call %ld of %ld fails unnoticed by answers", name, failing, all);
        int touched = 0;
        for (size_t k = 0; k < SCARP_GPU_ANSWERS; k++) {
            touched |= answer[1][k] != 0x42424242u;
        }
        CHECK(!touched, "%s: call %ld of %ld fails, and answers are written", name, failing, all);
    }
    failing = 0;
}

/* A text that is read while a call fails has an error, or no narrower interval. */
static void check_parse(const char *name, const char *text)
{
    static struct scarp_recipe other;
    float promised[2] = {0.0f, 0.0f}, met[2] = {0.0f, 0.0f};
    failing = calls = 0;
    CHECK(scarp_recipe_parse(text, strlen(text), &recipe, NULL, 0, NULL) == SCARP_OK, "%s", name);
    const long all = calls;
    (void)!scarp_recipe_range(&recipe, SCARP_RECIPE_OUTPUT, NULL, &promised[0], &promised[1]);
    for (long i = 1; i <= all; i++) {
        failing = i;
        calls = 0;
        if (scarp_recipe_parse(text, strlen(text), &other, NULL, 0, NULL) == SCARP_OK) {
            (void)!scarp_recipe_range(&other, SCARP_RECIPE_OUTPUT, NULL, &met[0], &met[1]);
            CHECK((met[0] <= promised[0] || met[0] - promised[0] <= 1e-5f * fabsf(met[0])) &&
                      met[1] >= promised[1],
                  "%s: call %ld of %ld fails, and [%g, %g] becomes [%g, %g]", name, i, all,
                  (double)promised[0], (double)promised[1], (double)met[0], (double)met[1]);
        }
    }
    failing = 0;
}

int main(void)
{
    set_positions();
    for (size_t t = 0; t < RECIPE_TEXTS; t++) {
        const char *const name = recipe_texts[t].name, *const text = recipe_texts[t].text;
        const int is_space = strstr(text, "space 3") != NULL;
        check_parse(name, text);
        const int most = recipe_order(&recipe);
        for (int how = 0; how < HOWS; how++) {
            for (int order = how == ON_STACK ? most : 0; order <= most; order++) {
                check_samples(name, (enum how)how, order, is_space);
            }
        }
        check_uniforms(name);
        check_answers(name, most);
    }
    return check_done();
}
