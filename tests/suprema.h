/* SPDX-License-Identifier: MIT
 *
 * The suprema of bases, and where they are reached, for the tests of ranges. test_suprema_simplex.c and
 * test_suprema_cells.c prove them.
 */
#ifndef SCARP_TESTS_SUPREMA_H
#define SCARP_TESTS_SUPREMA_H

#include <math.h>

#define SUPREMUM_SEED 2

/*
 * Gradient noise of seed 2 and frequency 1 reaches its supremum here, by [dimensions - 2][fade],
 * with the sign + and -: at the maximisers that test_range.c states, in cells whose corners have
 * the right gradients. They were found by trying 10^5 cells in 2D and 10^9 in 3D; another
 * lattice hash has others.
 */
static const double supremum_places[2][2][2][3] = {
    {{{3534.5, -379.4734, 0.0}, {112.4734, -2855.5, 0.0}},
     {{-1381.5, 155.4667, 0.0}, {-447.4667, -3550.5, 0.0}}},
    {{{-95963.4815, 944134.6447, 832439.5}, {-722478.3553, 1013619.4815, -989922.5}},
     {{986541.4764, 458029.5, -961114.3244}, {-610107.3244, -923159.4764, 785642.5}}},
};

/*
 * Simplex noise is n(p) = sum_v max(0, r^2 - |p - v|^2)^4 g_v . (p - v) over the vertices v of a
 * lattice. In 2D these are the corners of equilateral triangles, with rows parallel to x; in 3D the
 * integer points, and those moved by 1/2 along all axes.
 */
struct simplex {
    const char *name;
    int dimensions, directions; /* how many there are: 16 or 24 in 2D; the 12 edges of a cube */
    double edge;                /* of the triangles; in 3D of the cubes */
    double square;              /* r^2 */
    double supremum;            /* of |n|, for unit vectors in 2D and edges (1, 1, 0) in 3D */
    double at[3];               /* a maximiser in the box of test_suprema_simplex.c */
    double second; /* no second derivative with respect to two axes is more times the supremum */
};

#define SIMPLEX_SUPREMUM2 0.062366952212268554
#define SIMPLEX_SUPREMUM3 0.013007101282926131 /* scarp's edges are twice as long, and so is it */
#define SIMPLEX_SQUARE3 (0.5 - 0x1p-21)
#define ROOT_2_3 0.81649658092772603

/* The third is the noise of OpenSimplex2, which states 99.83685446303647 as 1 / supremum. Its
   lattice is turned by 15 degrees, which leaves the 24 directions as they are. */
static const struct simplex simplices[] = {
    {"2D", 2, 16, 1.0, 0.75, SIMPLEX_SUPREMUM2, {0.23812733, 0.40892589}, 40.0},
    {"3D", 3, 12, 1.0, SIMPLEX_SQUARE3, SIMPLEX_SUPREMUM3, {0.16684837, 0.0, 0.16685363}, 60.0},
    {"OpenSimplex2", 2, 24, ROOT_2_3, 0.5, 1.0 / 99.83685446303647, {0.19915901, 0.31698412}, 0.0},
};

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
