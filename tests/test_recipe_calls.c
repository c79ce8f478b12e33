/* SPDX-License-Identifier: MIT
 *
 * The calls around recipes: what is refused, scratch memory, parameters, seeds, tiles, levels of
 * detail, outputs by number, and the same calls by hand.
 */
#include "recipe_values.h"

static struct scarp_recipe other;
static float by_hand[POINTS], dx[POINTS], dy[POINTS];

/* On an error of the call, nothing is written. */
static void check_calls(void)
{
    const float untouched = 7.0f;
    const struct scarp_samples out = {.value = value}, hessian = {.value = value, .dxx = dx},
                               deep = {.value = value, .dz = dx}, flow = {.dphase = value};
    struct scarp_samples spare = out;
    spare.spare[1] = dx;
    const int32_t none[] = {99}, part[] = {SCARP_RECIPE_PARTS + 600}, word[] = {-1};
    (void)parses("recipe 1\na = noise(swiss, octaves=2)");
    value[0] = untouched;
    CHECK(sample(&recipe, &hessian, NULL) == SCARP_ERROR_UNSUPPORTED, "no Hessian");
    CHECK(sample(&recipe, &deep, NULL) == SCARP_ERROR_UNSUPPORTED, "along z");
    CHECK(sample(&recipe, &flow, NULL) == SCARP_ERROR_UNSUPPORTED, "dphase");
    CHECK(sample(&recipe, &spare, NULL) == SCARP_ERROR_UNSUPPORTED, "spare");
    CHECK(sample(&recipe, &out, none) == SCARP_ERROR_PARAMETER, "no such statement");
    CHECK(sample(&recipe, &out, part) == SCARP_ERROR_PARAMETER, "no such part");
    CHECK(sample(&recipe, &out, word) == SCARP_ERROR_PARAMETER, "a negative number");
    struct scarp_recipe_outputs outputs = {.out = &out, .count = 2};
    CHECK(scarp_recipe_sample_f64(&recipe, POINTS, x, y, z, &outputs, &scratch) ==
              SCARP_ERROR_PARAMETER,
          "two outputs of one");
    outputs.count = 0;
    CHECK(scarp_recipe_sample_f64(&recipe, POINTS, x, y, z, &outputs, &scratch) ==
              SCARP_ERROR_PARAMETER,
          "no outputs");
    outputs.count = 1;
    outputs.spare[3] = 1;
    CHECK(scarp_recipe_sample_f64(&recipe, POINTS, x, y, z, &outputs, &scratch) ==
              SCARP_ERROR_UNSUPPORTED,
          "spare of outputs");
    outputs.spare[3] = 0;
    struct scarp_scratch small = {.memory = memory, .size = 100};
    CHECK(scarp_recipe_sample_f64(&recipe, POINTS, x, y, z, &outputs, &small) == SCARP_ERROR_SIZE,
          "little scratch memory");
    small.spare[0] = 1;
    CHECK(scarp_recipe_sample_f64(&recipe, POINTS, x, y, z, &outputs, &small) ==
              SCARP_ERROR_UNSUPPORTED,
          "spare of scratch");
    CHECK(scarp_recipe_sample_f64(&recipe, POINTS, x, NULL, z, &outputs, NULL) == SCARP_ERROR_NULL,
          "no y");
    CHECK(scarp_recipe_sample_f64(&recipe, POINTS, x, y, NULL, &outputs, NULL) == SCARP_OK,
          "no z, in the plane");
    value[0] = untouched;
    CHECK(scarp_recipe_sample_f64(NULL, POINTS, x, y, z, &outputs, NULL) == SCARP_ERROR_NULL,
          "no recipe");
    CHECK(scarp_recipe_sample_f64(NULL, 0, x, y, z, NULL, NULL) == SCARP_OK, "no points");
    CHECK(scarp_recipe_sample_f64(&recipe, SIZE_MAX / 4, x, y, z, &outputs, NULL) ==
              SCARP_ERROR_SIZE,
          "too many points");
    memset(&other, 0, sizeof other);
    CHECK(scarp_recipe_sample_f64(&other, POINTS, x, y, z, &outputs, NULL) == SCARP_ERROR_PARAMETER,
          "zeros are no recipe");
    struct scarp_grid grid = {.step = {1.0, 1.0}, .count = {8, 8}};
    CHECK(scarp_recipe_grid(&recipe, NULL, &outputs, NULL) == SCARP_ERROR_NULL, "no grid");
    grid.row_stride = 7;
    CHECK(scarp_recipe_grid(&recipe, &grid, &outputs, NULL) == SCARP_ERROR_PARAMETER, "stride");
    grid.row_stride = 0;
    grid.spare[0] = 1;
    CHECK(scarp_recipe_grid(&recipe, &grid, &outputs, NULL) == SCARP_ERROR_UNSUPPORTED, "spare");
    grid.spare[0] = 0;
    grid.count[1] = 0;
    CHECK(scarp_recipe_grid(&recipe, &grid, &outputs, NULL) == SCARP_OK, "an empty grid");
    CHECK(value[0] == untouched, "something was written: %g", (double)value[0]);
    static char long_text[16385];
    memset(long_text, '#', sizeof long_text);
    CHECK(scarp_recipe_parse(long_text, sizeof long_text, &recipe, NULL, 0, NULL) ==
              SCARP_ERROR_SIZE,
          "a text of 16,385 bytes");
    CHECK(scarp_recipe_parse(NULL, 1, &recipe, NULL, 0, NULL) == SCARP_ERROR_NULL, "no text");
    CHECK(scarp_recipe_parse("", 0, NULL, NULL, 0, NULL) == SCARP_ERROR_NULL, "no recipe");
}

