/* SPDX-License-Identifier: MIT
 *
 * Any file in place of scarp.glsl and its like: scarp_recipe_shader cuts functions out of it.
 *
 * An input is the language, then how many edits are made in a short file that has what is looked
 * for, and the edits: where (2 bytes), how many bytes go (1), how many come (1), and these. What is
 * left of the input is behind.
 */
#include <string.h>

#include "draw.h"
#include "fuzz.h"
#include "scarp.h"

#define MOST_EDITS 8
#define MOST 8192
#define MOST_WRITTEN 65536

static const char recipe_text[] = "recipe 1\nout a = noise() * noise(ridged, octaves=2)\n";

static const char *const short_file[3] = {
    "#ifndef SCARP_GLSL\n#define SCARP_GLSL\n"
    "#define SCARP_LAYOUT(n) layout(std140, binding = n)\n#define scarp_pick(a, b) mix(a, b)\n"
    "/* A comment */\nSCARP_LAYOUT(0) uniform block {\n    float a;\n} scarp_plan[2];\n\n"
    "uint scarp_zero()\n{\n    return scarp_plan[0].zero;\n}\n\n"
    "// another\nfloat scarp_add(float a, float b)\n{\n    return a + b;\n}\n\n"
    "ScarpSample scarp_sample2(float x)\n{\n    return scarp_add(x, scarp_pick(1, 2));\n}\n"
    "#endif\n",
    "#ifndef SCARP_HLSL\n#define SCARP_HLSL\n#if A\n#define scarp_pick(a, b) (a)\n#else\n"
    "#define scarp_other 1\n#endif\nstruct ScarpSample {\n    float value;\n};\n\n"
    "uint scarp_zero()\n{\n    return 0;\n}\n\nfloat scarp_noise(float x)\n{\n    return x;\n}\n"
    "#endif\n",
    "override scarp_one = 1;\nconst scarp_two: u32 = 2;\nfn scarp_zero() -> u32 {\n    return "
    "0;\n}\n"
    "fn scarp_add(a: f32, b: f32) -> f32 {\n    return a + b; /* \n */\n}\n",
};

/* Replaces some bytes; returns the new length. */
static size_t edit(struct draw *bytes, char text[MOST], size_t length)
{
    const size_t at = (size_t)draw_bits(bytes, 2) % (length + 1);
    size_t gone = (size_t)draw_bits(bytes, 1), come = (size_t)draw_bits(bytes, 1);
    gone = gone < length - at ? gone : length - at;
    come = come < bytes->left ? come : bytes->left;
    memmove(text + at + come, text + at + gone, length - at - gone);
    memcpy(text + at, bytes->at, come);
    bytes->at += come;
    bytes->left -= come;
    return length - gone + come;
}

static void check(const struct scarp_recipe *recipe, const struct scarp_shader *how)
{
    static char out[MOST_WRITTEN], again[MOST_WRITTEN];
    size_t written = 0, needed = 0;
    const enum scarp_status status = scarp_recipe_shader(recipe, how, out, sizeof out, &written);
    MUST(status == SCARP_OK || status == SCARP_ERROR_PARAMETER, "status %d", (int)status);
    if (status != SCARP_OK) {
        return;
    }
    MUST(written < sizeof out && out[written] == '\0', "%zu bytes", written);
    MUST(scarp_recipe_shader(recipe, how, again, written + 1, &needed) == SCARP_OK &&
             needed == written && memcmp(out, again, written + 1) == 0,
         "another text in the room that was said: %zu", needed);
    MUST(scarp_recipe_shader(recipe, how, NULL, 0, &needed) == SCARP_ERROR_SIZE &&
             needed >= written,
         "%zu bytes are needed, %zu without room", written, needed);
}

int LLVMFuzzerTestOneInput(const uint8_t *input, size_t size)
{
    static struct scarp_recipe recipe;
    static char text[MOST];
    struct draw bytes = {input, size};
    const int language = (int)(draw_bits(&bytes, 1) % 3);
    const int edits = (int)draw_bits(&bytes, 1) % (MOST_EDITS + 1);
    size_t length = strlen(short_file[language]);
    memcpy(text, short_file[language], length);
    for (int i = 0; i < edits; i++) {
        length = edit(&bytes, text, length);
    }
    const size_t rest = bytes.left < MOST - length ? bytes.left : MOST - length;
    if (rest > 0) {
        memcpy(text + length, bytes.at, rest);
    }
    char *const exact = fuzz_text((const uint8_t *)text, length + rest);
    MUST(scarp_recipe_parse(recipe_text, sizeof recipe_text - 1, &recipe, NULL, 0, NULL) ==
             SCARP_OK,
         "the recipe");
    struct scarp_shader how = {
        .file = exact, .length = length + rest, .order = (int32_t)(size % 3)};
    for (how.language = 0; how.language < 3; how.language++) {
        size_t written;
        check(&recipe, &how);
        MUST(size > 0 || (scarp_recipe_shader(&recipe, &how, NULL, 0, &written) ==
                          SCARP_ERROR_SIZE) == (how.language == language),
             "the language of the file");
    }
    free(exact);
    return 0;
}
