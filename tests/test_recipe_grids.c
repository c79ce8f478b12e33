/* SPDX-License-Identifier: MIT
 *
 *     test_recipe_grids ISA COUNT
 *
 * A recipe on a grid has the bits that it has at the points of the grid, whatever the shape of the
 * grid is, the gaps in the arrays, the scratch memory, the outputs and the members that are asked
 * for; one noise also has those of scarp_grid2 or scarp_grid3. Nothing is written into gaps. Texts
 * that depend on few axes, several outputs, and COUNT random texts.
 */
#include "recipes.h"

#define OUTPUTS 4
#define ARRAYS 10
#define MOST 65536
#define GAPS (MOST * 3 / 2)
#define UNTOUCHED 12345.0f

static struct scarp_recipe recipe;
static double position[3][MOST];
static float expected[OUTPUTS][ARRAYS][MOST], met[OUTPUTS][ARRAYS][GAPS];
static uint64_t memory[(1 << 20) / 8];
static struct recipe_writer draw;

#define SPACE_ONE "recipe 1\nspace 3\n"
static const char *const texts[] = {
    /* One noise, and functions of it alone */
    "recipe 1\nout a = noise(size=2, octaves=3)",
    "recipe 1\nout a = 100 * noise(size=2) + 3",
    "recipe 1\nn = noise(size=2)\nout a = n\nout b = 2 * noise(value)\nout c = n\nout d = abs(n)",
    "recipe 1\nout a = noise(swiss, octaves=2)\nout b = noise(simplex)\nout c = noise() * 2 - 1",
    "recipe 1\nout a = 9 - 2 * noise(swiss, octaves=2)\nout b = 3 * noise(cell_f1) + 1\n"
    "w = noise(amplitude=0.5)\nout c = 7 * warp(noise(), w) - 2\nout d = -noise(value, rotate)",
    SPACE_ONE "out a = 2 - noise(octaves=3)\nout b = 9 * noise(jordan)\nout c = 3 * noise(cell_f2)",
    SPACE_ONE "out a = terrace(smoothstep(noise(size=3), -0.5, 0.5), 4) + 0.25",
    SPACE_ONE "out a = noise(rotate, octaves=2)\nout b = noise(cell_f1)\nout c = -noise()",
    /* Of fewer axes */
    "recipe 1\nout a = x\nout b = 2 * y + 1\nout c = x - y\nout d = min(x, 0.5) * noise()",
    "recipe 1\nout a = sine(x / 4) * noise() + smoothstep(y, 0, 4) * noise(seed=1, size=3)",
    "recipe 1\nout a = move(turn(x, 30), 1, 2) + scale(x * y, 2) + at(noise(), x, 0.25) * y",
    SPACE_ONE "out a = z - 70\nout b = x * y\nout c = curve(z, 0: 1, 3: 2) * x\nout d = y * z - x",
    SPACE_ONE "out a = flat(noise(octaves=2)) - z + noise(size=2)\nout b = flat(noise(seed=2))",
    SPACE_ONE "out a = at(noise(size=2), x, 0.5, z) * at(noise(), 0.25, y, z) + flat(noise()) * x",
    SPACE_ONE "out a = at(noise(), 0.1, 0.2, 0.3) * x + at(cell(noise(), f1), x, 1, 2)",
    SPACE_ONE "w = noise(amplitude=0.5)\nout a = flat(warp(noise(), w)) * warp(noise(), w)",
    SPACE_ONE "out a = flat(slope(noise() * x)) + at(slope(noise()), x, z, 0.5)",
    SPACE_ONE
    "out a = turn(noise() + z, 30, x) + move(flat(noise()), 1, 2, 3) + stretch(z, 1, 2, 3)",
    SPACE_ONE "out a = flat(gullies(noise(size=4), size=4)) + 0.5 * z\nout b = mix(x, z, 0.25)",
    SPACE_ONE "out a = flat(noise(octaves=2), y) - y + noise(size=2)\nout b = flat(noise(), x)",
    SPACE_ONE "out a = flat(noise(), x) * flat(noise(), y) + flat(slope(noise() * x), y) * 2",
    SPACE_ONE "m = smoothstep(x, 0, 2)\nout a = m * flat(noise(), y) + m * flat(noise(), x)",
    /* Masks of other axes than what they mask */
    SPACE_ONE "out a = smoothstep(x, 0, 2) * flat(noise()) + smoothstep(z, 1, 3) * flat(noise())",
    SPACE_ONE "out a = clamp(x, 0, 1) * (flat(noise()) * z)\nout b = clamp(z, 0, 1) * noise()",
    SPACE_ONE "m = smoothstep(y, 0, 2)\nout a = mix(flat(noise() * m), noise() * x, m) * m",
    SPACE_ONE "m = clamp(x, 0, 1)\np = flat(clamp(y, 0, 1) * (m * noise()))\n"
              "out a = m * (p + clamp(z, 0, 1) * (noise(seed=3) + p * flat(noise(seed=4))))",
};

