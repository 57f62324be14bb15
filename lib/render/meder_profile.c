/* What a frame of the pipeline `meder` asks the fitted form: its last quads drawn once more for
 * each channel. */
#include "meder.h"

#include <stdlib.h>

enum { CHANNELS = 3, FLOATS = 3 };

static gpu_status create_draw(render_frame *frame, gpu_draw **draw)
{
    gpu_draw_options options = {.name = "meder/profile",
                                .vertex = render_shader("meder/lighting.vert"),
                                .fragment = render_shader("meder/profile.frag"),
                                .binding_count = MEDER_DRAW_BINDINGS,
                                .push_size = sizeof(int32_t),
                                .target_count = 1,
                                .targets = {GPU_RGBA32F}};
    meder_draw_bindings(options.bindings);
    return gpu_draw_create(frame->device, &options, draw);
}

static gpu_status draw_channel(render_frame *frame, meder *m, gpu_draw *draw, gpu_image *target,
                               int32_t channel, float *pixels)
{
    gpu_step step = {.name = "profile",
                     .draw = draw,
                     .indices = m->indices,
                     .indirect = m->indirect,
                     .targets = {target},
                     .push = &channel};
    meder_draw_resources(frame, m, step.resources);
    gpu_status status = gpu_run(frame->device, &step, 1, NULL);
    return status == GPU_OK ? gpu_image_read(target, pixels) : status;
}

/* Those pixels that a lobe of any light was integrated for. */
static size_t collect(const float *pixels, size_t pixel_count, float *points)
{
    size_t count = 0;
    for (size_t i = 0; i < pixel_count; i++) {
        const float *p = pixels + 4 * i;
        if (p[3] == 0.0F || !(p[2] > 0.0F))
            continue;
        for (size_t c = 0; c < FLOATS; c++)
            points[FLOATS * count + c] = p[c];
        count++;
    }
    return count;
}

gpu_status meder_profile(render_frame *frame, void *state, float **points, size_t *count)
{
    size_t pixel_count = (size_t)frame->width * frame->height;
    gpu_draw *draw = NULL;
    gpu_image *target = NULL;
    float *pixels = malloc(4 * pixel_count * sizeof *pixels);
    float *found = malloc(CHANNELS * FLOATS * pixel_count * sizeof *found);
    gpu_status status = GPU_OK;
    *points = NULL;
    *count = 0;
    if (!pixels || !found)
        status = gpu_fail(GPU_OUT_OF_MEMORY, "meder: out of host memory");
    if (status == GPU_OK)
        status = create_draw(frame, &draw);
    if (status == GPU_OK)
        status = gpu_image_create(frame->device, GPU_RGBA32F, frame->width, frame->height, &target);
    for (int32_t channel = 0; channel < CHANNELS && status == GPU_OK; channel++) {
        status = draw_channel(frame, state, draw, target, channel, pixels);
        if (status == GPU_OK)
            *count += collect(pixels, pixel_count, found + FLOATS * *count);
    }
    gpu_draw_destroy(draw);
    gpu_image_destroy(target);
    free(pixels);
    if (status == GPU_OK)
        *points = found;
    else
        free(found);
    return status;
}
