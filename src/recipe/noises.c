/* SPDX-License-Identifier: MIT
 *
 * The nodes that sample noises, vector noise, cells and gullies at a place: with the period of the
 * tile, without octaves that are too fine, and with the warps of the place.
 */
#include <math.h>
#include <string.h>

#include "../plan/gully.h"
#include "compile.h"
#include "graph.h"

/* Octaves whose cells are smaller than `finest` are left out, and the last one that is left fades
   in. */
static void limit(double finest, double frequency, double lacunarity, double octaves, float *kept,
                  float *of_octaves)
{
    double cell = 1.0 / frequency, count = 1.0;
    while (lacunarity > 1.0 && count < octaves && cell / lacunarity >= finest) {
        cell /= lacunarity;
        count += 1.0;
    }
    if (lacunarity > 1.0 && count < octaves) {
        const double fraction = (cell - finest) / (cell - cell / lacunarity);
        count += fraction > 0.0 ? fraction : 0.0;
    }
    if (count < octaves) {
        *of_octaves = *of_octaves != 0.0f ? *of_octaves : (float)octaves;
        *kept = (float)count;
    }
}

static void limit_noise(struct scarp_noise *noise, double finest)
{
    limit(finest, value_or(noise->frequency, noise_bounds.frequency.standard),
          value_or((double)noise->lacunarity, noise_bounds.lacunarity.standard),
          value_or((double)noise->octaves, noise_bounds.octaves.standard), &noise->octaves,
          &noise->of_octaves);
}

/* Octaves of gullies count by the cells of the base, `cells` times as large as their own: the sum
   of the smaller ones is not 0 where they are too small to be seen. Measured on sharp valleys
   against means of blocks, with `finest` twice their side, fewer octaves are worse and more are no
   better. */
static void limit_gullies(struct scarp_gullies *gullies, double finest)
{
    limit(finest, value_or(gullies->frequency, gullies_standard.frequency),
          value_or((double)gullies->lacunarity, gullies_standard.lacunarity),
          value_or((double)gullies->octaves, gullies_standard.octaves), &gullies->octaves,
          &gullies->of_octaves);
}

/* The axis of the points along which an axis of a place lies: in space, planes may lie across any.
 */
static int axis_of_tile(const struct recipe_compiler *c, int axis, const double matrix[3][3])
{
    const int is_plane = matrix[2][0] == 0.0 && matrix[2][1] == 0.0 && matrix[2][2] == 0.0;
    return c->recipe->dimensions == 3 && is_plane && axis < 2 && matrix[axis][axis] == 0.0
               ? axis + 1
               : axis;
}

/* The period along an axis in cells, of a tile. Returns false after an error. */
static bool fit_tile(struct recipe_compiler *c, int e, int axis, const double matrix[3][3],
                     double frequency, uint32_t *period)
{
    const int along = axis_of_tile(c, axis, matrix);
    for (int i = 0; i < 3; i++) {
        if (i != along && matrix[axis][i] != 0.0) {
            scarpi_recipe_bad(
                c, e, "turned noise does not repeat, so it cannot be used with a tile", NULL);
            return false;
        }
    }
    const double cells =
        c->recipe->tile[along] * fabs(matrix[axis][along]) * (frequency != 0.0 ? frequency : 1.0);
    const double whole = cells < 1.0      ? 1.0
                         : cells > 0x1p30 ? 0x1p30
                                          : (double)(uint32_t)(cells + 0.5);
    if (!(fabs(cells - whole) <= 1e-9 * whole)) {
        if (c->errors != NULL) {
            c->errors->nearest = c->recipe->tile[along] * fabs(matrix[axis][along]) / whole;
        }
        scarpi_recipe_bad(
            c, e,
            "the tile is not a whole number of cells; `nearest` is the nearest size that fits",
            NULL);
        return false;
    }
    *period = (uint32_t)whole;
    return true;
}

/* Whether what is at fault with any period is so with that of a tile: no size mends it, so it is
   reported before the size is looked at. */
static int is_period_fault(const struct recipe_compiler *c, const char *why, const char *member)
{
    return c->recipe->is_tiled && why != NULL &&
           (strcmp(member, "rotate") == 0 || strcmp(member, "lacunarity") == 0 ||
            strncmp(member, "period", 6) == 0);
}