/* The size of scratch memory, and what it is refused for */
static void check_scratch_size(void)
{
    static const struct scarp_recipe none;
    (void)parses("recipe 1\na = noise()");
    CHECK(scarp_recipe_scratch_size(&recipe, 2, 16) > scarp_recipe_scratch_size(&recipe, 0, 16) &&
              scarp_recipe_scratch_size(&recipe, 0, 16) > 0,
          "it grows with derivatives");
    for (int order = 0; order < 3; order++) {
        const size_t best = scarp_recipe_scratch_size(&recipe, order, 0);
        CHECK(best > scarp_recipe_scratch_size(&recipe, order, 1024) &&
                  best <= scarp_recipe_scratch_size(&recipe, order, 32768),
              "0 points stand for a large call: %zu bytes", best);
    }
    for (size_t points = 0; points <= 16; points += 16) {
        CHECK(scarp_recipe_scratch_size(&recipe, -1, points) == 0 &&
                  scarp_recipe_scratch_size(&recipe, 3, points) == 0,
              "orders that there are not");
        CHECK(scarp_recipe_scratch_size(NULL, 0, points) == 0 &&
                  scarp_recipe_scratch_size(&none, 0, points) == 0,
              "no recipe");
    }
    CHECK(scarp_recipe_scratch_size(&recipe, 0, SIZE_MAX / 65536 + 1) == 0, "too many points");
}

/* Parts of grids take registers, which must not be missing where there is no scratch memory. */
static void check_without_memory(void)
{
    (void)parses("recipe 1\nspace 3\nn = noise(seed=1)\nm = flat(noise(seed=2))\n"
                 "a = n + m + sine((x + y) / 16) + m * smoothstep(z / 4, 0, 1) + abs(x)");
    for (int order = 0; order < 3; order++) {
        float of[10];
        const float at = 1.0f;
        const double at_f64 = 1.0;
        const struct scarp_samples out = recipe_samples(of, 1, order, 1);
        const struct scarp_recipe_outputs outputs = {.out = &out, .count = 1};
        const struct scarp_grid grid = {.step = {1.0, 1.0, 1.0}, .count = {1, 1, 1}};
        CHECK(scarp_recipe_sample(&recipe, 1, &at, &at, &at, &outputs, NULL) == SCARP_OK &&
                  scarp_recipe_sample_f64(&recipe, 1, &at_f64, &at_f64, &at_f64, &outputs, NULL) ==
                      SCARP_OK &&
                  scarp_recipe_grid(&recipe, &grid, &outputs, NULL) == SCARP_OK,
              "order %d", order);
    }
}

