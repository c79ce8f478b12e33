/* SPDX-License-Identifier: MIT
 *
 * The class ScarpRecipe, as recipe.c has it for godot.c, which registers it.
 */
#ifndef SCARP_GODOT_RECIPE_H
#define SCARP_GODOT_RECIPE_H

#include <gdextension_interface.h>
#include <stddef.h>
#include <stdint.h>

/* A method. `body` gets arguments and result as Godot has them in memory: an int is an int64_t, a
   float a double. The result is a value already: an empty array, an empty String, 0. */
#define GODOT_ARGUMENTS 6
struct godot_method {
    const char *name;
    void (*body)(void *self, const GDExtensionConstTypePtr *argument, GDExtensionTypePtr result);
    GDExtensionVariantType result; /* nil: none */
    uint32_t flags;
    int count;    /* of arguments */
    int optional; /* how many of them, at the end, may be left out: Strings, then empty */
    struct {
        const char *name;
        GDExtensionVariantType type;
    } argument[GODOT_ARGUMENTS];
};

extern const struct godot_method recipe_methods[];
extern const size_t recipe_method_count;
void *recipe_new(void); /* NULL if there is no memory */
void recipe_free(void *self);

#endif
