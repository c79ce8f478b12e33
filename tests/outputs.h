/* SPDX-License-Identifier: MIT
 *
 * The outputs in one list, the sample functions behind one call and the grids behind another,
 * arrays for all outputs, comparison by bits: what all tests that call the library have in common.
 */
#ifndef SCARP_TESTS_OUTPUTS_H
#define SCARP_TESTS_OUTPUTS_H

#include "../src/plan/traits.h"
#include "check.h"

/* Every output, in the order of struct scarp_samples: its member, how often it is derived, and
   along which axes (0, 1, 2; -1 where there is none, as for the phase). Other tests use this list.
 */
#define OUTPUTS_LIST(OUTPUT)                                                                       \
    OUTPUT(value, 0, -1, -1)                                                                       \
    OUTPUT(dx, 1, 0, -1)                                                                           \
    OUTPUT(dy, 1, 1, -1)                                                                           \
    OUTPUT(dz, 1, 2, -1)                                                                           \
    OUTPUT(dxx, 2, 0, 0)                                                                           \
    OUTPUT(dxy, 2, 0, 1)                                                                           \
    OUTPUT(dxz, 2, 0, 2)                                                                           \
    OUTPUT(dyy, 2, 1, 1)                                                                           \
    OUTPUT(dyz, 2, 1, 2)                                                                           \
    OUTPUT(dzz, 2, 2, 2)                                                                           \
    OUTPUT(dphase, 1, -1, -1)

#define OUTPUT_NUMBER(name, order, a, b) OUTPUT_##name,
#define OUTPUT_NAME(name, order, a, b) #name,
#define OUTPUT_AXES(name, order, a, b) {order, {a, b}},
#define OUTPUT_IN_PLANE(name, order, a, b) | ((a) < 2 && (b) < 2 ? 1u << OUTPUT_##name : 0)
#define OUTPUT_MEMBER(name, order, a, b) .name = outputs_row(o, mask, OUTPUT_##name, first),

enum { OUTPUTS_LIST(OUTPUT_NUMBER) OUTPUTS };

static const char *const output_names[OUTPUTS] = {OUTPUTS_LIST(OUTPUT_NAME)};

static const struct {
    int order, axes[2];
} output_kinds[OUTPUTS] = {OUTPUTS_LIST(OUTPUT_AXES)};

#define ORDERS 3
#define OUTPUTS_PHASE (1u << OUTPUT_dphase) /* what noise without gradients does not have */
/* The bits of the outputs of a 2D call, and of a 3D call, of every basis. */
#define OUTPUTS_ALL2 ((0u OUTPUTS_LIST(OUTPUT_IN_PLANE)) & ~OUTPUTS_PHASE)
#define OUTPUTS_ALL3 (((1u << OUTPUTS) - 1) & ~OUTPUTS_PHASE)
#define POISON 0xa5

/* The outputs of every basis up to the derivative `order`, by bits. */
static inline unsigned outputs_up_to(int order, int dimensions)
{
    unsigned mask = dimensions == 2 ? OUTPUTS_ALL2 : OUTPUTS_ALL3;
    for (int m = 0; m < OUTPUTS; m++) {
        mask &= output_kinds[m].order > order ? ~(1u << m) : ~0u;
    }
    return mask;
}

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

/* Whether a noise has a basis and a fractal of scarp.h: tests of errors have others, too. */
static inline int noise_is_known(const struct scarp_noise *noise)
{
    return (unsigned)noise->basis < SCARP_BASES && (unsigned)noise->fractal < SCARP_FRACTALS;
}

/* The highest derivative that the noise has: its warps must have it, too. */
static inline int noise_order(const struct scarp_noise *noise)
{
    int order = 2;
    for (; noise != NULL; noise = noise->warp) {
        if (noise_is_known(noise) && fractal_has(noise->fractal, FRACTAL_SLOPES)) {
            order = 1;
        }
    }
    return order;
}

/* The outputs that it has for this noise: erosion and what bends have no second derivatives; noise
   of another basis than gradients has no phase, and what bends no derivative with respect to it. */
static inline unsigned outputs_of(const struct scarp_noise *noise, enum function f)
{
    const int flows = noise_is_known(noise) && basis_has(noise->basis, BASIS_FLOWS) &&
                      !fractal_bends(noise->fractal);
    return outputs_up_to(noise_order(noise), function_dimensions(f)) | (flows ? OUTPUTS_PHASE : 0u);
}

/* Whether its derivatives are continuous everywhere. */
static inline int basis_smooth(enum scarp_basis basis)
{
    return !basis_has(basis, BASIS_CREASES | BASIS_JUMPS);
}

/* Takes from a noise what its basis cannot have, so that calls accept it: a phase, and a period
   across the rows of 2D simplex noise. */
static inline void fit_noise(struct scarp_noise *noise, int dimensions)
{
    noise->phase = basis_has(noise->basis, BASIS_FLOWS) ? noise->phase : 0.0f;
    for (int axis = basis_axes_with_period(noise->basis, dimensions); axis < dimensions; axis++) {
        noise->period[axis] = 0;
    }
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

/* The call for vector noise that takes the same points. */
static inline enum scarp_status vector_call(enum function f, const struct scarp_noise *noise,
                                            size_t count, const struct inputs *in,
                                            const struct scarp_samples *out)
{
    switch (f) {
    case SAMPLE2: return scarp_vector2(noise, count, in->f[0], in->f[1], out);
    case SAMPLE3: return scarp_vector3(noise, count, in->f[0], in->f[1], in->f[2], out);
    case SAMPLE2_F64: return scarp_vector2_f64(noise, count, in->d[0], in->d[1], out);
    default: return scarp_vector3_f64(noise, count, in->d[0], in->d[1], in->d[2], out);
    }
}

static inline enum scarp_status grid_call(int dimensions, const struct scarp_noise *noise,
                                          const struct scarp_grid *grid,
                                          const struct scarp_samples *out)
{
    return dimensions == 2 ? scarp_grid2(noise, grid, out) : scarp_grid3(noise, grid, out);
}

/* An array of `capacity` floats for every output. */
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

static inline float *outputs_row(const struct outputs *o, unsigned mask, int m, size_t first)
{
    return (mask >> m & 1) != 0 && o->array[m] != NULL ? o->array[m] + first : NULL;
}

/* The members of `mask`, from element `first` on; the others NULL. */
static inline struct scarp_samples outputs_at(const struct outputs *o, unsigned mask, size_t first)
{
    const struct scarp_samples s = {OUTPUTS_LIST(OUTPUT_MEMBER)};
    return s;
}

static inline struct scarp_samples outputs_subset(const struct outputs *o, unsigned mask)
{
    return outputs_at(o, mask, 0);
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

/* The bits of a float, the same for all NaNs. Works with -ffast-math too, which assumes that NaN
   does not exist. */
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
    size_t i = memcmp(a, b, count * sizeof *a) == 0 ? count : 0; /* usually all are equal */
    while (i < count && float_bits(a + i) == float_bits(b + i)) {
        i++;
    }
    return i;
}

/* Whether the first `count` elements of the members of `mask` agree, as far as both have arrays. If
   not, *member and *index say where. */
static inline int outputs_equal(const struct outputs *a, const struct outputs *b, unsigned mask,
                                size_t count, int *member, size_t *index)
{
    for (int m = 0; m < OUTPUTS; m++) {
        if ((mask >> m & 1) != 0 && a->array[m] != NULL) {
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
            for (int shift = 0; shift < 32; shift += 8) {
                hash = fnv_byte(hash, bits >> shift & 255);
            }
        }
    }
    return hash;
}

#endif
