/* internal.h: what the files of lib/render's core share. */
#ifndef RENDER_INTERNAL_H
#define RENDER_INTERNAL_H

#include "render.h"

/* struct View of shaders/common/frame.glsl; matrices column by column. */
typedef struct view_data {
    float clip_from_world[16], world_from_clip[16];
    float eye[4], right[4], up[4], forward[4], range[4];
    uint32_t size[4];
} view_data;

/* struct Light of shaders/common/lights.glsl. */
typedef struct light_data {
    float a[4], b[4], c[4], plane[4];
} light_data;

/* view.c */
void view_fill(const render_camera *camera, uint32_t width, uint32_t height, view_data *view);

/* gbuffer.c: the scene's triangles on the device, and drawing them. */
typedef struct geometry {
    gpu_device *device;
    gpu_buffer *positions, *normals, *indices, *materials, *albedos, *faces;
    gpu_draw *draw;
    uint32_t corner_count;
} geometry;

/* position, normal and albedo as in render_frame, with a depth of the same size */
typedef struct gbuffer {
    gpu_image *position, *normal, *albedo, *depth;
} gbuffer;

gpu_status gbuffer_create(gpu_device *device, uint32_t width, uint32_t height, gbuffer *images);
void gbuffer_destroy(gbuffer *images);
gpu_status geometry_create(gpu_device *device, const render_scene *scene, geometry *geometry);
void geometry_destroy(geometry *geometry);
/* ms: the median time of that many runs, as by render_run */
gpu_status geometry_draw(const geometry *geometry, gpu_buffer *view, const gbuffer *images,
                         bool detailed, int runs, double *ms);

/* lights.c: fills frame->lights and light_count; ms as above, of drawing the shadow map. */
gpu_status lights_create(render_frame *frame, const geometry *geometry, double *ms);

/* lights.c: light_closest of shaders/common/lights.glsl, for the `constant` of shaders: 2 mm, which
 * the shaders have and 0 stands for, or as much of the scene's longest side in metres where that is
 * below 1 m. A frame without a scene, as tests of one pass have it, has the shaders' own. */
float render_closest(const render_frame *frame);

/* profile.c: runs a draw into one RGBA32F target, its push constant an int32_t, 0 to layers - 1,
 * and collects the points for render_pipeline.profile: texels with w != 0 and a weight (z) above 0.
 */
gpu_status profile_draw(render_frame *frame, gpu_step step, int32_t layers, float **points,
                        size_t *count);

/* tone.c: frame->gain. */
gpu_status tone_measure(render_frame *frame);

/* run.c */
void statistics_add_time(render_statistics *statistics, const char *name, double ms);
gpu_status resolve_create(render_frame *frame);
gpu_status resolve_run(render_frame *frame, render_statistics *statistics);

/* n of pack_normal in shaders/common/frame.glsl. */
void unpack_normal(uint32_t packed, float n[3]);

/* exact.c */
extern const render_pipeline exact_pipeline, exact_unclipped_pipeline, limit_pipeline;

#endif
