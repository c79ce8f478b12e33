/* SPDX-License-Identifier: MIT
 *
 * Every sample of a grid has the bits of the point calls, whatever the tiles, strides, steps,
 * origins and instruction set, and nothing between the rows is written. Fewer than 1000 CASES run
 * fewer large grids too; 0 CASES run only these.
 *
 *     test_grid ISA [CASES]
 *     test_grid --must-differ ISA [CASES] some results must differ: for mutants
 *     test_grid --must-crash ISA 0        streaming to slices that are not aligned must crash: for
 *                                         a mutant that changes nothing else
 */
#include <math.h>
#include <signal.h>

#include "grid_cases.h"

#define FLOATS_MAX (1 << 17)

static struct outputs got, expected;
static double *coordinate[3];

static size_t row_stride(const struct scarp_grid *grid)
{
    return grid->row_stride != 0 ? grid->row_stride : grid->count[0];
}

static size_t slice_stride(const struct scarp_grid *grid)
{
    return grid->slice_stride != 0 ? grid->slice_stride : grid->count[1] * row_stride(grid);
}

static size_t floats_of(const struct grid_case *c)
{
    const size_t slices = c->dimensions == 3 ? c->grid.count[2] : 1;
    return slices * (slice_stride(&c->grid) + row_stride(&c->grid)) +
           c->grid.count[1] * row_stride(&c->grid);
}

/* The position of an index, as scarp.h has it. */
static double at(const struct scarp_grid *grid, int axis, size_t index)
{
    return grid->origin[axis] + (double)(grid->first[axis] + (int64_t)index) * grid->step[axis];
}

/* Samples the grid row by row with the point calls. */
static void run_points(const struct grid_case *c)
{
    const struct scarp_grid *const g = &c->grid;
    const enum function f = c->dimensions == 2 ? SAMPLE2_F64 : SAMPLE3_F64;
    const struct inputs in = {.d = {coordinate[0], coordinate[1], coordinate[2]}};
    for (size_t k = 0; k < (c->dimensions == 3 ? g->count[2] : 1); k++) {
        for (size_t j = 0; j < g->count[1]; j++) {
            for (size_t i = 0; i < g->count[0]; i++) {
                coordinate[0][i] = at(g, 0, i);
                coordinate[1][i] = at(g, 1, j);
                coordinate[2][i] = at(g, 2, k);
            }
            const struct scarp_samples row =
                outputs_at(&expected, c->wanted, k * slice_stride(g) + j * row_stride(g));
            const enum scarp_status status = function_call(f, &c->noise, g->count[0], &in, &row);
            CHECK(status == SCARP_OK, "points: %s", scarp_status_text(status));
        }
    }
}

static void describe(const struct grid_case *c, char *text, size_t size)
{
    snprintf(text, size,
             "%dD basis %d fade %d fractal %d rotate %u octaves %g order %d, %zu x %zu x %zu, "
             "steps %g %g %g, x from %g + %lld, %s",
             c->dimensions, (int)c->noise.basis, (int)c->noise.fade, (int)c->noise.fractal,
             (unsigned)c->noise.rotate, (double)c->noise.octaves, c->order, c->grid.count[0],
             c->grid.count[1], c->grid.count[2], c->grid.step[0], c->grid.step[1], c->grid.step[2],
             c->grid.origin[0], (long long)c->grid.first[0],
             c->noise.warp != NULL ? "warped" : "no warp");
}

static void test_points(const struct grid_case *c)
{
    char text[256];
    describe(c, text, sizeof text);
    outputs_poison(&got);
    outputs_poison(&expected);
    const struct scarp_samples out = outputs_subset(&got, c->wanted);
    const enum scarp_status status = grid_call(c->dimensions, &c->noise, &c->grid, &out);
    CHECK(status == SCARP_OK, "%s: %s", text, scarp_status_text(status));
    run_points(c);
    int member = 0;
    size_t where = 0;
    CHECK_BITS(
        outputs_equal(&got, &expected, OUTPUTS_ALL3 | OUTPUTS_PHASE, got.capacity, &member, &where),
        "%s: %s differs at %zu: %a, not %a", text, output_names[member], where,
        (double)got.array[member][where], (double)expected.array[member][where]);
}

/* Samples the grid of `c` in tiles of random size, one call per tile. `expected` still holds what
   test_points put there. */
