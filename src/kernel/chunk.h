/* SPDX-License-Identifier: MIT
 *
 * Chunks of a call whose positions are displaced before noise is computed there: some samples, with
 * arrays of their own for positions and for what is between the passes. The passes get what is left
 * of the scratch space.
 */
#ifndef SCARP_KERNEL_CHUNK_H
#define SCARP_KERNEL_CHUNK_H

#include "grid.h"

/* The most samples of a chunk; of one that is rows of a grid the most samples of a row, and the
   most rows. */
#define CHUNK_SAMPLES ((size_t)1408)
#define CHUNK_COLUMNS ((size_t)128)
#define CHUNK_ROWS ((size_t)32)

/* Where the samples of a call are: points, or a grid. */
struct source {
    const void *const *position;
    const struct scarp_grid *grid; /* NULL: points */
};

/* Some of them: points from at[0] on, which are one row, or rows of a slice of the grid. */
struct chunk {
    size_t at[3], columns, rows;
    size_t pitch; /* from a row to the next, in samples */
};

/* What a chunk keeps of the coordinates it begins with: nothing, as the caller's arrays have whole
   blocks; those of each sample; or, of a grid of doubles, those of each column, each row and the
   slice. Floats are displaced where they are kept. */
enum keep { KEEP_NONE, KEEP_SAMPLES, KEEP_ROWS };

/* What all chunks of a call share. Arrays have `most` elements. */
struct chunked {
    struct source source;
    struct frame f; /* how the coordinates are given: FLOATS or DOUBLES */
    enum keep keep;
    int copies;              /* whether coordinates are always copied: outputs may be there */
    size_t most;             /* samples of a chunk: whole blocks */
    void *position[3];       /* what is kept */
    const void *input[3];    /* of the chunk: where the caller has it, or `position` */
    struct workspace passes; /* what the passes have */
};

/* The samples of a chunk, with what is between rows. */
static size_t chunk_count(const struct chunk *chunk)
{
    return chunk->rows * chunk->pitch;
}

static size_t whole_blocks(size_t count)
{
    return (count + VEC_LANES - 1) / VEC_LANES * VEC_LANES;
}

/* What is kept of the coordinates of so many points. */
static enum keep keep_of(enum layout layout, size_t count)
{
    return layout == DOUBLES && count % VEC_LANES == 0 ? KEEP_NONE : KEEP_SAMPLES;
}

/* Floats that are kept along an axis. Coordinates of grids may be a vector more. */
static size_t kept_size(const struct chunked *w, int axis)
{
    const size_t rows[3] = {CHUNK_COLUMNS, CHUNK_ROWS, VEC_LANES};
    const size_t count = w->keep == KEEP_ROWS      ? rows[axis]
                         : w->keep == KEEP_SAMPLES ? w->most + VEC_LANES
                                                   : 0;
    return count * (w->f.layout == DOUBLES ? 2 : 1);
}

/* Decides how large chunks are that have `arrays` floats for each sample besides the coordinates,
   and takes these. The arrays have somewhat more than half of the space. Returns where the rest of
   it begins. */
static float *chunked_begin(struct chunked *w, struct workspace work, size_t arrays)
{
    const size_t doubles = w->f.layout == DOUBLES ? 2 : 1;
    const size_t kept = w->keep == KEEP_SAMPLES ? (size_t)w->f.dimensions * doubles : 0;
    const size_t blocks = work.vectors * 19 / 32 / (arrays + kept);
    float *from = (float *)work.space;
    w->most = least(blocks > 0 ? blocks : 1, CHUNK_SAMPLES / VEC_LANES) * VEC_LANES;
    for (int i = 0; i < w->f.dimensions; i++) {
        w->position[i] = from;
        from += kept_size(w, i);
    }
    return from;
}

/* Leaves what begins at `from` to the passes. */
static void chunked_end(struct chunked *w, struct workspace work, float *from)
{
    w->passes.space = (vf *)from;
    w->passes.vectors = work.vectors - (size_t)(w->passes.space - work.space);
}

/* Takes arrays for samples of that order from the space at *from. */
static void take_arrays(struct scarp_outputs *arrays, float **from, size_t most, int dimensions,
                        int order)
{
    for (int i = 0; i < OUTPUTS; i++) {
        const int has = i < OUTPUTS_UP_TO(order) &&
                        (dimensions == 3 || (i != DZ && i != DXZ && i != DYZ && i != DZZ));
        arrays->array[i] = has ? *from : NULL;
        *from += has ? most : 0;
    }
}

