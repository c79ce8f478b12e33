/* SPDX-License-Identifier: MIT
 *
 * Runs recipes as shaders on a Vulkan device, and compares every bit of all outputs, and the
 * self-test, with what recipe_cases.c wrote.
 *
 *     gpu_recipes [--must-differ] DIRECTORY
 *
 * There lie index.json and its files, and what is compiled of the shaders: N.spv. The sign of 0
 * does not count, nor do magnitudes below 2^-120.
 */
#include "device.h"
#include "members.h"

enum { POINTS = 2048, MOST = 16, ANSWERS = 4096, TASK_ANSWERS = 3 };

struct recipe_case {
    int number, dimensions, outputs, order[MOST];
};

struct run {
    struct gpu gpu;
    const char *directory;
    unsigned long recipes, compared, differing, answers, wrong;
};

static const char *path_of(const struct run *run, int number, const char *kind)
{
    static char path[4096];
    snprintf(path, sizeof path, "%s/%d.%s", run->directory, number, kind);
    return path;
}

static void copy_file(const struct run *run, int number, const char *kind, int buffer)
{
    size_t size;
    uint32_t *const words = gpu_read(path_of(run, number, kind), &size);
    memcpy(run->gpu.buffers[buffer].bytes, words, size);
    free(words);
}

static void compare_outputs(struct run *run, const struct recipe_case *c)
{
    size_t size;
    uint32_t *const words = gpu_read(path_of(run, c->number, "outputs"), &size);
    const float *const library = (const float *)(void *)words;
    const float *const shader = run->gpu.buffers[GPU_RESULTS].bytes;
    for (int i = 0; i < c->outputs * MEMBERS * POINTS; i++) {
        const int output = i / POINTS / MEMBERS, m = i / POINTS % MEMBERS;
        if (!has_member(m, c->dimensions, c->order[output])) {
            continue;
        }
        const int is_same = counted_bits(&shader[i]) == counted_bits(&library[i]);
        run->compared++;
        run->differing += !is_same;
        CHECK_BITS(is_same, "recipe %d, output %d, member %d, point %d: %a, not %a", c->number,
                   output, m, i % POINTS, (double)shader[i], (double)library[i]);
    }
    free(words);
}

static void compare_answers(struct run *run, const struct recipe_case *c)
{
    size_t size;
    uint32_t *const answers = gpu_read(path_of(run, c->number, "answers"), &size);
    const uint32_t *const shader = run->gpu.buffers[GPU_RESULTS].bytes;
    for (int i = 0; i < ANSWERS; i++) {
        run->answers++;
        run->wrong += shader[i] != answers[i];
        CHECK_BITS(shader[i] == answers[i], "recipe %d, answer %d: %08x, not %08x", c->number, i,
                   shader[i], answers[i]);
    }
    free(answers);
}

static void run_shader(const struct run *run, const struct recipe_case *c, uint32_t task,
                       uint32_t count)
{
    memset(run->gpu.buffers[GPU_RESULTS].bytes, POISON, sizeof(float) * POINTS * MEMBERS * MOST);
    VkPipeline pipeline = gpu_make_pipeline(&run->gpu, path_of(run, c->number, "spv"), task);
    gpu_run(&run->gpu, pipeline, (struct gpu_push){count, 2});
    vkDestroyPipeline(run->gpu.device, pipeline, NULL);
}

static void run_case(struct run *run, const struct recipe_case *c)
{
    copy_file(run, c->number, "uniforms", GPU_PLAN);
    copy_file(run, c->number, "points", GPU_POINTS);
    run_shader(run, c, 0, POINTS);
    compare_outputs(run, c);
    run->recipes++;
    if (c->number % 8 == 0) { /* a pipeline of its own, which takes as long as the other one */
        run_shader(run, c, TASK_ANSWERS, ANSWERS);
        compare_answers(run, c);
    }
}

/* Reads a line of index.json. */
static int read_case(FILE *index, struct recipe_case *c)
{
    char line[512];
    while (fgets(line, sizeof line, index) != NULL) {
        int at = 0, more = 0;
        if (sscanf(line, "{\"number\": %d, \"dimensions\": %d, \"orders\": [%n", &c->number,
                   &c->dimensions, &at) == 2 &&
            at > 0) {
            c->outputs = 0;
            while (c->outputs < MOST &&
                   sscanf(line + at, "%d%n", &c->order[c->outputs], &more) == 1) {
                c->outputs++;
                at += more + 2; /* a comma and a space */
            }
            return 1;
        }
    }
    return 0;
}

int main(int argc, char **argv)
{
    static struct run run;
    struct recipe_case c;
    char path[4096];
    argc = check_take_aim(argc, &argv);
    if (argc != 2) {
        printf("usage: gpu_recipes [--must-differ] DIRECTORY\n");
        return EXIT_FAILURE;
    }
    run.directory = argv[1];
    snprintf(path, sizeof path, "%s/index.json", argv[1]);
    FILE *const index = fopen(path, "r");
    if (index == NULL || !gpu_find(&run.gpu)) {
        printf(index == NULL ? "%s cannot be read\n" : "no Vulkan device\n", path);
        return EXIT_FAILURE;
    }
    printf("%s\n", run.gpu.properties.deviceName);
    gpu_open(&run.gpu, (VkDeviceSize[GPU_BUFFERS]){65536, 3 * sizeof(float) * POINTS,
                                                   sizeof(float) * POINTS * MEMBERS * MOST});
    while (read_case(index, &c) && !check_enough()) {
        run_case(&run, &c);
    }
    fclose(index);
    printf("%lu recipes: %lu of %lu outputs differ, %lu of %lu answers\n", run.recipes,
           run.differing, run.compared, run.wrong, run.answers);
    CHECK(run.compared > 0 && run.answers > 0, "nothing was compared");
    gpu_close(&run.gpu);
    return check_done();
}
