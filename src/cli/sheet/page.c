/* SPDX-License-Identifier: MIT
 *
 * The layout. A line of text has a height of its own and a little room above and below. Each panel
 * has its label below it; with two axes, rows and columns have titles, too.
 */
#include "sheet/page.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "shared/bounds.h"
#include "sheet/font.h"

#define MARGIN 16
#define GAP 12          /* between panels */
#define LINE_ROOM 4     /* above and below a text, in dots */
#define TITLES_MOST 240 /* pixels of the titles of rows, at most, if panels are not wider */
#define TEXT_SIZE 256   /* with the end */

static const uint8_t paper[3] = {30, 32, 35};
static const uint8_t title_ink[3] = {250, 248, 240};
static const uint8_t label_ink[3] = {200, 204, 206};

/* How high a text is, with its room */
static size_t line_height(size_t scale)
{
    return scale * (FONT_HEIGHT + LINE_ROOM);
}

static size_t text_width(size_t scale, const char *text)
{
    return scale * FONT_ADVANCE * strlen(text);
}

/* "seed 3" */
static void put_value(const struct axis *axis, size_t value, char text[TEXT_SIZE])
{
    snprintf(text, TEXT_SIZE, "%s %s", axis->name, axis->values[value]);
}

static void put_label(const struct axes *axes, const size_t *at, char text[TEXT_SIZE])
{
    put_value(&axes->list[0], at[0], text);
    if (axes->count > 1) {
        const size_t length = strlen(text);
        snprintf(text + length, TEXT_SIZE - length, "  %s %s", axes->list[1].name,
                 axes->list[1].values[at[1]]);
    }
}

static size_t panels_of(const struct axes *axes)
{
    return axes->list[0].count * (axes->count > 1 ? axes->list[1].count : 1);
}

/* The widest label, at one pixel per dot */
static size_t labels_width(const struct page *page, const struct axes *axes)
{
    size_t widest = 0;
    for (size_t n = 0; n < panels_of(axes); n++) {
        char text[TEXT_SIZE];
        size_t at[AXES_MAX];
        page_values(page, axes, n, at);
        put_label(axes, at, text);
        const size_t width = text_width(1, text);
        widest = width > widest ? width : widest;
    }
    return widest;
}

/* The widest title of an axis, at one pixel per dot */
static size_t titles_width(const struct axis *axis)
{
    size_t widest = 0;
    for (size_t i = 0; i < axis->count; i++) {
        char text[TEXT_SIZE];
        put_value(axis, i, text);
        const size_t width = text_width(1, text);
        widest = width > widest ? width : widest;
    }
    return widest;
}

/* Texts have two pixels per dot if all of them fit next to or below a panel then. */
static size_t scale_of(const struct page *page, size_t width)
{
    return 2 * width <= page->panel_width ? 2 : 1;
}

void page_arrange(struct page *page, const struct axes *axes, size_t panel_width,
                  size_t panel_height)
{
    const size_t panels = panels_of(axes);
    *page = (struct page){.columns = axes->list[0].count,
                          .rows = axes->count > 1 ? axes->list[1].count : 1,
                          .panel_width = panel_width,
                          .panel_height = panel_height,
                          .left = MARGIN};
    if (axes->count == 1 && panels > 5) {
        page->columns = 3;
        while (page->columns * page->columns < panels) {
            page->columns++;
        }
        page->rows = (panels + page->columns - 1) / page->columns;
    }
    page->label_scale = scale_of(page, labels_width(page, axes));
    page->top = MARGIN;
    if (axes->count > 1) {
        const size_t across = titles_width(&axes->list[0]), down = titles_width(&axes->list[1]);
        page->title_scale = scale_of(page, across > down ? across : down);
        page->top += line_height(page->title_scale);
        const size_t most = panel_width > TITLES_MOST ? panel_width : TITLES_MOST;
        page->left += smaller(page->title_scale * down, most) + GAP;
    }
    page->width = page->left + page->columns * (panel_width + GAP) - GAP + MARGIN;
    page->height = page->top + page->rows * (panel_height + line_height(page->label_scale) + GAP) -
                   GAP + MARGIN;
}

