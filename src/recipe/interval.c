/* SPDX-License-Identifier: MIT */
#include "interval.h"

#include <math.h>
#include <string.h>

#include "graph.h"
#include "operations.h"
#include "statuses.h"

typedef struct recipe_interval bounds;

static bounds whole(void)
{
    return (bounds){-INFINITY, INFINITY};
}

static bounds between(float a, float b)
{
    if (a != a || b != b) { /* infinities met */
        return whole();
    }
    return a <= b ? (bounds){a, b} : (bounds){b, a};
}

static float less(float a, float b)
{
    return a < b ? a : b;
}

static float greater(float a, float b)
{
    return a > b ? a : b;
}

/* As scarp_multiply has products: 0 where a factor is 0, infinities too. */
static float product(float a, float b)
{
    return a == 0.0f || b == 0.0f ? 0.0f : a * b;
}

static bounds multiply(bounds a, bounds b, int is_square)
{
    const float p[4] = {product(a.lowest, b.lowest), product(a.lowest, b.highest),
                        product(a.highest, b.lowest), product(a.highest, b.highest)};
    bounds r = {p[0], p[0]};
    for (int i = 1; i < 4; i++) {
        r.lowest = less(r.lowest, p[i]);
        r.highest = greater(r.highest, p[i]);
    }
    if (is_square) {
        r.lowest = a.lowest <= 0.0f && a.highest >= 0.0f ? 0.0f : less(p[0], p[3]);
    }
    return between(r.lowest, r.highest);
}

static bounds divide(bounds a, bounds b)
{
    if (b.lowest <= 0.0f && b.highest >= 0.0f) {
        return whole();
    }
    const float p[4] = {a.lowest / b.lowest, a.lowest / b.highest, a.highest / b.lowest,
                        a.highest / b.highest};
    bounds r = {p[0], p[0]};
    for (int i = 0; i < 4; i++) {
        if (p[i] != p[i]) {
            return whole();
        }
        r.lowest = less(r.lowest, p[i]);
        r.highest = greater(r.highest, p[i]);
    }
    return r;
}

static bounds magnitude(bounds a)
{
    const float lowest = a.lowest > 0.0f ? a.lowest : a.highest < 0.0f ? -a.highest : 0.0f;
    return (bounds){lowest, greater(-a.lowest, a.highest)};
}

static float finite_magnitude(float a)
{
    const float magnitude = a < 0.0f ? -a : a;
    return magnitude < INFINITY ? magnitude : 0.0f;
}

/* With some room: of functions that keep order but for rounding, by errors that are relative to the
   result. A value of smoothstep is below one of a smaller t by 4.2 * 2^-24 of itself at most (found
   by trying all floats t), and heights of terraces are rounded twice. Others that take this room
   need none. */
static bounds widened(float a, float b)
{
    bounds r = between(a, b);
    const float room = greater(finite_magnitude(r.lowest), finite_magnitude(r.highest)) * 0x1p-21f;
    r.lowest -= room;
    r.highest += room;
    return r;
}

/*
 * How far a value between two knots may be beyond those at the ends of an interval. These are of
 * one cubic, y + q with q = t (s0 + t (c2 + t c3)), which is held between its knots. With exact
 * sums of the floats y, rise, s0 and s1 it would not fall where it rises, since s0 and s1 are from
 * 0 to 2 rise. So a value is out of order by twice the error of y + q at most. With u = 2^-24, in
 * units of u rise:
 *
 *     c2 = 3 rise - 2 s0 - s1     9: each step is up to 3 rise
 *     c3 = s0 + s1 - 2 rise       6: steps up to 4 rise and 2 rise
 *     c2 + t c3                  20: 9, 6, and 2 and 3 for what is rounded here
 *     s0 + t (...)               25: 20, 3 and 2, since no slope is above 2 rise
 *     t (...)                    26
 *
 * and y + q is rounded by u of the larger knot. Twice 26 and 1 are 52 and 2: 56 and 4 have room for
 * terms in u^2, for t up to 1 + 2 u, and for the rounding of the ends. Slopes of knots are
 * subnormal if a segment rises by less than 2^-65: then it may be anywhere between its knots.
 */
static double room_of_cubic(bounds knots)
{
    const double rise = (double)knots.highest - (double)knots.lowest;
    const double most = (double)greater(-knots.lowest, knots.highest);
    return (56.0 * rise + 4.0 * most) * 0x1p-24 + 0x1p-64;
}

/* A level curve beyond its ends, with slopes that never overshoot: between knots it has no value
   that its two knots do not enclose. */
