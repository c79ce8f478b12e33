/* SPDX-License-Identifier: MIT
 *
 * Places: what warp(), turn(), at() and their like make of the place at which they stand.
 */
#include <math.h>

#include "../calls/partials.h"
#include "compile.h"
#include "graph.h"

/* u = matrix x + t */
struct transform {
    double matrix[3][3], t[3];
};

static int added(struct recipe_compiler *c, int e, struct recipe_place place)
{
    const int p = scarpi_recipe_add_place(c->recipe, place);
    return p < 0 ? scarpi_recipe_full(c, e).node : p;
}

/* The sum of two nodes, of which each may be none. Returns -2 on an error. */
static int sum(struct recipe_compiler *c, int e, int a, int b)
{
    if (a < 0 || b < 0) {
        return a < 0 ? b : a;
    }
    const int node = scarpi_recipe_node(c, e, scarpi_recipe_operation(OP_ADD, a, b)).node;
    return node < 0 ? -2 : node;
}

int scarpi_recipe_spelled_out(struct recipe_compiler *c, int e, int place)
{
    struct recipe *const r = c->recipe;
    int16_t component[3];
    if (r->place[place].warp < 0) {
        return place;
    }
    const int before = scarpi_recipe_spelled_out(c, e, r->place[place].before);
    if (before < 0 ||
        !scarpi_recipe_components(c, e, r->place[place].warp, r->place[place].before, component)) {
        return -1;
    }
    struct recipe_place p = r->place[before];
    for (int i = 0; i < p.dimensions; i++) {
        p.rest[i] = (int16_t)sum(c, e, p.rest[i], component[i]);
        if (p.rest[i] < 0) {
            return -1;
        }
    }
    return added(c, e, p);
}

/* The place u = A v + t, where v is a place. */
static int transformed(struct recipe_compiler *c, int e, int place, const struct transform *a)
{
    const int from = scarpi_recipe_spelled_out(c, e, place);
    if (from < 0) {
        return -1;
    }
    const struct recipe_place p = c->recipe->place[from];
    struct recipe_place q = p;
    for (int i = 0; i < p.dimensions; i++) {
        int rest = -1;
        q.t[i] = a->t[i];
        for (int j = 0; j < 3; j++) {
            q.m[i][j] = a->matrix[i][0] * p.m[0][j] + a->matrix[i][1] * p.m[1][j] +
                        a->matrix[i][2] * p.m[2][j];
        }
        for (int j = 0; j < p.dimensions && rest != -2; j++) {
            q.t[i] += a->matrix[i][j] * p.t[j];
            if (p.rest[j] >= 0 && a->matrix[i][j] != 0.0) {
                const int part = scarpi_recipe_affine(c, e, p.rest[j], a->matrix[i][j], 0.0).node;
                rest = part < 0 ? -2 : sum(c, e, rest, part);
            }
        }
        if (rest == -2) {
            return -1;
        }
        q.rest[i] = (int16_t)rest;
    }
    return added(c, e, q);
}

/* A coordinate that is written as an expression: its part that is linear stays in double. */
struct linear {
    double m[3], t;
    int rest; /* -1: none; -2: an error */
};

static struct linear linear_of(struct recipe_compiler *c, int e, int place);

static struct linear linear_sum(struct recipe_compiler *c, int e, int place, double sign)
{
    struct linear a = linear_of(c, c->recipe->expression[e].a, place);
    const struct linear b = linear_of(c, c->recipe->expression[e].b, place);
    for (int i = 0; i < 3; i++) {
        a.m[i] += sign * b.m[i];
    }
    a.t += sign * b.t;
    const int second = b.rest < 0 ? b.rest : scarpi_recipe_affine(c, e, b.rest, sign, 0.0).node;
    a.rest = a.rest == -2 || b.rest == -2 || (b.rest >= 0 && second < 0)
                 ? -2
                 : sum(c, e, a.rest, second);
    return a;
}

/* k a, a k or a / k, where k is a number and a is linear. Returns 0 if the expression is no such
   product. */
static int linear_product(struct recipe_compiler *c, int e, int place, struct linear *to)
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
        return 0;
    }
    const double k = x->type == EXPRESSION_DIVIDE ? 1.0 / b.number : b.number;
    *to = linear_of(c, of, place);
    for (int i = 0; i < 3; i++) {
        to->m[i] *= k;
    }
    to->t *= k;
    if (to->rest >= 0) {
        const int rest = scarpi_recipe_affine(c, e, to->rest, k, 0.0).node;
        to->rest = rest < 0 ? -2 : rest;
    }
    return 1;
}

