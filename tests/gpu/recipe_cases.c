/* SPDX-License-Identifier: MIT
 *
 * Writes recipes as shaders, and what these must give.
 *
 *     gpu_recipe_cases DIRECTORY COUNT EVERY FILE RECIPE...
 *
 * FILE is scarp.glsl, scarp.hlsl or scarp.wgsl. The recipes are those of files, then of those of
 * recipes.h and COUNT random ones every so many-th, and masks3. Of each, number N, there are in
 * DIRECTORY, which exists: N.comp (of GLSL, for Vulkan), N.hlsl or N.wgsl, the shader of a program
 * that runs it; N.text, only its functions; N.uniforms; N.points, x, y and z; N.outputs, of each
 * output value, dx, dy, dz, dxx, dxy, dxz, dyy, dyz, dzz; and N.answers. Arrays of 4-byte words in
 * the processor's order. index.json lists the recipes: their dimensions, and the order of each
 * output.
 */
#include "../recipes.h"
#include "members.h"

enum { POINTS = 2048, MOST = 16 };

static struct scarp_recipe recipe;

/* What is asked of a recipe: its dimensions, and the order of each output. */
struct described {
    int dimensions, outputs, order[MOST];
};

static struct described describe(const char *text)
{
    struct described d = {.dimensions = strstr(text, "\nspace 3") != NULL ? 3 : 2};
    struct scarp_recipe_entry entry;
    for (size_t i = 0; scarp_recipe_entry_at(&recipe, i, &entry) == SCARP_OK; i++) {
        CHECK(entry.output < MOST, "output %d", (int)entry.output);
        if (entry.output >= 0) {
            d.order[entry.output] = (int)entry.order;
            d.outputs++;
        }
    }
    return d;
}

static char *read_text(const char *path, size_t *length)
{
    FILE *const file = fopen(path, "rb");
    if (file == NULL || fseek(file, 0, SEEK_END) != 0) {
        perror(path);
        exit(EXIT_FAILURE);
    }
    const long size = ftell(file);
    char *const text = check_allocate((size_t)size + 1);
    rewind(file);
    *length = fread(text, 1, (size_t)size, file);
    text[*length] = '\0';
    fclose(file);
    return text;
}

/* The recipes of a run. */
struct recipes {
    int count, files; /* random ones, and files */
    char **file;
};

/* The text of recipe `number`, to be freed, or NULL. */
static char *text_of(const struct recipes *recipes, int number)
{
    static struct recipe_writer writer;
    const int texts = (int)RECIPE_TEXTS;
    size_t length;
    if (number < recipes->files) {
        return read_text(recipes->file[number], &length);
    }
    const int random = number - recipes->files - texts;
    if (random >= recipes->count) {
        return NULL;
    }
    if (random >= 0) {
        recipe_write(&writer, (uint64_t)random, random % 2);
    }
    const char *const text = random >= 0 ? writer.text : recipe_texts[number - recipes->files].text;
    char *const copy = check_allocate(strlen(text) + 1);
    strcpy(copy, text);
    return copy;
}

/* Files, every so many-th of the rest, and always the text whose masks are within each other */
static int is_taken(const struct recipes *recipes, int number, int every)
{
    const int i = number - recipes->files;
    return i < 0 || i % every == 0 ||
           (i < (int)RECIPE_TEXTS && strcmp(recipe_texts[i].name, "masks3") == 0);
}

/* Random recipes may pass a limit. */
static int open_recipe(const char *text, int number)
{
    struct scarp_recipe_error error = {0};
    const enum scarp_status status =
        scarp_recipe_parse(text, strlen(text), &recipe, &error, 1, NULL);
    CHECK(status == SCARP_OK || status == SCARP_ERROR_SIZE, "%d:%d: %s\n%s", (int)error.line,
          (int)error.column, error.text, text);
    (void)scarp_recipe_seed(&recipe, (uint64_t)number * 77 + 5);
    if (number % 4 == 1) { /* the place of the statements is no longer that of the points */
        (void)scarp_recipe_scale(&recipe, 1.75, 0.6, NULL);
    }
    return status == SCARP_OK;
}

