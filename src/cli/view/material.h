/* SPDX-License-Identifier: MIT
 *
 * What the ground is covered with: meadows, trees, earth, rock, snow, sand.
 */
#ifndef SCARP_CLI_VIEW_MATERIAL_H
#define SCARP_CLI_VIEW_MATERIAL_H

#include "view/scene.h"

/* What decides it at a place */
struct site {
    float height;
    float slope, broad;                  /* the slope there, and that of the hill as a whole */
    float hollow;                        /* how far it lies below the hill as a whole, in units */
    float patches, rough, layers, trees; /* textures */
};

struct material {
    struct colour colour; /* the part of the light that it gives back */
    float roughness;      /* how much the rough texture bends its normals */
    float trees;          /* how much trees do */
};

struct material material_at(const struct scene *scene, const struct site *site);

#endif
