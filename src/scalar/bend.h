/* SPDX-License-Identifier: MIT
 *
 * Reference: the fractals that bend, whose octaves look at y = x + w S, where S is what the slopes
 * of the octaves before add up to (Swiss and Jordan noise, scarp.h).
 */
#ifndef SCARP_SCALAR_BEND_H
#define SCARP_SCALAR_BEND_H

#include "driver.h"

/* What goes from octave to octave: the sum of slopes s with jacobian[m][j] = d s_m / d x_j; how
   much of the octaves is left, with its gradient; and the noise. */
struct bend {
    float s[3], jacobian[3][3];
    float left, left_by[3];
    struct outputs sum;
};

/* Bends x. */
static struct point bent(const struct point *x, const struct bend *bend, float reach,
                         int dimensions)
{
    struct point y = *x;
    y.displaced = 1;
    for (int i = 0; i < dimensions; i++) {
        y.f32[i] += reach * bend->s[i];
    }
    return y;
}

/* The gradient of the octave by x: A^T G with A = I + w (Jacobian of S). */
static float bent_first(const struct bend *bend, float reach, int j, const float g[3],
                        int dimensions)
{
    return g[j] + reach * column_dot(bend->jacobian, j, g, dimensions);
}

/* Row m of H A / f, the derivatives by x of component m of the slope. */
static float bent_second(const struct bend *bend, const struct bend_octave *b, int m, int j,
                         const struct outputs *n, int dimensions)
{
    const float row[3] = {n->of[second(m, 0)], n->of[second(m, 1)], n->of[second(m, 2)]};
    return bent_first(bend, b->reach, j, row, dimensions) * b->inverse;
}

/* Adds factor n times the slope g / f to S, with its derivatives: `by` are those of factor n. */
static void add_slope(struct bend *bend, const struct bend_octave *b, const struct outputs *n,
                      float product, const float by[3], int dimensions)
{
    float next[3][3];
    for (int m = 0; m < dimensions; m++) {
        const float slope = n->of[DX + m] * b->inverse;
        for (int j = 0; j < dimensions; j++) {
            next[m][j] = bend->jacobian[m][j] +
                         (by[j] * slope + product * bent_second(bend, b, m, j, n, dimensions));
        }
        bend->s[m] += product * slope;
    }
    for (int m = 0; m < dimensions; m++) {
        memcpy(bend->jacobian[m], next[m], (size_t)dimensions * sizeof(float));
    }
}

/* Swiss noise adds a u v with v = max(0, 1 - |n|), n being bent; S loses (a / a_0) u n g / f, and
   u is multiplied by the sum over a_0, at most by 1. */
static void swiss(struct bend *bend, const struct bend_octave *b, const struct outputs *n,
                  int dimensions)
{
    const float value = n->of[VALUE], share = b->weight * b->inverse_weight;
    const float u = bend->left, rest = 1.0f - fabsf(value);
    const float v = rest < 0.0f ? 0.0f : rest; /* NaN stays */
    float by[3];
    for (int j = 0; j < dimensions; j++) {
        const float nj = bent_first(bend, b->reach, j, &n->of[DX], dimensions);
        const float vj = rest < 0.0f ? 0.0f : with_sign(nj, value);
        bend->sum.of[DX + j] += b->weight * (v * bend->left_by[j] - u * vj);
        by[j] = -share * (bend->left_by[j] * value + u * nj);
    }
    bend->sum.of[VALUE] += b->weight * (u * v);
    add_slope(bend, b, n, -share * (u * value), by, dimensions);
    const float sum = bend->sum.of[VALUE] * b->inverse_weight;
    if (sum < 1.0f) {
        for (int j = 0; j < dimensions; j++) {
            bend->left_by[j] =
                sum * bend->left_by[j] + u * (bend->sum.of[DX + j] * b->inverse_weight);
        }
        bend->left = u * sum;
    }
}

/* Half of the derivative of S.S by coordinate j */
static float steepness_by(const struct bend *bend, int j, int dimensions)
{
    return column_dot(bend->jacobian, j, bend->s, dimensions);
}

/* Jordan noise adds a q n^2 with q = 1 - erosion / (1 + S.S), but 1 in octave 0; S gains n g / f.
 */
static void jordan(struct bend *bend, const struct bend_octave *b, float erosion,
                   const struct outputs *n, int is_first, int dimensions)
{
    const float value = n->of[VALUE], square = value * value;
    const float p = 1.0f / (1.0f + dot_of(bend->s, bend->s, dimensions));
    const float q = is_first ? 1.0f : 1.0f - erosion * p;
    const float damping = is_first ? 0.0f : 2.0f * erosion * (p * p) * square;
    float by[3];
    for (int j = 0; j < dimensions; j++) {
        by[j] = bent_first(bend, b->reach, j, &n->of[DX], dimensions);
        bend->sum.of[DX + j] +=
            b->weight * (damping * steepness_by(bend, j, dimensions) + 2.0f * q * (value * by[j]));
    }
    bend->sum.of[VALUE] += b->weight * (q * square);
    add_slope(bend, b, n, value, by, dimensions);
}

static struct outputs bend_octaves(const struct scarp_call_plan *plan, const struct point *x,
                                   int dimensions)
{
    struct bend bend = {.left = 1.0f};
    for (int k = 0; k < plan->octaves; k++) {
        const struct scarp_octave *const o = &plan->octave[k];
        const struct bend_octave b = bend_octave_of(plan, k);
        const struct point y = k == 0 ? *x : bent(x, &bend, b.reach, dimensions);
        const struct location at = location_of(plan, k, &y, dimensions);
        const struct outputs basis = basis_at(plan, o, &at, dimensions);
        const struct outputs n = in_input(o, is_turned(plan, k), &basis, dimensions);
        if (plan->fractal == SCARP_SWISS) {
            swiss(&bend, &b, &n, dimensions);
        } else {
            jordan(&bend, &b, plan->erosion, &n, k == 0, dimensions);
        }
    }
    return bend.sum;
}

#endif
