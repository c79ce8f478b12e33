/* SPDX-License-Identifier: MIT
 *
 * Any text is read, described, set and sampled without harm, and with the same bits by all kernel
 * sets, on grids and at points; and what shaders take of it fits together.
 */
#include "recipe.h"

#include <float.h>
#include <math.h>
#include <string.h>

#include "fuzz.h"
#include "recipes.h"
#include "scarp.h"

#define WIDTH 6
#define POINTS 24
#define ARRAYS 10
#define LENGTH_MOST 16384
#define SHADER_MOST (1 << 18)

struct recipe_counts recipe_counts;

static struct scarp_recipe recipe, copy;
static uint64_t memory[1 << 12];
static uint64_t plan[1 << 16]; /* of this recipe, or of one before */
static double position[3][POINTS];

struct values {
    float array[ARRAYS][POINTS];
};

/* Whether two are the same to the bit; NaN is NaN. */
static int is_same(const struct values *a, const struct values *b)
{
    for (int k = 0; k < ARRAYS; k++) {
        for (int i = 0; i < POINTS; i++) {
            const float x = a->array[k][i], y = b->array[k][i];
            if (memcmp(&x, &y, sizeof x) != 0 && !(isnan(x) && isnan(y))) {
                return 0;
            }
        }
    }
    return 1;
}

/* What is in outputs, scratch memory and on the stack before a call. Results must not depend on it.
 */
static int pattern = 0xff;

static __attribute__((noinline)) void fill_stack(void)
{
    volatile uint64_t words[2048];
    for (size_t i = 0; i < sizeof words / sizeof words[0]; i++) {
        words[i] = (uint64_t)pattern * UINT64_C(0x0101010101010101);
    }
}

/* Fills arrays that are asked for; the others are 0. */
static void fill_outputs(const struct scarp_samples *out, struct values *values)
{
    memset(values, 0, sizeof *values);
    for (int i = 0; i < ARRAYS; i++) {
        float *array;
        memcpy(&array, (const char *)out + (size_t)i * sizeof array, sizeof array);
        if (array != NULL) {
            memset(array, pattern, POINTS * sizeof *array);
        }
    }
}

/* Descriptions end, and have spans inside of the text. */
static void describe(size_t length)
{
    struct scarp_recipe_entry entry;
    struct scarp_recipe_part part;
    struct scarp_recipe_function function;
    for (size_t i = 0; scarp_recipe_entry_at(&recipe, i, &entry) == SCARP_OK; i++) {
        MUST(i < 96, "statements do not end");
        MUST(entry.span[0] <= entry.span[1] && entry.span[1] <= length, "statement %zu", i);
        MUST(entry.name[0] <= entry.name[1] && entry.name[1] <= length, "name %zu", i);
        MUST(entry.kind >= SCARP_RECIPE_BAD && entry.kind <= SCARP_RECIPE_KNOT, "kind %zu", i);
        MUST(!entry.is_param || entry.slider[0] <= entry.slider[1], "slider %zu", i);
        MUST(entry.part < 512 && entry.output < 16 && entry.order < 3 && entry.axes < 8,
             "numbers of statement %zu", i);
        MUST(entry.cell[0] >= entry.cell[1] && entry.cell[1] >= 0.0 && entry.cell[0] <= DBL_MAX &&
                 (entry.cell[0] > 0.0) == (entry.cell[1] > 0.0),
             "cells of statement %zu from %g to %g", i, entry.cell[0], entry.cell[1]);
        MUST(entry.jumps <= 1 && (entry.dimensions == 2 || entry.dimensions == 3) &&
                 entry.spare[0] == 0 && entry.spare[1] == 0,
             "answers of statement %zu", i);
    }
    for (size_t i = 0; scarp_recipe_part_at(&recipe, i, &part) == SCARP_OK; i++) {
        MUST(i < 512, "parts do not end");
        MUST(part.span[0] <= part.span[1] && part.span[1] <= length, "part %zu", i);
        MUST(part.name[0] <= part.name[1] && part.name[1] <= length, "name of part %zu", i);
        MUST(part.argument[0] <= part.argument[1] && part.argument[1] <= length,
             "argument of part %zu", i);
        MUST(part.parent < 512 && part.entry < 96 && part.order < 3 && part.axes < 8,
             "numbers of part %zu", i);
        MUST(part.function < 0 ||
                 scarp_recipe_function_at((size_t)part.function, &function) == SCARP_OK,
             "function of part %zu", i);
    }
}

