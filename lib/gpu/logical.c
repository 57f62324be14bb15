/* The device proper: its queue, the features that it has of those that are used, its limits. */
#include "internal.h"

#include <stdlib.h>
#include <string.h>

static bool has_extension(VkPhysicalDevice physical, const char *name)
{
    uint32_t count = 0;
    if (vkEnumerateDeviceExtensionProperties(physical, NULL, &count, NULL) != VK_SUCCESS)
        return false;
    VkExtensionProperties *extensions = calloc(count ? count : 1, sizeof *extensions);
    bool found = false;
    if (extensions &&
        vkEnumerateDeviceExtensionProperties(physical, NULL, &count, extensions) >= VK_SUCCESS)
        for (uint32_t i = 0; i < count && !found; i++)
            found = strcmp(extensions[i].extensionName, name) == 0;
    free(extensions);
    return found;
}

/* The first family that computes and draws, else the first that computes. */
static gpu_status find_queue(gpu_device *device)
{
    VkQueueFamilyProperties families[32];
    uint32_t count = 32;
    vkGetPhysicalDeviceQueueFamilyProperties(device->physical, &count, families);
    int best = -1;
    for (uint32_t i = 0; i < count; i++) {
        bool draws = families[i].queueFlags & VK_QUEUE_GRAPHICS_BIT;
        if (!(families[i].queueFlags & VK_QUEUE_COMPUTE_BIT) ||
            (best >= 0 && (device->draws || !draws)))
            continue;
        best = (int)i;
        device->draws = draws;
        device->queue_family = i;
        device->info.timestamps = families[i].timestampValidBits == 64;
    }
    if (best >= 0)
        return GPU_OK;
    return gpu_fail(GPU_UNSUPPORTED, "%s has no compute queue", device->info.name);
}

/* Of what the device offers, what we use: pipelines that need more than it has are refused when
 * they are made. */
static void choose_features(gpu_device *device, VkPhysicalDeviceFeatures *used,
                            VkPhysicalDeviceVulkan13Features *used13)
{
    VkPhysicalDeviceProperties properties;
    vkGetPhysicalDeviceProperties(device->physical, &properties);
    bool has13 = properties.apiVersion >= VK_API_VERSION_1_3;
    VkPhysicalDeviceVulkan13Features offered13 = {
        .sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_3_FEATURES};
    VkPhysicalDeviceFeatures2 offered = {.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_FEATURES_2,
                                         .pNext = has13 ? &offered13 : NULL};
    vkGetPhysicalDeviceFeatures2(device->physical, &offered);
    *used = (VkPhysicalDeviceFeatures){
        .fragmentStoresAndAtomics = offered.features.fragmentStoresAndAtomics,
        .vertexPipelineStoresAndAtomics = offered.features.vertexPipelineStoresAndAtomics,
        .shaderStorageImageExtendedFormats = offered.features.shaderStorageImageExtendedFormats,
        .drawIndirectFirstInstance = offered.features.drawIndirectFirstInstance,
        .fullDrawIndexUint32 = offered.features.fullDrawIndexUint32};
    *used13 = (VkPhysicalDeviceVulkan13Features){
        .sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_3_FEATURES,
        .dynamicRendering = offered13.dynamicRendering};
    device->draws = device->draws && offered13.dynamicRendering;
}

static VkResult create_logical(gpu_device *device)
{
    const char *statistics = VK_KHR_PIPELINE_EXECUTABLE_PROPERTIES_EXTENSION_NAME;
    device->info.statistics = has_extension(device->physical, statistics);
    VkPhysicalDeviceFeatures features;
    VkPhysicalDeviceVulkan13Features features13;
    choose_features(device, &features, &features13);
    VkPhysicalDevicePipelineExecutablePropertiesFeaturesKHR executable = {
        .sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PIPELINE_EXECUTABLE_PROPERTIES_FEATURES_KHR,
        .pNext = features13.dynamicRendering ? &features13 : NULL,
        .pipelineExecutableInfo = VK_TRUE};
    float priority = 1;
    VkDeviceQueueCreateInfo queue = {.sType = VK_STRUCTURE_TYPE_DEVICE_QUEUE_CREATE_INFO,
                                     .queueFamilyIndex = device->queue_family,
                                     .queueCount = 1,
                                     .pQueuePriorities = &priority};
    VkDeviceCreateInfo info = {.sType = VK_STRUCTURE_TYPE_DEVICE_CREATE_INFO,
                               .pNext = device->info.statistics ? &executable : executable.pNext,
                               .queueCreateInfoCount = 1,
                               .pQueueCreateInfos = &queue,
                               .enabledExtensionCount = device->info.statistics ? 1 : 0,
                               .ppEnabledExtensionNames = &statistics,
                               .pEnabledFeatures = &features};
    return vkCreateDevice(device->physical, &info, NULL, &device->device);
}

