/* Textures to be looked up in: float channels, uploaded through a buffer. */
#include "internal.h"

#include <stdlib.h>
#include <string.h>

/* To half, to nearest, ties to even; beyond its range infinity. */
static uint16_t half_from_float(float value)
{
    union {
        float f;
        uint32_t u;
    } bits = {value};
    uint32_t sign = bits.u >> 16 & 0x8000U, magnitude = bits.u & 0x7fffffffU;
    if (magnitude > 0x7f800000U)
        return (uint16_t)(sign | 0x7e00U);
    if (magnitude >= 0x477ff000U)
        return (uint16_t)(sign | 0x7c00U);
    if (magnitude < 0x33000000U)
        return (uint16_t)sign;
    uint32_t exponent = magnitude >> 23;
    uint32_t shift = 13, mantissa = magnitude - 0x38000000U; /* rebias 127 to 15 */
    if (exponent < 113) {
        shift = 126 - exponent;
        mantissa = (magnitude & 0x7fffffU) | 0x800000U;
    }
    uint32_t half = mantissa >> shift;
    uint32_t rest = mantissa & ((1U << shift) - 1), middle = 1U << (shift - 1);
    half += rest > middle || (rest == middle && (half & 1U));
    return (uint16_t)(sign | half);
}

static size_t channels_of(const gpu_texture_options *options)
{
    return options->channels > 0 ? (size_t)options->channels : 1;
}

static VkFormat format_of(const gpu_texture_options *options)
{
    switch (channels_of(options)) {
    case 1:
        return options->half ? VK_FORMAT_R16_SFLOAT : VK_FORMAT_R32_SFLOAT;
    case 2:
        return options->half ? VK_FORMAT_R16G16_SFLOAT : VK_FORMAT_R32G32_SFLOAT;
    case 4:
        return options->half ? VK_FORMAT_R16G16B16A16_SFLOAT : VK_FORMAT_R32G32B32A32_SFLOAT;
    default:
        return VK_FORMAT_UNDEFINED;
    }
}

static gpu_status fill_staging(gpu_device *device, const gpu_texture_options *options,
                               gpu_buffer **staging)
{
    size_t count =
        (size_t)options->width * (options->height ? options->height : 1) * channels_of(options);
    size_t texel = options->half ? sizeof(uint16_t) : sizeof(float);
    gpu_status status = gpu_buffer_create(device, count * texel, staging);
    if (status != GPU_OK)
        return status;
    if (!options->half) {
        memcpy(gpu_buffer_map(*staging), options->texels, count * texel);
        return GPU_OK;
    }
    uint16_t *halves = gpu_buffer_map(*staging);
    for (size_t i = 0; i < count; i++)
        halves[i] = half_from_float(options->texels[i]);
    return GPU_OK;
}

static VkResult create_image(gpu_texture *texture, const gpu_texture_options *options,
                             VkFormat format)
{
    gpu_device *device = texture->owner;
    VkImageCreateInfo info = {.sType = VK_STRUCTURE_TYPE_IMAGE_CREATE_INFO,
                              .imageType = options->height ? VK_IMAGE_TYPE_2D : VK_IMAGE_TYPE_1D,
                              .format = format,
                              .extent = {options->width, options->height ? options->height : 1, 1},
                              .mipLevels = 1,
                              .arrayLayers = 1,
                              .samples = VK_SAMPLE_COUNT_1_BIT,
                              .usage =
                                  VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT};
    VkResult result = vkCreateImage(device->device, &info, NULL, &texture->image);
    if (result != VK_SUCCESS)
        return result;
    VkMemoryRequirements needs;
    vkGetImageMemoryRequirements(device->device, texture->image, &needs);
    int type = gpu_memory_type(device, needs.memoryTypeBits, VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT);
    if (type < 0)
        type = gpu_memory_type(device, needs.memoryTypeBits, 0);
    VkMemoryAllocateInfo allocate = {.sType = VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO,
                                     .allocationSize = needs.size,
                                     .memoryTypeIndex = (uint32_t)type};
    result = type < 0 ? VK_ERROR_OUT_OF_DEVICE_MEMORY
                      : vkAllocateMemory(device->device, &allocate, NULL, &texture->memory);
    if (result == VK_SUCCESS)
        result = vkBindImageMemory(device->device, texture->image, texture->memory, 0);
    return result;
}

