/* SPDX-License-Identifier: MIT
 *
 * Prints errors.
 */
#include "shared/error.h"

#include <stdarg.h>
#include <stdio.h>

void cli_error(const char *format, ...)
{
    char message[1024];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(message, sizeof message, format, arguments);
    va_end(arguments);
    for (char *c = message; *c != '\0'; c++) {
        if ((unsigned char)*c < 0x20 || *c == 0x7f) {
            *c = '?';
        }
    }
    fprintf(stderr, "scarp: %s\n", message);
}
