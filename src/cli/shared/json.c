/* SPDX-License-Identifier: MIT
 *
 * A reader of JSON (RFC 8259) that goes past values without keeping them.
 */
#include "shared/json.h"

#include <string.h>

#define DEPTH_MAX 32

static const char *skip_space(const char *at)
{
    return at + strspn(at, " \t\r\n");
}

/* Each of these returns what follows what it goes past, or NULL if that is not there. */

static const char *pass_string(const char *at)
{
    if (*at != '"') {
        return NULL;
    }
    for (at++; *at != '"'; at++) {
        if ((unsigned char)*at < 0x20) {
            return NULL;
        }
        if (*at == '\\') {
            at++;
            if (*at == 'u') {
                if (strspn(at + 1, "0123456789abcdefABCDEF") < 4) {
                    return NULL;
                }
                at += 4;
            } else if (*at == '\0' || strchr("\"\\/bfnrt", *at) == NULL) {
                return NULL;
            }
        }
    }
    return at + 1;
}

static const char *pass_digits(const char *at)
{
    const size_t digits = strspn(at, "0123456789");
    return digits > 0 ? at + digits : NULL;
}

static const char *pass_number(const char *at)
{
    at += *at == '-' ? 1 : 0;
    if (at[0] == '0' && at[1] >= '0' && at[1] <= '9') {
        return NULL;
    }
    at = pass_digits(at);
    if (at != NULL && *at == '.') {
        at = pass_digits(at + 1);
    }
    if (at != NULL && (*at == 'e' || *at == 'E')) {
        at++;
        at = pass_digits(at + (*at == '+' || *at == '-' ? 1 : 0));
    }
    return at;
}

static const char *pass_word(const char *at)
{
    static const char *const words[] = {"true", "false", "null"};
    for (int i = 0; i < 3; i++) {
        if (strncmp(at, words[i], strlen(words[i])) == 0) {
            return at + strlen(words[i]);
        }
    }
    return NULL;
}

static const char *pass_value(const char *at, int depth);

/* A key and the colon behind it, with the space around them */
static const char *pass_key(const char *at)
{
    at = pass_string(skip_space(at));
    at = at != NULL ? skip_space(at) : NULL;
    return at != NULL && *at == ':' ? skip_space(at + 1) : NULL;
}

/* An array, or an object where `close` is a brace */
static const char *pass_list(const char *at, char close, int depth)
{
    at = skip_space(at + 1);
    if (*at == close) {
        return at + 1;
    }
    for (;;) {
        at = close == '}' ? pass_key(at) : skip_space(at);
        at = at != NULL ? pass_value(at, depth + 1) : NULL;
        if (at == NULL) {
            return NULL;
        }
        at = skip_space(at);
        if (*at == close) {
            return at + 1;
        }
        if (*at++ != ',') {
            return NULL;
        }
    }
}

static const char *pass_value(const char *at, int depth)
{
    if (depth > DEPTH_MAX) {
        return NULL;
    }
    switch (*at) {
    case '"': return pass_string(at);
    case '{': return pass_list(at, '}', depth);
    case '[': return pass_list(at, ']', depth);
    case 't':
    case 'f':
    case 'n': return pass_word(at);
    default: return pass_number(at);
    }
}

int json_read(const char *text, struct json_member *members, int most)
{
    const char *at = skip_space(text);
    const char *const end = *at == '{' ? pass_value(at, 0) : NULL;
    if (end == NULL || *skip_space(end) != '\0') {
        return -1;
    }
    int count = 0;
    for (at = skip_space(at + 1); *at != '}'; at = skip_space(at + (*at == ',' ? 1 : 0))) {
        const char *const key = at;
        const char *const value = pass_key(at);
        const char *const after = pass_value(value, 0);
        if (count == most) {
            return -1;
        }
        members[count++] = (struct json_member){
            key + 1, value, (size_t)(pass_string(key) - key) - 2, (size_t)(after - value)};
        at = skip_space(after);
    }
    return count;
}

const struct json_member *json_find_same(const struct json_member *members, int count,
                                         const struct json_member *like)
{
    for (int i = 0; i < count; i++) {
        if (members[i].key_length == like->key_length &&
            memcmp(members[i].key, like->key, like->key_length) == 0) {
            return &members[i];
        }
    }
    return NULL;
}

const struct json_member *json_find(const struct json_member *members, int count, const char *key)
{
    return json_find_same(members, count,
                          &(struct json_member){.key = key, .key_length = strlen(key)});
}

void json_add_string(struct text *text, const char *string)
{
    if (string == NULL) {
        text_add(text, "null");
        return;
    }
    text_add(text, "\"");
    for (const char *c = string; *c != '\0'; c++) {
        if (*c == '"' || *c == '\\') {
            text_add(text, "\\%c", *c);
        } else if ((unsigned char)*c < 0x20) {
            text_add(text, "\\u%04x", (unsigned)*c);
        } else {
            text_add(text, "%c", *c);
        }
    }
    text_add(text, "\"");
}
