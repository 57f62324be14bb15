/* pass.h: images, pipelines that draw, and lists of steps that run in one submission.
 *
 * Conventions as in gpu.h. Every image stays in the general layout, so that any step may use it in
 * any way; between two steps of a list everything that was written becomes visible to everything
 * that follows. */
#ifndef GPU_PASS_H
#define GPU_PASS_H

#include "gpu.h"

#ifdef __cplusplus
extern "C" {
#endif

/* ---- Images -----------------------------------------------------------------------------------
 */

typedef enum gpu_format {
    GPU_RGBA8, /* unsigned, normalised: values are 0 to 1 */
    GPU_R32F,
    GPU_RG32F,
    GPU_RGBA16F,
    GPU_RGBA32F,
    GPU_R32U,
    GPU_RG32U,
    GPU_RGBA32U,
    GPU_DEPTH32 /* only as a depth target or GPU_FETCHED */
} gpu_format;

typedef struct gpu_image gpu_image;

/* One level, one layer; contents undefined. GPU_UNSUPPORTED where a side is 0 or beyond the
 * device's limit. */
gpu_status gpu_image_create(gpu_device *device, gpu_format format, uint32_t width, uint32_t height,
                            gpu_image **image);
void gpu_image_destroy(gpu_image *image); /* NULL is fine */
uint32_t gpu_image_width(const gpu_image *image);
uint32_t gpu_image_height(const gpu_image *image);
size_t gpu_image_texel(const gpu_image *image); /* bytes */

/* The whole image, rows from the top, without gaps. */
gpu_status gpu_image_read(gpu_image *image, void *texels);
gpu_status gpu_image_write(gpu_image *image, const void *texels);

/* ---- Drawing ----------------------------------------------------------------------------------
 */

enum { GPU_MAX_TARGETS = 4 };

typedef struct gpu_draw gpu_draw;

/* A shader is given as SPIR-V words or, where words is NULL, as GLSL. */
typedef struct gpu_shader {
    const char *source;
    const uint32_t *words;
    size_t word_count;
} gpu_shader;

typedef struct gpu_draw_options {
    const char *name;
    gpu_shader vertex, fragment;
    int binding_count; /* set 0, bindings 0 to binding_count - 1, seen by both stages */
    gpu_binding bindings[GPU_MAX_BINDINGS];
    uint32_t push_size; /* seen by both stages */
    float constant;     /* constant_id 0 of both stages, a float; 0: as they have it */
    int target_count;
    gpu_format targets[GPU_MAX_TARGETS];
    bool depth; /* a GPU_DEPTH32 target, tested and written: nearer (less) wins, first one at
                   equality */
    bool lines; /* a list of lines; else of triangles, both sides drawn */
} gpu_draw_options;

/* There are no vertex attributes: vertex shaders read storage buffers at gl_VertexIndex. Depth is
 * 0 (near) to 1; y points down, as Vulkan has it. */
gpu_status gpu_draw_create(gpu_device *device, const gpu_draw_options *options, gpu_draw **draw);
void gpu_draw_destroy(gpu_draw *draw); /* NULL is fine */

/* ---- Lists of steps ---------------------------------------------------------------------------
 */

/* Exactly one of compute, draw, clear and fill is given. */
typedef struct gpu_step {
    const char *name;
    gpu_compute *compute;
    gpu_draw *draw;
    gpu_image *clear; /* every texel becomes clear_value (floats, depth) or clear_bits */
    gpu_buffer *fill; /* every 32-bit word becomes clear_bits[0] */

    /* gpu_buffer, gpu_texture or gpu_image, as the pipeline's bindings say */
    void *resources[GPU_MAX_BINDINGS];
    const void *push; /* push_size bytes, read during gpu_run */

    /* compute: groups, 0 counts as 1. indirect: three words at indirect_offset instead. */
    uint32_t groups[3];
    /* draw: vertex_count and instance_count (0 counts as 1), or with indices (32 bits each)
     * vertex_count of them. indirect: VkDrawIndirectCommand (four words), or with indices
     * VkDrawIndexedIndirectCommand (five). */
    uint32_t vertex_count, instance_count;
    gpu_buffer *indices;
    gpu_buffer *indirect;
    size_t indirect_offset;

    gpu_image *targets[GPU_MAX_TARGETS];
    gpu_image *depth;
    uint32_t viewport[2]; /* draw: pixels from -1 to 1 across and down, where not those of the
                             targets; what lies beyond these is never drawn */
    bool keep; /* draw over what the targets and the depth hold; else they are cleared: to
                  clear_value or clear_bits, depth to 1 */
    float clear_value[4];
    uint32_t clear_bits[4];
} gpu_step;

/* Runs the steps in order and waits. seconds: where not NULL, the time of each step, count of them.
 * Compute pipelines are those of gpu.h; the same pipeline may occur many times with different
 * resources. */
gpu_status gpu_run(gpu_device *device, const gpu_step *steps, int count, double *seconds);

/* Limits that the renderer needs beyond the guaranteed ones. GPU_UNSUPPORTED and a line that names
 * the first that is missing. */
typedef struct gpu_needs {
    uint32_t group_invocations; /* in a compute work group */
    uint32_t shared_bytes;
    uint32_t image_side;
    size_t buffer_bytes;           /* of a storage buffer */
    uint32_t subgroup_invocations; /* that add and shuffle, in compute shaders */
} gpu_needs;
gpu_status gpu_check(const gpu_device *device, const gpu_needs *needs);

#ifdef __cplusplus
}
#endif

#endif
