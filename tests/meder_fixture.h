/* meder_fixture.h: the pipeline `meder` on depth images that are made here: neither a scene nor the
 * G-buffer pass takes part. */
#ifndef MEDER_FIXTURE_H
#define MEDER_FIXTURE_H

#include "pass_fixture.h"

#include "meder_reference.h"
#include "render/internal.h"
#include "render/meder.h"

enum { LIGHTS = 7 };

/* A frame with nothing in it but what the pipeline reads. */
static inline void open_frame(render_frame *frame, uint32_t width, uint32_t height)
{
    *frame = (render_frame){.device = open_software_device(), .width = width, .height = height};
    render_camera camera = {{0.3, 1.7, 4.9}, {0, 0.85, 0}, {0, 1, 0}, 45, 0.1, 100};
    frame->view = make_buffer(frame->device, sizeof(view_data));
    view_data *view = gpu_buffer_map(frame->view);
    view_fill(&camera, width, height, view);
    view->size[2] = frame->light_count = LIGHTS;
    frame->lights = make_buffer(frame->device, LIGHTS * sizeof(light_data));
    reference_lights(gpu_buffer_map(frame->lights), LIGHTS);
    frame->counters = make_buffer(frame->device, 64);
    memset(gpu_buffer_map(frame->counters), 0, 64);
    frame->position = make_image(frame->device, GPU_RGBA32F, width, height);
    frame->normal = make_image(frame->device, GPU_RG32U, width, height);
    frame->depth = make_image(frame->device, GPU_DEPTH32, width, height);
    frame->light = make_image(frame->device, GPU_RGBA32F, width, height);
}

static inline void close_frame(render_frame *frame)
{
    gpu_buffer_destroy(frame->view);
    gpu_buffer_destroy(frame->lights);
    gpu_buffer_destroy(frame->counters);
    gpu_image_destroy(frame->position);
    gpu_image_destroy(frame->normal);
    gpu_image_destroy(frame->depth);
    gpu_image_destroy(frame->light);
    close_clean(frame->device);
}

/* Depth, and the positions that have it. The normals face the camera. */
static inline void fill_frame(render_frame *frame, const float *depth)
{
    size_t count = (size_t)frame->width * frame->height;
    float *position = calloc(count, 16);
    uint32_t *normal = calloc(count, 8);
    assert_non_null(position);
    assert_non_null(normal);
    const view_data *view = gpu_buffer_map(frame->view);
    for (uint32_t y = 0; y < frame->height; y++)
        for (uint32_t x = 0; x < frame->width; x++) {
            size_t i = (size_t)y * frame->width + x;
            double at[2] = {2 * (x + 0.5) / frame->width - 1, 2 * (y + 0.5) / frame->height - 1};
            if (depth[i] < 1)
                reference_unproject(view, at, (double)depth[i], position + 4 * i);
        }
    must(gpu_image_write(frame->depth, depth));
    must(gpu_image_write(frame->position, position));
    must(gpu_image_write(frame->normal, normal)); /* 0: the z axis */
    free(position);
    free(normal);
}

static inline meder *run_on(render_frame *frame, const float *depth)
{
    void *state;
    must(meder_pipeline.create(frame, &state));
    fill_frame(frame, depth);
    gpu_step steps[MEDER_STEPS];
    meder_steps(frame, state, steps);
    must(gpu_run(frame->device, steps, MEDER_STEPS, NULL));
    return state;
}

/* Smooth slopes, steps, noise and holes, each somewhere. */
static inline float *random_depth(uint32_t width, uint32_t height, uint32_t seed)
{
    float *depth = malloc((size_t)width * height * sizeof *depth);
    assert_non_null(depth);
    for (uint32_t y = 0; y < height; y++)
        for (uint32_t x = 0; x < width; x++) {
            seed = seed * 1664525U + 1013904223U;
            double u = (double)(seed >> 8) / 16777216, slope = 1.0 * x / width + 2.0 * y / height;
            double z = 0.95 + 0.01 * slope + 0.004 * (x * 5 / width * 3 % 4);
            if (x > width / 2)
                z += 0.002 * u; /* about the threshold */
            depth[(size_t)y * width + x] = u < 0.02 ? 1.0F : (float)(z < 0.999 ? z : 0.999);
        }
    return depth;
}

#endif
