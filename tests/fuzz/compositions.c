/* SPDX-License-Identifier: MIT
 *
 * Random recipes at points and on grids.
 */
#include "../outputs.h"
#include "../recipes.h"

#include "arguments.h"

/* Of what a call has without scratch memory, 7 KiB, this much is there for points on every machine:
   the rest depends on the size of pointers, and on where the stack lies. */
#define STACK_BYTES 5120

struct arguments {
    const struct scarp_recipe *recipe;
    const struct scarp_grid *grid; /* NULL: points */
    int doubles, outputs;
    const struct scarp_scratch *scratch;
    const float *f[3];
    const double *d[3];
};

static enum scarp_status make(const struct fuzz_call *call, size_t first, size_t count,
                              float *const pointers[FUZZ_OUTPUTS])
{
    const struct arguments *const a = call->arguments;
    struct scarp_samples out[3];
    for (int k = 0; k < 3; k++) {
        out[k] = *FUZZ_AS(scarp_samples, pointers + k * FUZZ_MEMBERS);
    }
    const struct scarp_recipe_outputs outputs = {.out = out, .count = a->outputs};
    return a->grid != NULL ? scarp_recipe_grid(a->recipe, a->grid, &outputs, a->scratch)
           : a->doubles
               ? scarp_recipe_sample_f64(a->recipe, count, a->d[0] + first, a->d[1] + first,
                                         a->d[2] + first, &outputs, a->scratch)
               : scarp_recipe_sample(a->recipe, count, a->f[0] + first, a->f[1] + first,
                                     a->f[2] + first, &outputs, a->scratch);
}

/* Output number k of the text: its statement. */
static struct scarp_recipe_entry entry_of(const struct scarp_recipe *recipe, int output)
{
    struct scarp_recipe_entry entry = {.output = -1};
    for (size_t i = 0; scarp_recipe_entry_at(recipe, i, &entry) == SCARP_OK; i++) {
        if (entry.output == output) {
            return entry;
        }
    }
    entry.output = -1;
    return entry;
}

static uint64_t draw_mask(struct draw *d, const struct arguments *a, int dimensions)
{
    uint64_t mask = 0;
    for (int k = 0; k < a->outputs; k++) {
        const int order = (int)entry_of(a->recipe, k).order;
        mask |= (uint64_t)(outputs_up_to(order, dimensions) & ((draw_bits(d, 2) | 1)))
                << (k * FUZZ_MEMBERS);
    }
    return mask;
}

/* How much scratch memory a recipe takes for 16 points of these outputs, the fewest that it gets.
 */
static size_t bytes_of_block(const struct scarp_recipe *recipe, uint64_t mask)
{
    int order = 0;
    for (int m = 0; m < FUZZ_OUTPUTS; m++) {
        const int of_output = m % FUZZ_MEMBERS < OUTPUTS ? output_kinds[m % FUZZ_MEMBERS].order : 0;
        order = (mask >> m & 1) != 0 && of_output > order ? of_output : order;
    }
    return scarp_recipe_scratch_size(recipe, order, 32) -
           scarp_recipe_scratch_size(recipe, order, 16);
}

static void check_values(const struct arguments *a, const struct fuzz_call *call)
{
    for (int k = 0; k < a->outputs; k++) {
        const struct scarp_recipe_entry entry = entry_of(a->recipe, k);
        for (size_t i = 0; i < call->count; i++) {
            const float value = fuzz_result[k * FUZZ_MEMBERS][i];
            fuzz_must(fuzz_is_nan(value) || (value >= entry.range[0] && value <= entry.range[1]));
        }
    }
}

static void check_grid(struct arguments *a, struct fuzz_call *call, const struct scarp_grid *grid)
{
    static struct fuzz_places places;
    fuzz_find_places(grid, &places);
    a->grid = NULL;
    a->doubles = 1;
    for (int axis = 0; axis < 3; axis++) {
        a->d[axis] = places.position[axis];
    }
    fuzz_check_places(call, &places);
}

/* A random text, whose words are mostly right, as a recipe with a seed of the world */
static enum scarp_status draw_recipe(struct draw *d, struct scarp_recipe *recipe, int *dimensions)
{
    static struct recipe_writer writer;
    const uint64_t number = draw_bits(d, 8);
    recipe_write(&writer, number, draw_rarely(d, 4));
    fuzz_case_noise = NULL;
    fuzz_case_text = writer.text;
    *dimensions = writer.is_space ? 3 : 2;
    enum scarp_status status =
        scarp_recipe_parse(writer.text, strlen(writer.text), recipe, NULL, 0, NULL);
    fuzz_note((uint64_t)status);
    if (status == SCARP_OK) {
        fuzz_must(scarp_recipe_seed(recipe, draw_bits(d, 2)) == SCARP_OK);
        if (draw_rarely(d, 4)) {
            scarp_recipe_set(recipe, "finest", draw_between(d, 0.0, 4.0), NULL);
        }
    }
    return status;
}

void fuzz_compositions(const uint8_t *bytes, size_t size)
{
    static struct scarp_recipe recipe;
    static struct fuzz_points points;
    static struct scarp_grid grid;
    static uint64_t memory[1 << 18];
    struct draw d = {bytes, size};
    int dimensions;
    if (draw_recipe(&d, &recipe, &dimensions) != SCARP_OK) {
        return;
    }
    const size_t chunk = 1 + draw_byte(&d);
    const struct scarp_scratch scratch = {.memory = memory,
                                          .size = scarp_recipe_scratch_size(&recipe, 2, chunk)};
    fuzz_must(scratch.size > 0 && scratch.size <= sizeof memory);
    struct arguments a = {.recipe = &recipe, .doubles = (int)draw_below(&d, 2)};
    a.scratch = &scratch;
    while (a.outputs < 3 && entry_of(&recipe, a.outputs).output >= 0) {
        a.outputs++;
    }
    fuzz_draw_points(&d, &points);
    fuzz_draw_grid(&d, dimensions, &grid);
    const int on_grid = draw_below(&d, 3) == 2;
    a.grid = on_grid ? &grid : NULL;
    for (int axis = 0; axis < 3; axis++) {
        a.f[axis] = points.f[axis];
        a.d[axis] = points.d[axis];
    }
    struct fuzz_call call = {.make = make,
                             .arguments = &a,
                             .count = on_grid ? FUZZ_ROOM : points.count,
                             .mask = draw_mask(&d, &a, dimensions),
                             .is_grid = on_grid};
    if (draw_below(&d, 2) == 0 && bytes_of_block(&recipe, call.mask) <= STACK_BYTES) {
        a.scratch = NULL;
    }
    const enum scarp_status status = fuzz_check(&d, &call);
    const int is_empty =
        on_grid ? grid.count[0] * grid.count[1] * grid.count[2] == 0 : points.count == 0;
    const int is_wrong = on_grid && scarp_grid_fault(&grid, dimensions, NULL) != NULL;
    fuzz_must(is_empty || (status == SCARP_OK) == !is_wrong);
    if (is_empty || status != SCARP_OK) {
        return;
    }
    if (on_grid) {
        check_grid(&a, &call, &grid);
    } else {
        check_values(&a, &call);
    }
}
