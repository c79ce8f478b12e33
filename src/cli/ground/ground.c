/* SPDX-License-Identifier: MIT
 *
 * Reads the recipe of a terrain, with a tile and a scale written into its text, and samples it.
 */
#include "ground/ground.h"

#include <float.h>
#include <math.h>
#include <string.h>

#include "shared/bounds.h"

#define TEXT_MOST 16384
#define NAME_MOST 100
/* Bytes of the lines that are added to a text */
#define ADDED_MOST (160 + (1 + GROUND_FIELDS_MOST) * (NAME_MOST + 100))
#define SCRATCH_SIZE (256 << 10) /* about 1,000 points of a large recipe */

/* What the names of statements begin with that are added to a text for its scale */
#define SCALED "scarp_scaled_"

/* A text with lines added */
struct edited {
    char bytes[TEXT_MOST + ADDED_MOST];
    size_t length;
    size_t at, added; /* behind the first line, so many bytes were put in */
};

static enum ground_problem fail(enum ground_problem problem, const char *text,
                                struct scarp_recipe_error *error)
{
    *error = (struct scarp_recipe_error){.text = text};
    return problem;
}

static void put(struct edited *text, const char *bytes, size_t length)
{
    memcpy(text->bytes + text->length, bytes, length);
    text->length += length;
}

static void put_words(struct edited *text, const char *words)
{
    put(text, words, strlen(words));
}

/* Where the line `recipe 1` ends, which comments may stand before; the length if there is no other
   line */
static size_t end_of_version(const char *text, size_t length)
{
    size_t at = 0;
    while (at < length) {
        const char *const newline = memchr(text + at, '\n', length - at);
        const size_t end = newline != NULL ? (size_t)(newline - text) + 1 : length;
        while (at < end && (text[at] == ' ' || text[at] == '\t' || text[at] == '\r')) {
            at++;
        }
        if (at < end && text[at] != '#' && text[at] != '\n') {
            return end;
        }
        at = end;
    }
    return length;
}

/* Copies the text, with a setting behind its version if the terrain has a tile. */
static void edit(const struct ground_source *source, struct edited *text)
{
    text->length = 0;
    text->at = end_of_version(source->text, source->length);
    put(text, source->text, text->at);
    text->added = text->length;
    if (source->tile != NULL) {
        put_words(text, "tile ");
        put_words(text, source->tile);
        put_words(text, "\n");
    }
    text->added = text->length - text->added;
    put(text, source->text + text->at, source->length - text->at);
}

/* Tells where an error is in the text as it was. */
static void restore(const struct edited *text, struct scarp_recipe_error *error)
{
    if (text->added > 0 && error->from >= text->at + text->added) {
        error->from -= text->added;
        error->to -= text->added;
        error->line--;
    } else if (text->added > 0 && error->from >= text->at) {
        error->from = error->to = text->at;
    }
}

/* The first output of a recipe, or its last statement without any */
static bool find_height(const struct scarp_recipe *recipe, int32_t *number,
                        struct scarp_recipe_entry *entry)
{
    struct scarp_recipe_entry each;
    bool is_output = false;
    *number = -1;
    for (size_t i = 0; scarp_recipe_entry_at(recipe, i, &each) == SCARP_OK && !is_output; i++) {
        is_output = each.output == 0;
        if (!each.is_param && (is_output || each.output < 0)) {
            *number = (int32_t)i;
            *entry = each;
        }
    }
    return *number >= 0;
}

static bool is_text(const char *text, const uint32_t span[2], const char *word)
{
    return span[1] - span[0] == strlen(word) && memcmp(text + span[0], word, strlen(word)) == 0;
}

/* Adds a statement, whose number begins with `letter`, that is another one at larger places, and
   larger if `grows`. */
static bool add_scale(struct edited *text, const struct scarp_recipe_entry *entry,
                      const char *scale, char letter, bool grows)
{
    const size_t length = entry->name[1] - entry->name[0];
    char name[NAME_MOST];
    if (length > sizeof name) {
        return false;
    }
    memcpy(name, text->bytes + entry->name[0], length);
    put_words(text, "\n" SCALED);
    put(text, &letter, 1);
    put_words(text, " = ");
    if (grows) {
        put_words(text, scale);
        put_words(text, " * ");
    }
    put_words(text, "scale(");
    put(text, name, length);
    put_words(text, ", ");
    put_words(text, scale);
    put_words(text, ")\n");
    return true;
}

/* The parameter `name`. False if there is none. */
static bool find_parameter(const struct scarp_recipe *recipe, const char *text, const char *name,
                           struct scarp_recipe_entry *entry)
{
    for (size_t i = 0; scarp_recipe_entry_at(recipe, i, entry) == SCARP_OK; i++) {
        if (entry->is_param && is_text(text, entry->name, name)) {
            return true;
        }
    }
    return false;
}

