/* Compute pipelines and their dispatch. */
#include "internal.h"

#include <stdlib.h>
#include <string.h>
#include <time.h>

static VkDescriptorType descriptor_type(gpu_binding binding)
{
    return binding == GPU_STORAGE_BUFFER ? VK_DESCRIPTOR_TYPE_STORAGE_BUFFER
                                         : VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER;
}

static VkResult create_layout(gpu_compute *compute)
{
    VkDevice device = compute->owner->device;
    VkDescriptorSetLayoutBinding bindings[GPU_MAX_BINDINGS];
    for (int i = 0; i < compute->binding_count; i++)
        bindings[i] =
            (VkDescriptorSetLayoutBinding){.binding = (uint32_t)i,
                                           .descriptorType = descriptor_type(compute->bindings[i]),
                                           .descriptorCount = 1,
                                           .stageFlags = VK_SHADER_STAGE_COMPUTE_BIT};
    VkDescriptorSetLayoutCreateInfo set = {.sType =
                                               VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_CREATE_INFO,
                                           .bindingCount = (uint32_t)compute->binding_count,
                                           .pBindings = bindings};
    VkResult result = vkCreateDescriptorSetLayout(device, &set, NULL, &compute->set_layout);
    if (result != VK_SUCCESS)
        return result;
    VkPushConstantRange push = {.stageFlags = VK_SHADER_STAGE_COMPUTE_BIT,
                                .size = compute->push_size};
    VkPipelineLayoutCreateInfo layout = {.sType = VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO,
                                         .setLayoutCount = 1,
                                         .pSetLayouts = &compute->set_layout,
                                         .pushConstantRangeCount = compute->push_size ? 1 : 0,
                                         .pPushConstantRanges = &push};
    return vkCreatePipelineLayout(device, &layout, NULL, &compute->layout);
}

static VkResult create_pipeline(gpu_compute *compute, const uint32_t *words, size_t word_count,
                                bool statistics)
{
    VkDevice device = compute->owner->device;
    VkShaderModuleCreateInfo module_info = {.sType = VK_STRUCTURE_TYPE_SHADER_MODULE_CREATE_INFO,
                                            .codeSize = word_count * sizeof(uint32_t),
                                            .pCode = words};
    VkShaderModule module;
    VkResult result = vkCreateShaderModule(device, &module_info, NULL, &module);
    if (result != VK_SUCCESS)
        return result;
    VkComputePipelineCreateInfo info = {
        .sType = VK_STRUCTURE_TYPE_COMPUTE_PIPELINE_CREATE_INFO,
        .flags = statistics ? VK_PIPELINE_CREATE_CAPTURE_STATISTICS_BIT_KHR : 0,
        .stage = {.sType = VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO,
                  .stage = VK_SHADER_STAGE_COMPUTE_BIT,
                  .module = module,
                  .pName = "main"},
        .layout = compute->layout};
    result = vkCreateComputePipelines(device, VK_NULL_HANDLE, 1, &info, NULL, &compute->pipeline);
    vkDestroyShaderModule(device, module, NULL);
    return result;
}

static VkResult create_set(gpu_compute *compute)
{
    VkDevice device = compute->owner->device;
    VkDescriptorPoolSize sizes[] = {{VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, GPU_MAX_BINDINGS},
                                    {VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER, GPU_MAX_BINDINGS}};
    VkDescriptorPoolCreateInfo pool = {.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_POOL_CREATE_INFO,
                                       .maxSets = 1,
                                       .poolSizeCount = 2,
                                       .pPoolSizes = sizes};
    VkResult result = vkCreateDescriptorPool(device, &pool, NULL, &compute->pool);
    if (result != VK_SUCCESS)
        return result;
    VkDescriptorSetAllocateInfo set = {.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_SET_ALLOCATE_INFO,
                                       .descriptorPool = compute->pool,
                                       .descriptorSetCount = 1,
                                       .pSetLayouts = &compute->set_layout};
    return vkAllocateDescriptorSets(device, &set, &compute->set);
}

gpu_status gpu_compute_create(gpu_device *device, const gpu_compute_options *options,
                              gpu_compute **out)
{
    *out = NULL;
    if (options->statistics && !device->info.statistics)
        return gpu_fail(GPU_UNSUPPORTED, "%s reports no pipeline statistics", device->info.name);
    uint32_t *words;
    size_t word_count;
    gpu_status status = gpu_compile(options->name, options->source, &words, &word_count);
    if (status != GPU_OK)
        return status;
    gpu_compute *compute = calloc(1, sizeof *compute);
    if (!compute) {
        free(words);
        return gpu_fail(GPU_OUT_OF_MEMORY, "%s: out of host memory", options->name);
    }
    compute->owner = device;
    compute->binding_count = options->binding_count;
    memcpy(compute->bindings, options->bindings, sizeof compute->bindings);
    compute->push_size = options->push_size;
    VkResult result = create_layout(compute);
    if (result == VK_SUCCESS)
        result = create_pipeline(compute, words, word_count, options->statistics);
    if (result == VK_SUCCESS && !device->info.compile_only)
        result = create_set(compute);
    free(words);
    if (result != VK_SUCCESS) {
        gpu_compute_destroy(compute);
        return gpu_vk(result, options->name);
    }
    *out = compute;
    return GPU_OK;
}

