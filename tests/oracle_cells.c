/* SPDX-License-Identifier: MIT
 *
 * Cellular noise (Worley 1996), by brute force over the 7^n cells around a point. Each has a
 * feature; with d = p - feature and s = d.d, F is the square root of the least or second least s,
 *
 *     grad F = d / F,   H_F = (I - grad F grad F^T) / F
 *
 * and soft noise is -V, V^2 being the sum of a^8, a = max(0, 1 - s). With U = V^2,
 *
 *     grad U = sum of -16 a^7 d,   H_U = sum of 224 a^6 d d^T - 16 a^7 I
 *     grad V = grad U / (2 V),     H_V = (H_U / 2 - grad V grad V^T) / V
 */
#include "oracle.h"

#include <math.h>

static const uint32_t draw_multiplier[3] = {1, 0xe41130e9, 0x6ecea30d};
static const uint32_t id_multiplier = 0xc603dc87;

uint32_t oracle_feature_id(uint32_t hash)
{
    return hash * id_multiplier;
}

double oracle_cells_supremum(enum scarp_basis basis, int dimensions, double jitter)
{
    const double n = (double)dimensions;
    const double corner = sqrt(n) * (1.0 + jitter) / 2.0;
    const double middle = sqrt(1.0 + jitter + n * jitter * jitter / 4.0);
    switch (basis) {
    case SCARP_CELL_F1: return corner;
    case SCARP_CELL_SOFT:
        return pow(2.0, n / 2.0) * pow(1.0 - n * pow((1.0 - fmax(jitter, 0.5625)) / 2.0, 2.0), 4.0);
    default: return fmax(corner, middle);
    }
}

/* A drawn number as a signed one, rounded to float. */
static double signed_draw(uint32_t draw)
{
    return (double)(float)((double)draw - (draw >= 0x80000000u ? 0x1p32 : 0.0));
}

/* The feature of cell `number` of the 7^n ones, as seen from p. */
static struct oracle_feature feature(const struct oracle_lattice *lattice, double jitter,
                                     const uint32_t cell[3], const double t[3], int number)
{
    const int step[3] = {number % 7 - 3, number / 7 % 7 - 3,
                         lattice->dimensions == 3 ? number / 49 - 3 : 0};
    struct oracle_feature f = {.square = 0.0,
                               .hash = oracle_hash(oracle_mixed(lattice, cell, step))};
    for (int i = 0; i < lattice->dimensions; i++) {
        const double stray = jitter * 0x1p-32 * signed_draw(f.hash * draw_multiplier[i]);
        f.d[i] = t[i] - ((double)step[i] + 0.5 + stray);
        f.square += f.d[i] * f.d[i];
    }
    return f;
}

static int cells_around(const struct oracle_lattice *lattice)
{
    return lattice->dimensions == 2 ? 7 * 7 : 7 * 7 * 7;
}

void oracle_features_none(struct oracle_feature nearest[ORACLE_FEATURES])
{
    for (int rank = 0; rank < ORACLE_FEATURES; rank++) {
        nearest[rank].square = nearest[rank].distance = HUGE_VAL;
    }
}

void oracle_features_add(int dimensions, struct oracle_feature feature,
                         struct oracle_feature nearest[ORACLE_FEATURES])
{
    feature.square = 0.0;
    for (int i = 0; i < dimensions; i++) {
        feature.square += feature.d[i] * feature.d[i];
    }
    for (int rank = 0; rank < ORACLE_FEATURES; rank++) { /* insertion */
        if (feature.square < nearest[rank].square) {
            const struct oracle_feature moved = nearest[rank];
            nearest[rank] = feature;
            nearest[rank].distance = sqrt(feature.square);
            feature = moved;
        }
    }
}

