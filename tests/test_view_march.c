/* SPDX-License-Identifier: MIT
 *
 * Marching against brute force: rays that look every quarter of a pixel. No ray of march.c may pass
 * through ground that a pixel shows, but for few at the edges of cliffs. `--figures` prints the
 * counts for larger pictures.
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "view/march.h"

#define MOST (480 * 270)

struct case_of {
    const char *name;
    struct scarp_noise noise;
    float height, sea;
    float camera_over; /* the ground */
    double azimuth, elevation;
};

static const struct case_of cases[] = {
    {"fbm", {.seed = 1, .frequency = 0.0025, .octaves = 9, .gain = 0.4f}, 120, -2, 30, 330, -6},
    {"ridged",
     {.seed = 1,
      .fractal = SCARP_RIDGED,
      .rotate = 1,
      .frequency = 0.0035,
      .octaves = 7,
      .gain = 0.42f},
     100,
     -2,
     12,
     165,
     -5},
    {"turbulence",
     {.seed = 2,
      .fractal = SCARP_TURBULENCE,
      .rotate = 1,
      .frequency = 0.004,
      .octaves = 8,
      .gain = 0.36f},
     260,
     -2,
     25,
     30,
     -8},
    {"erosion",
     {.seed = 3,
      .fractal = SCARP_EROSION,
      .erosion = 0.25f,
      .rotate = 1,
      .frequency = 0.0045,
      .octaves = 8,
      .gain = 0.46f},
     170,
     0.05f,
     40,
     100,
     -7},
    {"swiss",
     {.seed = 4,
      .fractal = SCARP_SWISS,
      .rotate = 1,
      .frequency = 0.0045,
      .octaves = 8,
      .gain = 0.45f},
     65,
     -2,
     20,
     200,
     -10},
    {"rough", {.seed = 5, .frequency = 0.01, .octaves = 10, .gain = 0.6f}, 100, -2, 15, 10, -25},
    {"cells",
     {.seed = 6,
      .basis = SCARP_CELL_F1,
      .rotate = 1,
      .frequency = 0.0045,
      .octaves = 8,
      .gain = 0.36f},
     -110,
     -2,
     30,
     270,
     -6},
    {"cliffs",
     {.seed = 12,
      .basis = SCARP_CELL_EDGE,
      .fractal = SCARP_EROSION,
      .rotate = 1,
      .frequency = 0.004,
      .octaves = 6},
     120,
     -2,
     40,
     315,
     -8},
    {"mesas",
     {.seed = 12, .basis = SCARP_CELL_VALUE, .frequency = 0.01, .octaves = 4},
     60,
     -2,
     10,
     315,
     -8},
    {"low", {.seed = 7, .frequency = 0.0025, .octaves = 9, .gain = 0.4f}, 120, -2, 1, 80, 2},
};

static void make_scene(const struct case_of *of, size_t width, struct scene *scene)
{
    struct ground ground = {.noise = {of->noise}, .height_scale = of->height};
    ground.noise[0].lacunarity = 2.0f; /* whoever limits octaves has to know it */
    scarp_range(ground.noise, 2, &ground.lowest, &ground.highest);
    if (of->height < 0.0f) { /* turned over */
        ground.noise[0].amplitude = -1.0f;
        ground.height_scale = -of->height;
        scarp_range(ground.noise, 2, &ground.lowest, &ground.highest);
    }
    ground.floor = of->sea > ground.lowest ? of->sea : ground.lowest;
    ground.ceiling = ground.highest;
    *scene = (struct scene){.haze = 0.0f};
    scene_set_ground(scene, &ground, 0.0, 0.0);
    const double x = 500.0, y = 500.0;
    float value;
    ground_points(&scene->ground, 1, &x, &y, &(struct scarp_samples){.value = &value});
    scene->camera = (struct camera){.x = x,
                                    .y = y,
                                    .z = scene->height_scale * value + of->camera_over,
                                    .width = width,
                                    .height = width * 9 / 16};
    camera_turn(&scene->camera, of->azimuth, of->elevation, 56.0);
    scene_set_bands(scene);
}

/* How far below the ground of its band a ray is at a distance, in pixels */
static float below(const struct scene *scene, const struct band *band, const struct rays *rays,
                   size_t ray, float distance)
{
    const double x = scene->camera.x + (double)(rays->x[ray] * distance);
    const double y = scene->camera.y + (double)(rays->y[ray] * distance);
    float value;
    ground_points(&band->ground, 1, &x, &y, &(struct scarp_samples){.value = &value});
    const float over = scene->camera.z + rays->z[ray] * distance - scene->height_scale * value;
    return -over / (scene->camera.pixel * distance);
}

struct brute {
    const struct scene *scene;
    const struct rays *rays;
    size_t count;
    uint32_t *ray;
    float *at, *deepest, *begins;
    double *x, *y;
    float *value;
};

/* Takes all rays to the ends of their ways by quarters of a pixel, and keeps the deepest point that
   lies before what march.c found, in pixels below the ground. */
