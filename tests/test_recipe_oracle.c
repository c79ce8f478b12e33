/* SPDX-License-Identifier: MIT
 *
 * Usage: test_recipe_oracle COUNT [FIRST]
 *
 * Compares recipes with an interpreter in double (oracle_recipe.c): each function, and COUNT random
 * recipes from number FIRST on, with values, gradients and Hessians. Values must also lie in the
 * range that is promised.
 *
 * Errors are in units of the largest magnitude of an output over all points of a recipe. Where a
 * crease or a jump is nearer than rounding, derivatives differ wholly, so a few points may.
 */
#include "oracle_recipe.h"
#include "recipes.h"

#define POINTS 48
#define ARRAYS 10

static struct scarp_recipe recipe;
static double position[3][POINTS];
static float array[ARRAYS][POINTS];
static uint64_t memory[1 << 16];
static int too_large; /* recipes that pass a limit */

static void set_positions(uint64_t seed)
{
    struct recipe_writer w = {.state = seed};
    for (int i = 0; i < POINTS; i++) {
        for (int a = 0; a < 3; a++) {
            position[a][i] = (double)recipe_draw(&w, 1u << 20) / 65536.0 - 8.0;
        }
    }
}

static void sample(int order, int is_space)
{
    const struct scarp_samples s = recipe_samples(array[0], POINTS, order, is_space);
    const struct scarp_recipe_outputs outputs = {.out = &s, .count = 1};
    const struct scarp_scratch scratch = {.memory = memory, .size = sizeof memory};
    const enum scarp_status status = scarp_recipe_sample_f64(
        &recipe, POINTS, position[0], position[1], position[2], &outputs, &scratch);
    CHECK(status == SCARP_OK, "%s", scarp_status_text(status));
}

static double of_jet(const struct oracle_jet *j, int a)
{
    static const int second[6][2] = {{0, 0}, {0, 1}, {1, 1}, {0, 2}, {1, 2}, {2, 2}};
    return a == 0  ? j->value
           : a < 4 ? j->first[a - 1]
                   : j->second[second[a - 4][0]][second[a - 4][1]];
}

static int is_asked(int a, int order, int is_space)
{
    const int is_z = a == 3 || a >= 7;
    return (a == 0 || (a < 4 ? order > 0 : order > 1)) && (is_space || !is_z);
}

/* The largest error of the arrays of an order, but for the `off` largest points. */
static double error_of(int order, int is_space, const struct oracle_jet jets[POINTS], int off)
{
    static const int first[4] = {0, 1, 4, ARRAYS};
    double error[POINTS] = {0.0}, scale = 0x1p-20;
    for (int a = first[order]; a < first[order + 1]; a++) {
        for (int i = 0; i < POINTS && is_asked(a, order, is_space); i++) {
            const double exact = of_jet(&jets[i], a);
            scale = larger(scale, fabs(exact));
            error[i] = larger(error[i], fabs(exact - (double)array[a][i]));
        }
    }
    for (int k = 0; k <= off; k++) { /* the largest to the end */
        for (int i = 1; i < POINTS - k; i++) {
            if (error[i - 1] > error[i] || error[i - 1] != error[i - 1]) {
                const double swap = error[i];
                error[i] = error[i - 1];
                error[i - 1] = swap;
            }
        }
    }
    return error[POINTS - 1 - off] / scale;
}

static void check_range(const char *name)
{
    const struct scarp_box box = {.lowest = {-8.0, -8.0, -8.0}, .highest = {8.0, 8.0, 8.0}};
    float lowest, highest, tight[2];
    (void)scarp_recipe_range(&recipe, SCARP_RECIPE_OUTPUT, NULL, &lowest, &highest);
    (void)scarp_recipe_range(&recipe, SCARP_RECIPE_OUTPUT, &box, &tight[0], &tight[1]);
    CHECK(lowest <= tight[0] && tight[1] <= highest,
          "%s: [%g, %g] with a box is wider than [%g, %g]", name, (double)tight[0],
          (double)tight[1], (double)lowest, (double)highest);
    for (int i = 0; i < POINTS; i++) {
        CHECK(array[0][i] >= tight[0] && array[0][i] <= tight[1], "%s: %g is outside [%g, %g]",
              name, (double)array[0][i], (double)tight[0], (double)tight[1]);
    }
}

