/* SPDX-License-Identifier: MIT
 *
 * A tile and a scale that calls give to a recipe: the same bits as those of a text that has them,
 * for all texts of recipes.h, the presets, several seeds and all kernel sets.
 */
#include "presets/presets.h"
#include "recipes.h"

#define WIDTH 17
#define HEIGHT 9
#define DEPTH 4
#define MOST (WIDTH * HEIGHT * DEPTH)
#define ARRAYS 10
#define ROOM 20000 /* bytes of a text with lines added */

static struct scarp_recipe recipe, by_text, copy;
static uint64_t memory[1 << 15];
static const uint64_t seeds[] = {0, 12, UINT64_MAX - 2};

struct values {
    float array[ARRAYS][MOST];
};

static enum scarp_status parse(const char *text, struct scarp_recipe *to)
{
    return scarp_recipe_parse(text, strlen(text), to, NULL, 0, NULL);
}

static int is_field(const struct scarp_recipe_entry *entry)
{
    return entry->kind == SCARP_RECIPE_FIELD || entry->kind == SCARP_RECIPE_NOISE;
}

/* Samples a statement on a grid, with all the derivatives that it has. `unit` is about a cell. */
static void sample(const struct scarp_recipe *of, int32_t number, double unit, struct values *to)
{
    const struct scarp_recipe_entry entry = recipe_entry(of, (size_t)number);
    const int is_space = entry.dimensions == 3;
    const struct scarp_grid grid = {.origin = {-3.25 * unit, 1.5 * unit, 0.75 * unit},
                                    .step = {0.37 * unit, 0.41 * unit, 0.83 * unit},
                                    .count = {WIDTH, HEIGHT, is_space ? DEPTH : 1}};
    const struct scarp_samples out = recipe_samples(to->array[0], MOST, (int)entry.order, is_space);
    const struct scarp_recipe_outputs outputs = {.out = &out, .which = &number, .count = 1};
    const struct scarp_scratch scratch = {.memory = memory, .size = sizeof memory};
    memset(to, 0, sizeof *to);
    CHECK(scarp_recipe_grid(of, &grid, &outputs, &scratch) == SCARP_OK, "statement %d",
          (int)number);
}

/* Compares a statement of a recipe with one of another. */
static void check_same(const char *what, const struct scarp_recipe *a, int32_t number_a,
                       const struct scarp_recipe *b, int32_t number_b, double unit)
{
    static struct values of_a, of_b;
    float range_a[2], range_b[2];
    sample(a, number_a, unit, &of_a);
    sample(b, number_b, unit, &of_b);
    CHECK(memcmp(&of_a, &of_b, sizeof of_a) == 0, "%s: statement %d differs", what, (int)number_a);
    CHECK(scarp_recipe_range(a, number_a, NULL, &range_a[0], &range_a[1]) == SCARP_OK &&
              scarp_recipe_range(b, number_b, NULL, &range_b[0], &range_b[1]) == SCARP_OK &&
              memcmp(range_a, range_b, sizeof range_a) == 0,
          "%s: statement %d has another range", what, (int)number_a);
}

static void check_same_in_sets(const char *what, const struct scarp_recipe *a, int32_t number_a,
                               const struct scarp_recipe *b, int32_t number_b, double unit)
{
    for (enum scarp_isa isa = SCARP_ISA_SCALAR; scarp_isa_name(isa) != NULL; isa++) {
        if (scarp_isa_select(isa) == SCARP_OK) {
            check_same(what, a, number_a, b, number_b, unit);
        }
    }
}

/* Compares all fields of two recipes whose statements are the same. */
static void check_same_recipes(const char *what, const struct scarp_recipe *a,
                               const struct scarp_recipe *b, double unit)
{
    struct scarp_recipe_entry entry;
    for (int32_t i = 0; scarp_recipe_entry_at(a, (size_t)i, &entry) == SCARP_OK; i++) {
        if (is_field(&entry)) {
            check_same_in_sets(what, a, i, b, i, unit);
        }
        CHECK(entry.hash == recipe_entry(b, (size_t)i).hash, "%s: another hash of %d", what,
              (int)i);
    }
}

