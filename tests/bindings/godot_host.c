/* SPDX-License-Identifier: MIT
 *
 * The extension for Godot gives the bits of the library, clear errors, and leaves nothing behind.
 *
 *     godot_host EXTENSION GLSL_FILE
 *
 * EXTENSION is the shared library, which this program loads as Godot does (godot_engine.h),
 * GLSL_FILE scarp.glsl.
 */
#include "check.h"

#include <dlfcn.h>

#include "godot_engine.h"

static const char *const recipe_text = "recipe 1\n"
                                       "param height = 110 [0, 10000]\n"
                                       "bend = noise(size=286, octaves=3, amplitude=75)\n"
                                       "hills = warp(noise(size=200, octaves=5), bend)\n"
                                       "out ground = height * hills\n"
                                       "out mask = smoothstep(hills, -0.2, 0.3)\n";

/* Arguments and results */

static struct variant integer(int64_t value)
{
    return (struct variant){GDEXTENSION_VARIANT_TYPE_INT, {.integer = value}};
}

static struct variant number(double value)
{
    return (struct variant){GDEXTENSION_VARIANT_TYPE_FLOAT, {.number = value}};
}

static struct variant string(const char *text)
{
    struct variant variant = {GDEXTENSION_VARIANT_TYPE_STRING, {.string = NULL}};
    string_new(&variant.as, text);
    return variant;
}

static const struct method *find(const char *name)
{
    for (int i = 0; i < class.methods; i++) {
        if (strcmp(class.method[i].name, name) == 0) {
            return &class.method[i];
        }
    }
    stop(name);
    return NULL;
}

static int same(const struct variant *a, const struct variant *b)
{
    size_t size = element(variant_type(a));
    if (a->type != b->type) {
        return 0;
    }
    if (size == 0 && a->type != GDEXTENSION_VARIANT_TYPE_STRING) {
        return memcmp(&a->as, &b->as, sizeof a->as.number) == 0;
    }
    const struct block *x = size > 0 ? a->as.array.block : a->as.string;
    const struct block *y = size > 0 ? b->as.array.block : b->as.string;
    return x == y || (x != NULL && y != NULL && x->count == y->count &&
                      memcmp(x->bytes, y->bytes, (size_t)x->count * x->size) == 0);
}

/* The same call with typed arguments, which must give the same */
static void call_typed(const struct method *method, const struct variant *given,
                       const struct variant *result)
{
    GDExtensionConstTypePtr argument[MOST_ARGUMENTS];
    for (uint32_t i = 0; i < method->info.argument_count; i++) {
        argument[i] = &given[i].as;
    }
    struct variant again = {(int32_t)method->result, {.array = {NULL, NULL}}};
    int none = method->result == GDEXTENSION_VARIANT_TYPE_NIL;
    if (!none) {
        get_constructor(method->result, 0)(&again.as, NULL);
    }
    method->info.ptrcall_func(method->info.method_userdata, object.instance, argument,
                              none ? NULL : (void *)&again.as);
    CHECK(same(result, &again), "%s: typed arguments give something else", method->name);
    variant_destroy(&again);
}

/* Calls a method, and destroys the arguments. *status is NULL where the call must be accepted. */
static struct variant call_status(const char *name, GDExtensionCallError *status, int count,
                                  struct variant *given)
{
    const struct method *method = find(name);
    GDExtensionConstVariantPtr pointer[MOST_ARGUMENTS];
    int exact = count == (int)method->info.argument_count;
    for (int i = 0; i < count; i++) {
        pointer[i] = &given[i];
        exact = exact && given[i].type == (int32_t)method->arguments[i];
    }
    GDExtensionCallError own = {GDEXTENSION_CALL_OK, 0, 0};
    struct variant result = {GDEXTENSION_VARIANT_TYPE_NIL, {.integer = 0}};
    method->info.call_func(method->info.method_userdata, object.instance, pointer, count, &result,
                           status != NULL ? status : &own);
    if (status == NULL) {
        CHECK(own.error == GDEXTENSION_CALL_OK, "%s is refused: %d", name, (int)own.error);
        CHECK(result.type == (int32_t)method->result, "%s: type %d", name, (int)result.type);
        if (exact) {
            call_typed(method, given, &result);
        }
    }
    for (int i = 0; i < count; i++) {
        variant_destroy(&given[i]);
    }
    return result;
}

