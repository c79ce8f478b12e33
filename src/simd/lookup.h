/* SPDX-License-Identifier: MIT
 *
 * The table type of vf_lookup (vec.h). Included by each vec_<isa>.h.
 */
#ifndef SCARP_SIMD_LOOKUP_H
#define SCARP_SIMD_LOOKUP_H

/*
 * 16 floats, with a period and a mirror:
 *   entry[i] = entry[i % period] for i < 8, period 4 or 8;
 *   entry[i + 8] = mirrored ? -entry[i] : entry[i].
 * Tables are compile-time constants, so an ISA branches on these facts at no cost.
 */
struct lookup {
    _Alignas(64) float entry[16];
    int period;
    int mirrored;
};

#define LOOKUP_4(a, b, c, d, sign) LOOKUP_TABLE(a, b, c, d, a, b, c, d, sign, 4)
#define LOOKUP_8(a, b, c, d, e, f, g, h, sign) LOOKUP_TABLE(a, b, c, d, e, f, g, h, sign, 8)
#define LOOKUP_TABLE(a, b, c, d, e, f, g, h, s, p)                                                 \
    {                                                                                              \
        .entry = {a, b, c, d, e, f, g, h, (s)*a, (s)*b, (s)*c, (s)*d, (s)*e, (s)*f, (s)*g, (s)*h}, \
        .period = (p), .mirrored = (s) < 0                                                         \
    }

#endif