/* A text with a line for each statement that is scaled. Returns how many statements it had. */
static int32_t write_scaled(const char *text, double by, double heights, char *to)
{
    struct scarp_recipe_entry entry;
    int32_t count = 0;
    size_t length = (size_t)sprintf(to, "%s\n", text);
    for (; scarp_recipe_entry_at(&recipe, (size_t)count, &entry) == SCARP_OK; count++) {
        if (is_field(&entry)) {
            length += (size_t)sprintf(to + length, "scaled_%d = ", (int)count);
            if (entry.output == 0) {
                length += (size_t)sprintf(to + length, "%.17g * ", heights);
            }
            length +=
                (size_t)sprintf(to + length, "scale(%.*s, %.17g)\n",
                                (int)(entry.name[1] - entry.name[0]), text + entry.name[0], by);
        }
    }
    return count;
}

/* The scale of a call, and statements that are scaled */
static void check_scale(const char *name, const char *text, double by, double heights, double unit)
{
    static char scaled[ROOM];
    struct scarp_recipe_entry entry;
    CHECK(parse(text, &recipe) == SCARP_OK, "%s", name);
    int32_t number = write_scaled(text, by, heights, scaled);
    /* Not all fit into one text. */
    if (parse(scaled, &by_text) == SCARP_ERROR_SIZE) {
        return;
    }
    CHECK(parse(scaled, &by_text) == SCARP_OK, "%s: the text with the lines", name);
    CHECK(scarp_recipe_scale(&recipe, by, heights, NULL) == SCARP_OK, "%s: scale", name);
    for (size_t s = 0; s < sizeof seeds / sizeof seeds[0]; s++) {
        int32_t scaled_number = number;
        CHECK(scarp_recipe_seed(&recipe, seeds[s]) == SCARP_OK &&
                  scarp_recipe_seed(&by_text, seeds[s]) == SCARP_OK,
              "%s: seed", name);
        memcpy(&copy, &recipe, sizeof copy);
        for (int32_t i = 0; i < number; i++) {
            entry = recipe_entry(&recipe, (size_t)i);
            if (is_field(&entry)) {
                check_same_in_sets(name, &copy, i, &by_text, scaled_number++, by * unit);
            }
        }
    }
}

/* A text with a tile */
static void write_tiled(const char *text, const char *tile, char *to)
{
    static const char space[] = "space 3\n";
    const char *behind = strchr(strstr(text, "recipe 1"), '\n') + 1;
    behind += strncmp(behind, space, strlen(space)) == 0 ? strlen(space) : 0;
    sprintf(to, "%.*stile %s\n%s", (int)(behind - text), text, tile, behind);
}

/* The tile of a call, and that of a line in the text. Returns 1 if the recipe repeats. */
static int check_tile(const char *name, const char *text, double side, double unit)
{
    static char tiled[ROOM];
    struct scarp_recipe_error list[32], error;
    char tile[100];
    size_t found = 0, first = 0;
    CHECK(parse(text, &recipe) == SCARP_OK, "%s", name);
    const int is_space = recipe_entry(&recipe, 0).dimensions == 3;
    sprintf(tile, is_space ? "%.17g, %.17g, %.17g" : "%.17g, %.17g", side, 2.0 * side, side);
    write_tiled(text, tile, tiled);
    const enum scarp_status status =
        scarp_recipe_parse(tiled, strlen(tiled), &by_text, list, 32, &found);
    memcpy(&copy, &recipe, sizeof copy);
    CHECK(scarp_recipe_tile(&recipe, side, 2.0 * side, side, &error) == status, "%s: %s", name,
          scarp_status_text(status));
    if (status == SCARP_OK) {
        for (size_t s = 0; s < sizeof seeds / sizeof seeds[0]; s++) {
            CHECK(scarp_recipe_seed(&recipe, seeds[s]) == SCARP_OK &&
                      scarp_recipe_seed(&by_text, seeds[s]) == SCARP_OK,
                  "%s: seed", name);
            check_same_recipes(name, &recipe, &by_text, unit);
        }
        return 1;
    }
    while (first < found && list[first].nearest != 0.0) {
        first++;
    }
    first = first < found ? first : 0;
    CHECK(error.text == list[first].text && error.member == list[first].member &&
              error.nearest == list[first].nearest && error.line == list[first].line - 1 &&
              error.column == list[first].column,
          "%s: line %d: %s, and not line %d: %s", name, (int)error.line, error.text,
          (int)list[first].line - 1, list[first].text);
    check_same_recipes(name, &recipe, &copy, unit);
    return 0;
}