#define CALL(name, ...)                                                                            \
    call_status(name, NULL, (int)(sizeof(struct variant[]){__VA_ARGS__} / sizeof(struct variant)), \
                (struct variant[]){__VA_ARGS__})

/* What a method that returns a String says */
static const char *said(struct variant result)
{
    static char text[4096];
    snprintf(text, sizeof text, "%s",
             result.type == GDEXTENSION_VARIANT_TYPE_STRING ? text_of(&result.as) : "no String");
    variant_destroy(&result);
    return text;
}

static int64_t count_of(const struct variant *array)
{
    return array->as.array.block == NULL ? 0 : array->as.array.block->count;
}

static const void *data(const struct variant *array)
{
    return array->as.array.block == NULL ? NULL : array->as.array.block->bytes;
}

/* The result is an empty array, and this error was shown. */
static void check_refused(struct variant result, const char *message)
{
    CHECK(count_of(&result) == 0, "%lld elements", (long long)count_of(&result));
    CHECK(errors > 0 && strstr(error, message) != NULL, "%s, not %s", error, message);
    variant_destroy(&result);
    errors = 0;
    *error = 0;
}

/* The tests, in their order */

static void check_class(void)
{
    static const struct {
        const char *name;
        int arguments, optional;
    } methods[] = {
        {"parse", 1, 0},     {"set_seed", 1, 0}, {"set_param", 2, 0}, {"set_tile", 3, 0},
        {"set_scale", 2, 0}, {"range", 1, 1},    {"at", 3, 1},        {"grid", 6, 1},
        {"normals", 6, 1},   {"shader", 2, 0},   {"uniforms", 0, 0},  {"answers", 1, 0},
    };
    CHECK(strcmp(class.name, "ScarpRecipe") == 0, "%s", class.name);
    CHECK(strcmp(class.parent, "RefCounted") == 0, "%s", class.parent);
    CHECK(class.info.is_exposed && !class.info.is_abstract && !class.info.is_virtual, "flags");
    CHECK(class.methods == sizeof methods / sizeof *methods, "%d", class.methods);
    for (size_t i = 0; i < sizeof methods / sizeof *methods; i++) {
        const GDExtensionClassMethodInfo *info = &find(methods[i].name)->info;
        CHECK((int)info->argument_count == methods[i].arguments, "%s", methods[i].name);
        CHECK((int)info->default_argument_count == methods[i].optional, "%s", methods[i].name);
    }
}

/* Before there is a recipe, all methods say so. */
static void check_nothing(void)
{
    const char *none = "there is no recipe: call parse first";
    check_refused(CALL("grid", integer(4), integer(4), number(0), number(0), number(1)), none);
    check_refused(CALL("normals", integer(4), integer(4), number(0), number(0), number(1)), none);
    check_refused(CALL("range", string("")), none);
    check_refused(CALL("answers", integer(0)), none);
    check_refused(call_status("uniforms", NULL, 0, NULL), none);
    CHECK(strcmp(said(CALL("shader", string(""), integer(0))), "") == 0 && errors > 0, "shader");
    CHECK(strcmp(said(CALL("set_param", string("height"), number(1))), none) == 0, "set_param");
    CHECK(strcmp(said(CALL("set_tile", number(8), number(8), number(0))), none) == 0, "set_tile");
    CHECK(strcmp(said(CALL("set_scale", number(2), number(2))), none) == 0, "set_scale");
    struct variant value = CALL("at", number(0), number(0));
    CHECK(isnan(value.as.number), "at gives %g", value.as.number);
    errors = 0;
}

