/* SPDX-License-Identifier: MIT
 *
 *     test_recipe_plan ISA
 *
 * Plans of recipes: calls use what fits, and give the same bits whatever the plan is: of the
 * recipe, of this recipe before it was changed, of another one, or none at all. And what
 * scarp_recipe_plan_make refuses.
 */
#include "../src/plan/kept.h"
#include "recipes.h"

#define POINTS 65
#define ARRAYS 10
#define POISON 0x5a
#define PLAN_BYTES ((size_t)1 << 19)

static struct scarp_recipe recipe, copy;
static int is_space; /* both are of the same space */
static double position[3][POINTS];
static float float_position[3][POINTS];
static uint64_t memory[1 << 13], plan[PLAN_BYTES / 8], other[PLAN_BYTES / 8];

struct result {
    float array[ARRAYS * POINTS];
};

enum how { FLOATS, DOUBLES, GRID, WITHOUT_MEMORY, HOWS };

/* Samples a recipe, and returns whether it could. */
static int evaluate(const struct scarp_recipe *of, enum how how, size_t count, int order,
                    const void *with, struct result *to)
{
    struct scarp_scratch scratch = {.memory = memory, .size = sizeof memory, .plan = with};
    const struct scarp_samples out = recipe_samples(to->array, POINTS, order, is_space);
    const struct scarp_recipe_outputs outputs = {.out = &out, .count = 1};
    const struct scarp_grid grid = {.origin = {-3.25, 1.5, 0.75},
                                    .step = {0.37, 0.41, 0.83},
                                    .count = {count > 4 ? count / 4 : 1, is_space ? 2 : 4, 2}};
    enum scarp_status status;
    memset(to, 0, sizeof *to);
    if (how == WITHOUT_MEMORY) {
        scratch.memory = NULL;
    }
    if (how == GRID) {
        status = scarp_recipe_grid(of, &grid, &outputs, &scratch);
    } else if (how == FLOATS) {
        status = scarp_recipe_sample(of, count, float_position[0], float_position[1],
                                     float_position[2], &outputs, &scratch);
    } else {
        status = scarp_recipe_sample_f64(of, count, position[0], position[1], position[2], &outputs,
                                         &scratch);
    }
    CHECK(status == SCARP_OK || (how == WITHOUT_MEMORY && status == SCARP_ERROR_SIZE), "%s",
          scarp_status_text(status));
    return status == SCARP_OK;
}

static int is_same(const struct result *a, const struct result *b)
{
    for (int i = 0; i < ARRAYS * POINTS; i++) {
        const float x = a->array[i], y = b->array[i];
        if (memcmp(&x, &y, sizeof x) != 0 && !(x != x && y != y)) {
            return 0;
        }
    }
    return 1;
}

/* Whether values are those without a plan. */
static int is_harmless(const struct scarp_recipe *of, const void *with)
{
    static struct result without, met;
    int same = 1;
    for (int how = 0; how < HOWS; how++) {
        same = same && (!evaluate(of, (enum how)how, 16, 0, NULL, &without) ||
                        !evaluate(of, (enum how)how, 16, 0, with, &met) || is_same(&without, &met));
    }
    return same;
}

static int parses(const char *text)
{
    struct scarp_recipe_error error = {0};
    const enum scarp_status status =
        scarp_recipe_parse(text, strlen(text), &recipe, &error, 1, NULL);
    is_space = strstr(text, "space 3") != NULL;
    CHECK(status == SCARP_OK, "%d:%d: %s in\n%s", (int)error.line, (int)error.column, error.text,
          text);
    return status == SCARP_OK;
}

/* Makes the plan of the recipe, and checks that nothing behind it is written. Returns its size. */
static size_t make_plan(uint64_t *to)
{
    const size_t size = scarp_recipe_plan_size(&recipe);
    const unsigned char *const bytes = (const unsigned char *)to;
    memset(to, POISON, PLAN_BYTES);
    CHECK(size > 0 && size < PLAN_BYTES - 64, "%zu bytes", size);
    CHECK(scarp_recipe_plan_make(&recipe, to, size) == SCARP_OK, "no plan");
    for (size_t i = size; i < size + 64; i++) {
        CHECK(bytes[i] == POISON, "byte %zu behind a plan of %zu", i - size, size);
    }
    return size;
}

/* Changes the constants of all noises, which lie where a mark of plans is. Returns how many these
   are. */
