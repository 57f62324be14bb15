/* Koa and Johan 2016: fragments refined where visibility differs inside them, upsampled in a single
 * pass. */
#include "multires.h"

#include <stdlib.h>

#include "base/buffer.h"

typedef struct state {
    multires m;
    gpu_compute *test, *additional, *upsample;
} state;

static void destroy(void *pointer)
{
    state *s = pointer;
    gpu_compute_destroy(s->test);
    gpu_compute_destroy(s->additional);
    gpu_compute_destroy(s->upsample);
    multires_destroy(&s->m);
    free(s);
}

static gpu_status create_with(render_frame *frame, const multires_settings *settings,
                              void **pointer)
{
    static const gpu_binding image = GPU_STORAGE_IMAGE;
    *pointer = NULL;
    state *s = base_allocate(sizeof *s);
    *s = (state){0};
    gpu_status status = multires_create(frame, settings, &s->m);
    if (status == GPU_OK)
        status = multires_compute(frame, "multires/test.comp", NULL, &s->test);
    if (status == GPU_OK)
        status = multires_compute(frame, "multires/additional.comp", NULL, &s->additional);
    if (status == GPU_OK)
        status = multires_compute(frame, "multires/upsample.comp", &image, &s->upsample);
    if (status == GPU_OK)
        *pointer = s;
    else
        destroy(s);
    return status;
}

static gpu_status run(render_frame *frame, void *pointer, render_statistics *statistics)
{
    static const char *const names[] = {NULL, "sub-fragment visibility 2",
                                        "sub-fragment visibility 4", "sub-fragment visibility 8",
                                        "sub-fragment visibility 16"};
    const state *s = pointer;
    gpu_step steps[16];
    int count = multires_begin(frame, &s->m, steps);
    for (int l = RENDER_LEVELS - 1; l > 0; l--)
        steps[count++] = multires_list_step(frame, &s->m, names[l], s->test, l, l, NULL);
    steps[count++] =
        multires_list_step(frame, &s->m, "additional samples", s->additional, 0, 0, NULL);
    steps[count] =
        multires_step(frame, &s->m, "single-pass upsampling", s->upsample, 0, frame->light);
    steps[count].groups[0] = (frame->width + 15) / 16;
    steps[count++].groups[1] = (frame->height + 7) / 8;
    return shadows_run(frame, steps, count, statistics);
}

static bool dump(render_frame *frame, void *pointer, const char *folder)
{
    const state *s = pointer;
    return multires_dump(frame, &s->m, folder);
}

#define MULTIRES(NAME, ID, POINTS, TITLE)                                                          \
    static gpu_status create##NAME(render_frame *frame, void **pointer)                            \
    {                                                                                              \
        multires_settings settings = multires_default;                                             \
        settings.points = POINTS;                                                                  \
        return create_with(frame, &settings, pointer);                                             \
    }                                                                                              \
    const render_pipeline multires##NAME##_pipeline = {                                            \
        .id = ID,                                                                                  \
        .title = TITLE,                                                                            \
        .shadows = true,                                                                           \
        .create = create##NAME,                                                                    \
        .run = run,                                                                                \
        .dump = dump,                                                                              \
        .destroy = destroy,                                                                        \
    };

MULTIRES(, "multires", MULTIRES_BOTH,
         "area lights with shadows by fragments of several resolutions (Koa and Johan 2016)")
MULTIRES(_same, "multires_same", MULTIRES_SAME, "the same by 16 points of each light alone")
MULTIRES(_apart, "multires_apart", MULTIRES_APART,
         "the same, 64 points split over four sub-fragments in the tests too")
