/* SPDX-License-Identifier: MIT
 *
 * A recipe as functions of a shading language: the buffer with its accessors, a function for the
 * octaves of each kind of noise, and one that gives all outputs at a point.
 */
#include <string.h>

#include "graph.h"
#include "shader.h"

/*
 * The head
 */

static void put_block(const struct shader_writer *w)
{
    static const char *const begin[] = {
        "SCARP_LAYOUT uniform ScarpRecipePlans\n{\n    uvec4 scarp_own_head;\n",
        "cbuffer ScarpRecipePlans : register(SCARP_REGISTER)\n{\n    uint4 scarp_own_head;\n",
        "struct ScarpRecipePlan {\n    head: vec4u,\n"};
    struct shader_text *const to = w->to;
    const struct shader_slots *const l = w->slots;
    put_text(to, begin[to->language]);
    if (to->language == SCARP_WGSL) {
        scarpi_shader_put(to, "    number: array<vec4f, %d>,\n    level: array<ScarpLevel, %d>,\n",
                          l->numbers, l->levels);
        scarpi_shader_put(to, "    octave: array<ScarpOctave, %d>,\n}\n\n", l->octaves);
        return;
    }
    scarpi_shader_put(to, "    %4 scarp_own_numbers[%d];\n", l->numbers);
    scarpi_shader_put(to, "    ScarpLevel scarp_own_levels[%d];\n", l->levels);
    scarpi_shader_put(to, "    ScarpOctave scarp_own_octaves[%d];\n};\n\n", l->octaves);
}

/* The operations of WGSL, as the file has them but for a call in each. They are most of what there
   is to compile: this halves the time. */
static void put_operations(struct shader_text *to)
{
    static const char *const operation[][2] = {{"add", "+"}, {"sub", "-"}, {"mul", "*"}};
    for (int i = 0; i < 3; i++) {
        scarpi_shader_put(to, "fn scarp_%s(a: f32, b: f32) -> f32 {\n", operation[i][0]);
        scarpi_shader_put(
            to, "    return bitcast<f32>(bitcast<u32>(a %s b) ^ scarp_plan.head.x);\n}\n\n",
            operation[i][1]);
    }
}

void scarpi_shader_put_head(const struct shader_writer *w)
{
    struct shader_text *const to = w->to;
    put_block(w);
    if (to->language == SCARP_WGSL) {
        put_operations(to);
        put_text(to, "fn scarp_own_number(i: u32) -> vec4f {\n"
                     "    return scarp_plan.number[i];\n}\n\n"
                     "fn scarp_own_level(i: u32) -> ScarpLevel {\n"
                     "    return scarp_plan.level[i];\n}\n\n"
                     "fn scarp_own_octave(i: u32) -> ScarpOctave {\n"
                     "    return scarp_plan.octave[i];\n}\n\n");
        return;
    }
    scarpi_shader_put(to, "uint scarp_zero()\n{\n    return scarp_own_head.x;\n}\n\n"
                          "%4 scarp_own_number(uint i)\n{\n    return scarp_own_numbers[i];\n}\n\n"
                          "ScarpLevel scarp_own_level(uint i)\n{\n"
                          "    return scarp_own_levels[i];\n}\n\n"
                          "ScarpOctave scarp_own_octave(uint i)\n{\n"
                          "    return scarp_own_octaves[i];\n}\n\n");
}

/*
 * The function of a recipe
 */

#define RECIPE_NAME 64 /* what counts of a name */

/* The name of an output. Shading languages have no names with two underscores in a row. */
static size_t name_of(const struct recipe *r, int output, char name[RECIPE_NAME])
{
    const struct recipe_span span = r->statement[r->output[output]].name;
    size_t length = 0;
    for (int i = span.from; i < span.to && length < RECIPE_NAME; i++) {
        if (r->text[i] != '_' || (i > span.from && r->text[i - 1] != '_')) {
            name[length++] = r->text[i];
        }
    }
    return length;
}

static void put_name(const struct shader_writer *w, int output)
{
    char name[RECIPE_NAME];
    scarpi_shader_put_span(w->to, name, name_of(w->recipe, output, name));
}

