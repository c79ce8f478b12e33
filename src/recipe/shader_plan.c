/* SPDX-License-Identifier: MIT
 *
 * The uniform buffer of a recipe: numbers of steps and places, and the levels and octaves of its
 * noises, which equal noises share.
 */
#include <string.h>

#include "../calls/chain.h"
#include "../calls/partials.h"
#include "../calls/run.h"
#include "../calls/shaders.h"
#include "../plan/gully.h"
#include "../plan/suprema.h"
#include "graph.h"
#include "shader.h"

_Static_assert(sizeof(struct scarp_gpu_level) == 48 && sizeof(struct scarp_gpu_octave) == 160,
               "arrays of levels and octaves have no gaps in std140");

struct filling {
    const struct recipe *recipe;
    const struct shader_uniforms *to;
    struct shader_slots *slots;
    int dimensions;                  /* of the noise that is filled in */
    const struct recipe_node *node;  /* whose noise that is */
    const struct scarp_noise *noise; /* and this is it */
    enum scarp_status status;        /* of the first call that failed */
};

static void keep_status(struct filling *f, enum scarp_status status)
{
    f->status = f->status == SCARP_OK ? status : f->status;
}

static void put_number(const struct filling *f, float a, float b, float c, float d)
{
    const int i = f->slots->numbers++;
    if (f->to->number != NULL) {
        const float number[4] = {a, b, c, d};
        memcpy(f->to->number[i], number, sizeof number);
    }
}

static void put_knots(struct filling *f, const struct recipe_node *n)
{
    float x[SCARP_CURVE_KNOTS], y[SCARP_CURVE_KNOTS], slope[SCARP_CURVE_KNOTS];
    for (int i = 0; i < n->knots; i++) {
        x[i] = f->recipe->knot[n->index + i][0];
        y[i] = f->recipe->knot[n->index + i][1];
    }
    if (!scarpi_curve_slopes(n->knots, x, y, slope)) {
        keep_status(f, SCARP_ERROR_PARAMETER);
        return;
    }
    for (int i = 0; i < n->knots; i++) {
        put_number(f, x[i], y[i], slope[i], i + 1 < n->knots ? 1.0f / (x[i + 1] - x[i]) : 0.0f);
    }
}

/* The numbers of a function that combines others: those of its call that shaders have. */
static void put_numbers(struct filling *f, const struct recipe_node *n)
{
#define N(number) 1u << CHAIN_##number
#define OPERATOR(NAME, name, FORM, COMPUTED, take, traits, range, shader, numbers)                 \
    IF_NUMBERS_##FORM([OP_##NAME] = {CHAIN_##NAME, numbers}, )
#define FUNCTION(NAME, name, FORM, COMPUTED, take, traits, range, shader, numbers, ...)            \
    OPERATOR(NAME, name, FORM, COMPUTED, take, traits, range, shader, numbers)
    static const struct {
        enum scarp_chain_function function;
        unsigned numbers;
    } of[OP_COUNT] = {
#include "../plan/functions.def"
    };
    const unsigned numbers = of[n->operation].numbers;
    float all[CHAIN_NUMBERS] = {0}, k[4] = {0};
    int count = 0;
    if (n->operation == OP_CONSTANT) {
        put_number(f, n->k[0], 0.0f, 0.0f, 0.0f);
    } else if (n->operation == OP_CURVE) {
        put_knots(f, n);
    }
    if (numbers == 0) {
        return;
    }
    if (!scarpi_chain_numbers(of[n->operation].function, n->k, all)) {
        keep_status(f, SCARP_ERROR_PARAMETER);
    }
    for (int i = 0; i < CHAIN_NUMBERS; i++) {
        if ((numbers >> i & 1u) != 0) {
            k[count++] = all[i];
        }
    }
    put_number(f, k[0], k[1], k[2], k[3]);
}

static void put_place(const struct filling *f, int place)
{
    for (; place > 0 && f->slots->place_of[place] < 0; place = f->recipe->place[place].frame) {
        const struct recipe_place *const p = &f->recipe->place[place];
        f->slots->place_of[place] = (int16_t)f->slots->numbers;
        for (int i = 0; i < 3; i++) {
            put_number(f, (float)p->m[i][0], (float)p->m[i][1], (float)p->m[i][2], (float)p->t[i]);
        }
    }
}

static struct scarp_gpu_level *level_at(const struct filling *f)
{
    return f->to->level != NULL ? f->to->level + f->slots->levels : NULL;
}

static struct scarp_gpu_octave *octave_at(const struct filling *f)
{
    return f->to->octave != NULL ? f->to->octave + f->slots->octaves : NULL;
}

static void put_noise(const struct scarp_call_plan *plan, const void *opaque)
{
    const struct filling *const f = opaque;
    const int count =
        scarpi_shader_levels(plan, f->dimensions, level_at(f), octave_at(f), f->slots->octaves);
    if (f->slots->octaves == 0) {
        f->slots->unit =
            scarpi_shader_unit(plan->warps.depth > 0 || plan->warps.vector
                                   ? scarpi_component_plan(plan, 0, 0).octave[0].frequency64
                                   : plan->octave[0].frequency64);
    }
    f->slots->levels += plan->warps.depth + 1;
    f->slots->octaves += count;
}

