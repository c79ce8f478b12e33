/* SPDX-License-Identifier: MIT
 *
 * What expressions are: their values at a place, the noises that they describe, the coordinates of
 * at(), and the places inside calls that transform.
 */
#include "compile.h"
#include "graph.h"

/* Goes one expression deeper. */
static bool enter(struct recipe_compiler *c, int e)
{
    if (c->depth == RECIPE_DEPTH) {
        scarpi_recipe_bad(c, e, "expressions are nested more than 40 deep, names included", NULL);
        return false;
    }
    c->depth++;
    return true;
}

static struct recipe_value coordinate(struct recipe_compiler *c, int e, int place, int axis)
{
    const int p = scarpi_recipe_spelled_out(c, e, place);
    if (p < 0) {
        return scarpi_recipe_bad_already();
    }
    if (axis >= c->recipe->place[p].dimensions) {
        return scarpi_recipe_bad(
            c, e, "there is no z in the plane: a recipe has it with space 3, outside of flat()",
            NULL);
    }
    if (c->recipe->is_tiled) {
        return scarpi_recipe_bad(
            c, e, "a coordinate does not repeat, so it cannot be used with a tile", NULL);
    }
    struct recipe_node node = scarpi_recipe_operation(OP_COORDINATE, RECIPE_NONE, RECIPE_NONE);
    node.place = (int16_t)p;
    node.detail = (uint8_t)axis;
    return scarpi_recipe_node(c, e, node);
}

static int axis_of(const struct recipe_compiler *c, int e)
{
    const struct recipe_span name = c->recipe->expression[e].name;
    const char letter = c->recipe->text[name.from];
    return name.to - name.from == 1 && letter >= 'x' && letter <= 'z' ? letter - 'x' : -1;
}

static struct recipe_value named(struct recipe_compiler *c, int e, int place)
{
    struct recipe *const r = c->recipe;
    const int axis = axis_of(c, e);
    if (axis >= 0) {
        return coordinate(c, e, place, axis);
    }
    const int i = scarpi_recipe_find(r, r->expression[e].name, r->statements);
    if (i < 0) {
        return scarpi_recipe_bad(c, e, "there is no such name", NULL);
    }
    if (r->statement[i].span.to > r->expression[e].name.from) {
        return scarpi_recipe_bad(c, e, "a name must be defined above the line that uses it", NULL);
    }
    const struct recipe_statement *const named = &r->statement[i];
    if (named->type == STATEMENT_PARAM) {
        return scarpi_recipe_number(named->value);
    }
    if (named->expression < 0 || c->node[i][place] == RECIPE_BAD) {
        return scarpi_recipe_bad_already();
    }
    if (r->expression[named->expression].kind == SCARP_RECIPE_NOISE) {
        r->expression[e].kind = SCARP_RECIPE_NOISE;
    }
    if (c->node[i][place] != RECIPE_UNKNOWN) { /* else chains of names would double at each */
        return (struct recipe_value){SCARP_RECIPE_FIELD, c->node[i][place], 0.0};
    }
    const struct recipe_value value = scarpi_recipe_value(c, named->expression, place);
    if (value.kind != SCARP_RECIPE_NUMBER) {
        c->node[i][place] = (int16_t)value.node;
    }
    return value;
}

static struct recipe_value value_of(struct recipe_compiler *c, int e, int place)
{
    const struct recipe_expression *const x = &c->recipe->expression[e];
    switch (x->type) {
    case EXPRESSION_NUMBER: return scarpi_recipe_number(x->number);
    case EXPRESSION_NAME: return named(c, e, place);
    case EXPRESSION_CALL: return scarpi_recipe_call(c, e, place);
    case EXPRESSION_NEGATIVE:
        return scarpi_recipe_combined(c, e, EXPRESSION_MULTIPLY, scarpi_recipe_number(-1.0),
                                      scarpi_recipe_value(c, x->a, place));
    case EXPRESSION_POWER: {
        const struct recipe_value a = scarpi_recipe_value(c, x->a, place);
        const struct recipe_value square = scarpi_recipe_combined(c, e, EXPRESSION_MULTIPLY, a, a);
        return x->exponent == 2 ? square
                                : scarpi_recipe_combined(c, e, EXPRESSION_MULTIPLY, square,
                                                         x->exponent == 3 ? a : square);
    }
    case EXPRESSION_KNOT:
        return scarpi_recipe_bad(c, e, "x: value must be an argument of curve() or blend()", NULL);
    default: {
        const struct recipe_value a = scarpi_recipe_value(c, x->a, place);
        return scarpi_recipe_combined(c, e, x->type, a, scarpi_recipe_value(c, x->b, place));
    }
    }
}

