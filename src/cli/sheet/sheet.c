/* SPDX-License-Identifier: MIT
 *
 * `scarp sheet`: from the options to the file. The parameters that panels differ in are read in
 * axes.c, panels are made and drawn in panel.c, and page.c has the page they are on.
 */
#include "commands.h"

#include <errno.h>
#include <stdatomic.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "formats/choose.h"
#include "formats/whole.h"
#include "ground/source.h"
#include "shared/amount.h"
#include "shared/crew.h"
#include "shared/error.h"
#include "shared/interrupt.h"
#include "shared/progress.h"
#include "shared/running.h"
#include "sheet/page.h"
#include "sheet/panel.h"

#ifdef SCARP_CLI_ZLIB
#define STANDARD_OUTPUT "sheet.png"
#else
#define STANDARD_OUTPUT "sheet.ppm"
#endif

struct sheet {
    struct sheet_options options;
    struct axes axes;
    struct page page;
    struct panel *panels;
    size_t count;
    struct crew *crew;
    struct writer writer;
    size_t row;             /* of panels: what is drawn */
    atomic_bool has_failed; /* for want of memory */
};

static bool choose_format(struct sheet *sheet)
{
    static const struct wanted wanted = {
        .option = "--output", .content = "sheets", .channels = 3, .types = SAMPLE_U8};
    const char *const output = sheet->options.output;
    struct writer *const writer = &sheet->writer;
    writer->format =
        format_choose(&wanted, output != NULL ? output : STANDARD_OUTPUT, &writer->path);
    writer->raster = (struct raster){.width = sheet->page.width,
                                     .height = sheet->page.height,
                                     .channels = 3,
                                     .type = SAMPLE_U8,
                                     .step = 1.0,
                                     .content = "sheet",
                                     .times = 1};
    return writer->format != NULL;
}

/* All panels, so that none is drawn if there is a mistake in one */
static int make_cells(struct sheet *sheet, char **argv)
{
    const struct ground_options *const ground = &sheet->options.ground;
    const bool has_recipe = ground->preset != 0 || ground->recipe != NULL;
    sheet->count = sheet->axes.list[0].count;
    sheet->count *= sheet->axes.count > 1 ? sheet->axes.list[1].count : 1;
    sheet->panels = calloc(sheet->count, sizeof *sheet->panels);
    if (sheet->panels == NULL) {
        cli_error("--sheet: no memory");
        return CLI_FAILURE;
    }
    for (size_t n = 0; n < sheet->count; n++) {
        size_t at[AXES_MAX];
        if (interrupted()) {
            cli_error("interrupted: nothing was written");
            return CLI_FAILURE;
        }
        page_values(&sheet->page, &sheet->axes, n, at);
        if (!panel_make(&sheet->panels[n], argv, has_recipe, &sheet->axes, at)) {
            return CLI_USAGE;
        }
    }
    return CLI_SUCCESS;
}

/* Draws bands of the panels of a row, as they come. */
static void draw(void *context, size_t number)
{
    struct sheet *const sheet = context;
    const struct page *const page = &sheet->page;
    const size_t bands = (page->panel_height + PANEL_BAND - 1) / PANEL_BAND;
    const size_t first = sheet->row * page->columns;
    const size_t left = sheet->count - first;
    const size_t tasks = bands * (left < page->columns ? left : page->columns);
    (void)number;
    for (size_t n; (n = crew_next(sheet->crew)) < tasks && !interrupted();) {
        const size_t panel = first + n / bands;
        if (!panel_draw(&sheet->panels[panel], n % bands * PANEL_BAND, page_panel(page, panel),
                        3 * page->width)) {
            atomic_store(&sheet->has_failed, true);
        }
    }
}

static int tell_failure(const struct sheet *sheet, int reason)
{
    if (interrupted()) {
        cli_error("interrupted: the unfinished file is removed");
    } else if (reason == ENOMEM) {
        cli_error("no memory for %zux%zu pixels", sheet->page.width, sheet->page.height);
    } else {
        cli_error("--output: %s: %s", file_name(sheet->writer.path), file_reason(reason));
    }
    return CLI_FAILURE;
}

