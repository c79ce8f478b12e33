/* SPDX-License-Identifier: MIT
 *
 * What a recipe says of its cells and its jumps, which is compared with the values.
 */
#include "recipe_values.h"

/* What a field is made of. MAY: the recipe says that it may jump, and it does not. */
enum jumps { NO, YES, MAY };

static const struct made_of {
    const char *text;
    double largest, smallest;
    enum jumps jumps;
} made_of[] = {
    {"x / 8", 0, 0, NO},
    {"noise()", 1, 1, NO},
    {"noise(size=7)", 7, 7, NO},
    {"noise(size=8, octaves=4)", 8, 1, NO},
    {"noise(size=8, octaves=3.5, lacunarity=3)", 8, 8.0 / 27, NO},
    {"noise(size=8, octaves=3, lacunarity=0.5)", 32, 8, NO},
    {"noise(frequency=0.25) + noise(size=3) * smoothstep(noise(size=90), 0, 1)", 90, 3, NO},
    {"scale(noise(octaves=3), 1000)", 1000, 250, NO},
    {"noise(size=1000, octaves=3)", 1000, 250, NO},
    {"scale(scale(noise(size=6), 5), 0.1)", 3, 3, NO},
    {"scale(noise(), -4)", 4, 4, NO},
    {"stretch(noise(size=2), 3, 5)", 10, 6, NO},
    {"turn(stretch(turn(noise(size=2), 30), 3, 5), 70)", 10, 6, NO},
    {"move(turn(noise(size=6000), 50), 12, 3)", 6000, 6000, NO},
    {"wind(noise(size=4200), 250, 1.6)", 6720, 4200, NO},
    {"warp(noise(size=5), noise(size=40, octaves=2))", 40, 5, NO},
    {"scale(warp(noise(size=5), noise(size=40, octaves=2)), 2)", 80, 10, NO},
    {"warp(noise(size=5) * x, warp(noise(size=40), noise(size=90)))", 90, 5, NO},
    {"at(noise(size=8), 4 * x, y / 2)", 16, 2, NO},
    {"at(noise(size=8), x + noise(size=300), y)", 300, 8, NO},
    {"at(noise(size=8), x, 3)", 8, 8, NO},
    {"at(noise(size=8), 5, 3)", 0, 0, NO},
    {"at(cell(noise(size=8)), 5, 3)", 0, 0, NO},
    {"at(x, 2 * x, y + noise(size=300))", 0, 0, NO},
    {"slope(noise(size=12))", 12, 12, NO},
    {"scale(slope(noise(size=12)), 3)", 36, 36, NO},
    {"gullies(noise(size=50), size=12, cells=2, octaves=3)", 50, 1.5, NO},
    {"gullies(x / 9, size=90)", 30, 1.875, NO},
    {"scale(gullies(noise(size=50), size=12, cells=2, octaves=1), 10)", 500, 60, NO},
    {"cell(noise(size=9, octaves=4))", 9, 9, YES},
    {"cell(noise(size=9), f1)", 9, 9, NO},
    {"cell(noise(size=9), f2)", 9, 9, NO},
    {"noise(cell_value, size=4)", 4, 4, YES},
    {"smoothstep(noise(cell_value), -1, 1)", 1, 1, YES},
    {"noise(size=3) * max(noise(cell_value), noise(), smooth=0.5)", 3, 1, YES},
    {"warp(noise(size=3), noise(cell_value, amplitude=0.3))", 3, 1, YES},
    {"at(noise(size=3), x, y + 0.5 * noise(cell_value))", 3, 1, YES},
    {"noise(cell_f1)", 1, 1, NO},
    {"noise(cell_soft, octaves=2)", 1, 0.5, NO},
    {"noise(cell_edge, erosion)", 1, 1, YES},
    {"noise(cell_f2, erosion)", 1, 1, NO},
    {"noise(cell_f1, erosion, octaves=2)", 1, 0.5, YES},
    {"noise(cell_f2, swiss, octaves=2)", 1, 0.5, YES},
    {"noise(cell_f1, jordan, octaves=2)", 1, 0.5, YES},
    {"noise(cell_f1, jordan)", 1, 1, NO},
    {"noise(erosion, octaves=3)", 1, 0.25, NO},
    {"noise(cubic, erosion, octaves=2)", 1, 0.5, NO},
    {"noise(ridged, octaves=2)", 1, 0.5, NO},
    {"abs(noise())", 1, 1, NO},
    {"slope(abs(noise()))", 1, 1, MAY}, /* both sides of its creases are as steep */
    {"slope(max(noise(), noise(seed=1)))", 1, 1, YES},
    {"slope(clamp(noise(), -0.1, 0.1))", 1, 1, YES},
    {"slope(noise(cubic))", 1, 1, NO},
    {"slope(slope(noise()))", 1, 1, NO},
    {"slope(warp(noise(size=3), noise(cell_f1, amplitude=0.3)))", 3, 1, YES},
    {"slope(noise(turbulence, octaves=2))", 1, 0.5, YES},
    {"slope(noise(ridged, octaves=2))", 1, 0.5, YES},
    {"slope(noise(pingpong, octaves=2))", 1, 0.5, YES},
    {"slope(noise(hybrid, octaves=3))", 1, 0.25, YES},
    {"slope(noise(swiss, octaves=2))", 1, 0.5, YES},
    {"slope(noise(jordan, octaves=2))", 1, 0.5, NO},
    {"slope(noise(erosion, octaves=2))", 1, 0.5, NO},
    {"slope(noise(cubic, erosion, octaves=2))", 1, 0.5, YES},
    {"slope(slope(noise(cubic)))", 1, 1, YES},
    {"slope(curve(noise(), -0.3: 0.1, 0: 0.7, 0.2: 0))", 1, 1, NO},
    {"gullies(max(noise(), noise(seed=1)), octaves=1)", 1, 1.0 / 3, YES},
};

