/* scenes_lobes.h: virtual spherical Gaussian lights. Private to bench. */
#ifndef BENCH_SCENES_LOBES_H
#define BENCH_SCENES_LOBES_H

#include "render/render.h"

enum { LOBE_LIGHTS = 2 };

/* struct Lobe of shaders/lobes/lobes.glsl. */
typedef struct lobe_light {
    float centre[3], variance;
    float axis[3], sharpness;
    float intensity[4];
} lobe_light;

/* One small light close to the widest wall of the scene's bounds. Returns 1. */
int lobe_light_sharp(const render_scene *scene, lobe_light lights[LOBE_LIGHTS]);

/* The frame's lights as two, by their places: k-means, from the strongest light and the one
 * farthest from it. Returns how many, at least 1. */
int lobe_lights_of(render_frame *frame, lobe_light lights[LOBE_LIGHTS]);

/* ---- scenes_lobe_errors.c -------------------------------------------------------------------- */

/* What is measured of a picture. */
typedef struct lobe_outcome {
    double smape, smape_p99; /* mean and 99th percentile over the surfaces' pixels */
    double largest;          /* error of green relative to its mean in the truth */
    size_t black;            /* pixels that are 0 or below where the truth is not */
} lobe_outcome;

/* light, truth: 4 floats a pixel, the truth's last is 0 where there is no surface. errors: one a
 * pixel: filled with the symmetric mean absolute percentage error, 0 to 1, below 0 where there is
 * no surface. */
lobe_outcome lobe_compare(size_t width, size_t height, const float *light, const float *truth,
                          float *errors);

#endif
