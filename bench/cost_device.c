/* cost_device.c: time on the Vulkan device at hand, as a ratio to the empty wrapper. */
#include "cost.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/text.h"

#ifdef HAVE_VULKAN

#include "gpu.h"

enum { EVALUATIONS = 8, INVOCATIONS = 1 << 15, GROUP = 64, RUNS_PER_SAMPLE = 4 };

struct cost_device {
    gpu_device *gpu;
    gpu_buffer *in, *out;
    gpu_texture *blank; /* stands where a subject has no texture */
    gpu_compute *empty;
    char driver[600];
};

static bool create(cost_device *device, const char *name, const char *glsl, gpu_wrapper wrapper,
                   gpu_compute **compute)
{
    char *text = gpu_wrap(wrapper, glsl);
    if (!text)
        return false;
    gpu_compute_options options = {
        .name = name,
        .source = text,
        .binding_count = 4,
        .bindings = {GPU_STORAGE_BUFFER, GPU_STORAGE_BUFFER, GPU_SAMPLED, GPU_SAMPLED}};
    gpu_status status = gpu_compute_create(device->gpu, &options, compute);
    free(text);
    return status == GPU_OK;
}

static bool prepare(cost_device *device, const char *name, const cost_points *points)
{
    static const float one = 1;
    if (gpu_device_open(&(gpu_device_options){.device = name}, &device->gpu) != GPU_OK)
        return false;
    const gpu_device_info *info = gpu_device_about(device->gpu);
    snprintf(device->driver, sizeof device->driver, "%s %s", info->driver, info->version);
    const size_t pairs = (size_t)INVOCATIONS * EVALUATIONS;
    if (gpu_buffer_create(device->gpu, pairs * 2 * sizeof(float), &device->in) != GPU_OK ||
        gpu_buffer_create(device->gpu, INVOCATIONS * sizeof(float), &device->out) != GPU_OK ||
        gpu_texture_create(device->gpu, &(gpu_texture_options){1, 1, 1, false, &one},
                           &device->blank) != GPU_OK)
        return false;
    float *in = gpu_buffer_map(device->in);
    for (size_t i = 0; i < pairs; i++) {
        in[2 * i] = points->lambda_f32[i % COST_POINTS];
        in[2 * i + 1] = points->cos_theta_f32[i % COST_POINTS];
    }
    return create(device, "empty", gpu_empty_function, GPU_EIGHT, &device->empty);
}

cost_device *cost_device_open(const char *name, const cost_points *points, char reason[256])
{
    cost_device *device = calloc(1, sizeof *device);
    if (!device) {
        snprintf(reason, 256, "out of memory");
        return NULL;
    }
    if (prepare(device, name, points))
        return device;
    snprintf(reason, 256, "%s", gpu_last_error());
    cost_device_close(device);
    return NULL;
}

void cost_device_close(cost_device *device)
{
    if (!device)
        return;
    gpu_compute_destroy(device->empty);
    gpu_texture_destroy(device->blank);
    gpu_buffer_destroy(device->in);
    gpu_buffer_destroy(device->out);
    gpu_device_close(device->gpu);
    free(device);
}

const char *cost_device_name(const cost_device *device)
{
    return gpu_device_about(device->gpu)->name;
}

const char *cost_device_driver(const cost_device *device)
{
    return device->driver;
}

static bool run(cost_device *device, gpu_compute *compute, gpu_texture *texture, double *seconds)
{
    gpu_dispatch dispatch = {.compute = compute,
                             .resources = {device->in, device->out, texture, texture},
                             .groups = {INVOCATIONS / GROUP},
                             .seconds = seconds};
    return gpu_dispatch_run(device->gpu, &dispatch) == GPU_OK;
}

/* The fastest of each: whatever else runs on the machine only ever adds. The two run in turn, so
 * that both meet the same clock; the first pair warms up and is not counted. */
