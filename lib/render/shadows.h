/* shadows.h: what the pipelines of area lights with shadows share: the lights and their fixed
 * points, the tree of boxes, the bindings of shaders/shadows/area.glsl. */
#ifndef RENDER_SHADOWS_H
#define RENDER_SHADOWS_H

#include "render.h"
#include "trace.h"

enum {
    SHADOWS_POINTS = 64, /* on each light */
    SHADOWS_BINDINGS = 9 /* those of area.glsl; a pass' own follow */
};

typedef struct shadows {
    render_tracer tracer;
    gpu_buffer *triangles, *areas, *points;
    uint32_t light_count; /* those without area are left out */
} shadows;

/* One clear line where the scene has no area light, or there is no Embree. */
gpu_status shadows_create(render_frame *frame, shadows *shadows);
/* The same for a scene that may have none. */
gpu_status shadows_create_any(render_frame *frame, shadows *shadows);
void shadows_destroy(shadows *shadows);

/* A pass with the bindings of area.glsl and count more after them. */
gpu_status shadows_compute(render_frame *frame, const char *path, const gpu_binding *own, int count,
                           uint32_t push_size, gpu_compute **compute);
/* Fills the resources of those bindings. */
void shadows_bind(const render_frame *frame, const shadows *shadows, gpu_step *step);

/* render_run; GPU_FAILED where a ray was not followed to its end. */
gpu_status shadows_run(render_frame *frame, const gpu_step *steps, int count,
                       render_statistics *statistics);

/* The points of a light in the order of the set: 64 of equal area, of which the first 16, and each
 * 16 that follow, cover it evenly too. Moved by `lift` along its normal. */
void shadows_points(const render_area_light *light, double lift, float points[SHADOWS_POINTS][4]);

/* The point of a light for one of the unit square, equal areas to equal areas. */
void shadows_point(const render_area_light *light, double x, double y, double point[3]);

/* The corners' mean normal times the area. */
void shadows_normal(const render_area_light *light, double normal[3]);

extern const render_pipeline shadows_pipeline, shadows2_pipeline, shadows4_pipeline;

#endif
