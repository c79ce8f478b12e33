/* SPDX-License-Identifier: MIT
 *
 * The methods of ScarpRecipe: a recipe of scarp as Godot's heights, normals and shaders.
 *
 * Axes are Godot's: the plane of the recipe, x and y, is the ground, x and z; heights are along y.
 * A recipe in space gives its slice at 0.
 */
#include "recipe.h"

#include "engine.h"

#include <math.h>
#include <scarp.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define MOST_SAMPLES (INT64_C(1) << 28) /* as many as an Image of Godot has pixels */
#define MOST_BYTES 16384                /* of a text: see scarp_recipe_parse */
#define BAND 65536                      /* samples whose gradients are in memory at a time */
#define ERRORS 8                        /* that are told one by one */

#define BYTES GDEXTENSION_VARIANT_TYPE_PACKED_BYTE_ARRAY
#define FLOAT GDEXTENSION_VARIANT_TYPE_FLOAT
#define FLOATS GDEXTENSION_VARIANT_TYPE_PACKED_FLOAT32_ARRAY
#define INT GDEXTENSION_VARIANT_TYPE_INT
#define INTS GDEXTENSION_VARIANT_TYPE_PACKED_INT32_ARRAY
#define NONE GDEXTENSION_VARIANT_TYPE_NIL
#define STRING GDEXTENSION_VARIANT_TYPE_STRING
#define VECTORS GDEXTENSION_VARIANT_TYPE_PACKED_VECTOR3_ARRAY

struct self {
    uint64_t seed;
    char *text;                  /* what the recipe was made of; NULL: there is none */
    struct scarp_recipe *recipe; /* NULL until a text without an error was parsed */
    void *plan;                  /* what calls take of it; without memory they take longer */
};

typedef const GDExtensionConstTypePtr *arguments;

void *recipe_new(void)
{
    return calloc(1, sizeof(struct self));
}

void recipe_free(void *instance)
{
    struct self *self = instance;
    free(self->text);
    free(self->recipe);
    free(self->plan);
    free(self);
}

/* To be called whenever the recipe has changed */
static void make_plan(struct self *self)
{
    size_t size = scarp_recipe_plan_size(self->recipe);
    free(self->plan);
    self->plan = malloc(size);
    if (self->plan != NULL && scarp_recipe_plan_make(self->recipe, self->plan, size) != SCARP_OK) {
        free(self->plan);
        self->plan = NULL;
    }
}

static int64_t integer(GDExtensionConstTypePtr argument)
{
    return *(const int64_t *)argument;
}

static double number(GDExtensionConstTypePtr argument)
{
    return *(const double *)argument;
}

/* Texts and their errors */

struct message {
    char text[4096];
    size_t length;
};

static void add(struct message *message, const char *text, ...)
{
    size_t room = sizeof message->text - message->length;
    va_list list;
    va_start(list, text);
    int length = vsnprintf(message->text + message->length, room, text, list);
    va_end(list);
    if (length > 0) {
        message->length += (size_t)length < room ? (size_t)length : room - 1;
    }
}

static void add_error(struct message *message, const struct scarp_recipe_error *error)
{
    if (error->member != NULL) {
        add(message, "%s: ", error->member);
    }
    add(message, "%s", error->text);
    if (error->nearest != 0) {
        add(message, "; %.9g would do", error->nearest);
    }
}

