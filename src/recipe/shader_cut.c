/* SPDX-License-Identifier: MIT
 *
 * Cuts scarp.glsl, scarp.hlsl or scarp.wgsl to what a recipe uses. The file is a list of pieces: a
 * function, a structure, a macro, or what stands between #if and #endif, each with the comment
 * above it. A piece stays if something that stays has its name.
 */
#include <string.h>

#include "shader.h"

#define PIECES 640
#define NAMES 768

struct piece {
    uint32_t from, to;
    uint8_t stays, is_seen;
};

/* A name, as a part of the file; its hash makes comparisons fast. */
struct name {
    uint32_t hash, from;
    uint16_t length, piece;
};

struct cutter {
    const char *file;
    size_t length;
    int pieces, names, is_full;
    struct piece piece[PIECES];
    struct name name[NAMES];
};

static int is_in_name(char c)
{
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
}

static int begins(const char *text, size_t length, const char *with)
{
    const size_t size = strlen(with);
    return size <= length && memcmp(text, with, size) == 0;
}

static size_t name_length(const char *text, size_t length)
{
    size_t n = 0;
    while (n < length && is_in_name(text[n])) {
        n++;
    }
    return n;
}

static uint32_t hash_of(const char *name, size_t length)
{
    uint32_t hash = 2166136261u;
    for (size_t i = 0; i < length; i++) {
        hash = (hash ^ (unsigned char)name[i]) * 16777619u;
    }
    return hash;
}

static void add_name(struct cutter *c, const char *name, size_t length, int piece)
{
    c->is_full |= c->names == NAMES;
    if (c->names < NAMES && length > 0) {
        c->name[c->names++] = (struct name){hash_of(name, length), (uint32_t)(name - c->file),
                                            (uint16_t)length, (uint16_t)piece};
    }
}

static int is_name(const struct cutter *c, int i, uint32_t hash, const char *name, size_t length)
{
    return c->name[i].hash == hash && c->name[i].length == length &&
           memcmp(c->file + c->name[i].from, name, length) == 0;
}

/* Where a character is in a text; the length of the text: nowhere. */
static size_t find(const char *text, size_t length, char which)
{
    size_t at = 0;
    while (at < length && text[at] != which) {
        at++;
    }
    return at;
}

/* The end of the line that begins at a place, behind its newline. */
static size_t line_end(const struct cutter *c, size_t at)
{
    const size_t end = at + find(c->file + at, c->length - at, '\n');
    return end < c->length ? end + 1 : c->length;
}

/* The end of a piece that begins with #if. */
static size_t group_end(const struct cutter *c, size_t at)
{
    int depth = 0;
    do {
        depth += begins(c->file + at, c->length - at, "#if");
        depth -= begins(c->file + at, c->length - at, "#endif");
        at = line_end(c, at);
    } while (depth > 0 && at < c->length);
    return at;
}

/* The end of a declaration: a line that ends it, or the brace in front of a line. */
static size_t declaration_end(const struct cutter *c, size_t at)
{
    int has_brace = 0;
    while (at < c->length) {
        const size_t end = line_end(c, at), length = end - at;
        const int closes = begins(c->file + at, length, "}");
        has_brace |= find(c->file + at, length, '{') < length;
        at = end;
        if (closes || (!has_brace && length >= 2 && c->file[end - 2] == ';')) {
            break;
        }
    }
    return at;
}

/* How long a comment is that a text begins with: up to the end of a line, or behind it; 0: there is
   none. */
static size_t comment_length(const char *text, size_t length)
{
    const int is_line = begins(text, length, "//");
    if (!is_line && !begins(text, length, "/*")) {
        return 0;
    }
    size_t at = 2;
    while (at < length && (is_line ? text[at] != '\n' : !begins(text + at, length - at, "*/"))) {
        at++;
    }
    return is_line || at == length ? at : at + 2;
}

/* All macros of a piece of the preprocessor. */
static void add_macros(struct cutter *c, size_t at, size_t end, int piece)
{
    static const char define[] = "#define ";
    for (; at < end; at = line_end(c, at)) {
        if (begins(c->file + at, end - at, define)) {
            const char *const name = c->file + at + sizeof define - 1;
            add_name(c, name, name_length(name, (size_t)(c->file + end - name)), piece);
        }
    }
}

/* The name of a declaration: behind struct and the like, that in front of the first parenthesis, or
   of a block that of its array. */
static void add_declared(struct cutter *c, size_t at, size_t end, int piece)
{
    static const char *const words[] = {"struct ", "fn ", "override ", "const "};
    for (size_t i = 0; i < sizeof words / sizeof words[0]; i++) {
        if (begins(c->file + at, end - at, words[i])) {
            const char *const name = c->file + at + strlen(words[i]);
            add_name(c, name, name_length(name, (size_t)(c->file + end - name)), piece);
            return;
        }
    }
    const int is_block =
        begins(c->file + at, end - at, "SCARP_LAYOUT") || begins(c->file + at, end - at, "cbuffer");
    const size_t stop = at + find(c->file + at, end - at, is_block ? '[' : '(');
    size_t from = stop;
    while (stop < end && from > at && is_in_name(c->file[from - 1])) {
        from--;
    }
    add_name(c, c->file + from, stop < end ? stop - from : 0, piece);
}

static void add_piece(struct cutter *c, size_t from, size_t at, size_t end)
{
    const int is_macro = c->file[at] == '#', names = c->names;
    if (c->pieces == PIECES) {
        c->is_full = 1;
        return;
    }
    if (is_macro) {
        add_macros(c, at, end, c->pieces);
    } else {
        add_declared(c, at, end, c->pieces);
    }
    c->piece[c->pieces++] =
        (struct piece){(uint32_t)from, (uint32_t)end, (uint8_t)(c->names == names), 0};
}

