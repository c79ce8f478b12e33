/* SPDX-License-Identifier: MIT
 *
 * Whether a file is whole, which --resume asks of .png, .tif and .img: of other bytes, it is not.
 *
 * The first byte says which format.
 */
#include <string.h>

#include "cli.h"
#include "draw.h"
#include "formats/formats.h"
#include "fuzz.h"

int LLVMFuzzerTestOneInput(const uint8_t *input, size_t size)
{
    static const struct {
        const struct format *format;
        const char *name;
        size_t least; /* bytes of a whole file */
    } kinds[] = {
        {&format_tif, "w.tif", 16},
        {&format_img, "w.hdr", 100},
#ifdef SCARP_CLI_ZLIB
        {&format_png, "w.png", 36},
#endif
    };
    struct draw bytes = {input, size};
    const size_t kind = draw_bits(&bytes, 1) % (sizeof kinds / sizeof kinds[0]);
    const bool is_big = kind == 0 && bytes.left % 2 == 1;
    const struct raster raster = {.width = is_big ? 100000 : 3,
                                  .height = is_big ? 100000 : 2,
                                  .channels = 1,
                                  .type = SAMPLE_F32,
                                  .step = 1.0,
                                  .content = "heights",
                                  .times = 1};
    const char *const path = fuzz_file(kinds[kind].name, bytes.at, bytes.left);
    char image[320];
    snprintf(image, sizeof image, "%s", path);
    if (kind == 1) {
        strcpy(image + strlen(image) - strlen("hdr"), "img");
    }
    MUST(!kinds[kind].format->is_whole(&raster, image) || bytes.left >= kinds[kind].least,
         "%zu bytes are a whole file %s", bytes.left, kinds[kind].name);
    return 0;
}
