/* SPDX-License-Identifier: MIT
 *
 * The recipes by hand: their noises, and the calls that make the result of them. Registers are
 * arrays of the points at hand.
 */
#include "hand.h"

#include <string.h>

#define COUNT_OF(array) ((int)(sizeof(array) / sizeof(array)[0]))
#define NOISES(array) .noises = array, .noise_count = COUNT_OF(array)

static void sample(struct hand *h, int noise, int to)
{
    const struct scarp_noise *const n = &h->noise[noise];
    const struct scarp_samples *const out = &h->at[to];
    const void *const *const x = h->x;
    if (h->grid != NULL) {
        (void)(h->dimensions == 2 ? scarp_grid2(n, h->grid, out) : scarp_grid3(n, h->grid, out));
    } else if (h->is_double) {
        (void)(h->dimensions == 2 ? scarp_sample2_f64(n, h->count, x[0], x[1], out)
                                  : scarp_sample3_f64(n, h->count, x[0], x[1], x[2], out));
    } else {
        (void)(h->dimensions == 2 ? scarp_sample2(n, h->count, x[0], x[1], out)
                                  : scarp_sample3(n, h->count, x[0], x[1], x[2], out));
    }
}

static void affine(struct hand *h, int a, float scale, float offset)
{
    scarp_affine(h->count, &h->at[a], scale, offset, &h->at[a]);
}

static void add(struct hand *h, int a, int b)
{
    scarp_add(h->count, &h->at[a], &h->at[b], &h->at[a]);
}

static void multiply(struct hand *h, int a, int b)
{
    scarp_multiply(h->count, &h->at[a], &h->at[b], &h->at[a]);
}

static void smoothstep(struct hand *h, int a, float lo, float hi)
{
    scarp_smoothstep(h->count, &h->at[a], lo, hi, &h->at[a]);
}

static void absolute(struct hand *h, int a)
{
    scarp_abs(h->count, &h->at[a], &h->at[a]);
}

static void curve(struct hand *h, int a, size_t knots, const float *x, const float *y, int to)
{
    scarp_curve(h->count, &h->at[a], knots, x, y, &h->at[to]);
}

static double coordinate(const struct scarp_grid *g, int d, size_t i)
{
    return g->origin[d] + (double)(g->first[d] + (int64_t)i) * g->step[d];
}

static void fill(float *array, size_t count, float value)
{
    for (size_t i = 0; array != NULL && i < count; i++) {
        array[i] = value;
    }
}

/* A linear field of the plane: slope . (x, y) */
static void ramp(struct hand *h, const double slope[2], int to)
{
    float *value = h->at[to].value;
    if (h->grid != NULL) {
        const size_t width = h->grid->count[0];
        for (size_t j = 0; j < h->grid->count[1]; j++, value += width) {
            const double row = slope[1] * coordinate(h->grid, 1, j);
            for (size_t i = 0; i < width; i++) {
                value[i] = (float)(slope[0] * coordinate(h->grid, 0, i) + row);
            }
        }
    } else {
        const double *const x = h->x[0], *const y = h->x[1];
        for (size_t i = 0; i < h->count; i++) {
            value[i] = (float)(slope[0] * x[i] + slope[1] * y[i]);
        }
    }
    fill(h->at[to].dx, h->count, (float)slope[0]);
    fill(h->at[to].dy, h->count, (float)slope[1]);
}

/* Sets or raises a register to, or by, scale * z + offset. */
static void ramp_z(struct hand *h, int to, int raises, float scale, float offset)
{
    const struct scarp_samples *const out = &h->at[to];
    const double *const z = h->grid == NULL ? h->x[2] : NULL;
    const size_t slice = h->grid != NULL ? h->grid->count[0] * h->grid->count[1] : 1;
    float *value = out->value;
    for (size_t k = 0; k < h->count / slice; k++, value += slice) {
        const double at = h->grid != NULL ? coordinate(h->grid, 2, k) : z[k];
        const float by = scale * (float)at + offset;
        for (size_t i = 0; i < slice; i++) {
            value[i] = raises ? value[i] + by : by;
        }
    }
    for (size_t i = 0; out->dz != NULL && i < h->count; i++) {
        out->dz[i] = raises ? out->dz[i] + scale : scale;
    }
    if (!raises) {
        fill(out->dx, h->count, 0);
        fill(out->dy, h->count, 0);
    }
}

/* Copies what was computed of the plane to all slices. */
static void flat(struct hand *h, int from, int to)
{
    const struct scarp_samples *const p = &h->plane[from], *const out = &h->at[to];
    const float *const source[3] = {p->value, p->dx, p->dy};
    float *const arrays[3] = {out->value, out->dx, out->dy};
    const struct scarp_grid *const g = h->grid;
    for (int i = 0; i < 3 && arrays[i] != NULL; i++) {
        float *row = arrays[i];
        if (g == NULL) {
            memcpy(row, source[i], h->count * sizeof *row);
            continue;
        }
        for (size_t k = 0; k < g->count[2]; k++) {
            for (size_t j = 0; j < g->count[1]; j++, row += g->count[0]) {
                memcpy(row,
                       source[i] + ((size_t)g->first[1] + j) * h->plane_width + (size_t)g->first[0],
                       g->count[0] * sizeof *row);
            }
        }
    }
    fill(out->dz, h->count, 0);
}

