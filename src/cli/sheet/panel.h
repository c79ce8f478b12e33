/* SPDX-License-Identifier: MIT
 *
 * A panel of a sheet: a small map of a terrain.
 */
#ifndef SCARP_CLI_PANEL_H
#define SCARP_CLI_PANEL_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "look/palette.h"
#include "raster/surface.h"
#include "sheet/axes.h"
#include "sheet/sheet_options.h"

#define PANEL_BAND 8 /* rows of pixels that are drawn at once */
#define PANEL_LABEL_SIZE (2 * (AXIS_NAME_SIZE + AXIS_VALUE_SIZE) + 4)

struct panel {
    struct sheet_options options;
    struct surface surface; /* its samples: `samples` times as many as pixels each way */
    struct palette palette;
    char *typed[AXES_MAX]; /* the options of its values, to which the others may point */
};

/* Makes a panel of the command line `argv`, which ends with NULL and may ask for a recipe, and of
   the value number at[i] of each axis i. False, with a line on stderr, if these do not go together.
   Free it in any case. */
bool panel_make(struct panel *panel, char **argv, bool has_recipe, const struct axes *axes,
                const size_t *at);
void panel_free(struct panel *panel);

/* Draws PANEL_BAND rows of pixels, or what is left of them, from `row` on. `to` is where the panel's
   top left pixel goes, three bytes each, with `stride` bytes from row to row. False without memory.
 */
bool panel_draw(const struct panel *panel, size_t row, uint8_t *to, size_t stride);

#endif