/* The first octave, whose lattice is made of cells whatever the basis is. */
static void put_cells(const struct scarp_call_plan *plan, const void *opaque)
{
    const struct filling *const f = opaque;
    struct scarp_octave first =
        plan->warps.depth > 0 ? scarpi_component_plan(plan, 0, 0).octave[0] : plan->octave[0];
    first.jitter = scarpi_stray(f->noise);
    first.middle = 0.0f;
    first.stretch = 1.0;
    const struct scarp_call_plan cells = {
        .basis = SCARP_CELL_F1, .octaves = 1, .octave = &first, .warps = {.depth = 0}};
    put_noise(&cells, f);
}

/* Their lattice is a noise. What it does not need has the constants of gullies. */
static void put_gullies(const struct scarp_call_plan *plan, const void *opaque)
{
    const struct filling *const f = opaque;
    struct scarp_gully_plan g;
    struct scarp_gpu_octave *const octave = octave_at(f);
    scarpi_gullies_plan(&g, &f->recipe->gully[f->node->index], plan);
    put_number(f, g.low, g.steepness, g.slope2, g.slope2_low);
    put_number(f, g.lowered, g.round, g.round2, g.fall);
    put_number(f, g.branch, g.of_base[0], g.of_base[1], g.of_base[2]);
    put_number(f, g.of_sum[0], g.of_sum[1], 0.0f, 0.0f);
    put_noise(plan, f);
    for (int k = 0; octave != NULL && k < plan->octaves; k++) {
        const struct scarp_gully_octave *const o = &g.octave[k];
        const float turn[4] = {o->keep, o->stretch, o->waves[0], o->waves[1]};
        memcpy(octave[k].turn, turn, sizeof turn);
        for (int i = 0; i < 2; i++) {
            octave[k].gradient[0][i] = o->angles[i];
            octave[k].gradient[1][i] = o->cells[i];
        }
    }
}

/* An earlier step that has the same levels, or -1. */
static int equal_step(const struct filling *f, int step)
{
    const struct recipe *const r = f->recipe;
    const struct recipe_node *const n = &r->node[r->schedule.step[step]];
    for (int k = 0; k < step; k++) {
        const struct recipe_node *const other = &r->node[r->schedule.step[k]];
        if (other->operation == n->operation && other->index == n->index &&
            r->place[other->place].dimensions == r->place[n->place].dimensions) {
            return k;
        }
    }
    return -1;
}

static void put_levels(struct filling *f, int step)
{
    const struct recipe *const r = f->recipe;
    const int node = r->schedule.step[step], equal = equal_step(f, step);
    const struct recipe_node *const n = &r->node[node];
    struct scarp_noise noise[5];
    struct scarp_request kind = {.dimensions = r->place[n->place].dimensions};
    if (equal >= 0) {
        f->slots->level_of[node] = f->slots->level_of[r->schedule.step[equal]];
        f->slots->number_of[node] = f->slots->number_of[r->schedule.step[equal]];
        return;
    }
    f->slots->level_of[node] = (int16_t)f->slots->levels;
    f->dimensions = kind.dimensions;
    f->node = n;
    f->noise = noise;
    if (n->operation == OP_GULLIES) {
        noise[0] = scarpi_gullies_lattice(&r->gully[n->index]);
        keep_status(f, scarpi_run(noise, kind, put_gullies, f));
        return;
    }
    scarpi_recipe_spell_noise(r, n->index, noise);
    kind.vector = n->operation == OP_VECTOR;
    keep_status(f, scarpi_run(noise, kind, n->operation == OP_CELL ? put_cells : put_noise, f));
}

enum scarp_status scarpi_shader_lay_out(const struct recipe *recipe,
                                        const struct shader_uniforms *to,
                                        struct shader_slots *slots)
{
    struct filling f = {.recipe = recipe, .to = to, .slots = slots};
    memset(slots, 0, sizeof *slots);
    memset(slots->place_of, 0xff, sizeof slots->place_of);
    slots->unit = 0x1p-8f;
    for (int k = 0; k < recipe->schedule.steps; k++) {
        const int node = recipe->schedule.step[k];
        const struct recipe_node *const n = &recipe->node[node];
        put_place(&f, n->place);
        slots->number_of[node] = (int16_t)slots->numbers;
        if (n->operation == OP_NOISE || n->operation == OP_VECTOR || n->operation == OP_CELL ||
            n->operation == OP_GULLIES) {
            put_levels(&f, k);
        } else {
            put_numbers(&f, n);
        }
    }
    slots->numbers = slots->numbers > 0 ? slots->numbers : 1;
    slots->levels = slots->levels > 0 ? slots->levels : 1;
    slots->octaves = slots->octaves > 0 ? slots->octaves : 1;
    return f.status;
}
