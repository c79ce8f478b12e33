/* SPDX-License-Identifier: MIT
 *
 * The list of formats, in the order in which the program lists them.
 */
#include "formats/formats.h"

const struct format *const formats_known[] = {
#ifdef SCARP_CLI_ZLIB
    &format_png,
#endif
    &format_pgm, &format_ppm, &format_r16, &format_r32, &format_pfm,
    &format_img, &format_tif, &format_npy, NULL,
};
