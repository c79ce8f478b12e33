/* SPDX-License-Identifier: MIT
 *
 * Text of shading languages; and the functions for the octaves of each kind of noise.
 */
#include <stdarg.h>
#include <string.h>

#include "../plan/call.h"
#include "graph.h"
#include "shader.h"

/* The words of GLSL, HLSL and WGSL for a vector of three, and of four. */
static const char *word_of(int language, char which)
{
    static const char *const words[3][2] = {
        {"vec3", "vec4"}, {"float3", "float4"}, {"vec3f", "vec4f"}};
    return words[language][which == '4'];
}

/* How many characters of a text come before this one, or its end. */
static size_t length_until(const char *text, char end)
{
    size_t length = 0;
    while (text[length] != '\0' && text[length] != end) {
        length++;
    }
    return length;
}

void scarpi_shader_put_span(struct shader_text *to, const char *from, size_t length)
{
    if (to->length < to->capacity) {
        const size_t room = to->capacity - to->length;
        memcpy(to->text + to->length, from, length < room ? length : room);
    }
    to->length += length;
}

static void put_int(struct shader_text *to, int number)
{
    char digits[12];
    size_t at = sizeof digits;
    unsigned left = (unsigned)number; /* none is below 0 */
    do {
        digits[--at] = (char)('0' + left % 10u);
        left /= 10u;
    } while (left > 0);
    scarpi_shader_put_span(to, digits + at, sizeof digits - at);
}

/* What declares a variable whose type stands next in the format. Returns how many characters of it
   are done with. */
static size_t put_declaration(struct shader_text *to, const char *format, char which)
{
    const size_t type = length_until(format, ' ');
    if (to->language == SCARP_WGSL) {
        put_text(to, which == 'L' ? "let" : "var");
        return type;
    }
    return 0;
}

void scarpi_shader_put(struct shader_text *to, const char *format, ...)
{
    va_list list;
    va_start(list, format);
    while (*format != '\0') {
        const size_t plain = length_until(format, '%');
        scarpi_shader_put_span(to, format, plain);
        format += plain;
        if (*format == '\0') {
            break;
        }
        const char which = format[1];
        format += 2;
        switch (which) {
        case 'd': put_int(to, va_arg(list, int)); break;
        case 's': put_text(to, va_arg(list, const char *)); break;
        case 'L':
        case 'X': format += put_declaration(to, format, which); break;
        default: put_text(to, word_of(to->language, which)); break;
        }
    }
    va_end(list);
}

/*
 * Octaves of noise
 */

enum { BASIS = 0, FRACTAL = 4, FADE = 8, ROTATE = 10, SPACE = 11 };

static int part_of(uint32_t kind, int shift, uint32_t mask)
{
    return (int)(kind >> shift & mask);
}

int scarpi_shader_kind(struct shader_writer *w, const struct scarp_noise *noise, int dimensions)
{
    const uint32_t kind = (uint32_t)noise->basis << BASIS | (uint32_t)noise->fractal << FRACTAL |
                          (uint32_t)(blends_corners(noise->basis) ? noise->fade : 0) << FADE |
                          (uint32_t)(noise->rotate != 0) << ROTATE |
                          (uint32_t)(dimensions == 3) << SPACE;
    int i = 0;
    while (i < w->kinds && w->kind[i] != kind) {
        i++;
    }
    if (i == w->kinds) {
        w->kind[w->kinds++] = kind;
    }
    return i;
}

