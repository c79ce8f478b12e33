/* SPDX-License-Identifier: MIT
 *
 * The list of workloads. A row of the table is a product: every basis times every number of
 * dimensions times every size times every step times every output it names. Names are made from the
 * same fields that the measurement reads, so they cannot disagree. A new fractal or layout is a new
 * row.
 */
#include "work.h"

#include <stdio.h>
#include <string.h>

#define COUNT_OF(array) (sizeof(array) / sizeof(array)[0])
#define STANDARD_POINTS 65536
#define STANDARD_STEP 0.01f

enum {
    GRADIENT = 1 << SCARP_GRADIENT,
    VALUE = 1 << SCARP_VALUE,
    BOTH_BASES = GRADIENT | VALUE,
    SIMPLEX = 1 << SCARP_SIMPLEX,
    CELL_F1 = 1 << SCARP_CELL_F1,
    CELLS = CELL_F1 | 1 << SCARP_CELL_F2 | 1 << SCARP_CELL_EDGE | 1 << SCARP_CELL_SOFT |
            1 << SCARP_CELL_VALUE,

    ONLY_VALUE = 1 << BENCH_VALUE,
    ONLY_GRADIENT = 1 << BENCH_PLUS_GRADIENT,
    UP_TO_GRADIENT = ONLY_VALUE | ONLY_GRADIENT,
    UP_TO_HESSIAN = UP_TO_GRADIENT | 1 << BENCH_PLUS_HESSIAN,
    ONLY_PHASE = 1 << BENCH_PLUS_PHASE,
    DIFFERENCES = 1 << BENCH_FORWARD_DIFFERENCES | 1 << BENCH_CENTRAL_DIFFERENCES
};

struct product {
    struct bench_work work; /* what all have in common; 0 means the default */
    unsigned bases, outputs;
    const size_t *sizes[2]; /* in 2D and 3D: numbers of points, or of samples along an edge of a
                               grid. They end in 0; NULL: the standard */
    const float *steps;     /* of a grid; likewise */
};

static const size_t standard_sizes[] = {STANDARD_POINTS, 0};
static const size_t standard_squares[] = {1024, 0}, standard_cubes[] = {64, 0};
static const float standard_steps[] = {STANDARD_STEP, 0};

static const size_t other_sizes[] = {1, 4, 16, 64, 256, 4096, 1048576, 0};
static const size_t squares[] = {256, 1024, 4096, 0}, huge_square[] = {16384, 0};
static const size_t cubes[] = {64, 256, 0}, large_cube[] = {256, 0};
static const size_t product_sizes[] = {4096, 1048576, 0}; /* a chunk, and far beyond the caches */
static const float other_steps[] = {0.1f, 0.3f, 1.7f, 0};
static const float none_steps[] = {0.0025f, 0}, alps_steps[] = {0.0035f, 0};
static const float dunes_steps[] = {0.0022f, 0}, islands_steps[] = {0.0045f, 0};
static const float period_steps[] = {0x1p-7f, 0}; /* 1024 samples cross 8 cells */
static const float canyon_steps[] = {0.004f, 0}, quick_noise_steps[] = {0x1p-7f, 0};

