/* SPDX-License-Identifier: MIT
 *
 * Places: what warp(), turn(), at() and their like make of the place at which they are called.
 */
#include <math.h>
#include <string.h>

#include "../calls/partials.h"
#include "compile.h"
#include "graph.h"

/* u = matrix x + t */
struct transform {
    double matrix[3][3], t[3];
};

/* The place u = A v + t, where v is a place. */
static int mapped(struct recipe_compiler *c, int e, int place, const struct transform *a)
{
    const int from = scarpi_recipe_spelled_out(c, e, place);
    if (from < 0) {
        return RECIPE_BAD;
    }
    const struct recipe_place p = c->recipe->place[from];
    struct recipe_place q = p;
    for (int i = 0; i < p.dimensions; i++) {
        int rest = RECIPE_NONE;
        q.t[i] = a->t[i];
        for (int j = 0; j < 3; j++) {
            q.m[i][j] = a->matrix[i][0] * p.m[0][j] + a->matrix[i][1] * p.m[1][j] +
                        a->matrix[i][2] * p.m[2][j];
        }
        for (int j = 0; j < p.dimensions && rest != RECIPE_BAD; j++) {
            q.t[i] += a->matrix[i][j] * p.t[j];
            if (p.rest[j] >= 0 && a->matrix[i][j] != 0.0) {
                const int part = scarpi_recipe_affine(c, e, p.rest[j], a->matrix[i][j], 0.0).node;
                rest = scarpi_recipe_sum(c, e, rest, part);
            }
        }
        if (rest == RECIPE_BAD) {
            return RECIPE_BAD;
        }
        q.rest[i] = (int16_t)rest;
    }
    return scarpi_recipe_place(c, e, &q);
}

int scarpi_recipe_warped(struct recipe_compiler *c, int e, int place, int noise)
{
    struct recipe_place p = c->recipe->place[place];
    p.warp = (int16_t)noise;
    p.before = (int16_t)place;
    return scarpi_recipe_place(c, e, &p);
}

int scarpi_recipe_looking_at(struct recipe_compiler *c, int call, int place,
                             const struct recipe_linear *coordinate)
{
    struct recipe_place p = c->recipe->place[place];
    for (int i = 0; i < p.dimensions; i++) {
        memcpy(p.m[i], coordinate[i].m, sizeof p.m[i]);
        p.t[i] = coordinate[i].t;
        p.rest[i] = (int16_t)coordinate[i].rest;
    }
    return scarpi_recipe_place(c, call, &p);
}

int scarpi_recipe_flattened(struct recipe_compiler *c, int call, int place, int axis)
{
    const int p = scarpi_recipe_spelled_out(c, call, place);
    if (p < 0) {
        return RECIPE_BAD;
    }
    struct recipe_place q = c->recipe->place[p];
    if (q.dimensions != 3) {
        return scarpi_recipe_bad(
                   c, call, "flat() needs space 3, and must not be inside another flat()", NULL)
            .node;
    }
    q.dimensions = 2;
    for (int i = axis; i < 2; i++) { /* axes behind it move up */
        memcpy(q.m[i], q.m[i + 1], sizeof q.m[i]);
        q.t[i] = q.t[i + 1];
        q.rest[i] = q.rest[i + 1];
    }
    q.m[2][0] = q.m[2][1] = q.m[2][2] = q.t[2] = 0.0;
    q.rest[2] = RECIPE_NONE;
    return scarpi_recipe_place(c, call, &q);
}

static double cosine(double turns)
{
    return scarpi_sine_of_turns(turns + 0.25);
}

/* u = x / factor along each axis. Returns false for a factor that is 0, or too small or large. */
static bool set_factors(struct transform *a, const double factor[3], int dimensions)
{
    for (int i = 0; i < dimensions; i++) {
        if (!(fabs(factor[i]) >= 0x1p-40 && fabs(factor[i]) <= 0x1p40)) {
            return false;
        }
        a->matrix[i][i] = 1.0 / factor[i];
    }
    return true;
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

/* The transform of a call. Returns false if a number is out of range. */
static bool set_transform(struct transform *a, int function, int dimensions, const double k[3],
                          int axis)
{
    const double equal[3] = {k[0], k[0], k[0]};
    const double across[3] = {1.0, k[1], 1.0};
    bool good = true;
    switch (function) {
    case FUNCTION_TURN:
        good = fabs(k[0]) <= 0x1p40;
        set_turn(a, good ? k[0] / 360.0 : 0.0, axis);
        break;
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
    return good;
}

int scarpi_recipe_transformed(struct recipe_compiler *c, int call, int function, int place,
                              const double number[3], int axis)
{
    struct transform a = {.matrix = {{1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}}};
    const int dimensions = c->recipe->place[place].dimensions;
    if (dimensions == 2 && axis != 2) {
        return scarpi_recipe_bad(c, call, "in the plane, turn() turns around z only", NULL).node;
    }
    if (!set_transform(&a, function, dimensions, number, axis)) {
        return scarpi_recipe_bad(c, call, "a number is 0, or too small or large", NULL).node;
    }
    return mapped(c, call, place, &a);
}

/* Whether the coordinates of a place are those of its frame. */
static bool is_frame(const struct recipe *recipe, int place)
{
    const struct recipe_place *const p = &recipe->place[place];
    bool same = p->dimensions == scarpi_recipe_frame_dimensions(recipe, p->frame);
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
                                 "slope() and gullies() are nested more than 3 deep, at places "
                                 "that are transformed",
                                 NULL)
            .node;
    }
    struct recipe_place q = {.rest = {RECIPE_NONE, RECIPE_NONE, RECIPE_NONE},
                             .frame = (int16_t)p,
                             .warp = RECIPE_NONE,
                             .before = RECIPE_NONE,
                             .dimensions = c->recipe->place[p].dimensions};
    for (int i = 0; i < q.dimensions; i++) {
        q.m[i][i] = 1.0;
    }
    return scarpi_recipe_place(c, e, &q);
}

struct recipe_value scarpi_recipe_pulled(struct recipe_compiler *c, int e, int place,
                                         struct recipe_value value)
{
    const int p = scarpi_recipe_spelled_out(c, e, place);
    if (value.kind != SCARP_RECIPE_FIELD || p < 0 || is_frame(c->recipe, p)) {
        return value;
    }
    struct recipe_node node = scarpi_recipe_operation(OP_PULL, value.node, RECIPE_NONE);
    node.place = (int16_t)p;
    return scarpi_recipe_node(c, e, node);
}
