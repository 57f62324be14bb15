/* internal.h: what the files of lib/gpu share. */
#ifndef GPU_INTERNAL_H
#define GPU_INTERNAL_H

#include "gpu.h"

#include <vulkan/vulkan.h>

struct gpu_device {
    VkInstance instance;
    VkDebugUtilsMessengerEXT messenger;
    VkPhysicalDevice physical;
    VkDevice device;
    VkQueue queue;
    uint32_t queue_family;
    VkPhysicalDeviceMemoryProperties memory;
    VkCommandPool commands;
    VkFence fence;
    VkQueryPool queries;
    PFN_vkGetPipelineExecutableStatisticsKHR get_statistics;
    gpu_device_info info;
    int message_count;
    char messages[4096];
};

struct gpu_buffer {
    gpu_device *owner;
    VkBuffer buffer;
    VkDeviceMemory memory;
    void *mapped;
    size_t size;
};

struct gpu_texture {
    gpu_device *owner;
    VkImage image;
    VkDeviceMemory memory;
    VkImageView view;
    VkSampler sampler;
};

struct gpu_compute {
    gpu_device *owner;
    int binding_count;
    gpu_binding bindings[GPU_MAX_BINDINGS];
    uint32_t push_size;
    VkDescriptorSetLayout set_layout;
    VkPipelineLayout layout;
    VkPipeline pipeline;
    VkDescriptorPool pool;
    VkDescriptorSet set;
};

/* The status of a Vulkan result that is not VK_SUCCESS, with its line: "what: reason". */
gpu_status gpu_vk(VkResult result, const char *what);

enum { GPU_MAX_DEVICES = 32 };

/* instance.c */
gpu_status gpu_create_instance(gpu_device *device, bool validation);
void gpu_destroy_instance(gpu_device *device);
gpu_status gpu_enumerate(VkInstance instance, VkPhysicalDevice devices[GPU_MAX_DEVICES],
                         uint32_t *count);
void gpu_describe(VkPhysicalDevice physical, VkPhysicalDeviceProperties2 *properties,
                  VkPhysicalDeviceDriverProperties *driver);

/* Index of a memory type with all those properties among the allowed ones, or -1. */
int gpu_memory_type(const gpu_device *device, uint32_t allowed, VkMemoryPropertyFlags properties);

/* Begins a command buffer; gpu_submit ends it, runs it, waits and frees it. */
gpu_status gpu_begin(gpu_device *device, VkCommandBuffer *commands);
gpu_status gpu_submit(gpu_device *device, VkCommandBuffer commands);

#endif
