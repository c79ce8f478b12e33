/* SPDX-License-Identifier: MIT
 *
 * Which format a file name asks for.
 */
#ifndef SCARP_CLI_CHOOSE_H
#define SCARP_CLI_CHOOSE_H

#include "formats/writer.h"

/* What a file is to hold */
struct wanted {
    const char *option;  /* that asks for it, for messages */
    const char *content; /* what it holds: "pictures" */
    size_t channels;
    unsigned types; /* of samples that it can be stored as, or'ed */
};

/* The format that goes by this name, in capitals or not; NULL if there is none. */
const struct format *format_find(const char *name, size_t length);

/* Finds the format of `text`: PATH, whose extension names it, or FORMAT:PATH. Sets *path to PATH.
   NULL, with a line on stderr, if no format that can hold what is wanted goes with it. */
const struct format *format_choose(const struct wanted *wanted, const char *text,
                                   const char **path);

#endif
