/* SPDX-License-Identifier: MIT
 *
 * The header of .npy files, as numpy.lib.format documents it: the magic, a version, the length of
 * a text in little-endian order, and the text: a Python dictionary of three keys, padded.
 */
#include "formats/npy.h"

#include <math.h>
#include <stdint.h>
#include <string.h>

bool npy_preamble(const char bytes[NPY_PREAMBLE_SIZE], size_t *text, size_t *length)
{
    const unsigned char *const b = (const unsigned char *)bytes;
    if (memcmp(b, NPY_MAGIC, NPY_MAGIC_SIZE) != 0 || b[6] < 1 || b[6] > 3 || b[7] != 0) {
        return false;
    }
    *text = b[6] == 1 ? 10 : 12;
    *length = (size_t)b[8] | (size_t)b[9] << 8;
    if (b[6] > 1) {
        *length |= (size_t)b[10] << 16 | (size_t)b[11] << 24;
    }
    return true;
}

/* What is left of the text; each reader below goes past what it reads, or returns false. */
struct cursor {
    const char *at, *end;
};

static void skip_space(struct cursor *cursor)
{
    while (cursor->at < cursor->end && (*cursor->at == ' ' || *cursor->at == '\n')) {
        cursor->at++;
    }
}

static bool read_mark(struct cursor *cursor, const char *mark)
{
    const size_t length = strlen(mark);
    skip_space(cursor);
    if ((size_t)(cursor->end - cursor->at) < length || memcmp(cursor->at, mark, length) != 0) {
        return false;
    }
    cursor->at += length;
    return true;
}

/* On one line and without escapes, which no key and no type has */
static bool read_string(struct cursor *cursor, char *string, size_t size)
{
    const char quote = read_mark(cursor, "'") ? '\'' : '"';
    if (quote == '"' && !read_mark(cursor, "\"")) {
        return false;
    }
    size_t length = 0;
    for (; cursor->at < cursor->end && *cursor->at != quote; cursor->at++) {
        if (*cursor->at == '\\' || *cursor->at == '\n') {
            return false;
        }
        if (length + 1 < size) {
            string[length++] = *cursor->at;
        }
    }
    string[length] = '\0';
    return read_mark(cursor, quote == '"' ? "\"" : "'");
}

/* The types of the fields of a record are in a list, which is only passed over. */
static bool read_descr(struct cursor *cursor, struct npy_array *array)
{
    if (!read_mark(cursor, "[")) {
        return read_string(cursor, array->descr, sizeof array->descr);
    }
    strcpy(array->descr, "[...]");
    for (int depth = 1; depth > 0; cursor->at++) {
        if (cursor->at == cursor->end) {
            return false;
        }
        depth += *cursor->at == '[' ? 1 : *cursor->at == ']' ? -1 : 0;
    }
    return true;
}

static bool read_fortran(struct cursor *cursor, struct npy_array *array)
{
    array->fortran = read_mark(cursor, "True");
    return array->fortran || read_mark(cursor, "False");
}

/* Digits, without zeros before them */
static bool read_size(struct cursor *cursor, size_t *size)
{
    skip_space(cursor);
    const char *const begin = cursor->at;
    for (*size = 0; cursor->at < cursor->end && *cursor->at >= '0' && *cursor->at <= '9';
         cursor->at++) {
        const size_t digit = (size_t)(*cursor->at - '0');
        if (*size > (SIZE_MAX - digit) / 10) {
            return false;
        }
        *size = *size * 10 + digit;
    }
    const size_t length = (size_t)(cursor->at - begin);
    if (cursor->at < cursor->end && *cursor->at == 'L') { /* written by Python 2 */
        cursor->at++;
    }
    return length == 1 || (length > 1 && *begin != '0');
}

/* A tuple: of one size only with a comma behind it */
static bool read_shape(struct cursor *cursor, struct npy_array *array)
{
    if (!read_mark(cursor, "(")) {
        return false;
    }
    array->dimensions = 0;
    while (!read_mark(cursor, ")")) {
        if (array->dimensions == NPY_DIMENSIONS_MAX ||
            !read_size(cursor, &array->shape[array->dimensions])) {
            return false;
        }
        array->dimensions++;
        if (!read_mark(cursor, ",")) {
            return array->dimensions > 1 && read_mark(cursor, ")");
        }
    }
    return true;
}

static bool has_control(const char *text, size_t length)
{
    for (size_t i = 0; i < length; i++) {
        if (((unsigned char)text[i] < 0x20 && text[i] != '\n') || text[i] == 0x7f) {
            return true;
        }
    }
    return false;
}

/* A key, its value, and what separates them from the next: *last is then false. Returns like
   npy_parse_header. */
