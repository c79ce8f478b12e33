/* SPDX-License-Identifier: MIT
 *
 * Reference: velocity from potentials. In the plane, of the noise psi,
 *
 *     v = (psi_y, -psi_x);   the Jacobian is ((psi_xy, psi_yy), (-psi_xx, -psi_xy))
 *
 * In space, of three potentials, with i, j, k = 0, 1, 2 in turn,
 *
 *     v_i = d_j psi_k - d_k psi_j;   d_m v_i = d_j d_m psi_k - d_k d_m psi_j
 *
 * Each is one subtraction.
 */
#ifndef SCARP_SCALAR_CURL_H
#define SCARP_SCALAR_CURL_H

#include "warp.h"

static void curl2_at(float of[FLOW_OUTPUTS], const struct scarp_call_plan *plan,
                     const struct point *x)
{
    const struct outputs psi = sample_at(plan, x, 2);
    of[FLOW_V + 0] = psi.of[DY];
    of[FLOW_V + 1] = -psi.of[DX];
    for (int m = 0; m < 2; m++) {
        of[FLOW_JACOBIAN + m] = psi.of[second(1, m)];
        of[FLOW_JACOBIAN + 3 + m] = -psi.of[second(0, m)];
    }
}

/* Outputs that the dimensions do not have are 0. */
static void curl_at(float of[FLOW_OUTPUTS], const struct scarp_call_plan *plan,
                    const struct point *x, int dimensions)
{
    struct outputs psi[3];
    memset(of, 0, FLOW_OUTPUTS * sizeof *of);
    if (dimensions == 2) {
        curl2_at(of, plan, x);
        return;
    }
    for (int i = 0; i < 3; i++) {
        psi[i] = component_at(plan, x, 3, i);
    }
    for (int i = 0; i < 3; i++) {
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        of[FLOW_V + i] = psi[k].of[DX + j] - psi[j].of[DX + k];
        for (int m = 0; m < 3; m++) {
            of[FLOW_JACOBIAN + 3 * i + m] = psi[k].of[second(j, m)] - psi[j].of[second(k, m)];
        }
    }
}

#endif
