/* SPDX-License-Identifier: MIT
 *
 * The list of workloads. A row of the table is a product: every basis times every number of
 * dimensions times every size times every step times every output it names. A new fractal or layout
 * is a new row.
 */
#include "work.h"

#include <string.h>

#define COUNT_OF(array) (sizeof(array) / sizeof(array)[0])
#define STANDARD_STEP 0.01f

enum {
    GRADIENT = 1 << SCARP_GRADIENT,
    VALUE = 1 << SCARP_VALUE,
    BOTH_BASES = GRADIENT | VALUE,
    SIMPLEX = 1 << SCARP_SIMPLEX,
    CELL_F1 = 1 << SCARP_CELL_F1,
    CELLS = CELL_F1 | 1 << SCARP_CELL_F2 | 1 << SCARP_CELL_EDGE | 1 << SCARP_CELL_SOFT |
            1 << SCARP_CELL_VALUE,
    ALL_BASES = BOTH_BASES | SIMPLEX | CELLS,

    ONLY_VALUE = 1 << BENCH_VALUE,
    ONLY_GRADIENT = 1 << BENCH_PLUS_GRADIENT,
    UP_TO_GRADIENT = ONLY_VALUE | ONLY_GRADIENT,
    UP_TO_HESSIAN = UP_TO_GRADIENT | 1 << BENCH_PLUS_HESSIAN,
    ONLY_PHASE = 1 << BENCH_PLUS_PHASE,
    DIFFERENCES = 1 << BENCH_FORWARD_DIFFERENCES | 1 << BENCH_CENTRAL_DIFFERENCES
};

struct shape {
    size_t count[3]; /* samples along each axis */
};

struct product {
    struct bench_work work; /* what all have in common; 0 means the default */
    unsigned bases, outputs;
    const size_t *sizes[2]; /* in 2D and 3D: numbers of points, or of samples along an edge of a
                               grid. They end in 0; NULL: the standard */
    const float *steps;     /* of a grid; likewise */
    const struct shape *shapes[2]; /* of grids, in place of sizes; likewise */
};

static const size_t standard_sizes[] = {BENCH_STANDARD_POINTS, 0};
static const size_t standard_squares[] = {1024, 0}, standard_cubes[] = {64, 0};
static const float standard_steps[] = {STANDARD_STEP, 0};

static const size_t other_sizes[] = {1, 4, 16, 64, 256, 4096, 1048576, 0};
static const size_t squares[] = {256, 1024, 4096, 0}, huge_square[] = {16384, 0};
static const size_t cubes[] = {64, 256, 0}, large_cube[] = {256, 0};
static const size_t product_sizes[] = {4096, 1048576, 0}; /* a chunk, and far beyond the caches */
static const size_t recipe_squares[] = {512, 0}, tile[] = {256, 0}, chunk[] = {32, 0};
static const size_t recipe_points[] = {8192, 0}, recipe_few[] = {1, 4, 16, 64, 4096, 0};
static const float terrain_steps[] = {2, 0}, marble_steps[] = {0.005f, 0}, clouds_steps[] = {40, 0};
static const float unit_steps[] = {1, 0};
static const struct shape slab[] = {{{256, 16, 16}}, {{0, 0, 0}}};
static const struct shape chunks[] = {
    {{32, 32, 32}}, {{16, 16, 256}}, {{256, 16, 16}}, {{0, 0, 0}}};
/* Others, for recipes of one noise and for `density` */
static const struct shape recipe_shapes2[] = {{{65, 65, 1}}, {{1024, 1024, 1}}, {{0, 0, 0}}};
static const struct shape recipe_shapes3[] = {
    {{17, 17, 17}}, {{32, 32, 32}}, {{16, 256, 16}}, {{16, 16, 256}}, {{0, 0, 0}}};
static const struct shape density_shapes[] = {{{17, 17, 17}}, {{16, 256, 16}}, {{0, 0, 0}}};
/* Chunks of voxels, with and without a sample more on each side, and tiles of height maps. */
static const struct shape shapes2[] = {
    {{17, 17, 1}}, {{33, 33, 1}}, {{65, 65, 1}}, {{129, 129, 1}}, {{0, 0, 0}}};
