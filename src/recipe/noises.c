/* SPDX-License-Identifier: MIT
 *
 * Noises, vector noise, cells and gullies: their members, and the nodes that sample them.
 */
#include <math.h>
#include <string.h>

#include "compile.h"
#include "graph.h"

static const struct recipe_value nothing = {SCARP_RECIPE_BAD, -1, 0.0};

/* Arguments of noise(), in their order; words come first. */
enum {
    NOISE_BASIS,
    NOISE_FRACTAL,
    NOISE_FADE,
    NOISE_ROTATE,
    NOISE_SIZE,
    NOISE_FREQUENCY,
    NOISE_SEED,
    NOISE_OCTAVES,
    NOISE_OF_OCTAVES,
    NOISE_PHASE = 13,
    NOISE_PERIOD = 16,
    NOISE_PERIOD_X
};

/* Arguments of gullies(). */
enum { GULLIES_SIZE = 1, GULLIES_FREQUENCY, GULLIES_SEED, GULLIES_AMPLITUDE, GULLIES_ROTATE = 20 };

static uint64_t splitmix(uint64_t start, uint64_t number)
{
    uint64_t z = start + number * UINT64_C(0x9E3779B97F4A7C15);
    z = (z ^ z >> 30) * UINT64_C(0xBF58476D1CE4E5B9);
    z = (z ^ z >> 27) * UINT64_C(0x94D049BB133111EB);
    return z ^ z >> 31;
}

/* Numbers up to 63 belong to octaves, warps and curls. Those of negative seeds come from the other
   end: 64 more would make numbers from 0 to 63 of -64 to -1. */
uint64_t scarpi_recipe_seed_of(uint64_t world, double number)
{
    const uint64_t whole = (uint64_t)(int64_t)number;
    return number == 0.0 ? world : splitmix(splitmix(world, 1), number < 0.0 ? whole : 64 + whole);
}

static int take_seed(struct recipe_compiler *c, int e, uint64_t *seed)
{
    double number;
    if (!scarpi_recipe_take_number(c, e, &number)) {
        return 0;
    }
    if (!(fabs(number) < 0x1p53) || (double)(int64_t)number != number) {
        return scarpi_recipe_bad(c, e, "a seed is a whole number of magnitude below 2^53", NULL), 0;
    }
    *seed = scarpi_recipe_seed_of(c->recipe->seed, number);
    return 1;
}

/* A frequency, given as such or as the length of a cell. */
static int take_frequency(struct recipe_compiler *c, int size, int frequency, double *to)
{
    double number;
    if (size >= 0 && frequency >= 0) {
        return scarpi_recipe_bad(c, frequency, "size and frequency say the same", NULL), 0;
    }
    if (size < 0 && frequency < 0) {
        return 1;
    }
    if (!scarpi_recipe_take_number(c, size >= 0 ? size : frequency, &number)) {
        return 0;
    }
    *to = size < 0 ? number : number > 0.0 ? 1.0 / number : 0.0;
    if (!(*to >= 0x1p-32 && *to <= 0x1p48)) {
        return scarpi_recipe_bad(c, size >= 0 ? size : frequency,
                                 "a frequency is from 2^-32 to 2^48, and a size 1 over that", NULL),
               0;
    }
    return 1;
}

static int take_words(struct recipe_compiler *c, const int16_t argument[RECIPE_ARGUMENTS],
                      struct scarp_noise *noise)
{
    const struct scarp_recipe_function *const f = scarpi_recipe_function_number(FUNCTION_NOISE);
    int word[NOISE_SIZE];
    for (int i = 0; i < NOISE_SIZE; i++) {
        word[i] = argument[i] < 0
                      ? -1
                      : scarpi_recipe_word_of(c->recipe, c->recipe->expression[argument[i]].name,
                                              &f->argument[i]);
    }
    noise->basis = (enum scarp_basis)(word[NOISE_BASIS] < 0 ? 0 : word[NOISE_BASIS]);
    noise->fractal = (enum scarp_fractal)(word[NOISE_FRACTAL] < 0 ? 0 : word[NOISE_FRACTAL]);
    noise->fade = (enum scarp_fade)(word[NOISE_FADE] < 0 ? 0 : word[NOISE_FADE]);
    noise->rotate = word[NOISE_ROTATE] == 0;
    return 1;
}

