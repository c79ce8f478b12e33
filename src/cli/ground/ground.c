/* SPDX-License-Identifier: MIT
 *
 * Reads the recipe of a terrain, gives it its tile and its scale, and samples it.
 */
#include "ground/ground.h"

#include <float.h>
#include <math.h>
#include <string.h>

#include "shared/bounds.h"

#define SCRATCH_SIZE (256 << 10) /* about 1,000 points of a large recipe */

static enum ground_problem fail(enum ground_problem problem, const char *text,
                                struct scarp_recipe_error *error)
{
    *error = (struct scarp_recipe_error){.text = text};
    return problem;
}

static bool is_text(const char *text, const uint32_t span[2], const char *word)
{
    return span[1] - span[0] == strlen(word) && memcmp(text + span[0], word, strlen(word)) == 0;
}

/* The number of the parameter, or else of the output, of that name; -1 if there is none */
static int32_t find(const struct scarp_recipe *recipe, const char *text, const char *name,
                    bool is_param, struct scarp_recipe_entry *entry)
{
    for (size_t i = 0; scarp_recipe_entry_at(recipe, i, entry) == SCARP_OK; i++) {
        if ((is_param ? entry->is_param != 0 : entry->output >= 0) &&
            is_text(text, entry->name, name)) {
            return (int32_t)i;
        }
    }
    return -1;
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
    if (find(&ground->recipe, text, "sea", true, &sea) >= 0) {
        ground->floor = within((float)(sea.value * scale), ground->lowest, ground->highest);
    }
    return true;
}

/* Reads the text, and gives it its scale and its tile. */
static enum ground_problem parse(struct ground *ground, const struct ground_source *source,
                                 struct scarp_recipe_error *error)
{
    const double *const tile = source->tile;
    *error = (struct scarp_recipe_error){.text = "the text is longer than 16,384 bytes"};
    enum scarp_status status =
        scarp_recipe_parse(source->text, source->length, &ground->recipe, error, 1, NULL);
    if (status == SCARP_OK && source->scale != 0.0) {
        status = scarp_recipe_scale(&ground->recipe, source->scale, source->scale, error);
    }
    if (status == SCARP_OK && tile[0] != 0.0) {
        status = scarp_recipe_tile(&ground->recipe, tile[0], tile[1], 0.0, error);
    }
    if (status != SCARP_OK && error->text == NULL) {
        error->text = "a number is too small or too large";
    }
    return status == SCARP_OK ? GROUND_FINE : GROUND_BAD_TEXT;
}

/* Finds the height, which is the first output. */
static enum ground_problem set_height(struct ground *ground, const struct ground_source *source,
                                      struct scarp_recipe_error *error)
{
    struct scarp_recipe_entry height;
    ground->height = 0;
    while (scarp_recipe_entry_at(&ground->recipe, (size_t)ground->height, &height) == SCARP_OK &&
           height.output != 0) {
        ground->height++;
    }
    if (height.kind != SCARP_RECIPE_FIELD && height.kind != SCARP_RECIPE_NOISE) {
        return fail(GROUND_BAD_TERRAIN, "there is no height that depends on the place", error);
    }
    if ((height.axes & 4) != 0 && !source->is_any) {
        return fail(GROUND_BAD_TERRAIN, "the height depends on z, and a terrain is of the plane",
                    error);
    }
    return GROUND_FINE;
}

/* Finds the other outputs that are asked for. */
static enum ground_problem set_fields(struct ground *ground, const struct ground_source *source,
                                      struct scarp_recipe_error *error)
{
    struct scarp_recipe_entry entry;
    ground->field_count = source->field_count;
    for (size_t i = 0; i < source->field_count; i++) {
        const int32_t number =
            find(&ground->recipe, source->text, source->fields[i], false, &entry);
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
                                      struct scarp_recipe_error *error)
{
    for (size_t i = 0; i < source->count; i++) {
        struct scarp_recipe_entry entry;
        const struct ground_value *const set = &source->values[i];
        enum ground_problem problem = GROUND_FINE;
        *error = (struct scarp_recipe_error){.text = NULL};
        if (find(&ground->recipe, source->text, set->name, true, &entry) < 0) {
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
    const double scale = source->scale != 0.0 ? source->scale : 1.0;
    struct scarp_recipe_entry height;
    enum ground_problem problem = parse(ground, source, error);
    if (problem == GROUND_FINE) {
        problem = set_height(ground, source, error);
    }
    if (problem == GROUND_FINE) {
        problem = set_fields(ground, source, error);
    }
    if (problem == GROUND_FINE) {
        problem = set_values(ground, source, error);
    }
    if (problem != GROUND_FINE) {
        return problem;
    }
    (void)scarp_recipe_seed(&ground->recipe, source->seed);
    (void)scarp_recipe_entry_at(&ground->recipe, (size_t)ground->height, &height);
    ground->cell = height.cell[0] > 0.0 ? height.cell[0] : scale;
    ground->jumps = height.jumps != 0;
    ground->is_space = height.dimensions == 3;
    set_field_ranges(ground);
    return set_range(ground, source->text, scale) || source->is_any
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
