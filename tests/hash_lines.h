/* SPDX-License-Identifier: MIT
 *
 * The statistics that tests/test_hash.c takes of whole lattice lines, by Fourier transform: whether
 * a line is nearly periodic, and whether it follows another line, of its own lattice or of another
 * seed or octave, at any shift.
 *
 * A line of random numbers has a power at each frequency that is exponentially distributed: P(power
 * > p times the mean) = exp(-p). 10^8 of them, as many as are looked at, stay below 19 typically,
 * and below 30 but once in 10^5.
 */
#ifndef SCARP_TESTS_HASH_LINES_H
#define SCARP_TESTS_HASH_LINES_H

#include "../src/scalar/sample.h"

#include "../src/formulas/basis.h"
#include "hash_fields.h"
#include "hash_stats.h"

#define LINE_BITS 10
#define LINE_CELLS (1 << LINE_BITS)
#define LINE_SEEDS 4
#define LINES_PER_SEED 6000 /* with 2^20 points in a block; fewer in proportion */
#define LINES_PER_PAIR 600
#define FIRST_LINE 2550 /* the known periodic line of product_hash is y = 2596 of seed 1 */

struct complex {
    double re, im;
};

/* Two lines, one in the real and one in the imaginary parts, and space for a transform. */
struct line_space {
    struct complex line[LINE_CELLS], turn[LINE_CELLS / 2];
    uint32_t hash[LINE_CELLS];
};

static inline void line_space_make(struct line_space *s)
{
    for (int k = 0; k < LINE_CELLS / 2; k++) {
        const double angle = -2.0 * 3.14159265358979323846 * k / LINE_CELLS;
        s->turn[k] = (struct complex){cos(angle), sin(angle)};
    }
}

/* Transforms s->line in place by the discrete Fourier transform: radix 2, decimation in time. */
static inline void transform(struct line_space *s)
{
    for (unsigned i = 0; i < LINE_CELLS; i++) {
        unsigned j = 0;
        for (int bit = 0; bit < LINE_BITS; bit++) {
            j |= (i >> bit & 1) << (LINE_BITS - 1 - bit);
        }
        if (i < j) {
            const struct complex swapped = s->line[i];
            s->line[i] = s->line[j];
            s->line[j] = swapped;
        }
    }
    for (int half = 1; half < LINE_CELLS; half *= 2) {
        for (int begin = 0; begin < LINE_CELLS; begin += 2 * half) {
            for (int i = 0; i < half; i++) {
                const struct complex w = s->turn[LINE_CELLS / 2 / half * i];
                struct complex *const a = &s->line[begin + i], *const b = a + half;
                const struct complex p = {w.re * b->re - w.im * b->im, w.re * b->im + w.im * b->re};
                *b = (struct complex){a->re - p.re, a->im - p.im};
                *a = (struct complex){a->re + p.re, a->im + p.im};
            }
        }
    }
}

/* The hashes of line `number` along an axis, from the cell 0 on. */
static inline void hash_line(const struct hash *hash, const uint32_t key[3], int dimensions,
                             int axis, int number, uint32_t *out)
{
    uint32_t point[3] = {0, 0, 0};
    const uint32_t other = (uint32_t)(FIRST_LINE + number);
    if (dimensions == 2) {
        point[1 - axis] = other;
    } else {
        point[(axis + 1) % 3] = other & 127;
        point[(axis + 2) % 3] = other >> 7;
    }
    hash_row_fn *const row = dimensions == 2 ? hash->row2 : hash->row3;
    if (axis == 0) {
        row(key, point[0], point[1], point[2], LINE_CELLS, out);
        return;
    }
    for (int i = 0; i < LINE_CELLS; i++, point[axis]++) {
        row(key, point[0], point[1], point[2], 1, &out[i]);
    }
}

/* These give what the noises draw: the lattice value, and the x component of the gradient. */
static inline double drawn_value(uint32_t hash)
{
    return (double)(int32_t)hash * 0x1p-31;
}

static inline double drawn_gradient(int dimensions, uint32_t hash)
{
    return (double)(dimensions == 2 ? directions2[direction_index2(hash)]
                                    : directions3[direction_index3(hash)])[0];
}

/* The powers of both lines at frequency k. */
static inline void line_powers(const struct line_space *s, int k, double power[2])
{
    const struct complex a = s->line[k], b = s->line[(LINE_CELLS - k) % LINE_CELLS];
    power[0] = (a.re + b.re) * (a.re + b.re) + (a.im - b.im) * (a.im - b.im);
    power[1] = (a.re - b.re) * (a.re - b.re) + (a.im + b.im) * (a.im + b.im);
}

/* Reports the highest peak in the spectra of a line's values and gradients, in units of their
 * means. */
