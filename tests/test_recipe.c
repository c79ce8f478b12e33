/* SPDX-License-Identifier: MIT
 *
 * Usage: test_recipe
 *
 * Recipes as a language, and the calls around them: numbers, errors and their spans, parameters,
 * seeds, tiles, levels of detail, ranges, what editors are told, outputs by number, and the same
 * calls by hand.
 */
#include <limits.h>

#include "recipes.h"

#define POINTS 64

static struct scarp_recipe recipe, other;
static struct scarp_recipe_error errors[8];
static double x[POINTS], y[POINTS], z[POINTS];
static float value[POINTS], by_hand[POINTS], dx[POINTS], dy[POINTS];
static uint64_t memory[1 << 14];
static const struct scarp_scratch scratch = {.memory = memory, .size = sizeof memory};

static size_t parse(const char *text)
{
    size_t found = 0;
    memset(errors, 0, sizeof errors);
    (void)scarp_recipe_parse(text, strlen(text), &recipe, errors, 8, &found);
    return found;
}

static int parses(const char *text)
{
    const size_t found = parse(text);
    CHECK(found == 0, "%d:%d: %s in\n%s", (int)errors[0].line, (int)errors[0].column,
          errors[0].text, text);
    return found == 0;
}

static enum scarp_status sample(const struct scarp_recipe *of, const struct scarp_samples *out,
                                const int32_t *which)
{
    const struct scarp_recipe_outputs outputs = {.out = out, .count = 1, .which = which};
    return scarp_recipe_sample_f64(of, POINTS, x, y, z, &outputs, &scratch);
}

static void set_positions(void)
{
    for (int i = 0; i < POINTS; i++) {
        x[i] = 0.37 * (double)(i % 8) - 1.0;
        y[i] = 0.41 * (double)(i / 8) + 0.25;
        z[i] = 0.1 * (double)i;
    }
}

/* Values of a text at the points; the text must be right. */
static const float *values(const char *text)
{
    const struct scarp_samples out = {.value = value};
    if (parses(text)) {
        const enum scarp_status status = sample(&recipe, &out, NULL);
        CHECK(status == SCARP_OK, "%s: %s", text, scarp_status_text(status));
    }
    return value;
}

static void check_same_values(const char *text, const char *as)
{
    float kept[POINTS];
    memcpy(kept, values(text), sizeof kept);
    (void)values(as);
    CHECK(memcmp(kept, value, sizeof kept) == 0, "differ: %s and %s, %g and %g", text, as,
          (double)kept[0], (double)value[0]);
}

static void check_different_values(const char *text, const char *as)
{
    float kept[POINTS];
    memcpy(kept, values(text), sizeof kept);
    (void)values(as);
    CHECK(memcmp(kept, value, sizeof kept) != 0, "are the same: %s and %s", text, as);
}

/* Numbers are what strtod makes of them, in the locale of C. */
static void check_number(const char *text)
{
    char recipe_text[128];
    struct scarp_recipe_entry entry;
    snprintf(recipe_text, sizeof recipe_text, "recipe 1\na = %s\nb = noise()", text);
    if (parses(recipe_text)) {
        (void)scarp_recipe_entry_at(&recipe, 0, &entry);
        CHECK(entry.value == strtod(text, NULL), "%s is %.17g", text, entry.value);
    }
}

static void check_numbers(void)
{
    static const char *const texts[] = {"0",
                                        "1",
                                        "0.1",
                                        "5.",
                                        ".5",
                                        "1e3",
                                        "1E-3",
                                        "2.5e+2",
                                        "123456789012345678",
                                        "0.30000000000000004",
                                        "9007199254740993",
                                        "9007199254740992.5",
                                        "1e60",
                                        "1e-60",
                                        "1.0000000000000002",
                                        "1.00000000000000011102230246251565",
                                        "8.41e21",
                                        "9.5367431640625e-07",
                                        "0.000001",
                                        "179769313486231570814527423731704356",
                                        "3.14159265358979323846264338327950288",
                                        "4.35e-59",
                                        "5e-324e0",
                                        "7.2057594037927933e16",
                                        "6929495644600919.5",
                                        "3.7455744005952583e15"};
    for (size_t i = 0; i < sizeof texts / sizeof texts[0]; i++) {
        if (strcmp(texts[i], "5e-324e0") != 0) {
            check_number(texts[i]);
        }
    }
    struct recipe_writer w = {.state = 99};
    for (int i = 0; i < 3000; i++) {
        char text[64];
        size_t length = 0;
        const uint32_t digits = 1 + recipe_draw(&w, 30), point = recipe_draw(&w, digits + 1);
        for (uint32_t k = 0; k < digits; k++) {
            if (k == point) {
                text[length++] = '.';
            }
            text[length++] = (char)('0' + recipe_draw(&w, 10));
        }
        snprintf(text + length, sizeof text - length, "e%d", (int)recipe_draw(&w, 50) - 25);
        check_number(text);
    }
}

/* An error of a text: where it is, and what it says. */
static void check_error(const char *text, int line, int column, const char *says)
{
    const size_t found = parse(text);
    CHECK(found >= 1 && errors[0].line == line && errors[0].column == column &&
              errors[0].text != NULL && strstr(errors[0].text, says) != NULL,
          "%zu errors, %d:%d: %s, not %d:%d: %s, in\n%s", found, (int)errors[0].line,
          (int)errors[0].column, errors[0].text != NULL ? errors[0].text : "", line, column, says,
          text);
    for (size_t i = 0; i < sizeof errors / sizeof errors[0] && i < found; i++) {
        CHECK(errors[i].from <= errors[i].to && errors[i].to <= strlen(text),
              "a span of %zu to %zu", errors[i].from, errors[i].to);
        CHECK(errors[i].spare[0] == 0 && errors[i].spare[5] == 0, "a spare member is written");
    }
}

#define ONE "recipe 1\nn = noise()\n"

