/* SPDX-License-Identifier: MIT
 *
 * An input read in whatever pieces it comes. A pipe that is fed slowly hands over what there is
 * instead of waiting until a buffer is full, as stdio does: what can be answered is answered. "-"
 * is standard input.
 */
#ifndef SCARP_CLI_INPUT_H
#define SCARP_CLI_INPUT_H

#include <stdbool.h>
#include <stddef.h>

#define INPUT_SIZE ((size_t)1 << 17)

/* Zero-initialise, then open. */
struct input {
    const char *name;  /* in messages */
    char *bytes;       /* room for INPUT_SIZE, and one more for a NUL */
    size_t start, end; /* bytes[start..end) was read and is not yet used */
    /* Private to input.c: */
    int descriptor;
    int error; /* why reading failed; 0: it did not */
    bool begun, ended;
};

/* False, with errno, if the file cannot be opened or memory is short. */
bool input_open(struct input *input, const char *path);

/* Waits for something to follow bytes[start..end), which must leave room and moves to the front of
   `bytes`. False if nothing follows: the end, or an error. */
bool input_more(struct input *input);

/* Waits until `length` unused bytes are there. False if the input ends before. */
bool input_need(struct input *input, size_t length);

/* Whether the unused bytes begin with these. Waits for no more bytes than that takes. */
bool input_begins_with(struct input *input, const char *bytes, size_t length);

/* An exit status: after an error, with a line on stderr, CLI_USAGE if nothing could be read at all
   (a directory) and CLI_FAILURE later; otherwise CLI_SUCCESS. */
int input_status(const struct input *input);

/* The name stays. May be called at any time after zero-initialisation. */
void input_close(struct input *input);

#endif
