/* SPDX-License-Identifier: MIT
 *
 * The part of Godot, for tests of the extension in src/bindings/godot. Variants, Strings and arrays
 * are Godot's as far as its header tells; what they have inside is this file's own. Every value is
 * counted, and an index behind the end of an array ends the program. Included by godot_host.c.
 */
#ifndef SCARP_TESTS_GODOT_ENGINE_H
#define SCARP_TESTS_GODOT_ENGINE_H

#include "check.h"

#include <gdextension_interface.h>

#define MOST_METHODS 32
#define MOST_ARGUMENTS 8

/* Values. A String and a StringName point to a block, a packed array has its block in the second
   word, and is empty where that is NULL. */
struct block {
    int64_t count;
    size_t size; /* of an element */
    char *bytes;
};
struct array {
    void *unused;
    struct block *block;
};
struct variant {
    int32_t type;
    union {
        int64_t integer;
        double number;
        void *string;
        struct array array;
    } as;
};

static long live;        /* blocks that exist */
static int no_memory;    /* resize fails */
static size_t real = 4;  /* bytes of a component of Vector3 */
static long errors;      /* print_error was called */
static char error[1024]; /* with this */

static void stop(const char *why)
{
    printf("stopped: %s\n", why);
    exit(1);
}

static struct block *block_new(const void *bytes, int64_t count, size_t size)
{
    struct block *block = malloc(sizeof *block);
    size_t length = (size_t)count * size;
    block->count = count;
    block->size = size;
    block->bytes = calloc(1, length + 1);
    if (bytes != NULL) {
        memcpy(block->bytes, bytes, length);
    }
    live++;
    return block;
}

static void block_free(struct block *block)
{
    if (block != NULL) {
        free(block->bytes);
        free(block);
        live--;
    }
}

static struct block *block_copy(const struct block *block)
{
    return block == NULL ? NULL : block_new(block->bytes, block->count, block->size);
}

static int is_text(GDExtensionVariantType type)
{
    return type == GDEXTENSION_VARIANT_TYPE_STRING || type == GDEXTENSION_VARIANT_TYPE_STRING_NAME;
}

static size_t element(GDExtensionVariantType type)
{
    switch (type) {
    case GDEXTENSION_VARIANT_TYPE_PACKED_BYTE_ARRAY: return 1;
    case GDEXTENSION_VARIANT_TYPE_PACKED_INT32_ARRAY:
    case GDEXTENSION_VARIANT_TYPE_PACKED_FLOAT32_ARRAY: return 4;
    case GDEXTENSION_VARIANT_TYPE_PACKED_VECTOR3_ARRAY: return 3 * real;
    default: return 0;
    }
}

/* The functions of the interface */

static void string_new(GDExtensionUninitializedStringPtr to, const char *text)
{
    *(struct block **)to = block_new(text, (int64_t)strlen(text), 1);
}

static void string_name_new(GDExtensionUninitializedStringNamePtr to, const char *text,
                            GDExtensionBool is_static)
{
    (void)is_static;
    string_new(to, text);
}

static GDExtensionInt string_to_utf8(GDExtensionConstStringPtr string, char *text,
                                     GDExtensionInt most)
{
    const struct block *block = *(struct block *const *)string;
    if (text != NULL) {
        memcpy(text, block->bytes, (size_t)(block->count < most ? block->count : most));
    }
    return block->count;
}

static const char *text_of(GDExtensionConstStringPtr string)
{
    return (*(struct block *const *)string)->bytes;
}

static void destroy_text(GDExtensionTypePtr value)
{
    block_free(*(struct block **)value);
}

static void destroy_array(GDExtensionTypePtr value)
{
    block_free(((struct array *)value)->block);
}

static GDExtensionPtrDestructor get_destructor(GDExtensionVariantType type)
{
    return is_text(type) ? destroy_text : element(type) > 0 ? destroy_array : NULL;
}

static void construct_number(GDExtensionUninitializedTypePtr to,
                             const GDExtensionConstTypePtr *from)
{
    (void)from;
    memset(to, 0, sizeof(int64_t));
}

static void construct_text(GDExtensionUninitializedTypePtr to, const GDExtensionConstTypePtr *from)
{
    (void)from;
    string_new(to, "");
}

static void construct_array(GDExtensionUninitializedTypePtr to, const GDExtensionConstTypePtr *from)
{
    (void)from;
    memset(to, 0, sizeof(struct array));
}

static GDExtensionPtrConstructor get_constructor(GDExtensionVariantType type, int32_t number)
{
    if (number != 0) {
        stop("a constructor other than the first");
    }
    return is_text(type) ? construct_text : element(type) > 0 ? construct_array : construct_number;
}