static VkResult create_view(gpu_texture *texture, const gpu_texture_options *options,
                            VkFormat format)
{
    VkDevice device = texture->owner->device;
    VkImageViewCreateInfo view = {.sType = VK_STRUCTURE_TYPE_IMAGE_VIEW_CREATE_INFO,
                                  .image = texture->image,
                                  .viewType = options->height ? VK_IMAGE_VIEW_TYPE_2D
                                                              : VK_IMAGE_VIEW_TYPE_1D,
                                  .format = format,
                                  .subresourceRange = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 1, 0, 1}};
    VkResult result = vkCreateImageView(device, &view, NULL, &texture->view);
    if (result != VK_SUCCESS)
        return result;
    VkSamplerCreateInfo sampler = {.sType = VK_STRUCTURE_TYPE_SAMPLER_CREATE_INFO,
                                   .magFilter = VK_FILTER_LINEAR,
                                   .minFilter = VK_FILTER_LINEAR,
                                   .mipmapMode = VK_SAMPLER_MIPMAP_MODE_NEAREST,
                                   .addressModeU = VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_EDGE,
                                   .addressModeV = VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_EDGE,
                                   .addressModeW = VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_EDGE};
    return vkCreateSampler(device, &sampler, NULL, &texture->sampler);
}

static void transition(VkCommandBuffer commands, VkImage image, VkImageLayout from,
                       VkImageLayout to)
{
    bool upload = from == VK_IMAGE_LAYOUT_UNDEFINED;
    VkImageMemoryBarrier barrier = {.sType = VK_STRUCTURE_TYPE_IMAGE_MEMORY_BARRIER,
                                    .srcAccessMask = upload ? 0 : VK_ACCESS_TRANSFER_WRITE_BIT,
                                    .dstAccessMask = upload ? VK_ACCESS_TRANSFER_WRITE_BIT
                                                            : VK_ACCESS_SHADER_READ_BIT,
                                    .oldLayout = from,
                                    .newLayout = to,
                                    .srcQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED,
                                    .dstQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED,
                                    .image = image,
                                    .subresourceRange = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 1, 0, 1}};
    vkCmdPipelineBarrier(
        commands, upload ? VK_PIPELINE_STAGE_TOP_OF_PIPE_BIT : VK_PIPELINE_STAGE_TRANSFER_BIT,
        upload ? VK_PIPELINE_STAGE_TRANSFER_BIT : VK_PIPELINE_STAGE_COMPUTE_SHADER_BIT, 0, 0, NULL,
        0, NULL, 1, &barrier);
}

static gpu_status upload(gpu_texture *texture, const gpu_texture_options *options,
                         const gpu_buffer *staging)
{
    VkCommandBuffer commands;
    gpu_status status = gpu_begin(texture->owner, &commands);
    if (status != GPU_OK)
        return status;
    transition(commands, texture->image, VK_IMAGE_LAYOUT_UNDEFINED,
               VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL);
    VkBufferImageCopy region = {
        .imageSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 0, 1},
        .imageExtent = {options->width, options->height ? options->height : 1, 1}};
    vkCmdCopyBufferToImage(commands, staging->buffer, texture->image,
                           VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, 1, &region);
    transition(commands, texture->image, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL,
               VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL);
    return gpu_submit(texture->owner, commands);
}

gpu_status gpu_texture_create(gpu_device *device, const gpu_texture_options *options,
                              gpu_texture **out)
{
    *out = NULL;
    VkFormat format = format_of(options);
    if (format == VK_FORMAT_UNDEFINED)
        return gpu_fail(GPU_UNSUPPORTED, "a texture: expected 1, 2 or 4 channels, got %d",
                        options->channels);
    gpu_buffer *staging;
    gpu_status status = fill_staging(device, options, &staging);
    if (status != GPU_OK)
        return status;
    gpu_texture *texture = calloc(1, sizeof *texture);
    if (!texture) {
        gpu_buffer_destroy(staging);
        return gpu_fail(GPU_OUT_OF_MEMORY, "a texture: out of host memory");
    }
    texture->owner = device;
    VkResult result = create_image(texture, options, format);
    if (result == VK_SUCCESS)
        result = create_view(texture, options, format);
    status = result == VK_SUCCESS ? upload(texture, options, staging) : gpu_vk(result, "a texture");
    gpu_buffer_destroy(staging);
    if (status != GPU_OK) {
        gpu_texture_destroy(texture);
        return status;
    }
    *out = texture;
    return GPU_OK;
}

void gpu_texture_destroy(gpu_texture *texture)
{
    if (!texture)
        return;
    VkDevice device = texture->owner->device;
    vkDestroySampler(device, texture->sampler, NULL);
    vkDestroyImageView(device, texture->view, NULL);
    vkDestroyImage(device, texture->image, NULL);
    vkFreeMemory(device, texture->memory, NULL);
    free(texture);
}
