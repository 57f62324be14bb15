/* hull.h: lighting gathered at the vertices of a hull in screen space, with near lights exact at
 * every pixel; see shaders/hull/hull.glsl. */
#ifndef RENDER_HULL_H
#define RENDER_HULL_H

#include "render.h"

enum {
    HULL_TILE = 32,
    HULL_ROWS = 4, /* of a tile that are read together, ROWS of shaders/hull/hull.glsl */
    HULL_LEVELS = 4,
    HULL_RANKS = 16,           /* RANKS of shaders/hull/hull.glsl */
    HULL_MOST_COMPONENTS = 64, /* in a tile */
    HULL_BLOCK = 8,
    HULL_MOST_NEAR = 64,
    HULL_MOST_TILE = 255,
    HULL_VERTEX_BYTES = 13 * 16,
    HULL_QUAD_BYTES = 3 * 16,
    HULL_SAMPLE_BYTES = 12 * 16,
    HULL_LOBE_COUNT = 6, /* of a vertex, LOBES of shaders/hull/vertex_lobe.glsl */
    HULL_MEAN_ROWS = 9   /* of 32 samples */
};

/* How the far light is brought to the pixels. */
typedef enum hull_kind {
    HULL_MOMENTS, /* by the hull, vertices that keep moments of the radiance */
    HULL_LOBES,   /* by the hull, vertices that keep lobes */
    HULL_UPSAMPLE /* by joint bilateral upsampling of a sample a block */
} hull_kind;

typedef struct hull_settings {
    hull_kind kind;
    float link_plane, link_cosine;     /* see links.comp */
    float split;                       /* see split.glsl */
    float tau, tau_width, near_pixels; /* see window.glsl; tau 0: there are no near lights */
    uint32_t factor;                   /* with HULL_UPSAMPLE: pixels along a block */
    float plane, power, least;         /* of upsampling, see shaders/upsample/sample.glsl */
    float merge; /* error of one light that stands for many, over the mean irradiance, at most;
                    0: there is no tree, every light is tested and gathered by itself */
    /* 0, or at most so many, of as many as find room: vertices, quads made by splitting at each
       level, corners of triangles */
    uint32_t most_vertices, most_quads, most_corners;
} hull_settings;

extern const hull_settings hull_standard, hull_lobe_standard; /* of the pipelines */

gpu_status hull_create(render_frame *frame, const hull_settings *settings, void **state);
gpu_status hull_run(render_frame *frame, void *state, render_statistics *statistics);
void hull_destroy(void *state);
bool hull_dump(render_frame *frame, void *state, const char *folder);

/* The record of a pipeline that create_NAME makes with settings of its own. */
#define HULL_PIPELINE(NAME, TITLE, PROFILE)                                                        \
    const render_pipeline NAME##_pipeline = {                                                      \
        .id = #NAME,                                                                               \
        .title = TITLE,                                                                            \
        .create = create_##NAME,                                                                   \
        .run = hull_run,                                                                           \
        .dump = hull_dump,                                                                         \
        .destroy = hull_destroy,                                                                   \
        .profile = PROFILE,                                                                        \
    };

extern const render_pipeline hull_pipeline, hull_lobe_pipeline;
/* upsample_sh.c */
extern const render_pipeline upsample_sh2_pipeline, upsample_sh4_pipeline, upsample_sh8_pipeline;
extern const render_pipeline upsample_far_pipeline, upsample_far6_pipeline, upsample_far4_pipeline;

#endif