static void check_set(void)
{
    const struct scarp_samples out = {.value = value};
    (void)parses("recipe 1\nparam k = 2 [1, 4]\nparam lo = 0\na = k * clamp(noise(), lo, 0.5)");
    (void)sample(&recipe, &out, NULL);
    memcpy(by_hand, value, sizeof by_hand);
    CHECK(scarp_recipe_set(&recipe, "k", 4.0, errors) == SCARP_OK, "k = 4");
    (void)sample(&recipe, &out, NULL);
    for (int i = 0; i < POINTS; i++) {
        CHECK(value[i] == 2.0f * by_hand[i], "%g is not twice %g", (double)value[i],
              (double)by_hand[i]);
    }
    CHECK(scarp_recipe_set(&recipe, "k", 4.5, errors) == SCARP_ERROR_PARAMETER, "k = 4.5");
    CHECK(scarp_recipe_set(&recipe, "k", (double)NAN, errors) == SCARP_ERROR_PARAMETER, "k = NaN");
    CHECK(scarp_recipe_set(&recipe, "q", 1.0, errors) == SCARP_ERROR_PARAMETER, "q");
    CHECK(scarp_recipe_set(&recipe, NULL, 1.0, errors) == SCARP_ERROR_NULL, "NULL");
    CHECK(errors[0].text == NULL, "an error of the text that is none");
    CHECK(scarp_recipe_set(&recipe, "lo", 0.75, errors) == SCARP_ERROR_PARAMETER &&
              errors[0].line == 4 && errors[0].text != NULL,
          "lo above hi, line %d", (int)errors[0].line);
    memcpy(by_hand, value, sizeof by_hand);
    (void)sample(&recipe, &out, NULL);
    CHECK(memcmp(by_hand, value, sizeof value) == 0, "the old value went");
    struct scarp_recipe_entry entry;
    (void)scarp_recipe_entry_at(&recipe, 0, &entry);
    CHECK(entry.value == 4.0 && entry.slider[0] == 1.0 && entry.slider[1] == 4.0, "k is %g",
          entry.value);
    (void)parses("recipe 1\nparam k = -2.5 [-3, -1]\na = k * noise()");
    (void)scarp_recipe_entry_at(&recipe, 0, &entry);
    CHECK(entry.value == -2.5 && entry.slider[0] == -3.0 && entry.slider[1] == -1.0, "k is %g",
          entry.value);
}

/* Seeds of noises, of cells and of gullies are those that the page of the language has, so others
   can make the same calls. */
static void check_rebuilt_seeds(void)
{
    static const struct {
        const char *seed;
        uint64_t number;
    } cases[] = {
        {"1", 65},
        {"7", 71},
        {"9007199254740991", (UINT64_C(1) << 53) + 63},
        {"-1", UINT64_MAX},
        {"-64", 0 - UINT64_C(64)},
        {"-9007199254740991", 1 - (UINT64_C(1) << 53)},
    };
    const uint64_t worlds[] = {0, 8, UINT64_C(0xfedcba9876543210)};
    const struct scarp_samples out = {.value = value}, hand = {.value = by_hand};
    const struct scarp_samples base = {.value = value, .dx = dx, .dy = dy};
    const struct scarp_eroded eroded = {.displacement = by_hand};
    static uint32_t id[POINTS];
    const struct scarp_cells cells = {.id = id};
    for (size_t i = 0; i < 3 * sizeof cases / sizeof cases[0]; i++) {
        const uint64_t world = worlds[i % 3], number = cases[i / 3].number;
        const uint64_t seed = check_random_number(check_random_number(world, 1), number);
        const struct scarp_noise noise = {.offset_first = 1, .seed = seed, .octaves = 2.0f},
                                 level = {.offset_first = 1, .seed = world};
        const struct scarp_gullies gullies = {.offset_first = 1, .seed = seed};
        char text[128];
        snprintf(text, sizeof text,
                 "recipe 1\nn = noise(octaves=2, seed=%s)\ng = displacement(noise(), seed=%s)\n"
                 "c = cell(n)",
                 cases[i / 3].seed, cases[i / 3].seed);
        (void)parses(text);
        (void)scarp_recipe_seed(&recipe, world);
        (void)sample(&recipe, &out, &(const int32_t){0});
        (void)scarp_sample2_f64(&noise, POINTS, x, y, &hand);
        CHECK(memcmp(value, by_hand, sizeof value) == 0, "%s of world %d", cases[i / 3].seed,
              (int)(i % 3));
        (void)sample(&recipe, &out, &(const int32_t){2});
        (void)scarp_cells2_f64(&noise, POINTS, x, y, &cells);
        for (int k = 0; k < POINTS; k++) {
            CHECK(value[k] == (float)((double)(int32_t)id[k] * 0x1p-31), "cells of %s",
                  cases[i / 3].seed);
        }
        (void)scarp_sample2_f64(&level, POINTS, x, y, &base);
        (void)scarp_gullies2_f64(&gullies, POINTS, x, y, &base, &eroded);
        (void)sample(&recipe, &out, &(const int32_t){1});
        CHECK(memcmp(value, by_hand, sizeof value) == 0, "gullies of %s", cases[i / 3].seed);
    }
}

