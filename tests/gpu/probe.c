/* SPDX-License-Identifier: MIT
 *
 * Exits with 0 if there is a Vulkan device that runs compute shaders. gpu_vulkan.cmake compiles and
 * runs this to find out whether tests can use one.
 */
#include "device.h"

int main(void)
{
    struct gpu gpu = {0};
    if (!gpu_find(&gpu)) {
        printf("no Vulkan device\n");
        return EXIT_FAILURE;
    }
    printf("%s\n", gpu.properties.deviceName);
    vkDestroyInstance(gpu.instance, NULL);
    return EXIT_SUCCESS;
}
