/* SPDX-License-Identifier: MIT
 *
 * Renders the picture of src/gpu/README.md with picture.comp, and compares what the shader says of
 * the ground at each pixel with the library, to the bit.
 *
 *     gpu_picture SHADER > landscape.ppm
 *     gpu_picture SHADER --small    only compares, at a quarter of the height
 */
#include <math.h>

#include "device.h"
#include "scarp.h"

enum { X, Y, VALUE, DX, DY, COLOR, MEMBERS = COLOR + 3 };

/* The ground, of that many octaves of 13. */
static struct scarp_noise ground_of(float octaves)
{
    const struct scarp_noise noise = {
        .basis = SCARP_VALUE,
        .fractal = SCARP_EROSION,
        .rotate = 1,
        .seed = 11,
        .frequency = 0x1p-8,
        .octaves = octaves,
        .of_octaves = 13.0f,
        .amplitude = 150.0f,
    };
    return noise;
}

/* How many outputs of the pixels differ from the library's. */
static size_t differing(const float *pixels, size_t count)
{
    const struct scarp_noise ground = ground_of(13.0f);
    size_t differ = 0;
    for (size_t i = 0; i < count; i++) {
        float of[3];
        const struct scarp_samples out = {.value = &of[0], .dx = &of[1], .dy = &of[2]};
        const float x = pixels[X * count + i], y = pixels[Y * count + i];
        if (scarp_sample2(&ground, 1, &x, &y, &out) != SCARP_OK) {
            return count;
        }
        for (size_t k = 0; k < 3; k++) {
            differ += memcmp(&of[k], &pixels[(VALUE + k) * count + i], sizeof of[k]) != 0;
        }
    }
    return differ;
}

static int write_ppm(const float *pixels, size_t width, size_t height)
{
    const size_t count = width * height;
    printf("P6\n%zu %zu\n255\n", width, height);
    for (size_t i = 0; i < count; i++) {
        for (size_t k = 0; k < 3; k++) {
            const float c = pixels[(COLOR + k) * count + i];
            putchar(c < 0.0f ? 0 : c > 1.0f ? 255 : (int)lrintf(c * 255.0f));
        }
    }
    return fflush(stdout) != 0 || ferror(stdout);
}

int main(int argc, char **argv)
{
    const int is_small = argc > 2 && strcmp(argv[2], "--small") == 0;
    const uint32_t height = is_small ? 120 : 480, width = height * 107 / 60;
    const size_t count = (size_t)width * height;
    const VkDeviceSize sizes[GPU_BUFFERS] = {2 * sizeof(struct scarp_gpu_plan), 16,
                                             count * MEMBERS * sizeof(float)};
    const struct scarp_noise far = ground_of(7.0f), near = ground_of(13.0f);
    struct gpu gpu;
    if (argc < 2 || !gpu_find(&gpu)) {
        fprintf(stderr, "usage: gpu_picture SHADER [--small]; it needs a Vulkan device\n");
        return 2;
    }
    gpu_open(&gpu, sizes);
    struct scarp_gpu_plan *const plans = gpu.buffers[GPU_PLAN].bytes;
    if (scarp_gpu_plan_make(&far, 2, &plans[0], NULL) != SCARP_OK ||
        scarp_gpu_plan_make(&near, 2, &plans[1], NULL) != SCARP_OK) {
        return 1;
    }
    const VkPipeline pipeline = gpu_make_pipeline(&gpu, argv[1], 0);
    gpu_run(&gpu, pipeline, (struct gpu_push){(uint32_t)count, width});
    const float *const pixels = gpu.buffers[GPU_RESULTS].bytes;
    const size_t differ = differing(pixels, count);
    fprintf(stderr, "%s: %zu of %zu heights and slopes differ from the library's\n",
            gpu.properties.deviceName, differ, 3 * count);
    const int failed = (!is_small && write_ppm(pixels, width, height)) || differ > 0;
    vkDestroyPipeline(gpu.device, pipeline, NULL);
    gpu_close(&gpu);
    return failed;
}