static void check_seeds(void)
{
    const struct scarp_samples out = {.value = value};
    check_same_values("recipe 1\na = noise(seed=0)", "recipe 1\na = noise()");
    check_different_values("recipe 1\na = noise(seed=1)", "recipe 1\na = noise()");
    check_different_values("recipe 1\na = noise(seed=1)", "recipe 1\na = noise(seed=2)");
    check_different_values("recipe 1\na = noise(seed=-1)", "recipe 1\na = noise(seed=1)");
    check_same_values("recipe 1\na = noise(seed=-0)", "recipe 1\na = noise()");
    check_rebuilt_seeds();
    (void)parses("recipe 1\na = noise()");
    (void)scarp_recipe_seed(&recipe, UINT64_C(0x123456789abcdef0));
    (void)sample(&recipe, &out, NULL);
    const struct scarp_noise noise = {.offset_first = 1, .seed = UINT64_C(0x123456789abcdef0)};
    const struct scarp_samples hand = {.value = by_hand};
    (void)scarp_sample2_f64(&noise, POINTS, x, y, &hand);
    CHECK(memcmp(value, by_hand, sizeof value) == 0, "the seed of the world");
}

/* The same calls, made by hand */
static void check_by_hand(void)
{
    const struct scarp_noise warp = {.offset_first = 1, .frequency = 0.5, .amplitude = 0.3f},
                             noise = {.offset_first = 1, .octaves = 3.0f, .warp = &warp},
                             mask = {.offset_first = 1, .basis = SCARP_VALUE};
    static float a[3][POINTS], b[3][POINTS];
    const struct scarp_samples n = {.value = a[0], .dx = a[1], .dy = a[2]};
    const struct scarp_samples m = {.value = b[0], .dx = b[1], .dy = b[2]};
    const struct scarp_samples out = {.value = value, .dx = dx, .dy = dy};
    (void)parses("recipe 1\na = 3 * (warp(noise(octaves=3), noise(size=2, amplitude=0.3)) * "
                 "smoothstep(noise(value), -0.5, 0.5)) + 2");
    (void)sample(&recipe, &out, NULL);
    (void)scarp_sample2_f64(&noise, POINTS, x, y, &n);
    (void)scarp_sample2_f64(&mask, POINTS, x, y, &m);
    (void)scarp_smoothstep(POINTS, &m, -0.5f, 0.5f, &m);
    (void)scarp_multiply(POINTS, &n, &m, &n);
    (void)scarp_affine(POINTS, &n, 3.0f, 0.0f, &n);
    (void)scarp_affine(POINTS, &n, 1.0f, 2.0f, &n);
    CHECK(memcmp(value, a[0], sizeof value) == 0 && memcmp(dx, a[1], sizeof dx) == 0 &&
              memcmp(dy, a[2], sizeof dy) == 0,
          "the recipe differs from the same calls by hand: %g and %g", (double)value[0],
          (double)a[0][0]);
}

