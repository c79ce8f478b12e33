/* SPDX-License-Identifier: MIT
 *
 *     test_recipe_skips [--must-differ] ISA COUNT
 *
 * What bounds leave out changes no bit, and is left out. Noises of the texts have names. An output
 * is compared with itself where all of these are outputs, too, so that nothing is left out: at
 * points and on grids, with all derivatives, in one chunk and in many, with coordinates that are
 * huge, infinite or NaN, by texts that are written for it and COUNT random ones.
 */
#include "../src/recipe/machine.h"
#include "recipes.h"

#define WIDTH 7
#define HEIGHT 5
#define DEPTH 3
#define MOST (WIDTH * HEIGHT * DEPTH)
#define ARRAYS 10
#define OUTPUTS 16
#define ORDERS 3

static struct scarp_recipe recipe;
static double position[3][MOST];
static float float_position[3][MOST];
static uint64_t memory[1 << 15];

struct result {
    float array[ARRAYS][MOST];
};
static struct result reference, met, others[OUTPUTS];

enum how { POINTS, FLOATS, GRID };
static const char *const hows[] = {"points", "floats", "grid"};

/* Where a text is looked at, and by which sizes of chunks. */
struct look {
    struct scarp_grid grid;
    size_t count;
    enum how how;
    int order, is_space;
    size_t chunk; /* points */
};

static void set_points(struct look *look)
{
    const struct scarp_grid *const g = &look->grid;
    size_t i = 0;
    for (size_t z = 0; z < g->count[2]; z++) {
        for (size_t y = 0; y < g->count[1]; y++) {
            for (size_t x = 0; x < g->count[0]; x++, i++) {
                position[0][i] = g->origin[0] + (double)x * g->step[0];
                position[1][i] = g->origin[1] + (double)y * g->step[1];
                position[2][i] = g->origin[2] + (double)z * g->step[2];
                for (int a = 0; a < 3; a++) {
                    float_position[a][i] = (float)position[a][i];
                }
            }
        }
    }
    look->count = i;
}

static void set_point(size_t i, double x, double y, double z)
{
    const double at[3] = {x, y, z};
    for (int a = 0; a < 3; a++) {
        position[a][i] = at[a];
        float_position[a][i] = (float)at[a];
    }
}

static enum scarp_status run(const struct look *l, const struct scarp_recipe_outputs *outputs,
                             size_t size)
{
    const struct scarp_scratch scratch = {.memory = memory, .size = size};
    memset(memory, l->chunk == MOST ? 0x42 : 0xff, sizeof memory); /* 48.56, and NaN */
    return l->how == GRID ? scarp_recipe_grid(&recipe, &l->grid, outputs, &scratch)
           : l->how == FLOATS
               ? scarp_recipe_sample(&recipe, l->count, float_position[0], float_position[1],
                                     float_position[2], outputs, &scratch)
               : scarp_recipe_sample_f64(&recipe, l->count, position[0], position[1], position[2],
                                         outputs, &scratch);
}

/* The output, and nothing else */
static enum scarp_status evaluate(const struct look *l)
{
    const struct scarp_samples out = recipe_samples(met.array[0], MOST, l->order, l->is_space);
    const struct scarp_recipe_outputs outputs = {.out = &out, .count = 1};
    memset(&met, 0, sizeof met);
    return run(l, &outputs, scarp_recipe_scratch_size(&recipe, l->order, l->chunk));
}

/* The output, which is the last statement, and all statements that are named n... The others need
   no derivatives: these may not exist. */
static enum scarp_status evaluate_all(const struct look *l, const char *text)
{
    struct scarp_samples out[OUTPUTS];
    int32_t which[OUTPUTS];
    struct scarp_recipe_entry entry;
    struct scarp_recipe_outputs outputs = {.out = out, .which = which, .count = 1};
    for (size_t i = 0; scarp_recipe_entry_at(&recipe, i, &entry) == SCARP_OK; i++) {
        if (text[entry.name[0]] == 'n' && outputs.count < OUTPUTS) {
            which[outputs.count] = (int32_t)i;
            out[outputs.count] =
                recipe_samples(others[outputs.count].array[0], MOST, 0, l->is_space);
            outputs.count++;
        } else {
            which[0] = (int32_t)i;
        }
    }
    out[0] = recipe_samples(reference.array[0], MOST, l->order, l->is_space);
    memset(&reference, 0, sizeof reference);
    return run(l, &outputs, sizeof memory);
}