static const struct scarp_noise noise1_noises[] = {{.frequency = 1 / 50.0}};
static const struct scarp_noise noise4_noises[] = {{.frequency = 1 / 50.0, .octaves = 4}};
static const struct scarp_noise warped_noises[] = {
    {.frequency = 1 / 50.0, .warp = &warped_noises[1]},
    {.frequency = 1 / 50.0, .amplitude = 25, .seed = 1}};

static void bare(struct hand *h)
{
    sample(h, 0, 0);
}

static void scaled(struct hand *h)
{
    sample(h, 0, 0);
    affine(h, 0, 100, 3);
}

static const struct scarp_noise fade_noises[] = {
    {.frequency = 1 / 400.0, .octaves = 6},
    {.frequency = 1 / 250.0, .octaves = 8, .seed = 1},
    {.frequency = 1 / 900.0, .octaves = 3, .seed = 2},
};

static void fade(struct hand *h)
{
    sample(h, 2, 2);
    smoothstep(h, 2, -0.2f, 0.2f);
    sample(h, 1, 1);
    sample(h, 0, 0);
    scarp_mix(h->count, &h->at[0], &h->at[1], &h->at[2], &h->at[0]);
    affine(h, 0, 100, 0);
}

static const struct scarp_noise alps_noises[] = {
    {.frequency = 0.0016, .octaves = 3, .rotate = 1},
    {.frequency = 0.005,
     .octaves = 9,
     .fractal = SCARP_SWISS,
     .rotate = 1,
     .gain = 0.45f,
     .warp = &alps_noises[3]},
    {.frequency = 0.0016,
     .octaves = 8,
     .fractal = SCARP_HYBRID,
     .rotate = 1,
     .gain = 0.42f,
     .amplitude = 1.4f},
    {.frequency = 0.0035, .octaves = 5, .amplitude = 75},
};

static void alps(struct hand *h)
{
    sample(h, 0, 1);
    smoothstep(h, 1, -0.5f, 0.25f);
    sample(h, 1, 0);
    multiply(h, 0, 1);
    sample(h, 2, 1);
    add(h, 0, 1);
    affine(h, 0, 110, 0);
}

static const struct scarp_noise overworld_noises[] = {
    {.frequency = 1 / 2400.0, .octaves = 6, .rotate = 1, .seed = 2, .warp = &overworld_noises[5]},
    {.frequency = 1 / 1500.0, .octaves = 4, .rotate = 1, .seed = 3, .warp = &overworld_noises[5]},
    {.frequency = 1 / 700.0, .octaves = 5, .rotate = 1, .seed = 4},
    {.frequency = 1 / 260.0,
     .octaves = 6,
     .fractal = SCARP_RIDGED,
     .rotate = 1,
     .gain = 0.45f,
     .seed = 5},
    {.frequency = 1 / 40.0, .octaves = 3, .seed = 6},
    {.frequency = 1 / 600.0, .octaves = 3, .amplitude = 120, .seed = 1},
};

static void overworld(struct hand *h)
{
    static const float shelf_x[] = {-1, -0.45f, -0.2f, -0.1f, 0.05f, 0.3f, 0.7f};
    static const float shelf_y[] = {-60, -55, -18, 2, 8, 30, 60};
    static const float rugged_x[] = {-0.7f, -0.3f, 0, 0.4f}, rugged_y[] = {1, 0.6f, 0.2f, 0.05f};
    sample(h, 0, 1);
    curve(h, 1, 7, shelf_x, shelf_y, 0);
    smoothstep(h, 1, -0.12f, 0.3f);
    sample(h, 1, 2);
    curve(h, 2, 4, rugged_x, rugged_y, 2);
    multiply(h, 1, 2);
    sample(h, 2, 3);
    absolute(h, 3);
    affine(h, 3, 3, -2);
    absolute(h, 3);
    affine(h, 3, -70, 70);
    sample(h, 3, 2);
    affine(h, 2, 90, 0);
    add(h, 3, 2);
    multiply(h, 1, 3);
    sample(h, 4, 2);
    affine(h, 2, 6, 0);
    add(h, 0, 2);
    add(h, 0, 1);
}

static const struct scarp_noise marble_noises[] = {
    {.frequency = 1 / 0.7, .octaves = 6, .fractal = SCARP_TURBULENCE, .seed = 1}};

