/* SPDX-License-Identifier: MIT
 *
 * PNG by libpng; built only where it was found. libpng reports errors by longjmp, so each function
 * that calls it has one setjmp and no local variable that changes after it.
 */
#include <errno.h>
#include <png.h>
#include <setjmp.h>
#include <stdlib.h>

#include "image.h"

/* Of 1 to 9. Fractal terrain hardly compresses: measured on the three default pictures together, 6
   (libpng's own choice) saves 8 % of the bytes over 1 and takes four times as long. */
#define COMPRESSION_LEVEL 1

struct png_state {
    png_structp png;
    png_infop info;
};

static void on_error(png_structp png, png_const_charp message)
{
    (void)message;
    png_longjmp(png, 1);
}

static void on_warning(png_structp png, png_const_charp message)
{
    (void)png;
    (void)message;
}

/* libpng's own writer would take its FILE from another C library on some systems. */
static void write_bytes(png_structp png, png_bytep bytes, size_t count)
{
    if (fwrite(bytes, 1, count, png_get_io_ptr(png)) != count) {
        png_error(png, "write error");
    }
}

static void flush_bytes(png_structp png)
{
    if (fflush(png_get_io_ptr(png)) != 0) {
        png_error(png, "write error");
    }
}

static bool create(struct png_state *state)
{
    state->png = png_create_write_struct(PNG_LIBPNG_VER_STRING, NULL, on_error, on_warning);
    if (state->png == NULL) {
        return false;
    }
    state->info = png_create_info_struct(state->png);
    return state->info != NULL;
}

static bool png_open(struct image *image)
{
    struct png_state *const state = calloc(1, sizeof *state);
    image->state = state;
    if (state == NULL || !create(state)) {
        errno = ENOMEM;
        return false;
    }
    if (setjmp(png_jmpbuf(state->png))) {
        return false;
    }
    png_set_write_fn(state->png, image->file, write_bytes, flush_bytes);
    png_set_compression_level(state->png, COMPRESSION_LEVEL);
    png_set_IHDR(state->png, state->info, (png_uint_32)image->width, (png_uint_32)image->height,
                 image->depth, image->channels == 1 ? PNG_COLOR_TYPE_GRAY : PNG_COLOR_TYPE_RGB,
                 PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
    png_write_info(state->png, state->info);
    return true;
}

static bool png_row(struct image *image, const uint8_t *samples)
{
    struct png_state *const state = image->state;
    if (setjmp(png_jmpbuf(state->png))) {
        return false;
    }
    png_write_row(state->png, samples);
    return true;
}

static bool png_end(struct png_state *state)
{
    if (setjmp(png_jmpbuf(state->png))) {
        return false;
    }
    png_write_end(state->png, state->info);
    return true;
}

static bool png_close(struct image *image, bool complete)
{
    struct png_state *const state = image->state;
    if (state == NULL) {
        return false;
    }
    const bool ended = complete && png_end(state);
    const int reason = errno;
    png_destroy_write_struct(&state->png, &state->info);
    free(state);
    image->state = NULL;
    errno = reason;
    return ended || !complete;
}

const char *image_png_version(void)
{
    return png_get_libpng_ver(NULL);
}

const struct image_format image_png = {
    .grey_extension = ".png",
    .colour_extension = ".png",
    .open = png_open,
    .row = png_row,
    .close = png_close,
};
