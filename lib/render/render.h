/* render.h: the validation renderer. A frame holds a scene on a device with its G-buffer and its
 * lights; a pipeline fills the frame's light buffer (irradiance), everything else is shared. */
#ifndef RENDER_RENDER_H
#define RENDER_RENDER_H

#include "gpu/pass.h"
#include "render/scene.h"

/* ---- Statistics ---------------------------------------------------------------------- */

enum { RENDER_MOST_TIMES = 64, RENDER_LEVELS = 5 };

typedef struct render_statistics {
    uint64_t pixels_covered; /* with a surface and a light value that the pipeline made for them */
    uint64_t pixels_uncovered; /* with a surface, but no light value */
    uint64_t pixels_wrong;     /* lit by a segment that they are not part of */
    uint64_t quads, vertices;
    uint64_t light_evaluations; /* pairs of a point and a light, as the shaders executed them */
    /* area lights with shadows: rays, places where irradiance was computed, fragments of
     * 1, 2, 4, 8, 16 pixels a side */
    uint64_t visibility_rays, samples, fragments_by_level[RENDER_LEVELS];
    /* indirect light: its volume's points on surfaces, which count among the samples too, and its
     * voxels */
    uint64_t volume_samples, voxels;
    uint64_t ground_truth_evaluations; /* pixels with a surface times lights */
    uint64_t triangles, lights;
    int time_count;
    struct {
        const char *name; /* of the pass */
        double ms;        /* median of the runs */
    } times[RENDER_MOST_TIMES];
} render_statistics;

/* Of irradiance, over the covered pixels. The error of a pixel is the root mean square over the
 * three channels of (E - E_gt), divided by the mean of E_gt over the pixels and the channels. */
typedef struct render_comparison {
    double rel; /* root mean square of the errors */
    double p50, p95, p99, p999;
    double bias; /* mean of E - E_gt, divided by the mean of E_gt */
} render_comparison;

/* light, truth: 4 floats a pixel, the last one 0 where there is no surface. errors: where not NULL,
 * one a pixel. */
void render_compare(size_t pixels, const float *light, const float *truth, float *errors,
                    render_comparison *result);

/* Structural similarity of light and truth (Wang, Bovik, Sheikh and Simoncelli 2004: Gaussian
 * window of 11 x 11 pixels with a standard deviation of 1.5, K1 = 0.01, K2 = 0.03), -1 to 1, 1: the
 * same: mean over the pixels with a surface. Compared is the luminance of white surfaces under that
 * light, by render_tone with that gain. Images as for render_compare, in rows. */
double render_ssim(uint32_t width, uint32_t height, double gain, const float *light,
                   const float *truth);

/* ---- Frames -------------------------------------------------------------------------- */

/* LPV: one diffuse bounce of what a pipeline lights, by a light propagation volume: lpv.h. */
typedef enum render_indirect { RENDER_INDIRECT_NONE, RENDER_INDIRECT_LPV } render_indirect;

typedef struct render_options {
    uint32_t width, height;
    const char *method;    /* of the registry, for passes that integrate lobes; NULL: "standard" */
    bool detailed_normals; /* strong procedural detail on the shading normals */
    render_indirect indirect; /* beside what a pipeline lights */
    uint32_t volume, steps;   /* of its volume: voxels along the longest side, 1 to 96, and how
                                 often light moves on; 0: 24, and twice the volume */
    int runs; /* of which times are the medians, after one that does not count where they are more
                 than one; 0 counts as 1 */
} render_options;

typedef struct render_frame {
    gpu_device *device;
    const render_scene *scene;
    render_options options;
    uint32_t width, height, light_count;
    uint32_t texel_count; /* the lights that are texels of the reflective shadow map: the first */

    gpu_buffer *view;     /* struct View of shaders/common/frame.glsl */
    gpu_buffer *lights;   /* struct Light of shaders/common/lights.glsl */
    gpu_buffer *counters; /* uint32 pairs (low, high), see shaders/common/counters.glsl */

    /* GPU_RGBA32F: world position; w: distance along the view axis, 0: no surface */
    gpu_image *position;
    /* GPU_RG32U: octahedral, packSnorm2x16: x shading, y geometric normal */
    gpu_image *normal;
    gpu_image *albedo; /* GPU_RGBA8 */
    gpu_image *depth;  /* GPU_DEPTH32 */
    /* GPU_RGBA32F: irradiance; w: 1 lit, 0 no surface, -1 uncovered, -2 wrongly owned. Cleared to
     * 0 before a pipeline runs: what it leaves at 0 on a surface is found to be uncovered. */
    gpu_image *light;
    gpu_image *image; /* GPU_RGBA32F: radiance, albedo/pi applied; w: 1, or 0 without a surface */

    /* times of the passes "gbuffer" and "rsm"; triangles, lights */
    render_statistics made;
    double gain; /* exposure of pictures of this scene and view, see render_tone */
    gpu_compute *resolve, *count;
    struct lpv *lpv; /* NULL: no indirect light */
} render_frame;