static int is_space(void)
{
    float value;
    const double place = 0.0;
    const struct scarp_samples out = {.dz = &value};
    const struct scarp_recipe_outputs outputs = {.out = &out, .count = 1};
    return scarp_recipe_sample_f64(&recipe, 1, &place, &place, &place, &outputs, NULL) == SCARP_OK;
}

/* The grid of an input; its coordinates, some of which the input may replace */
static struct scarp_grid place(const uint8_t header[HEADER_SIZE], int has_slices)
{
    static const double steps[] = {1e7, -0.3, 0.01, 1e36};
    static const double odd[] = {NAN,  INFINITY, -INFINITY, 1e300,
                                 -0.0, 1e-310,   -3e38,     9007199254740993.0};
    const double step = steps[header[HEADER_STEP] & 3];
    const int rows = has_slices ? 2 : POINTS / WIDTH, slices = POINTS / WIDTH / rows;
    const struct scarp_grid grid = {.origin = {header[HEADER_PLACE], -7.5, 0.25},
                                    .step = {step, step, step},
                                    .count = {WIDTH, (size_t)rows, (size_t)slices}};
    for (int i = 0; i < POINTS; i++) {
        position[0][i] = grid.origin[0] + (double)(i % WIDTH) * step;
        position[1][i] = grid.origin[1] + (double)(i / WIDTH % rows) * step;
        position[2][i] = grid.origin[2] + (double)(i / WIDTH / rows) * step;
    }
    for (int i = 0; header[HEADER_STEP] >= 128 && i < 8; i++) {
        position[i % 3][3 * i] = odd[i];
    }
    return grid;
}

/* What sampling takes besides the recipe */
struct sampling {
    struct scarp_recipe_outputs outputs;
    struct scarp_scratch scratch;
    int32_t which[1];
    int order, is_space;
};

/* Makes the plan of the recipe, or leaves that of another input where it is. */
static void make_plan(void)
{
    const size_t size = scarp_recipe_plan_size(&recipe);
    const enum scarp_status status = scarp_recipe_plan_make(&recipe, plan, sizeof plan);
    MUST(status == (size == 0             ? SCARP_ERROR_PARAMETER
                    : size <= sizeof plan ? SCARP_OK
                                          : SCARP_ERROR_SIZE),
         "a plan of %zu bytes: %d", size, (int)status);
}

static struct sampling sampling_of(const uint8_t header[HEADER_SIZE])
{
    const uint8_t which = header[HEADER_WHICH];
    struct sampling sampling = {.order = header[HEADER_ORDER] % 3, .is_space = is_space()};
    sampling.outputs.count = 1;
    sampling.which[0] = which < 128 ? which % 12 : SCARP_RECIPE_PARTS + which % 64;
    sampling.scratch.size = sizeof memory - header[HEADER_PLACE];
    sampling.scratch.memory = header[HEADER_ORDER] < 128 ? memory : NULL;
    sampling.scratch.plan = header[HEADER_ORDER] / 32 % 2 == 0 ? plan : NULL;
    if (header[HEADER_ORDER] / 16 % 2 == 0) {
        make_plan();
    }
    return sampling;
}

/* Samples at the points, or on a grid. On an error nothing is written. Each call finds another
   pattern than the one before. */
static enum scarp_status sample(const struct scarp_recipe *of, struct sampling *sampling,
                                const uint8_t header[HEADER_SIZE], const struct scarp_grid *grid,
                                struct values *values)
{
    const struct scarp_samples out =
        recipe_samples(values->array[0], POINTS, sampling->order, sampling->is_space);
    static struct values before;
    pattern = pattern == 0xff ? 0x42 : 0xff; /* NaNs, and 48.56 */
    fill_outputs(&out, values);
    memcpy(&before, values, sizeof before);
    memset(memory, pattern, sizeof memory);
    fill_stack();
    sampling->outputs.out = &out;
    sampling->outputs.which = header[HEADER_WHICH] == 0 ? NULL : sampling->which;
    const enum scarp_status status =
        grid != NULL ? scarp_recipe_grid(of, grid, &sampling->outputs, &sampling->scratch)
                     : scarp_recipe_sample_f64(of, POINTS, position[0], position[1], position[2],
                                               &sampling->outputs, &sampling->scratch);
    MUST(status == SCARP_OK || memcmp(values, &before, sizeof before) == 0,
         "an error, and something is written");
    return status;
}