/* Lines that write all outputs, or the answer, at a point. */
static void write_main(FILE *file, const struct described *d, int language)
{
    const int is_hlsl = language == SCARP_HLSL;
    static const char *const members[MEMBERS] = {
        "value",   "gradient.x", "gradient.y", "gradient.z", "diagonal.x",
        "mixed.x", "mixed.y",    "diagonal.y", "mixed.z",    "diagonal.z"};
    if (language == SCARP_WGSL) {
        return; /* the page has its own */
    }
    fputs(is_hlsl ? "[[vk::constant_id(0)]] const uint task = 0;\n"
                    "StructuredBuffer<float> point_of : register(t1);\n"
                    "RWStructuredBuffer<uint> result : register(u2);\n"
                    "[[vk::push_constant]] cbuffer Push { uint count; uint order; };\n"
                    "[numthreads(64, 1, 1)]\nvoid main(uint3 id : SV_DispatchThreadID)\n{\n"
                    "    uint i = id.x;\n"
                  : "layout(local_size_x = 64) in;\n"
                    "layout(constant_id = 0) const uint task = 0u;\n"
                    "layout(std430, binding = 1) readonly buffer Points { float point_of[]; };\n"
                    "layout(std430, binding = 2) writeonly buffer Results { uint result[]; };\n"
                    "layout(push_constant) uniform Push { uint count; uint order; };\n"
                    "void main()\n{\n    uint i = gl_GlobalInvocationID.x;\n",
          file);
    fputs("    if (i >= count) {\n        return;\n    }\n    if (task == 3u) {\n"
          "        result[i] = scarp_answer_recipe(i);\n        return;\n    }\n"
          "    ScarpRecipe r = scarp_recipe(point_of[i], point_of[count + i]",
          file);
    fputs(d->dimensions == 3 ? ", point_of[2u * count + i]);\n" : ");\n", file);
    for (int output = 0; output < d->outputs; output++) {
        for (int m = 0; m < MEMBERS; m++) {
            fprintf(file, "    result[%du * count + i] = %s(r.out%d.%s);\n", output * MEMBERS + m,
                    is_hlsl ? "asuint" : "floatBitsToUint", output, members[m]);
        }
    }
    fputs("}\n", file);
}

static FILE *open_file(const char *directory, int number, const char *kind)
{
    char path[4096];
    snprintf(path, sizeof path, "%s/%d.%s", directory, number, kind);
    FILE *const file = fopen(path, "wb");
    if (file == NULL) {
        perror(path);
        exit(EXIT_FAILURE);
    }
    return file;
}

static void write_bytes(const char *directory, int number, const char *kind, const void *bytes,
                        size_t size)
{
    FILE *const file = open_file(directory, number, kind);
    CHECK(fwrite(bytes, 1, size, file) == size && fclose(file) == 0, "%d.%s", number, kind);
}

static void write_shader(const char *directory, int number, const struct described *d,
                         const struct scarp_shader *how)
{
    static const char *const kinds[] = {"comp", "hlsl", "wgsl"};
    static char shader[1 << 19];
    size_t length = 0;
    const enum scarp_status status =
        scarp_recipe_shader(&recipe, how, shader, sizeof shader, &length);
    CHECK(status == SCARP_OK, "recipe %d: %s", number, scarp_status_text(status));
    write_bytes(directory, number, "text", shader, length);
    FILE *const file = open_file(directory, number, kinds[how->language]);
    fprintf(file, "%s%s", how->language == SCARP_GLSL ? "#version 450\n" : "", shader);
    write_main(file, d, how->language);
    fclose(file);
}

/* Half of the points lie on corners and middles of cells of the first noise. */
static void set_points(float points[3][POINTS], float unit, int number)
{
    uint64_t state = (uint64_t)number + 1;
    for (int i = 0; i < POINTS; i++) {
        for (int axis = 0; axis < 3; axis++) {
            const int32_t any = (int32_t)(check_random(&state) >> 32 & 0x7fff) - 0x4000;
            points[axis][i] = (float)(i % 2 == 0 ? any / 128 * 128 : any) * unit; /* exact */
        }
    }
}