void oracle_features(const struct oracle_lattice *lattice, double jitter, const uint32_t cell[3],
                     const double t[3], struct oracle_feature nearest[ORACLE_FEATURES])
{
    oracle_features_none(nearest);
    for (int number = 0; number < cells_around(lattice); number++) {
        oracle_features_add(lattice->dimensions, feature(lattice, jitter, cell, t, number),
                            nearest);
    }
}

/* sum += a F */
static void add_distance(int dimensions, double a, const struct oracle_feature *f,
                         struct oracle_sample *sum)
{
    sum->value += a * f->distance;
    for (int i = 0; i < dimensions && f->distance > 0.0; i++) {
        const double gi = f->d[i] / f->distance;
        sum->gradient[i] += a * gi;
        for (int j = 0; j < dimensions; j++) {
            const double gj = f->d[j] / f->distance;
            sum->hessian[i][j] += a * ((i == j ? 1.0 : 0.0) - gi * gj) / f->distance;
        }
    }
}

static void soft(const struct oracle_lattice *lattice, double jitter, const uint32_t cell[3],
                 const double t[3], struct oracle_sample *n)
{
    const int d = lattice->dimensions;
    double u = 0.0, gradient[3] = {0.0}, hessian[3][3] = {{0.0}};
    *n = (struct oracle_sample){.clearance = 1.0, .nearest = 1.0};
    for (int number = 0; number < cells_around(lattice); number++) {
        const struct oracle_feature f = feature(lattice, jitter, cell, t, number);
        const double a = fmax(0.0, 1.0 - f.square);
        n->clearance = fmin(n->clearance, fabs(f.square - 1.0) / 4.0); /* or more */
        if (a == 0.0) {
            continue; /* which saves time only */
        }
        u += pow(a, 8.0);
        for (int i = 0; i < d; i++) {
            gradient[i] -= 16.0 * pow(a, 7.0) * f.d[i];
            hessian[i][i] -= 16.0 * pow(a, 7.0);
            for (int j = 0; j < d; j++) {
                hessian[i][j] += 224.0 * pow(a, 6.0) * f.d[i] * f.d[j];
            }
        }
    }
    const double v = sqrt(u);
    n->value = -v;
    for (int i = 0; i < d && v > 0.0; i++) {
        n->gradient[i] = -gradient[i] / (2.0 * v);
        for (int j = 0; j < d; j++) {
            const double product = gradient[i] * gradient[j] / (4.0 * u);
            n->hessian[i][j] = -(hessian[i][j] / 2.0 - product) / v;
        }
    }
}

void oracle_cell_noise_of(const struct oracle_feature f[ORACLE_FEATURES], enum scarp_basis basis,
                          int dimensions, struct oracle_sample *n)
{
    *n = (struct oracle_sample){.nearest = fmin(1.0, f[0].distance)};
    n->clearance = fmin(f[0].distance, (f[1].distance - f[0].distance) / 2.0);
    if (basis == SCARP_CELL_VALUE) {
        n->value = signed_draw(oracle_feature_id(f[0].hash)) * 0x1p-31;
        n->nearest = 1.0;
    } else if (basis == SCARP_CELL_F1) {
        add_distance(dimensions, 1.0, &f[0], n);
    } else {
        n->clearance = fmin(n->clearance, (f[2].distance - f[1].distance) / 2.0);
        add_distance(dimensions, 1.0, &f[1], n);
        if (basis == SCARP_CELL_EDGE) {
            add_distance(dimensions, -1.0, &f[0], n);
        }
    }
}

void oracle_cell_noise(const struct oracle_lattice *lattice, enum scarp_basis basis, double jitter,
                       const uint32_t cell[3], const double t[3], struct oracle_sample *n)
{
    if (basis == SCARP_CELL_SOFT) {
        soft(lattice, jitter, cell, t, n);
        return;
    }
    struct oracle_feature f[ORACLE_FEATURES];
    oracle_features(lattice, jitter, cell, t, f);
    oracle_cell_noise_of(f, basis, lattice->dimensions, n);
}