static bounds curve(const struct recipe *recipe, const struct recipe_node *n, bounds a)
{
    const float(*const knot)[2] = (const float(*)[2])recipe->knot[n->index];
    bounds r = {INFINITY, -INFINITY};
    for (int i = 0; i < n->knots; i++) {
        const int is_left = i + 1 < n->knots && knot[i + 1][0] <= a.lowest;
        const int is_right = i > 0 && knot[i - 1][0] >= a.highest;
        if (!is_left && !is_right) {
            r.lowest = less(r.lowest, knot[i][1]);
            r.highest = greater(r.highest, knot[i][1]);
        }
    }
    float ends[2] = {a.lowest, a.highest}; /* tighter, where the curve is monotone between */
    float values[2];
    int inside = 0;
    for (int i = 0; i < n->knots; i++) {
        inside += knot[i][0] > a.lowest && knot[i][0] < a.highest;
    }
    if (inside == 0) {
        if (scarpi_recipe_curve(recipe, n, 2, ends, values) != SCARP_OK) {
            return whole();
        }
        const bounds tight = between(values[0], values[1]);
        const double room = room_of_cubic(r);
        r.lowest = greater(r.lowest, (float)((double)tight.lowest - room));
        r.highest = less(r.highest, (float)((double)tight.highest + room));
    }
    return r;
}

static bounds terrace(const struct recipe_node *n, bounds a)
{
    /* Values stay between the multiples of 1 / steps around them. */
    const float steps = n->k[0];
    const float lowest = floorf(a.lowest * steps) / steps,
                highest = -floorf(-(a.highest * steps)) / steps;
    return widened(lowest, highest);
}

static bounds smoothstep(const struct recipe_node *n, bounds a)
{
    float value[2] = {a.lowest, a.highest}, out[2];
    for (int i = 0; i < 2; i++) { /* infinities are NaN to the function, and its ends are level */
        value[i] = less(greater(value[i], -0x1p120f), 0x1p120f);
    }
    const struct scarp_samples in = {.value = value}, to = {.value = out};
    if (scarp_smoothstep(2, &in, n->k[0], n->k[1], &to) != SCARP_OK) {
        return whole();
    }
    const bounds r = widened(out[0], out[1]);
    return (bounds){greater(r.lowest, 0.0f), less(r.highest, 1.0f)};
}

static bounds noise(const struct recipe *recipe, const struct recipe_node *n)
{
    struct scarp_noise levels[5];
    bounds r;
    scarpi_recipe_spell_noise(recipe, n->index, levels);
    const int dimensions = recipe->place[n->place].dimensions;
    const enum scarp_status status = scarp_range(&levels[0], dimensions, &r.lowest, &r.highest);
    return status == SCARP_OK ? r : whole();
}

static bounds cell(const struct recipe *recipe, const struct recipe_node *n)
{
    struct scarp_noise levels[5];
    scarpi_recipe_spell_noise(recipe, n->index, levels);
    const double jitter = levels[0].jitter != 0.0f ? (double)levels[0].jitter : 1.0;
    const double frequency = levels[0].frequency != 0.0 ? levels[0].frequency : 1.0;
    const int is_plane = recipe->place[n->place].dimensions == 2;
    if (n->detail == 0) {
        return (bounds){-1.0f, 1.0f};
    }
    /* See "Cells" in scarp.h. */
    const double corner = sqrt(is_plane ? 2.0 : 3.0) * (1.0 + jitter) / 2.0;
    const double second = sqrt(1.0 + jitter + jitter * jitter * (is_plane ? 0.5 : 0.75));
    const double most = n->detail == 2 && second > corner ? second : corner;
    return (bounds){0.0f, (float)(most / frequency * (1.0 + 0x1p-20))};
}

static bounds gullies(const struct recipe *recipe, const struct recipe_node *n)
{
    bounds r;
    const enum scarp_status status =
        scarp_gullies_range(&recipe->gully[n->index], 0.0f, 0.0f, &r.lowest, &r.highest);
    return status == SCARP_OK ? r : whole();
}

struct reader {
    const struct recipe *recipe;
    const struct recipe_interval *of;
    const struct scarp_box *box;
};

static double larger(double a, double b)
{
    return fabs(a) > fabs(b) ? fabs(a) : fabs(b);
}

/* The interval of coordinate i of a place, in double, with room for float coordinates. */
static void coordinate(const struct reader *by, int place, int i, double *lowest, double *highest)
{
    const struct recipe_place *const p = &by->recipe->place[place];
    double lo = p->t[i], hi = p->t[i], most = fabs(p->t[i]);
    for (int j = 0; j < 3; j++) {
        double a = -(double)INFINITY, b = (double)INFINITY;
        if (p->m[i][j] == 0.0) {
            continue;
        }
        if (p->frame >= 0) {
            coordinate(by, p->frame, j, &a, &b);
        } else if (by->box != NULL) {
            a = by->box->lowest[j];
            b = by->box->highest[j];
        }
        const double from = p->m[i][j] * (p->m[i][j] > 0.0 ? a : b);
        const double to = p->m[i][j] * (p->m[i][j] > 0.0 ? b : a);
        lo += from;
        hi += to;
        most += larger(from, to);
    }
    if (p->rest[i] >= 0) {
        const bounds r =
            by->of != NULL ? by->of[p->rest[i]] : by->recipe->node[p->rest[i]].interval;
        lo += (double)r.lowest;
        hi += (double)r.highest;
        most += larger((double)r.lowest, (double)r.highest);
    }
    *lowest = lo - most * 0x1p-20;
    *highest = hi + most * 0x1p-20;
    if (!(*lowest <= *highest)) {
        *lowest = -(double)INFINITY;
        *highest = (double)INFINITY;
    }
}

