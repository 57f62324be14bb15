/* Pipelines that draw, by dynamic rendering. */
#include "internal.h"

#include <stdlib.h>
#include <string.h>

/* The states that are the same in all of them. */
static const VkPipelineVertexInputStateCreateInfo no_attributes = {
    .sType = VK_STRUCTURE_TYPE_PIPELINE_VERTEX_INPUT_STATE_CREATE_INFO};
static const VkPipelineViewportStateCreateInfo one_viewport = {
    .sType = VK_STRUCTURE_TYPE_PIPELINE_VIEWPORT_STATE_CREATE_INFO,
    .viewportCount = 1,
    .scissorCount = 1};
static const VkPipelineRasterizationStateCreateInfo both_sides = {
    .sType = VK_STRUCTURE_TYPE_PIPELINE_RASTERIZATION_STATE_CREATE_INFO,
    .polygonMode = VK_POLYGON_MODE_FILL,
    .cullMode = VK_CULL_MODE_NONE,
    .frontFace = VK_FRONT_FACE_COUNTER_CLOCKWISE,
    .lineWidth = 1};
static const VkPipelineMultisampleStateCreateInfo one_sample = {
    .sType = VK_STRUCTURE_TYPE_PIPELINE_MULTISAMPLE_STATE_CREATE_INFO,
    .rasterizationSamples = VK_SAMPLE_COUNT_1_BIT};
static const VkDynamicState dynamic_states[] = {VK_DYNAMIC_STATE_VIEWPORT,
                                                VK_DYNAMIC_STATE_SCISSOR};
static const VkPipelineDynamicStateCreateInfo dynamic = {
    .sType = VK_STRUCTURE_TYPE_PIPELINE_DYNAMIC_STATE_CREATE_INFO,
    .dynamicStateCount = 2,
    .pDynamicStates = dynamic_states};

static VkPipelineShaderStageCreateInfo stage_info(VkShaderStageFlagBits stage,
                                                  VkShaderModule module,
                                                  const VkSpecializationInfo *constants)
{
    return (VkPipelineShaderStageCreateInfo){
        .sType = VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO,
        .stage = stage,
        .module = module,
        .pName = "main",
        .pSpecializationInfo = constants};
}

static VkResult create_pipeline(gpu_draw *draw, VkShaderModule vertex, VkShaderModule fragment,
                                const gpu_draw_options *options)
{
    const VkSpecializationInfo constants = gpu_constants(&options->constant);
    VkPipelineShaderStageCreateInfo stages[] = {
        stage_info(VK_SHADER_STAGE_VERTEX_BIT, vertex, &constants),
        stage_info(VK_SHADER_STAGE_FRAGMENT_BIT, fragment, &constants)};
    VkPipelineInputAssemblyStateCreateInfo assembly = {
        .sType = VK_STRUCTURE_TYPE_PIPELINE_INPUT_ASSEMBLY_STATE_CREATE_INFO,
        .topology =
            options->lines ? VK_PRIMITIVE_TOPOLOGY_LINE_LIST : VK_PRIMITIVE_TOPOLOGY_TRIANGLE_LIST};
    VkPipelineDepthStencilStateCreateInfo depth = {
        .sType = VK_STRUCTURE_TYPE_PIPELINE_DEPTH_STENCIL_STATE_CREATE_INFO,
        .depthTestEnable = draw->depth,
        .depthWriteEnable = draw->depth,
        .depthCompareOp = VK_COMPARE_OP_LESS};
    VkFormat formats[GPU_MAX_TARGETS];
    VkPipelineColorBlendAttachmentState attachments[GPU_MAX_TARGETS];
    for (int i = 0; i < draw->target_count; i++) {
        formats[i] = gpu_format_vk(draw->targets[i]);
        attachments[i] = (VkPipelineColorBlendAttachmentState){
            .colorWriteMask = VK_COLOR_COMPONENT_R_BIT | VK_COLOR_COMPONENT_G_BIT |
                              VK_COLOR_COMPONENT_B_BIT | VK_COLOR_COMPONENT_A_BIT};
    }
    VkPipelineColorBlendStateCreateInfo blend = {
        .sType = VK_STRUCTURE_TYPE_PIPELINE_COLOR_BLEND_STATE_CREATE_INFO,
        .attachmentCount = (uint32_t)draw->target_count,
        .pAttachments = attachments};
    VkPipelineRenderingCreateInfo rendering = {
        .sType = VK_STRUCTURE_TYPE_PIPELINE_RENDERING_CREATE_INFO,
        .colorAttachmentCount = (uint32_t)draw->target_count,
        .pColorAttachmentFormats = formats,
        .depthAttachmentFormat = draw->depth ? gpu_format_vk(GPU_DEPTH32) : VK_FORMAT_UNDEFINED};
    VkGraphicsPipelineCreateInfo info = {.sType = VK_STRUCTURE_TYPE_GRAPHICS_PIPELINE_CREATE_INFO,
                                         .pNext = &rendering,
                                         .stageCount = 2,
                                         .pStages = stages,
                                         .pVertexInputState = &no_attributes,
                                         .pInputAssemblyState = &assembly,
                                         .pViewportState = &one_viewport,
                                         .pRasterizationState = &both_sides,
                                         .pMultisampleState = &one_sample,
                                         .pDepthStencilState = &depth,
                                         .pColorBlendState = &blend,
                                         .pDynamicState = &dynamic,
                                         .layout = draw->layout.pipeline};
    return vkCreateGraphicsPipelines(draw->owner->device, VK_NULL_HANDLE, 1, &info, NULL,
                                     &draw->pipeline);
}

