/* SPDX-License-Identifier: MIT
 *
 * Rasters written row by row, top row first, in one of several formats. Each format is a file of
 * its own; formats.h lists them.
 */
#ifndef SCARP_CLI_WRITER_H
#define SCARP_CLI_WRITER_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "shared/file.h"

/* How a sample is stored. A format may take several. */
enum sample_kind {
    SAMPLE_U8 = 1,
    SAMPLE_U16_HIGH = 2, /* 16-bit integers, high byte first */
    SAMPLE_U16_LOW = 4,  /* and low byte first */
    SAMPLE_F32 = 8       /* 32-bit floats, low byte first */
};

#define MAX_CHANNELS 3

struct raster {
    size_t width, height;
    size_t channels; /* of a pixel; stored together */
    enum sample_kind kind;
    /* Where the centre of the top left pixel lies, x to the right and y up; distance of pixels */
    double x, y, step;
    const char *content; /* a word: "heights" */
    size_t times;        /* how often each pixel and each row is there; both sizes count that */
};

struct writer;

/* Rows of a raster that are packed together, each of them once: the format repeats them. */
struct part {
    const uint8_t *samples; /* of its rows; before them the row above, or zeros if there is none */
    size_t row, rows;       /* which ones, counted before they are repeated */
    uint8_t *bytes;         /* room for what becomes of them */
    size_t size;            /* what that took; 0: it failed */
    uint32_t sum;           /* the format's */
};

/* How rows are packed before they are written, by several threads at a time. The file depends on
   the raster alone. */
struct packing {
    size_t (*part_rows)(const struct raster *raster);         /* of every part but the last: 2^n */
    size_t (*room)(const struct raster *raster, size_t rows); /* bytes that `rows` take at most */
    void *(*open)(void); /* what a thread needs to pack; NULL without memory */
    void (*close)(void *packer);
    /* Packs a part to its bytes, and sets `size` and `sum`. */
    void (*pack)(void *packer, const struct raster *raster, struct part *part);
    /* Writes the next part from the top. */
    bool (*write)(struct writer *writer, const struct part *part);
};

/* Each function returns whether it succeeded; on failure errno may tell why. */
struct format {
    const char *name;                 /* also its extension, without the dot */
    unsigned kinds[MAX_CHANNELS + 1]; /* by channels: the kinds it takes, or'ed */
    bool needs_file;                  /* and not a pipe: not all is written in order */
    /* Writes what stands before the first row. */
    bool (*open)(struct writer *writer);
    /* Writes `rows` rows, from `row` of the raster on; calls go from the top to the bottom. */
    bool (*write)(struct writer *writer, const uint8_t *samples, size_t row, size_t rows);
    const struct packing *packing; /* instead of `write`, or NULL */
    /* Writes what stands after the last row. NULL: nothing does. */
    bool (*end)(struct writer *writer);
    /* Whether a file that took its name still is what was written there, as far as a look at its
       size or its ends can tell. */
    bool (*is_whole)(const struct raster *raster, const char *path);
};

/* Zero-initialise, set the first four members, open. */
struct writer {
    struct raster raster;
    const struct format *format;
    const char *path;
    bool makes_directories; /* those that lead to the file */
    struct file file;
    struct file header; /* of ENVI; elsewhere not used */
    uint32_t sum;       /* the format's */
};

size_t sample_bytes(enum sample_kind kind);
size_t raster_row_bytes(const struct raster *raster);

/* The `write` of formats that store samples as they come */
bool writer_write_raw(struct writer *writer, const uint8_t *samples, size_t row, size_t rows);

/* For `is_whole`: whether the file holds `before` bytes, the samples and nothing else */
bool writer_has_size(const struct raster *raster, const char *path, size_t before);

/* All return whether they succeeded; on failure errno may tell why. */
bool writer_open(struct writer *writer);
bool writer_write(struct writer *writer, const uint8_t *samples, size_t row, size_t rows);
bool writer_write_part(struct writer *writer, const struct part *part); /* if the format packs */
bool writer_close(struct writer *writer); /* completes the file, still under its unfinished name */
bool writer_publish(struct writer *writer);
void writer_retract(struct writer *writer);      /* see file_retract */
bool writer_settle(const struct writer *writer); /* its name survives a power cut */

/* Frees the writer. Unless its file was published, it is removed. May be called at any time after
   zero-initialisation. */
void writer_discard(struct writer *writer);

/* Whether two open writers write one file. */
bool writer_is_same(const struct writer *a, const struct writer *b);

/* Whether the raster is there, whole, under its final name, and was not written before `since`. */
bool writer_is_there(const struct writer *writer, struct file_time since);

#endif