/* Presets are not ended by a NUL. */
static const char *preset_text(int number)
{
    static char text[ROOM];
    sprintf(text, "%.*s", (int)preset_list[number].length, preset_list[number].text);
    return text;
}

static void check_texts(void)
{
    int repeating = 0;
    for (size_t i = 0; i < RECIPE_TEXTS; i++) {
        const struct recipe_text *const t = &recipe_texts[i];
        const int is_tiled = strstr(t->text, "\ntile") != NULL;
        check_scale(t->name, t->text, is_tiled ? 2.0 : 3.3, 0.7, 1.0);
        check_scale(t->name, t->text, 0.25, 1.0, 1.0);
        repeating += !is_tiled && check_tile(t->name, t->text, 12.0, 1.0);
        repeating += !is_tiled && check_tile(t->name, t->text, 1.5, 1.0);
    }
    CHECK(repeating >= 30, "%d of the texts repeat", repeating);
    for (int i = 1; preset_name(i) != NULL; i++) {
        check_scale(preset_name(i), preset_text(i), 0.1, 0.1, 200.0);
        check_scale(preset_name(i), preset_text(i), 2.5, 2.5, 200.0);
        check_tile(preset_name(i), preset_text(i), 512.0, 200.0);
    }
}

/* Both together, in any order, and with what is set later: as a text has it */
static void check_together(void)
{
    static const char text[] =
        "recipe 1\nparam k = 2 [1, 9]\nw = noise(size=8, amplitude=k)\nb = noise(size=16, "
        "octaves=3)\nout h = warp(b, w)\nout c = move(b, k, 1)";
    static const char other[] =
        "recipe 1\ntile 160, 96\nparam k = 2 [1, 9]\nw = scale(noise(size=8, amplitude=k), 2)\n"
        "b = scale(noise(size=16, octaves=3), 2)\n"
        "out h = 3 * scale(warp(noise(size=16, octaves=3), noise(size=8, amplitude=k)), 2)\n"
        "out c = scale(move(noise(size=16, octaves=3), k, 1), 2)";
    CHECK(parse(other, &by_text) == SCARP_OK && parse(text, &recipe) == SCARP_OK, "parse");
    (void)scarp_recipe_seed(&by_text, 5);
    (void)scarp_recipe_set(&by_text, "k", 3.5, NULL);
    (void)scarp_recipe_set(&by_text, "finest", 9.0, NULL);
    CHECK(scarp_recipe_scale(&recipe, 7.0, 0.1, NULL) == SCARP_OK &&
              scarp_recipe_scale(&recipe, 2.0, 3.0, NULL) == SCARP_OK,
          "the later scale counts");
    CHECK(scarp_recipe_seed(&recipe, 5) == SCARP_OK &&
              scarp_recipe_tile(&recipe, 160.0, 96.0, NAN, NULL) == SCARP_OK &&
              scarp_recipe_set(&recipe, "k", 3.5, NULL) == SCARP_OK &&
              scarp_recipe_set(&recipe, "finest", 9.0, NULL) == SCARP_OK,
          "settings");
    memcpy(&copy, &recipe, sizeof copy);
    memset(&recipe, 0x42, sizeof recipe);
    for (int32_t i = 1; i < 5; i++) {
        check_same_in_sets("together", &copy, i, &by_text, i, 10.0);
    }
    CHECK(parse(text, &recipe) == SCARP_OK, "parse");
    (void)scarp_recipe_set(&recipe, "finest", 9.0, NULL);
    (void)scarp_recipe_set(&recipe, "k", 3.5, NULL);
    (void)scarp_recipe_tile(&recipe, 160.0, 96.0, 0.0, NULL);
    (void)scarp_recipe_seed(&recipe, 5);
    CHECK(scarp_recipe_scale(&recipe, 2.0, 3.0, NULL) == SCARP_OK, "scale");
    check_same_recipes("in another order", &recipe, &copy, 10.0);
    CHECK(scarp_recipe_tile(&recipe, 0.0, 0.0, 0.0, NULL) == SCARP_OK &&
              scarp_recipe_scale(&recipe, 1.0, 1.0, NULL) == SCARP_OK,
          "taken back");
    (void)parse(text, &copy);
    (void)scarp_recipe_seed(&copy, 5);
    (void)scarp_recipe_set(&copy, "k", 3.5, NULL);
    (void)scarp_recipe_set(&copy, "finest", 9.0, NULL);
    check_same_recipes("taken back", &recipe, &copy, 10.0);
}

