/* SPDX-License-Identifier: MIT
 *
 * Numbers made of the bytes of an input: the same on every machine. Behind its end an input has
 * zeros, which stand for what is usual.
 */
#ifndef SCARP_TESTS_DRAW_H
#define SCARP_TESTS_DRAW_H

#include <math.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

struct draw {
    const uint8_t *at;
    size_t left;
};

static inline uint32_t draw_byte(struct draw *d)
{
    if (d->left == 0) {
        return 0;
    }
    d->left--;
    return *d->at++;
}

static inline uint64_t draw_bits(struct draw *d, int bytes)
{
    uint64_t bits = 0;
    for (int i = 0; i < bytes; i++) {
        bits |= (uint64_t)draw_byte(d) << (8 * i);
    }
    return bits;
}

/* Below `count`, which is at most 256. */
static inline uint32_t draw_below(struct draw *d, uint32_t count)
{
    return draw_byte(d) % count;
}

/* True once in `often` times. */
static inline int draw_rarely(struct draw *d, uint32_t often)
{
    return draw_byte(d) % often == often - 1;
}

/* Any bits at all, or a number that calls may have trouble with. */
static inline double draw_wild(struct draw *d)
{
    static const double special[] = {
        0.0,    -0.0,      1.0,        -1.0,     0.5,       2.0,         0x1p-24,  0x1p24,
        0x1p60, -0x1p60,   0x1p-60,    0x1p31,   0x1p53,    -0x1p53,     0x1p-126, 0x1p-149,
        1e-300, 0x1p-1074, 0x1.8p1023, INFINITY, -INFINITY, (double)NAN, 32.0,     33.0,
    };
    const uint32_t kind = draw_below(d, 32);
    if (kind < sizeof special / sizeof special[0]) {
        return special[kind];
    }
    double number;
    const uint64_t bits = draw_bits(d, 8);
    memcpy(&number, &bits, sizeof number);
    return number;
}

/* From `lowest` to `highest`, ends included. All compilers agree, since none may fuse these
   operations: scarp_compile_rules sees to it. */
static inline double draw_between(struct draw *d, double lowest, double highest)
{
    return lowest + (highest - lowest) * ((double)draw_bits(d, 2) / 65535.0);
}

/* The same, but all powers of two are as likely. Both ends are positive. */
static inline double draw_scale(struct draw *d, double lowest, double highest)
{
    int first, last;
    frexp(lowest, &first);
    frexp(highest, &last);
    const int exponent = first + (int)(draw_bits(d, 2) % (uint64_t)(last - first + 1));
    const double number = ldexp(draw_between(d, 0.5, 1.0), exponent);
    return number < lowest ? lowest : number > highest ? highest : number;
}

#endif
