/* SPDX-License-Identifier: MIT
 *
 * Writes the plan of the relief of src/gpu/samples, and what the library says of its pixels, for
 * pages.py.
 *
 *     write_relief PLAN PIXELS      PIXELS: floats, all heights, then all dx, then all dy
 */
#include <stdlib.h>

#include "../../src/gpu/samples/relief.h"

int main(int argc, char **argv)
{
    static struct relief terrain;
    FILE *const file = argc == 3 ? fopen(argv[2], "wb") : NULL;
    if (file == NULL || !relief_write_plan(argv[1]) || relief_by_library(&terrain) != SCARP_OK) {
        return EXIT_FAILURE;
    }
    const int written = fwrite(&terrain, sizeof terrain, 1, file) == 1;
    return fclose(file) == 0 && written ? EXIT_SUCCESS : EXIT_FAILURE;
}
