/* Lists of steps: checked, bound, recorded into one command buffer, timed. */
#include "internal.h"

#include <stdlib.h>
#include <time.h>

static const char *name_of(const gpu_step *step)
{
    return step->name ? step->name : "a step";
}

static gpu_status check_target(const gpu_step *step, const gpu_image *target, gpu_format format,
                               const char *what, uint32_t size[2])
{
    if (!target)
        return gpu_fail(GPU_FAILED, "%s: %s is missing", name_of(step), what);
    if (target->format != format)
        return gpu_fail(GPU_FAILED, "%s: %s is not of the pipeline's format", name_of(step), what);
    if (size[0] && (target->width != size[0] || target->height != size[1]))
        return gpu_fail(GPU_FAILED, "%s: %s is %u x %u, another target %u x %u", name_of(step),
                        what, target->width, target->height, size[0], size[1]);
    size[0] = target->width;
    size[1] = target->height;
    return GPU_OK;
}

static gpu_status check_draw(const gpu_step *step)
{
    static const char *const names[GPU_MAX_TARGETS] = {"target 0", "target 1", "target 2",
                                                       "target 3"};
    uint32_t size[2] = {0, 0};
    gpu_status status = GPU_OK;
    for (int i = 0; i < step->draw->target_count && status == GPU_OK; i++)
        status = check_target(step, step->targets[i], step->draw->targets[i], names[i], size);
    if (status == GPU_OK && step->draw->depth)
        status = check_target(step, step->depth, GPU_DEPTH32, "the depth target", size);
    return status;
}

static gpu_status check_groups(const gpu_device *device, const gpu_step *step)
{
    for (int i = 0; i < 3; i++)
        if (step->groups[i] > device->limits.maxComputeWorkGroupCount[i])
            return gpu_fail(GPU_UNSUPPORTED, "%s: %u work groups along %c, %s allows %u",
                            name_of(step), step->groups[i], "xyz"[i], device -> info.name,
                            device->limits.maxComputeWorkGroupCount[i]);
    return GPU_OK;
}

static gpu_status check_step(const gpu_device *device, const gpu_step *step)
{
    int given = (step->compute != NULL) + (step->draw != NULL) + (step->clear != NULL) +
                (step->fill != NULL);
    if (given != 1)
        return gpu_fail(GPU_FAILED, "%s: expected one thing to do, got %d", name_of(step), given);
    const gpu_layout *layout = gpu_step_layout(step);
    if (!layout)
        return GPU_OK;
    if (layout->push_size && !step->push)
        return gpu_fail(GPU_FAILED, "%s: push constants are missing", name_of(step));
    size_t words = step->compute ? 3 : step->indices ? 5 : 4;
    if (step->indirect &&
        (step->indirect_offset % 4 || step->indirect_offset > step->indirect->size ||
         step->indirect->size - step->indirect_offset < words * sizeof(uint32_t)))
        return gpu_fail(GPU_FAILED, "%s: no %zu indirect words at byte %zu of %zu", name_of(step),
                        words, step->indirect_offset, step->indirect->size);
    if (step->draw && step->indices && !step->indirect &&
        step->vertex_count > step->indices->size / sizeof(uint32_t))
        return gpu_fail(GPU_FAILED, "%s: %u indices, the buffer has %zu", name_of(step),
                        step->vertex_count, step->indices->size / sizeof(uint32_t));
    return step->draw ? check_draw(step) : check_groups(device, step);
}

static gpu_status check_steps(const gpu_device *device, const gpu_step *steps, int count)
{
    if (device->info.compile_only)
        return gpu_fail(GPU_UNSUPPORTED, "%s only compiles", device->info.name);
    for (int i = 0; i < count; i++) {
        gpu_status status = check_step(device, &steps[i]);
        if (status != GPU_OK)
            return status;
    }
    return GPU_OK;
}

/* ---- Descriptor sets ----------------------------------------------------------------------------
 */

typedef struct run {
    gpu_device *device;
    const gpu_step *steps;
    VkDescriptorPool pool;
    VkDescriptorSet *sets;      /* one a step; unused where nothing is bound */
    const gpu_layout **layouts; /* of the steps that have one */
} run;

