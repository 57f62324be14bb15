/* internal.h: what the files of lib/gpu share. */
#ifndef GPU_INTERNAL_H
#define GPU_INTERNAL_H

#include "gpu.h"
#include "pass.h"

#include <vulkan/vulkan.h>

typedef struct gpu_kept gpu_kept;

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
    uint32_t query_count; /* in the pool */
    VkSampler nearest;    /* of GPU_FETCHED; made with the first image */
    VkPhysicalDeviceLimits limits;
    uint32_t subgroup_invocations; /* 0 where they do not add and shuffle in compute shaders */
    bool draws;                    /* has a graphics queue and dynamic rendering */
    PFN_vkGetPipelineExecutableStatisticsKHR get_statistics;
    gpu_kept *kept; /* pipelines, see keep.c */
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

struct gpu_image {
    gpu_device *owner;
    gpu_format format;
    uint32_t width, height;
    VkImage image;
    VkDeviceMemory memory;
    VkImageView view;
};

/* What a pipeline is bound to: set 0 and push constants. */
typedef struct gpu_layout {
    int binding_count;
    gpu_binding bindings[GPU_MAX_BINDINGS];
    uint32_t push_size;
    VkShaderStageFlags stages;
    VkDescriptorSetLayout set;
    VkPipelineLayout pipeline;
} gpu_layout;

struct gpu_compute {
    gpu_device *owner;
    gpu_layout layout;
    VkPipeline pipeline;
    VkDescriptorPool pool;
    VkDescriptorSet set;
    bool kept; /* until the device is closed */
};

struct gpu_draw {
    gpu_device *owner;
    gpu_layout layout;
    VkPipeline pipeline;
    int target_count;
    gpu_format targets[GPU_MAX_TARGETS];
    bool depth;
    bool kept;
};

/* The status of a Vulkan result that is not VK_SUCCESS, with its line: "what: reason". */
gpu_status gpu_vk(VkResult result, const char *what);

enum { GPU_MAX_DEVICES = 32 };

/* crash.c: where memory is limited, a crash is told in one line and ends the program with status 1.
 */
void gpu_tell_of_crashes(void);

/* instance.c */
gpu_status gpu_create_instance(gpu_device *device, bool validation);
void gpu_destroy_instance(gpu_device *device);
gpu_status gpu_enumerate(VkInstance instance, VkPhysicalDevice devices[GPU_MAX_DEVICES],
                         uint32_t *count);
void gpu_describe(VkPhysicalDevice physical, VkPhysicalDeviceProperties2 *properties,
                  VkPhysicalDeviceDriverProperties *driver);

/* logical.c: the device proper, its queue, and what is made once for it. */
gpu_status gpu_create_device(gpu_device *device);

/* keep.c. Asking: where the device keeps such a pipeline it is stored, and NULL returned; else an
 * entry for gpu_keep, or NULL where such a pipeline is not kept. */
gpu_kept *gpu_kept_compute(gpu_device *device, const gpu_compute_options *options,
                           gpu_compute **compute);
gpu_kept *gpu_kept_draw(gpu_device *device, const gpu_draw_options *options, gpu_draw **draw);
/* Keeps one of the two from now on; entry NULL: does nothing. */
void gpu_keep(gpu_device *device, gpu_kept *entry, gpu_compute *compute, gpu_draw *draw);
void gpu_keep_no_more(gpu_device *device);

/* layout.c */
VkResult gpu_layout_create(gpu_device *device, gpu_layout *layout);

/* constant_id 0 of a stage, nothing where it is 0. The value is pointed to. */
VkSpecializationInfo gpu_constants(const float *constant);
void gpu_layout_destroy(gpu_device *device, gpu_layout *layout);
/* A pool for one set of each layout that is given; none, and NULL, where count is 0. */
VkResult gpu_layout_pool(gpu_device *device, const gpu_layout *const *layouts, size_t count,
                         VkDescriptorPool *pool);
gpu_status gpu_layout_write(gpu_device *device, const gpu_layout *layout, const char *name,
                            void *const *resources, VkDescriptorSet set);

/* shader.c: a module of SPIR-V words or, where these are NULL, of GLSL. */
gpu_status gpu_module_create(gpu_device *device, gpu_stage stage, const char *name,
                             const gpu_shader *shader, VkShaderModule *module);

/* record.c: the layout of a step's pipeline, NULL where it has none; a barrier of all before
 * against all after; one checked step. */
const gpu_layout *gpu_step_layout(const gpu_step *step);
void gpu_record_barrier(VkCommandBuffer commands);
void gpu_record_step(VkCommandBuffer commands, const gpu_step *step, VkDescriptorSet set);

/* image.c */
VkFormat gpu_format_vk(gpu_format format);

/* memory.c: a pool of at least that many timestamps in device->queries. */
VkResult gpu_need_queries(gpu_device *device, uint32_t count);

/* Index of a memory type with all those properties among the allowed ones, or -1. */
int gpu_memory_type(const gpu_device *device, uint32_t allowed, VkMemoryPropertyFlags properties);

/* Begins a command buffer; gpu_submit ends it, runs it, waits and frees it. */
gpu_status gpu_begin(gpu_device *device, VkCommandBuffer *commands);
gpu_status gpu_submit(gpu_device *device, VkCommandBuffer commands);

#endif