static void check_texts(void)
{
    CHECK(strcmp(said(CALL("parse", string(recipe_text))), "") == 0, "a good text");
    const char *text = said(CALL("parse", string("recipe 1\nout a = noise(size=100, octaves=99)")));
    CHECK(strcmp(text, "line 2, column 33: octaves: outside (0, 32]") == 0, "%s", text);
    text = said(CALL("parse", string("recipe 1\nout a = nois(1)\nout b = 2 + \xC3\xA9\n")));
    CHECK(strstr(text, "line 2, column 9: ") == text, "%s", text);
    CHECK(strstr(text, "\nline 3, column 13: ") != NULL, "%s", text);
    CHECK(strcmp(said(CALL("parse", string(""))), "") != 0, "an empty text has no error");

    char *wrong = malloc(17000);
    memset(wrong, ' ', 16999);
    wrong[16999] = 0;
    text = said(CALL("parse", string(wrong)));
    CHECK(strcmp(text, "the text has 16999 bytes; at most 16384 can be read") == 0, "%s", text);
    strcpy(wrong, "recipe 1\n");
    for (int i = 0; i < 12; i++) {
        strcat(wrong, "out a = 1 +\n");
    }
    text = said(CALL("parse", string(wrong)));
    CHECK(strstr(text, "\nand 4 more") != NULL, "%s", text);
    free(wrong);
    CHECK(errors == 0, "%s", error); /* texts come back, they are not shown */
}

static void check_refusals(void)
{
    const char *sizes = "both must be at least 1";
    const int64_t bad[][2] = {{0, 4},         {4, 0},         {-1, 4},
                              {4, INT64_MIN}, {INT64_MAX, 2}, {1 << 14, 1 << 15}};
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++) {
        for (int j = 0; j < 2; j++) {
            check_refused(CALL(j ? "normals" : "grid", integer(bad[i][0]), integer(bad[i][1]),
                               number(0), number(0), number(1)),
                          sizes);
        }
    }
    check_refused(CALL("grid", integer(4), integer(4), number(NAN), number(0), number(1)),
                  "x, z and step must be finite");
    check_refused(CALL("grid", integer(4), integer(4), number(0), number(0), number(INFINITY)),
                  "x, z and step must be finite");
    check_refused(
        CALL("grid", integer(4), integer(4), number(0), number(0), number(1), string("sea")),
        "the recipe has no output sea");
    check_refused(CALL("range", string("height")), "the recipe has no output height");
    check_refused(CALL("answers", integer(3)), "answers: ");
    CHECK(strcmp(said(CALL("shader", string("no shader"), integer(0))), "") == 0, "shader");
    no_memory = 1;
    check_refused(CALL("grid", integer(4), integer(4), number(0), number(0), number(1)),
                  "no memory");
    check_refused(CALL("normals", integer(4), integer(4), number(0), number(0), number(1)),
                  "no memory");
    no_memory = 0;
    const char *text = said(CALL("set_param", string("height"), number(-1)));
    CHECK(strstr(text, "height = -1: ") == text, "%s", text);
    text = said(CALL("set_param", string("depth"), number(1)));
    CHECK(strstr(text, "depth = 1: ") == text, "%s", text);
    text = said(CALL("set_scale", number(0), number(1)));
    CHECK(strcmp(text, "scale 0, 1: factors are from 2^-40 to 2^40") == 0, "%s", text);
    text = said(CALL("set_tile", number(-1), number(1), number(0)));
    CHECK(strcmp(text, "tile -1, 1: no lengths of a tile") == 0, "%s", text);
    text = said(CALL("set_tile", number(500), number(500), number(0)));
    CHECK(strstr(text, "tile 500, 500: ") == text && strstr(text, " would do") != NULL, "%s", text);
    errors = 0;

    GDExtensionCallError status = {GDEXTENSION_CALL_OK, 0, 0};
    call_status("parse", &status, 1, (struct variant[]){integer(1)});
    CHECK(status.error == GDEXTENSION_CALL_ERROR_INVALID_ARGUMENT && status.argument == 0 &&
              status.expected == GDEXTENSION_VARIANT_TYPE_STRING,
          "%d", (int)status.error);
    call_status("parse", &status, 0, NULL);
    CHECK(status.error == GDEXTENSION_CALL_ERROR_TOO_FEW_ARGUMENTS && status.expected == 1, "%d",
          (int)status.error);
    call_status("uniforms", &status, 1, (struct variant[]){integer(1)});
    CHECK(status.error == GDEXTENSION_CALL_ERROR_TOO_MANY_ARGUMENTS && status.expected == 0, "%d",
          (int)status.error);
    call_status("set_seed", &status, 1, (struct variant[]){number(1)});
    CHECK(status.error == GDEXTENSION_CALL_ERROR_INVALID_ARGUMENT, "a seed of 1.0");
}