static void check_errors(void)
{
    static const struct {
        const char *text;
        int line, column;
        const char *says;
    } cases[] = {
        {"", 1, 1, "needs a name"},
        {"a = noise()", 1, 1, "begins with its version"},
        {"recipe 2\na = noise()", 1, 8, "version 1"},
        {"recipe 1\nparam k = 2\n", 3, 1, "needs a name"},
        {ONE "a = n +", 3, 8, "expected a number"},
        {ONE "a = (n", 3, 7, "expected )"},
        {"recipe 1\na = (x", 2, 7, "expected )"},
        {ONE "a = clamp(n, 1=2, 3)", 3, 15, "expected , or )"},
        {ONE "a = min(n n)", 3, 11, "expected , or )"},
        {ONE "a = n n", 3, 7, "expected an operator"},
        {ONE "a n", 3, 3, "expected ="},
        {ONE "a = n^5", 3, 7, "exponents"},
        {ONE "a = 1.2.3 * n", 3, 8, "goes on"},
        {ONE "a = 1e99 * n", 3, 5, "expected a number"},
        {ONE "a = b + n", 3, 5, "no such name"},
        {ONE "a = b + n\nb = n", 3, 5, "above"},
        {ONE "a = a", 3, 5, "above"},
        {ONE "n = 2 * n", 3, 1, "given above"},
        {ONE "min = n", 3, 1, "name of a function"},
        {ONE "x = n", 3, 1, "meaning of its own"},
        {ONE "a = what(n)", 3, 5, "no such function"},
        {ONE "a = abs()", 3, 5, "missing"},
        {ONE "a = abs(n, n)", 3, 12, "too many"},
        {ONE "a = clamp(n, lo=1, lo=2)", 3, 23, "twice"},
        {ONE "a = clamp(n, lo=1, ho=2)", 3, 23, "no argument of that name"},
        {ONE "a = clamp(n, 1, 0)", 3, 5, "outside the interval"},
        {ONE "a = clamp(n, n, 1)", 3, 14, "expected a number"},
        {ONE "a = smoothstep(n, 1, 1)", 3, 5, "outside the interval"},
        {ONE "a = terrace(n, 0)", 3, 5, "outside the interval"},
        {ONE "a = min(n, 1, smooth=-1)", 3, 5, "outside the interval"},
        {ONE "a = mix(n, 1, n)", 3, 5, "mask of mix"},
        {ONE "a = 1 / n", 3, 5, "divisor can be 0"},
        {"recipe 1\na = 1 / curve(0.9998392 + 1.44e-06 * noise(), 0: 1000, 1: 0)", 2, 5,
         "divisor can be 0"},
        {ONE "a = n / 0", 3, 5, "division by 0"},
        {ONE "a = 1 / 0 + n", 3, 5, "division by 0"},
        {ONE "a = curve(n, 0: 1)", 3, 5, "from 2 to 64"},
        {ONE "a = curve(n, 0: 1, 0: 2)", 3, 20, "in order"},
        {ONE "a = curve(n, 0: 1, n)", 3, 20, "expected x: value"},
        {ONE "a = blend(n, 0: 1)", 3, 5, "at least 2"},
        {ONE "a = n + 1: 2", 3, 10, "expected an operator"},
        {ONE "a = abs(1: 2)", 3, 9, "curve() and blend() alone"},
        {ONE "a = warp(n, x)", 3, 13, "expected a noise"},
        {ONE "a = warp(n, 2 * n)", 3, 13, "expected a noise"},
        {ONE "a = cell(x)", 3, 10, "expected a noise"},
        {ONE "a = cell(n, f3)", 3, 13, "no such word"},
        {"recipe 1\ntile 64, 64\nout o = cell(noise(simplex, size=8), f1)", 3, 9, "simplex noise"},
        {"recipe 1\nspace 3\ntile 64, 64, 64\nout o = flat(cell(noise(simplex, size=8)))", 4, 14,
         "simplex noise"},
        {"recipe 1\nspace 3\nout o = z * flat(cell(noise(simplex, period_y=4), f2))", 3, 18,
         "simplex noise"},
        {ONE "a = noise(perlin)", 3, 11, "no such word"},
        {ONE "a = noise(octaves=40)", 3, 19, "outside (0, 32]"},
        {ONE "a = noise(octaves=0)", 3, 19, "must not be 0"},
        {ONE "a = noise(size=0)", 3, 16, "a frequency is from"},
        {ONE "a = noise(size=2, frequency=2)", 3, 29, "say the same"},
        {ONE "a = noise(seed=0.5)", 3, 16, "whole number"},
        {ONE "a = noise(seed=-0.5)", 3, 16, "magnitude below 2^53"},
        {ONE "a = noise(seed=-9007199254740993)", 3, 16, "magnitude below 2^53"},
        {ONE "a = noise(period=0.5)", 3, 18, "whole number"},
        {ONE "a = noise(gradient, value)", 3, 21, "twice"},
        {ONE "a = noise(frequency=x)", 3, 21, "expected a number"},
        {ONE "a = scale(n, 0)", 3, 5, "is 0"},
        {ONE "a = turn(n, 30, x)", 3, 5, "around z"},
        {ONE "a = at(n, x)", 3, 5, "missing"},
        {ONE "a = at(n, x, y, x)", 3, 5, "for each axis"},
        {ONE "a = z + n", 3, 5, "no z"},
        {ONE "a = flat(n)", 3, 5, "stands in space"},
        {"recipe 1\nspace 4\na = noise()", 2, 7, "2 or 3"},
        {"recipe 1\na = noise()\nspace 3", 3, 7, "before all"},
        {"recipe 1\nspace 3\na = gullies(noise())", 3, 5, "of the plane"},
        {"recipe 1\nspace 3\na = flat(z)", 3, 10, "no z"},
        {ONE "a = gullies(noise(erosion, octaves=2))", 3, 13, "second derivatives"},
        {ONE "a = gullies(slope(n))", 3, 13, "second derivatives"},
        {ONE "a = gullies(n, depth=-1)", 3, 22, "outside [2^-24, 2^10]"},
        {ONE "a = slope(slope(slope(n)))", 3, 5, "no gradient"},
        {"recipe 1\ntile 4, 0\na = noise()", 2, 6, "above 0"},
        {"recipe 1\ntile 4\na = noise()", 2, 7, "length for each axis"},
        {"recipe 1\ntile 4, 4\na = noise(size=3)", 3, 5, "not a whole number of cells"},
        {"recipe 1\ntile 4, 4\na = turn(noise(), 30)", 3, 10, "turned does not repeat"},
        {"recipe 1\ntile 4, 4\na = x * noise()", 3, 5, "does not repeat"},
        {"recipe 1\ntile 4, 4\na = noise(rotate, octaves=2)", 3, 5, "turned axes cannot repeat"},
        {"recipe 1\nparam k = 3 [0, 2]\na = k * noise()", 2, 11, "outside its interval"},
        {"recipe 1\nparam k = 3 [0, 2\na = k * noise()", 2, 18, "expected [lowest, highest]"},
        {"recipe 1\na = noise()\n\x01", 3, 1, "expected a name"},
        {ONE "a = ((((((((((((((((((((((((n))))))))))))))))))))))))", 3, 29, "more than 24"},
    };
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        check_error(cases[i].text, cases[i].line, cases[i].column, cases[i].says);
    }
}

/* All errors of a text are found, in its order, and good statements may be sampled all the same. */
static void check_many_errors(void)
{
    const char *const text =
        "recipe 1\na = noise(\nb = noise()\nc = b +* 2\nd = abs(b)\ne = q\nf = e + a";
    const size_t found = parse(text);
    CHECK(found == 3, "%zu errors", found);
    CHECK(errors[0].line == 4 && errors[1].line == 4 && errors[2].line == 6, "lines %d %d %d",
          (int)errors[0].line, (int)errors[1].line, (int)errors[2].line);
    const struct scarp_samples out = {.value = value};
    const int32_t good[] = {3}, bad[] = {5};
    CHECK(sample(&recipe, &out, good) == SCARP_OK, "d has no error");
    memcpy(by_hand, value, sizeof by_hand);
    (void)values("recipe 1\nd = abs(noise())");
    CHECK(memcmp(by_hand, value, sizeof value) == 0, "d is another one");
    (void)parse(text);
    CHECK(sample(&recipe, &out, bad) == SCARP_ERROR_PARAMETER, "f has an error");
    CHECK(sample(&recipe, &out, NULL) == SCARP_ERROR_PARAMETER, "the recipe has an error");
    CHECK(scarp_recipe_set(&recipe, "k", 1.0, NULL) == SCARP_ERROR_PARAMETER, "set");
    CHECK(scarp_recipe_seed(&recipe, 1) == SCARP_ERROR_PARAMETER, "seed");
    CHECK(scarp_recipe_scratch_size(&recipe, 0, 16) == 0, "scratch_size");
    size_t all = 0;
    struct scarp_recipe_error first = {0};
    (void)scarp_recipe_parse(text, strlen(text), &recipe, &first, 1, &all);
    CHECK(all == 3 && first.line == 4, "with room for one, %zu, line %d", all, (int)first.line);
}

