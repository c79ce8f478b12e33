/* SPDX-License-Identifier: MIT
 *
 * Simplex noise (Perlin 2001, Gustavson 2005) as a sum over all vertices near a point, whatever
 * triangle or tetrahedron they belong to: with d = p - v, w = max(0, r^2 - d.d) and q = g . d,
 *
 *     n = sum of w^m q
 *     gradient = sum of w^m g - 2m w^(m-1) q d
 *     Hessian = sum of 4m (m-1) w^(m-2) q d d^T - 2m w^(m-1) (g d^T + d g^T + q I)
 *
 * 2D: rows of triangles with edge 1, odd rows moved by 1/2. 3D: the corners and centres of cubes.
 * scarp has m = 4, rows that make the triangles equilateral and r^2 = 3/4 in 2D, and
 * r^2 = 1/2 - 2^-21 in 3D.
 */
#include "oracle.h"

#include <math.h>

static const uint32_t centre_addend = 0xbcfa3e4d; /* in place of hash_addend of oracle.c */

/* Adds the vertex `step` from the cell. In 3D that may be the centre of the cube. */
static void add_vertex(const struct oracle_simplex *simplex, const uint32_t cell[3],
                       const int step[3], int centre, const double t[3], struct oracle_sample *n)
{
    const int dimensions = simplex->dimensions;
    double d[3] = {0.0}, g[3], square = 0.0, q = 0.0;
    for (int i = 0; i < dimensions; i++) {
        const int odd_row = dimensions == 2 && i == 0 && (cell[1] + (uint32_t)step[1]) % 2 == 1;
        d[i] = t[i] - ((double)step[i] + (centre || odd_row ? 0.5 : 0.0));
        d[i] *= dimensions == 2 && i == 1 ? simplex->row : 1.0;
        square += d[i] * d[i];
    }
    const double m = simplex->power, w = fmax(0.0, simplex->square - square);
    n->clearance = fmin(n->clearance, fabs(square - simplex->square) / 4.0); /* or more */
    if (w == 0.0) {
        return; /* which saves time only */
    }
    simplex->draw(simplex->lattice, cell, step, centre, g);
    for (int i = 0; i < dimensions; i++) {
        q += g[i] * d[i];
    }
    n->value += pow(w, m) * q;
    for (int i = 0; i < dimensions; i++) {
        n->gradient[i] += pow(w, m) * g[i] - 2.0 * m * pow(w, m - 1.0) * q * d[i];
        for (int j = 0; j < dimensions; j++) {
            n->hessian[i][j] +=
                4.0 * m * (m - 1.0) * pow(w, m - 2.0) * q * d[i] * d[j] -
                2.0 * m * pow(w, m - 1.0) * (g[i] * d[j] + d[i] * g[j] + (i == j ? q : 0.0));
        }
    }
}

static void sum_triangles(const struct oracle_simplex *simplex, const uint32_t cell[3],
                          const double t[3], struct oracle_sample *n)
{
    for (int row = -2; row <= 3; row++) {
        for (int column = -3; column <= 3; column++) {
            const int step[3] = {column, row, 0};
            add_vertex(simplex, cell, step, 0, t, n);
        }
    }
}

static void sum_tetrahedra(const struct oracle_simplex *simplex, const uint32_t cell[3],
                           const double t[3], struct oracle_sample *n)
{
    for (int number = 0; number < 4 * 4 * 4; number++) { /* from two below to one above */
        const int step[3] = {number % 4 - 2, number / 4 % 4 - 2, number / 16 - 2};
        add_vertex(simplex, cell, step, 0, t, n);
        add_vertex(simplex, cell, step, 1, t, n);
    }
}

void oracle_simplex_sum(const struct oracle_simplex *simplex, const uint32_t cell[3],
                        const double t[3], struct oracle_sample *n)
{
    *n = (struct oracle_sample){.clearance = 1.0, .nearest = 1.0};
    if (simplex->dimensions == 2) {
        sum_triangles(simplex, cell, t, n);
    } else {
        sum_tetrahedra(simplex, cell, t, n);
    }
}

static void draw_vertex(const void *opaque, const uint32_t cell[3], const int step[3], int centre,
                        double gradient[3])
{
    const struct oracle_lattice *const lattice = opaque;
    const uint32_t h = oracle_mixed(lattice, cell, step);
    const uint32_t drawn = centre ? h * h + centre_addend * h : oracle_hash(h);
    const double *const g = oracle_gradient_drawn(lattice, drawn);
    gradient[0] = g[0];
    gradient[1] = g[1];
    gradient[2] = g[2];
}

struct oracle_simplex oracle_simplex_own(int dimensions)
{
    return (struct oracle_simplex){.dimensions = dimensions,
                                   .row = sqrt(3.0) / 2.0,
                                   .square = dimensions == 2 ? 0.75 : 0.5 - 0x1p-21,
                                   .power = 4.0};
}

void oracle_simplex_noise(const struct oracle_lattice *lattice, const uint32_t cell[3],
                          const double t[3], struct oracle_sample *n)
{
    struct oracle_simplex simplex = oracle_simplex_own(lattice->dimensions);
    simplex.draw = draw_vertex;
    simplex.lattice = lattice;
    oracle_simplex_sum(&simplex, cell, t, n);
}