struct shape {
    size_t count[3];
};
static const struct shape plane[] = {
    {{65, 65, 1}}, {{1, 1, 1}}, {{1, 40, 1}}, {{300, 200, 1}}, {{20000, 3, 1}}};
static const struct shape space[] = {{{17, 17, 17}},  {{32, 32, 32}},  {{1, 1, 1}},
                                     {{1, 1, 40}},    {{1, 40, 2}},    {{16, 256, 16}},
                                     {{16, 16, 256}}, {{256, 16, 16}}, {{5000, 2, 3}}};

static size_t count_of(const struct scarp_grid *g)
{
    return g->count[0] * g->count[1] * g->count[2];
}

static void spread(const struct scarp_grid *g)
{
    for (size_t i = 0; i < count_of(g); i++) {
        const size_t at[3] = {i % g->count[0], i / g->count[0] % g->count[1],
                              i / g->count[0] / g->count[1]};
        for (int a = 0; a < 3; a++) {
            position[a][i] = g->origin[a] + (double)(g->first[a] + (int64_t)at[a]) * g->step[a];
        }
    }
}

static float *array_of(const struct scarp_samples *s, int i)
{
    float *const all[ARRAYS] = {s->value, s->dx,  s->dy,  s->dz,  s->dxx,
                                s->dxy,   s->dyy, s->dxz, s->dyz, s->dzz};
    return all[i];
}

/* Some of the members up to an order: all of them more often than not. */
static struct scarp_samples some_of(struct scarp_samples s)
{
    float **const all[ARRAYS] = {&s.value, &s.dx,  &s.dy,  &s.dz,  &s.dxx,
                                 &s.dxy,   &s.dyy, &s.dxz, &s.dyz, &s.dzz};
    for (int i = 0; i < ARRAYS && recipe_draw(&draw, 2) == 0; i++) {
        *all[recipe_draw(&draw, ARRAYS)] = NULL;
    }
    return s;
}

/* How many numbers differ: from those of the points, or in gaps from what was there. */
static size_t differences(const struct scarp_grid *g, const float *of, const float *at_points)
{
    size_t different = 0, untouched = 0, i = 0;
    for (size_t row = 0; row < g->count[1] * g->count[2]; row++) {
        const float *const line =
            of + row / g->count[1] * g->slice_stride + row % g->count[1] * g->row_stride;
        for (size_t x = 0; x < g->count[0]; x++, i++) {
            const float a = at_points[i], b = line[x];
            different += memcmp(&a, &b, sizeof a) != 0 && !(a != a && b != b);
        }
    }
    for (size_t k = 0; k < GAPS; k++) {
        untouched += of[k] == UNTOUCHED;
    }
    return different + (untouched == GAPS - i ? 0 : 1);
}

/* What outputs are, by number: of the recipe, or its statements and parts. */
static int32_t numbers[OUTPUTS];

static void expect(const struct scarp_grid *g, int outputs, int order, int is_space)
{
    const struct scarp_scratch scratch = {.memory = memory, .size = sizeof memory};
    spread(g);
    for (int i = 0; i < outputs; i++) {
        const struct scarp_samples out = recipe_samples(expected[i][0], MOST, order, is_space);
        const struct scarp_recipe_outputs one = {.out = &out, .which = &numbers[i], .count = 1};
        const enum scarp_status status = scarp_recipe_sample_f64(
            &recipe, count_of(g), position[0], position[1], position[2], &one, &scratch);
        CHECK(status == SCARP_OK, "points: %s", scarp_status_text(status));
    }
}