/* On an error of the call, nothing is written. */
static void check_calls(void)
{
    const float untouched = 7.0f;
    const struct scarp_samples out = {.value = value}, hessian = {.value = value, .dxx = dx},
                               deep = {.value = value, .dz = dx}, flow = {.dphase = value};
    struct scarp_samples spare = out;
    spare.spare[1] = dx;
    const int32_t none[] = {99}, part[] = {SCARP_RECIPE_PARTS + 600}, word[] = {-1};
    (void)parses("recipe 1\na = noise(swiss, octaves=2)");
    value[0] = untouched;
    CHECK(sample(&recipe, &hessian, NULL) == SCARP_ERROR_UNSUPPORTED, "no Hessian");
    CHECK(sample(&recipe, &deep, NULL) == SCARP_ERROR_UNSUPPORTED, "along z");
    CHECK(sample(&recipe, &flow, NULL) == SCARP_ERROR_UNSUPPORTED, "dphase");
    CHECK(sample(&recipe, &spare, NULL) == SCARP_ERROR_UNSUPPORTED, "spare");
    CHECK(sample(&recipe, &out, none) == SCARP_ERROR_PARAMETER, "no such statement");
    CHECK(sample(&recipe, &out, part) == SCARP_ERROR_PARAMETER, "no such part");
    CHECK(sample(&recipe, &out, word) == SCARP_ERROR_PARAMETER, "a negative number");
    struct scarp_recipe_outputs outputs = {.out = &out, .count = 2};
    CHECK(scarp_recipe_sample_f64(&recipe, POINTS, x, y, z, &outputs, &scratch) ==
              SCARP_ERROR_PARAMETER,
          "two outputs of one");
    outputs.count = 0;
    CHECK(scarp_recipe_sample_f64(&recipe, POINTS, x, y, z, &outputs, &scratch) ==
              SCARP_ERROR_PARAMETER,
          "no outputs");
    outputs.count = 1;
    outputs.spare[3] = 1;
    CHECK(scarp_recipe_sample_f64(&recipe, POINTS, x, y, z, &outputs, &scratch) ==
              SCARP_ERROR_UNSUPPORTED,
          "spare of outputs");
    outputs.spare[3] = 0;
    struct scarp_scratch small = {.memory = memory, .size = 100};
    CHECK(scarp_recipe_sample_f64(&recipe, POINTS, x, y, z, &outputs, &small) == SCARP_ERROR_SIZE,
          "little scratch memory");
    small.spare[0] = 1;
    CHECK(scarp_recipe_sample_f64(&recipe, POINTS, x, y, z, &outputs, &small) ==
              SCARP_ERROR_UNSUPPORTED,
          "spare of scratch");
    CHECK(scarp_recipe_sample_f64(&recipe, POINTS, x, NULL, z, &outputs, NULL) == SCARP_ERROR_NULL,
          "no y");
    CHECK(scarp_recipe_sample_f64(&recipe, POINTS, x, y, NULL, &outputs, NULL) == SCARP_OK,
          "no z, in the plane");
    value[0] = untouched;
    CHECK(scarp_recipe_sample_f64(NULL, POINTS, x, y, z, &outputs, NULL) == SCARP_ERROR_NULL,
          "no recipe");
    CHECK(scarp_recipe_sample_f64(NULL, 0, x, y, z, NULL, NULL) == SCARP_OK, "no points");
    CHECK(scarp_recipe_sample_f64(&recipe, SIZE_MAX / 4, x, y, z, &outputs, NULL) ==
              SCARP_ERROR_SIZE,
          "too many points");
    memset(&other, 0, sizeof other);
    CHECK(scarp_recipe_sample_f64(&other, POINTS, x, y, z, &outputs, NULL) == SCARP_ERROR_PARAMETER,
          "zeros are no recipe");
    struct scarp_grid grid = {.step = {1.0, 1.0}, .count = {8, 8}};
    CHECK(scarp_recipe_grid(&recipe, NULL, &outputs, NULL) == SCARP_ERROR_NULL, "no grid");
    grid.row_stride = 7;
    CHECK(scarp_recipe_grid(&recipe, &grid, &outputs, NULL) == SCARP_ERROR_PARAMETER, "stride");
    grid.row_stride = 0;
    grid.spare[0] = 1;
    CHECK(scarp_recipe_grid(&recipe, &grid, &outputs, NULL) == SCARP_ERROR_UNSUPPORTED, "spare");
    grid.spare[0] = 0;
    grid.count[1] = 0;
    CHECK(scarp_recipe_grid(&recipe, &grid, &outputs, NULL) == SCARP_OK, "an empty grid");
    CHECK(value[0] == untouched, "something was written: %g", (double)value[0]);
    static char long_text[16385];
    memset(long_text, '#', sizeof long_text);
    CHECK(scarp_recipe_parse(long_text, sizeof long_text, &recipe, NULL, 0, NULL) ==
              SCARP_ERROR_SIZE,
          "a text of 16,385 bytes");
    CHECK(scarp_recipe_parse(NULL, 1, &recipe, NULL, 0, NULL) == SCARP_ERROR_NULL, "no text");
    CHECK(scarp_recipe_parse("", 0, NULL, NULL, 0, NULL) == SCARP_ERROR_NULL, "no recipe");
}

/* The size of scratch memory, and what it is not told for */
static void check_scratch_size(void)
{
    static const struct scarp_recipe none;
    (void)parses("recipe 1\na = noise()");
    CHECK(scarp_recipe_scratch_size(&recipe, 2, 16) > scarp_recipe_scratch_size(&recipe, 0, 16) &&
              scarp_recipe_scratch_size(&recipe, 0, 16) > 0,
          "it grows with derivatives");
    CHECK(scarp_recipe_scratch_size(&recipe, -1, 16) == 0 &&
              scarp_recipe_scratch_size(&recipe, 3, 16) == 0,
          "orders that there are not");
    CHECK(scarp_recipe_scratch_size(NULL, 0, 16) == 0 &&
              scarp_recipe_scratch_size(&none, 0, 16) == 0,
          "no recipe");
    CHECK(scarp_recipe_scratch_size(&recipe, 0, SIZE_MAX / 65536 + 1) == 0, "too many points");
}

