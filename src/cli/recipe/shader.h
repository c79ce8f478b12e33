/* SPDX-License-Identifier: MIT
 *
 * A recipe as a shader, for `scarp recipe --shader`.
 */
#ifndef SCARP_CLI_RECIPE_SHADER_H
#define SCARP_CLI_RECIPE_SHADER_H

#include <scarp.h>
#include <stddef.h>

/* scarp.glsl, scarp.hlsl and scarp.wgsl, by enum scarp_language */
struct shader_file {
    const char *text;
    size_t length;
};
extern const struct shader_file shader_files[];

/* The words for languages, NULL past the last */
const char *shader_word(int language);

/* What is asked for; a language of -1 and NULL: nothing */
struct shader_options {
    int language;
    size_t order;
    const char *uniforms, *answers; /* files */
};

/* Prints the shader of a recipe, and writes its buffer and its answers. Returns an exit status, and
   tells why on failure. */
int shader_write(const struct scarp_recipe *recipe, const struct shader_options *options);

#endif
