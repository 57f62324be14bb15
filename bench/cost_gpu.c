/* cost_gpu.c: instructions, as Mesa's RADV compiles a method's own shader text for hardware that is
 * not there. Deterministic: the same Mesa gives the same numbers. */
#include "cost.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "base/text.h"

const char *const cost_families[COST_FAMILIES] = {"navi21", "gfx1100", "vega10"};

#define UNKNOWN ((double)NAN)
const cost_count cost_unknown = {UNKNOWN, UNKNOWN, UNKNOWN, UNKNOWN, UNKNOWN, UNKNOWN, UNKNOWN};

#ifdef HAVE_VULKAN

#include "gpu.h"

struct cost_counter {
    gpu_counter *gpu;
    char driver[600];
};

cost_counter *cost_counter_open(const char *family, char reason[256])
{
    cost_counter *counter = calloc(1, sizeof *counter);
    if (!counter) {
        snprintf(reason, 256, "out of memory");
        return NULL;
    }
    if (gpu_counter_open(family, &counter->gpu) != GPU_OK) {
        snprintf(reason, 256, "%s", gpu_last_error());
        free(counter);
        return NULL;
    }
    const gpu_device_info *info = gpu_counter_about(counter->gpu);
    snprintf(counter->driver, sizeof counter->driver, "%s %s", info->driver, info->version);
    return counter;
}

void cost_counter_close(cost_counter *counter)
{
    if (!counter)
        return;
    gpu_counter_close(counter->gpu);
    free(counter);
}

const char *cost_counter_driver(const cost_counter *counter)
{
    return counter->driver;
}

bool cost_counter_run(cost_counter *counter, const char *name, const char *glsl, cost_count *count)
{
    gpu_cost cost;
    if (gpu_count(counter->gpu, name, glsl, &cost) != GPU_OK) {
        base_error("%s", gpu_last_error());
        return false;
    }
    *count = (cost_count){.instructions = cost.one.instructions,
                          .inverse_throughput = cost.one.inverse_throughput,
                          .slope = cost.slope.inverse_throughput,
                          .slope_instructions = cost.slope.instructions,
                          .vgprs = cost.one.vgprs,
                          .pixel_instructions = cost.pixel.instructions,
                          .pixel_slope = cost.pixel_slope.inverse_throughput};
    return true;
}

#else

cost_counter *cost_counter_open(const char *family, char reason[256])
{
    snprintf(reason, 256, "%s: built without Vulkan and shaderc", family);
    return NULL;
}

void cost_counter_close(cost_counter *counter)
{
    (void)counter;
}

const char *cost_counter_driver(const cost_counter *counter)
{
    (void)counter;
    return "";
}

bool cost_counter_run(cost_counter *counter, const char *name, const char *glsl, cost_count *count)
{
    (void)counter;
    (void)glsl;
    *count = cost_unknown;
    base_error("%s: built without Vulkan and shaderc", name);
    return false;
}

#endif
