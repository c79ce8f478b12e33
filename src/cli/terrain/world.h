/* SPDX-License-Identifier: MIT
 *
 * The manifest of a terrain: everything that its files depend on.
 */
#ifndef SCARP_CLI_WORLD_H
#define SCARP_CLI_WORLD_H

#include "terrain/manifest.h"
#include "terrain/outputs.h"
#include "terrain/terrain_options.h"

/* Makes the manifest beside the first of the outputs, or compares this run with it. Returns an exit
   status, after a line on stderr if it is not CLI_SUCCESS. */
int world_open(struct manifest *manifest, const struct terrain_options *options,
               const struct surface *surface, const struct tiling *tiling,
               const struct outputs *outputs);

#endif
