/* SPDX-License-Identifier: MIT
 *
 * Reference: value noise. Its lattice values are in units of 2^-31; the plan's amplitudes carry the
 * factor. Included by basis.h.
 */
#ifndef SCARP_SCALAR_VALUE_H
#define SCARP_SCALAR_VALUE_H

#include "columns.h"

/* A lattice value, in units of 2^-31: the hash as a signed number, rounded to float. */
static inline float lattice_value(uint32_t hash)
{
    return (float)(int32_t)hash;
}

static inline struct column value_column2(const uint32_t key[3], uint32_t x, const struct place *p,
                                          struct fade v)
{
    const float c0 = lattice_value(hash2(key, x, p->cell[1][0]));
    const float c1 = lattice_value(hash2(key, x, p->cell[1][1]));
    const float d = c1 - c0;
    const struct column c = {
        .value.b = c0 + v.u * d, .y.b = v.du * d, .yy.b = v.ddu * d, .flat = 1};
    return c;
}

static inline struct column value_column3(const uint32_t key[3], uint32_t x, const struct place *p,
                                          struct fade v, struct fade w)
{
    const uint32_t *const y = p->cell[1], *const z = p->cell[2];
    const float c00 = lattice_value(hash3(key, x, y[0], z[0]));
    const float c01 = lattice_value(hash3(key, x, y[0], z[1]));
    const float c10 = lattice_value(hash3(key, x, y[1], z[0]));
    const float c11 = lattice_value(hash3(key, x, y[1], z[1]));
    const float dz0 = c01 - c00;
    const float dz1 = c11 - c10;
    const float e0 = c00 + w.u * dz0;
    const float e1 = c10 + w.u * dz1;
    const float dy = e1 - e0;
    const float ddz = dz1 - dz0;
    const float dz = dz0 + v.u * ddz; /* interpolated over y */
    const struct column c = {
        .value.b = e0 + v.u * dy,
        .y.b = v.du * dy,
        .z.b = w.du * dz,
        .yy.b = v.ddu * dy,
        .yz.b = v.du * (w.du * ddz),
        .zz.b = w.ddu * dz,
        .flat = 1,
    };
    return c;
}

static inline struct column value_column(const uint32_t key[3], uint32_t x, const struct place *p,
                                         enum scarp_fade kind, int dimensions)
{
    const struct fade v = fade(kind, p->t[1]);
    return dimensions == 2 ? value_column2(key, x, p, v)
                           : value_column3(key, x, p, v, fade(kind, p->t[2]));
}

#endif
