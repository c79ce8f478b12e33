/* SPDX-License-Identifier: MIT
 *
 * Recipes for tests: a text for each function, whole landscapes, and random ones, which are made of
 * everything and have no errors.
 */
#ifndef SCARP_TESTS_RECIPES_H
#define SCARP_TESTS_RECIPES_H

#include <stdarg.h>

#include "check.h"

/* Samples of a recipe with derivatives up to an order: ten arrays of `points` numbers, one behind
   another, of which the plane leaves some out. */
static inline struct scarp_samples recipe_samples(float *first, size_t points, int order,
                                                  int is_space)
{
    struct scarp_samples s = {.value = first};
    if (order > 0) {
        s.dx = first + points;
        s.dy = first + 2 * points;
        s.dz = is_space ? first + 3 * points : NULL;
    }
    if (order > 1) {
        s.dxx = first + 4 * points;
        s.dxy = first + 5 * points;
        s.dyy = first + 6 * points;
        s.dxz = is_space ? first + 7 * points : NULL;
        s.dyz = is_space ? first + 8 * points : NULL;
        s.dzz = is_space ? first + 9 * points : NULL;
    }
    return s;
}

/* Whether numbers have the same bits; NaN is NaN. */
static inline int recipe_same(const float *a, const float *b, size_t count)
{
    for (size_t i = 0; i < count; i++) {
        if (memcmp(&a[i], &b[i], sizeof a[i]) != 0 && !(a[i] != a[i] && b[i] != b[i])) {
            return 0;
        }
    }
    return 1;
}

/* A statement; one that is not there is all zeros. */
static inline struct scarp_recipe_entry recipe_entry(const struct scarp_recipe *of, size_t number)
{
    struct scarp_recipe_entry entry;
    memset(&entry, 0, sizeof entry);
    (void)scarp_recipe_entry_at(of, number, &entry);
    return entry;
}

/* The highest order of derivatives that the first output has */
static inline int recipe_order(const struct scarp_recipe *recipe)
{
    struct scarp_recipe_entry entry;
    int order = 0;
    for (size_t i = 0; scarp_recipe_entry_at(recipe, i, &entry) == SCARP_OK; i++) {
        order = entry.output == 0 ? (int)entry.order : order;
    }
    return order;
}

/* Each is sampled over some cells of size 1 around the origin. `rough`: its value or its slope may
   jump, so a few points may be off. */
struct recipe_text {
    const char *name, *text;
    int is_rough;
};

#define PLANE "recipe 1\nn = noise(octaves=2)\nm = noise(value, size=1.5, seed=1)\n"
#define SPACE "recipe 1\nspace 3\nn = noise(octaves=2)\nm = noise(value, size=1.5, seed=1)\n"

