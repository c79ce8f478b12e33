/* SPDX-License-Identifier: MIT
 *
 * The oracle of recipes: what each function is worth at a point, with its derivatives.
 */
#include "oracle_recipe.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "oracle_gullies.h"
#include "oracle_jet.h"
#include "oracle_recipe_text.h"

/* The value and the derivatives of an oracle's noise, by its coordinates. */
static jet jet_of(const struct oracle *noise, const struct place *at)
{
    const double u[3] = {at->u[0].value, at->u[1].value,
                         at->dimensions == 3 ? at->u[2].value : 0.0};
    struct oracle_sample s;
    jet r;
    oracle_evaluate(noise, ORACLE_EXACT, u, &s);
    r.value = s.value;
    memcpy(r.first, s.gradient, sizeof r.first);
    memcpy(r.second, s.hessian, sizeof r.second);
    return r;
}

/* Tiles repeat by their nature where cells fit; what is here are their periods at a place,
   whose axes are those of the points. */
static void set_periods(const struct oracle_recipe *o, struct scarp_noise *n,
                        const struct place *at)
{
    for (int i = 0; o->tile[0] > 0.0 && i < at->dimensions; i++) {
        const int along = at->dimensions == 2 && at->u[i].first[i] == 0.0 ? i + 1 : i;
        n->period[i] =
            (uint32_t)(o->tile[along] * fabs(at->u[i].first[along]) * n->frequency + 0.5);
    }
}

static void displace(const struct oracle_recipe *o, int part, const struct place *at, jet shift[3],
                     const double scale[3])
{
    const int call = oracle_call_of(o, part);
    if (oracle_is(o, o->part[call].name, "warp")) { /* a noise that is bent itself */
        struct place moved = *at;
        jet inner[3];
        displace(o, oracle_argument(o, call, "by", 1), at, inner, scale);
        for (int i = 0; i < at->dimensions; i++) {
            moved.u[i] = add(at->u[i], inner[i], 1.0);
        }
        displace(o, oracle_argument(o, call, "f", 0), &moved, shift, scale);
        return;
    }
    struct scarp_noise n = oracle_noise_of(o, call);
    struct place straight = *at;
    for (int i = 0; i < at->dimensions; i++) {
        memset(&straight.u[i], 0, sizeof straight.u[i]);
        straight.u[i].first[i] = scale[i];
    }
    set_periods(o, &n, &straight);
    for (int i = 0; i < at->dimensions; i++) {
        struct oracle noise;
        oracle_make_component(&noise, &n, at->dimensions, i);
        shift[i] = composed(jet_of(&noise, at), at);
    }
}

/* The scale of a place along each axis, without what noise displaces: for tiles. It is 1 but for
   what stretch() and its like make of it, which `part` is in. */
struct frame {
    struct place at;
    double scale[3];
    int shift[3]; /* by how many axes flat() moved each one */
};

static jet evaluate_in(const struct oracle_recipe *o, int part, const struct frame *in);

static jet sampled(const struct oracle_recipe *o, int call, const struct frame *in)
{
    struct oracle_recipe *const cache = (struct oracle_recipe *)(uintptr_t)o;
    if (o->tile[0] == 0.0 && o->made[call] != NULL &&
        o->made[call]->dimensions == in->at.dimensions) {
        return composed(jet_of(o->made[call], &in->at), &in->at);
    }
    struct scarp_noise n = oracle_noise_of(o, call);
    struct place straight = {.dimensions = in->at.dimensions};
    for (int i = 0; i < 3; i++) {
        straight.u[i].first[i + in->shift[i]] = in->scale[i];
    }
    set_periods(o, &n, &straight);
    if (o->made[call] == NULL) {
        cache->made[call] = malloc(sizeof *cache->made[call]);
    }
    oracle_make(o->made[call], &n, in->at.dimensions);
    return composed(jet_of(o->made[call], &in->at), &in->at);
}

