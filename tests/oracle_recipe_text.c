/* SPDX-License-Identifier: MIT
 *
 * What a text says, for the oracle of recipes: parts of expressions, arguments, and the structures of
 * noises and gullies.
 */
#include "oracle_recipe_text.h"

#include <string.h>

int oracle_is(const struct oracle_recipe *o, const uint32_t span[2], const char *word)
{
    return strlen(word) == span[1] - span[0] && strncmp(o->text + span[0], word, strlen(word)) == 0;
}

/* The parts of a part, in the order of the text. */
int oracle_parts(const struct oracle_recipe *o, int parent, int child[64])
{
    int count = 0;
    for (int i = 0; i < o->parts; i++) {
        if (o->part[i].parent == parent && count < 64) {
            int at = count++;
            for (; at > 0 && o->part[child[at - 1]].span[0] > o->part[i].span[0]; at--) {
                child[at] = child[at - 1];
            }
            child[at] = i;
        }
    }
    return count;
}

/* The argument of a name, or that at a position; -1: not there. */
int oracle_argument(const struct oracle_recipe *o, int call, const char *name, int position)
{
    int child[64];
    const int count = oracle_parts(o, call, child);
    for (int i = 0; i < count; i++) {
        if (oracle_is(o, o->part[child[i]].argument, name)) {
            return child[i];
        }
    }
    return position < count && position >= 0 &&
                   o->part[child[position]].argument[1] == o->part[child[position]].argument[0]
               ? child[position]
               : -1;
}

double oracle_number_or(const struct oracle_recipe *o, int call, const char *name, int position,
                        double otherwise)
{
    const int part = oracle_argument(o, call, name, position);
    return part < 0 ? otherwise : o->number(o, part);
}

static uint64_t seed_of(const struct oracle_recipe *o, int call)
{
    const double given = oracle_number_or(o, call, "seed", -1, 0.0);
    return given == 0.0
               ? o->seed
               : check_random_number(check_random_number(o->seed, 1),
                                     given < 0.0 ? (uint64_t)(int64_t)given : 64 + (uint64_t)given);
}

static double frequency_of(const struct oracle_recipe *o, int call)
{
    const double size = oracle_number_or(o, call, "size", -1, 0.0);
    return size != 0.0 ? 1.0 / size : oracle_number_or(o, call, "frequency", -1, 1.0);
}

int oracle_has_word(const struct oracle_recipe *o, int call, const char *word)
{
    int child[64];
    const int count = oracle_parts(o, call, child);
    for (int i = 0; i < count; i++) {
        if (o->part[child[i]].kind == SCARP_RECIPE_WORD &&
            oracle_is(o, o->part[child[i]].name, word)) {
            return 1;
        }
    }
    return 0;
}

/* A word of the library, which has dashes. */
static int has_name(const struct oracle_recipe *o, int call, const char *name)
{
    char word[32] = "";
    for (size_t i = 0; name[i] != '\0' && i < sizeof word - 1; i++) {
        word[i] = name[i] == '-' ? '_' : name[i];
        word[i + 1] = '\0';
    }
    return oracle_has_word(o, call, word);
}

struct scarp_noise oracle_noise_of(const struct oracle_recipe *o, int call)
{
    struct scarp_noise n = {
        .seed = seed_of(o, call), .frequency = frequency_of(o, call), .offset_first = 1};
    for (int i = 0; scarp_basis_name((enum scarp_basis)i) != NULL; i++) {
        n.basis = has_name(o, call, scarp_basis_name((enum scarp_basis)i)) ? (enum scarp_basis)i
                                                                           : n.basis;
    }
    for (int i = 0; scarp_fractal_name((enum scarp_fractal)i) != NULL; i++) {
        n.fractal = has_name(o, call, scarp_fractal_name((enum scarp_fractal)i))
                        ? (enum scarp_fractal)i
                        : n.fractal;
    }
    n.fade = oracle_has_word(o, call, "cubic") ? SCARP_CUBIC : SCARP_QUINTIC;
    n.rotate = oracle_has_word(o, call, "rotate") != 0;
    n.octaves = (float)oracle_number_or(o, call, "octaves", -1, 0.0);
    n.of_octaves = (float)oracle_number_or(o, call, "of_octaves", -1, 0.0);
    n.lacunarity = (float)oracle_number_or(o, call, "lacunarity", -1, 0.0);
    n.gain = (float)oracle_number_or(o, call, "gain", -1, 0.0);
    n.amplitude = (float)oracle_number_or(o, call, "amplitude", -1, 0.0);
    n.erosion = (float)oracle_number_or(o, call, "erosion", -1, 0.0);
    n.phase = (float)oracle_number_or(o, call, "phase", -1, 0.0);
    n.jitter = (float)oracle_number_or(o, call, "jitter", -1, 0.0);
    n.sharpness = (float)oracle_number_or(o, call, "sharpness", -1, 0.0);
    static const char *const periods[3] = {"period_x", "period_y", "period_z"};
    for (int i = 0; i < o->dimensions; i++) {
        n.period[i] = (uint32_t)oracle_number_or(o, call, periods[i], -1,
                                                 oracle_number_or(o, call, "period", -1, 0.0));
    }
    return n;
}

/* The call noise(...) behind names; -1: the part is something else. */
int oracle_call_of(const struct oracle_recipe *o, int part)
{
    while (part >= 0 && o->part[part].function < 0) {
        part = o->part[part].entry >= 0 ? o->entry[o->part[part].entry].part : -1;
    }
    return part;
}

/* A member of gullies. What is 0 in a recipe has no effect; in the library it is the default. */
static float member_of(const struct oracle_recipe *o, int call, const char *name, double standard)
{
    const float given = (float)oracle_number_or(o, call, name, -1, standard);
    return given == 0.0f ? 0x1p-24f : given;
}

struct scarp_gullies oracle_gullies_of(const struct oracle_recipe *o, int call)
{
    const struct scarp_gullies g = {
        .seed = seed_of(o, call),
        .frequency = frequency_of(o, call),
        .amplitude = (float)oracle_number_or(o, call, "amplitude", -1, 0.0),
        .octaves = (float)oracle_number_or(o, call, "octaves", -1, 0.0),
        .of_octaves = (float)oracle_number_or(o, call, "of_octaves", -1, 0.0),
        .lacunarity = (float)oracle_number_or(o, call, "lacunarity", -1, 0.0),
        .gain = (float)oracle_number_or(o, call, "gain", -1, 0.0),
        .depth = member_of(o, call, "depth", 0.25),
        .cells = (float)oracle_number_or(o, call, "cells", -1, 0.0),
        .slope = (float)oracle_number_or(o, call, "slope", -1, 0.0),
        .slope_low = (float)oracle_number_or(o, call, "slope_low", -1, 0.0),
        .low = member_of(o, call, "low", -1.0),
        .high = member_of(o, call, "high", 1.0),
        .floor = member_of(o, call, "floor", 0.5),
        .stripes = (float)oracle_number_or(o, call, "stripes", -1, 0.0),
        .branch = member_of(o, call, "branch", 0.8),
        .round = (float)oracle_number_or(o, call, "round", -1, 0.0),
        .keep = member_of(o, call, "keep", 1.0),
        .rotate = oracle_has_word(o, call, "rotate") != 0,
        .offset_first = 1,
    };
    return g;
}
