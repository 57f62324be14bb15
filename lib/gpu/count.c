/* What a function costs on hardware that need not be there. */
#include "internal.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

struct gpu_counter {
    gpu_device *device;
    gpu_statistics empty;
};

static const char head[] =
    "#version 450\n"
    "layout(local_size_x = 64) in;\n"
    "layout(std430, set = 0, binding = 0) readonly buffer count_in_one { vec2 count_p[]; };\n"
    "layout(std430, set = 0, binding = 0) readonly buffer count_in_eight { vec4 count_q[]; };\n"
    "layout(std430, set = 0, binding = 1) writeonly buffer count_out { float count_r[]; };\n"
    "#line 1\n";

const char gpu_empty_function[] =
    "float f(float lambda, float cos_theta) { return lambda + cos_theta; }\n";

/* The literal stands for any sharpness: what depends on lambda alone is folded away. */
static const char *const bodies[] = {
    "count_r[i] = f(count_p[i].x, count_p[i].y);",
    "vec4 a = count_q[4u * i], b = count_q[4u * i + 1u], c = count_q[4u * i + 2u],"
    " d = count_q[4u * i + 3u];"
    " count_r[i] = f(a.x, a.y) + f(a.z, a.w) + f(b.x, b.y) + f(b.z, b.w) + f(c.x, c.y)"
    " + f(c.z, c.w) + f(d.x, d.y) + f(d.z, d.w);",
    "count_r[i] = f(7.3890561, count_p[i].x + count_p[i].y);",
    "vec4 a = count_q[4u * i], b = count_q[4u * i + 1u], c = count_q[4u * i + 2u],"
    " d = count_q[4u * i + 3u]; const float k = 7.3890561;"
    " count_r[i] = f(k, a.x + a.y) + f(k, a.z + a.w) + f(k, b.x + b.y) + f(k, b.z + b.w)"
    " + f(k, c.x + c.y) + f(k, c.z + c.w) + f(k, d.x + d.y) + f(k, d.z + d.w);"};

char *gpu_wrap(gpu_wrapper wrapper, const char *source)
{
    size_t size = sizeof head + strlen(source) + strlen(bodies[wrapper]) + 100;
    char *text = malloc(size);
    if (text)
        snprintf(text, size, "%s%s\nvoid main() { uint i = gl_GlobalInvocationID.x; %s }\n", head,
                 source, bodies[wrapper]);
    return text;
}

static gpu_status measure(gpu_counter *counter, const char *name, const char *source,
                          gpu_wrapper wrapper, gpu_statistics *statistics)
{
    char *text = gpu_wrap(wrapper, source);
    if (!text)
        return gpu_fail(GPU_OUT_OF_MEMORY, "%s: out of host memory", name);
    gpu_compute_options options = {
        .name = name,
        .source = text,
        .binding_count = 4,
        .bindings = {GPU_STORAGE_BUFFER, GPU_STORAGE_BUFFER, GPU_SAMPLED, GPU_SAMPLED},
        .statistics = true};
    gpu_compute *compute;
    gpu_status status = gpu_compute_create(counter->device, &options, &compute);
    free(text);
    if (status != GPU_OK)
        return status;
    status = gpu_compute_statistics(compute, statistics);
    gpu_compute_destroy(compute);
    return status;
}

gpu_status gpu_counter_open(const char *family, gpu_counter **out)
{
    *out = NULL;
    gpu_counter *counter = calloc(1, sizeof *counter);
    if (!counter)
        return gpu_fail(GPU_OUT_OF_MEMORY, "opening Vulkan: out of host memory");
    gpu_device_options options = {.compile_for = family};
    gpu_status status = gpu_device_open(&options, &counter->device);
    if (status == GPU_OK)
        status = measure(counter, "empty", gpu_empty_function, GPU_ONE, &counter->empty);
    if (status != GPU_OK) {
        gpu_counter_close(counter);
        return status;
    }
    *out = counter;
    return GPU_OK;
}

void gpu_counter_close(gpu_counter *counter)
{
    if (!counter)
        return;
    gpu_device_close(counter->device);
    free(counter);
}

const gpu_device_info *gpu_counter_about(const gpu_counter *counter)
{
    return gpu_device_about(counter->device);
}

/* whole - part, then times scale; the registers stay those of the whole. */
static gpu_statistics difference(const gpu_statistics *whole, const gpu_statistics *part,
                                 double scale)
{
    gpu_statistics d = *whole;
    d.instructions = (whole->instructions - part->instructions) * scale;
    d.inverse_throughput = (whole->inverse_throughput - part->inverse_throughput) * scale;
    d.latency = (whole->latency - part->latency) * scale;
    d.code_size = (whole->code_size - part->code_size) * scale;
    d.branches = (whole->branches - part->branches) * scale;
    return d;
}

gpu_status gpu_count(gpu_counter *counter, const char *name, const char *source, gpu_cost *cost)
{
    gpu_statistics raw[4];
    for (gpu_wrapper wrapper = GPU_ONE; wrapper <= GPU_PIXEL_EIGHT; wrapper++) {
        gpu_status status = measure(counter, name, source, wrapper, &raw[wrapper]);
        if (status != GPU_OK)
            return status;
    }
    gpu_cost result = {.one = difference(&raw[GPU_ONE], &counter->empty, 1),
                       .slope = difference(&raw[GPU_EIGHT], &raw[GPU_ONE], 1.0 / 7.0),
                       .pixel = difference(&raw[GPU_PIXEL_ONE], &counter->empty, 1),
                       .pixel_slope =
                           difference(&raw[GPU_PIXEL_EIGHT], &raw[GPU_PIXEL_ONE], 1.0 / 7.0)};
    /* The addition of the empty wrapper is gone where f stands alone. */
    result.one.instructions += 1;
    *cost = result;
    return GPU_OK;
}
