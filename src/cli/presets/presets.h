/* SPDX-License-Identifier: MIT
 *
 * The recipes of the program: the files in presets/, which the build puts into it.
 */
#ifndef SCARP_CLI_PRESETS_H
#define SCARP_CLI_PRESETS_H

#include <stddef.h>

#include "presets_words.h" /* written by presets.cmake: what help says */

struct preset {
    const char *text; /* not ended by a NUL */
    size_t length;
};

extern const struct preset preset_list[]; /* by number; that of "none", 0, is empty */

/* NULL past the last */
const char *preset_name(int number);

#endif
