/* The passes of the light propagation volume. */
#include "lpv.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/buffer.h"
#include "internal.h"

const lpv_settings lpv_default = {.volume = LPV_USUAL_VOLUME,
                                  .samples = 4000,
                                  .darts = 100000,
                                  .points = 16,
                                  .sharpest = 0.5F,
                                  .lift = 1};

enum { GROUP = 64, EMITTERS = 64, LOBES_BYTES = 48, SUMS_BYTES = 96 };

/* struct Emitter of shaders/lpv/gather.comp. */
typedef struct emitter_data {
    float position[4], normal[4], flux[4];
} emitter_data;

/* Push constants of shaders/lpv/gather.comp. */
typedef struct gather_push {
    uint32_t samples, points, first_light, last_light, emitters, add;
} gather_push;

/* ---- Buffers -------------------------------------------------------------------------- */

static gpu_status make_buffer(render_frame *frame, const void *data, size_t size,
                              gpu_buffer **buffer)
{
    static const size_t most = (size_t)128 << 20; /* that every device offers */
    if (size > most)
        return gpu_fail(GPU_UNSUPPORTED, "indirect light: the volume needs %zu MiB, more than 128",
                        size >> 20);
    gpu_status status = gpu_buffer_create(frame->device, size, buffer);
    if (status == GPU_OK && data && size)
        memcpy(gpu_buffer_map(*buffer), data, size);
    return status;
}

static gpu_status make_volume(render_frame *frame, const lpv_samples *samples, lpv *l)
{
    lpv_volume v;
    lpv_volume_make(frame->scene, samples, l->settings.volume, &v);
    l->push.voxels = (uint32_t)v.voxels;
    l->push.side = (float)v.side;
    l->push.lift = l->settings.lift;
    l->push.sharpest = l->settings.sharpest;
    for (int k = 0; k < 3; k++) {
        l->push.size[k] = v.size[k];
        l->push.low[k] = (float)v.low[k];
    }
    gpu_status status = make_buffer(frame, v.first, (v.voxels + 1) * sizeof *v.first, &l->first);
    if (status == GPU_OK)
        status = make_buffer(frame, v.entries, v.entry_count * sizeof *v.entries, &l->entries);
    if (status == GPU_OK)
        status = make_buffer(frame, v.open, 4 * v.voxels * sizeof *v.open, &l->open);
    gpu_buffer **const own[] = {&l->lobes[0], &l->lobes[1], &l->sums};
    for (int i = 0; i < 3 && status == GPU_OK; i++)
        status = make_buffer(frame, NULL, v.voxels * (i < 2 ? LOBES_BYTES : SUMS_BYTES), own[i]);
    lpv_volume_free(&v);
    return status;
}

/* The shadow map's texels, of which there may be very many, as EMITTERS of equal flux: those texels
 * that the sum of their luminances passes in equal steps. */
static void choose_emitters(const render_frame *frame, emitter_data *emitters)
{
    const light_data *lights = gpu_buffer_map(frame->lights);
    uint32_t texels = frame->texel_count;
    double all = 0, area = 0, before = 0;
    for (uint32_t i = 0; i < texels; i++) {
        all += (double)(lights[i].plane[3] * (0.2126F * lights[i].a[3] + 0.7152F * lights[i].b[3] +
                                              0.0722F * lights[i].c[3]));
        area += (double)lights[i].plane[3];
    }
    uint32_t made = 0;
    for (uint32_t i = 0; i < texels && all > 0; i++) {
        const light_data *l = &lights[i];
        const float exitance[3] = {l->a[3], l->b[3], l->c[3]};
        double luminance = 0.2126 * (double)exitance[0] + 0.7152 * (double)exitance[1] +
                           0.0722 * (double)exitance[2];
        before += (double)l->plane[3] * luminance;
        for (; made < EMITTERS && (made + 0.5) * all / EMITTERS <= before; made++) {
            emitter_data *e = &emitters[made];
            for (int k = 0; k < 3; k++) {
                e->position[k] = (l->a[k] + l->b[k] + l->c[k]) / 3;
                e->normal[k] = l->plane[k];
                e->flux[k] = (float)((double)exitance[k] / luminance * all / EMITTERS);
            }
            e->position[3] = (float)(area / (EMITTERS * 3.14159265358979323846));
        }
    }
}

static gpu_status make_samples(render_frame *frame, lpv *l)
{
    lpv_samples samples;
    emitter_data emitters[EMITTERS] = {{{0}, {0}, {0}}};
    lpv_samples_make(frame->scene, l->settings.samples, l->settings.darts, &samples);
    l->samples = (uint32_t)samples.count;
    gpu_status status = GPU_OK;
    if (samples.count > 0) {
        status = make_buffer(frame, samples.samples, samples.count * sizeof *samples.samples,
                             &l->sample_data);
        if (status == GPU_OK)
            status = make_buffer(frame, NULL, samples.count * 32, &l->reflected);
        choose_emitters(frame, emitters);
        if (status == GPU_OK)
            status = make_buffer(frame, emitters, sizeof emitters, &l->emitters);
        if (status == GPU_OK)
            status = make_volume(frame, &samples, l);
    }
    lpv_samples_free(&samples);
    return status;
}

/* ---- Passes --------------------------------------------------------------------------- */

