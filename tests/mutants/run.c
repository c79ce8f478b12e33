/* SPDX-License-Identifier: MIT
 *
 * Runs a test program on libraries with one mistake each. The program is linked in, its main under
 * the name test_main; the library is the one with all mistakes in it, each behind a switch. The
 * program must pass while no mistake is switched on, and must see each mistake that list.cmake
 * expects it to see. Each run is a process of its own, so that none inherits what another one has
 * left, and a mistake may crash.
 *
 *     mutant_TEST ISA GOLDEN_FILE      all mistakes of the set that TEST has to see
 *
 * SCARP_MUTANT in the environment names one mistake: then only that is run.
 */
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/types.h>
#include <sys/wait.h>
#include <unistd.h>

#include "mutants.h"

#define SKIPPED 77   /* ctest's SKIP_RETURN_CODE */
#define PATIENCE 120 /* seconds: a mistake may make a loop endless */
#define WORDS 5      /* arguments of a test program, at most */

int test_main(int argc, char **argv);

/* How a test program is called so that it ends soon. "ISA" and "FILE" stand for the
   arguments, "RECIPES" for the hashes of recipes. */
static const struct {
    const char *test, *seen_by; /* seen_by "": no mistake is switched on */
    const char *arguments[WORDS];
} runs[] = {
    {"bits", "", {"ISA", "131", "13"}},
    {"bits", "bits", {"--must-differ", "ISA", "131", "13"}},
    {"chain", "", {"ISA"}},
    {"chain", "chain", {"--must-differ", "ISA"}},
    {"curl", "", {"ISA"}},
    {"curl", "curl", {"--must-differ", "ISA"}},
    {"golden", "", {"FILE", "ISA"}},
    {"golden", "golden", {"--must-differ", "FILE", "ISA"}},
    {"grid", "", {"ISA", "250"}},
    {"grid", "grid", {"--must-differ", "ISA", "2000"}}, /* at most */
    {"grid", "large", {"--must-differ", "ISA", "0"}},
    {"grid", "crash", {"--must-crash", "ISA", "0"}},
    {"gullies", "", {"ISA"}},
    {"gullies", "gullies", {"--must-differ", "ISA"}},
    {"plan", "", {"ISA"}},
    {"plan", "plan", {"--must-differ", "ISA"}},
    {"recipe_bits", "", {"ISA", "5", "RECIPES"}},
    {"recipe_bits", "recipe_bits", {"--must-differ", "ISA", "60", "RECIPES"}},
    {"recipe_grids", "", {"ISA", "0"}},
    {"recipe_grids", "recipe_grids", {"--must-differ", "ISA", "20"}},
    {"recipe_skips", "", {"ISA", "5"}},
    {"recipe_skips", "recipe_skips", {"--must-differ", "ISA", "60"}},
    {"vector", "", {"ISA"}},
    {"vector", "vector", {"--must-differ", "ISA"}},
};

static int call_test(int run, char *isa, char *file)
{
    static char program[] = "test", recipes[] = RECIPES_FILE;
    char *argv[WORDS + 2] = {program};
    int argc = 1;
    for (; argc <= WORDS && runs[run].arguments[argc - 1] != NULL; argc++) {
        const char *const word = runs[run].arguments[argc - 1];
        argv[argc] = strcmp(word, "ISA") == 0    ? isa
                     : strcmp(word, "FILE") == 0 ? file
                     : strcmp(word, "RECIPES") == 0
                         ? recipes
                         : (char *)(size_t)word; /* nobody writes to it */
    }
    return test_main(argc, argv);
}

/* Runs the test with mistake number `mutant` switched on; 0 is none. Returns its exit status, or -1
   if it crashed. */
static int run_apart(int run, int mutant, char *isa, char *file)
{
    int status = 0;
    fflush(NULL);
    const pid_t child = fork();
    if (child == 0) {
        alarm(PATIENCE);
        scarp_mutant[mutant] = mutant > 0;
        exit(call_test(run, isa, file));
    }
    if (child < 0 || waitpid(child, &status, 0) != child) {
        perror("mutants");
        exit(EXIT_FAILURE);
    }
    if (WIFSIGNALED(status)) {
        printf("signal %d\n", WTERMSIG(status));
        return -1;
    }
    return WEXITSTATUS(status);
}

/* Whether the comma-separated list has the word. */
static int has_word(const char *list, const char *word)
{
    const size_t length = strlen(word);
    for (; *list != '\0'; list += strcspn(list, ","), list += *list == ',') {
        if (strcspn(list, ",") == length && strncmp(list, word, length) == 0) {
            return 1;
        }
    }
    return 0;
}

static int is_mutant(const char *name)
{
    int i = 0;
    while (i < scarp_mutant_count && strcmp(name, scarp_mutants[i].name) != 0) {
        i++;
    }
    return i < scarp_mutant_count;
}

/* Makes run number `run` once per mistake that it is for, or for `only` alone. Returns how many
   that were, and counts those that the test did not see. */
static int run_mutants(int run, const char *only, char *isa, char *file, int *failed)
{
    int made = 0;
    for (int i = 0; i < scarp_mutant_count; i++) {
        const struct mutant *const mutant = &scarp_mutants[i];
        if (strcmp(mutant->seen_by, runs[run].seen_by) == 0 && has_word(mutant->sets, isa) &&
            (only == NULL || strcmp(only, mutant->name) == 0)) {
            const char *problem = mutant->problem;
            made++;
            printf("mutant %s\n", mutant->name);
            if (problem[0] == '\0' && run_apart(run, i + 1, isa, file) != EXIT_SUCCESS) {
                problem = "the test does not see it";
            }
            if (problem[0] != '\0') {
                printf("FAILED: mutant %s: %s\n", mutant->name, problem);
                ++*failed;
            }
        }
    }
    return made;
}

int main(int argc, char **argv)
{
    const char *const only = getenv("SCARP_MUTANT");
    int made = 0, failed = 0;
    if (argc != 3) {
        printf("usage: mutant_%s ISA GOLDEN_FILE\n", TEST);
        return EXIT_FAILURE;
    }
    if (only != NULL && !is_mutant(only)) {
        printf("list.cmake has no mutant %s\n", only);
        return EXIT_FAILURE;
    }
    for (int run = 0; run < (int)(sizeof runs / sizeof runs[0]); run++) {
        if (strcmp(runs[run].test, TEST) != 0) {
            continue;
        }
        if (runs[run].seen_by[0] != '\0') {
            made += run_mutants(run, only, argv[1], argv[2], &failed);
            continue;
        }
        const int status = run_apart(run, 0, argv[1], argv[2]);
        if (status != EXIT_SUCCESS) { /* also where the set cannot run */
            return status == SKIPPED ? SKIPPED : EXIT_FAILURE;
        }
    }
    if (made == 0 && only != NULL) {
        printf("skipped: %s is not for this test and set\n", only);
        return SKIPPED;
    }
    printf("%d mistakes, %d not seen\n", made, failed);
    return made > 0 && failed == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
