/* SPDX-License-Identifier: MIT
 *
 * Usage: test_recipe_interval COUNT
 *
 * No value of a function leaves the interval that recipes promise for it, where its arguments are
 * in theirs. Each function that combines fields gets COUNT random numbers (of curves: knots) and
 * intervals, from the widest to single floats, often at places where the function is level, and a
 * batch of arguments for each.
 */
#include "../src/recipe/interval.h"
#include "check.h"

#define BATCH 64

struct subject {
    const char *name;
    int operation;
    int arguments; /* that are fields */
};

static const struct subject subjects[] = {
    {"affine", OP_AFFINE, 1},
    {"add", OP_ADD, 2},
    {"multiply", OP_MULTIPLY, 2},
    {"divide", OP_DIVIDE, 2},
    {"min", OP_MIN, 2},
    {"max", OP_MAX, 2},
    {"smooth min", OP_SMOOTH_MIN, 2},
    {"smooth max", OP_SMOOTH_MAX, 2},
    {"clamp", OP_CLAMP, 1},
    {"abs", OP_ABS, 1},
    {"smooth_abs", OP_SMOOTH_ABS, 1},
    {"smoothstep", OP_SMOOTHSTEP, 1},
    {"terrace", OP_TERRACE, 1},
    {"curve", OP_CURVE, 1},
    {"sqrt", OP_SQRT, 1},
    {"sine", OP_SINE, 1},
    {"pulse", OP_PULSE, 1},
    {"mix", OP_MIX, 2},
};

static struct recipe recipe; /* has the knots of the curve */
static float in[3][BATCH], out[BATCH];
static uint64_t state;

static uint64_t draw(void)
{
    uint64_t z = state += UINT64_C(0x9E3779B97F4A7C15);
    z = (z ^ z >> 30) * UINT64_C(0xBF58476D1CE4E5B9);
    z = (z ^ z >> 27) * UINT64_C(0x94D049BB133111EB);
    return z ^ z >> 31;
}

static int below(int count)
{
    return (int)(draw() % (uint64_t)count);
}

static double unit(void)
{
    return (double)(draw() >> 11) * 0x1p-53;
}

/* A number of any magnitude that matters. */
static float any(void)
{
    const double magnitude = (1.0 + unit()) * exp2(below(3) == 0 ? below(80) - 40 : below(16) - 8);
    return (float)(below(2) == 0 ? magnitude : -magnitude);
}

static float more_than(float number)
{
    return number + fmaxf(fabsf(any()), 0x1p-20f * fabsf(number));
}

/* Numbers, and a place where the function bends or is level. */
static float set_numbers(struct recipe_node *n)
{
    switch (n->operation) {
    case OP_SMOOTH_MIN:
    case OP_SMOOTH_MAX:
    case OP_SMOOTH_ABS: n->k[0] = fabsf(any()); return 0.0f;
    case OP_TERRACE:
        n->k[0] = fabsf(any());
        n->k[1] = below(2) == 0 ? 1.0f : (float)(0.001 + 0.998 * unit());
        n->k[2] = below(2) == 0 ? 1.0f : (float)unit();
        return (float)below(20) / n->k[0];
    case OP_CLAMP:
    case OP_SMOOTHSTEP:
        n->k[0] = any();
        n->k[1] = more_than(n->k[0]);
        if (n->operation == OP_SMOOTHSTEP && below(2) == 0) {
            const float lo = n->k[0];
            n->k[0] = n->k[1];
            n->k[1] = lo;
        }
        return n->k[below(2)];
    case OP_CURVE:
        n->knots = (uint8_t)(2 + below(5));
        for (int i = 0; i < n->knots; i++) {
            recipe.knot[i][0] = i == 0 ? any() : more_than(recipe.knot[i - 1][0]);
            recipe.knot[i][1] = below(4) == 0 ? 0.0f : below(4) == 0 ? 1000.0f : any();
        }
        return recipe.knot[below(n->knots)][0];
    default:
        n->k[0] = any();
        n->k[1] = below(2) == 0 ? 0.0f : any();
        return 0.0f;
    }
}

static struct recipe_interval interval_at(float place, int is_unit)
{
    if (is_unit) {
        const float a = below(4) == 0 ? 0.0f : (float)unit(),
                    b = below(4) == 0 ? 1.0f : (float)unit();
        return (struct recipe_interval){a < b ? a : b, a < b ? b : a};
    }
    const float middle = below(4) == 0 ? any() : place;
    const float width = fabsf(any()) * (float)exp2(-below(30));
    struct recipe_interval r = {middle - width * (float)unit(), middle + width * (float)unit()};
    r.lowest = below(16) == 0 ? -INFINITY : below(8) == 0 ? middle : r.lowest;
    r.highest = below(16) == 0 ? INFINITY : below(8) == 0 ? middle : r.highest;
    return r;
}

/* Ends and their neighbours come first. */
static float argument_in(struct recipe_interval r, int i)
{
    const float ends[2] = {r.lowest, r.highest};
    float a = ends[i & 1];
    if (isinf(a)) {
        a = any();
    } else if (i < 16) {
        for (int k = 0; k < i / 2; k++) {
            a = nextafterf(a, ends[!(i & 1)]);
        }
    } else {
        const double from = isinf(r.lowest) ? (double)r.highest - 1e3 : (double)r.lowest;
        const double to = isinf(r.highest) ? (double)r.lowest + 1e3 : (double)r.highest;
        a = (float)(from + (to - from) * unit());
    }
    return a < r.lowest ? r.lowest : a > r.highest ? r.highest : a;
}

