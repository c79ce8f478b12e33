/* SPDX-License-Identifier: MIT
 *
 * The rows of the options that say how a command runs.
 */
#include "shared/running_options.h"

#include "shared/crew.h"

#define FIELD(name) offsetof(struct running_options, name)

const struct option running_option_rows[RUNNING_ROWS] = {
    {.name = "--threads",
     .argument = "N",
     .otherwise = "one per processor",
     .help = "the most threads that work, from 1 to 1024 (1 without POSIX threads); the files "
             "do not depend on it",
#ifdef SCARP_CLI_THREADS
     .allowed = "an integer from 1 to 1024",
     .highest = THREADS_MAX,
#else
     .allowed = "1: this program was built without threads",
     .highest = 1,
#endif
     .parse = option_count,
     .offset = FIELD(threads),
     .lowest = 1,
     .of_run = 1},
    {OPTION_ISA(isa), .of_run = 1},
    {OPTION_FLAG("--quiet", quiet, "print nothing but errors"), .of_run = 1},
};
