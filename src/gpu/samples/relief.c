/* SPDX-License-Identifier: MIT
 *
 * Draws a relief whose heights and slopes a Vulkan device computes, and compares them with those of
 * the library: what host code needs for scarp.glsl, from start to end.
 *
 *     relief PICTURE.ppm relief.spv     relief.spv is relief.comp, compiled
 *     relief PICTURE.ppm                the same picture, by the library alone
 *     relief NAME.plan                  only writes the plan, for webgpu.html and webgl.html
 */
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <vulkan/vulkan.h>

#include "relief.h"

static void check(int is_ok, const char *what)
{
    if (!is_ok) {
        fprintf(stderr, "relief: %s failed\n", what);
        exit(EXIT_FAILURE);
    }
}

#define CALL(call) check((call) == VK_SUCCESS, #call)

struct buffer {
    VkBuffer buffer;
    VkDeviceMemory memory;
    void *bytes; /* where the processor sees it */
};

struct gpu {
    VkInstance instance;
    VkPhysicalDevice physical;
    VkDevice device;
    VkQueue queue;
    VkCommandPool pool;
    VkDescriptorSetLayout set_layout;
    VkPipelineLayout layout;
    VkDescriptorPool sets;
    VkDescriptorSet set;
    VkShaderModule shader;
    struct buffer plan, results;
};

/* Opens the first device that computes. */
static void open_device(struct gpu *gpu)
{
    const VkApplicationInfo application = {.sType = VK_STRUCTURE_TYPE_APPLICATION_INFO,
                                           .apiVersion = VK_API_VERSION_1_1};
    const VkInstanceCreateInfo instance = {.sType = VK_STRUCTURE_TYPE_INSTANCE_CREATE_INFO,
                                           .pApplicationInfo = &application};
    CALL(vkCreateInstance(&instance, NULL, &gpu->instance));
    VkPhysicalDevice devices[8];
    uint32_t count = 8, family = UINT32_MAX;
    check(vkEnumeratePhysicalDevices(gpu->instance, &count, devices) >= 0, "listing devices");
    for (uint32_t i = 0; i < count && family == UINT32_MAX; i++) {
        VkQueueFamilyProperties families[16];
        uint32_t kinds = 16;
        vkGetPhysicalDeviceQueueFamilyProperties(devices[i], &kinds, families);
        for (uint32_t k = 0; k < kinds && family == UINT32_MAX; k++) {
            if ((families[k].queueFlags & VK_QUEUE_COMPUTE_BIT) != 0) {
                gpu->physical = devices[i];
                family = k;
            }
        }
    }
    check(family != UINT32_MAX, "finding a device that computes");
    const float priority = 1.0f;
    const VkDeviceQueueCreateInfo queue = {.sType = VK_STRUCTURE_TYPE_DEVICE_QUEUE_CREATE_INFO,
                                           .queueFamilyIndex = family,
                                           .queueCount = 1,
                                           .pQueuePriorities = &priority};
    const VkDeviceCreateInfo device = {.sType = VK_STRUCTURE_TYPE_DEVICE_CREATE_INFO,
                                       .queueCreateInfoCount = 1,
                                       .pQueueCreateInfos = &queue};
    const VkCommandPoolCreateInfo pool = {.sType = VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO,
                                          .queueFamilyIndex = family};
    CALL(vkCreateDevice(gpu->physical, &device, NULL, &gpu->device));
    CALL(vkCreateCommandPool(gpu->device, &pool, NULL, &gpu->pool));
    vkGetDeviceQueue(gpu->device, family, 0, &gpu->queue);
}

/* A buffer that both sides see, which is simple; large results are faster in memory of the device.
 */