static void check_set(void)
{
    const struct scarp_samples out = {.value = value};
    (void)parses("recipe 1\nparam k = 2 [1, 4]\nparam lo = 0\na = k * clamp(noise(), lo, 0.5)");
    (void)sample(&recipe, &out, NULL);
    memcpy(by_hand, value, sizeof by_hand);
    CHECK(scarp_recipe_set(&recipe, "k", 4.0, errors) == SCARP_OK, "k = 4");
    (void)sample(&recipe, &out, NULL);
    for (int i = 0; i < POINTS; i++) {
        CHECK(value[i] == 2.0f * by_hand[i], "%g is not twice %g", (double)value[i],
              (double)by_hand[i]);
    }
    CHECK(scarp_recipe_set(&recipe, "k", 4.5, errors) == SCARP_ERROR_PARAMETER, "k = 4.5");
    CHECK(scarp_recipe_set(&recipe, "k", (double)NAN, errors) == SCARP_ERROR_PARAMETER, "k = NaN");
    CHECK(scarp_recipe_set(&recipe, "q", 1.0, errors) == SCARP_ERROR_PARAMETER, "q");
    CHECK(scarp_recipe_set(&recipe, NULL, 1.0, errors) == SCARP_ERROR_NULL, "NULL");
    CHECK(errors[0].text == NULL, "an error of the text that is none");
    CHECK(scarp_recipe_set(&recipe, "lo", 0.75, errors) == SCARP_ERROR_PARAMETER &&
              errors[0].line == 4 && errors[0].text != NULL,
          "lo above hi, line %d", (int)errors[0].line);
    memcpy(by_hand, value, sizeof by_hand);
    (void)sample(&recipe, &out, NULL);
    CHECK(memcmp(by_hand, value, sizeof value) == 0, "the old value went");
    struct scarp_recipe_entry entry;
    (void)scarp_recipe_entry_at(&recipe, 0, &entry);
    CHECK(entry.value == 4.0 && entry.slider[0] == 1.0 && entry.slider[1] == 4.0, "k is %g",
          entry.value);
    (void)parses("recipe 1\nparam k = -2.5 [-3, -1]\na = k * noise()");
    (void)scarp_recipe_entry_at(&recipe, 0, &entry);
    CHECK(entry.value == -2.5 && entry.slider[0] == -3.0 && entry.slider[1] == -1.0, "k is %g",
          entry.value);
}

/* Seeds of noises, of cells and of gullies are those that the page of the language has, so others
   can make the same calls. */
static void check_rebuilt_seeds(void)
{
    static const struct {
        const char *seed;
        uint64_t number;
    } cases[] = {
        {"1", 65},
        {"7", 71},
        {"9007199254740991", (UINT64_C(1) << 53) + 63},
        {"-1", UINT64_MAX},
        {"-64", 0 - UINT64_C(64)},
        {"-9007199254740991", 1 - (UINT64_C(1) << 53)},
    };
    const uint64_t worlds[] = {0, 8, UINT64_C(0xfedcba9876543210)};
    const struct scarp_samples out = {.value = value}, hand = {.value = by_hand};
    const struct scarp_samples base = {.value = value, .dx = dx, .dy = dy};
    const struct scarp_eroded eroded = {.displacement = by_hand};
    static uint32_t id[POINTS];
    const struct scarp_cells cells = {.id = id};
    for (size_t i = 0; i < 3 * sizeof cases / sizeof cases[0]; i++) {
        const uint64_t world = worlds[i % 3], number = cases[i / 3].number;
        const uint64_t seed = check_random_number(check_random_number(world, 1), number);
        const struct scarp_noise noise = {.offset_first = 1, .seed = seed, .octaves = 2.0f},
                                 level = {.offset_first = 1, .seed = world};
        const struct scarp_gullies gullies = {.offset_first = 1, .seed = seed};
        char text[128];
        snprintf(text, sizeof text,
                 "recipe 1\nn = noise(octaves=2, seed=%s)\ng = displacement(noise(), seed=%s)\n"
                 "c = cell(n)",
                 cases[i / 3].seed, cases[i / 3].seed);
        (void)parses(text);
        (void)scarp_recipe_seed(&recipe, world);
        (void)sample(&recipe, &out, &(const int32_t){0});
        (void)scarp_sample2_f64(&noise, POINTS, x, y, &hand);
        CHECK(memcmp(value, by_hand, sizeof value) == 0, "%s of world %d", cases[i / 3].seed,
              (int)(i % 3));
        (void)sample(&recipe, &out, &(const int32_t){2});
        (void)scarp_cells2_f64(&noise, POINTS, x, y, &cells);
        for (int k = 0; k < POINTS; k++) {
            CHECK(value[k] == (float)((double)(int32_t)id[k] * 0x1p-31), "cells of %s",
                  cases[i / 3].seed);
        }
        (void)scarp_sample2_f64(&level, POINTS, x, y, &base);
        (void)scarp_gullies2_f64(&gullies, POINTS, x, y, &base, &eroded);
        (void)sample(&recipe, &out, &(const int32_t){1});
        CHECK(memcmp(value, by_hand, sizeof value) == 0, "gullies of %s", cases[i / 3].seed);
    }
}

static void check_seeds(void)
{
    const struct scarp_samples out = {.value = value};
    check_same_values("recipe 1\na = noise(seed=0)", "recipe 1\na = noise()");
    check_different_values("recipe 1\na = noise(seed=1)", "recipe 1\na = noise()");
    check_different_values("recipe 1\na = noise(seed=1)", "recipe 1\na = noise(seed=2)");
    check_different_values("recipe 1\na = noise(seed=-1)", "recipe 1\na = noise(seed=1)");
    check_same_values("recipe 1\na = noise(seed=-0)", "recipe 1\na = noise()");
    check_rebuilt_seeds();
    (void)parses("recipe 1\na = noise()");
    (void)scarp_recipe_seed(&recipe, UINT64_C(0x123456789abcdef0));
    (void)sample(&recipe, &out, NULL);
    const struct scarp_noise noise = {.offset_first = 1, .seed = UINT64_C(0x123456789abcdef0)};
    const struct scarp_samples hand = {.value = by_hand};
    (void)scarp_sample2_f64(&noise, POINTS, x, y, &hand);
    CHECK(memcmp(value, by_hand, sizeof value) == 0, "the seed of the world");
}

static void check_language(void)
{
    check_same_values("recipe 1\na = noise(size=4)", "recipe 1\na = noise(frequency=0.25)");
    check_same_values("recipe 1\na = noise() - 2 - 1", "recipe 1\na = (noise() - 2) - 1");
    check_same_values("recipe 1\na = -noise()^2", "recipe 1\na = -(noise()^2)");
    check_same_values("recipe 1\na = --noise()", "recipe 1\na = noise()");
    check_same_values("recipe 1\na = noise(\n# a comment\nsize=2,\n\n octaves=3)",
                      "recipe 1\r\na = noise(size = 2, octaves = 3) # \xc3\xa4\r\n");
    check_same_values("recipe 1\nparam k = 3\nb = 2 * k\na = b * noise()",
                      "recipe 1\na = 6 * noise()");
    check_same_values("recipe 1\nout a = noise()\nb = 2 * a", "recipe 1\na = noise()");
    check_same_values(
        "recipe 1\na = min(2, 3) * noise() + max(1, 4) + abs(-2) + sqrt(4) + clamp(5, 0, 1)",
        "recipe 1\na = 2 * noise() + 4 + 2 + 2 + 1");
    check_same_values("recipe 1\na = terrace(a=noise(), strength=0.5, steps=4)",
                      "recipe 1\na = terrace(noise(), 4, 0.5, 0.5)");
    check_same_values("recipe 1\nw = noise()\na = warp(noise(seed=1), by=w)",
                      "recipe 1\na = warp(noise(seed=1), noise())");
    check_same_values("recipe 1\na = turn(noise(), 360)", "recipe 1\na = noise()");
    check_same_values("recipe 1\na = scale(noise(), 4)", "recipe 1\na = noise(size=4)");
    check_same_values("recipe 1\na = at(noise(), x, y)", "recipe 1\na = noise()");
    check_same_values("recipe 1\na = min(noise(), noise(seed=1), smooth=0)",
                      "recipe 1\na = min(noise(), noise(seed=1))");
    check_different_values("recipe 1\na = noise(simplex)", "recipe 1\na = noise(value)");
    check_different_values("recipe 1\na = noise(octaves=2, rotate)",
                           "recipe 1\na = noise(octaves=2)");
}

