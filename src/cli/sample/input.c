/* SPDX-License-Identifier: MIT
 *
 * Reads by the system's own call: stdio has none that returns what there is.
 */
#include "sample/input.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>

#include "shared/error.h"
#include "shared/interrupt.h"
#include "shared/posix.h"

#define STDIN_DESCRIPTOR 0

bool input_open(struct input *input, const char *path)
{
    const bool standard = strcmp(path, "-") == 0;
    input->name = standard ? "standard input" : path;
    input->bytes = malloc(INPUT_SIZE + 1);
    if (input->bytes == NULL) {
        return false;
    }
    if (standard) {
        input->descriptor = STDIN_DESCRIPTOR;
        return true;
    }
    input->descriptor = open(path, O_RDONLY);
    if (input->descriptor < 0) {
        const int reason = errno;
        free(input->bytes);
        input->bytes = NULL;
        errno = reason;
    }
    return input->descriptor >= 0;
}

bool input_more(struct input *input)
{
    if (input->ended) {
        return false;
    }
    if (input->start > 0) {
        memmove(input->bytes, input->bytes + input->start, input->end - input->start);
        input->end -= input->start;
        input->start = 0;
    }
    long long count = -1;
    for (errno = EINTR; count < 0 && errno == EINTR && !interrupted();) {
        count = read(input->descriptor, input->bytes + input->end, INPUT_SIZE - input->end);
    }
    if (count <= 0) {
        input->error = count == 0 ? 0 : errno;
        input->ended = true;
        return false;
    }
    input->end += (size_t)count;
    input->begun = true;
    return true;
}

bool input_need(struct input *input, size_t length)
{
    while (input->end - input->start < length) {
        if (!input_more(input)) {
            return false;
        }
    }
    return true;
}

bool input_begins_with(struct input *input, const char *bytes, size_t length)
{
    for (size_t i = 0; i < length; i++) {
        if (!input_need(input, i + 1) || input->bytes[input->start + i] != bytes[i]) {
            return false;
        }
    }
    return true;
}

int input_status(const struct input *input)
{
    if (input->error == 0) {
        return CLI_SUCCESS;
    }
    if (input->error == EINTR) {
        cli_error("interrupted: not all points were read");
        return CLI_FAILURE;
    }
    cli_error("--input: %s: %s", input->name, strerror(input->error));
    return input->begun ? CLI_FAILURE : CLI_USAGE;
}

void input_close(struct input *input)
{
    if (input->bytes != NULL && input->descriptor != STDIN_DESCRIPTOR) {
        close(input->descriptor);
    }
    free(input->bytes);
    input->bytes = NULL;
}
