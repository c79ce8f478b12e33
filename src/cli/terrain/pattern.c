/* SPDX-License-Identifier: MIT
 *
 * Finds, checks and replaces placeholders.
 */
#include "terrain/pattern.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "shared/error.h"
#include "shared/path.h"
#include "shared/text.h"

#define DIGITS_MAX 18

struct placeholder {
    const char *name; /* of placeholder_names */
    int digits;       /* at least */
    size_t length;    /* from brace to brace */
};

static const char *const placeholder_names[] = {"x", "y", "-y", "level", "-level", NULL};

/* Reads the placeholder that begins at the brace `at`. False if there is none. */
static bool read_placeholder(const char *at, struct placeholder *placeholder)
{
    for (const char *const *name = placeholder_names; *name != NULL; name++) {
        const size_t length = strlen(*name);
        if (strncmp(at + 1, *name, length) != 0) {
            continue;
        }
        const char *end = at + 1 + length;
        int digits = 1;
        if (end[0] == ':' && end[1] == '0') {
            char *after;
            const long given = strtol(end + 2, &after, 10);
            if (end[2] < '1' || end[2] > '9' || given > DIGITS_MAX) {
                continue;
            }
            digits = (int)given;
            end = after;
        }
        if (*end == '}') {
            *placeholder = (struct placeholder){*name, digits, (size_t)(end + 1 - at)};
            return true;
        }
    }
    return false;
}

/* The first placeholder in `text`; NULL if there is none. */
static const char *find_placeholder(const char *text, struct placeholder *placeholder)
{
    for (const char *at = strchr(text, '{'); at != NULL; at = strchr(at + 1, '{')) {
        if (read_placeholder(at, placeholder)) {
            return at;
        }
    }
    return NULL;
}

bool pattern_is(const char *path)
{
    struct placeholder placeholder;
    return find_placeholder(path, &placeholder) != NULL;
}

/* Whether `path` has a placeholder of this axis: 'x' or 'y'. */
static bool has_axis(const char *path, char axis)
{
    struct placeholder placeholder;
    for (const char *at = find_placeholder(path, &placeholder); at != NULL;
         at = find_placeholder(at + placeholder.length, &placeholder)) {
        if (placeholder.name[strlen(placeholder.name) - 1] == axis) {
            return true;
        }
    }
    return false;
}

static bool is_of_level(const struct placeholder *placeholder)
{
    return strstr(placeholder->name, "level") != NULL;
}

bool pattern_has_level(const char *path)
{
    struct placeholder placeholder;
    for (const char *at = find_placeholder(path, &placeholder); at != NULL;
         at = find_placeholder(at + placeholder.length, &placeholder)) {
        if (is_of_level(&placeholder)) {
            return true;
        }
    }
    return false;
}

/* Whether the run has what the placeholders stand for */
static bool check_options(const char *path, const struct tiling *tiling, const char *option)
{
    struct placeholder placeholder;
    for (const char *at = find_placeholder(path, &placeholder); at != NULL;
         at = find_placeholder(at + placeholder.length, &placeholder)) {
        const bool is_level = is_of_level(&placeholder);
        if (is_level ? tiling->level_count == 1 : !tiling->numbered) {
            cli_error("%s: {%s} in '%.200s' needs %s", option, placeholder.name, path,
                      is_level ? "--levels" : "--tile");
            return false;
        }
    }
    return true;
}

/* How many different numbers a placeholder stands for */
static size_t count_of(const struct placeholder *placeholder, const struct tiling *tiling)
{
    return is_of_level(placeholder)                                  ? tiling->level_count
           : placeholder->name[strlen(placeholder->name) - 1] == 'x' ? tiling->levels[0].across
                                                                     : tiling->levels[0].down;
}

/* Whether all its numbers have the same number of digits */
static bool is_fixed(const struct placeholder *placeholder, const struct tiling *tiling)
{
    int digits = 1;
    for (size_t most = count_of(placeholder, tiling) - 1; most > 9; most /= 10) {
        digits++;
    }
    return placeholder->digits >= digits;
}

/* Whether numbers can be told apart. Of those with no more than digits between them, one at most
   may be long or short: {x}{y} would be 111 both for 1, 11 and for 11, 1. */
static bool check_digits(const char *path, const struct tiling *tiling, const char *option)
{
    struct placeholder placeholder;
    int loose = 0;
    const char *end = path;
    for (const char *at = find_placeholder(path, &placeholder); at != NULL;
         at = find_placeholder(end, &placeholder)) {
        if (strspn(end, "0123456789") < (size_t)(at - end)) {
            loose = 0;
        }
        loose += is_fixed(&placeholder, tiling) ? 0 : 1;
        if (loose > 1) {
            cli_error(
                "%s: '%.200s' has nothing but digits between {%s} and the number before it, so two "
                "tiles could have one name; give it digits, as in {x:04}",
                option, path, placeholder.name);
            return false;
        }
        end = at + placeholder.length;
    }
    return true;
}