static void test_tiles(const struct grid_case *c, uint64_t *state)
{
    const struct scarp_grid *const g = &c->grid;
    const size_t slices = c->dimensions == 3 ? g->count[2] : 1;
    size_t size[3];
    for (int axis = 0; axis < 3; axis++) {
        size[axis] = 1 + pick(state, g->count[axis]);
    }
    outputs_poison(&got);
    for (size_t k = 0; k < slices; k += size[2]) {
        for (size_t j = 0; j < g->count[1]; j += size[1]) {
            for (size_t i = 0; i < g->count[0]; i += size[0]) {
                const size_t begin[3] = {i, j, k};
                struct scarp_grid tile = *g;
                tile.row_stride = row_stride(g);
                tile.slice_stride = slice_stride(g);
                for (int axis = 0; axis < 3; axis++) {
                    const size_t left = g->count[axis] - begin[axis];
                    tile.first[axis] += (int64_t)begin[axis];
                    tile.count[axis] = left < size[axis] ? left : size[axis];
                }
                const struct scarp_samples out =
                    outputs_at(&got, c->wanted, k * slice_stride(g) + j * row_stride(g) + i);
                const enum scarp_status status = grid_call(c->dimensions, &c->noise, &tile, &out);
                CHECK(status == SCARP_OK, "tile: %s", scarp_status_text(status));
            }
        }
    }
    char text[256];
    describe(c, text, sizeof text);
    int member = 0;
    size_t where = 0;
    CHECK_BITS(
        outputs_equal(&got, &expected, OUTPUTS_ALL3 | OUTPUTS_PHASE, got.capacity, &member, &where),
        "%s: tiles of %zu x %zu x %zu: %s differs at %zu", text, size[0], size[1], size[2],
        output_names[member], where);
}

/* Samples rows on lattice planes, where only rounding decides between two cells: samples that
   should be k / 16 cells apart cross one column more or less now and then. */
static void test_on_planes(uint64_t *state)
{
    struct grid_case c = {.dimensions = 2, .order = 1, .wanted = outputs_up_to(1, 2)};
    const double apart = (double)(1 + pick(state, 18)) / 16;
    c.noise.frequency = 1 / (1 + (double)pick(state, 1000) / 7);
    c.noise.seed = check_random(state);
    c.grid.step[0] = (pick(state, 4) == 0 ? -apart : apart) / c.noise.frequency;
    c.grid.step[1] = 0.3;
    c.grid.first[0] = (int64_t)pick(state, 2000000) - 1000000;
    c.grid.count[0] = 64 + pick(state, 1000);
    c.grid.count[1] = 2;
    got.capacity = expected.capacity = floats_of(&c);
    test_points(&c);
}

/* Samples a grid of short rows that has more samples than are added up at once (CROSSING_SAMPLES of
   kernel/crossing.h). */
static void test_short_rows(uint64_t *state)
{
    struct grid_case c = {.dimensions = 2 + (int)pick(state, 2), .order = (int)pick(state, 2)};
    c.noise.basis = (enum scarp_basis)pick(state, 8);
    c.noise.octaves = (float)(1 + pick(state, 2));
    c.noise.seed = check_random(state);
    c.grid.count[0] = 1 + pick(state, 19);
    c.grid.count[1] = c.dimensions == 2 ? 1 : 1 + pick(state, 50);
    c.grid.count[c.dimensions - 1] = 20000 / (c.grid.count[0] * c.grid.count[1]);
    c.grid.count[2] += c.dimensions == 2;
    for (int axis = 0; axis < 3; axis++) {
        c.grid.origin[axis] = check_random_double(state, 100.0);
        c.grid.step[axis] = check_random_double(state, 0.2);
    }
    c.wanted = outputs_up_to(c.order, c.dimensions);
    got.capacity = expected.capacity = floats_of(&c);
    test_points(&c);
}

/* A grid whose outputs are more than STREAM_BYTES (kernel/grid.h), 24 MiB. */
struct large_case {
    int dimensions, order;
    size_t count[3], gap; /* between rows */
    size_t slice_gap;     /* between slices */
    size_t start, apart;  /* outputs begin start, start + apart, ... floats past a cache line */
};

#define LARGE_FLOATS ((size_t)8 << 20)
#define LARGE_CASES 19
#define FLOWING_CASES 16 /* those from here on flow */
#define LARGE_CASES_FEW 3
#define LINE 16 /* floats */

