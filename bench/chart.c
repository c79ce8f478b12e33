/* SPDX-License-Identifier: MIT
 *
 * The report as a chart: SVG, 900 wide. Each workload has a panel with an axis of its own; a panel
 * has a bar for each library and instruction set, and for gradients from differences too.
 */
#include "report.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#define WIDTH 900
#define MARGIN 24
#define GAP 28 /* between two columns of panels */
#define HEADER 106
#define PANEL_TITLE 22
#define BAR 16 /* from bar to bar */
#define AXIS 34
#define LABELS 148 /* of a panel's width, left of its bars */
#define VALUES 48  /* right of them */

struct panel {
    char work[BENCH_NAME_SIZE];
    size_t bars;
    double most; /* million points per second */
};

struct rect {
    double x, y, width, height;
};

static void write_escaped(FILE *file, const char *text)
{
    for (const char *c = text; *c != '\0'; c++) {
        switch (*c) {
        case '&': fputs("&amp;", file); break;
        case '<': fputs("&lt;", file); break;
        case '>': fputs("&gt;", file); break;
        default: putc((unsigned char)*c < 0x20 || *c == 0x7f ? ' ' : *c, file);
        }
    }
}

static void write_text(FILE *file, double x, double y, const char *class, const char *text)
{
    fprintf(file, "<text x=\"%.1f\" y=\"%.1f\" class=\"%s\">", x, y, class);
    write_escaped(file, text);
    fprintf(file, "</text>\n");
}

static void write_rect(FILE *file, const struct rect *rect, const char *color, const char *opacity)
{
    fprintf(file,
            "<rect x=\"%.1f\" y=\"%.1f\" width=\"%.1f\" height=\"%.1f\" fill=\"%s\" "
            "fill-opacity=\"%s\"/>\n",
            rect->x, rect->y, rect->width, rect->height, color, opacity);
}

/* A colour per library, scarp's first; the libraries beyond the list share its last. */
static const char *color_of(const char *library)
{
    static const struct {
        const char *library, *color;
    } colors[] = {
        {"scarp", "#0b6e4f"},         {"FastNoise2", "#c8553d"}, {"FastNoise2-strict", "#e39a6f"},
        {"FastNoiseLite", "#5b6c9e"}, {"stb_perlin", "#8d7bb0"}, {"libnoise", "#9a8f5c"}};
    for (size_t i = 0; i < sizeof colors / sizeof colors[0]; i++) {
        if (strcmp(library, colors[i].library) == 0) {
            return colors[i].color;
        }
    }
    return "#888888";
}

static int belongs(const struct bench_row *row, const struct panel *panel)
{
    char name[sizeof row->work];
    bench_group_name(row->work, name, sizeof name);
    return strcmp(name, panel->work) == 0;
}

/* Puts the panels, in order of appearance, into panels[report->count]. Returns their number. */
static size_t collect_panels(const struct bench_report *report, struct panel *panels)
{
    size_t count = 0;
    for (size_t i = 0; i < report->count; i++) {
        size_t p = 0;
        while (p < count && !belongs(&report->rows[i], &panels[p])) {
            p++;
        }
        if (p == count) {
            panels[count] = (struct panel){.bars = 0};
            bench_group_name(report->rows[i].work, panels[count].work, sizeof panels[count].work);
            count++;
        }
        panels[p].bars++;
        panels[p].most = fmax(panels[p].most, 1000 / report->rows[i].median);
    }
    return count;
}

static double panel_height(const struct panel *panel)
{
    return PANEL_TITLE + (double)panel->bars * BAR + AXIS;
}

/* Chooses 1, 2 or 5 times a power of ten, so that 3 to 6 ticks fit up to `most`. */
static double tick_distance(double most)
{
    const double power = pow(10, floor(log10(most / 3)));
    const double ratio = most / 3 / power;
    return power * (ratio < 2 ? 1 : ratio < 5 ? 2 : 5);
}

static void write_axis(FILE *file, double x, double top, double bottom, double scale, double most)
{
    const double distance = tick_distance(most);
    for (int i = 0; i * distance <= most * 1.0001; i++) {
        const double at = x + i * distance * scale;
        char number[32];
        snprintf(number, sizeof number, "%g", i * distance);
        fprintf(file, "<line x1=\"%.1f\" y1=\"%.1f\" x2=\"%.1f\" y2=\"%.1f\" stroke=\"%s\"/>\n", at,
                top, at, bottom, i == 0 ? "#555" : "#ddd");
        write_text(file, at, bottom + 12, "tick", number);
    }
}