/* Outputs that are numbers are scaled once, however often the recipe is compiled. */
static void check_scaled_numbers(void)
{
    static const char *const numbers[] = {"0.29", "-0.29", "(0.29)", "0.1 + 0.19", "k", "-k"};
    for (size_t i = 0; i < sizeof numbers / sizeof numbers[0]; i++) {
        char text[ROOM], scaled[ROOM];
        struct scarp_recipe_part part;
        sprintf(text, "recipe 1\nparam k = 0.29 [-1, 1]\nn = x\nout h = %s\nout b = h + n",
                numbers[i]);
        sprintf(scaled, "recipe 1\nparam k = 0.29 [-1, 1]\nout h = 3.7 * (%s)", numbers[i]);
        CHECK(parse(text, &recipe) == SCARP_OK && parse(scaled, &by_text) == SCARP_OK, "parse");
        CHECK(scarp_recipe_scale(&recipe, 1.0, 3.7, NULL) == SCARP_OK, "scale");
        memcpy(&copy, &recipe, sizeof copy);
        for (int again = 0; again < 3; again++) {
            CHECK(scarp_recipe_seed(&recipe, 7) == SCARP_OK &&
                      scarp_recipe_tile(&recipe, 5.0, 5.0, 0.0, NULL) == SCARP_ERROR_PARAMETER &&
                      scarp_recipe_set(&recipe, "k", 0.29, NULL) == SCARP_OK,
                  "again");
            check_same(numbers[i], &recipe, 2, &by_text, 1, 1.0);
            check_same_recipes(numbers[i], &recipe, &copy, 1.0);
        }
        for (size_t k = 0; scarp_recipe_part_at(&recipe, k, &part) == SCARP_OK; k++) {
            struct scarp_recipe_part before;
            CHECK(scarp_recipe_part_at(&copy, k, &before) == SCARP_OK &&
                      part.value == before.value && part.hash == before.hash,
                  "%s: part %zu is %g, and was %g", numbers[i], k, part.value, before.value);
        }
        CHECK(scarp_recipe_scale(&recipe, 1.0, 1.0, NULL) == SCARP_OK &&
                  parse(text, &copy) == SCARP_OK,
              "taken back");
        check_same_recipes("taken back", &recipe, &copy, 1.0);
    }
}

/* A tile of a call takes the place of that of the text, and no sides take it away. */
static void check_other_tile(void)
{
    static const char tiled[] = "recipe 1\ntile 8, 8\na = noise()",
                      none[] = "recipe 1\na = noise()";
    CHECK(parse(tiled, &recipe) == SCARP_OK &&
              parse("recipe 1\ntile 3, 4\na = noise()", &copy) == SCARP_OK &&
              scarp_recipe_tile(&recipe, 3.0, 4.0, 0.0, NULL) == SCARP_OK,
          "another tile");
    check_same_recipes("another tile", &recipe, &copy, 1.0);
    CHECK(parse(none, &copy) == SCARP_OK &&
              scarp_recipe_tile(&recipe, 0.0, 0.0, 0.0, NULL) == SCARP_OK,
          "no tile");
    check_same_recipes("no tile", &recipe, &copy, 1.0);
}

static void check_refused(const char *what, enum scarp_status status, enum scarp_status expected,
                          const struct scarp_recipe_error *error, const char *says)
{
    CHECK(status == expected, "%s: %s", what, scarp_status_text(status));
    CHECK(says == NULL ? error->text == NULL
                       : error->text != NULL && strstr(error->text, says) != NULL,
          "%s: %s", what, error->text);
    check_same_recipes(what, &recipe, &copy, 1.0);
}