/* Copies `count` doubles, and up to a vector more. */
VEC_INLINE void copy_doubles(double *to, const double *from, size_t count)
{
    for (size_t i = 0; i < count; i += VEC_LANES / 2) {
        const vd x = vd_load(from + i);
        memcpy(to + i, &x, sizeof x);
    }
}

/* Puts a number `count` times, and up to a vector more. */
VEC_INLINE void fill_doubles(double *to, double number, size_t count)
{
    const vd x = vd_set(number);
    for (size_t i = 0; i < count; i += VEC_LANES / 2) {
        memcpy(to + i, &x, sizeof x);
    }
}

/* Fills in the coordinates of a chunk of a grid along an axis, and up to a vector more. */
static void grid_coordinates(double *to, const struct scarp_grid *grid, const struct chunk *chunk,
                             int axis)
{
    const size_t columns = chunk->columns;
    for (size_t i = 0; axis == 0 && i < columns; i++) {
        to[i] = coordinate(grid, 0, chunk->at[0] + i);
    }
    for (size_t r = axis == 0; r < chunk->rows; r++) {
        if (axis == 0) {
            copy_doubles(to + r * columns, to, columns);
        } else {
            const size_t at = chunk->at[axis] + (axis == 1 ? r : 0);
            fill_doubles(to + r * columns, coordinate(grid, axis, at), columns);
        }
    }
}

/* Fills in the coordinates of the columns, the rows and the slice of a chunk of a grid, each padded
   to whole blocks with copies of the last one. */
static void row_coordinates(struct chunked *w, const struct chunk *chunk)
{
    const struct scarp_grid *const grid = w->source.grid;
    const size_t counts[3] = {chunk->columns, chunk->rows, 1};
    for (int axis = 0; axis < w->f.dimensions; axis++) {
        double *const to = w->position[axis];
        for (size_t i = 0; i < counts[axis]; i += VEC_LANES) {
            block_coordinates(to + i, grid, axis, chunk->at[axis] + i, counts[axis] - i);
        }
        w->input[axis] = to;
    }
}

/* Finds the coordinates that a chunk begins with. Where samples are kept that are not whole blocks
   of points, coordinates are copied, and padded. */
static void find_input(struct chunked *w, const struct chunk *chunk)
{
    const size_t count = chunk_count(chunk), end = whole_blocks(count);
    const size_t bytes = w->f.layout == DOUBLES ? sizeof(double) : sizeof(float);
    if (w->keep == KEEP_ROWS) {
        row_coordinates(w, chunk);
        return;
    }
    for (int axis = 0; axis < w->f.dimensions; axis++) {
        char *const to = (char *)w->position[axis];
        w->input[axis] = to;
        if (w->source.grid == NULL && count == end && !w->copies) {
            w->input[axis] = (const char *)w->source.position[axis] + chunk->at[0] * bytes;
            continue;
        }
        if (w->source.grid != NULL) {
            grid_coordinates((double *)w->position[axis], w->source.grid, chunk, axis);
        } else {
            memcpy(to, (const char *)w->source.position[axis] + chunk->at[0] * bytes,
                   count * bytes);
        }
        for (size_t i = count; i < end; i++) {
            memcpy(to + i * bytes, to + (count - 1) * bytes, bytes);
        }
    }
}

/* Sets the positions at a block of floats to the displaced input. */
VEC_INLINE void displace(const struct chunked *w, int axis, size_t at, vf by)
{
    const vf x = vf_load((const float *)w->input[axis] + at);
    vf_store((float *)w->position[axis] + at, x + by);
}

/* Describes the positions of a chunk of doubles that is displaced by `by`, for passes over MOVED
   positions. */
static void moved_input(struct moved_axis axis[3], const struct chunked *w,
                        const struct chunk *chunk, const float *const by[3])
{
    for (int i = 0; i < w->f.dimensions; i++) {
        axis[i].x = w->input[i];
        axis[i].by = by[i];
        axis[i].row_blocks = w->keep == KEEP_ROWS ? chunk->pitch / VEC_LANES : 0;
    }
}

VEC_INLINE struct sample sample_at(const struct scarp_outputs *arrays, size_t at, struct variant v)
{
    struct sample s;
#define DO(i, member, rank) s.member = vf_load(arrays->array[i] + at)
    EACH_OUTPUT(v, DO);
#undef DO
    return s;
}

#endif