/* How many guards bounds have left out in the last chunk: in the machine, which is in front in the
   scratch memory. */
static int skipped(void)
{
    const size_t lost = -(uintptr_t)memory % 64;
    const struct recipe_machine *const m = (const void *)((const char *)memory + lost);
    int count = 0;
    for (int i = 1; i <= m->schedule->guards; i++) {
        count += m->schedule->guard[i].kind == GUARD_BY_BOUNDS && m->state[i] > GUARD_LEFT_OUT;
    }
    return count;
}

static int parse(const char *text)
{
    struct scarp_recipe_error error = {0};
    const enum scarp_status status =
        scarp_recipe_parse(text, strlen(text), &recipe, &error, 1, NULL);
    CHECK(status == SCARP_OK, "%d:%d: %s\n%s", (int)error.line, (int)error.column,
          error.text != NULL ? error.text : "", text);
    return status == SCARP_OK;
}

/* Compares the output with itself where nothing is left out. */
static long skips; /* of all comparisons in one chunk */

static void compare(struct look *l, const char *text)
{
    static const size_t chunks[] = {16, 48, MOST};
    const enum scarp_status status = evaluate_all(l, text);
    CHECK(status == SCARP_OK, "%s: %s", text, scarp_status_text(status));
    for (int i = 0; i < 3; i++) {
        l->chunk = chunks[i];
        CHECK(evaluate(l) == SCARP_OK, "%s", text);
        CHECK_BITS(recipe_same(reference.array[0], met.array[0], ARRAYS * MOST),
                   "%s: %s, order %d, chunks of %d, at %g", text, hows[l->how], l->order,
                   (int)l->chunk, l->grid.origin[0]);
    }
    skips += skipped();
}

/*
 * Texts that are written for it
 */

#define PLANE_2 "recipe 1\nn = noise(octaves=2)\nnm = noise(value, size=1.5, seed=1)\n"
#define SPACE_3 "recipe 1\nspace 3\nn = noise(octaves=2)\nnm = noise(value, size=1.5, seed=1)\n"