/* The same calls, made by hand */
static void check_by_hand(void)
{
    const struct scarp_noise warp = {.offset_first = 1, .frequency = 0.5, .amplitude = 0.3f},
                             noise = {.offset_first = 1, .octaves = 3.0f, .warp = &warp},
                             mask = {.offset_first = 1, .basis = SCARP_VALUE};
    static float a[3][POINTS], b[3][POINTS];
    const struct scarp_samples n = {.value = a[0], .dx = a[1], .dy = a[2]};
    const struct scarp_samples m = {.value = b[0], .dx = b[1], .dy = b[2]};
    const struct scarp_samples out = {.value = value, .dx = dx, .dy = dy};
    (void)parses("recipe 1\na = 3 * (warp(noise(octaves=3), noise(size=2, amplitude=0.3)) * "
                 "smoothstep(noise(value), -0.5, 0.5)) + 2");
    (void)sample(&recipe, &out, NULL);
    (void)scarp_sample2_f64(&noise, POINTS, x, y, &n);
    (void)scarp_sample2_f64(&mask, POINTS, x, y, &m);
    (void)scarp_smoothstep(POINTS, &m, -0.5f, 0.5f, &m);
    (void)scarp_multiply(POINTS, &n, &m, &n);
    (void)scarp_affine(POINTS, &n, 3.0f, 0.0f, &n);
    (void)scarp_affine(POINTS, &n, 1.0f, 2.0f, &n);
    CHECK(memcmp(value, a[0], sizeof value) == 0 && memcmp(dx, a[1], sizeof dx) == 0 &&
              memcmp(dy, a[2], sizeof dy) == 0,
          "the recipe differs from the same calls by hand: %g and %g", (double)value[0],
          (double)a[0][0]);
}

/* Two things of one kind in a text stay two. What a text has again is kept once, so that it comes
   under its limits. */
static void check_shared(void)
{
    static char many[16384];
    check_different_values(ONE "a = curve(n, -1: 0, 1: 1) + curve(n, -1: 0, 1: 1)",
                           ONE "a = curve(n, -1: 0, 1: 1) + curve(n, -1: 5, 1: 6)");
    check_different_values(ONE "a = displacement(n) + displacement(n)",
                           ONE "a = displacement(n) + displacement(n, seed=9)");
    check_different_values(ONE "a = turn(n, 30) + turn(n, 30)",
                           ONE "a = turn(n, 30) + turn(n, 40)");
    check_same_values(ONE "a = -n", ONE "a = 0 - n");
    (void)parses("recipe 1\nw = noise(amplitude=0.1)\n"
                 "a = warp(noise(seed=5), warp(w, warp(w, warp(w, warp(w, w)))))");
    static const struct {
        const char *statement; /* with its number, twice */
        int count;             /* more than the limit of what it has */
    } repeated[] = {
        {"a%d = displacement(x * %d + 3 * y)\n", 12},
        {"a%d = turn(x * %d, 30)\n", 40},
        {"a%d = x * %d * noise(seed=5)\n", 60},
        {"a%d = curve(x, 0: 1, 1: 2, 2: 3, 3: 5)\n", 33},
    };
    for (size_t k = 0; k < sizeof repeated / sizeof repeated[0]; k++) {
        size_t length = (size_t)snprintf(many, sizeof many, "recipe 1\n");
        for (int i = 1; i <= repeated[k].count; i++) {
            length += (size_t)snprintf(many + length, sizeof many - length, repeated[k].statement,
                                       i, i + 1);
        }
        (void)parses(many);
    }
}

/* Cells are those of the first octave, whichever octaves there are. */
static void check_cells(void)
{
    static const char *const of[] = {"octaves=0.5, of_octaves=0.75", "octaves=1, of_octaves=1",
                                     "octaves=3, of_octaves=3.5", "octaves=0.25"};
    static const char *const what[] = {"", ", f1", ", f2"};
    for (int i = 0; i < 4 * 3; i++) {
        char text[128], as[128];
        snprintf(text, sizeof text, "recipe 1\nout o = cell(noise(seed=3, %s)%s) * 2", of[i / 3],
                 what[i % 3]);
        snprintf(as, sizeof as, "recipe 1\nout o = cell(noise(seed=3)%s) * 2", what[i % 3]);
        check_same_values(text, as);
    }
}

/* flat() changes no coordinate of the plane, also inside of places in places. */
static void check_flat(void)
{
    check_same_values(SPACE "a = at(at(flat(x), x + m, y, z), y + n, x, z)",
                      SPACE "a = at(at(x, x + m, y, z), y + n, x, z)");
    check_same_values(SPACE "a = at(flat(n), x + m, y, z + n)",
                      SPACE "a = at(flat(n), x + m, y, z)");
}

/* Wind from the west or from the south, across which the field is longer */
static void check_wind(void)
{
    check_same_values(ONE "a = wind(n, 270, 3)", ONE "a = stretch(n, 1, 3)");
    check_same_values("recipe 1\nspace 3\na = wind(x + 2 * y + 4 * z, 270, 4)",
                      "recipe 1\nspace 3\na = x + y / 2 + 4 * z");
    check_same_values("recipe 1\nspace 3\na = wind(noise(), 270, 3)",
                      "recipe 1\nspace 3\na = stretch(noise(), 1, 3)");
}

/* Arguments that have names may stand in any order. */
static void check_names(void)
{
    static const struct {
        const char *text, *as;
    } texts[] = {
        {ONE "a = clamp(lo=-0.1, hi=0.2, n)", ONE "a = clamp(n, -0.1, 0.2)"},
        {ONE "a = mix(m=smoothstep(x, 0, 1), b=n, a=y)", ONE "a = mix(y, n, smoothstep(x, 0, 1))"},
        {ONE "a = warp(by=noise(seed=5), f=n)", ONE "a = warp(n, noise(seed=5))"},
        {ONE "a = warp(by=noise(seed=5), n + x)", ONE "a = warp(n + x, noise(seed=5))"},
        {ONE "a = cell(warp(by=noise(seed=5), n))", ONE "a = cell(warp(n, noise(seed=5)))"},
        {ONE "a = move(dy=2, dx=1, n)", ONE "a = move(n, 1, 2)"},
        {ONE "a = at(v=x, u=y, f=n)", ONE "a = at(n, y, x)"},
        {"recipe 1\na = gullies(amplitude=2, noise(seed=5))",
         "recipe 1\na = gullies(noise(seed=5), amplitude=2)"},
        {ONE "a = gullies(size=4, f=n)", ONE "a = gullies(n, size=4)"},
        {ONE "a = displacement(seed=3, n, rotate)", ONE "a = displacement(n, rotate, seed=3)"},
    };
    for (size_t i = 0; i < sizeof texts / sizeof texts[0]; i++) {
        check_same_values(texts[i].text, texts[i].as);
    }
    check_error("recipe 1\nn = noise()\na = warp(by=n)", 3, 5, "an argument is missing");
    check_error("recipe 1\na = gullies(size=4)", 2, 5, "an argument is missing");
}

/* A mask that is 0 hides NaN, also of a chunk in which it is 0 here and there only. */
static void check_masks(void)
{
    struct scarp_samples out = {.value = value, .dx = dx, .dy = dy};
    double kept = y[5];
    (void)parses(
        "recipe 1\na = mix(1, noise() + at(noise(), x, y * 1e30 * 1e30), smoothstep(x, 5, 6))");
    y[5] = 1e290; /* the inner place overflows there */
    (void)sample(&recipe, &out, NULL);
    for (int i = 0; i < POINTS; i++) {
        CHECK(value[i] == 1.0f && dx[i] == 0.0f, "%d: %g, %g", i, (double)value[i], (double)dx[i]);
    }
    y[5] = kept;
}

