/* bounce.h: the reference of indirect light: one diffuse bounce of area lights, by paths that
 * Embree traces on the host. */
#ifndef RENDER_BOUNCE_H
#define RENDER_BOUNCE_H

#include "render.h"

typedef struct bounce_options {
    uint32_t paths;   /* of each place, at least 2 */
    uint32_t step;    /* of every so manyth pixel and row, from half of that on; 0 counts as 1 */
    uint32_t threads; /* 0: as many as there are processors; changes nothing but the time */
} bounce_options;

/* Irradiance of places on surfaces and the variance of each estimate, W/m^2 and its square. */
typedef struct bounce {
    uint32_t width, height; /* of the places: those of the frame over the step, rounded down */
    float *irradiance;      /* 4 a place; w: 1, or 0 where there is no surface */
    float *variance;        /* 3 a place */
} bounce;

/* Irradiance of the frame's G-buffer by light that was reflected once, evenly, by a surface that
 * area lights light: mean of albedo times irradiance where rays end that leave the pixel with the
 * density of the clamped cosine about its shading normal. There a ray goes to a random point of
 * each light, one from each of equal parts of its area in turn. Random numbers depend on the pixel
 * and the path alone. The texels of the reflective shadow map do not shine. GPU_UNSUPPORTED
 * without Embree. Free with bounce_free. */
gpu_status bounce_render(render_frame *frame, const bounce_options *options, bounce *result);
void bounce_free(bounce *result);

typedef struct bounce_comparison {
    double rel;   /* root mean square of the difference over places and channels, over the mean of
                     the reference; the noise of the reference is part of it */
    double noise; /* root mean square of the reference's standard errors over its mean: of
                     independent paths; those of a place are spread evenly and do better */
    double bias;  /* mean of the difference over that mean */
    double mean;  /* of the reference, W/m^2 */
} bounce_comparison;

/* light: 4 floats a pixel of a frame of that width, whose places the reference has. */
void bounce_compare(const bounce *reference, const float *light, uint32_t width, uint32_t step,
                    bounce_comparison *result);

#endif