/* Whether no output before has the same name in shaders. */
static int has_own_name(const struct recipe *r, int output)
{
    char name[RECIPE_NAME], before[RECIPE_NAME];
    const size_t length = name_of(r, output, name);
    for (int i = 0; i < output; i++) {
        if (name_of(r, i, before) == length && memcmp(name, before, length) == 0) {
            return 0;
        }
    }
    return 1;
}

static void put_outputs(const struct shader_writer *w)
{
    struct shader_text *const to = w->to;
    put_text(to, "/* All outputs. */\nstruct ScarpRecipe {\n");
    for (int i = 0; i < w->recipe->outputs; i++) {
        scarpi_shader_put(to,
                          to->language == SCARP_WGSL ? "    out%d: ScarpSample, // "
                                                     : "    ScarpSample out%d; // ",
                          i);
        put_name(w, i);
        put_text(to, "\n");
    }
    put_text(to, to->language == SCARP_WGSL ? "}\n\n" : "};\n\n");
}

/* The head of a function of the coordinates. */
static void put_function(const struct shader_writer *w, const char *type, int output)
{
    struct shader_text *const to = w->to;
    const int is_space = w->recipe->dimensions == 3, is_wgsl = to->language == SCARP_WGSL;
    scarpi_shader_put(to, "%s scarp_recipe", is_wgsl ? "fn" : type);
    if (output >= 0) {
        put_text(to, "_");
        put_name(w, output);
    }
    put_text(to, is_wgsl ? "(x: f32, y: f32" : "(float x, float y");
    put_text(to, !is_space ? "" : is_wgsl ? ", z: f32" : ", float z");
    scarpi_shader_put(to, is_wgsl ? ") -> %s {\n" : ")\n{\n", type);
}

static const char *coordinates_of(const struct shader_writer *w)
{
    return w->recipe->dimensions == 3 ? "x, y, z" : "x, y";
}

static void put_answer(const struct shader_writer *w, int order)
{
    struct shader_text *const to = w->to;
    const struct recipe *const r = w->recipe;
    put_text(to, "/* The self-test: answer i of scarp_recipe_answers. */\n");
    put_text(to, to->language == SCARP_WGSL ? "fn scarp_answer_recipe(i: u32) -> u32 {\n"
                                            : "uint scarp_answer_recipe(uint i)\n{\n");
    scarpi_shader_put(to, "    %Lfloat unit = %s;\n",
                      to->language == SCARP_WGSL   ? "bitcast<f32>(scarp_plan.head.y)"
                      : to->language == SCARP_HLSL ? "asfloat(scarp_own_head.y)"
                                                   : "uintBitsToFloat(scarp_own_head.y)");
    scarpi_shader_put(to, "    %LScarpRecipe r = scarp_recipe(");
    for (int axis = 0; axis < r->dimensions; axis++) {
        scarpi_shader_put(to, "%sscarp_test_coordinate(unit, i, %du)", axis > 0 ? ", " : "", axis);
    }
    scarpi_shader_put(to, ");\n    %Xuint h = 0u;\n");
    for (int i = 0; i < r->outputs; i++) {
        const int has = r->node[scarpi_recipe_output_node(r, i)].order;
        scarpi_shader_put(to, "    h = scarp_hash_with_sample(h, r.out%d, %du, %d);\n", i,
                          order < has ? order : has, r->dimensions);
    }
    put_text(to, "    return h;\n}\n");
}

void scarpi_shader_put_functions(struct shader_writer *w, int order)
{
    struct shader_text *const to = w->to;
    scarpi_shader_put_kinds(w);
    put_outputs(w);
    put_function(w, "ScarpRecipe", -1);
    scarpi_shader_put_steps(w);
    put_text(to, "}\n\n");
    for (int i = 0; i < w->recipe->outputs; i++) {
        if (has_own_name(w->recipe, i)) {
            put_function(w, "ScarpSample", i);
            scarpi_shader_put(to, "    return scarp_recipe(%s).out%d;\n}\n\n", coordinates_of(w),
                              i);
        }
    }
    put_answer(w, order);
}