/* Tiles repeat, in every bit where coordinates are exact. */
static void check_tile(void)
{
    double moved[POINTS], rounded[2][POINTS];
    struct scarp_samples out = {.value = value}, there = {.value = by_hand};
    const struct scarp_recipe_outputs outputs = {.out = &out, .count = 1},
                                      others = {.out = &there, .count = 1};
    (void)parses("recipe 1\ntile 8, 4\nw = noise(size=2, amplitude=0.4, octaves=2)\n"
                 "a = warp(noise(octaves=2), w) + stretch(noise(size=2), 2, 1) + "
                 "gullies(noise(size=2), size=2, cells=2, octaves=2) + cell(noise())");
    for (int i = 0; i < POINTS; i++) {
        rounded[0][i] = (double)(int)(x[i] * 64.0) / 64.0;
        rounded[1][i] = (double)(int)(y[i] * 64.0) / 64.0;
        moved[i] = rounded[0][i] + 8.0;
    }
    (void)scarp_recipe_sample_f64(&recipe, POINTS, rounded[0], rounded[1], NULL, &outputs,
                                  &scratch);
    (void)scarp_recipe_sample_f64(&recipe, POINTS, moved, rounded[1], NULL, &others, &scratch);
    CHECK(memcmp(value, by_hand, sizeof value) == 0, "along x: %g and %g", (double)value[0],
          (double)by_hand[0]);
    for (int i = 0; i < POINTS; i++) {
        moved[i] = rounded[1][i] - 4.0;
    }
    (void)scarp_recipe_sample_f64(&recipe, POINTS, rounded[0], moved, NULL, &others, &scratch);
    CHECK(memcmp(value, by_hand, sizeof value) == 0, "along y: %g and %g", (double)value[0],
          (double)by_hand[0]);
    (void)parse("recipe 1\ntile 10, 10\na = noise(size=3)");
    CHECK(fabs(errors[0].nearest - 10.0 / 3.0) < 1e-12, "the nearest size is %g",
          errors[0].nearest);
}

/* Octaves below `finest` go, and come back bit by bit. */
static void check_finest(void)
{
    const struct scarp_samples out = {.value = value};
    (void)parses("recipe 1\na = noise(size=8, octaves=6)");
    CHECK(scarp_recipe_set(&recipe, "finest", 2.0, NULL) == SCARP_OK, "finest = 2");
    (void)sample(&recipe, &out, NULL);
    const struct scarp_noise three = {
        .offset_first = 1, .frequency = 0.125, .octaves = 3.0f, .of_octaves = 6.0f};
    const struct scarp_samples hand = {.value = by_hand};
    (void)scarp_sample2_f64(&three, POINTS, x, y, &hand);
    CHECK(memcmp(value, by_hand, sizeof value) == 0, "finest = 2 is not three of six octaves");
    CHECK(scarp_recipe_set(&recipe, "finest", 0.0, NULL) == SCARP_OK, "finest = 0");
    (void)sample(&recipe, &out, NULL);
    memcpy(by_hand, value, sizeof by_hand);
    (void)values("recipe 1\na = noise(size=8, octaves=6)");
    CHECK(memcmp(value, by_hand, sizeof value) == 0, "finest = 0 is not all of it");
    (void)parses("recipe 1\na = scale(noise(size=2, octaves=6), 4)");
    (void)scarp_recipe_set(&recipe, "finest", 2.0, NULL);
    (void)sample(&recipe, &out, NULL);
    const struct scarp_noise scaled = {
        .offset_first = 1, .frequency = 0.125, .octaves = 3.0f, .of_octaves = 6.0f};
    (void)scarp_sample2_f64(&scaled, POINTS, x, y, &hand);
    CHECK(memcmp(value, by_hand, sizeof value) == 0, "a place that scales divides it");
    static const char *const squeezed[] = {"recipe 1\na = stretch(noise(size=16, %s), 0.5, 1)",
                                           "recipe 1\na = stretch(noise(size=16, %s), 1, 0.5)",
                                           "recipe 1\nspace 3\na = "
                                           "stretch(noise(size=16, %s), 1, 2, 0.5)",
                                           "recipe 1\nspace 3\nn = noise(size=9)\na = "
                                           "stretch(at(stretch(noise(size=16, %s), 2, 2, 0.5), "
                                           "x + n, y + n, z - n), 2, 2, 1)"};
    for (int i = 0; i < 4; i++) {
        char text[2][256];
        snprintf(text[0], sizeof text[0], squeezed[i], "octaves=6");
        snprintf(text[1], sizeof text[1], squeezed[i], "octaves=3, of_octaves=6");
        (void)parses(text[0]);
        (void)scarp_recipe_set(&recipe, "finest", 2.0, NULL);
        (void)sample(&recipe, &out, NULL);
        memcpy(by_hand, value, sizeof by_hand);
        (void)values(text[1]);
        CHECK(memcmp(value, by_hand, sizeof value) == 0, "%s: the axis of most cells counts",
              text[0]);
    }
    (void)parses("recipe 1\na = gullies(noise(size=16), size=16, octaves=6, cells=3)");
    (void)scarp_recipe_set(&recipe, "finest", 4.0, NULL);
    (void)sample(&recipe, &out, NULL);
    memcpy(by_hand, value, sizeof by_hand);
    (void)values(
        "recipe 1\na = gullies(noise(size=16), size=16, octaves=3, of_octaves=6, cells=3)");
    CHECK(memcmp(value, by_hand, sizeof value) == 0, "gullies count by cells of the base");
}

