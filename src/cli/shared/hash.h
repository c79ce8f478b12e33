/* SPDX-License-Identifier: MIT
 *
 * XXH64 with seed 0: a fast 64-bit checksum, the same as the program xxhsum prints. It finds what
 * was damaged, not what somebody forged. (Y. Collet, xxHash fast digest algorithm, version 0.1.1)
 */
#ifndef SCARP_CLI_HASH_H
#define SCARP_CLI_HASH_H

#include <stdbool.h>
#include <stdint.h>

/* Of a file. False, with errno, if it cannot be read. */
bool hash_file(const char *path, uint64_t *sum);

#endif
