/* SPDX-License-Identifier: MIT
 *
 * Takes the stack before something else takes the memory.
 */
#include "shared/stack.h"

#include <stdlib.h>

#ifdef _WIN32
bool stack_reserve(void)
{
    return true;
}
#else
#include <sys/resource.h>

#include "shared/error.h"

/* Arguments and environment take some of it, too. */
#define ALLOWED ((rlim_t)(2 * STACK_NEEDED))

/* The pages nearest to the end come first: some systems allow no jump beyond it. Out of line: a
   caller that had this frame would need it before it could check anything. */
static __attribute__((noinline)) void touch(void)
{
    volatile unsigned char bytes[STACK_NEEDED];
    for (size_t i = STACK_NEEDED; i > 0; i -= 1024) {
        bytes[i - 1] = 0;
    }
    (void)bytes;
}

bool stack_reserve(void)
{
    struct rlimit limit;
    if (getrlimit(RLIMIT_STACK, &limit) == 0 && limit.rlim_cur < ALLOWED) {
        const struct rlimit higher = {.rlim_cur = ALLOWED, .rlim_max = limit.rlim_max};
        if (limit.rlim_max < ALLOWED || setrlimit(RLIMIT_STACK, &higher) != 0) {
            cli_error("the stack is limited to %llu KiB and must not be to less than %llu; see "
                      "ulimit -s",
                      (unsigned long long)limit.rlim_cur >> 10, (unsigned long long)ALLOWED >> 10);
            return false;
        }
    }
    /* A stack that cannot grow would end the program. */
    void *volatile memory = malloc(2 * STACK_NEEDED);
    if (memory == NULL) {
        cli_error("no memory for the stack");
        return false;
    }
    free(memory);
    touch();
    return true;
}
#endif
