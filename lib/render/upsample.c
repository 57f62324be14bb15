/* Irradiance at a half, a quarter and an eighth of the resolution, with joint bilateral
 * upsampling: what most renderers do instead of a hull. */
#include "upsample.h"

#include <stdlib.h>

#include "base/buffer.h"

typedef struct upsample {
    upsample_settings settings;
    gpu_compute *gather, *upsample, *exact;
    gpu_image *sample_light, *sample_position;
    gpu_buffer *arguments, *list; /* pixels that are lit exactly */
} upsample;

static void destroy(void *state)
{
    upsample *u = state;
    if (!u)
        return;
    gpu_compute_destroy(u->gather);
    gpu_compute_destroy(u->upsample);
    gpu_compute_destroy(u->exact);
    gpu_image_destroy(u->sample_light);
    gpu_image_destroy(u->sample_position);
    gpu_buffer_destroy(u->arguments);
    gpu_buffer_destroy(u->list);
    free(u);
}

static gpu_status create_passes(render_frame *frame, upsample *u)
{
    static const gpu_binding gather[] = {GPU_STORAGE_BUFFER, GPU_STORAGE_BUFFER, GPU_STORAGE_BUFFER,
                                         GPU_FETCHED,        GPU_FETCHED,        GPU_STORAGE_IMAGE,
                                         GPU_STORAGE_IMAGE};
    static const gpu_binding up[] = {GPU_STORAGE_BUFFER, GPU_FETCHED,       GPU_FETCHED,
                                     GPU_FETCHED,        GPU_FETCHED,       GPU_STORAGE_IMAGE,
                                     GPU_STORAGE_BUFFER, GPU_STORAGE_BUFFER};
    static const gpu_binding exact[] = {GPU_STORAGE_BUFFER, GPU_STORAGE_BUFFER, GPU_STORAGE_BUFFER,
                                        GPU_FETCHED,        GPU_FETCHED,        GPU_STORAGE_IMAGE,
                                        GPU_STORAGE_BUFFER, GPU_STORAGE_BUFFER};
    uint32_t push = sizeof(upsample_settings);
    gpu_status status =
        render_compute(frame, "upsample/gather.comp", false, gather, 7, push, &u->gather);
    if (status == GPU_OK)
        status = render_compute(frame, "upsample/upsample.comp", false, up, 8, push, &u->upsample);
    if (status == GPU_OK)
        status = render_compute(frame, "upsample/exact.comp", false, exact, 8, 0, &u->exact);
    return status;
}

gpu_status upsample_create(render_frame *frame, const upsample_settings *settings, void **state)
{
    *state = NULL;
    upsample *u = calloc(1, sizeof *u);
    if (!u)
        return gpu_fail(GPU_OUT_OF_MEMORY, "upsampling: out of host memory");
    u->settings = *settings;
    uint32_t x = u->settings.blocks_x = (frame->width + settings->factor - 1) / settings->factor;
    uint32_t y = u->settings.blocks_y = (frame->height + settings->factor - 1) / settings->factor;
    size_t pixels = (size_t)frame->width * frame->height;
    gpu_device *device = frame->device;
    gpu_status status = gpu_image_create(device, GPU_RGBA32U, x, y, &u->sample_light);
    if (status == GPU_OK)
        status = gpu_image_create(device, GPU_RGBA32F, x, y, &u->sample_position);
    if (status == GPU_OK)
        status = gpu_buffer_create(device, 4 * sizeof(uint32_t), &u->arguments);
    if (status == GPU_OK)
        status = gpu_buffer_create(device, pixels * sizeof(uint32_t), &u->list);
    if (status == GPU_OK)
        status = create_passes(frame, u);
    if (status == GPU_OK)
        *state = u;
    else
        destroy(u);
    return status;
}

static gpu_status run(render_frame *frame, void *state, render_statistics *statistics)
{
    const upsample *u = state;
    const upsample_settings *s = &u->settings;
    gpu_step steps[] = {
        {.name = "reset", .fill = u->arguments, .clear_bits = {1}},
        {.name = "gather",
         .compute = u->gather,
         .resources = {frame->view, frame->lights, frame->counters, frame->position, frame->normal,
                       u->sample_light, u->sample_position},
         .push = s,
         .groups = {(s->blocks_x + 15) / 16, (s->blocks_y + 15) / 16, 1}},
        {.name = "upsample",
         .compute = u->upsample,
         .resources = {frame->view, frame->position, frame->normal, u->sample_light,
                       u->sample_position, frame->light, u->arguments, u->list},
         .push = s,
         .groups = {(frame->width + 63) / 64, s->blocks_y + 1, 1}},
        {.name = "exact",
         .compute = u->exact,
         .resources = {frame->view, frame->lights, frame->counters, frame->position, frame->normal,
                       frame->light, u->arguments, u->list},
         .indirect = u->arguments},
    };
    return render_run(frame, steps, (int)(sizeof steps / sizeof *steps), statistics);
}

#define UPSAMPLE(FACTOR, TITLE, ...)                                                               \
    static gpu_status create##FACTOR(render_frame *frame, void **state)                            \
    {                                                                                              \
        static const upsample_settings settings = {.factor = FACTOR, __VA_ARGS__};                 \
        return upsample_create(frame, &settings, state);                                           \
    }                                                                                              \
    const render_pipeline upsample##FACTOR##_pipeline = {                                          \
        .id = "upsample" #FACTOR,                                                                  \
        .title = TITLE " resolution, joint bilateral upsampling of irradiance",                    \
        .create = create##FACTOR,                                                                  \
        .run = run,                                                                                \
        .destroy = destroy,                                                                        \
    };

/* Chosen by bench/rivals_tried.md. */
UPSAMPLE(2, "half", .plane = 0.25F, .power = 32, .least = 0.1F)
UPSAMPLE(4, "quarter", .plane = 0.25F, .power = 32, .least = 0.01F)
UPSAMPLE(8, "an eighth of the", .plane = 1, .power = 8, .least = 0.01F)
