/* SPDX-License-Identifier: MIT
 *
 * A font of dots: the printable characters of ASCII.
 */
#ifndef SCARP_CLI_FONT_H
#define SCARP_CLI_FONT_H

#include <stddef.h>
#include <stdint.h>

#define FONT_WIDTH 5   /* dots of a character, without the gap to the next one */
#define FONT_HEIGHT 9  /* of which two are below the base line */
#define FONT_ADVANCE 6 /* from one character to the next */

/* The rows of a character, from the top: bit 4 is the dot at the left. What is not printable looks
   like a question mark. */
const uint8_t *font_rows(char c);

#endif
