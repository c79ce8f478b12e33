/* SPDX-License-Identifier: MIT
 *
 * The members of noises and gullies, from the words and numbers of their calls.
 */
#include <math.h>
#include <string.h>

#include "../plan/members.h"
#include "compile.h"

static uint64_t splitmix(uint64_t start, uint64_t number)
{
    uint64_t z = start + number * UINT64_C(0x9E3779B97F4A7C15);
    z = (z ^ z >> 30) * UINT64_C(0xBF58476D1CE4E5B9);
    z = (z ^ z >> 27) * UINT64_C(0x94D049BB133111EB);
    return z ^ z >> 31;
}

/* Numbers up to 63 belong to octaves, warps and curls. Those of negative seeds come from the other
   end: 64 more would make numbers from 0 to 63 of -64 to -1. */
static uint64_t seed_of(uint64_t world, double number)
{
    const uint64_t whole = (uint64_t)(int64_t)number;
    return number == 0.0 ? world : splitmix(splitmix(world, 1), number < 0.0 ? whole : 64 + whole);
}

static bool set_seed(struct recipe_compiler *c, int e, double number, uint64_t *seed)
{
    if (!(fabs(number) < 0x1p53) || (double)(int64_t)number != number) {
        scarpi_recipe_bad(c, e, "a seed must be a whole number of magnitude below 2^53", NULL);
        return false;
    }
    *seed = seed_of(c->recipe->seed, number);
    return true;
}

bool scarpi_recipe_one_length(struct recipe_compiler *c, int size, int frequency)
{
    if (size >= 0 && frequency >= 0) {
        scarpi_recipe_bad(c, frequency, "give either size or frequency, not both", NULL);
        return false;
    }
    return true;
}

static bool set_frequency(struct recipe_compiler *c, int e, double frequency, double *to)
{
    if (!within(frequency, noise_bounds.frequency)) {
        scarpi_recipe_bad(c, e, "a frequency is from 2^-32 to 2^48, a size from 2^-48 to 2^32",
                          NULL);
        return false;
    }
    *to = frequency;
    return true;
}

static bool set_size(struct recipe_compiler *c, int e, double size, double *frequency)
{
    return set_frequency(c, e, size > 0.0 ? 1.0 / size : 0.0, frequency);
}

static bool set_period(struct recipe_compiler *c, int e, int argument, double number,
                       struct scarp_noise *noise)
{
    if (!(number >= 0.0 && number <= 0x1p30) || (double)(uint32_t)number != number) {
        scarpi_recipe_bad(c, e, "a period must be a whole number of cells, up to 2^30", NULL);
        return false;
    }
    for (int axis = 0; axis < c->recipe->dimensions; axis++) {
        if (argument == NOISE_PERIOD || argument == NOISE_PERIOD_X + axis) {
            noise->period[axis] = (uint32_t)number;
        }
    }
    return true;
}

bool scarpi_recipe_set_noise(struct recipe_compiler *c, int e, int argument, double number,
                             struct scarp_noise *noise)
{
    float *const member[] = {&noise->octaves, &noise->of_octaves, &noise->lacunarity,
                             &noise->gain,    &noise->amplitude,  &noise->erosion,
                             &noise->phase,   &noise->jitter,     &noise->sharpness};
    switch (argument) {
    case NOISE_SIZE: return set_size(c, e, number, &noise->frequency);
    case NOISE_FREQUENCY: return set_frequency(c, e, number, &noise->frequency);
    case NOISE_SEED: return set_seed(c, e, number, &noise->seed);
    default: break;
    }
    if (argument >= NOISE_PERIOD) {
        return set_period(c, e, argument, number, noise);
    }
    if ((float)number == 0.0f && argument != NOISE_PHASE && argument != NOISE_OF_OCTAVES) {
        scarpi_recipe_bad(c, e, "this member of a noise must not be 0", NULL);
        return false;
    }
    *member[argument - NOISE_OCTAVES] = (float)number;
    return true;
}

