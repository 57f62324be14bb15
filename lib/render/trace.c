/* The tree of boxes on the device. */
#include "trace.h"

#include <string.h>

static const size_t most_bytes = (size_t)128 << 20; /* that every device offers */

static gpu_status upload(gpu_device *device, const void *from, size_t size, gpu_buffer **buffer)
{
    if (size > most_bytes)
        return gpu_fail(GPU_UNSUPPORTED, "shadows: the triangles need %zu MiB, more than 128",
                        size >> 20);
    gpu_status status = gpu_buffer_create(device, size ? size : 16, buffer);
    if (status == GPU_OK && size)
        memcpy(gpu_buffer_map(*buffer), from, size);
    return status;
}

gpu_status render_tracer_create(gpu_device *device, const render_scene *scene,
                                render_tracer *tracer)
{
    *tracer = (render_tracer){0};
    render_bvh bvh;
    gpu_status status = render_bvh_build(scene, &bvh);
    if (status == GPU_OK)
        status = upload(device, bvh.nodes, 32 * bvh.node_count, &tracer->nodes);
    if (status == GPU_OK)
        status = upload(device, bvh.triangles, 48 * bvh.triangle_count, &tracer->triangles);
    tracer->root = bvh.root;
    tracer->triangle_count = bvh.triangle_count;
    render_bvh_free(&bvh);
    if (status != GPU_OK)
        render_tracer_destroy(tracer);
    return status;
}

void render_tracer_destroy(render_tracer *tracer)
{
    gpu_buffer_destroy(tracer->nodes);
    gpu_buffer_destroy(tracer->triangles);
    *tracer = (render_tracer){0};
}