static struct linear linear_of(struct recipe_compiler *c, int e, int place)
{
    const struct recipe_expression *const x = &c->recipe->expression[e];
    struct linear l = {.rest = -1};
    const char letter = c->recipe->text[x->name.from];
    if (c->depth == RECIPE_DEPTH) {
        (void)scarpi_recipe_value(c, e, place); /* which tells it */
        l.rest = -2;
        return l;
    }
    if (x->type == EXPRESSION_NAME && x->name.to - x->name.from == 1 && letter >= 'x' &&
        letter <= 'z') {
        const int p = scarpi_recipe_spelled_out(c, e, place), i = letter - 'x';
        if (p < 0 || i >= c->recipe->place[p].dimensions || c->recipe->is_tiled) {
            (void)scarpi_recipe_value(c, e, place);
            l.rest = -2;
            return l;
        }
        const struct recipe_place *const at = &c->recipe->place[p];
        return (struct linear){{at->m[i][0], at->m[i][1], at->m[i][2]}, at->t[i], at->rest[i]};
    }
    c->depth++;
    const int is_sum = x->type == EXPRESSION_ADD || x->type == EXPRESSION_SUBTRACT;
    const int is_product = x->type == EXPRESSION_MULTIPLY || x->type == EXPRESSION_DIVIDE;
    if (is_sum) {
        l = linear_sum(c, e, place, x->type == EXPRESSION_ADD ? 1.0 : -1.0);
    } else if (!is_product || !linear_product(c, e, place, &l)) {
        const struct recipe_value value = scarpi_recipe_value(c, e, place);
        l.t = value.kind == SCARP_RECIPE_NUMBER ? value.number : 0.0;
        l.rest = value.kind == SCARP_RECIPE_BAD ? -2 : value.node;
    }
    c->depth--;
    return l;
}

static int looking_at(struct recipe_compiler *c, int call, int place,
                      const int16_t argument[RECIPE_ARGUMENTS])
{
    const int p = scarpi_recipe_spelled_out(c, call, place);
    if (p < 0) {
        return -1;
    }
    struct recipe_place q = c->recipe->place[p];
    if ((argument[3] >= 0) != (q.dimensions == 3)) {
        return scarpi_recipe_bad(c, call, "at() has a coordinate for each axis", NULL).node;
    }
    for (int i = 0; i < q.dimensions; i++) {
        const struct linear l = linear_of(c, argument[i + 1], place);
        if (l.rest == -2) {
            return -1;
        }
        for (int j = 0; j < 3; j++) {
            q.m[i][j] = l.m[j];
        }
        q.t[i] = l.t;
        q.rest[i] = (int16_t)l.rest;
    }
    return added(c, call, q);
}

static int warped(struct recipe_compiler *c, int place, const int16_t argument[RECIPE_ARGUMENTS])
{
    const int noise = scarpi_recipe_noise_of(c, argument[1]);
    if (noise < 0) {
        if (noise == -1 && scarpi_recipe_value(c, argument[1], 0).kind != SCARP_RECIPE_BAD) {
            (void)scarpi_recipe_bad(c, argument[1], "expected a noise to displace by", NULL);
        }
        return -1;
    }
    struct recipe_place p = c->recipe->place[place];
    p.warp = (int16_t)noise;
    p.before = (int16_t)place;
    return added(c, argument[1], p);
}

static int flattened(struct recipe_compiler *c, int call, int place)
{
    const int p = scarpi_recipe_spelled_out(c, call, place);
    if (p < 0) {
        return -1;
    }
    struct recipe_place q = c->recipe->place[p];
    if (q.dimensions != 3) {
        return scarpi_recipe_bad(c, call, "flat() stands in space, and not in itself", NULL).node;
    }
    q.dimensions = 2;
    q.m[2][0] = q.m[2][1] = q.m[2][2] = q.t[2] = 0.0;
    q.rest[2] = -1;
    return added(c, call, q);
}

/* Numbers of the call; those that are not given have their defaults. Returns 0 on an error. */
static int take_numbers(struct recipe_compiler *c, int function,
                        const int16_t argument[RECIPE_ARGUMENTS], double number[3])
{
    const struct scarp_recipe_function *const f = scarpi_recipe_function_number(function);
    for (int i = 1; i < f->arguments; i++) {
        if (f->argument[i].kind == SCARP_RECIPE_NUMBER) {
            number[i - 1] = f->argument[i].otherwise;
            if (argument[i] >= 0 && !scarpi_recipe_take_number(c, argument[i], &number[i - 1])) {
                return 0;
            }
        }
    }
    return 1;
}

static double cosine(double turns)
{
    return scarpi_sine_of_turns(turns + 0.25);
}

/* u = x / factor along each axis. Returns 0 for a factor that is 0, or too small or large. */
static int set_factors(struct transform *a, const double factor[3], int dimensions)
{
    for (int i = 0; i < dimensions; i++) {
        if (!(fabs(factor[i]) >= 0x1p-40 && fabs(factor[i]) <= 0x1p40)) {
            return 0;
        }
        a->matrix[i][i] = 1.0 / factor[i];
    }
    return 1;
}

/* Turns the picture counterclockwise, seen from the end of the axis. */
static void set_turn(struct transform *a, double turns, int axis)
{
    const int i = (axis + 1) % 3, j = (axis + 2) % 3;
    a->matrix[i][i] = a->matrix[j][j] = cosine(turns);
    a->matrix[i][j] = scarpi_sine_of_turns(turns);
    a->matrix[j][i] = -a->matrix[i][j];
}