/* Effects that are not wanted are 0 in recipes, where the library takes 0 for a default. */
bool scarpi_recipe_set_gullies(struct recipe_compiler *c, int e, int argument, double number,
                               struct scarp_gullies *g)
{
    float *const member[] = {&g->amplitude, &g->octaves, &g->of_octaves, &g->lacunarity,
                             &g->gain,      &g->depth,   &g->cells,      &g->slope,
                             &g->slope_low, &g->low,     &g->high,       &g->floor,
                             &g->stripes,   &g->branch,  &g->round,      &g->keep};
    switch (argument) {
    case GULLIES_SIZE: return set_size(c, e, number, &g->frequency);
    case GULLIES_FREQUENCY: return set_frequency(c, e, number, &g->frequency);
    case GULLIES_SEED: return set_seed(c, e, number, &g->seed);
    default: break;
    }
    float *const to = member[argument - GULLIES_AMPLITUDE];
    const bool is_effect = to == &g->depth || to == &g->low || to == &g->high || to == &g->floor ||
                           to == &g->branch || to == &g->keep;
    *to = (float)number;
    if (*to == 0.0f && is_effect) {
        *to = 0x1p-24f;
    } else if (*to == 0.0f && to != &g->of_octaves) {
        scarpi_recipe_bad(c, e, "this member of gullies must not be 0", NULL);
        return false;
    }
    return true;
}

/* The word that an argument of noise() is; the first one if it is not given. */
static int word_of(const struct recipe_compiler *c, const int16_t argument[RECIPE_ARGUMENTS], int i)
{
    const struct scarp_recipe_function *const f = scarpi_recipe_function_number(FUNCTION_NOISE);
    return argument[i] < 0
               ? 0
               : scarpi_recipe_word_of(c->recipe, c->recipe->expression[argument[i]].name,
                                       &f->argument[i]);
}

void scarpi_recipe_start_noise(const struct recipe_compiler *c,
                               const int16_t argument[RECIPE_ARGUMENTS], struct scarp_noise *noise)
{
    memset(noise, 0, sizeof *noise); /* padding, too: noises are compared */
    noise->basis = (enum scarp_basis)word_of(c, argument, NOISE_BASIS);
    noise->fractal = (enum scarp_fractal)word_of(c, argument, NOISE_FRACTAL);
    noise->fade = (enum scarp_fade)word_of(c, argument, NOISE_FADE);
    noise->rotate = argument[NOISE_ROTATE] >= 0;
    noise->seed = c->recipe->seed;
}

void scarpi_recipe_start_gullies(const struct recipe_compiler *c,
                                 const int16_t argument[RECIPE_ARGUMENTS],
                                 struct scarp_gullies *gullies)
{
    memset(gullies, 0, sizeof *gullies);
    gullies->rotate = argument[GULLIES_ROTATE] >= 0;
    gullies->seed = c->recipe->seed;
    gullies->offset_first = 1;
}

/* Reports why the library refuses a noise or gullies, at the argument with the name of the member
   at fault, or at the call if there is none. */
static bool refuse(struct recipe_compiler *c, int call, int function,
                   const int16_t argument[RECIPE_ARGUMENTS], const char *why, const char *member)
{
    const struct scarp_recipe_function *const f = scarpi_recipe_function_number(function);
    int at = call;
    for (int i = 0; member != NULL && i < f->arguments; i++) {
        if (argument[i] >= 0 && strcmp(f->argument[i].name, member) == 0) {
            at = argument[i];
        }
    }
    scarpi_recipe_bad(c, at, why, member);
    return false;
}

bool scarpi_recipe_check_noise(struct recipe_compiler *c, int call,
                               const int16_t argument[RECIPE_ARGUMENTS],
                               const struct scarp_noise *noise)
{
    const char *member;
    const char *const why = scarp_noise_fault(noise, c->recipe->dimensions, 0, 0, &member);
    return why == NULL || refuse(c, call, FUNCTION_NOISE, argument, why, member);
}

bool scarpi_recipe_check_gullies(struct recipe_compiler *c, int call,
                                 const int16_t argument[RECIPE_ARGUMENTS],
                                 const struct scarp_gullies *gullies)
{
    const char *member;
    const char *const why = scarp_gullies_fault(gullies, &member);
    return why == NULL || refuse(c, call, FUNCTION_GULLIES, argument, why, member);
}
