/* What the compiler of a driver says about a pipeline, and the cost of one function from that. */
#include "internal.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static double value_of(const VkPipelineExecutableStatisticKHR *statistic)
{
    switch (statistic->format) {
    case VK_PIPELINE_EXECUTABLE_STATISTIC_FORMAT_BOOL32_KHR:
        return statistic->value.b32 ? 1 : 0;
    case VK_PIPELINE_EXECUTABLE_STATISTIC_FORMAT_INT64_KHR:
        return (double)statistic->value.i64;
    case VK_PIPELINE_EXECUTABLE_STATISTIC_FORMAT_UINT64_KHR:
        return (double)statistic->value.u64;
    case VK_PIPELINE_EXECUTABLE_STATISTIC_FORMAT_FLOAT64_KHR:
        return statistic->value.f64;
    default:
        return (double)NAN;
    }
}

static double find(const VkPipelineExecutableStatisticKHR *statistics, uint32_t count,
                   const char *name)
{
    for (uint32_t i = 0; i < count; i++)
        if (strcmp(statistics[i].name, name) == 0)
            return value_of(&statistics[i]);
    return (double)NAN;
}

gpu_status gpu_compute_statistics(const gpu_compute *compute, gpu_statistics *out)
{
    const gpu_device *device = compute->owner;
    if (!device->get_statistics)
        return gpu_fail(GPU_UNSUPPORTED, "%s reports no pipeline statistics", device->info.name);
    VkPipelineExecutableInfoKHR info = {.sType = VK_STRUCTURE_TYPE_PIPELINE_EXECUTABLE_INFO_KHR,
                                        .pipeline = compute->pipeline};
    VkPipelineExecutableStatisticKHR statistics[64];
    for (int i = 0; i < 64; i++)
        statistics[i] = (VkPipelineExecutableStatisticKHR){
            .sType = VK_STRUCTURE_TYPE_PIPELINE_EXECUTABLE_STATISTIC_KHR};
    uint32_t count = 64;
    VkResult result = device->get_statistics(device->device, &info, &count, statistics);
    if (result != VK_SUCCESS && result != VK_INCOMPLETE)
        return gpu_vk(result, "reading pipeline statistics");
    *out = (gpu_statistics){.instructions = find(statistics, count, "Instructions"),
                            .inverse_throughput = find(statistics, count, "Inverse Throughput"),
                            .latency = find(statistics, count, "Latency"),
                            .vgprs = find(statistics, count, "VGPRs"),
                            .sgprs = find(statistics, count, "SGPRs"),
                            .code_size = find(statistics, count, "Code size"),
                            .branches = find(statistics, count, "Branches")};
    return GPU_OK;
}