/* clang-format off */
static const struct large_case large_cases[LARGE_CASES] = {
    {3, 0, {64, 1024, 97}, 0, 3, 0, 0},  /* each slice lies differently: not to be streamed */
    {2, 2, {2048, 520, 1}, 0, 0, 0, 0},  /* rows of whole cache lines */
    {3, 2, {1030, 25, 25}, 10, 0, 7, 0}, /* aligned inside rows only */
    {2, 2, {2101, 510, 1}, 11, 0, 4, 0}, /* aligned as by malloc */
    {2, 2, {2101, 510, 1}, 11, 0, 13, 16},
    {2, 2, {2048, 520, 1}, 4, 0, 4, 4},/* for vectors of 4 floats only */
    {2, 2, {2048, 520, 1}, 0, 0, 1, 1},  /* outputs lie differently */
    {2, 2, {2049, 520, 1}, 0, 0, 0, 0},  /* rows lie differently */
    {2, 2, {2044, 520, 1}, 4, 0, 0, 0},
    {2, 1, {1039, 2040, 1}, 17, 0, 5, 0},
    {2, 0, {4096, 1540, 1}, 0, 0, 0, 0},
    {2, 0, {2400, 2640, 1}, 16, 0, 4, 0},
    {3, 1, {160, 100, 100}, 0, 0, 0, 0},
    {3, 0, {64, 320, 310}, 16, 0, 0, 0},
    {3, 0, {1100, 76, 76}, 4, 0, 3, 0},
    {2, 2, {2069, 520, 1}, 11, 0, 0, 0}, /* less than a vector is left behind whole strips */
    {2, 0, {2048, 1600, 1}, 0, 0, 0, 0}, /* these have a phase, and DPHASE */
    {3, 1, {160, 90, 90}, 0, 0, 0, 0},
    {2, 0, {2048, 1600, 1}, 0, 0, 0, 1},
};
/* clang-format on */

/* Handles the signal of a vector that is streamed to an address that is not aligned to it. */
static void crashed(int number)
{
    (void)number;
    _Exit(check_failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE);
}

/* Checks a large grid: where its outputs are aligned, they are stored past the caches. */
static void test_large(int i, float *const memory[2])
{
    const struct large_case *const large = &large_cases[i];
    struct grid_case c = {.dimensions = large->dimensions, .order = large->order};
    c.noise.basis = i >= FLOWING_CASES       ? SCARP_GRADIENT
                    : i % 8 == 4             ? SCARP_SIMPLEX
                    : i == 7 && c.order == 2 ? SCARP_CELL_F1
                                             : (enum scarp_basis)(i % 2);
    c.noise.phase = i >= FLOWING_CASES ? 0.3f : 0.0f;
    for (int axis = 0; axis < 3; axis++) {
        c.grid.origin[axis] = -3.7;
        c.grid.step[axis] = i % 3 == 0 ? 0.3 : 0.01;
        c.grid.count[axis] = large->count[axis];
    }
    c.grid.row_stride = large->count[0] + large->gap;
    c.grid.slice_stride = large->count[1] * c.grid.row_stride + large->slice_gap;
    c.wanted =
        outputs_up_to(large->order, large->dimensions) | (i >= FLOWING_CASES ? OUTPUTS_PHASE : 0u);
    const size_t floats = large->count[2] * c.grid.slice_stride;
    const size_t next = (floats / LINE + 2) * LINE + large->apart; /* poison follows each output */
    struct outputs *const both[2] = {&got, &expected};
    const struct outputs before[2] = {got, expected};
    for (int o = 0; o < 2; o++) {
        size_t at = large->start;
        both[o]->capacity = next;
        for (int m = 0; m < OUTPUTS; m++) {
            both[o]->array[m] = (c.wanted >> m & 1) != 0 ? memory[o] + at : NULL;
            at += both[o]->array[m] != NULL ? next : 0;
        }
        CHECK(at <= LARGE_FLOATS, "large case %d: %zu floats", i, at);
    }
    if (check_aim == CHECK_CRASH && large->slice_gap != 0) {
        signal(SIGSEGV, crashed);
    }
    test_points(&c);
    signal(SIGSEGV, SIG_DFL);
    got = before[0];
    expected = before[1];
}

static void test_all_large(int cases)
{
    float *memory[2], *aligned[2];
    for (int o = 0; o < 2; o++) {
        memory[o] = check_allocate((LARGE_FLOATS + LINE) * sizeof(float));
        aligned[o] = memory[o] + (0 - (uintptr_t)memory[o] / sizeof(float)) % LINE;
    }
    for (int i = 0; i < cases; i++) {
        test_large(i, aligned);
    }
    if (cases <= FLOWING_CASES && cases > 0) {
        test_large(FLOWING_CASES, aligned);
    }
    free(memory[0]);
    free(memory[1]);
}

