/* A frame: a scene on a device, its G-buffer and its lights. */
#include "internal.h"
#include "lpv.h"

#include <stdlib.h>
#include <string.h>

static gpu_status check_needs(gpu_device *device, const render_options *options)
{
    uint32_t side = options->width > options->height ? options->width : options->height;
    gpu_needs needs = {.group_invocations = 1024,
                       .shared_bytes = 16384,
                       .image_side = side,
                       .subgroup_invocations = 4};
    return gpu_check(device, &needs);
}

static gpu_status create_images(render_frame *frame)
{
    gbuffer images;
    gpu_status status = gbuffer_create(frame->device, frame->width, frame->height, &images);
    frame->position = images.position;
    frame->normal = images.normal;
    frame->albedo = images.albedo;
    frame->depth = images.depth;
    if (status == GPU_OK)
        status = gpu_image_create(frame->device, GPU_RGBA32F, frame->width, frame->height,
                                  &frame->light);
    if (status == GPU_OK)
        status = gpu_image_create(frame->device, GPU_RGBA32F, frame->width, frame->height,
                                  &frame->image);
    return status;
}

static gpu_status create_buffers(render_frame *frame)
{
    gpu_status status = gpu_buffer_create(frame->device, sizeof(view_data), &frame->view);
    if (status != GPU_OK)
        return status;
    view_data *view = gpu_buffer_map(frame->view);
    view_fill(&frame->scene->camera, frame->width, frame->height, view);
    view->size[3] = (uint32_t)frame->scene->triangle_count;
    return gpu_buffer_create(frame->device, 128, &frame->counters);
}

static gpu_status draw(render_frame *frame, const geometry *geometry)
{
    gbuffer images = {frame->position, frame->normal, frame->albedo, frame->depth};
    double ms;
    gpu_status status = geometry_draw(geometry, frame->view, &images,
                                      frame->options.detailed_normals, frame->options.runs, &ms);
    if (status != GPU_OK)
        return status;
    statistics_add_time(&frame->made, "gbuffer", ms);
    status = lights_create(frame, geometry, &ms);
    if (status != GPU_OK)
        return status;
    if (frame->scene->has_spot)
        statistics_add_time(&frame->made, "rsm", ms);
    view_data *view = gpu_buffer_map(frame->view);
    view->size[2] = frame->light_count;
    frame->made.triangles = frame->scene->triangle_count;
    frame->made.lights = frame->light_count;
    return tone_measure(frame);
}

gpu_status render_frame_create(gpu_device *device, const render_scene *scene,
                               const render_options *options, render_frame *frame)
{
    *frame = (render_frame){.device = device,
                            .scene = scene,
                            .options = *options,
                            .width = options->width,
                            .height = options->height};
    if (frame->options.runs < 1)
        frame->options.runs = 1;
    gpu_status status = check_needs(device, options);
    geometry geometry = {0};
    if (status == GPU_OK)
        status = create_images(frame);
    if (status == GPU_OK)
        status = create_buffers(frame);
    if (status == GPU_OK)
        status = geometry_create(device, scene, &geometry);
    if (status == GPU_OK)
        status = draw(frame, &geometry);
    if (status == GPU_OK)
        status = resolve_create(frame);
    if (status == GPU_OK && options->indirect == RENDER_INDIRECT_LPV) {
        lpv_settings settings = lpv_default;
        settings.volume = options->volume;
        settings.steps = options->steps;
        status = lpv_create(frame, &settings, &frame->lpv);
    }
    geometry_destroy(&geometry);
    if (status != GPU_OK)
        render_frame_destroy(frame);
    return status;
}

void render_frame_destroy(render_frame *frame)
{
    lpv_destroy(frame->lpv);
    gpu_compute_destroy(frame->resolve);
    gpu_compute_destroy(frame->count);
    gpu_buffer_destroy(frame->view);
    gpu_buffer_destroy(frame->lights);
    gpu_buffer_destroy(frame->counters);
    gpu_image_destroy(frame->position);
    gpu_image_destroy(frame->normal);
    gpu_image_destroy(frame->albedo);
    gpu_image_destroy(frame->depth);
    gpu_image_destroy(frame->light);
    gpu_image_destroy(frame->image);
    *frame = (render_frame){0};
}

gpu_status render_frame_run(render_frame *frame, const render_pipeline *pipeline, void *state,
                            render_statistics *statistics)
{
    *statistics = frame->made;
    gpu_step clear = {.name = "clear", .clear = frame->light};
    gpu_status status = gpu_run(frame->device, &clear, 1, NULL);
    if (status == GPU_OK)
        status = pipeline->run(frame, state, statistics);
    if (status == GPU_OK && frame->lpv)
        status = lpv_run(frame, frame->lpv, !pipeline->shadows, statistics);
    if (status == GPU_OK)
        status = resolve_run(frame, statistics);
    statistics->ground_truth_evaluations =
        (statistics->pixels_covered + statistics->pixels_uncovered) * statistics->lights;
    return status;
}

gpu_status render_frame_light(render_frame *frame, const render_pipeline *pipeline,
                              render_statistics *statistics)
{
    void *state = NULL;
    gpu_status status = pipeline->create(frame, &state);
    if (status != GPU_OK)
        return status;
    status = render_frame_run(frame, pipeline, state, statistics);
    pipeline->destroy(state);
    return status;
}