static int take_periods(struct recipe_compiler *c, const int16_t argument[RECIPE_ARGUMENTS],
                        struct scarp_noise *noise)
{
    for (int i = NOISE_PERIOD; i < NOISE_PERIOD_X + 3; i++) {
        double number;
        if (argument[i] < 0) {
            continue;
        }
        if (!scarpi_recipe_take_number(c, argument[i], &number)) {
            return 0;
        }
        if (!(number >= 0.0 && number <= 0x1p30) || (double)(uint32_t)number != number) {
            return scarpi_recipe_bad(c, argument[i],
                                     "a period is a whole number of cells, up to 2^30", NULL),
                   0;
        }
        for (int axis = 0; axis < c->recipe->dimensions; axis++) {
            if (i == NOISE_PERIOD || i == NOISE_PERIOD_X + axis) {
                noise->period[axis] = (uint32_t)number;
            }
        }
    }
    return 1;
}

static int take_members(struct recipe_compiler *c, const int16_t argument[RECIPE_ARGUMENTS],
                        struct scarp_noise *noise)
{
    float *const member[] = {&noise->octaves, &noise->of_octaves, &noise->lacunarity,
                             &noise->gain,    &noise->amplitude,  &noise->erosion,
                             &noise->phase,   &noise->jitter,     &noise->sharpness};
    for (int i = NOISE_OCTAVES; i < NOISE_PERIOD; i++) {
        double number;
        if (argument[i] < 0) {
            continue;
        }
        if (!scarpi_recipe_take_number(c, argument[i], &number)) {
            return 0;
        }
        if ((float)number == 0.0f && i != NOISE_PHASE && i != NOISE_OF_OCTAVES) {
            return scarpi_recipe_bad(c, argument[i], "this member of a noise must not be 0", NULL),
                   0;
        }
        *member[i - NOISE_OCTAVES] = (float)number;
    }
    return take_frequency(c, argument[NOISE_SIZE], argument[NOISE_FREQUENCY], &noise->frequency) &&
           (argument[NOISE_SEED] < 0 || take_seed(c, argument[NOISE_SEED], &noise->seed)) &&
           take_periods(c, argument, noise);
}

/* The argument that is called as a member, or the call itself */
static int argument_of(int call, int function, const int16_t argument[RECIPE_ARGUMENTS],
                       const char *member)
{
    const struct scarp_recipe_function *const f = scarpi_recipe_function_number(function);
    for (int i = 0; member != NULL && i < f->arguments; i++) {
        if (argument[i] >= 0 && strcmp(f->argument[i].name, member) == 0) {
            return argument[i];
        }
    }
    return call;
}

static int described(struct recipe_compiler *c, int call)
{
    int16_t argument[RECIPE_ARGUMENTS];
    int knots;
    struct scarp_noise noise;
    memset(&noise, 0, sizeof noise); /* padding, too: noises are compared */
    noise.seed = c->recipe->seed;
    if (!scarpi_recipe_bind(c, call, FUNCTION_NOISE, argument, &knots) ||
        !take_words(c, argument, &noise) || !take_members(c, argument, &noise)) {
        return -2;
    }
    const char *member;
    const char *const why = scarp_noise_fault(&noise, c->recipe->dimensions, 0, 0, &member);
    if (why != NULL) {
        const int at = argument_of(call, FUNCTION_NOISE, argument, member);
        return scarpi_recipe_bad(c, at, why, member), -2;
    }
    const int added = scarpi_recipe_add_noise(c->recipe, &noise, -1);
    return added < 0 ? (scarpi_recipe_full(c, call), -2) : added;
}

