/* SPDX-License-Identifier: MIT
 *
 * The report as JSON, written and read back. The reader takes what the writer writes, in any order
 * and spacing: one object of strings and numbers, and "rows", an array of such objects.
 */
#include "report.h"

#include <stdlib.h>
#include <string.h>

static void write_string(FILE *file, const char *key, const char *text, const char *after)
{
    fprintf(file, "\"%s\":\"", key);
    for (const char *c = text; *c != '\0'; c++) {
        if (*c == '"' || *c == '\\') {
            fprintf(file, "\\%c", *c);
        } else {
            putc((unsigned char)*c < 0x20 ? ' ' : *c, file);
        }
    }
    fprintf(file, "\"%s", after);
}

static void write_row(FILE *file, const struct bench_row *row)
{
    fprintf(file, "{");
    write_string(file, "work", row->work, ",");
    write_string(file, "isa", row->isa, ",");
    write_string(file, "library", row->library, ",");
    fprintf(file, "\"points\":%zu,\"ns_per_point\":%.6g,\"mpoints_per_s\":%.6g,", row->points,
            row->median, 1000 / row->median);
    fprintf(file, "\"fastest_ns_per_point\":%.6g,\"spread\":%.4g", row->minimum, row->spread);
    if (row->note[0] != '\0') {
        fprintf(file, ",");
        write_string(file, "note", row->note, "");
    }
    if (row->way[0] != '\0') {
        fprintf(file, ",");
        write_string(file, "way", row->way, "");
    }
    fprintf(file, "}");
}

void bench_write_json(FILE *file, const struct bench_report *report)
{
    fprintf(file, "{");
    write_string(file, "version", report->version, ",\n");
    write_string(file, "date", report->date, ",\n");
    write_string(file, "cpu", report->cpu, ",\n");
    write_string(file, "isas", report->isas, ",\n");
    write_string(file, "compiler", report->compiler, ",\n");
    write_string(file, "flags", report->flags, ",\n");
    fprintf(file, "\"min_time\":%g,\n\"repeat\":%d,\n\"rows\":[", report->min_time, report->repeat);
    for (size_t i = 0; i < report->count; i++) {
        fprintf(file, i == 0 ? "\n" : ",\n");
        write_row(file, &report->rows[i]);
    }
    fprintf(file, "\n]}\n");
}

struct reader {
    FILE *file;
    int next; /* the next character, or EOF at the end */
};

static void advance(struct reader *in)
{
    in->next = getc(in->file);
}

static void skip_space(struct reader *in)
{
    while (in->next == ' ' || in->next == '\t' || in->next == '\r' || in->next == '\n') {
        advance(in);
    }
}

/* Skips one punctuation mark and the space around it; 0 if there is another character. */
static int take(struct reader *in, int mark)
{
    skip_space(in);
    if (in->next != mark) {
        return 0;
    }
    advance(in);
    skip_space(in);
    return 1;
}

/* Reads a string into text[size], and cuts it if it is longer. */
static int read_string(struct reader *in, char *text, size_t size)
{
    size_t length = 0;
    skip_space(in);
    if (in->next != '"') {
        return 0;
    }
    for (advance(in); in->next != '"'; advance(in)) {
        if (in->next == '\\') {
            advance(in);
        }
        if (in->next == EOF) {
            return 0;
        }
        if (length + 1 < size) {
            text[length++] = (char)in->next;
        }
    }
    text[length] = '\0';
    advance(in);
    return 1;
}

static int read_number(struct reader *in, double *value)
{
    char text[64], *end;
    size_t length = 0;
    while (in->next != EOF && strchr("+-.0123456789eE", in->next) != NULL &&
           length + 1 < sizeof text) {
        text[length++] = (char)in->next;
        advance(in);
    }
    text[length] = '\0';
    *value = strtod(text, &end);
    return length > 0 && *end == '\0';
}

/* Where the value of a key goes: a string's array and its size, or a number */
struct field {
    const char *key;
    char *text;
    size_t size;
    double *number;
};

