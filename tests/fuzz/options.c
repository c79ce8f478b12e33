/* SPDX-License-Identifier: MIT
 *
 * Command lines: one error if they are bad, and else the same values each time. Those of `scarp
 * terrain` are described as JSON, and the description typed again gives the same description.
 *
 * The first byte says of which command, then come words, a line each.
 */
#include "shared/options.h"

#include <string.h>

#include "cli.h"
#include "commands.h"
#include "draw.h"
#include "fuzz.h"
#include "shared/json.h"
#include "sheet/sheet_options.h"
#include "terrain/pattern.h"
#include "terrain/terrain_options.h"
#include "terrain/tiling.h"
#include "view/view_options.h"

#define WORDS_MOST 400
#define MEMBERS_MOST 100

union values {
    uint64_t start;
    char bytes[1 << 14]; /* more than any command has */
};
static union values first, second, typed_again;

/* Cuts a text into its lines. Returns how many there are. */
static size_t cut(char *text, char *words[WORDS_MOST + 1])
{
    size_t count = 0;
    for (char *at = text; *at != '\0' && count < WORDS_MOST;) {
        const size_t length = strcspn(at, "\n");
        const bool is_last = at[length] == '\0';
        words[count++] = at;
        at[length] = '\0';
        at += length + (is_last ? 0 : 1);
    }
    words[count] = NULL;
    return count;
}

/* Which prints the help */
static bool asks_for_help(char *const *words)
{
    for (; *words != NULL; words++) {
        if (strcmp(*words, "--help") == 0 || strcmp(*words, "-h") == 0) {
            return true;
        }
    }
    return false;
}

static char *describe(const union values *values)
{
    struct text text = {0};
    text_add(&text, "{\n");
    options_describe(&terrain_table, values, &text);
    text_add(&text, "  \"end\": 0\n}");
    MUST(text.bytes != NULL, "no memory");
    return text.bytes;
}

/* Whether the option that a member describes is among the words */
static bool is_typed(const struct json_member *member, char *const *words)
{
    for (; *words != NULL; words++) {
        const char *const name = *words + 2;
        if (strncmp(*words, "--", 2) == 0 && strcspn(name, "=") == member->key_length &&
            memcmp(name, member->key, member->key_length) == 0) {
            return true;
        }
    }
    return false;
}

/* Adds the option that a member describes, as it would be typed. */
static void type_member(const struct json_member *member, struct text *typed)
{
    const char *value = member->value;
    size_t length = member->value_length;
    text_add(typed, "--%.*s", (int)member->key_length, member->key);
    if (*value == '"' || *value == '[') {
        value++;
        length -= 2;
    }
    const char *const comma = *member->value == '[' ? strchr(value, ',') : NULL;
    if (json_find(member, 1, "crs") != NULL) {
        text_add(typed, "\nEPSG:%.*s\n", (int)length, value);
    } else if (comma != NULL) {
        void *field;
        char name[64];
        snprintf(name, sizeof name, "--%.*s", (int)member->key_length, member->key);
        const struct option *const option =
            options_find(&terrain_table, 0, terrain_table.count, name, &first, &field);
        MUST(option != NULL, "no option %s", name);
        text_add(typed, "\n%.*s%c%.*s\n", (int)(comma - value), value,
                 option->parse == option_size ? 'x' : ',', (int)(value + length - comma - 2),
                 comma + 2);
    } else if (*member->value != 't' && *member->value != 'f') {
        text_add(typed, "\n%.*s\n", (int)length, value);
    } else {
        text_add(typed, "\n");
    }
}

/* Types what is described of the options that were typed. Texts may have what a line cannot; then
 * nothing is said of it. */
static void type_again(const char *description, char *const *typed_words)
{
    struct json_member members[MEMBERS_MOST];
    struct text typed = {0};
    char *words[WORDS_MOST + 1];
    const int count = json_read(description, members, MEMBERS_MOST);
    MUST(count > 0, "no JSON: %s", description);
    bool is_plain = true;
    text_add(&typed, "%s", "");
    for (int i = 0; i < count; i++) {
        if (!is_typed(&members[i], typed_words)) {
            continue;
        }
        is_plain = is_plain && (*members[i].value != '"' ||
                                (memchr(members[i].value, '\\', members[i].value_length) == NULL &&
                                 strncmp(members[i].value, "\"--", 3) != 0));
        type_member(&members[i], &typed);
    }
    cut(typed.bytes, words);
    if (is_plain && !asks_for_help(words)) {
        memcpy(&typed_again, &first, sizeof first);
        MUST(options_parse(&terrain_table, words, &typed_again) == OPTIONS_RUN,
             "what is described cannot be typed: %s", description);
        char *const again = describe(&typed_again);
        MUST(strcmp(again, description) == 0, "%s\nand %s", description, again);
        free(again);
    }
    free(typed.bytes);
}

/* How the raster falls into tiles */
static void check_tiling(const struct terrain_options *options)
{
    struct tiling tiling;
    memset(&tiling, 0, sizeof tiling);
    const bool is_right = tiling_make(options, &tiling);
    fuzz_must_tell(!is_right, "tiles");
    if (is_right) {
        MUST(tiling.begin <= tiling.end, "a share that ends before it begins");
        if (tiling.begin < tiling.end) {
            const struct tile one = tiling_at(&tiling, tiling.begin),
                              last = tiling_at(&tiling, tiling.end - 1);
            MUST(one.width > 0 && one.height > 0 && last.width > 0 && last.height > 0 &&
                     one.level < tiling.level_count && last.level < tiling.level_count,
                 "tiles without samples");
        }
        if (options->heights != NULL) {
            const bool is_path = pattern_check(options->heights, &tiling, "--heights");
            fuzz_must_tell(!is_path, "a pattern");
        }
    }
}

int LLVMFuzzerTestOneInput(const uint8_t *input, size_t size)
{
    static const struct option_table *const tables[] = {
        &terrain_table, &terrain_table, &view_table, &sheet_table, &sample_table, &recipe_table};
    struct draw bytes = {input, size};
    const struct option_table *const table =
        tables[draw_bits(&bytes, 1) % (sizeof tables / sizeof tables[0])];
    char *const text = fuzz_text(bytes.at, bytes.left);
    char *words[WORDS_MOST + 1];
    cut(text, words);
    if (asks_for_help(words)) {
        free(text);
        return 0;
    }
    memset(&first, 0, sizeof first);
    memset(&second, 0, sizeof second);
    fuzz_no_errors();
    const enum options_outcome outcome = options_parse(table, words, &first);
    fuzz_must_tell(outcome == OPTIONS_BAD, "options");
    MUST(options_parse(table, words, &second) == outcome &&
             memcmp(&first, &second, sizeof first) == 0,
         "other values the second time");
    fuzz_no_errors();
    if (outcome == OPTIONS_RUN && table == &terrain_table) {
        const struct terrain_options options = *(const struct terrain_options *)(void *)&first;
        char *const description = describe(&first);
        type_again(description, words);
        free(description);
        check_tiling(&options);
    }
    free(text);
    return 0;
}
