/* SPDX-License-Identifier: MIT
 *
 * Runs the shaders on a Vulkan device and compares every bit with the library: all noises of
 * cases.h, or the answers of the self-test. The sign of 0 does not count, nor do magnitudes below
 * 2^-120, which shaders may flush to 0.
 *
 *     gpu_vulkan [--must-differ] SHADER [POINTS [TASK [CASE]]]
 *
 * SHADER is the beginning of file names: SHADER-2d.spv and SHADER-3d.spv, or SHADER-2d-rounded.spv
 * and SHADER-3d-rounded.spv where these exist and the device can be told to round to nearest. TASK
 * is value, gradient, hessian (outputs up to this order, which is the default), or answers. CASE
 * selects the cases whose names contain it.
 */
#include <time.h>

#include "cases.h"
#include "device.h"
#include "members.h"

enum { TASK_ANSWERS = 3 };

static const char *const task_names[] = {"value", "gradient", "hessian", "answers"};

struct run {
    struct gpu gpu;
    VkPipeline pipelines[4]; /* by dimensions; that of 2 and 3 are in use */
    uint32_t task, points;
    float *axes[3];
    struct outputs library;
    unsigned long compared[ORDERS], differing[ORDERS];
};

static double seconds(void)
{
    struct timespec now;
    timespec_get(&now, TIME_UTC);
    return (double)now.tv_sec + (double)now.tv_nsec * 1e-9;
}

/* Compares one output of all points and returns how many differ. */
static unsigned long compare_output(const struct run *run, const struct gpu_case *c, int output)
{
    const float *const shader =
        (const float *)run->gpu.buffers[GPU_RESULTS].bytes + (size_t)output * run->points;
    const float *const library = run->library.array[output];
    unsigned long differing = 0;
    for (uint32_t i = 0; i < run->points; i++) {
        const int same = counted_bits(shader + i) == counted_bits(library + i);
        differing += !same;
        CHECK_BITS(same, "%s: %s of point %u (%a, %a, %a): %08x, not %08x", c->name,
                   output_names[output], i, (double)run->axes[0][i], (double)run->axes[1][i],
                   (double)run->axes[2][i], float_bits(shader + i), float_bits(library + i));
    }
    return differing;
}

/* Compares these outputs, and counts. */
static void compare_outputs(struct run *run, const struct gpu_case *c, unsigned wanted)
{
    unsigned long differing[ORDERS] = {0};
    for (int m = 0; m < OUTPUTS; m++) {
        if ((wanted >> m & 1) != 0) {
            differing[output_kinds[m].order] += compare_output(run, c, m);
            run->compared[output_kinds[m].order] += run->points;
        }
    }
    printf("%-34s", c->name);
    for (int order = 0; order < ORDERS; order++) {
        printf(" %8lu", differing[order]);
        run->differing[order] += differing[order];
    }
}

static size_t results_size(uint32_t count)
{
    return OUTPUTS * sizeof(float) * count;
}

/* Runs the shader, and says how long that took. */
static double run_shader(const struct run *run, const struct gpu_case *c, uint32_t count,
                         uint32_t order)
{
    memset(run->gpu.buffers[GPU_RESULTS].bytes, POISON, results_size(count));
    const double before = seconds();
    gpu_run(&run->gpu, run->pipelines[c->dimensions], (struct gpu_push){count, order});
    return seconds() - before;
}

static void compare_answers(const struct run *run, const struct gpu_case *c,
                            const struct scarp_noise *noise, int order)
{
    static uint32_t answers[SCARP_GPU_ANSWERS];
    const enum scarp_status status = scarp_gpu_answers(noise, c->dimensions, order, answers);
    CHECK(status == SCARP_OK, "%s: %s", c->name, scarp_status_text(status));
    run_shader(run, c, SCARP_GPU_ANSWERS, (uint32_t)order);
    const uint32_t *const shader = run->gpu.buffers[GPU_RESULTS].bytes;
    unsigned long differing = 0;
    for (uint32_t i = 0; i < SCARP_GPU_ANSWERS; i++) {
        differing += shader[i] != answers[i];
        CHECK_BITS(shader[i] == answers[i], "%s: answer %u of order %d: %08x, not %08x", c->name, i,
                   order, shader[i], answers[i]);
    }
    printf("%-34s order %d: %lu answers differ\n", c->name, order, differing);
}

static void sample_case(struct run *run, const struct gpu_case *c, const struct scarp_noise *noise,
                        int order)
{
    const unsigned wanted = outputs_up_to(order, c->dimensions);
    const struct inputs in = {{run->axes[0], run->axes[1], run->axes[2]}, {NULL}};
    const struct scarp_samples out = outputs_subset(&run->library, wanted);
    gpu_points(c, run->points, run->axes);
    float *const points = run->gpu.buffers[GPU_POINTS].bytes;
    for (int k = 0; k < 3; k++) {
        memcpy(points + (size_t)k * run->points, run->axes[k], run->points * sizeof(float));
    }
    const double took = run_shader(run, c, run->points, 0);
    const enum scarp_status status =
        function_call(c->dimensions == 2 ? SAMPLE2 : SAMPLE3, noise, run->points, &in, &out);
    CHECK(status == SCARP_OK, "%s: %s", c->name, scarp_status_text(status));
    compare_outputs(run, c, wanted);
    printf(" %8.2f\n", (double)run->points / took * 1e-6);
}