/* Cells are those of the first octave, whichever octaves there are. */
static void check_cells(void)
{
    static const char *const of[] = {"octaves=0.5, of_octaves=0.75", "octaves=1, of_octaves=1",
                                     "octaves=3, of_octaves=3.5", "octaves=0.25"};
    static const char *const what[] = {"", ", f1", ", f2"};
    for (int i = 0; i < 4 * 3; i++) {
        char text[128], as[128];
        snprintf(text, sizeof text, "recipe 1\nout o = cell(noise(seed=3, %s)%s) * 2", of[i / 3],
                 what[i % 3]);
        snprintf(as, sizeof as, "recipe 1\nout o = cell(noise(seed=3)%s) * 2", what[i % 3]);
        check_same_values(text, as);
    }
}

/* flat() changes no coordinate of the plane, also inside of places in places. */
static void check_flat(void)
{
    check_same_values(SPACE "a = at(at(flat(x), x + m, y, z), y + n, x, z)",
                      SPACE "a = at(at(x, x + m, y, z), y + n, x, z)");
    check_same_values(SPACE "a = at(flat(n), x + m, y, z + n)",
                      SPACE "a = at(flat(n), x + m, y, z)");
}

/* Wind from the west or from the south, across which the field is longer */
static void check_wind(void)
{
    check_same_values(ONE "a = wind(n, 270, 3)", ONE "a = stretch(n, 1, 3)");
    check_same_values("recipe 1\nspace 3\na = wind(x + 2 * y + 4 * z, 270, 4)",
                      "recipe 1\nspace 3\na = x + y / 2 + 4 * z");
    check_same_values("recipe 1\nspace 3\na = wind(noise(), 270, 3)",
                      "recipe 1\nspace 3\na = stretch(noise(), 1, 3)");
}

/* Two things of one kind in a text stay two. What a text has again is kept once, so that it comes
   under its limits. */
static void check_shared(void)
{
    static char many[16384];
    check_different_values(ONE "a = curve(n, -1: 0, 1: 1) + curve(n, -1: 0, 1: 1)",
                           ONE "a = curve(n, -1: 0, 1: 1) + curve(n, -1: 5, 1: 6)");
    check_different_values(ONE "a = displacement(n) + displacement(n)",
                           ONE "a = displacement(n) + displacement(n, seed=9)");
    check_different_values(ONE "a = turn(n, 30) + turn(n, 30)",
                           ONE "a = turn(n, 30) + turn(n, 40)");
    check_same_values(ONE "a = -n", ONE "a = 0 - n");
    (void)parses("recipe 1\nw = noise(amplitude=0.1)\n"
                 "a = warp(noise(seed=5), warp(w, warp(w, warp(w, warp(w, w)))))");
    static const struct {
        const char *statement; /* with its number, twice */
        int count;             /* more than the limit of what it has */
    } repeated[] = {
        {"a%d = displacement(x * %d + 3 * y)\n", 12},
        {"a%d = turn(x * %d, 30)\n", 40},
        {"a%d = x * %d * noise(seed=5)\n", 60},
        {"a%d = curve(x, 0: 1, 1: 2, 2: 3, 3: 5)\n", 33},
    };
    for (size_t k = 0; k < sizeof repeated / sizeof repeated[0]; k++) {
        size_t length = (size_t)snprintf(many, sizeof many, "recipe 1\n");
        for (int i = 1; i <= repeated[k].count; i++) {
            length += (size_t)snprintf(many + length, sizeof many - length, repeated[k].statement,
                                       i, i + 1);
        }
        (void)parses(many);
    }
}

/* A mask that is 0 hides NaN, also of a chunk in which it is 0 here and there only. */
static void check_masks(void)
{
    struct scarp_samples out = {.value = value, .dx = dx, .dy = dy};
    double kept = y[5];
    (void)parses(
        "recipe 1\na = mix(1, noise() + at(noise(), x, y * 1e30 * 1e30), smoothstep(x, 5, 6))");
    y[5] = 1e290; /* the inner place overflows there */
    (void)sample(&recipe, &out, NULL);
    for (int i = 0; i < POINTS; i++) {
        CHECK(value[i] == 1.0f && dx[i] == 0.0f, "%d: %g, %g", i, (double)value[i], (double)dx[i]);
    }
    y[5] = kept;
}

