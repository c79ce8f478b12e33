/* SPDX-License-Identifier: MIT
 *
 * Runs in place of a test that needs tools which are missing. ctest reports the test as skipped, or
 * as failed if SCARP_REQUIRE_TOOLS in the environment names one of them.
 *
 *     test_skip MISSING... of TOOL...      TOOL... are all that SCARP_REQUIRE_TOOLS may name
 */
#include "check.h"

static char **tools;

static void must_be_tool(const char *name)
{
    for (char **tool = tools; *tool != NULL; tool++) {
        if (strcmp(*tool, name) == 0) {
            return;
        }
    }
    printf("%s is no tool of any test\n", name);
    exit(EXIT_FAILURE);
}

int main(int argc, char **argv)
{
    int count = 1, failed = 0;
    while (count < argc && strcmp(argv[count], "of") != 0) {
        count++;
    }
    if (count == 1 || count == argc) {
        printf("usage: test_skip MISSING... of TOOL...\n");
        return EXIT_FAILURE;
    }
    tools = argv + count + 1;
    for (int i = 1; i < count; i++) {
        must_be_tool(argv[i]);
        const int required = check_listed("SCARP_REQUIRE_TOOLS", argv[i], must_be_tool);
        printf("%s: %s is missing\n", required ? "FAILED (required)" : "skipped", argv[i]);
        failed |= required;
    }
    return failed ? EXIT_FAILURE : CHECK_SKIPPED;
}