static gpu_status make_passes(render_frame *frame, lpv *l)
{
    static const gpu_binding buffers[6] = {GPU_STORAGE_BUFFER};
    static const gpu_binding pixels[] = {GPU_STORAGE_BUFFER, GPU_STORAGE_BUFFER, GPU_FETCHED,
                                         GPU_FETCHED,        GPU_FETCHED,        GPU_STORAGE_IMAGE};
    bool printed = l->settings.printed;
    gpu_status status =
        shadows_compute(frame, "lpv/gather.comp", buffers, 3, sizeof(gather_push), &l->gather);
    if (status == GPU_OK)
        status = render_compute(frame, printed ? "lpv/deposit_printed.comp" : "lpv/deposit.comp",
                                false, buffers, 6, sizeof(lpv_push), &l->deposit);
    if (status == GPU_OK)
        status = render_compute(frame, printed ? "lpv/printed.comp" : "lpv/propagate.comp", false,
                                buffers, 4, sizeof(lpv_push), &l->propagate);
    if (status == GPU_OK)
        status =
            gpu_image_create(frame->device, GPU_RGBA32F, frame->width, frame->height, &l->light);
    if (status == GPU_OK)
        status = render_compute(frame, "lpv/look_up.comp", false, pixels, 6, sizeof(lpv_push),
                                &l->look_up);
    return status;
}

gpu_status lpv_create(render_frame *frame, const lpv_settings *settings, lpv **result)
{
    *result = NULL;
    lpv *l = base_allocate(sizeof *l);
    *l = (lpv){.settings = *settings};
    if (l->settings.volume == 0)
        l->settings.volume = lpv_default.volume;
    if (l->settings.steps == 0)
        l->settings.steps = 2 * l->settings.volume;
    gpu_status status = shadows_create_any(frame, &l->shadows);
    if (status == GPU_OK)
        status = make_samples(frame, l);
    if (status == GPU_OK && l->samples > 0)
        status = make_passes(frame, l);
    if (status == GPU_OK)
        *result = l;
    else
        lpv_destroy(l);
    return status;
}

void lpv_destroy(lpv *l)
{
    if (!l)
        return;
    gpu_compute *const passes[] = {l->gather, l->deposit, l->propagate, l->look_up};
    for (size_t i = 0; i < sizeof passes / sizeof *passes; i++)
        gpu_compute_destroy(passes[i]);
    gpu_buffer *const buffers[] = {l->sample_data, l->reflected, l->emitters, l->first, l->entries,
                                   l->open,        l->lobes[0],  l->lobes[1], l->sums};
    for (size_t i = 0; i < sizeof buffers / sizeof *buffers; i++)
        gpu_buffer_destroy(buffers[i]);
    gpu_image_destroy(l->light);
    shadows_destroy(&l->shadows);
    free(l);
}

/* Some lights at a time, so that no driver ends the loop over their rays. Returns the number of
 * steps. */
static uint32_t gather_steps(const render_frame *frame, const lpv *l, bool texels,
                             gather_push *push, gpu_step *steps)
{
    uint32_t lights = l->shadows.light_count, together = SHADOWS_POINTS / l->settings.points;
    uint32_t parts = (lights + together - 1) / together, emitters = texels && frame->texel_count;
    for (uint32_t i = 0; i < parts + emitters || i == 0; i++) {
        uint32_t first = i < parts ? i * together : lights;
        uint32_t last = first + together < lights ? first + together : lights;
        push[i] = (gather_push){
            l->samples, l->settings.points, first, last, i < parts || !emitters ? 0 : EMITTERS,
            i > 0};
        steps[i] = (gpu_step){.name = "lpv gathering",
                              .compute = l->gather,
                              .push = &push[i],
                              .groups = {(2 * l->samples + GROUP - 1) / GROUP, 1, 1}};
        shadows_bind(frame, &l->shadows, &steps[i]);
        steps[i].resources[SHADOWS_BINDINGS] = l->sample_data;
        steps[i].resources[SHADOWS_BINDINGS + 1] = l->reflected;
        steps[i].resources[SHADOWS_BINDINGS + 2] = l->emitters;
    }
    return parts + emitters ? parts + emitters : 1;
}

gpu_status lpv_run(render_frame *frame, lpv *l, bool texels, render_statistics *statistics)
{
    if (l->samples == 0)
        return GPU_OK;
    size_t most = (size_t)l->shadows.light_count + l->settings.steps + 4;
    gpu_step *steps = base_allocate(most * sizeof *steps);
    gather_push *push = base_allocate(most * sizeof *push);
    uint32_t count = gather_steps(frame, l, texels, push, steps);
    uint32_t groups = (l->push.voxels + GROUP - 1) / GROUP;
    steps[count++] = (gpu_step){
        .name = "lpv deposit",
        .compute = l->deposit,
        .push = &l->push,
        .resources = {l->sample_data, l->reflected, l->first, l->entries, l->lobes[0], l->sums},
        .groups = {groups, 1, 1}};
    for (uint32_t i = 0; i < l->settings.steps; i++)
        steps[count++] =
            (gpu_step){.name = "lpv propagation",
                       .compute = l->propagate,
                       .push = &l->push,
                       .resources = {l->lobes[i % 2], l->lobes[1 - i % 2], l->open, l->sums},
                       .groups = {groups, 1, 1}};
    steps[count++] = (gpu_step){
        .name = "lpv look-up",
        .compute = l->look_up,
        .push = &l->push,
        .resources = {frame->view, l->sums, frame->position, frame->normal, frame->light, l->light},
        .groups = {(frame->width + 15) / 16, (frame->height + 7) / 8, 1}};
    gpu_status status = shadows_run(frame, steps, (int)count, statistics);
    free(steps);
    free(push);
    /* the list may run several times: it reads one image and writes another */
    gpu_image *lit = l->light;
    l->light = frame->light;
    frame->light = lit;
    statistics->volume_samples = l->samples;
    statistics->voxels = l->push.voxels;
    return status;
}
