/* SPDX-License-Identifier: MIT
 *
 * Intervals of nodes. Functions of plan/functions.def have a rule each, by its name there.
 */
#include "interval.h"

#include <math.h>

#include "combine.h"
#include "graph.h"

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

static float more(float a, float b)
{
    return a > b ? a : b;
}

/*
 * Rules of plan/functions.def, of the intervals a and b of the first two inputs: rule_<range>().
 */

struct operands {
    const struct recipe *recipe;
    const struct recipe_node *node;
    bounds a, b;
};

/* For functions with values between -1 and 1 */
static bounds rule_unit(const struct operands *o)
{
    (void)o;
    return (bounds){-1.0f, 1.0f};
}

/* For functions with any value from 0 on */
static bounds rule_length(const struct operands *o)
{
    (void)o;
    return (bounds){0.0f, INFINITY};
}

static bounds rule_sum(const struct operands *o)
{
    const bounds r = {o->a.lowest + o->b.lowest, o->a.highest + o->b.highest};
    return r.lowest <= r.highest ? r : whole();
}

/* As scarp_multiply has products: 0 where a factor is 0, infinities too. */
static float times(float a, float b)
{
    return a == 0.0f || b == 0.0f ? 0.0f : a * b;
}

static bounds rule_product(const struct operands *o)
{
    const bounds a = o->a, b = o->b;
    const float p[4] = {times(a.lowest, b.lowest), times(a.lowest, b.highest),
                        times(a.highest, b.lowest), times(a.highest, b.highest)};
    bounds r = {p[0], p[0]};
    for (int i = 1; i < 4; i++) {
        r.lowest = less(r.lowest, p[i]);
        r.highest = more(r.highest, p[i]);
    }
    if (o->node->in[0] == o->node->in[1]) {
        r.lowest = a.lowest <= 0.0f && a.highest >= 0.0f ? 0.0f : less(p[0], p[3]);
    }
    return between(r.lowest, r.highest);
}

static bounds rule_quotient(const struct operands *o)
{
    const bounds a = o->a, b = o->b;
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
        r.highest = more(r.highest, p[i]);
    }
    return r;
}

static bounds rule_affine(const struct operands *o)
{
    const float *const k = o->node->k;
    return between(times(k[0], o->a.lowest) + k[1], times(k[0], o->a.highest) + k[1]);
}

static bounds rule_lesser(const struct operands *o)
{
    return (bounds){less(o->a.lowest, o->b.lowest), less(o->a.highest, o->b.highest)};
}

static bounds rule_greater(const struct operands *o)
{
    return (bounds){more(o->a.lowest, o->b.lowest), more(o->a.highest, o->b.highest)};
}

static bounds rule_clamped(const struct operands *o)
{
    const float lo = o->node->k[0], hi = o->node->k[1];
    return (bounds){less(more(o->a.lowest, lo), hi), less(more(o->a.highest, lo), hi)};
}

static bounds rule_root(const struct operands *o)
{
    return (bounds){sqrtf(more(o->a.lowest, 0.0f)), sqrtf(more(o->a.highest, 0.0f))};
}

static bounds rule_magnitude(const struct operands *o)
{
    const bounds a = o->a;
    const float lowest = a.lowest > 0.0f ? a.lowest : a.highest < 0.0f ? -a.highest : 0.0f;
    return (bounds){lowest, more(-a.lowest, a.highest)};
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
    const float room = more(finite_magnitude(r.lowest), finite_magnitude(r.highest)) * 0x1p-21f;
    r.lowest -= room;
    r.highest += room;
    return r;
}

static bounds rule_smooth_lesser(const struct operands *o)
{
    const bounds r = rule_lesser(o);
    return widened(r.lowest - o->node->k[0] * 0.16666669f, r.highest);
}

static bounds rule_smooth_greater(const struct operands *o)
{
    const bounds r = rule_greater(o);
    return widened(r.lowest, r.highest + o->node->k[0] * 0.16666669f);
}

static bounds rule_smooth_magnitude(const struct operands *o)
{
    const bounds a = rule_magnitude(o);
    const float round = o->node->k[0];
    return widened(sqrtf(a.lowest * a.lowest + round * round),
                   sqrtf(a.highest * a.highest + round * round));
}

/* Of the blend by a mask in [0, 1] */
static bounds rule_blend(const struct operands *o)
{
    return widened(less(o->a.lowest, o->b.lowest), more(o->a.highest, o->b.highest));
}

/* Values of terraces stay between the multiples of 1 / steps around them. */
static bounds rule_steps(const struct operands *o)
{
    const float count = o->node->k[0];
    return widened(floorf(o->a.lowest * count) / count, -floorf(-(o->a.highest * count)) / count);
}

