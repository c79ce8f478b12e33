/* SPDX-License-Identifier: MIT
 *
 * Points on the ground are lit band by band, some thousands at a time: the ground and its exact
 * gradient, textures, the sea, the sun and its shadows; then the haze between them and the camera.
 */
#include "view/light.h"

#include "shared/interrupt.h"
#include "view/material.h"
#include "view/sky.h"
#include "view/water.h"

#define TREE_HEIGHT 1.6f
#define ROUGH_HEIGHT 2.4f
#define CLIFF_NEAREST 0.0625f
#define CLOUD_HEIGHT 1500.0f /* above the camera */

static struct vector ray_of(const struct rays *rays, uint32_t ray)
{
    return (struct vector){rays->x[ray], rays->y[ray], rays->z[ray]};
}

static void count_call(struct light *light)
{
    light->calls++;
    light->points += light->count;
}

static void place(struct light *light, const struct scene *scene, const struct band *band,
                  const struct rays *rays)
{
    for (size_t i = 0; i < light->count; i++) {
        const uint32_t ray = light->ray[i];
        const float distance = rays->distance[ray];
        light->x[i] = scene->camera.x + (double)(rays->x[ray] * distance);
        light->y[i] = scene->camera.y + (double)(rays->y[ray] * distance);
        light->along[i] = (distance - band->begin) / (band->end - band->begin);
    }
}

static void blend(const struct light *light, float *a, const float *b)
{
    for (size_t i = 0; i < light->count; i++) {
        a[i] = mix(a[i], b[i], light->along[i]);
    }
}

/* How wide a pixel is at a distance, but not 0 */
static float pixel_at(const struct scene *scene, float distance)
{
    return scene->camera.pixel * (distance > CLIFF_NEAREST ? distance : CLIFF_NEAREST);
}

/* Points on cliffs are as high as their rays. Their slopes are those of the ground a pixel around
   them, by its mean difference along 16 directions. */
static void sample_cliffs(struct light *light, const struct scene *scene, size_t band,
                          const struct rays *rays)
{
    static const float cosines[16] = {1.0f,  0.92387953f,  0.70710678f,  0.38268343f,
                                      0.0f,  -0.38268343f, -0.70710678f, -0.92387953f,
                                      -1.0f, -0.92387953f, -0.70710678f, -0.38268343f,
                                      0.0f,  0.38268343f,  0.70710678f,  0.92387953f};
    uint32_t *const cliff = light->point;
    size_t count = 0;
    for (size_t i = 0; i < light->count; i++) {
        const uint32_t ray = light->ray[i];
        if (rays->cliff[ray]) {
            light->height[i] = scene->camera.z + rays->z[ray] * rays->distance[ray];
            light->dx[i] = light->dy[i] = 0.0f;
            cliff[count++] = (uint32_t)i;
        }
    }
    for (size_t k = 0; k < 16 && count > 0; k++) {
        const float x = cosines[k], y = cosines[(k + 12) % 16];
        for (size_t n = 0; n < count; n++) {
            const float reach = pixel_at(scene, rays->distance[light->ray[cliff[n]]]);
            light->u[n] = light->x[cliff[n]] + (double)(reach * x);
            light->v[n] = light->y[cliff[n]] + (double)(reach * y);
        }
        interrupt_unless(ground_points(&scene->band[band].ground, count, light->u, light->v,
                                       &(struct scarp_samples){.value = light->other[0]}));
        light->calls++;
        light->points += count;
        for (size_t n = 0; n < count; n++) {
            const float reach = pixel_at(scene, rays->distance[light->ray[cliff[n]]]);
            const float rises = light->other[0][n] / (8.0f * reach);
            light->dx[cliff[n]] += x * rises;
            light->dy[cliff[n]] += y * rises;
        }
    }
}

/* The ground of the band and the one of the next band, blended by distance, so that no octave ends
   at a line that is seen; and the ground with fewer octaves, for hills as a whole. */
