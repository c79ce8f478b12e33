/* SPDX-License-Identifier: MIT
 *
 *     test_packed FILE
 *
 * A packed file gives back the inputs that were written, in the order of their names, and any
 * damage to it is noticed. FILE is written for this.
 */
#include "check.h"
#include "packed.h"

/* The longest name */
#define LONGEST "d12345678901234567890123456789012345678901234567890123456789012"

static const char zeros[300];

/* In the order of their names */
static const struct {
    const char *name;
    const char *bytes;
    size_t size;
} inputs[] = {{"A-3_b", "\r\n\x1a\xff", 4},
              {"b", "", 0},
              {"b.txt", "\0abc\0", 5},
              {"c", zeros, sizeof zeros},
              {LONGEST, "fuzzpack", 8}};

#define COUNT (sizeof inputs / sizeof inputs[0])

static const char *add(struct packed *set, size_t i)
{
    return packed_add(set, inputs[i].name, (const uint8_t *)inputs[i].bytes, inputs[i].size);
}

static void check_equal(const struct packed *set)
{
    CHECK(set->count == COUNT, "%zu inputs", set->count);
    for (size_t i = 0; i < COUNT && i < set->count; i++) {
        const struct packed_input *const input = &set->inputs[i];
        CHECK(strcmp(input->name, inputs[i].name) == 0, "%s at %zu", input->name, i);
        CHECK(input->size == inputs[i].size, "%s has %zu bytes", input->name, input->size);
        CHECK(packed_find(set, (const uint8_t *)inputs[i].bytes, inputs[i].size) == input,
              "%s is not found by its bytes", input->name);
    }
}

static void check_names(struct packed *set)
{
    static const char *const bad[] = {"",     ".",   "..",  ".a",       "-a",  "_",        "a/b",
                                      "a\\b", "a b", "a:b", "\xc3\xa4", "a\n", LONGEST "3"};
    for (size_t i = 0; i < sizeof bad / sizeof bad[0]; i++) {
        CHECK(packed_add(set, bad[i], NULL, 0) != NULL, "the name \"%s\" is taken", bad[i]);
    }
    for (size_t i = 0; i < COUNT; i++) {
        CHECK(add(set, i) != NULL, "%s is taken twice", inputs[i].name);
    }
    check_equal(set);
}

/* A copy of just that size, so that tools notice what reads beyond it */
static const char *parse(const uint8_t *bytes, size_t size)
{
    struct packed set;
    uint8_t *const copy = malloc(size > 0 ? size : 1);
    memcpy(copy, bytes, size);
    const char *const wrong = packed_parse(&set, copy, size);
    CHECK((wrong == NULL) == (set.count > 0), "%zu inputs: %s", set.count, wrong ? wrong : "read");
    packed_free(&set);
    free(copy);
    return wrong;
}

static void write_sum(uint8_t *bytes, size_t size)
{
    uint64_t hash = FNV_BASIS;
    for (size_t i = 0; i < size - 8; i++) {
        hash = fnv_byte(hash, bytes[i]);
    }
    for (size_t i = 0; i < 8; i++) {
        bytes[size - 8 + i] = (uint8_t)(hash >> (8 * i));
    }
}

/* Every byte of the file is changed and every beginning of it is read, which the checksum notices.
   With a new checksum, names, sizes and order must be refused. */
static void check_damage(uint8_t *bytes, size_t size)
{
    CHECK(parse(bytes, size) == NULL, "the file is not read");
    for (size_t i = 0; i < size; i++) {
        CHECK(parse(bytes, i) != NULL, "%zu of %zu bytes are read", i, size);
        bytes[i] ^= 1;
        CHECK(parse(bytes, size) != NULL, "byte %zu can change", i);
        bytes[i] ^= 1;
    }
    size_t end = 8; /* of the inputs that are whole */
    for (size_t i = 8, whole = 0; i < size - 8; i++) {
        uint8_t *const copy = malloc(i + 8);
        memcpy(copy, bytes, i);
        write_sum(copy, i + 8);
        if (i == end + 1 + strlen(inputs[whole].name) + 4 + inputs[whole].size) {
            end = i;
            whole++;
        }
        CHECK((parse(copy, i + 8) == NULL) == (i == end && whole > 0), "cut at %zu of %zu bytes", i,
              size);
        free(copy);
    }
    static const struct {
        size_t at;
        uint8_t value;
        const char *what;
    } edits[] = {
        {8, 0, "no name"},          {8, 64, "a long name"},      {8, 255, "a longer name"},
        {9, '/', "a slash"},        {10, 0, "a 0 byte"},         {9, 'x', "wrong order"},
        {14, 5, "a shorter input"}, {14, 200, "a longer input"}, {17, 255, "an input of 4 GB"}};
    for (size_t i = 0; i < sizeof edits / sizeof edits[0]; i++) {
        const uint8_t old = bytes[edits[i].at];
        bytes[edits[i].at] = edits[i].value;
        write_sum(bytes, size);
        CHECK(parse(bytes, size) != NULL, "%s is read", edits[i].what);
        bytes[edits[i].at] = old;
    }
    write_sum(bytes, size);
    CHECK(parse(bytes, size) == NULL, "the file is not read again");
}

int main(int argc, char **argv)
{
    static const size_t order[COUNT] = {2, 0, 4, 3, 1};
    static uint8_t bytes[PACKED_MOST];
    struct packed set = {0};
    size_t size = 0;
    if (argc != 2) {
        fprintf(stderr, "usage: %s FILE\n", argv[0]);
        return EXIT_FAILURE;
    }
    CHECK(packed_write(&set, argv[1]) != NULL, "a file without inputs is written");
    for (size_t i = 0; i < COUNT; i++) {
        CHECK(add(&set, order[i]) == NULL, "%s is refused", inputs[order[i]].name);
    }
    check_equal(&set);
    check_names(&set);
    CHECK(packed_write(&set, argv[1]) == NULL, "%s is not written", argv[1]);
    packed_free(&set);
    CHECK(packed_read(&set, argv[1]) == NULL, "%s is not read", argv[1]);
    check_equal(&set);
    packed_free(&set);
    CHECK(packed_load(argv[1], bytes, &size) == NULL, "%s is not read", argv[1]);
    check_damage(bytes, size);
    return check_done();
}
