/* SPDX-License-Identifier: MIT
 *
 * The four sample functions behind one call, arrays for all of their outputs, and comparison by
 * bits: what test_api.c, test_special.c, test_fpmode.c and test_threads.c have in common.
 */
#ifndef SCARP_TESTS_OUTPUTS_H
#define SCARP_TESTS_OUTPUTS_H

#include "check.h"

#define OUTPUTS 10
#define OUTPUTS_ALL2 0x0b7u /* the bits of the outputs that a 2D call has */
#define OUTPUTS_ALL3 0x3ffu
#define POISON 0xa5

static const char *const output_names[OUTPUTS] = {"value", "dx",  "dy",  "dz",  "dxx",
                                                  "dxy",   "dxz", "dyy", "dyz", "dzz"};

enum function { SAMPLE2, SAMPLE3, SAMPLE2_F64, SAMPLE3_F64, FUNCTIONS };

static const char *const function_names[FUNCTIONS] = {"scarp_sample2", "scarp_sample3",
                                                      "scarp_sample2_f64", "scarp_sample3_f64"};

static inline int function_dimensions(enum function f)
{
    return f == SAMPLE2 || f == SAMPLE2_F64 ? 2 : 3;
}

static inline int function_doubles(enum function f)
{
    return f == SAMPLE2_F64 || f == SAMPLE3_F64;
}

static inline unsigned function_outputs(enum function f)
{
    return function_dimensions(f) == 2 ? OUTPUTS_ALL2 : OUTPUTS_ALL3;
}

/* Those that it has for this noise: erosion has no second derivatives. */
static inline unsigned outputs_of(const struct scarp_noise *noise, enum function f)
{
    return function_outputs(f) & (noise->fractal == SCARP_EROSION ? 0xfu : OUTPUTS_ALL3);
}

/* Coordinates in both precisions; a function takes its own. */
struct inputs {
    const float *f[3];
    const double *d[3];
};

static inline enum scarp_status function_call(enum function f, const struct scarp_noise *noise,
                                              size_t count, const struct inputs *in,
                                              const struct scarp_samples *out)
{
    switch (f) {
    case SAMPLE2: return scarp_sample2(noise, count, in->f[0], in->f[1], out);
    case SAMPLE3: return scarp_sample3(noise, count, in->f[0], in->f[1], in->f[2], out);
    case SAMPLE2_F64: return scarp_sample2_f64(noise, count, in->d[0], in->d[1], out);
    default: return scarp_sample3_f64(noise, count, in->d[0], in->d[1], in->d[2], out);
    }
}

/* Ten arrays of `capacity` floats. */
struct outputs {
    size_t capacity;
    float *array[OUTPUTS];
};

static inline void *check_allocate(size_t bytes)
{
    void *const memory = malloc(bytes);
    if (memory == NULL) {
        printf("out of memory\n");
        exit(EXIT_FAILURE);
    }
    return memory;
}

static inline void outputs_poison(const struct outputs *o)
{
    for (int m = 0; m < OUTPUTS; m++) {
        if (o->array[m] != NULL) {
            memset(o->array[m], POISON, o->capacity * sizeof(float));
        }
    }
}

static inline struct outputs outputs_make(size_t capacity)
{
    struct outputs o = {.capacity = capacity};
    for (int m = 0; m < OUTPUTS; m++) {
        o.array[m] = check_allocate(capacity * sizeof(float));
    }
    outputs_poison(&o);
    return o;
}

static inline void outputs_free(struct outputs *o)
{
    for (int m = 0; m < OUTPUTS; m++) {
        free(o->array[m]);
    }
}

/* The members of `mask`; the others NULL. */
static inline struct scarp_samples outputs_subset(const struct outputs *o, unsigned mask)
{
    float *p[OUTPUTS];
    for (int m = 0; m < OUTPUTS; m++) {
        p[m] = (mask >> m & 1) != 0 ? o->array[m] : NULL;
    }
    const struct scarp_samples s = {.value = p[0],
                                    .dx = p[1],
                                    .dy = p[2],
                                    .dz = p[3],
                                    .dxx = p[4],
                                    .dxy = p[5],
                                    .dxz = p[6],
                                    .dyy = p[7],
                                    .dyz = p[8],
                                    .dzz = p[9]};
    return s;
}

/* Whether `bytes` bytes are all poison. */
static inline int all_poison(const void *memory, size_t bytes)
{
    const unsigned char *const p = memory;
    for (size_t i = 0; i < bytes; i++) {
        if (p[i] != POISON) {
            return 0;
        }
    }
    return 1;
}

static inline int outputs_untouched(const struct outputs *o, unsigned mask)
{
    for (int m = 0; m < OUTPUTS; m++) {
        if ((mask >> m & 1) != 0 && !all_poison(o->array[m], o->capacity * sizeof(float))) {
            return 0;
        }
    }
    return 1;
}

/* The bits of a float, all NaNs alike; safe where -ffast-math believes that NaN does not exist. */
static inline uint32_t float_bits(const float *value)
{
    uint32_t bits;
    memcpy(&bits, value, sizeof bits);
    return (bits & 0x7fffffffu) > 0x7f800000u ? 0x7fc00000u : bits;
}

static inline float float_of_bits(uint32_t bits)
{
    float value;
    memcpy(&value, &bits, sizeof value);
    return value;
}

static inline int is_nan_bits(const float *value)
{
    return float_bits(value) == 0x7fc00000u;
}

static inline int is_finite_bits(const float *value)
{
    return (float_bits(value) & 0x7f800000u) != 0x7f800000u;
}

static inline size_t first_difference(const float *a, const float *b, size_t count)
{
    size_t i = 0;
    while (i < count && float_bits(a + i) == float_bits(b + i)) {
        i++;
    }
    return i;
}

/* Whether the first `count` elements of the members of `mask` agree, and where they do not. */
static inline int outputs_equal(const struct outputs *a, const struct outputs *b, unsigned mask,
                                size_t count, int *member, size_t *index)
{
    for (int m = 0; m < OUTPUTS; m++) {
        if ((mask >> m & 1) != 0) {
            const size_t i = first_difference(a->array[m], b->array[m], count);
            if (i < count) {
                *member = m;
                *index = i;
                return 0;
            }
        }
    }
    return 1;
}

/* FNV-1a over the members of `mask`, NaNs alike, the same for either byte order. */
static inline uint64_t outputs_hash(uint64_t hash, const struct outputs *o, unsigned mask,
                                    size_t count)
{
    for (int m = 0; m < OUTPUTS; m++) {
        for (size_t i = 0; (mask >> m & 1) != 0 && i < count; i++) {
            const uint32_t bits = float_bits(o->array[m] + i);
            for (int byte = 0; byte < 4; byte++) {
                hash = (hash ^ (bits >> 8 * byte & 255)) * UINT64_C(0x100000001b3);
            }
        }
    }
    return hash;
}

#define FNV_BASIS UINT64_C(0xcbf29ce484222325)

#endif
