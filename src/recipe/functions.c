/* SPDX-License-Identifier: MIT
 *
 * Calls: what their arguments are, and the nodes that they become.
 */
#include <math.h>

#include "../calls/run.h"
#include "combine.h"
#include "compile.h"
#include "graph.h"

static const struct recipe_value nothing = {SCARP_RECIPE_BAD, RECIPE_BAD, 0.0};

static struct recipe_expression *expression(const struct recipe_compiler *c, int e)
{
    return &c->recipe->expression[e];
}

static int is_named(const struct recipe_expression *x)
{
    return x->argument.to > x->argument.from;
}

/* The argument that a bare word is for; of functions that take several, any. */
static int argument_of_word(const struct recipe_compiler *c, int e,
                            const struct scarp_recipe_function *f, int from)
{
    for (int i = from; expression(c, e)->type == EXPRESSION_NAME && i < f->arguments; i++) {
        if (scarpi_recipe_word_of(c->recipe, expression(c, e)->name, &f->argument[i]) >= 0) {
            return i;
        }
    }
    return -1;
}

/* Which argument an expression is, the one behind `position` if it has no name. */
static int argument_of(struct recipe_compiler *c, int e, const struct scarp_recipe_function *f,
                       int position)
{
    const struct recipe_expression *const x = expression(c, e);
    if (is_named(x)) {
        for (int i = 0; i < f->arguments; i++) {
            if (f->argument[i].kind != SCARP_RECIPE_WORD &&
                scarpi_recipe_is(c->recipe, x->argument, f->argument[i].name)) {
                return i;
            }
        }
        return scarpi_recipe_bad(c, e, "this function has no argument of that name", f->name).node;
    }
    /* A field may have the name of a word; numbers give way to words. */
    const int expected = position < f->arguments ? f->argument[position].kind : SCARP_RECIPE_WORD;
    const int word = expected == SCARP_RECIPE_WORD || expected == SCARP_RECIPE_NUMBER
                         ? argument_of_word(c, e, f, position)
                         : -1;
    return word >= 0                       ? word
           : expected != SCARP_RECIPE_WORD ? position
           : position < f->arguments
               ? scarpi_recipe_bad(c, e, "this function has no such word", f->name).node
               : scarpi_recipe_bad(c, e, "too many arguments", f->name).node;
}

bool scarpi_recipe_bind(struct recipe_compiler *c, int call, int function,
                        int16_t argument[RECIPE_ARGUMENTS], int *knots)
{
    const struct scarp_recipe_function *const f = scarpi_recipe_function_number(function);
    int position = 0;
    for (int i = 0; i < RECIPE_ARGUMENTS; i++) {
        argument[i] = -1;
    }
    *knots = 0;
    for (int e = expression(c, call)->a; e >= 0; e = expression(c, e)->next) {
        const int i = argument_of(c, e, f, position);
        if (i < 0) {
            return false;
        }
        if (f->argument[i].kind == SCARP_RECIPE_KNOT) {
            if (expression(c, e)->type != EXPRESSION_KNOT) {
                scarpi_recipe_bad(c, e, "expected x: value", f->name);
                return false;
            }
            expression(c, e)->kind = SCARP_RECIPE_KNOT;
            argument[i] = (int16_t)(*knots == 0 ? e : argument[i]);
            ++*knots;
            continue;
        }
        if (argument[i] >= 0) {
            scarpi_recipe_bad(c, e, "this argument is given twice", f->argument[i].name);
            return false;
        }
        if (f->argument[i].kind == SCARP_RECIPE_WORD) {
            expression(c, e)->kind = SCARP_RECIPE_WORD;
        } else if (!is_named(expression(c, e))) {
            position++;
        }
        argument[i] = (int16_t)e;
    }
    for (int i = 0; i < f->arguments; i++) {
        if (f->argument[i].is_needed && argument[i] < 0) {
            scarpi_recipe_bad(c, call, "an argument is missing", f->argument[i].name);
            return false;
        }
    }
    return true;
}

/* Evaluates the fields and the numbers of a call, in their order. Returns 0 on an error. */
struct arguments {
    int fields, numbers, are_numbers; /* all fields are numbers */
    struct recipe_value field[3];
    double number[3];
};

