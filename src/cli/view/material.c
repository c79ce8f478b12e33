/* SPDX-License-Identifier: MIT
 *
 * Materials by height and slope, with borders that textures break: from the lowest layer to the
 * one on top of it.
 */
#include "view/material.h"

#define SHORE 2.2f /* units of height that are sand */

/* What the material is made of; each is from 0 to 1. */
static struct material cover(struct material material, struct colour colour, float roughness,
                             float share)
{
    material.colour = colour_mix(material.colour, colour, share);
    material.roughness = mix(material.roughness, roughness, share);
    return material;
}

static struct material rock_at(const struct scene *scene, const struct site *site)
{
    const struct colours *const colours = &scene->colours;
    const float dark = clamp(0.45f + 0.55f * site->layers + 0.35f * site->rough, 0.0f, 1.0f);
    const struct colour colour = colour_mix(colours->rock, colours->dark_rock, dark);
    return (struct material){colour_scaled(colour, 1.0f + 0.25f * site->patches), 1.0f, 0.0f};
}

struct material material_at(const struct scene *scene, const struct site *site)
{
    const struct colours *const colours = &scene->colours;
    const struct relief *const relief = &scene->relief;
    const float up = (site->height - relief->low) / (relief->high - relief->low);
    const float broken = 0.6f * site->patches + 0.25f * site->rough;
    const float slope = 0.55f * site->slope + 0.45f * site->broad;
    struct material material = rock_at(scene, site);

    /* Earth and debris where it is less steep, then grass, which the height makes dry. */
    const float bare = clamp(relief->steep, 0.45f, 1.0f);
    const float steep = slope + 0.22f * bare * broken - 0.006f * site->hollow;
    material = cover(material, colour_scaled(colours->earth, 1.0f + 0.35f * broken), 0.7f,
                     ramp(1.1f * bare, 0.85f * bare, steep));
    const float dry = ramp(0.25f, 0.75f, up + 0.35f * broken);
    const struct colour grass = colour_scaled(colour_mix(colours->meadow, colours->dry_grass, dry),
                                              1.0f + 0.3f * site->rough);
    material =
        cover(material, grass, 0.45f,
              ramp(0.95f * bare, 0.7f * bare, steep) * ramp(0.86f, 0.66f, up + 0.16f * broken));

    /* Trees in places, below their line, not where it is steep or wet. */
    const float wood =
        ramp(-0.02f, 0.10f, site->patches - 0.12f) * ramp(0.50f, 0.40f, up + 0.14f * site->rough) *
        ramp(0.85f * bare, 0.65f * bare, steep) *
        (scene->has_sea ? ramp(1.0f, 3.0f, (site->height - scene->sea) / SHORE) : 1.0f);
    const struct colour tree = colour_scaled(colours->forest, 1.25f - 0.6f * site->trees);
    material = cover(material, tree, 0.35f, wood);
    material.trees = wood;

    /* Snow lies where it is high, deeper in hollows, and slides off where it is steep. */
    const float cold = up + 0.10f * site->patches + 0.03f * site->rough + 0.003f * site->hollow;
    const float snow = ramp(0.64f, 0.74f, cold) *
                       ramp(1.25f * bare + 0.25f, 0.9f * bare + 0.1f, slope + 0.25f * site->rough);
    material = cover(material, colours->snow, 0.12f, snow);
    material.trees *= 1.0f - snow;

    if (scene->has_sea) {
        const float above = site->height - scene->sea + 1.2f * broken;
        material = cover(material, colours->sand, 0.15f,
                         ramp(SHORE, 0.5f * SHORE, above) * ramp(0.9f, 0.5f, slope));
    }
    return material;
}
