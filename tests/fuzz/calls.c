/* SPDX-License-Identifier: MIT
 *
 * Makes a target of one of the functions of arguments.h: TARGET.
 */
#include "arguments.h"
#include "fuzz.h"

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t size)
{
    TARGET(bytes, size);
    return 0;
}
