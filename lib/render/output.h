/* output.h: what a frame is written as. */
#ifndef RENDER_OUTPUT_H
#define RENDER_OUTPUT_H

#include <cjson/cJSON.h>

#include "render.h"

/* A frame after its pipeline has run, read back; 4 floats a pixel each. */
typedef struct output_frame {
    int width, height;
    float *radiance;            /* frame->image */
    float *light;               /* frame->light */
    float *truth;               /* light of the exact pipeline; NULL: was not asked for */
    float *errors;              /* 1 float a pixel; NULL with truth */
    float *position;            /* the G-buffer, read where layers are asked for, else NULL */
    float *shading, *geometric; /* normals, 3 floats a pixel */
    float *albedo;
    double origin[3]; /* of the scene: positions count from there */
} output_frame;

/* Whether --out, --png, --stats, --profile and --dump, NULL where not given, are files of their
 * own: one would silently replace the other. False after one line. */
enum { OUTPUT_PATHS = 5, OUTPUT_DUMP = 4 };
bool output_are_apart(const char *const paths[OUTPUT_PATHS]);

/* Whether all of them can be written, asked before the work; files may go into the folder of the
 * dump, which is made with the first picture. False after one line; nothing is left. */
bool output_can_be_written(const char *const paths[OUTPUT_PATHS]);

gpu_status output_read(render_frame *frame, bool layers, output_frame *out);
gpu_status output_read_image(gpu_image *image, float **pixels); /* of GPU_RGBA32F */
void output_free(output_frame *out);

/* Linear radiance as channels R, G, B, and with layers everything that was read. position.X, Y, Z
 * count from the scene's origin (floats would not hold more); where that is not 0 it is the text
 * attribute "origin", "x y z" in the description's coordinates. All three: false after one line. */
bool output_exr(const char *path, const output_frame *out);
/* Radiance by render_tone, as sRGB. */
bool output_png(const char *path, int width, int height, const float *radiance, double gain);
/* The layers and, where there is a truth, four times the error, as pictures in a folder. */
bool output_dump(const char *folder, const output_frame *out, double gain);

/* Values from 0 to 1 as colours: black, violet, red, yellow, white; 1 float a pixel, scaled. */
bool output_false_colour(const char *path, int width, int height, const float *values, float scale);

/* CSV with columns lambda, cos_theta and weight: the points, as a pipeline's profile gives them,
 * with those that are close to each other merged into their mean. */
bool output_profile(const char *path, const float *points, size_t count);

/* The scene's origin as an array. */
void output_origin(cJSON *object, const render_scene *scene);

/* Counts and times, as the keys that README lists. */
void output_statistics(cJSON *object, const render_statistics *statistics);
/* To a file, or NULL: to standard output. False after one line. */
bool output_json(const char *path, const cJSON *json);
void output_comparison(cJSON *object, const render_comparison *comparison);

#endif