/* Draws all panels. False, with errno, without memory or when interrupted. */
static bool draw_all(struct sheet *sheet, struct progress *progress)
{
    if (!page_open(&sheet->page, &sheet->axes)) {
        errno = ENOMEM;
        return false;
    }
    for (sheet->row = 0; sheet->row < sheet->page.rows && !interrupted(); sheet->row++) {
        crew_run(sheet->crew, crew_most(sheet->crew), draw, sheet);
        progress_add(progress, 1);
    }
    errno = ENOMEM;
    return !atomic_load(&sheet->has_failed) && !interrupted();
}

/* Draws the sheet and writes it to a file that appears when it is whole. */
static int write_sheet(struct sheet *sheet)
{
    struct writer *const writer = &sheet->writer;
    errno = 0;
    if (!writer_open(writer)) {
        const bool is_usage = !interrupted() && errno != EPIPE;
        tell_failure(sheet, errno);
        return is_usage ? CLI_USAGE : CLI_FAILURE;
    }
    struct progress progress;
    progress_start(&progress, sheet->page.rows, sheet->options.running.quiet != 0);
    const bool is_drawn = draw_all(sheet, &progress);
    const bool is_written = is_drawn && writer_write_whole(writer, sheet->crew, sheet->page.rgb) &&
                            writer_close(writer) && writer_publish(writer) && writer_settle(writer);
    const int reason = errno;
    progress_end(&progress, is_written);
    return is_written ? CLI_SUCCESS : tell_failure(sheet, reason);
}

static void print_summary(const struct sheet *sheet, double duration)
{
    const char *const path = sheet->writer.path;
    const bool is_file = strcmp(path, "-") != 0 && !file_is_special(path);
    FILE *const stream = is_file ? stdout : stderr;
    char time[AMOUNT_SIZE];
    fprintf(stream, "%zu panel%s of %zux%zu pixels in %s", sheet->count,
            sheet->count == 1 ? "" : "s", sheet->page.panel_width, sheet->page.panel_height,
            amount_seconds(time, duration));
    running_print(stream, sheet->crew);
}

static int prepare(struct sheet *sheet, char **argv)
{
    const struct sheet_options *const options = &sheet->options;
    if (!axes_parse(options->sheet, &sheet->axes)) {
        return CLI_USAGE;
    }
    page_arrange(&sheet->page, &sheet->axes, options->panel.width, options->panel.height);
    if (!choose_format(sheet)) {
        return CLI_USAGE;
    }
    sheet->crew = running_begin(&options->running);
    return sheet->crew != NULL ? make_cells(sheet, argv) : CLI_FAILURE;
}

static int print_recipe(const struct sheet_options *options)
{
    struct source source = {.name = NULL};
    const int status = source_open(&source, &options->ground, options->step);
    if (status == CLI_SUCCESS) {
        source_print(&source);
    }
    source_close(&source);
    return status;
}

int cli_sheet(char **argv)
{
    static struct sheet sheet = {.options = SHEET_OPTIONS_UNSET}; /* large for a stack */
    switch (options_parse(&sheet_table, argv, &sheet.options)) {
    case OPTIONS_HELP: return CLI_SUCCESS;
    case OPTIONS_BAD: return CLI_USAGE;
    default: break;
    }
    if (sheet.options.ground.print_recipe) {
        return print_recipe(&sheet.options);
    }
    const double start = running_seconds();
    int status = prepare(&sheet, argv);
    if (status == CLI_SUCCESS) {
        status = write_sheet(&sheet);
    }
    if (status == CLI_SUCCESS && !sheet.options.running.quiet) {
        print_summary(&sheet, running_seconds() - start);
    }
    writer_discard(&sheet.writer);
    for (size_t n = 0; n < sheet.count && sheet.panels != NULL; n++) {
        panel_free(&sheet.panels[n]);
    }
    free(sheet.panels);
    page_close(&sheet.page);
    crew_close(sheet.crew);
    return status;
}