static const struct product products[] = {
    {.bases = BOTH_BASES, .outputs = UP_TO_HESSIAN | DIFFERENCES},
    {{.octaves = 8}, .bases = GRADIENT, .outputs = UP_TO_HESSIAN | DIFFERENCES},
    {{.octaves = 8}, .bases = VALUE, .outputs = UP_TO_HESSIAN},
    {{.octaves = 8, .turned = 1}, .bases = GRADIENT, .outputs = UP_TO_HESSIAN},
    {{.fractal = SCARP_TURBULENCE, .octaves = 8}, .bases = GRADIENT, .outputs = UP_TO_HESSIAN},
    {{.fractal = SCARP_RIDGED, .octaves = 8}, .bases = GRADIENT, .outputs = UP_TO_HESSIAN},
    {{.fractal = SCARP_PINGPONG, .octaves = 8}, .bases = GRADIENT, .outputs = UP_TO_GRADIENT},
    {{.fractal = SCARP_HYBRID, .octaves = 8}, .bases = GRADIENT, .outputs = UP_TO_GRADIENT},
    {{.fractal = SCARP_EROSION, .octaves = 8},
     .bases = GRADIENT,
     .outputs = UP_TO_GRADIENT | DIFFERENCES},
    /* Terrain is made like this: heights and slopes from one call. */
    {{.fractal = SCARP_EROSION, .octaves = 8, .turned = 1, .dimensions = 2},
     .bases = BOTH_BASES,
     .outputs = ONLY_GRADIENT},
    {{.fade = SCARP_CUBIC}, .bases = BOTH_BASES, .outputs = UP_TO_GRADIENT},
    {{.f64 = 1}, .bases = GRADIENT, .outputs = UP_TO_HESSIAN},
    {{.f64 = 1, .octaves = 8}, .bases = GRADIENT, .outputs = UP_TO_GRADIENT},
    {{.pattern = BENCH_SEQUENTIAL}, .bases = GRADIENT, .outputs = UP_TO_GRADIENT},
    {{.pattern = BENCH_SAME_CELL}, .bases = GRADIENT, .outputs = UP_TO_GRADIENT},
    {.bases = GRADIENT, .outputs = UP_TO_GRADIENT, .sizes = {other_sizes, other_sizes}},
    {{.layout = BENCH_GRID},
     .bases = GRADIENT,
     .outputs = UP_TO_GRADIENT,
     .sizes = {squares, cubes}},
    {{.layout = BENCH_GRID},
     .bases = GRADIENT,
     .outputs = ONLY_VALUE,
     .sizes = {NULL, large_cube},
     .steps = other_steps},
    {{.layout = BENCH_GRID}, .bases = VALUE, .outputs = UP_TO_GRADIENT},
    {{.layout = BENCH_GRID, .octaves = 8},
     .bases = GRADIENT,
     .outputs = UP_TO_GRADIENT,
     .sizes = {NULL, cubes}},
    {{.layout = BENCH_GRID, .octaves = 8, .turned = 1},
     .bases = GRADIENT,
     .outputs = UP_TO_GRADIENT},
    {{.layout = BENCH_GRID, .fractal = SCARP_RIDGED, .octaves = 8, .dimensions = 2},
     .bases = GRADIENT,
     .outputs = UP_TO_GRADIENT},
    {{.layout = BENCH_GRID, .fractal = SCARP_EROSION, .octaves = 8, .dimensions = 2},
     .bases = GRADIENT,
     .outputs = UP_TO_GRADIENT},
    /* A power of two, and no power of two. */
    {{.period = 256}, .bases = GRADIENT, .outputs = ONLY_VALUE},
    {{.period = 200}, .bases = GRADIENT, .outputs = ONLY_VALUE},
    {{.period = 200, .f64 = 1}, .bases = GRADIENT, .outputs = ONLY_VALUE},
    {{.layout = BENCH_GRID, .dimensions = 2},
     .bases = GRADIENT,
     .outputs = UP_TO_GRADIENT,
     .steps = period_steps},
    {{.layout = BENCH_GRID, .period = 8, .dimensions = 2},
     .bases = GRADIENT,
     .outputs = UP_TO_GRADIENT,
     .steps = period_steps},
    {{.layout = BENCH_GRID, .octaves = 8, .period = 8, .dimensions = 2},
     .bases = GRADIENT,
     .outputs = UP_TO_GRADIENT,
     .steps = period_steps},
    {{.phase = 0.3f}, .bases = GRADIENT, .outputs = UP_TO_GRADIENT | ONLY_PHASE},
    {{.layout = BENCH_GRID, .phase = 0.3f}, .bases = GRADIENT, .outputs = UP_TO_GRADIENT},
    {{.layout = BENCH_GRID, .phase = 0.3f, .octaves = 8},
     .bases = GRADIENT,
     .outputs = UP_TO_GRADIENT | ONLY_PHASE},
    {{.warp = BENCH_WARP_GRADIENT}, .bases = GRADIENT, .outputs = UP_TO_HESSIAN},
    {{.warp = BENCH_WARP_VALUE}, .bases = GRADIENT, .outputs = UP_TO_GRADIENT},
    {{.layout = BENCH_GRID, .warp = BENCH_WARP_GRADIENT},
     .bases = GRADIENT,
     .outputs = UP_TO_GRADIENT},
    {{.layout = BENCH_GRID, .warp = BENCH_WARP_VALUE}, .bases = GRADIENT, .outputs = ONLY_VALUE},
    {{.fractal = SCARP_SWISS, .octaves = 8}, .bases = GRADIENT, .outputs = UP_TO_GRADIENT},
    {{.fractal = SCARP_JORDAN, .octaves = 8}, .bases = GRADIENT, .outputs = UP_TO_GRADIENT},
    {.bases = SIMPLEX, .outputs = UP_TO_HESSIAN},
    {.bases = CELLS, .outputs = UP_TO_GRADIENT},
    {{.octaves = 8}, .bases = SIMPLEX | CELL_F1, .outputs = UP_TO_GRADIENT},
    {{.layout = BENCH_GRID}, .bases = SIMPLEX | CELLS, .outputs = UP_TO_GRADIENT},
    {{.layout = BENCH_GRID, .octaves = 8}, .bases = SIMPLEX | CELL_F1, .outputs = UP_TO_GRADIENT},
    /* 1 GB is far beyond all caches. */
    {{.layout = BENCH_GRID, .dimensions = 2, .on_request = 1},
     .bases = GRADIENT,
     .outputs = ONLY_VALUE,
     .sizes = {huge_square, NULL}},
    {{.layout = BENCH_NORMALS, .dimensions = 2}, .bases = GRADIENT, .outputs = ONLY_VALUE},
    {{.layout = BENCH_PRODUCT},
     .bases = GRADIENT,
     .outputs = ONLY_GRADIENT,
     .sizes = {product_sizes, product_sizes}},
    {{.layout = BENCH_VECTOR}, .bases = BOTH_BASES | SIMPLEX, .outputs = ONLY_VALUE},
    {{.layout = BENCH_CURL}, .bases = BOTH_BASES | SIMPLEX, .outputs = ONLY_VALUE},
    /* What `scarp terrain` samples: heights alone, or with what lights them. Those of presets,
       which are one noise, tests/test_bench_presets.c holds to the program's. */
    {{.layout = BENCH_GRID, .title = "preset-none", .octaves = 9, .gain = 0.4f, .dimensions = 2},
     .bases = GRADIENT,
     .outputs = UP_TO_GRADIENT,
     .steps = none_steps},
    {{.layout = BENCH_GRID,
      .title = "terrain-ridged",
      .fractal = SCARP_RIDGED,
      .octaves = 7,
      .gain = 0.42f,
      .turned = 1,
      .dimensions = 2},
     .bases = GRADIENT,
     .outputs = UP_TO_GRADIENT,
     .steps = alps_steps},
    {{.layout = BENCH_GRID,
      .title = "terrain-waves",
      .fractal = SCARP_RIDGED,
      .octaves = 2,
      .lacunarity = 3.5f,
      .gain = 8.0f,
      .turned = 1,
      .dimensions = 2},
     .bases = GRADIENT,
     .outputs = UP_TO_GRADIENT,
     .steps = dunes_steps},
    {{.layout = BENCH_GRID,
      .title = "preset-islands",
      .fractal = SCARP_EROSION,
      .octaves = 8,
      .gain = 0.46f,
      .erosion = 0.25f,
      .turned = 1,
      .dimensions = 2},
     .bases = GRADIENT,
     .outputs = UP_TO_GRADIENT,
     .steps = islands_steps},
    {{.layout = BENCH_GRID,
      .title = "terrain-turbulence",
      .fractal = SCARP_TURBULENCE,
      .octaves = 8,
      .gain = 0.36f,
      .turned = 1,
      .dimensions = 2},
     .bases = GRADIENT,
     .outputs = UP_TO_GRADIENT,
     .steps = canyon_steps},
    {{.layout = BENCH_GRID,
      .title = "preset-cirques",
      .fractal = SCARP_EROSION,
      .octaves = 8,
      .gain = 0.44f,
      .erosion = 0.3f,
      .turned = 1,
      .dimensions = 2},
     .bases = 1 << SCARP_CELL_SOFT,
     .outputs = UP_TO_GRADIENT,
     .steps = canyon_steps},
    {{.layout = BENCH_GRID,
      .title = "preset-karst",
      .octaves = 8,
      .gain = 0.36f,
      .amplitude = -1.0f,
      .turned = 1,
      .dimensions = 2},
     .bases = CELL_F1,
     .outputs = UP_TO_GRADIENT,
     .steps = islands_steps},
    {{.layout = BENCH_GRID,
      .title = "terrain-swiss",
      .fractal = SCARP_SWISS,
      .octaves = 8,
      .gain = 0.45f,
      .turned = 1,
      .dimensions = 2},
     .bases = GRADIENT,
     .outputs = UP_TO_GRADIENT,
     .steps = islands_steps},
    /* quick-noise 0.3.0 (Rust) tells 0.82 ms for it, 0.78 ns per sample; the frequency is that of
       its examples. */
    {{.layout = BENCH_GRID, .title = "quick-noise", .octaves = 3, .dimensions = 2},
     .bases = GRADIENT,
     .outputs = ONLY_VALUE,
     .steps = quick_noise_steps},
};