/* Where the pieces are. The guard around the whole file is none. */
static void find_pieces(struct cutter *c)
{
    size_t from = 0;
    for (size_t at = 0; at < c->length;) {
        const size_t length = c->length - at;
        size_t end = line_end(c, at);
        const size_t comment = comment_length(c->file + at, length);
        if (comment > 0) {
            at = line_end(c, at + comment - 1);
            continue; /* it belongs to what comes next, but for an empty line */
        }
        if (c->file[at] != '\n' && !begins(c->file + at, length, "#ifndef SCARP_GLSL\n") &&
            !begins(c->file + at, length, "#ifndef SCARP_HLSL\n") &&
            !begins(c->file + at, length, "#define SCARP_GLSL\n") &&
            !begins(c->file + at, length, "#define SCARP_HLSL\n") &&
            !begins(c->file + at, length, "#endif")) {
            end = begins(c->file + at, length, "#if") ? group_end(c, at)
                  : c->file[at] == '#'                ? end
                                                      : declaration_end(c, at);
            add_piece(c, from, at, end);
        }
        at = from = end;
    }
}

/* What a text names stays. Returns how many pieces are new. */
static int keep_named(struct cutter *c, const char *text, size_t length)
{
    int found = 0;
    for (size_t at = 0; at < length;) {
        const size_t size = name_length(text + at, length - at);
        if (size == 0) {
            const size_t comment = comment_length(text + at, length - at);
            at += comment > 0 ? comment : 1;
            continue;
        }
        const uint32_t hash = size > 5 ? hash_of(text + at, size) : 0;
        for (int i = 0; size > 5 && i < c->names; i++) {
            struct piece *const p = &c->piece[c->name[i].piece];
            if (!p->stays && is_name(c, i, hash, text + at, size)) {
                p->stays = 1;
                found++;
            }
        }
        at += size;
    }
    return found;
}

static void keep_all(struct cutter *c)
{
    int found = 1;
    while (found > 0) {
        found = 0;
        for (int i = 0; i < c->pieces; i++) {
            struct piece *const p = &c->piece[i];
            if (p->stays && !p->is_seen) {
                p->is_seen = 1;
                found += 1 + keep_named(c, c->file + p->from, p->to - p->from);
            }
        }
    }
}

/* The piece of a name, or -1. */
static int piece_of(const struct cutter *c, const char *name)
{
    const size_t length = strlen(name);
    const uint32_t hash = hash_of(name, length);
    for (int i = 0; i < c->names; i++) {
        if (is_name(c, i, hash, name, length)) {
            return c->name[i].piece;
        }
    }
    return -1;
}

/* What the recipe's own text has in the place of that of the file counts as seen, and goes. */
static void set_replaced(struct cutter *c, int language, int is_seen)
{
    static const char *const names[] = {"scarp_zero", "scarp_plan", "scarp_add", "scarp_sub",
                                        "scarp_mul"};
    for (int i = 0; i < (language == SCARP_WGSL ? 5 : 2); i++) {
        const int piece = piece_of(c, names[i]);
        if (piece >= 0) {
            c->piece[piece].is_seen = (uint8_t)is_seen;
            c->piece[piece].stays = 0;
        }
    }
}

/* Whether the file is of the language: of the three, WGSL has no macros, and GLSL one for layouts.
 */
static int is_of_language(const struct cutter *c, int language)
{
    const int has_macros = piece_of(c, "scarp_pick") >= 0;
    const int has_layout = piece_of(c, "SCARP_LAYOUT") >= 0;
    return piece_of(c, "scarp_zero") >= 0 && language == (!has_macros  ? SCARP_WGSL
                                                          : has_layout ? SCARP_GLSL
                                                                       : SCARP_HLSL);
}

static size_t size_of(const struct cutter *c, int from, int to)
{
    size_t size = 0;
    for (int i = from; i < to; i++) {
        size += c->piece[i].stays ? c->piece[i].to - c->piece[i].from + 1 : 0;
    }
    return size;
}

static void put_pieces(const struct cutter *c, int from, int to, struct shader_text *text)
{
    for (int i = from; i < to; i++) {
        if (c->piece[i].stays) {
            scarpi_shader_put_span(text, c->file + c->piece[i].from,
                                   c->piece[i].to - c->piece[i].from);
            scarpi_shader_put_span(text, "\n", 1);
        }
    }
}

int scarpi_shader_cut(const struct shader_cut *cut, struct shader_text *text)
{
    struct cutter c = {.file = cut->file, .length = cut->length};
    const size_t own = text->length;
    if (cut->length > UINT32_MAX / 2) {
        return 0;
    }
    find_pieces(&c);
    const int zero = piece_of(&c, "scarp_zero");
    if (!is_of_language(&c, text->language) || c.is_full) {
        return 0;
    }
    set_replaced(&c, text->language, 1);
    (void)keep_named(&c, text->text, own < text->capacity ? own : text->capacity);
    keep_all(&c);
    set_replaced(&c, text->language, 0);
    const size_t all = own + size_of(&c, 0, c.pieces);
    if (all > text->capacity || own > text->capacity) {
        text->length = own > text->capacity ? own + cut->length + PIECES : all;
        return 1;
    }
    char *const end = text->text + all - own;
    memmove(end, text->text, own);
    text->length = 0;
    put_pieces(&c, 0, zero, text);
    memmove(text->text + text->length, end, cut->head);
    text->length += cut->head;
    put_pieces(&c, zero + 1, c.pieces, text);
    text->length = all;
    return 1;
}