static int take_arguments(struct recipe_compiler *c, int function, int place,
                          const int16_t argument[RECIPE_ARGUMENTS], struct arguments *to)
{
    const struct scarp_recipe_function *const f = scarpi_recipe_function_number(function);
    int good = 1;
    *to = (struct arguments){.are_numbers = 1};
    for (int i = 0; i < f->arguments && good; i++) {
        if (f->argument[i].kind == SCARP_RECIPE_FIELD) {
            const struct recipe_value value = scarpi_recipe_value(c, argument[i], place);
            to->field[to->fields++] = value;
            to->are_numbers = to->are_numbers && value.kind == SCARP_RECIPE_NUMBER;
            good = value.kind != SCARP_RECIPE_BAD;
        } else if (f->argument[i].kind == SCARP_RECIPE_NUMBER) {
            double *const number = &to->number[to->numbers++];
            *number = f->argument[i].otherwise;
            good = argument[i] < 0 || scarpi_recipe_take_number(c, argument[i], number);
        }
    }
    return good;
}

/* Functions of numbers alone, in double. Those that are not there are fields. */
static struct recipe_value folded(int function, const struct arguments *g)
{
    const double a = g->field[0].number, b = g->fields > 1 ? g->field[1].number : 0.0;
    const double lo = g->number[0], hi = g->number[1];
    switch (function) {
    case FUNCTION_ABS: return scarpi_recipe_number(fabs(a));
    case FUNCTION_SQRT: return scarpi_recipe_number(a > 0.0 ? sqrt(a) : 0.0);
    case FUNCTION_MIN: return g->number[0] == 0.0 ? scarpi_recipe_number(b < a ? b : a) : nothing;
    case FUNCTION_MAX: return g->number[0] == 0.0 ? scarpi_recipe_number(b > a ? b : a) : nothing;
    case FUNCTION_CLAMP:
        return lo <= hi ? scarpi_recipe_number(a < lo ? lo : a > hi ? hi : a) : nothing;
    default: return nothing;
    }
}

static struct recipe_value mixed(struct recipe_compiler *c, int e, int a, int b, int m)
{
    if (a < 0 || b < 0 || m < 0) {
        return nothing;
    }
    const struct recipe_interval mask = c->recipe->node[m].interval;
    if (mask.lowest < 0.0f || mask.highest > 1.0f) {
        return scarpi_recipe_bad(
            c, e, "the mask of mix must stay in [0, 1]: see smoothstep and clamp", NULL);
    }
    struct recipe_node node = scarpi_recipe_operation(OP_MIX, a, b);
    node.in[2] = (int16_t)m;
    return scarpi_recipe_node(c, e, node);
}

/* Functions that become one node */
static struct recipe_value simple(struct recipe_compiler *c, int call, int function, int place,
                                  const int16_t argument[RECIPE_ARGUMENTS])
{
#define FUNCTION(NAME, ...) [FUNCTION_##NAME] = OP_##NAME,
    static const uint8_t operations[FUNCTION_COUNT] = {
#include "../plan/functions.def"
    };
    struct arguments given;
    int node_of[3] = {-1, -1, -1};
    if (!take_arguments(c, function, place, argument, &given)) {
        return nothing;
    }
    if (given.are_numbers && folded(function, &given).kind != SCARP_RECIPE_BAD) {
        return folded(function, &given);
    }
    for (int i = 0; i < given.fields; i++) {
        node_of[i] = scarpi_recipe_field(c, call, given.field[i]);
        if (node_of[i] < 0) {
            return nothing;
        }
    }
    if (function == FUNCTION_MIX) {
        return mixed(c, call, node_of[0], node_of[1], node_of[2]);
    }
    struct recipe_node node = scarpi_recipe_operation(operations[function], node_of[0], node_of[1]);
    for (int i = 0; i < given.numbers; i++) {
        node.k[i] = (float)given.number[i];
    }
    if ((function == FUNCTION_MIN || function == FUNCTION_MAX) && node.k[0] != 0.0f) {
        node.operation = function == FUNCTION_MIN ? OP_SMOOTH_MIN : OP_SMOOTH_MAX;
    }
    if (scarpi_recipe_try_numbers(&node) != SCARP_OK) {
        return scarpi_recipe_bad(c, call,
                                 "a number is outside the interval that the function takes",
                                 scarpi_recipe_function_number(function)->name);
    }
    if (function == FUNCTION_SLOPE && c->recipe->node[node_of[0]].order == 0) {
        return scarpi_recipe_bad(c, call, "the field has no gradient", NULL);
    }
    return scarpi_recipe_node(c, call, node);
}