#define DERIVED(name, value, first, second, expression, is_rough)                                  \
    {#name, PLANE "u = n\na = " expression, is_rough},
static const struct recipe_text recipe_texts[] = {
    {"number", PLANE "out a = n + 2^3 / 4 - -1", 0},
    {"seed", PLANE "a = noise(seed=-1) - noise(seed=-64) * cell(noise(seed=-9007199254740991))", 1},
    {"coordinates", PLANE "a = x - 2 * y", 0},
    {"coordinates3", SPACE "a = x - 2 * y + z / 3", 0},
    {"add", PLANE "a = n + m", 0},
    {"subtract", PLANE "a = n - 2 * m", 0},
    {"multiply", PLANE "a = n * m", 0},
    {"square", PLANE "a = n^2 + m^3 - n^4", 0},
    {"divide", PLANE "a = n / (m + 2) + 1 / (n - 3)", 0},
    {"min", PLANE "a = min(n, m)", 1},
    {"max", PLANE "a = max(n, m)", 1},
    {"smooth", PLANE "a = min(n, m, smooth=0.5) + max(n, m, 0.25)", 0},
    {"clamp", PLANE "a = clamp(n, -0.1, 0.2)", 1},
    {"smoothstep", PLANE "a = smoothstep(n, -0.3, 0.3) - smoothstep(m, 0.3, -0.2)", 0},
    {"terrace", PLANE "a = terrace(n, 4) + terrace(m, 3, riser=0.8, strength=0.5)", 0},
    {"mix", PLANE "a = mix(n, m, smoothstep(n - m, -0.3, 0.3))", 0},
    {"curve", PLANE "a = curve(n, -0.4: 0.2, -0.1: 0.5, 0: 0.7, 0.3: 0.1)", 1},
    {"blend", PLANE "a = blend(n, -0.3: m, -0.05: n * m, 0.2: 0.5, 0.4: m^2)", 0},
    {"slope", PLANE "a = slope(n + m)", 1},
    {"cell", PLANE "a = cell(noise(seed=5, jitter=0.8))", 1},
    {"cell_f1", PLANE "a = cell(noise(size=2), f1) - cell(n, f2)", 1},
    {"cell3", SPACE "a = cell(noise(size=2), f1) + turn(cell(n, id), 20)", 1},
    {"turn", PLANE "a = turn(n * x, 30)", 0},
    {"turn3", SPACE "a = turn(n, 30) + turn(m, -50, x) + turn(n * m, 70, y)", 0},
    {"move", PLANE "a = move(n + m, 3, -4.5)", 0},
    {"move3", SPACE "a = move(n + m, 3, -4.5, 1.25)", 0},
    {"scale", PLANE "a = scale(n + m, 2.5)", 0},
    {"stretch", PLANE "a = stretch(n + m, 0.5, 3)", 0},
    {"stretch3", SPACE "a = stretch(n + m, 0.5, 3, 2)", 0},
    {"wind", PLANE "a = wind(n * y, 250, 3)", 0},
    {"warp", PLANE "w = noise(amplitude=0.3, seed=2)\na = warp(n, w)", 0},
    {"warp_sum", PLANE "w = noise(amplitude=0.3, seed=2)\na = warp(n * x + m, w)", 0},
    {"warp_warp", PLANE "w = noise(amplitude=0.3, seed=2)\na = warp(warp(n, w), warp(w, m))", 0},
    {"warp3", SPACE "w = noise(simplex, amplitude=0.3, seed=2)\na = warp(n * z + m, w)", 0},
    {"warp_turned", PLANE "w = noise(amplitude=0.3, seed=2)\na = warp(turn(n, 40), w)", 0},
    {"at", PLANE "a = at(n - m, x + 0.5 * m, 2 * y - x / 3 + 0.2 * n)", 0},
    {"at3", SPACE "a = at(n - m, z, x + 0.5 * m, y * 2 - x / 3)", 0},
    {"at_column",
     SPACE "a = at(m * smoothstep(y / 4, -1, 1), x + clamp(n, -1, 1), y - x / 4, z / 2)", 1},
    {"at_order",
     PLANE "a = at(n * y, x + noise(swiss, octaves=2), y) + at(slope(n), x + "
           "noise(swiss), y - m)",
     1},
    {"flat", SPACE "a = flat(n) * m + turn(flat(m), 30, x)", 0},
    {"slope_warped", PLANE "w = noise(amplitude=0.3)\na = warp(slope(n), w) + scale(slope(m), 3)",
     1},
    {"slope3", SPACE "a = slope(n) + stretch(slope(m), 1, 2, 3)", 1},
    {"gullies", PLANE "f = noise(size=4)\na = gullies(f, size=4, octaves=2)", 0},
    {"displacement",
     PLANE "f = 2 * noise(size=4)\n"
           "a = displacement(f, size=4, amplitude=2, octaves=2, floor=0, rotate)",
     0},
    {"gullies_members",
     PLANE
     "f = 2 * noise(size=4)\n"
     "g = gullies(f, size=4, seed=9, amplitude=2, octaves=2.5, of_octaves=4, lacunarity=1.9,\n"
     "            gain=0.5, depth=0.3, cells=2, slope=0.9, slope_low=1.4, low=-0.6, high=0.7,\n"
     "            floor=-0.4, stripes=1.2, branch=0.6, round=0.3, keep=0.8, rotate)\n"
     "a = g + displacement(f, size=4, low=-1, high=0, branch=0, keep=0, octaves=1)",
     0},
    {"gullies_turned",
     PLANE "f = noise(size=4)\nw = noise(size=3, amplitude=0.5)\n"
           "a = warp(turn(gullies(f, size=4, octaves=2), 30), w)",
     0},
    {"gullies3", SPACE "f = noise(size=4)\na = flat(gullies(f, size=4, octaves=2)) + m", 0},
    {"masks3", /* the mask of the sum is computed per column, that of the product is not */
     SPACE "a = clamp(abs(n) + 1, 0, 2) * smoothstep(clamp(turn(y / 8, -161), -2, 2) * "
           "smoothstep(x / 8 + m, 0, 0.4), -0.1, 0.4)",
     1},
    {"ridged", PLANE "a = noise(ridged, octaves=3, gain=0.4) + noise(turbulence, seed=3)", 1},
    {"bent",
     PLANE "a = noise(swiss, octaves=3) + noise(jordan, octaves=2) + noise(erosion, octaves=3)", 1},
    {"words",
     PLANE "a = noise(simplex, hybrid, rotate, octaves=2.5, of_octaves=4, lacunarity=1.9)\n"
           "out b = a + noise(cubic, pingpong, sharpness=1.5) + noise(phase=0.3)",
     1},
    {"period", PLANE "a = noise(period=4) + noise(period_x=3, octaves=2)", 0},
    {"tile",
     "recipe 1\ntile 8, 4\nw = noise(size=2, amplitude=0.4)\n"
     "a = warp(noise(octaves=2), w) + stretch(noise(size=2), 2, 1) + move(noise(), 1, 2)",
     0},
#include "functions.def"
    {"flat_y", SPACE "a = flat(n, y) * m + turn(flat(m, y), 30, x)", 0},
    {"flat_x", SPACE "a = flat(n * x, x) * m + warp(flat(m + y, x), noise(amplitude=0.3))", 0},
    {"flat_tile",
     "recipe 1\nspace 3\ntile 8, 4, 12\na = flat(noise(size=2), y) + flat(noise(seed=1), x) + "
     "stretch(flat(noise(size=2, seed=2)), 2, 1, 1)",
     0},
};
#define RECIPE_TEXTS (sizeof recipe_texts / sizeof recipe_texts[0])

/*
 * Random recipes
 */

struct recipe_writer {
    uint64_t state;
    char text[16384];
    size_t length;
    int fields, noises; /* names f0, f1, ... and n0, n1, ... */
    int is_space, has_tile;
    int is_smooth; /* no creases, no gullies, no order lost */
};

static inline uint32_t recipe_draw(struct recipe_writer *w, uint32_t below)
{
    uint64_t z = w->state += UINT64_C(0x9E3779B97F4A7C15);
    z = (z ^ z >> 30) * UINT64_C(0xBF58476D1CE4E5B9);
    z = (z ^ z >> 27) * UINT64_C(0x94D049BB133111EB);
    return (uint32_t)((z ^ z >> 31) >> 33) % below;
}

/* A number with two digits behind the point. */
static inline double recipe_number(struct recipe_writer *w, double lowest, double highest)
{
    return lowest + (double)recipe_draw(w, (uint32_t)((highest - lowest) * 100.0) + 1) / 100.0;
}

static inline void recipe_put(struct recipe_writer *w, const char *format, ...)
{
    va_list list;
    va_start(list, format);
    const int length = vsnprintf(w->text + w->length, sizeof w->text - w->length, format, list);
    va_end(list);
    w->length += (size_t)length;
}

static inline void recipe_put_noise(struct recipe_writer *w, double amplitude)
{
    static const char *const bases[] = {"gradient, ", "value, ", "cell_soft, ", "", "simplex, "};
    const uint32_t count = w->has_tile ? 4 : 5; /* rows of simplex noise do not repeat */
    static const char *const rough[] = {"cell_f1, ", "cell_edge, ", "cell_value, "};
    static const char *const fractals[] = {"ridged, ",  "turbulence, ", "pingpong, ", "hybrid, ",
                                           "erosion, ", "swiss, ",      "jordan, "};
    const int is_rough = !w->is_smooth && recipe_draw(w, 3) == 0;
    recipe_put(w, "noise(%s",
               recipe_draw(w, 4) == 0 && is_rough ? rough[recipe_draw(w, 3)]
                                                  : bases[recipe_draw(w, count)]);
    if (is_rough) {
        recipe_put(w, "%s", fractals[recipe_draw(w, 7)]);
    }
    if (!w->has_tile && recipe_draw(w, 3) == 0) {
        recipe_put(w, "rotate, ");
    }
    if (w->has_tile) {
        recipe_put(w, "size=%d", 1 << recipe_draw(w, 3));
    } else {
        recipe_put(w, "size=%.2f", recipe_number(w, 1.0, 5.0));
    }
    /* One by one: compilers differ in which argument they draw first. */
    const unsigned seed = recipe_draw(w, 5);
    const double octaves = recipe_number(w, 1.0, 3.0);
    recipe_put(w, ", octaves=%.1f, seed=%u, amplitude=%.2f)", octaves, seed, amplitude);
}

static inline void recipe_put_field(struct recipe_writer *w, int depth);

static inline void recipe_put_one(struct recipe_writer *w, const char *before, const char *behind,
                                  int depth)
{
    recipe_put(w, "%s", before);
    recipe_put_field(w, depth - 1);
    recipe_put(w, "%s", behind);
}

static inline void recipe_put_two(struct recipe_writer *w, const char *before, const char *between,
                                  const char *behind, int depth)
{
    recipe_put_one(w, before, between, depth);
    recipe_put_one(w, "", behind, depth);
}

/* A place that f is brought to. */
static inline void recipe_put_placed(struct recipe_writer *w, int depth)
{
    const char *const z = w->is_space ? ", 0.8" : "";
    const uint32_t kind = w->has_tile ? recipe_draw(w, 2) : recipe_draw(w, 8);
    switch (kind) {
    case 0:
        recipe_put_one(w, "warp(", ", ", depth);
        if (w->noises > 0 && recipe_draw(w, 2) == 0) {
            recipe_put(w, "n%u)", (unsigned)recipe_draw(w, (uint32_t)w->noises));
        } else {
            recipe_put_noise(w, 0.4);
            recipe_put(w, ")");
        }
        break;
    case 1:
        recipe_put_one(w, "move(", "", depth);
        recipe_put(w, ", %.2f, -3.5%s)", recipe_number(w, -5.0, 5.0), z);
        break;
    case 2:
        recipe_put_one(w, "turn(", "", depth);
        recipe_put(w, ", %.2f)", recipe_number(w, -180.0, 180.0));
        break;
    case 3:
        recipe_put_one(w, "scale(", "", depth);
        recipe_put(w, ", %.2f)", recipe_number(w, 0.5, 2.0));
        break;
    case 4:
        recipe_put_one(w, "stretch(", "", depth);
        recipe_put(w, ", %.2f, 0.75%s)", recipe_number(w, 0.5, 2.0), z);
        break;
    case 5:
        recipe_put_one(w, "wind(", "", depth);
        recipe_put(w, ", %.2f, 1.5)", recipe_number(w, 0.0, 360.0));
        break;
    case 6:
        recipe_put_one(w, "at(", ", x + ", depth);
        recipe_put_one(w, "clamp(", ", -1, 1), y - x / 4", depth);
        recipe_put(w, "%s)", w->is_space ? ", z / 2" : "");
        break;
    default:
        if (w->is_space) {
            recipe_put(w, "flat(");
            recipe_put_noise(w, 1.0);
            recipe_put(w, ")");
        } else {
            recipe_put_noise(w, 1.0);
        }
        break;
    }
}

static inline void recipe_put_rough(struct recipe_writer *w, int depth)
{
    switch (recipe_draw(w, 7)) {
    case 0: recipe_put_two(w, "min(", ", ", ")", depth); break;
    case 1: recipe_put_two(w, "max(", ", ", ")", depth); break;
    case 2: recipe_put_one(w, "abs(", ")", depth); break;
    case 3: recipe_put_one(w, "clamp(", ", -0.5, 0.75)", depth); break;
    case 4: recipe_put_one(w, "curve(", ", -0.5: 0, 0: 0.25, 0.5: 0)", depth); break;
    case 5: recipe_put_one(w, "pulse(", ")", depth); break;
    default:
        recipe_put(w, "cell(");
        recipe_put_noise(w, 1.0);
        recipe_put(w, recipe_draw(w, 2) == 0 ? ", f1)" : ")");
        break;
    }
}

static inline void recipe_put_field(struct recipe_writer *w, int depth)
{
    if (depth <= 0 || recipe_draw(w, 6) == 0) {
        if (w->fields > 0 && recipe_draw(w, 2) == 0) {
            recipe_put(w, "f%u", (unsigned)recipe_draw(w, (uint32_t)w->fields));
        } else if (!w->has_tile && recipe_draw(w, 5) == 0) {
            recipe_put(w, recipe_draw(w, 2) == 0 ? "x / 8" : "y / 8");
        } else {
            recipe_put_noise(w, 1.0);
        }
        return;
    }
    switch (recipe_draw(w, w->is_smooth ? 14 : 17)) {
    case 0: recipe_put_two(w, "(", " + ", ")", depth); break;
    case 1: recipe_put_two(w, "(", " - ", ")", depth); break;
    case 2: recipe_put_two(w, "clamp(", ", -2, 2) * smoothstep(", ", 0, 0.4)", depth); break;
    case 3: recipe_put_two(w, "sine(", " / 4) * (", ")", depth); break;
    case 4: recipe_put_two(w, "(", " / (2 + smooth_abs(", ", 0.2)))", depth); break;
    case 5:
        recipe_put_two(w, "mix(", ", ", ", smoothstep(", depth);
        recipe_put_one(w, "", ", -0.25, 0.25))", depth);
        break;
    case 6: recipe_put_one(w, "smoothstep(", ", -0.5, 0.5)", depth); break;
    case 7: recipe_put_one(w, "terrace(", ", 2, riser=0.9, strength=0.4)", depth); break;
    case 8:
        recipe_put_two(w, "blend(", ", -0.3: ", ", 0.1: ", depth);
        recipe_put_one(w, "", ")", depth);
        break;
    case 9: recipe_put_two(w, "max(", ", ", ", smooth=0.3)", depth); break;
    case 10: recipe_put_one(w, "sqrt(1 + smooth_abs(", ", 0.1))", depth); break;
    case 11:
        recipe_put(w, "%.2f * ", recipe_number(w, 0.25, 1.5));
        recipe_put_one(w, "(", ")", depth);
        break;
    case 12:
    case 13: recipe_put_placed(w, depth); break;
    default: recipe_put_rough(w, depth); break;
    }
}

/* Writes the random recipe of a number. */
static inline void recipe_write(struct recipe_writer *w, uint64_t number, int is_smooth)
{
    memset(w, 0, sizeof *w);
    w->state = number * UINT64_C(0xD1342543DE82EF95) + 1;
    w->is_smooth = is_smooth;
    w->is_space = recipe_draw(w, 3) == 0;
    w->has_tile = recipe_draw(w, 6) == 0;
    recipe_put(w, "recipe 1\n%s%s", w->is_space ? "space 3\n" : "",
               !w->has_tile  ? ""
               : w->is_space ? "tile 64, 32, 16\n"
                             : "tile 64, 32\n");
    const uint32_t statements = 2 + recipe_draw(w, 4);
    for (uint32_t i = 0; i < statements; i++) {
        if (recipe_draw(w, 3) == 0) {
            recipe_put(w, "n%d = ", w->noises);
            recipe_put_noise(w, 0.3);
            w->noises++;
        } else {
            recipe_put(w, "f%d = ", w->fields);
            recipe_put_field(w, 1 + (int)recipe_draw(w, 3));
            w->fields++;
        }
        recipe_put(w, "\n");
    }
    recipe_put(w, "out last = ");
    recipe_put_field(w, 3);
    recipe_put(w, "\n");
}

/*
 * Random recipes in which bounds leave much out: noises have names, n0, n1, ... in front of all
 * else, so whoever asks for them, too, has all of them computed.
 */

static inline void recipe_put_side(struct recipe_writer *w, int depth);

static inline void recipe_put_sides(struct recipe_writer *w, const char *before,
                                    const char *between, const char *behind, int depth)
{
    recipe_put(w, "%s", before);
    recipe_put_side(w, depth - 1);
    recipe_put(w, "%s", between);
    recipe_put_side(w, depth - 1);
    recipe_put(w, "%s", behind);
}

static inline void recipe_put_held(struct recipe_writer *w, const char *before, const char *behind,
                                   int depth)
{
    recipe_put(w, "%s", before);
    recipe_put_side(w, depth - 1);
    recipe_put(w, "%s", behind);
}

static inline void recipe_put_ramp(struct recipe_writer *w)
{
    static const char *const ramps[] = {"x / 4",     "y / 8", "(x + y) / 16",
                                        "3 - x / 2", "z / 4", "1 - z / 8"};
    recipe_put(w, "(%s)", ramps[recipe_draw(w, w->is_space ? 6 : 4)]);
}

static inline void recipe_put_side(struct recipe_writer *w, int depth)
{
    if (depth <= 0) {
        if (recipe_draw(w, 5) < 2) {
            recipe_put_ramp(w);
        } else {
            const int other = (int)recipe_draw(w, 4) == 0; /* mostly each once */
            recipe_put(w, "n%d", other ? 1 : w->fields++ % w->noises);
        }
        return;
    }
    switch (recipe_draw(w, 22)) {
    case 0: recipe_put_sides(w, "max(", ", ", ")", depth); break;
    case 1: recipe_put_sides(w, "min(", ", ", ")", depth); break;
    case 2: recipe_put_sides(w, "max(", ", ", ", smooth=0.5)", depth); break;
    case 3: recipe_put_sides(w, "min(", ", ", ", smooth=0.25)", depth); break;
    case 4: recipe_put_held(w, "clamp(", ", -0.5, 1)", depth); break;
    case 5: recipe_put_held(w, "smoothstep(", ", -0.5, 0.5)", depth); break;
    case 6: recipe_put_held(w, "smoothstep(", ", 1, 0)", depth); break;
    case 7: recipe_put_held(w, "curve(", ", -1: 0.5, 0: 0, 1: 2)", depth); break;
    case 8: recipe_put_held(w, "max(", ", 0)", depth); break;
    case 9: recipe_put_sides(w, "mix(", ", n0, smoothstep(", ", -1, 1))", depth); break;
    case 10: recipe_put_sides(w, "", " * max(", ", 0)", depth); break;
    case 11: recipe_put_sides(w, "", " * clamp(", ", 0, 1)", depth); break;
    case 12: recipe_put_held(w, "abs(", ")", depth); break;
    case 13: recipe_put_held(w, "sine(1e20 * (", ")^2)", depth); break;
    case 14: recipe_put_held(w, "(slope(n0) + ", ")", depth); break;
    default: recipe_put_sides(w, "(", " + ", ")", depth); break;
    }
}

static inline void recipe_write_skips(struct recipe_writer *w, uint64_t number)
{
    memset(w, 0, sizeof *w);
    w->state = number * UINT64_C(0xD1342543DE82EF95) + 2;
    w->is_smooth = 1;
    w->is_space = recipe_draw(w, 2) == 0;
    recipe_put(w, "recipe 1\n%s", w->is_space ? "space 3\n" : "");
    while (w->noises < 10) {
        recipe_put(w, "n%d = ", w->noises);
        if (w->is_space && recipe_draw(w, 3) == 0) {
            recipe_put(w, "flat(");
            recipe_put_noise(w, 1.0);
            recipe_put(w, ")");
        } else {
            recipe_put_noise(w, 1.0);
        }
        recipe_put(w, "\n");
        w->noises++;
    }
    recipe_put(w, "out last = ");
    recipe_put_side(w, 2 + (int)recipe_draw(w, 3));
    recipe_put(w, "\n");
}

#endif
