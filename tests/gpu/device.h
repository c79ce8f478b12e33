/* SPDX-License-Identifier: MIT
 *
 * As much of Vulkan as it takes to run a compute shader with one uniform buffer and two storage
 * buffers, all of which the processor can write. Included by vulkan.c and probe.c.
 */
#ifndef SCARP_TESTS_GPU_DEVICE_H
#define SCARP_TESTS_GPU_DEVICE_H

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <vulkan/vulkan.h>

/* A call that must succeed: a driver that fails is no result of a test. */
#define GPU_CALL(call)                                                                             \
    do {                                                                                           \
        const VkResult gpu_result = (call);                                                        \
        if (gpu_result != VK_SUCCESS) {                                                            \
            printf("%s:%d: %s: %d\n", __FILE__, __LINE__, #call, (int)gpu_result);                 \
            exit(EXIT_FAILURE);                                                                    \
        }                                                                                          \
    } while (0)

enum { GPU_PLAN, GPU_POINTS, GPU_RESULTS, GPU_BUFFERS }; /* by binding */

struct gpu_buffer {
    VkBuffer buffer;
    VkDeviceMemory memory;
    void *bytes;
};

struct gpu {
    VkInstance instance;
    VkPhysicalDevice physical;
    VkPhysicalDeviceProperties properties;
    int rounds; /* whether shaders may demand that the device rounds to nearest */
    uint32_t family;
    VkDevice device;
    VkQueue queue;
    VkCommandPool commands;
    VkCommandBuffer command;
    VkDescriptorSetLayout set_layout;
    VkPipelineLayout layout;
    VkDescriptorPool sets;
    VkDescriptorSet set;
    struct gpu_buffer buffers[GPU_BUFFERS];
};

struct gpu_push {
    uint32_t count, order;
};

/* How much a kind of device is wanted. */
static inline int gpu_rank(VkPhysicalDeviceType type)
{
    return type == VK_PHYSICAL_DEVICE_TYPE_DISCRETE_GPU     ? 4
           : type == VK_PHYSICAL_DEVICE_TYPE_INTEGRATED_GPU ? 3
           : type == VK_PHYSICAL_DEVICE_TYPE_VIRTUAL_GPU    ? 2
                                                            : 1;
}

/* The first family of queues that runs compute shaders, or -1. */
static inline int gpu_family(VkPhysicalDevice device)
{
    VkQueueFamilyProperties families[16];
    uint32_t count = 16;
    vkGetPhysicalDeviceQueueFamilyProperties(device, &count, families);
    for (uint32_t i = 0; i < count; i++) {
        if ((families[i].queueFlags & VK_QUEUE_COMPUTE_BIT) != 0) {
            return (int)i;
        }
    }
    return -1;
}

/* Whether a device of Vulkan 1.2 lets shaders demand rounding to nearest. */
static inline int gpu_rounds(VkPhysicalDevice device)
{
    VkPhysicalDeviceFloatControlsProperties floats = {
        .sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_FLOAT_CONTROLS_PROPERTIES};
    VkPhysicalDeviceProperties2 all = {.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PROPERTIES_2,
                                       .pNext = &floats};
    vkGetPhysicalDeviceProperties2(device, &all);
    return floats.shaderRoundingModeRTEFloat32 == VK_TRUE;
}

/* Takes a real graphics processor if there is one. Returns 0 if there is no device at all. */
static inline int gpu_find(struct gpu *gpu)
{
    const VkApplicationInfo application = {.sType = VK_STRUCTURE_TYPE_APPLICATION_INFO,
                                           .apiVersion = VK_API_VERSION_1_2};
    const VkInstanceCreateInfo info = {.sType = VK_STRUCTURE_TYPE_INSTANCE_CREATE_INFO,
                                       .pApplicationInfo = &application};
    if (vkCreateInstance(&info, NULL, &gpu->instance) != VK_SUCCESS) {
        return 0;
    }
    VkPhysicalDevice devices[16];
    uint32_t count = 16;
    int best = 0;
    const VkResult result = vkEnumeratePhysicalDevices(gpu->instance, &count, devices);
    for (uint32_t i = 0; (result == VK_SUCCESS || result == VK_INCOMPLETE) && i < count; i++) {
        VkPhysicalDeviceProperties properties;
        vkGetPhysicalDeviceProperties(devices[i], &properties);
        const int family = gpu_family(devices[i]);
        if (family >= 0 && gpu_rank(properties.deviceType) > best) {
            best = gpu_rank(properties.deviceType);
            gpu->family = (uint32_t)family;
            gpu->physical = devices[i];
            gpu->properties = properties;
        }
    }
    if (best > 0 && gpu->properties.apiVersion >= VK_API_VERSION_1_2) {
        gpu->rounds = gpu_rounds(gpu->physical);
    }
    return best > 0;
}

/* A type of memory that the processor sees, without flushing, and that the buffer can be in. */
static inline uint32_t gpu_memory_type(const struct gpu *gpu, uint32_t types)
{
    const VkMemoryPropertyFlags wanted =
        VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT | VK_MEMORY_PROPERTY_HOST_COHERENT_BIT;
    VkPhysicalDeviceMemoryProperties memory;
    vkGetPhysicalDeviceMemoryProperties(gpu->physical, &memory);
    for (uint32_t i = 0; i < memory.memoryTypeCount; i++) {
        if ((types >> i & 1) != 0 && (memory.memoryTypes[i].propertyFlags & wanted) == wanted) {
            return i;
        }
    }
    printf("no memory that both sides see\n");
    exit(EXIT_FAILURE);
}

static inline struct gpu_buffer gpu_make_buffer(const struct gpu *gpu, VkDeviceSize size,
                                                VkBufferUsageFlags usage)
{
    struct gpu_buffer made;
    const VkBufferCreateInfo info = {
        .sType = VK_STRUCTURE_TYPE_BUFFER_CREATE_INFO, .size = size, .usage = usage};
    GPU_CALL(vkCreateBuffer(gpu->device, &info, NULL, &made.buffer));
    VkMemoryRequirements needs;
    vkGetBufferMemoryRequirements(gpu->device, made.buffer, &needs);
    const VkMemoryAllocateInfo memory = {.sType = VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO,
                                         .allocationSize = needs.size,
                                         .memoryTypeIndex =
                                             gpu_memory_type(gpu, needs.memoryTypeBits)};
    GPU_CALL(vkAllocateMemory(gpu->device, &memory, NULL, &made.memory));
    GPU_CALL(vkBindBufferMemory(gpu->device, made.buffer, made.memory, 0));
    GPU_CALL(vkMapMemory(gpu->device, made.memory, 0, VK_WHOLE_SIZE, 0, &made.bytes));
    return made;
}

static inline VkDescriptorType gpu_kind(uint32_t binding)
{
    return binding == GPU_PLAN ? VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER
                               : VK_DESCRIPTOR_TYPE_STORAGE_BUFFER;
}

static inline void gpu_make_device(struct gpu *gpu)
{
    const float priority = 1.0f;
    const VkDeviceQueueCreateInfo queue = {.sType = VK_STRUCTURE_TYPE_DEVICE_QUEUE_CREATE_INFO,
                                           .queueFamilyIndex = gpu->family,
                                           .queueCount = 1,
                                           .pQueuePriorities = &priority};
    const VkDeviceCreateInfo device = {.sType = VK_STRUCTURE_TYPE_DEVICE_CREATE_INFO,
                                       .queueCreateInfoCount = 1,
                                       .pQueueCreateInfos = &queue};
    GPU_CALL(vkCreateDevice(gpu->physical, &device, NULL, &gpu->device));
    vkGetDeviceQueue(gpu->device, gpu->family, 0, &gpu->queue);
    const VkCommandPoolCreateInfo pool = {.sType = VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO,
                                          .flags = VK_COMMAND_POOL_CREATE_RESET_COMMAND_BUFFER_BIT,
                                          .queueFamilyIndex = gpu->family};
    GPU_CALL(vkCreateCommandPool(gpu->device, &pool, NULL, &gpu->commands));
    const VkCommandBufferAllocateInfo command = {.sType =
                                                     VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO,
                                                 .commandPool = gpu->commands,
                                                 .level = VK_COMMAND_BUFFER_LEVEL_PRIMARY,
                                                 .commandBufferCount = 1};
    GPU_CALL(vkAllocateCommandBuffers(gpu->device, &command, &gpu->command));
}

/* Says which buffers shaders find where. */
static inline void gpu_make_layout(struct gpu *gpu)
{
    VkDescriptorSetLayoutBinding bindings[GPU_BUFFERS];
    for (uint32_t i = 0; i < GPU_BUFFERS; i++) {
        bindings[i] = (VkDescriptorSetLayoutBinding){.binding = i,
                                                     .descriptorType = gpu_kind(i),
                                                     .descriptorCount = 1,
                                                     .stageFlags = VK_SHADER_STAGE_COMPUTE_BIT};
    }
    const VkDescriptorSetLayoutCreateInfo set = {
        .sType = VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_CREATE_INFO,
        .bindingCount = GPU_BUFFERS,
        .pBindings = bindings};
    GPU_CALL(vkCreateDescriptorSetLayout(gpu->device, &set, NULL, &gpu->set_layout));
    const VkPushConstantRange push = {.stageFlags = VK_SHADER_STAGE_COMPUTE_BIT,
                                      .size = sizeof(struct gpu_push)};
    const VkPipelineLayoutCreateInfo layout = {.sType =
                                                   VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO,
                                               .setLayoutCount = 1,
                                               .pSetLayouts = &gpu->set_layout,
                                               .pushConstantRangeCount = 1,
                                               .pPushConstantRanges = &push};
    GPU_CALL(vkCreatePipelineLayout(gpu->device, &layout, NULL, &gpu->layout));
}

static inline void gpu_make_set(struct gpu *gpu)
{
    const VkDescriptorPoolSize sizes[2] = {{VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER, 1},
                                           {VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, 2}};
    const VkDescriptorPoolCreateInfo pool = {.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_POOL_CREATE_INFO,
                                             .maxSets = 1,
                                             .poolSizeCount = 2,
                                             .pPoolSizes = sizes};
    GPU_CALL(vkCreateDescriptorPool(gpu->device, &pool, NULL, &gpu->sets));
    const VkDescriptorSetAllocateInfo set = {.sType =
                                                 VK_STRUCTURE_TYPE_DESCRIPTOR_SET_ALLOCATE_INFO,
                                             .descriptorPool = gpu->sets,
                                             .descriptorSetCount = 1,
                                             .pSetLayouts = &gpu->set_layout};
    GPU_CALL(vkAllocateDescriptorSets(gpu->device, &set, &gpu->set));
    for (uint32_t i = 0; i < GPU_BUFFERS; i++) {
        const VkDescriptorBufferInfo buffer = {gpu->buffers[i].buffer, 0, VK_WHOLE_SIZE};
        const VkWriteDescriptorSet write = {.sType = VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET,
                                            .dstSet = gpu->set,
                                            .dstBinding = i,
                                            .descriptorCount = 1,
                                            .descriptorType = gpu_kind(i),
                                            .pBufferInfo = &buffer};
        vkUpdateDescriptorSets(gpu->device, 1, &write, 0, NULL);
    }
}

/* Opens the device that gpu_find found, with buffers of these sizes in bytes. */
static inline void gpu_open(struct gpu *gpu, const VkDeviceSize sizes[GPU_BUFFERS])
{
    gpu_make_device(gpu);
    for (int i = 0; i < GPU_BUFFERS; i++) {
        gpu->buffers[i] = gpu_make_buffer(gpu, sizes[i],
                                          i == GPU_PLAN ? VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT
                                                        : VK_BUFFER_USAGE_STORAGE_BUFFER_BIT);
    }
    gpu_make_layout(gpu);
    gpu_make_set(gpu);
}

/* The words of a file of SPIR-V, to be freed. */
static inline uint32_t *gpu_read(const char *path, size_t *size)
{
    FILE *file = fopen(path, "rb");
    if (file == NULL || fseek(file, 0, SEEK_END) != 0) {
        printf("%s cannot be read\n", path);
        exit(EXIT_FAILURE);
    }
    const long end = ftell(file);
    uint32_t *words = end > 0 ? malloc((size_t)end) : NULL;
    rewind(file);
    *size = words != NULL ? fread(words, 1, (size_t)end, file) : 0;
    fclose(file);
    if (*size == 0 || *size != (size_t)end) {
        printf("%s cannot be read\n", path);
        exit(EXIT_FAILURE);
    }
    return words;
}

/* Makes a pipeline of the shader in a file, whose constant 0 is `task`. */
static inline VkPipeline gpu_make_pipeline(const struct gpu *gpu, const char *path, uint32_t task)
{
    VkShaderModuleCreateInfo code = {.sType = VK_STRUCTURE_TYPE_SHADER_MODULE_CREATE_INFO};
    uint32_t *words = gpu_read(path, &code.codeSize);
    code.pCode = words;
    VkShaderModule module;
    GPU_CALL(vkCreateShaderModule(gpu->device, &code, NULL, &module));
    const VkSpecializationMapEntry entry = {0, 0, sizeof task};
    const VkSpecializationInfo constants = {1, &entry, sizeof task, &task};
    const VkComputePipelineCreateInfo info = {
        .sType = VK_STRUCTURE_TYPE_COMPUTE_PIPELINE_CREATE_INFO,
        .stage = {.sType = VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO,
                  .stage = VK_SHADER_STAGE_COMPUTE_BIT,
                  .module = module,
                  .pName = "main",
                  .pSpecializationInfo = &constants},
        .layout = gpu->layout};
    VkPipeline pipeline;
    GPU_CALL(vkCreateComputePipelines(gpu->device, VK_NULL_HANDLE, 1, &info, NULL, &pipeline));
    vkDestroyShaderModule(gpu->device, module, NULL);
    free(words);
    return pipeline;
}

/* Runs the pipeline for `push.count` points and waits until it is done. */
static inline void gpu_run(const struct gpu *gpu, VkPipeline pipeline, struct gpu_push push)
{
    const VkCommandBufferBeginInfo begin = {.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO};
    const VkMemoryBarrier written = {.sType = VK_STRUCTURE_TYPE_MEMORY_BARRIER,
                                     .srcAccessMask = VK_ACCESS_SHADER_WRITE_BIT,
                                     .dstAccessMask = VK_ACCESS_HOST_READ_BIT};
    GPU_CALL(vkBeginCommandBuffer(gpu->command, &begin));
    vkCmdBindPipeline(gpu->command, VK_PIPELINE_BIND_POINT_COMPUTE, pipeline);
    vkCmdBindDescriptorSets(gpu->command, VK_PIPELINE_BIND_POINT_COMPUTE, gpu->layout, 0, 1,
                            &gpu->set, 0, NULL);
    vkCmdPushConstants(gpu->command, gpu->layout, VK_SHADER_STAGE_COMPUTE_BIT, 0, sizeof push,
                       &push);
    vkCmdDispatch(gpu->command, (push.count + 63) / 64, 1, 1);
    vkCmdPipelineBarrier(gpu->command, VK_PIPELINE_STAGE_COMPUTE_SHADER_BIT,
                         VK_PIPELINE_STAGE_HOST_BIT, 0, 1, &written, 0, NULL, 0, NULL);
    GPU_CALL(vkEndCommandBuffer(gpu->command));
    const VkSubmitInfo submit = {.sType = VK_STRUCTURE_TYPE_SUBMIT_INFO,
                                 .commandBufferCount = 1,
                                 .pCommandBuffers = &gpu->command};
    GPU_CALL(vkQueueSubmit(gpu->queue, 1, &submit, VK_NULL_HANDLE));
    GPU_CALL(vkQueueWaitIdle(gpu->queue));
}

/* Closes the device, but for its pipelines, which must be gone. */
static inline void gpu_close(struct gpu *gpu)
{
    for (int i = 0; i < GPU_BUFFERS; i++) {
        vkDestroyBuffer(gpu->device, gpu->buffers[i].buffer, NULL);
        vkFreeMemory(gpu->device, gpu->buffers[i].memory, NULL);
    }
    vkDestroyDescriptorPool(gpu->device, gpu->sets, NULL);
    vkDestroyPipelineLayout(gpu->device, gpu->layout, NULL);
    vkDestroyDescriptorSetLayout(gpu->device, gpu->set_layout, NULL);
    vkDestroyCommandPool(gpu->device, gpu->commands, NULL);
    vkDestroyDevice(gpu->device, NULL);
    vkDestroyInstance(gpu->instance, NULL);
}

#endif
