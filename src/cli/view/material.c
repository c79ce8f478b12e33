/* SPDX-License-Identifier: MIT
 *
 * Materials by height and slope, with borders that textures break: from the lowest layer to the
 * one on top of it.
 */
#include "view/material.h"

#define SHORE 2.2f      /* units of height that are sand */
#define ROUGH_MEAN 0.3f /* of the texture */
#define MAP 0.5f        /* what is given back of light where a map would be white */

/* What the material is made of; each is from 0 to 1. */
static struct material cover(struct material material, struct colour colour, float roughness,
                             float share)
{
    material.colour = colour_mix(material.colour, colour, share);
    material.roughness = mix(material.roughness, roughness, share);
    return material;
}

/* Layers, cracks between them, and regions of one kind of rock or another */
static struct material rock_at(const struct scene *scene, const struct site *site, float rough)
{
    const struct colours *const colours = &scene->colours;
    const float dark =
        clamp(0.5f + 1.0f * site->layers + 0.7f * site->patches - 0.8f * rough, 0.0f, 1.0f);
    return (struct material){colour_mix(colours->rock, colours->dark_rock, dark), 1.0f, 0.0f};
}

/* The colour that a file has for a height */
static struct material file_at(const struct palette *file, const struct site *site, float rough)
{
    const struct palette_stop *const stops = file->stops;
    size_t next = 0; /* the first stop above the height */
    while (next < file->count && stops[next].height <= site->height) {
        next++;
    }
    struct colour c = next == 0 ? file->below : file->above;
    if (next > 0 && next < file->count) {
        const struct palette_stop *const a = &stops[next - 1], *const b = &stops[next];
        c = colour_mix(a->colour, b->colour, (site->height - a->height) / (b->height - a->height));
    }
    c = colour_scaled(colour_product(c, c), MAP * (1.0f + 0.3f * rough));
    return (struct material){c, 0.6f, 0.0f};
}

struct material material_at(const struct scene *scene, const struct site *site)
{
    const struct colours *const colours = &scene->colours;
    const struct survey *const survey = &scene->survey;
    const float up = (site->height - survey->low) / (survey->high - survey->low);
    const float rough = site->rough - ROUGH_MEAN;
    if (colours->file != NULL) {
        return file_at(colours->file, site, rough);
    }
    const float broken = 0.7f * site->patches + 0.35f * rough;
    const float slope = 0.55f * site->slope + 0.45f * site->broad;
    struct material material = rock_at(scene, site, rough);

    /* Earth and debris where it is less steep, then grass, which the height makes dry. */
    const float bare = clamp(survey->steep, colours->bare[0], colours->bare[1]);
    const float steep = slope + 0.35f * bare * broken - 0.006f * site->hollow;
    material = cover(material, colour_scaled(colours->earth, 1.0f + 0.5f * broken), 0.7f,
                     ramp(1.05f * bare, 0.92f * bare, steep));
    const float dry = ramp(0.2f, 0.75f, up + 0.5f * broken);
    const struct colour grass =
        colour_scaled(colour_mix(colours->meadow, colours->dry, dry), 1.0f + 0.5f * rough);
    material = cover(material, grass, colours->meadow_rough,
                     ramp(0.90f * bare, 0.78f * bare, steep) * ramp(colours->meadow_end + 0.06f,
                                                                    colours->meadow_end - 0.06f,
                                                                    up + 0.25f * broken));

    /* Trees in places, below their line, not where it is steep or wet. */
    const float wood =
        ramp(-0.02f, 0.08f, site->patches - colours->woods + 0.25f * rough) *
        ramp(0.48f, 0.40f, up + 0.2f * rough) * ramp(0.85f * bare, 0.70f * bare, steep) *
        (scene->has_sea ? ramp(1.0f, 3.0f, (site->height - scene->sea) / SHORE) : 1.0f);
    const struct colour tree = colour_scaled(colours->forest, 1.15f - 0.4f * site->trees);
    material = cover(material, tree, 0.35f, wood);
    material.trees = wood;

    /* Snow lies where it is high, deeper in hollows, and slides off where it is steep. */
    const float least = colours->snow_least / (survey->high - survey->low);
    const float line = colours->snow_line > least ? colours->snow_line : least;
    const float cold = up + 0.16f * site->patches + 0.10f * rough + 0.003f * site->hollow;
    const float snow =
        ramp(line - 0.02f, line + 0.02f, cold) *
        ramp(1.2f * bare + 0.2f, 1.0f * bare + 0.1f, slope + 0.5f * rough - 0.6f * (cold - line));
    material = cover(material, colours->snow, 0.12f, snow);
    material.trees *= 1.0f - snow;

    if (scene->has_sea) {
        const float above = site->height - scene->sea + 1.2f * broken;
        material = cover(material, colours->sand, 0.15f,
                         ramp(SHORE, 0.5f * SHORE, above) * ramp(0.9f, 0.5f, slope));
    }
    return material;
}
