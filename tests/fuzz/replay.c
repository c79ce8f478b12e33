/* SPDX-License-Identifier: MIT
 *
 * In place of libFuzzer: runs a target on nothing, and on the inputs of a packed file. Before each
 * input its name is printed, so that the last line names the one that ended the program.
 */
#include "check.h"
#include "fuzz.h"
#include "packed.h"

int main(int argc, char **argv)
{
    struct packed set = {0};
    if (argc != 2) {
        fprintf(stderr, "usage: %s PACKED\n", argv[0]);
        return EXIT_FAILURE;
    }
    const char *const wrong = packed_read(&set, argv[1]);
    CHECK(wrong == NULL, "%s: %s", argv[1], wrong);
    CHECK(LLVMFuzzerTestOneInput((const uint8_t *)"", 0) == 0, "the empty input");
    for (size_t i = 0; i < set.count && check_failures == 0; i++) {
        const struct packed_input *const input = &set.inputs[i];
        printf("%s\n", input->name);
        fflush(stdout);
        CHECK(LLVMFuzzerTestOneInput(input->bytes, input->size) == 0, "%s", input->name);
    }
    packed_free(&set);
    return check_done();
}