static int read_value(struct reader *in, const struct field *fields, const char *key)
{
    char unknown_text[8];
    double unknown_number;
    struct field field = {key, unknown_text, sizeof unknown_text, &unknown_number};
    for (; fields->key != NULL; fields++) {
        if (strcmp(fields->key, key) == 0) {
            field = *fields;
        }
    }
    if (in->next == '"') {
        return field.text != NULL && read_string(in, field.text, field.size);
    }
    return field.number != NULL && read_number(in, field.number);
}

static int read_row(struct reader *in, struct bench_row *row)
{
    double points = 0;
    const struct field fields[] = {{"work", row->work, sizeof row->work, NULL},
                                   {"isa", row->isa, sizeof row->isa, NULL},
                                   {"library", row->library, sizeof row->library, NULL},
                                   {"note", row->note, sizeof row->note, NULL},
                                   {"way", row->way, sizeof row->way, NULL},
                                   {"points", NULL, 0, &points},
                                   {"ns_per_point", NULL, 0, &row->median},
                                   {"fastest_ns_per_point", NULL, 0, &row->minimum},
                                   {"spread", NULL, 0, &row->spread},
                                   {NULL, NULL, 0, NULL}};
    *row = (struct bench_row){.points = 0};
    if (!take(in, '{')) {
        return 0;
    }
    do {
        char key[32];
        if (!read_string(in, key, sizeof key) || !take(in, ':') || !read_value(in, fields, key)) {
            return 0;
        }
    } while (take(in, ','));
    row->points = points >= 1 && points < 1e12 ? (size_t)points : 0;
    return take(in, '}') && row->points > 0 && row->median > 0 && row->work[0] != '\0';
}

/* Adds a row, unless there is one for its workload, library and instruction set. */
static int add_row(struct bench_report *report, const struct bench_row *row)
{
    if (bench_find_row(report, row->work, row->library, row->isa) != NULL) {
        return 1;
    }
    struct bench_row *const rows = realloc(report->rows, (report->count + 1) * sizeof *rows);
    if (rows == NULL) {
        return 0;
    }
    rows[report->count++] = *row;
    report->rows = rows;
    return 1;
}

static int read_rows(struct reader *in, struct bench_report *report)
{
    if (!take(in, '[')) {
        return 0;
    }
    if (take(in, ']')) {
        return 1;
    }
    do {
        struct bench_row row;
        if (!read_row(in, &row) || !add_row(report, &row)) {
            return 0;
        }
    } while (take(in, ','));
    return take(in, ']');
}

static int read_report(struct reader *in, struct bench_report *header, struct bench_report *report)
{
    double repeat = 0;
    const struct field fields[] = {{"version", header->version, sizeof header->version, NULL},
                                   {"date", header->date, sizeof header->date, NULL},
                                   {"cpu", header->cpu, sizeof header->cpu, NULL},
                                   {"isas", header->isas, sizeof header->isas, NULL},
                                   {"compiler", header->compiler, sizeof header->compiler, NULL},
                                   {"flags", header->flags, sizeof header->flags, NULL},
                                   {"min_time", NULL, 0, &header->min_time},
                                   {"repeat", NULL, 0, &repeat},
                                   {NULL, NULL, 0, NULL}};
    if (!take(in, '{')) {
        return 0;
    }
    do {
        char key[32];
        if (!read_string(in, key, sizeof key) || !take(in, ':') ||
            !(strcmp(key, "rows") == 0 ? read_rows(in, report) : read_value(in, fields, key))) {
            return 0;
        }
    } while (take(in, ','));
    header->repeat = repeat >= 1 && repeat <= 1e6 ? (int)repeat : 1;
    return take(in, '}') && in->next == EOF;
}

const char *bench_read_json(FILE *file, struct bench_report *report)
{
    struct bench_report header = {.repeat = 0};
    struct reader in = {file, ' '};
    if (!read_report(&in, &header, report)) {
        return ferror(file) ? "cannot be read" : "is not a report of this program";
    }
    if (report->version[0] == '\0') {
        header.rows = report->rows;
        header.count = report->count;
        *report = header;
    }
    return report->count > 0 ? NULL : "has no rows";
}
