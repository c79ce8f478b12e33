/* SPDX-License-Identifier: MIT
 *
 * The terrain of relief.c, and its picture. Lengths are in pixels, x points right, y down, z up.
 */
#ifndef SCARP_GPU_RELIEF_H
#define SCARP_GPU_RELIEF_H

#include <math.h>
#include <stdio.h>

#include <scarp.h>

enum { RELIEF_WIDTH = 800, RELIEF_HEIGHT = 450, RELIEF_PIXELS = RELIEF_WIDTH * RELIEF_HEIGHT };

/* Of all pixels, row by row. */
struct relief {
    float value[RELIEF_PIXELS], dx[RELIEF_PIXELS], dy[RELIEF_PIXELS];
};

/* relief.comp fixes the basis and the number of warps. */
static const struct scarp_noise relief_bend = {
    .seed = 9,
    .frequency = 1.0 / 190.0,
    .octaves = 3.0f,
    .amplitude = 44.0f,
};
static const struct scarp_noise relief_ground = {
    .fractal = SCARP_SWISS,
    .rotate = 1,
    .seed = 14,
    .frequency = 1.0 / 300.0,
    .octaves = 7.0f,
    .amplitude = 160.0f,
    .sharpness = 0.12f,
    .warp = &relief_bend,
};

/* Heights of the lakes and of the snow. */
static const float relief_water = 72.0f, relief_snow = 136.0f;

/* Writes the bytes that shaders read. Returns 0 if that fails. */
static inline int relief_write_plan(const char *path)
{
    struct scarp_gpu_plan plan;
    FILE *const file = fopen(path, "wb");
    if (file == NULL || scarp_gpu_plan_make(&relief_ground, 2, &plan, NULL) != SCARP_OK) {
        return 0;
    }
    const int written = fwrite(&plan, sizeof plan, 1, file) == 1;
    return fclose(file) == 0 && written;
}

/* What the shader computes, by the library: at the same points, not by scarp_grid2, which computes
   positions in double precision. */
static inline enum scarp_status relief_by_library(struct relief *terrain)
{
    enum scarp_status status = SCARP_OK;
    for (int j = 0; j < RELIEF_HEIGHT && status == SCARP_OK; j++) {
        float x[RELIEF_WIDTH], y[RELIEF_WIDTH];
        for (int i = 0; i < RELIEF_WIDTH; i++) {
            x[i] = (float)i;
            y[i] = (float)j;
        }
        const int row = j * RELIEF_WIDTH;
        const struct scarp_samples out = {
            .value = terrain->value + row, .dx = terrain->dx + row, .dy = terrain->dy + row};
        status = scarp_sample2(&relief_ground, RELIEF_WIDTH, x, y, &out);
    }
    return status;
}

static inline float relief_mix(float a, float b, float t)
{
    return a + (b - a) * t;
}

/* From 0 at `from` to 1 at `to`. */
static inline float relief_ramp(float from, float to, float x)
{
    const float t = fminf(fmaxf((x - from) / (to - from), 0.0f), 1.0f);
    return t * t * (3.0f - 2.0f * t);
}

/* The direction to the sun, in the north west: rays to it meet pixels in their middles. */
static const float relief_sun[3] = {-0.55f, -0.55f, 0.63f};

/* How much of the sun is above the ground, seen from height z at column i and row j: 0 to 1. */
static inline float relief_sunlight(const struct relief *terrain, int i, int j, float z)
{
    float open = 1.0f;
    for (int t = 1; t <= i && t <= j && t < 200 && open > 0.0f; t++) {
        const float ray = z + (float)t * relief_sun[2] / -relief_sun[0];
        const float above = ray - terrain->value[(j - t) * RELIEF_WIDTH + i - t];
        open = fminf(open, above / (1.0f + 0.08f * (float)t));
    }
    return fmaxf(open, 0.0f);
}

/* The color of the ground: grass, rock where it is high or steep, snow; or water. */
static inline void relief_ground_color(float height, float up, float color[3])
{
    static const float meadow[3] = {0.34f, 0.33f, 0.15f}, wood[3] = {0.13f, 0.20f, 0.07f};
    static const float rock[3] = {0.36f, 0.31f, 0.26f}, snow[3] = {0.92f, 0.94f, 0.98f};
    static const float shore[3] = {0.20f, 0.38f, 0.40f}, deep[3] = {0.03f, 0.10f, 0.17f};
    const float dry = relief_ramp(0.0f, 45.0f, height - relief_water);
    const float green =
        relief_ramp(0.60f, 0.85f, up) * (1.0f - relief_ramp(-20.0f, -2.0f, height - relief_snow));
    const float white = relief_ramp(-4.0f, 8.0f, height - relief_snow + 8.0f * (up - 0.7f)) *
                        relief_ramp(0.45f, 0.62f, up);
    for (int k = 0; k < 3; k++) {
        const float grass = relief_mix(wood[k], meadow[k], dry);
        color[k] = relief_mix(relief_mix(rock[k], grass, green), snow[k], white);
        if (height < relief_water) {
            color[k] =
                relief_mix(shore[k], deep[k], relief_ramp(0.0f, 30.0f, relief_water - height));
        }
    }
}

/* A pixel in the light of the sun and of the sky. */
static inline void relief_pixel(const struct relief *terrain, int i, int j, unsigned char rgb[3])
{
    static const float sun[3] = {1.9f, 1.7f, 1.4f}, sky[3] = {0.24f, 0.31f, 0.44f};
    const int at = j * RELIEF_WIDTH + i;
    const float height = terrain->value[at];
    const float dry = height < relief_water ? 0.0f : 1.0f;
    const float dx = dry * terrain->dx[at], dy = dry * terrain->dy[at];
    const float up = 1.0f / sqrtf(dx * dx + dy * dy + 1.0f);
    const float facing = up * (relief_sun[2] - dx * relief_sun[0] - dy * relief_sun[1]);
    const float lit =
        fmaxf(facing, 0.0f) * relief_sunlight(terrain, i, j, fmaxf(height, relief_water));
    float color[3];
    relief_ground_color(height, up, color);
    for (int k = 0; k < 3; k++) {
        const float light = color[k] * (lit * sun[k] + (0.35f + 0.65f * up) * sky[k]);
        const float shown = sqrtf(light / (1.0f + 0.25f * light)); /* for screens */
        rgb[k] = (unsigned char)lrintf(255.0f * fminf(shown, 1.0f));
    }
}

/* Writes the picture as PPM. Returns 0 if that fails. */
static inline int relief_write(const struct relief *terrain, const char *path)
{
    FILE *const file = fopen(path, "wb");
    if (file == NULL) {
        return 0;
    }
    fprintf(file, "P6\n%d %d\n255\n", RELIEF_WIDTH, RELIEF_HEIGHT);
    for (int at = 0; at < RELIEF_PIXELS; at++) {
        unsigned char rgb[3];
        relief_pixel(terrain, at % RELIEF_WIDTH, at / RELIEF_WIDTH, rgb);
        fwrite(rgb, 1, sizeof rgb, file);
    }
    const int failed = ferror(file);
    return fclose(file) == 0 && !failed;
}

#endif