static void write_bar(FILE *file, const struct bench_row *row, double x, double y, double scale)
{
    const double rate = 1000 / row->median;
    const int differences = row->note[0] != '\0';
    char label[80], value[48];
    snprintf(label, sizeof label, "%s %s%s", row->library, row->isa,
             differences ? " \xe2\x80\xa0" : "");
    if (differences && strcmp(row->library, "scarp") == 0) {
        const int central = strncmp(row->note, "central", 7) == 0;
        snprintf(label, sizeof label, "%s, %s \xe2\x80\xa0", row->isa,
                 central ? "central diff." : "forward diff.");
    }
    snprintf(value, sizeof value, "%.*f", rate < 100 ? 1 : 0, rate);
    write_text(file, x - 6, y + 11, "label", label);
    const struct rect bar = {x, y + 1.5, rate * scale, BAR - 3};
    if (differences) {
        write_rect(file, &bar, "#fff", "1");
    }
    write_rect(file, &bar, color_of(row->library), differences ? "0.45" : "1");
    write_text(file, x + rate * scale + 4, y + 11, "value", value);
}

static void write_panel(FILE *file, const struct bench_report *report, const struct panel *panel,
                        double x, double y, double width)
{
    const double scale = (width - LABELS - VALUES) / panel->most;
    const double top = y + PANEL_TITLE, bottom = top + (double)panel->bars * BAR;
    write_text(file, x, y + 14, "panel", panel->work);
    write_axis(file, x + LABELS, top, bottom, scale, panel->most);
    double bar = top;
    for (size_t i = 0; i < report->count; i++) {
        if (belongs(&report->rows[i], panel)) {
            write_bar(file, &report->rows[i], x + LABELS, bar, scale);
            bar += BAR;
        }
    }
}

/* Writes rows of one or two panels, from `y` down. Returns where they end; with `file` NULL it only
   computes that. */
static double write_panels(FILE *file, const struct bench_report *report,
                           const struct panel *panels, size_t count, double y)
{
    const double width = count == 1 ? WIDTH - 2 * MARGIN : (WIDTH - 2 * MARGIN - GAP) / 2.0;
    for (size_t i = 0; i < count; i += 2) {
        double height = 0;
        for (size_t j = i; j < count && j < i + 2; j++) {
            const double x = MARGIN + (double)(j - i) * (width + GAP);
            if (file != NULL) {
                write_panel(file, report, &panels[j], x, y, width);
            }
            height = fmax(height, panel_height(&panels[j]));
        }
        y += height;
    }
    return y;
}

static void write_legend(FILE *file, const struct bench_report *report, double y)
{
    double x = MARGIN;
    int differences = 0;
    for (size_t i = 0; i < report->count; i++) {
        const char *const library = report->rows[i].library;
        size_t first = 0;
        while (strcmp(report->rows[first].library, library) != 0) {
            first++;
        }
        differences |= report->rows[i].note[0] != '\0';
        if (first == i) {
            write_rect(file, &(struct rect){x, y - 10, 12, 12}, color_of(library), "1");
            write_text(file, x + 17, y, "legend", library);
            x += 17 + 6.8 * (double)strlen(library) + 18;
        }
    }
    if (differences) {
        write_text(file, x, y, "legend", "\xe2\x80\xa0 gradient from differences of values");
    }
}

static void write_heading(FILE *file, const struct bench_report *report)
{
    int peers = 0;
    for (size_t i = 0; i < report->count; i++) {
        peers |= strcmp(report->rows[i].library, "scarp") != 0;
    }
    char line[512];
    snprintf(line, sizeof line, "scarp %s%s: million points per second, one thread",
             report->version, peers ? " and others" : "");
    write_text(file, MARGIN, 34, "title", line);
    snprintf(line, sizeof line, "%s, %.10s. Longer is better; every panel has its own axis.",
             report->cpu, report->date);
    write_text(file, MARGIN, 54, "legend", line);
    snprintf(line, sizeof line, "%.90s, %.50s", report->compiler, report->flags);
    write_text(file, MARGIN, 71, "legend", line);
    write_legend(file, report, 93);
}

int bench_write_chart(FILE *file, const struct bench_report *report)
{
    struct panel *const panels = malloc((report->count + 1) * sizeof *panels);
    if (panels == NULL) {
        return 0;
    }
    const size_t count = collect_panels(report, panels);
    const double height = write_panels(NULL, report, panels, count, HEADER) + MARGIN / 2.0;
    fprintf(file,
            "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"%d\" height=\"%.0f\" "
            "viewBox=\"0 0 %d %.0f\">\n",
            WIDTH, height, WIDTH, height);
    fputs(
        "<style>\n"
        "text { font-family: 'DejaVu Sans', Verdana, Helvetica, Arial, sans-serif; fill: #222; }\n"
        ".title { font-size: 18px; font-weight: bold; }\n"
        ".legend { font-size: 12px; }\n"
        ".panel { font-size: 13px; font-weight: bold; }\n"
        ".label { font-size: 10.5px; text-anchor: end; }\n"
        ".value { font-size: 10.5px; }\n"
        ".tick { font-size: 9.5px; text-anchor: middle; fill: #666; }\n"
        "</style>\n"
        "<rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n",
        file);
    write_heading(file, report);
    write_panels(file, report, panels, count, HEADER);
    fputs("</svg>\n", file);
    free(panels);
    return 1;
}
