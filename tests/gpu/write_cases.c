/* SPDX-License-Identifier: MIT
 *
 * Writes what the page in the browser compares with, for browser.py.
 *
 *     write_cases DIRECTORY      which is there
 *
 * For each noise of cases.h, number N: N.plan, the struct scarp_gpu_plan; N.points, x, y and z;
 * N.outputs, value, dx, dy, dz, dxx, dxy, dxz, dyy, dyz, dzz (zeros where the noise has none); and
 * N.answers, those of orders 0 to 2 (likewise). Arrays of 4-byte words in the processor's order.
 * index.json lists the noises.
 */
#include "cases.h"

enum { POINTS = 4096, OUTPUTS = 10, ORDERS = 3 };

static const char *directory;

static FILE *open_file(const char *name)
{
    char path[4096];
    snprintf(path, sizeof path, "%s/%s", directory, name);
    FILE *const file = fopen(path, "wb");
    if (file == NULL) {
        perror(path);
        exit(EXIT_FAILURE);
    }
    return file;
}

static void close_file(FILE *file)
{
    if (ferror(file) != 0 || fclose(file) != 0) {
        perror("write_cases");
        exit(EXIT_FAILURE);
    }
}

static void write_file(int number, const char *kind, const void *bytes, size_t size)
{
    char name[64];
    snprintf(name, sizeof name, "%d.%s", number, kind);
    FILE *const file = open_file(name);
    fwrite(bytes, 1, size, file);
    close_file(file);
}

static void must(enum scarp_status status, const struct gpu_case *c, const char *function)
{
    if (status != SCARP_OK) {
        printf("%s: %s: %s\n", c->name, function, scarp_status_text(status));
        exit(EXIT_FAILURE);
    }
}

static void write_outputs(int number, const struct gpu_case *c, const struct scarp_noise *noise)
{
    static float in[3][POINTS], out[OUTPUTS][POINTS];
    memset(out, 0, sizeof out);
    gpu_points(c, POINTS, (float *const[3]){in[0], in[1], in[2]});
    const int order = gpu_order_of(noise), in_space = c->dimensions == 3;
    const struct scarp_samples samples = {
        .value = out[0],
        .dx = order >= 1 ? out[1] : NULL,
        .dy = order >= 1 ? out[2] : NULL,
        .dz = order >= 1 && in_space ? out[3] : NULL,
        .dxx = order >= 2 ? out[4] : NULL,
        .dxy = order >= 2 ? out[5] : NULL,
        .dxz = order >= 2 && in_space ? out[6] : NULL,
        .dyy = order >= 2 ? out[7] : NULL,
        .dyz = order >= 2 && in_space ? out[8] : NULL,
        .dzz = order >= 2 && in_space ? out[9] : NULL,
    };
    must(in_space ? scarp_sample3(noise, POINTS, in[0], in[1], in[2], &samples)
                  : scarp_sample2(noise, POINTS, in[0], in[1], &samples),
         c, "scarp_sample");
    write_file(number, "points", in, sizeof in);
    write_file(number, "outputs", out, sizeof out);
}

static void write_answers(int number, const struct gpu_case *c, const struct scarp_noise *noise)
{
    static uint32_t answers[ORDERS][SCARP_GPU_ANSWERS];
    memset(answers, 0, sizeof answers);
    for (int order = 0; order <= gpu_order_of(noise); order++) {
        must(scarp_gpu_answers(noise, c->dimensions, order, answers[order]), c,
             "scarp_gpu_answers");
    }
    write_file(number, "answers", answers, sizeof answers);
}

static void write_case(int number, const struct gpu_case *c)
{
    const struct scarp_noise noise = gpu_noise_of(c);
    struct scarp_gpu_plan plan;
    must(scarp_gpu_plan_make(&noise, c->dimensions, &plan, NULL), c, "scarp_gpu_plan_make");
    write_file(number, "plan", &plan, sizeof plan);
    write_outputs(number, c, &noise);
    write_answers(number, c, &noise);
}

int main(int argc, char **argv)
{
    if (argc != 2) {
        printf("usage: write_cases DIRECTORY\n");
        return EXIT_FAILURE;
    }
    directory = argv[1];
    FILE *const index = open_file("index.json");
    fprintf(index, "{\"points\": %d, \"answers\": %d, \"list\": [", POINTS, SCARP_GPU_ANSWERS);
    for (int i = 0; i < GPU_CASES; i++) {
        const struct gpu_case *const c = &gpu_cases[i];
        write_case(i, c);
        fprintf(index, "%s\n  {\"name\": \"%s\", \"dimensions\": %d, \"order\": %d}",
                i > 0 ? "," : "", c->name, c->dimensions, gpu_order_of(&c->noise));
    }
    fprintf(index, "\n]}\n");
    close_file(index);
    return EXIT_SUCCESS;
}