static void write_outputs(const char *directory, int number, const struct described *d, float unit)
{
    static float points[3][POINTS], array[MOST][MEMBERS][POINTS];
    static struct scarp_samples samples[MOST];
    static uint64_t memory[1 << 15];
    const struct scarp_scratch scratch = {.memory = memory, .size = sizeof memory};
    memset(samples, 0, sizeof samples);
    memset(array, 0, sizeof array);
    set_points(points, unit, number);
    for (int output = 0; output < d->outputs; output++) {
        for (int m = 0; m < MEMBERS; m++) {
            float *const to =
                has_member(m, d->dimensions, d->order[output]) ? array[output][m] : NULL;
            memcpy((char *)&samples[output] + (size_t)m * sizeof to, &to, sizeof to);
        }
    }
    const struct scarp_recipe_outputs outputs = {.out = samples, .count = d->outputs};
    const enum scarp_status status =
        scarp_recipe_sample(&recipe, POINTS, points[0], points[1], points[2], &outputs, &scratch);
    CHECK(status == SCARP_OK, "recipe %d: %s", number, scarp_status_text(status));
    write_bytes(directory, number, "points", points, sizeof points);
    write_bytes(directory, number, "outputs", array, (size_t)d->outputs * sizeof array[0]);
}

static void write_recipe(const char *directory, int number, const char *text,
                         const struct scarp_shader *how, FILE *index)
{
    static uint64_t uniforms[65536 / sizeof(uint64_t)];
    static uint32_t answers[SCARP_GPU_ANSWERS];
    const struct described d = describe(text);
    size_t size = 0;
    float unit;
    CHECK(scarp_recipe_uniforms(&recipe, uniforms, sizeof uniforms, &size) == SCARP_OK &&
              scarp_recipe_answers(&recipe, how->order, answers) == SCARP_OK,
          "recipe %d", number);
    memcpy(&unit, (const char *)uniforms + 4, sizeof unit);
    write_shader(directory, number, &d, how);
    write_bytes(directory, number, "uniforms", uniforms, size);
    write_bytes(directory, number, "answers", answers, sizeof answers);
    write_outputs(directory, number, &d, unit);
    fprintf(index, "%s\n{\"number\": %d, \"dimensions\": %d, \"orders\": [",
            ftell(index) > 64 ? "," : "", number, d.dimensions);
    for (int i = 0; i < d.outputs; i++) {
        fprintf(index, "%s%d", i > 0 ? ", " : "", d.order[i]);
    }
    fprintf(index, "]}");
}

int main(int argc, char **argv)
{
    if (argc < 5) {
        printf("usage: gpu_recipe_cases DIRECTORY COUNT EVERY FILE RECIPE...\n");
        return EXIT_FAILURE;
    }
    const struct recipes recipes = {atoi(argv[2]), argc - 5, argv + 5};
    const int every = atoi(argv[3]);
    struct scarp_shader how = {.order = 2};
    how.language = strstr(argv[4], ".glsl") != NULL   ? SCARP_GLSL
                   : strstr(argv[4], ".hlsl") != NULL ? SCARP_HLSL
                                                      : SCARP_WGSL;
    char *const file = read_text(argv[4], &how.length);
    char path[4096];
    snprintf(path, sizeof path, "%s/index.json", argv[1]);
    FILE *const index = fopen(path, "wb");
    if (index == NULL) {
        perror(path);
        return EXIT_FAILURE;
    }
    how.file = file;
    fprintf(index, "{\"points\": %5d, \"answers\": %5d, \"order\": %d, \"list\": [", POINTS,
            SCARP_GPU_ANSWERS, how.order);
    char *text;
    for (int i = 0; (text = text_of(&recipes, i)) != NULL; i++) {
        if (is_taken(&recipes, i, every) && open_recipe(text, i)) {
            write_recipe(argv[1], i, text, &how, index);
        }
        free(text);
    }
    fprintf(index, "\n]}\n");
    CHECK(fclose(index) == 0, "%s", path);
    free(file);
    return check_done();
}