/* Tiles repeat, in every bit where coordinates are exact. */
static void check_tile(void)
{
    double moved[POINTS], rounded[2][POINTS];
    struct scarp_samples out = {.value = value}, there = {.value = by_hand};
    const struct scarp_recipe_outputs outputs = {.out = &out, .count = 1},
                                      others = {.out = &there, .count = 1};
    (void)parses("recipe 1\ntile 8, 4\nw = noise(size=2, amplitude=0.4, octaves=2)\n"
                 "a = warp(noise(octaves=2), w) + stretch(noise(size=2), 2, 1) + "
                 "gullies(noise(size=2), size=2, cells=2, octaves=2) + cell(noise())");
    for (int i = 0; i < POINTS; i++) {
        rounded[0][i] = (double)(int)(x[i] * 64.0) / 64.0;
        rounded[1][i] = (double)(int)(y[i] * 64.0) / 64.0;
        moved[i] = rounded[0][i] + 8.0;
    }
    (void)scarp_recipe_sample_f64(&recipe, POINTS, rounded[0], rounded[1], NULL, &outputs,
                                  &scratch);
    (void)scarp_recipe_sample_f64(&recipe, POINTS, moved, rounded[1], NULL, &others, &scratch);
    CHECK(memcmp(value, by_hand, sizeof value) == 0, "along x: %g and %g", (double)value[0],
          (double)by_hand[0]);
    for (int i = 0; i < POINTS; i++) {
        moved[i] = rounded[1][i] - 4.0;
    }
    (void)scarp_recipe_sample_f64(&recipe, POINTS, rounded[0], moved, NULL, &others, &scratch);
    CHECK(memcmp(value, by_hand, sizeof value) == 0, "along y: %g and %g", (double)value[0],
          (double)by_hand[0]);
    (void)parse("recipe 1\ntile 10, 10\na = noise(size=3)");
    CHECK(fabs(errors[0].nearest - 10.0 / 3.0) < 1e-12, "the nearest size is %g",
          errors[0].nearest);
}

/* Octaves below `finest` go, and come back bit by bit. */
static void check_finest(void)
{
    const struct scarp_samples out = {.value = value};
    (void)parses("recipe 1\na = noise(size=8, octaves=6)");
    CHECK(scarp_recipe_set(&recipe, "finest", 2.0, NULL) == SCARP_OK, "finest = 2");
    (void)sample(&recipe, &out, NULL);
    const struct scarp_noise three = {
        .offset_first = 1, .frequency = 0.125, .octaves = 3.0f, .of_octaves = 6.0f};
    const struct scarp_samples hand = {.value = by_hand};
    (void)scarp_sample2_f64(&three, POINTS, x, y, &hand);
    CHECK(memcmp(value, by_hand, sizeof value) == 0, "finest = 2 is not three of six octaves");
    CHECK(scarp_recipe_set(&recipe, "finest", 0.0, NULL) == SCARP_OK, "finest = 0");
    (void)sample(&recipe, &out, NULL);
    memcpy(by_hand, value, sizeof by_hand);
    (void)values("recipe 1\na = noise(size=8, octaves=6)");
    CHECK(memcmp(value, by_hand, sizeof value) == 0, "finest = 0 is not all of it");
    (void)parses("recipe 1\na = scale(noise(size=2, octaves=6), 4)");
    (void)scarp_recipe_set(&recipe, "finest", 2.0, NULL);
    (void)sample(&recipe, &out, NULL);
    const struct scarp_noise scaled = {
        .offset_first = 1, .frequency = 0.125, .octaves = 3.0f, .of_octaves = 6.0f};
    (void)scarp_sample2_f64(&scaled, POINTS, x, y, &hand);
    CHECK(memcmp(value, by_hand, sizeof value) == 0, "a place that scales divides it");
    static const char *const squeezed[] = {"recipe 1\na = stretch(noise(size=16, %s), 0.5, 1)",
                                           "recipe 1\na = stretch(noise(size=16, %s), 1, 0.5)",
                                           "recipe 1\nspace 3\na = "
                                           "stretch(noise(size=16, %s), 1, 2, 0.5)",
                                           "recipe 1\nspace 3\nn = noise(size=9)\na = "
                                           "stretch(at(stretch(noise(size=16, %s), 2, 2, 0.5), "
                                           "x + n, y + n, z - n), 2, 2, 1)"};
    for (int i = 0; i < 4; i++) {
        char text[2][256];
        snprintf(text[0], sizeof text[0], squeezed[i], "octaves=6");
        snprintf(text[1], sizeof text[1], squeezed[i], "octaves=3, of_octaves=6");
        (void)parses(text[0]);
        (void)scarp_recipe_set(&recipe, "finest", 2.0, NULL);
        (void)sample(&recipe, &out, NULL);
        memcpy(by_hand, value, sizeof by_hand);
        (void)values(text[1]);
        CHECK(memcmp(value, by_hand, sizeof value) == 0, "%s: the axis of most cells counts",
              text[0]);
    }
    (void)parses("recipe 1\na = gullies(noise(size=16), size=16, octaves=6, cells=3)");
    (void)scarp_recipe_set(&recipe, "finest", 4.0, NULL);
    (void)sample(&recipe, &out, NULL);
    memcpy(by_hand, value, sizeof by_hand);
    (void)values(
        "recipe 1\na = gullies(noise(size=16), size=16, octaves=3, of_octaves=6, cells=3)");
    CHECK(memcmp(value, by_hand, sizeof value) == 0, "gullies count by cells of the base");
}