/* Rasters, one of them higher than a band of normals, against the library */
static void check_raster(const struct scarp_recipe *recipe, int width, int height, int which)
{
    size_t count = (size_t)width * (size_t)height;
    float *expected = malloc(6 * count * sizeof(float));
    float *dx = expected + count, *dy = dx + count, *n = dy + count;
    struct scarp_grid grid = {
        .origin = {-1e7, 31.25}, .step = {0.3, 0.3}, .count = {(size_t)width, (size_t)height, 1}};
    struct scarp_samples out[2] = {{.value = NULL}};
    out[which] = (struct scarp_samples){.value = expected, .dx = dx, .dy = dy};
    struct scarp_recipe_outputs outputs = {.out = out, .count = which + 1};
    CHECK(scarp_recipe_grid(recipe, &grid, &outputs, NULL) == SCARP_OK, "grid");
    scarp_normals(count, dx, dy, 1.0f, n, n + count, n + 2 * count);

    const char *name = which == 0 ? "" : "mask";
    struct variant heights = CALL("grid", integer(width), integer(height), number(-1e7),
                                  number(31.25), number(0.3), string(name));
    CHECK(count_of(&heights) == (int64_t)count, "%lld heights", (long long)count_of(&heights));
    CHECK(memcmp(data(&heights), expected, count * sizeof(float)) == 0, "heights differ");
    struct variant vectors = CALL("normals", integer(width), integer(height), number(-1e7),
                                  number(31.25), number(0.3), string(name));
    CHECK(count_of(&vectors) == (int64_t)count, "%lld normals", (long long)count_of(&vectors));
    for (size_t i = 0; i < count; i++) {
        const float axes[3] = {n[i], n[i + 2 * count], n[i + count]}; /* y is up */
        const double wide[3] = {(double)axes[0], (double)axes[1], (double)axes[2]};
        const char *at = (const char *)data(&vectors) + 3 * real * i;
        int equal =
            real == 4 ? memcmp(at, axes, sizeof axes) == 0 : memcmp(at, wide, sizeof wide) == 0;
        CHECK(equal, "normal %zu differs", i);
    }
    struct variant value =
        CALL("at", number(-1e7 + 0.3 * (width - 1)), number(31.25), string(name));
    CHECK((float)value.as.number == expected[width - 1], "%.9g at the end of a row",
          value.as.number);
    variant_destroy(&heights);
    variant_destroy(&vectors);
    free(expected);
}

static void check_shader(const struct scarp_recipe *recipe)
{
    const char *file = "// a shader that lacks everything";
    (void)recipe;
    CHECK(strcmp(said(CALL("shader", string(file), integer(0))), "") == 0, "no scarp.glsl");

    static uint32_t bytes[16384 / 4], answer[SCARP_GPU_ANSWERS];
    size_t size = 0;
    CHECK(scarp_recipe_uniforms(recipe, bytes, sizeof bytes, &size) == SCARP_OK, "uniforms");
    struct variant given = call_status("uniforms", NULL, 0, NULL);
    CHECK(count_of(&given) == (int64_t)size && memcmp(data(&given), bytes, size) == 0, "uniforms");
    variant_destroy(&given);
    CHECK(scarp_recipe_answers(recipe, 1, answer) == SCARP_OK, "answers");
    given = CALL("answers", integer(1));
    CHECK(count_of(&given) == SCARP_GPU_ANSWERS && memcmp(data(&given), answer, sizeof answer) == 0,
          "answers");
    variant_destroy(&given);
}