static void check_range(const struct sampling *sampling, const struct values *values,
                        const struct scarp_box *box)
{
    const int32_t which =
        sampling->outputs.which != NULL ? sampling->which[0] : SCARP_RECIPE_OUTPUT;
    float lowest, highest;
    MUST(scarp_recipe_range(&recipe, which, box, &lowest, &highest) == SCARP_OK,
         "what was sampled has no range");
    for (int i = 0; i < POINTS; i++) {
        const float value = values->array[0][i];
        MUST(isnan(value) || (value >= lowest && value <= highest), "%.9g at %d, not in %.9g..%.9g",
             (double)value, i, (double)lowest, (double)highest);
    }
}

/* Whatever the kernel set, the bits are those of the reference. */
static void check_sets(struct sampling *sampling, const uint8_t header[HEADER_SIZE],
                       const struct scarp_grid *grid)
{
    static struct values reference, met;
    const enum scarp_isa before = scarp_isa_active();
    scarp_isa_select(SCARP_ISA_SCALAR);
    const void *const with = sampling->scratch.plan;
    sampling->scratch.plan = NULL;
    const enum scarp_status status = sample(&recipe, sampling, header, NULL, &reference);
    sampling->scratch.plan = with;
    const enum scarp_status again = sample(&recipe, sampling, header, NULL, &met);
    MUST(again == status && (status != SCARP_OK || is_same(&reference, &met)),
         "it depends on what was in memory");
    for (enum scarp_isa isa = SCARP_ISA_SCALAR; scarp_isa_name(isa) != NULL; isa++) {
        if (scarp_isa_select(isa) != SCARP_OK) {
            continue;
        }
        MUST(sample(&recipe, sampling, header, NULL, &met) == status, "%s has another status",
             scarp_isa_name(isa));
        MUST(status != SCARP_OK || is_same(&reference, &met), "%s differs", scarp_isa_name(isa));
        if (grid != NULL && sample(&copy, sampling, header, grid, &met) == SCARP_OK) {
            MUST(status != SCARP_OK || is_same(&reference, &met), "%s differs on a grid",
                 scarp_isa_name(isa));
        }
    }
    scarp_isa_select(before);
    if (status == SCARP_OK) {
        recipe_counts.sampled++;
        check_range(sampling, &reference, NULL);
    }
}

/* Samples a statement or a part, or the outputs. */
static void check_samples(const uint8_t header[HEADER_SIZE])
{
    struct sampling sampling = sampling_of(header);
    const struct scarp_grid grid = place(header, sampling.is_space);
    memcpy(&copy, &recipe, sizeof copy);
    check_sets(&sampling, header, header[HEADER_STEP] < 128 ? &grid : NULL);
    if (header[HEADER_STEP] < 128) {
        struct values values;
        struct scarp_box box;
        for (int d = 0; d < 3; d++) {
            const double a = position[d][0], b = position[d][POINTS - 1];
            box.lowest[d] = a < b ? a : b;
            box.highest[d] = a < b ? b : a;
        }
        if (sample(&recipe, &sampling, header, NULL, &values) == SCARP_OK) {
            check_range(&sampling, &values, &box);
        }
    }
}

/* The text of scarp.glsl, scarp.hlsl or scarp.wgsl */
static const char *shader_file(enum scarp_language language, size_t *length)
{
    static const char *const paths[] = {SCARP_INCLUDE "/scarp.glsl", SCARP_INCLUDE "/scarp.hlsl",
                                        SCARP_INCLUDE "/scarp.wgsl"};
    static char text[3][SHADER_MOST];
    static size_t lengths[3];
    if (lengths[language] == 0) {
        FILE *const file = fopen(paths[language], "rb");
        MUST(file != NULL, "%s cannot be read", paths[language]);
        lengths[language] = fread(text[language], 1, SHADER_MOST, file);
        fclose(file);
    }
    *length = lengths[language];
    return text[language];
}

static uint8_t uniforms[1 << 17], uniforms_again[1 << 17];

