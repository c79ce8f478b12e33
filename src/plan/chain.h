/* SPDX-License-Identifier: MIT
 *
 * Describes a call of the chain rule: what calls/chain.c makes of the arguments, for kernels.
 */
#ifndef SCARP_CHAIN_H
#define SCARP_CHAIN_H

#include "functions.h"
#include "outputs.h"

/* Those of functions.def that kernels compute, and those that are given by partial derivatives. */
#define OPERATOR(NAME, name, FORM, COMPUTED, ...) IF_KERNEL_##COMPUTED(CHAIN_##NAME, )
#define FUNCTION(...) OPERATOR(__VA_ARGS__)
enum scarp_chain_function {
#include "functions.def"
    CHAIN_APPLY1,
    CHAIN_APPLY2
};

/* The inputs, in the order of the arguments. */
enum { CHAIN_A, CHAIN_B, CHAIN_M, CHAIN_INPUTS };

/* The members of struct scarp_partials, in their order, and how one is read as a list. */
enum { PARTIAL_F, PARTIAL_A, PARTIAL_B, PARTIAL_AA, PARTIAL_AB, PARTIAL_BB, PARTIALS };

struct __attribute__((may_alias)) scarp_partial_arrays {
    const float *array[PARTIALS];
};

/* The numbers of a call. Which of them a function has is said there; the others are 0. */
enum {
    CHAIN_SCALE = 0, /* affine */
    CHAIN_OFFSET,
    CHAIN_LO = 0, /* clamp, smoothstep */
    CHAIN_HI,
    CHAIN_INVERSE,   /* smoothstep: 1 / (hi - lo); smooth minimum and maximum: 1 / k */
    CHAIN_DEPTH,     /* the latter: k / 6, negative for the maximum */
    CHAIN_BEND,      /* -1 / k, positive for the maximum */
    CHAIN_ROUND = 0, /* smooth magnitude */
    CHAIN_ROUND2,    /* and its square */
    CHAIN_STEPS = 0, /* terrace */
    CHAIN_HEIGHT,    /* 1 / steps */
    CHAIN_STEEP,     /* 1 / riser */
    CHAIN_STRENGTH,
    CHAIN_NUMBERS = 5
};

struct scarp_chain {
    enum scarp_chain_function function;
    float number[CHAIN_NUMBERS];
    /* Whether nothing but values is asked for: then only out[VALUE], in[...][VALUE] and
       partial[PARTIAL_F] are set. */
    int has_values_only;
    /* What no output needs is NULL. */
    const float *in[CHAIN_INPUTS][OUTPUTS];
    const float *partial[PARTIALS];
    float *out[OUTPUTS];
};

/* The first derivatives that a second one is made of, for DXX to DZZ. */
static const unsigned char scarp_chain_axes[DPHASE - DXX][2] = {{DX, DX}, {DX, DY}, {DX, DZ},
                                                                {DY, DY}, {DY, DZ}, {DZ, DZ}};

#endif
