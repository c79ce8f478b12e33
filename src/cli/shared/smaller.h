/* SPDX-License-Identifier: MIT
 *
 * The smaller of two sizes.
 */
#ifndef SCARP_CLI_SMALLER_H
#define SCARP_CLI_SMALLER_H

#include <stddef.h>

static inline size_t smaller(size_t a, size_t b)
{
    return a < b ? a : b;
}

#endif