static const struct shape shapes3[] = {
    {{16, 16, 16}}, {{17, 17, 17}}, {{18, 18, 18}},  {{34, 34, 34}},  {{31, 32, 32}},
    {{40, 32, 32}}, {{5, 33, 5}},   {{16, 256, 16}}, {{256, 16, 16}}, {{0, 0, 0}}};
static const float shape_steps[] = {0.05f, 0};
/* What a row of the table is of */
#define OF(which, asked) .bases = which, .outputs = asked
/* A noise as terrains have it */
#define TERRAIN(name, ...)                                                                         \
    {                                                                                              \
        .layout = BENCH_GRID, .title = name, .dimensions = 2, __VA_ARGS__                          \
    }
#define RECIPE_GRID(name, axes, distances, ...)                                                    \
    {                                                                                              \
        {.layout = BENCH_RECIPE_GRID, .title = name, .dimensions = axes},                          \
            OF(GRADIENT, UP_TO_GRADIENT), .steps = distances, __VA_ARGS__                          \
    }
#define SHAPES OF(ALL_BASES, UP_TO_GRADIENT), .steps = shape_steps, .shapes = {shapes2, shapes3}

static const float other_steps[] = {0.1f, 0.3f, 1.7f, 0};
static const float none_steps[] = {0.0025f, 0}, alps_steps[] = {0.0035f, 0};
static const float dunes_steps[] = {0.0022f, 0}, islands_steps[] = {0.0045f, 0};
static const float period_steps[] = {0x1p-7f, 0}; /* 1024 samples cross 8 cells */
static const float canyon_steps[] = {0.004f, 0}, quick_noise_steps[] = {0x1p-7f, 0};