static struct buffer make_buffer(const struct gpu *gpu, VkDeviceSize size, VkBufferUsageFlags usage)
{
    const VkMemoryPropertyFlags wanted =
        VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT | VK_MEMORY_PROPERTY_HOST_COHERENT_BIT;
    const VkBufferCreateInfo info = {
        .sType = VK_STRUCTURE_TYPE_BUFFER_CREATE_INFO, .size = size, .usage = usage};
    struct buffer made;
    VkMemoryRequirements needs;
    VkPhysicalDeviceMemoryProperties memory;
    CALL(vkCreateBuffer(gpu->device, &info, NULL, &made.buffer));
    vkGetBufferMemoryRequirements(gpu->device, made.buffer, &needs);
    vkGetPhysicalDeviceMemoryProperties(gpu->physical, &memory);
    uint32_t type = 0;
    while (type < memory.memoryTypeCount &&
           ((needs.memoryTypeBits >> type & 1) == 0 ||
            (memory.memoryTypes[type].propertyFlags & wanted) != wanted)) {
        type++;
    }
    const VkMemoryAllocateInfo allocation = {.sType = VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO,
                                             .allocationSize = needs.size,
                                             .memoryTypeIndex = type};
    CALL(vkAllocateMemory(gpu->device, &allocation, NULL, &made.memory));
    CALL(vkBindBufferMemory(gpu->device, made.buffer, made.memory, 0));
    CALL(vkMapMemory(gpu->device, made.memory, 0, VK_WHOLE_SIZE, 0, &made.bytes));
    return made;
}

/* Binding 0 is the plan, a uniform buffer; binding 1 the results, a storage buffer. */
static void bind_buffers(struct gpu *gpu)
{
    VkDescriptorSetLayoutBinding bindings[2];
    VkDescriptorPoolSize sizes[2];
    const VkDescriptorBufferInfo buffers[2] = {{gpu->plan.buffer, 0, VK_WHOLE_SIZE},
                                               {gpu->results.buffer, 0, VK_WHOLE_SIZE}};
    VkWriteDescriptorSet writes[2];
    for (uint32_t i = 0; i < 2; i++) {
        const VkDescriptorType type =
            i == 0 ? VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER : VK_DESCRIPTOR_TYPE_STORAGE_BUFFER;
        bindings[i] = (VkDescriptorSetLayoutBinding){i, type, 1, VK_SHADER_STAGE_COMPUTE_BIT, NULL};
        sizes[i] = (VkDescriptorPoolSize){type, 1};
        writes[i] = (VkWriteDescriptorSet){.sType = VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET,
                                           .dstBinding = i,
                                           .descriptorCount = 1,
                                           .descriptorType = type,
                                           .pBufferInfo = &buffers[i]};
    }
    const VkDescriptorSetLayoutCreateInfo set_layout = {
        .sType = VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_CREATE_INFO,
        .bindingCount = 2,
        .pBindings = bindings};
    const VkDescriptorPoolCreateInfo pool = {.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_POOL_CREATE_INFO,
                                             .maxSets = 1,
                                             .poolSizeCount = 2,
                                             .pPoolSizes = sizes};
    CALL(vkCreateDescriptorSetLayout(gpu->device, &set_layout, NULL, &gpu->set_layout));
    CALL(vkCreateDescriptorPool(gpu->device, &pool, NULL, &gpu->sets));
    const VkDescriptorSetAllocateInfo set = {.sType =
                                                 VK_STRUCTURE_TYPE_DESCRIPTOR_SET_ALLOCATE_INFO,
                                             .descriptorPool = gpu->sets,
                                             .descriptorSetCount = 1,
                                             .pSetLayouts = &gpu->set_layout};
    CALL(vkAllocateDescriptorSets(gpu->device, &set, &gpu->set));
    writes[0].dstSet = writes[1].dstSet = gpu->set;
    vkUpdateDescriptorSets(gpu->device, 2, writes, 0, NULL);
    const VkPushConstantRange push = {VK_SHADER_STAGE_COMPUTE_BIT, 0, 2 * sizeof(uint32_t)};
    const VkPipelineLayoutCreateInfo layout = {.sType =
                                                   VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO,
                                               .setLayoutCount = 1,
                                               .pSetLayouts = &gpu->set_layout,
                                               .pushConstantRangeCount = 1,
                                               .pPushConstantRanges = &push};
    CALL(vkCreatePipelineLayout(gpu->device, &layout, NULL, &gpu->layout));
}