static void check_ranges(void)
{
    static const struct {
        const char *text;
        float lowest, highest;
    } cases[] = {
        {"recipe 1\na = 3 * noise() + 1", -2.0f, 4.0f},
        {"recipe 1\na = abs(2 * noise() - 1)", 0.0f, 3.0f},
        {"recipe 1\na = noise()^2", 0.0f, 1.0f},
        {"recipe 1\na = noise() * noise(seed=1)", -1.0f, 1.0f},
        {"recipe 1\na = clamp(noise(), -0.25, 4)", -0.25f, 1.0f},
        {"recipe 1\na = min(noise(), 0.5) + max(noise(seed=1), 0)", -1.0f, 1.5f},
        {"recipe 1\na = 1 / (2 + noise())", 1.0f / 3.0f, 1.0f},
        {"recipe 1\na = sqrt(noise() - 0.75)", 0.0f, 0.5f},
        {"recipe 1\na = curve(noise(), -2: 5, 0: 3, 1: 4, 2: 7)", 3.0f, 5.0f},
        {"recipe 1\na = curve(noise(), -1: 3, 1: 4)", 3.0f, 4.0f},
        {"recipe 1\na = slope(noise())", 0.0f, INFINITY},
        {"recipe 1\na = clamp(x, -5, 5)", -5.0f, 5.0f},
        {"recipe 1\na = x", -INFINITY, INFINITY},
        {"recipe 1\na = 2 * displacement(noise(), depth=0.5)", -1.0f, 1.0f},
        {"recipe 1\na = cell(noise())", -1.0f, 1.0f},
        {"recipe 1\na = sine(3 * x) + pulse(y)", -2.0f, 2.0f},
    };
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        float lowest = 0.0f, highest = 0.0f;
        (void)parses(cases[i].text);
        const enum scarp_status status =
            scarp_recipe_range(&recipe, SCARP_RECIPE_OUTPUT, NULL, &lowest, &highest);
        CHECK(status == SCARP_OK, "%s: %s", cases[i].text, scarp_status_text(status));
        CHECK(lowest == cases[i].lowest || fabsf(lowest - cases[i].lowest) <= 1e-5f * fabsf(lowest),
              "%s: from %g", cases[i].text, (double)lowest);
        CHECK(highest == cases[i].highest ||
                  fabsf(highest - cases[i].highest) <= 1e-5f * fabsf(highest),
              "%s: to %g", cases[i].text, (double)highest);
    }
    const struct scarp_box box = {.lowest = {1.0, 2.0, 1.0}, .highest = {3.0, 5.0}},
                           wrong = {.lowest = {1.0}};
    float lowest, highest;
    (void)parses("recipe 1\na = 2 * x - y");
    CHECK(scarp_recipe_range(&recipe, 0, &box, &lowest, &highest) == SCARP_OK,
          "in the plane, z of a box is no matter");
    CHECK(fabsf(lowest + 3.0f) < 1e-4f && fabsf(highest - 4.0f) < 1e-4f, "[%g, %g]", (double)lowest,
          (double)highest);
    CHECK(scarp_recipe_range(&recipe, 0, &wrong, &lowest, &highest) == SCARP_ERROR_PARAMETER,
          "box");
    CHECK(scarp_recipe_range(&recipe, 9, &box, &lowest, &highest) == SCARP_ERROR_PARAMETER,
          "which");
    CHECK(scarp_recipe_range(&recipe, 0, &box, NULL, &highest) == SCARP_ERROR_NULL, "NULL");
}

/* Where a curve is nearly level, rounding may turn its order around: by what the knots round by,
   not the values. */
static void check_range_of_curve(void)
{
    const double at[2] = {92.932067947896229, 26.232472307156989};
    const struct scarp_samples out = {.value = value};
    const struct scarp_recipe_outputs outputs = {.out = &out, .count = 1};
    float lowest, highest;
    (void)parses("recipe 1\na = curve(0.9998392 + 1.44e-06 * noise(), 0: 1000, 1: 0)");
    (void)scarp_recipe_range(&recipe, SCARP_RECIPE_OUTPUT, NULL, &lowest, &highest);
    (void)scarp_recipe_sample_f64(&recipe, 1, &at[0], &at[1], NULL, &outputs, &scratch);
    CHECK(value[0] >= lowest && value[0] <= highest, "%.9g, not in [%.9g, %.9g]", (double)value[0],
          (double)lowest, (double)highest);
    CHECK(highest < 0.01f, "a curve near 0 reaches %.9g", (double)highest);
}

/* Fields of coordinates reach the ends of their ranges, and go no further. */
static void check_reached_ranges(void)
{
#define XY "recipe 1\nu = clamp(x, -1, 0.7)\nv = clamp(y, -0.4, 1)\nw = clamp(y, 0.5, 2)\na = "
    static const char *const texts[] = {
        XY "u + v",
        XY "u - v",
        XY "u * v",
        XY "u^2 + v",
        XY "u^4",
        XY "-2 * u + 1",
        XY "u / w",
        XY "w / (2 + u)",
        XY "min(u, v)",
        XY "max(u, v)",
        XY "min(u, 0.2 * v - 0.92, smooth=0.6)",
        XY "max(u, v - 0.3, smooth=0.6)",
        XY "abs(u)",
        XY "abs(w)",
        XY "smooth_abs(u, 0.1)",
        XY "clamp(u, -0.5, 0.3)",
        XY "smoothstep(v, -2, 2)",
        XY "smoothstep(v, 2, -2)",
        XY "terrace(0.9 * u, 3, riser=0.2, strength=1)",
        XY "terrace(v, 2.5, riser=0.2, strength=1)",
        XY "mix(u, w, smoothstep(x, -1, 1))",
        XY "curve(u, -0.5: 3, 0: -1, 0.5: 4)",
        XY "curve(u, -2: 3, 2: -1)",
        XY "blend(u, -0.5: v, 0.5: w)",
        XY "sqrt(w - 0.75)",
        XY "sine(3 * u)",
        XY "pulse(4 * u)",
        XY "turn(u, 30) + scale(v, 0.25)",
        XY "at(u, 2 * x - y, y)",
    };
    static float field[201 * 201];
    const struct scarp_grid grid = {.origin = {-2, -2}, .step = {0.02, 0.02}, .count = {201, 201}};
    const struct scarp_samples out = {.value = field};
    const struct scarp_recipe_outputs outputs = {.out = &out, .count = 1};
    for (size_t i = 0; i < sizeof texts / sizeof texts[0]; i++) {
        float lowest = 0.0f, highest = 0.0f, least = INFINITY, most = -INFINITY;
        (void)parses(texts[i]);
        (void)scarp_recipe_range(&recipe, SCARP_RECIPE_OUTPUT, NULL, &lowest, &highest);
        (void)scarp_recipe_grid(&recipe, &grid, &outputs, &scratch);
        for (int k = 0; k < 201 * 201; k++) {
            least = field[k] < least ? field[k] : least;
            most = field[k] > most ? field[k] : most;
        }
        CHECK(lowest <= least && most <= highest, "%s: [%g, %g] is promised, and [%g, %g] met",
              texts[i], (double)lowest, (double)highest, (double)least, (double)most);
        const float room = 0.04f * (highest - lowest);
        const int is_terrace = strstr(texts[i], "terrace") != NULL;
        CHECK(is_terrace || (least <= lowest + room && most >= highest - room),
              "%s: [%g, %g] is promised, and only [%g, %g] met", texts[i], (double)lowest,
              (double)highest, (double)least, (double)most);
    }
}

static int spans(const char *text, const uint32_t span[2], const char *word)
{
    return strlen(word) == span[1] - span[0] && strncmp(text + span[0], word, strlen(word)) == 0;
}

