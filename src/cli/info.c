/* SPDX-License-Identifier: MIT
 *
 * `scarp info`: which library runs, what it can run on, and what the program was built with.
 */
#include "commands.h"

#include <stdio.h>
#include <string.h>

#include "formats/formats.h"
#include "scarp.h"
#include "shared/crew.h"
#include "shared/error.h"
#include "shared/options.h"

#define TEXT(x) #x
#define VERSION_TEXT(major, minor, patch) TEXT(major) "." TEXT(minor) "." TEXT(patch)

static const struct option_table table = {
    .command = "info",
    .purpose = "Tells the version, the instruction sets, the libraries that were found, and the\n"
               "formats of rasters.",
};

static void print_versions(void)
{
    static const char header[] =
        VERSION_TEXT(SCARP_VERSION_MAJOR, SCARP_VERSION_MINOR, SCARP_VERSION_PATCH);
    printf("scarp %s\n", scarp_version());
    if (strcmp(header, scarp_version()) != 0) {
        printf("warning: this program was built for scarp %s\n", header);
    }
}

static void print_isas(void)
{
    printf("\n%-16s %-10s %s\n", "instruction set", "supported", "active");
    for (enum scarp_isa isa = SCARP_ISA_NONE + 1; scarp_isa_name(isa) != NULL; isa++) {
        printf("%-16s %-10s %s\n", scarp_isa_name(isa), scarp_isa_supported(isa) ? "yes" : "no",
               scarp_isa_active() == isa ? "yes" : "no");
    }
}

static void print_optional(void)
{
#ifdef SCARP_CLI_ZLIB
    printf("\nzlib             %s\n", png_version());
#else
    printf("\nzlib             not found: no PNG, but PGM and PPM\n");
#endif
#ifdef SCARP_CLI_THREADS
    printf("threads          POSIX: %zu\n", crew_processors());
#else
    printf("threads          not found: one thread\n");
#endif
    printf("formats         ");
    for (size_t i = 0; formats_known[i] != NULL; i++) {
        printf(" %s", formats_known[i]->name);
    }
    putchar('\n');
}

int cli_info(char **argv)
{
    switch (options_parse(&table, argv, NULL)) {
    case OPTIONS_HELP: return CLI_SUCCESS;
    case OPTIONS_BAD: return CLI_USAGE;
    default: break;
    }
    print_versions();
    print_isas();
    print_optional();
    return CLI_SUCCESS;
}
