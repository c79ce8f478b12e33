/* SPDX-License-Identifier: MIT
 *
 * Names and numbers of columns. Names are compared without their quotes and the blanks around them,
 * and capital letters of ASCII are like small ones; so a name may fit two columns, which is
 * refused.
 */
#include "sample/columns.h"

#include <stdio.h>

#include "shared/error.h"

#define LIST_SIZE 700 /* bytes of names in a message: it has room for 1024 in all */

/* Reads a number of decimal digits only. False if it is none. */
static bool read_number(const struct field *name, size_t *number)
{
    *number = 0;
    for (const char *c = name->begin; c < name->end; c++) {
        if (*c < '0' || *c > '9') {
            return false;
        }
        const size_t next = 10 * *number + (size_t)(*c - '0');
        *number = next <= COLUMNS_NUMBER_MAX ? next : COLUMNS_NUMBER_MAX + 1;
    }
    return name->end > name->begin;
}

/* Splits the list as a line of CSV: names may be in quotes. */
static bool read_names(struct columns *columns, const char *text)
{
    for (const char *at = text; at != NULL; columns->count++) {
        if (columns->count == COLUMNS_AXES) {
            return false;
        }
        struct field *const name = &columns->name[columns->count];
        *name = field_csv(at);
        if (name->problem != NULL || name->begin == name->end) {
            return false;
        }
        for (size_t i = 0; i < columns->count; i++) {
            if (field_same(name, &columns->name[i])) {
                return false;
            }
        }
        at = name->next;
    }
    return columns->count >= 2;
}

enum option_result option_columns(const struct option *option, const char *text, void *field)
{
    (void)option;
    struct columns columns = {.numbered = true};
    if (!read_names(&columns, text)) {
        return OPTION_INVALID;
    }
    size_t number[COLUMNS_AXES] = {0};
    for (size_t i = 0; i < columns.count; i++) {
        columns.numbered = read_number(&columns.name[i], &number[i]) && columns.numbered;
    }
    for (size_t i = 0; i < columns.count && columns.numbered; i++) {
        if (number[i] < 1 || number[i] > COLUMNS_NUMBER_MAX ||
            (i > 0 && number[i] == number[i - 1]) || (i > 1 && number[i] == number[0])) {
            return OPTION_INVALID;
        }
        columns.index[i] = number[i] - 1;
    }
    *(struct columns *)field = columns;
    return OPTION_VALID;
}

static size_t count_names(const struct columns_header *header, const char *row)
{
    size_t count = 0;
    for (const char *at = row; at != NULL; at = header->field(at).next) {
        count++;
    }
    return count;
}

/* Writes the names of a row for a message, as many as there is room for. */
static const char *list_names(const struct columns_header *header, char list[LIST_SIZE])
{
    char *to = list;
    *to = '\0';
    for (const char *at = header->row; at != NULL;) {
        const struct field name = header->field(at);
        char shown[FIELD_SHOWN];
        field_show(&name, shown);
        if (list + LIST_SIZE - to < (int)sizeof shown + 32) {
            snprintf(to, 32, " and %zu more", count_names(header, at));
            break;
        }
        to += snprintf(to, sizeof shown + 8, "%s'%s'", at == header->row ? "" : ", ", shown);
        at = name.next;
    }
    return list;
}

/* How many columns have the name. *index becomes the first of them. */
static size_t find_name(const struct columns_header *header, const struct field *name,
                        size_t *index)
{
    size_t found = 0, i = 0;
    for (const char *at = header->row; at != NULL; i++) {
        const struct field here = header->field(at);
        if (field_same(&here, name)) {
            *index = found == 0 ? i : *index;
            found++;
        }
        at = here.next;
    }
    return found;
}

/* The name was found that often: more than once is an error. */
static bool check_once(const struct columns_header *header, const struct field *name, size_t found)
{
    char list[LIST_SIZE], shown[FIELD_SHOWN];
    if (found > 1) {
        cli_error("--columns: %s has %zu columns '%s'; choose by number, from 1 on: %s",
                  header->input, found, field_show(name, shown), list_names(header, list));
    }
    return found <= 1;
}