static void load_shader(struct gpu *gpu, const char *path)
{
    enum { MOST = 1 << 20 };
    uint32_t *const words = malloc(MOST);
    FILE *const file = fopen(path, "rb");
    check(words != NULL && file != NULL, "opening the shader");
    const VkShaderModuleCreateInfo info = {.sType = VK_STRUCTURE_TYPE_SHADER_MODULE_CREATE_INFO,
                                           .codeSize = fread(words, 1, MOST, file),
                                           .pCode = words};
    check(info.codeSize > 0 && info.codeSize < MOST, "reading the shader");
    fclose(file);
    CALL(vkCreateShaderModule(gpu->device, &info, NULL, &gpu->shader));
    free(words);
}

/* Runs the shader, with its constant `tests`, and waits for the results. */
static void run(const struct gpu *gpu, VkBool32 tests, uint32_t count)
{
    const VkSpecializationMapEntry entry = {0, 0, sizeof tests};
    const VkSpecializationInfo constants = {1, &entry, sizeof tests, &tests};
    const VkComputePipelineCreateInfo info = {
        .sType = VK_STRUCTURE_TYPE_COMPUTE_PIPELINE_CREATE_INFO,
        .stage = {.sType = VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO,
                  .stage = VK_SHADER_STAGE_COMPUTE_BIT,
                  .module = gpu->shader,
                  .pName = "main",
                  .pSpecializationInfo = &constants},
        .layout = gpu->layout};
    VkPipeline pipeline;
    CALL(vkCreateComputePipelines(gpu->device, VK_NULL_HANDLE, 1, &info, NULL, &pipeline));
    const VkCommandBufferAllocateInfo allocation = {
        .sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO,
        .commandPool = gpu->pool,
        .level = VK_COMMAND_BUFFER_LEVEL_PRIMARY,
        .commandBufferCount = 1};
    VkCommandBuffer commands;
    CALL(vkAllocateCommandBuffers(gpu->device, &allocation, &commands));
    const VkCommandBufferBeginInfo begin = {.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO};
    const VkMemoryBarrier written = {.sType = VK_STRUCTURE_TYPE_MEMORY_BARRIER,
                                     .srcAccessMask = VK_ACCESS_SHADER_WRITE_BIT,
                                     .dstAccessMask = VK_ACCESS_HOST_READ_BIT};
    const uint32_t push[2] = {count, RELIEF_WIDTH};
    CALL(vkBeginCommandBuffer(commands, &begin));
    vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_COMPUTE, pipeline);
    vkCmdBindDescriptorSets(commands, VK_PIPELINE_BIND_POINT_COMPUTE, gpu->layout, 0, 1, &gpu->set,
                            0, NULL);
    vkCmdPushConstants(commands, gpu->layout, VK_SHADER_STAGE_COMPUTE_BIT, 0, sizeof push, push);
    vkCmdDispatch(commands, (count + 63) / 64, 1, 1);
    vkCmdPipelineBarrier(commands, VK_PIPELINE_STAGE_COMPUTE_SHADER_BIT, VK_PIPELINE_STAGE_HOST_BIT,
                         0, 1, &written, 0, NULL, 0, NULL);
    CALL(vkEndCommandBuffer(commands));
    const VkSubmitInfo submit = {.sType = VK_STRUCTURE_TYPE_SUBMIT_INFO,
                                 .commandBufferCount = 1,
                                 .pCommandBuffers = &commands};
    CALL(vkQueueSubmit(gpu->queue, 1, &submit, VK_NULL_HANDLE));
    CALL(vkQueueWaitIdle(gpu->queue));
    vkFreeCommandBuffers(gpu->device, gpu->pool, 1, &commands);
    vkDestroyPipeline(gpu->device, pipeline, NULL);
}