/* The place of the next knot, above the last one. Returns false after an error. */
static bool take_knot(struct recipe_compiler *c, int e, int is_first, float *x)
{
    double number;
    const float before = *x;
    if (!scarpi_recipe_take_number(c, expression(c, e)->a, &number)) {
        return false;
    }
    *x = (float)number;
    if (!(fabsf(*x) <= 0x1p60f) || (!is_first && !(*x - before >= 0x1p-60f))) {
        scarpi_recipe_bad(c, e, "knots must come in order, at least 2^-60 apart, up to 2^60", NULL);
        return false;
    }
    return true;
}

/* Fills in the knots of a node, from the first one on. Returns false after an error. It is not
   inlined, so that fields within fields do not take its stack. */
static NOINLINE bool take_knots(struct recipe_compiler *c, int call, int e, int knots,
                                struct recipe_node *node)
{
    float knot[SCARP_CURVE_KNOTS][2] = {{0}};
    float x = 0.0f;
    if (knots < 2 || knots > SCARP_CURVE_KNOTS) {
        scarpi_recipe_bad(c, call, "a curve has from 2 to 64 knots", NULL);
        return false;
    }
    for (int i = 0; i < knots; i++, e = expression(c, e)->next) {
        double value;
        if (!take_knot(c, e, i == 0, &x) ||
            !scarpi_recipe_take_number(c, expression(c, e)->b, &value)) {
            return false;
        }
        knot[i][0] = x;
        knot[i][1] = (float)value;
        if (!(fabsf(knot[i][1]) <= 0x1p60f)) {
            scarpi_recipe_bad(c, e, "values of knots go up to 2^60", NULL);
            return false;
        }
    }
    node->knots = (uint8_t)knots;
    node->index = (int16_t)scarpi_recipe_add_knots(c->recipe, knots, knot);
    if (node->index < 0) {
        scarpi_recipe_full(c, call);
    }
    return node->index >= 0;
}

static struct recipe_value curve(struct recipe_compiler *c, int call, int place,
                                 const int16_t argument[RECIPE_ARGUMENTS], int knots)
{
    const int a = scarpi_recipe_field(c, call, scarpi_recipe_value(c, argument[0], place));
    struct recipe_node node = scarpi_recipe_operation(OP_CURVE, a, -1);
    return a >= 0 && take_knots(c, call, argument[1], knots, &node)
               ? scarpi_recipe_node(c, call, node)
               : nothing;
}

/* Mixes of neighbours, by smoothsteps between knots */
static struct recipe_value blend(struct recipe_compiler *c, int call, int place,
                                 const int16_t argument[RECIPE_ARGUMENTS], int knots)
{
    const int by = scarpi_recipe_field(c, call, scarpi_recipe_value(c, argument[0], place));
    if (by < 0) {
        return nothing;
    }
    if (knots < 2) {
        return scarpi_recipe_bad(c, call, "blend has at least 2 knots", NULL);
    }
    struct recipe_value result = nothing;
    float x = 0.0f;
    int e = argument[1];
    for (int i = 0; i < knots; i++, e = expression(c, e)->next) {
        const float before = x;
        if (!take_knot(c, e, i == 0, &x)) {
            return nothing;
        }
        const int f = scarpi_recipe_field(c, e, scarpi_recipe_value(c, expression(c, e)->b, place));
        if (f < 0) {
            return nothing;
        }
        if (i == 0) {
            result = (struct recipe_value){SCARP_RECIPE_FIELD, f, 0.0};
            continue;
        }
        struct recipe_node mask = scarpi_recipe_operation(OP_SMOOTHSTEP, by, -1);
        mask.k[0] = before;
        mask.k[1] = x;
        if (scarpi_recipe_try_numbers(&mask) != SCARP_OK) {
            return scarpi_recipe_bad(c, e, "knots must be between 2^-60 and 2^60 apart", NULL);
        }
        result = mixed(c, e, result.node, f, scarpi_recipe_node(c, e, mask).node);
        if (result.kind == SCARP_RECIPE_BAD) {
            return nothing;
        }
    }
    return result;
}

/* slope(), whose gradient is by the coordinates of its place */
static struct recipe_value slope(struct recipe_compiler *c, int call, int place,
                                 const int16_t argument[RECIPE_ARGUMENTS])
{
    const int framed = scarpi_recipe_framed(c, call, place);
    return framed < 0 ? nothing
                      : scarpi_recipe_pulled(c, call, place,
                                             simple(c, call, FUNCTION_SLOPE, framed, argument));
}

