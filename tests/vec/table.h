/* SPDX-License-Identifier: MIT
 *
 * The operations of src/simd/vec.h as functions that work on arrays: a table per instruction set,
 * made by operations.h and called by test_vec.c.
 */
#ifndef SCARP_TESTS_VEC_TABLE_H
#define SCARP_TESTS_VEC_TABLE_H

#include "../../src/dispatch/kernels.h"
#include "../../src/simd/lookup.h"

#define LANES_MAX 16

/* Inputs and outputs have an element per lane, unless said otherwise. */
struct vec_operations {
    enum scarp_isa isa;
    int lanes, table; /* VEC_LANES, VF_TABLE */
    void (*copy_f)(float *out, const float *in);
    void (*copy_u)(uint32_t *out, const uint32_t *in);
    void (*copy_d)(double *out, const double *in);
    /* Loads a part of n elements, which `loaded` gets with what is in the other lanes, and stores
       it. Half a vector is the most for doubles, which are not stored. */
    void (*partial_f)(float *out, float *loaded, const float *in, size_t n);
    void (*partial_d)(double *loaded, const double *in, size_t n);
    void (*stream)(float *out, const float *in); /* out is aligned to a vector */
    void (*set_f)(float *out, float a);
    void (*set_u)(uint32_t *out, uint32_t a);
    void (*set_d)(double *out, double a);
    void (*numbers)(uint32_t *out);
    void (*floor_f)(float *out, const float *in);
    void (*floor_d)(double *out, const double *in);
    void (*u_from_f)(uint32_t *out, const float *in);
    void (*f_from_i)(float *out, const uint32_t *in);
    void (*f_from_d)(float *out, const double *in);
    void (*f_stored_d)(float *out, const double *in); /* f_from_d, stored at once */
    void (*d_from_f)(double *out, const float *in);
    void (*low_bits)(uint32_t *out, const double *in);
    void (*sqrt_d)(double *out, const double *in);
    void (*sqrt_f)(float *out, const float *in);
    void (*positive)(float *out, const float *in);
    void (*lesser)(float *out, const float *a, const float *b);
    void (*where)(float *added, float *subtracted, uint32_t *sum, const float *a, const float *b,
                  const uint32_t *bits);
    void (*greater)(float *out, const float *a, const float *b);
    void (*term)(float *out, const float *a, const float *b);
    int (*masks)(float *chosen, uint32_t *kept, const float *a, const float *b);
    /* a b + c, a b being exact */
    void (*exact_fma)(float *out, const float *a, const float *b, const float *c);
    void (*turn8)(uint32_t *out, const uint32_t *in);
    void (*turn16)(uint32_t *out, const uint32_t *in);
    void (*upper_times12)(uint32_t *out, const uint32_t *in);
    void (*upper_times144)(uint32_t *out, const uint32_t *in);
    void (*xor3)(uint32_t *out, const uint32_t *a, const uint32_t *b, const uint32_t *c);
    int (*any)(const uint32_t *in);
    void (*multiply)(uint32_t *out, const uint32_t *a, const uint32_t *b);
    void (*shift)(uint32_t *out, const uint32_t *in, int bits); /* to the right */
    void (*less)(uint32_t *out, const float *a, const float *b);
    void (*not_equal)(uint32_t *out, const float *a, const float *b);
    void (*lookup)(float *out, const struct lookup *table, const uint32_t *hash);
    /* Inputs and outputs are four vectors, one after the other. */
    void (*lookup_four)(float *out, const struct lookup *table, const uint32_t *hash);
    void (*lookup_top)(float *out, const struct lookup_top *table, const uint32_t *hash);
    void (*sixteen)(float *out, float *four, const float *entry, const uint32_t *index);
    void (*sixteen_odd)(float *out, float *four, const float *entry, const uint32_t *hash);
    void (*among)(float *out, const float *entry, const uint32_t *index);
    void (*twelfth)(uint32_t *out, const uint32_t *hash);
    /* `entries` has VF_TABLE floats. With `next`, VF_INDEX_NEXT is added to the index. */
    void (*permute)(float *out, const float *entries, const uint32_t *index, int next);
    /* The same, after the floats of `after` were slid in. */
    void (*slide)(float *out, const float *entries, const float *after, const uint32_t *index);
};

#define VEC_OPERATIONS(table) VEC_OPERATIONS_EXPANDED(table)
#define VEC_OPERATIONS_EXPANDED(table) table##_operations

#define VEC_DECLARE(ISA, table, name, here)                                                        \
    extern const struct vec_operations scarpi_kernels_##table##_operations;
SCARP_ISA_VECTORS(VEC_DECLARE)
#undef VEC_DECLARE

#endif