/* The text of the shader, of scarp.glsl */
static void check_shader_text(const struct scarp_recipe *recipe, const char *path)
{
    FILE *stream = fopen(path, "rb");
    if (stream == NULL) {
        stop(path);
    }
    char *file = calloc(1, 1 << 20), *text = calloc(1, 1 << 20);
    size_t length = fread(file, 1, (1 << 20) - 1, stream), size = 0;
    fclose(stream);
    struct scarp_shader how = {.language = SCARP_GLSL, .order = 1, .file = file, .length = length};
    CHECK(scarp_recipe_shader(recipe, &how, text, 1 << 20, &size) == SCARP_OK, "shader");
    struct variant given = CALL("shader", string(file), integer(1));
    CHECK(size > 1000 && strcmp(text_of(&given.as), text) == 0, "the text of the shader differs");
    variant_destroy(&given);
    free(file);
    free(text);
}

/* Tile and scale are those of the library; a new text has neither. */
static void check_changes(void)
{
    const char *text = "recipe 1\nout a = noise(size=8)\nout mask = noise(size=4)\n";
    const char *space = "recipe 1\nspace 3\nout a = noise(size=8)\nout mask = z + 2\n";
    struct scarp_recipe *recipe = malloc(sizeof *recipe);
    for (int is_space = 0; is_space < 2; is_space++) {
        const char *of = is_space ? space : text;
        CHECK(scarp_recipe_parse(of, strlen(of), recipe, NULL, 0, NULL) == SCARP_OK, "parse");
        CHECK(strcmp(said(CALL("parse", string(of))), "") == 0, "parse");
        scarp_recipe_seed(recipe, (uint64_t)-5);
        check_raster(recipe, 9, 7, 0);
        CHECK(scarp_recipe_scale(recipe, 2, 3, NULL) == SCARP_OK, "scale");
        CHECK(strcmp(said(CALL("set_scale", number(2), number(3))), "") == 0, "set_scale");
        check_raster(recipe, 9, 7, 0);
        if (is_space) { /* z does not repeat */
            const char *refused = said(CALL("set_tile", number(16), number(16), number(16)));
            CHECK(strstr(refused, "tile 16, 16: ") == refused, "%s", refused);
            CHECK(strcmp(said(CALL("set_tile", number(0), number(0), number(0))), "") == 0, "0");
        } else {
            CHECK(scarp_recipe_tile(recipe, 32, 48, 0, NULL) == SCARP_OK, "tile");
            CHECK(strcmp(said(CALL("set_tile", number(32), number(48), number(0))), "") == 0,
                  "set_tile");
        }
        check_raster(recipe, 9, 7, 0);
    }
    free(recipe);
}

/* Adds "NAME = NOISE + NOISE ..." with six noises, from number `first` on, each followed by `what`. */
static void add_sum(char *text, const char *name, int first, const char *what)
{
    sprintf(text + strlen(text), "%s%d = ", name, first);
    for (int i = first; i < first + 6; i++) {
        sprintf(text + strlen(text), "n%d%s%s", i, what, i < first + 5 ? " + " : "\n");
    }
}

/* A recipe that holds more than the stack has room for: 30 noises, for gullies with Hessians */
static void check_large(void)
{
    char text[4096] = "recipe 1\n";
    for (int i = 0; i < 30; i++) {
        sprintf(text + strlen(text), "n%d = noise(size=30, seed=%d)\n", i, i);
    }
    for (int i = 0; i < 30; i += 6) {
        add_sum(text, "s", i, "");
    }
    strcat(text, "s = s0 + s6 + s12 + s18 + s24\n");
    for (int i = 0; i < 30; i += 6) {
        add_sum(text, "p", i, " * s");
    }
    strcat(text, "out a = gullies(p0 + p6 + p12 + p18 + p24, size=9)\n");
    CHECK(strcmp(said(CALL("parse", string(text))), "") == 0, "parse");
    struct variant point = CALL("at", number(7), number(8));
    struct variant heights = CALL("grid", integer(1), integer(1), number(7), number(8), number(1));
    CHECK(count_of(&heights) == 1 && (double)*(const float *)data(&heights) == point.as.number,
          "at gives %g", point.as.number);
    variant_destroy(&heights);
}

