/* Ground truth, with and without the horizon clip, and the least that any pass over the pixels
 * costs. */
#include "internal.h"

#include <stdlib.h>

#include "base/buffer.h"

/* Pairs of a pixel and a light in a dispatch: of the order of a second on a software device. */
static const double strip_pairs = 3e7;

static gpu_status create(render_frame *frame, const char *path, void **state)
{
    static const gpu_binding bindings[] = {GPU_STORAGE_BUFFER, GPU_STORAGE_BUFFER,
                                           GPU_STORAGE_BUFFER, GPU_FETCHED,
                                           GPU_FETCHED,        GPU_STORAGE_IMAGE};
    gpu_compute *compute;
    gpu_status status = render_compute(frame, path, false, bindings, 6, sizeof(uint32_t), &compute);
    *state = compute;
    return status;
}

static gpu_status create_exact(render_frame *frame, void **state)
{
    return create(frame, "exact/exact.comp", state);
}

static gpu_status create_unclipped(render_frame *frame, void **state)
{
    return create(frame, "exact/exact_unclipped.comp", state);
}

static gpu_status run_exact(render_frame *frame, void *state, render_statistics *statistics)
{
    enum { GROUP_WIDTH = 16, GROUP_HEIGHT = 16 };
    double row_pairs = (double)frame->width * (frame->light_count ? frame->light_count : 1);
    double fit = strip_pairs / row_pairs / GROUP_HEIGHT;
    uint32_t group_rows = (frame->height + GROUP_HEIGHT - 1) / GROUP_HEIGHT;
    uint32_t strip = fit < 1 ? 1 : fit < group_rows ? (uint32_t)fit : group_rows;
    uint32_t count = (group_rows + strip - 1) / strip;
    gpu_step *steps = base_allocate(count * sizeof *steps);
    uint32_t *first_rows = base_allocate(count * sizeof *first_rows);
    for (uint32_t i = 0; i < count; i++) {
        first_rows[i] = i * strip * GROUP_HEIGHT;
        uint32_t left = group_rows - i * strip;
        steps[i] = (gpu_step){.name = "exact",
                              .compute = state,
                              .resources = {frame->view, frame->lights, frame->counters,
                                            frame->position, frame->normal, frame->light},
                              .push = &first_rows[i],
                              .groups = {(frame->width + GROUP_WIDTH - 1) / GROUP_WIDTH,
                                         left < strip ? left : strip, 1}};
    }
    gpu_status status = render_run(frame, steps, (int)count, statistics);
    free(steps);
    free(first_rows);
    return status;
}

static gpu_status create_limit(render_frame *frame, void **state)
{
    static const gpu_binding bindings[] = {GPU_STORAGE_BUFFER, GPU_FETCHED, GPU_FETCHED,
                                           GPU_STORAGE_IMAGE};
    gpu_compute *compute;
    gpu_status status = render_compute(frame, "limit/limit.comp", false, bindings, 4, 0, &compute);
    *state = compute;
    return status;
}

static gpu_status run_limit(render_frame *frame, void *state, render_statistics *statistics)
{
    gpu_step step = {.name = "limit",
                     .compute = state,
                     .resources = {frame->view, frame->position, frame->normal, frame->light},
                     .groups = {(frame->width + 15) / 16, (frame->height + 7) / 8, 1}};
    return render_run(frame, &step, 1, statistics);
}

static void destroy(void *state)
{
    gpu_compute_destroy(state);
}

#define PIPELINE(NAME, TITLE, CREATE, RUN)                                                         \
    const render_pipeline NAME##_pipeline = {                                                      \
        .id = #NAME, .title = TITLE, .create = CREATE, .run = RUN, .destroy = destroy}

PIPELINE(exact, "ground truth: every light at every pixel, clipped to the horizon", create_exact,
         run_exact);
PIPELINE(exact_unclipped, "every light at every pixel, not clipped to the horizon",
         create_unclipped, run_exact);
PIPELINE(limit, "reads the G-buffer and writes the light buffer, without lighting", create_limit,
         run_limit);
