/* SPDX-License-Identifier: MIT
 *
 * A recipe as a shader: functions as text, and one uniform buffer.
 *
 *     shader.c        the public functions
 *     shader_plan.c   the buffer: a head, numbers, and levels and octaves of all noises
 *     shader_text.c   text of a language; the functions for the octaves of each kind of noise
 *     shader_steps.c  a line for each step
 *     shader_functions.c  the declaration of the buffer, and all functions
 *     shader_cut.c    what is left of scarp.glsl and its like when it has what these use
 */
#ifndef SCARP_RECIPE_SHADER_H
#define SCARP_RECIPE_SHADER_H

#include <stddef.h>
#include <string.h>

#include "recipe.h"
#include "statuses.h"

/* Each noise may be sampled in the plane and in space. */
enum { SHADER_KINDS = 2 * RECIPE_NOISES };

/* Where the constants of a recipe are in its buffer. */
struct shader_slots {
    int numbers, levels, octaves;    /* how many, at least 1 of each */
    int16_t number_of[RECIPE_NODES]; /* by node: its first vector of numbers */
    int16_t level_of[RECIPE_NODES];  /* by node: the level of its noise */
    int16_t place_of[RECIPE_PLACES]; /* by place: the first of its three rows */
    float unit;                      /* of test points */
};

/* The buffer. Arrays are NULL while slots are counted. */
struct shader_uniforms {
    float (*number)[4];
    struct scarp_gpu_level *level;
    struct scarp_gpu_octave *octave;
};

KEEP_STATUS enum scarp_status scarpi_shader_lay_out(const struct recipe *recipe,
                                                    const struct shader_uniforms *to,
                                                    struct shader_slots *slots);

/* Text; what exceeds the capacity is counted and not written. */
struct shader_text {
    char *text;
    size_t capacity, length;
    int language; /* enum scarp_language */
};

/* Adds text in which %d is an int from 0 on, %s a text. %V and %4 are the words of the language for
   a vector of three numbers and one of four; %L is what declares a variable that
   does not change, and %X one that does, of a type whose name follows in the format up to a space:
   "%LScarpSample r1 = 0;". */
void scarpi_shader_put(struct shader_text *to, const char *format, ...);
void scarpi_shader_put_span(struct shader_text *to, const char *from, size_t length);

static inline void put_text(struct shader_text *to, const char *text)
{
    scarpi_shader_put_span(to, text, strlen(text));
}

/* What is needed to write the functions. */
struct shader_writer {
    const struct recipe *recipe;
    const struct shader_slots *slots;
    struct shader_text *to;
    uint8_t order_of[RECIPE_NODES];
    int kinds;
    uint32_t kind[SHADER_KINDS]; /* of noise: what its function depends on, packed */
    int warped;                  /* a node whose warp is still known here, or -1 */
};

/* The declaration of the buffer, which stands behind the structures. */
void scarpi_shader_put_head(const struct shader_writer *w);

/* The functions. */
void scarpi_shader_put_functions(struct shader_writer *w, int order);

/* Looks which kinds of noise there are, and writes their functions. */
void scarpi_shader_put_kinds(struct shader_writer *w);

/* The number of the function for the octaves of a noise. */
int scarpi_shader_kind(struct shader_writer *w, const struct scarp_noise *noise, int dimensions);

/* The body of the function that gives all outputs. */
void scarpi_shader_put_steps(struct shader_writer *w);

/* What a shader uses of scarp.glsl or its like. */
struct shader_cut {
    const char *file;
    size_t length;
    size_t head; /* of the recipe's own text, this much declares the buffer */
};

/* Puts what is used around a recipe's own text, which `text` has from its beginning. Returns 0 if
   the file is none of these. */
int scarpi_shader_cut(const struct shader_cut *cut, struct shader_text *text);

#endif