/* What bounds leave out at x, y and z near -100, and near 100, by the order of derivatives. */
static const struct {
    const char *text;
    int below[ORDERS], above[ORDERS];
} texts[] = {
    {PLANE_2 "a = max(n, x / 8)", {0, 0, 0}, {1, 1, 1}},
    {PLANE_2 "a = max(x / 8, n)", {0, 0, 0}, {1, 1, 1}},
    {PLANE_2 "a = min(n, x / 8)", {1, 1, 1}, {0, 0, 0}},
    {PLANE_2 "a = max(n, x / 8, smooth=0.5)", {0, 0, 0}, {1, 0, 0}},
    {PLANE_2 "a = min(n, x / 8, smooth=0.5)", {1, 0, 0}, {0, 0, 0}},
    {PLANE_2 "a = clamp(n + x / 8, -1, 1)", {1, 0, 0}, {1, 0, 0}},
    {PLANE_2 "a = smoothstep(n + x / 8, -1, 1)", {1, 0, 0}, {1, 0, 0}},
    {PLANE_2 "a = smoothstep(n + x / 8, 1, -1)", {1, 0, 0}, {1, 0, 0}},
    {PLANE_2 "a = curve(n + x / 8, -2: 0.25, 0: 1, 2: 0.5)", {1, 0, 0}, {1, 0, 0}},
    {PLANE_2 "a = max(n * (x / 8)^2, nm)", {0, 0, 0}, {0, 0, 0}},
    {PLANE_2 "a = max((n + 2) * x / 8, nm + x / 1000)", {1, 1, 1}, {1, 1, 1}},
    {PLANE_2 "a = min(n + x / 8, nm)", {1, 1, 1}, {1, 1, 1}},
    {PLANE_2 "a = nm * max(n + x / 8, 0)", {1, 1, 1}, {0, 0, 0}},
    {PLANE_2 "a = nm * clamp(n + x / 8, 0, 1)", {1, 0, 0}, {1, 0, 0}},
    {PLANE_2 "a = mix(nm, n, smoothstep(n + x / 8, 0, 1))", {0, 0, 0}, {0, 0, 0}},
    {PLANE_2 "n3 = noise(seed=9)\na = max(max(min(n, nm) + x / 8, x / 4 - 20), n3)",
     {1, 1, 1},
     {1, 1, 1}},
    {PLANE_2 "a = max(smoothstep(x, 0, 1) * min(n, nm - y / 8), 2 + x / 8)", {0, 0, 0}, {1, 1, 1}},
    /* what is skipped might be NaN, or jumps */
    {PLANE_2 "a = max(sine((1e20 * n)^2), x / 8)", {0, 0, 0}, {0, 0, 0}},
    {PLANE_2 "a = max(slope(n) / 1000, x / 8)", {0, 0, 0}, {0, 0, 0}},
    {PLANE_2 "a = max(sine(x^4 * n), x / 8)", {0, 0, 0}, {0, 0, 0}},
    {PLANE_2 "a = max(at(n, x^4, y), x / 8)", {0, 0, 0}, {0, 0, 0}},
    {PLANE_2 "a = max(turn(n, 30), x / 8) + max(at(n, x + nm, y), x / 8)", {0, 0, 0}, {2, 2, 2}},
    {SPACE_3 "a = max(n, z / 8)", {0, 0, 0}, {1, 1, 1}},
    {SPACE_3 "a = clamp((4 * flat(n) - z) / 8 + n, -1, 1)", {1, 0, 0}, {1, 0, 0}},
    {SPACE_3 "a = max(flat(max(nm, x / 8)) + n, 2 - z)", {1, 1, 1}, {1, 1, 1}},
    {SPACE_3 "a = flat(min(n, nm + y / 8)) * max(nm, z / 8)", {1, 1, 1}, {2, 2, 2}},
    {SPACE_3 "n4 = noise(seed=4)\n"
             "a = min((40 * flat(n) - z) / 8 + n, 1 - nm^2) * max(z / 8 - n4, 0)",
     {1, 1, 1},
     {1, 1, 1}},
};

static void compare_all(const char *text, struct look *l, int is_grid)
{
    const int most = recipe_order(&recipe);
    for (l->order = 0; l->order <= most && !check_enough(); l->order++) {
        for (int how = POINTS; how <= (is_grid ? GRID : FLOATS); how++) {
            l->how = (enum how)how;
            compare(l, text);
        }
    }
}

static void check_texts(void)
{
    for (size_t i = 0; i < sizeof texts / sizeof texts[0] && !check_enough(); i++) {
        const char *const text = texts[i].text;
        if (!parse(text)) {
            continue;
        }
        const int is_space = strstr(text, "space 3") != NULL, most = recipe_order(&recipe);
        for (int side = -1; side <= 1; side++) {
            const double at = side * 100.0;
            struct look l = {.grid = {.origin = {at, at, at},
                                      .step = {0.37, 0.41, 0.83},
                                      .count = {WIDTH, HEIGHT, is_space ? DEPTH : 1}},
                             .is_space = is_space};
            set_points(&l);
            compare_all(text, &l, 1);
            l.chunk = MOST;
            for (l.order = 0; side != 0 && l.order <= most; l.order++) {
                const int expected = (side < 0 ? texts[i].below : texts[i].above)[l.order];
                /* On grids, what does not depend on z runs before what the machine knows. */
                const int most_how = strstr(text, "flat(m") != NULL ? FLOATS : GRID;
                for (int how = POINTS; how <= most_how; how++) {
                    l.how = (enum how)how;
                    (void)evaluate(&l);
                    CHECK(check_aim != CHECK_SAME || skipped() == expected,
                          "%s: %d guards, and not %d, order %d, %s, at %g", text, skipped(),
                          expected, l.order, hows[how], at);
                }
            }
        }
    }
}