static double difference(const double from[2], const double to[2])
{
    const struct scarp_samples out = {.value = value};
    x[0] = from[0];
    x[1] = to[0];
    y[0] = from[1];
    y[1] = to[1];
    const struct scarp_recipe_outputs outputs = {.out = &out, .count = 1};
    CHECK(scarp_recipe_sample_f64(&recipe, 2, x, y, NULL, &outputs, &scratch) == SCARP_OK,
          "samples");
    return fabs((double)value[1] - (double)value[0]);
}

/* Halves an interval of a line again and again, keeping the half with the larger difference. */
static double left_over(double from[2], double to[2])
{
    double left = 0.0;
    for (int i = 0; i < 34; i++) {
        const double middle[2] = {0.5 * (from[0] + to[0]), 0.5 * (from[1] + to[1])};
        const double before = difference(from, middle), behind = difference(middle, to);
        left = before > behind ? before : behind;
        memcpy(before > behind ? to : from, middle, sizeof middle);
    }
    return left;
}

/* The largest jump that is met on random lines, near their largest steps */
static double worst_jump(double unit)
{
    enum { LINES = 120, STEPS = 512 };
    static double line_x[STEPS], line_y[STEPS];
    static float found[STEPS];
    const struct scarp_samples out = {.value = found};
    const struct scarp_recipe_outputs outputs = {.out = &out, .count = 1};
    uint64_t state = 7;
    double worst = 0.0;
    for (int line = 0; line < LINES; line++) {
        const double turns = check_random_double(&state, 3.2), step = unit / 200.0;
        const double start[2] = {check_random_double(&state, 20.0 * unit),
                                 check_random_double(&state, 20.0 * unit)};
        size_t at = 0;
        for (size_t i = 0; i < STEPS; i++) {
            line_x[i] = start[0] + cos(turns) * step * (double)i;
            line_y[i] = start[1] + sin(turns) * step * (double)i;
        }
        CHECK(scarp_recipe_sample_f64(&recipe, STEPS, line_x, line_y, NULL, &outputs, &scratch) ==
                  SCARP_OK,
              "samples");
        for (size_t i = 0; i + 1 < STEPS; i++) {
            at = fabsf(found[i + 1] - found[i]) > fabsf(found[at + 1] - found[at]) ? i : at;
        }
        worst = larger(worst, left_over((double[]){line_x[at], line_y[at]},
                                        (double[]){line_x[at + 1], line_y[at + 1]}));
    }
    return worst;
}

static int is_near(double a, double b)
{
    return fabs(a - b) <= 1e-6 * fabs(b);
}

