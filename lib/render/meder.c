/* The pipeline of Meder and Bruederlin's paper, as printed: downsampling, segmentation, bounding
 * boxes, quads, light gathered at their corners and integrated at their pixels. */
#include "meder.h"
#include "internal.h"

#include <stdlib.h>
#include <string.h>

uint32_t meder_quad_count(const meder *m)
{
    return *(const uint32_t *)gpu_buffer_map(m->indirect) / 6;
}

/* Six indices a quad, its corners in the order left top, right top, left bottom, right bottom. */
static void fill_indices(uint32_t *indices)
{
    static const uint32_t corners[6] = {0, 1, 2, 2, 1, 3};
    for (uint32_t quad = 0; quad < MEDER_MOST_SEGMENTS; quad++)
        for (uint32_t i = 0; i < 6; i++)
            indices[6 * quad + i] = 4 * quad + corners[i];
}

static gpu_status create_resources(gpu_device *device, meder *m)
{
    const struct {
        gpu_buffer **buffer;
        size_t size;
    } buffers[] = {{&m->boxes, MEDER_MOST_SEGMENTS * sizeof(meder_box)},
                   {&m->counts, MEDER_TILES * MEDER_TILES * sizeof(uint32_t)},
                   {&m->quads, MEDER_MOST_SEGMENTS * sizeof(uint32_t)},
                   {&m->indirect, 5 * sizeof(uint32_t)},
                   {&m->indices, 6 * MEDER_MOST_SEGMENTS * sizeof(uint32_t)}};
    gpu_status status = GPU_OK;
    for (size_t i = 0; i < sizeof buffers / sizeof *buffers && status == GPU_OK; i++)
        status = gpu_buffer_create(device, buffers[i].size, buffers[i].buffer);
    if (status == GPU_OK)
        status = gpu_image_create(device, GPU_R32F, MEDER_SIDE, MEDER_SIDE, &m->downsampled);
    if (status == GPU_OK)
        status = gpu_image_create(device, GPU_R32U, MEDER_SIDE, MEDER_SIDE, &m->labels);
    if (status != GPU_OK)
        return status;
    fill_indices(gpu_buffer_map(m->indices));
    for (int i = 0; i < 5; i++)
        ((uint32_t *)gpu_buffer_map(m->indirect))[i] = 0;
    return GPU_OK;
}

static gpu_status create_segmentation(render_frame *frame, meder *m)
{
    static const gpu_binding downsample[] = {GPU_STORAGE_BUFFER, GPU_FETCHED, GPU_STORAGE_IMAGE};
    static const gpu_binding boxes[] = {GPU_STORAGE_BUFFER, GPU_FETCHED, GPU_FETCHED,
                                        GPU_STORAGE_BUFFER, GPU_STORAGE_BUFFER};
    static const gpu_binding quads[] = {GPU_STORAGE_BUFFER, GPU_STORAGE_BUFFER, GPU_STORAGE_BUFFER,
                                        GPU_STORAGE_BUFFER, GPU_STORAGE_BUFFER};
    gpu_status status =
        render_compute(frame, "meder/downsample.comp", false, downsample, 3, 0, &m->downsample);
    if (status == GPU_OK)
        status = render_compute(frame, "meder/segment.comp", false, downsample, 3, sizeof(float),
                                &m->segment);
    if (status == GPU_OK)
        status = render_compute(frame, "meder/boxes.comp", false, boxes, 5, 0, &m->box);
    if (status == GPU_OK)
        status = render_compute(frame, "meder/quads.comp", false, quads, 5, 0, &m->list);
    return status;
}

void meder_draw_bindings(gpu_binding bindings[MEDER_DRAW_BINDINGS + 1])
{
    for (int i = 0; i <= MEDER_DRAW_BINDINGS; i++)
        bindings[i] = i >= 5 && i < MEDER_DRAW_BINDINGS ? GPU_FETCHED : GPU_STORAGE_BUFFER;
}

void meder_draw_resources(render_frame *frame, meder *m, void **resources)
{
    void *all[MEDER_DRAW_BINDINGS] = {frame->view,  frame->lights, frame->counters,
                                      m->boxes,     m->quads,      frame->position,
                                      frame->depth, frame->normal, m->labels};
    for (int i = 0; i < MEDER_DRAW_BINDINGS; i++)
        resources[i] = all[i];
}