/* What editors are told */
static void check_descriptions(void)
{
    const char *const text = "recipe 1\nparam k = 2 [1, 3]\nw = noise(size=8, amplitude=k)\n"
                             "out a = (1 + abs(w)) * curve(x / 4, 0: 1, 2: k)\nout b = flatten\n";
    (void)parse(text);
    struct scarp_recipe_entry entry;
    struct scarp_recipe_part part;
    size_t count = 0;
    for (; scarp_recipe_entry_at(&recipe, count, &entry) == SCARP_OK; count++) {
        CHECK(entry.span[0] <= entry.name[0] && entry.name[1] <= entry.span[1], "spans of %zu",
              count);
    }
    CHECK(count == 4, "%zu statements", count);
    (void)scarp_recipe_entry_at(&recipe, 2, &entry);
    CHECK(spans(text, entry.name, "a") && entry.output == 0 && entry.kind == SCARP_RECIPE_FIELD &&
              entry.axes == 3 && entry.order == 2 && entry.range[0] == 1.0f &&
              entry.range[1] == 6.0f,
          "a: output %d, kind %d, axes %u, order %u, [%g, %g]", entry.output, entry.kind,
          entry.axes, entry.order, (double)entry.range[0], (double)entry.range[1]);
    CHECK(spans(text, entry.span, "out a = (1 + abs(w)) * curve(x / 4, 0: 1, 2: k)"), "its span");
    const int32_t root = entry.part;
    (void)scarp_recipe_entry_at(&recipe, 3, &entry);
    CHECK(entry.kind == SCARP_RECIPE_BAD && entry.output == 1, "b has an error");
    static const struct {
        const char *span, *argument;
        int kind, operation;
    } expected[] = {
        {"(1 + abs(w)) * curve(x / 4, 0: 1, 2: k)", "", SCARP_RECIPE_FIELD, '*'},
        {"(1 + abs(w))", "", SCARP_RECIPE_FIELD, '+'},
        {"abs(w)", "", SCARP_RECIPE_FIELD, 0},
        {"w", "", SCARP_RECIPE_NOISE, 0},
        {"x / 4", "", SCARP_RECIPE_FIELD, '/'},
        {"0: 1", "", SCARP_RECIPE_KNOT, 0},
        {"k", "amplitude", SCARP_RECIPE_NUMBER, 0},
        {"8", "size", SCARP_RECIPE_NUMBER, 0},
        {"noise(size=8, amplitude=k)", "", SCARP_RECIPE_NOISE, 0},
    };
    for (size_t i = 0; i < sizeof expected / sizeof expected[0]; i++) {
        int found = 0;
        for (size_t p = 0; scarp_recipe_part_at(&recipe, p, &part) == SCARP_OK; p++) {
            found += spans(text, part.span, expected[i].span) && part.kind == expected[i].kind &&
                     part.operation == expected[i].operation &&
                     spans(text, part.argument, expected[i].argument);
        }
        CHECK(found >= 1, "%d parts are %s", found, expected[i].span);
    }
    (void)scarp_recipe_part_at(&recipe, (size_t)root, &part);
    CHECK(part.parent == -1, "the parent of a whole expression is %d", part.parent);
    struct scarp_recipe_function function;
    size_t functions = 0;
    for (; scarp_recipe_function_at(functions, &function) == SCARP_OK; functions++) {
        CHECK(function.name != NULL && function.text != NULL && function.arguments > 0, "%zu",
              functions);
        for (int i = 0; i < function.arguments; i++) {
            const struct scarp_recipe_argument *const a = &function.argument[i];
            CHECK(a->name != NULL && a->text != NULL &&
                      (a->kind != SCARP_RECIPE_NUMBER || a->lowest < a->highest) &&
                      (a->kind == SCARP_RECIPE_WORD) == (a->words != NULL),
                  "%s, argument %d", function.name, i);
        }
    }
    CHECK(functions == 26, "%zu functions", functions);
}

/* Words are those of the library. */
static void check_words(void)
{
    struct scarp_recipe_function noise;
    (void)scarp_recipe_function_at(0, &noise);
    const char *(*const names[3])(int) = {basis_name, fractal_name, fade_name};
    for (int list = 0; list < 3; list++) {
        int i = 0;
        for (; names[list](i) != NULL && noise.argument[list].words[i] != NULL; i++) {
            const char *const word = noise.argument[list].words[i];
            int same = strlen(word) == strlen(names[list](i));
            for (size_t k = 0; same && word[k] != '\0'; k++) {
                same = word[k] == names[list](i)[k] || (word[k] == '_' && names[list](i)[k] == '-');
            }
            CHECK(same, "%s is not %s", word, names[list](i));
        }
        CHECK(names[list](i) == NULL && noise.argument[list].words[i] == NULL, "lists of %d words",
              i);
    }
}

static uint64_t hash_of(const char *text, size_t statement)
{
    struct scarp_recipe_entry entry = {0};
    (void)parses(text);
    (void)scarp_recipe_entry_at(&recipe, statement, &entry);
    return entry.hash;
}

/* Hashes stay where nothing has to be drawn anew. */
static void check_hashes(void)
{
    const uint64_t a = hash_of("recipe 1\na = 2 * warp(noise(), noise(size=3))", 0);
    CHECK(a ==
              hash_of(
                  "recipe 1 # more\nn = noise(seed=7)\nw = noise(size=3)\nb = 2 * warp(noise(), w)",
                  2),
          "another text of the same field");
    CHECK(a != hash_of("recipe 1\na = 2 * warp(noise(), noise(size=4))", 0), "another warp");
    CHECK(a != hash_of("recipe 1\na = 3 * warp(noise(), noise(size=3))", 0), "another number");
    CHECK(hash_of("recipe 1\na = turn(noise(), 3)", 0) !=
              hash_of("recipe 1\na = turn(noise(), 4)", 0),
          "another place");
    CHECK(hash_of("recipe 1\na = curve(noise(), 0: 1, 1: 2)", 0) !=
              hash_of("recipe 1\na = curve(noise(), 0: 1, 1: 3)", 0),
          "another knot");
    CHECK(hash_of("recipe 1\na = gullies(noise(), depth=0.5)", 0) !=
              hash_of("recipe 1\na = gullies(noise())", 0),
          "other gullies");
}

/* Statements and parts by number, several at once */
static void check_which(void)
{
    (void)parses("recipe 1\na = noise()\nout b = 2 * a\nout c = warp(a, noise(size=2)) + a");
    const struct scarp_samples out[3] = {{.value = value}, {.value = by_hand}, {.value = dx}};
    struct scarp_recipe_outputs outputs = {.out = out, .count = 2};
    float kept[2][POINTS];
    CHECK(scarp_recipe_sample_f64(&recipe, POINTS, x, y, z, &outputs, &scratch) == SCARP_OK,
          "both");
    memcpy(kept[0], value, sizeof value);
    memcpy(kept[1], by_hand, sizeof by_hand);
    const int32_t which[3] = {2, 0, 1};
    outputs.which = which;
    outputs.count = 3;
    CHECK(scarp_recipe_sample_f64(&recipe, POINTS, x, y, z, &outputs, NULL) == SCARP_OK, "three");
    for (int i = 0; i < POINTS; i++) {
        CHECK(value[i] == kept[1][i] && dx[i] == kept[0][i] && dx[i] == 2.0f * by_hand[i],
              "%d: %g %g %g", i, (double)value[i], (double)by_hand[i], (double)dx[i]);
    }
    /* Each part that is a field */
    struct scarp_recipe_part part;
    for (size_t p = 0; scarp_recipe_part_at(&recipe, p, &part) == SCARP_OK; p++) {
        const int32_t one[1] = {(int32_t)p + SCARP_RECIPE_PARTS};
        const int is_field = part.kind == SCARP_RECIPE_FIELD || part.kind == SCARP_RECIPE_NOISE;
        const enum scarp_status status = sample(&recipe, &out[0], one);
        CHECK(is_field == (status == SCARP_OK), "part %zu, kind %d: %s", p, part.kind,
              scarp_status_text(status));
    }
    /* An output that is a number */
    (void)values("recipe 1\nout a = 7");
    CHECK(value[POINTS - 1] == 7.0f, "%g", (double)value[POINTS - 1]);
}

int main(void)
{
    set_positions();
    check_numbers();
    check_errors();
    check_many_errors();
    check_calls();
    check_scratch_size();
    check_set();
    check_seeds();
    check_language();
    check_by_hand();
    check_cells();
    check_flat();
    check_wind();
    check_names();
    check_shared();
    check_masks();
    check_tile();
    check_finest();
    check_ranges();
    check_range_of_curve();
    check_reached_ranges();
    check_descriptions();
    check_words();
    check_hashes();
    check_which();
    return check_done();
}