static void sample_ground(struct light *light, const struct scene *scene, size_t band,
                          const struct rays *rays)
{
    float *const value = light->other[0], *const dx = light->other[1], *const dy = light->other[2];
    interrupt_unless(ground_points(
        &scene->band[band].ground, light->count, light->x, light->y,
        &(struct scarp_samples){.value = light->height, .dx = light->dx, .dy = light->dy}));
    interrupt_unless(ground_points(&scene->band[band + 1].ground, light->count, light->x, light->y,
                                   &(struct scarp_samples){.value = value, .dx = dx, .dy = dy}));
    blend(light, light->dx, dx);
    blend(light, light->dy, dy);
    sample_cliffs(light, scene, band, rays);
    interrupt_unless(ground_points(&scene->smooth[0], light->count, light->x, light->y,
                                   &(struct scarp_samples){.value = light->hollow[0],
                                                           .dx = light->smooth_dx,
                                                           .dy = light->smooth_dy}));
    interrupt_unless(ground_points(&scene->smooth[1], light->count, light->x, light->y,
                                   &(struct scarp_samples){.value = light->hollow[1]}));
    for (size_t i = 0; i < light->count; i++) {
        for (int j = 0; j < 2; j++) {
            light->hollow[j][i] -= scene->survey.smoothed[j] + light->height[i];
        }
    }
    for (int i = 0; i < 4; i++) {
        count_call(light);
    }
}

/* A texture, whose smallest cells go by distance, too */
static void sample_texture(struct light *light, const struct scene *scene, size_t band,
                           enum texture texture, const double *x, const double *y)
{
    const struct scarp_samples first = {.value = light->texture[texture],
                                        .dx = light->texture_dx[texture],
                                        .dy = light->texture_dy[texture]};
    const struct scarp_samples second = {
        .value = light->other[0], .dx = light->other[1], .dy = light->other[2]};
    texture_sample(texture, scene->band[band].finest, light->count, x, y, &first);
    texture_sample(texture, scene->band[band + 1].finest, light->count, x, y, &second);
    blend(light, first.value, second.value);
    blend(light, first.dx, second.dx);
    blend(light, first.dy, second.dy);
    count_call(light);
    count_call(light);
}

static void sample_textures(struct light *light, const struct scene *scene, size_t band)
{
    sample_texture(light, scene, band, TEXTURE_PATCHES, light->x, light->y);
    sample_texture(light, scene, band, TEXTURE_ROUGH, light->x, light->y);
    sample_texture(light, scene, band, TEXTURE_TREES, light->x, light->y);
    /* Layers of rock are level but for broad waves. */
    for (size_t i = 0; i < light->count; i++) {
        light->u[i] = 0.05 * (light->x[i] - light->y[i]);
        light->v[i] = (double)(light->height[i] + 6.0f * light->texture[TEXTURE_PATCHES][i]);
    }
    sample_texture(light, scene, band, TEXTURE_LAYERS, light->u, light->v);
    if (scene->has_sea) {
        sample_texture(light, scene, band, TEXTURE_WAVES, light->x, light->y);
        interrupt_unless(ground_points(&scene->bed, light->count, light->x, light->y,
                                       &(struct scarp_samples){.value = light->bed}));
        count_call(light);
    }
}

static bool is_sea(const struct light *light, const struct scene *scene, size_t i)
{
    return scene->has_sea && light->height[i] <= scene->sea;
}

static struct vector normal_of(float dx, float dy)
{
    return unit((struct vector){-dx, -dy, 1.0f});
}

/* Looks for the sun from where the ground faces it. */
static void shade(struct light *light, const struct scene *scene, size_t band)
{
    for (size_t i = 0; i < light->count; i++) {
        const struct vector normal = normal_of(light->dx[i], light->dy[i]);
        light->sun[i] = dot(normal, scene->sun) > -0.1f ? 1.0f : 0.0f;
    }
    const struct shadow_points points = {light->count, light->x, light->y, light->height,
                                         light->sun};
    shadow_points(&light->shadow, scene, band, &points);
}

static struct site site_of(const struct light *light, size_t i)
{
    const float dx = light->dx[i], dy = light->dy[i];
    const float smooth_dx = light->smooth_dx[i], smooth_dy = light->smooth_dy[i];
    return (struct site){.height = light->height[i],
                         .slope = sqrtf(dx * dx + dy * dy),
                         .broad = sqrtf(smooth_dx * smooth_dx + smooth_dy * smooth_dy),
                         .hollow = light->hollow[0][i],
                         .patches = light->texture[TEXTURE_PATCHES][i],
                         .rough = light->texture[TEXTURE_ROUGH][i],
                         .layers = light->texture[TEXTURE_LAYERS][i],
                         .trees = light->texture[TEXTURE_TREES][i]};
}

/* The light of the sun, of the sky as far as the ground around leaves it, and of the ground in the
   sun across, on a material */