bool pattern_check(const char *path, const struct tiling *tiling, const char *option)
{
    struct placeholder placeholder;
    const char *const first = find_placeholder(path, &placeholder);
    if (!check_options(path, tiling, option)) {
        return false;
    }
    const bool is_pattern = tiling->numbered || first != NULL;
    for (const char *at = is_pattern ? strchr(path, '{') : NULL; at != NULL;
         at = strchr(at + 1, '{')) {
        if (!read_placeholder(at, &placeholder)) {
            cli_error(
                "%s: '%.60s' does not begin with {x}, {y}, {-y}, {level} or {-level}, or with "
                "digits as in {x:04}",
                option, at);
            return false;
        }
    }
    if (first == NULL) {
        return true;
    }
    if (!check_digits(path, tiling, option)) {
        return false;
    }
    if (tiling->levels[0].across > 1 && !has_axis(path, 'x')) {
        cli_error("%s: '%.200s' has no {x}, so the %zu tiles of a row would have one name", option,
                  path, tiling->levels[0].across);
        return false;
    }
    if (tiling->levels[0].down > 1 && !has_axis(path, 'y')) {
        cli_error("%s: '%.200s' has no {y} or {-y}, so the %zu tiles of a column would have one "
                  "name",
                  option, path, tiling->levels[0].down);
        return false;
    }
    return true;
}

char *pattern_of(const char *path, bool numbered)
{
    const char *const extension = path_extension(path);
    char *const stem = text_join_part(path, (size_t)(extension - path), "");
    char *const pattern = numbered && !pattern_is(path)
                              ? text_join((const char *const[]){stem != NULL ? stem : "",
                                                                "_{y}_{x}", extension, NULL})
                              : text_copy(path);
    if (stem == NULL) {
        free(pattern);
        return NULL;
    }
    free(stem);
    return pattern;
}

/* `path` with -levelN before its extension */
static char *with_level(const char *path, unsigned level)
{
    char text[32];
    snprintf(text, sizeof text, "-level%u", level);
    return text_insert(path, (size_t)(path_extension(path) - path), text);
}

static size_t number_of(const struct placeholder *placeholder, const struct tile *tile)
{
    const bool is_negative = placeholder->name[0] == '-';
    switch (placeholder->name[is_negative ? 1 : 0]) {
    case 'x': return tile->x;
    case 'y': return is_negative ? tile->up : tile->y;
    default: return is_negative ? tile->coarser : tile->level;
    }
}

/* Writes numbers in place of the placeholders. */
static char *expand(const char *pattern, const struct tile *tile)
{
    struct text name = {0};
    struct placeholder placeholder;
    const char *rest = pattern;
    for (const char *at = find_placeholder(rest, &placeholder); at != NULL;
         at = find_placeholder(rest, &placeholder)) {
        text_add(&name, "%.*s%0*zu", (int)(at - rest), rest, placeholder.digits,
                 number_of(&placeholder, tile));
        rest = at + placeholder.length;
    }
    text_add(&name, "%s", rest);
    return name.bytes;
}

char *pattern_expand(const char *path, const struct tile *tile)
{
    const bool tells_level = tile->level > 0 && !pattern_has_level(path);
    char *const plain = tells_level ? with_level(path, tile->level) : text_copy(path);
    char *const pattern = plain != NULL ? pattern_of(plain, tile->numbered) : NULL;
    const bool is_pattern = tile->numbered || tile->level + tile->coarser > 0;
    char *const name = pattern == NULL ? NULL
                       : is_pattern    ? expand(pattern, tile)
                                       : text_copy(pattern);
    free(plain);
    free(pattern);
    return name;
}

/* Adds the characters up to `end`, without separators. */
static void add_as_word(struct text *name, const char *begin, const char *end)
{
    for (; begin < end; begin++) {
        text_add(name, "%c", path_directory_length((char[]){*begin, '\0'}) == 1 ? '_' : *begin);
    }
}

char *pattern_manifest(const char *path)
{
    struct text name = {0};
    struct placeholder placeholder;
    const char *at = find_placeholder(path, &placeholder);
    char *const literal = text_join_part(path, at != NULL ? (size_t)(at - path) : strlen(path), "");
    if (literal == NULL) {
        return NULL;
    }
    const char *rest = path + path_directory_length(literal);
    free(literal);
    text_add(&name, "%.*s", (int)(rest - path), path);
    for (; at != NULL; at = find_placeholder(rest, &placeholder)) {
        add_as_word(&name, rest, at);
        text_add(&name, "%s", placeholder.name);
        rest = at + placeholder.length;
    }
    add_as_word(&name, rest, rest + strlen(rest));
    text_add(&name, ".json");
    return name.bytes;
}
