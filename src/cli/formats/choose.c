/* SPDX-License-Identifier: MIT
 *
 * Finds the format by the extension of a file name, or by what is before it.
 */
#include "formats/choose.h"

#include <string.h>

#include "formats/formats.h"
#include "shared/error.h"
#include "shared/path.h"
#include "shared/unfinished.h"

/* Whether the `length` characters at `word` are `name`, in capitals or not. */
static bool is_word(const char *word, size_t length, const char *name)
{
    if (strlen(name) != length) {
        return false;
    }
    for (size_t i = 0; i < length; i++) {
        const char c = word[i] >= 'A' && word[i] <= 'Z' ? (char)(word[i] - 'A' + 'a') : word[i];
        if (c != name[i]) {
            return false;
        }
    }
    return true;
}

const struct format *format_find(const char *name, size_t length)
{
    for (size_t i = 0; formats_known[i] != NULL; i++) {
        if (is_word(name, length, formats_known[i]->name)) {
            return formats_known[i];
        }
    }
    return NULL;
}

static bool can_hold(const struct format *format, const struct wanted *wanted)
{
    return (format->types[wanted->channels] & wanted->types) != 0;
}

static void extension_error(const struct wanted *wanted, const char *text)
{
    char names[128] = "";
    for (size_t i = 0; formats_known[i] != NULL; i++) {
        if (can_hold(formats_known[i], wanted)) {
            strcat(strcat(names, " ."), formats_known[i]->name);
        }
    }
    cli_error("%s: '%.200s' has no extension for %s, which are%s%s", wanted->option, text,
              wanted->content, names,
              format_find("png", 3) == NULL ? " (this program was built without zlib)" : "");
}

const struct format *format_choose(const struct wanted *wanted, const char *text, const char **path)
{
    /* A colon after the name of a format: what follows is the path, whatever its extension. */
    const size_t prefix = strcspn(text, ":");
    const struct format *format = text[prefix] == ':' ? format_find(text, prefix) : NULL;
    *path = format != NULL ? text + prefix + 1 : text;
    if (format == NULL) {
        const char *const dot = path_extension(text);
        format = *dot == '.' ? format_find(dot + 1, strlen(dot + 1)) : NULL;
    }
    const size_t length = strlen(*path);
    const size_t end = strlen(UNFINISHED_END);
    if (length > end && strcmp(*path + length - end, UNFINISHED_END) == 0) {
        cli_error("%s: '%.200s' is a name for an unfinished file", wanted->option, *path);
        return NULL;
    }
    if (format == NULL || !can_hold(format, wanted) || length == 0) {
        extension_error(wanted, text);
        return NULL;
    }
    if (format->needs_file && strcmp(*path, "-") == 0) {
        cli_error("%s: %s cannot go to standard output, only to a file", wanted->option,
                  format->name);
        return NULL;
    }
    return format;
}