static gpu_status bind_steps(run *r, int count)
{
    size_t bound = 0;
    for (int i = 0; i < count; i++)
        if (gpu_step_layout(&r->steps[i]))
            r->layouts[bound++] = gpu_step_layout(&r->steps[i]);
    VkResult result = gpu_layout_pool(r->device, r->layouts, bound, &r->pool);
    for (int i = 0; i < count && result == VK_SUCCESS; i++) {
        const gpu_layout *layout = gpu_step_layout(&r->steps[i]);
        if (!layout)
            continue;
        VkDescriptorSetAllocateInfo info = {.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_SET_ALLOCATE_INFO,
                                            .descriptorPool = r->pool,
                                            .descriptorSetCount = 1,
                                            .pSetLayouts = &layout->set};
        result = vkAllocateDescriptorSets(r->device->device, &info, &r->sets[i]);
        if (result != VK_SUCCESS)
            break;
        gpu_status status = gpu_layout_write(r->device, layout, name_of(&r->steps[i]),
                                             r->steps[i].resources, r->sets[i]);
        if (status != GPU_OK)
            return status;
    }
    return result == VK_SUCCESS ? GPU_OK : gpu_vk(result, "binding the resources of steps");
}

/* ---- Running ------------------------------------------------------------------------------------
 */

static double now(void)
{
    struct timespec t;
    timespec_get(&t, TIME_UTC);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

/* Steps [first, end) in one submission. With timestamps: query i before step first + i, and one
 * after the last. A barrier stands on both sides of each timestamp, so that it neither moves into a
 * step nor waits for the next one. */
static gpu_status submit(const run *r, int first, int end, bool timestamps)
{
    VkCommandBuffer commands;
    gpu_status status = gpu_begin(r->device, &commands);
    if (status != GPU_OK)
        return status;
    if (timestamps)
        vkCmdResetQueryPool(commands, r->device->queries, 0, (uint32_t)(end - first + 1));
    for (int i = first; i <= end; i++) {
        gpu_record_barrier(commands);
        if (timestamps) {
            vkCmdWriteTimestamp(commands, VK_PIPELINE_STAGE_BOTTOM_OF_PIPE_BIT, r->device->queries,
                                (uint32_t)(i - first));
            gpu_record_barrier(commands);
        }
        if (i < end)
            gpu_record_step(commands, &r->steps[i], r->sets[i]);
    }
    return gpu_submit(r->device, commands);
}

static gpu_status run_timed(const run *r, int count, double *seconds)
{
    gpu_device *device = r->device;
    VkResult result = gpu_need_queries(device, (uint32_t)count + 1);
    if (result != VK_SUCCESS)
        return gpu_vk(result, "timestamps");
    gpu_status status = submit(r, 0, count, true);
    uint64_t *ticks = calloc((size_t)count + 1, sizeof *ticks);
    if (!ticks)
        return gpu_fail(GPU_OUT_OF_MEMORY, "timestamps: out of host memory");
    if (status == GPU_OK) {
        result = vkGetQueryPoolResults(device->device, device->queries, 0, (uint32_t)count + 1,
                                       ((size_t)count + 1) * sizeof *ticks, ticks, sizeof *ticks,
                                       VK_QUERY_RESULT_64_BIT | VK_QUERY_RESULT_WAIT_BIT);
        if (result != VK_SUCCESS)
            status = gpu_vk(result, "reading timestamps");
    }
    for (int i = 0; i < count && status == GPU_OK; i++)
        seconds[i] = (double)(ticks[i + 1] - ticks[i]) * device->info.timestamp_nanosecond * 1e-9;
    free(ticks);
    return status;
}

/* Without timestamps each step is a submission, and its time is taken around that. */
static gpu_status run_one_by_one(const run *r, int count, double *seconds)
{
    gpu_status status = GPU_OK;
    for (int i = 0; i < count && status == GPU_OK; i++) {
        double start = now();
        status = submit(r, i, i + 1, false);
        seconds[i] = now() - start;
    }
    return status;
}

gpu_status gpu_run(gpu_device *device, const gpu_step *steps, int count, double *seconds)
{
    gpu_status status = check_steps(device, steps, count);
    if (status != GPU_OK || count <= 0)
        return status;
    run r = {.device = device, .steps = steps};
    r.sets = calloc((size_t)count, sizeof *r.sets);
    r.layouts = calloc((size_t)count, sizeof *r.layouts);
    status = r.sets && r.layouts
                 ? bind_steps(&r, count)
                 : gpu_fail(GPU_OUT_OF_MEMORY, "a list of steps: out of host memory");
    if (status == GPU_OK)
        status = !seconds                  ? submit(&r, 0, count, false)
                 : device->info.timestamps ? run_timed(&r, count, seconds)
                                           : run_one_by_one(&r, count, seconds);
    vkDestroyDescriptorPool(device->device, r.pool, NULL);
    free(r.sets);
    free(r.layouts);
    return status;
}