static const char *const layout_names[] = {"points",  "grid",   "normals",
                                           "product", "vector", "curl"};
static const char *const pattern_names[] = {"", "/sequential", "/same-cell"};
static const char *const warp_names[] = {"", "/warped", "/warped-by-value"};
static const char *const output_names[] = {"value",   "+gradient",           "+hessian",
                                           "+dphase", "forward-differences", "central-differences"};

static void write_name(struct bench_work *work)
{
    if (work->layout == BENCH_NORMALS) {
        snprintf(work->name, sizeof work->name, "%s", layout_names[work->layout]);
        return;
    }
    if (work->layout == BENCH_PRODUCT) {
        snprintf(work->name, sizeof work->name, "%s%d/%s/n=%zu", layout_names[work->layout],
                 work->dimensions, output_names[work->output], work->points);
        return;
    }
    char fade[16] = "", fractal[32] = "", title[32] = "", size[32] = "", period[24] = "";
    if (work->fade != SCARP_QUINTIC) {
        snprintf(fade, sizeof fade, "/%s", scarp_fade_name(work->fade));
    }
    if (work->octaves > 1) {
        snprintf(fractal, sizeof fractal, "/%s%d", scarp_fractal_name(work->fractal),
                 work->octaves);
    }
    if (work->title != NULL) {
        snprintf(title, sizeof title, "/%s", work->title);
    }
    if (work->layout == BENCH_GRID) {
        snprintf(size, sizeof size, "/%zu/step%g", work->grid[0], (double)work->step);
    } else if (work->points != STANDARD_POINTS) {
        snprintf(size, sizeof size, "/n=%zu", work->points);
    }
    if (work->period != 0) {
        snprintf(period, sizeof period, "/period%u", work->period);
    }
    snprintf(work->name, sizeof work->name, "%s%d/%s%s%s%s%s%s%s%s%s%s/%s%s",
             layout_names[work->layout], work->dimensions, scarp_basis_name(work->basis), fade,
             fractal, work->turned ? "/turned" : "", period, work->phase != 0.0f ? "/flow" : "",
             warp_names[work->warp], title, work->f64 ? "/f64" : "", pattern_names[work->pattern],
             output_names[work->output], size);
}