static const char *read_member(struct cursor *cursor, struct npy_array *array, unsigned *found,
                               bool *last)
{
    static const struct {
        const char *key, *twice, *bad;
        bool (*read)(struct cursor *cursor, struct npy_array *array);
    } members[] = {
        {"descr", "has 'descr' twice", "has a 'descr' that cannot be understood", read_descr},
        {"fortran_order", "has 'fortran_order' twice",
         "has a 'fortran_order' that is not True or False", read_fortran},
        {"shape", "has 'shape' twice", "has a 'shape' that cannot be understood", read_shape},
    };
    char key[16];
    unsigned m = 0;
    if (!read_string(cursor, key, sizeof key)) {
        return "has something else than a key, or not all braces and commas";
    }
    while (m < 3 && strcmp(key, members[m].key) != 0) {
        m++;
    }
    if (m == 3) {
        return "has a key that is not 'descr', 'fortran_order' or 'shape'";
    }
    if ((*found & 1u << m) != 0) {
        return members[m].twice;
    }
    *found |= 1u << m;
    if (!read_mark(cursor, ":") || !members[m].read(cursor, array)) {
        return members[m].bad;
    }
    *last = !read_mark(cursor, ",");
    return NULL;
}

const char *npy_parse_header(const char *text, size_t length, struct npy_array *array)
{
    struct cursor cursor = {text, text + length};
    unsigned found = 0;
    bool last = false;
    *array = (struct npy_array){0};
    if (has_control(text, length)) {
        return "has a control character";
    }
    if (!read_mark(&cursor, "{")) {
        return "does not begin with a brace";
    }
    while (!read_mark(&cursor, "}")) {
        const char *const problem = last ? "has a value with neither a comma nor a brace behind it"
                                         : read_member(&cursor, array, &found, &last);
        if (problem != NULL) {
            return problem;
        }
    }
    skip_space(&cursor);
    if (cursor.at < cursor.end) {
        return "goes on after its closing brace";
    }
    return found == 7 ? NULL : "has not all of 'descr', 'fortran_order' and 'shape'";
}

bool npy_write_header(FILE *stream, const char *descr, const size_t *shape, int dimensions)
{
    char text[256];
    int length =
        snprintf(text, sizeof text, "{'descr': '%s', 'fortran_order': False, 'shape': (", descr);
    for (int i = 0; i < dimensions; i++) {
        length += snprintf(text + length, sizeof text - (size_t)length, "%s%zu%s", i > 0 ? " " : "",
                           shape[i], dimensions == 1 || i < dimensions - 1 ? "," : "");
    }
    length += snprintf(text + length, sizeof text - (size_t)length, "), }");
    int size = NPY_HEADER_SIZE - 10;
    while (size < length + 1) {
        size += 64;
    }
    const unsigned char preamble[4] = {1, 0, (unsigned char)(size & 255),
                                       (unsigned char)(size >> 8)};
    return fwrite(NPY_MAGIC, 1, NPY_MAGIC_SIZE, stream) == NPY_MAGIC_SIZE &&
           fwrite(preamble, 1, sizeof preamble, stream) == sizeof preamble &&
           fprintf(stream, "%-*s\n", size - 1, text) == size;
}

static void put(unsigned char *to, uint64_t bits, int size)
{
    for (int i = 0; i < size; i++) {
        to[i] = (unsigned char)(bits >> (8 * i) & 255);
    }
}

static uint64_t get(const unsigned char *from, int size, bool big_endian)
{
    uint64_t bits = 0;
    for (int i = 0; i < size; i++) {
        bits |= (uint64_t)from[i] << (8 * (big_endian ? size - 1 - i : i));
    }
    return bits;
}

void npy_put_float(unsigned char *to, float value)
{
    uint32_t bits;
    memcpy(&bits, &value, sizeof bits);
    put(to, bits, 4);
}

void npy_put_double(unsigned char *to, double value)
{
    uint64_t bits;
    memcpy(&bits, &value, sizeof bits);
    put(to, bits, 8);
}

bool npy_read_type(const char *descr, struct npy_type *type)
{
    if (strlen(descr) != 3 || strchr("<>|", descr[0]) == NULL || strchr("fiu", descr[1]) == NULL) {
        return false;
    }
    *type =
        (struct npy_type){.kind = descr[1], .size = descr[2] - '0', .big_endian = descr[0] == '>'};
    const bool has_order = descr[0] != '|' || type->size == 1; /* one byte needs none */
    return has_order && (type->size == 2 || type->size == 4 || type->size == 8 ||
                         (type->size == 1 && type->kind != 'f'));
}

/* IEEE 754's binary16 */
static double half(uint64_t bits)
{
    const int exponent = (int)(bits >> 10 & 31), fraction = (int)(bits & 1023);
    const double magnitude = exponent == 31  ? (fraction != 0 ? NAN : INFINITY)
                             : exponent == 0 ? ldexp(fraction, -24)
                                             : ldexp(fraction + 1024, exponent - 25);
    return (bits >> 15 & 1) != 0 ? -magnitude : magnitude;
}

static double float_of(uint64_t bits, int size)
{
    const uint32_t bits32 = (uint32_t)bits;
    float single;
    double value;
    memcpy(&single, &bits32, sizeof single);
    memcpy(&value, &bits, sizeof value);
    return size == 2 ? half(bits) : size == 4 ? (double)single : value;
}

double npy_get(const unsigned char *from, struct npy_type type)
{
    const uint64_t bits = get(from, type.size, type.big_endian);
    const uint64_t sign = (uint64_t)1 << (8 * type.size - 1);
    if (type.kind == 'f') {
        return float_of(bits, type.size);
    }
    if (type.kind == 'u' || (bits & sign) == 0) {
        return (double)bits;
    }
    return -(double)(sign - (bits - sign)); /* two's complement */
}