static struct recipe_value cell(struct recipe_compiler *c, int call, int place,
                                const int16_t argument[RECIPE_ARGUMENTS])
{
    const struct scarp_recipe_function *const f = scarpi_recipe_function_number(FUNCTION_CELL);
    const int noise = scarpi_recipe_noise_of(c, argument[0]);
    const int what =
        argument[1] < 0
            ? 0
            : scarpi_recipe_word_of(c->recipe, expression(c, argument[1])->name, &f->argument[1]);
    if (noise < 0) {
        return noise == RECIPE_NONE ? scarpi_recipe_bad(c, argument[0], "expected a noise", NULL)
                                    : nothing;
    }
    return scarpi_recipe_cell(c, call, noise, what, place);
}

/* Sets the members of gullies that the arguments from one to another are. */
static bool set_gullies(struct recipe_compiler *c, const int16_t argument[RECIPE_ARGUMENTS],
                        int from, int to, struct scarp_gullies *g)
{
    for (int i = from; i < to; i++) {
        double number;
        if (argument[i] >= 0 && !(scarpi_recipe_take_number(c, argument[i], &number) &&
                                  scarpi_recipe_set_gullies(c, argument[i], i, number, g))) {
            return false;
        }
    }
    return true;
}

static struct recipe_value gullies(struct recipe_compiler *c, int call, int function, int place,
                                   const int16_t argument[RECIPE_ARGUMENTS])
{
    const int framed = scarpi_recipe_framed(c, call, place), f = argument[GULLIES_BASE];
    struct scarp_gullies g;
    if (framed < 0) {
        return nothing;
    }
    if (c->recipe->place[framed].dimensions != 2) {
        return scarpi_recipe_bad(c, call, "in space, gullies must be inside flat()", NULL);
    }
    const int base = scarpi_recipe_field(c, f, scarpi_recipe_value(c, f, framed));
    if (base < 0) {
        return nothing;
    }
    if (c->recipe->node[base].order < 2) {
        return scarpi_recipe_bad(c, f,
                                 "gullies need a base with second derivatives, which some "
                                 "fractals, slope and gullies do not have",
                                 NULL);
    }
    scarpi_recipe_start_gullies(c, argument, &g);
    if (!set_gullies(c, argument, GULLIES_AMPLITUDE, GULLIES_ROTATE, &g) ||
        !scarpi_recipe_one_length(c, argument[GULLIES_SIZE], argument[GULLIES_FREQUENCY]) ||
        !set_gullies(c, argument, GULLIES_SIZE, GULLIES_AMPLITUDE, &g) ||
        !scarpi_recipe_check_gullies(c, call, argument, &g)) {
        return nothing;
    }
    struct recipe_value value = scarpi_recipe_displacement(c, call, base, framed, &g);
    if (value.kind != SCARP_RECIPE_BAD && function == FUNCTION_GULLIES) {
        value = scarpi_recipe_node(c, call, scarpi_recipe_operation(OP_ADD, base, value.node));
    }
    return scarpi_recipe_pulled(c, call, place, value);
}

struct recipe_value scarpi_recipe_call(struct recipe_compiler *c, int call, int place)
{
    const int function = scarpi_recipe_function_of(c->recipe, expression(c, call)->name);
    int16_t argument[RECIPE_ARGUMENTS];
    int knots;
    if (function < 0) {
        return scarpi_recipe_bad(c, call, "there is no such function", NULL);
    }
    if (function == FUNCTION_NOISE) {
        const int noise = scarpi_recipe_noise_of(c, call);
        return noise < 0 ? nothing : scarpi_recipe_sampled(c, call, noise, place);
    }
    if (!scarpi_recipe_bind(c, call, function, argument, &knots)) {
        return nothing;
    }
    switch (function) {
    case FUNCTION_CURVE: return curve(c, call, place, argument, knots);
    case FUNCTION_BLEND: return blend(c, call, place, argument, knots);
    case FUNCTION_SLOPE: return slope(c, call, place, argument);
    case FUNCTION_CELL: return cell(c, call, place, argument);
    case FUNCTION_GULLIES:
    case FUNCTION_DISPLACEMENT: return gullies(c, call, function, place, argument);
    case FUNCTION_WARP:
    case FUNCTION_TURN:
    case FUNCTION_MOVE:
    case FUNCTION_SCALE:
    case FUNCTION_STRETCH:
    case FUNCTION_WIND:
    case FUNCTION_AT:
    case FUNCTION_FLAT: {
        if (function == FUNCTION_WARP) {
            (void)scarpi_recipe_noise_of(c, call); /* marks it as a noise, if it is one */
        }
        const int inside = scarpi_recipe_place_inside(c, call, function, place, argument);
        return inside < 0 ? nothing : scarpi_recipe_value(c, argument[0], inside);
    }
    default: return simple(c, call, function, place, argument);
    }
}