static const struct product products[] = {
    {OF(BOTH_BASES, UP_TO_HESSIAN | DIFFERENCES)},
    {{.octaves = 8}, OF(GRADIENT, UP_TO_HESSIAN | DIFFERENCES)},
    {{.octaves = 8}, OF(VALUE, UP_TO_HESSIAN)},
    {{.octaves = 8, .turned = 1}, OF(GRADIENT, UP_TO_HESSIAN)},
    {{.fractal = SCARP_TURBULENCE, .octaves = 8}, OF(GRADIENT, UP_TO_HESSIAN)},
    {{.fractal = SCARP_RIDGED, .octaves = 8}, OF(GRADIENT, UP_TO_HESSIAN)},
    {{.fractal = SCARP_PINGPONG, .octaves = 8}, OF(GRADIENT, UP_TO_GRADIENT)},
    {{.fractal = SCARP_HYBRID, .octaves = 8}, OF(GRADIENT, UP_TO_GRADIENT)},
    {{.fractal = SCARP_EROSION, .octaves = 8}, OF(GRADIENT, UP_TO_GRADIENT | DIFFERENCES)},
    /* Terrain is made like this: heights and slopes from one call. */
    {{.fractal = SCARP_EROSION, .octaves = 8, .turned = 1, .dimensions = 2},
     OF(BOTH_BASES, ONLY_GRADIENT)},
    {{.fade = SCARP_CUBIC}, OF(BOTH_BASES, UP_TO_GRADIENT)},
    {{.f64 = 1}, OF(GRADIENT, UP_TO_HESSIAN)},
    {{.f64 = 1, .octaves = 8}, OF(GRADIENT, UP_TO_GRADIENT)},
    {{.pattern = BENCH_SEQUENTIAL}, OF(GRADIENT, UP_TO_GRADIENT)},
    {{.pattern = BENCH_SAME_CELL}, OF(GRADIENT, UP_TO_GRADIENT)},
    {OF(GRADIENT, UP_TO_GRADIENT), .sizes = {other_sizes, other_sizes}},
    {{.layout = BENCH_GRID}, OF(GRADIENT, UP_TO_GRADIENT), .sizes = {squares, cubes}},
    {{.layout = BENCH_GRID},
     OF(GRADIENT, ONLY_VALUE),
     .sizes = {NULL, large_cube},
     .steps = other_steps},
    {{.layout = BENCH_GRID}, OF(VALUE, UP_TO_GRADIENT)},
    {{.layout = BENCH_GRID, .octaves = 8}, OF(GRADIENT, UP_TO_GRADIENT), .sizes = {NULL, cubes}},
    {{.layout = BENCH_GRID, .octaves = 8, .turned = 1}, OF(GRADIENT, UP_TO_GRADIENT)},
    {{.layout = BENCH_GRID, .fractal = SCARP_RIDGED, .octaves = 8, .dimensions = 2},
     OF(GRADIENT, UP_TO_GRADIENT)},
    {{.layout = BENCH_GRID, .fractal = SCARP_EROSION, .octaves = 8, .dimensions = 2},
     OF(GRADIENT, UP_TO_GRADIENT)},
    /* A power of two, and no power of two. */
    {{.period = 256}, OF(GRADIENT, ONLY_VALUE)},
    {{.period = 200}, OF(GRADIENT, ONLY_VALUE)},
    {{.period = 200, .f64 = 1}, OF(GRADIENT, ONLY_VALUE)},
    {{.layout = BENCH_GRID, .dimensions = 2}, OF(GRADIENT, UP_TO_GRADIENT), .steps = period_steps},
    {{.layout = BENCH_GRID, .period = 8, .dimensions = 2},
     OF(GRADIENT, UP_TO_GRADIENT),
     .steps = period_steps},
    {{.layout = BENCH_GRID, .octaves = 8, .period = 8, .dimensions = 2},
     OF(GRADIENT, UP_TO_GRADIENT),
     .steps = period_steps},
    {{.phase = 0.3f}, OF(GRADIENT, UP_TO_GRADIENT | ONLY_PHASE)},
    {{.layout = BENCH_GRID, .phase = 0.3f}, OF(GRADIENT, UP_TO_GRADIENT)},
    {{.layout = BENCH_GRID, .phase = 0.3f, .octaves = 8},
     OF(GRADIENT, UP_TO_GRADIENT | ONLY_PHASE)},
    {{.warp = BENCH_WARP_GRADIENT}, OF(GRADIENT, UP_TO_HESSIAN)},
    {{.warp = BENCH_WARP_VALUE}, OF(GRADIENT, UP_TO_GRADIENT)},
    {{.layout = BENCH_GRID, .warp = BENCH_WARP_GRADIENT}, OF(GRADIENT, UP_TO_GRADIENT)},
    {{.layout = BENCH_GRID, .warp = BENCH_WARP_VALUE}, OF(GRADIENT, ONLY_VALUE)},
    {{.fractal = SCARP_SWISS, .octaves = 8}, OF(GRADIENT, UP_TO_GRADIENT)},
    {{.fractal = SCARP_JORDAN, .octaves = 8}, OF(GRADIENT, UP_TO_GRADIENT)},
    {OF(SIMPLEX, UP_TO_HESSIAN)},
    {OF(CELLS, UP_TO_GRADIENT)},
    {{.octaves = 8}, OF(SIMPLEX | CELL_F1, UP_TO_GRADIENT)},
    {{.layout = BENCH_GRID}, OF(SIMPLEX | CELLS, UP_TO_GRADIENT)},
    {{.layout = BENCH_GRID, .octaves = 8}, OF(SIMPLEX | CELL_F1, UP_TO_GRADIENT)},
    /* 1 GB is far beyond all caches. */
    {{.layout = BENCH_GRID, .dimensions = 2, .request = BENCH_BY_NAME},
     OF(GRADIENT, ONLY_VALUE),
     .sizes = {huge_square, NULL}},
    /* Grids of the shapes that programs have, and the same samples as points. */
    {{.layout = BENCH_GRID, .request = BENCH_BY_WORK}, SHAPES},
    {{.layout = BENCH_GRID, .octaves = 4, .request = BENCH_BY_WORK}, SHAPES},
    {{.layout = BENCH_GRID, .octaves = 4, .turned = 1, .request = BENCH_BY_WORK}, SHAPES},
    {{.layout = BENCH_GRID, .as_points = 1, .request = BENCH_BY_WORK}, SHAPES},
    {{.layout = BENCH_GRID, .octaves = 4, .as_points = 1, .request = BENCH_BY_WORK}, SHAPES},
    {{.layout = BENCH_GRID, .octaves = 4, .turned = 1, .as_points = 1, .request = BENCH_BY_WORK},
     SHAPES},
    {{.layout = BENCH_NORMALS, .dimensions = 2}, OF(GRADIENT, ONLY_VALUE)},
    {{.layout = BENCH_PRODUCT},
     OF(GRADIENT, ONLY_GRADIENT),
     .sizes = {product_sizes, product_sizes}},
    {{.layout = BENCH_VECTOR}, OF(BOTH_BASES | SIMPLEX, ONLY_VALUE)},
    {{.layout = BENCH_CURL}, OF(BOTH_BASES | SIMPLEX, ONLY_VALUE)},
    {{.layout = BENCH_GULLIES, .octaves = 1, .dimensions = 2},
     OF(GRADIENT, UP_TO_GRADIENT),
     .sizes = {product_sizes, NULL}},
    {{.layout = BENCH_GULLIES, .octaves = 5, .dimensions = 2},
     OF(GRADIENT, UP_TO_GRADIENT),
     .sizes = {product_sizes, NULL}},
    {{.layout = BENCH_GULLIES, .octaves = 5, .turned = 1, .f64 = 1, .dimensions = 2},
     OF(GRADIENT, UP_TO_GRADIENT),
     .sizes = {product_sizes, NULL}},
    /* Recipes, next to the same calls by hand. */
    RECIPE_GRID("fade", 2, terrain_steps, .sizes = {recipe_squares}),
    RECIPE_GRID("alps", 2, terrain_steps, .sizes = {recipe_squares}),
    RECIPE_GRID("overworld", 2, terrain_steps, .sizes = {recipe_squares}),
    RECIPE_GRID("marble", 2, marble_steps, .sizes = {recipe_squares}),
    RECIPE_GRID("clouds", 3, clouds_steps, .sizes = {NULL, standard_cubes}),
    RECIPE_GRID("density", 3, unit_steps, .shapes = {NULL, chunks}),
    /* One noise, and times and plus numbers */
    RECIPE_GRID("noise1", 2, unit_steps, .sizes = {tile}),
    RECIPE_GRID("noise4", 2, unit_steps, .sizes = {standard_squares}),
    RECIPE_GRID("noise1", 3, unit_steps, .shapes = {NULL, slab}),
    RECIPE_GRID("warped", 3, unit_steps, .sizes = {NULL, chunk}),
    RECIPE_GRID("scaled-noise1", 2, unit_steps, .sizes = {tile}),
    RECIPE_GRID("scaled-noise4", 2, unit_steps, .sizes = {standard_squares}),
    RECIPE_GRID("scaled-noise1", 3, unit_steps, .shapes = {NULL, slab}),
    RECIPE_GRID("scaled-warped", 3, unit_steps, .sizes = {NULL, chunk}),
    /* The presets of the program */
    RECIPE_GRID("terrain-alps", 2, terrain_steps, .sizes = {recipe_squares}),
    RECIPE_GRID("terrain-range", 2, terrain_steps, .sizes = {recipe_squares}),
    RECIPE_GRID("terrain-hills", 2, terrain_steps, .sizes = {recipe_squares}),
    RECIPE_GRID("terrain-badlands", 2, terrain_steps, .sizes = {recipe_squares}),
    RECIPE_GRID("terrain-canyon", 2, terrain_steps, .sizes = {recipe_squares}),
    RECIPE_GRID("terrain-mesas", 2, terrain_steps, .sizes = {recipe_squares}),
    RECIPE_GRID("terrain-dunes", 2, terrain_steps, .sizes = {recipe_squares}),
    RECIPE_GRID("terrain-volcanic", 2, terrain_steps, .sizes = {recipe_squares}),
    RECIPE_GRID("terrain-islands", 2, terrain_steps, .sizes = {recipe_squares}),
    {{.layout = BENCH_RECIPE_GRID, .title = "noise1", .request = BENCH_BY_WORK},
     OF(GRADIENT, UP_TO_GRADIENT),
     .steps = unit_steps,
     .shapes = {recipe_shapes2, recipe_shapes3}},
    {{.layout = BENCH_RECIPE_GRID, .title = "density", .dimensions = 3, .request = BENCH_BY_WORK},
     OF(GRADIENT, UP_TO_GRADIENT),
     .steps = unit_steps,
     .shapes = {NULL, density_shapes}},
    {{.layout = BENCH_RECIPE, .title = "fade", .dimensions = 2},
     OF(GRADIENT, ONLY_VALUE),
     .sizes = {recipe_points, NULL}},
    {{.layout = BENCH_RECIPE, .title = "alps", .dimensions = 2, .f64 = 1},
     OF(GRADIENT, UP_TO_GRADIENT),
     .sizes = {recipe_few, NULL}},
    {{.layout = BENCH_RECIPE, .title = "density", .dimensions = 3, .f64 = 1},
     OF(GRADIENT, ONLY_VALUE),
     .sizes = {NULL, recipe_few}},
    /* One noise, as terrains have it: only heights, or with what lights them. */
    {TERRAIN("terrain-fbm", .octaves = 9, .gain = 0.4f), OF(GRADIENT, UP_TO_GRADIENT),
     .steps = none_steps},
    {TERRAIN("terrain-ridged", .fractal = SCARP_RIDGED, .octaves = 7, .gain = 0.42f, .turned = 1),
     OF(GRADIENT, UP_TO_GRADIENT), .steps = alps_steps},
    {TERRAIN("terrain-waves", .fractal = SCARP_RIDGED, .octaves = 2, .lacunarity = 3.5f,
             .gain = 8.0f, .turned = 1),
     OF(GRADIENT, UP_TO_GRADIENT), .steps = dunes_steps},
    {TERRAIN("terrain-erosion", .fractal = SCARP_EROSION, .octaves = 8, .gain = 0.46f,
             .erosion = 0.25f, .turned = 1),
     OF(GRADIENT, UP_TO_GRADIENT), .steps = islands_steps},
    {TERRAIN("terrain-turbulence", .fractal = SCARP_TURBULENCE, .octaves = 8, .gain = 0.36f,
             .turned = 1),
     OF(GRADIENT, UP_TO_GRADIENT), .steps = canyon_steps},
    {TERRAIN("terrain-soft", .fractal = SCARP_EROSION, .octaves = 8, .gain = 0.44f, .erosion = 0.3f,
             .turned = 1),
     OF(1 << SCARP_CELL_SOFT, UP_TO_GRADIENT), .steps = canyon_steps},
    {TERRAIN("terrain-cells", .octaves = 8, .gain = 0.36f, .amplitude = -1.0f, .turned = 1),
     OF(CELL_F1, UP_TO_GRADIENT), .steps = islands_steps},
    {TERRAIN("terrain-swiss", .fractal = SCARP_SWISS, .octaves = 8, .gain = 0.45f, .turned = 1),
     OF(GRADIENT, UP_TO_GRADIENT), .steps = islands_steps},
    /* quick-noise 0.3.0 (Rust) states 0.82 ms for it, 0.78 ns per sample; the frequency is that of
       its examples. */
    {TERRAIN("quick-noise", .octaves = 3), OF(GRADIENT, ONLY_VALUE), .steps = quick_noise_steps},
};