/* Makes the images, draws the G-buffer and the reflective shadow map and turns its texels and the
 * area lights into triangles: first a triangle for each texel with a surface, in rows from the
 * map's top left corner, in the plane of the surface and of the area that the texel sees there;
 * then the area lights as fans. The map covers the square around the spotlight's cone. */
gpu_status render_frame_create(gpu_device *device, const render_scene *scene,
                               const render_options *options, render_frame *frame);
void render_frame_destroy(render_frame *frame);

/* Radiance to the [0, 1] of a picture before its encoding as sRGB: x = gain * radiance, by channel
 * x (1 + x/16)/(1 + x), so that 4 is white (Reinhard's curve). gain puts the log-average luminance
 * of a coarse grid of exactly lit pixels at 0.18: it depends on the scene and the view, not on the
 * pipeline, and little on the size. */
float render_tone(double gain, float radiance);

/* ---- Pipelines ----------------------------------------------------------------------- */

typedef struct render_pipeline {
    const char *id;    /* as after --pipeline */
    const char *title; /* one line */
    bool shadows;      /* of area lights alone, with shadows: its truth is `shadows`, not `exact` */
    /* Makes buffers and pipelines of its own for the frame; leaves nothing behind on failure. */
    gpu_status (*create)(render_frame *frame, void **state);
    /* Fills frame->light, options.runs times, and adds its counts and times to the statistics. */
    gpu_status (*run)(render_frame *frame, void *state, render_statistics *statistics);
    /* Writes an image of every stage into a folder; NULL: has none. False after one line. */
    bool (*dump)(render_frame *frame, void *state, const char *folder);
    void (*destroy)(void *state);
    /* What the frame integrates by the fitted form: 3 floats each, lambda, cos_theta and a weight
     * that is the square of the luminance of the lobe's flux (so that weighted squares of errors
     * of L are squares of errors of the image); free() points. NULL: integrates no lobes. */
    gpu_status (*profile)(render_frame *frame, void *state, float **points, size_t *count);
} render_pipeline;

extern const render_pipeline *const render_pipelines[];      /* ends with NULL */
const render_pipeline *render_pipeline_find(const char *id); /* NULL: unknown */
/* The same; where it is unknown NULL after one line that lists all, about --pipeline. */
const render_pipeline *render_pipeline_choose(const char *id);

/* The text, and below it a line for each pipeline; malloc'ed. */
char *render_pipelines_help(const char *before);

/* Runs a list of steps frame->options.runs times and adds the median time of each name to the
 * statistics (steps of the same name count together), and what the shaders counted in one run. The
 * list must be repeatable; the counters are set to 0 before each run. */
gpu_status render_run(render_frame *frame, const gpu_step *steps, int count,
                      render_statistics *statistics);

/* One frame by a pipeline that was created for it: clears frame->light, runs it, adds the indirect
 * light that the options ask for (of area lights, and of the shadow map's texels where the pipeline
 * shows them) and resolves into frame->image. The statistics start as frame->made. */
gpu_status render_frame_run(render_frame *frame, const render_pipeline *pipeline, void *state,
                            render_statistics *statistics);

/* The same with its creation before and its destruction after it. */
gpu_status render_frame_light(render_frame *frame, const render_pipeline *pipeline,
                              render_statistics *statistics);

/* A compute pipeline from shaders/: its words, or where method is true the text with the frame's
 * method. */
gpu_status render_compute(render_frame *frame, const char *path, bool method,
                          const gpu_binding *bindings, int binding_count, uint32_t push_size,
                          gpu_compute **compute);

/* ---- Shaders ------------------------------------------------------------------------- */

/* A shader of shaders/ by its path below that folder ("hull/gather.comp"): SPIR-V embedded at
 * build time. NULL words where there is none of that name. */
gpu_shader render_shader(const char *path);

/* The same as text with its includes spliced in, to be compiled when its pipeline is made, with
 * SG_METHOD_A_h and SG_METHOD_L (see common/method.glsl) set to sg_A_h_METHOD and sg_L_METHOD;
 * NULL: "standard". free() source. */
gpu_status render_shader_method(const char *path, const char *method, gpu_shader *shader);

#endif
