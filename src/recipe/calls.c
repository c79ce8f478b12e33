/* SPDX-License-Identifier: MIT
 *
 * The public functions of recipes that parse and sample; change.c has those that set, describe.c
 * those for editors.
 */
#include <string.h>

#include "../calls/grid.h"
#include "../calls/run.h"
#include "../dispatch/dispatch.h"
#include "../dispatch/fpmode.h"
#include "compile.h"
#include "evaluate.h"
#include "interval.h"
#include "plans.h"
#include "reader.h"
#include "schedule.h"

#define STACK_BYTES 7168 /* of scratch memory, if the caller has none */

static NOINLINE enum scarp_status parse(const char *text, size_t length,
                                        struct scarp_recipe *recipe, struct recipe_errors *errors)
{
    struct recipe *const r = scarpi_recipe_inside(recipe);
    memset(recipe, 0, sizeof *recipe);
    r->version = RECIPE_VERSION;
    r->scale[0] = r->scale[1] = 1.0;
    r->length = (int16_t)length;
    memcpy(r->text, text, length);
    scarpi_recipe_read(r, errors);
    scarpi_recipe_compile(r, errors);
    return errors->found == 0 ? SCARP_OK
           : errors->is_size  ? SCARP_ERROR_SIZE
                              : SCARP_ERROR_PARAMETER;
}

enum scarp_status scarp_recipe_parse(const char *text, size_t length, struct scarp_recipe *recipe,
                                     struct scarp_recipe_error *errors, size_t capacity,
                                     size_t *found)
{
    struct recipe_errors to = {.list = errors, .capacity = errors == NULL ? 0 : capacity};
    if (found != NULL) {
        *found = 0;
    }
    if (recipe == NULL || (text == NULL && length > 0)) {
        return SCARP_ERROR_NULL;
    }
    if (length > RECIPE_TEXT) {
        return SCARP_ERROR_SIZE;
    }
    if (scarpi_dispatch_refuses()) {
        return SCARP_ERROR_UNSUPPORTED;
    }
    const struct fpmode caller = fpmode_enter();
    const enum scarp_status status = parse(length > 0 ? text : "", length, recipe, &to);
    fpmode_leave(caller);
    if (found != NULL) {
        *found = to.found;
    }
    return status;
}

/* The node of an output that is named by number, or -1. */
static int node_of(const struct recipe *r, int32_t which)
{
    int e = -1;
    if (which >= SCARP_RECIPE_PARTS && which - SCARP_RECIPE_PARTS < r->expressions) {
        e = which - SCARP_RECIPE_PARTS;
    } else if (which >= 0 && which < r->statements) {
        e = r->statement[which].expression;
    }
    if (e < 0 || (r->expression[e].kind != SCARP_RECIPE_FIELD &&
                  r->expression[e].kind != SCARP_RECIPE_NOISE)) {
        return e >= 0 && r->expression[e].kind == SCARP_RECIPE_NUMBER && !r->is_bad
                   ? r->expression[e].node
                   : -1;
    }
    return r->expression[e].node;
}

static enum scarp_status take_roots(const struct recipe *r, int outputs, const int32_t *which,
                                    int16_t root[RECIPE_OUTPUTS])
{
    if (outputs < 1 || outputs > (which == NULL ? r->outputs : RECIPE_OUTPUTS) ||
        (which == NULL && r->is_bad)) {
        return SCARP_ERROR_PARAMETER;
    }
    for (int i = 0; i < outputs; i++) {
        root[i] = (int16_t)node_of(r, which == NULL ? r->output[i] : which[i]);
        if (root[i] < 0) {
            return SCARP_ERROR_PARAMETER;
        }
    }
    return SCARP_OK;
}

static NOINLINE enum scarp_status evaluate_on_stack(struct recipe_evaluation *call)
{
    uint64_t memory[STACK_BYTES / sizeof(uint64_t)];
    call->memory = memory;
    call->size = sizeof memory;
    return scarpi_recipe_evaluate(call);
}

static enum scarp_status evaluate_in(struct recipe_evaluation *call,
                                     const struct scarp_scratch *scratch)
{
    call->plan = scratch != NULL ? scratch->plan : NULL;
    if (scratch == NULL || scratch->memory == NULL) {
        return evaluate_on_stack(call);
    }
    call->memory = scratch->memory;
    call->size = scratch->size;
    return scarpi_recipe_evaluate(call);
}