/* Values to variants and back: a pair of functions for each type, since they are not told it */
#define CONVERSIONS(name, variant_type, member, copy)                                              \
    static void name##_to_variant(GDExtensionUninitializedVariantPtr to, GDExtensionTypePtr from)  \
    {                                                                                              \
        struct variant *variant = to;                                                              \
        variant->type = (int32_t)(variant_type);                                                   \
        memcpy(&variant->as, from, sizeof variant->as.member);                                     \
        copy(&variant->as);                                                                        \
    }                                                                                              \
    static void name##_of_variant(GDExtensionUninitializedTypePtr to, GDExtensionVariantPtr from)  \
    {                                                                                              \
        struct variant *variant = from;                                                            \
        if (variant->type == GDEXTENSION_VARIANT_TYPE_INT &&                                       \
            (variant_type) == GDEXTENSION_VARIANT_TYPE_FLOAT) {                                    \
            double number = (double)variant->as.integer;                                           \
            memcpy(to, &number, sizeof number);                                                    \
            return;                                                                                \
        }                                                                                          \
        memcpy(to, &variant->as, sizeof variant->as.member);                                       \
        copy(to);                                                                                  \
    }

static void copy_number(void *value)
{
    (void)value;
}

static void copy_text(void *value)
{
    *(struct block **)value = block_copy(*(struct block **)value);
}

static void copy_array(void *value)
{
    ((struct array *)value)->block = block_copy(((struct array *)value)->block);
}

CONVERSIONS(integer, GDEXTENSION_VARIANT_TYPE_INT, integer, copy_number)
CONVERSIONS(number, GDEXTENSION_VARIANT_TYPE_FLOAT, number, copy_number)
CONVERSIONS(string, GDEXTENSION_VARIANT_TYPE_STRING, string, copy_text)
CONVERSIONS(bytes, GDEXTENSION_VARIANT_TYPE_PACKED_BYTE_ARRAY, array, copy_array)
CONVERSIONS(ints, GDEXTENSION_VARIANT_TYPE_PACKED_INT32_ARRAY, array, copy_array)
CONVERSIONS(floats, GDEXTENSION_VARIANT_TYPE_PACKED_FLOAT32_ARRAY, array, copy_array)
CONVERSIONS(vectors, GDEXTENSION_VARIANT_TYPE_PACKED_VECTOR3_ARRAY, array, copy_array)

#define EACH_TYPE(X)                                                                               \
    X(GDEXTENSION_VARIANT_TYPE_INT, integer)                                                       \
    X(GDEXTENSION_VARIANT_TYPE_FLOAT, number)                                                      \
    X(GDEXTENSION_VARIANT_TYPE_STRING, string)                                                     \
    X(GDEXTENSION_VARIANT_TYPE_PACKED_BYTE_ARRAY, bytes)                                           \
    X(GDEXTENSION_VARIANT_TYPE_PACKED_INT32_ARRAY, ints)                                           \
    X(GDEXTENSION_VARIANT_TYPE_PACKED_FLOAT32_ARRAY, floats)                                       \
    X(GDEXTENSION_VARIANT_TYPE_PACKED_VECTOR3_ARRAY, vectors)

static GDExtensionVariantFromTypeConstructorFunc get_to_variant(GDExtensionVariantType type)
{
    switch ((int)type) {
#define TO_VARIANT(type, name)                                                                     \
    case type: return name##_to_variant;
        EACH_TYPE(TO_VARIANT)
    default: stop("no variant of this type"); return NULL;
    }
}

static GDExtensionTypeFromVariantConstructorFunc get_of_variant(GDExtensionVariantType type)
{
    switch ((int)type) {
#define OF_VARIANT(type, name)                                                                     \
    case type: return name##_of_variant;
        EACH_TYPE(OF_VARIANT)
    default: stop("no value of this type"); return NULL;
    }
}

static GDExtensionVariantType variant_type(GDExtensionConstVariantPtr variant)
{
    return (GDExtensionVariantType)((const struct variant *)variant)->type;
}

static void variant_destroy(GDExtensionVariantPtr value)
{
    struct variant *variant = value;
    GDExtensionPtrDestructor destructor = get_destructor(variant_type(variant));
    if (destructor != NULL) {
        destructor(&variant->as);
    }
    variant->type = GDEXTENSION_VARIANT_TYPE_NIL;
}