static void check_bad_numbers(int is_space)
{
    static const double bad[] = {-1.0, NAN, INFINITY, -INFINITY, 1e-61, 1e61};
    struct scarp_recipe_error error;
    CHECK(parse(is_space ? "recipe 1\nspace 3\na = noise()" : "recipe 1\na = noise()", &recipe) ==
              SCARP_OK,
          "parse");
    memcpy(&copy, &recipe, sizeof copy);
    for (size_t i = 0; i < sizeof bad / sizeof bad[0]; i++) {
        for (int axis = 0; axis < 2 + is_space; axis++) {
            double side[3] = {4.0, 4.0, 4.0};
            side[axis] = bad[i];
            memset(&error, 0x42, sizeof error);
            check_refused("a bad side",
                          scarp_recipe_tile(&recipe, side[0], side[1], side[2], &error),
                          SCARP_ERROR_PARAMETER, &error, NULL);
            side[axis] = 0.0;
            check_refused("a side of 0",
                          scarp_recipe_tile(&recipe, side[0], side[1], side[2], &error),
                          SCARP_ERROR_PARAMETER, &error, NULL);
        }
        memset(&error, 0x42, sizeof error);
        check_refused("a bad factor", scarp_recipe_scale(&recipe, bad[i], 1.0, &error),
                      SCARP_ERROR_PARAMETER, &error, NULL);
        check_refused("bad heights", scarp_recipe_scale(&recipe, 1.0, bad[i], &error),
                      SCARP_ERROR_PARAMETER, &error, NULL);
    }
    check_refused("0", scarp_recipe_scale(&recipe, 0.0, 1.0, &error), SCARP_ERROR_PARAMETER, &error,
                  NULL);
    check_refused("0", scarp_recipe_scale(&recipe, 1.0, 0.0, NULL), SCARP_ERROR_PARAMETER, &error,
                  NULL);
    CHECK(scarp_recipe_scale(&recipe, 0x1p-40, 0x1p40, NULL) == SCARP_OK &&
              scarp_recipe_scale(&recipe, 0x1p40, 0x1p-40, NULL) == SCARP_OK &&
              scarp_recipe_scale(&recipe, 0x1.8p40, 1.0, NULL) == SCARP_ERROR_PARAMETER,
          "the ends of the interval");
}

static void check_bad_recipes(void)
{
    struct scarp_recipe_error error;
    CHECK(scarp_recipe_tile(NULL, 1.0, 1.0, 1.0, &error) == SCARP_ERROR_NULL && error.text == NULL,
          "no recipe");
    CHECK(scarp_recipe_scale(NULL, 1.0, 1.0, NULL) == SCARP_ERROR_NULL, "no recipe");
    memset(&copy, 0, sizeof copy);
    CHECK(scarp_recipe_tile(&copy, 1.0, 1.0, 1.0, &error) == SCARP_ERROR_PARAMETER &&
              scarp_recipe_scale(&copy, 1.0, 1.0, &error) == SCARP_ERROR_PARAMETER,
          "zeros");
    CHECK(parse("recipe 1\na = b", &copy) == SCARP_ERROR_PARAMETER &&
              scarp_recipe_tile(&copy, 1.0, 1.0, 1.0, &error) == SCARP_ERROR_PARAMETER &&
              scarp_recipe_scale(&copy, 1.0, 1.0, &error) == SCARP_ERROR_PARAMETER,
          "a text with an error");
}

