/* Steps as commands. */
#include "internal.h"

#include <string.h>

const gpu_layout *gpu_step_layout(const gpu_step *step)
{
    return step->compute ? &step->compute->layout : step->draw ? &step->draw->layout : NULL;
}

static uint32_t at_least_one(uint32_t value)
{
    return value ? value : 1;
}

void gpu_record_barrier(VkCommandBuffer commands)
{
    VkMemoryBarrier memory = {.sType = VK_STRUCTURE_TYPE_MEMORY_BARRIER,
                              .srcAccessMask = VK_ACCESS_MEMORY_WRITE_BIT,
                              .dstAccessMask =
                                  VK_ACCESS_MEMORY_READ_BIT | VK_ACCESS_MEMORY_WRITE_BIT};
    vkCmdPipelineBarrier(commands, VK_PIPELINE_STAGE_ALL_COMMANDS_BIT | VK_PIPELINE_STAGE_HOST_BIT,
                         VK_PIPELINE_STAGE_ALL_COMMANDS_BIT | VK_PIPELINE_STAGE_HOST_BIT, 0, 1,
                         &memory, 0, NULL, 0, NULL);
}

static VkClearColorValue clear_color(const gpu_step *step, gpu_format format)
{
    VkClearColorValue value;
    if (format == GPU_R32U || format == GPU_RG32U || format == GPU_RGBA32U)
        memcpy(value.uint32, step->clear_bits, sizeof value.uint32);
    else
        memcpy(value.float32, step->clear_value, sizeof value.float32);
    return value;
}

static void record_clear(VkCommandBuffer commands, const gpu_step *step)
{
    const gpu_image *image = step->clear;
    bool depth = image->format == GPU_DEPTH32;
    VkImageSubresourceRange range = {depth ? VK_IMAGE_ASPECT_DEPTH_BIT : VK_IMAGE_ASPECT_COLOR_BIT,
                                     0, 1, 0, 1};
    if (depth) {
        VkClearDepthStencilValue value = {step->clear_value[0], 0};
        vkCmdClearDepthStencilImage(commands, image->image, VK_IMAGE_LAYOUT_GENERAL, &value, 1,
                                    &range);
    } else {
        VkClearColorValue value = clear_color(step, image->format);
        vkCmdClearColorImage(commands, image->image, VK_IMAGE_LAYOUT_GENERAL, &value, 1, &range);
    }
}

static void record_compute(VkCommandBuffer commands, const gpu_step *step)
{
    vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_COMPUTE, step->compute->pipeline);
    if (step->indirect)
        vkCmdDispatchIndirect(commands, step->indirect->buffer, step->indirect_offset);
    else
        vkCmdDispatch(commands, at_least_one(step->groups[0]), at_least_one(step->groups[1]),
                      at_least_one(step->groups[2]));
}

static void begin_rendering(VkCommandBuffer commands, const gpu_step *step)
{
    const gpu_draw *draw = step->draw;
    VkAttachmentLoadOp load = step->keep ? VK_ATTACHMENT_LOAD_OP_LOAD : VK_ATTACHMENT_LOAD_OP_CLEAR;
    VkRenderingAttachmentInfo targets[GPU_MAX_TARGETS], depth;
    for (int i = 0; i < draw->target_count; i++)
        targets[i] =
            (VkRenderingAttachmentInfo){.sType = VK_STRUCTURE_TYPE_RENDERING_ATTACHMENT_INFO,
                                        .imageView = step->targets[i]->view,
                                        .imageLayout = VK_IMAGE_LAYOUT_GENERAL,
                                        .loadOp = load,
                                        .storeOp = VK_ATTACHMENT_STORE_OP_STORE,
                                        .clearValue.color = clear_color(step, draw->targets[i])};
    if (draw->depth)
        depth = (VkRenderingAttachmentInfo){.sType = VK_STRUCTURE_TYPE_RENDERING_ATTACHMENT_INFO,
                                            .imageView = step->depth->view,
                                            .imageLayout = VK_IMAGE_LAYOUT_GENERAL,
                                            .loadOp = load,
                                            .storeOp = VK_ATTACHMENT_STORE_OP_STORE,
                                            .clearValue.depthStencil = {1, 0}};
    const gpu_image *any = draw->target_count ? step->targets[0] : step->depth;
    VkRect2D area = {{0, 0}, {any->width, any->height}};
    uint32_t across = step->viewport[0] ? step->viewport[0] : any->width;
    uint32_t down = step->viewport[1] ? step->viewport[1] : any->height;
    VkViewport viewport = {0, 0, (float)across, (float)down, 0, 1};
    VkRenderingInfo info = {.sType = VK_STRUCTURE_TYPE_RENDERING_INFO,
                            .renderArea = area,
                            .layerCount = 1,
                            .colorAttachmentCount = (uint32_t)draw->target_count,
                            .pColorAttachments = targets,
                            .pDepthAttachment = draw->depth ? &depth : NULL};
    vkCmdBeginRendering(commands, &info);
    vkCmdSetViewport(commands, 0, 1, &viewport);
    vkCmdSetScissor(commands, 0, 1, &area);
}

static void record_draw(VkCommandBuffer commands, const gpu_step *step)
{
    begin_rendering(commands, step);
    vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, step->draw->pipeline);
    if (step->indices)
        vkCmdBindIndexBuffer(commands, step->indices->buffer, 0, VK_INDEX_TYPE_UINT32);
    if (step->indices && step->indirect)
        vkCmdDrawIndexedIndirect(commands, step->indirect->buffer, step->indirect_offset, 1, 0);
    else if (step->indices)
        vkCmdDrawIndexed(commands, step->vertex_count, at_least_one(step->instance_count), 0, 0, 0);
    else if (step->indirect)
        vkCmdDrawIndirect(commands, step->indirect->buffer, step->indirect_offset, 1, 0);
    else
        vkCmdDraw(commands, step->vertex_count, at_least_one(step->instance_count), 0, 0);
    vkCmdEndRendering(commands);
}

void gpu_record_step(VkCommandBuffer commands, const gpu_step *step, VkDescriptorSet set)
{
    const gpu_layout *layout = gpu_step_layout(step);
    if (layout) {
        vkCmdBindDescriptorSets(
            commands, step->draw ? VK_PIPELINE_BIND_POINT_GRAPHICS : VK_PIPELINE_BIND_POINT_COMPUTE,
            layout->pipeline, 0, 1, &set, 0, NULL);
        if (layout->push_size)
            vkCmdPushConstants(commands, layout->pipeline, layout->stages, 0, layout->push_size,
                               step->push);
    }
    if (step->compute)
        record_compute(commands, step);
    else if (step->draw)
        record_draw(commands, step);
    else if (step->clear)
        record_clear(commands, step);
    else
        vkCmdFillBuffer(commands, step->fill->buffer, 0, VK_WHOLE_SIZE, step->clear_bits[0]);
}
