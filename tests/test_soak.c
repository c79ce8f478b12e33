/* SPDX-License-Identifier: MIT
 *
 * Random calls, for as long as asked: every promise of arguments.h is checked, memory stays flat,
 * and the hash of all results is that of any other machine.
 *
 *     test_soak CASES [FILE]        so many cases; their hash must be the one that FILE has for
 * them test_soak --seconds SECONDS   prints the hash of 2,000 cases, and of every 50,000 test_soak
 * --case NUMBER       only this case, as where one has failed
 */
#if !defined(_WIN32) && !defined(__wasm__)
#define _DEFAULT_SOURCE
#include <sys/resource.h>
#define HAS_USAGE 1
#else
#define HAS_USAGE 0
#endif

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "fuzz/arguments.h"

#define BYTES 700
#define FIRST 2000      /* cases before the first line of a long run, which has at least one */
#define EVERY 50000     /* cases from one line to the next */
#define SETTLED 20000   /* cases after which memory must not grow */
#define GROWTH_KIB 1024 /* what the system may add to it by itself */

static void (*const targets[])(const uint8_t *, size_t) = {
    fuzz_samples, fuzz_vectors, fuzz_chain,   fuzz_gullies,
    fuzz_samples, fuzz_vectors, fuzz_shaders, fuzz_compositions,
};
#define TARGETS (sizeof targets / sizeof targets[0])

static void run_case(uint64_t number)
{
    static uint8_t bytes[BYTES];
    uint64_t state = number * UINT64_C(0x9e3779b97f4a7c15);
    for (size_t i = 0; i < sizeof bytes; i++) {
        state = state * UINT64_C(6364136223846793005) + 1442695040888963407;
        bytes[i] = (uint8_t)(state >> 56);
    }
    fuzz_case = (long)number;
    fuzz_case_noise = NULL;
    fuzz_case_text = NULL;
    targets[number % TARGETS](bytes, sizeof bytes);
}

/* The most memory that the program ever had; 0 where the system does not say. */
static long peak_kib(void)
{
#if HAS_USAGE
    struct rusage usage;
    const long bytes_or_kib = getrusage(RUSAGE_SELF, &usage) == 0 ? usage.ru_maxrss : 0;
#ifdef __APPLE__
    return bytes_or_kib / 1024;
#else
    return bytes_or_kib;
#endif
#else
    return 0;
#endif
}

static void print(long cases)
{
    printf("%ld %016llx\n", cases, (unsigned long long)fuzz_digest);
    fflush(stdout);
}

/* The hash that the file has for so many cases; 0 if it has none. */
static unsigned long long expected(const char *path, long cases)
{
    char line[80];
    unsigned long long hash = 0, of_line;
    long count;
    FILE *const file = fopen(path, "r");
    while (file != NULL && fgets(line, sizeof line, file) != NULL) {
        if (sscanf(line, "%ld %llx", &count, &of_line) == 2 && count == cases) {
            hash = of_line;
        }
    }
    if (file != NULL) {
        fclose(file);
    }
    return hash;
}

static int run_cases(long cases, const char *path)
{
    for (long i = 0; i < cases; i++) {
        run_case((uint64_t)i);
    }
    print(cases);
    printf("%ld calls, %ld gave results\n", fuzz_calls, fuzz_served);
    if (path != NULL && expected(path, cases) != fuzz_digest) {
        printf("%s has %016llx\n", path, expected(path, cases));
        return EXIT_FAILURE;
    }
    return fuzz_served > fuzz_calls / 2 ? EXIT_SUCCESS : EXIT_FAILURE;
}

static int run_seconds(long seconds)
{
    const time_t start = time(NULL);
    long cases = 0, settled = 0;
    while (difftime(time(NULL), start) < (double)seconds) {
        run_case((uint64_t)cases++);
        if (cases == SETTLED) {
            settled = peak_kib();
        }
        if (cases == FIRST || cases % EVERY == 0) {
            print(cases);
        }
    }
    const long growth = settled > 0 ? peak_kib() - settled : 0;
    printf("%ld cases, %ld calls, %ld gave results, %.0f s\n", cases, fuzz_calls, fuzz_served,
           difftime(time(NULL), start));
    if (settled > 0) {
        printf("%ld KiB of memory, %ld more than after %d cases\n", peak_kib(), growth, SETTLED);
    } else {
        printf("memory was not measured\n");
    }
    const int is_enough = cases >= FIRST && fuzz_served > fuzz_calls / 2;
    return is_enough && growth <= GROWTH_KIB ? EXIT_SUCCESS : EXIT_FAILURE;
}

int main(int argc, char **argv)
{
    const int has_word = argc == 3 && argv[1][0] == '-';
    const long number = argc < 2 ? -1 : atol(argv[has_word ? 2 : 1]);
    if (number < 0 || argc > 3 || (!has_word && number == 0)) {
        fprintf(stderr, "usage: test_soak CASES [FILE] | --seconds SECONDS | --case NUMBER\n");
        return 2;
    }
    if (has_word && strcmp(argv[1], "--case") == 0) {
        run_case((uint64_t)number);
        print(1);
        return EXIT_SUCCESS;
    }
    return has_word && strcmp(argv[1], "--seconds") == 0
               ? run_seconds(number)
               : run_cases(number, argc == 3 ? argv[2] : NULL);
}
