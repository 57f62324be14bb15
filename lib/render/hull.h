/* hull.h: lighting gathered at the vertices of a hull in screen space, with near lights exact at
 * every pixel; see shaders/hull/hull.glsl. */
#ifndef RENDER_HULL_H
#define RENDER_HULL_H

#include "render.h"

enum {
    HULL_TILE = 32,
    HULL_LEVELS = 4,
    HULL_MOST_COMPONENTS = 32, /* in a tile */
    HULL_BLOCK = 8,
    HULL_MOST_NEAR = 64,
    HULL_VERTEX_BYTES = 12 * 16,
    HULL_MEAN_ROWS = 18 /* of 32 samples */
};

typedef struct hull_settings {
    float link_plane, link_cosine;     /* see links.comp */
    float split;                       /* see split.comp */
    float tau, tau_width, near_pixels; /* see window.glsl */
} hull_settings;

extern const hull_settings hull_standard;

gpu_status hull_create(render_frame *frame, const hull_settings *settings, void **state);
gpu_status hull_run(render_frame *frame, void *state, render_statistics *statistics);
void hull_destroy(void *state);

extern const render_pipeline hull_pipeline;

#endif
