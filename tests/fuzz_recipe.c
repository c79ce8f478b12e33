/* SPDX-License-Identifier: MIT
 *
 * Any text is read, described, set and sampled without harm: a target for libFuzzer, and, built
 * without it, a test that mutates texts by itself.
 *
 *     clang -g -O1 -fsanitize=fuzzer,address,undefined -DSCARP_LIBFUZZER -Iinclude \
 *         tests/fuzz_recipe.c libscarp.a -lm && ./a.out
 *     fuzz_recipe COUNT      as many mutated texts of recipes.h and random ones
 *
 * The first four bytes of an input say how a text is sampled, the rest is the text.
 */
#include "recipes.h"

#define POINTS 24
#define HEADER 4

static struct scarp_recipe recipe, copy;
static uint64_t memory[1 << 12];
static long parsed, read_well, sampled;

static void must(int condition, const char *what)
{
    if (!condition) {
        fprintf(stderr, "%s\n", what);
        abort();
    }
}

/* Descriptions end, and have spans inside of the text. */
static void describe(size_t length)
{
    struct scarp_recipe_entry entry;
    struct scarp_recipe_part part;
    float lowest, highest;
    for (size_t i = 0; scarp_recipe_entry_at(&recipe, i, &entry) == SCARP_OK; i++) {
        must(entry.span[0] <= entry.span[1] && entry.span[1] <= length, "the span of a statement");
        must(entry.name[0] <= entry.name[1] && entry.name[1] <= length, "the span of a name");
    }
    for (size_t i = 0; scarp_recipe_part_at(&recipe, i, &part) == SCARP_OK; i++) {
        must(part.span[0] <= part.span[1] && part.span[1] <= length, "the span of a part");
        must(part.parent < 512 && part.entry < 96 && part.function < 64, "numbers of a part");
    }
    (void)scarp_recipe_range(&recipe, SCARP_RECIPE_OUTPUT, NULL, &lowest, &highest);
}

/* Samples a statement or a part, or the outputs; grids and points agree, and values are in range.
 */
static void sample(const uint8_t header[HEADER])
{
    static double position[3][POINTS];
    static float value[POINTS], grid_value[POINTS], d[9][POINTS];
    const int32_t which[1] = {header[1] < 128 ? header[1] % 12
                                              : SCARP_RECIPE_PARTS + header[1] % 64};
    struct scarp_samples out = {.value = value}, out_of_grid = {.value = grid_value};
    struct scarp_recipe_outputs outputs = {
        .out = &out, .count = 1, .which = header[1] == 0 ? NULL : which};
    const struct scarp_scratch scratch = {.memory = memory, .size = sizeof memory - header[2]};
    const double step = (header[3] & 3) == 0 ? 1e7 : (header[3] & 3) == 1 ? -0.3 : 0.01;
    const struct scarp_grid grid = {
        .origin = {header[2], -7.5, 0.25}, .step = {step, step, step}, .count = {6, 4, 1}};
    for (int i = 0; i < POINTS; i++) {
        position[0][i] = grid.origin[0] + (double)(i % 6) * step;
        position[1][i] = grid.origin[1] + (double)(i / 6) * step;
        position[2][i] = grid.origin[2];
    }
    if (header[0] % 3 > 0) {
        out.dx = d[0];
        out.dy = d[1];
    }
    if (header[0] % 3 > 1) {
        out.dxx = d[2];
        out.dxy = d[3];
        out.dyy = d[4];
    }
    const enum scarp_status status =
        scarp_recipe_sample_f64(&recipe, POINTS, position[0], position[1], position[2], &outputs,
                                header[0] < 64 ? NULL : &scratch);
    memcpy(&copy, &recipe, sizeof copy);
    outputs.out = &out_of_grid;
    const enum scarp_status on_grid = scarp_recipe_grid(&copy, &grid, &outputs, &scratch);
    float lowest = 0.0f, highest = 0.0f;
    if (status != SCARP_OK || on_grid != SCARP_OK) {
        return;
    }
    sampled++;
    must(scarp_recipe_range(&recipe, outputs.which != NULL ? which[0] : SCARP_RECIPE_OUTPUT, NULL,
                            &lowest, &highest) == SCARP_OK,
         "the range of what was sampled");
    for (int i = 0; i < POINTS; i++) {
        must(memcmp(&value[i], &grid_value[i], sizeof value[i]) == 0 ||
                 (value[i] != value[i] && grid_value[i] != grid_value[i]),
             "a grid differs");
        must(value[i] != value[i] || (value[i] >= lowest && value[i] <= highest),
             "a value out of range");
    }
}

