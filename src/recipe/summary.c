/* SPDX-License-Identifier: MIT
 *
 * What a field is made of. Cells are those of the octaves of all noises, cells and gullies that a
 * node depends on, as the matrices of their places have them. Jumps follow from how smooth the
 * parts are: a jump stays one through all functions, and slopes make jumps of creases.
 */
#include "summary.h"

#include <math.h>

#include "../calls/run.h"
#include "../plan/gully.h"
#include "../plan/parameters.h"
#include "graph.h"

/* How smooth a field is. Slopes and gullies, which have gradients in their values, take one away. */
enum smoothness { JUMPS, CREASES, HAS_GRADIENT, HAS_HESSIAN };

static int lesser(int a, int b)
{
    return a < b ? a : b;
}

/* Whether a node depends on something; the others are computed with it, and change nothing. */
static int varies(const struct recipe_node *n)
{
    return n->axes != 0;
}

/* The nodes that the value of a node depends on. A coordinate does not depend on the others of its
   place. */
static int dependencies(const struct recipe *r, int node, int16_t reads[RECIPE_READS])
{
    int slopes;
    const struct recipe_node *const n = &r->node[node];
    const int count = scarpi_recipe_reads(r, node, reads, &slopes);
    return n->operation == OP_COORDINATE && r->place[n->place].frame < 0 ? slopes : count;
}

/* Cells */

static void add_cell(struct recipe_summary *to, double largest, double smallest)
{
    if (!(smallest > 0.0 && largest < INFINITY)) {
        return;
    }
    to->cell[0] = to->cell[0] > largest ? to->cell[0] : largest;
    to->cell[1] = to->cell[1] > 0.0 && to->cell[1] < smallest ? to->cell[1] : smallest;
}

/* Makes an element of a symmetric matrix 0 by turning two axes, as Jacobi's method does. */
static void turn(double a[3][3], int p, int q)
{
    const double half = (a[q][q] - a[p][p]) / (2.0 * a[p][q]);
    const double t = (half < 0.0 ? -1.0 : 1.0) / (fabs(half) + sqrt(half * half + 1.0));
    const double c = 1.0 / sqrt(t * t + 1.0), s = t * c;
    for (int i = 0; i < 3; i++) {
        const double u = a[i][p], v = a[i][q];
        a[i][p] = c * u - s * v;
        a[i][q] = s * u + c * v;
    }
    for (int i = 0; i < 3; i++) {
        const double u = a[p][i], v = a[q][i];
        a[p][i] = c * u - s * v;
        a[q][i] = s * u + c * v;
    }
    a[p][q] = a[q][p] = 0.0;
}

/* By how much a matrix stretches lengths, at least and at most: its singular values, of which those
   that are 0 do not count. Axes that are turned are rounded, so these are rounded to floats: a
   picture that is turned has cells of the same size. Returns 0 if there is none. */
static int stretches(const double m[3][3], double stretch[2])
{
    double square[3][3], largest = 0.0, least = INFINITY, most = 0.0;
    int is_turned = 0;
    for (int i = 0; i < 9; i++) {
        largest = fabs(m[i / 3][i % 3]) > largest ? fabs(m[i / 3][i % 3]) : largest;
    }
    if (!(largest >= 1e-30 && largest <= 1e30)) { /* squares and floats have room */
        return 0;
    }
    for (int i = 0; i < 3; i++) {
        for (int j = 0; j < 3; j++) {
            square[i][j] = 0.0;
            for (int k = 0; k < 3; k++) {
                square[i][j] += m[i][k] * m[j][k];
            }
            is_turned |= i != j && square[i][j] != 0.0;
        }
    }
    for (int sweep = 0; is_turned && sweep < 3 * 12; sweep++) {
        const int p = sweep % 3, q = (p + 1) % 3;
        if (square[p][q] != 0.0) {
            turn(square, p, q);
        }
    }
    for (int i = 0; i < 3; i++) {
        most = square[i][i] > most ? square[i][i] : most;
    }
    for (int i = 0; i < 3; i++) {
        least = square[i][i] > 1e-14 * most && square[i][i] < least ? square[i][i] : least;
    }
    stretch[0] = is_turned ? (double)(float)sqrt(least) : sqrt(least);
    stretch[1] = is_turned ? (double)(float)sqrt(most) : sqrt(most);
    return 1;
}

/* The cells of the first and of the last octave of a noise and its warps, as large as the matrix of
   a place makes them */