static int spoil(uint64_t *of, size_t size)
{
    unsigned char *const bytes = (unsigned char *)of;
    int found = 0;
    for (size_t at = 0; at + sizeof(struct kept) < size; at += sizeof *of) {
        if (of[at / sizeof *of] >> 32 == mark_of(2, 0) >> 32) {
            const size_t first = at + offsetof(struct kept, octave);
            found++;
            for (size_t i = first; i < first + sizeof(struct scarp_octave) && i < size; i++) {
                bytes[i] ^= 0x10;
            }
        }
    }
    return found;
}

/* All texts, with all orders of derivatives, at any number of points. Constants that are changed
   show that they are used. */
static void test_bits(void)
{
    static struct result without, met;
    for (size_t i = 0; i < RECIPE_TEXTS && !check_enough(); i++) {
        if (!parses(recipe_texts[i].text)) {
            continue;
        }
        const size_t size = make_plan(plan);
        memcpy(&copy, &recipe, sizeof copy);
        memcpy(other, plan, size);
        for (int order = 0; order <= recipe_order(&recipe); order++) {
            for (size_t count = 1; count <= POINTS; count += count < 17 ? 1 : 16) {
                for (int how = 0; how < HOWS; how++) {
                    if (!evaluate(&recipe, (enum how)how, count, order, NULL, &without)) {
                        continue;
                    }
                    (void)evaluate(&copy, (enum how)how, count, order, count % 2 ? plan : other,
                                   &met);
                    CHECK_BITS(is_same(&without, &met), "%s, order %d, %zu points, way %d",
                               recipe_texts[i].name, order, count, how);
                }
            }
        }
        const int noises = spoil(plan, size);
        CHECK_BITS(noises == 0 || !is_harmless(&recipe, plan), "%s: the plan is unused",
                   recipe_texts[i].name);
    }
}

static const char changing[] =
    "recipe 1\n"
    "param size = 2 [0.5, 4]\n"
    "param tall = 3 [1, 9]\n"
    "w = noise(size=size, octaves=2, amplitude=0.4)\n"
    "v = noise(value, size=4, amplitude=0.2)\n"
    "out a = tall * warp(warp(noise(octaves=4), w), v) + cell(noise(size=2), f1) + w\n"
    "out b = noise(cell_f1, size=size, seed=2) + gullies(noise(size=4), size=4, octaves=2)\n";

/* A plan that was made before a change, or after one that was taken back. */
static void test_stale(void)
{
    for (int change = 0; change < 8; change++) {
        if (!parses(changing)) {
            return;
        }
        (void)scarp_recipe_seed(&recipe, 5);
        (void)make_plan(plan);
        memcpy(&copy, &recipe, sizeof copy);
        const enum scarp_status status =
            change == 0   ? scarp_recipe_seed(&recipe, 6)
            : change == 1 ? scarp_recipe_set(&recipe, "size", 1.5, NULL)
            : change == 2 ? scarp_recipe_set(&recipe, "tall", 4, NULL)
            : change == 3 ? scarp_recipe_set(&recipe, "finest", 0.4, NULL)
            : change == 4 ? scarp_recipe_tile(&recipe, 8, 8, 0, NULL)
            : change == 5 ? scarp_recipe_scale(&recipe, 2, 2, NULL)
            : change == 6 ? scarp_recipe_scale(&recipe, 1, 3, NULL)
                          : SCARP_OK;
        CHECK(status == SCARP_OK, "change %d: %s", change, scarp_status_text(status));
        if (change == 7) { /* the same noises in another order, and some more */
            static char text[1024];
            snprintf(text, sizeof text, "recipe 1\nu = noise(seed=9)\n%s\nout c = u + w",
                     changing + sizeof "recipe 1");
            (void)parses(text);
            (void)scarp_recipe_seed(&recipe, 5);
        }
        CHECK_BITS(is_harmless(&recipe, plan), "change %d", change);
        (void)make_plan(other);
        CHECK_BITS(is_harmless(&copy, other), "change %d, backwards", change);
        CHECK_BITS(is_harmless(&copy, plan), "change %d, taken back", change);
    }
}

/* Plans of other recipes. */
static void test_others(void)
{
    for (size_t i = 0; i < RECIPE_TEXTS && !check_enough(); i++) {
        (void)parses(recipe_texts[i].text);
        (void)make_plan(plan);
        for (size_t k = i % 7; k < RECIPE_TEXTS; k += 7) {
            (void)parses(recipe_texts[k].text);
            CHECK_BITS(is_harmless(&recipe, plan), "%s with the plan of %s", recipe_texts[k].name,
                       recipe_texts[i].name);
        }
    }
}