uint8_t *page_panel(const struct page *page, size_t n)
{
    const size_t x = page->left + n % page->columns * (page->panel_width + GAP);
    const size_t y =
        page->top + n / page->columns * (page->panel_height + line_height(page->label_scale) + GAP);
    return page->rgb + 3 * (y * page->width + x);
}

void page_values(const struct page *page, const struct axes *axes, size_t n, size_t *at)
{
    at[0] = axes->count > 1 ? n % page->columns : n;
    at[1] = axes->count > 1 ? n / page->columns : 0;
}

/* How texts look */
struct pen {
    size_t scale, width; /* pixels per dot, and those that a text may take across */
    const uint8_t *ink;
};

static void put_dot(const struct page *page, const struct pen *pen, uint8_t *to)
{
    for (size_t row = 0; row < pen->scale; row++) {
        for (size_t i = 0; i < pen->scale; i++) {
            memcpy(to + 3 * (row * page->width + i), pen->ink, 3);
        }
    }
}

/* Writes as much of a text as there is room for; `to` is its top left pixel. */
static void put_text(const struct page *page, const struct pen *pen, const char *text, uint8_t *to)
{
    const size_t scale = pen->scale, most = pen->width / (scale * FONT_ADVANCE);
    const size_t length = strlen(text), shown = smaller(length, most);
    for (size_t n = 0; n < shown; n++) {
        /* What is cut off leaves two dots. */
        const char c = shown < length && n + 2 >= shown ? '.' : text[n];
        const uint8_t *const rows = font_rows(c);
        for (size_t dot = 0; dot < FONT_HEIGHT * FONT_WIDTH; dot++) {
            const size_t x = dot % FONT_WIDTH, y = dot / FONT_WIDTH;
            if ((rows[y] >> (FONT_WIDTH - 1 - x) & 1) != 0) {
                put_dot(page, pen, to + 3 * scale * (y * page->width + n * FONT_ADVANCE + x));
            }
        }
    }
}

static void put_titles(const struct page *page, const struct axes *axes)
{
    char text[TEXT_SIZE];
    const struct pen above = {page->title_scale, page->panel_width, title_ink};
    for (size_t column = 0; column < page->columns; column++) {
        put_value(&axes->list[0], column, text);
        put_text(page, &above, text,
                 page_panel(page, column) - 3 * page->width * line_height(page->title_scale));
    }
    const struct pen beside = {page->title_scale, page->left - GAP - MARGIN, title_ink};
    /* Negative where the title is higher than the panel */
    const ptrdiff_t down =
        (ptrdiff_t)(page->panel_height / 2) - (ptrdiff_t)(page->title_scale * FONT_HEIGHT / 2);
    for (size_t row = 0; row < page->rows; row++) {
        put_value(&axes->list[1], row, text);
        put_text(page, &beside, text,
                 page_panel(page, row * page->columns) + 3 * (ptrdiff_t)page->width * down -
                     3 * (beside.width + GAP));
    }
}

bool page_open(struct page *page, const struct axes *axes)
{
    page->memory = malloc(3 * page->width * (page->height + 1));
    if (page->memory == NULL) {
        return false;
    }
    memset(page->memory, 0, 3 * page->width);
    page->rgb = page->memory + 3 * page->width;
    for (size_t i = 0; i < page->width * page->height; i++) {
        memcpy(page->rgb + 3 * i, paper, 3);
    }
    const struct pen below = {page->label_scale, page->panel_width, label_ink};
    for (size_t n = 0; n < panels_of(axes); n++) {
        char text[TEXT_SIZE];
        size_t at[AXES_MAX];
        page_values(page, axes, n, at);
        put_label(axes, at, text);
        put_text(page, &below, text,
                 page_panel(page, n) +
                     3 * page->width * (page->panel_height + page->label_scale * LINE_ROOM));
    }
    if (axes->count > 1) {
        put_titles(page, axes);
    }
    return true;
}

void page_close(struct page *page)
{
    free(page->memory);
    *page = (struct page){.width = 0};
}
