/* SPDX-License-Identifier: MIT
 *
 * The list of functions. Intervals of numbers are those of sliders; what calls take may be more.
 */
#include "words.h"

#include <stddef.h>

#include "../plan/members.h"
#include "../plan/traits.h"
#include "text.h"

#define NEEDED 1

#define NUMBER(name, otherwise, lowest, highest, text)                                             \
    {                                                                                              \
        name, text, SCARP_RECIPE_NUMBER, 0, otherwise, lowest, highest, NULL,                      \
        {                                                                                          \
            0                                                                                      \
        }                                                                                          \
    }
#define NEEDED_NUMBER(name, lowest, highest, text)                                                 \
    {                                                                                              \
        name, text, SCARP_RECIPE_NUMBER, NEEDED, 0.0, lowest, highest, NULL,                       \
        {                                                                                          \
            0                                                                                      \
        }                                                                                          \
    }
#define FIELD(name, text)                                                                          \
    {                                                                                              \
        name, text, SCARP_RECIPE_FIELD, NEEDED, 0.0, 0.0, 0.0, NULL,                               \
        {                                                                                          \
            0                                                                                      \
        }                                                                                          \
    }
#define MORE(name, text)                                                                           \
    {                                                                                              \
        name, text, SCARP_RECIPE_FIELD, 0, 0.0, 0.0, 0.0, NULL,                                    \
        {                                                                                          \
            0                                                                                      \
        }                                                                                          \
    }
#define NOISE(name, text)                                                                          \
    {                                                                                              \
        name, text, SCARP_RECIPE_NOISE, NEEDED, 0.0, 0.0, 0.0, NULL,                               \
        {                                                                                          \
            0                                                                                      \
        }                                                                                          \
    }
#define KNOTS(name, text)                                                                          \
    {                                                                                              \
        name, text, SCARP_RECIPE_KNOT, NEEDED, 0.0, 0.0, 0.0, NULL,                                \
        {                                                                                          \
            0                                                                                      \
        }                                                                                          \
    }
#define WORD(name, words, text)                                                                    \
    {                                                                                              \
        name, text, SCARP_RECIPE_WORD, 0, 0.0, 0.0, 0.0, words,                                    \
        {                                                                                          \
            0                                                                                      \
        }                                                                                          \
    }

#define BASIS(enumerator, name, word, traits) [SCARP_##enumerator] = word,
#define FRACTAL(enumerator, name, ...) [SCARP_##enumerator] = name,
static const char *const bases[SCARP_BASES + 1] = {SCARP_BASIS_LIST(BASIS)};
static const char *const fractals[SCARP_FRACTALS + 1] = {SCARP_FRACTAL_LIST(FRACTAL)};
static const char *const fades[] = {"quintic", "cubic", NULL};
static const char *const rotate[] = {"rotate", NULL};
static const char *const cells[] = {"id", "f1", "f2", NULL};
static const char *const axes[] = {"x", "y", "z", NULL};