struct recipe_value scarpi_recipe_value(struct recipe_compiler *c, int e, int place)
{
    struct recipe_expression *const x = &c->recipe->expression[e];
    if (!enter(c, e)) {
        return scarpi_recipe_bad_already();
    }
    const struct recipe_value value = value_of(c, e, place);
    c->depth--;
    if (place == c->root && value.kind != SCARP_RECIPE_BAD) {
        x->kind = x->kind == SCARP_RECIPE_NOISE ? x->kind : (uint8_t)value.kind;
        x->node = (int16_t)value.node;
        x->number = value.number;
    }
    return value;
}

bool scarpi_recipe_take_number(struct recipe_compiler *c, int e, double *number)
{
    const struct recipe_value value = scarpi_recipe_value(c, e, c->root);
    if (value.kind == SCARP_RECIPE_FIELD) {
        scarpi_recipe_bad(c, e, "expected a number, but this depends on the position", NULL);
    }
    *number = value.number;
    return value.kind == SCARP_RECIPE_NUMBER;
}

/* Sets the members of a noise that the arguments from one to another are. */
static bool set_noise(struct recipe_compiler *c, const int16_t argument[RECIPE_ARGUMENTS], int from,
                      int to, struct scarp_noise *noise)
{
    for (int i = from; i < to; i++) {
        double number;
        if (argument[i] >= 0 && !(scarpi_recipe_take_number(c, argument[i], &number) &&
                                  scarpi_recipe_set_noise(c, argument[i], i, number, noise))) {
            return false;
        }
    }
    return true;
}

/* noise(...) */
static int described(struct recipe_compiler *c, int call)
{
    int16_t argument[RECIPE_ARGUMENTS];
    int knots;
    struct scarp_noise noise;
    if (!scarpi_recipe_bind(c, call, FUNCTION_NOISE, argument, &knots)) {
        return RECIPE_BAD;
    }
    scarpi_recipe_start_noise(c, argument, &noise);
    if (!set_noise(c, argument, NOISE_OCTAVES, NOISE_PERIOD, &noise) ||
        !scarpi_recipe_one_length(c, argument[NOISE_SIZE], argument[NOISE_FREQUENCY]) ||
        !set_noise(c, argument, NOISE_SIZE, NOISE_OCTAVES, &noise) ||
        !set_noise(c, argument, NOISE_PERIOD, NOISE_END, &noise) ||
        !scarpi_recipe_check_noise(c, call, argument, &noise)) {
        return RECIPE_BAD;
    }
    const int added = scarpi_recipe_add_noise(c->recipe, &noise, RECIPE_NONE);
    return added >= 0 ? added : scarpi_recipe_full(c, call).node;
}

/* warp(n, w) of noises is the noise n with the warp w, if it has none. */
static int warped(struct recipe_compiler *c, int call)
{
    int16_t argument[RECIPE_ARGUMENTS];
    int knots;
    if (!scarpi_recipe_bind(c, call, FUNCTION_WARP, argument, &knots)) {
        return RECIPE_BAD;
    }
    const int n = scarpi_recipe_noise_of(c, argument[0]);
    const int w = scarpi_recipe_noise_of(c, argument[1]);
    if (n == RECIPE_BAD || w == RECIPE_BAD) {
        return RECIPE_BAD;
    }
    if (n == RECIPE_NONE || w == RECIPE_NONE || c->recipe->noise[n].warp >= 0) {
        return RECIPE_NONE;
    }
    struct scarp_noise noise[5];
    scarpi_recipe_spell_noise(c->recipe, n, noise);
    const int added = scarpi_recipe_add_noise(c->recipe, &noise[0], w);
    return added >= 0 ? added : scarpi_recipe_full(c, call).node;
}

