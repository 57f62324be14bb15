/* Nichols, Penmatsa and Wyman 2010: fragments refined where visibility differs from that of their
 * neighbours, upsampled from level to level. */
#include <stdlib.h>

#include "base/buffer.h"
#include "multires.h"

typedef struct state {
    multires m;
    multires_push *push; /* of each level, for each light */
    uint32_t lights;
    gpu_buffer *visible;
    gpu_compute *trace, *refine, *upsample;
} state;

static void destroy(void *pointer)
{
    state *s = pointer;
    gpu_buffer_destroy(s->visible);
    gpu_compute_destroy(s->trace);
    gpu_compute_destroy(s->refine);
    gpu_compute_destroy(s->upsample);
    multires_destroy(&s->m);
    free(s->push);
    free(s);
}

static gpu_status create_visible(render_frame *frame, state *s)
{
    size_t bytes = MULTIRES_FRAGMENTS * s->m.tiles * (1 + (size_t)s->m.shadows.light_count) * 8;
    if (bytes > (size_t)128 << 20)
        return gpu_fail(GPU_UNSUPPORTED,
                        "nichols keeps 64 bits for each fragment and light: %zu MiB here, more "
                        "than 128",
                        bytes >> 20);
    return gpu_buffer_create(frame->device, bytes, &s->visible);
}

/* A dispatch traces the rays to one light: drivers may end a shader whose loops turn often, and 64
 * rays through deep trees turn a lot. */
static void make_pushes(state *s)
{
    s->lights = s->m.shadows.light_count;
    s->push = base_allocate(s->lights * RENDER_LEVELS * sizeof *s->push);
    for (uint32_t i = 0; i < s->lights * RENDER_LEVELS; i++) {
        s->push[i] = s->m.push[i / s->lights];
        s->push[i].first_light = i % s->lights;
        s->push[i].last_light = s->push[i].first_light + 1;
    }
}

gpu_status nichols_create_state(render_frame *frame, const multires_settings *own, void **pointer)
{
    static const gpu_binding image = GPU_STORAGE_IMAGE, buffer = GPU_STORAGE_BUFFER;
    *pointer = NULL;
    state *s = base_allocate(sizeof *s);
    *s = (state){0};
    multires_settings settings = *own;
    settings.together = 64;
    settings.tolerance = 0;
    gpu_status status = multires_create(frame, &settings, &s->m);
    if (status == GPU_OK)
        status = create_visible(frame, s);
    if (status == GPU_OK)
        status = multires_compute(frame, "nichols/trace.comp", &buffer, &s->trace);
    if (status == GPU_OK)
        status = multires_compute(frame, "nichols/refine.comp", &buffer, &s->refine);
    if (status == GPU_OK)
        status = multires_compute(frame, "nichols/upsample.comp", &image, &s->upsample);
    if (status == GPU_OK) {
        make_pushes(s);
        *pointer = s;
    } else {
        destroy(s);
    }
    return status;
}

static gpu_status create(render_frame *frame, void **pointer)
{
    return nichols_create_state(frame, &multires_default, pointer);
}

/* A dispatch over all fragments of a level. */
static gpu_step level_step(const render_frame *frame, const state *s, const char *name,
                           gpu_compute *compute, int level, uint32_t wide, uint32_t high, void *own)
{
    gpu_step step = multires_step(frame, &s->m, name, compute, level, own);
    uint32_t fragments = MULTIRES_TILE >> level;
    step.groups[0] = (s->m.push[0].tiles[0] * fragments + wide - 1) / wide;
    step.groups[1] = (s->m.push[0].tiles[1] * fragments + high - 1) / high;
    return step;
}

static gpu_status run(render_frame *frame, void *pointer, render_statistics *statistics)
{
    static const char *const traced[] = {"visibility 1", "visibility 2", "visibility 4",
                                         "visibility 8", "visibility 16"};
    static const char *const refined[] = {"", "refinement 2", "refinement 4", "refinement 8",
                                          "refinement 16"};
    static const char *const up[] = {"upsampling to 1", "upsampling to 2", "upsampling to 4",
                                     "upsampling to 8", "upsampling to 16"};
    const state *s = pointer;
    gpu_step *steps = base_allocate((32 + s->lights * RENDER_LEVELS) * sizeof *steps);
    int count = multires_begin(frame, &s->m, steps);
    steps[count++] = (gpu_step){.name = "reset visibility", .fill = s->visible};
    for (int l = RENDER_LEVELS - 1; l >= 0; l--) {
        for (uint32_t light = 0; light < s->lights; light++) {
            steps[count] = multires_list_step(frame, &s->m, traced[l], s->trace, l, l, s->visible);
            steps[count++].push = &s->push[(uint32_t)l * s->lights + light];
        }
        if (l > 0)
            steps[count++] = level_step(frame, s, refined[l], s->refine, l, 8, 8, s->visible);
    }
    for (int l = RENDER_LEVELS - 1; l >= 0; l--)
        steps[count++] = level_step(frame, s, up[l], s->upsample, l, 16, 8, frame->light);
    gpu_status status = shadows_run(frame, steps, count, statistics);
    free(steps);
    return status;
}

static bool dump(render_frame *frame, void *pointer, const char *folder)
{
    const state *s = pointer;
    return multires_dump(frame, &s->m, folder);
}

const render_pipeline nichols_pipeline = {
    .id = "nichols",
    .title = "area lights with shadows by refinement between neighbours (Nichols et al. 2010)",
    .shadows = true,
    .create = create,
    .run = run,
    .dump = dump,
    .destroy = destroy,
};
