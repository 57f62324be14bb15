/* Memory, buffers, textures and the one-shot command buffers that everything runs in. */
#include "internal.h"

#include <stdlib.h>
#include <string.h>

int gpu_memory_type(const gpu_device *device, uint32_t allowed, VkMemoryPropertyFlags properties)
{
    for (uint32_t i = 0; i < device->memory.memoryTypeCount; i++)
        if ((allowed >> i & 1) &&
            (device->memory.memoryTypes[i].propertyFlags & properties) == properties)
            return (int)i;
    return -1;
}

gpu_status gpu_begin(gpu_device *device, VkCommandBuffer *commands)
{
    VkCommandBufferAllocateInfo allocate = {.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO,
                                            .commandPool = device->commands,
                                            .level = VK_COMMAND_BUFFER_LEVEL_PRIMARY,
                                            .commandBufferCount = 1};
    VkResult result = vkAllocateCommandBuffers(device->device, &allocate, commands);
    if (result != VK_SUCCESS)
        return gpu_vk(result, "recording commands");
    VkCommandBufferBeginInfo begin = {.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO,
                                      .flags = VK_COMMAND_BUFFER_USAGE_ONE_TIME_SUBMIT_BIT};
    result = vkBeginCommandBuffer(*commands, &begin);
    if (result == VK_SUCCESS)
        return GPU_OK;
    vkFreeCommandBuffers(device->device, device->commands, 1, commands);
    return gpu_vk(result, "recording commands");
}

gpu_status gpu_submit(gpu_device *device, VkCommandBuffer commands)
{
    VkResult result = vkEndCommandBuffer(commands);
    if (result == VK_SUCCESS)
        result = vkResetFences(device->device, 1, &device->fence);
    VkSubmitInfo submit = {.sType = VK_STRUCTURE_TYPE_SUBMIT_INFO,
                           .commandBufferCount = 1,
                           .pCommandBuffers = &commands};
    if (result == VK_SUCCESS)
        result = vkQueueSubmit(device->queue, 1, &submit, device->fence);
    if (result == VK_SUCCESS)
        result = vkWaitForFences(device->device, 1, &device->fence, VK_TRUE, UINT64_MAX);
    vkFreeCommandBuffers(device->device, device->commands, 1, &commands);
    return result == VK_SUCCESS ? GPU_OK : gpu_vk(result, "running commands");
}

VkResult gpu_need_queries(gpu_device *device, uint32_t count)
{
    if (device->query_count >= count)
        return VK_SUCCESS;
    vkDestroyQueryPool(device->device, device->queries, NULL);
    device->queries = VK_NULL_HANDLE;
    device->query_count = 0;
    VkQueryPoolCreateInfo info = {.sType = VK_STRUCTURE_TYPE_QUERY_POOL_CREATE_INFO,
                                  .queryType = VK_QUERY_TYPE_TIMESTAMP,
                                  .queryCount = count};
    VkResult result = vkCreateQueryPool(device->device, &info, NULL, &device->queries);
    if (result == VK_SUCCESS)
        device->query_count = count;
    return result;
}

gpu_status gpu_buffer_create(gpu_device *device, size_t size, gpu_buffer **out)
{
    *out = NULL;
    if (device->info.compile_only)
        return gpu_fail(GPU_UNSUPPORTED, "%s only compiles", device->info.name);
    gpu_buffer *buffer = calloc(1, sizeof *buffer);
    if (!buffer)
        return gpu_fail(GPU_OUT_OF_MEMORY, "a buffer of %zu bytes: out of host memory", size);
    size = size ? size : 4;
    buffer->owner = device;
    buffer->size = size;
    VkBufferCreateInfo info = {
        .sType = VK_STRUCTURE_TYPE_BUFFER_CREATE_INFO,
        .size = size,
        .usage = VK_BUFFER_USAGE_STORAGE_BUFFER_BIT | VK_BUFFER_USAGE_INDEX_BUFFER_BIT |
                 VK_BUFFER_USAGE_INDIRECT_BUFFER_BIT | VK_BUFFER_USAGE_TRANSFER_SRC_BIT |
                 VK_BUFFER_USAGE_TRANSFER_DST_BIT};
    VkResult result = vkCreateBuffer(device->device, &info, NULL, &buffer->buffer);
    if (result == VK_SUCCESS) {
        VkMemoryRequirements needs;
        vkGetBufferMemoryRequirements(device->device, buffer->buffer, &needs);
        int type = gpu_memory_type(device, needs.memoryTypeBits,
                                   VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT |
                                       VK_MEMORY_PROPERTY_HOST_COHERENT_BIT);
        VkMemoryAllocateInfo allocate = {.sType = VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO,
                                         .allocationSize = needs.size,
                                         .memoryTypeIndex = (uint32_t)type};
        result = type < 0 ? VK_ERROR_OUT_OF_DEVICE_MEMORY
                          : vkAllocateMemory(device->device, &allocate, NULL, &buffer->memory);
    }
    if (result == VK_SUCCESS)
        result = vkBindBufferMemory(device->device, buffer->buffer, buffer->memory, 0);
    if (result == VK_SUCCESS)
        result = vkMapMemory(device->device, buffer->memory, 0, VK_WHOLE_SIZE, 0, &buffer->mapped);
    if (result != VK_SUCCESS) {
        gpu_buffer_destroy(buffer);
        return gpu_vk(result, "a buffer");
    }
    *out = buffer;
    return GPU_OK;
}

void gpu_buffer_destroy(gpu_buffer *buffer)
{
    if (!buffer)
        return;
    vkDestroyBuffer(buffer->owner->device, buffer->buffer, NULL);
    vkFreeMemory(buffer->owner->device, buffer->memory, NULL);
    free(buffer);
}

void *gpu_buffer_map(gpu_buffer *buffer)
{
    return buffer->mapped;
}

size_t gpu_buffer_size(const gpu_buffer *buffer)
{
    return buffer->size;
}