/* The room that a shader says it needs is the room that it takes. */
static void check_shader(const uint8_t header[HEADER_SIZE])
{
    static char text[SHADER_MOST];
    const unsigned choice = header[HEADER_SHADER];
    struct scarp_shader how = {.language = (int32_t)(choice >> 1) % 3,
                               .order = (int32_t)(choice >> 1) / 3 % 3};
    size_t length = 0, again = 0, size = 0;
    how.file = shader_file((enum scarp_language)how.language, &how.length);
    const enum scarp_status status = scarp_recipe_shader(&recipe, &how, text, sizeof text, &length);
    if (status != SCARP_OK) {
        return;
    }
    MUST(length < sizeof text && text[length] == '\0' && memchr(text, '\0', length) == NULL,
         "%zu bytes of a shader", length);
    char *const room = malloc(length + 1);
    MUST(room != NULL, "no memory");
    MUST(scarp_recipe_shader(&copy, &how, room, length + 1, &again) == SCARP_OK &&
             again == length && memcmp(room, text, length + 1) == 0,
         "another shader of %zu bytes, in place of %zu", again, length);
    MUST(scarp_recipe_shader(&copy, &how, room, length, &again) == SCARP_ERROR_SIZE,
         "a shader has less room than it needs");
    free(room);
    memset(uniforms, 0x42, sizeof uniforms);
    memset(uniforms_again, 0xff, sizeof uniforms_again);
    MUST(scarp_recipe_uniforms(&recipe, uniforms, sizeof uniforms, &size) == SCARP_OK &&
             size % 16 == 0,
         "%zu bytes of uniforms", size);
    MUST(scarp_recipe_uniforms(&recipe, uniforms_again, size, &again) == SCARP_OK &&
             again == size && memcmp(uniforms, uniforms_again, size) == 0,
         "uniforms depend on what was in memory");
    MUST(scarp_recipe_uniforms(&recipe, uniforms, size - 1, &again) == SCARP_ERROR_SIZE &&
             again == size,
         "uniforms have less room than they need");
}

/* Shaders are compared with these, so they must not depend on the kernel set. */
static void check_answers(const uint8_t header[HEADER_SIZE])
{
    static uint32_t answers[2][SCARP_GPU_ANSWERS];
    memset(answers[0], 0x42, sizeof answers[0]);
    memset(answers[1], 0xff, sizeof answers[1]);
    const enum scarp_isa before = scarp_isa_active();
    const int order = header[HEADER_ORDER] % 3;
    scarp_isa_select(SCARP_ISA_SCALAR);
    const enum scarp_status status = scarp_recipe_answers(&recipe, order, answers[0]);
    scarp_isa_select(before);
    MUST(scarp_recipe_answers(&recipe, order, answers[1]) == status, "another status of answers");
    MUST(status != SCARP_OK || memcmp(answers[0], answers[1], sizeof answers[0]) == 0,
         "answers differ");
}

/* Sets a parameter. If that is refused, the old value stays. */
static void set(size_t number, const char *text, const uint8_t header[HEADER_SIZE])
{
    struct scarp_recipe_entry entry, after;
    struct scarp_recipe_error error;
    char name[64] = "finest";
    MUST(scarp_recipe_entry_at(&recipe, number, &entry) == SCARP_OK, "statement %zu", number);
    const size_t length = entry.name[1] - entry.name[0];
    const int is_param = entry.is_param && length < sizeof name;
    double value = header[HEADER_SETTING] / 16.0;
    if (is_param) {
        memcpy(name, text + entry.name[0], length);
        name[length] = '\0';
        const double share = (header[HEADER_SETTING] & 127) / 127.0;
        value = entry.slider[0] * (1.0 - share) + entry.slider[1] * share;
        value = header[HEADER_SETTING] < 128 ? value : (header[HEADER_SETTING] - 192) / 4.0;
    }
    const enum scarp_status status = scarp_recipe_set(&recipe, name, value, &error);
    MUST(scarp_recipe_entry_at(&recipe, number, &after) == SCARP_OK, "statement %zu", number);
    MUST(status == SCARP_OK || entry.value == after.value ||
             (isnan(entry.value) && isnan(after.value)),
         "%s is %g after an error, and was %g", name, after.value, entry.value);
    MUST(status != SCARP_OK || !is_param || after.value == value, "%s is %g and not %g", name,
         after.value, value);
}

