/* SPDX-License-Identifier: MIT
 *
 * Tells how many enumerators scarp.h has of each kind. Numbers below have names (names.c) and pass
 * the checks (check.c, scarp.c). New enumerators are appended, so the last one stands here.
 */
#ifndef SCARP_NAMES_H
#define SCARP_NAMES_H

#include "isas.h"
#include "scarp.h"

#define SCARP_BASES (SCARP_CELL_VALUE + 1)
#define SCARP_FADES (SCARP_CUBIC + 1)
#define SCARP_FRACTALS (SCARP_JORDAN + 1)

/* Counts SCARP_ISA_NONE and the sets of the list. */
#define SCARP_ISA_COUNT(ISA, table, name, here) +1
#define SCARP_ISAS (1 SCARP_ISA_LIST(SCARP_ISA_COUNT))

#endif