static jet celled(const struct oracle_recipe *o, int call, const struct frame *in)
{
    const int noise = oracle_call_of(o, oracle_argument(o, call, "n", 0));
    struct scarp_noise n = oracle_noise_of(o, noise);
    const struct scarp_noise first = {.seed = n.seed,
                                      .frequency = n.frequency,
                                      .jitter = n.jitter,
                                      .offset_first = n.offset_first,
                                      .basis = oracle_has_word(o, call, "f1")   ? SCARP_CELL_F1
                                               : oracle_has_word(o, call, "f2") ? SCARP_CELL_F2
                                                                                : SCARP_CELL_VALUE,
                                      .period = {n.period[0], n.period[1], n.period[2]}};
    struct scarp_noise tiled = first;
    struct place straight = {.dimensions = in->at.dimensions};
    for (int i = 0; i < 3; i++) {
        straight.u[i].first[i + in->shift[i]] = in->scale[i];
    }
    set_periods(o, &tiled, &straight);
    struct oracle made;
    struct oracle_sample s;
    const double u[3] = {in->at.u[0].value, in->at.u[1].value,
                         in->at.dimensions == 3 ? in->at.u[2].value : 0.0};
    oracle_make(&made, &tiled, in->at.dimensions);
    oracle_octave_at(&made, ORACLE_EXACT, 0, u, &s);
    jet r = constant(s.value * made.supremum + made.middle);
    if (first.basis == SCARP_CELL_VALUE) {
        return r;
    }
    r.value /= first.frequency;
    for (int i = 0; i < in->at.dimensions; i++) {
        r.first[i] = s.gradient[i] * made.supremum;
    }
    return composed(r, &in->at);
}

static jet curved(const struct oracle_recipe *o, int call, const struct frame *in)
{
    int child[64], knot[64][2];
    const int count = oracle_parts(o, call, child) - 1;
    double x[64], y[64], s[64] = {0.0};
    const jet a = evaluate_in(o, child[0], in);
    for (int i = 0; i < count; i++) {
        (void)oracle_parts(o, child[i + 1], knot[i]);
        x[i] = (double)(float)o->number(o, knot[i][0]);
        y[i] = (double)(float)o->number(o, knot[i][1]);
    }
    for (int i = 1; i < count - 1; i++) {
        const double l = (y[i] - y[i - 1]) / (x[i] - x[i - 1]);
        const double r = (y[i + 1] - y[i]) / (x[i + 1] - x[i]);
        s[i] = l * r > 0.0 ? 2.0 * l * r / (l + r) : 0.0;
    }
    if (a.value <= x[0] || a.value >= x[count - 1]) {
        return constant(a.value <= x[0] ? y[0] : y[count - 1]);
    }
    int k = 0;
    while (a.value >= x[k + 1]) {
        k++;
    }
    /* Hermite's cubic */
    const double w = x[k + 1] - x[k], t = (a.value - x[k]) / w;
    const double f = (1.0 + 2.0 * t) * (1.0 - t) * (1.0 - t) * y[k] +
                     t * (1.0 - t) * (1.0 - t) * w * s[k] + t * t * (3.0 - 2.0 * t) * y[k + 1] +
                     t * t * (t - 1.0) * w * s[k + 1];
    const double fa = 6.0 * t * (t - 1.0) * (y[k] - y[k + 1]) / w +
                      (1.0 - t) * (1.0 - 3.0 * t) * s[k] + t * (3.0 * t - 2.0) * s[k + 1];
    const double faa = ((12.0 * t - 6.0) * (y[k] - y[k + 1]) / w + (6.0 * t - 4.0) * s[k] +
                        (6.0 * t - 2.0) * s[k + 1]) /
                       w;
    return apply(a, f, fa, faa);
}

static jet blended(const struct oracle_recipe *o, int call, const struct frame *in)
{
    int child[64], knot[2];
    const int count = oracle_parts(o, call, child) - 1;
    const jet a = evaluate_in(o, child[0], in);
    jet result = constant(0.0);
    double before = 0.0;
    for (int i = 0; i < count; i++) {
        int both[64];
        (void)oracle_parts(o, child[i + 1], both);
        knot[0] = both[0];
        knot[1] = both[1];
        const double x = o->number(o, knot[0]);
        const jet f = evaluate_in(o, knot[1], in);
        result = i == 0 ? f : mix(result, f, smooth_step(a, before, x));
        before = x;
    }
    return result;
}