static void parse(void *instance, arguments argument, GDExtensionTypePtr result)
{
    struct self *self = instance;
    struct message message = {.length = 0};
    struct scarp_recipe_error errors[ERRORS];
    size_t length = 0, found = 0;
    char *text = godot_text(argument[0], &length);
    struct scarp_recipe *recipe = malloc(sizeof *recipe);
    if (text == NULL || recipe == NULL) {
        add(&message, "no memory");
    } else if (length > MOST_BYTES) {
        add(&message, "the text has %zu bytes; at most %d can be read", length, MOST_BYTES);
    } else if (scarp_recipe_parse(text, length, recipe, errors, ERRORS, &found) == SCARP_OK) {
        scarp_recipe_seed(recipe, self->seed);
        char *old_text = self->text;
        struct scarp_recipe *old = self->recipe;
        self->text = text, self->recipe = recipe;
        text = old_text, recipe = old;
        make_plan(self);
    }
    for (size_t i = 0; i < found && i < ERRORS; i++) {
        add(&message, "%sline %d, column %d: ", i > 0 ? "\n" : "", (int)errors[i].line,
            (int)errors[i].column); /* in bytes; all before an error are ASCII */
        add_error(&message, &errors[i]);
    }
    if (found > ERRORS) {
        add(&message, "\nand %zu more", found - ERRORS);
    }
    free(text);
    free(recipe);
    godot_set_text(result, message.text);
}

static void set_seed(void *instance, arguments argument, GDExtensionTypePtr result)
{
    struct self *self = instance;
    (void)result;
    self->seed = (uint64_t)integer(argument[0]);
    if (self->recipe != NULL) {
        scarp_recipe_seed(self->recipe, self->seed);
        make_plan(self);
    }
}

/* The result of a call that changes the recipe: "", or `what` was to be and why it is not */
static void tell_change(GDExtensionTypePtr result, struct self *self, enum scarp_status status,
                        const struct scarp_recipe_error *error, const char *otherwise,
                        const char *what, ...)
{
    struct message message = {.length = 0};
    if (self->recipe == NULL) {
        add(&message, "there is no recipe: call parse first");
    } else if (status != SCARP_OK) {
        va_list list;
        va_start(list, what);
        int length = vsnprintf(message.text, sizeof message.text, what, list);
        va_end(list);
        message.length = length > 0 ? (size_t)length : 0;
        if (error->text != NULL) {
            add_error(&message, error);
        } else {
            add(&message, "%s", otherwise);
        }
    } else {
        make_plan(self);
    }
    godot_set_text(result, message.text);
}

static void set_param(void *instance, arguments argument, GDExtensionTypePtr result)
{
    struct self *self = instance;
    struct scarp_recipe_error error = {.text = NULL};
    size_t length = 0;
    char *name = godot_text(argument[0], &length);
    double value = number(argument[1]);
    enum scarp_status status = scarp_recipe_set(self->recipe, name, value, &error);
    tell_change(result, self, status, &error,
                name == NULL ? "no memory" : "no parameter of this name takes this value",
                "%.100s = %.9g: ", name != NULL ? name : "", value);
    free(name);
}

static void set_tile(void *instance, arguments argument, GDExtensionTypePtr result)
{
    struct self *self = instance;
    struct scarp_recipe_error error = {.text = NULL};
    double x = number(argument[0]), z = number(argument[1]), y = number(argument[2]);
    enum scarp_status status = scarp_recipe_tile(self->recipe, x, z, y, &error);
    tell_change(result, self, status, &error, "no lengths of a tile", "tile %.9g, %.9g: ", x, z);
}

static void set_scale(void *instance, arguments argument, GDExtensionTypePtr result)
{
    struct self *self = instance;
    struct scarp_recipe_error error = {.text = NULL};
    double by = number(argument[0]), heights = number(argument[1]);
    enum scarp_status status = scarp_recipe_scale(self->recipe, by, heights, &error);
    tell_change(result, self, status, &error, "factors are from 2^-40 to 2^40",
                "scale %.9g, %.9g: ", by, heights);
}

/* What is sampled */

