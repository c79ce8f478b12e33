/* SPDX-License-Identifier: MIT
 *
 * The functions of Godot, and its values: names, Strings, packed arrays, errors.
 */
#include "engine.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>

/* Of Godot's extension_api.json: the hash of resize(int) -> int, which all packed arrays have */
#define RESIZE_HASH 848867239

#define FIRST_PACKED GDEXTENSION_VARIANT_TYPE_PACKED_BYTE_ARRAY
#define LAST_PACKED GDEXTENSION_VARIANT_TYPE_PACKED_VECTOR3_ARRAY

struct godot godot;
static GDExtensionPtrBuiltInMethod resize[LAST_PACKED - FIRST_PACKED + 1];

const char *godot_load(GDExtensionInterfaceGetProcAddress get)
{
    const char *missing = NULL;
#define GODOT_LOAD(name, type)                                                                     \
    godot.name = (GDExtensionInterface##type)(void (*)(void))get(#name);                           \
    missing = godot.name == NULL ? #name : missing;
    GODOT_FUNCTIONS(GODOT_LOAD)
#undef GODOT_LOAD
    if (missing == NULL) {
        void *name;
        godot_name(&name, "resize");
        for (int i = FIRST_PACKED; i <= LAST_PACKED; i++) {
            GDExtensionPtrBuiltInMethod found =
                godot.variant_get_ptr_builtin_method((GDExtensionVariantType)i, &name, RESIZE_HASH);
            resize[i - FIRST_PACKED] = found;
            missing = found == NULL ? "resize of packed arrays" : missing;
        }
        godot_destroy(GDEXTENSION_VARIANT_TYPE_STRING_NAME, &name);
    }
    return missing;
}

void godot_name(GDExtensionTypePtr name, const char *text)
{
    godot.string_name_new_with_latin1_chars(name, text, 0);
}

void godot_destroy(GDExtensionVariantType type, GDExtensionTypePtr value)
{
    int has_destructor = type == GDEXTENSION_VARIANT_TYPE_STRING ||
                         type == GDEXTENSION_VARIANT_TYPE_STRING_NAME || type >= FIRST_PACKED;
    if (has_destructor) {
        godot.variant_get_ptr_destructor(type)(value);
    }
}

int godot_resize(GDExtensionVariantType type, GDExtensionTypePtr array, int64_t count)
{
    GDExtensionConstTypePtr argument[1] = {&count};
    int64_t error = 0;
    resize[type - FIRST_PACKED](array, argument, &error, 1);
    return error == 0;
}

char *godot_text(GDExtensionConstTypePtr string, size_t *length)
{
    GDExtensionInt bytes = godot.string_to_utf8_chars(string, NULL, 0);
    char *text = malloc((size_t)bytes + 1);
    if (text != NULL) {
        godot.string_to_utf8_chars(string, text, bytes);
        text[bytes] = 0;
        *length = (size_t)bytes;
    }
    return text;
}

void godot_set_text(GDExtensionTypePtr string, const char *text)
{
    godot_destroy(GDEXTENSION_VARIANT_TYPE_STRING, string);
    godot.string_new_with_utf8_chars(string, text);
}

void godot_error(const char *function, const char *text, ...)
{
    char message[512];
    va_list list;
    va_start(list, text);
    vsnprintf(message, sizeof message, text, list);
    va_end(list);
    godot.print_error(message, function, "ScarpRecipe", 0, 1);
}