static jet sloped(const struct oracle_recipe *o, int call, const struct frame *in)
{
    struct frame inner = *in;
    inner.at = own(&in->at);
    const jet f = evaluate_in(o, oracle_argument(o, call, "a", 0), &inner);
    jet r =
        constant(sqrt(f.first[0] * f.first[0] + f.first[1] * f.first[1] + f.first[2] * f.first[2]));
    for (int i = 0; i < 3 && r.value > 0.0; i++) {
        for (int j = 0; j < 3; j++) {
            r.first[i] += f.first[j] * f.second[i][j] / r.value;
        }
    }
    return composed(r, &in->at);
}

static double displacement_at(const struct oracle_recipe *o, int call,
                              const struct oracle_gullies *g, const struct frame *in)
{
    const jet f = evaluate_in(o, oracle_argument(o, call, "f", 0), in);
    const double u[2] = {in->at.u[0].value, in->at.u[1].value};
    return oracle_gullies_at(g, u, f.value, f.first);
}

/* The gradient comes from differences of the displacement, which is all that the oracle of gullies
   has. */
static jet gullied(const struct oracle_recipe *o, int call, const struct frame *in, int is_base)
{
    struct oracle_gullies made;
    const struct scarp_gullies g = oracle_gullies_of(o, call);
    struct frame inner = *in;
    const double step = 1e-5 / g.frequency;
    inner.at = own(&in->at);
    oracle_gullies_make(&made, &g);
    jet r = constant(displacement_at(o, call, &made, &inner));
    for (int i = 0; i < 2; i++) {
        double side[2];
        for (int k = 0; k < 2; k++) {
            struct frame near = inner;
            near.at.u[i].value += k == 0 ? -step : step;
            side[k] = displacement_at(o, call, &made, &near);
        }
        r.first[i] = (side[1] - side[0]) / (2.0 * step);
    }
    if (is_base) {
        r = add(r, evaluate_in(o, oracle_argument(o, call, "f", 0), &inner), 1.0);
    }
    return composed(r, &in->at);
}

/* u = matrix u + t */
static struct place transformed(const struct place *at, double matrix[3][3], const double t[3])
{
    struct place p = {.dimensions = at->dimensions};
    for (int i = 0; i < at->dimensions; i++) {
        p.u[i] = constant(t[i]);
        for (int j = 0; j < at->dimensions; j++) {
            p.u[i] = add(p.u[i], at->u[j], matrix[i][j]);
        }
    }
    return p;
}

static double sine(double degrees)
{
    return sin(degrees * 0.017453292519943295);
}

static double cosine(double degrees)
{
    return cos(degrees * 0.017453292519943295);
}

static jet placed(const struct oracle_recipe *o, int call, const struct frame *in)
{
    const uint32_t *const name = o->part[call].name;
    double m[3][3] = {{1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}}, t[3] = {0.0, 0.0, 0.0};
    struct frame inner = *in;
    const int f = oracle_argument(o, call, "f", 0) >= 0 ? oracle_argument(o, call, "f", 0)
                                                        : oracle_argument(o, call, "a", 0);
    if (oracle_is(o, name, "flat")) {
        for (int i = oracle_has_word(o, call, "x")   ? 0
                     : oracle_has_word(o, call, "y") ? 1
                                                     : 2;
             i < 2; i++) {
            inner.at.u[i] = in->at.u[i + 1];
            inner.scale[i] = in->scale[i + 1];
            inner.shift[i] = 1;
        }
        inner.at.dimensions = 2;
        return evaluate_in(o, f, &inner);
    }
    if (oracle_is(o, name, "warp")) {
        jet shift[3];
        displace(o, oracle_argument(o, call, "by", 1), &in->at, shift, in->scale);
        for (int i = 0; i < in->at.dimensions; i++) {
            inner.at.u[i] = add(in->at.u[i], shift[i], 1.0);
        }
        return evaluate_in(o, f, &inner);
    }
    if (oracle_is(o, name, "at")) {
        static const char *const axes[3] = {"u", "v", "w"};
        for (int i = 0; i < in->at.dimensions; i++) {
            inner.at.u[i] = evaluate_in(o, oracle_argument(o, call, axes[i], i + 1), in);
        }
        return evaluate_in(o, f, &inner);
    }
    if (oracle_is(o, name, "turn")) {
        const double d = o->number(o, oracle_argument(o, call, "degrees", 1));
        const int axis = oracle_has_word(o, call, "x") ? 0 : oracle_has_word(o, call, "y") ? 1 : 2;
        const int i = (axis + 1) % 3, j = (axis + 2) % 3;
        m[i][i] = m[j][j] = cosine(d);
        m[i][j] = sine(d);
        m[j][i] = -sine(d);
    } else if (oracle_is(o, name, "move")) {
        t[0] = -o->number(o, oracle_argument(o, call, "dx", 1));
        t[1] = -o->number(o, oracle_argument(o, call, "dy", 2));
        t[2] = -oracle_number_or(o, call, "dz", 3, 0.0);
    } else if (oracle_is(o, name, "wind")) {
        const double from = o->number(o, oracle_argument(o, call, "from", 1));
        const double by = oracle_number_or(o, call, "by", 2, 1.0);
        m[0][0] = -sine(from);
        m[0][1] = -cosine(from);
        m[1][0] = cosine(from) / by;
        m[1][1] = -sine(from) / by;
    } else { /* scale, stretch */
        const int is_scale = oracle_is(o, name, "scale");
        for (int i = 0; i < 3; i++) {
            static const char *const names[3] = {"sx", "sy", "sz"};
            const double by = is_scale ? o->number(o, oracle_argument(o, call, "by", 1))
                                       : oracle_number_or(o, call, names[i], i + 1, 1.0);
            m[i][i] = 1.0 / by;
            inner.scale[i] /= by;
        }
    }
    inner.at = transformed(&in->at, m, t);
    return evaluate_in(o, f, &inner);
}

