/* SPDX-License-Identifier: MIT
 *
 * Pictures written row by row, top row first. A picture is built under a temporary name beside its
 * own and takes its own name when all of it is on disk: a run that fails leaves no half pictures,
 * and older ones as they were. Included by the command that makes pictures and by the formats.
 */
#ifndef SCARP_CLI_IMAGE_H
#define SCARP_CLI_IMAGE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

struct image;

/* A file format. Each function returns whether it succeeded; on failure errno may tell why. */
struct image_format {
    const char *grey_extension, *colour_extension;
    /* Writes what stands before the first row. */
    bool (*open)(struct image *image);
    /* Writes width * channels samples: bytes, or 16-bit numbers with the high byte first. */
    bool (*row)(struct image *image, const uint8_t *samples);
    /* Writes what stands after the last row if `complete`, and frees `state` in any case. */
    bool (*close)(struct image *image, bool complete);
};

extern const struct image_format image_pnm; /* binary PGM (grey) and PPM (colour) */
#ifdef SCARP_CLI_PNG
extern const struct image_format image_png;
const char *image_png_version(void); /* of libpng */
#endif

/* Zero-initialise, set the first five members, open. */
struct image {
    const char *name; /* what the file holds: "height" gives STEM-height.png */
    size_t width, height;
    int channels, depth; /* 1: grey, 3: red, green, blue; 8 or 16 bits */
    /* Private to image.c and the format: */
    const struct image_format *format;
    FILE *file;
    void *state;
    char *path, *partial;    /* the final and the temporary name */
    bool created, published; /* under the temporary, under the final name */
};

/* All return whether they succeeded; on failure errno may tell why. */
bool image_open(struct image *image, const char *stem);
bool image_row(struct image *image, const uint8_t *samples);
bool image_close(struct image *image); /* completes the file, still under its temporary name */
bool image_publish(struct image *image);

/* Frees the picture. Unless `keep`, the file is removed, published or not. May be called at any
   time after zero-initialisation. */
void image_discard(struct image *image, bool keep);

#endif