static void try_input(const uint8_t *bytes, size_t size)
{
    struct scarp_recipe_error errors[3];
    struct scarp_recipe_entry entry;
    size_t found = 0;
    if (size < HEADER) {
        return;
    }
    const char *const text = (const char *)bytes + HEADER;
    parsed++;
    const enum scarp_status status =
        scarp_recipe_parse(text, size - HEADER, &recipe, errors, 3, &found);
    must(found > 0 || status == SCARP_OK || size - HEADER > 16384, "an error that is not told");
    for (size_t i = 0; i < found && i < 3; i++) {
        must(errors[i].from <= errors[i].to && errors[i].to <= size - HEADER &&
                 errors[i].text != NULL && errors[i].line > 0 && errors[i].column > 0,
             "the span of an error");
    }
    if (size - HEADER > 16384) {
        return;
    }
    read_well += status == SCARP_OK;
    describe(size - HEADER);
    sample(bytes);
    for (size_t i = 0; status == SCARP_OK && scarp_recipe_entry_at(&recipe, i, &entry) == SCARP_OK;
         i++) {
        char name[64] = "finest";
        const size_t length = entry.name[1] - entry.name[0];
        if (entry.is_param && length < sizeof name) {
            memcpy(name, text + entry.name[0], length);
            name[length] = '\0';
        }
        (void)scarp_recipe_set(&recipe, name, (double)bytes[0] / 16.0, errors);
        (void)scarp_recipe_seed(&recipe, bytes[2]);
        sample(bytes);
    }
}

#ifdef SCARP_LIBFUZZER

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t size);
int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t size)
{
    try_input(bytes, size);
    return 0;
}

#else

/* Changes some bytes, words or lines of a text. */
static size_t mutate(struct recipe_writer *w, uint8_t *bytes, size_t size, size_t room)
{
    static const char *const words[] = {
        "noise(", "warp(",     "(",           ")",    ",",     "x",        "^3",     "^",  "-",
        " / ",    ": ",        "0",           "1e30", "flat(", "gullies(", "slope(", "\n", "out ",
        "param ", "space 3\n", "tile 4, 4\n", "#",    "at(",   "cell(",    "curve("};
    const uint32_t changes = recipe_draw(w, 4);
    for (uint32_t i = 0; i < changes; i++) {
        const size_t at = HEADER + recipe_draw(w, (uint32_t)(size - HEADER) + 1);
        const size_t cut =
            recipe_draw(w, 12) < size - at ? recipe_draw(w, 12) % (size - at + 1) : 0;
        const char *const word = words[recipe_draw(w, sizeof words / sizeof words[0])];
        const size_t length = recipe_draw(w, 2) == 0 ? strlen(word) : 0;
        if (size - cut + length > room) {
            continue;
        }
        memmove(bytes + at + length, bytes + at + cut, size - at - cut);
        memcpy(bytes + at, word, length);
        size += length - cut;
    }
    return size;
}

int main(int argc, char **argv)
{
    static struct recipe_writer w;
    static uint8_t bytes[17000];
    const int count = argc == 2 ? atoi(argv[1]) : 0;
    if (count < 1) {
        fprintf(stderr, "usage: fuzz_recipe COUNT\n");
        return EXIT_FAILURE;
    }
    for (int i = 0; i < count; i++) {
        const char *text = recipe_texts[(size_t)i % RECIPE_TEXTS].text;
        if (i % 3 == 0) {
            recipe_write(&w, (uint64_t)i, 0);
            text = w.text;
        }
        struct recipe_writer draw = {.state = (uint64_t)i};
        for (int k = 0; k < HEADER; k++) {
            bytes[k] = (uint8_t)recipe_draw(&draw, 256);
        }
        size_t size = HEADER + strlen(text);
        memcpy(bytes + HEADER, text, size - HEADER);
        size = mutate(&draw, bytes, size, sizeof bytes);
        try_input(bytes, size);
    }
    CHECK(parsed == count && read_well > count / 50 && sampled > count / 50,
          "%ld texts, %ld are right, %ld samples", parsed, read_well, sampled);
    printf("%ld texts, %ld are right, %ld samples\n", parsed, read_well, sampled);
    return check_done();
}

#endif