/* The members of a noise in a text that its cells and its jumps depend on */
struct call {
    double frequency, octaves;
    bool is_value, is_edge, is_creased, has_slopes, is_erosion;
};

static void read_word(const char *text, const uint32_t span[2], struct call *call)
{
    call->is_value |= is_text(text, span, "cell_value");
    call->is_edge |= is_text(text, span, "cell_edge");
    call->is_creased |= is_text(text, span, "cell_f1") || is_text(text, span, "cell_f2") ||
                        is_text(text, span, "cell_edge");
    call->is_erosion |= is_text(text, span, "erosion");
    call->has_slopes |= is_text(text, span, "erosion") || is_text(text, span, "swiss") ||
                        is_text(text, span, "jordan");
}

static struct call read_call(const struct scarp_recipe *recipe, const char *text, int32_t number)
{
    struct scarp_recipe_part part;
    struct call call = {.frequency = 1.0, .octaves = 1.0};
    for (size_t i = (size_t)number + 1; scarp_recipe_part_at(recipe, i, &part) == SCARP_OK; i++) {
        if (part.parent != number) {
            continue;
        }
        if (is_text(text, part.argument, "size")) {
            call.frequency = 1.0 / part.value;
        } else if (is_text(text, part.argument, "frequency")) {
            call.frequency = part.value;
        } else if (is_text(text, part.argument, "octaves")) {
            call.octaves = part.value;
        } else if (part.kind == SCARP_RECIPE_WORD) {
            read_word(text, part.span, &call);
        }
    }
    return call;
}

/* The points where one octave of cell_f1 jumps are not looked at. */
static bool call_jumps(const struct call *call)
{
    return call->is_value || (call->is_creased && call->has_slopes && call->octaves > 1.0) ||
           (call->is_edge && call->is_erosion);
}

/* Finds the largest cells, and whether something jumps, from the calls of the text. */
static void look_at_calls(struct ground *ground, const char *text, double scale)
{
    struct scarp_recipe_part part;
    double lowest = INFINITY;
    ground->jumps = false;
    for (size_t i = 0; scarp_recipe_part_at(&ground->recipe, i, &part) == SCARP_OK; i++) {
        if (part.function < 0) {
            continue;
        }
        const bool is_noise = is_text(text, part.name, "noise");
        const struct call call = read_call(&ground->recipe, text, (int32_t)i);
        if (is_noise && call.frequency < lowest) {
            lowest = call.frequency;
        }
        ground->jumps |= (is_noise && call_jumps(&call)) || is_text(text, part.name, "cell");
    }
    ground->cell = (lowest < INFINITY ? 1.0 / lowest : 1.0) * scale;
}

/* Finds the range, and the level of the sea within it. False if there is no bound. */
static bool set_range(struct ground *ground, const char *text, double scale)
{
    struct scarp_recipe_entry sea;
    if (scarp_recipe_range(&ground->recipe, ground->height, NULL, &ground->lowest,
                           &ground->highest) != SCARP_OK ||
        !(ground->highest - ground->lowest <= FLT_MAX)) {
        ground->floor = ground->lowest = -INFINITY;
        return false;
    }
    ground->floor = ground->lowest;
    if (find_parameter(&ground->recipe, text, "sea", &sea)) {
        ground->floor = within((float)(sea.value * scale), ground->lowest, ground->highest);
    }
    return true;
}

#define ERRORS_MOST 16

/* Of errors in what has to repeat, one that no other size mends comes first. */
static enum ground_problem parse(struct ground *ground, const struct edited *text,
                                 struct scarp_recipe_error *error)
{
    struct scarp_recipe_error errors[ERRORS_MOST];
    size_t count = 0, chosen = 0;
    if (scarp_recipe_parse(text->bytes, text->length, &ground->recipe, errors, ERRORS_MOST,
                           &count) == SCARP_OK) {
        return GROUND_FINE;
    }
    count = count < ERRORS_MOST ? count : ERRORS_MOST;
    while (chosen < count && errors[chosen].nearest != 0.0) {
        chosen++;
    }
    *error = count == 0
                 ? (struct scarp_recipe_error){.text = "the text is longer than 16,384 bytes"}
                 : errors[chosen < count ? chosen : 0];
    restore(text, error);
    return GROUND_BAD_TEXT;
}

static double scale_of(const struct ground_source *source)
{
    return source->scale != 0.0 ? source->scale : 1.0;
}

