/* SPDX-License-Identifier: MIT
 *
 * What fuzz targets of the program's parsers share. This cli_error is linked in place of that of
 * shared/error.c.
 */
#include "cli.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "fuzz.h"
#include "shared/error.h"
#include "shared/posix.h"

int fuzz_errors;

void cli_error(const char *format, ...)
{
    char message[1024];
    va_list arguments;
    va_start(arguments, format);
    const int length = vsnprintf(message, sizeof message, format, arguments);
    va_end(arguments);
    MUST(length > 0, "a message that cannot be printed: %s", format);
    fuzz_errors++;
}

void fuzz_no_errors(void)
{
    fuzz_errors = 0;
}

void fuzz_must_tell(bool has_failed, const char *what)
{
    MUST(fuzz_errors == (has_failed ? 1 : 0), "%s: %s, and %d errors are printed", what,
         has_failed ? "it failed" : "it succeeded", fuzz_errors);
    fuzz_no_errors();
}

static char folder[256], path[300];

static void remove_folder(void)
{
    if (*path != '\0') {
        remove(path);
    }
    rmdir(folder);
}

/* In memory where that is a folder */
static void make_folder(void)
{
    const char *const temporary = getenv("TMPDIR");
    const char *const places[] = {"/dev/shm", temporary != NULL ? temporary : "/tmp", "."};
    for (size_t i = 0; i < sizeof places / sizeof places[0]; i++) {
        snprintf(folder, sizeof folder, "%.200s/scarp-fuzz-%ld", places[i], (long)getpid());
        if (mkdir(folder, 0700) == 0) {
            atexit(remove_folder);
            return;
        }
    }
    MUST(false, "%s cannot be made", folder);
}

const char *fuzz_file(const char *name, const uint8_t *bytes, size_t size)
{
    if (*folder == '\0') {
        make_folder();
    }
    char now[sizeof path];
    snprintf(now, sizeof now, "%s/%.30s", folder, name);
    if (*path != '\0' && strcmp(now, path) != 0) {
        remove(path);
    }
    strcpy(path, now);
    FILE *const file = fopen(path, "wb");
    MUST(file != NULL && fwrite(bytes, 1, size, file) == size, "%s cannot be written", path);
    MUST(fclose(file) == 0, "%s cannot be written", path);
    return path;
}
