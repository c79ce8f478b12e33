/* SPDX-License-Identifier: MIT
 *
 * What the two halves of GeoTIFF share: the file, and the packing of its tiles.
 */
#ifndef SCARP_CLI_TIFF_H
#define SCARP_CLI_TIFF_H

#include "formats/writer.h"

#define TIFF_SIDE 256 /* of a tile; rows of parts are powers of two */

#ifdef SCARP_CLI_ZLIB
#define TIFF_DEFLATES true
#else
#define TIFF_DEFLATES false
#endif

/* A tile takes no more, packed or not. */
size_t tiff_room(const struct raster *raster);

/* The tiles of a file that is being written; in writer->memory */
struct tiff_tiles {
    uint64_t end;   /* of the last one, in the file */
    uint64_t count; /* that are written */
    uint32_t sizes[];
};

extern const struct packing tiff_packing;

#endif