static void run_case(struct run *run, const struct gpu_case *c)
{
    const struct scarp_noise noise = gpu_noise_of(c);
    struct scarp_gpu_plan plan;
    const char *member = "";
    const enum scarp_status status = scarp_gpu_plan_make(&noise, c->dimensions, &plan, &member);
    CHECK(status == SCARP_OK, "%s: %s: %s", c->name, member, scarp_status_text(status));
    if (status != SCARP_OK) {
        return;
    }
    memcpy(run->gpu.buffers[GPU_PLAN].bytes, &plan, sizeof plan);
    const int most = gpu_order_of(&noise);
    if (run->task == TASK_ANSWERS) {
        for (int order = 0; order <= most; order++) {
            compare_answers(run, c, &noise, order);
        }
        return;
    }
    sample_case(run, c, &noise, (int)run->task < most ? (int)run->task : most);
}

static VkPipeline open_pipeline(const struct run *run, const char *shader, int dimensions)
{
    char path[4096];
    snprintf(path, sizeof path, "%s-%dd-rounded.spv", shader, dimensions);
    FILE *file = run->gpu.rounds ? fopen(path, "rb") : NULL;
    if (file != NULL) {
        fclose(file);
    } else {
        snprintf(path, sizeof path, "%s-%dd.spv", shader, dimensions);
    }
    return gpu_make_pipeline(&run->gpu, path, run->task);
}

/* Opens the shader, and runs it for a point of nothing: drivers may compile when they have to. */
static void open_shader(struct run *run, const char *shader, int dimensions)
{
    const struct gpu_case nothing = {.dimensions = dimensions};
    const double before = seconds();
    run->pipelines[dimensions] = open_pipeline(run, shader, dimensions);
    memset(run->gpu.buffers[GPU_PLAN].bytes, 0, sizeof(struct scarp_gpu_plan));
    memset(run->gpu.buffers[GPU_POINTS].bytes, 0, 3 * sizeof(float));
    run_shader(run, &nothing, 1, 0);
    printf("%dD: compiled in %.2f s\n", dimensions, seconds() - before);
}

static void open_run(struct run *run, const char *shader)
{
    if (!gpu_find(&run->gpu)) {
        printf("no Vulkan device\n");
        exit(EXIT_FAILURE);
    }
    printf("%s, %s\n", run->gpu.properties.deviceName,
           run->gpu.rounds ? "can be told to round to nearest" : "rounds as it likes");
    const uint32_t words = run->points > SCARP_GPU_ANSWERS ? run->points : SCARP_GPU_ANSWERS;
    const VkDeviceSize sizes[GPU_BUFFERS] = {sizeof(struct scarp_gpu_plan),
                                             3 * sizeof(float) * words, results_size(words)};
    gpu_open(&run->gpu, sizes);
    for (int d = 2; d <= 3; d++) {
        open_shader(run, shader, d);
    }
    run->library = outputs_make(run->points);
    for (int k = 0; k < 3; k++) {
        run->axes[k] = check_allocate(run->points * sizeof(float));
    }
}

static void close_run(struct run *run)
{
    outputs_free(&run->library);
    for (int k = 0; k < 3; k++) {
        free(run->axes[k]);
    }
    for (int d = 2; d <= 3; d++) {
        vkDestroyPipeline(run->gpu.device, run->pipelines[d], NULL);
    }
    gpu_close(&run->gpu);
}

/* The number of a task, which must exist. */
static uint32_t task_by_name(const char *name)
{
    for (uint32_t i = 0; i <= TASK_ANSWERS; i++) {
        if (strcmp(name, task_names[i]) == 0) {
            return i;
        }
    }
    printf("unknown task %s\n", name);
    exit(EXIT_FAILURE);
}

int main(int argc, char **argv)
{
    static struct run run;
    argc = check_take_aim(argc, &argv);
    if (argc < 2) {
        printf("usage: gpu_vulkan [--must-differ] SHADER [POINTS [TASK [CASE]]]\n");
        return EXIT_FAILURE;
    }
    run.points = argc > 2 ? (uint32_t)strtoul(argv[2], NULL, 10) : 4099;
    run.task = task_by_name(argc > 3 ? argv[3] : "hessian");
    if (run.points == 0) {
        printf("POINTS must be above 0\n");
        return EXIT_FAILURE;
    }
    open_run(&run, argv[1]);
    if (run.task != TASK_ANSWERS) {
        printf("%-34s %8s %8s %8s %8s\n", "what differs", "values", "gradient", "Hessian", "Mpt/s");
    }
    for (int i = 0; i < GPU_CASES && !check_enough(); i++) {
        if (argc <= 4 || strstr(gpu_cases[i].name, argv[4]) != NULL) {
            run_case(&run, &gpu_cases[i]);
        }
    }
    for (int order = 0; order < ORDERS && run.compared[order] > 0; order++) {
        printf("order %d: %lu of %lu floats differ\n", order, run.differing[order],
               run.compared[order]);
    }
    close_run(&run);
    return check_done();
}
