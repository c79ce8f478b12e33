/* SPDX-License-Identifier: MIT
 *
 * The class ScarpRecipe for Godot 4.2 and later: the entry point, the registration, and how calls
 * come in. What methods do is in recipe.c.
 */
#include "engine.h"
#include "recipe.h"

#if defined(_WIN32)
#define EXPORTED __declspec(dllexport)
#else
#define EXPORTED __attribute__((visibility("default")))
#endif

#define CLASS "ScarpRecipe"
#define PARENT "RefCounted"

/* Of Godot's extension_api.json: PROPERTY_USAGE_DEFAULT; the size of a Variant, 24 bytes, or 40 with
   precision=double */
#define USAGE_DEFAULT 6
#define VARIANT_DOUBLES 5

/* A StringName is one pointer. That of the class lives as long as the class is registered. */
typedef void *string_name;
static string_name class_name;

/* Instances */

static GDExtensionObjectPtr create_instance(void *userdata)
{
    (void)userdata;
    void *self = recipe_new();
    if (self == NULL) {
        godot_error("new", "no memory");
        return NULL;
    }
    string_name parent;
    godot_name(&parent, PARENT);
    GDExtensionObjectPtr object = godot.classdb_construct_object(&parent);
    godot_destroy(GDEXTENSION_VARIANT_TYPE_STRING_NAME, &parent);
    godot.object_set_instance(object, &class_name, self);
    return object;
}

static void free_instance(void *userdata, GDExtensionClassInstancePtr self)
{
    (void)userdata;
    recipe_free(self);
}

/* Calls with typed arguments, and those with variants */

static void call_typed(void *method, GDExtensionClassInstancePtr self,
                       const GDExtensionConstTypePtr *argument, GDExtensionTypePtr result)
{
    ((const struct godot_method *)method)->body(self, argument, result);
}

/* Whether the variants are what the method takes; if not, *error says why. */
static int check_variants(const struct godot_method *method,
                          const GDExtensionConstVariantPtr *given, GDExtensionInt count,
                          GDExtensionCallError *error)
{
    error->error = GDEXTENSION_CALL_OK;
    if (count > method->count) {
        error->error = GDEXTENSION_CALL_ERROR_TOO_MANY_ARGUMENTS;
        error->expected = method->count;
    } else if (count < method->count - method->optional) {
        error->error = GDEXTENSION_CALL_ERROR_TOO_FEW_ARGUMENTS;
        error->expected = method->count - method->optional;
    }
    for (int i = 0; error->error == GDEXTENSION_CALL_OK && i < count; i++) {
        GDExtensionVariantType type = godot.variant_get_type(given[i]);
        GDExtensionVariantType wanted = method->argument[i].type;
        int converts =
            (type == GDEXTENSION_VARIANT_TYPE_INT && wanted == GDEXTENSION_VARIANT_TYPE_FLOAT) ||
            (type == GDEXTENSION_VARIANT_TYPE_STRING_NAME &&
             wanted == GDEXTENSION_VARIANT_TYPE_STRING);
        if (type != wanted && !converts) {
            error->error = GDEXTENSION_CALL_ERROR_INVALID_ARGUMENT;
            error->argument = i;
            error->expected = (int32_t)wanted;
        }
    }
    return error->error == GDEXTENSION_CALL_OK;
}

static void call_variants(void *userdata, GDExtensionClassInstancePtr self,
                          const GDExtensionConstVariantPtr *given, GDExtensionInt count,
                          GDExtensionVariantPtr result, GDExtensionCallError *error)
{
    const struct godot_method *method = userdata;
    if (!check_variants(method, given, count, error)) {
        return;
    }
    union {
        int64_t integer;
        double number;
        void *two[2]; /* a packed array, which is the largest; a String has one */
    } value[GODOT_ARGUMENTS], answer;
    GDExtensionConstTypePtr argument[GODOT_ARGUMENTS];
    for (int i = 0; i < method->count; i++) {
        argument[i] = &value[i];
        if (i < count) {
            GDExtensionVariantPtr variant = (GDExtensionVariantPtr)given[i]; /* only read */
            godot.get_variant_to_type_constructor(method->argument[i].type)(&value[i], variant);
        } else {
            godot.string_new_with_utf8_chars(&value[i], "");
        }
    }
    if (method->result == GDEXTENSION_VARIANT_TYPE_NIL) {
        method->body(self, argument, NULL);
    } else {
        godot.variant_get_ptr_constructor(method->result, 0)(&answer, NULL);
        method->body(self, argument, &answer);
        godot.variant_destroy(result);
        godot.get_variant_from_type_constructor(method->result)(result, &answer);
        godot_destroy(method->result, &answer);
    }
    for (int i = 0; i < method->count; i++) {
        godot_destroy(method->argument[i].type, &value[i]);
    }
}

