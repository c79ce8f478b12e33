/* SPDX-License-Identifier: MIT
 *
 * PGM and PPM in their binary forms (P5, P6): a header in text, then the samples, 16-bit ones with
 * the high byte first. Every image program reads them, and nothing but libc is needed.
 */
#include "image.h"

static bool pnm_open(struct image *image)
{
    const int maximum = (1 << image->depth) - 1;
    return fprintf(image->file, "P%c\n%zu %zu\n%d\n", image->channels == 1 ? '5' : '6',
                   image->width, image->height, maximum) > 0;
}

static bool pnm_row(struct image *image, const uint8_t *samples)
{
    const size_t bytes = image->width * (size_t)(image->channels * image->depth / 8);
    return fwrite(samples, 1, bytes, image->file) == bytes;
}

static bool pnm_close(struct image *image, bool complete)
{
    (void)image;
    (void)complete;
    return true;
}

const struct image_format image_pnm = {
    .grey_extension = ".pgm",
    .colour_extension = ".ppm",
    .open = pnm_open,
    .row = pnm_row,
    .close = pnm_close,
};