static void marble(struct hand *h)
{
    static const double coarse[2] = {5 * 0.9063077870366499, 5 * 0.42261826174069944};
    static const double fine[2] = {20 * 0.6427876096865394, 20 * -0.766044443118978};
    sample(h, 0, 2);
    ramp(h, coarse, 0);
    scarp_affine(h->count, &h->at[2], 1.8f, 0, &h->at[3]);
    add(h, 0, 3);
    scarp_sine(h->count, &h->at[0], &h->at[0]);
    affine(h, 0, -0.5f, 0.5f);
    scarp_multiply(h->count, &h->at[0], &h->at[0], &h->at[3]);
    multiply(h, 0, 3);
    ramp(h, fine, 1);
    affine(h, 2, 3.6f, 0);
    add(h, 1, 2);
    scarp_sine(h->count, &h->at[1], &h->at[1]);
    affine(h, 1, -0.1f, -0.9f);
    multiply(h, 0, 1);
    affine(h, 0, 1, 1);
}

static const struct scarp_noise clouds_noises[] = {
    {.frequency = 1 / 6000.0, .octaves = 3, .seed = 4},
    {.frequency = 1 / 1400.0, .octaves = 5, .seed = 2, .warp = &clouds_noises[3]},
    {.frequency = 1 / 300.0, .octaves = 3, .basis = SCARP_CELL_F1, .seed = 3},
    {.frequency = 1 / 900.0, .octaves = 2, .amplitude = 150, .seed = 1},
};

static void clouds_plane(struct hand *h)
{
    sample(h, 0, 0);
    affine(h, 0, 1, 0.05f);
}

static void clouds(struct hand *h)
{
    static const float x[] = {0, 0.15f, 0.6f, 1}, y[] = {0, 1, 0.8f, 0};
    ramp_z(h, 2, 0, 1 / 1600.0f, -1100 / 1600.0f);
    curve(h, 2, 4, x, y, 2);
    sample(h, 1, 0);
    affine(h, 0, 0.8f, 0);
    flat(h, 0, 1);
    add(h, 0, 1);
    multiply(h, 0, 2);
    sample(h, 2, 1);
    affine(h, 1, 0.2f, -0.2f);
    add(h, 0, 1);
    affine(h, 1, 0, 0);
    scarp_smooth_max(h->count, &h->at[0], &h->at[1], 0.05f, &h->at[0]);
}

static const struct scarp_noise density_noises[] = {
    {.frequency = 1 / 900.0, .octaves = 2, .seed = 1},
    {.frequency = 1 / 250.0, .octaves = 4, .seed = 2},
    {.frequency = 1 / 60.0, .octaves = 4, .seed = 3},
    {.frequency = 1 / 80.0, .octaves = 2, .fractal = SCARP_RIDGED, .seed = 4},
    {.frequency = 1 / 80.0, .octaves = 2, .fractal = SCARP_RIDGED, .seed = 5},
};

/* The height, and by how much rock may be above or below it */
static void density_plane(struct hand *h)
{
    sample(h, 0, 1);
    smoothstep(h, 1, -0.15f, 0.15f);
    scarp_affine(h->count, &h->at[1], 60, 6, &h->at[0]);
    sample(h, 1, 2);
    multiply(h, 0, 2);
    affine(h, 0, 1, 20);
    affine(h, 1, 14, 2);
}

static void density(struct hand *h)
{
    sample(h, 2, 0);
    flat(h, 1, 1);
    multiply(h, 0, 1);
    flat(h, 0, 1);
    add(h, 0, 1);
    ramp_z(h, 0, 1, -1, 0);
    affine(h, 0, 1 / 16.0f, 0);
    sample(h, 3, 1);
    sample(h, 4, 2);
    scarp_min(h->count, &h->at[1], &h->at[2], &h->at[1]);
    affine(h, 1, -12, 9.6f);
    scarp_min(h->count, &h->at[0], &h->at[1], &h->at[0]);
    ramp_z(h, 1, 0, -1, 4);
    scarp_max(h->count, &h->at[0], &h->at[1], &h->at[0]);
}

const struct hand_recipe hand_recipes[] = {
    {.title = "noise1", NOISES(noise1_noises), .registers = 1, .compute = bare},
    {.title = "noise4", NOISES(noise4_noises), .registers = 1, .compute = bare},
    {.title = "warped", NOISES(warped_noises), .warps = 1, .registers = 1, .compute = bare},
    {.title = "scaled-noise1", NOISES(noise1_noises), .registers = 1, .compute = scaled},
    {.title = "scaled-noise4", NOISES(noise4_noises), .registers = 1, .compute = scaled},
    {.title = "scaled-warped",
     NOISES(warped_noises),
     .warps = 1,
     .registers = 1,
     .compute = scaled},
    {.title = "fade", NOISES(fade_noises), .registers = 3, .compute = fade},
    {.title = "alps", NOISES(alps_noises), .warps = 1, .registers = 2, .compute = alps},
    {.title = "overworld",
     NOISES(overworld_noises),
     .warps = 1,
     .registers = 4,
     .compute = overworld},
    {.title = "marble", NOISES(marble_noises), .registers = 4, .compute = marble},
    {.title = "clouds",
     NOISES(clouds_noises),
     .plane_noises = 1,
     .warps = 1,
     .registers = 3,
     .compute_plane = clouds_plane,
     .compute = clouds},
    {.title = "density",
     NOISES(density_noises),
     .plane_noises = 2,
     .registers = 3,
     .compute_plane = density_plane,
     .compute = density},
    {.title = NULL},
};