/* The fragment shader integrates: it is compiled again where another method is asked for. */
static gpu_status create_light(render_frame *frame, meder *m)
{
    static const char fragment[] = "meder/lighting.frag";
    const char *method = frame->options.method;
    gpu_draw_options options = {.name = "meder/lighting",
                                .vertex = render_shader("meder/lighting.vert"),
                                .fragment = render_shader(fragment),
                                .binding_count = MEDER_DRAW_BINDINGS,
                                .target_count = 1,
                                .targets = {GPU_RGBA32F},
                                .constant = render_closest(frame)};
    meder_draw_bindings(options.bindings);
    gpu_status status = GPU_OK;
    if (method && strcmp(method, "standard") != 0)
        status = render_shader_method(fragment, method, &options.fragment);
    if (status == GPU_OK)
        status = gpu_draw_create(frame->device, &options, &m->light);
    free((char *)options.fragment.source);
    return status;
}

static void destroy(void *state)
{
    meder *m = state;
    if (!m)
        return;
    gpu_image_destroy(m->downsampled);
    gpu_image_destroy(m->labels);
    gpu_buffer_destroy(m->boxes);
    gpu_buffer_destroy(m->counts);
    gpu_buffer_destroy(m->quads);
    gpu_buffer_destroy(m->indirect);
    gpu_buffer_destroy(m->indices);
    gpu_compute_destroy(m->downsample);
    gpu_compute_destroy(m->segment);
    gpu_compute_destroy(m->box);
    gpu_compute_destroy(m->list);
    gpu_draw_destroy(m->light);
    free(m);
}

static gpu_status create(render_frame *frame, void **state)
{
    static const gpu_needs needs = {.group_invocations = MEDER_TILE * MEDER_TILE,
                                    .shared_bytes = 6 * MEDER_TILE * MEDER_TILE * 4 + 64 * 4,
                                    .image_side = MEDER_SIDE,
                                    .buffer_bytes = MEDER_MOST_SEGMENTS * sizeof(meder_box)};
    *state = NULL;
    gpu_status status = gpu_check(frame->device, &needs);
    if (status != GPU_OK)
        return status;
    meder *m = calloc(1, sizeof *m);
    if (!m)
        return gpu_fail(GPU_OUT_OF_MEMORY, "meder: out of host memory");
    m->threshold = 0.02F;
    status = create_resources(frame->device, m);
    if (status == GPU_OK)
        status = create_segmentation(frame, m);
    if (status == GPU_OK)
        status = create_light(frame, m);
    if (status != GPU_OK) {
        destroy(m);
        return status;
    }
    *state = m;
    return GPU_OK;
}

void meder_steps(render_frame *frame, meder *m, gpu_step steps[MEDER_STEPS])
{
    steps[MEDER_DOWNSAMPLE] = (gpu_step){.name = "downsampling",
                                         .compute = m->downsample,
                                         .resources = {frame->view, frame->depth, m->downsampled},
                                         .groups = {MEDER_SIDE / 16, MEDER_SIDE / 8}};
    steps[MEDER_SEGMENT] = (gpu_step){.name = "segmentation",
                                      .compute = m->segment,
                                      .resources = {frame->view, m->downsampled, m->labels},
                                      .groups = {MEDER_TILES, MEDER_TILES},
                                      .push = &m->threshold};
    steps[MEDER_BOXES] =
        (gpu_step){.name = "bounding_boxes",
                   .compute = m->box,
                   .resources = {frame->view, m->downsampled, m->labels, m->boxes, m->counts},
                   .groups = {MEDER_TILES, MEDER_TILES}};
    steps[MEDER_QUADS] =
        (gpu_step){.name = "quads",
                   .compute = m->list,
                   .resources = {frame->view, frame->counters, m->counts, m->quads, m->indirect},
                   .groups = {MEDER_TILES * MEDER_TILES}};
    steps[MEDER_LIGHT] = (gpu_step){.name = "lighting",
                                    .draw = m->light,
                                    .indices = m->indices,
                                    .indirect = m->indirect,
                                    .targets = {frame->light}};
    meder_draw_resources(frame, m, steps[MEDER_LIGHT].resources);
}

static gpu_status run(render_frame *frame, void *state, render_statistics *statistics)
{
    gpu_step steps[MEDER_STEPS];
    meder_steps(frame, state, steps);
    return render_run(frame, steps, MEDER_STEPS, statistics);
}

const render_pipeline meder_pipeline = {.id = "meder",
                                        .title =
                                            "Screen Space Approximate Gaussian Hulls as printed",
                                        .create = create,
                                        .run = run,
                                        .dump = meder_dump,
                                        .destroy = destroy,
                                        .profile = meder_profile};
