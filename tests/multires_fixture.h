/* multires_fixture.h: a small frame of the built-in scene with area lights, its G-buffer on the
 * host, and the fragments of shaders/multires/fragments.glsl. */
#ifndef MULTIRES_FIXTURE_H
#define MULTIRES_FIXTURE_H

#include "pass_fixture.h"

#include <math.h>

#include "render/internal.h"
#include "render/multires.h"

typedef struct fixture {
    gpu_device *device;
    render_scene scene;
    render_frame frame;
    float *position;
    float (*normal)[3], (*face)[3];
} fixture;

static inline void fixture_read(fixture *f)
{
    size_t pixels = (size_t)f->frame.width * f->frame.height;
    uint32_t *packed = malloc(pixels * 8);
    f->position = malloc(pixels * 16);
    f->normal = malloc(pixels * sizeof *f->normal);
    f->face = malloc(pixels * sizeof *f->face);
    must(gpu_image_read(f->frame.position, f->position));
    must(gpu_image_read(f->frame.normal, packed));
    for (size_t i = 0; i < pixels; i++) {
        unpack_normal(packed[2 * i], f->normal[i]);
        unpack_normal(packed[2 * i + 1], f->face[i]);
    }
    free(packed);
}

static inline void fixture_frame(fixture *f, uint32_t width, uint32_t height)
{
    render_options options = {.width = width, .height = height};
    must(render_frame_create(f->device, &f->scene, &options, &f->frame));
    fixture_read(f);
}

/* The frame points into the fixture, which therefore stays where it is. */
static inline void fixture_open(fixture *f, const char *name, uint32_t width, uint32_t height)
{
    char path[1000];
    const char *root = getenv("SGFIT_ROOT");
    snprintf(path, sizeof path, "%s/tests/scenes/%s.json", root ? root : ".", name);
    *f = (fixture){.device = open_software_device()};
    assert_true(render_scene_read(path, NULL, &f->scene));
    fixture_frame(f, width, height);
}

static inline void fixture_close_frame(fixture *f)
{
    free(f->position);
    free(f->normal);
    free(f->face);
    render_frame_destroy(&f->frame);
}

static inline void fixture_close(fixture *f)
{
    fixture_close_frame(f);
    render_scene_free(&f->scene);
    close_clean(f->device);
}

/* Lights the frame; the light image, malloc'ed. */
static inline float *fixture_light(fixture *f, const render_pipeline *pipeline,
                                   render_statistics *statistics)
{
    must(render_frame_light(&f->frame, pipeline, statistics));
    float *light = malloc((size_t)f->frame.width * f->frame.height * 16);
    must(gpu_image_read(f->frame.light, light));
    return light;
}

/* How the device looks from a pixel at a light: its points, its normal, where rays begin. */
static inline void shadow_rays(const fixture *f, const render_area_light *light, size_t at,
                               float points[SHADOWS_POINTS][4], double normal[3], float origin[3])
{
    const float *p = f->position + 4 * at;
    double size = (double)p[3], extent = 0;
    for (int k = 0; k < 3; k++)
        size = fmax(size, fabs((double)p[k]));
    for (int i = 0; i < light->corner_count; i++)
        for (int k = 0; k < 3; k++)
            extent = fmax(extent, fabs(light->corners[i][k]));
    shadows_points(light, 1e-4 * extent, points);
    shadows_normal(light, normal);
    for (int k = 0; k < 3; k++)
        origin[k] = p[k] + (float)(1e-4 * size) * f->face[at][k];
}

static inline double dot(const float a[3], const float b[3])
{
    return (double)a[0] * (double)b[0] + (double)a[1] * (double)b[1] + (double)a[2] * (double)b[2];
}

/* Form factor of a light at a pixel, without shadow, by a grid of points on it. */
static inline double form_factor(const fixture *f, const render_area_light *light, uint32_t x,
                                 uint32_t y)
{
    enum { SIDE = 40 };
    size_t at = (size_t)y * f->frame.width + x;
    double n[3], sum = 0;
    shadows_normal(light, n);
    for (int i = 0; i < SIDE * SIDE; i++) {
        double to[3], square = 0, facing = 0, above = 0;
        shadows_point(light, (i % SIDE + 0.5) / SIDE, (i / SIDE + 0.5) / SIDE, to);
        for (int k = 0; k < 3; k++) {
            double d = to[k] - (double)f->position[4 * at + (size_t)k];
            square += d * d;
            facing -= d * n[k]; /* n: as long as the light has area */
            above += d * (double)f->normal[at][k];
        }
        sum += fmax(facing, 0) * fmax(above, 0) / (square * square);
    }
    return sum / (SIDE * SIDE * 3.14159265358979323846);
}