static bool compare(cost_device *device, gpu_compute *compute, gpu_texture *texture, int samples,
                    double *ratio)
{
    double best_with = (double)INFINITY, best_without = (double)INFINITY;
    for (int i = -1; i < RUNS_PER_SAMPLE * samples; i++) {
        double with, without;
        if (!run(device, device->empty, device->blank, &without) ||
            !run(device, compute, texture, &with))
            return false;
        if (i >= 0) {
            best_with = fmin(best_with, with);
            best_without = fmin(best_without, without);
        }
    }
    *ratio = best_with / best_without;
    return true;
}

/* The subject's shader and its texture, or the blank one. */
static bool load(cost_device *device, const cost_subject *subject, gpu_wrapper wrapper,
                 gpu_compute **compute, gpu_texture **texture)
{
    const cost_texture *from = &subject->texture;
    gpu_texture_options options = {from->width, from->height, from->channels, from->half,
                                   from->texels};
    *texture = NULL;
    return create(device, subject->id, subject->glsl, wrapper, compute) &&
           (!from->texels || gpu_texture_create(device->gpu, &options, texture) == GPU_OK);
}

bool cost_device_run(cost_device *device, const cost_subject *subject, int samples, double *ratio)
{
    gpu_compute *compute = NULL;
    gpu_texture *texture = NULL;
    bool good = load(device, subject, GPU_EIGHT, &compute, &texture) &&
                compare(device, compute, texture ? texture : device->blank, samples, ratio);
    if (!good)
        base_error("%s", gpu_last_error());
    gpu_texture_destroy(texture);
    gpu_compute_destroy(compute);
    return good;
}

bool cost_device_values(cost_device *device, const cost_subject *subject, size_t n,
                        const float *pairs, float *values)
{
    gpu_compute *compute = NULL;
    gpu_texture *texture = NULL;
    gpu_buffer *in = NULL, *out = NULL;
    size_t groups = (n + GROUP - 1) / GROUP, capacity = groups * GROUP * sizeof(float);
    bool good = load(device, subject, GPU_ONE, &compute, &texture) &&
                gpu_buffer_create(device->gpu, 2 * capacity, &in) == GPU_OK &&
                gpu_buffer_create(device->gpu, capacity, &out) == GPU_OK;
    if (good) {
        gpu_texture *bound = texture ? texture : device->blank;
        memcpy(gpu_buffer_map(in), pairs, 2 * n * sizeof *pairs);
        gpu_dispatch dispatch = {
            .compute = compute, .resources = {in, out, bound, bound}, .groups = {(uint32_t)groups}};
        good = gpu_dispatch_run(device->gpu, &dispatch) == GPU_OK;
    }
    if (good)
        memcpy(values, gpu_buffer_map(out), n * sizeof *values);
    else
        base_error("%s", gpu_last_error());
    gpu_buffer_destroy(in);
    gpu_buffer_destroy(out);
    gpu_texture_destroy(texture);
    gpu_compute_destroy(compute);
    return good;
}

#else

cost_device *cost_device_open(const char *name, const cost_points *points, char reason[256])
{
    (void)points;
    snprintf(reason, 256, "%s: built without Vulkan and shaderc", name);
    return NULL;
}

void cost_device_close(cost_device *device)
{
    (void)device;
}

const char *cost_device_name(const cost_device *device)
{
    (void)device;
    return "";
}

const char *cost_device_driver(const cost_device *device)
{
    (void)device;
    return "";
}

bool cost_device_values(cost_device *device, const cost_subject *subject, size_t n,
                        const float *pairs, float *values)
{
    (void)device;
    (void)n;
    (void)pairs;
    (void)values;
    base_error("%s: built without Vulkan and shaderc", subject->id);
    return false;
}

bool cost_device_run(cost_device *device, const cost_subject *subject, int samples, double *ratio)
{
    (void)device;
    (void)samples;
    *ratio = (double)NAN;
    base_error("%s: built without Vulkan and shaderc", subject->id);
    return false;
}

#endif