/* Registration */

static void register_method(GDExtensionClassLibraryPtr library, const struct godot_method *method)
{
    string_name empty, name, names[GODOT_ARGUMENTS];
    void *hint;
    godot_name(&empty, "");
    godot_name(&name, method->name);
    godot.string_new_with_utf8_chars(&hint, "");
    GDExtensionPropertyInfo result = {method->result, &empty, &empty, 0, &hint, USAGE_DEFAULT};
    GDExtensionPropertyInfo arguments[GODOT_ARGUMENTS];
    GDExtensionClassMethodArgumentMetadata metadata[GODOT_ARGUMENTS] = {
        GDEXTENSION_METHOD_ARGUMENT_METADATA_NONE};
    for (int i = 0; i < method->count; i++) {
        godot_name(&names[i], method->argument[i].name);
        arguments[i] = result;
        arguments[i].type = method->argument[i].type;
        arguments[i].name = &names[i];
    }
    double storage[VARIANT_DOUBLES]; /* the variant of an empty String */
    godot.get_variant_from_type_constructor(GDEXTENSION_VARIANT_TYPE_STRING)(storage, &hint);
    GDExtensionVariantPtr defaults[GODOT_ARGUMENTS];
    for (int i = 0; i < method->optional; i++) {
        defaults[i] = storage;
    }

    GDExtensionClassMethodInfo info = {
        .name = &name,
        .method_userdata = (void *)method,
        .call_func = call_variants,
        .ptrcall_func = call_typed,
        .method_flags = method->flags,
        .has_return_value = method->result != GDEXTENSION_VARIANT_TYPE_NIL,
        .return_value_info = &result,
        .return_value_metadata = GDEXTENSION_METHOD_ARGUMENT_METADATA_NONE,
        .argument_count = (uint32_t)method->count,
        .arguments_info = arguments,
        .arguments_metadata = metadata,
        .default_argument_count = (uint32_t)method->optional,
        .default_arguments = defaults,
    };
    godot.classdb_register_extension_class_method(library, &class_name, &info);

    godot.variant_destroy(storage);
    for (int i = 0; i < method->count; i++) {
        godot_destroy(GDEXTENSION_VARIANT_TYPE_STRING_NAME, &names[i]);
    }
    godot_destroy(GDEXTENSION_VARIANT_TYPE_STRING, &hint);
    godot_destroy(GDEXTENSION_VARIANT_TYPE_STRING_NAME, &name);
    godot_destroy(GDEXTENSION_VARIANT_TYPE_STRING_NAME, &empty);
}

static void initialize(void *library, GDExtensionInitializationLevel level)
{
    if (level != GDEXTENSION_INITIALIZATION_SCENE) {
        return;
    }
    GDExtensionClassCreationInfo2 info = {
        .is_exposed = 1,
        .create_instance_func = create_instance,
        .free_instance_func = free_instance,
    };
    string_name parent;
    godot_name(&parent, PARENT);
    godot_name(&class_name, CLASS);
    godot.classdb_register_extension_class2(library, &class_name, &parent, &info);
    godot_destroy(GDEXTENSION_VARIANT_TYPE_STRING_NAME, &parent);
    for (size_t i = 0; i < recipe_method_count; i++) {
        register_method(library, &recipe_methods[i]);
    }
}

static void deinitialize(void *library, GDExtensionInitializationLevel level)
{
    if (level == GDEXTENSION_INITIALIZATION_SCENE) {
        godot.classdb_unregister_extension_class(library, &class_name);
        godot_destroy(GDEXTENSION_VARIANT_TYPE_STRING_NAME, &class_name);
    }
}

/* The entry point, which scarp.gdextension names. Returns 0 if this Godot lacks a function. */
EXPORTED GDExtensionBool scarp_godot_init(GDExtensionInterfaceGetProcAddress get,
                                          GDExtensionClassLibraryPtr library,
                                          GDExtensionInitialization *initialization);

GDExtensionBool scarp_godot_init(GDExtensionInterfaceGetProcAddress get,
                                 GDExtensionClassLibraryPtr library,
                                 GDExtensionInitialization *initialization)
{
    const char *missing = godot_load(get);
    if (missing != NULL) {
        if (godot.print_error != NULL) {
            godot_error("scarp_godot_init", "scarp needs Godot 4.2 or later: there is no %s",
                        missing);
        }
        return 0;
    }
    initialization->minimum_initialization_level = GDEXTENSION_INITIALIZATION_SCENE;
    initialization->userdata = library;
    initialization->initialize = initialize;
    initialization->deinitialize = deinitialize;
    return 1;
}