/* The number of the statement with this name, or of the first output; -1 after an error */
static int32_t choose(const char *method, const struct self *self, GDExtensionConstTypePtr argument)
{
    if (self->recipe == NULL) {
        godot_error(method, "there is no recipe: call parse first");
        return -1;
    }
    size_t length = 0;
    char *name = godot_text(argument, &length);
    struct scarp_recipe_entry entry;
    int32_t found = -1;
    for (int32_t i = 0; name != NULL && found < 0 &&
                        scarp_recipe_entry_at(self->recipe, (size_t)i, &entry) == SCARP_OK;
         i++) {
        size_t bytes = entry.name[1] - entry.name[0];
        int same = length == 0
                       ? entry.output == 0
                       : length == bytes && memcmp(name, self->text + entry.name[0], bytes) == 0;
        int sampled = entry.kind == SCARP_RECIPE_FIELD || entry.kind == SCARP_RECIPE_NOISE ||
                      entry.kind == SCARP_RECIPE_NUMBER;
        found = same && sampled && !entry.is_param ? i : -1;
    }
    if (found < 0) {
        godot_error(method, "the recipe has no output %.100s", name != NULL ? name : "");
    }
    free(name);
    return found;
}

static void range(void *instance, arguments argument, GDExtensionTypePtr result)
{
    const struct self *self = instance;
    int32_t which = choose("range", self, argument[0]);
    float ends[2];
    if (which >= 0 &&
        scarp_recipe_range(self->recipe, which, NULL, &ends[0], &ends[1]) == SCARP_OK &&
        godot_resize(FLOATS, result, 2)) {
        memcpy(godot.packed_float32_array_operator_index(result, 0), ends, sizeof ends);
    }
}

/* A raster: width, height, x, z, step and the output, as arguments have them */
struct raster {
    int64_t width, height;
    int32_t which;
    struct scarp_grid grid;
    struct scarp_scratch scratch; /* for free() */
};

/* Returns 0 after an error. */
static int read_raster(struct raster *raster, const char *method, const struct self *self,
                       arguments argument, int order)
{
    int64_t width = integer(argument[0]), height = integer(argument[1]);
    double x = number(argument[2]), z = number(argument[3]), step = number(argument[4]);
    if (width < 1 || height < 1 || width > MOST_SAMPLES / height) {
        godot_error(method,
                    "%lld x %lld samples: both must be at least 1, the product at most %lld",
                    (long long)width, (long long)height, (long long)MOST_SAMPLES);
        return 0;
    }
    if (!isfinite(x) || !isfinite(z) || !isfinite(step)) {
        godot_error(method, "x, z and step must be finite");
        return 0;
    }
    int32_t which = choose(method, self, argument[5]);
    size_t size = which < 0 ? 0 : scarp_recipe_scratch_size(self->recipe, order, 0);
    *raster = (struct raster){
        .width = width,
        .height = height,
        .which = which,
        .grid = {.origin = {x, z, 0}, .step = {step, step, 0}, .count = {(size_t)width, 0, 1}},
        .scratch = {.memory = size > 0 ? malloc(size) : NULL, .size = size, .plan = self->plan},
    };
    return which >= 0;
}

/* Samples some rows. Without scratch memory this takes longer. Returns 0 after an error. */
static int sample_rows(struct raster *raster, const char *method, const struct self *self,
                       int64_t first, int64_t rows, const struct scarp_samples *out)
{
    raster->grid.first[1] = first;
    raster->grid.count[1] = (size_t)rows;
    struct scarp_recipe_outputs outputs = {.out = out, .which = &raster->which, .count = 1};
    enum scarp_status status =
        scarp_recipe_grid(self->recipe, &raster->grid, &outputs, &raster->scratch);
    if (status != SCARP_OK) {
        godot_error(method, "%s", scarp_status_text(status));
    }
    return status == SCARP_OK;
}

static void grid(void *instance, arguments argument, GDExtensionTypePtr result)
{
    struct raster raster;
    if (!read_raster(&raster, "grid", instance, argument, 0)) {
        return;
    }
    if (!godot_resize(FLOATS, result, raster.width * raster.height)) {
        godot_error("grid", "no memory for the heights");
    } else {
        struct scarp_samples out = {.value = godot.packed_float32_array_operator_index(result, 0)};
        if (!sample_rows(&raster, "grid", instance, 0, raster.height, &out)) {
            godot_resize(FLOATS, result, 0);
        }
    }
    free(raster.scratch.memory);
}