/* What no call has made, and plans of other versions, which spoilt constants would show. */
static void test_garbage(void)
{
    static const int fills[] = {0, 0xff, 0x77, 1};
    unsigned char *const bytes = (unsigned char *)plan;
    uint64_t state = 1;
    (void)parses(changing);
    for (size_t i = 0; i < sizeof fills / sizeof fills[0]; i++) {
        memset(plan, fills[i], sizeof plan);
        CHECK_BITS(is_harmless(&recipe, plan), "all %d", fills[i]);
    }
    for (size_t i = 0; i < sizeof plan; i++) {
        bytes[i] = (unsigned char)check_random(&state);
    }
    CHECK_BITS(is_harmless(&recipe, plan), "random bytes");
    const size_t size = make_plan(plan);
    CHECK_BITS(spoil(plan, size) > 5 && !is_harmless(&recipe, plan), "the plan is unused");
    for (int bit = 0; bit < 64; bit++) {
        plan[0] ^= UINT64_C(1) << bit;
        CHECK_BITS(is_harmless(&recipe, plan), "bit %d of the mark", bit);
        plan[0] ^= UINT64_C(1) << bit;
    }
    memmove(bytes + 1, bytes, size);
    CHECK_BITS(is_harmless(&recipe, bytes + 1), "a plan that is not aligned is used");
}

/* How much memory, and what is refused. */
static void test_refused(void)
{
    static const char alps[] =
        "recipe 1\nbend = noise(frequency=0.0035, octaves=5, amplitude=75)\n"
        "ridges = warp(noise(swiss, rotate, frequency=0.005, octaves=9, gain=0.45), bend)\n"
        "ground = noise(hybrid, rotate, frequency=0.0016, octaves=8, gain=0.42, amplitude=1.4)\n"
        "high = smoothstep(noise(rotate, frequency=0.0016, octaves=3), -0.5, 0.25)\n"
        "alps = ridges * high + ground\n";
    const unsigned char *const bytes = (const unsigned char *)plan;
    (void)parses(alps);
    const size_t size = scarp_recipe_plan_size(&recipe);
    CHECK(size >= 25 * sizeof(struct scarp_octave) &&
              size <= 25 * sizeof(struct scarp_octave) + 4 * sizeof(struct kept) + 256,
          "%zu bytes for 25 octaves of 4 noises", size);
    memset(plan, POISON, sizeof plan);
    CHECK(scarp_recipe_plan_make(&recipe, plan, size - 1) == SCARP_ERROR_SIZE, "too small");
    CHECK(scarp_recipe_plan_make(&recipe, plan, 0) == SCARP_ERROR_SIZE, "no room");
    CHECK(scarp_recipe_plan_make(NULL, plan, size) == SCARP_ERROR_NULL, "no recipe");
    CHECK(scarp_recipe_plan_make(&recipe, NULL, size) == SCARP_ERROR_NULL, "no memory");
    CHECK(scarp_recipe_plan_make(&recipe, (char *)plan + 1, sizeof plan - 1) ==
              SCARP_ERROR_PARAMETER,
          "not aligned");
    memset(&copy, 0, sizeof copy);
    CHECK(scarp_recipe_plan_make(&copy, plan, sizeof plan) == SCARP_ERROR_PARAMETER, "zeros");
    CHECK(scarp_recipe_plan_size(&copy) == 0 && scarp_recipe_plan_size(NULL) == 0, "a size");
    CHECK(scarp_recipe_parse("recipe 1\na = u", 14, &copy, NULL, 0, NULL) != SCARP_OK, "no error");
    CHECK(scarp_recipe_plan_make(&copy, plan, sizeof plan) == SCARP_ERROR_PARAMETER &&
              scarp_recipe_plan_size(&copy) == 0,
          "a recipe with errors");
    for (size_t i = 0; i < sizeof plan; i++) {
        CHECK(bytes[i] == POISON, "an error, and byte %zu is written", i);
    }
    (void)parses("recipe 1\na = x"); /* without any noise */
    (void)make_plan(plan);
    CHECK_BITS(is_harmless(&recipe, plan), "no noise");
}

int main(int argc, char **argv)
{
    uint64_t state = 1;
    check_select_isa(argc > 1 ? argv[1] : "scalar");
    for (int i = 0; i < 3 * POINTS; i++) {
        position[i % 3][i / 3] = check_random_double(&state, 4.0);
        float_position[i % 3][i / 3] = (float)position[i % 3][i / 3];
    }
    test_bits();
    test_stale();
    test_others();
    test_garbage();
    test_refused();
    return check_done();
}
