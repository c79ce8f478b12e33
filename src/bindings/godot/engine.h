/* SPDX-License-Identifier: MIT
 *
 * The functions of Godot, and what recipe.c and godot.c do with its values.
 */
#ifndef SCARP_GODOT_ENGINE_H
#define SCARP_GODOT_ENGINE_H

#include <gdextension_interface.h>
#include <stddef.h>
#include <stdint.h>

/* The functions of Godot that are used here: name, and the rest of the name of its type. All are in
   Godot 4.2 and later. */
#define GODOT_FUNCTIONS(X)                                                                         \
    X(classdb_construct_object, ClassdbConstructObject)                                            \
    X(classdb_register_extension_class2, ClassdbRegisterExtensionClass2)                           \
    X(classdb_register_extension_class_method, ClassdbRegisterExtensionClassMethod)                \
    X(classdb_unregister_extension_class, ClassdbUnregisterExtensionClass)                         \
    X(get_variant_from_type_constructor, GetVariantFromTypeConstructor)                            \
    X(get_variant_to_type_constructor, GetVariantToTypeConstructor)                                \
    X(object_set_instance, ObjectSetInstance)                                                      \
    X(packed_byte_array_operator_index, PackedByteArrayOperatorIndex)                              \
    X(packed_float32_array_operator_index, PackedFloat32ArrayOperatorIndex)                        \
    X(packed_int32_array_operator_index, PackedInt32ArrayOperatorIndex)                            \
    X(packed_vector3_array_operator_index, PackedVector3ArrayOperatorIndex)                        \
    X(print_error, PrintError)                                                                     \
    X(string_name_new_with_latin1_chars, StringNameNewWithLatin1Chars)                             \
    X(string_new_with_utf8_chars, StringNewWithUtf8Chars)                                          \
    X(string_to_utf8_chars, StringToUtf8Chars)                                                     \
    X(variant_destroy, VariantDestroy)                                                             \
    X(variant_get_ptr_builtin_method, VariantGetPtrBuiltinMethod)                                  \
    X(variant_get_ptr_constructor, VariantGetPtrConstructor)                                       \
    X(variant_get_ptr_destructor, VariantGetPtrDestructor)                                         \
    X(variant_get_type, VariantGetType)

struct godot {
#define GODOT_MEMBER(name, type) GDExtensionInterface##type name;
    GODOT_FUNCTIONS(GODOT_MEMBER)
#undef GODOT_MEMBER
};
extern struct godot godot;

/* Finds the functions. Returns NULL, or what this Godot lacks. */
const char *godot_load(GDExtensionInterfaceGetProcAddress get);

/* A StringName is one pointer. godot_destroy() ends it, and other values that own memory. */
void godot_name(GDExtensionTypePtr name, const char *text);
void godot_destroy(GDExtensionVariantType type, GDExtensionTypePtr value);

/* Elements of a packed array become `count`. Returns 0 if there is no memory for them. */
int godot_resize(GDExtensionVariantType type, GDExtensionTypePtr array, int64_t count);

/* A String as UTF-8, with a 0 behind it, for free(); NULL if there is no memory. */
char *godot_text(GDExtensionConstTypePtr string, size_t *length);

/* A String gets another value: a result does. */
void godot_set_text(GDExtensionTypePtr string, const char *text);

/* Shows an error in the console and in the debugger. `text` is as for printf. */
#ifdef __GNUC__
__attribute__((format(printf, 2, 3)))
#endif
void godot_error(const char *function, const char *text, ...);

#endif
