/* SPDX-License-Identifier: MIT
 *
 * The life of a picture's file: temporary name, final name, removal. The formats are in pnm.c and
 * png.c.
 */
#include "image.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>

#ifdef SCARP_CLI_PNG
static const struct image_format *const best_format = &image_png;
#else
static const struct image_format *const best_format = &image_pnm;
#endif

/* The texts one after the other, in memory that the caller frees; NULL without memory. */
static char *join(const char *const *texts)
{
    size_t length = 1;
    for (size_t i = 0; texts[i] != NULL; i++) {
        length += strlen(texts[i]);
    }
    char *const joined = malloc(length);
    if (joined == NULL) {
        return NULL;
    }
    joined[0] = '\0';
    for (size_t i = 0; texts[i] != NULL; i++) {
        strcat(joined, texts[i]);
    }
    return joined;
}

/* Whether `path` can take the picture: nothing is there yet, or a file that may be changed.
   Renaming would tell only at the very end, and would replace a write-protected file. */
static bool is_replaceable(const char *path)
{
    FILE *const file = fopen(path, "r+b");
    if (file == NULL) {
        return errno == ENOENT;
    }
    return fclose(file) == 0;
}

bool image_open(struct image *image, const char *stem)
{
    image->format = best_format;
    const char *const extension =
        image->channels == 1 ? image->format->grey_extension : image->format->colour_extension;
    image->path = join((const char *const[]){stem, "-", image->name, extension, NULL});
    if (image->path == NULL) {
        return false;
    }
    image->partial = join((const char *const[]){image->path, ".part", NULL});
    if (image->partial == NULL || !is_replaceable(image->path)) {
        return false;
    }
    image->file = fopen(image->partial, "wb");
    image->created = image->file != NULL;
    return image->created && image->format->open(image);
}

bool image_row(struct image *image, const uint8_t *samples)
{
    return image->format->row(image, samples);
}

/* The format's end and the file's, both in any case. */
static bool finish(struct image *image, bool complete)
{
    const bool formatted = image->format->close(image, complete);
    const int reason = errno;
    const bool closed = fclose(image->file) == 0;
    image->file = NULL;
    if (!formatted) {
        errno = reason;
    }
    return formatted && closed;
}

bool image_close(struct image *image)
{
    return finish(image, true);
}

bool image_publish(struct image *image)
{
#ifdef _WIN32
    remove(image->path); /* where rename does not replace */
#endif
    image->published = rename(image->partial, image->path) == 0;
    return image->published;
}

void image_discard(struct image *image, bool keep)
{
    if (image->file != NULL) {
        finish(image, false);
    }
    if (image->created && !keep) {
        remove(image->published ? image->path : image->partial);
    }
    free(image->path);
    free(image->partial);
    *image = (struct image){0};
}
