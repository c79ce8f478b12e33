/* SPDX-License-Identifier: MIT
 *
 * The public functions that change a recipe: its seed, its parameters, its tile and its scale. Each
 * compiles it again; with an error, all stays as it was.
 */
#include <string.h>

#include "../calls/run.h"
#include "../dispatch/fpmode.h"
#include "compile.h"

#define ERRORS 16 /* of a text that does not repeat, which are looked through */

/* Compiles what has changed. */
static enum scarp_status compiled(struct recipe *r, struct recipe_errors *errors)
{
    scarpi_recipe_compile(r, errors);
    return errors->found == 0 ? SCARP_OK
           : errors->is_size  ? SCARP_ERROR_SIZE
                              : SCARP_ERROR_PARAMETER;
}

/* Compiles what was there before. */
static void compile_again(struct recipe *r)
{
    struct recipe_errors none = {.capacity = 0};
    scarpi_recipe_compile(r, &none);
}

/* Checks what all calls take. */
static enum scarp_status check(const struct scarp_recipe *recipe, struct scarp_recipe_error *error)
{
    if (error != NULL) {
        memset(error, 0, sizeof *error);
    }
    return recipe == NULL                                                  ? SCARP_ERROR_NULL
           : !scarpi_is_recipe(recipe) || scarpi_recipe_of(recipe)->is_bad ? SCARP_ERROR_PARAMETER
                                                                           : SCARP_OK;
}

static NOINLINE void seed_again(struct recipe *r, uint64_t seed)
{
    r->seed = seed;
    compile_again(r);
}

enum scarp_status scarp_recipe_seed(struct scarp_recipe *recipe, uint64_t seed)
{
    const enum scarp_status status = check(recipe, NULL);
    if (status != SCARP_OK) {
        return status;
    }
    const struct fpmode caller = fpmode_enter();
    seed_again(scarpi_recipe_inside(recipe), seed);
    fpmode_leave(caller);
    return SCARP_OK;
}

/* Where the number of a name is: a parameter's, or "finest". NULL: there is none. */
static double *number_of(struct recipe *r, const char *name)
{
    if (strcmp(name, "finest") == 0) {
        return &r->finest;
    }
    for (int i = 0; i < r->statements; i++) {
        if (r->statement[i].type == STATEMENT_PARAM &&
            scarpi_recipe_is(r, r->statement[i].name, name)) {
            return &r->statement[i].value;
        }
    }
    return NULL;
}

static NOINLINE enum scarp_status set(struct recipe *r, const char *name, double value,
                                      struct scarp_recipe_error *error)
{
    struct recipe_errors errors = {.list = error, .capacity = error != NULL};
    double *const number = number_of(r, name);
    double lowest = 0.0, highest = 1e60; /* of "finest" */
    for (int i = 0; i < r->statements; i++) {
        if (number == &r->statement[i].value) {
            lowest = r->statement[i].lowest;
            highest = r->statement[i].highest;
        }
    }
    if (number == NULL || !(value >= lowest && value <= highest)) {
        return SCARP_ERROR_PARAMETER;
    }
    const double before = *number;
    *number = value;
    const enum scarp_status status = compiled(r, &errors);
    if (status != SCARP_OK) {
        *number = before;
        compile_again(r);
    }
    return status;
}

enum scarp_status scarp_recipe_set(struct scarp_recipe *recipe, const char *name, double value,
                                   struct scarp_recipe_error *error)
{
    const enum scarp_status checked = check(recipe, error);
    if (checked != SCARP_OK || name == NULL) {
        return recipe == NULL || name == NULL ? SCARP_ERROR_NULL : checked;
    }
    const struct fpmode caller = fpmode_enter();
    const enum scarp_status status = set(scarpi_recipe_inside(recipe), name, value, error);
    fpmode_leave(caller);
    return status;
}

/* Reports one of the errors: the first that no other size mends, or else the first. */
static void report(const struct recipe_errors *errors, struct scarp_recipe_error *error)
{
    const size_t count = errors->found < errors->capacity ? errors->found : errors->capacity;
    size_t chosen = 0;
    while (chosen < count && errors->list[chosen].nearest != 0.0) {
        chosen++;
    }
    if (error != NULL && count > 0) {
        *error = errors->list[chosen < count ? chosen : 0];
    }
}

/* Whether sides are such as a text may have, or all 0 */
static int are_sides(const double side[3], int count, int *is_tiled)
{
    int lengths = 0, zeros = 0;
    for (int i = 0; i < count; i++) {
        lengths += side[i] >= 1e-60 && side[i] <= 1e60;
        zeros += side[i] == 0.0;
    }
    *is_tiled = lengths == count;
    return *is_tiled || zeros == count;
}

static NOINLINE enum scarp_status set_tile(struct recipe *r, const double side[3],
                                           struct scarp_recipe_error *error)
{
    struct scarp_recipe_error list[ERRORS];
    struct recipe_errors errors = {.list = list, .capacity = ERRORS};
    const double before[3] = {r->tile[0], r->tile[1], r->tile[2]};
    const uint8_t was_tiled = r->is_tiled;
    int is_tiled;
    if (!are_sides(side, r->dimensions, &is_tiled)) {
        return SCARP_ERROR_PARAMETER;
    }
    for (int i = 0; i < r->dimensions; i++) {
        r->tile[i] = side[i];
    }
    r->is_tiled = (uint8_t)is_tiled;
    const enum scarp_status status = compiled(r, &errors);
    if (status != SCARP_OK) {
        report(&errors, error);
        memcpy(r->tile, before, sizeof before);
        r->is_tiled = was_tiled;
        compile_again(r);
    }
    return status;
}

enum scarp_status scarp_recipe_tile(struct scarp_recipe *recipe, double x, double y, double z,
                                    struct scarp_recipe_error *error)
{
    const double side[3] = {x, y, z};
    const enum scarp_status checked = check(recipe, error);
    if (checked != SCARP_OK) {
        return checked;
    }
    const struct fpmode caller = fpmode_enter();
    const enum scarp_status status = set_tile(scarpi_recipe_inside(recipe), side, error);
    fpmode_leave(caller);
    return status;
}

static NOINLINE enum scarp_status set_scale(struct recipe *r, const double scale[2],
                                            struct scarp_recipe_error *error)
{
    struct recipe_errors errors = {.list = error, .capacity = error != NULL};
    const double before[2] = {r->scale[0], r->scale[1]};
    for (int i = 0; i < 2; i++) {
        if (!(scale[i] >= 0x1p-40 && scale[i] <= 0x1p40)) {
            return SCARP_ERROR_PARAMETER;
        }
    }
    memcpy(r->scale, scale, sizeof r->scale);
    const enum scarp_status status = compiled(r, &errors);
    if (status != SCARP_OK) {
        memcpy(r->scale, before, sizeof before);
        compile_again(r);
    }
    return status;
}

enum scarp_status scarp_recipe_scale(struct scarp_recipe *recipe, double by, double heights,
                                     struct scarp_recipe_error *error)
{
    const double scale[2] = {by, heights};
    const enum scarp_status checked = check(recipe, error);
    if (checked != SCARP_OK) {
        return checked;
    }
    const struct fpmode caller = fpmode_enter();
    const enum scarp_status status = set_scale(scarpi_recipe_inside(recipe), scale, error);
    fpmode_leave(caller);
    return status;
}
