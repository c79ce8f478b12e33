/* SPDX-License-Identifier: MIT
 *
 * Formulas: velocities without divergence. Each number is a difference of two derivatives of
 * potentials, in the plane one derivative.
 */
#ifndef SCARP_FORMULAS_CURL_H
#define SCARP_FORMULAS_CURL_H

#include "warp.h"

/* A velocity without divergence, and the rows of its Jacobian: the derivatives of each component.
 */
struct flow {
    vec3 velocity;
    vec3 x;
    vec3 y;
    vec3 z;
};

/* Of a potential in the plane, v = (psi_y, -psi_x); nothing along z. */
static inline struct flow curl_in_plane(struct sample psi)
{
    struct flow f;
    f.velocity = vec3_of(psi.gradient.y, -psi.gradient.x, 0.0f);
    f.x = vec3_of(psi.mixed.x, psi.diagonal.y, 0.0f);
    f.y = vec3_of(-psi.diagonal.x, -psi.mixed.x, 0.0f);
    f.z = vec3_of(0.0f, 0.0f, 0.0f);
    return f;
}

/* Of three potentials, with i, j, k = x, y, z in turn, v_i = d_j psi_k - d_k psi_j. */
static inline struct flow curl_in_space(struct displaced psi)
{
    const struct rows a = hessian_of(psi.x);
    const struct rows b = hessian_of(psi.y);
    const struct rows c = hessian_of(psi.z);
    struct flow f;
    f.velocity = vec3_of(psi.z.gradient.y - psi.y.gradient.z, psi.x.gradient.z - psi.z.gradient.x,
                         psi.y.gradient.x - psi.x.gradient.y);
    f.x = sub3(c.y, b.z);
    f.y = sub3(a.z, c.x);
    f.z = sub3(b.x, a.y);
    return f;
}

#endif
