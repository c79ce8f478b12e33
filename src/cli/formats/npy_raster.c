/* SPDX-License-Identifier: MIT
 *
 * NumPy's .npy with height x width samples, or height x width x channels.
 */
#include "formats/formats.h"
#include "formats/npy.h"

static bool npy_open(struct writer *writer)
{
    const struct raster *const raster = &writer->raster;
    const size_t shape[] = {raster->height, raster->width, raster->channels};
    return npy_write_header(writer->file.stream, raster->type == SAMPLE_U8 ? "|u1" : "<f4", shape,
                            raster->channels == 1 ? 2 : 3);
}

static uint64_t npy_bytes(const struct raster *raster)
{
    return NPY_HEADER_SIZE + raster_bytes(raster);
}

#define TYPES (SAMPLE_U8 | SAMPLE_F32)
const struct format format_npy = {.name = "npy",
                                  .types = {0, TYPES, TYPES, TYPES},
                                  .open = npy_open,
                                  .write = writer_write_raw,
                                  .bytes = npy_bytes};
