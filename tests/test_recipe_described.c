/* SPDX-License-Identifier: MIT
 *
 * What a recipe says of itself: ranges, what editors ask, the words, hashes.
 */
#include "recipe_values.h"

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
#define DERIVED(name, value, first, second, expression, ...) XY expression,
    static const char *const texts[] = {
#include "functions.def"
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
        XY "abs(w)",
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

/* What editors ask */
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
#define FUNCTION(...) +1
#define WORD(...) +1
    const size_t all = 0
#include "../src/plan/functions.def"
        ;
    CHECK(functions == all, "%zu functions", functions);
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

int main(void)
{
    set_positions();
    check_ranges();
    check_range_of_curve();
    check_reached_ranges();
    check_descriptions();
    check_words();
    check_hashes();
    return check_done();
}