/* Others than the outputs have a schedule of their own, on the stack. */
static NOINLINE enum scarp_status
evaluate_others(struct recipe_evaluation *call, const struct scarp_scratch *scratch, int has_parts)
{
    struct recipe_schedule schedule;
    scarpi_recipe_schedule(call->recipe, call->root, call->outputs, has_parts, &schedule);
    call->schedule = &schedule;
    return evaluate_in(call, scratch);
}

/* Whether a call asks for the outputs of the text in their order, by number or not. */
static int are_outputs(const struct recipe_evaluation *call)
{
    const struct recipe *const r = call->recipe;
    int same = !r->is_bad && call->outputs == r->outputs;
    for (int i = 0; same && i < r->outputs; i++) {
        same = call->root[i] == node_of(r, r->output[i]);
    }
    return same;
}

static NOINLINE enum scarp_status evaluate(struct recipe_evaluation *call, const int32_t *which,
                                           const struct scarp_scratch *scratch)
{
    const enum scarp_status status = take_roots(call->recipe, call->outputs, which, call->root);
    if (status != SCARP_OK) {
        return status;
    }
    if (!are_outputs(call)) {
        return evaluate_others(call, scratch, call->grid != NULL); /* points have no parts */
    }
    call->schedule = &call->recipe->schedule;
    return evaluate_in(call, scratch);
}

static int reserved_in_use(const struct scarp_recipe_outputs *outputs,
                           const struct scarp_scratch *scratch)
{
    uint32_t used = 0;
    for (size_t i = 0; scratch != NULL && i < sizeof scratch->spare / sizeof scratch->spare[0];
         i++) {
        used |= scratch->spare[i];
    }
    for (size_t i = 0; i < sizeof outputs->spare / sizeof outputs->spare[0]; i++) {
        used |= outputs->spare[i];
    }
    return used != 0;
}

/* Runs a call whose points are there. */
static enum scarp_status run(struct recipe_evaluation *call,
                             const struct scarp_recipe_outputs *outputs,
                             const struct scarp_scratch *scratch)
{
    if (scarpi_dispatch_refuses() || reserved_in_use(outputs, scratch)) {
        return SCARP_ERROR_UNSUPPORTED;
    }
    call->outputs = outputs->count;
    call->out = outputs->out;
    const struct fpmode caller = fpmode_enter();
    enum scarp_status status = evaluate(call, outputs->which, scratch);
    if (status == SCARP_ERROR_SIZE) { /* without parts, fewer registers do */
        status = evaluate_others(call, scratch, 0);
    }
    fpmode_leave(caller);
    return status;
}

static enum scarp_status sample(const struct scarp_recipe *recipe, const struct scarp_at *points,
                                const struct scarp_recipe_outputs *outputs,
                                const struct scarp_scratch *scratch)
{
    if (points->count == 0) {
        return SCARP_OK;
    }
    if (recipe == NULL || outputs == NULL || outputs->out == NULL) {
        return SCARP_ERROR_NULL;
    }
    if (!scarpi_is_recipe(recipe)) {
        return SCARP_ERROR_PARAMETER;
    }
    const struct recipe *const r = scarpi_recipe_of(recipe);
    const enum scarp_status status =
        scarpi_check_points(points->count, points->position, r->dimensions,
                            points->doubles ? sizeof(double) : sizeof(float));
    struct recipe_evaluation call; /* as a whole, gcc would set it to 0 by "rep stos" */
    call.recipe = r;
    call.has_doubles = points->doubles;
    call.count = points->count;
    call.grid = NULL;
    for (int i = 0; i < 3; i++) {
        call.at[i] = points->position[i];
    }
    return status != SCARP_OK ? status : run(&call, outputs, scratch);
}

enum scarp_status scarp_recipe_sample(const struct scarp_recipe *recipe, size_t count,
                                      const float *x, const float *y, const float *z,
                                      const struct scarp_recipe_outputs *outputs,
                                      const struct scarp_scratch *scratch)
{
    const struct scarp_at points = {.count = count, .position = {x, y, z}};
    return sample(recipe, &points, outputs, scratch);
}

enum scarp_status scarp_recipe_sample_f64(const struct scarp_recipe *recipe, size_t count,
                                          const double *x, const double *y, const double *z,
                                          const struct scarp_recipe_outputs *outputs,
                                          const struct scarp_scratch *scratch)
{
    const struct scarp_at points = {.count = count, .position = {x, y, z}, .doubles = 1};
    return sample(recipe, &points, outputs, scratch);
}

