/* reference_render.h: ground truth without the device: rays by Embree, everything else in double,
 * written for this purpose from the definitions alone. */
#ifndef TESTS_REFERENCE_RENDER_H
#define TESTS_REFERENCE_RENDER_H

#include "render/scene.h"

typedef struct reference reference;

/* NULL where there is no memory. The scene must outlive it. */
reference *reference_open(const render_scene *scene);
void reference_close(reference *from);
const render_scene *reference_scene(const reference *from);

/* What the ray through a pixel's centre hits first. */
typedef struct reference_pixel {
    double depth; /* along the view axis; 0: nothing */
    double position[3];
    double normal[3]; /* interpolated, on the side of the face that is seen */
    double face[3];   /* of the triangle, towards the viewer */
    float albedo[3];
} reference_pixel;

void reference_view(reference *from, const render_camera *camera, int width, int height,
                    reference_pixel *pixels);

/* One-sided triangle, corners counter-clockwise seen from the side that emits. */
typedef struct reference_light {
    double corners[3][3], normal[3], exitance[3];
} reference_light;

/* The texels of the reflective shadow map that see a surface, in rows from the top left corner of
 * the square round the spotlight's cone, then the area lights as fans from their first corner;
 * malloc'ed, NULL without memory. A texel of solid angle W that sees a surface at distance d,
 * cosine c between its normal and the light, is an equilateral triangle round the hit, in the plane
 * of the triangle there, of area A = W d^2/max(c, 0.05) and exitance albedo * intensity * W/A; a
 * side runs along axis x normal, of the axis that the normal has least of. */
reference_light *reference_lights(reference *from, size_t *count);

/* Of the cosine-weighted hemisphere at x about n (unit); 0 behind the light and less than 2 mm
 * before its plane. */
double reference_form_factor(const reference_light *light, const double x[3], const double n[3]);

/* Irradiance of every pixel, 3 values each; 0 where nothing was hit. */
void reference_irradiance(const reference_pixel *pixels, size_t pixel_count,
                          const reference_light *lights, size_t light_count, double (*rgb)[3]);

#endif