static inline double exitance(const render_area_light *light)
{
    return (light->exitance[0] + light->exitance[1] + light->exitance[2]) / 3;
}

/* ---- Fragments ----------------------------------------------------------------------- */

enum { STATE_NOTHING, STATE_FINAL, STATE_SAMPLE, STATE_PART, STATE_DARK, STATE_SHARED };

static inline size_t fragment_index(const multires *m, int level, uint32_t x, uint32_t y)
{
    static const size_t before[] = {0, 256, 320, 336, 340};
    return before[level] * m->tiles + (size_t)y * (m->push[0].tiles[0] << (4 - level)) + x;
}

static inline const float *illumination(const multires *m, int level, uint32_t x, uint32_t y)
{
    return (const float *)gpu_buffer_map(m->illumination) + 4 * fragment_index(m, level, x, y);
}

static inline int state_of(const multires *m, int level, uint32_t x, uint32_t y)
{
    float w = illumination(m, level, x, y)[3];
    return w < 0 ? STATE_SHARED : (int)w;
}

static inline float discontinuity(const multires *m, int level, uint32_t x, uint32_t y)
{
    return (
        (const float *)gpu_buffer_map(m->pyramid))[fragment_index(m, level, x, y) - 256 * m->tiles];
}

static inline uint32_t list_count(const multires *m, int list)
{
    return ((const uint32_t *)gpu_buffer_map(m->work))[4 * list + 3] - 1;
}

static inline const uint32_t *list_entries(const multires *m, int list)
{
    size_t base = list == 0 ? 85 * m->tiles : fragment_index(m, list, 0, 0) - 256 * m->tiles;
    return (const uint32_t *)gpu_buffer_map(m->lists) + base;
}

static inline int ascending(const void *a, const void *b)
{
    uint32_t x = *(const uint32_t *)a, y = *(const uint32_t *)b;
    return (x > y) - (x < y);
}

/* The mean that mean.comp left. */
static inline double mean_of(const multires *m)
{
    float mean;
    memcpy(&mean, (const uint32_t *)gpu_buffer_map(m->work) + 4 * RENDER_LEVELS, sizeof mean);
    return (double)mean;
}

/* malloc'ed, in ascending order */
static inline uint32_t *sorted_list(const multires *m, int list)
{
    uint32_t count = list_count(m, list), *sorted = malloc(4 * (size_t)count + 4);
    memcpy(sorted, list_entries(m, list), 4 * (size_t)count);
    qsort(sorted, count, 4, ascending);
    return sorted;
}

/* The passes of the pipeline; kept is bound to the test, which here does all lights at once. */
static inline gpu_compute *compile_test(fixture *f, gpu_buffer **kept)
{
    static const gpu_binding buffer = GPU_STORAGE_BUFFER;
    gpu_compute *test;
    must(multires_compute(&f->frame, "multires/test.comp", &buffer, &test));
    must(gpu_buffer_create(f->device, 16, kept));
    return test;
}

/* The same for fragments of level 1. */
static inline gpu_compute *compile_quads(fixture *f)
{
    static const gpu_binding buffer = GPU_STORAGE_BUFFER;
    gpu_compute *quads;
    must(multires_compute(&f->frame, "multires/quads.comp", &buffer, &quads));
    return quads;
}

/* The pyramids and the first fragments. */
static inline void run_first(fixture *f, multires *m)
{
    must(multires_create(&f->frame, &multires_default, m));
    gpu_step steps[MULTIRES_FIRST_STEPS];
    assert_int_equal(multires_begin(&f->frame, m, steps), MULTIRES_FIRST_STEPS);
    must(gpu_run(f->device, steps, MULTIRES_FIRST_STEPS, NULL));
}

#endif
