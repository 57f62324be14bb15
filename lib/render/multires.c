/* Koa and Johan 2016: fragments refined where visibility differs inside them, upsampled in a single
 * pass. */
#include "multires.h"

#include <stdlib.h>

#include "base/buffer.h"

typedef struct state {
    multires m;
    gpu_compute *test, *additional, *upsample;
    gpu_compute *quads;  /* tests of four pixels that share what they see; else NULL */
    gpu_buffer *kept;    /* by test.comp between its dispatches */
    bool all_points;     /* an invocation may trace 64 rays to a light, not 16 */
    uint32_t at_once;    /* lights in a dispatch, where each has 16 rays */
    gpu_step *steps;     /* of a frame */
    multires_push *push; /* of the steps that do some of the lights */
    int step_count;
} state;

static void destroy(void *pointer)
{
    state *s = pointer;
    gpu_compute_destroy(s->test);
    gpu_compute_destroy(s->quads);
    gpu_compute_destroy(s->additional);
    gpu_compute_destroy(s->upsample);
    gpu_buffer_destroy(s->kept);
    multires_destroy(&s->m);
    free(s->steps);
    free(s->push);
    free(s);
}

/* ---- Steps --------------------------------------------------------------------------- */

/* Drivers may end a shader whose loops turn often (llvmpipe after 65,535 turns in all): so an
 * invocation traces rays to as many lights in one dispatch as settings have it; to a quarter of
 * them where each may have four times the rays, of all points of a light. */
static uint32_t lights_at_once(const state *s, int level)
{
    return level < 2 && s->all_points && s->at_once > 4 ? s->at_once / 4
           : level < 2 && s->all_points                 ? 1
                                                        : s->at_once;
}

static uint32_t parts_of(const state *s, uint32_t at_once)
{
    uint32_t lights = s->m.shadows.light_count;
    return lights > at_once ? (lights + at_once - 1) / at_once : 1;
}

/* One step over a list for each part of the lights. */
static void add_parts(state *s, gpu_step step, multires_push push, uint32_t at_once,
                      multires_push **next)
{
    for (uint32_t i = 0, parts = parts_of(s, at_once); i < parts; i++) {
        push.first_light = i * at_once;
        if (i + 1 < parts)
            push.last_light = push.first_light + at_once;
        else
            push.last_light = s->m.shadows.light_count;
        **next = push;
        step.push = (*next)++;
        s->steps[s->step_count++] = step;
    }
}

static void make_steps(render_frame *frame, state *s)
{
    static const char *const names[] = {NULL, "sub-fragment visibility 2",
                                        "sub-fragment visibility 4", "sub-fragment visibility 8",
                                        "sub-fragment visibility 16"};
    size_t most = 2 * RENDER_LEVELS * (size_t)parts_of(s, lights_at_once(s, 0));
    s->steps = base_allocate((most + MULTIRES_FIRST_STEPS + 2) * sizeof *s->steps);
    s->push = base_allocate(most * sizeof *s->push);
    multires_push *next = s->push;
    s->step_count = multires_begin(frame, &s->m, s->steps);
    for (int l = RENDER_LEVELS - 1; l > 0; l--) {
        gpu_compute *test = l == 1 && s->quads ? s->quads : s->test;
        gpu_step step = multires_list_step(frame, &s->m, names[l], test, l, l, s->kept);
        multires_push push = s->m.push[l];
        uint32_t rounds = push.last_round, at_once = lights_at_once(s, l);
        bool together = s->m.shadows.light_count * rounds <= at_once;
        if (together)
            add_parts(s, step, push, at_once, &next);
        for (uint32_t round = 0; !together && round < rounds; round++) {
            push.first_round = round;
            push.last_round = round + 1;
            add_parts(s, step, push, at_once, &next);
        }
    }
    gpu_step more =
        multires_list_step(frame, &s->m, "additional samples", s->additional, 0, 0, NULL);
    add_parts(s, more, s->m.push[0], lights_at_once(s, 0), &next);
    gpu_step *up = &s->steps[s->step_count++];
    *up = multires_step(frame, &s->m, "single-pass upsampling", s->upsample, 0, frame->light);
    up->groups[0] = (frame->width + 15) / 16;
    up->groups[1] = (frame->height + 7) / 8;
}

/* ---- Pipelines ----------------------------------------------------------------------- */

/* 32 bytes for each of the four sub-fragments of as many fragments as level 1 has. */
static gpu_status create_kept(render_frame *frame, state *s)
{
    size_t bytes = s->m.shadows.light_count > 1 ? 32 * ((size_t)256 * s->m.tiles + 64) : 16;
    if (bytes > (size_t)128 << 20)
        return gpu_fail(GPU_UNSUPPORTED,
                        "%u x %u pixels: what is known of them between some of %u area lights and "
                        "the next needs %zu MiB, more than 128",
                        frame->width, frame->height, s->m.shadows.light_count, bytes >> 20);
    return gpu_buffer_create(frame->device, bytes, &s->kept);
}

gpu_status multires_create_state(render_frame *frame, const multires_settings *settings,
                                 void **pointer)
{
    static const gpu_binding image = GPU_STORAGE_IMAGE, buffer = GPU_STORAGE_BUFFER;
    *pointer = NULL;
    state *s = base_allocate(sizeof *s);
    *s = (state){.all_points = settings->points != MULTIRES_SAME, .at_once = settings->at_once};
    gpu_status status = multires_create(frame, settings, &s->m);
    if (status == GPU_OK)
        status = create_kept(frame, s);
    if (status == GPU_OK)
        status = multires_compute(
            frame, settings->lobes ? "multires/test_lobe.comp" : "multires/test.comp", &buffer,
            &s->test);
    if (status == GPU_OK && settings->points == MULTIRES_BOTH)
        status = multires_compute(
            frame, settings->lobes ? "multires/quads_lobe.comp" : "multires/quads.comp", &buffer,
            &s->quads);
    if (status == GPU_OK)
        status = multires_compute(
            frame, settings->lobes ? "multires/additional_lobe.comp" : "multires/additional.comp",
            NULL, &s->additional);
    if (status == GPU_OK)
        status = multires_compute(frame, "multires/upsample.comp", &image, &s->upsample);
    if (status == GPU_OK) {
        make_steps(frame, s);
        *pointer = s;
    } else {
        destroy(s);
    }
    return status;
}

static gpu_status run(render_frame *frame, void *pointer, render_statistics *statistics)
{
    const state *s = pointer;
    return shadows_run(frame, s->steps, s->step_count, statistics);
}

static bool dump(render_frame *frame, void *pointer, const char *folder)
{
    const state *s = pointer;
    return multires_dump(frame, &s->m, folder);
}

#define MULTIRES(NAME, ID, POINTS, LOBES, TITLE)                                                   \
    static gpu_status create##NAME(render_frame *frame, void **pointer)                            \
    {                                                                                              \
        multires_settings settings = multires_default;                                             \
        settings.points = POINTS;                                                                  \
        settings.lobes = LOBES;                                                                    \
        return multires_create_state(frame, &settings, pointer);                                   \
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

MULTIRES(, "multires", MULTIRES_BOTH, false,
         "area lights with shadows by fragments of several resolutions (Koa and Johan 2016)")
MULTIRES(_same, "multires_same", MULTIRES_SAME, false, "the same by 16 points of each light alone")
MULTIRES(_apart, "multires_apart", MULTIRES_APART, false,
         "the same, 64 points split over four sub-fragments in the tests too")
MULTIRES(_lobe, "multires_lobe", MULTIRES_BOTH, true,
         "the same, lights without shadow taken as spherical Gaussians")