static void check_values(const char *shader)
{
    struct scarp_recipe *recipe = malloc(sizeof *recipe);
    CHECK(scarp_recipe_parse(recipe_text, strlen(recipe_text), recipe, NULL, 0, NULL) == SCARP_OK,
          "the recipe");
    check_raster(recipe, 37, 21, 0);
    scarp_recipe_seed(recipe, (uint64_t)-5);
    CALL("set_seed", integer(-5));
    check_raster(recipe, 1, 1, 0);
    scarp_recipe_set(recipe, "height", 250.5, NULL);
    CHECK(strcmp(said(CALL("set_param", string("height"), number(250.5))), "") == 0, "height");
    check_raster(recipe, 257, 300, 0);
    check_raster(recipe, 65, 3, 1);
    check_shader(recipe);
    check_shader_text(recipe, shader);

    float ends[2];
    struct variant interval = CALL("range", string(""));
    scarp_recipe_range(recipe, SCARP_RECIPE_OUTPUT, NULL, &ends[0], &ends[1]);
    CHECK(count_of(&interval) == 2 && memcmp(data(&interval), ends, sizeof ends) == 0, "range");
    variant_destroy(&interval);

    /* Another text has its own parameters, and the seed stays. */
    CHECK(strcmp(said(CALL("parse", string(recipe_text))), "") == 0, "again");
    scarp_recipe_set(recipe, "height", 110, NULL);
    errors = 0;
    check_raster(recipe, 9, 9, 0);
    CHECK(errors == 0, "%s", error);
    /* Integers are numbers, and a StringName is a String. */
    struct variant name = string("mask");
    name.type = GDEXTENSION_VARIANT_TYPE_STRING_NAME;
    struct variant heights =
        CALL("grid", integer(3), integer(3), integer(7), integer(8), integer(2), name);
    CHECK(count_of(&heights) == 9, "integers");
    variant_destroy(&heights);
    free(recipe);
}

static void run(GDExtensionInitializationFunction entry, const char *shader)
{
    GDExtensionInitialization start;
    hidden = -1;
    CHECK(entry(get_proc_address, &class, &start), "the entry point refuses: %s", error);
    for (int level = 0; level < GDEXTENSION_MAX_INITIALIZATION_LEVEL; level++) {
        start.initialize(start.userdata, (GDExtensionInitializationLevel)level);
    }
    check_class();
    CHECK(class.info.create_instance_func(class.info.class_userdata) == &object, "another object");
    CHECK(strcmp(object.parent, class.parent) == 0, "the object is a %s", object.parent);
    check_nothing();
    check_texts();
    check_refusals();
    check_values(shader);
    check_changes();
    check_large();
    class.info.free_instance_func(class.info.class_userdata, object.instance);
    for (int level = GDEXTENSION_MAX_INITIALIZATION_LEVEL - 1; level >= 0; level--) {
        start.deinitialize(start.userdata, (GDExtensionInitializationLevel)level);
    }
    CHECK(class.methods == 0, "the class stays");
    CHECK(live == 0, "%ld values stay", live);
}

int main(int argc, char **argv)
{
    if (argc != 3) {
        stop("godot_host EXTENSION GLSL_FILE");
    }
    void *extension = dlopen(argv[1], RTLD_NOW | RTLD_LOCAL);
    if (extension == NULL) {
        stop(dlerror());
    }
    GDExtensionInitializationFunction entry;
    *(void **)&entry = dlsym(extension, "scarp_godot_init");
    if (entry == NULL) {
        stop("no entry point");
    }
    /* A Godot that lacks a function is refused, whichever it is. */
    GDExtensionInitialization start;
    for (hidden = 0; hidden < 20; hidden++) {
        asked = 0;
        errors = 0;
        CHECK(!entry(get_proc_address, &class, &start), "function %d is not needed", hidden);
        CHECK(asked == 20, "%d functions", asked);
        CHECK(strstr(error, "scarp needs Godot 4.2 or later") != NULL || errors == 0, "%s", error);
    }
    errors = 0;
    run(entry, argv[2]);
    real = 8; /* Godot with precision=double */
    run(entry, argv[2]);
    return check_done();
}