static struct colour lit(const struct light *light, const struct scene *scene, size_t i)
{
    const struct site site = site_of(light, i);
    const struct material material = material_at(scene, &site);
    const float rough = ROUGH_HEIGHT * material.roughness;
    const float tree = TREE_HEIGHT * material.trees;
    const struct vector normal =
        normal_of(light->dx[i] + rough * light->texture_dx[TEXTURE_ROUGH][i] -
                      tree * light->texture_dx[TEXTURE_TREES][i],
                  light->dy[i] + rough * light->texture_dy[TEXTURE_ROUGH][i] -
                      tree * light->texture_dy[TEXTURE_TREES][i]);
    const float open =
        clamp(1.0f - 0.035f * light->hollow[0][i], 0.45f, 1.15f) *
        clamp(1.0f - 0.010f * light->hollow[1][i], 0.55f, 1.15f) *
        (1.0f - 0.35f * material.trees * clamp(light->texture[TEXTURE_TREES][i], 0.0f, 1.0f));
    const float facing = dot(normal, scene->sun);
    const float sun = light->sun[i] * (facing > 0.0f ? facing : 0.0f);
    const struct colour incoming = colour_sum(colour_scaled(scene->sunlight, sun),
                                              colour_scaled(sky_light(scene, normal), open * open));
    return colour_product(material.colour, incoming);
}

static void light_piece(struct light *light, const struct scene *scene, size_t band,
                        const struct rays *rays, struct colour *colours)
{
    place(light, scene, &scene->band[band], rays);
    sample_ground(light, scene, band, rays);
    sample_textures(light, scene, band);
    shade(light, scene, band);
    for (size_t i = 0; i < light->count; i++) {
        const uint32_t ray = light->ray[i];
        const struct vector direction = ray_of(rays, ray);
        struct colour colour;
        if (is_sea(light, scene, i)) {
            const struct water water = {.depth = scene->sea - light->bed[i],
                                        .distance = rays->distance[ray],
                                        .sun = light->sun[i],
                                        .dx = light->texture_dx[TEXTURE_WAVES][i],
                                        .dy = light->texture_dy[TEXTURE_WAVES][i]};
            colour = water_lit(scene, direction, &water);
        } else {
            colour = lit(light, scene, i);
        }
        colours[ray] = sky_haze(scene, direction, rays->distance[ray], colour);
    }
}

/* Clouds lie on a plane high above the camera; their light comes by the slope of their density. */
static void light_sky_piece(struct light *light, const struct scene *scene, const struct rays *rays,
                            struct colour *colours)
{
    float *const density = light->texture[TEXTURE_CLOUDS];
    for (size_t i = 0; i < light->count; i++) {
        const struct vector ray = ray_of(rays, light->point[i]);
        const float distance = CLOUD_HEIGHT / (ray.z > 0.01f ? ray.z : 0.01f);
        light->u[i] = scene->camera.x + (double)(ray.x * distance);
        light->v[i] = scene->camera.y + (double)(ray.y * distance);
    }
    texture_sample(TEXTURE_CLOUDS, 0.0f, light->count, light->u, light->v,
                   &(struct scarp_samples){.value = density,
                                           .dx = light->texture_dx[TEXTURE_CLOUDS],
                                           .dy = light->texture_dy[TEXTURE_CLOUDS]});
    count_call(light);
    for (size_t i = 0; i < light->count; i++) {
        const uint32_t n = light->point[i];
        const struct vector ray = ray_of(rays, n);
        const float rises = light->texture_dx[TEXTURE_CLOUDS][i] * scene->sun.x +
                            light->texture_dy[TEXTURE_CLOUDS][i] * scene->sun.y;
        const float lit = clamp(0.75f - 300.0f * rises, 0.0f, 1.3f);
        const float cloud = 0.85f * ramp(-0.02f, 0.55f, density[i]) * ramp(0.015f, 0.16f, ray.z);
        colours[n] = sky_cloudy(scene, ray, cloud, lit);
    }
}

static void light_sky(struct light *light, const struct scene *scene, const struct rays *rays,
                      struct colour *colours)
{
    light->count = 0;
    for (size_t i = 0; i < rays->count; i++) {
        if (rays->distance[i] == INFINITY) {
            light->point[light->count++] = (uint32_t)i;
        }
        if (light->count == LIGHT_MOST || (i + 1 == rays->count && light->count > 0)) {
            light_sky_piece(light, scene, rays, colours);
            light->count = 0;
        }
    }
}

void light_rays(struct light *light, const struct scene *scene, const struct rays *rays,
                struct colour *colours)
{
    light_sky(light, scene, rays, colours);
    for (size_t b = 0; b < BANDS; b++) {
        for (size_t i = rays->first_hit[b]; i < rays->first_hit[b + 1]; i += light->count) {
            const size_t left = rays->first_hit[b + 1] - i;
            light->count = left < LIGHT_MOST ? left : LIGHT_MOST;
            light->ray = rays->hit + i;
            light_piece(light, scene, b, rays, colours);
        }
    }
}
