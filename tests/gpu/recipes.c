/* SPDX-License-Identifier: MIT
 *
 * Recipes as shaders on a Vulkan device: every bit of all outputs, and the self-test, against the
 * library.
 *
 *     gpu_recipes write DIRECTORY COUNT FILE RECIPE...    the shaders: DIRECTORY/N.comp, or N.hlsl
 *     gpu_recipes run DIRECTORY COUNT - RECIPE...         compares what is made of them: N.spv
 *
 * The recipes are all texts of recipes.h, those of files, and COUNT random ones. FILE is scarp.glsl
 * or scarp.hlsl. Outputs are compared as vulkan.c compares them.
 */
#include "../recipes.h"
#include "../outputs.h"
#include "device.h"

enum { POINTS = 2048, MEMBERS = 10, MOST = 16 };

static struct scarp_recipe recipe;

static const unsigned char order_of[MEMBERS] = {0, 1, 1, 1, 2, 2, 2, 2, 2, 2};
static const unsigned char is_along_z[MEMBERS] = {0, 0, 0, 1, 0, 0, 1, 0, 1, 1};

/* What is asked of a recipe: its dimensions, and the order of each output. */
struct described {
    int dimensions, outputs, order[MOST];
};

static struct described describe(const char *text)
{
    struct described d = {.dimensions = strstr(text, "\nspace 3") != NULL ? 3 : 2};
    struct scarp_recipe_entry entry;
    for (size_t i = 0; scarp_recipe_entry_at(&recipe, i, &entry) == SCARP_OK; i++) {
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
    if (number >= texts && number < texts + recipes->files) {
        return read_text(recipes->file[number - texts], &length);
    }
    const int random = number - texts - recipes->files;
    if (random >= recipes->count) {
        return NULL;
    }
    if (random >= 0) {
        recipe_write(&writer, (uint64_t)random, random % 2);
    }
    const char *const text = random >= 0 ? writer.text : recipe_texts[number].text;
    char *const copy = check_allocate(strlen(text) + 1);
    strcpy(copy, text);
    return copy;
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
    return status == SCARP_OK;
}

/* Lines that write all outputs, or the answer, at a point. */
static void write_main(FILE *file, const struct described *d, int is_hlsl)
{
    static const char *const members[MEMBERS] = {
        "value",   "gradient.x", "gradient.y", "gradient.z", "diagonal.x",
        "mixed.x", "mixed.y",    "diagonal.y", "mixed.z",    "diagonal.z"};
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

static void write_shader(const char *directory, int number, const char *text, int is_hlsl,
                         const struct scarp_shader *how)
{
    static char shader[1 << 19];
    char path[4096];
    size_t length = 0;
    const struct described d = describe(text);
    const enum scarp_status status =
        scarp_recipe_shader(&recipe, how, shader, sizeof shader, &length);
    CHECK(status == SCARP_OK, "%s: %s", text, scarp_status_text(status));
    snprintf(path, sizeof path, "%s/%d.%s", directory, number, is_hlsl ? "hlsl" : "comp");
    FILE *const file = fopen(path, "wb");
    if (file == NULL) {
        perror(path);
        exit(EXIT_FAILURE);
    }
    fprintf(file, "%s%s", is_hlsl ? "" : "#version 450\n", shader);
    write_main(file, &d, is_hlsl);
    fclose(file);
}

static int write_all(const char *directory, const struct recipes *recipes, const char *library)
{
    const int is_hlsl = strstr(library, ".hlsl") != NULL;
    struct scarp_shader how = {.language = is_hlsl ? SCARP_HLSL : SCARP_GLSL, .order = 2};
    char *const file = read_text(library, &how.length);
    char *text;
    how.file = file;
    for (int i = 0; (text = text_of(recipes, i)) != NULL; i++) {
        if (open_recipe(text, i)) {
            write_shader(directory, i, text, is_hlsl, &how);
        }
        free(text);
    }
    free(file);
    return check_done();
}

struct run {
    struct gpu gpu;
    float *points[3];
    unsigned long compared, differing, answers, wrong;
};

/* 0 below 2^-120 */
static uint32_t counted_bits(const float *value)
{
    const uint32_t bits = float_bits(value);
    return (bits & 0x7fffffffu) < (uint32_t)(127 - 120) << 23 ? 0 : bits;
}

static void compare_member(struct run *run, const char *text, int output, int member,
                           const float *library)
{
    const float *const shader = (const float *)run->gpu.buffers[GPU_RESULTS].bytes +
                                (size_t)(output * MEMBERS + member) * POINTS;
    for (int i = 0; i < POINTS; i++) {
        const int is_same = counted_bits(&shader[i]) == counted_bits(&library[i]);
        run->compared++;
        run->differing += !is_same;
        CHECK_BITS(is_same, "output %d, member %d at (%a, %a, %a): %a, not %a\n%s", output, member,
                   (double)run->points[0][i], (double)run->points[1][i], (double)run->points[2][i],
                   (double)shader[i], (double)library[i], text);
    }
}

static void compare_outputs(struct run *run, const char *text, const struct described *d)
{
    static float array[MOST][MEMBERS][POINTS];
    static struct scarp_samples samples[MOST];
    static uint64_t memory[1 << 15];
    const struct scarp_scratch scratch = {.memory = memory, .size = sizeof memory};
    memset(samples, 0, sizeof samples);
    for (int output = 0; output < d->outputs; output++) {
        for (int m = 0; m < MEMBERS; m++) {
            float *const to =
                order_of[m] <= d->order[output] && (d->dimensions == 3 || !is_along_z[m])
                    ? array[output][m]
                    : NULL;
            memcpy((char *)&samples[output] + (size_t)m * sizeof to, &to, sizeof to);
        }
    }
    const struct scarp_recipe_outputs outputs = {.out = samples, .count = d->outputs};
    const enum scarp_status status = scarp_recipe_sample(
        &recipe, POINTS, run->points[0], run->points[1], run->points[2], &outputs, &scratch);
    CHECK(status == SCARP_OK, "%s: %s", text, scarp_status_text(status));
    for (int output = 0; output < d->outputs; output++) {
        for (int m = 0; m < MEMBERS; m++) {
            if (order_of[m] <= d->order[output] && (d->dimensions == 3 || !is_along_z[m])) {
                compare_member(run, text, output, m, array[output][m]);
            }
        }
    }
}

static void compare_answers(struct run *run, const char *text)
{
    static uint32_t answers[SCARP_GPU_ANSWERS];
    CHECK(scarp_recipe_answers(&recipe, 2, answers) == SCARP_OK, "%s", text);
    const uint32_t *const shader = run->gpu.buffers[GPU_RESULTS].bytes;
    for (int i = 0; i < SCARP_GPU_ANSWERS; i++) {
        run->answers++;
        run->wrong += shader[i] != answers[i];
        CHECK_BITS(shader[i] == answers[i], "answer %d: %08x, not %08x\n%s", i, shader[i],
                   answers[i], text);
    }
}

/* Half of the points lie on corners and middles of cells of the first noise. */
static void set_points(struct run *run, float unit, int number)
{
    uint64_t state = (uint64_t)number + 1;
    for (int i = 0; i < POINTS; i++) {
        for (int axis = 0; axis < 3; axis++) {
            const int32_t any = (int32_t)(check_random(&state) >> 32 & 0x7fff) - 0x4000;
            run->points[axis][i] =
                (float)(i % 4 == 0 ? any / 128 * 128 : any) * unit; /* exact: unit is 2^n */
        }
    }
    float *const to = run->gpu.buffers[GPU_POINTS].bytes;
    for (int axis = 0; axis < 3; axis++) {
        memcpy(to + axis * POINTS, run->points[axis], POINTS * sizeof(float));
    }
}

static void run_recipe(struct run *run, const char *path, const char *text, int number)
{
    const struct described d = describe(text);
    size_t size = 0;
    void *const uniforms = run->gpu.buffers[GPU_PLAN].bytes;
    const enum scarp_status status = scarp_recipe_uniforms(&recipe, uniforms, 65536, &size);
    CHECK(status == SCARP_OK, "%s: %s", text, scarp_status_text(status));
    float unit;
    memcpy(&unit, (const char *)uniforms + 4, sizeof unit);
    set_points(run, unit, number);
    VkPipeline pipeline = gpu_make_pipeline(&run->gpu, path, 0);
    gpu_run(&run->gpu, pipeline, (struct gpu_push){POINTS, 2});
    vkDestroyPipeline(run->gpu.device, pipeline, NULL);
    compare_outputs(run, text, &d);
    if (number % 8 == 0) {
        pipeline = gpu_make_pipeline(&run->gpu, path, 3);
        gpu_run(&run->gpu, pipeline, (struct gpu_push){SCARP_GPU_ANSWERS, 2});
        vkDestroyPipeline(run->gpu.device, pipeline, NULL);
        compare_answers(run, text);
    }
}

static int run_all(const char *directory, const struct recipes *recipes)
{
    static struct run run;
    if (!gpu_find(&run.gpu)) {
        printf("no Vulkan device\n");
        return EXIT_FAILURE;
    }
    const VkDeviceSize sizes[GPU_BUFFERS] = {65536, 3 * sizeof(float) * POINTS,
                                             sizeof(float) * POINTS * MEMBERS * MOST};
    gpu_open(&run.gpu, sizes);
    for (int axis = 0; axis < 3; axis++) {
        run.points[axis] = check_allocate(POINTS * sizeof(float));
    }
    char *text;
    int done = 0;
    for (int i = 0; (text = text_of(recipes, i)) != NULL; i++) {
        char path[4096];
        snprintf(path, sizeof path, "%s/%d.spv", directory, i);
        if (!check_enough() && open_recipe(text, i)) {
            run_recipe(&run, path, text, i);
            done++;
        }
        free(text);
    }
    printf("%d recipes: %lu of %lu outputs differ, %lu of %lu answers\n", done, run.differing,
           run.compared, run.wrong, run.answers);
    for (int axis = 0; axis < 3; axis++) {
        free(run.points[axis]);
    }
    gpu_close(&run.gpu);
    return check_done();
}

int main(int argc, char **argv)
{
    argc = check_take_aim(argc, &argv);
    if (argc < 5) {
        printf("usage: gpu_recipes write|run DIRECTORY COUNT FILE RECIPE...\n");
        return EXIT_FAILURE;
    }
    const struct recipes recipes = {atoi(argv[3]), argc - 5, argv + 5};
    return strcmp(argv[1], "write") == 0 ? write_all(argv[2], &recipes, argv[4])
                                         : run_all(argv[2], &recipes);
}