/* Vectors are of floats, or of doubles where Godot is built with precision=double. */
static void write_vectors(char *vector, size_t size, size_t count, const float *const axis[3])
{
    for (size_t i = 0; i < count; i++, vector += size) {
        for (size_t j = 0; j < 3; j++) {
            double wide = (double)axis[j][i];
            if (size == sizeof(double[3])) {
                memcpy(vector + j * sizeof wide, &wide, sizeof wide);
            } else {
                memcpy(vector + j * sizeof(float), &axis[j][i], sizeof(float));
            }
        }
    }
}

static int write_normals(struct raster *raster, const struct self *self, GDExtensionTypePtr result)
{
    int64_t count = raster->width * raster->height, rows = BAND / raster->width;
    rows = rows < 1 ? 1 : rows > raster->height ? raster->height : rows;
    size_t band = (size_t)(rows * raster->width);
    float *memory = malloc(3 * band * sizeof *memory);
    if (memory == NULL || !godot_resize(VECTORS, result, count + 1)) {
        free(memory);
        godot_error("normals", "no memory for the normals");
        return 0;
    }
    char *vector = godot.packed_vector3_array_operator_index(result, 0);
    size_t size = (size_t)((char *)godot.packed_vector3_array_operator_index(result, 1) - vector);
    float *dx = memory, *dy = dx + band, *up = dy + band;
    struct scarp_samples out = {.dx = dx, .dy = dy};
    int good = 1;
    for (int64_t first = 0; good && first < raster->height; first += rows) {
        int64_t left = raster->height - first < rows ? raster->height - first : rows;
        size_t samples = (size_t)(left * raster->width);
        good = sample_rows(raster, "normals", self, first, left, &out);
        if (good) {
            scarp_normals(samples, dx, dy, 1.0f, dx, dy, up);
            write_vectors(vector, size, samples, (const float *const[3]){dx, up, dy});
            vector += samples * size;
        }
    }
    free(memory);
    return godot_resize(VECTORS, result, good ? count : 0) && good;
}

static void normals(void *instance, arguments argument, GDExtensionTypePtr result)
{
    struct raster raster;
    if (read_raster(&raster, "normals", instance, argument, 1)) {
        write_normals(&raster, instance, result);
        free(raster.scratch.memory);
    }
}

static void at(void *instance, arguments argument, GDExtensionTypePtr result)
{
    const struct self *self = instance;
    int32_t which = choose("at", self, argument[2]);
    double x = number(argument[0]), y = number(argument[1]), z = 0;
    float value = NAN;
    struct scarp_samples out = {.value = &value};
    struct scarp_recipe_outputs outputs = {.out = &out, .which = &which, .count = 1};
    struct scarp_scratch scratch = {.plan = self->plan}; /* the stack does for most recipes */
    enum scarp_status status = SCARP_OK;
    if (which >= 0) {
        status = scarp_recipe_sample_f64(self->recipe, 1, &x, &y, &z, &outputs, &scratch);
    }
    if (status == SCARP_ERROR_SIZE) {
        scratch.size = scarp_recipe_scratch_size(self->recipe, 0, 0);
        scratch.memory = malloc(scratch.size);
        status = scarp_recipe_sample_f64(self->recipe, 1, &x, &y, &z, &outputs, &scratch);
        free(scratch.memory);
    }
    if (status != SCARP_OK) {
        godot_error("at", "%s", scarp_status_text(status));
    }
    *(double *)result = (double)value;
}

/* Shaders */

/* Whether there is a recipe, and what came of it was SCARP_OK */
static int fine(const char *method, const struct self *self, enum scarp_status status)
{
    if (self->recipe == NULL) {
        godot_error(method, "there is no recipe: call parse first");
    } else if (status != SCARP_OK) {
        godot_error(method, "%s", scarp_status_text(status));
    }
    return self->recipe != NULL && status == SCARP_OK;
}

