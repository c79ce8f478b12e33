/* SPDX-License-Identifier: MIT
 *
 * File names of tiles: patterns such as w/{y}/{x}.png, or plain names, which get _y_x before their
 * extension. {x} and {y} count from the top left, {-y} from the bottom, {level} from the finest and
 * {-level} from the coarsest level, all from 0; {x:04} has four digits at least. Names without a
 * level get -levelN before their extension, but for level 0.
 */
#ifndef SCARP_CLI_PATTERN_H
#define SCARP_CLI_PATTERN_H

#include <stdbool.h>
#include <stddef.h>

#include "terrain/tiling.h"

/* Whether there is a placeholder in `path`, and whether one is for the level. */
bool pattern_is(const char *path);
bool pattern_has_level(const char *path);

/* Whether `path` can name the tiles of a raster, or the raster without tiles. If not, prints why on
   stderr in one line that begins with `option`. */
bool pattern_check(const char *path, const struct tiling *tiling, const char *option);

/* All return memory that the caller frees; NULL without. */

/* The name of a tile. */
char *pattern_expand(const char *path, const struct tile *tile);

/* The pattern that a plain name stands for; a pattern itself as it is. */
char *pattern_of(const char *path, bool numbered);

/* A name for what is said of all tiles: PATH.json of a plain name. Of a pattern, the directory
   without placeholders, and the rest as one word: w/y_x.png.json. */
char *pattern_manifest(const char *path);

#endif
