/* render_fixture.h: a small scene in memory, and rendering it on the software device. */
#ifndef RENDER_FIXTURE_H
#define RENDER_FIXTURE_H

#include "gpu_fixture.h"

#include <math.h>
#include <string.h>

#include "render/internal.h"

enum { FIXTURE_MOST = 64 }; /* triangles */

static inline void fixture_near(double found, double expected, double tolerance, int line)
{
    if (!(fabs(found - expected) <= tolerance))
        fail_msg("line %d: %.9g, expected %.9g within %.3g", line, found, expected, tolerance);
}
#define assert_near(found, expected, tolerance) fixture_near(found, expected, tolerance, __LINE__)

typedef struct fixture {
    render_scene scene;
    float positions[9 * FIXTURE_MOST], normals[9 * FIXTURE_MOST], albedos[9];
    uint32_t indices[3 * FIXTURE_MOST], materials[FIXTURE_MOST];
    render_area_light area;
} fixture;

static inline double fixture_dot(const double a[3], const double b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static inline void fixture_cross(const double a[3], const double b[3], double c[3])
{
    c[0] = a[1] * b[2] - a[2] * b[1];
    c[1] = a[2] * b[0] - a[0] * b[2];
    c[2] = a[0] * b[1] - a[1] * b[0];
}

static inline void fixture_unit(double a[3])
{
    double length = sqrt(fixture_dot(a, a));
    for (int i = 0; i < 3; i++)
        a[i] /= length;
}

static inline void fixture_corner(const fixture *f, size_t triangle, int corner, double p[3])
{
    for (int i = 0; i < 3; i++)
        p[i] = (double)f->positions[3 * f->indices[3 * triangle + (size_t)corner] + (size_t)i];
}

/* Its unit normal by the order of its corners. */
static inline void fixture_face(const fixture *f, size_t triangle, double normal[3])
{
    double p[3][3], side[2][3];
    for (int corner = 0; corner < 3; corner++)
        fixture_corner(f, triangle, corner, p[corner]);
    for (int i = 0; i < 3; i++) {
        side[0][i] = p[1][i] - p[0][i];
        side[1][i] = p[2][i] - p[0][i];
    }
    fixture_cross(side[0], side[1], normal);
    fixture_unit(normal);
}

/* Corners three apart in one array; the normals are the face's. */
static inline void fixture_add(fixture *f, const float corners[9], uint32_t material)
{
    size_t triangle = f->scene.triangle_count++;
    f->scene.vertex_count += 3;
    memcpy(f->positions + 9 * triangle, corners, 9 * sizeof *corners);
    f->materials[triangle] = material;
    for (size_t i = 0; i < 3; i++)
        f->indices[3 * triangle + i] = (uint32_t)(3 * triangle + i);
    double normal[3];
    fixture_face(f, triangle, normal);
    for (size_t i = 0; i < 9; i++)
        f->normals[9 * triangle + i] = (float)normal[i % 3];
}

static inline void fixture_quad(fixture *f, const float c[12], uint32_t material)
{
    fixture_add(f, (float[]){c[0], c[1], c[2], c[3], c[4], c[5], c[6], c[7], c[8]}, material);
    fixture_add(f, (float[]){c[0], c[1], c[2], c[6], c[7], c[8], c[9], c[10], c[11]}, material);
}

/* A floor, two walls, one of them seen from behind, and a leaning triangle; a spotlight on the
 * floor and the back wall, and an area light above. */
static inline void fixture_make(fixture *f)
{
    memset(f, 0, sizeof *f);
    fixture_quad(f, (float[]){-2, 0, 2, 2, 0, 2, 2, 0, -2, -2, 0, -2}, 0);
    fixture_quad(f, (float[]){-2, 0, -2, 2, 0, -2, 2, 3, -2, -2, 3, -2}, 1);
    fixture_quad(f, (float[]){-2, 0, 2, -2, 3, 2, -2, 3, -2, -2, 0, -2}, 2);
    fixture_add(f, (float[]){-0.5F, 0, 0, 0.9F, 0, 0.4F, 0.3F, 1.2F, -0.4F}, 2);
    static const float albedos[9] = {0.8F, 0.8F, 0.8F, 0.2F, 0.6F, 0.4F, 1, 0.2F, 0};
    memcpy(f->albedos, albedos, sizeof albedos);
    f->area = (render_area_light){
        .corner_count = 4,
        .corners = {{0.5, 2.5, 0.5}, {-0.5, 2.5, 0.5}, {-0.5, 2.5, -0.5}, {0.5, 2.5, -0.5}},
        .exitance = {2, 3, 4}};
    f->scene.name = (char *)"fixture";
    f->scene.material_count = 3;
    f->scene.positions = f->positions;
    f->scene.normals = f->normals;
    f->scene.indices = f->indices;
    f->scene.materials = f->materials;
    f->scene.albedos = f->albedos;
    f->scene.low[0] = f->scene.low[2] = -2;
    f->scene.high[0] = f->scene.high[2] = 2;
    f->scene.high[1] = 3;
    f->scene.camera = (render_camera){.eye = {0.4, 1.5, 4},
                                      .target = {0, 0.8, 0},
                                      .up = {0, 1, 0},
                                      .fov_y_deg = 55,
                                      .near = 0.1,
                                      .far = 20};
    f->scene.has_spot = true;
    f->scene.spot = (render_spot){.position = {1.5, 2.6, 1.6},
                                  .target = {0, 0.3, -0.8},
                                  .angle_deg = 50,
                                  .intensity = {30, 25, 20}};
    f->scene.area_light_count = 1;
    f->scene.area_lights = &f->area;
    f->scene.rsm_size = 8;
}

static const double pi = 3.14159265358979323846;

static inline int open_device(void **state)
{
    gpu_device *device = NULL;
    gpu_device_options options = {.device = "llvmpipe", .validation = true};
    gpu_status status = gpu_device_open(&options, &device);
    if (status != GPU_OK && (status != GPU_NO_DEVICE || getenv("CI"))) {
        fprintf(stderr, "%s\n", gpu_last_error());
        return 1;
    }
    *state = device;
    return 0;
}

static inline int close_device(void **state)
{
    gpu_device *device = *state;
    if (!device)
        return 0;
    int messages = gpu_message_count(device);
    if (messages)
        fprintf(stderr, "validation: %s\n", gpu_messages(device));
    gpu_device_close(device);
    return messages != 0;
}

static inline void check(gpu_status status)
{
    if (status != GPU_OK)
        fail_msg("%s", gpu_last_error());
}

static inline void make_frame(void **state, const fixture *f, render_options options,
                              render_frame *frame)
{
    if (!*state)
        skip();
    check(render_frame_create(*state, &f->scene, &options, frame));
}

static inline void light_with(render_frame *frame, const char *id, render_statistics *statistics,
                              float *light)
{
    const render_pipeline *pipeline = render_pipeline_find(id);
    assert_non_null(pipeline);
    check(render_frame_light(frame, pipeline, statistics));
    check(gpu_image_read(frame->light, light));
}

#endif
