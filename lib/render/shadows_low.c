/* Area lights with shadows at a half and a quarter of the resolution, with joint bilateral
 * upsampling. */
#include <stdlib.h>

#include "base/buffer.h"
#include "shadows.h"
#include "upsample.h"

/* Push constants of the passes that trace, for one light each: drivers may end a shader whose loops
 * turn often. */
typedef struct light_push {
    uint32_t first, last;
} light_push;
typedef struct gather_push {
    upsample_settings settings;
    light_push lights;
} gather_push;

typedef struct state {
    shadows shadows;
    upsample_settings settings;
    gpu_compute *gather, *upsample, *rest;
    gpu_image *sample_light, *sample_position;
    gpu_buffer *arguments, *list; /* pixels without a sample */
} state;

static void destroy(void *pointer)
{
    state *s = pointer;
    gpu_compute_destroy(s->gather);
    gpu_compute_destroy(s->upsample);
    gpu_compute_destroy(s->rest);
    gpu_image_destroy(s->sample_light);
    gpu_image_destroy(s->sample_position);
    gpu_buffer_destroy(s->arguments);
    gpu_buffer_destroy(s->list);
    shadows_destroy(&s->shadows);
    free(s);
}

static gpu_status create_passes(render_frame *frame, state *s)
{
    static const gpu_binding gather[] = {GPU_STORAGE_IMAGE, GPU_STORAGE_IMAGE};
    static const gpu_binding rest[] = {GPU_STORAGE_IMAGE, GPU_STORAGE_BUFFER, GPU_STORAGE_BUFFER};
    static const gpu_binding up[] = {GPU_STORAGE_BUFFER, GPU_FETCHED,       GPU_FETCHED,
                                     GPU_FETCHED,        GPU_FETCHED,       GPU_STORAGE_IMAGE,
                                     GPU_STORAGE_BUFFER, GPU_STORAGE_BUFFER};
    uint32_t push = sizeof(upsample_settings);
    gpu_status status =
        shadows_compute(frame, "shadows/gather.comp", gather, 2, sizeof(gather_push), &s->gather);
    if (status == GPU_OK)
        status = render_compute(frame, "upsample/upsample.comp", false, up, 8, push, &s->upsample);
    if (status == GPU_OK)
        status = shadows_compute(frame, "shadows/rest.comp", rest, 3, sizeof(light_push), &s->rest);
    return status;
}

static gpu_status create_images(render_frame *frame, state *s)
{
    gpu_device *device = frame->device;
    uint32_t x = s->settings.blocks_x, y = s->settings.blocks_y;
    size_t pixels = (size_t)frame->width * frame->height;
    gpu_status status = gpu_image_create(device, GPU_RGBA32U, x, y, &s->sample_light);
    if (status == GPU_OK)
        status = gpu_image_create(device, GPU_RGBA32F, x, y, &s->sample_position);
    if (status == GPU_OK)
        status = gpu_buffer_create(device, 4 * sizeof(uint32_t), &s->arguments);
    if (status == GPU_OK)
        status = gpu_buffer_create(device, pixels * sizeof(uint32_t), &s->list);
    return status;
}

static gpu_status create(render_frame *frame, uint32_t factor, void **pointer)
{
    *pointer = NULL;
    state *s = base_allocate(sizeof *s);
    *s = (state){.settings = {.factor = factor,
                              .blocks_x = (frame->width + factor - 1) / factor,
                              .blocks_y = (frame->height + factor - 1) / factor,
                              .plane = 1,
                              .power = 32,
                              .least = 1e-3F}};
    gpu_status status = shadows_create(frame, &s->shadows);
    if (status == GPU_OK)
        status = create_images(frame, s);
    if (status == GPU_OK)
        status = create_passes(frame, s);
    if (status == GPU_OK)
        *pointer = s;
    else
        destroy(s);
    return status;
}

static gpu_step gather_step(const render_frame *frame, const state *s, const gather_push *push)
{
    gpu_step step = {.name = "gather",
                     .compute = s->gather,
                     .push = push,
                     .groups = {(s->settings.blocks_x * s->settings.blocks_y + 63) / 64, 1, 1}};
    shadows_bind(frame, &s->shadows, &step);
    step.resources[SHADOWS_BINDINGS] = s->sample_light;
    step.resources[SHADOWS_BINDINGS + 1] = s->sample_position;
    return step;
}

static gpu_step upsample_step(const render_frame *frame, const state *s)
{
    return (gpu_step){.name = "upsample",
                      .compute = s->upsample,
                      .resources = {frame->view, frame->position, frame->normal, s->sample_light,
                                    s->sample_position, frame->light, s->arguments, s->list},
                      .push = &s->settings,
                      .groups = {(frame->width + 63) / 64, s->settings.blocks_y + 1, 1}};
}

static gpu_step rest_step(const render_frame *frame, const state *s, const light_push *push)
{
    gpu_step step = {
        .name = "all rays", .compute = s->rest, .push = push, .indirect = s->arguments};
    shadows_bind(frame, &s->shadows, &step);
    step.resources[SHADOWS_BINDINGS] = frame->light;
    step.resources[SHADOWS_BINDINGS + 1] = s->arguments;
    step.resources[SHADOWS_BINDINGS + 2] = s->list;
    return step;
}

static gpu_status run(render_frame *frame, void *pointer, render_statistics *statistics)
{
    const state *s = pointer;
    uint32_t lights = s->shadows.light_count, parts = lights ? lights : 1;
    gather_push *push = base_allocate(parts * sizeof *push);
    gpu_step *steps = base_allocate((2 * (size_t)parts + 2) * sizeof *steps);
    int count = 0;
    steps[count++] = (gpu_step){.name = "reset", .fill = s->arguments, .clear_bits = {1}};
    for (uint32_t i = 0; i < parts; i++) {
        push[i] = (gather_push){s->settings, {i, i < lights ? i + 1 : lights}};
        steps[count++] = gather_step(frame, s, &push[i]);
    }
    steps[count++] = upsample_step(frame, s);
    for (uint32_t i = 0; i < parts; i++)
        steps[count++] = rest_step(frame, s, &push[i].lights);
    gpu_status status = shadows_run(frame, steps, count, statistics);
    free(steps);
    free(push);
    return status;
}

#define LOW(FACTOR, TITLE)                                                                         \
    static gpu_status create##FACTOR(render_frame *frame, void **pointer)                          \
    {                                                                                              \
        return create(frame, FACTOR, pointer);                                                     \
    }                                                                                              \
    const render_pipeline shadows##FACTOR##_pipeline = {                                           \
        .id = "shadows" #FACTOR,                                                                   \
        .title = "area lights with shadows at " TITLE " resolution, joint bilateral upsampling",   \
        .shadows = true,                                                                           \
        .create = create##FACTOR,                                                                  \
        .run = run,                                                                                \
        .destroy = destroy,                                                                        \
    };

LOW(2, "half")
LOW(4, "quarter")
