/* SPDX-License-Identifier: MIT
 *
 * The page of a sheet: where panels and texts are, and the texts.
 */
#ifndef SCARP_CLI_PAGE_H
#define SCARP_CLI_PAGE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "sheet/axes.h"

struct page {
    size_t width, height;             /* pixels */
    size_t columns, rows;             /* panels */
    size_t panel_width, panel_height; /* pixels of a panel */
    size_t left, top;                 /* of the first panel */
    size_t label_scale;               /* pixels per dot of labels */
    size_t title_scale;               /* and of titles */
    uint8_t *memory;                  /* a row of zeros, and the pixels: three bytes each */
    uint8_t *rgb;                     /* in there */
};

/* Decides where all is. With one axis, panels go on in the next row. */
void page_arrange(struct page *page, const struct axes *axes, size_t panel_width,
                  size_t panel_height);

/* Makes the page with its texts. False without memory. */
bool page_open(struct page *page, const struct axes *axes);
void page_close(struct page *page);

/* Where the top left pixel of panel number `n` goes, counted through the rows; rows of pixels are
   3 * width bytes apart. */
uint8_t *page_panel(const struct page *page, size_t n);

/* Which values panel number `n` has: at[i] of axis i. */
void page_values(const struct page *page, const struct axes *axes, size_t n, size_t *at);

#endif
