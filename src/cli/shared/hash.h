/* SPDX-License-Identifier: MIT
 *
 * XXH64 with seed 0: a fast 64-bit checksum, the same as the program xxhsum prints. It finds what
 * was damaged, not what somebody forged. (Y. Collet, xxHash fast digest algorithm, version 0.1.1)
 */
#ifndef SCARP_CLI_HASH_H
#define SCARP_CLI_HASH_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

struct hash {
    uint64_t lane[4];
    uint64_t length;
    uint8_t held[32]; /* what is not yet a whole stripe */
};

void hash_begin(struct hash *hash);
void hash_add(struct hash *hash, const void *bytes, size_t count);
uint64_t hash_end(const struct hash *hash);

/* Of a whole file. False, with errno, if it cannot be read. */
bool hash_file(const char *path, uint64_t *sum);

#endif