static int is_grid(const struct bench_work *work)
{
    return work->layout == BENCH_GRID || work->layout == BENCH_RECIPE_GRID;
}

/* Completes a workload that has its size. */
static void complete(struct bench_work *work)
{
    /* The origin is off the lattice planes. Grids that begin on one have samples that miss others
       by rounding alone; where it is by less than 1e-12, fades are denormal numbers, which slow
       many processors down. */
    static const float origin[3] = {3.3371f, 4.437f, 5.533f};
    work->octaves = work->octaves != 0 ? work->octaves : 1;
    work->lacunarity = work->lacunarity != 0.0f ? work->lacunarity : 2.0f;
    work->gain = work->gain != 0.0f ? work->gain : 0.5f;
    work->erosion = work->erosion != 0.0f ? work->erosion : 1.0f;
    if (is_grid(work)) {
        memcpy(work->origin, origin, sizeof work->origin);
        work->points = work->grid[0] * work->grid[1] * work->grid[2];
    }
    bench_work_write_name(work);
}

static const size_t *sizes_of(const struct product *product, int dimensions)
{
    const size_t *const sizes = product->sizes[dimensions - 2];
    if (sizes != NULL) {
        return sizes;
    }
    if (is_grid(&product->work)) {
        return dimensions == 2 ? standard_squares : standard_cubes;
    }
    return standard_sizes;
}