/* warp(n, w) of noises is the noise n with the warp w, if it has none. */
static int warped(struct recipe_compiler *c, int call)
{
    int16_t argument[RECIPE_ARGUMENTS];
    int knots;
    if (!scarpi_recipe_bind(c, call, FUNCTION_WARP, argument, &knots)) {
        return -2;
    }
    const int n = scarpi_recipe_noise_of(c, argument[0]),
              w = scarpi_recipe_noise_of(c, argument[1]);
    if (n < 0 || w < 0 || c->recipe->noise[n].warp >= 0) {
        return n == -2 || w == -2 ? -2 : -1;
    }
    struct scarp_noise noise[5];
    scarpi_recipe_spell_noise(c->recipe, n, noise);
    const int added = scarpi_recipe_add_noise(c->recipe, &noise[0], w);
    return added < 0 ? (scarpi_recipe_full(c, call), -2) : added;
}

static int noise_of_name(struct recipe_compiler *c, int e)
{
    const struct recipe *const r = c->recipe;
    const int i = scarpi_recipe_find(r, r->expression[e].name, r->statements);
    if (i < 0 || r->statement[i].span.to > r->expression[e].name.from ||
        r->statement[i].type != STATEMENT_FIELD) {
        return -1;
    }
    if (r->statement[i].expression < 0) {
        return -2;
    }
    if (c->noise[i] == 0) {
        c->noise[i] = (int16_t)(scarpi_recipe_noise_of(c, r->statement[i].expression) + 3);
    }
    return c->noise[i] - 3;
}

int scarpi_recipe_noise_of(struct recipe_compiler *c, int e)
{
    struct recipe_expression *const x = &c->recipe->expression[e];
    int noise = -1;
    if (c->depth == RECIPE_DEPTH) {
        return scarpi_recipe_bad(c, e, "expressions are nested more than 40 deep, through names",
                                 NULL),
               -2;
    }
    c->depth++;
    if (x->type == EXPRESSION_NAME) {
        noise = noise_of_name(c, e);
    } else if (x->type == EXPRESSION_CALL && scarpi_recipe_is(c->recipe, x->name, "noise")) {
        noise = described(c, e);
    } else if (x->type == EXPRESSION_CALL && scarpi_recipe_is(c->recipe, x->name, "warp")) {
        noise = warped(c, e);
    }
    c->depth--;
    if (noise >= 0) {
        x->kind = SCARP_RECIPE_NOISE;
    }
    return noise;
}

/* Octaves whose cells are smaller than `finest` are left out, and the last one that is left fades
   in. Members that are 0 have the values that the library takes for it. */
static void limit(double finest, double frequency, float lacunarity, float octaves, float *kept,
                  float *of_octaves)
{
    const double ratio = (double)lacunarity;
    double cell = 1.0 / (frequency != 0.0 ? frequency : 1.0), count = 1.0;
    while (ratio > 1.0 && count < (double)octaves && cell / ratio >= finest) {
        cell /= ratio;
        count += 1.0;
    }
    if (ratio > 1.0 && count < (double)octaves) {
        const double fraction = (cell - finest) / (cell - cell / ratio);
        count += fraction > 0.0 ? fraction : 0.0;
    }
    if (count < (double)octaves) {
        *of_octaves = *of_octaves != 0.0f ? *of_octaves : octaves;
        *kept = (float)count;
    }
}

static float otherwise(float value, float standard)
{
    return value != 0.0f ? value : standard;
}

static void limit_noise(struct scarp_noise *noise, double finest)
{
    limit(finest, noise->frequency, otherwise(noise->lacunarity, 2.0f),
          otherwise(noise->octaves, 1.0f), &noise->octaves, &noise->of_octaves);
}

/* Octaves of gullies count by the cells of the base, `cells` times as large as their own: the sum
   of the smaller ones is not 0 where they are too small to be seen. Measured on sharp valleys
   against means of blocks, with `finest` twice their side, fewer octaves are worse and more are no
   better. */
