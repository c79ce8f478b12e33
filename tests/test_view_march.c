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
    const char *height; /* the recipe's output */
    uint64_t seed;
    float camera_over; /* the ground */
    double azimuth, elevation;
};

static const struct case_of cases[] = {
    {"fbm", "120 * noise(frequency=0.0025, octaves=9, gain=0.4)", 1, 30, 330, -6},
    {"ridged", "100 * noise(ridged, rotate, frequency=0.0035, octaves=7, gain=0.42)", 1, 12, 165,
     -5},
    {"turbulence", "260 * noise(turbulence, rotate, frequency=0.004, octaves=8, gain=0.36)", 2, 25,
     30, -8},
    {"erosion",
     "170 * noise(erosion, rotate, frequency=0.0045, octaves=8, gain=0.46, erosion=0.25)", 3, 40,
     100, -7},
    {"swiss", "65 * noise(swiss, rotate, frequency=0.0045, octaves=8, gain=0.45)", 4, 20, 200, -10},
    {"rough", "100 * noise(frequency=0.01, octaves=10, gain=0.6)", 6, 15, 10, -25},
    {"cells", "-110 * noise(cell_f1, rotate, frequency=0.0045, octaves=8, gain=0.36)", 6, 30, 270,
     -6},
    {"gullies",
     "600 * gullies(smooth_abs(noise(size=900, octaves=2, rotate), 0.1), size=800, octaves=8, "
     "amplitude=0.4, depth=0.2)",
     3, 30, 45, -6},
    {"cliffs", "120 * noise(cell_edge, erosion, rotate, frequency=0.004, octaves=6)", 12, 40, 315,
     -8},
    {"mesas", "60 * noise(cell_value, frequency=0.01, octaves=4)", 12, 10, 315, -8},
    {"low", "120 * noise(frequency=0.0025, octaves=9, gain=0.4)", 7, 1, 80, 2},
};

static void make_scene(const struct case_of *of, size_t width, struct scene *scene)
{
    static struct ground ground;
    struct scarp_recipe_error error;
    char text[512];
    const int length = snprintf(text, sizeof text, "recipe 1\nparam sea = %s\nout height = %s\n",
                                strcmp(of->name, "erosion") == 0 ? "8.5" : "-1000", of->height);
    const struct ground_source source = {.text = text, .length = (size_t)length, .seed = of->seed};
    if (ground_open(&ground, &source, &error) != GROUND_FINE) {
        printf("%s: %s\n", of->name, error.text);
        exit(1);
    }
    memset(scene, 0, sizeof *scene);
    scene_set_ground(scene, &ground, 0.0, 0.0);
    const double x = 500.0, y = 500.0;
    float value;
    ground_points(&scene->ground, 1, &x, &y, &(struct scarp_samples){.value = &value});
    scene->camera = (struct camera){
        .x = x, .y = y, .z = value + of->camera_over, .width = width, .height = width * 9 / 16};
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
    const float over = scene->camera.z + rays->z[ray] * distance - value;
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
                    const float over = scene->camera.z + rays->z[ray] * at - brute->value[n++];
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
    const bool jumps = scene.ground.jumps;
    const size_t allowed = jumps ? rays.count / 50 : 0; /* edges that steps pass over */
    const bool is_slow = first_points > 400 * rays.count;
    const size_t bent = rays.count / 1000; /* ground that is no line between two points */
    if (figures || (half <= 2 * allowed && off <= allowed + bent && (cliffs > 0) == jumps &&
                    !is_slow && rays.first_hit[BANDS] > rays.count / 4)) {
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
