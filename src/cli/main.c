/* SPDX-License-Identifier: MIT
 *
 * The program scarp: finds the command and calls it.
 */
#include <errno.h>
#include <stdbool.h>
#include <stdio.h>
#include <string.h>

#include "commands.h"
#include "scarp.h"
#include "shared/error.h"
#include "shared/interrupt.h"
#include "shared/posix.h"
#include "shared/stack.h"

static const char usage[] =
    "usage: scarp <command> [options]\n"
    "\n"
    "Noise for terrain, with exact derivatives, at many points at once.\n"
    "\n"
    "  terrain    write a terrain: heights, normals, hillshade, relief, slopes; whole or tiles\n"
    "  view       show a terrain from a camera: a picture with light, shadows and haze\n"
    "  sheet      draw many small maps of a terrain that differ in one or two parameters\n"
    "  sample     read points, write the noise and its derivatives at each of them\n"
    "  recipe     print a recipe, check it, and show its parameters, outputs, values and cost\n"
    "  info       show the version, the instruction sets and the libraries that were found\n"
    "  help       print this, or with the name of a command its options\n"
    "\n"
    "scarp --version prints the version of the library.\n"
    "Exit status: 0 done, 1 failed on the way, 2 bad command line or input, and no file was\n"
    "written.\n";

static const struct {
    const char *name;
    int (*run)(char **argv);
} commands[] = {{"terrain", cli_terrain}, {"view", cli_view},     {"sheet", cli_sheet},
                {"sample", cli_sample},   {"recipe", cli_recipe}, {"info", cli_info}};

static int run_command(const char *name, char **argv)
{
    for (size_t i = 0; i < sizeof commands / sizeof commands[0]; i++) {
        if (strcmp(name, commands[i].name) == 0) {
            return commands[i].run(argv);
        }
    }
    cli_error("%.60s: unknown %s; see: scarp --help", name, name[0] == '-' ? "option" : "command");
    return CLI_USAGE;
}

static bool is_help(const char *word)
{
    return strcmp(word, "help") == 0 || strcmp(word, "--help") == 0 || strcmp(word, "-h") == 0;
}

static int run(int argc, char **argv)
{
    if (argc < 2) {
        fputs(usage, stderr);
        return CLI_USAGE;
    }
    const bool help = is_help(argv[1]), version = strcmp(argv[1], "--version") == 0;
    if (!help && !version) {
        return run_command(argv[1], argv + 2);
    }
    if (argc > (help ? 3 : 2)) {
        cli_error("%.60s: unexpected argument; see: scarp --help", argv[help ? 3 : 2]);
        return CLI_USAGE;
    }
    if (version) {
        printf("scarp %s\n", scarp_version());
    } else if (argc == 2 || is_help(argv[2])) {
        fputs(usage, stdout);
    } else {
        char option[] = "--help";
        return run_command(argv[2], (char *[]){option, NULL});
    }
    return CLI_SUCCESS;
}

#ifdef _WIN32
static bool start(int *argc, char ***argv)
{
    const bool started = windows_start(argc, argv);
    if (!started) {
        cli_error("no memory for the arguments");
    }
    return started;
}
#else
/* A file that got the number of a standard stream which the caller has closed would take in what
   is printed. What takes those numbers here can neither be written nor be read. */
static bool start(int *argc, char ***argv)
{
    (void)argc;
    (void)argv;
    int descriptor;
    do {
        descriptor = open("/", O_RDONLY);
    } while (descriptor >= 0 && descriptor <= STDERR_FILENO);
    if (descriptor >= 0) {
        close(descriptor);
    }
    return true;
}
#endif

int main(int argc, char **argv)
{
    if (!start(&argc, &argv)) {
        return CLI_FAILURE;
    }
    interrupt_install();
    const int status = stack_reserve() ? run(argc, argv) : CLI_FAILURE;
    interrupt_end();
    /* What was printed may still fail to arrive, on a full disk for instance. */
    if ((fflush(stdout) != 0 || ferror(stdout)) && status == CLI_SUCCESS) {
        cli_error("standard output: %s", strerror(errno));
        return CLI_FAILURE;
    }
    return status;
}
