/* SPDX-License-Identifier: MIT
 *
 * The outputs at a block of VEC_LANES points, and where they come from and go to: what the stages
 * hand to each other.
 */
#ifndef SCARP_KERNEL_SAMPLE_H
#define SCARP_KERNEL_SAMPLE_H

#include "../plan/call.h"
#include "../plan/outputs.h"

/* What a pass is compiled for; a constant wherever it is passed on. */
struct variant {
    enum scarp_basis basis;
    int dimensions, order; /* order: the highest derivative */
    int flows;             /* whether gradients come from tables that the phase turned */
};

/* Members beyond the order and the dimensions of the variant are unset. */
struct sample {
    vf value, dx, dy, dz, dxx, dxy, dxz, dyy, dyz, dzz;
};

/* DO(output, member of struct sample, order of the output) for the outputs of variant v. */
#define EACH_OUTPUT(v, DO)                                                                         \
    do {                                                                                           \
        DO(VALUE, value, 0);                                                                       \
        if ((v).order >= 1) {                                                                      \
            DO(DX, dx, 1);                                                                         \
            DO(DY, dy, 1);                                                                         \
            if ((v).dimensions == 3) {                                                             \
                DO(DZ, dz, 1);                                                                     \
            }                                                                                      \
        }                                                                                          \
        if ((v).order >= 2) {                                                                      \
            DO(DXX, dxx, 2);                                                                       \
            DO(DXY, dxy, 2);                                                                       \
            DO(DYY, dyy, 2);                                                                       \
            if ((v).dimensions == 3) {                                                             \
                DO(DXZ, dxz, 2);                                                                   \
                DO(DYZ, dyz, 2);                                                                   \
                DO(DZZ, dzz, 2);                                                                   \
            }                                                                                      \
        }                                                                                          \
    } while (0)

/* Vectors of a sample that is stored without its unset members. */
VEC_INLINE size_t sample_size(int dimensions, int order)
{
    static const unsigned char sizes[2][3] = {{1, 3, 6}, {1, 4, 10}};
    return sizes[dimensions - 2][order];
}

/* Where an output is in a stored sample. */
VEC_INLINE int stored_at(int output, int dimensions)
{
    return dimensions == 3 || output < DZ ? output : output == DYY ? 5 : output - 1;
}

VEC_INLINE struct sample sample_load(const vf *stored, struct variant v)
{
    struct sample s;
#define DO(i, member, rank) s.member = stored[stored_at(i, v.dimensions)]
    EACH_OUTPUT(v, DO);
#undef DO
    return s;
}

VEC_INLINE void sample_store(vf *stored, const struct sample *s, struct variant v)
{
#define DO(i, member, rank) stored[stored_at(i, v.dimensions)] = s->member
    EACH_OUTPUT(v, DO);
#undef DO
}

/* Where samples are, or go. Block b of row r of output i is at array[i] + r * row[i] + b * block
   floats. An output that nobody asked for has one row, which all rows share. */
struct outputs {
    float *array[OUTPUTS];
    size_t row[OUTPUTS];
    size_t block;
};

/* The size of a tile. */
struct extent {
    size_t rows, blocks; /* blocks of each row */
};

/* Copies what a pass of that variant uses: nothing that it stores can alias a copy. Where one
   function serves all orders, all is copied: gcc warns of what lies behind a comparison with the
   order. */
VEC_INLINE void outputs_copy(struct outputs *to, const struct outputs *from, struct variant v)
{
#if VEC_SMALL
    (void)v;
    *to = *from;
#else
#define DO(i, member, rank) to->array[i] = from->array[i], to->row[i] = from->row[i]
    EACH_OUTPUT(v, DO);
#undef DO
    to->block = from->block;
#endif
}

/* Moves on by a row. */
VEC_INLINE void outputs_next_row(struct outputs *outputs, struct variant v)
{
#define DO(i, member, rank) outputs->array[i] += outputs->row[i]
    EACH_OUTPUT(v, DO);
#undef DO
}

/* Moves on by `rows` rows, or back if they are negative. */
static __attribute__((noinline)) void outputs_move(struct outputs *outputs, int order,
                                                   ptrdiff_t rows)
{
    for (int i = 0; i < OUTPUTS_UP_TO(order); i++) {
        outputs->array[i] += rows * (ptrdiff_t)outputs->row[i];
    }
    outputs->array[DPHASE] += rows * (ptrdiff_t)outputs->row[DPHASE];
}

