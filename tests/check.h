/* SPDX-License-Identifier: MIT
 *
 * What every test program shares: checks that count, random numbers from integers, and the choice
 * of the instruction set under test. Header only; included by each tests/test_*.c.
 *
 * A test ends with `return check_done();`, which fails if anything failed or nothing was checked.
 */
#ifndef SCARP_TESTS_CHECK_H
#define SCARP_TESTS_CHECK_H

#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "scarp.h"

#define CHECK_SKIPPED 77 /* ctest's SKIP_RETURN_CODE */
#define CHECK_SHOWN 20   /* failures printed one by one */

static long check_count, check_failures;

/* CHECK(condition, "printf format", ...): what failed, with the numbers that show it. */
#define CHECK(condition, ...)                                                                      \
    do {                                                                                           \
        check_count++;                                                                             \
        if (!(condition)) {                                                                        \
            check_fail(__FILE__, __LINE__, #condition);                                            \
            if (check_failures <= CHECK_SHOWN) {                                                   \
                printf("    " __VA_ARGS__);                                                        \
                printf("\n");                                                                      \
            }                                                                                      \
        }                                                                                          \
    } while (0)

static inline void check_fail(const char *file, int line, const char *condition)
{
    if (++check_failures <= CHECK_SHOWN) {
        printf("%s:%d: failed: %s\n", file, line, condition);
    }
}

static inline int check_done(void)
{
    printf("%ld checks, %ld failed\n", check_count, check_failures);
    return check_count > 0 && check_failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}

/* splitmix64 */
static inline uint64_t check_random(uint64_t *state)
{
    uint64_t z = (*state += UINT64_C(0x9e3779b97f4a7c15));
    z = (z ^ (z >> 30)) * UINT64_C(0xbf58476d1ce4e5b9);
    z = (z ^ (z >> 27)) * UINT64_C(0x94d049bb133111eb);
    return z ^ (z >> 31);
}

/* Uniform in [-span, span), span a power of two: an integer times a power of two, so exact on every
   compiler. */
static inline float check_random_float(uint64_t *state, float span)
{
    const int32_t i = (int32_t)(check_random(state) >> 40) - (1 << 23);
    return (float)i * (span * 0x1p-23f);
}

static inline double check_random_double(uint64_t *state, double span)
{
    const int64_t i = (int64_t)(check_random(state) >> 11) - (INT64_C(1) << 52);
    return (double)i * (span * 0x1p-52);
}

/* How many enumerators enum scarp_isa has, SCARP_ISA_NONE among them. */
static inline int check_isa_count(void)
{
    enum scarp_isa isa = SCARP_ISA_NONE;
    while (scarp_isa_name(isa) != NULL) {
        isa++;
    }
    return (int)isa;
}

static inline enum scarp_isa check_isa_by_name(const char *name)
{
    for (enum scarp_isa isa = SCARP_ISA_NONE + 1; scarp_isa_name(isa) != NULL; isa++) {
        if (strcmp(name, scarp_isa_name(isa)) == 0) {
            return isa;
        }
    }
    printf("unknown instruction set %s\n", name);
    exit(EXIT_FAILURE);
}

/* Whether the comma-separated list in the environment variable has `name`. Every word of the list
   goes to `must_be_known`, which ends the program if it is a mistake: a gate that cannot close
   would be no gate. */
static inline int check_listed(const char *variable, const char *name,
                               void (*must_be_known)(const char *word))
{
    const char *list = getenv(variable);
    int listed = 0;
    while (list != NULL && *list != '\0') {
        char word[32] = "";
        const size_t length = strcspn(list, ",");
        memcpy(word, list, length < sizeof word - 1 ? length : sizeof word - 1);
        must_be_known(word);
        listed |= strcmp(word, name) == 0;
        list += length + (list[length] == ',');
    }
    return listed;
}

static inline void check_isa_known(const char *name)
{
    check_isa_by_name(name);
}

/* Selects the instruction set `name`. Where it cannot run, the whole program ends: as skipped, or
   as failed if SCARP_REQUIRE_ISAS names it. */
static inline enum scarp_isa check_select_isa(const char *name)
{
    const enum scarp_isa isa = check_isa_by_name(name);
    const int required = check_listed("SCARP_REQUIRE_ISAS", name, check_isa_known);
    if (!scarp_isa_supported(isa)) {
        printf("%s cannot run here: %s\n", name, required ? "FAILED (required)" : "skipped");
        exit(required ? EXIT_FAILURE : CHECK_SKIPPED);
    }
    if (scarp_isa_select(isa) != SCARP_OK || scarp_isa_active() != isa) {
        printf("%s: could not be selected\n", name);
        exit(EXIT_FAILURE);
    }
    return isa;
}

#endif