static void expect(enum scarp_status wanted, const struct grid_case *c, const char *what)
{
    outputs_poison(&got);
    const struct scarp_samples out = outputs_subset(&got, c->wanted);
    const enum scarp_status status = grid_call(c->dimensions, &c->noise, &c->grid, &out);
    CHECK(status == wanted, "%dD, %s: %s", c->dimensions, what, scarp_status_text(status));
    if (wanted != SCARP_OK) {
        CHECK(outputs_untouched(&got, ~0u), "%dD, %s: written", c->dimensions, what);
    }
}

static struct grid_case plain_case(int dimensions)
{
    const struct grid_case c = {
        .grid = {.step = {0.1, 0.1, 0.1}, .count = {20, 3, 2}},
        .dimensions = dimensions,
        .wanted = 1,
    };
    return c;
}

/* Rows of simplex noise so long and so dense that no processor takes them as points */
static void test_dense_rows(void)
{
    for (int i = 0; i < 16; i++) {
        struct grid_case c = plain_case(2 + i % 2);
        c.noise.basis = SCARP_SIMPLEX;
        c.noise.seed = (uint64_t)i;
        c.order = i / 2 % 2;
        c.wanted = outputs_up_to(c.order, c.dimensions);
        for (int axis = 0; axis < 3; axis++) {
            c.grid.origin[axis] = 0.37 * i;
            c.grid.step[axis] = i < 8 ? 0.01 : 0.03;
        }
        c.grid.count[0] = 600;
        got.capacity = expected.capacity = floats_of(&c);
        test_points(&c);
    }
}

static void test_numbers(int dimensions)
{
    static const double bad[] = {(double)INFINITY, -(double)INFINITY, (double)NAN};
    for (int axis = 0; axis < 3; axis++) {
        const enum scarp_status ignored = axis < dimensions ? SCARP_ERROR_PARAMETER : SCARP_OK;
        for (int i = 0; i < 3; i++) {
            struct grid_case c = plain_case(dimensions);
            c.grid.origin[axis] = bad[i];
            expect(ignored, &c, "origin");
            c = plain_case(dimensions);
            c.grid.step[axis] = bad[i];
            expect(ignored, &c, "step");
        }
        const int64_t limit = INT64_C(1) << 53;
        struct grid_case c = plain_case(dimensions);
        c.grid.first[axis] = -limit;
        expect(SCARP_OK, &c, "lowest index");
        c.grid.first[axis] = limit + 1 - (int64_t)c.grid.count[axis];
        expect(SCARP_OK, &c, "highest index");
        c.grid.first[axis]++;
        expect(ignored, &c, "index too high");
        c.grid.first[axis] = -limit - 1;
        expect(ignored, &c, "index too low");
        c.grid.first[axis] = INT64_MAX;
        expect(ignored, &c, "highest integer");
    }
}

static void test_sizes(int dimensions)
{
    struct grid_case c = plain_case(dimensions);
    c.grid.row_stride = 19;
    expect(SCARP_ERROR_PARAMETER, &c, "row stride");
    c = plain_case(dimensions);
    c.grid.slice_stride = 59;
    expect(dimensions == 3 ? SCARP_ERROR_PARAMETER : SCARP_OK, &c, "slice stride");
    c.grid.slice_stride = 60;
    c.grid.row_stride = 20;
    expect(SCARP_OK, &c, "strides as packed");
    for (int axis = 0; axis < 3; axis++) {
        const int counts = axis < dimensions;
        c = plain_case(dimensions);
        c.grid.count[axis] = 0;
        c.grid.origin[0] = (double)NAN;
        expect(counts ? SCARP_OK : SCARP_ERROR_PARAMETER, &c, "nothing, not looked at");
        CHECK(!counts || outputs_untouched(&got, ~0u), "an empty grid was written");
        c = plain_case(dimensions);
        c.grid.count[axis] = SIZE_MAX / 8;
        expect(counts && sizeof(size_t) < 8 ? SCARP_ERROR_SIZE
               : counts                     ? SCARP_ERROR_PARAMETER
                                            : SCARP_OK,
               &c, "more samples than indices");
    }
    if (sizeof(size_t) == 8) {
        c = plain_case(dimensions);
        c.grid.count[0] = (size_t)1 << 40;
        c.grid.count[1] = (size_t)1 << 40;
        expect(SCARP_ERROR_SIZE, &c, "count product");
        c = plain_case(dimensions);
        c.grid.row_stride = SIZE_MAX;
        expect(SCARP_ERROR_SIZE, &c, "row stride beyond memory");
        c = plain_case(3);
        c.grid.slice_stride = SIZE_MAX / 2;
        expect(SCARP_ERROR_SIZE, &c, "slice stride beyond memory");
    }
}

