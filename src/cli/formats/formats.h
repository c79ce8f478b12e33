/* SPDX-License-Identifier: MIT
 *
 * The formats of rasters, one by one and as a list.
 */
#ifndef SCARP_CLI_FORMATS_H
#define SCARP_CLI_FORMATS_H

#include "formats/writer.h"

extern const struct format format_png; /* 16-bit or 8-bit grey; 8-bit red, green, blue, alpha */
extern const struct format format_pgm; /* 16-bit or 8-bit grey */
extern const struct format format_ppm; /* 8-bit red, green, blue */
extern const struct format format_r16; /* nothing but 16-bit integers */
extern const struct format format_r32; /* nothing but floats */
extern const struct format format_pfm; /* floats, bottom row first */
extern const struct format format_img; /* ENVI: bytes or floats, and a header file next to it */
bool img_knows(unsigned epsg);         /* whether its header can name that system */
extern const struct format format_npy; /* NumPy: bytes or floats */
extern const struct format format_tif; /* GeoTIFF: bytes, 16-bit integers or floats */

/* Ends with NULL. PNG is there only with zlib. */
extern const struct format *const formats_known[];

#ifdef SCARP_CLI_ZLIB
const char *png_version(void); /* of zlib */
#endif

#endif
