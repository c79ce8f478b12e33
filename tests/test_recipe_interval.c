/* SPDX-License-Identifier: MIT
 *
 * Usage: test_recipe_interval COUNT
 *
 * No value of a function leaves the interval that recipes promise for it, where its arguments are
 * in theirs. Each function that combines fields gets COUNT random numbers (of curves: knots) and
 * intervals, from the widest to single floats, often at places where the function is level, and a
 * batch of arguments for each.
 */
#include "../src/plan/functions.h"
#include "../src/recipe/combine.h"
#include "../src/recipe/interval.h"
#include "check.h"

#define BATCH 64

struct subject {
    const char *name;
    int operation;
    int arguments; /* that are fields */
};

#define OPERATOR(NAME, name, FORM, ...) {#name, OP_##NAME, INPUTS_OF_##FORM},
#define FUNCTION(...) OPERATOR(__VA_ARGS__)
static const struct subject subjects[] = {
#include "../src/plan/functions.def"
};

/* What numbers functions take: see functions.def */
#define CASE(name, function, COMPUTED, FORM, kinds, ...) {#function, kinds},
static const struct {
    const char *function, *kinds;
} cases[] = {
#include "functions.def"
};

static const char *kinds_of(const char *function)
{
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        if (strcmp(cases[i].function, function) == 0) {
            return cases[i].kinds;
        }
    }
    return "";
}

static struct recipe recipe; /* has the knots of the curve */
static float in[3][BATCH], out[BATCH];
static float level[BATCH]; /* the gradient of what has one */
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

static float number_of_kind(char kind)
{
    switch (kind) {
    case 's': return fabsf(any());
    case 'r': return below(2) == 0 ? 1.0f : (float)(0.001 + 0.998 * unit());
    case 'u': return below(2) == 0 ? 1.0f : (float)unit();
    default: return any();
    }
}

/* Numbers, and a place where the function bends or is level. */
static float set_numbers(const struct subject *subject, struct recipe_node *n)
{
    const char *const kinds = kinds_of(subject->name);
    for (int i = 0; kinds[i] != '\0'; i++) {
        n->k[i] = number_of_kind(kinds[i]);
    }
    switch (n->operation) {
    case OP_AFFINE: n->k[1] = below(2) == 0 ? 0.0f : n->k[1]; return 0.0f;
    case OP_TERRACE: return (float)below(20) / n->k[0];
    case OP_CLAMP:
    case OP_SMOOTHSTEP:
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
    default: return 0.0f;
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

static enum scarp_status run(const struct recipe_node *n)
{
    const struct scarp_samples samples[3] = {
        {.value = in[0], .dx = level, .dy = level}, {.value = in[1]}, {.value = in[2]}};
    const struct scarp_samples to = {.value = out};
    return scarpi_recipe_combine(&recipe, n, BATCH, samples, &to);
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
    const float place = set_numbers(subject, &n);
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
    const int count = (int)check_argument(argc, argv, 1, 1, "COUNT");
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
