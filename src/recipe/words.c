/* SPDX-License-Identifier: MIT
 *
 * The words of plan/functions.def as structures of scarp.h, for the compiler and for editors.
 */
#include "words.h"

#include <stddef.h>

#include "../plan/members.h"
#include "../plan/traits.h"
#include "text.h"

#define BASIS(enumerator, name, word, traits) [SCARP_##enumerator] = word,
#define FRACTAL(enumerator, name, ...) [SCARP_##enumerator] = name,
static const char *const bases[SCARP_BASES + 1] = {SCARP_BASIS_LIST(BASIS)};
static const char *const fractals[SCARP_FRACTALS + 1] = {SCARP_FRACTAL_LIST(FRACTAL)};
static const char *const fades[] = {"quintic", "cubic", NULL};
static const char *const rotate[] = {"rotate", NULL};
static const char *const cells[] = {"id", "f1", "f2", NULL};
static const char *const axes[] = {"x", "y", "z", NULL};

/* Arguments. Their last member is spare. */
#define ARGUMENT(name, kind, is_needed, otherwise, lowest, highest, words, text)                   \
    {                                                                                              \
        name, text, kind, is_needed, otherwise, lowest, highest, words,                            \
        {                                                                                          \
            0                                                                                      \
        }                                                                                          \
    }
#define NUMBER(name, otherwise, lowest, highest, text)                                             \
    ARGUMENT(name, SCARP_RECIPE_NUMBER, 0, otherwise, lowest, highest, NULL, text)
#define NEEDED_NUMBER(name, lowest, highest, text)                                                 \
    ARGUMENT(name, SCARP_RECIPE_NUMBER, 1, 0.0, lowest, highest, NULL, text)
#define FIELD(name, text) ARGUMENT(name, SCARP_RECIPE_FIELD, 1, 0.0, 0.0, 0.0, NULL, text)
#define MORE(name, text) ARGUMENT(name, SCARP_RECIPE_FIELD, 0, 0.0, 0.0, 0.0, NULL, text)
#define NOISE(name, text) ARGUMENT(name, SCARP_RECIPE_NOISE, 1, 0.0, 0.0, 0.0, NULL, text)
#define KNOTS(name, text) ARGUMENT(name, SCARP_RECIPE_KNOT, 1, 0.0, 0.0, 0.0, NULL, text)
#define WORDS(name, words, text) ARGUMENT(name, SCARP_RECIPE_WORD, 0, 0.0, 0.0, 0.0, words, text)

/* Those that are members of structures, each with a comma behind it. */
#define MEMBER(X, member, refusal, standard, lowest, highest, told, least, most, text)             \
    NUMBER(#member, standard, least, most, text),
#define OTHER(X, member, standard, least, most, text) NUMBER(#member, standard, least, most, text),
#define NOISE_MEMBERS SCARP_NOISE_MEMBERS(MEMBER, OTHER, )
#define GULLIES_MEMBERS SCARP_GULLIES_MEMBERS(MEMBER, OTHER, )

#define LIST(...) __VA_ARGS__
#define WORD(NAME, name, arguments, ...)                                                           \
    static const struct scarp_recipe_argument arguments_of_##name[] = {LIST arguments};
#define FUNCTION(NAME, name, FORM, COMPUTED, take, traits, range, shader, numbers, arguments, ...) \
    WORD(NAME, name, arguments, )
#include "../plan/functions.def"

#define WORD(NAME, name, arguments, text, ...)                                                     \
    {#name,                                                                                        \
     text,                                                                                         \
     arguments_of_##name,                                                                          \
     (int32_t)(sizeof arguments_of_##name / sizeof arguments_of_##name[0]),                        \
     {0}},
#define FUNCTION(NAME, name, FORM, COMPUTED, take, traits, range, shader, numbers, arguments,      \
                 text, ...)                                                                        \
    WORD(NAME, name, arguments, text, )
static const struct scarp_recipe_function functions[FUNCTION_COUNT] = {
#include "../plan/functions.def"
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
