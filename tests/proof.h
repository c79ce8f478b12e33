/* SPDX-License-Identifier: MIT
 *
 * Proofs by branch and bound that a sum over the corners of a cell stays below a limit, for
 * test_range.c and test_phase_range.c, which say what is summed. test_suprema_simplex.c and
 * test_suprema_cells.c take the search for their own bounds.
 */
#ifndef SCARP_TESTS_PROOF_H
#define SCARP_TESTS_PROOF_H

#include "check.h"

static const char *const fade_names[] = {"quintic", "cubic"};

/*
 * S(t) is the maximum over G of n_G(t) = sum_c W_c(t) g_c . (t - c), c being the corners of the
 * cell and G a choice of a vector for each of them. On a box with centre m and half-size h,
 * Taylor's theorem bounds every n_G: n_G(t) <= n_G(m) + h sum_i |d_i n_G(m)| + K h^2 / 2,       K
 * >= sum_ij |d_ij n_G|. `first_order` is the largest n_G(m) + h sum_i |d_i n_G(m)| over all G; with
 * h = 0 it is S(m). Roundings in double are below 1e-14 and of no account.
 */
struct proof {
    int dimensions; /* of the boxes: 2, 3, or 4 */
    enum scarp_fade fade;
    double (*first_order)(const struct proof *proof, const double *m, double h);
    const void *vectors; /* what G chooses from; first_order knows its type */
    double curvature;    /* K */
    double limit;        /* what is to be proven an upper bound */
    long boxes;
    int depth; /* of the smallest box */
};

/*
 * K: W_c is a product of fades u or 1 - u. With U and V the largest |u'| and |u''|, and over the
 * corners of one axis sum |w'| = 2 |u'| and sum w = 1,
 *     sum_c |d_i W_c| <= 2 U,   sum_c |d_ii W_c| <= 2 V,   sum_c |d_ij W_c| <= 4 U^2.
 * With `product` the largest |g . (t - c)| and `component` that of the components of g, the product
 * rule gives
 *     |d_ii n| <= 2 V product + 4 U component     |d_ij n| <= 4 U^2 product + 4 U component.
 */
static inline double proof_curvature(int dimensions, enum scarp_fade fade, double product,
                                     double component)
{
    const double d = dimensions;
    const double u = fade == SCARP_QUINTIC ? 15.0 / 8.0 : 3.0 / 2.0; /* at t = 1/2 */
    const double v = fade == SCARP_QUINTIC ? 10.0 / sqrt(3.0) : 6.0; /* 1/2 +- sqrt(3)/6; 0 */
    return d * (2.0 * v * product + 4.0 * u * component) +
           d * (d - 1.0) * (4.0 * u * u * product + 4.0 * u * component);
}

static inline void fade_at(enum scarp_fade fade, double t, double *u, double *du)
{
    *u =
        fade == SCARP_QUINTIC ? t * t * t * (t * (t * 6.0 - 15.0) + 10.0) : t * t * (3.0 - 2.0 * t);
    *du = fade == SCARP_QUINTIC ? 30.0 * t * t * (t - 1.0) * (t - 1.0) : 6.0 * t * (1.0 - t);
}

/* Whether S <= limit on the box: by the bound, or because it holds on the 2^d parts. */
static inline int proof_bounded(struct proof *proof, const double *m, double h, int depth)
{
    proof->boxes++;
    proof->depth = depth > proof->depth ? depth : proof->depth;
    if (proof->first_order(proof, m, h) + 0.5 * proof->curvature * h * h <= proof->limit) {
        return 1;
    }
    if (h < 1e-3 && proof->first_order(proof, m, 0.0) > proof->limit) {
        return 0; /* the claim is wrong */
    }
    if (h < 1e-10) {
        return 0; /* the slack is too small for doubles */
    }
    for (int part = 0; part < 1 << proof->dimensions; part++) {
        double centre[4] = {0.0, 0.0, 0.0, 0.0};
        for (int i = 0; i < proof->dimensions; i++) {
            centre[i] = m[i] + (part >> i & 1 ? 0.5 : -0.5) * h;
        }
        if (!proof_bounded(proof, centre, 0.5 * h, depth + 1)) {
            return 0;
        }
    }
    return 1;
}

/* Moves t to a local maximum of S in the cell, by pattern search, and returns S there. */
static inline double proof_climb(const struct proof *proof, double *t, double first_step)
{
    double best = proof->first_order(proof, t, 0.0);
    for (double step = first_step; step > 0x1p-30;) {
        int moved = 0;
        for (int direction = 0; direction < 2 * proof->dimensions; direction++) {
            double there[4];
            memcpy(there, t, (size_t)proof->dimensions * sizeof *t);
            double *const moving = &there[direction / 2];
            *moving = fmin(1.0, fmax(0.0, *moving + (direction % 2 == 0 ? step : -step)));
            const double value = proof->first_order(proof, there, 0.0);
            if (value > best) {
                best = value;
                memcpy(t, there, (size_t)proof->dimensions * sizeof *t);
                moved = 1;
            }
        }
        step *= moved ? 1.0 : 0.5;
    }
    return best;
}

#endif