/* Whether the noise can have periods at all. Returns 0 on an error. */
static int can_repeat(struct recipe_compiler *c, int e, const struct scarp_noise *noise,
                      int dimensions)
{
    const char *member;
    struct scarp_noise tiled = *noise;
    tiled.warp = NULL;
    for (int axis = 0; axis < dimensions; axis++) {
        tiled.period[axis] = 1;
    }
    const char *const why = scarp_noise_fault(&tiled, dimensions, 0, 0, &member);
    return !is_period_fault(c, why, member) || (scarpi_recipe_bad(c, e, why, member), 0);
}

/* How many units of a place one unit of the points has, at most. */
static double scale_of(const double matrix[3][3])
{
    double most = 0.0;
    for (int i = 0; i < 3; i++) {
        const double square =
            matrix[i][0] * matrix[i][0] + matrix[i][1] * matrix[i][1] + matrix[i][2] * matrix[i][2];
        most = square > most ? square : most;
    }
    return sqrt(most);
}

/* A noise as it is at a place: with the period of the tile, and without what is too fine.
   RECIPE_NONE stays RECIPE_NONE. */
static int finished(struct recipe_compiler *c, int e, int noise, int place)
{
    struct recipe *const r = c->recipe;
    struct scarp_noise levels[5];
    double matrix[3][3];
    if (noise < 0 || (r->finest == 0.0 && !r->is_tiled)) {
        return noise;
    }
    const int warp = finished(c, e, r->noise[noise].warp, place);
    scarpi_recipe_matrix(r, place, matrix);
    scarpi_recipe_spell_noise(r, noise, levels);
    if (!can_repeat(c, e, &levels[0], r->place[place].dimensions)) {
        return RECIPE_BAD;
    }
    for (int axis = 0; r->is_tiled && axis < r->place[place].dimensions; axis++) {
        if (!fit_tile(c, e, axis, (const double(*)[3])matrix, levels[0].frequency,
                      &levels[0].period[axis])) {
            return RECIPE_BAD;
        }
    }
    if (r->finest != 0.0) {
        limit_noise(&levels[0], r->finest * scale_of((const double(*)[3])matrix));
    }
    if (warp == RECIPE_BAD) {
        return RECIPE_BAD;
    }
    const int added = scarpi_recipe_add_noise(r, &levels[0], warp);
    return added >= 0 ? added : scarpi_recipe_full(c, e).node;
}

static int depth_of(const struct recipe *recipe, int noise)
{
    int depth = -1;
    for (; noise >= 0; noise = recipe->noise[noise].warp) {
        depth++;
    }
    return depth;
}

/* Whether the library takes a noise as it has become. Returns false after an error. */
static bool is_right(struct recipe_compiler *c, int e, int noise, int dimensions)
{
    struct scarp_noise levels[5];
    const char *member;
    scarpi_recipe_spell_noise(c->recipe, noise, levels);
    const char *const why = scarp_noise_fault(&levels[0], dimensions, 0, 0, &member);
    if (why != NULL) {
        scarpi_recipe_bad(c, e, why, member);
    }
    return why == NULL;
}

/* Moves warps of the place into the noise, which the library bends by itself, and spells out what
   is left of them. Returns false after an error. */
static bool settle(struct recipe_compiler *c, int e, int *noise, int *place)
{
    struct recipe *const r = c->recipe;
    struct scarp_noise levels[5];
    while (r->place[*place].warp >= 0 && r->noise[*noise].warp < 0 &&
           depth_of(r, r->place[*place].warp) < 4) {
        scarpi_recipe_spell_noise(r, *noise, levels);
        *noise = scarpi_recipe_add_noise(r, &levels[0], r->place[*place].warp);
        *place = r->place[*place].before;
        if (*noise < 0) {
            scarpi_recipe_full(c, e);
            return false;
        }
    }
    *place = scarpi_recipe_spelled_out(c, e, *place);
    if (*place < 0) {
        return false;
    }
    *noise = finished(c, e, *noise, *place);
    return *noise >= 0 && is_right(c, e, *noise, r->place[*place].dimensions);
}

static struct recipe_value sampled_by(struct recipe_compiler *c, int e, int operation, int noise,
                                      int place)
{
    struct recipe_node node = scarpi_recipe_operation(operation, RECIPE_NONE, RECIPE_NONE);
    node.index = (int16_t)noise;
    node.place = (int16_t)place;
    return scarpi_recipe_node(c, e, node);
}

