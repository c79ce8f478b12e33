/* SPDX-License-Identifier: MIT
 *
 * What others need of the calls of the chain rule.
 */
#ifndef SCARP_CALLS_CHAIN_H
#define SCARP_CALLS_CHAIN_H

#include "../plan/chain.h"
#include "scarp.h"

/* Computes the numbers that kernels want of those of a call. Returns 0 if one is outside its
   interval. */
int scarpi_chain_numbers(enum scarp_chain_function function, const float given[3],
                         float to[CHAIN_NUMBERS]);

/* The values of a function that kernels compute, with the numbers of its call, of values of its
   inputs; others are NULL. It runs in the default floating-point mode. */
enum scarp_status scarpi_chain_values(enum scarp_chain_function function, size_t count,
                                      const float *const in[CHAIN_INPUTS], const float given[3],
                                      float *out);

#endif