/* The answers of each text, in the plane and once more in a recipe of space; that it jumps is seen.
   What else is in the text does not count. */
static void check_made_of(const struct made_of *m)
{
    static char text[2000];
    struct scarp_recipe_entry entry;
    sprintf(text, "recipe 1\na = noise(size=1e5)\nb = cell(a)\nout f = %s", m->text);
    parses(text);
    entry = recipe_entry(&recipe, 2);
    CHECK(is_near(entry.cell[0], m->largest) && is_near(entry.cell[1], m->smallest),
          "%s: cells from %g to %g, and not from %g to %g", m->text, entry.cell[0], entry.cell[1],
          m->largest, m->smallest);
    CHECK(entry.jumps == (m->jumps != NO) && entry.dimensions == 2, "%s: jumps %d, %d dimensions",
          m->text, (int)entry.jumps, (int)entry.dimensions);
    const double jump = worst_jump(m->smallest > 0.0 ? m->smallest : 1.0);
    CHECK((jump > 1e-3) == (m->jumps == YES), "%s jumps by %g", m->text, jump);
    CHECK(scarp_recipe_scale(&recipe, 2.5, 9.0, NULL) == SCARP_OK, "%s: scale", m->text);
    entry = recipe_entry(&recipe, 2);
    CHECK(is_near(entry.cell[0], 2.5 * m->largest) && is_near(entry.cell[1], 2.5 * m->smallest),
          "%s: scaled, cells from %g to %g", m->text, entry.cell[0], entry.cell[1]);
}

/* Cells in space, and of statements that are no fields */
static void check_space(void)
{
    static const char text[] = "recipe 1\nspace 3\nparam p = 2\na = stretch(noise(), 2, 3, 4)\n"
                               "b = flat(scale(noise(size=5), p))\nc = 2 * p\n"
                               "d = turn(turn(a, 30), 50, x)";
    static const double cells[][2] = {{0, 0}, {4, 2}, {10, 10}, {0, 0}, {4, 2}};
    parses(text);
    for (size_t i = 0; i < 5; i++) {
        const struct scarp_recipe_entry entry = recipe_entry(&recipe, i);
        CHECK(is_near(entry.cell[0], cells[i][0]) && is_near(entry.cell[1], cells[i][1]) &&
                  entry.dimensions == 3 && entry.jumps == 0,
              "statement %zu: cells from %g to %g, %d dimensions", i, entry.cell[0], entry.cell[1],
              (int)entry.dimensions);
    }
    (void)scarp_recipe_set(&recipe, "p", 3.0, NULL);
    CHECK(is_near(recipe_entry(&recipe, 2).cell[0], 15.0), "cells follow parameters");
}

/* Nothing is finer than the smallest cell: "finest" changes nothing up to there. */
static void check_finest(void)
{
    for (size_t i = 0; i < RECIPE_TEXTS; i++) {
        struct scarp_recipe_entry entry;
        int32_t number = 0;
        parses(recipe_texts[i].text);
        for (; scarp_recipe_entry_at(&recipe, (size_t)number, &entry) == SCARP_OK; number++) {
            if (entry.cell[1] > 0.0) {
                static struct scarp_recipe copy;
                memcpy(&copy, &recipe, sizeof copy);
                CHECK(scarp_recipe_set(&copy, "finest", (1.0 - 1e-6) * entry.cell[1], NULL) ==
                              SCARP_OK &&
                          recipe_entry(&copy, (size_t)number).hash == entry.hash,
                      "%s: something is smaller than %g", recipe_texts[i].name, entry.cell[1]);
            }
        }
    }
    CHECK(parses("recipe 1\na = turn(stretch(noise(octaves=4), 3, 1), 9)") &&
              is_near(recipe_entry(&recipe, 0).cell[1], 0.125),
          "a noise");
    (void)scarp_recipe_set(&recipe, "finest", 0.3, NULL);
    CHECK(is_near(recipe_entry(&recipe, 0).cell[1], 0.25), "the octaves that are left count");
}

int main(void)
{
    for (size_t i = 0; i < sizeof made_of / sizeof made_of[0]; i++) {
        check_made_of(&made_of[i]);
    }
    check_space();
    check_finest();
    return check_done();
}
