/* SPDX-License-Identifier: MIT
 *
 * Reference: the directions of gradients.
 */
#ifndef SCARP_SCALAR_DIRECTIONS_H
#define SCARP_SCALAR_DIRECTIONS_H

#include "../formulas/c.h"

/* The 16 directions 11.25 degrees + k * 22.5: cosine and sine. Bit 3 of the index is the sign of x,
   bit 0 that of y. */
#define COS_1 0.980785280f /* cos 11.25 */
#define COS_3 0.831469612f /* cos 33.75 */
#define COS_5 0.555570233f /* cos 56.25 */
#define COS_7 0.195090322f /* cos 78.75 */

static const float directions2[16][2] = {
    {COS_1, COS_7},  {COS_1, -COS_7},  {COS_3, COS_5},  {COS_3, -COS_5},
    {COS_5, COS_3},  {COS_5, -COS_3},  {COS_7, COS_1},  {COS_7, -COS_1},
    {-COS_1, COS_7}, {-COS_1, -COS_7}, {-COS_3, COS_5}, {-COS_3, -COS_5},
    {-COS_5, COS_3}, {-COS_5, -COS_3}, {-COS_7, COS_1}, {-COS_7, -COS_1},
};

/* The 12 edges of a cube, the directions of improved noise (Perlin 2002), which draws four of them
   twice as often. The edges are twice as long as Perlin's, because then only the top byte of each
   component is not 0, and tables of bytes serve; products are exact. */
static const float directions3[12][3] = {
    {2, 2, 0},  {2, -2, 0},  {-2, 2, 0}, {-2, -2, 0}, {2, 0, 2},  {2, 0, -2},
    {-2, 0, 2}, {-2, 0, -2}, {0, 2, 2},  {0, 2, -2},  {0, -2, 2}, {0, -2, -2},
};

/* What directions become after a quarter of a turn (scarp.h, "Flow"): in 3D d x g / |d|, with |d| =
   sqrt(3), which is 2 / sqrt(3) times these. */
static const float quarters3[12][3] = {
    {1, -1, 2}, {1, 1, -2}, {-1, -1, -2}, {-1, 1, 2}, {-1, 2, 1},   {-1, -2, -1},
    {1, -2, 1}, {1, 2, -1}, {2, 1, -1},   {-2, 1, 1}, {-2, -1, -1}, {2, -1, 1},
};
#define TWO_OVER_ROOT_3 1.15470054f

static inline vec3 direction2(uint i)
{
    return vec3_of(directions2[i][0], directions2[i][1], 0.0f);
}

static inline vec3 direction3(uint i)
{
    return vec3_of(directions3[i][0], directions3[i][1], directions3[i][2]);
}

static inline vec3 quarter3(uint i)
{
    const float *const q = quarters3[i];
    return vec3_of(TWO_OVER_ROOT_3 * q[0], TWO_OVER_ROOT_3 * q[1], TWO_OVER_ROOT_3 * q[2]);
}

#endif