static bounds of_one(const struct recipe *recipe, const struct recipe_node *n, bounds a)
{
    float lowest = greater(a.lowest, 0.0f), highest = greater(a.highest, 0.0f);
    switch (n->operation) {
    case OP_AFFINE:
        return between(product(n->k[0], a.lowest) + n->k[1], product(n->k[0], a.highest) + n->k[1]);
    case OP_CLAMP:
        return (bounds){less(greater(a.lowest, n->k[0]), n->k[1]),
                        less(greater(a.highest, n->k[0]), n->k[1])};
    case OP_ABS: return magnitude(a);
    case OP_SMOOTH_ABS:
        a = magnitude(a);
        lowest = sqrtf(a.lowest * a.lowest + n->k[0] * n->k[0]);
        highest = sqrtf(a.highest * a.highest + n->k[0] * n->k[0]);
        return widened(lowest, highest);
    case OP_SMOOTHSTEP: return smoothstep(n, a);
    case OP_TERRACE: return terrace(n, a);
    case OP_CURVE: return curve(recipe, n, a);
    case OP_SQRT: return (bounds){sqrtf(lowest), sqrtf(highest)};
    case OP_SINE:
    case OP_PULSE: return (bounds){-1.0f, 1.0f};
    case OP_SLOPE: return (bounds){0.0f, INFINITY};
    default: return a;
    }
}

static bounds of_two(const struct recipe_node *n, bounds a, bounds b)
{
    switch (n->operation) {
    case OP_ADD: {
        const bounds r = {a.lowest + b.lowest, a.highest + b.highest};
        return r.lowest <= r.highest ? r : whole();
    }
    case OP_MULTIPLY: return multiply(a, b, n->in[0] == n->in[1]);
    case OP_DIVIDE: return divide(a, b);
    case OP_MIN: return (bounds){less(a.lowest, b.lowest), less(a.highest, b.highest)};
    case OP_MAX: return (bounds){greater(a.lowest, b.lowest), greater(a.highest, b.highest)};
    case OP_SMOOTH_MIN: {
        const float lowest = less(a.lowest, b.lowest), highest = less(a.highest, b.highest);
        return widened(lowest - n->k[0] * 0.16666669f, highest);
    }
    case OP_SMOOTH_MAX: {
        const float lowest = greater(a.lowest, b.lowest), highest = greater(a.highest, b.highest);
        return widened(lowest, highest + n->k[0] * 0.16666669f);
    }
    default: /* OP_MIX, whose mask is in [0, 1] */
        return widened(less(a.lowest, b.lowest), greater(a.highest, b.highest));
    }
}

struct recipe_interval scarpi_recipe_interval_of(const struct recipe *recipe,
                                                 const struct recipe_node *n,
                                                 const struct recipe_interval *of,
                                                 const struct scarp_box *box)
{
    bounds in[2] = {whole(), whole()};
    for (int i = 0; i < 2; i++) {
        if (n->in[i] >= 0) {
            in[i] = of != NULL ? of[n->in[i]] : recipe->node[n->in[i]].interval;
        }
    }
    switch (n->operation) {
    case OP_CONSTANT: return (bounds){n->k[0], n->k[0]};
    case OP_COORDINATE: {
        const struct reader by = {recipe, of, box};
        double lowest, highest;
        coordinate(&by, n->place, n->detail, &lowest, &highest);
        return (bounds){(float)lowest, (float)highest};
    }
    case OP_NOISE:
    case OP_VECTOR: return noise(recipe, n);
    case OP_CELL: return cell(recipe, n);
    case OP_GULLIES: return gullies(recipe, n);
    default: break;
    }
    return n->in[1] >= 0 ? of_two(n, in[0], in[1]) : of_one(recipe, n, in[0]);
}

struct recipe_interval scarpi_recipe_interval_in(const struct recipe *recipe, int node,
                                                 const struct scarp_box *box)
{
    struct recipe_interval of[RECIPE_NODES];
    for (int i = 0; i <= node; i++) {
        const bounds any = recipe->node[i].interval;
        of[i] = scarpi_recipe_interval_of(recipe, &recipe->node[i], of, box);
        of[i].lowest = greater(of[i].lowest, any.lowest);
        of[i].highest = less(of[i].highest, any.highest);
    }
    return of[node];
}
