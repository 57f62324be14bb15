/* Images: one level, always in the general layout. */
#include "internal.h"

#include <stdlib.h>
#include <string.h>

static const struct {
    VkFormat format;
    uint32_t texel;
} formats[] = {[GPU_RGBA8] = {VK_FORMAT_R8G8B8A8_UNORM, 4},
               [GPU_R32F] = {VK_FORMAT_R32_SFLOAT, 4},
               [GPU_RG32F] = {VK_FORMAT_R32G32_SFLOAT, 8},
               [GPU_RGBA16F] = {VK_FORMAT_R16G16B16A16_SFLOAT, 8},
               [GPU_RGBA32F] = {VK_FORMAT_R32G32B32A32_SFLOAT, 16},
               [GPU_R32U] = {VK_FORMAT_R32_UINT, 4},
               [GPU_RG32U] = {VK_FORMAT_R32G32_UINT, 8},
               [GPU_RGBA32U] = {VK_FORMAT_R32G32B32A32_UINT, 16},
               [GPU_DEPTH32] = {VK_FORMAT_D32_SFLOAT, 4}};

VkFormat gpu_format_vk(gpu_format format)
{
    return formats[format].format;
}

static VkImageAspectFlags aspect(gpu_format format)
{
    return format == GPU_DEPTH32 ? VK_IMAGE_ASPECT_DEPTH_BIT : VK_IMAGE_ASPECT_COLOR_BIT;
}

static VkImageCreateInfo image_info(gpu_format format, uint32_t width, uint32_t height)
{
    VkImageUsageFlags own = format == GPU_DEPTH32
                                ? VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT
                                : VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT | VK_IMAGE_USAGE_STORAGE_BIT;
    return (VkImageCreateInfo){.sType = VK_STRUCTURE_TYPE_IMAGE_CREATE_INFO,
                               .imageType = VK_IMAGE_TYPE_2D,
                               .format = formats[format].format,
                               .extent = {width, height, 1},
                               .mipLevels = 1,
                               .arrayLayers = 1,
                               .samples = VK_SAMPLE_COUNT_1_BIT,
                               .tiling = VK_IMAGE_TILING_OPTIMAL,
                               .usage = own | VK_IMAGE_USAGE_SAMPLED_BIT |
                                        VK_IMAGE_USAGE_TRANSFER_SRC_BIT |
                                        VK_IMAGE_USAGE_TRANSFER_DST_BIT};
}

static gpu_status check(const gpu_device *device, const VkImageCreateInfo *info)
{
    uint32_t width = info->extent.width, height = info->extent.height;
    if (device->info.compile_only)
        return gpu_fail(GPU_UNSUPPORTED, "%s only compiles", device->info.name);
    if (width == 0 || height == 0)
        return gpu_fail(GPU_UNSUPPORTED, "an image of %u x %u pixels: no side may be 0", width,
                        height);
    VkImageFormatProperties properties;
    VkResult result = vkGetPhysicalDeviceImageFormatProperties(
        device->physical, info->format, info->imageType, info->tiling, info->usage, info->flags,
        &properties);
    if (result != VK_SUCCESS)
        return gpu_vk(result, "an image's format");
    if (width > properties.maxExtent.width || height > properties.maxExtent.height)
        return gpu_fail(GPU_UNSUPPORTED, "an image of %u x %u pixels: %s allows %u x %u", width,
                        height, device->info.name, properties.maxExtent.width,
                        properties.maxExtent.height);
    return GPU_OK;
}

static VkResult create_memory(gpu_image *image)
{
    gpu_device *device = image->owner;
    VkMemoryRequirements needs;
    vkGetImageMemoryRequirements(device->device, image->image, &needs);
    int type = gpu_memory_type(device, needs.memoryTypeBits, VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT);
    if (type < 0)
        type = gpu_memory_type(device, needs.memoryTypeBits, 0);
    if (type < 0)
        return VK_ERROR_OUT_OF_DEVICE_MEMORY;
    VkMemoryAllocateInfo allocate = {.sType = VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO,
                                     .allocationSize = needs.size,
                                     .memoryTypeIndex = (uint32_t)type};
    VkResult result = vkAllocateMemory(device->device, &allocate, NULL, &image->memory);
    if (result == VK_SUCCESS)
        result = vkBindImageMemory(device->device, image->image, image->memory, 0);
    return result;
}

static VkResult create_view(gpu_image *image)
{
    gpu_device *device = image->owner;
    VkImageViewCreateInfo view = {.sType = VK_STRUCTURE_TYPE_IMAGE_VIEW_CREATE_INFO,
                                  .image = image->image,
                                  .viewType = VK_IMAGE_VIEW_TYPE_2D,
                                  .format = formats[image->format].format,
                                  .subresourceRange = {aspect(image->format), 0, 1, 0, 1}};
    VkResult result = vkCreateImageView(device->device, &view, NULL, &image->view);
    if (result != VK_SUCCESS || device->nearest)
        return result;
    VkSamplerCreateInfo sampler = {.sType = VK_STRUCTURE_TYPE_SAMPLER_CREATE_INFO,
                                   .magFilter = VK_FILTER_NEAREST,
                                   .minFilter = VK_FILTER_NEAREST,
                                   .mipmapMode = VK_SAMPLER_MIPMAP_MODE_NEAREST,
                                   .addressModeU = VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_EDGE,
                                   .addressModeV = VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_EDGE,
                                   .addressModeW = VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_EDGE};
    return vkCreateSampler(device->device, &sampler, NULL, &device->nearest);
}

