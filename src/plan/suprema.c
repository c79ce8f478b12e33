/* SPDX-License-Identifier: MIT
 *
 * The suprema of |basis| as the kernels evaluate it. tests/test_range.c, test_suprema_simplex.c and
 * test_suprema_cells.c prove them by branch and bound.
 */
#include "suprema.h"

#include <math.h>

#include "members.h"

/*
 * Gradient noise, by [fade], is sum_c W_c(t) g_c . (t - c) over the corners c of a cell, so its
 * supremum is the maximum over t of sum_c W_c(t) max_g g . (t - c).
 *   2D: 16 unit vectors; at t = (.5, .5266) and (.4667, .5), and their mirror images
 *   3D: edge vectors (+-2, +-2, 0); at (.5185, .5, .3553) and (.5, .5236, .6756)
 * Value noise is evaluated in units of 2^-31 of its lattice values, which lie in [-2^31, 2^31].
 */
static const double gradient2_supremum[] = {
    [SCARP_QUINTIC] = 0.69535270367848662, [SCARP_CUBIC] = 0.69580995165323791};
static const double gradient3_supremum[] = {
    [SCARP_QUINTIC] = 2.0 * 1.0363538112118029, [SCARP_CUBIC] = 2.0 * 1.0449051896098760};
static const double value_supremum = 0x1p31;

/*
 * Simplex noise, likewise the maximum over p of sum_v w_v^4 max_g g . (p - v), with w_v = max(0,
 * r^2
 * - |p - v|^2).
 *   2D: 16 unit vectors, r^2 = 3/4; at (.738127, .457100)
 *   3D: edge vectors (+-2, +-2, 0), r^2 = 1/2 - 2^-21; at (.166848, 0, .833146)
 */
static const double simplex2_supremum = 0.062366952212268554;
static const double simplex3_supremum = 2.0 * 0.013007101282926131;

static double jitter_of(const struct scarp_noise *noise)
{
    return value_or((double)noise->jitter, noise_bounds.jitter.standard);
}

float scarpi_stray(const struct scarp_noise *noise)
{
    return (float)(jitter_of(noise) * 0x1p-32);
}

/* A point's own cell has a feature within sqrt(n) (1 + j) / 2, j being the jitter; that is reached
   at the corners of cells. */
static double nearest_supremum(double jitter, int dimensions)
{
    return sqrt((double)dimensions) * (1.0 + jitter) / 2.0;
}

/* Half a cell and half the jitter off along one axis, half the jitter along the others: that is
   reached in the middles of cells. In 3D and with more jitter, their corners are further from all.
 */
static double second_supremum(double jitter, int dimensions)
{
    const double far = 1.0 + jitter / 2.0, near = jitter / 2.0;
    const double middle = sqrt(far * far + (double)(dimensions - 1) * near * near);
    const double corner = nearest_supremum(jitter, dimensions);
    return middle > corner ? middle : corner;
}

/* Soft noise is the root of a sum of (1 - s)^8. It is largest at the corner of 2^n cells whose
   features are as near as they can be, from a jitter of .525 on; with less it is smaller, so what
   holds for more holds there. */
#define SOFT_JITTER 0.5625

static double soft_supremum(double jitter, int dimensions)
{
    const double gap = (1.0 - (jitter > SOFT_JITTER ? jitter : SOFT_JITTER)) / 2.0;
    const double near = 1.0 - (double)dimensions * gap * gap;
    return sqrt((double)(1 << dimensions)) * (near * near) * (near * near);
}

/* The supremum of the distance that cellular noise is made of. */
static double distance_supremum(const struct scarp_noise *noise, int dimensions)
{
    switch ((int)noise->basis) {
    case SCARP_CELL_F1: return nearest_supremum(jitter_of(noise), dimensions);
    case SCARP_CELL_F2:
    case SCARP_CELL_EDGE: return second_supremum(jitter_of(noise), dimensions);
    default: return soft_supremum(jitter_of(noise), dimensions);
    }
}

double scarpi_supremum(const struct scarp_noise *noise, int dimensions)
{
    switch (noise->basis) { /* no default: a compiler warns of a basis that is missing */
    case SCARP_GRADIENT:
        return (dimensions == 2 ? gradient2_supremum : gradient3_supremum)[noise->fade];
    case SCARP_VALUE:
    case SCARP_CELL_VALUE: return value_supremum;
    case SCARP_SIMPLEX: return dimensions == 2 ? simplex2_supremum : simplex3_supremum;
    case SCARP_CELL_F1:
    case SCARP_CELL_F2:
    case SCARP_CELL_EDGE:
    case SCARP_CELL_SOFT: return distance_supremum(noise, dimensions) / 2.0;
    }
    return 1.0;
}

double scarpi_middle(const struct scarp_noise *noise, int dimensions)
{
    return basis_has(noise->basis, BASIS_DISTANCE) ? distance_supremum(noise, dimensions) / 2.0
                                                   : 0.0;
}