static void limit_gullies(struct scarp_gullies *gullies, double finest)
{
    limit(finest, gullies->frequency, otherwise(gullies->lacunarity, 2.0f),
          otherwise(gullies->octaves, 5.0f), &gullies->octaves, &gullies->of_octaves);
}

/* The period along an axis in cells, of a tile. Returns 0 on an error. */
static int fit_tile(struct recipe_compiler *c, int e, int axis, const double matrix[3][3],
                    double frequency, uint32_t *period)
{
    for (int i = 0; i < 3; i++) {
        if (i != axis && matrix[axis][i] != 0.0) {
            return scarpi_recipe_bad(
                       c, e, "what is turned does not repeat, and the recipe has a tile", NULL),
                   0;
        }
    }
    const double cells =
        c->recipe->tile[axis] * fabs(matrix[axis][axis]) * (frequency != 0.0 ? frequency : 1.0);
    const double whole = cells < 1.0      ? 1.0
                         : cells > 0x1p30 ? 0x1p30
                                          : (double)(uint32_t)(cells + 0.5);
    if (!(fabs(cells - whole) <= 1e-9 * whole)) {
        if (c->errors != NULL) {
            c->errors->nearest = c->recipe->tile[axis] * fabs(matrix[axis][axis]) / whole;
        }
        return scarpi_recipe_bad(c, e,
                                 "the tile is not a whole number of cells; `nearest` is the "
                                 "nearest size that fits",
                                 NULL),
               0;
    }
    *period = (uint32_t)whole;
    return 1;
}

/* Whether what is at fault with any period is so with that of a tile: no size mends it, so it is
   told before the size is looked at. */
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

static int gullies_can_repeat(struct recipe_compiler *c, int e, const struct scarp_gullies *gullies)
{
    const char *member;
    struct scarp_gullies tiled = *gullies;
    tiled.period[0] = tiled.period[1] = 1;
    tiled.cells = 1.0f;
    const char *const why = scarp_gullies_fault(&tiled, &member);
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

/* A noise as it is at a place: with the period of the tile, and without what is too fine. */
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
        return -2;
    }
    for (int axis = 0; r->is_tiled && axis < r->place[place].dimensions; axis++) {
        if (!fit_tile(c, e, axis, (const double(*)[3])matrix, levels[0].frequency,
                      &levels[0].period[axis])) {
            return -2;
        }
    }
    if (r->finest != 0.0) {
        limit_noise(&levels[0], r->finest * scale_of((const double(*)[3])matrix));
    }
    const int added = warp == -2 ? -2 : scarpi_recipe_add_noise(r, &levels[0], warp);
    return added == -1 ? (scarpi_recipe_full(c, e), -2) : added;
}

static int depth_of(const struct recipe *recipe, int noise)
{
    int depth = -1;
    for (; noise >= 0; noise = recipe->noise[noise].warp) {
        depth++;
    }
    return depth;
}

/* Whether the library takes a noise as it has become. Returns 0 on an error. */
static int is_right(struct recipe_compiler *c, int e, int noise, int dimensions)
{
    struct scarp_noise levels[5];
    const char *member;
    scarpi_recipe_spell_noise(c->recipe, noise, levels);
    const char *const why = scarp_noise_fault(&levels[0], dimensions, 0, 0, &member);
    return why == NULL ? 1 : (scarpi_recipe_bad(c, e, why, member), 0);
}

/* Moves warps of the place into the noise, which the library bends by itself, and spells out what
   is left of them. Returns 0 on an error. */