/* What a text cannot be */
static void check_bad_texts(void)
{
    static char text[ROOM];
    struct scarp_recipe_error error;
    CHECK(parse("recipe 1\na = noise(size=8) * turn(noise(size=5), 9)", &recipe) == SCARP_OK, "a");
    memcpy(&copy, &recipe, sizeof copy);
    check_refused("no size mends it", scarp_recipe_tile(&recipe, 12.0, 8.0, 0.0, &error),
                  SCARP_ERROR_PARAMETER, &error, "turned noise does not repeat");
    CHECK(parse("recipe 1\ntile 8, 8\na = noise(size=4)", &recipe) == SCARP_OK, "a tile");
    memcpy(&copy, &recipe, sizeof copy);
    check_refused("a tile that is too small", scarp_recipe_scale(&recipe, 3.0, 1.0, &error),
                  SCARP_ERROR_PARAMETER, &error, "not a whole number of cells");
    CHECK(error.nearest != 0.0, "a size would do");
    check_refused("another tile that does not fit", scarp_recipe_tile(&recipe, 7.0, 8.0, 0.0, NULL),
                  SCARP_ERROR_PARAMETER, &(struct scarp_recipe_error){.text = NULL}, NULL);
    CHECK(parse("recipe 1\na = 3e38 * noise() + 1", &recipe) == SCARP_OK, "large");
    CHECK(scarp_recipe_scale(&recipe, 1.0, 0x1p40, NULL) == SCARP_OK, "infinite values");
    CHECK(parse("recipe 1\nout a = 1e38\nout b = noise()", &recipe) == SCARP_OK, "large");
    memcpy(&copy, &recipe, sizeof copy);
    check_refused("a number that is too large", scarp_recipe_scale(&recipe, 1.0, 100.0, &error),
                  SCARP_ERROR_PARAMETER, &error, "too large");
    size_t length = (size_t)sprintf(text, "recipe 1\na0 = noise()\n");
    for (int i = 1; i < 32; i++) { /* with the points, all places that there are */
        length += (size_t)sprintf(text + length, "a%d = turn(a0, %d)\n", i, i);
    }
    CHECK(parse(text, &recipe) == SCARP_OK, "31 places");
    memcpy(&copy, &recipe, sizeof copy);
    check_refused("too many places", scarp_recipe_scale(&recipe, 2.0, 1.0, &error),
                  SCARP_ERROR_SIZE, &error, "too large");
}

/* The answers of shaders are those of a text that is scaled. */
static void check_answers(void)
{
    static uint32_t answers[2][SCARP_GPU_ANSWERS];
    CHECK(parse("recipe 1\nn = noise(octaves=3)\nout a = gullies(n, octaves=2)\nout b = slope(n)",
                &recipe) == SCARP_OK &&
              scarp_recipe_scale(&recipe, 3.0, 2.0, NULL) == SCARP_OK,
          "a recipe");
    CHECK(parse("recipe 1\nn = noise(octaves=3)\nout a = 2 * scale(gullies(n, octaves=2), 3)\n"
                "out b = scale(slope(n), 3)",
                &copy) == SCARP_OK,
          "its text");
    CHECK(scarp_recipe_answers(&recipe, 1, answers[0]) == SCARP_OK &&
              scarp_recipe_answers(&copy, 1, answers[1]) == SCARP_OK &&
              memcmp(answers[0], answers[1], sizeof answers[0]) == 0,
          "answers differ");
}

/* A number that is an output stays one where fields behind it use it. */
static void check_numbers(void)
{
    float value[2] = {0.0f, 0.0f};
    const double place = 1.0;
    const struct scarp_samples out[2] = {{.value = &value[0]}, {.value = &value[1]}};
    const struct scarp_recipe_outputs outputs = {.out = out, .count = 2};
    CHECK(parse("recipe 1\nout a = 5\nout b = turn(a * noise(), 30)", &recipe) == SCARP_OK,
          "parse");
    for (int i = 0; i < 2; i++) {
        CHECK(scarp_recipe_sample_f64(&recipe, 1, &place, &place, NULL, &outputs, NULL) ==
                      SCARP_OK &&
                  value[0] == (i == 0 ? 5.0f : 15.0f) &&
                  recipe_entry(&recipe, 0).value == (double)value[0],
              "the number is %g", (double)value[0]);
        CHECK(scarp_recipe_scale(&recipe, 2.0, 3.0, NULL) == SCARP_OK, "scale");
    }
}

int main(void)
{
    check_texts();
    check_together();
    check_scaled_numbers();
    check_other_tile();
    check_bad_numbers(0);
    check_bad_numbers(1);
    check_bad_recipes();
    check_bad_texts();
    check_answers();
    check_numbers();
    return check_done();
}
