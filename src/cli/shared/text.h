/* SPDX-License-Identifier: MIT
 *
 * Texts put together in memory that the caller frees. All return NULL without memory.
 */
#ifndef SCARP_CLI_TEXT_H
#define SCARP_CLI_TEXT_H

#include <stdbool.h>
#include <stddef.h>

char *text_copy(const char *text);

/* The texts one after the other; NULL at the end */
char *text_join(const char *const *texts);

/* The first `length` characters of `text`, and `end` */
char *text_join_part(const char *text, size_t length, const char *end);

/* `text` with `inserted` behind its first `at` characters */
char *text_insert(const char *text, size_t at, const char *inserted);

/* A text that grows. Zero-initialise; free `bytes`. */
struct text {
    char *bytes; /* NULL: nothing was added yet, or memory ran out */
    size_t length, size;
    bool failed; /* memory ran out; nothing is added any more */
};

/* Adds what printf would print. */
#if defined(__clang__) || (defined(__GNUC__) && !defined(_WIN32))
__attribute__((format(printf, 2, 3)))
#endif
void text_add(struct text *text, const char *format, ...);

#endif
