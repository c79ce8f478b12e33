/* SPDX-License-Identifier: MIT
 *
 * Packs all parts, then writes them.
 */
#include "formats/whole.h"

#include <errno.h>
#include <stdlib.h>

struct whole {
    const struct writer *writer;
    struct crew *crew;
    struct part *parts;
    size_t count; /* of parts */
};

/* Parts that no thread packs keep the size 0. */
static void pack(void *context, size_t number)
{
    const struct whole *const whole = context;
    const struct packing *const packing = whole->writer->format->packing;
    void *const packer = packing->open();
    (void)number;
    for (size_t n; packer != NULL && (n = crew_next(whole->crew)) < whole->count;) {
        packing->pack(packer, &whole->writer->raster, &whole->parts[n]);
    }
    if (packer != NULL) {
        packing->close(packer);
    }
}

static bool write_parts(struct writer *writer, const struct whole *whole)
{
    for (size_t n = 0; n < whole->count; n++) {
        if (!writer_write_part(writer, &whole->parts[n])) {
            return false;
        }
    }
    return true;
}

static bool pack_and_write(struct writer *writer, struct crew *crew, const uint8_t *samples)
{
    const struct raster *const raster = &writer->raster;
    const struct parts parts = parts_of(writer->format->packing, raster);
    struct whole whole = {
        .writer = writer, .crew = crew, .count = parts_count(&parts, raster->height)};
    uint8_t *const bytes = malloc(whole.count * parts.room);
    whole.parts = calloc(whole.count, sizeof *whole.parts);
    bool is_written = bytes != NULL && whole.parts != NULL;
    errno = ENOMEM;
    for (size_t n = 0; n < whole.count && is_written; n++) {
        whole.parts[n] = parts_at(&parts, raster, samples, 0, n);
        whole.parts[n].bytes = bytes + n * parts.room;
    }
    if (is_written) {
        const size_t most = crew_most(crew);
        crew_run(crew, most < whole.count ? most : whole.count, pack, &whole);
        errno = 0;
        is_written = write_parts(writer, &whole);
    }
    free(bytes);
    free(whole.parts);
    return is_written;
}

bool writer_write_whole(struct writer *writer, struct crew *crew, const uint8_t *samples)
{
    return writer->format->packing != NULL
               ? pack_and_write(writer, crew, samples)
               : writer_write(writer, samples, 0, writer->raster.height);
}