static inline void test_spectrum(struct report *report, const struct hash *hash, uint64_t seed,
                                 int dimensions, int axis, int number, struct line_space *s)
{
    uint32_t key[3];
    seed_keys(seed, 0, key);
    hash_line(hash, key, dimensions, axis, number, s->hash);
    for (int i = 0; i < LINE_CELLS; i++) {
        s->line[i].re = drawn_value(s->hash[i]);
        s->line[i].im = drawn_gradient(dimensions, s->hash[i]);
    }
    transform(s);
    double sum[2] = {0.0, 0.0}, peak[2] = {0.0, 0.0};
    for (int k = 1; k < LINE_CELLS / 2; k++) {
        double power[2];
        line_powers(s, k, power);
        for (int i = 0; i < 2; i++) {
            sum[i] += power[i];
            peak[i] = fmax(peak[i], power[i]);
        }
    }
    for (int i = 0; i < 2; i++) {
        REPORT(report, TOPIC_SPECTRA, peak[i] / (sum[i] / (LINE_CELLS / 2 - 1)),
               "%s, %dD, line %d along axis %d, seed %llu", i == 0 ? "value" : "gradient",
               dimensions, FIRST_LINE + number, axis, (unsigned long long)seed);
    }
}

static inline int lines_of(int lines, int bits)
{
    return bits < 20 ? lines >> (20 - bits) : lines;
}

static inline void test_spectra(struct report *report, const struct hash *hash, int bits)
{
    struct line_space s;
    line_space_make(&s);
    for (int dimensions = 2; dimensions <= 3; dimensions++) {
        for (int axis = 0; axis < dimensions; axis++) {
            for (int seed = 0; seed < LINE_SEEDS; seed++) {
                for (int i = 0; i < lines_of(LINES_PER_SEED, bits); i++) {
                    test_spectrum(report, hash, (uint64_t)seed, dimensions, axis, i, &s);
                }
            }
        }
    }
}

/* Two lattices, or one and its next line. */
struct line_pair {
    const char *name;
    uint64_t seed;
    int octave, next_line;
};

/* The greatest correlation of two lines' values over all shifts, as z: for random numbers each is
   nearly normal. It is computed as the transform of the cross spectrum (Wiener, Khinchin). */
static inline double shifted_z(struct line_space *s)
{
    transform(s);
    double powers[2] = {0.0, 0.0};
    struct complex cross[LINE_CELLS];
    cross[0] = (struct complex){0.0, 0.0}; /* the means are taken away */
    for (int k = 1; k < LINE_CELLS; k++) {
        const struct complex a = s->line[k], b = s->line[LINE_CELLS - k];
        const struct complex u = {a.re + b.re, a.im - b.im}, v = {a.im + b.im, b.re - a.re};
        double power[2];
        line_powers(s, k, power);
        powers[0] += power[0];
        powers[1] += power[1];
        cross[k] = (struct complex){u.re * v.re + u.im * v.im, u.im * v.re - u.re * v.im};
    }
    memcpy(s->line, cross, sizeof cross);
    transform(s);
    double largest = 0.0;
    for (int i = 0; i < LINE_CELLS; i++) {
        largest = fmax(largest, fabs(s->line[i].re));
    }
    return largest / sqrt(powers[0] * powers[1]) * sqrt(LINE_CELLS);
}

static inline void test_line_pair(struct report *report, const struct hash *hash, uint64_t seed,
                                  const struct line_pair *pair, int dimensions, int axis,
                                  int number, struct line_space *s)
{
    uint32_t key[3], other[3];
    seed_keys(seed, 0, key);
    seed_keys(seed + pair->seed, pair->octave, other);
    hash_line(hash, key, dimensions, axis, number, s->hash);
    for (int i = 0; i < LINE_CELLS; i++) {
        s->line[i].re = drawn_value(s->hash[i]);
    }
    hash_line(hash, other, dimensions, axis, number + pair->next_line, s->hash);
    for (int i = 0; i < LINE_CELLS; i++) {
        s->line[i].im = drawn_value(s->hash[i]);
    }
    REPORT(report, TOPIC_LINES, shifted_z(s), "%s, %dD, line %d along axis %d, seed %llu",
           pair->name, dimensions, FIRST_LINE + number, axis, (unsigned long long)seed);
}

static inline void test_line_pairs(struct report *report, const struct hash *hash, int bits)
{
    static const struct line_pair pairs[] = {
        {"next seed", 1, 0, 0}, {"octaves 0 and 1", 0, 1, 0}, {"next line", 0, 0, 1}};
    struct line_space s;
    line_space_make(&s);
    for (int dimensions = 2; dimensions <= 3; dimensions++) {
        for (int axis = 0; axis < dimensions; axis++) {
            for (size_t p = 0; p < sizeof pairs / sizeof pairs[0]; p++) {
                for (int i = 0; i < LINE_SEEDS * lines_of(LINES_PER_PAIR, bits); i++) {
                    test_line_pair(report, hash, (uint64_t)(i % LINE_SEEDS), &pairs[p], dimensions,
                                   axis, i / LINE_SEEDS, &s);
                }
            }
        }
    }
}

#endif