static void add_noise(struct recipe_summary *to, const double stretch[2],
                      const struct scarp_noise *noise)
{
    for (; noise != NULL; noise = noise->warp) {
        const struct parameters p = parameters_of(noise);
        double frequency = p.frequency;
        add_cell(to, 1.0 / (frequency * stretch[0]), 1.0 / (frequency * stretch[1]));
        for (int k = octaves_in(noise); k > 1; k--) {
            frequency *= p.lacunarity;
        }
        add_cell(to, 1.0 / (frequency * stretch[0]), 1.0 / (frequency * stretch[1]));
    }
}

static int is_noise(const struct recipe_node *n)
{
    return n->operation == OP_NOISE || n->operation == OP_VECTOR || n->operation == OP_CELL;
}

static void add_cells(const struct recipe *r, const struct recipe_node *n,
                      struct recipe_summary *to)
{
    struct scarp_noise noise[5];
    double matrix[3][3], stretch[2];
    if (!is_noise(n) && n->operation != OP_GULLIES) {
        return;
    }
    scarpi_recipe_matrix(r, n->place, matrix);
    if (!stretches((const double(*)[3])matrix, stretch)) {
        return;
    }
    if (n->operation == OP_GULLIES) {
        noise[0] = scarpi_gullies_lattice(&r->gully[n->index]);
    } else {
        scarpi_recipe_spell_noise(r, n->index, noise);
    }
    add_noise(to, stretch, &noise[0]);
}

/* Jumps */

/* How smooth a noise that does not jump is, without its warp: scarp.h under "Creases" */
static int smoothness_of_level(const struct scarp_noise *noise)
{
    const int takes_slopes = fractal_has(noise->fractal, FRACTAL_OWN_SLOPES) ||
                             (fractal_has(noise->fractal, FRACTAL_SLOPES) && noise->octaves > 1.0f);
    int smoothness = basis_has(noise->basis, BASIS_CREASES)                       ? CREASES
                     : blends_corners(noise->basis) && noise->fade == SCARP_CUBIC ? HAS_GRADIENT
                                                                                  : HAS_HESSIAN;
    smoothness = takes_slopes && smoothness > CREASES ? smoothness - 1 : smoothness;
    return fractal_has(noise->fractal, FRACTAL_CREASES) ? lesser(smoothness, CREASES) : smoothness;
}

static int smoothness_of_noise(const struct recipe *r, int index)
{
    struct scarp_noise noise[5];
    int smoothness = HAS_HESSIAN;
    scarpi_recipe_spell_noise(r, index, noise);
    for (const struct scarp_noise *n = &noise[0]; n != NULL; n = n->warp) {
        smoothness = lesser(smoothness, smoothness_of_level(n));
    }
    return noise_jumps(&noise[0]) ? JUMPS : smoothness;
}

/* How smooth a node is, given the least of what it depends on */
static int smoothness_of(const struct recipe *r, const struct recipe_node *n, int least)
{
    switch (n->operation) {
    case OP_NOISE:
    case OP_VECTOR: return lesser(least, smoothness_of_noise(r, n->index));
    case OP_CELL: return n->detail == 0 ? JUMPS : lesser(least, CREASES);
    default: break;
    }
    const int traits = scarpi_recipe_traits(n->operation);
    const int most = (traits & IS_C0) != 0   ? CREASES
                     : (traits & IS_C1) != 0 ? HAS_GRADIENT
                                             : HAS_HESSIAN;
    const int has_slopes = (traits & NEEDS_SLOPES) != 0; /* those of a crease jump */
    return lesser(has_slopes && least > JUMPS ? least - 1 : least, most);
}

NOINLINE void scarpi_recipe_summary(const struct recipe *r, int node, struct recipe_summary *to)
{
    uint8_t is_needed[RECIPE_NODES] = {0}, smoothness[RECIPE_NODES];
    int16_t reads[RECIPE_READS];
    *to = (struct recipe_summary){.jumps = 0};
    is_needed[node] = 1;
    for (int i = node; i >= 0; i--) {
        const int count = is_needed[i] ? dependencies(r, i, reads) : 0;
        for (int k = 0; k < count; k++) {
            is_needed[reads[k]] = 1;
        }
    }
    for (int i = 0; i <= node; i++) {
        const struct recipe_node *const n = &r->node[i];
        int least = HAS_HESSIAN;
        smoothness[i] = HAS_HESSIAN;
        if (!is_needed[i] || !varies(n)) {
            continue;
        }
        const int count = dependencies(r, i, reads);
        for (int k = 0; k < count; k++) {
            least = lesser(least, smoothness[reads[k]]);
        }
        smoothness[i] = (uint8_t)smoothness_of(r, n, least);
        add_cells(r, n, to);
    }
    to->jumps = smoothness[node] == JUMPS;
}