/* Where both sides meet: x is the same at all points. */
static const struct {
    const char *text;
    double x;
    int skips;
} borders[] = {
    {"max(clamp(n, 0, 0), x)", -0.0, 0},
    {"max(x, clamp(n, 0, 0))", -0.0, 0},
    {"max(clamp(n, 0, 0), x)", 1e-40, 1},
    {"max(clamp(n, 0, 0), x)", -1e-40, 0},
    {"min(clamp(n, 0, 0), x)", -0.0, 0},
    {"min(clamp(n, 0, 0), x)", -1e-40, 1},
    {"min(x, n + 100)", -0.0, 1},
    {"max(x, n - 100)", -0.0, 1},
    {"min(x, n + 100, smooth=0.5)", -0.0, 1},
    {"max(x, n - 100, smooth=0.5)", -0.0, 1},
    {"max(n - 100, x, smooth=0.5)", -0.0, 1},
    {"max(x, clamp(n, 0.25, 0.25), smooth=0.5)", 0.75, 1},
    {"max(x, clamp(n, 0.25, 0.25), smooth=0.5)", 0.7499999, 0},
    {"max(clamp(n, 0.25, 0.25), x, smooth=0.5)", 0.5, 0},
    {"min(x, clamp(n, 0.25, 0.25), smooth=0.5)", -0.25, 1},
    {"min(x, clamp(n, 0.25, 0.25), smooth=0.5)", -0.2499999, 0},
    {"min(clamp(n, 0.25, 0.25), x, smooth=0.5)", 0.0, 0},
    {"clamp(clamp(n, 0, 0) + x, 0, 1)", 0.0, 0},
    {"clamp(clamp(n, 1, 1) * x, 0, 1)", -0.0, 0},
    {"clamp(clamp(n, 1, 1) * x, 0, 1)", 0.5, 0},
    {"clamp(clamp(n, 1, 1) * x, 0, 1)", -1e-40, 1},
    {"clamp(clamp(n, 1, 1) * x, 0, 1)", 1.0, 0},
    {"clamp(clamp(n, 1, 1) * x, 0, 1)", 1.0000002, 1},
    {"smoothstep(clamp(n, 1, 1) * x, 0, 1)", -0.0, 0},
    {"smoothstep(clamp(n, 1, 1) * x, 0, 1)", 1.0, 1},
    {"smoothstep(clamp(n, 1, 1) * x, 0, 1)", -1e-30, 1},
    {"smoothstep(clamp(n, 1, 1) * x, 1, 0)", 0.0, 1},
    {"smoothstep(clamp(n, 1, 1) * x, 1, 0)", 1.0, 0},
    {"curve(clamp(n, 1, 1) * x, 0: 2, 1: 3)", 0.0, 1},
    {"curve(clamp(n, 1, 1) * x, 0: 2, 1: 3)", 1e-30, 0},
    {"curve(clamp(n, 1, 1) * x, 0: 2, 1: 3)", 1.0, 1},
};

static void check_borders(void)
{
    for (size_t i = 0; i < sizeof borders / sizeof borders[0] && !check_enough(); i++) {
        static char text[256];
        struct look l = {.grid = {.origin = {borders[i].x, -1.5},
                                  .step = {0.0, 0.41},
                                  .count = {WIDTH, HEIGHT, 1}}};
        snprintf(text, sizeof text, PLANE_2 "a = %s", borders[i].text);
        if (!parse(text)) {
            continue;
        }
        set_points(&l);
        for (size_t k = 0; k < l.count; k++) { /* -0 too */
            set_point(k, borders[i].x, position[1][k], 0.0);
        }
        compare_all(text, &l, 0);
        l.order = 0;
        l.chunk = MOST;
        l.how = POINTS;
        (void)evaluate(&l);
        CHECK(check_aim != CHECK_SAME || skipped() == borders[i].skips,
              "%s at %g: %d guards, and not %d", borders[i].text, borders[i].x, skipped(),
              borders[i].skips);
    }
}

