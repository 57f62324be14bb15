/* What a pipeline is bound to: descriptor sets and push constants. */
#include "internal.h"

static VkDescriptorType descriptor_type(gpu_binding binding)
{
    switch (binding) {
    case GPU_STORAGE_BUFFER:
        return VK_DESCRIPTOR_TYPE_STORAGE_BUFFER;
    case GPU_STORAGE_IMAGE:
        return VK_DESCRIPTOR_TYPE_STORAGE_IMAGE;
    case GPU_SAMPLED:
    case GPU_FETCHED:
        break;
    }
    return VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER;
}

VkResult gpu_layout_create(gpu_device *device, gpu_layout *layout)
{
    VkDescriptorSetLayoutBinding bindings[GPU_MAX_BINDINGS];
    for (int i = 0; i < layout->binding_count; i++)
        bindings[i] =
            (VkDescriptorSetLayoutBinding){.binding = (uint32_t)i,
                                           .descriptorType = descriptor_type(layout->bindings[i]),
                                           .descriptorCount = 1,
                                           .stageFlags = layout->stages};
    VkDescriptorSetLayoutCreateInfo set = {.sType =
                                               VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_CREATE_INFO,
                                           .bindingCount = (uint32_t)layout->binding_count,
                                           .pBindings = bindings};
    VkResult result = vkCreateDescriptorSetLayout(device->device, &set, NULL, &layout->set);
    if (result != VK_SUCCESS)
        return result;
    VkPushConstantRange push = {.stageFlags = layout->stages, .size = layout->push_size};
    VkPipelineLayoutCreateInfo info = {.sType = VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO,
                                       .setLayoutCount = 1,
                                       .pSetLayouts = &layout->set,
                                       .pushConstantRangeCount = layout->push_size ? 1 : 0,
                                       .pPushConstantRanges = &push};
    return vkCreatePipelineLayout(device->device, &info, NULL, &layout->pipeline);
}

void gpu_layout_destroy(gpu_device *device, gpu_layout *layout)
{
    vkDestroyPipelineLayout(device->device, layout->pipeline, NULL);
    vkDestroyDescriptorSetLayout(device->device, layout->set, NULL);
}

VkResult gpu_layout_pool(gpu_device *device, const gpu_layout *const *layouts, size_t count,
                         VkDescriptorPool *pool)
{
    *pool = VK_NULL_HANDLE;
    if (count == 0)
        return VK_SUCCESS;
    /* A pool wants at least one descriptor, and a layout may have none. */
    VkDescriptorPoolSize sizes[] = {{VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, 1},
                                    {VK_DESCRIPTOR_TYPE_STORAGE_IMAGE, 1},
                                    {VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER, 1}};
    for (size_t i = 0; i < count; i++)
        for (int j = 0; j < layouts[i]->binding_count; j++)
            for (int k = 0; k < 3; k++)
                sizes[k].descriptorCount +=
                    sizes[k].type == descriptor_type(layouts[i]->bindings[j]);
    VkDescriptorPoolCreateInfo info = {.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_POOL_CREATE_INFO,
                                       .maxSets = (uint32_t)count,
                                       .poolSizeCount = 3,
                                       .pPoolSizes = sizes};
    return vkCreateDescriptorPool(device->device, &info, NULL, pool);
}

static VkDescriptorImageInfo image_info(gpu_device *device, gpu_binding binding,
                                        const void *resource)
{
    if (binding == GPU_SAMPLED) {
        const gpu_texture *texture = resource;
        return (VkDescriptorImageInfo){texture->sampler, texture->view,
                                       VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL};
    }
    const gpu_image *image = resource;
    return (VkDescriptorImageInfo){device->nearest, image->view, VK_IMAGE_LAYOUT_GENERAL};
}

static gpu_status check(const gpu_device *device, const gpu_layout *layout, const char *name,
                        void *const *resources)
{
    for (int i = 0; i < layout->binding_count; i++) {
        if (!resources[i])
            return gpu_fail(GPU_FAILED, "%s: nothing is given for binding %d", name, i);
        if (layout->bindings[i] == GPU_STORAGE_BUFFER &&
            ((const gpu_buffer *)resources[i])->size > device->limits.maxStorageBufferRange)
            return gpu_fail(GPU_UNSUPPORTED,
                            "%s: the buffer at binding %d has %zu bytes, %s allows %u", name, i,
                            ((const gpu_buffer *)resources[i])->size, device->info.name,
                            device->limits.maxStorageBufferRange);
        if (layout->bindings[i] == GPU_STORAGE_IMAGE &&
            ((const gpu_image *)resources[i])->format == GPU_DEPTH32)
            return gpu_fail(GPU_FAILED, "%s: binding %d: depth cannot be a storage image", name, i);
    }
    return GPU_OK;
}

gpu_status gpu_layout_write(gpu_device *device, const gpu_layout *layout, const char *name,
                            void *const *resources, VkDescriptorSet set)
{
    gpu_status status = check(device, layout, name, resources);
    if (status != GPU_OK)
        return status;
    VkWriteDescriptorSet writes[GPU_MAX_BINDINGS];
    VkDescriptorBufferInfo buffers[GPU_MAX_BINDINGS];
    VkDescriptorImageInfo images[GPU_MAX_BINDINGS];
    for (int i = 0; i < layout->binding_count; i++) {
        writes[i] = (VkWriteDescriptorSet){.sType = VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET,
                                           .dstSet = set,
                                           .dstBinding = (uint32_t)i,
                                           .descriptorCount = 1,
                                           .descriptorType = descriptor_type(layout->bindings[i])};
        if (layout->bindings[i] == GPU_STORAGE_BUFFER) {
            const gpu_buffer *buffer = resources[i];
            buffers[i] = (VkDescriptorBufferInfo){buffer->buffer, 0, VK_WHOLE_SIZE};
            writes[i].pBufferInfo = &buffers[i];
        } else {
            images[i] = image_info(device, layout->bindings[i], resources[i]);
            writes[i].pImageInfo = &images[i];
        }
    }
    vkUpdateDescriptorSets(device->device, (uint32_t)layout->binding_count, writes, 0, NULL);
    return GPU_OK;
}

VkSpecializationInfo gpu_constants(const float *constant)
{
    static const VkSpecializationMapEntry first = {.size = sizeof *constant};
    return (VkSpecializationInfo){.mapEntryCount = *constant != 0,
                                  .pMapEntries = &first,
                                  .dataSize = sizeof *constant,
                                  .pData = constant};
}