/* Looks for values outside of the range that is promised everywhere: from all points uphill, then
   downhill, along the gradient. */
static void search_range(const char *name, int is_space)
{
    const float *const slopes[3] = {array[1], array[2], array[3]};
    float lowest, highest;
    (void)scarp_recipe_range(&recipe, SCARP_RECIPE_OUTPUT, NULL, &lowest, &highest);
    for (int step = 0; step < 60; step++) {
        const double length = (step < 30 ? 0.25 : -0.25) / (double)(1 + step % 30 / 3);
        sample(1, is_space);
        for (int i = 0; i < POINTS; i++) {
            CHECK(array[0][i] >= lowest && array[0][i] <= highest, "%s: %g is outside [%g, %g]",
                  name, (double)array[0][i], (double)lowest, (double)highest);
            double square = 1e-30;
            for (int a = 0; a < 2 + is_space; a++) {
                square += (double)slopes[a][i] * (double)slopes[a][i];
            }
            for (int a = 0; a < 2 + is_space; a++) {
                position[a][i] += length * (double)slopes[a][i] / sqrt(square);
            }
        }
    }
}

/* `off` points may be wrong; the rest is within the tolerance of its order. */
static void check_text(const char *name, const char *text, int off, const double tolerance[3])
{
    struct oracle_jet jets[POINTS];
    const uint64_t seed = fnv_text(name);
    const int is_space = strstr(text, "space 3") != NULL;
    const enum scarp_status status = scarp_recipe_parse(text, strlen(text), &recipe, NULL, 0, NULL);
    if (status == SCARP_ERROR_SIZE && off > 1) { /* random recipes may pass a limit */
        too_large++;
        return;
    }
    CHECK(status == SCARP_OK, "%s: %s\n%s", name, scarp_status_text(status), text);
    if (status != SCARP_OK) {
        return;
    }
    (void)scarp_recipe_seed(&recipe, seed);
    const int order = recipe_order(&recipe);
    struct oracle_recipe *const oracle = oracle_recipe_make(text, &recipe, seed);
    set_positions(seed);
    sample(order, is_space);
    for (int i = 0; i < POINTS; i++) {
        const double x[3] = {position[0][i], position[1][i], position[2][i]};
        jets[i] = oracle_recipe_at(oracle, x);
    }
    oracle_recipe_free(oracle);
    for (int o = 0; o <= order; o++) {
        const double error = error_of(o, is_space, jets, off);
        CHECK(error <= tolerance[o], "%s: error %.3g, order %d, and %.0g is allowed\n%s", name,
              error, o, tolerance[o], text);
        if (getenv("SCARP_TEST_VERBOSE") != NULL) {
            printf("%s, order %d: %.2g\n", name, o, error);
        }
    }
    check_range(name);
    if (order > 0 && off <= 1) {
        search_range(name, is_space);
    }
}

int main(int argc, char **argv)
{
    if (argc < 2 || argc > 3) {
        fprintf(stderr, "usage: test_recipe_oracle COUNT [FIRST]\n");
        return EXIT_FAILURE;
    }
    const int count = atoi(argv[1]), first = argc == 3 ? atoi(argv[2]) : 0;
    static const double one[3] = {3e-6, 2e-5, 3e-4}, several[3] = {2e-4, 2e-3, 1e-2};
    for (size_t i = 0; i < RECIPE_TEXTS; i++) {
        check_text(recipe_texts[i].name, recipe_texts[i].text, recipe_texts[i].is_rough ? 1 : 0,
                   one);
    }
    for (int i = first; i < first + count; i++) {
        static struct recipe_writer w;
        char name[32];
        recipe_write(&w, (uint64_t)i, i % 2);
        snprintf(name, sizeof name, "random %d", i);
        check_text(name, w.text, i % 2 == 0 ? 5 : 2, several);
    }
    CHECK(too_large <= count / 100, "%d of %d recipes are too large", too_large, count);
    return check_done();
}