/* x of the picture points to where the wind blows, y across it, `by` times longer. */
static void set_wind(struct transform *a, double from, double by)
{
    const double sine = scarpi_sine_of_turns(from / 360.0), other = cosine(from / 360.0);
    a->matrix[0][0] = -sine;
    a->matrix[0][1] = -other;
    a->matrix[1][0] = other / by;
    a->matrix[1][1] = -sine / by;
}

static int axis_of_turn(struct recipe_compiler *c, const int16_t argument[RECIPE_ARGUMENTS])
{
    const struct scarp_recipe_function *const f = scarpi_recipe_function_number(FUNCTION_TURN);
    return argument[2] < 0
               ? 2
               : scarpi_recipe_word_of(c->recipe, c->recipe->expression[argument[2]].name,
                                       &f->argument[2]);
}

/* The transform of a call. Returns 0 on an error. */
static int take_transform(struct recipe_compiler *c, int call, int function, int dimensions,
                          const int16_t argument[RECIPE_ARGUMENTS], struct transform *a)
{
    double k[3] = {0.0, 0.0, 0.0};
    if (!take_numbers(c, function, argument, k)) {
        return 0;
    }
    const double equal[3] = {k[0], k[0], k[0]};
    const double across[3] = {1.0, k[1], 1.0};
    int good = 1;
    switch (function) {
    case FUNCTION_TURN: {
        const int axis = axis_of_turn(c, argument);
        good = fabs(k[0]) <= 0x1p40;
        if (dimensions == 2 && axis != 2) {
            return scarpi_recipe_bad(c, call, "the plane turns around z alone", NULL), 0;
        }
        set_turn(a, good ? k[0] / 360.0 : 0.0, axis);
        break;
    }
    case FUNCTION_MOVE:
        for (int i = 0; i < dimensions; i++) {
            a->t[i] = -k[i];
            good = good && fabs(k[i]) <= 0x1p60;
        }
        break;
    case FUNCTION_WIND:
        good = set_factors(a, across, dimensions) && fabs(k[0]) <= 0x1p40;
        set_wind(a, good ? k[0] : 0.0, good ? k[1] : 1.0);
        break;
    default: good = set_factors(a, function == FUNCTION_SCALE ? equal : k, dimensions); break;
    }
    return good || (scarpi_recipe_bad(c, call, "a number is 0, or too small or large", NULL), 0);
}

int scarpi_recipe_place_inside(struct recipe_compiler *c, int call, int function, int place,
                               const int16_t argument[RECIPE_ARGUMENTS])
{
    struct transform a = {.matrix = {{1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}}};
    const int dimensions = c->recipe->place[place].dimensions;
    switch (function) {
    case FUNCTION_WARP: return warped(c, place, argument);
    case FUNCTION_FLAT: return flattened(c, call, place);
    case FUNCTION_AT: return looking_at(c, call, place, argument);
    default:
        return take_transform(c, call, function, dimensions, argument, &a)
                   ? transformed(c, call, place, &a)
                   : -1;
    }
}

/* Whether the coordinates of a place are those of its frame. */
static int is_frame(const struct recipe *recipe, int place)
{
    const struct recipe_place *const p = &recipe->place[place];
    int same = p->dimensions == scarpi_recipe_frame_dimensions(recipe, p->frame);
    for (int i = 0; i < p->dimensions; i++) {
        same = same && p->t[i] == 0.0 && p->rest[i] < 0;
        for (int j = 0; j < 3; j++) {
            same = same && p->m[i][j] == (i == j ? 1.0 : 0.0);
        }
    }
    return same;
}

int scarpi_recipe_framed(struct recipe_compiler *c, int e, int place)
{
    const int p = scarpi_recipe_spelled_out(c, e, place);
    if (p < 0 || is_frame(c->recipe, p)) {
        return p;
    }
    int frames = 0;
    for (int i = c->recipe->place[p].frame; i >= 0; i = c->recipe->place[i].frame) {
        frames++;
    }
    if (frames == RECIPE_FRAMES) {
        return scarpi_recipe_bad(c, e,
                                 "slopes and gullies are nested more than 3 deep, at places "
                                 "that are transformed",
                                 NULL)
            .node;
    }
    struct recipe_place q = {.rest = {-1, -1, -1},
                             .frame = (int16_t)p,
                             .warp = -1,
                             .before = -1,
                             .dimensions = c->recipe->place[p].dimensions};
    for (int i = 0; i < q.dimensions; i++) {
        q.m[i][i] = 1.0;
    }
    return added(c, e, q);
}

struct recipe_value scarpi_recipe_pulled(struct recipe_compiler *c, int e, int place,
                                         struct recipe_value value)
{
    const int p = scarpi_recipe_spelled_out(c, e, place);
    if (value.kind != SCARP_RECIPE_FIELD || p < 0 || is_frame(c->recipe, p)) {
        return value;
    }
    struct recipe_node node = scarpi_recipe_operation(OP_PULL, value.node, -1);
    node.place = (int16_t)p;
    return scarpi_recipe_node(c, e, node);
}