/* Between the values at the ends of an interval, of a function of one input */
static bounds at_ends(const struct operands *o, bounds a)
{
    float value[2] = {a.lowest, a.highest}, out[2];
    const struct scarp_samples in[3] = {{.value = value}}, to = {.value = out};
    const enum scarp_status status = scarpi_recipe_combine(o->recipe, o->node, 2, in, &to);
    return status == SCARP_OK ? between(out[0], out[1]) : whole();
}

/* For functions that only rise, or only fall, but for rounding */
static bounds rule_rising(const struct operands *o)
{
    const bounds r = at_ends(o, o->a);
    return widened(r.lowest, r.highest);
}

/* A step is level beyond its ends, and infinities would be NaN to it. */
static bounds rule_step(const struct operands *o)
{
    struct operands held = *o;
    held.a.lowest = less(more(o->a.lowest, -0x1p120f), 0x1p120f);
    held.a.highest = less(more(o->a.highest, -0x1p120f), 0x1p120f);
    const bounds r = rule_rising(&held);
    return (bounds){more(r.lowest, 0.0f), less(r.highest, 1.0f)};
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
    const double most = (double)more(-knots.lowest, knots.highest);
    return (56.0 * rise + 4.0 * most) * 0x1p-24 + 0x1p-64;
}

/* A level curve beyond its ends, with slopes that never overshoot: between knots it has no value
   that its two knots do not enclose. */
static bounds rule_curve(const struct operands *o)
{
    const struct recipe_node *const n = o->node;
    const float(*const knot)[2] = (const float(*)[2])o->recipe->knot[n->index];
    const bounds a = o->a;
    bounds r = {INFINITY, -INFINITY};
    for (int i = 0; i < n->knots; i++) {
        const int is_left = i + 1 < n->knots && knot[i + 1][0] <= a.lowest;
        const int is_right = i > 0 && knot[i - 1][0] >= a.highest;
        if (!is_left && !is_right) {
            r.lowest = less(r.lowest, knot[i][1]);
            r.highest = more(r.highest, knot[i][1]);
        }
    }
    int inside = 0;
    for (int i = 0; i < n->knots; i++) {
        inside += knot[i][0] > a.lowest && knot[i][0] < a.highest;
    }
    if (inside == 0) { /* tighter, where the curve is monotone between */
        const bounds tight = at_ends(o, a);
        const double room = room_of_cubic(r);
        r.lowest = more(r.lowest, (float)((double)tight.lowest - room));
        r.highest = less(r.highest, (float)((double)tight.highest + room));
    }
    return r;
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

/* With room for float coordinates */
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

void scarpi_recipe_coordinate(const struct recipe *recipe, int place, int i,
                              const struct recipe_interval *of, const struct scarp_box *box,
                              double *lowest, double *highest)
{
    const struct reader by = {recipe, of, box};
    coordinate(&by, place, i, lowest, highest);
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
    const struct operands o = {recipe, n, in[0], in[1]};
#define OPERATOR(NAME, name, FORM, COMPUTED, take, traits, range, ...)                             \
    case OP_##NAME:                                                                                \
        return rule_##range(&o);
#define FUNCTION(...) OPERATOR(__VA_ARGS__)
    switch (n->operation) {
#include "../plan/functions.def"
    case OP_CONSTANT: return (bounds){n->k[0], n->k[0]};
    case OP_COORDINATE: {
        double lowest, highest;
        scarpi_recipe_coordinate(recipe, n->place, n->detail, of, box, &lowest, &highest);
        return (bounds){(float)lowest, (float)highest};
    }
    case OP_NOISE:
    case OP_VECTOR: return of != NULL ? n->interval : noise(recipe, n);
    case OP_CELL: return of != NULL ? n->interval : cell(recipe, n);
    case OP_GULLIES: return of != NULL ? n->interval : gullies(recipe, n);
    default: return in[0]; /* a component, or what is pulled */
    }
}

struct recipe_interval scarpi_recipe_interval_in(const struct recipe *recipe, int node,
                                                 const struct scarp_box *box)
{
    struct recipe_interval of[RECIPE_NODES];
    for (int i = 0; i <= node; i++) {
        const bounds any = recipe->node[i].interval;
        of[i] = scarpi_recipe_interval_of(recipe, &recipe->node[i], of, box);
        of[i].lowest = more(of[i].lowest, any.lowest);
        of[i].highest = less(of[i].highest, any.highest);
    }
    return of[node];
}