#define MEMBER(X, member, refusal, standard, lowest, highest, told, least, most, text)             \
    NUMBER(#member, standard, least, most, text),
#define OTHER(X, member, standard, least, most, text) NUMBER(#member, standard, least, most, text),

static const struct scarp_recipe_argument noise[] = {
    WORD("basis", bases, "the noise of one octave"),
    WORD("fractal", fractals, "how octaves are summed"),
    WORD("fade", fades, "the blend between lattice points"),
    WORD("rotate", rotate, "turns the axes between octaves"),
    NUMBER("size", 1.0, 1.0, 10000.0, "length of a cell of the first octave; 1 / frequency"),
    SCARP_NOISE_MEMBERS(MEMBER, OTHER, )
        NUMBER("period", 0.0, 0.0, 64.0, "cells after which the noise repeats along all axes"),
    NUMBER("period_x", 0.0, 0.0, 64.0, "the same along x"),
    NUMBER("period_y", 0.0, 0.0, 64.0, "the same along y"),
    NUMBER("period_z", 0.0, 0.0, 64.0, "the same along z"),
};

static const struct scarp_recipe_argument gullies[] = {
    FIELD("f", "the base"),
    NUMBER("size", 1.0, 10.0, 10000.0, "length of a cell of the base; 1 / frequency"),
    SCARP_GULLIES_MEMBERS(MEMBER, OTHER, ) WORD("rotate", rotate, "turns the axes between octaves"),
};

static const struct scarp_recipe_argument cell[] = {
    NOISE("n", "a noise, whose basis does not matter"),
    WORD("what", cells, "a number in [-1, 1] for each cell, or a distance in units"),
};
static const struct scarp_recipe_argument one[] = {FIELD("a", "a field")};
static const struct scarp_recipe_argument two[] = {
    FIELD("a", "a field"),
    FIELD("b", "a field"),
    NUMBER("smooth", 0.0, 0.0, 1.0, "how near fields are where the crease is round"),
};
static const struct scarp_recipe_argument smooth_abs[] = {
    FIELD("a", "a field"),
    NEEDED_NUMBER("round", 0.01, 1.0, "the value where a is 0"),
};
static const struct scarp_recipe_argument interval[] = {
    FIELD("a", "a field"),
    NEEDED_NUMBER("lo", -1.0, 1.0, "the lower end"),
    NEEDED_NUMBER("hi", -1.0, 1.0, "the upper end"),
};
static const struct scarp_recipe_argument terrace[] = {
    FIELD("a", "a field"),
    NEEDED_NUMBER("steps", 1.0, 32.0, "steps per unit of value"),
    NUMBER("riser", 0.5, 0.05, 1.0, "the part of a step that rises"),
    NUMBER("strength", 0.75, 0.0, 1.0, "how level steps are"),
};
static const struct scarp_recipe_argument mix[] = {
    FIELD("a", "where the mask is 0"),
    FIELD("b", "where the mask is 1"),
    FIELD("m", "the mask, in [0, 1]"),
};
static const struct scarp_recipe_argument curve[] = {
    FIELD("a", "a field"),
    KNOTS("knots", "x: value, with x from the least to the greatest"),
};
static const struct scarp_recipe_argument blend[] = {
    FIELD("a", "a field"),
    KNOTS("knots", "x: field, with x from the least to the greatest"),
};
static const struct scarp_recipe_argument warp[] = {
    FIELD("f", "what is bent"),
    NOISE("by", "the displacement, in units"),
};
static const struct scarp_recipe_argument turn[] = {
    FIELD("f", "what is turned"),
    NEEDED_NUMBER("degrees", -180.0, 180.0, "counterclockwise, seen from the end of the axis"),
    WORD("axis", axes, "of space: the axis around which f is turned, otherwise z"),
};
static const struct scarp_recipe_argument move[] = {
    FIELD("f", "what is moved"),
    NEEDED_NUMBER("dx", -1000.0, 1000.0, "units along x"),
    NEEDED_NUMBER("dy", -1000.0, 1000.0, "units along y"),
    NUMBER("dz", 0.0, -1000.0, 1000.0, "units along z"),
};
static const struct scarp_recipe_argument scale[] = {
    FIELD("f", "what is scaled"),
    NEEDED_NUMBER("by", 0.1, 10.0, "how many times as large"),
};
static const struct scarp_recipe_argument stretch[] = {
    FIELD("f", "what is stretched"),
    NEEDED_NUMBER("sx", 0.1, 10.0, "along x"),
    NEEDED_NUMBER("sy", 0.1, 10.0, "along y"),
    NUMBER("sz", 1.0, 0.1, 10.0, "along z"),
};
static const struct scarp_recipe_argument wind[] = {
    FIELD("f", "what lies across the wind along its x"),
    NEEDED_NUMBER("from", 0.0, 360.0, "degrees clockwise from north (y), whence the wind blows"),
    NUMBER("by", 1.0, 1.0, 10.0, "how many times longer f is across the wind"),
};
static const struct scarp_recipe_argument at[] = {
    FIELD("f", "what is looked at"),
    FIELD("u", "in place of x"),
    FIELD("v", "in place of y"),
    MORE("w", "in place of z"),
};

#define ROW(name, arguments, text)                                                                 \
    {                                                                                              \
        name, text, arguments, (int32_t)(sizeof arguments / sizeof arguments[0]),                  \
        {                                                                                          \
            0                                                                                      \
        }                                                                                          \
    }

static const struct scarp_recipe_function functions[FUNCTION_COUNT] = {
    [FUNCTION_NOISE] = ROW("noise", noise, "Noise of any basis and fractal."),
    [FUNCTION_CELL] = ROW("cell", cell, "The number of a cell, or the distance to its feature."),
    [FUNCTION_FLAT] = ROW("flat", one, "A field of the plane, the same at every z."),
    [FUNCTION_MIN] = ROW("min", two, "The lesser of two fields."),
    [FUNCTION_MAX] = ROW("max", two, "The greater of two fields."),
    [FUNCTION_ABS] = ROW("abs", one, "The magnitude, with a crease at 0."),
    [FUNCTION_SMOOTH_ABS] = ROW("smooth_abs", smooth_abs, "The magnitude, with a round floor."),
    [FUNCTION_CLAMP] = ROW("clamp", interval, "A field, held within an interval."),
    [FUNCTION_SMOOTHSTEP] = ROW("smoothstep", interval, "A mask: from 0 at lo to 1 at hi."),
    [FUNCTION_TERRACE] = ROW("terrace", terrace, "Steps in a slope."),
    [FUNCTION_MIX] = ROW("mix", mix, "A blend of two fields by a mask."),
    [FUNCTION_CURVE] = ROW("curve", curve, "A smooth curve through knots, level beyond them."),
    [FUNCTION_BLEND] = ROW("blend", blend, "Fields one after the other, by the value of another."),
    [FUNCTION_SQRT] = ROW("sqrt", one, "The square root; 0 below 0."),
    [FUNCTION_SINE] = ROW("sine", one, "The sine of a number of turns."),
    [FUNCTION_PULSE] = ROW("pulse", one, "A field folded to and fro between -1 and 1, period 2."),
    [FUNCTION_SLOPE] = ROW("slope", one, "The length of the gradient."),
    [FUNCTION_WARP] = ROW("warp", warp, "A field, bent by a noise."),
    [FUNCTION_TURN] = ROW("turn", turn, "A field, turned around the origin."),
    [FUNCTION_MOVE] = ROW("move", move, "A field, moved."),
    [FUNCTION_SCALE] = ROW("scale", scale, "A field, scaled from the origin."),
    [FUNCTION_STRETCH] = ROW("stretch", stretch, "A field, scaled along each axis."),
    [FUNCTION_WIND] = ROW("wind", wind, "A field, turned and stretched as by the wind."),
    [FUNCTION_AT] = ROW("at", at, "A field, looked at elsewhere."),
    [FUNCTION_GULLIES] = ROW("gullies", gullies, "Gullies and spurs, drawn into a base."),
    [FUNCTION_DISPLACEMENT] =
        ROW("displacement", gullies, "What gullies add to their base: a map of ridges."),
};

const struct scarp_recipe_function *scarpi_recipe_function_number(int function)
{
    return function >= 0 && function < FUNCTION_COUNT ? &functions[function] : NULL;
}

int scarpi_recipe_function_of(const struct recipe *recipe, struct recipe_span name)
{
    for (int i = 0; i < FUNCTION_COUNT; i++) {
        if (scarpi_recipe_is(recipe, name, functions[i].name)) {
            return i;
        }
    }
    return -1;
}

int scarpi_recipe_word_of(const struct recipe *recipe, struct recipe_span name,
                          const struct scarp_recipe_argument *argument)
{
    for (int i = 0; argument->words != NULL && argument->words[i] != NULL; i++) {
        if (scarpi_recipe_is(recipe, name, argument->words[i])) {
            return i;
        }
    }
    return -1;
}
