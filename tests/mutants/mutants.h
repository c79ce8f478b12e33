/* SPDX-License-Identifier: MIT
 *
 * The mistakes of list.cmake, as mutate.cmake writes them to mutants.c.
 */
#ifndef SCARP_TESTS_MUTANTS_H
#define SCARP_TESTS_MUTANTS_H

struct mutant {
    const char *name;
    const char *problem; /* why it is not in the library; "" if it is */
    const char *seen_by, *sets;
};

/* Mistake i is switched on by scarp_mutant[i + 1] = 1. */
extern int scarp_mutant[];
extern const struct mutant scarp_mutants[];
extern const int scarp_mutant_count;

#endif
