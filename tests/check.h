/* SPDX-License-Identifier: MIT
 *
 * What every test program shares: checks that count, random numbers from integers, and the choice
 * of the instruction set under test. Header only; included by each tests/test_*.c.
 *
 * A test ends with `return check_done();`, which fails if anything failed or nothing was checked.
 */
#ifndef SCARP_TESTS_CHECK_H
#define SCARP_TESTS_CHECK_H

#include <limits.h>
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "scarp.h"

#define CHECK_SKIPPED 77 /* ctest's SKIP_RETURN_CODE */
#define CHECK_SHOWN 20   /* failures printed one by one */
#ifndef CHECK_STOPS      /* whether the first failure ends the program (mutants/rules.py) */
#define CHECK_STOPS 0
#endif

/* What the test program has to see. A mutant is a library with a deliberate mistake
   (mutants.cmake): a test program catches it if a result that CHECK_BITS compares differs and no
   CHECK fails, or if the program crashes where it is meant to. */
enum check_aim { CHECK_SAME, CHECK_DIFFERENT, CHECK_CRASH };

static enum check_aim check_aim;
static long check_count, check_failures, check_differences;

/* CHECK(condition, "printf format", ...) counts a check. If it fails, the text is printed: give the
   numbers that show why. */
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

/* The same for results, which are what a mistake in a kernel changes. */
#define CHECK_BITS(condition, ...)                                                                 \
    do {                                                                                           \
        if (check_aim != CHECK_DIFFERENT) {                                                        \
            CHECK(condition, __VA_ARGS__);                                                         \
        } else if (check_count++, !(condition) && check_differences++ == 0) {                      \
            printf("differs: " __VA_ARGS__);                                                       \
            printf("\n");                                                                          \
        }                                                                                          \
    } while (0)

static inline void check_fail(const char *file, int line, const char *condition)
{
    if (++check_failures <= CHECK_SHOWN) {
        printf("%s:%d: failed: %s\n", file, line, condition);
    }
    if (CHECK_STOPS) {
        exit(EXIT_FAILURE);
    }
}

/* Whether a difference was what this run is for, and was seen: the rest can be left out. */
static inline int check_enough(void)
{
    return check_aim == CHECK_DIFFERENT && check_differences > 0;
}

static inline int check_done(void)
{
    const int seen = check_aim == CHECK_SAME || (check_aim == CHECK_DIFFERENT && check_differences);
    printf("%ld checks, %ld failed\n", check_count, check_failures);
    if (!seen) {
        printf("%s\n", check_aim == CHECK_CRASH ? "did not crash" : "no result differs");
    }
    return seen && check_count > 0 && check_failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}

/* Takes --must-differ or --must-crash away from the arguments if it comes first. Returns how many
   arguments are left; `*argv` still begins with a word to be ignored, as in main. */
static inline int check_take_aim(int argc, char ***argv)
{
    check_aim = argc < 2                                   ? CHECK_SAME
                : strcmp((*argv)[1], "--must-differ") == 0 ? CHECK_DIFFERENT
                : strcmp((*argv)[1], "--must-crash") == 0  ? CHECK_CRASH
                                                           : CHECK_SAME;
    const int taken = check_aim != CHECK_SAME;
    *argv += taken;
    return argc - taken;
}

/* FNV-1a */
#define FNV_BASIS UINT64_C(0xcbf29ce484222325)

static inline uint64_t fnv_byte(uint64_t hash, unsigned byte)
{
    return (hash ^ byte) * UINT64_C(0x100000001b3);
}

static inline uint64_t fnv_text(const char *text)
{
    uint64_t hash = FNV_BASIS;
    for (; *text != '\0'; text++) {
        hash = fnv_byte(hash, (unsigned char)*text);
    }
    return hash;
}

/* Unlike fmax, this keeps a NaN. (Under -ffast-math, clang warns of isnan.) */
static inline double larger(double a, double b)
{
    return a > b || a != a ? a : b;
}

/* These give the library's words for any number. */
static inline const char *basis_name(int basis)
{
    return scarp_basis_name((enum scarp_basis)basis);
}

static inline const char *fade_name(int fade)
{
    return scarp_fade_name((enum scarp_fade)fade);
}

static inline const char *fractal_name(int fractal)
{
    return scarp_fractal_name((enum scarp_fractal)fractal);
}

static inline const char *isa_name(int isa)
{
    return scarp_isa_name((enum scarp_isa)isa);
}

/* How many of a kind there are. */
static inline int count_names(const char *(*name)(int))
{
    int count = 0;
    while (name(count) != NULL) {
        count++;
    }
    return count;
}

/* splitmix64, and number `number`, from 1 on, of the generator that `start` starts */
static inline uint64_t check_random(uint64_t *state)
{
    uint64_t z = (*state += UINT64_C(0x9e3779b97f4a7c15));
    z = (z ^ (z >> 30)) * UINT64_C(0xbf58476d1ce4e5b9);
    z = (z ^ (z >> 27)) * UINT64_C(0x94d049bb133111eb);
    return z ^ (z >> 31);
}

static inline uint64_t check_random_number(uint64_t start, uint64_t number)
{
    start += (number - 1) * UINT64_C(0x9e3779b97f4a7c15);
    return check_random(&start);
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
    return count_names(isa_name);
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
   goes to `must_be_known`, which ends the program if the word is unknown: a mistyped word would
   require nothing. */
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

static inline void check_isa_required(const char *name)
{
    if (!scarp_isa_supported(check_isa_by_name(name))) {
        printf("%s cannot run here: FAILED (required)\n", name);
        exit(EXIT_FAILURE);
    }
}

/* Argument `index`, a number of at least `least`. Without one, prints the usage and ends the program. */
static inline long check_argument(int argc, char **argv, int index, long least, const char *usage)
{
    const long number = argc > index ? strtol(argv[index], NULL, 10) : LONG_MIN;
    if (number < least) {
        printf("usage: %s %s (at least %ld)\n", argv[0], usage, least);
        exit(EXIT_FAILURE);
    }
    return number;
}

/* Selects the instruction set `name`. Where it cannot run, the whole program ends as skipped. Where
   any set of SCARP_REQUIRE_ISAS cannot run, it fails: there may be no test of that set. */
static inline enum scarp_isa check_select_isa(const char *name)
{
    const enum scarp_isa isa = check_isa_by_name(name);
    check_listed("SCARP_REQUIRE_ISAS", name, check_isa_required);
    if (!scarp_isa_supported(isa)) {
        printf("%s cannot run here: skipped\n", name);
        exit(CHECK_SKIPPED);
    }
    if (scarp_isa_select(isa) != SCARP_OK || scarp_isa_active() != isa) {
        printf("%s: could not be selected\n", name);
        exit(EXIT_FAILURE);
    }
    return isa;
}

/* Selects the instruction set that the only argument names, as check_select_isa does. Without one, prints
   the usage and ends the program. */
static inline enum scarp_isa check_isa_argument(int argc, char **argv)
{
    if (argc != 2) {
        printf("usage: %s ISA\n", argv[0]);
        exit(EXIT_FAILURE);
    }
    return check_select_isa(argv[1]);
}

#endif