/* Gives the workload size number n of its product. Returns 0 where there are no more. */
static int set_size(const struct product *product, size_t n, struct bench_work *work)
{
    const struct shape *const shapes = product->shapes[work->dimensions - 2];
    if (shapes != NULL) {
        memcpy(work->grid, shapes[n].count, sizeof work->grid);
        return work->grid[0] != 0;
    }
    work->points = sizes_of(product, work->dimensions)[n];
    for (int d = 0; d < 3; d++) {
        work->grid[d] = d < work->dimensions ? work->points : 1;
    }
    return work->points != 0;
}

/* Like get_from_product, but keeps the basis and the dimensions that `work` has. */
static int get_from_sizes(const struct product *product, size_t *index, struct bench_work *work)
{
    const float *const steps = product->steps != NULL ? product->steps : standard_steps;
    for (size_t n = 0; set_size(product, n, work); n++) {
        for (const float *step = steps; *step > 0; step++) {
            for (unsigned output = 0; output < BENCH_OUTPUTS; output++) {
                if (!(product->outputs >> output & 1) || (*index)-- > 0) {
                    continue;
                }
                work->step = *step;
                work->output = (enum bench_output)output;
                complete(work);
                return 1;
            }
        }
    }
    return 0;
}

/* Like bench_work_get, among the workloads of one product. *index counts down past those that were
   skipped. Innermost come the outputs, then steps, sizes, dimensions and bases. */