static void resize(struct array *array, int64_t count, size_t size, int64_t *result)
{
    *result = no_memory && count > 0 ? 6 : 0; /* ERR_OUT_OF_MEMORY */
    if (*result == 0) {
        struct block *old = array->block;
        array->block = count > 0 ? block_new(NULL, count, size) : NULL;
        if (old != NULL && count > 0) {
            memcpy(array->block->bytes, old->bytes,
                   size * (size_t)(old->count < count ? old->count : count));
        }
        block_free(old);
    }
}

#define RESIZE(name, type)                                                                         \
    static void resize_##name(GDExtensionTypePtr base, const GDExtensionConstTypePtr *argument,    \
                              GDExtensionTypePtr result, int count)                                \
    {                                                                                              \
        if (count != 1) {                                                                          \
            stop("resize takes one argument");                                                     \
        }                                                                                          \
        resize(base, *(const int64_t *)argument[0], element(type), result);                        \
    }
RESIZE(bytes, GDEXTENSION_VARIANT_TYPE_PACKED_BYTE_ARRAY)
RESIZE(words, GDEXTENSION_VARIANT_TYPE_PACKED_FLOAT32_ARRAY)
RESIZE(vectors, GDEXTENSION_VARIANT_TYPE_PACKED_VECTOR3_ARRAY)

static GDExtensionPtrBuiltInMethod
get_builtin(GDExtensionVariantType type, GDExtensionConstStringNamePtr name, GDExtensionInt hash)
{
    if (strcmp(text_of(name), "resize") != 0 || hash != 848867239) {
        return NULL;
    }
    size_t size = element(type);
    return size == 1 ? resize_bytes : size == 3 * real ? resize_vectors : resize_words;
}

static void *index_array(GDExtensionTypePtr value, GDExtensionInt index)
{
    const struct block *block = ((struct array *)value)->block;
    if (block == NULL || index < 0 || index >= block->count) {
        stop("an index behind the end of an array");
    }
    return block->bytes + (size_t)index * block->size;
}

static uint8_t *index_bytes(GDExtensionTypePtr value, GDExtensionInt index)
{
    return index_array(value, index);
}

static int32_t *index_ints(GDExtensionTypePtr value, GDExtensionInt index)
{
    return index_array(value, index);
}

static float *index_floats(GDExtensionTypePtr value, GDExtensionInt index)
{
    return index_array(value, index);
}

static void print_error(const char *text, const char *function, const char *file, int32_t line,
                        GDExtensionBool notify)
{
    (void)file, (void)line, (void)notify;
    errors++;
    snprintf(error, sizeof error, "%s: %s", function, text);
}

/* Classes and objects: there is one of each */

static struct {
    char name[64], parent[64];
    GDExtensionClassCreationInfo2 info;
    int methods;
    struct method {
        char name[64];
        GDExtensionClassMethodInfo info;
        GDExtensionVariantType result, arguments[MOST_ARGUMENTS];
    } method[MOST_METHODS];
} class;

static struct {
    char parent[64];
    GDExtensionClassInstancePtr instance;
} object;

static void register_class(GDExtensionClassLibraryPtr library, GDExtensionConstStringNamePtr name,
                           GDExtensionConstStringNamePtr parent,
                           const GDExtensionClassCreationInfo2 *info)
{
    CHECK(library == &class, "another library");
    snprintf(class.name, sizeof class.name, "%s", text_of(name));
    snprintf(class.parent, sizeof class.parent, "%s", text_of(parent));
    class.info = *info;
}

static void register_method(GDExtensionClassLibraryPtr library, GDExtensionConstStringNamePtr name,
                            const GDExtensionClassMethodInfo *info)
{
    struct method *method = &class.method[class.methods++];
    CHECK(library == &class && strcmp(text_of(name), class.name) == 0, "another class");
    snprintf(method->name, sizeof method->name, "%s", text_of(info->name));
    method->info = *info;
    method->result =
        info->has_return_value ? info->return_value_info->type : GDEXTENSION_VARIANT_TYPE_NIL;
    for (uint32_t i = 0; i < info->argument_count; i++) {
        method->arguments[i] = info->arguments_info[i].type;
        CHECK(*text_of(info->arguments_info[i].name) != 0, "%s: argument %u has no name",
              method->name, i);
        CHECK(info->arguments_metadata[i] == GDEXTENSION_METHOD_ARGUMENT_METADATA_NONE, "metadata");
    }
    for (uint32_t i = 0; i < info->default_argument_count; i++) {
        const struct variant *variant = info->default_arguments[i];
        CHECK(variant->type == GDEXTENSION_VARIANT_TYPE_STRING && *text_of(&variant->as) == 0,
              "%s: a default is no empty String", method->name);
    }
}