static uint32_t find_subgroup(VkPhysicalDevice physical)
{
    const VkSubgroupFeatureFlags used = VK_SUBGROUP_FEATURE_BASIC_BIT |
                                        VK_SUBGROUP_FEATURE_ARITHMETIC_BIT |
                                        VK_SUBGROUP_FEATURE_SHUFFLE_BIT;
    VkPhysicalDeviceSubgroupProperties subgroup = {
        .sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_SUBGROUP_PROPERTIES};
    VkPhysicalDeviceProperties2 properties = {
        .sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PROPERTIES_2, .pNext = &subgroup};
    vkGetPhysicalDeviceProperties2(physical, &properties);
    bool all = (subgroup.supportedOperations & used) == used &&
               (subgroup.supportedStages & VK_SHADER_STAGE_COMPUTE_BIT) != 0;
    return all ? subgroup.subgroupSize : 0;
}

gpu_status gpu_create_device(gpu_device *device)
{
    device->subgroup_invocations = find_subgroup(device->physical);
    gpu_status status = find_queue(device);
    if (status != GPU_OK)
        return status;
    VkResult result = create_logical(device);
    if (result != VK_SUCCESS)
        return gpu_vk(result, device->info.name);
    if (device->info.statistics)
        device->get_statistics = (PFN_vkGetPipelineExecutableStatisticsKHR)(void (*)(
            void))vkGetDeviceProcAddr(device->device, "vkGetPipelineExecutableStatisticsKHR");
    if (device->info.compile_only)
        return GPU_OK;
    vkGetPhysicalDeviceMemoryProperties(device->physical, &device->memory);
    vkGetDeviceQueue(device->device, device->queue_family, 0, &device->queue);
    VkCommandPoolCreateInfo pool = {.sType = VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO,
                                    .queueFamilyIndex = device->queue_family};
    VkFenceCreateInfo fence = {.sType = VK_STRUCTURE_TYPE_FENCE_CREATE_INFO};
    result = vkCreateCommandPool(device->device, &pool, NULL, &device->commands);
    if (result == VK_SUCCESS)
        result = vkCreateFence(device->device, &fence, NULL, &device->fence);
    if (result == VK_SUCCESS && device->info.timestamps)
        result = gpu_need_queries(device, 2);
    return result == VK_SUCCESS ? GPU_OK : gpu_vk(result, device->info.name);
}

gpu_status gpu_check(const gpu_device *device, const gpu_needs *needs)
{
    const VkPhysicalDeviceLimits *limits = &device->limits;
    const struct {
        const char *what;
        size_t need, have;
    } rows[] = {{"invocations in a work group", needs->group_invocations,
                 limits->maxComputeWorkGroupInvocations},
                {"bytes of shared memory", needs->shared_bytes, limits->maxComputeSharedMemorySize},
                {"pixels a side of an image", needs->image_side, limits->maxImageDimension2D},
                {"bytes of a storage buffer", needs->buffer_bytes, limits->maxStorageBufferRange},
                {"invocations in a subgroup, which add and shuffle,", needs->subgroup_invocations,
                 device->subgroup_invocations}};
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++)
        if (rows[i].need > rows[i].have)
            return gpu_fail(GPU_UNSUPPORTED, "%s: %zu %s are needed, it has %zu", device->info.name,
                            rows[i].need, rows[i].what, rows[i].have);
    return GPU_OK;
}
