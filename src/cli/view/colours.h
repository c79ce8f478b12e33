/* SPDX-License-Identifier: MIT
 *
 * The colours of the ground, in one place: reflectances in linear light.
 */
#ifndef SCARP_CLI_VIEW_COLOURS_H
#define SCARP_CLI_VIEW_COLOURS_H

#include "view/maths.h"

struct colours {
    struct colour meadow, dry_grass, forest; /* from the valleys up to the tree line */
    struct colour earth;                     /* between grass and rock */
    struct colour rock, dark_rock;           /* layers of it */
    struct colour snow;
    struct colour sand;             /* along the shore */
    struct colour shallows, depths; /* of the sea */
};

extern const struct colours colours_alpine;

#endif