static void unregister_class(GDExtensionClassLibraryPtr library, GDExtensionConstStringNamePtr name)
{
    CHECK(library == &class && strcmp(text_of(name), class.name) == 0, "another class");
    class.methods = 0;
}

static GDExtensionObjectPtr construct_object(GDExtensionConstStringNamePtr name)
{
    snprintf(object.parent, sizeof object.parent, "%s", text_of(name));
    return &object;
}

static void set_instance(GDExtensionObjectPtr of, GDExtensionConstStringNamePtr name,
                         GDExtensionClassInstancePtr instance)
{
    CHECK(of == &object && strcmp(text_of(name), class.name) == 0, "another object");
    object.instance = instance;
}

/* By name; each function is compared with its type in the header. */
static int hidden = -1,
           asked; /* the function with this number is missing; how many were asked for */

static GDExtensionInterfaceFunctionPtr get_proc_address(const char *name)
{
    static const GDExtensionInterfaceClassdbConstructObject f0 = construct_object;
    static const GDExtensionInterfaceClassdbRegisterExtensionClass2 f1 = register_class;
    static const GDExtensionInterfaceClassdbRegisterExtensionClassMethod f2 = register_method;
    static const GDExtensionInterfaceClassdbUnregisterExtensionClass f3 = unregister_class;
    static const GDExtensionInterfaceGetVariantFromTypeConstructor f4 = get_to_variant;
    static const GDExtensionInterfaceGetVariantToTypeConstructor f5 = get_of_variant;
    static const GDExtensionInterfaceObjectSetInstance f6 = set_instance;
    static const GDExtensionInterfacePackedByteArrayOperatorIndex f7 = index_bytes;
    static const GDExtensionInterfacePackedFloat32ArrayOperatorIndex f8 = index_floats;
    static const GDExtensionInterfacePackedInt32ArrayOperatorIndex f9 = index_ints;
    static const GDExtensionInterfacePackedVector3ArrayOperatorIndex f10 = index_array;
    static const GDExtensionInterfacePrintError f11 = print_error;
    static const GDExtensionInterfaceStringNameNewWithLatin1Chars f12 = string_name_new;
    static const GDExtensionInterfaceStringNewWithUtf8Chars f13 = string_new;
    static const GDExtensionInterfaceStringToUtf8Chars f14 = string_to_utf8;
    static const GDExtensionInterfaceVariantDestroy f15 = variant_destroy;
    static const GDExtensionInterfaceVariantGetPtrBuiltinMethod f16 = get_builtin;
    static const GDExtensionInterfaceVariantGetPtrConstructor f17 = get_constructor;
    static const GDExtensionInterfaceVariantGetPtrDestructor f18 = get_destructor;
    static const GDExtensionInterfaceVariantGetType f19 = variant_type;
#define FUNCTION(name, f)                                                                          \
    {                                                                                              \
        name, (GDExtensionInterfaceFunctionPtr)(void (*)(void))f                                   \
    }
    const struct {
        const char *name;
        GDExtensionInterfaceFunctionPtr function;
    } table[] = {
        FUNCTION("classdb_construct_object", f0),
        FUNCTION("classdb_register_extension_class2", f1),
        FUNCTION("classdb_register_extension_class_method", f2),
        FUNCTION("classdb_unregister_extension_class", f3),
        FUNCTION("get_variant_from_type_constructor", f4),
        FUNCTION("get_variant_to_type_constructor", f5),
        FUNCTION("object_set_instance", f6),
        FUNCTION("packed_byte_array_operator_index", f7),
        FUNCTION("packed_float32_array_operator_index", f8),
        FUNCTION("packed_int32_array_operator_index", f9),
        FUNCTION("packed_vector3_array_operator_index", f10),
        FUNCTION("print_error", f11),
        FUNCTION("string_name_new_with_latin1_chars", f12),
        FUNCTION("string_new_with_utf8_chars", f13),
        FUNCTION("string_to_utf8_chars", f14),
        FUNCTION("variant_destroy", f15),
        FUNCTION("variant_get_ptr_builtin_method", f16),
        FUNCTION("variant_get_ptr_constructor", f17),
        FUNCTION("variant_get_ptr_destructor", f18),
        FUNCTION("variant_get_type", f19),
    };
    if (asked++ == hidden) {
        return NULL;
    }
    for (size_t i = 0; i < sizeof table / sizeof *table; i++) {
        if (strcmp(name, table[i].name) == 0) {
            return table[i].function;
        }
    }
    return NULL;
}

#endif