static int settle(struct recipe_compiler *c, int e, int *noise, int *place)
{
    struct recipe *const r = c->recipe;
    struct scarp_noise levels[5];
    while (r->place[*place].warp >= 0 && r->noise[*noise].warp < 0 &&
           depth_of(r, r->place[*place].warp) < 4) {
        scarpi_recipe_spell_noise(r, *noise, levels);
        *noise = scarpi_recipe_add_noise(r, &levels[0], r->place[*place].warp);
        *place = r->place[*place].before;
        if (*noise < 0) {
            return scarpi_recipe_full(c, e), 0;
        }
    }
    *place = scarpi_recipe_spelled_out(c, e, *place);
    *noise = *place < 0 ? -2 : finished(c, e, *noise, *place);
    return *noise >= 0 && is_right(c, e, *noise, r->place[*place].dimensions);
}

struct recipe_value scarpi_recipe_sampled(struct recipe_compiler *c, int e, int noise, int place)
{
    if (!settle(c, e, &noise, &place)) {
        return nothing;
    }
    struct recipe_node node = scarpi_recipe_operation(OP_NOISE, -1, -1);
    node.index = (int16_t)noise;
    node.place = (int16_t)place;
    return scarpi_recipe_node(c, e, node);
}

int scarpi_recipe_components(struct recipe_compiler *c, int e, int noise, int place,
                             int16_t component[3])
{
    if (!settle(c, e, &noise, &place)) {
        return 0;
    }
    struct recipe_node node = scarpi_recipe_operation(OP_VECTOR, -1, -1);
    node.index = (int16_t)noise;
    node.place = (int16_t)place;
    component[0] = (int16_t)scarpi_recipe_node(c, e, node).node;
    for (int i = 1; i < c->recipe->place[place].dimensions && component[i - 1] >= 0; i++) {
        struct recipe_node other = scarpi_recipe_operation(OP_COMPONENT, component[0], -1);
        other.detail = (uint8_t)i;
        component[i] = (int16_t)scarpi_recipe_node(c, e, other).node;
    }
    return component[c->recipe->place[place].dimensions - 1] >= 0;
}

struct recipe_value scarpi_recipe_cell(struct recipe_compiler *c, int e, int noise, int what,
                                       int place)
{
    struct recipe *const r = c->recipe;
    struct scarp_noise levels[5];
    scarpi_recipe_spell_noise(r, noise, levels);
    levels[0].octaves = 1.0f; /* others change nothing, and fewer than that would be refused */
    levels[0].of_octaves = levels[0].of_octaves < 1.0f ? 0.0f : levels[0].of_octaves;
    noise = scarpi_recipe_add_noise(r, &levels[0], -1);
    place = scarpi_recipe_spelled_out(c, e, place);
    if (noise < 0 || place < 0) {
        return noise < 0 ? scarpi_recipe_full(c, e) : nothing;
    }
    noise = finished(c, e, noise, place);
    if (noise < 0 || !is_right(c, e, noise, r->place[place].dimensions)) {
        return nothing;
    }
    struct recipe_node node = scarpi_recipe_operation(OP_CELL, -1, -1);
    node.index = (int16_t)noise;
    node.place = (int16_t)place;
    node.detail = (uint8_t)what;
    return scarpi_recipe_node(c, e, node);
}