/* Completes the workload; `size` is one of those in struct product. */
static void complete(struct bench_work *work, size_t size)
{
    /* The origin is off the lattice planes. Grids that begin on one have samples that miss others
       by rounding alone; where it is by less than 1e-12, fades are denormal numbers, which slow
       many processors down. */
    static const float origin[3] = {3.3371f, 4.437f, 5.533f};
    work->octaves = work->octaves != 0 ? work->octaves : 1;
    work->lacunarity = work->lacunarity != 0.0f ? work->lacunarity : 2.0f;
    work->gain = work->gain != 0.0f ? work->gain : 0.5f;
    work->erosion = work->erosion != 0.0f ? work->erosion : 1.0f;
    work->points = size;
    if (work->layout == BENCH_GRID) {
        for (int d = 0; d < 3; d++) {
            work->origin[d] = origin[d];
            work->grid[d] = d < work->dimensions ? size : 1;
        }
        work->points = size * size * work->grid[2];
    }
    write_name(work);
}

static const size_t *sizes_of(const struct product *product, int dimensions)
{
    const size_t *const sizes = product->sizes[dimensions - 2];
    if (sizes != NULL) {
        return sizes;
    }
    if (product->work.layout == BENCH_GRID) {
        return dimensions == 2 ? standard_squares : standard_cubes;
    }
    return standard_sizes;
}

/* Like get_from_product, but keeps the basis and the dimensions that `work` has. */
static int get_from_sizes(const struct product *product, size_t *index, struct bench_work *work)
{
    const float *const steps = product->steps != NULL ? product->steps : standard_steps;
    for (const size_t *size = sizes_of(product, work->dimensions); *size != 0; size++) {
        for (const float *step = steps; *step > 0; step++) {
            for (unsigned output = 0; output < COUNT_OF(output_names); output++) {
                if (!(product->outputs >> output & 1) || (*index)-- > 0) {
                    continue;
                }
                work->step = *step;
                work->output = (enum bench_output)output;
                complete(work, *size);
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

static int glob(const char *pattern, const char *text)
{
    for (; *pattern != '\0' && *pattern != '*'; pattern++, text++) {
        if (*text == '\0' || (*pattern != '?' && *pattern != *text)) {
            return 0;
        }
    }
    if (*pattern == '\0') {
        return *text == '\0';
    }
    while (!glob(pattern + 1, text)) {
        if (*text++ == '\0') {
            return 0;
        }
    }
    return 1;
}

static int is_name(const char *pattern)
{
    struct bench_work work;
    for (size_t i = 0; bench_work_get(i, &work); i++) {
        if (strcmp(pattern, work.name) == 0) {
            return 1;
        }
    }
    return 0;
}

int bench_work_matches(const char *pattern, const char *name)
{
    if (strpbrk(pattern, "*?") != NULL) {
        return glob(pattern, name);
    }
    return is_name(pattern) ? strcmp(pattern, name) == 0 : strstr(name, pattern) != NULL;
}
