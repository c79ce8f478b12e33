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
enum sample_type {
    SAMPLE_U8 = 1,
    SAMPLE_U16_HIGH = 2, /* 16-bit integers, high byte first */
    SAMPLE_U16_LOW = 4,  /* and low byte first */
    SAMPLE_F32 = 8       /* 32-bit floats, low byte first */
};

#define MAX_CHANNELS 4

struct raster {
    size_t width, height;
    size_t channels; /* of a pixel; stored together */
    enum sample_type type;
    /* Where the centre of the top left pixel lies, x to the right and y up; distance of pixels */
    double x, y, step;
    const char *content; /* a word: "heights" */
    size_t times;        /* how often each pixel and each row is there; both sizes count that */
    unsigned epsg;       /* the number of the system of x and y in EPSG's list; 0: none */
};

struct writer;

/* What is packed together: rows, each of them once, which the format repeats; or a tile of them. */
struct part {
    const uint8_t *samples; /* its first one; before them the row above, or zeros without one */
    size_t row, rows;       /* which ones, counted before they are repeated */
    size_t column, columns; /* of these rows */
    uint8_t *bytes;         /* room for what becomes of them */
    size_t size;            /* what that took; 0: it failed */
    uint32_t sum;           /* the format's */
};

/* How rows are packed before they are written, by several threads at a time. The file depends on
   the raster only. */
struct packing {
    size_t (*part_rows)(const struct raster *raster); /* of every part but the last: 2^n */
    /* And columns; then parts go row by row through the raster. NULL: all of them */
    size_t (*part_columns)(const struct raster *raster);
    size_t (*room)(const struct raster *raster, size_t rows); /* bytes a part takes at most */
    void *(*open)(void); /* what a thread needs to pack; NULL without memory */
    void (*close)(void *packer);
    /* Packs a part to its bytes, and sets `size` and `sum`. */
    void (*pack)(void *packer, const struct raster *raster, struct part *part);
    /* Writes the next part. */
    bool (*write)(struct writer *writer, const struct part *part);
};

/* How a raster falls into parts, which are counted row by row */
struct parts {
    size_t rows, columns; /* of a part; at the right and at the bottom there may be fewer */
    size_t across;        /* side by side */
    size_t room;          /* bytes that a part takes at most */
};

struct parts parts_of(const struct packing *packing, const struct raster *raster);

/* Parts of `rows` rows */
size_t parts_count(const struct parts *parts, size_t rows);

/* Part number `n` of the rows from `first` on, whose samples begin at `samples`; its room is still
   to be set. */
struct part parts_at(const struct parts *parts, const struct raster *raster, const uint8_t *samples,
                     size_t first, size_t n);

/* Each function returns whether it succeeded; on failure errno may tell why. */
struct format {
    const char *name;                 /* also its extension, without the dot */
    unsigned types[MAX_CHANNELS + 1]; /* by channels: the types it takes, or'ed */
    bool needs_file;                  /* and not a pipe: not all is written in order */
    const char *overview; /* what GDAL adds to the name of a file for that of its next coarser
                             level; NULL: it knows none */
    /* Writes what comes before the first row. */
    bool (*open)(struct writer *writer);
    /* Writes `rows` rows, from `row` of the raster on; calls go from the top to the bottom. */
    bool (*write)(struct writer *writer, const uint8_t *samples, size_t row, size_t rows);
    const struct packing *packing; /* instead of `write`, or NULL */
    /* Writes what comes after the last row. NULL: nothing does. */
    bool (*end)(struct writer *writer);
    char *(*beside)(const char *path); /* the file that goes with it, which the caller frees; NULL:
                                          none does */
    /* How many bytes a file has. NULL: that is known when it is packed. */
    uint64_t (*bytes)(const struct raster *raster);
    /* Whether a file that took its name still is what was written there, as far as a look at its
       ends can tell, if its size is right. NULL: the size tells it. */
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
    void *memory;       /* the format's; freed with the writer */
};

size_t sample_bytes(enum sample_type type);
size_t raster_row_bytes(const struct raster *raster);

/* The `write` of formats that store samples as they come */
bool writer_write_raw(struct writer *writer, const uint8_t *samples, size_t row, size_t rows);

/* Of all samples. Formats that store nothing else have it as their `bytes`. */
uint64_t raster_bytes(const struct raster *raster);

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

/* How many bytes the file will have, if *is_exact; at most about so many, if not. */
uint64_t writer_bytes(const struct writer *writer, bool *is_exact);

#endif
