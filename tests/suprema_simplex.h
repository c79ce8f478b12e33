/* SPDX-License-Identifier: MIT
 *
 * The suprema of simplex noise and where it reaches them, for the tests of ranges.
 * test_suprema_simplex.c proves them.
 */
#ifndef SCARP_TESTS_SUPREMA_SIMPLEX_H
#define SCARP_TESTS_SUPREMA_SIMPLEX_H

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

#endif