static int find_numbers(const struct columns *columns, const struct columns_header *header,
                        size_t index[COLUMNS_AXES])
{
    char list[LIST_SIZE];
    const size_t total = count_names(header, header->row);
    for (size_t i = 0; i < columns->count; i++) {
        index[i] = columns->index[i];
        if (index[i] >= total) {
            cli_error("--columns: %s has no column %zu; choose from 1 to %zu: %s", header->input,
                      index[i] + 1, total, list_names(header, list));
            return 0;
        }
    }
    return (int)columns->count;
}

static int find_names(const struct columns *columns, const struct columns_header *header,
                      size_t index[COLUMNS_AXES])
{
    char list[LIST_SIZE], shown[FIELD_SHOWN];
    for (size_t i = 0; i < columns->count; i++) {
        const struct field *const name = &columns->name[i];
        const size_t found = find_name(header, name, &index[i]);
        if (found == 0) {
            cli_error("--columns: %s has no column '%s'; choose from %s", header->input,
                      field_show(name, shown), list_names(header, list));
        }
        if (found == 0 || !check_once(header, name, found)) {
            return 0;
        }
    }
    return (int)columns->count;
}

static const char letters[] = "xyz";
static const struct field axes[COLUMNS_AXES] = {{.begin = letters, .end = letters + 1},
                                                {.begin = letters + 1, .end = letters + 2},
                                                {.begin = letters + 2, .end = letters + 3}};

bool columns_are_named(const struct columns *columns, const struct columns_header *header)
{
    const bool are_chosen = columns->count > 0 && !columns->numbered;
    const struct field *const name = are_chosen ? columns->name : axes;
    const size_t count = are_chosen ? columns->count : 2;
    size_t index, i = 0;
    while (i < count && find_name(header, &name[i], &index) > 0) {
        i++;
    }
    return i == count;
}

static int find_axes(const struct columns_header *header, int dims, size_t index[COLUMNS_AXES])
{
    char list[LIST_SIZE];
    size_t found[COLUMNS_AXES] = {0};
    for (int d = 0; d < (dims == 2 ? 2 : 3); d++) {
        found[d] = find_name(header, &axes[d], &index[d]);
        if (!check_once(header, &axes[d], found[d])) {
            return 0;
        }
    }
    if (found[0] == 0 || found[1] == 0) {
        cli_error("--columns: %s has no column%s; choose from %s", header->input,
                  found[1] > 0   ? " x"
                  : found[0] > 0 ? " y"
                                 : "s x and y",
                  list_names(header, list));
        return 0;
    }
    if (dims == 3 && found[2] == 0) {
        cli_error("--dims: %s has no column z; --columns chooses from %s", header->input,
                  list_names(header, list));
        return 0;
    }
    return found[2] > 0 ? 3 : 2;
}

int columns_in_header(const struct columns *columns, const struct columns_header *header, int dims,
                      size_t index[COLUMNS_AXES])
{
    size_t column = 1;
    for (const char *at = header->row; at != NULL; column++) {
        const struct field name = header->field(at);
        if (name.problem != NULL) {
            cli_error("--input: %s: the header row's column %zu %s", header->input, column,
                      name.problem);
            return 0;
        }
        at = name.next;
    }
    return columns->count == 0 ? find_axes(header, dims, index)
           : columns->numbered ? find_numbers(columns, header, index)
                               : find_names(columns, header, index);
}

void columns_by_number(const struct columns *columns, size_t index[COLUMNS_AXES])
{
    for (size_t i = 0; i < COLUMNS_AXES; i++) {
        index[i] = columns->numbered && i < columns->count ? columns->index[i] : i;
    }
}

size_t columns_needed(const size_t index[COLUMNS_AXES], int dims)
{
    size_t needed = 0;
    for (int d = 0; d < dims; d++) {
        needed = needed > index[d] ? needed : index[d] + 1;
    }
    return needed;
}

bool columns_nameless(const struct columns *columns, const char *input, size_t total)
{
    char shown[FIELD_SHOWN];
    if (columns->count == 0 || columns->numbered) {
        return true;
    }
    size_t i = 0, number;
    while (read_number(&columns->name[i], &number)) { /* one of them is none */
        i++;
    }
    cli_error("--columns: %s has no column names, and so no '%s'; choose from 1 to %zu", input,
              field_show(&columns->name[i], shown), total);
    return false;
}