/* One call. */
static void check_call(const char *name, const struct scarp_grid *g, int outputs, int order,
                       size_t size, int is_named)
{
    const int is_space = g->slice_stride > 0;
    struct scarp_samples out[OUTPUTS];
    const struct scarp_recipe_outputs to = {
        .out = out, .which = is_named ? numbers : NULL, .count = outputs};
    const struct scarp_scratch scratch = {.memory = (char *)memory + size % 32, .size = size};
    memset(memory, 0xff, sizeof memory);
    for (int i = 0; i < outputs; i++) {
        out[i] = some_of(recipe_samples(met[i][0], GAPS, order, is_space));
        for (int k = 0; k < ARRAYS; k++) {
            for (size_t n = 0; array_of(&out[i], k) != NULL && n < GAPS; n++) {
                met[i][k][n] = UNTOUCHED;
            }
        }
    }
    const enum scarp_status status =
        scarp_recipe_grid(&recipe, g, &to, size == 0 ? NULL : &scratch);
    CHECK(status == SCARP_OK || (size == 0 && status == SCARP_ERROR_SIZE), "%s: %s", name,
          scarp_status_text(status));
    for (int i = 0; i < outputs * ARRAYS && status == SCARP_OK; i++) {
        const float *const of = array_of(&out[i / ARRAYS], i % ARRAYS);
        const size_t different =
            of == NULL ? 0 : differences(g, of, expected[i / ARRAYS][i % ARRAYS]);
        CHECK_BITS(different == 0,
                   "%s\noutput %d, member %d, %zu x %zu x %zu, row %zu, slice %zu, %zu bytes: %zu",
                   name, i / ARRAYS, i % ARRAYS, g->count[0], g->count[1], g->count[2],
                   g->row_stride, g->slice_stride, size, different);
    }
}

/* The calls for a shape: of all sizes of memory and kinds of gaps, or of some. */
#define ALL_CALLS 12
static int calls;

/* Shapes with more samples are left out. */
static size_t largest = MOST;

static void check_shape(const char *name, const struct shape *shape, int outputs, int order,
                        int is_space)
{
    const size_t sizes[] = {0, 4096, 32 << 10, 64 << 10, 256 << 10, sizeof memory - 64};
    struct scarp_grid g = {
        .origin = {-3.25, 1.5, 0.75}, .step = {0.37, 0.041, -0.083}, .first = {-7, 2, 40}};
    memcpy(g.count, shape->count, sizeof g.count);
    g.row_stride = g.count[0];
    g.slice_stride = is_space ? g.count[0] * g.count[1] : 0;
    expect(&g, outputs, order, is_space);
    for (int k = 0; k < calls && !check_enough(); k++) {
        const int i = calls == ALL_CALLS ? k : (int)recipe_draw(&draw, ALL_CALLS);
        struct scarp_grid with_gaps = g;
        const size_t least = scarp_recipe_scratch_size(&recipe, 2, 16 + (size_t)i * 7);
        const size_t size = sizes[i % 6] == 4096 || (sizes[i % 6] > 0 && sizes[i % 6] < least)
                                ? least
                                : sizes[i % 6];
        if (i % 4 == 1) {
            with_gaps.row_stride += g.count[0] < 4096 ? 3 : 0;
            with_gaps.slice_stride = is_space ? with_gaps.row_stride * g.count[1] : 0;
        }
        if (i % 4 == 2 && is_space && g.count[0] * g.count[1] > 100) {
            with_gaps.slice_stride += 5;
        }
        if (with_gaps.slice_stride * g.count[2] > GAPS ||
            with_gaps.row_stride * g.count[1] > GAPS) {
            with_gaps = g;
        }
        check_call(name, &with_gaps, outputs, order, size, i % 2);
    }
}

/* The outputs of a recipe, or its last statements where these are fewer. */
static int find_outputs(void)
{
    struct scarp_recipe_entry entry;
    int outputs = 0;
    for (size_t i = 0; scarp_recipe_entry_at(&recipe, i, &entry) == SCARP_OK; i++) {
        if (entry.output >= 0 && outputs < OUTPUTS) {
            numbers[outputs++] = (int32_t)i;
        }
    }
    return outputs;
}

static int lowest_order(int outputs)
{
    struct scarp_recipe_entry entry;
    int order = 2;
    for (int i = 0; i < outputs; i++) {
        if (scarp_recipe_entry_at(&recipe, (size_t)numbers[i], &entry) == SCARP_OK &&
            (int)entry.order < order) {
            order = (int)entry.order;
        }
    }
    return order;
}