/* Everything before against everything after. */
static void change_layout(VkCommandBuffer commands, const gpu_image *image, VkImageLayout from,
                          VkImageLayout to)
{
    VkImageMemoryBarrier barrier = {.sType = VK_STRUCTURE_TYPE_IMAGE_MEMORY_BARRIER,
                                    .srcAccessMask = VK_ACCESS_MEMORY_WRITE_BIT,
                                    .dstAccessMask =
                                        VK_ACCESS_MEMORY_READ_BIT | VK_ACCESS_MEMORY_WRITE_BIT,
                                    .oldLayout = from,
                                    .newLayout = to,
                                    .srcQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED,
                                    .dstQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED,
                                    .image = image->image,
                                    .subresourceRange = {aspect(image->format), 0, 1, 0, 1}};
    vkCmdPipelineBarrier(commands, VK_PIPELINE_STAGE_ALL_COMMANDS_BIT,
                         VK_PIPELINE_STAGE_ALL_COMMANDS_BIT, 0, 0, NULL, 0, NULL, 1, &barrier);
}

static gpu_status into_general_layout(gpu_image *image)
{
    VkCommandBuffer commands;
    gpu_status status = gpu_begin(image->owner, &commands);
    if (status != GPU_OK)
        return status;
    change_layout(commands, image, VK_IMAGE_LAYOUT_UNDEFINED, VK_IMAGE_LAYOUT_GENERAL);
    return gpu_submit(image->owner, commands);
}

gpu_status gpu_image_create(gpu_device *device, gpu_format format, uint32_t width, uint32_t height,
                            gpu_image **out)
{
    *out = NULL;
    VkImageCreateInfo info = image_info(format, width, height);
    gpu_status status = check(device, &info);
    if (status != GPU_OK)
        return status;
    gpu_image *image = calloc(1, sizeof *image);
    if (!image)
        return gpu_fail(GPU_OUT_OF_MEMORY, "an image: out of host memory");
    image->owner = device;
    image->format = format;
    image->width = width;
    image->height = height;
    VkResult result = vkCreateImage(device->device, &info, NULL, &image->image);
    if (result == VK_SUCCESS)
        result = create_memory(image);
    if (result == VK_SUCCESS)
        result = create_view(image);
    status = result == VK_SUCCESS ? into_general_layout(image) : gpu_vk(result, "an image");
    if (status != GPU_OK) {
        gpu_image_destroy(image);
        return status;
    }
    *out = image;
    return GPU_OK;
}

void gpu_image_destroy(gpu_image *image)
{
    if (!image)
        return;
    VkDevice device = image->owner->device;
    vkDestroyImageView(device, image->view, NULL);
    vkDestroyImage(device, image->image, NULL);
    vkFreeMemory(device, image->memory, NULL);
    free(image);
}

uint32_t gpu_image_width(const gpu_image *image)
{
    return image->width;
}

uint32_t gpu_image_height(const gpu_image *image)
{
    return image->height;
}

size_t gpu_image_texel(const gpu_image *image)
{
    return formats[image->format].texel;
}

/* The whole image from or into a buffer, in the layouts that drivers want for that. */
static gpu_status copy(gpu_image *image, gpu_buffer *buffer, bool read)
{
    VkCommandBuffer commands;
    gpu_status status = gpu_begin(image->owner, &commands);
    if (status != GPU_OK)
        return status;
    VkBufferImageCopy region = {.imageSubresource = {aspect(image->format), 0, 0, 1},
                                .imageExtent = {image->width, image->height, 1}};
    VkImageLayout layout =
        read ? VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL : VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL;
    change_layout(commands, image, VK_IMAGE_LAYOUT_GENERAL, layout);
    if (read)
        vkCmdCopyImageToBuffer(commands, image->image, layout, buffer->buffer, 1, &region);
    else
        vkCmdCopyBufferToImage(commands, buffer->buffer, image->image, layout, 1, &region);
    change_layout(commands, image, layout, VK_IMAGE_LAYOUT_GENERAL);
    gpu_record_barrier(commands);
    return gpu_submit(image->owner, commands);
}

static gpu_status transfer(gpu_image *image, void *out, const void *in)
{
    size_t size = (size_t)image->width * image->height * formats[image->format].texel;
    gpu_buffer *staging;
    gpu_status status = gpu_buffer_create(image->owner, size, &staging);
    if (status != GPU_OK)
        return status;
    if (in)
        memcpy(gpu_buffer_map(staging), in, size);
    status = copy(image, staging, out != NULL);
    if (status == GPU_OK && out)
        memcpy(out, gpu_buffer_map(staging), size);
    gpu_buffer_destroy(staging);
    return status;
}

gpu_status gpu_image_read(gpu_image *image, void *texels)
{
    return transfer(image, texels, NULL);
}

gpu_status gpu_image_write(gpu_image *image, const void *texels)
{
    return transfer(image, NULL, texels);
}
