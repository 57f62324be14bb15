/* Compute pipelines and their dispatch. */
#include "internal.h"

#include <stdlib.h>
#include <string.h>
#include <time.h>

static VkResult create_pipeline(gpu_compute *compute, VkShaderModule module,
                                const gpu_compute_options *options)
{
    const VkSpecializationInfo constants = gpu_constants(&options->constant);
    VkComputePipelineCreateInfo info = {
        .sType = VK_STRUCTURE_TYPE_COMPUTE_PIPELINE_CREATE_INFO,
        .flags = options->statistics ? VK_PIPELINE_CREATE_CAPTURE_STATISTICS_BIT_KHR : 0,
        .stage = {.sType = VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO,
                  .stage = VK_SHADER_STAGE_COMPUTE_BIT,
                  .module = module,
                  .pName = "main",
                  .pSpecializationInfo = &constants},
        .layout = compute->layout.pipeline};
    return vkCreateComputePipelines(compute->owner->device, VK_NULL_HANDLE, 1, &info, NULL,
                                    &compute->pipeline);
}

/* The set of gpu_dispatch_run; gpu_run has sets of its own. */
static VkResult create_set(gpu_compute *compute)
{
    const gpu_layout *layout = &compute->layout;
    VkResult result = gpu_layout_pool(compute->owner, &layout, 1, &compute->pool);
    if (result != VK_SUCCESS)
        return result;
    VkDescriptorSetAllocateInfo set = {.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_SET_ALLOCATE_INFO,
                                       .descriptorPool = compute->pool,
                                       .descriptorSetCount = 1,
                                       .pSetLayouts = &layout->set};
    return vkAllocateDescriptorSets(compute->owner->device, &set, &compute->set);
}

static gpu_status make_compute(gpu_device *device, const gpu_compute_options *options,
                               gpu_compute **out)
{
    VkShaderModule module;
    gpu_shader shader = {options->source, options->words, options->word_count};
    gpu_status status =
        gpu_module_create(device, GPU_COMPUTE_STAGE, options->name, &shader, &module);
    if (status != GPU_OK)
        return status;
    gpu_compute *compute = calloc(1, sizeof *compute);
    if (!compute) {
        vkDestroyShaderModule(device->device, module, NULL);
        return gpu_fail(GPU_OUT_OF_MEMORY, "%s: out of host memory", options->name);
    }
    compute->owner = device;
    compute->layout = (gpu_layout){.binding_count = options->binding_count,
                                   .push_size = options->push_size,
                                   .stages = VK_SHADER_STAGE_COMPUTE_BIT};
    memcpy(compute->layout.bindings, options->bindings, sizeof options->bindings);
    VkResult result = gpu_layout_create(device, &compute->layout);
    if (result == VK_SUCCESS)
        result = create_pipeline(compute, module, options);
    if (result == VK_SUCCESS && !device->info.compile_only)
        result = create_set(compute);
    vkDestroyShaderModule(device->device, module, NULL);
    if (result != VK_SUCCESS) {
        gpu_compute_destroy(compute);
        return gpu_vk(result, options->name);
    }
    *out = compute;
    return GPU_OK;
}

gpu_status gpu_compute_create(gpu_device *device, const gpu_compute_options *options,
                              gpu_compute **out)
{
    *out = NULL;
    if (options->statistics && !device->info.statistics)
        return gpu_fail(GPU_UNSUPPORTED, "%s reports no pipeline statistics", device->info.name);
    gpu_kept *entry = gpu_kept_compute(device, options, out);
    if (*out)
        return GPU_OK;
    gpu_status status = make_compute(device, options, out);
    if (status == GPU_OK)
        gpu_keep(device, entry, *out, NULL);
    else
        free(entry);
    return status;
}

void gpu_compute_destroy(gpu_compute *compute)
{
    if (!compute || compute->kept)
        return;
    VkDevice device = compute->owner->device;
    vkDestroyDescriptorPool(device, compute->pool, NULL);
    vkDestroyPipeline(device, compute->pipeline, NULL);
    gpu_layout_destroy(compute->owner, &compute->layout);
    free(compute);
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
    vkCmdBindDescriptorSets(commands, VK_PIPELINE_BIND_POINT_COMPUTE, compute->layout.pipeline, 0,
                            1, &compute->set, 0, NULL);
    if (compute->layout.push_size)
        vkCmdPushConstants(commands, compute->layout.pipeline, VK_SHADER_STAGE_COMPUTE_BIT, 0,
                           compute->layout.push_size, dispatch->push);
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
    const gpu_compute *compute = dispatch->compute;
    gpu_status status =
        gpu_layout_write(device, &compute->layout, "a dispatch", dispatch->resources, compute->set);
    VkCommandBuffer commands;
    if (status == GPU_OK)
        status = gpu_begin(device, &commands);
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
