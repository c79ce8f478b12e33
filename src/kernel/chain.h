/* SPDX-License-Identifier: MIT
 *
 * The chain rule over samples, a block of points at a time; the reference is formulas/chain.h.
 *
 * Each output is a line: a loop over one array, or a few, which writes another. Lines of functions
 * that are given by partial derivatives take these from arrays, which are made first (or come from
 * the caller). All lines of a block are written before the outputs are, which may be where inputs
 * are; but where each output needs only its own member of the inputs, they are written at once.
 * Calls for values only need none of that.
 */
#ifndef SCARP_KERNEL_CHAIN_H
#define SCARP_KERNEL_CHAIN_H

#include <string.h>

#include "../dispatch/kernels.h"
#include "chain_partials.h"

#define CHAIN_POINTS 256 /* a multiple of VEC_LANES */

/* How an output is computed. */
enum chain_line {
    LINE_COPY, /* of f */
    LINE_SCALE_OFFSET,
    LINE_SCALE,
    LINE_SUM,
    LINE_LESSER,
    LINE_GREATER,
    LINE_PRODUCT_VALUE,
    LINE_PRODUCT_FIRST,
    LINE_PRODUCT_SECOND,
    LINE_MIX_VALUE,
    LINE_MIX_FIRST,
    LINE_MIX_SECOND,
    LINE_ONE_FIRST,
    LINE_ONE_SECOND,
    LINE_TWO_FIRST,
    LINE_TWO_SECOND,
    LINE_SMOOTH_SECOND
};

/* By the order of the output. */
static const unsigned char chain_lines[][3] = {
    [CHAIN_AFFINE] = {LINE_SCALE_OFFSET, LINE_SCALE, LINE_SCALE},
    [CHAIN_ADD] = {LINE_SUM, LINE_SUM, LINE_SUM},
    [CHAIN_MULTIPLY] = {LINE_PRODUCT_VALUE, LINE_PRODUCT_FIRST, LINE_PRODUCT_SECOND},
    [CHAIN_MIX] = {LINE_MIX_VALUE, LINE_MIX_FIRST, LINE_MIX_SECOND},
    [CHAIN_MIN] = {LINE_LESSER, LINE_LESSER, LINE_LESSER},
    [CHAIN_MAX] = {LINE_GREATER, LINE_GREATER, LINE_GREATER},
#define SECOND_BENT LINE_ONE_SECOND
#define SECOND_STRAIGHT LINE_ONE_FIRST
#define OPERATOR(NAME, name, FORM, COMPUTED, ...)                                                  \
    IF_ONE_##COMPUTED([CHAIN_##NAME] = {LINE_COPY, LINE_ONE_FIRST, SECOND_##COMPUTED}, )           \
        IF_SMOOTH_##COMPUTED([CHAIN_##NAME] = {LINE_COPY, LINE_TWO_FIRST, LINE_SMOOTH_SECOND}, )
#define FUNCTION(...) OPERATOR(__VA_ARGS__)
#include "../plan/functions.def"
    [CHAIN_APPLY1] = {LINE_COPY, LINE_ONE_FIRST, LINE_ONE_SECOND},
    [CHAIN_APPLY2] = {LINE_COPY, LINE_TWO_FIRST, LINE_TWO_SECOND},
};

/* What is between the stages. */
struct chain_room {
    float partial[PARTIAL_AA + 1][CHAIN_POINTS];
    float result[OUTPUTS][CHAIN_POINTS];
};

VEC_INLINE void chain_partials_loop(const struct scarp_chain *call,
                                    enum scarp_chain_function function, size_t first, size_t count,
                                    struct chain_room *room)
{
    const int two = chain_lines[function][1] == LINE_TWO_FIRST;
    const float *const a = call->in[CHAIN_A][VALUE] + first;
    const float *const b = two ? call->in[CHAIN_B][VALUE] + first : NULL;
    const struct scarp_chain local = *call;
    VEC_ROLLED_LOOP
    for (size_t i = 0; i < count; i += VEC_LANES) {
        const struct chain_partials p = chain_partials_of(&local, function, vf_load(a + i),
                                                          two ? vf_load(b + i) : vf_set(0.0f));
        vf_store(room->partial[PARTIAL_F] + i, p.f);
        vf_store(room->partial[PARTIAL_A] + i, p.a);
        if (two) {
            vf_store(room->partial[PARTIAL_B] + i, p.b);
        }
        if (chain_lines[function][2] != LINE_ONE_FIRST) {
            vf_store(room->partial[PARTIAL_AA] + i, p.aa);
        }
    }
}