/* One point among others at which a side is decided, where it is not. */
static void check_inner_points(void)
{
    static const char text[] =
        PLANE_2 "n4 = noise(seed=4)\na = max(n, x / 8) + min(n4 - x / 8, nm)";
    for (size_t k = 0; parse(text) && k < WIDTH * HEIGHT && !check_enough(); k++) {
        struct look l = {
            .grid = {.origin = {100.0, -1.5}, .step = {0.37, 0.41}, .count = {WIDTH, HEIGHT, 1}}};
        set_points(&l);
        set_point(k, -100.0, 0.0, 0.0);
        compare_all(text, &l, 0);
    }
}

/* Among points at which a side is decided, some that are no finite numbers, or whose positions
   overflow. Then nothing is skipped. */
static void check_odd_points(void)
{
    static const char text[] = PLANE_2
        "n4 = noise(frequency=1e14)\na = max(n4, x / 8) + clamp(n + x / 8, -1, 1) * max(nm, x / 8)";
    static const double odd[] = {NAN, INFINITY, -INFINITY, 1e300, -1e300, 3e38, -3e38, 1e30, 1e14};
    if (!parse(text)) {
        return;
    }
    for (int k = 0; k < 2 * (int)(sizeof odd / sizeof odd[0]) && !check_enough(); k++) {
        struct look l = {
            .grid = {.origin = {100.0, -1.5}, .step = {0.37, 0.41}, .count = {WIDTH, HEIGHT, 1}}};
        set_points(&l);
        set_point(17 + (size_t)k % 3, k % 2 == 0 ? 100.0 : odd[k / 2],
                  k % 2 == 0 ? odd[k / 2] : 1.0, 0.0);
        compare_all(text, &l, 0);
        l.order = 0;
        l.chunk = MOST;
        for (l.how = POINTS; l.how <= FLOATS; l.how++) {
            (void)evaluate(&l);
            CHECK(check_aim != CHECK_SAME || skipped() == 0, "%g: %d guards", odd[k / 2],
                  skipped());
        }
    }
    for (int k = 0; k < 3 && !check_enough(); k++) { /* grids as large as that */
        static const double steps[] = {1e30, 1e37, 1e300};
        struct look l = {.grid = {.origin = {100.0, -1.5},
                                  .step = {0.37, steps[k]},
                                  .count = {WIDTH, HEIGHT, 1}}};
        set_points(&l);
        compare_all(text, &l, 1);
    }
}

static void check_random_texts(int count)
{
    static struct recipe_writer w;
    skips = 0;
    for (int i = 0; i < count && !check_enough(); i++) {
        recipe_write_skips(&w, (uint64_t)i);
        if (!parse(w.text)) {
            continue;
        }
        const double far = recipe_draw(&w, 2) == 0 ? 8.0 : 60.0;
        struct look l = {.is_space = w.is_space, .grid = {.count = {WIDTH, HEIGHT, 1}}};
        for (int axis = 0; axis < 3; axis++) {
            l.grid.origin[axis] = recipe_number(&w, -far, far);
            l.grid.step[axis] = recipe_number(&w, 0.0, 1.0);
        }
        l.grid.count[2] = w.is_space ? DEPTH : 1;
        set_points(&l);
        compare_all(w.text, &l, 1);
        for (int k = 0; k < 2; k++) {
            static const double odd[] = {NAN, -INFINITY, 1e38, -0.0};
            const double x = odd[recipe_draw(&w, 4)], y = odd[recipe_draw(&w, 4)];
            set_point(recipe_draw(&w, (uint32_t)l.count), x, y, -y);
        }
        compare_all(w.text, &l, 0);
    }
    printf("%ld guards of %d random recipes leave something out\n", skips, count);
    CHECK(check_aim != CHECK_SAME || count < 50 || 2 * skips >= count, "%ld of %d", skips, count);
}

int main(int argc, char **argv)
{
    argc = check_take_aim(argc, &argv);
    if (argc != 3) {
        fprintf(stderr, "usage: test_recipe_skips [--must-differ] ISA COUNT\n");
        return EXIT_FAILURE;
    }
    (void)check_select_isa(argv[1]);
    check_texts();
    check_borders();
    check_inner_points();
    check_odd_points();
    check_random_texts(atoi(argv[2]));
    return check_done();
}
