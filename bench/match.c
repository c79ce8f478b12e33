/* SPDX-License-Identifier: MIT
 *
 * Which workloads a pattern names.
 */
#include <string.h>

#include "work.h"

static int glob(const char *pattern, const char *text)
{
    for (; *pattern != '\0' && *pattern != '*'; pattern++, text++) {
        if (*text == '\0' || (*pattern != '?' && *pattern != *text)) {
            return 0;
        }
    }
    if (*pattern == '\0') {
        return *text == '\0';
    }
    while (!glob(pattern + 1, text)) {
        if (*text++ == '\0') {
            return 0;
        }
    }
    return 1;
}

/* Whether a workload is called that. It takes going through all of them, so the last answer is
   kept: names are asked for the same pattern one after the other. */
static int is_name(const char *pattern)
{
    static char asked[BENCH_NAME_SIZE];
    static int found;
    struct bench_work work;
    if (strlen(pattern) >= sizeof asked || strcmp(pattern, asked) == 0) {
        return found && strlen(pattern) < sizeof asked;
    }
    strcpy(asked, pattern);
    found = 0;
    for (size_t i = 0; !found && bench_work_get(i, &work); i++) {
        found = strcmp(pattern, work.name) == 0;
    }
    return found;
}

int bench_work_matches(const char *pattern, const char *name)
{
    if (strpbrk(pattern, "*?") != NULL) {
        return glob(pattern, name);
    }
    if (strcmp(pattern, name) == 0) {
        return 1;
    }
    return strstr(name, pattern) != NULL && !is_name(pattern); /* most are no part of the name */
}