/* Effects that are not wanted are 0 in recipes, where the library takes 0 for a default. */
static int take_gullies(struct recipe_compiler *c, int call,
                        const int16_t argument[RECIPE_ARGUMENTS], struct scarp_gullies *g)
{
    float *const member[] = {&g->amplitude, &g->octaves, &g->of_octaves, &g->lacunarity,
                             &g->gain,      &g->depth,   &g->cells,      &g->slope,
                             &g->slope_low, &g->low,     &g->high,       &g->floor,
                             &g->stripes,   &g->branch,  &g->round,      &g->keep};
    for (int i = GULLIES_AMPLITUDE; i < GULLIES_ROTATE; i++) {
        double number;
        if (argument[i] < 0) {
            continue;
        }
        if (!scarpi_recipe_take_number(c, argument[i], &number)) {
            return 0;
        }
        float *const to = member[i - GULLIES_AMPLITUDE];
        const int is_effect = to == &g->depth || to == &g->low || to == &g->high ||
                              to == &g->floor || to == &g->branch || to == &g->keep;
        *to = (float)number;
        if (*to == 0.0f && to != &g->of_octaves) {
            if (!is_effect) {
                return scarpi_recipe_bad(c, argument[i], "this member of gullies must not be 0",
                                         NULL),
                       0;
            }
            *to = 0x1p-24f;
        }
    }
    g->rotate = argument[GULLIES_ROTATE] >= 0;
    if (!take_frequency(c, argument[GULLIES_SIZE], argument[GULLIES_FREQUENCY], &g->frequency) ||
        (argument[GULLIES_SEED] >= 0 && !take_seed(c, argument[GULLIES_SEED], &g->seed))) {
        return 0;
    }
    const char *at_fault;
    const char *const why = scarp_gullies_fault(g, &at_fault);
    if (why != NULL) {
        const int at = argument_of(call, FUNCTION_GULLIES, argument, at_fault);
        return scarpi_recipe_bad(c, at, why, at_fault), 0;
    }
    return 1;
}

/* The members of gullies at a place: an index, or -1 on an error. */
static int gullies_at(struct recipe_compiler *c, int call, const int16_t argument[RECIPE_ARGUMENTS],
                      int place)
{
    double matrix[3][3];
    struct scarp_gullies g;
    memset(&g, 0, sizeof g);
    g.seed = c->recipe->seed;
    g.offset_first = 1;
    if (!take_gullies(c, call, argument, &g)) {
        return -1;
    }
    scarpi_recipe_matrix(c->recipe, place, matrix);
    if (!gullies_can_repeat(c, call, &g)) {
        return -1;
    }
    for (int axis = 0; c->recipe->is_tiled && axis < 2; axis++) {
        if (!fit_tile(c, call, axis, (const double(*)[3])matrix, g.frequency, &g.period[axis])) {
            return -1;
        }
    }
    if (c->recipe->finest != 0.0) {
        limit_gullies(&g, c->recipe->finest * scale_of((const double(*)[3])matrix));
    }
    const char *member;
    const char *const why = scarp_gullies_fault(&g, &member);
    if (why != NULL) {
        return scarpi_recipe_bad(c, call, why, member).node;
    }
    const int added = scarpi_recipe_add_gullies(c->recipe, &g);
    return added < 0 ? scarpi_recipe_full(c, call).node : added;
}

struct recipe_value scarpi_recipe_gullies(struct recipe_compiler *c, int call, int place,
                                          const int16_t argument[RECIPE_ARGUMENTS],
                                          int is_displacement)
{
    struct recipe *const r = c->recipe;
    const int framed = scarpi_recipe_framed(c, call, place);
    if (framed < 0) {
        return nothing;
    }
    if (r->place[framed].dimensions != 2) {
        return scarpi_recipe_bad(c, call, "gullies are of the plane: see flat", NULL);
    }
    const int f = argument[0];
    const int base = scarpi_recipe_field(c, f, scarpi_recipe_value(c, f, framed));
    if (base < 0) {
        return nothing;
    }
    if (r->node[base].order < 2) {
        return scarpi_recipe_bad(c, f,
                                 "gullies need a base with second derivatives, which erosion, "
                                 "swiss, jordan, slope and gullies do not have",
                                 NULL);
    }
    struct recipe_node node = scarpi_recipe_operation(OP_GULLIES, base, -1);
    node.place = (int16_t)framed;
    node.index = (int16_t)gullies_at(c, call, argument, framed);
    if (node.index < 0) {
        return nothing;
    }
    struct recipe_value value = scarpi_recipe_node(c, call, node);
    if (value.kind != SCARP_RECIPE_BAD && !is_displacement) {
        value = scarpi_recipe_node(c, call, scarpi_recipe_operation(OP_ADD, base, value.node));
    }
    return scarpi_recipe_pulled(c, call, place, value);
}
