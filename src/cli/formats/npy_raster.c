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
    return npy_write_header(writer->file.stream, raster->kind == SAMPLE_U8 ? "|u1" : "<f4", shape,
                            raster->channels == 1 ? 2 : 3);
}

static bool npy_is_whole(const struct raster *raster, const char *path)
{
    return writer_has_size(raster, path, NPY_HEADER_SIZE);
}

#define KINDS (SAMPLE_U8 | SAMPLE_F32)
const struct format format_npy = {.name = "npy",
                                  .kinds = {0, KINDS, KINDS, KINDS},
                                  .open = npy_open,
                                  .write = writer_write_raw,
                                  .is_whole = npy_is_whole};
