/* SPDX-License-Identifier: MIT
 *
 * The report as text and as Markdown.
 */
#include "report.h"

#include <string.h>

const struct bench_row *bench_find_row(const struct bench_report *report, const char *work,
                                       const char *library, const char *isa)
{
    for (size_t i = 0; i < report->count; i++) {
        const struct bench_row *const row = &report->rows[i];
        if (strcmp(row->work, work) == 0 && strcmp(row->library, library) == 0 &&
            strcmp(row->isa, isa) == 0) {
            return row;
        }
    }
    return NULL;
}

void bench_group_name(const char *work, char *name, size_t size)
{
    const char *const last = strrchr(work, '/');
    if (last != NULL && strstr(last, "-differences") != NULL) {
        snprintf(name, size, "%.*s/+gradient", (int)(last - work), work);
    } else {
        snprintf(name, size, "%s", work);
    }
}

static void write_header(FILE *file, const struct bench_report *report, const char *bullet)
{
    fprintf(file, "%sscarp %s, %s\n", bullet, report->version, report->date);
    fprintf(file, "%sprocessor: %s, with %s\n", bullet, report->cpu, report->isas);
    fprintf(file, "%scompiler: %s, %s\n", bullet, report->compiler, report->flags);
    fprintf(file, "%smethod: one thread, median of %d interleaved repeats, %g s per row\n\n",
            bullet, report->repeat, report->min_time);
}

/* Finds the row whose result a row of differences approximates; NULL if that was not measured. */
static const struct bench_row *find_exact(const struct bench_report *report,
                                          const struct bench_row *row)
{
    char name[sizeof row->work];
    bench_group_name(row->work, name, sizeof name);
    return strcmp(name, row->work) == 0 ? NULL
                                        : bench_find_row(report, name, row->library, row->isa);
}

static int has_differences(const struct bench_report *report)
{
    for (size_t i = 0; i < report->count; i++) {
        if (find_exact(report, &report->rows[i]) != NULL) {
            return 1;
        }
    }
    return 0;
}

/* How wide the column of the workloads is */
static int work_width(const struct bench_report *report)
{
    size_t width = 52;
    for (size_t i = 0; i < report->count; i++) {
        const size_t length = strlen(report->rows[i].work);
        width = length > width ? length : width;
    }
    return (int)width;
}

void bench_write_text(FILE *file, const struct bench_report *report)
{
    const int width = work_width(report);
    write_header(file, report, "");
    fprintf(file, "%-*s %-17s %-7s %9s %10s %9s %8s\n", width, "workload", "library", "isa",
            "ns/point", "Mpoints/s", "fastest", "spread");
    for (size_t i = 0; i < report->count; i++) {
        const struct bench_row *const row = &report->rows[i];
        fprintf(file, "%-*s %-17s %-7s %9.3f %10.1f %9.3f %6.1f %%%s%s%s%s\n", width, row->work,
                row->library, row->isa, row->median, 1000 / row->median, row->minimum,
                row->spread * 100, row->note[0] != '\0' ? "  " : "", row->note,
                row->way[0] != '\0' ? "  " : "", row->way);
    }
    if (!has_differences(report)) {
        return;
    }
    fprintf(file, "\nThe same library in closed form:\n");
    for (size_t i = 0; i < report->count; i++) {
        const struct bench_row *const row = &report->rows[i];
        const struct bench_row *const exact = find_exact(report, row);
        if (exact != NULL) {
            fprintf(file, "%-*s %-17s %-7s %9.2f times faster\n", width, row->work, row->library,
                    row->isa, row->median / exact->median);
        }
    }
}

/* Whether row i is the first with its workload, or with its library and instruction set */
static int is_first_of_work(const struct bench_report *report, size_t i)
{
    size_t j = 0;
    while (strcmp(report->rows[j].work, report->rows[i].work) != 0) {
        j++;
    }
    return j == i;
}

static int is_first_of_series(const struct bench_report *report, size_t i)
{
    size_t j = 0;
    while (strcmp(report->rows[j].library, report->rows[i].library) != 0 ||
           strcmp(report->rows[j].isa, report->rows[i].isa) != 0) {
        j++;
    }
    return j == i;
}

static void write_rate(FILE *file, const struct bench_row *row)
{
    if (row == NULL) {
        fprintf(file, " |");
        return;
    }
    const double rate = 1000 / row->median;
    const int peer = strcmp(row->library, "scarp") != 0;
    fprintf(file, " %.*f%s |", rate < 100 ? 1 : 0, rate, peer && row->note[0] != '\0' ? "\\*" : "");
}

/* Writes a table: a row per workload, a column per library and instruction set, both in order of
   appearance. */
static void write_rates(FILE *file, const struct bench_report *report)
{
    fprintf(file, "| million points per second |");
    size_t columns = 0;
    for (size_t i = 0; i < report->count; i++) {
        if (is_first_of_series(report, i)) {
            fprintf(file, " %s %s |", report->rows[i].library, report->rows[i].isa);
            columns++;
        }
    }
    fprintf(file, "\n|---|");
    for (size_t i = 0; i < columns; i++) {
        fprintf(file, "---:|");
    }
    fprintf(file, "\n");
    for (size_t i = 0; i < report->count; i++) {
        if (!is_first_of_work(report, i)) {
            continue;
        }
        const char *const work = report->rows[i].work;
        fprintf(file, "| %s |", work);
        for (size_t j = 0; j < report->count; j++) {
            if (is_first_of_series(report, j)) {
                write_rate(file, bench_find_row(report, work, report->rows[j].library,
                                                report->rows[j].isa));
            }
        }
        fprintf(file, "\n");
    }
}

void bench_write_markdown(FILE *file, const struct bench_report *report)
{
    write_header(file, report, "- ");
    write_rates(file, report);
    int starred = 0;
    for (size_t i = 0; i < report->count; i++) {
        const struct bench_row *const row = &report->rows[i];
        starred |= row->note[0] != '\0' && strcmp(row->library, "scarp") != 0;
    }
    if (starred) {
        fprintf(file, "\n\\* has no derivatives: central differences of its values\n");
    }
    if (!has_differences(report)) {
        return;
    }
    fprintf(file,
            "\n| value and gradient | isa | times as fast in closed form |\n|---|---|---:|\n");
    for (size_t i = 0; i < report->count; i++) {
        const struct bench_row *const row = &report->rows[i];
        const struct bench_row *const exact = find_exact(report, row);
        if (exact != NULL) {
            fprintf(file, "| %s | %s | %.2f |\n", row->work, row->isa, row->median / exact->median);
        }
    }
}