struct recipe_value scarpi_recipe_sampled(struct recipe_compiler *c, int e, int noise, int place)
{
    return settle(c, e, &noise, &place) ? sampled_by(c, e, OP_NOISE, noise, place)
                                        : scarpi_recipe_bad_already();
}

/* The components of the vector noise that a noise makes, at a place. */
static bool components(struct recipe_compiler *c, int e, int noise, int place, int16_t component[3])
{
    if (!settle(c, e, &noise, &place)) {
        return false;
    }
    component[0] = (int16_t)sampled_by(c, e, OP_VECTOR, noise, place).node;
    for (int i = 1; i < c->recipe->place[place].dimensions && component[i - 1] >= 0; i++) {
        struct recipe_node other = scarpi_recipe_operation(OP_COMPONENT, component[0], RECIPE_NONE);
        other.detail = (uint8_t)i;
        component[i] = (int16_t)scarpi_recipe_node(c, e, other).node;
    }
    return component[c->recipe->place[place].dimensions - 1] >= 0;
}

int scarpi_recipe_spelled_out(struct recipe_compiler *c, int e, int place)
{
    struct recipe *const r = c->recipe;
    int16_t component[3];
    if (r->place[place].warp < 0) {
        return place;
    }
    const int before = scarpi_recipe_spelled_out(c, e, r->place[place].before);
    if (before < 0 || !components(c, e, r->place[place].warp, r->place[place].before, component)) {
        return RECIPE_BAD;
    }
    struct recipe_place p = r->place[before];
    for (int i = 0; i < p.dimensions; i++) {
        p.rest[i] = (int16_t)scarpi_recipe_sum(c, e, p.rest[i], component[i]);
        if (p.rest[i] < 0) {
            return RECIPE_BAD;
        }
    }
    return scarpi_recipe_place(c, e, &p);
}

struct recipe_value scarpi_recipe_cell(struct recipe_compiler *c, int e, int noise, int what,
                                       int place)
{
    struct recipe *const r = c->recipe;
    struct scarp_noise levels[5];
    scarpi_recipe_spell_noise(r, noise, levels);
    levels[0].octaves = 1.0f; /* others change nothing, and fewer than that would be refused */
    levels[0].of_octaves = levels[0].of_octaves < 1.0f ? 0.0f : levels[0].of_octaves;
    noise = scarpi_recipe_add_noise(r, &levels[0], RECIPE_NONE);
    place = scarpi_recipe_spelled_out(c, e, place);
    if (noise < 0) {
        return scarpi_recipe_full(c, e);
    }
    noise = place < 0 ? RECIPE_BAD : finished(c, e, noise, place);
    if (noise < 0 || !is_right(c, e, noise, r->place[place].dimensions)) {
        return scarpi_recipe_bad_already();
    }
    struct recipe_node node = scarpi_recipe_operation(OP_CELL, RECIPE_NONE, RECIPE_NONE);
    node.index = (int16_t)noise;
    node.place = (int16_t)place;
    node.detail = (uint8_t)what;
    return scarpi_recipe_node(c, e, node);
}

struct recipe_value scarpi_recipe_displacement(struct recipe_compiler *c, int call, int base,
                                               int place, struct scarp_gullies *g)
{
    double matrix[3][3];
    const char *member;
    scarpi_recipe_matrix(c->recipe, place, matrix);
    const struct scarp_noise lattice = scarpi_gullies_lattice(g);
    if (!can_repeat(c, call, &lattice, 2)) {
        return scarpi_recipe_bad_already();
    }
    for (int axis = 0; c->recipe->is_tiled && axis < 2; axis++) {
        if (!fit_tile(c, call, axis, (const double(*)[3])matrix, g->frequency, &g->period[axis])) {
            return scarpi_recipe_bad_already();
        }
    }
    if (c->recipe->finest != 0.0) {
        limit_gullies(g, c->recipe->finest * scale_of((const double(*)[3])matrix));
    }
    const char *const why = scarp_gullies_fault(g, &member);
    if (why != NULL) {
        return scarpi_recipe_bad(c, call, why, member);
    }
    const int added = scarpi_recipe_add_gullies(c->recipe, g);
    if (added < 0) {
        return scarpi_recipe_full(c, call);
    }
    struct recipe_node node = scarpi_recipe_operation(OP_GULLIES, base, RECIPE_NONE);
    node.place = (int16_t)place;
    node.index = (int16_t)added;
    return scarpi_recipe_node(c, call, node);
}