/* An array from element `first` on, if it is there. */
VEC_INLINE const float *chain_from(const float *array, size_t first)
{
    return array != NULL ? array + first : NULL;
}

/* Makes the partial derivatives of functions that have them, and says where they are. */
static void chain_take_partials(const float *at[PARTIALS], const struct scarp_chain *call,
                                size_t first, size_t count, struct chain_room *room)
{
#define CHAIN_CASE(NAME)                                                                           \
    case CHAIN_##NAME:                                                                             \
        chain_partials_loop(call, CHAIN_##NAME, first, count, room);                               \
        break;
#define OPERATOR(NAME, name, FORM, COMPUTED, ...)                                                  \
    IF_ONE_##COMPUTED(CHAIN_CASE(NAME)) IF_SMOOTH_##COMPUTED(CHAIN_CASE(NAME))
#define FUNCTION(...) OPERATOR(__VA_ARGS__)
    switch (call->function) {
#include "../plan/functions.def"
    default:
        for (int i = 0; i < PARTIALS; i++) {
            at[i] = chain_from(call->partial[i], first);
        }
        return;
    }
#undef CHAIN_CASE
    for (int i = 0; i <= PARTIAL_AA; i++) {
        at[i] = room->partial[i];
    }
}

/*
 * Lines.
 */

/* An input of a line: the arrays of its value, of the two first derivatives that belong to a second
   one, and of the member that is computed. */
struct chain_arrays {
    const float *value, *i, *j, *member;
};

struct chain_sources {
    struct chain_arrays in[CHAIN_INPUTS];
    const float *partial[PARTIALS];
    float scale, offset;
};

struct chain_terms {
    vf value, i, j, member;
};

/* What a line needs of an input, by the order of the output. */
VEC_INLINE struct chain_terms chain_load(const struct chain_arrays *from, size_t at, int order)
{
    struct chain_terms t;
    t.member = vf_load(from->member + at);
    t.value = order > 0 ? vf_load(from->value + at) : t.member;
    t.i = order > 1 ? vf_load(from->i + at) : t.member;
    t.j = order > 1 ? vf_load(from->j + at) : t.member;
    return t;
}

VEC_INLINE vf chain_product(struct chain_terms a, struct chain_terms b, int order)
{
    if (order == 0) {
        return vf_term(a.value, b.value);
    }
    const vf linear = vf_term(b.value, a.member) + vf_term(a.value, b.member);
    return order == 1 ? linear : linear + (vf_term(a.i, b.j) + vf_term(a.j, b.i));
}

VEC_INLINE vf chain_multiply(const struct chain_sources *from, size_t at, int order)
{
    return chain_product(chain_load(&from->in[CHAIN_A], at, order),
                         chain_load(&from->in[CHAIN_B], at, order), order);
}

VEC_INLINE vf chain_mixed(struct chain_terms a, struct chain_terms b, struct chain_terms share,
                          int order)
{
    const struct chain_terms d = {a.value - b.value, a.i - b.i, a.j - b.j, a.member - b.member};
    const vm nearer_b = vm_less(vf_set(0.5f), share.value);
    share.value = vm_choose(nearer_b, share.value - 1.0f, share.value);
    return vm_choose(nearer_b, b.member, a.member) - chain_product(d, share, order);
}

VEC_INLINE vf chain_mix(const struct chain_sources *from, size_t at, int order)
{
    return chain_mixed(chain_load(&from->in[CHAIN_A], at, order),
                       chain_load(&from->in[CHAIN_B], at, order),
                       chain_load(&from->in[CHAIN_M], at, order), order);
}

VEC_INLINE vf chain_chosen(struct chain_terms a, struct chain_terms b, int greater)
{
    const vu second = chain_takes_b(a.value, b.value, greater);
    return (vf)vu_choose(second, (vu)b.member, (vu)a.member);
}

VEC_INLINE vf chain_choose(const struct chain_sources *from, size_t at, int greater)
{
    return chain_chosen(chain_load(&from->in[CHAIN_A], at, 1),
                        chain_load(&from->in[CHAIN_B], at, 1), greater);
}

VEC_INLINE vf chain_two_first(const struct chain_sources *from, size_t at)
{
    return vf_load(from->partial[PARTIAL_A] + at) * vf_load(from->in[CHAIN_A].member + at) +
           vf_load(from->partial[PARTIAL_B] + at) * vf_load(from->in[CHAIN_B].member + at);
}

VEC_INLINE vf chain_one_second(const struct chain_sources *from, size_t at)
{
    const struct chain_arrays *const a = &from->in[CHAIN_A];
    return vf_load(from->partial[PARTIAL_A] + at) * vf_load(a->member + at) +
           vf_load(from->partial[PARTIAL_AA] + at) * vf_load(a->i + at) * vf_load(a->j + at);
}

VEC_INLINE vf chain_two_second(const struct chain_sources *from, size_t at, int smooth)
{
    const struct chain_arrays *const a = &from->in[CHAIN_A], *const b = &from->in[CHAIN_B];
    const vf ai = vf_load(a->i + at), aj = vf_load(a->j + at);
    const vf bi = vf_load(b->i + at), bj = vf_load(b->j + at);
    const vf linear = chain_two_first(from, at);
    const vf aa = vf_load(from->partial[PARTIAL_AA] + at);
    if (smooth) {
        return linear + aa * (ai - bi) * (aj - bj);
    }
    return linear + (aa * ai * aj + vf_load(from->partial[PARTIAL_BB] + at) * bi * bj) +
           vf_load(from->partial[PARTIAL_AB] + at) * (ai * bj + aj * bi);
}

VEC_INLINE vf chain_line_of(enum chain_line line, const struct chain_sources *from, size_t at)
{
    const float *const a = from->in[CHAIN_A].member;
    switch (line) {
    case LINE_COPY: return vf_load(from->partial[PARTIAL_F] + at);
    case LINE_SCALE_OFFSET: return from->scale * vf_load(a + at) + from->offset;
    case LINE_SCALE: return from->scale * vf_load(a + at);
    case LINE_SUM: return vf_load(a + at) + vf_load(from->in[CHAIN_B].member + at);
    case LINE_LESSER: return chain_choose(from, at, 0);
    case LINE_GREATER: return chain_choose(from, at, 1);
    case LINE_PRODUCT_VALUE: return chain_multiply(from, at, 0);
    case LINE_PRODUCT_FIRST: return chain_multiply(from, at, 1);
    case LINE_PRODUCT_SECOND: return chain_multiply(from, at, 2);
    case LINE_MIX_VALUE: return chain_mix(from, at, 0);
    case LINE_MIX_FIRST: return chain_mix(from, at, 1);
    case LINE_MIX_SECOND: return chain_mix(from, at, 2);
    case LINE_ONE_FIRST: return vf_load(from->partial[PARTIAL_A] + at) * vf_load(a + at);
    case LINE_ONE_SECOND: return chain_one_second(from, at);
    case LINE_TWO_FIRST: return chain_two_first(from, at);
    case LINE_TWO_SECOND: return chain_two_second(from, at, 0);
    case LINE_SMOOTH_SECOND: return chain_two_second(from, at, 1);
    }
    return vf_set(0.0f);
}

VEC_INLINE void chain_loop(enum chain_line line, struct chain_sources from, size_t count, float *to)
{
    VEC_ROLLED_LOOP
    for (size_t i = 0; i < count; i += VEC_LANES) {
        vf_store(to + i, chain_line_of(line, &from, i));
    }
}

/* Writes a line of a block. */
static void chain_write(enum chain_line line, const struct chain_sources *from, size_t count,
                        float *to)
{
#define CHAIN_CASE(LINE)                                                                           \
    case LINE: chain_loop(LINE, *from, count, to); break;
    switch (line) {
        CHAIN_CASE(LINE_COPY)
        CHAIN_CASE(LINE_SCALE_OFFSET)
        CHAIN_CASE(LINE_SCALE)
        CHAIN_CASE(LINE_SUM)
        CHAIN_CASE(LINE_LESSER)
        CHAIN_CASE(LINE_GREATER)
        CHAIN_CASE(LINE_PRODUCT_VALUE)
        CHAIN_CASE(LINE_PRODUCT_FIRST)
        CHAIN_CASE(LINE_PRODUCT_SECOND)
        CHAIN_CASE(LINE_MIX_VALUE)
        CHAIN_CASE(LINE_MIX_FIRST)
        CHAIN_CASE(LINE_MIX_SECOND)
        CHAIN_CASE(LINE_ONE_FIRST)
        CHAIN_CASE(LINE_ONE_SECOND)
        CHAIN_CASE(LINE_TWO_FIRST)
        CHAIN_CASE(LINE_TWO_SECOND)
        CHAIN_CASE(LINE_SMOOTH_SECOND)
    }
#undef CHAIN_CASE
}

/* Finds the inputs of output m. Inputs that it does not need stay unset. */
static void chain_find(struct chain_sources *from, const struct scarp_chain *call, size_t first,
                       int m, int order)
{
    const int i = order == 2 ? scarp_chain_axes[m - DXX][0] : m;
    const int j = order == 2 ? scarp_chain_axes[m - DXX][1] : m;
    for (int k = 0; k < CHAIN_INPUTS; k++) {
        const float *const *const array = call->in[k];
        const struct chain_arrays at = {chain_from(array[VALUE], first),
                                        chain_from(array[i], first), chain_from(array[j], first),
                                        chain_from(array[m], first)};
        from->in[k] = at;
    }
}

/* Whether outputs need only their own members of the inputs, and are where no others are. */
static int chain_is_straight(const struct scarp_chain *call)
{
    int member[OUTPUTS], members = 0;
    for (int m = 0; m < OUTPUTS; m++) {
        member[members] = m;
        members += call->out[m] != NULL;
    }
    int straight = call->function == CHAIN_AFFINE || call->function == CHAIN_ADD;
    for (int i = 0; i < members; i++) {
        const float *const out = call->out[member[i]];
        for (int k = 0; k < members; k++) {
            straight &= i == k || (out != call->in[CHAIN_A][member[k]] &&
                                   out != call->in[CHAIN_B][member[k]]);
        }
    }
    return straight;
}

/* Computes `count` points from `first` on, a multiple of VEC_LANES, where outputs are straight. */
static void chain_straight(const struct scarp_chain *call, size_t first, size_t count)
{
    struct chain_sources from = {.scale = call->number[CHAIN_SCALE],
                                 .offset = call->number[CHAIN_OFFSET]};
    for (int m = 0; m < OUTPUTS; m++) {
        if (call->out[m] != NULL) {
            const int order = m == VALUE ? 0 : m < DXX || m == DPHASE ? 1 : 2;
            chain_find(&from, call, first, m, order);
            chain_write(chain_lines[call->function][order], &from, count, call->out[m] + first);
        }
    }
}

/* Computes `count` points from `first` on, a multiple of VEC_LANES, and writes `keep` of them. */
static void chain_block(const struct scarp_chain *call, size_t first, size_t count, size_t keep)
{
    struct chain_room room;
    struct chain_sources from = {.scale = call->number[CHAIN_SCALE],
                                 .offset = call->number[CHAIN_OFFSET]};
    chain_take_partials(from.partial, call, first, count, &room);
    for (int m = 0; m < OUTPUTS; m++) {
        if (call->out[m] != NULL) {
            const int order = m == VALUE ? 0 : m < DXX || m == DPHASE ? 1 : 2;
            chain_find(&from, call, first, m, order);
            chain_write(chain_lines[call->function][order], &from, count, room.result[m]);
        }
    }
    for (int m = 0; m < OUTPUTS; m++) {
        if (call->out[m] != NULL) {
            memcpy(call->out[m] + first, room.result[m], keep * sizeof(float));
        }
    }
}

/* Replaces an array by a copy of `count` elements from `first` on. */
static __attribute__((noinline)) void chain_copy(const float **array, float to[VEC_LANES],
                                                 size_t first, size_t count)
{
    vf_store(to, vf_load_partial(*array + first, count));
    *array = to;
}

/* Computes the last points, which do not fill a vector, from copies that do. */
static void chain_tail(const struct scarp_chain *call, size_t first, size_t count)
{
    float in[CHAIN_INPUTS][OUTPUTS][VEC_LANES], partials[PARTIALS][VEC_LANES];
    struct scarp_chain filled = *call;
    VEC_ROLLED_LOOP
    for (int m = 0; m < OUTPUTS; m++) {
        for (int k = 0; k < CHAIN_INPUTS; k++) {
            if (call->in[k][m] != NULL) {
                chain_copy(&filled.in[k][m], in[k][m], first, count);
            }
        }
        if (call->out[m] != NULL) {
            filled.out[m] += first;
        }
    }
    VEC_ROLLED_LOOP
    for (int i = 0; i < PARTIALS; i++) {
        if (call->partial[i] != NULL) {
            chain_copy(&filled.partial[i], partials[i], first, count);
        }
    }
    chain_block(&filled, 0, VEC_LANES, count);
}

/*
 * Values only: a vector at a time, without what is between the stages. The operations are those of
 * the lines.
 */

/* Loads and stores are out of line where a vector is not full, for the sake of size. */
static __attribute__((noinline)) vf chain_load_part(const float *from, size_t count)
{
    return vf_load_partial(from, count);
}

static __attribute__((noinline)) void chain_store_part(float *to, vf v, size_t count)
{
    vf_store_partial(to, v, count);
}

VEC_INLINE vf chain_load_most(const float *from, size_t count)
{
    return count >= VEC_LANES ? vf_load(from) : chain_load_part(from, count);
}

/* The terms of an input that are its value. */
VEC_INLINE struct chain_terms chain_value(vf value)
{
    return (struct chain_terms){value, value, value, value};
}

VEC_INLINE vf chain_value_of(const struct scarp_chain *call, enum scarp_chain_function function,
                             vf a, vf b, vf m)
{
    switch (function) {
    case CHAIN_AFFINE: return call->number[CHAIN_SCALE] * a + call->number[CHAIN_OFFSET];
    case CHAIN_ADD: return a + b;
    case CHAIN_MULTIPLY: return chain_product(chain_value(a), chain_value(b), 0);
    case CHAIN_MIX: return chain_mixed(chain_value(a), chain_value(b), chain_value(m), 0);
    case CHAIN_MIN:
    case CHAIN_MAX: return chain_chosen(chain_value(a), chain_value(b), function == CHAIN_MAX);
    case CHAIN_APPLY1:
    case CHAIN_APPLY2: return a; /* f */
    default: return chain_partials_of(call, function, a, b).f;
    }
}

VEC_INLINE void chain_values_loop(const struct scarp_chain *call,
                                  enum scarp_chain_function function, int inputs, size_t count)
{
    const int is_given = function == CHAIN_APPLY1 || function == CHAIN_APPLY2;
    const float *const a = is_given ? call->partial[PARTIAL_F] : call->in[CHAIN_A][VALUE];
    const float *const b = call->in[CHAIN_B][VALUE], *const m = call->in[CHAIN_M][VALUE];
    float *const to = call->out[VALUE];
    const struct scarp_chain local = *call;
    VEC_ROLLED_LOOP
    for (size_t i = 0; i < count; i += VEC_LANES) {
        const size_t left = count - i;
        const vf zero = vf_set(0.0f), at_a = chain_load_most(a + i, left);
        const vf at_b = inputs > 1 ? chain_load_most(b + i, left) : zero;
        const vf at_m = inputs > 2 ? chain_load_most(m + i, left) : zero;
        const vf value = chain_value_of(&local, function, at_a, at_b, at_m);
        if (left >= VEC_LANES) {
            vf_store(to + i, value);
        } else {
            chain_store_part(to + i, value, left);
        }
    }
}

static void chain_values(const struct scarp_chain *call, size_t count)
{
#define CHAIN_CASE(NAME, inputs)                                                                   \
    case CHAIN_##NAME: chain_values_loop(call, CHAIN_##NAME, inputs, count); break;
    switch (call->function) {
#define OPERATOR(NAME, name, FORM, COMPUTED, ...)                                                  \
    IF_KERNEL_##COMPUTED(CHAIN_CASE(NAME, INPUTS_OF_##FORM))
#define FUNCTION(...) OPERATOR(__VA_ARGS__)
#include "../plan/functions.def"
    case CHAIN_APPLY1:
    case CHAIN_APPLY2: chain_values_loop(call, CHAIN_APPLY1, 1, count); break;
    }
#undef CHAIN_CASE
}

static void chain(const struct scarp_chain *call, size_t count)
{
    if (call->has_values_only) {
        chain_values(call, count);
        return;
    }
    const size_t tail = count % VEC_LANES;
    const size_t whole = count - tail;
    const int straight = whole > 0 && chain_is_straight(call);
    if (straight) {
        chain_straight(call, 0, whole);
    }
    for (size_t first = 0; !straight && first < whole; first += CHAIN_POINTS) {
        const size_t left = whole - first;
        const size_t points = left < CHAIN_POINTS ? left : CHAIN_POINTS;
        chain_block(call, first, points, points);
    }
    if (tail > 0) {
        chain_tail(call, whole, tail);
    }
}

#endif
