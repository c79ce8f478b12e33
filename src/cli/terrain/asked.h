/* SPDX-License-Identifier: MIT
 *
 * From the options to the list of products: which files were asked for, and whether the recipe and
 * the formats have what they need.
 */
#ifndef SCARP_CLI_ASKED_H
#define SCARP_CLI_ASKED_H

#include <stdbool.h>
#include <stddef.h>

#include "ground/source.h"
#include "raster/surface.h"
#include "terrain/products.h"
#include "terrain/terrain_options.h"

#define ASKED_NAME_MOST 255

/* Outputs of the recipe by name */
struct asked {
    struct asked_field {
        char name[ASKED_NAME_MOST + 1];
        const char *file;
        size_t number; /* among the fields of the ground */
    } fields[GROUND_FIELDS_MOST];
    size_t count;
};

/* Each returns false, with a line on stderr, if something is wrong. */

/* Reads the texts NAME=FILE, sorts them, so that their order does not matter, and asks the source
   for the products. */
bool asked_read(struct asked *asked, const struct option_list *list, struct source *source);

/* Adds all files that the options ask for. */
bool asked_products(const struct terrain_options *options, const struct asked *asked,
                    struct products *products);

/* Whether the ground has what the products are made of, and the files a place for --crs */
bool asked_check(const struct products *products, const struct surface *surface);

#endif
