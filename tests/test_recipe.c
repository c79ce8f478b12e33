/* SPDX-License-Identifier: MIT
 *
 * Recipes as a language: numbers, errors and their spans, ways to write the same.
 */
#include "recipe_values.h"

static float by_hand[POINTS];

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
        {ONE "a = n^5", 3, 7, "an exponent"},
        {ONE "a = 1.2.3 * n", 3, 8, "after a number"},
        {ONE "a = 1e99 * n", 3, 5, "expected a number"},
        {ONE "a = b + n", 3, 5, "no such name"},
        {ONE "a = b + n\nb = n", 3, 5, "above"},
        {ONE "a = a", 3, 5, "above"},
        {ONE "n = 2 * n", 3, 1, "defined above"},
        {ONE "min = n", 3, 1, "name of a function"},
        {ONE "x = n", 3, 1, "reserved"},
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
        {ONE "a = abs(1: 2)", 3, 9, "curve() or blend()"},
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
        {ONE "a = noise(size=2, frequency=2)", 3, 29, "either size or frequency"},
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
        {ONE "a = flat(n)", 3, 5, "needs space 3"},
        {"recipe 1\nspace 4\na = noise()", 2, 7, "2 or 3"},
        {"recipe 1\na = noise()\nspace 3", 3, 7, "must come before"},
        {"recipe 1\nspace 3\na = gullies(noise())", 3, 5, "inside flat()"},
        {"recipe 1\nspace 3\na = flat(z)", 3, 10, "no z"},
        {ONE "a = gullies(noise(erosion, octaves=2))", 3, 13, "second derivatives"},
        {ONE "a = gullies(slope(n))", 3, 13, "second derivatives"},
        {ONE "a = gullies(n, depth=-1)", 3, 22, "outside [2^-24, 2^10]"},
        {ONE "a = slope(slope(slope(n)))", 3, 5, "no gradient"},
        {"recipe 1\ntile 4, 0\na = noise()", 2, 6, "above 0"},
        {"recipe 1\ntile 4\na = noise()", 2, 7, "length for each axis"},
        {"recipe 1\ntile 4, 4\na = noise(size=3)", 3, 5, "not a whole number of cells"},
        {"recipe 1\ntile 4, 4\na = turn(noise(), 30)", 3, 10, "turned noise does not repeat"},
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

/* Arguments that have names may be in any order. */
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

int main(void)
{
    set_positions();
    check_numbers();
    check_errors();
    check_many_errors();
    check_language();
    check_names();
    return check_done();
}