static void test_refusals(int dimensions)
{
    struct grid_case c = plain_case(dimensions);
    const struct scarp_samples out = outputs_subset(&got, 1);
    outputs_poison(&got);
    CHECK(grid_call(c.dimensions, &c.noise, NULL, &out) == SCARP_ERROR_NULL, "grid NULL");
    CHECK(grid_call(c.dimensions, &c.noise, &c.grid, NULL) == SCARP_ERROR_NULL, "out NULL");
    CHECK(grid_call(dimensions, NULL, &c.grid, &out) == SCARP_ERROR_NULL, "noise NULL");
    c.noise.octaves = 33.0f;
    expect(SCARP_ERROR_PARAMETER, &c, "octaves");
    c = plain_case(dimensions);
    c.noise.fractal = (enum scarp_fractal)count_names(fractal_name);
    expect(SCARP_ERROR_ENUM, &c, "fractal");
    c = plain_case(dimensions);
    c.wanted = OUTPUTS_ALL3;
    expect(dimensions == 2 ? SCARP_ERROR_UNSUPPORTED : SCARP_OK, &c, "derivatives along z");
    c.wanted = OUTPUTS_ALL2;
    c.noise.fractal = SCARP_EROSION;
    expect(SCARP_ERROR_UNSUPPORTED, &c, "Hessian of erosion");
    c.noise.fractal = SCARP_FBM;
    c.noise.warp = &warps[1];
    expect(SCARP_ERROR_UNSUPPORTED, &c, "Hessian of noise with a warp that bends");
    test_numbers(dimensions);
    test_sizes(dimensions);
}

/* Grids with an axis so long that what is computed once for it comes in parts (kernel/crossing.h),
   or does not come at all. */
static void test_long(void)
{
    static const struct {
        int dimensions;
        size_t count[3];
    } shapes[] = {{2, {3, 4500, 1}}, {2, {9, 3000, 1}}, {2, {1750, 3, 1}},
                  {3, {2, 3, 2600}}, {3, {5, 700, 5}},  {3, {40, 1745, 1}}};
    for (int i = 0; i < (int)(sizeof shapes / sizeof shapes[0]) && !check_enough(); i++) {
        for (int basis = 0; basis < 2; basis++) {
            struct grid_case c = plain_case(shapes[i].dimensions);
            memcpy(c.grid.count, shapes[i].count, sizeof c.grid.count);
            c.noise.basis = basis == 0 ? SCARP_GRADIENT : SCARP_CELL_F1;
            c.noise.octaves = 2.0f;
            if (floats_of(&c) <= FLOATS_MAX) {
                got.capacity = expected.capacity = floats_of(&c);
                test_points(&c);
            }
        }
    }
}

int main(int argc, char **argv)
{
    argc = check_take_aim(argc, &argv);
    const int cases = argc > 2 ? atoi(argv[2]) : 2000;
    check_select_isa(argc > 1 ? argv[1] : "scalar");
    got = outputs_make(FLOATS_MAX);
    expected = outputs_make(FLOATS_MAX);
    for (int axis = 0; axis < 3; axis++) {
        coordinate[axis] = check_allocate(FLOATS_MAX * sizeof(double));
    }
    got.capacity = expected.capacity = 4096;
    test_refusals(2);
    test_refusals(3);
    uint64_t state = 20261121;
    for (int i = 0; i < cases && !check_enough(); i++) {
        struct grid_case c;
        random_case(&c, &state);
        if (floats_of(&c) <= FLOATS_MAX) {
            got.capacity = expected.capacity = floats_of(&c);
            test_points(&c);
            test_tiles(&c, &state);
        }
        test_on_planes(&state);
        if (i % 100 == 0) {
            test_short_rows(&state);
        }
    }
    if (cases > 0) {
        test_dense_rows();
        test_long();
    }
    test_all_large(check_enough() ? 0 : cases < 1000 ? LARGE_CASES_FEW : LARGE_CASES);
    got.capacity = expected.capacity = FLOATS_MAX;
    outputs_free(&got);
    outputs_free(&expected);
    for (int axis = 0; axis < 3; axis++) {
        free(coordinate[axis]);
    }
    return check_done();
}