static int noise_of_name(struct recipe_compiler *c, int e)
{
    const struct recipe *const r = c->recipe;
    const int i = scarpi_recipe_find(r, r->expression[e].name, r->statements);
    if (i < 0 || r->statement[i].span.to > r->expression[e].name.from ||
        r->statement[i].type != STATEMENT_FIELD) {
        return RECIPE_NONE;
    }
    if (r->statement[i].expression < 0) {
        return RECIPE_BAD;
    }
    if (c->noise[i] == RECIPE_UNKNOWN) {
        c->noise[i] = (int16_t)scarpi_recipe_noise_of(c, r->statement[i].expression);
    }
    return c->noise[i];
}

int scarpi_recipe_noise_of(struct recipe_compiler *c, int e)
{
    struct recipe_expression *const x = &c->recipe->expression[e];
    int noise = RECIPE_NONE;
    if (!enter(c, e)) {
        return RECIPE_BAD;
    }
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

static struct recipe_linear linear_of(struct recipe_compiler *c, int e, int place);

static struct recipe_linear linear_sum(struct recipe_compiler *c, int e, int place, double sign)
{
    struct recipe_linear a = linear_of(c, c->recipe->expression[e].a, place);
    const struct recipe_linear b = linear_of(c, c->recipe->expression[e].b, place);
    for (int i = 0; i < 3; i++) {
        a.m[i] += sign * b.m[i];
    }
    a.t += sign * b.t;
    const int second = b.rest < 0 ? b.rest : scarpi_recipe_affine(c, e, b.rest, sign, 0.0).node;
    a.rest = scarpi_recipe_sum(c, e, a.rest, second);
    return a;
}

/* k a, a k or a / k, where k is a number and a is linear. Returns false if the expression is no
   such product. */
static bool linear_product(struct recipe_compiler *c, int e, int place, struct recipe_linear *to)
{
    const struct recipe_expression *const x = &c->recipe->expression[e];
    struct recipe_value a = scarpi_recipe_value(c, x->a, place);
    struct recipe_value b = scarpi_recipe_value(c, x->b, place);
    int of = x->a;
    if (x->type == EXPRESSION_MULTIPLY && a.kind == SCARP_RECIPE_NUMBER) {
        const struct recipe_value swap = a;
        a = b;
        b = swap;
        of = x->b;
    }
    if (b.kind != SCARP_RECIPE_NUMBER || a.kind != SCARP_RECIPE_FIELD || b.number == 0.0) {
        return false;
    }
    const double k = x->type == EXPRESSION_DIVIDE ? 1.0 / b.number : b.number;
    *to = linear_of(c, of, place);
    for (int i = 0; i < 3; i++) {
        to->m[i] *= k;
    }
    to->t *= k;
    if (to->rest >= 0) {
        to->rest = scarpi_recipe_affine(c, e, to->rest, k, 0.0).node;
    }
    return true;
}

static struct recipe_linear linear_coordinate(struct recipe_compiler *c, int e, int place, int axis)
{
    const int p = scarpi_recipe_spelled_out(c, e, place);
    if (p < 0 || axis >= c->recipe->place[p].dimensions || c->recipe->is_tiled) {
        return (struct recipe_linear){.rest = coordinate(c, e, place, axis).node};
    }
    const struct recipe_place *const at = &c->recipe->place[p];
    return (struct recipe_linear){
        {at->m[axis][0], at->m[axis][1], at->m[axis][2]}, at->t[axis], at->rest[axis]};
}

static struct recipe_linear linear_of(struct recipe_compiler *c, int e, int place)
{
    const struct recipe_expression *const x = &c->recipe->expression[e];
    struct recipe_linear l = {.rest = RECIPE_BAD};
    if (!enter(c, e)) {
        return l;
    }
    const int axis = x->type == EXPRESSION_NAME ? axis_of(c, e) : -1;
    const bool is_sum = x->type == EXPRESSION_ADD || x->type == EXPRESSION_SUBTRACT;
    const bool is_product = x->type == EXPRESSION_MULTIPLY || x->type == EXPRESSION_DIVIDE;
    if (axis >= 0) {
        l = linear_coordinate(c, e, place, axis);
    } else if (is_sum) {
        l = linear_sum(c, e, place, x->type == EXPRESSION_ADD ? 1.0 : -1.0);
    } else if (!is_product || !linear_product(c, e, place, &l)) {
        const struct recipe_value value = scarpi_recipe_value(c, e, place);
        l.t = value.kind == SCARP_RECIPE_NUMBER ? value.number : 0.0;
        l.rest = value.node;
    }
    c->depth--;
    return l;
}

static int place_of_at(struct recipe_compiler *c, int call, int place,
                       const int16_t argument[RECIPE_ARGUMENTS])
{
    struct recipe_linear coordinate[3];
    const int p = scarpi_recipe_spelled_out(c, call, place);
    if (p < 0) {
        return RECIPE_BAD;
    }
    const int dimensions = c->recipe->place[p].dimensions;
    if ((argument[3] >= 0) != (dimensions == 3)) {
        return scarpi_recipe_bad(c, call, "at() needs a coordinate for each axis", NULL).node;
    }
    for (int i = 0; i < dimensions; i++) {
        coordinate[i] = linear_of(c, argument[i + 1], place);
        if (coordinate[i].rest == RECIPE_BAD) {
            return RECIPE_BAD;
        }
    }
    return scarpi_recipe_looking_at(c, call, p, coordinate);
}

static int place_of_warp(struct recipe_compiler *c, int place,
                         const int16_t argument[RECIPE_ARGUMENTS])
{
    const int noise = scarpi_recipe_noise_of(c, argument[1]);
    if (noise >= 0) {
        return scarpi_recipe_warped(c, argument[1], place, noise);
    }
    if (noise == RECIPE_NONE &&
        scarpi_recipe_value(c, argument[1], c->root).kind != SCARP_RECIPE_BAD) {
        scarpi_recipe_bad(c, argument[1], "expected a noise to displace by", NULL);
    }
    return RECIPE_BAD;
}

/* Of turn(), move(), scale(), stretch() and wind(): numbers, and an axis. */
static int place_of_transform(struct recipe_compiler *c, int call, int function, int place,
                              const int16_t argument[RECIPE_ARGUMENTS])
{
    const struct scarp_recipe_function *const f = scarpi_recipe_function_number(function);
    double number[3] = {0.0, 0.0, 0.0};
    int axis = 2;
    for (int i = 1; i < f->arguments; i++) {
        if (f->argument[i].kind == SCARP_RECIPE_NUMBER) {
            number[i - 1] = f->argument[i].otherwise;
            if (argument[i] >= 0 && !scarpi_recipe_take_number(c, argument[i], &number[i - 1])) {
                return RECIPE_BAD;
            }
        } else if (argument[i] >= 0) {
            axis = scarpi_recipe_word_of(c->recipe, c->recipe->expression[argument[i]].name,
                                         &f->argument[i]);
        }
    }
    return scarpi_recipe_transformed(c, call, function, place, number, axis);
}

static int place_of_flat(struct recipe_compiler *c, int call, int place, int word)
{
    const struct scarp_recipe_function *const f = scarpi_recipe_function_number(FUNCTION_FLAT);
    const int axis = word < 0 ? 2
                              : scarpi_recipe_word_of(c->recipe, c->recipe->expression[word].name,
                                                      &f->argument[1]);
    return scarpi_recipe_flattened(c, call, place, axis);
}

int scarpi_recipe_place_inside(struct recipe_compiler *c, int call, int function, int place,
                               const int16_t argument[RECIPE_ARGUMENTS])
{
    switch (function) {
    case FUNCTION_WARP: return place_of_warp(c, place, argument);
    case FUNCTION_FLAT: return place_of_flat(c, call, place, argument[1]);
    case FUNCTION_AT: return place_of_at(c, call, place, argument);
    default: return place_of_transform(c, call, function, place, argument);
    }
}
