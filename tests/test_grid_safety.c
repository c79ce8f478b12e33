/* SPDX-License-Identifier: MIT
 *
 * Grids write their rows and not a byte beyond (between guard pages), and the caller's
 * floating-point mode neither changes them nor is changed. Usage: test_grid_safety ISA.
 */
#include "guarded.h"

#include "check.h"
#include "fpmode_set.h"
#include "outputs.h"

#define ROWS 3
#define ARRAYS 4 /* value, dx, dy, dz: the first outputs */
#define LONGEST 1100
#define NOISES 9

static const struct scarp_noise noises[NOISES] = {
    {.octaves = 3.0f},                           /* octaves are added up in the caller's arrays */
    {.octaves = 2.0f, .frequency = 16.0},        /* several cells per sample */
    {.octaves = 3.0f, .rotate = 1},              /* parts go through the scratch space */
    {.octaves = 3.0f, .fractal = SCARP_EROSION}, /* likewise, with a state */
    {.octaves = 2.0f, .basis = SCARP_VALUE, .rotate = 1}, /* value noise */
    {.octaves = 2.0f, .basis = SCARP_SIMPLEX},
    {.basis = SCARP_SIMPLEX, .rotate = 1, .frequency = 2.0},
    {.basis = SCARP_CELL_EDGE, .jitter = 0.9f},
    {.octaves = 2.0f, .basis = SCARP_CELL_SOFT, .period = {3, 0, 0}},
};

static struct scarp_samples first_outputs(float *const *arrays, int dimensions)
{
    struct outputs o = {.capacity = 0};
    memcpy(o.array, arrays, ARRAYS * sizeof *arrays);
    return outputs_subset(&o, outputs_up_to(1, dimensions));
}

static struct scarp_grid grid_of(size_t width)
{
    const struct scarp_grid g = {.origin = {3.3371, 4.437, -5.533},
                                 .step = {0.11, 0.07, 0.3},
                                 .first = {-20, 7, 0},
                                 .count = {width, ROWS, 1}};
    return g;
}

static void run(const struct scarp_noise *noise, size_t width, float *const *arrays, int dimensions)
{
    const struct scarp_grid g = grid_of(width);
    const struct scarp_samples out = first_outputs(arrays, dimensions);
    const enum scarp_status status = grid_call(dimensions, noise, &g, &out);
    CHECK(status == SCARP_OK, "%s", scarp_status_text(status));
}

static float *reference[ARRAYS], *again[ARRAYS];

static int all_equal(float *const *arrays, size_t count, int dimensions)
{
    int equal = 1;
    for (int a = 0; a < (dimensions == 2 ? 3 : ARRAYS); a++) {
        equal &= memcmp(arrays[a], reference[a], count * sizeof(float)) == 0;
    }
    return equal;
}

#if GUARDED_EXISTS
/* Puts the grid at the end of the memory, where writing beyond the last row ends the program, and
   at its start. */
static void test_guarded(void)
{
    struct guarded memory[ARRAYS];
    for (int a = 0; a < ARRAYS; a++) {
        memory[a] = guarded_make(LONGEST * ROWS * sizeof(float));
    }
    for (size_t width = 1; width <= LONGEST; width += width < 70 ? 1 : width < 600 ? 61 : 97) {
        const size_t bytes = width * ROWS * sizeof(float);
        for (int n = 0; n < NOISES * 2; n++) {
            const struct scarp_noise *const noise = &noises[n / 2];
            const int dimensions = 2 + n % 2;
            run(noise, width, reference, dimensions);
            for (int end = 0; end < 2; end++) {
                float *arrays[ARRAYS];
                for (int a = 0; a < ARRAYS; a++) {
                    unsigned char *const start = memory[a].start;
                    memset(start, POISON, memory[a].size);
                    arrays[a] = (float *)(void *)(end ? start + memory[a].size - bytes : start);
                }
                run(noise, width, arrays, dimensions);
                CHECK(all_equal(arrays, width * ROWS, dimensions), "%dD, noise %d, %zu wide",
                      dimensions, n / 2, width);
                for (int a = 0; a < ARRAYS; a++) {
                    unsigned char *const rest = memory[a].start + (end ? 0 : bytes);
                    CHECK(all_poison(rest, memory[a].size - bytes), "written beyond, %zu wide",
                          width);
                }
            }
        }
    }
}
#else
static void test_guarded(void)
{
    printf("no guard pages here\n");
}
#endif