static enum scarp_status curve(const struct recipe_node *n, const struct scarp_samples *a,
                               const struct scarp_samples *to)
{
    float x[8], y[8];
    for (int i = 0; i < n->knots; i++) {
        x[i] = recipe.knot[i][0];
        y[i] = recipe.knot[i][1];
    }
    return scarp_curve(BATCH, a, n->knots, x, y, to);
}

static enum scarp_status run(const struct recipe_node *n)
{
    const struct scarp_samples a = {.value = in[0]}, b = {.value = in[1]}, m = {.value = in[2]};
    const struct scarp_samples to = {.value = out};
    switch (n->operation) {
    case OP_AFFINE: return scarp_affine(BATCH, &a, n->k[0], n->k[1], &to);
    case OP_ADD: return scarp_add(BATCH, &a, &b, &to);
    case OP_MULTIPLY: return scarp_multiply(BATCH, &a, &b, &to);
    case OP_DIVIDE: return scarp_divide(BATCH, &a, &b, &to);
    case OP_MIN: return scarp_min(BATCH, &a, &b, &to);
    case OP_MAX: return scarp_max(BATCH, &a, &b, &to);
    case OP_SMOOTH_MIN: return scarp_smooth_min(BATCH, &a, &b, n->k[0], &to);
    case OP_SMOOTH_MAX: return scarp_smooth_max(BATCH, &a, &b, n->k[0], &to);
    case OP_CLAMP: return scarp_clamp(BATCH, &a, n->k[0], n->k[1], &to);
    case OP_ABS: return scarp_abs(BATCH, &a, &to);
    case OP_SMOOTH_ABS: return scarp_smooth_abs(BATCH, &a, n->k[0], &to);
    case OP_SMOOTHSTEP: return scarp_smoothstep(BATCH, &a, n->k[0], n->k[1], &to);
    case OP_TERRACE: return scarp_terrace(BATCH, &a, n->k[0], n->k[1], n->k[2], &to);
    case OP_CURVE: return curve(n, &a, &to);
    case OP_SQRT: return scarp_sqrt(BATCH, &a, &to);
    case OP_SINE: return scarp_sine(BATCH, &a, &to);
    case OP_PULSE: return scarp_pulse(BATCH, &a, &to);
    default: return scarp_mix(BATCH, &a, &b, &m, &to);
    }
}

/* Whether the values of a batch stay inside; else which one does not. NaN has no interval. */
static int outside(struct recipe_interval promised)
{
    for (int i = 0; i < BATCH; i++) {
        if (out[i] < promised.lowest || out[i] > promised.highest) {
            return i;
        }
    }
    return -1;
}

static void check_once(const struct subject *subject)
{
    struct recipe_node n = {.in = {0, (int16_t)(subject->arguments > 1 ? 1 : -1), -1},
                            .place = -1,
                            .operation = (uint8_t)subject->operation};
    const float place = set_numbers(&n);
    const int is_square = subject->operation == OP_MULTIPLY && below(3) == 0;
    const struct recipe_interval of[3] = {
        interval_at(place, 0), interval_at(below(2) == 0 ? place : any(), 0), interval_at(0.0f, 1)};
    n.in[1] = is_square ? 0 : n.in[1];
    if (subject->operation == OP_DIVIDE && of[1].lowest <= 0.0f && of[1].highest >= 0.0f) {
        return; /* an error of a text */
    }
    const struct recipe_interval promised = scarpi_recipe_interval_of(&recipe, &n, of, NULL);
    for (int i = 0; i < BATCH; i++) {
        for (int k = 0; k < 3; k++) {
            in[k][i] = argument_in(of[k], i < 16 ? i : 16 + below(2));
        }
        in[1][i] = is_square ? in[0][i] : in[1][i];
    }
    CHECK(run(&n) == SCARP_OK, "%s", subject->name);
    const int i = outside(promised);
    CHECK(i < 0, "%s of %.9g in [%.9g, %.9g] and %.9g, with %.9g %.9g: %.9g, not in [%.9g, %.9g]",
          subject->name, (double)in[0][i], (double)of[0].lowest, (double)of[0].highest,
          (double)in[1][i], (double)n.k[0], (double)n.k[1], (double)out[i], (double)promised.lowest,
          (double)promised.highest);
}

int main(int argc, char **argv)
{
    if (argc != 2) {
        fprintf(stderr, "usage: test_recipe_interval COUNT\n");
        return EXIT_FAILURE;
    }
    const int count = atoi(argv[1]);
    for (size_t i = 0; i < sizeof subjects / sizeof subjects[0]; i++) {
        const long before = check_failures;
        for (int k = 0; k < count; k++) {
            check_once(&subjects[i]);
        }
        if (check_failures > before) {
            printf("%s: %ld of %d batches leave the interval\n", subjects[i].name,
                   check_failures - before, count);
        }
    }
    return check_done();
}
