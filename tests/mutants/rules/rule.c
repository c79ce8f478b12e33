/* SPDX-License-Identifier: MIT
 *
 * Reads the switch of mutations by rule from the environment, in each program and library that
 * rules.py builds:
 *
 *     SCARP_RULE=NUMBER     switches on this mutation
 *     SCARP_RULE_MET=FILE   of RULES ints, in which 1 says that a mutation was met
 */
#define _POSIX_C_SOURCE 200809L
#include <fcntl.h>
#include <stdlib.h>
#include <sys/mman.h>
#include <unistd.h>

#include "rule.h"

static int unseen[RULES];

int scarp_rule, *scarp_rule_met = unseen;

static __attribute__((constructor)) void read_environment(void)
{
    const char *const number = getenv("SCARP_RULE"), *const path = getenv("SCARP_RULE_MET");
    scarp_rule = number != NULL ? atoi(number) : 0;
    const int file = path != NULL ? open(path, O_RDWR) : -1;
    if (file >= 0) {
        void *const met = mmap(NULL, sizeof unseen, PROT_READ | PROT_WRITE, MAP_SHARED, file, 0);
        scarp_rule_met = met != MAP_FAILED ? met : unseen;
        close(file);
    }
}