/* The line that adds octave `n` of the basis. */
static void put_fractal(struct shader_text *to, enum scarp_fractal fractal, const char *turned,
                        int dimensions)
{
#define CALL(enumerator, name, sharpness, most_erosion, range, traits, call)                       \
    [SCARP_##enumerator] = call,
    static const char *const calls[SCARP_FRACTALS] = {SCARP_FRACTAL_LIST(CALL)};
#undef CALL
    const int takes_turned = fractal_has(fractal, FRACTAL_OWN_SLOPES);
    if (!takes_turned) {
        scarpi_shader_put(to, "        n = scarp_in_input(o, %s, n, %d);\n", turned, dimensions);
    }
    scarpi_shader_put(to, "        s = scarp_%s", calls[fractal]);
    if (takes_turned) {
        scarpi_shader_put(to, ", %s", turned);
    }
    if (fractal_has(fractal, FRACTAL_SLOPES)) {
        scarpi_shader_put(to, ", %d", dimensions);
    }
    put_text(to, ");\n");
}

static void put_basis(struct shader_text *to, uint32_t kind, const char *turned, int dimensions)
{
    static const char *const call[] = {
        "gradient_at(scarp_lattice_of(o, l), ", "value_at(scarp_lattice_of(o, l), ",
        "simplex_at(scarp_lattice_of(o, l)", "cells_at(scarp_lattice_of(o, l), "};
    const enum scarp_basis basis = (enum scarp_basis)part_of(kind, BASIS, 15);
    const enum scarp_fractal fractal = (enum scarp_fractal)part_of(kind, FRACTAL, 15);
    scarpi_shader_put(to, "        %LScarpLocation p = scarp_location_of(o, %du, %s, %s, %d);\n",
                      (int)basis, turned, fractal_bends(fractal) ? "scarp_bent(s, o, k, x)" : "x",
                      dimensions);
    scarpi_shader_put(to, "        %XScarpSample n = scarp_%s",
                      call[basis_has(basis, BASIS_CELLS) ? SCARP_CELL_F1 : basis]);
    if (basis != SCARP_SIMPLEX) {
        scarpi_shader_put(to, "%du", blends_corners(basis) ? part_of(kind, FADE, 3) : (int)basis);
    }
    scarpi_shader_put(to, ", p, %d);\n", dimensions);
    put_fractal(to, fractal, turned, dimensions);
}

static void put_kind(struct shader_text *to, int number, uint32_t kind)
{
    const int is_wgsl = to->language == SCARP_WGSL;
    const int shares_lattice = components_share_lattice((enum scarp_basis)part_of(kind, BASIS, 15));
    const char *const turned = part_of(kind, ROTATE, 1) ? "k > 0u" : "false";
    scarpi_shader_put(to,
                      is_wgsl ? "fn scarp_own_kind%d(index: u32, component: u32, x: vec3f) -> "
                                "ScarpSample {\n"
                              : "ScarpSample scarp_own_kind%d(uint index, uint component, %V "
                                "x)\n{\n",
                      number);
    scarpi_shader_put(to, "    %XScarpLevel l = scarp_own_level(index);\n"
                          "    %XScarpState s = scarp_no_octaves();\n");
    put_text(to, shares_lattice ? "    l.component = component;\n"
                                : "    l.first = l.first + component * l.octaves;\n");
    put_text(to, is_wgsl ? "    for (var k = 0u; k < l.octaves; k++) {\n"
                         : "    for (uint k = 0u; k < l.octaves; k++) {\n");
    scarpi_shader_put(to, "        %LScarpOctave o = scarp_own_octave(l.first + k);\n");
    put_basis(to, kind, turned, part_of(kind, SPACE, 1) ? 3 : 2);
    put_text(to, "    }\n    return s.sum;\n}\n\n");
}

/* All components of a warp: a loop, so that compilers see the octaves once. */
static void put_warp(struct shader_text *to, int number, uint32_t kind)
{
    const int is_wgsl = to->language == SCARP_WGSL;
    scarpi_shader_put(to,
                      is_wgsl ? "fn scarp_own_warp%d(index: u32, x: vec3f) -> ScarpDisplaced {\n"
                              : "ScarpDisplaced scarp_own_warp%d(uint index, %V x)\n{\n",
                      number);
    scarpi_shader_put(to, "    %XScarpDisplaced d = scarp_not_displaced();\n");
    scarpi_shader_put(to, "    for (%Xuint c = 0u; c < %du; c++) {\n",
                      part_of(kind, SPACE, 1) ? 3 : 2);
    scarpi_shader_put(to, "        %LScarpSample s = scarp_own_kind%d(index, c, x);\n", number);
    put_text(to, "        if (c == 0u) {\n            d.x = s;\n"
                 "        } else if (c == 1u) {\n            d.y = s;\n"
                 "        } else {\n            d.z = s;\n        }\n    }\n    return d;\n}\n\n");
}

void scarpi_shader_put_kinds(struct shader_writer *w)
{
    const struct recipe *const r = w->recipe;
    uint8_t is_warp[SHADER_KINDS] = {0};
    for (int k = 0; k < r->schedule.steps; k++) {
        const struct recipe_node *const n = &r->node[r->schedule.step[k]];
        struct scarp_noise noise[5];
        if (n->operation != OP_NOISE && n->operation != OP_VECTOR) {
            continue;
        }
        scarpi_recipe_spell_noise(r, n->index, noise);
        int is_component = n->operation == OP_VECTOR;
        for (const struct scarp_noise *of = noise; of != NULL; of = of->warp) {
            const int kind = scarpi_shader_kind(w, of, r->place[n->place].dimensions);
            is_warp[kind] = (uint8_t)(is_warp[kind] | is_component);
            is_component = 1;
        }
    }
    for (int i = 0; i < w->kinds; i++) {
        put_kind(w->to, i, w->kind[i]);
        if (is_warp[i]) {
            put_warp(w->to, i, w->kind[i]);
        }
    }
}