/* A function of one input by the formulas of functions.def; its numbers come behind the field. */
static jet derived(const struct oracle_recipe *o, int call, jet in)
{
    const uint32_t *const name = o->part[call].name;
    const double a = in.value;
    struct scarp_recipe_function f;
    double k[3] = {0.0, 0.0, 0.0};
    (void)scarp_recipe_function_at((size_t)o->part[call].function, &f);
    for (int i = 1; i < f.arguments; i++) {
        k[i - 1] = oracle_number_or(o, call, f.argument[i].name, i, f.argument[i].otherwise);
    }
#define TURN 6.283185307179586
#define DERIVED(function, value, first, second, ...)                                               \
    if (oracle_is(o, name, #function)) {                                                           \
        return apply(in, value, first, second);                                                    \
    }
#include "functions.def"
    return constant(NAN);
}

static jet called(const struct oracle_recipe *o, int call, const struct frame *in)
{
    const uint32_t *const name = o->part[call].name;
    static const char *const places[] = {"warp",    "turn", "move", "scale",
                                         "stretch", "wind", "at",   "flat"};
    for (size_t i = 0; i < sizeof places / sizeof places[0]; i++) {
        if (oracle_is(o, name, places[i])) {
            return placed(o, call, in);
        }
    }
    if (oracle_is(o, name, "noise")) {
        return sampled(o, call, in);
    }
    if (oracle_is(o, name, "cell")) {
        return celled(o, call, in);
    }
    if (oracle_is(o, name, "curve")) {
        return curved(o, call, in);
    }
    if (oracle_is(o, name, "blend")) {
        return blended(o, call, in);
    }
    if (oracle_is(o, name, "slope")) {
        return sloped(o, call, in);
    }
    if (oracle_is(o, name, "gullies") || oracle_is(o, name, "displacement")) {
        return gullied(o, call, in, oracle_is(o, name, "gullies"));
    }
    const jet a = evaluate_in(o, oracle_argument(o, call, "a", 0), in);
    const int second = oracle_argument(o, call, "b", 1);
    if (oracle_is(o, name, "min") || oracle_is(o, name, "max")) {
        return least(a, evaluate_in(o, second, in), oracle_number_or(o, call, "smooth", 2, 0.0),
                     oracle_is(o, name, "min") ? 1.0 : -1.0);
    }
    if (oracle_is(o, name, "mix")) {
        return mix(a, evaluate_in(o, second, in),
                   evaluate_in(o, oracle_argument(o, call, "m", 2), in));
    }
    if (oracle_is(o, name, "clamp") || oracle_is(o, name, "smoothstep")) {
        const double lo = (double)(float)o->number(o, oracle_argument(o, call, "lo", 1));
        const double hi = (double)(float)o->number(o, oracle_argument(o, call, "hi", 2));
        return oracle_is(o, name, "smoothstep") ? smooth_step(a, lo, hi)
               : a.value < lo                   ? constant(lo)
               : a.value > hi                   ? constant(hi)
                                                : a;
    }
    if (oracle_is(o, name, "terrace")) {
        return terraced(a, o->number(o, oracle_argument(o, call, "steps", 1)),
                        oracle_number_or(o, call, "riser", 2, 0.5),
                        oracle_number_or(o, call, "strength", 3, 0.75));
    }
    return derived(o, call, a);
}

static jet evaluate_in(const struct oracle_recipe *o, int part, const struct frame *in)
{
    const struct scarp_recipe_part *const p = &o->part[part];
    int child[64];
    if (p->function >= 0) {
        return called(o, part, in);
    }
    if (p->operation == 0 && p->name[1] > p->name[0]) {
        for (int i = 0; i < 3; i++) {
            const char axis[2] = {(char)('x' + i), '\0'};
            if (oracle_is(o, p->name, axis)) {
                return in->at.u[i];
            }
        }
        const struct scarp_recipe_entry *const e = &o->entry[p->entry];
        return e->is_param ? constant(e->value) : evaluate_in(o, e->part, in);
    }
    const int count = oracle_parts(o, part, child);
    if (count == 0) {
        return constant(strtod(o->text + p->span[0], NULL));
    }
    const jet a = evaluate_in(o, child[0], in);
    if (count == 1) {
        if (p->operation == '-') {
            return scaled(a, -1.0);
        }
        const int exponent = o->text[p->span[1] - 1] - '0';
        jet r = a;
        for (int i = 1; i < exponent; i++) {
            r = multiply(r, a);
        }
        return r;
    }
    const jet b = evaluate_in(o, child[1], in);
    switch (p->operation) {
    case '+': return add(a, b, 1.0);
    case '-': return add(a, b, -1.0);
    case '*': return multiply(a, b);
    default:
        return multiply(a, apply(b, 1.0 / b.value, -1.0 / (b.value * b.value),
                                 2.0 / (b.value * b.value * b.value)));
    }
}

static jet evaluate(const struct oracle_recipe *o, int part, const struct place *at)
{
    const struct frame in = {.at = *at, .scale = {1.0, 1.0, 1.0}};
    return evaluate_in(o, part, &in);
}

static double number(const struct oracle_recipe *o, int part)
{
    const struct place nowhere = {.dimensions = o->dimensions};
    return evaluate(o, part, &nowhere).value;
}

struct oracle_recipe *oracle_recipe_make(const char *text, const struct scarp_recipe *recipe,
                                         uint64_t seed)
{
    struct oracle_recipe *const o = calloc(1, sizeof *o);
    if (o == NULL) {
        abort();
    }
    o->text = text;
    o->seed = seed;
    o->number = number;
    o->dimensions = strstr(text, "space 3") != NULL ? 3 : 2;
    const char *const tile = strstr(text, "tile ");
    if (tile != NULL) {
        char *at = (char *)(uintptr_t)(tile + 4);
        for (int i = 0; i < o->dimensions; i++) {
            o->tile[i] = strtod(at + 1, &at);
        }
    }
    while (o->parts < PARTS &&
           scarp_recipe_part_at(recipe, (size_t)o->parts, &o->part[o->parts]) == SCARP_OK) {
        o->parts++;
    }
    while (o->statements < STATEMENTS &&
           scarp_recipe_entry_at(recipe, (size_t)o->statements, &o->entry[o->statements]) ==
               SCARP_OK) {
        o->output = o->entry[o->statements].output == 0 ? o->statements : o->output;
        o->statements++;
    }
    return o;
}

void oracle_recipe_free(struct oracle_recipe *o)
{
    for (int i = 0; i < o->parts; i++) {
        free(o->made[i]);
    }
    free(o);
}

struct oracle_jet oracle_recipe_at(const struct oracle_recipe *o, const double x[3])
{
    struct place at = {.dimensions = o->dimensions};
    for (int i = 0; i < o->dimensions; i++) {
        at.u[i].value = x[i];
        at.u[i].first[i] = 1.0;
    }
    return evaluate(o, o->entry[o->output].part, &at);
}