/* Finds the height. */
static enum ground_problem set_height(struct ground *ground, const struct ground_source *source,
                                      struct scarp_recipe_error *error)
{
    struct scarp_recipe_entry height = {.kind = SCARP_RECIPE_BAD};
    if (!find_height(&ground->recipe, &ground->height, &height) ||
        (height.kind != SCARP_RECIPE_FIELD && height.kind != SCARP_RECIPE_NOISE)) {
        return fail(GROUND_BAD_TERRAIN, "there is no height that depends on the place", error);
    }
    if ((height.axes & 4) != 0 && !source->is_any) {
        return fail(GROUND_BAD_TERRAIN, "the height depends on z, and a terrain is of the plane",
                    error);
    }
    return GROUND_FINE;
}

/* The number of the output of that name; -1 if there is none */
static int32_t find_output(const struct scarp_recipe *recipe, const char *text, const char *name,
                           struct scarp_recipe_entry *entry)
{
    for (size_t i = 0; scarp_recipe_entry_at(recipe, i, entry) == SCARP_OK; i++) {
        if (entry->output >= 0 && is_text(text, entry->name, name)) {
            return (int32_t)i;
        }
    }
    return -1;
}

/* Finds the other outputs that are asked for. */
static enum ground_problem set_fields(struct ground *ground, const struct ground_source *source,
                                      const char *text, struct scarp_recipe_error *error)
{
    struct scarp_recipe_entry entry;
    ground->field_count = source->field_count;
    for (size_t i = 0; i < source->field_count; i++) {
        const int32_t number = find_output(&ground->recipe, text, source->fields[i], &entry);
        const char *const reason =
            number < 0 ? NULL
            : entry.kind != SCARP_RECIPE_FIELD && entry.kind != SCARP_RECIPE_NOISE
                ? "does not depend on the place"
            : (entry.axes & 4) != 0 ? "depends on z, and a terrain is of the plane"
                                    : "";
        if (reason == NULL || reason[0] != '\0') {
            *error = (struct scarp_recipe_error){.text = reason, .from = i, .to = i};
            return GROUND_BAD_FIELD;
        }
        ground->fields[i].statement = number;
    }
    return GROUND_FINE;
}

/* Scales the height and the other outputs: each becomes a statement at the end of the text. */
static enum ground_problem scale_all(struct ground *ground, const struct ground_source *source,
                                     struct edited *text, struct scarp_recipe_error *error)
{
    const int32_t height = ground->height;
    struct scarp_recipe_entry entry;
    int32_t next = 0;
    while (scarp_recipe_entry_at(&ground->recipe, (size_t)next, &entry) == SCARP_OK) {
        next++;
    }
    (void)scarp_recipe_entry_at(&ground->recipe, (size_t)height, &entry);
    bool is_added = add_scale(text, &entry, source->digits, 'a', true);
    ground->height = next++;
    for (size_t i = 0; i < ground->field_count && is_added; i++) {
        int32_t *const statement = &ground->fields[i].statement;
        const bool is_height = *statement == height;
        (void)scarp_recipe_entry_at(&ground->recipe, (size_t)*statement, &entry);
        is_added = is_height || add_scale(text, &entry, source->digits, (char)('b' + i), false);
        *statement = is_height ? ground->height : next++;
    }
    return is_added
               ? parse(ground, text, error)
               : fail(GROUND_BAD_TERRAIN, "the name of an output is too long to be scaled", error);
}

static void set_field_ranges(struct ground *ground)
{
    for (size_t i = 0; i < ground->field_count; i++) {
        struct ground_field *const field = &ground->fields[i];
        if (scarp_recipe_range(&ground->recipe, field->statement, NULL, &field->lowest,
                               &field->highest) != SCARP_OK) {
            field->lowest = -INFINITY;
            field->highest = INFINITY;
        }
    }
}

static enum ground_problem set_values(struct ground *ground, const struct ground_source *source,
                                      const char *text, struct scarp_recipe_error *error)
{
    for (size_t i = 0; i < source->count; i++) {
        struct scarp_recipe_entry entry;
        const struct ground_value *const set = &source->values[i];
        enum ground_problem problem = GROUND_FINE;
        *error = (struct scarp_recipe_error){.text = NULL};
        if (!find_parameter(&ground->recipe, text, set->name, &entry)) {
            problem = GROUND_BAD_NAME;
        } else if (scarp_recipe_set(&ground->recipe, set->name, set->value, error) != SCARP_OK) {
            problem = GROUND_BAD_VALUE;
        }
        if (problem != GROUND_FINE) {
            error->from = error->to = i;
            return problem;
        }
    }
    return GROUND_FINE;
}