static void look_everywhere(struct brute *brute)
{
    const struct scene *const scene = brute->scene;
    const struct rays *const rays = brute->rays;
    const float pixel = scene->camera.pixel;
    size_t live = 0;
    for (size_t i = 0; i < rays->count; i++) {
        brute->deepest[i] = 0.0f;
        const float over = scene->camera.z - scene->top;
        if (over >= 0.0f && rays->z[i] >= 0.0f) {
            continue;
        }
        brute->ray[live] = (uint32_t)i;
        brute->at[live++] = over > 0.0f ? over / -rays->z[i] : 0.05f;
    }
    for (size_t b = 0; b < BANDS; b++) {
        const struct band *const band = &scene->band[b];
        for (bool all = false; !all;) {
            size_t count = 0;
            for (size_t i = 0; i < live; i++) {
                if (brute->at[i] < band->end) {
                    const uint32_t ray = brute->ray[i];
                    brute->x[count] = scene->camera.x + (double)(rays->x[ray] * brute->at[i]);
                    brute->y[count++] = scene->camera.y + (double)(rays->y[ray] * brute->at[i]);
                }
            }
            all = count == 0;
            ground_points(&band->ground, count, brute->x, brute->y,
                          &(struct scarp_samples){.value = brute->value});
            size_t n = 0, left = 0;
            for (size_t i = 0; i < live; i++) {
                const uint32_t ray = brute->ray[i];
                float at = brute->at[i];
                if (at < band->end) {
                    const float over = scene->camera.z + rays->z[ray] * at -
                                       scene->height_scale * brute->value[n++];
                    const float depth = -over / (pixel * at);
                    if (depth > brute->deepest[ray]) {
                        brute->deepest[ray] = depth;
                    }
                    at += 0.25f * pixel * at;
                }
                const bool is_sky =
                    rays->z[ray] >= 0.0f && scene->camera.z + rays->z[ray] * at >= scene->top;
                /* To be seen, the ground has to be a part of a pixel nearer. */
                if (at < rays->distance[ray] * (1.0f - 0.5f * pixel) && at < scene->farthest &&
                    !is_sky) {
                    brute->ray[left] = ray;
                    brute->at[left++] = at;
                }
            }
            live = left;
        }
    }
}

static int check(const struct case_of *of, size_t width, bool figures)
{
    static struct scene scene;
    static float x[MOST], y[MOST], z[MOST], begin[MOST], distance[MOST], at[MOST], deepest[MOST],
        value[MOST];
    static bool cliff[MOST];
    static uint32_t hit[MOST], ray[MOST];
    static double px[MOST], py[MOST];
    struct march march;
    uint64_t first_points = 0;
    make_scene(of, width, &scene);
    struct rays rays = {
        .x = x, .y = y, .z = z, .begin = begin, .distance = distance, .cliff = cliff, .hit = hit};
    if (!march_open(&march, MOST)) {
        return 1;
    }
    /* First the rays through the middles of pixels, then those near a corner, which begin where
       the first ones let them. */
    rays.count = width * scene.camera.height;
    for (int pass = 0; pass < 2; pass++) {
        const float place = pass == 0 ? 0.5f : 0.98f;
        rays.spread = pass == 0 ? 0.75f * scene.camera.pixel : 0.0f;
        for (size_t i = 0; i < rays.count; i++) {
            const struct vector ray_at =
                camera_ray(&scene.camera, (float)(i % width) + place, (float)(i / width) + place);
            x[i] = ray_at.x;
            y[i] = ray_at.y;
            z[i] = ray_at.z;
            begin[i] = pass == 0 ? 0.0f : begin[i];
        }
        march.points = pass == 0 ? 0 : march.points;
        march_rays(&march, &scene, &rays);
        first_points = pass == 0 ? march.points : first_points;
    }
    struct brute brute = {.scene = &scene,
                          .rays = &rays,
                          .ray = ray,
                          .at = at,
                          .deepest = deepest,
                          .x = px,
                          .y = py,
                          .value = value};
    look_everywhere(&brute);
    size_t half = 0, whole = 0, off = 0, cliffs = 0;
    for (size_t i = 0; i < rays.count; i++) {
        half += deepest[i] > 0.5f;
        whole += deepest[i] > 1.0f;
    }
    for (size_t b = 0; b < BANDS; b++) { /* what was found is the ground */
        for (size_t i = rays.first_hit[b]; i < rays.first_hit[b + 1]; i++) {
            const float to = distance[hit[i]];
            const float depth = below(&scene, &scene.band[b], &rays, hit[i], to);
            const float beyond =
                below(&scene, &scene.band[b], &rays, hit[i], to * (1.0f + 0x1p-18f));
            cliffs += cliff[hit[i]];
            off += cliff[hit[i]] ? depth > 0.0f || beyond < 0.0f : fabsf(depth) > 0.25f;
        }
    }
    if (figures) {
        printf(
            "%-10s %zu rays, %zu hit, %.1f and %.1f points each; passed through ground: by half "
            "a pixel "
            "%zu, by one %zu; %zu hits a quarter of a pixel off the ground, %zu at cliffs\n",
            of->name, rays.count, rays.first_hit[BANDS], (double)first_points / (double)rays.count,
            (double)(march.points - first_points) / (double)rays.count, half, whole, off, cliffs);
    }
    march_close(&march);
    const bool jumps = ground_jumps(&scene.ground);
    const size_t allowed = jumps ? rays.count / 50 : 0; /* edges that steps pass over */
    const bool is_slow = first_points > 400 * rays.count;
    if (figures || (half <= 2 * allowed && off <= allowed && (cliffs > 0) == jumps && !is_slow &&
                    rays.first_hit[BANDS] > rays.count / 4)) {
        return 0;
    }
    printf(
        "%s: %zu rays pass through the ground, %zu end off it, %zu at cliffs; %.0f points each\n",
        of->name, half, off, cliffs, (double)first_points / (double)rays.count);
    return 1;
}

int main(int argc, char **argv)
{
    const bool figures = argc > 1 && strcmp(argv[1], "--figures") == 0;
    int failed = 0;
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        failed += check(&cases[i], figures ? 240 : 64, figures);
    }
    return failed != 0;
}
