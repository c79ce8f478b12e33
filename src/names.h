/* SPDX-License-Identifier: MIT
 *
 * How many enumerators scarp.h has of each kind: what is below is known, has a name (names.c), and
 * passes the checks (plan.c, scarp.c). A new enumerator is appended, so it is the last one here.
 */
#ifndef SCARP_NAMES_H
#define SCARP_NAMES_H

#include "isas.h"
#include "scarp.h"

#define SCARP_BASES (SCARP_VALUE + 1)
#define SCARP_FADES (SCARP_CUBIC + 1)
#define SCARP_FRACTALS (SCARP_EROSION + 1)

/* SCARP_ISA_NONE and those of the list. */
#define SCARP_ISA_COUNT(ISA, table, name, here) +1
#define SCARP_ISAS (1 SCARP_ISA_LIST(SCARP_ISA_COUNT))

#endif
