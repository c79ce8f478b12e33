/* SPDX-License-Identifier: MIT
 *
 * Packed files of inputs; packed.h has the format.
 */
#include "packed.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "check.h"

#define MAGIC "fuzzpack"
#define MAGIC_SIZE 8
#define SIZE_SIZE 4
#define SUM_SIZE 8

static void *allocate(void *old, size_t size)
{
    void *const memory = realloc(old, size > 0 ? size : 1);
    if (memory == NULL) {
        fprintf(stderr, "no memory\n");
        exit(EXIT_FAILURE);
    }
    return memory;
}

static void put(uint8_t *bytes, uint64_t value, size_t size)
{
    for (size_t i = 0; i < size; i++) {
        bytes[i] = (uint8_t)(value >> (8 * i));
    }
}

static uint64_t get(const uint8_t *bytes, size_t size)
{
    uint64_t value = 0;
    for (size_t i = 0; i < size; i++) {
        value |= (uint64_t)bytes[i] << (8 * i);
    }
    return value;
}

static uint64_t sum(const uint8_t *bytes, size_t size)
{
    uint64_t hash = FNV_BASIS;
    for (size_t i = 0; i < size; i++) {
        hash = fnv_byte(hash, bytes[i]);
    }
    return hash;
}

static int is_name(const char *name)
{
    static const char known[] = "._-0123456789abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ";
    const size_t length = strlen(name);
    return length > 0 && length <= PACKED_NAME_MOST && strspn(name, known) == length &&
           strchr("._-", name[0]) == NULL;
}

const char *packed_add(struct packed *set, const char *name, const uint8_t *bytes, size_t size)
{
    size_t at = set->count;
    if (!is_name(name)) {
        return "a name has 1 to 63 letters, digits and \"._-\", a letter or a digit first";
    }
    while (at > 0 && strcmp(set->inputs[at - 1].name, name) >= 0) {
        at--;
    }
    if (at < set->count && strcmp(set->inputs[at].name, name) == 0) {
        return "another input has this name";
    }
    set->inputs = allocate(set->inputs, (set->count + 1) * sizeof *set->inputs);
    struct packed_input *const input = &set->inputs[at];
    memmove(input + 1, input, (set->count - at) * sizeof *input);
    set->count++;
    strcpy(input->name, name);
    input->size = size;
    input->bytes = allocate(NULL, size);
    memcpy(input->bytes, bytes, size);
    return NULL;
}

const struct packed_input *packed_find(const struct packed *set, const uint8_t *bytes, size_t size)
{
    for (size_t i = 0; i < set->count; i++) {
        const struct packed_input *const input = &set->inputs[i];
        if (input->size == size && memcmp(input->bytes, bytes, size) == 0) {
            return input;
        }
    }
    return NULL;
}

/* Adds the input at `bytes`, of which at most `size` belong to it, and says how many do. */
static const char *parse_input(struct packed *set, const uint8_t *bytes, size_t size, size_t *taken)
{
    char name[PACKED_NAME_MOST + 1] = "";
    const size_t length = bytes[0], begin = 1 + length + SIZE_SIZE;
    if (length > PACKED_NAME_MOST || begin > size) {
        return "damaged: a name is too long";
    }
    memcpy(name, bytes + 1, length);
    const uint64_t input_size = get(bytes + 1 + length, SIZE_SIZE);
    if (strlen(name) != length) {
        return "damaged: a name has a byte of 0";
    }
    if (input_size > size - begin) {
        return "damaged: an input is too long";
    }
    if (set->count > 0 && strcmp(set->inputs[set->count - 1].name, name) > 0) {
        return "damaged: names are not in order";
    }
    *taken = begin + (size_t)input_size;
    return packed_add(set, name, bytes + begin, (size_t)input_size);
}

const char *packed_parse(struct packed *set, const uint8_t *bytes, size_t size)
{
    const char *wrong = NULL;
    size_t at = MAGIC_SIZE;
    *set = (struct packed){0};
    if (size < MAGIC_SIZE + SUM_SIZE || memcmp(bytes, MAGIC, MAGIC_SIZE) != 0) {
        return "not a packed file";
    }
    const size_t end = size - SUM_SIZE;
    if (get(bytes + end, SUM_SIZE) != sum(bytes, end)) {
        return "damaged: the checksum differs";
    }
    while (wrong == NULL && at < end) {
        size_t taken = 0;
        wrong = parse_input(set, bytes + at, end - at, &taken);
        at += taken;
    }
    if (wrong == NULL && set->count == 0) {
        wrong = "no inputs";
    }
    if (wrong != NULL) {
        packed_free(set);
    }
    return wrong;
}

const char *packed_load(const char *path, uint8_t *bytes, size_t *size)
{
    FILE *const file = fopen(path, "rb");
    if (file == NULL) {
        return "cannot be opened";
    }
    *size = fread(bytes, 1, PACKED_MOST, file);
    const char *const wrong = ferror(file)           ? "cannot be read"
                              : *size == PACKED_MOST ? "too long"
                                                     : NULL;
    fclose(file);
    return wrong;
}

const char *packed_read(struct packed *set, const char *path)
{
    uint8_t *const bytes = allocate(NULL, PACKED_MOST);
    size_t size = 0;
    *set = (struct packed){0};
    const char *wrong = packed_load(path, bytes, &size);
    if (wrong == NULL) {
        wrong = packed_parse(set, bytes, size);
    }
    free(bytes);
    return wrong;
}

const char *packed_write(const struct packed *set, const char *path)
{
    size_t size = MAGIC_SIZE, at = MAGIC_SIZE;
    for (size_t i = 0; i < set->count; i++) {
        size += 1 + strlen(set->inputs[i].name) + SIZE_SIZE + set->inputs[i].size;
    }
    if (set->count == 0) {
        return "no inputs";
    }
    if (size + SUM_SIZE >= PACKED_MOST) {
        return "too long";
    }
    uint8_t *const bytes = allocate(NULL, size + SUM_SIZE);
    memcpy(bytes, MAGIC, MAGIC_SIZE);
    for (size_t i = 0; i < set->count; i++) {
        const struct packed_input *const input = &set->inputs[i];
        const size_t length = strlen(input->name);
        bytes[at] = (uint8_t)length;
        memcpy(bytes + at + 1, input->name, length);
        put(bytes + at + 1 + length, input->size, SIZE_SIZE);
        memcpy(bytes + at + 1 + length + SIZE_SIZE, input->bytes, input->size);
        at += 1 + length + SIZE_SIZE + input->size;
    }
    put(bytes + size, sum(bytes, size), SUM_SIZE);
    size += SUM_SIZE;
    FILE *const file = fopen(path, "wb");
    const int is_written = file != NULL && fwrite(bytes, 1, size, file) == size;
    const int is_closed = file != NULL && fclose(file) == 0;
    free(bytes);
    return is_written && is_closed ? NULL : "cannot be written";
}

void packed_free(struct packed *set)
{
    for (size_t i = 0; i < set->count; i++) {
        free(set->inputs[i].bytes);
    }
    free(set->inputs);
    *set = (struct packed){0};
}
