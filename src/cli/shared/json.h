/* SPDX-License-Identifier: MIT
 *
 * JSON: the members of an object, as text, and strings as JSON has them.
 */
#ifndef SCARP_CLI_JSON_H
#define SCARP_CLI_JSON_H

#include <stdbool.h>
#include <stddef.h>

#include "shared/text.h"

/* A member of an object. Key and value point into the text that was read: the key without its
   quotes, the value as it is there. */
struct json_member {
    const char *key, *value;
    size_t key_length, value_length;
};

/* Reads the object that `text` is, all of it. Returns how many members it has, or -1 if it is no
   object of JSON or has more than `most`. */
int json_read(const char *text, struct json_member *members, int most);

/* The first member of that key, or of the key of `like`; NULL if there is none. */
const struct json_member *json_find(const struct json_member *members, int count, const char *key);
const struct json_member *json_find_same(const struct json_member *members, int count,
                                         const struct json_member *like);

/* Adds `string` in quotes. NULL becomes null. */
void json_add_string(struct text *text, const char *string);

#endif