enum scarp_status scarp_recipe_grid(const struct scarp_recipe *recipe,
                                    const struct scarp_grid *grid,
                                    const struct scarp_recipe_outputs *outputs,
                                    const struct scarp_scratch *scratch)
{
    if (recipe == NULL || grid == NULL || outputs == NULL || outputs->out == NULL) {
        return SCARP_ERROR_NULL;
    }
    if (!scarpi_is_recipe(recipe)) {
        return SCARP_ERROR_PARAMETER;
    }
    const struct recipe *const r = scarpi_recipe_of(recipe);
    struct scarp_grid whole = *grid;
    for (int i = 0; i < r->dimensions; i++) {
        if (grid->count[i] == 0) {
            return SCARP_OK;
        }
    }
    const struct scarp_fault fault = scarpi_check_grid(&whole, r->dimensions);
    if (fault.why != REFUSED_NOT) {
        return scarpi_fault_status(fault, NULL);
    }
    if (scarpi_grid_reserved_in_use(grid)) {
        return SCARP_ERROR_UNSUPPORTED;
    }
    struct recipe_evaluation call = {.recipe = r, .has_doubles = 1, .grid = &whole};
    return run(&call, outputs, scratch);
}

size_t scarp_recipe_scratch_size(const struct scarp_recipe *recipe, int order, size_t points)
{
    if (!scarpi_is_recipe(recipe) || order < 0 || order > 2 || points > SIZE_MAX / 65536) {
        return 0;
    }
    const struct recipe *const r = scarpi_recipe_of(recipe);
    return r->is_bad ? 0 : scarpi_recipe_bytes(r, &r->schedule, order, points);
}

size_t scarp_recipe_plan_size(const struct scarp_recipe *recipe)
{
    if (!scarpi_is_recipe(recipe) || scarpi_recipe_of(recipe)->is_bad) {
        return 0;
    }
    return scarpi_recipe_plan_bytes(scarpi_recipe_of(recipe));
}

static NOINLINE enum scarp_status write_plan(const struct recipe *r, void *memory)
{
    return scarpi_recipe_plan_write(r, memory);
}

enum scarp_status scarp_recipe_plan_make(const struct scarp_recipe *recipe, void *memory,
                                         size_t size)
{
    if (recipe == NULL || memory == NULL) {
        return SCARP_ERROR_NULL;
    }
    const size_t needed = scarp_recipe_plan_size(recipe);
    if (needed == 0 || (uintptr_t)memory % _Alignof(struct scarp_plan) != 0) {
        return SCARP_ERROR_PARAMETER;
    }
    if (size < needed) {
        return SCARP_ERROR_SIZE;
    }
    if (scarpi_dispatch_refuses()) {
        return SCARP_ERROR_UNSUPPORTED;
    }
    const struct fpmode caller = fpmode_enter();
    const enum scarp_status status = write_plan(scarpi_recipe_of(recipe), memory);
    fpmode_leave(caller);
    return status;
}

static NOINLINE void find_range(const struct recipe *r, int node, const struct scarp_box *box,
                                struct recipe_interval *range)
{
    *range = r->node[node].interval;
    if (box != NULL) {
        *range = scarpi_recipe_interval_in(r, node, box);
    }
}

static int is_box(const struct scarp_box *box, int dimensions)
{
    for (int i = 0; i < dimensions; i++) {
        if (!(box->lowest[i] <= box->highest[i])) {
            return 0;
        }
    }
    return 1;
}

enum scarp_status scarp_recipe_range(const struct scarp_recipe *recipe, int32_t which,
                                     const struct scarp_box *box, float *lowest, float *highest)
{
    if (recipe == NULL || lowest == NULL || highest == NULL) {
        return SCARP_ERROR_NULL;
    }
    if (!scarpi_is_recipe(recipe)) {
        return SCARP_ERROR_PARAMETER;
    }
    const struct recipe *const r = scarpi_recipe_of(recipe);
    const int node = node_of(r, which == SCARP_RECIPE_OUTPUT ? r->output[0] : which);
    if (node < 0 || (which == SCARP_RECIPE_OUTPUT && r->is_bad) ||
        (box != NULL && !is_box(box, r->dimensions))) {
        return SCARP_ERROR_PARAMETER;
    }
    struct recipe_interval range;
    const struct fpmode caller = fpmode_enter();
    find_range(r, node, box, &range);
    fpmode_leave(caller);
    *lowest = range.lowest;
    *highest = range.highest;
    return SCARP_OK;
}
