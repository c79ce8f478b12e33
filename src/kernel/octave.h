/* SPDX-License-Identifier: MIT
 *
 * Second pass over a chunk of points (see points.h): one octave of noise from corner hashes and
 * fractions, scaled and added to rows of sums. Included by lines.h and turn.h.
 */
#ifndef SCARP_KERNEL_OCTAVE_H
#define SCARP_KERNEL_OCTAVE_H

#include "gradient.h"
#include "value.h"

/* What the value, the gradient and the Hessian of the basis are multiplied by. */
struct weights {
    float amplitude, slope, curvature;
};

/* A row for every output of struct scarp_samples, in their order. */
enum { VALUE, DX, DY, DZ, DXX, DXY, DXZ, DYY, DYZ, DZZ, ROWS };

struct rows {
    vf row[ROWS][CHUNK_BLOCKS];
};

/* to = from + weights * basis, for every row up to the order of the pass; where `from` is NULL, to
   = weights * basis. The rows of `from` and `to` are all there, hold whole blocks, and may be the
   same. */
typedef void octave_pass(const struct lattice *lattice, size_t blocks, enum scarp_fade fade,
                         const struct weights *weights, const struct scarp_samples *from,
                         const struct scarp_samples *to);

/* `first` of an octave that is the only one, at rows that are aligned to a vector and too many for
   the caches, where an ordinary store would first fetch what it is about to replace. */
enum { STREAM = 2 };

/* `from` is not looked at if this is the first octave. */
VEC_INLINE void add(float *to, int first, const float *from, size_t b, vf term)
{
    if (first == STREAM) {
        vf_stream(to + b * VEC_LANES, term);
        return;
    }
    vf_store(to + b * VEC_LANES, first ? term : vf_load(from + b * VEC_LANES) + term);
}

/* to = from + weights * s at a block of points. */
VEC_INLINE void add_sample(const struct scarp_samples *to, int first,
                           const struct scarp_samples *from, size_t b, const struct sample *s,
                           const struct weights *weights, int dimensions, int order)
{
    const vf amplitude = vf_set(weights->amplitude);
    const vf slope = vf_set(weights->slope);
    const vf curvature = vf_set(weights->curvature);
    add(to->value, first, from->value, b, amplitude * s->value);
    if (order >= 1) {
        add(to->dx, first, from->dx, b, slope * s->dx);
        add(to->dy, first, from->dy, b, slope * s->dy);
        if (dimensions == 3) {
            add(to->dz, first, from->dz, b, slope * s->dz);
        }
    }
    if (order >= 2) {
        add(to->dxx, first, from->dxx, b, curvature * s->dxx);
        add(to->dxy, first, from->dxy, b, curvature * s->dxy);
        add(to->dyy, first, from->dyy, b, curvature * s->dyy);
        if (dimensions == 3) {
            add(to->dxz, first, from->dxz, b, curvature * s->dxz);
            add(to->dyz, first, from->dyz, b, curvature * s->dyz);
            add(to->dzz, first, from->dzz, b, curvature * s->dzz);
        }
    }
}

/* A copy of the rows, which nothing that is stored can alias; of `from` NULL, of none. */
VEC_INLINE struct scarp_samples rows_of(const struct scarp_samples *rows)
{
    static const struct scarp_samples none; /* all NULL */
    return rows != NULL ? *rows : none;
}

VEC_INLINE struct sample basis_at(const struct lattice *lattice, size_t b, enum scarp_fade fade,
                                  enum scarp_basis basis, int dimensions, int order)
{
    if (basis == SCARP_GRADIENT) {
        return dimensions == 2 ? gradient2(lattice, b, fade, order)
                               : gradient3(lattice, b, fade, order);
    }
    return dimensions == 2 ? value2(lattice, b, fade, order) : value3(lattice, b, fade, order);
}

VEC_INLINE void octave_run(const struct lattice *lattice, size_t blocks, enum scarp_fade fade,
                           const struct weights *weights, int first,
                           const struct scarp_samples *from_rows,
                           const struct scarp_samples *to_rows, enum scarp_basis basis,
                           int dimensions, int order)
{
    const struct weights w = *weights;
    const struct scarp_samples from = rows_of(from_rows), to = *to_rows;
    for (size_t b = 0; b < blocks; b++) {
        const struct sample n = basis_at(lattice, b, fade, basis, dimensions, order);
        add_sample(&to, first, &from, b, &n, &w, dimensions, order);
    }
}

VEC_INLINE void octave_with_fade(const struct lattice *lattice, size_t blocks, enum scarp_fade fade,
                                 const struct weights *weights, const struct scarp_samples *from,
                                 const struct scarp_samples *to, enum scarp_basis basis,
                                 int dimensions, int order)
{
    if (from == NULL) {
        octave_run(lattice, blocks, fade, weights, 1, from, to, basis, dimensions, order);
    } else {
        octave_run(lattice, blocks, fade, weights, 0, from, to, basis, dimensions, order);
    }
}

/* What is the same for all points is decided outside the loop, which is there once for each case.
 */
#define OCTAVE_PASS(name, basis, dims, order)                                                      \
    static void name(const struct lattice *lattice, size_t blocks, enum scarp_fade fade,           \
                     const struct weights *weights, const struct scarp_samples *from,              \
                     const struct scarp_samples *to)                                               \
    {                                                                                              \
        if (fade == SCARP_QUINTIC) {                                                               \
            octave_with_fade(lattice, blocks, SCARP_QUINTIC, weights, from, to, basis, dims,       \
                             order);                                                               \
        } else {                                                                                   \
            octave_with_fade(lattice, blocks, SCARP_CUBIC, weights, from, to, basis, dims, order); \
        }                                                                                          \
    }

OCTAVE_PASS(gradient2_order0, SCARP_GRADIENT, 2, 0)
OCTAVE_PASS(gradient2_order1, SCARP_GRADIENT, 2, 1)
OCTAVE_PASS(gradient2_order2, SCARP_GRADIENT, 2, 2)
OCTAVE_PASS(gradient3_order0, SCARP_GRADIENT, 3, 0)
OCTAVE_PASS(gradient3_order1, SCARP_GRADIENT, 3, 1)
OCTAVE_PASS(gradient3_order2, SCARP_GRADIENT, 3, 2)
OCTAVE_PASS(value2_order0, SCARP_VALUE, 2, 0)
OCTAVE_PASS(value2_order1, SCARP_VALUE, 2, 1)
OCTAVE_PASS(value2_order2, SCARP_VALUE, 2, 2)
OCTAVE_PASS(value3_order0, SCARP_VALUE, 3, 0)
OCTAVE_PASS(value3_order1, SCARP_VALUE, 3, 1)
OCTAVE_PASS(value3_order2, SCARP_VALUE, 3, 2)

#undef OCTAVE_PASS

/* By [dimensions - 2][basis][order]. */
static octave_pass *const octave_passes[2][2][3] = {
    {{gradient2_order0, gradient2_order1, gradient2_order2},
     {value2_order0, value2_order1, value2_order2}},
    {{gradient3_order0, gradient3_order1, gradient3_order2},
     {value3_order0, value3_order1, value3_order2}},
};

#endif
