/* SPDX-License-Identifier: MIT
 *
 * The suprema of cellular noise by jitter, for the tests of ranges. test_suprema_cells.c proves
 * them.
 */
#ifndef SCARP_TESTS_SUPREMA_CELLS_H
#define SCARP_TESTS_SUPREMA_CELLS_H

#include <math.h>

/*
 * Each cell has one feature, which may be anywhere in its box of edge j, the jitter, around the
 * cell's centre. At a given point p every cell may have its feature where it is farthest from p.
 * Then F1 and F2 have their largest values there, for they grow with every distance. With a_i how
 * far p is from the centre of its cell along axis i, and m the largest of them, that distance is
 *     sqrt(sum (a_i + j/2)^2)                                        for the cell of p
 *     sqrt((1 - m + j/2)^2 + sum of the others (a_i + j/2)^2)        for the second, along axis m.
 * The first is largest at the corner of a cell, a_i = 1/2. The second grows with the others to
 * a_i = m, and its square is then convex in m: it is largest at the centre or at the corner.
 *
 * F2 - F1 is largest if the nearest feature is at p itself, which takes a_i <= j/2: again m = 0,
 * or m = j/2.
 */
static inline double cells_f1(int dimensions, double j)
{
    return sqrt(dimensions) * (1.0 + j) / 2.0;
}

static inline double cells_f2(int dimensions, double j)
{
    const double centre = sqrt(1.0 + j + dimensions * j * j / 4.0);
    return fmax(centre, cells_f1(dimensions, j)); /* in 2D and for j <= 1/2 the centre */
}

static inline double cells_edge(int dimensions, double j)
{
    const double centre = sqrt(1.0 + j + dimensions * j * j / 4.0);
    return fmax(centre, sqrt(1.0 + (dimensions - 1) * j * j)); /* in 3D the latter from 4/5 on */
}

/*
 * V = sqrt(sum (1 - s_c)^8), over the squared distances s_c < 1. 2^n features meet at a corner of
 * cells, but for (1 - j)/2 along each axis. For a small jitter V has its maximum elsewhere, but
 * since it grows with the boxes it is not above that of CELLS_SOFT_JITTER.
 */
#define CELLS_SOFT_JITTER 0.5625

static inline double cells_soft(int dimensions, double j)
{
    const double gap = (1.0 - fmax(j, CELLS_SOFT_JITTER)) / 2.0;
    return sqrt(1 << dimensions) * pow(1.0 - dimensions * gap * gap, 4.0);
}

#endif
