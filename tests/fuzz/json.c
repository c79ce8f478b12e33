/* SPDX-License-Identifier: MIT
 *
 * JSON: members lie in the text, an object that is put together of them is read as the same, and
 * any string that is written is read.
 */
#include "shared/json.h"

#include <string.h>

#include "fuzz.h"

#define MOST 8

static void put_together(const struct json_member *members, int count)
{
    struct text text = {0};
    struct json_member again[MOST];
    text_add(&text, "{");
    for (int i = 0; i < count; i++) {
        text_add(&text, "%s\"%.*s\":%.*s", i > 0 ? "," : "", (int)members[i].key_length,
                 members[i].key, (int)members[i].value_length, members[i].value);
    }
    text_add(&text, "}");
    MUST(json_read(text.bytes, again, MOST) == count, "not %d members again", count);
    for (int i = 0; i < count; i++) {
        MUST(again[i].key_length == members[i].key_length &&
                 again[i].value_length == members[i].value_length &&
                 memcmp(again[i].value, members[i].value, members[i].value_length) == 0,
             "member %d", i);
        const struct json_member *const found = json_find_same(again, count, &members[i]);
        MUST(found != NULL && found <= &again[i], "member %d is not found", i);
    }
    free(text.bytes);
}

static void write_string(const char *string)
{
    struct text text = {0};
    struct json_member member;
    text_add(&text, "{\"key\": ");
    json_add_string(&text, string);
    text_add(&text, "}");
    MUST(json_read(text.bytes, &member, 1) == 1, "a string that was written is not read");
    MUST(json_find(&member, 1, "key") == &member && json_find(&member, 1, "ke") == NULL,
         "the key is not found");
    MUST(member.value_length + strlen("{\"key\": }") == text.length, "the string ends elsewhere");
    free(text.bytes);
}

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t size)
{
    char *const text = fuzz_text(bytes, size);
    const size_t length = strlen(text);
    struct json_member members[MOST];
    const int count = json_read(text, members, MOST);
    MUST(count >= -1 && count <= MOST, "%d members", count);
    for (int i = 0; i < count; i++) {
        MUST(members[i].key > text && members[i].key + members[i].key_length < members[i].value &&
                 members[i].value + members[i].value_length < text + length,
             "member %d", i);
    }
    if (count >= 0) {
        put_together(members, count);
    }
    write_string(text);
    free(text);
    return 0;
}
