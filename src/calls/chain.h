/* SPDX-License-Identifier: MIT
 *
 * What others need of the calls of the chain rule.
 */
#ifndef SCARP_CALLS_CHAIN_H
#define SCARP_CALLS_CHAIN_H

#include "../plan/chain.h"

/* Computes the numbers that kernels want of those of a call. Returns 0 if one is outside its
   interval. */
int scarpi_chain_numbers(enum scarp_chain_function function, const float given[3],
                         float to[CHAIN_NUMBERS]);

#endif
