/* What multires and nichols share: buffers of fragments, the pyramids, the first fragments. */
#include <string.h>

#include "multires.h"

/* Four words for each of the lists and for the mean irradiance, see struct Work. */
enum { WORK_WORDS = 4 * (RENDER_LEVELS + 1) };

const multires_settings multires_default = {.differing = 1,
                                            .steep = 4,
                                            .tolerance = 0.06F,
                                            .plane_limit = 1.5F,
                                            .normal_limit = 0.25F,
                                            .points = MULTIRES_BOTH,
                                            .together = 16,
                                            .at_once = 4};

static const size_t most_bytes = (size_t)128 << 20;

static gpu_status create_buffers(render_frame *frame, multires *m)
{
    size_t all = MULTIRES_FRAGMENTS * m->tiles, above = (MULTIRES_FRAGMENTS - 256) * m->tiles;
    if (all * 16 > most_bytes)
        return gpu_fail(GPU_UNSUPPORTED,
                        "%u x %u pixels: their fragments need %zu MiB, more than 128", frame->width,
                        frame->height, all * 16 >> 20);
    gpu_status status = gpu_buffer_create(frame->device, WORK_WORDS * sizeof(uint32_t), &m->work);
    if (status == GPU_OK)
        status = gpu_buffer_create(frame->device, all * sizeof(uint32_t), &m->lists);
    if (status == GPU_OK)
        status = gpu_buffer_create(frame->device, above * sizeof(float), &m->pyramid);
    if (status == GPU_OK)
        status = gpu_buffer_create(frame->device, all * 4 * sizeof(float), &m->illumination);
    return status;
}

gpu_status multires_create(render_frame *frame, const multires_settings *settings, multires *m)
{
    *m = (multires){0};
    gpu_status status = shadows_create(frame, &m->shadows);
    uint32_t across = (frame->width + MULTIRES_TILE - 1) / MULTIRES_TILE;
    uint32_t down = (frame->height + MULTIRES_TILE - 1) / MULTIRES_TILE;
    m->tiles = (size_t)across * down;
    float tolerance = settings->points == MULTIRES_BOTH ? settings->tolerance : 0;
    for (uint32_t l = 0; l < RENDER_LEVELS; l++)
        m->push[l] =
            (multires_push){.tiles = {across, down},
                            .level = l,
                            .differing = settings->differing,
                            .steep = settings->steep,
                            .tolerance = l > 2 ? tolerance / 3 : tolerance,
                            .plane_limit = settings->plane_limit,
                            .normal_limit = settings->normal_limit,
                            .points = (uint32_t)settings->points,
                            .together = settings->together,
                            .last_light = m->shadows.light_count,
                            .last_round = settings->points == MULTIRES_BOTH && l > 1 ? 2 : 1};
    if (status == GPU_OK)
        status = create_buffers(frame, m);
    if (status == GPU_OK)
        status = multires_compute(frame, "multires/pyramids.comp", NULL, &m->pyramids);
    if (status == GPU_OK)
        status = multires_compute(frame, "multires/cull.comp", NULL, &m->cull);
    if (status == GPU_OK && tolerance > 0)
        status = multires_compute(frame, "multires/mean.comp", NULL, &m->mean);
    if (status != GPU_OK)
        multires_destroy(m);
    return status;
}

void multires_destroy(multires *m)
{
    gpu_compute_destroy(m->pyramids);
    gpu_compute_destroy(m->cull);
    gpu_compute_destroy(m->mean);
    gpu_buffer_destroy(m->work);
    gpu_buffer_destroy(m->lists);
    gpu_buffer_destroy(m->pyramid);
    gpu_buffer_destroy(m->illumination);
    shadows_destroy(&m->shadows);
    *m = (multires){0};
}

gpu_status multires_compute(render_frame *frame, const char *path, const gpu_binding *own,
                            gpu_compute **compute)
{
    gpu_binding bindings[] = {GPU_STORAGE_BUFFER, GPU_STORAGE_BUFFER, GPU_STORAGE_BUFFER,
                              GPU_STORAGE_BUFFER, own ? *own : GPU_STORAGE_BUFFER};
    return shadows_compute(frame, path, bindings, own ? 5 : 4, sizeof(multires_push), compute);
}

gpu_step multires_step(const render_frame *frame, const multires *m, const char *name,
                       gpu_compute *compute, int level, void *own)
{
    gpu_step step = {.name = name, .compute = compute, .push = &m->push[level]};
    shadows_bind(frame, &m->shadows, &step);
    void *resources[] = {m->work, m->lists, m->pyramid, m->illumination, own};
    memcpy(step.resources + SHADOWS_BINDINGS, resources, sizeof resources);
    return step;
}

gpu_step multires_list_step(const render_frame *frame, const multires *m, const char *name,
                            gpu_compute *compute, int level, int list, void *own)
{
    gpu_step step = multires_step(frame, m, name, compute, level, own);
    step.indirect = m->work;
    step.indirect_offset = (size_t)list * 4 * sizeof(uint32_t);
    return step;
}

int multires_begin(const render_frame *frame, const multires *m, gpu_step *steps)
{
    const uint32_t *tiles = m->push[0].tiles;
    steps[0] = (gpu_step){.name = "reset lists", .fill = m->work, .clear_bits = {1}};
    steps[1] = (gpu_step){.name = "reset illumination", .fill = m->illumination};
    int count = 2;
    for (int l = RENDER_LEVELS - 1; m->mean && l >= 0; l -= RENDER_LEVELS - 1) {
        steps[count] = multires_step(
            frame, m, l > 0 ? "visibility for the mean" : "mean irradiance", m->mean, l, NULL);
        uint32_t groups = l > 0 ? (uint32_t)((m->tiles + 63) / 64) : 1;
        memcpy(steps[count++].groups, (uint32_t[3]){groups, 1, 1}, sizeof steps->groups);
    }
    steps[count++] = multires_step(frame, m, "discontinuity pyramids", m->pyramids, 0, NULL);
    steps[count++] = multires_step(frame, m, "discontinuity and culling", m->cull, 0, NULL);
    for (int i = count - 2; i < count; i++)
        memcpy(steps[i].groups, (uint32_t[3]){tiles[0], tiles[1], 1}, sizeof steps[i].groups);
    return count;
}
