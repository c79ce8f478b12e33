/* SPDX-License-Identifier: MIT
 *
 * Numbers as text, one way to read and to write them. Used where points and results are text.
 */
#ifndef SCARP_CLI_NUMBER_H
#define SCARP_CLI_NUMBER_H

#define NUMBER_SIZE 32 /* room that any number written here takes */

/* Reads the decimal number at the start of `text` as strtod does, but no space before it, no
   "nan", no "inf", nothing hexadecimal. It may overflow to infinity. Returns what follows it; NULL
   if there is none. */
const char *number_read(const char *text, double *value);

/* Write a number as printf does with %.9g and %.17g, enough digits to read the same number again,
   but every NaN as "nan": its sign differs between processors. Return the end. */
char *number_write_float(char *to, float value);
char *number_write_double(char *to, double value);

/* Writes the shortest text of six digits or more that reads back as the same double, or the same
   float if `is_float`, of a finite number. Returns the end. */
char *number_write_shortest(char *to, double value, int is_float);

#endif