static void check_text(const char *text, int is_random)
{
    struct scarp_recipe_error error = {0};
    const enum scarp_status status =
        scarp_recipe_parse(text, strlen(text), &recipe, &error, 1, NULL);
    if (is_random && status == SCARP_ERROR_SIZE) {
        return;
    }
    CHECK(status == SCARP_OK, "%s\n%s", text, error.text != NULL ? error.text : "");
    if (status != SCARP_OK) {
        return;
    }
    const int is_space = strstr(text, "space 3") != NULL;
    const struct shape *const shapes = is_space ? space : plane;
    const size_t count = is_space ? sizeof space / sizeof *space : sizeof plane / sizeof *plane;
    const int outputs = find_outputs(), most = lowest_order(outputs);
    const size_t only = recipe_draw(&draw, (uint32_t)count);
    for (size_t i = 0; i < count && !check_enough(); i++) {
        const size_t samples = shapes[i].count[0] * shapes[i].count[1] * shapes[i].count[2];
        if (samples <= largest && (!is_random || i == only)) {
            check_shape(text, &shapes[i], outputs, (int)recipe_draw(&draw, (uint32_t)most + 1),
                        is_space);
        }
    }
}

/* More copies of nodes of fewer axes than there is room for: all nodes are taken for others. */
static void check_many(void)
{
    char text[4096] = "recipe 1\nn = noise()\n";
    size_t length = strlen(text);
    for (int i = 0; i < OUTPUTS; i++) {
        length += (size_t)snprintf(text + length, sizeof text - length, "out a%d = n", i);
        for (int k = 0; k < 17; k++) {
            length += (size_t)snprintf(text + length, sizeof text - length, " + (x + %d.5) * y",
                                       17 * i + k);
        }
        length += (size_t)snprintf(text + length, sizeof text - length, "\n");
    }
    check_text(text, 0);
}

/* Where coordinates are not finite, what does not depend on an axis is NaN on part of it. */
static void check_infinite(void)
{
    static const char text[] = SPACE_ONE "out a = flat(noise(value)) + move(x, 1, 0, 0)\nout b = x";
    struct scarp_grid g = {.step = {0.5, 0.25, 1e306}, .first = {0, 0, 90}, .count = {30, 20, 100}};
    g.row_stride = 30;
    g.slice_stride = 600;
    CHECK(scarp_recipe_parse(text, strlen(text), &recipe, NULL, 0, NULL) == SCARP_OK, "%s", text);
    const int outputs = find_outputs();
    expect(&g, outputs, 1, 1);
    CHECK(expected[0][0][0] == expected[0][0][0], "the first slice is finite");
    CHECK(expected[0][0][59999] != expected[0][0][59999], "the last slice is not");
    check_call(text, &g, outputs, 1, sizeof memory / 2, 0);
}

/* One noise has the bits of its own call. */
static void check_noise(int dimensions)
{
    const char *const text = dimensions == 2 ? "recipe 1\na = noise(size=2, octaves=2)"
                                             : SPACE_ONE "a = noise(size=2, octaves=2)";
    const struct scarp_noise noise = {.frequency = 0.5f, .octaves = 2, .offset_first = 1};
    const struct scarp_grid g = {.step = {0.1, 0.2, 0.3}, .count = {50, 30, 10}};
    const struct scarp_samples a = recipe_samples(met[0][0], GAPS, 2, dimensions == 3);
    const struct scarp_samples b = recipe_samples(met[1][0], GAPS, 2, dimensions == 3);
    const struct scarp_recipe_outputs to = {.out = &a, .count = 1};
    CHECK(scarp_recipe_parse(text, strlen(text), &recipe, NULL, 0, NULL) == SCARP_OK, "%s", text);
    memset(met, 0, sizeof met);
    CHECK(scarp_recipe_grid(&recipe, &g, &to, NULL) == SCARP_OK, "grid");
    CHECK((dimensions == 2 ? scarp_grid2(&noise, &g, &b) : scarp_grid3(&noise, &g, &b)) == SCARP_OK,
          "noise");
    CHECK_BITS(memcmp(met[0], met[1], sizeof met[0]) == 0, "%s: not the noise's bits", text);
}

int main(int argc, char **argv)
{
    argc = check_take_aim(argc, &argv);
    if (argc != 3) {
        fprintf(stderr, "usage: test_recipe_grids [--must-differ] ISA COUNT\n");
        return EXIT_FAILURE;
    }
    const int count = atoi(argv[2]);
    calls = count >= 100 ? ALL_CALLS : count >= 20 ? ALL_CALLS / 3 : 2;
    largest = count > 0 ? MOST : 5000;
    (void)check_select_isa(argv[1]);
    check_noise(2);
    check_noise(3);
    check_many();
    check_infinite();
    for (size_t i = 0; i < sizeof texts / sizeof texts[0] && !check_enough(); i++) {
        check_text(texts[i], 0);
    }
    for (int i = 0; i < count && !check_enough(); i++) {
        static struct recipe_writer w;
        recipe_write(&w, (uint64_t)i + 1000, i % 2);
        check_text(w.text, 1);
    }
    return check_done();
}