static void test_modes(void)
{
    int tried = 0;
    for (size_t m = 0; m < sizeof modes_all / sizeof modes_all[0]; m++) {
        if (!mode_works(&modes_all[m])) {
            continue;
        }
        tried++;
        for (int n = 0; n < NOISES * 2; n++) {
            run(&noises[n / 2], 300, reference, 2 + n % 2);
            const struct mode_control before = mode_enter(&modes_all[m]);
            run(&noises[n / 2], 300, again, 2 + n % 2);
            const struct mode_control after = mode_leave(before);
            CHECK(mode_is(&modes_all[m], &after), "%s: the mode was changed", modes_all[m].name);
            CHECK(all_equal(again, (size_t)300 * ROWS, 2 + n % 2), "%s: noise %d differs",
                  modes_all[m].name, n / 2);
        }
    }
    CHECK(tried > 0, "no mode can be set");
}

/* A call that is asked for nothing makes its checks, and does not visit the samples, which may be
   as many as an array could have. */
static void test_nothing(void)
{
    static const char text[] = "recipe 1\na = noise()", space[] = "recipe 1\nspace 3\na = noise()";
    static struct scarp_recipe plane, cube;
    const size_t most = (size_t)1 << (sizeof(size_t) * 4 - 2);
    const struct scarp_grid grid = {.count = {most, most, 1}},
                            bad = {.step = {(double)INFINITY}, .count = {most, most, 1}};
    const struct scarp_samples nothing = {0}, base = {.value = reference[0],
                                                      .dx = reference[0],
                                                      .dy = reference[0]};
    const struct scarp_noise noise = {.octaves = 2.0f}, wrong = {.octaves = 33.0f};
    const struct scarp_gullies gullies = {0};
    const struct scarp_eroded none = {0};
    const struct scarp_recipe_outputs outputs = {.out = &nothing, .count = 1};
    CHECK(scarp_grid2(&noise, &grid, &nothing) == SCARP_OK, "grid2");
    CHECK(scarp_grid3(&noise, &grid, &nothing) == SCARP_OK, "grid3");
    CHECK(scarp_grid2(&wrong, &grid, &nothing) == SCARP_ERROR_PARAMETER, "the noise");
    CHECK(scarp_grid2(&noise, &bad, &nothing) == SCARP_ERROR_PARAMETER, "the grid");
    CHECK(scarp_gullies_grid2(&gullies, &grid, &base, &none) == SCARP_OK, "gullies");
    CHECK(scarp_gullies_grid2(&gullies, &grid, &nothing, &none) == SCARP_ERROR_NULL, "the base");
    (void)scarp_recipe_parse(text, sizeof text - 1, &plane, NULL, 0, NULL);
    (void)scarp_recipe_parse(space, sizeof space - 1, &cube, NULL, 0, NULL);
    CHECK(scarp_recipe_grid(&plane, &grid, &outputs, NULL) == SCARP_OK, "a recipe");
    CHECK(scarp_recipe_grid(&cube, &grid, &outputs, NULL) == SCARP_OK, "a recipe of space");
    const int32_t which = 7;
    const struct scarp_recipe_outputs missing = {.out = &nothing, .which = &which, .count = 1};
    CHECK(scarp_recipe_grid(&plane, &grid, &missing, NULL) == SCARP_ERROR_PARAMETER, "no output 7");
}

int main(int argc, char **argv)
{
    check_select_isa(argc > 1 ? argv[1] : "scalar");
    for (int a = 0; a < ARRAYS; a++) {
        reference[a] = check_allocate(LONGEST * ROWS * sizeof(float));
        again[a] = check_allocate(LONGEST * ROWS * sizeof(float));
    }
    test_guarded();
    test_modes();
    test_nothing();
    for (int a = 0; a < ARRAYS; a++) {
        free(reference[a]);
        free(again[a]);
    }
    return check_done();
}
