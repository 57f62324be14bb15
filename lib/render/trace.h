/* trace.h: a scene's tree of boxes on the device, for shaders that include trace/trace.glsl. */
#ifndef RENDER_TRACE_H
#define RENDER_TRACE_H

#include "bvh.h"

typedef struct render_tracer {
    gpu_buffer *nodes, *triangles;
    uint32_t root; /* for trace_scene */
    size_t triangle_count;
} render_tracer;

/* GPU_UNSUPPORTED without Embree, or where the triangles need a buffer above 128 MiB. */
gpu_status render_tracer_create(gpu_device *device, const render_scene *scene,
                                render_tracer *tracer);
void render_tracer_destroy(render_tracer *tracer);

#endif