/* Statements and parts by number, several at once */
static void check_which(void)
{
    (void)parses("recipe 1\na = noise()\nout b = 2 * a\nout c = warp(a, noise(size=2)) + a");
    const struct scarp_samples out[3] = {{.value = value}, {.value = by_hand}, {.value = dx}};
    struct scarp_recipe_outputs outputs = {.out = out, .count = 2};
    float kept[2][POINTS];
    CHECK(scarp_recipe_sample_f64(&recipe, POINTS, x, y, z, &outputs, &scratch) == SCARP_OK,
          "both");
    memcpy(kept[0], value, sizeof value);
    memcpy(kept[1], by_hand, sizeof by_hand);
    const int32_t which[3] = {2, 0, 1};
    outputs.which = which;
    outputs.count = 3;
    CHECK(scarp_recipe_sample_f64(&recipe, POINTS, x, y, z, &outputs, NULL) == SCARP_OK, "three");
    for (int i = 0; i < POINTS; i++) {
        CHECK(value[i] == kept[1][i] && dx[i] == kept[0][i] && dx[i] == 2.0f * by_hand[i],
              "%d: %g %g %g", i, (double)value[i], (double)by_hand[i], (double)dx[i]);
    }
    /* Each part that is a field */
    struct scarp_recipe_part part;
    for (size_t p = 0; scarp_recipe_part_at(&recipe, p, &part) == SCARP_OK; p++) {
        const int32_t one[1] = {(int32_t)p + SCARP_RECIPE_PARTS};
        const int is_field = part.kind == SCARP_RECIPE_FIELD || part.kind == SCARP_RECIPE_NOISE;
        const enum scarp_status status = sample(&recipe, &out[0], one);
        CHECK(is_field == (status == SCARP_OK), "part %zu, kind %d: %s", p, part.kind,
              scarp_status_text(status));
    }
    /* An output that is a number */
    (void)values("recipe 1\nout a = 7");
    CHECK(value[POINTS - 1] == 7.0f, "%g", (double)value[POINTS - 1]);
}

int main(void)
{
    set_positions();
    check_calls();
    check_scratch_size();
    check_without_memory();
    check_set();
    check_seeds();
    check_by_hand();
    check_cells();
    check_flat();
    check_wind();
    check_shared();
    check_masks();
    check_tile();
    check_finest();
    check_which();
    return check_done();
}