void gpu_compute_destroy(gpu_compute *compute)
{
    if (!compute)
        return;
    VkDevice device = compute->owner->device;
    vkDestroyDescriptorPool(device, compute->pool, NULL);
    vkDestroyPipeline(device, compute->pipeline, NULL);
    vkDestroyPipelineLayout(device, compute->layout, NULL);
    vkDestroyDescriptorSetLayout(device, compute->set_layout, NULL);
    free(compute);
}

static void write_set(const gpu_dispatch *dispatch)
{
    const gpu_compute *compute = dispatch->compute;
    VkWriteDescriptorSet writes[GPU_MAX_BINDINGS];
    VkDescriptorBufferInfo buffers[GPU_MAX_BINDINGS];
    VkDescriptorImageInfo images[GPU_MAX_BINDINGS];
    for (int i = 0; i < compute->binding_count; i++) {
        writes[i] = (VkWriteDescriptorSet){.sType = VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET,
                                           .dstSet = compute->set,
                                           .dstBinding = (uint32_t)i,
                                           .descriptorCount = 1,
                                           .descriptorType = descriptor_type(compute->bindings[i])};
        if (compute->bindings[i] == GPU_STORAGE_BUFFER) {
            const gpu_buffer *buffer = dispatch->resources[i];
            buffers[i] = (VkDescriptorBufferInfo){buffer->buffer, 0, VK_WHOLE_SIZE};
            writes[i].pBufferInfo = &buffers[i];
        } else {
            const gpu_texture *texture = dispatch->resources[i];
            images[i] = (VkDescriptorImageInfo){texture->sampler, texture->view,
                                                VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL};
            writes[i].pImageInfo = &images[i];
        }
    }
    vkUpdateDescriptorSets(compute->owner->device, (uint32_t)compute->binding_count, writes, 0,
                           NULL);
}

static void barrier(VkCommandBuffer commands, VkPipelineStageFlags from, VkAccessFlags from_access,
                    VkPipelineStageFlags to, VkAccessFlags to_access)
{
    VkMemoryBarrier memory = {.sType = VK_STRUCTURE_TYPE_MEMORY_BARRIER,
                              .srcAccessMask = from_access,
                              .dstAccessMask = to_access};
    vkCmdPipelineBarrier(commands, from, to, 0, 1, &memory, 0, NULL, 0, NULL);
}

static uint32_t at_least_one(uint32_t value)
{
    return value ? value : 1;
}

static void record(gpu_device *device, const gpu_dispatch *dispatch, VkCommandBuffer commands)
{
    const gpu_compute *compute = dispatch->compute;
    bool timed = dispatch->seconds && device->info.timestamps;
    vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_COMPUTE, compute->pipeline);
    vkCmdBindDescriptorSets(commands, VK_PIPELINE_BIND_POINT_COMPUTE, compute->layout, 0, 1,
                            &compute->set, 0, NULL);
    if (compute->push_size)
        vkCmdPushConstants(commands, compute->layout, VK_SHADER_STAGE_COMPUTE_BIT, 0,
                           compute->push_size, dispatch->push);
    if (timed) {
        vkCmdResetQueryPool(commands, device->queries, 0, 2);
        vkCmdWriteTimestamp(commands, VK_PIPELINE_STAGE_TOP_OF_PIPE_BIT, device->queries, 0);
    }
    int repeat = dispatch->repeat > 0 ? dispatch->repeat : 1;
    for (int i = 0; i < repeat; i++) {
        if (i > 0)
            barrier(commands, VK_PIPELINE_STAGE_COMPUTE_SHADER_BIT, VK_ACCESS_SHADER_WRITE_BIT,
                    VK_PIPELINE_STAGE_COMPUTE_SHADER_BIT,
                    VK_ACCESS_SHADER_READ_BIT | VK_ACCESS_SHADER_WRITE_BIT);
        vkCmdDispatch(commands, at_least_one(dispatch->groups[0]),
                      at_least_one(dispatch->groups[1]), at_least_one(dispatch->groups[2]));
    }
    if (timed)
        vkCmdWriteTimestamp(commands, VK_PIPELINE_STAGE_BOTTOM_OF_PIPE_BIT, device->queries, 1);
    barrier(commands, VK_PIPELINE_STAGE_COMPUTE_SHADER_BIT, VK_ACCESS_SHADER_WRITE_BIT,
            VK_PIPELINE_STAGE_HOST_BIT, VK_ACCESS_HOST_READ_BIT);
}

static double now(void)
{
    struct timespec t;
    timespec_get(&t, TIME_UTC);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

gpu_status gpu_dispatch_run(gpu_device *device, const gpu_dispatch *dispatch)
{
    if (device->info.compile_only)
        return gpu_fail(GPU_UNSUPPORTED, "%s only compiles", device->info.name);
    write_set(dispatch);
    VkCommandBuffer commands;
    gpu_status status = gpu_begin(device, &commands);
    if (status != GPU_OK)
        return status;
    record(device, dispatch, commands);
    double start = now();
    status = gpu_submit(device, commands);
    if (status != GPU_OK || !dispatch->seconds)
        return status;
    *dispatch->seconds = now() - start;
    if (device->info.timestamps) {
        uint64_t ticks[2];
        VkResult result = vkGetQueryPoolResults(device->device, device->queries, 0, 2, sizeof ticks,
                                                ticks, sizeof ticks[0],
                                                VK_QUERY_RESULT_64_BIT | VK_QUERY_RESULT_WAIT_BIT);
        if (result != VK_SUCCESS)
            return gpu_vk(result, "reading timestamps");
        *dispatch->seconds =
            (double)(ticks[1] - ticks[0]) * device->info.timestamp_nanosecond * 1e-9;
    }
    return GPU_OK;
}
