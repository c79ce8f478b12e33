/* SPDX-License-Identifier: MIT
 *
 * The published closed forms of value noise and gradient noise, with their gradients (I. Quilez,
 * "Value noise derivatives" and "Gradient noise derivatives") and Hessians (derived below).
 *
 * With the corners of a cell named a = 000, b = 100, c = 010, d = 110, e = 001, f = 101, g = 011,
 * h = 111 (x, y, z) and u, v, w the fades of the position, the interpolation of corner values is
 *
 *     n = k0 + k1 u + k2 v + k3 w + k4 uv + k5 vw + k6 wu + k7 uvw
 *     k0 = a         k1 = b - a             k2 = c - a             k3 = e - a
 *     k4 = a - b - c + d     k5 = a - c - e + g     k6 = a - b - e + f
 *     k7 = -a + b + c - d + e - f - g + h
 *
 * Value noise is n itself; u depends on x only, so n_x = u' n_u, n_xx = u'' n_u, n_xy = u'v' n_uv.
 *
 * Gradient noise is n of the corners' dot products D = g . (t - corner), which depend on x too, by
 * their gradient's component X: with n[.] the interpolation of a quantity of the corners,
 *
 *     n_x  = n[X] + u' n_u[D]
 *     n_xx = 2 u' n_u[X] + u'' n_u[D]
 *     n_xy = v' n_v[X] + u' n_u[Y] + u'v' n_uv[D]
 *
 * (n[X] contains the term uw (X101 - X001 - X100 + X000), whose last sign a widely copied
 * derivation has wrong.)
 */
#include "oracle.h"

struct fade {
    double u, du, ddu;
};

static struct fade fade_at(enum scarp_fade kind, double t)
{
    struct fade f;
    if (kind == SCARP_QUINTIC) {
        f.u = t * t * t * (t * (t * 6.0 - 15.0) + 10.0);
        f.du = 30.0 * t * t * (t * t - 2.0 * t + 1.0);
        f.ddu = 60.0 * t * (2.0 * t * t - 3.0 * t + 1.0);
    } else {
        f.u = 3.0 * t * t - 2.0 * t * t * t;
        f.du = 6.0 * t * (1.0 - t);
        f.ddu = 6.0 - 12.0 * t;
    }
    return f;
}

/* The interpolation of a quantity, and its partial derivatives with respect to u, v and w. */
struct blend {
    double n, n1[3], n2[3][3];
};

static struct blend blend(const double corner[8], int dimensions, const struct fade fade[3])
{
    const double a = corner[0], b = corner[1], c = corner[2], d = corner[3];
    const double u = fade[0].u, v = fade[1].u;
    const double k0 = a, k1 = b - a, k2 = c - a, k4 = a - b - c + d;
    if (dimensions == 2) {
        const struct blend plane = {
            .n = k0 + k1 * u + k2 * v + k4 * u * v,
            .n1 = {k1 + k4 * v, k2 + k4 * u},
            .n2 = {{0.0, k4}, {k4, 0.0}},
        };
        return plane;
    }
    const double e = corner[4], f = corner[5], g = corner[6], h = corner[7];
    const double w = fade[2].u;
    const double k3 = e - a, k5 = a - c - e + g, k6 = a - b - e + f;
    const double k7 = -a + b + c - d + e - f - g + h;
    const double uv = k4 + k7 * w, vw = k5 + k7 * u, wu = k6 + k7 * v;
    const struct blend space = {
        .n = k0 + k1 * u + k2 * v + k3 * w + k4 * u * v + k5 * v * w + k6 * w * u + k7 * u * v * w,
        .n1 = {k1 + k4 * v + k6 * w + k7 * v * w, k2 + k5 * w + k4 * u + k7 * w * u,
               k3 + k6 * u + k5 * v + k7 * u * v},
        .n2 = {{0.0, uv, wu}, {uv, 0.0, vw}, {wu, vw, 0.0}},
    };
    return space;
}

/* Draws the corners a ... h. */
static void draw_corners(oracle_draw *draw, const void *lattice, int dimensions,
                         const uint32_t cell[3], double corner[8][3])
{
    for (uint32_t i = 0; i < 1u << dimensions; i++) {
        const uint32_t point[3] = {cell[0] + (i & 1), cell[1] + (i >> 1 & 1),
                                   dimensions == 3 ? cell[2] + (i >> 2) : 0};
        draw(lattice, point, corner[i]);
    }
}

void oracle_value_noise(oracle_draw *draw, const void *lattice, int dimensions,
                        enum scarp_fade fade, const uint32_t cell[3], const double t[3],
                        struct oracle_sample *n)
{
    double corner[8][3], value[8] = {0.0};
    draw_corners(draw, lattice, dimensions, cell, corner);
    for (int i = 0; i < 1 << dimensions; i++) {
        value[i] = corner[i][0];
    }
    struct fade f[3] = {{0.0, 0.0, 0.0}};
    for (int i = 0; i < dimensions; i++) {
        f[i] = fade_at(fade, t[i]);
    }
    const struct blend b = blend(value, dimensions, f);
    *n = (struct oracle_sample){.value = b.n, .clearance = 1.0, .nearest = 1.0};
    for (int i = 0; i < dimensions; i++) {
        n->gradient[i] = f[i].du * b.n1[i];
        for (int j = 0; j < dimensions; j++) {
            n->hessian[i][j] = i == j ? f[i].ddu * b.n1[i] : f[i].du * f[j].du * b.n2[i][j];
        }
    }
}

void oracle_gradient_noise(oracle_draw *draw, const void *lattice, int dimensions,
                           enum scarp_fade fade, const uint32_t cell[3], const double t[3],
                           struct oracle_sample *n)
{
    double corner[8][3];
    draw_corners(draw, lattice, dimensions, cell, corner);
    double dot[8] = {0.0}, component[3][8] = {{0.0}};
    for (int i = 0; i < 1 << dimensions; i++) {
        for (int axis = 0; axis < dimensions; axis++) {
            component[axis][i] = corner[i][axis];
            dot[i] += corner[i][axis] * (t[axis] - (double)(i >> axis & 1));
        }
    }
    struct fade f[3] = {{0.0, 0.0, 0.0}};
    for (int i = 0; i < dimensions; i++) {
        f[i] = fade_at(fade, t[i]);
    }
    const struct blend d = blend(dot, dimensions, f);
    struct blend g[3];
    for (int i = 0; i < dimensions; i++) {
        g[i] = blend(component[i], dimensions, f);
    }
    *n = (struct oracle_sample){.value = d.n, .clearance = 1.0, .nearest = 1.0};
    for (int i = 0; i < dimensions; i++) {
        n->gradient[i] = g[i].n + f[i].du * d.n1[i];
        for (int j = 0; j < dimensions; j++) {
            n->hessian[i][j] = f[j].du * g[i].n1[j] + f[i].du * g[j].n1[i] +
                               (i == j ? f[i].ddu * d.n1[i] : f[i].du * f[j].du * d.n2[i][j]);
        }
    }
}
