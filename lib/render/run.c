/* Running lists of steps several times, reading what the shaders counted, and the last pass of
 * every pipeline. */
#include "internal.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/order.h"
#include "base/progress.h"

enum { COUNTERS = 13 }; /* as shaders/common/counters.glsl numbers them */

void statistics_add_time(render_statistics *statistics, const char *name, double ms)
{
    int i = 0;
    while (i < statistics->time_count && strcmp(statistics->times[i].name, name) != 0)
        i++;
    if (i == RENDER_MOST_TIMES)
        return;
    if (i == statistics->time_count) {
        statistics->times[i].name = name;
        statistics->times[i].ms = 0;
        statistics->time_count++;
    }
    statistics->times[i].ms += ms;
}

static void add_counters(const render_frame *frame, render_statistics *statistics)
{
    uint64_t *fields[COUNTERS] = {
        &statistics->light_evaluations, &statistics->pixels_covered, &statistics->pixels_uncovered,
        &statistics->pixels_wrong,      &statistics->quads,          &statistics->vertices,
        &statistics->visibility_rays,   &statistics->samples,
    };
    for (int i = 0; i < RENDER_LEVELS; i++)
        fields[COUNTERS - RENDER_LEVELS + i] = &statistics->fragments_by_level[i];
    const uint32_t *halves = gpu_buffer_map(frame->counters);
    for (int i = 0; i < COUNTERS; i++)
        *fields[i] += halves[2 * i] | (uint64_t)halves[2 * i + 1] << 32;
}

/* Length of the piece of the list that is submitted next: steps of one name are parts of something
 * long and go one by one, so that progress can be shown. */
static int piece(const gpu_step *steps, int count)
{
    int length = 1;
    if (count > 1 && strcmp(steps[0].name, steps[1].name) == 0)
        return 1;
    while (length < count && strcmp(steps[length - 1].name, steps[length].name) != 0 &&
           (length + 1 == count || strcmp(steps[length].name, steps[length + 1].name) != 0))
        length++;
    return length;
}

/* times[step]: seconds; of a later step of the same name they count to the first one. */
static gpu_status run_once(render_frame *frame, const gpu_step *steps, int count, double *times,
                           base_progress *progress)
{
    memset(gpu_buffer_map(frame->counters), 0, gpu_buffer_size(frame->counters));
    for (int at = 0; at < count;) {
        int length = piece(steps + at, count - at);
        gpu_status status = gpu_run(frame->device, steps + at, length, times + at);
        if (status != GPU_OK)
            return status;
        at += length;
        for (int i = 0; i < length; i++)
            base_progress_step(progress, NULL);
    }
    for (int i = 0; i < count; i++)
        for (int j = 0; j < i; j++)
            if (strcmp(steps[i].name, steps[j].name) == 0) {
                times[j] += times[i];
                times[i] = -1;
                break;
            }
    return GPU_OK;
}

gpu_status render_run(render_frame *frame, const gpu_step *steps, int count,
                      render_statistics *statistics)
{
    int runs = frame->options.runs > 0 ? frame->options.runs : 1;
    int warm = runs > 1; /* drivers compile shaders when these run for the first time */
    size_t stride = (size_t)count;
    double *times = calloc((size_t)runs * stride + (size_t)runs, sizeof *times);
    if (!times)
        return gpu_fail(GPU_OUT_OF_MEMORY, "running passes: out of host memory");
    double *column = times + (size_t)runs * stride;
    base_progress *progress = base_progress_begin("rendering", (size_t)(runs + warm) * stride);
    gpu_status status = GPU_OK;
    for (int run = -warm; status == GPU_OK && run < runs; run++)
        status =
            run_once(frame, steps, count, times + (size_t)(run < 0 ? 0 : run) * stride, progress);
    base_progress_end(progress);
    for (int i = 0; status == GPU_OK && i < count; i++) {
        if (times[i] < 0)
            continue;
        for (int run = 0; run < runs; run++)
            column[run] = times[(size_t)run * stride + (size_t)i];
        statistics_add_time(statistics, steps[i].name, 1e3 * base_median(column, (size_t)runs));
    }
    if (status == GPU_OK)
        add_counters(frame, statistics);
    free(times);
    return status;
}

gpu_status render_compute(render_frame *frame, const char *path, bool method,
                          const gpu_binding *bindings, int binding_count, uint32_t push_size,
                          gpu_compute **compute)
{
    *compute = NULL;
    gpu_shader shader = render_shader(path);
    bool other = method && frame->options.method && strcmp(frame->options.method, "standard") != 0;
    if (other) {
        gpu_status status = render_shader_method(path, frame->options.method, &shader);
        if (status != GPU_OK)
            return status;
    } else if (!shader.words) {
        return gpu_fail(GPU_BAD_SHADER, "%s: there is no such shader", path);
    }
    gpu_compute_options options = {.name = path,
                                   .source = shader.source,
                                   .words = shader.words,
                                   .word_count = shader.word_count,
                                   .binding_count = binding_count,
                                   .push_size = push_size,
                                   .constant = render_closest(frame)};
    memcpy(options.bindings, bindings, (size_t)binding_count * sizeof *bindings);
    gpu_status status = gpu_compute_create(frame->device, &options, compute);
    free((char *)shader.source);
    return status;
}

/* ---- The last pass ------------------------------------------------------------------- */

gpu_status resolve_create(render_frame *frame)
{
    static const gpu_binding resolve[] = {GPU_STORAGE_BUFFER, GPU_FETCHED, GPU_FETCHED,
                                          GPU_STORAGE_IMAGE};
    static const gpu_binding count[] = {GPU_STORAGE_BUFFER, GPU_STORAGE_BUFFER, GPU_FETCHED,
                                        GPU_STORAGE_IMAGE};
    gpu_status status =
        render_compute(frame, "resolve/resolve.comp", false, resolve, 4, 0, &frame->resolve);
    if (status == GPU_OK)
        status = render_compute(frame, "resolve/count.comp", false, count, 4, 0, &frame->count);
    return status;
}

gpu_status resolve_run(render_frame *frame, render_statistics *statistics)
{
    uint32_t across = (frame->width + 15) / 16, down = (frame->height + 7) / 8;
    gpu_step resolve = {.name = "resolve",
                        .compute = frame->resolve,
                        .resources = {frame->view, frame->albedo, frame->light, frame->image},
                        .groups = {across, down, 1}};
    gpu_step count = {.name = "count",
                      .compute = frame->count,
                      .resources = {frame->view, frame->counters, frame->position, frame->light},
                      .groups = {across, down, 1}};
    gpu_status status = render_run(frame, &resolve, 1, statistics);
    /* counting belongs to measuring, not to the frame: its time is left out */
    memset(gpu_buffer_map(frame->counters), 0, gpu_buffer_size(frame->counters));
    if (status == GPU_OK)
        status = gpu_run(frame->device, &count, 1, NULL);
    if (status == GPU_OK)
        add_counters(frame, statistics);
    return status;
}