static void close_device(struct gpu *gpu)
{
    const struct buffer buffers[2] = {gpu->plan, gpu->results};
    for (int i = 0; i < 2; i++) {
        vkDestroyBuffer(gpu->device, buffers[i].buffer, NULL);
        vkFreeMemory(gpu->device, buffers[i].memory, NULL);
    }
    vkDestroyShaderModule(gpu->device, gpu->shader, NULL);
    vkDestroyPipelineLayout(gpu->device, gpu->layout, NULL);
    vkDestroyDescriptorPool(gpu->device, gpu->sets, NULL);
    vkDestroyDescriptorSetLayout(gpu->device, gpu->set_layout, NULL);
    vkDestroyCommandPool(gpu->device, gpu->pool, NULL);
    vkDestroyDevice(gpu->device, NULL);
    vkDestroyInstance(gpu->instance, NULL);
}

/* Says whether this driver keeps the bits, by the self-test. */
static void ask_driver(const struct gpu *gpu)
{
    static uint32_t answers[SCARP_GPU_ANSWERS];
    check(scarp_gpu_answers(&relief_ground, 2, 1, answers) == SCARP_OK, "scarp_gpu_answers");
    run(gpu, VK_TRUE, SCARP_GPU_ANSWERS);
    const uint32_t *const given = gpu->results.bytes;
    int equal = 0;
    for (int i = 0; i < SCARP_GPU_ANSWERS; i++) {
        equal += given[i] == answers[i];
    }
    VkPhysicalDeviceProperties properties;
    vkGetPhysicalDeviceProperties(gpu->physical, &properties);
    printf("%s %s the bits: %d of %d answers are equal\n", properties.deviceName,
           equal == SCARP_GPU_ANSWERS ? "keeps" : "DOES NOT KEEP", equal, SCARP_GPU_ANSWERS);
}

/* Compares every 97th pixel with the library. */
static void compare(const struct relief *terrain)
{
    int equal = 0, count = 0;
    for (int i = 0; i < RELIEF_PIXELS; i += 97, count++) {
        const float x = (float)(i % RELIEF_WIDTH), y = (float)(i / RELIEF_WIDTH);
        float value;
        const struct scarp_samples out = {.value = &value};
        check(scarp_sample2(&relief_ground, 1, &x, &y, &out) == SCARP_OK, "scarp_sample2");
        equal += memcmp(&value, &terrain->value[i], sizeof value) == 0;
    }
    printf("%d of %d heights are the library's\n", equal, count);
}

/* Lets the device compute the terrain. */
static void compute(struct relief *terrain, const char *shader)
{
    struct gpu gpu;
    struct scarp_gpu_plan plan;
    check(scarp_gpu_plan_make(&relief_ground, 2, &plan, NULL) == SCARP_OK, "scarp_gpu_plan_make");
    open_device(&gpu);
    gpu.plan = make_buffer(&gpu, sizeof plan, VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT);
    gpu.results = make_buffer(&gpu, sizeof *terrain, VK_BUFFER_USAGE_STORAGE_BUFFER_BIT);
    memcpy(gpu.plan.bytes, &plan, sizeof plan);
    bind_buffers(&gpu);
    load_shader(&gpu, shader);
    ask_driver(&gpu);
    run(&gpu, VK_FALSE, RELIEF_PIXELS);
    memcpy(terrain, gpu.results.bytes, sizeof *terrain);
    close_device(&gpu);
    compare(terrain);
}

int main(int argc, char **argv)
{
    static struct relief terrain;
    if (argc != 2 && argc != 3) {
        fprintf(stderr, "usage: relief PICTURE.ppm [relief.spv], or relief NAME.plan\n");
        return EXIT_FAILURE;
    }
    const char *const ending = strrchr(argv[1], '.');
    if (ending != NULL && strcmp(ending, ".plan") == 0) {
        check(relief_write_plan(argv[1]), "writing the plan");
        return EXIT_SUCCESS;
    }
    if (argc == 3) {
        compute(&terrain, argv[2]);
    } else {
        check(relief_by_library(&terrain) == SCARP_OK, "scarp_sample2");
    }
    check(relief_write(&terrain, argv[1]), "writing the picture");
    return EXIT_SUCCESS;
}