static void check_settings(const char *text, const uint8_t header[HEADER_SIZE])
{
    struct scarp_recipe_entry entry;
    int settings = 0;
    for (size_t i = 0; scarp_recipe_entry_at(&recipe, i, &entry) == SCARP_OK && settings < 3; i++) {
        if (entry.is_param || i == 0) {
            settings++;
            set(i, text, header);
            (void)scarp_recipe_seed(&recipe, header[HEADER_PLACE]);
            check_samples(header);
        }
    }
}

/* The hashes of all statements */
static uint64_t hash_of_all(void)
{
    struct scarp_recipe_entry entry;
    uint64_t hash = 0;
    for (size_t i = 0; scarp_recipe_entry_at(&recipe, i, &entry) == SCARP_OK; i++) {
        hash = hash * 31 + entry.hash;
    }
    return hash;
}

/* Cells grow with a scale, and with an error all stays as it was. */
static void check_changes(size_t length, const uint8_t header[HEADER_SIZE])
{
    static const double sides[] = {0.0, 8.0, 12.0, 1.5, 0.25, 1e9, NAN, -1.0};
    static const double factors[] = {2.0, 0x1p-40, 0x1p40, 0.1, 3.7, 1.0, 0.0, INFINITY};
    const double side = sides[header[HEADER_STEP] & 7], by = factors[header[HEADER_SETTING] & 7];
    struct scarp_recipe_error error = {.text = NULL};
    struct scarp_recipe_entry before, after;
    const uint64_t hash = hash_of_all();
    (void)scarp_recipe_entry_at(&recipe, 0, &before);
    if (scarp_recipe_scale(&recipe, by, factors[header[HEADER_PLACE] & 7], &error) != SCARP_OK) {
        MUST(hash_of_all() == hash, "another recipe after an error of scale");
    } else if (before.cell[0] > 1e-9 && before.cell[0] < 1e9) {
        (void)scarp_recipe_entry_at(&recipe, 0, &after);
        MUST(fabs(after.cell[0] / before.cell[0] / by - 1.0) < 1e-5, "a cell of %g, and not %g",
             after.cell[0], by * before.cell[0]);
    }
    const uint64_t scaled = hash_of_all();
    const double other = header[HEADER_ORDER] < 64 ? 4.0 : side;
    if (scarp_recipe_tile(&recipe, side, other, side, &error) != SCARP_OK) {
        MUST(hash_of_all() == scaled, "another recipe after an error of tile");
    }
    MUST(error.text == NULL || (error.from <= error.to && error.to <= length),
         "the span of an error");
    (void)scarp_recipe_seed(&recipe, header[HEADER_WHICH]);
    check_samples(header);
}

static enum scarp_status parse(const char *text, size_t length)
{
    struct scarp_recipe_error errors[3];
    size_t found = 0;
    recipe_counts.parsed++;
    const enum scarp_status status = scarp_recipe_parse(text, length, &recipe, errors, 3, &found);
    const int is_long = length > LENGTH_MOST;
    MUST(is_long ? status == SCARP_ERROR_SIZE && found == 0 : (status == SCARP_OK) == (found == 0),
         "%zu errors, and %s", found, scarp_status_text(status));
    for (size_t i = 0; i < found && i < 3; i++) {
        MUST(errors[i].from <= errors[i].to && errors[i].to <= length && errors[i].text != NULL &&
                 errors[i].line > 0 && errors[i].column > 0,
             "the span of error %zu", i);
    }
    return status;
}

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t size)
{
    if (size < HEADER_SIZE) {
        return 0;
    }
    const size_t length = size - HEADER_SIZE;
    char *const text = malloc(length > 0 ? length : 1); /* without a 0 behind it */
    MUST(text != NULL, "no memory");
    memcpy(text, bytes + HEADER_SIZE, length);
    const enum scarp_status status = parse(text, length);
    if (length <= LENGTH_MOST) {
        describe(length);
        check_samples(bytes);
    }
    if (status == SCARP_OK) {
        recipe_counts.read_well++;
        if ((bytes[HEADER_SHADER] & 1) != 0) {
            check_shader(bytes);
            if (bytes[HEADER_SHADER] >= 192 && length < 200) { /* 4096 points of all noises */
                check_answers(bytes);
            }
        }
        check_settings(text, bytes);
        check_changes(length, bytes);
        describe(length);
    }
    free(text);
    return 0;
}
