/* SPDX-License-Identifier: MIT
 *
 * Texts in memory.
 */
#include "shared/text.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

char *text_copy(const char *text)
{
    return text_join((const char *const[]){text, NULL});
}

char *text_join(const char *const *texts)
{
    size_t length = 1;
    for (size_t i = 0; texts[i] != NULL; i++) {
        length += strlen(texts[i]);
    }
    char *const joined = malloc(length);
    if (joined == NULL) {
        return NULL;
    }
    joined[0] = '\0';
    for (size_t i = 0; texts[i] != NULL; i++) {
        strcat(joined, texts[i]);
    }
    return joined;
}

char *text_join_part(const char *text, size_t length, const char *end)
{
    const size_t more = strlen(end) + 1;
    char *const joined = malloc(length + more);
    if (joined != NULL) {
        memcpy(joined, text, length);
        memcpy(joined + length, end, more);
    }
    return joined;
}

char *text_insert(const char *text, size_t at, const char *inserted)
{
    char *const begin = text_join_part(text, at, inserted);
    char *const whole =
        begin != NULL ? text_join((const char *const[]){begin, text + at, NULL}) : NULL;
    free(begin);
    return whole;
}

/* Makes room for `length` more characters and a NUL. */
static bool reserve(struct text *text, size_t length)
{
    const size_t needed = text->length + length + 1;
    if (text->failed || needed <= text->size) {
        return !text->failed;
    }
    const size_t size = 2 * needed;
    char *const bytes = realloc(text->bytes, size);
    if (bytes == NULL) {
        free(text->bytes);
        text->bytes = NULL;
        text->failed = true;
        return false;
    }
    text->bytes = bytes;
    text->size = size;
    return true;
}

void text_add(struct text *text, const char *format, ...)
{
    va_list arguments, again;
    va_start(arguments, format);
    va_copy(again, arguments);
    const int length = vsnprintf(NULL, 0, format, arguments);
    if (length >= 0 && reserve(text, (size_t)length)) {
        vsnprintf(text->bytes + text->length, (size_t)length + 1, format, again);
        text->length += (size_t)length;
    }
    va_end(again);
    va_end(arguments);
}