static gpu_status check(const gpu_device *device, const gpu_draw_options *options)
{
    if (!device->draws)
        return gpu_fail(GPU_UNSUPPORTED, "%s: %s does not draw (Vulkan 1.3 with dynamic rendering)",
                        options->name, device->info.name);
    if (options->target_count == 0 && !options->depth)
        return gpu_fail(GPU_UNSUPPORTED, "%s: it draws into nothing", options->name);
    for (int i = 0; i < options->target_count; i++)
        if (options->targets[i] == GPU_DEPTH32)
            return gpu_fail(GPU_UNSUPPORTED, "%s: target %d cannot hold depth", options->name, i);
    return GPU_OK;
}

static gpu_status create(gpu_draw *draw, const gpu_draw_options *options)
{
    gpu_device *device = draw->owner;
    VkShaderModule vertex = VK_NULL_HANDLE, fragment = VK_NULL_HANDLE;
    gpu_status status =
        gpu_module_create(device, GPU_VERTEX_STAGE, options->name, &options->vertex, &vertex);
    if (status == GPU_OK)
        status = gpu_module_create(device, GPU_FRAGMENT_STAGE, options->name, &options->fragment,
                                   &fragment);
    if (status == GPU_OK) {
        VkResult result = gpu_layout_create(device, &draw->layout);
        if (result == VK_SUCCESS)
            result = create_pipeline(draw, vertex, fragment, options);
        if (result != VK_SUCCESS)
            status = gpu_vk(result, options->name);
    }
    vkDestroyShaderModule(device->device, vertex, NULL);
    vkDestroyShaderModule(device->device, fragment, NULL);
    return status;
}

gpu_status gpu_draw_create(gpu_device *device, const gpu_draw_options *options, gpu_draw **out)
{
    *out = NULL;
    gpu_status status = check(device, options);
    if (status != GPU_OK)
        return status;
    gpu_kept *entry = gpu_kept_draw(device, options, out);
    if (*out)
        return GPU_OK;
    gpu_draw *draw = calloc(1, sizeof *draw);
    if (!draw) {
        free(entry);
        return gpu_fail(GPU_OUT_OF_MEMORY, "%s: out of host memory", options->name);
    }
    draw->owner = device;
    draw->target_count = options->target_count;
    memcpy(draw->targets, options->targets, sizeof draw->targets);
    draw->depth = options->depth;
    draw->layout =
        (gpu_layout){.binding_count = options->binding_count,
                     .push_size = options->push_size,
                     .stages = VK_SHADER_STAGE_VERTEX_BIT | VK_SHADER_STAGE_FRAGMENT_BIT};
    memcpy(draw->layout.bindings, options->bindings, sizeof options->bindings);
    status = create(draw, options);
    if (status != GPU_OK) {
        gpu_draw_destroy(draw);
        free(entry);
        return status;
    }
    gpu_keep(device, entry, NULL, draw);
    *out = draw;
    return GPU_OK;
}

void gpu_draw_destroy(gpu_draw *draw)
{
    if (!draw || draw->kept)
        return;
    vkDestroyPipeline(draw->owner->device, draw->pipeline, NULL);
    gpu_layout_destroy(draw->owner, &draw->layout);
    free(draw);
}
