/* SPDX-License-Identifier: MIT
 *
 * The gradients of flow noise: tables that the phase turns, made anew for each pass over an octave.
 * The reference is formulas/gradient.h; scarp.h defines it ("Flow").
 */
#ifndef SCARP_KERNEL_BASIS_DIRECTIONS_H
#define SCARP_KERNEL_BASIS_DIRECTIONS_H

#include "../../plan/call.h"

/* The components of 16 gradients; of 12 in 3D, where the others are not used. */
struct directions {
    vf_sixteen of[3];
};

/* Gradients at rest: their components, what these become after a quarter of a turn, and ones for
   those that turn twice as fast. */
struct still {
    float at_rest[3][16], quarter[3][16];
    uint32_t quick[16];
};

#define C1 0.980785280f /* cos 11.25 */
#define C3 0.831469612f /* cos 33.75 */
#define C5 0.555570233f /* cos 56.25 */
#define C7 0.195090322f /* cos 78.75 */
#define Q 0xffffffffu

/* Of the other eight, number i ^ 9 is the opposite of number i. */
static const struct still still2 = {
    .at_rest = {{C1, C1, C3, C3, C5, C5, C7, C7}, {C7, -C7, C5, -C5, C3, -C3, C1, -C1}},
    .quarter = {{-C7, -C7, C5, C5, -C3, -C3, C1, C1}, {C1, -C1, -C3, C3, C5, -C5, -C7, C7}},
    .quick = {0, Q, Q, 0, 0, Q, Q, 0},
};

#undef C1
#undef C3
#undef C5
#undef C7
#define R 1.15470054f /* 2 / sqrt(3) */

static const struct still still3 = {
    .at_rest = {{2, 2, -2, -2, 2, 2, -2, -2, 0, 0, 0, 0},
                {2, -2, 2, -2, 0, 0, 0, 0, 2, 2, -2, -2},
                {0, 0, 0, 0, 2, -2, 2, -2, 2, -2, 2, -2}},
    .quarter = {{R, R, -R, -R, -R, -R, R, R, 2 * R, -2 * R, -2 * R, 2 * R},
                {-R, R, -R, R, 2 * R, -2 * R, -2 * R, 2 * R, R, R, -R, -R},
                {2 * R, -2 * R, -2 * R, 2 * R, R, -R, R, -R, -R, R, -R, R}},
    .quick = {0, 0, Q, Q, Q, Q, 0, 0, Q, 0, 0, Q},
};

#undef Q
#undef R

/* Turns the gradients by the angles of `turn` (struct scarp_octave). */
VEC_INLINE void turn_directions(struct directions *d, const float turn[4], int dimensions)
{
    const struct still *const still = dimensions == 2 ? &still2 : &still3;
    for (int axis = 0; axis < dimensions; axis++) {
        float turned[16];
        for (int i = 0; i < 16; i += VEC_LANES) {
            const vu quick = vu_load(still->quick + i);
            const vf cosine = (vf)vu_choose(quick, (vu)vf_set(turn[2]), (vu)vf_set(turn[0]));
            const vf sine = (vf)vu_choose(quick, (vu)vf_set(turn[3]), (vu)vf_set(turn[1]));
            vf_store(turned + i, cosine * vf_load(still->at_rest[axis] + i) +
                                     sine * vf_load(still->quarter[axis] + i));
        }
        for (int i = 0; dimensions == 2 && i < 8; i++) {
            turned[i ^ 9] = -turned[i];
        }
        d->of[axis] = vf_sixteen_load(turned);
    }
}

/* These two are out of line for the sake of size: passes are many. */
static __attribute__((noinline)) void turn_directions2(struct directions *d, const float turn[4])
{
    turn_directions(d, turn, 2);
}

static __attribute__((noinline)) void turn_directions3(struct directions *d, const float turn[4])
{
    turn_directions(d, turn, 3);
}

#endif