static int get_from_product(const struct product *product, size_t *index, struct bench_work *work)
{
    const int fixed = product->work.dimensions;
    *work = product->work;
    for (enum scarp_basis basis = 0; scarp_basis_name(basis) != NULL; basis++) {
        for (int d = 2; d <= 3; d++) {
            if (!(product->bases >> basis & 1) || (fixed != 0 && fixed != d)) {
                continue;
            }
            work->basis = basis;
            work->dimensions = d;
            if (get_from_sizes(product, index, work)) {
                return 1;
            }
        }
    }
    return 0;
}

int bench_work_get(size_t index, struct bench_work *work)
{
    for (size_t i = 0; i < COUNT_OF(products); i++) {
        if (get_from_product(&products[i], &index, work)) {
            return 1;
        }
    }
    return 0;
}

struct scarp_noise bench_work_noise(const struct bench_work *work)
{
    static const struct scarp_noise warps[] = {
        [BENCH_WARP_GRADIENT] = {.seed = 11, .amplitude = BENCH_WARP_REACH},
        [BENCH_WARP_VALUE] = {.basis = SCARP_VALUE,
                              .fade = SCARP_CUBIC,
                              .seed = 11,
                              .amplitude = BENCH_WARP_REACH},
    };
    return (struct scarp_noise){.basis = work->basis,
                                .fade = work->fade,
                                .fractal = work->fractal,
                                .rotate = work->turned != 0,
                                .phase = work->phase,
                                .period = {work->period, work->period, work->period},
                                .seed = 7,
                                .octaves = (float)work->octaves,
                                .lacunarity = work->lacunarity,
                                .gain = work->gain,
                                .amplitude = work->amplitude,
                                .erosion = work->erosion,
                                .warp = work->warp != 0 ? &warps[work->warp] : NULL};
}
