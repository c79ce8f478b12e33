/* SPDX-License-Identifier: MIT
 *
 * Simplex noise (Perlin 2001, Gustavson 2005) as a sum over all vertices near a point, whatever
 * triangle or tetrahedron they belong to: with d = p - v, w = max(0, r^2 - d.d) and q = g . d,
 *
 *     n = sum of w^4 q
 *     gradient = sum of w^4 g - 8 w^3 q d
 *     Hessian = sum of 48 w^2 q d d^T - 8 w^3 (g d^T + d g^T + q I)
 *
 * 2D: rows of triangles with edge 1, odd rows moved by 1/2; r^2 = 3/4. 3D: the corners and centres
 * of cubes; r^2 = 1/2 - 2^-21.
 */
#include "oracle.h"

#include <math.h>

static const uint32_t centre_addend = 0xbcfa3e4d; /* in place of hash_addend of oracle.c */

/* Adds the vertex with this hash, at d from p. */
static void add_vertex(const struct oracle_lattice *lattice, double r2, const double d[3],
                       uint32_t hash, struct oracle_sample *n)
{
    const int dimensions = lattice->dimensions;
    const double *const g = oracle_gradient_drawn(lattice, hash);
    const double z = dimensions == 3 ? d[2] : 0.0;
    const double square = d[0] * d[0] + d[1] * d[1] + z * z;
    const double q = g[0] * d[0] + g[1] * d[1] + g[2] * z;
    const double w = fmax(0.0, r2 - square);
    n->clearance = fmin(n->clearance, fabs(square - r2) / 4.0); /* or more */
    if (w == 0.0) {
        return; /* which saves time only */
    }
    n->value += pow(w, 4.0) * q;
    for (int i = 0; i < dimensions; i++) {
        n->gradient[i] += pow(w, 4.0) * g[i] - 8.0 * pow(w, 3.0) * q * d[i];
        for (int j = 0; j < dimensions; j++) {
            n->hessian[i][j] +=
                48.0 * w * w * q * d[i] * d[j] -
                8.0 * pow(w, 3.0) * (g[i] * d[j] + d[i] * g[j] + (i == j ? q : 0.0));
        }
    }
}

static void sum_triangles(const struct oracle_lattice *lattice, const uint32_t cell[3],
                          const double t[3], struct oracle_sample *n)
{
    for (int row = -2; row <= 3; row++) {
        const double shift = (cell[1] + (uint32_t)row) % 2 == 1 ? 0.5 : 0.0;
        for (int column = -3; column <= 3; column++) {
            const int step[3] = {column, row, 0};
            const double d[3] = {t[0] - ((double)column + shift),
                                 (t[1] - (double)row) * sqrt(3.0) / 2.0, 0.0};
            const uint32_t drawn = oracle_hash(oracle_mixed(lattice, cell, step));
            add_vertex(lattice, 0.75, d, drawn, n);
        }
    }
}

static void sum_tetrahedra(const struct oracle_lattice *lattice, const uint32_t cell[3],
                           const double t[3], struct oracle_sample *n)
{
    for (int number = 0; number < 4 * 4 * 4; number++) { /* from two below to one above */
        const int step[3] = {number % 4 - 2, number / 4 % 4 - 2, number / 16 - 2};
        const uint32_t h = oracle_mixed(lattice, cell, step);
        double corner[3], centre[3];
        for (int i = 0; i < 3; i++) {
            corner[i] = t[i] - (double)step[i];
            centre[i] = t[i] - ((double)step[i] + 0.5);
        }
        const double r2 = 0.5 - 0x1p-21;
        add_vertex(lattice, r2, corner, oracle_hash(h), n);
        add_vertex(lattice, r2, centre, h * h + centre_addend * h, n);
    }
}

void oracle_simplex_noise(const struct oracle_lattice *lattice, const uint32_t cell[3],
                          const double t[3], struct oracle_sample *n)
{
    *n = (struct oracle_sample){.clearance = 1.0, .nearest = 1.0};
    if (lattice->dimensions == 2) {
        sum_triangles(lattice, cell, t, n);
    } else {
        sum_tetrahedra(lattice, cell, t, n);
    }
}