enum ground_problem ground_open(struct ground *ground, const struct ground_source *source,
                                struct scarp_recipe_error *error)
{
    struct edited text;
    const double scale = scale_of(source);
    if (source->length > TEXT_MOST) {
        return fail(GROUND_BAD_TEXT, "the text is longer than 16,384 bytes", error);
    }
    edit(source, &text);
    enum ground_problem problem = parse(ground, &text, error);
    if (problem == GROUND_FINE) {
        problem = set_height(ground, source, error);
    }
    if (problem == GROUND_FINE) {
        problem = set_fields(ground, source, text.bytes, error);
    }
    if (problem == GROUND_FINE && scale != 1.0) {
        problem = scale_all(ground, source, &text, error);
    }
    if (problem == GROUND_FINE) {
        problem = set_values(ground, source, text.bytes, error);
    }
    if (problem != GROUND_FINE) {
        return problem;
    }
    (void)scarp_recipe_seed(&ground->recipe, source->seed);
    look_at_calls(ground, text.bytes, scale);
    set_field_ranges(ground);
    return set_range(ground, text.bytes, scale) || source->is_any
               ? GROUND_FINE
               : fail(GROUND_BAD_TERRAIN, "heights have no bound, since they grow with x or y",
                      error);
}

void ground_limit(const struct ground *ground, double finest, struct ground *limited)
{
    *limited = *ground;
    (void)scarp_recipe_set(&limited->recipe, "finest", finest, NULL);
}

#if defined(__wasm__)
#define PER_THREAD static
#else
#define PER_THREAD static _Thread_local
#endif

const struct scarp_scratch *ground_scratch(void)
{
    PER_THREAD uint64_t memory[SCRATCH_SIZE / sizeof(uint64_t)];
    PER_THREAD struct scarp_scratch scratch;
    scratch.memory = memory;
    scratch.size = sizeof memory;
    return &scratch;
}

bool ground_dry_grid(const struct ground *ground, const struct scarp_grid *grid,
                     const struct scarp_samples *out)
{
    return ground_fields_grid(ground, grid, out, NULL);
}

bool ground_fields_grid(const struct ground *ground, const struct scarp_grid *grid,
                        const struct scarp_samples *out, float *const *fields)
{
    struct scarp_samples samples[1 + GROUND_FIELDS_MOST] = {*out};
    int32_t which[1 + GROUND_FIELDS_MOST] = {ground->height};
    const size_t count = fields != NULL ? ground->field_count : 0;
    for (size_t i = 0; i < count; i++) {
        samples[1 + i] = (struct scarp_samples){.value = fields[i]};
        which[1 + i] = ground->fields[i].statement;
    }
    const struct scarp_recipe_outputs outputs = {
        .out = samples, .which = which, .count = (int32_t)(1 + count)};
    return scarp_recipe_grid(&ground->recipe, grid, &outputs, ground_scratch()) == SCARP_OK;
}

bool ground_dry_points(const struct ground *ground, size_t count, const double *x, const double *y,
                       const struct scarp_samples *out)
{
    const struct scarp_recipe_outputs outputs = {.out = out, .which = &ground->height, .count = 1};
    return scarp_recipe_sample_f64(&ground->recipe, count, x, y, NULL, &outputs,
                                   ground_scratch()) == SCARP_OK;
}

bool ground_grid(const struct ground *ground, const struct scarp_grid *grid,
                 const struct scarp_samples *out)
{
    const bool is_done = ground_dry_grid(ground, grid, out);
    ground_cover(ground, grid->count[0] * grid->count[1], out);
    return is_done;
}

bool ground_points(const struct ground *ground, size_t count, const double *x, const double *y,
                   const struct scarp_samples *out)
{
    const bool is_done = ground_dry_points(ground, count, x, y, out);
    ground_cover(ground, count, out);
    return is_done;
}

void ground_cover(const struct ground *ground, size_t count, const struct scarp_samples *out)
{
    float *const derivatives[] = {out->dx, out->dy, out->dxx, out->dxy, out->dyy};
    if (!ground_has_sea(ground)) {
        return;
    }
    for (size_t i = 0; i < count; i++) {
        if (!(out->value[i] < ground->floor)) {
            continue;
        }
        out->value[i] = ground->floor;
        for (size_t d = 0; d < sizeof derivatives / sizeof derivatives[0]; d++) {
            if (derivatives[d] != NULL) {
                derivatives[d][i] = 0.0f;
            }
        }
    }
}

bool ground_is_space(const struct ground *ground)
{
    float value;
    const double origin = 0.0;
    const struct scarp_samples out = {.value = &value};
    const struct scarp_recipe_outputs outputs = {.out = &out, .which = &ground->height, .count = 1};
    return scarp_recipe_sample_f64(&ground->recipe, 1, &origin, &origin, NULL, &outputs,
                                   ground_scratch()) == SCARP_ERROR_NULL;
}
