/* SPDX-License-Identifier: MIT
 *
 * Amounts for readers, in the unit that suits their size: no message says 0.00 GB.
 */
#ifndef SCARP_CLI_AMOUNT_H
#define SCARP_CLI_AMOUNT_H

#include <stdint.h>

#define AMOUNT_SIZE 48 /* room for what these write; they return `text` */

/* "640 ", "12.3 thousand ", "4.1 million ": what is counted follows. */
const char *amount_count(char text[AMOUNT_SIZE], double count);

/* "1 byte", "640 bytes", "3.42 kB", "17.18 GB" */
const char *amount_bytes(char text[AMOUNT_SIZE], uint64_t bytes);

/* Two amounts that differ, by so many digits that it shows */
void amount_bytes_two(char one[AMOUNT_SIZE], uint64_t bytes, char other[AMOUNT_SIZE],
                      uint64_t other_bytes);

/* "21.084 s", "350.2 ms", "41.0 us" */
const char *amount_seconds(char text[AMOUNT_SIZE], double seconds);

#endif
