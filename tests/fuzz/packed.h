/* SPDX-License-Identifier: MIT
 *
 * The inputs of a fuzz target in one packed file:
 *
 *     8 bytes       "fuzzpack"
 *     then for each input, in ascending order of the names' bytes:
 *       1 byte      length of the name, 1 to PACKED_NAME_MOST
 *       ...         the name: letters, digits and "._-", a letter or a digit first
 *       4 bytes     number of bytes of the input, little-endian
 *       ...         the input
 *     8 bytes       FNV-1a of all bytes before, little-endian
 *
 * There is at least one input, and names differ.
 */
#ifndef SCARP_TESTS_FUZZ_PACKED_H
#define SCARP_TESTS_FUZZ_PACKED_H

#include <stddef.h>
#include <stdint.h>

#define PACKED_MOST (1 << 20) /* bytes of a packed file or of an input */
#define PACKED_NAME_MOST 63

struct packed_input {
    char name[PACKED_NAME_MOST + 1];
    uint8_t *bytes; /* an allocation of just this size, so that tools notice reads beyond it */
    size_t size;
};

/* Begins as {0}. */
struct packed {
    struct packed_input *inputs; /* sorted by name */
    size_t count;
};

/* These return NULL, or what is wrong, as a constant text. They end the program without memory.
   After an error, a set that was read has no inputs, and one that was added to has what it had. */
const char *packed_read(struct packed *set, const char *path);
const char *packed_parse(struct packed *set, const uint8_t *bytes, size_t size);
const char *packed_add(struct packed *set, const char *name, const uint8_t *bytes, size_t size);
const char *packed_write(const struct packed *set, const char *path);

/* The input with these bytes, or NULL */
const struct packed_input *packed_find(const struct packed *set, const uint8_t *bytes, size_t size);

/* Reads a whole file into `bytes`, which has room for PACKED_MOST. Returns NULL or what is wrong.
 */
const char *packed_load(const char *path, uint8_t *bytes, size_t *size);

void packed_free(struct packed *set);

#endif