static void shader(void *instance, arguments argument, GDExtensionTypePtr result)
{
    const struct self *self = instance;
    size_t length = 0;
    char *file = godot_text(argument[0], &length), *text = NULL;
    int64_t order = integer(argument[1]);
    struct scarp_shader how = {.language = SCARP_GLSL,
                               .order = order < 0 || order > 2 ? -1 : (int32_t)order,
                               .file = file,
                               .length = length};
    size_t size = 0;
    enum scarp_status status = scarp_recipe_shader(self->recipe, &how, NULL, 0, &size);
    if (status == SCARP_ERROR_SIZE) {
        text = malloc(size + 1);
        status = text == NULL ? SCARP_ERROR_SIZE
                              : scarp_recipe_shader(self->recipe, &how, text, size + 1, &size);
    }
    if (fine("shader", self, status)) {
        godot_set_text(result, text);
    }
    free(text);
    free(file);
}

static void uniforms(void *instance, arguments argument, GDExtensionTypePtr result)
{
    const struct self *self = instance;
    (void)argument;
    size_t size = 0;
    enum scarp_status status = scarp_recipe_uniforms(self->recipe, NULL, 0, &size);
    if (status == SCARP_ERROR_SIZE && godot_resize(BYTES, result, (int64_t)size)) {
        uint8_t *bytes = godot.packed_byte_array_operator_index(result, 0);
        status = scarp_recipe_uniforms(self->recipe, bytes, size, &size);
    }
    fine("uniforms", self, status);
}

static void answers(void *instance, arguments argument, GDExtensionTypePtr result)
{
    const struct self *self = instance;
    int64_t order = integer(argument[0]);
    if (!fine("answers", self, order < 0 || order > 2 ? SCARP_ERROR_PARAMETER : SCARP_OK) ||
        !godot_resize(INTS, result, SCARP_GPU_ANSWERS)) {
        return;
    }
    uint32_t *answer = (uint32_t *)godot.packed_int32_array_operator_index(result, 0);
    fine("answers", self, scarp_recipe_answers(self->recipe, (int)order, answer));
}

#define DEFAULT GDEXTENSION_METHOD_FLAGS_DEFAULT
#define CONST (GDEXTENSION_METHOD_FLAGS_DEFAULT | GDEXTENSION_METHOD_FLAG_CONST)
#define RASTER                                                                                     \
    {"width", INT}, {"height", INT}, {"x", FLOAT}, {"z", FLOAT}, {"step", FLOAT},                  \
    {                                                                                              \
        "output", STRING                                                                           \
    }

const struct godot_method recipe_methods[] = {
    {"parse", parse, STRING, DEFAULT, 1, 0, {{"text", STRING}}},
    {"set_seed", set_seed, NONE, DEFAULT, 1, 0, {{"seed", INT}}},
    {"set_param", set_param, STRING, DEFAULT, 2, 0, {{"name", STRING}, {"value", FLOAT}}},
    {"set_tile", set_tile, STRING, DEFAULT, 3, 0, {{"x", FLOAT}, {"z", FLOAT}, {"y", FLOAT}}},
    {"set_scale", set_scale, STRING, DEFAULT, 2, 0, {{"by", FLOAT}, {"heights", FLOAT}}},
    {"range", range, FLOATS, CONST, 1, 1, {{"output", STRING}}},
    {"at", at, FLOAT, CONST, 3, 1, {{"x", FLOAT}, {"z", FLOAT}, {"output", STRING}}},
    {"grid", grid, FLOATS, CONST, 6, 1, {RASTER}},
    {"normals", normals, VECTORS, CONST, 6, 1, {RASTER}},
    {"shader", shader, STRING, CONST, 2, 0, {{"file", STRING}, {"order", INT}}},
    {"uniforms", uniforms, BYTES, CONST, 0, 0, {{NULL, NONE}}},
    {"answers", answers, INTS, CONST, 1, 0, {{"order", INT}}},
};
const size_t recipe_method_count = sizeof recipe_methods / sizeof *recipe_methods;