/* Describes samples of `size` vectors that are stored one after the other, `blocks` to a row.
   DPHASE, if they have it, is their last vector. (This and outputs_of fill in a structure instead
   of returning it: copying it in wide vectors waits until what was written in narrow ones has left
   the core.) */
static __attribute__((noinline)) void outputs_stored(struct outputs *to, vf *stored, size_t size,
                                                     int dimensions, int order, size_t blocks)
{
    to->block = size * VEC_LANES;
    to->array[DPHASE] = (float *)(stored + (size > 0 ? size - 1 : 0));
    to->row[DPHASE] = blocks * to->block;
    for (int i = 0; i < OUTPUTS_UP_TO(order); i++) {
        to->array[i] = (float *)(stored + stored_at(i, dimensions));
        to->row[i] = blocks * to->block;
    }
}

/* Describes the caller's array of an output from sample `first` on, with rows `row` floats apart;
   or `spare`, if nobody asked for the output. */
VEC_INLINE void output_of(struct outputs *to, const struct scarp_outputs *out, int i, size_t first,
                          size_t row, vf *spare)
{
    const int asked = out->array[i] != NULL;
    to->array[i] = asked ? out->array[i] + first : (float *)spare;
    to->row[i] = asked ? row : 0;
}

static __attribute__((noinline)) void outputs_of_order(struct outputs *to,
                                                       const struct scarp_outputs *out, int order,
                                                       size_t first, size_t row, vf *spare)
{
    for (int i = 0; i < OUTPUTS_UP_TO(order); i++) {
        output_of(to, out, i, first, row, spare);
    }
}

/* Describes the caller's arrays from sample `first` on, whose rows are `row` floats apart. `spare`,
   which has room for a row, takes what nobody asked for. */
VEC_INLINE void outputs_of(struct outputs *to, const struct scarp_outputs *out, int order,
                           size_t first, size_t row, vf *spare)
{
    to->block = VEC_LANES;
    output_of(to, out, VALUE, first, row, spare);
    output_of(to, out, DPHASE, first, row, spare);
    if (order > 0) { /* out of line for the sake of size */
        outputs_of_order(to, out, order, first, row, spare);
    }
}

/* Describes where DPHASE goes, as where values go. */
static void outputs_of_phase(struct outputs *to, const struct outputs *of)
{
    to->block = of->block;
    to->array[VALUE] = of->array[DPHASE];
    to->row[VALUE] = of->row[DPHASE];
}

/* What values, gradients and Hessians are multiplied by. */
struct weights {
    float factor[3];
};

/* How samples are put: added to what is there, stored, or stored past the caches. PUT_STREAM serves
   rows of single octaves whose arrays are aligned to a vector and too large for the caches, where
   an ordinary store would first fetch what it is about to replace. */
enum put { PUT_ADD, PUT_FIRST, PUT_STREAM };

VEC_INLINE void put_block(float *to, vf term, enum put put)
{
    if (put == PUT_STREAM) {
        vf_stream(to, term);
    } else {
        vf_store(to, put == PUT_FIRST ? term : vf_load(to) + term);
    }
}

/* Puts weights * s at a block, `at` floats from the beginning of the row. */
VEC_INLINE void put_sample(const struct outputs *to, size_t at, const struct weights *w,
                           const struct sample *s, struct variant v, enum put put)
{
#define DO(i, member, rank) put_block(to->array[i] + at, vf_set(w->factor[rank]) * s->member, put)
    EACH_OUTPUT(v, DO);
#undef DO
}

/* Puts weights * s at a block where `put` is no constant. The branch goes the same way in a whole
   pass; a loop for each would multiply the code. */
VEC_INLINE void put_any_sample(const struct outputs *to, size_t at, const struct weights *w,
                               const struct sample *s, struct variant v, enum put put)
{
    if (put == PUT_ADD) {
        put_sample(to, at, w, s, v, PUT_ADD);
    } else if (put == PUT_FIRST) {
        put_sample(to, at, w, s, v, PUT_FIRST);
    } else {
        put_sample(to, at, w, s, v, PUT_STREAM);
    }
}

/* Adds or stores weights * s. */
VEC_INLINE void add_sample(const struct outputs *to, size_t at, const struct weights *w,
                           const struct sample *s, struct variant v, enum put put)
{
    put_any_sample(to, at, w, s, v, put == PUT_ADD ? PUT_ADD : PUT_FIRST);
}

#endif
