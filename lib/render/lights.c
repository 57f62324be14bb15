/* What shines: the texels of the reflective shadow map, one triangle each, and the area lights. */
#include "internal.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/buffer.h"

static double dot(const double a[3], const double b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static void cross(const double a[3], const double b[3], double c[3])
{
    c[0] = a[1] * b[2] - a[2] * b[1];
    c[1] = a[2] * b[0] - a[0] * b[2];
    c[2] = a[0] * b[1] - a[1] * b[0];
}

void unpack_normal(uint32_t packed, float n[3])
{
    float p[2];
    for (int i = 0; i < 2; i++) {
        int bits = (int)(packed >> (16 * i) & 0xffff);
        float value = (float)(bits < 32768 ? bits : bits - 65536) / 32767;
        p[i] = value < -1 ? -1 : value;
    }
    n[2] = 1 - fabsf(p[0]) - fabsf(p[1]);
    n[0] = n[2] < 0 ? copysignf(1 - fabsf(p[1]), p[0]) : p[0];
    n[1] = n[2] < 0 ? copysignf(1 - fabsf(p[0]), p[1]) : p[1];
    float length = sqrtf(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
    for (int i = 0; i < 3; i++)
        n[i] /= length;
}

/* ---- One light ----------------------------------------------------------------------- */

static void set_light(light_data *light, double corners[3][3], const double normal[3],
                      const double exitance[3])
{
    float *const places[3] = {light->a, light->b, light->c};
    double side[2][3], across[3];
    for (int i = 0; i < 3; i++) {
        side[0][i] = corners[1][i] - corners[0][i];
        side[1][i] = corners[2][i] - corners[0][i];
    }
    cross(side[0], side[1], across);
    for (int corner = 0; corner < 3; corner++) {
        for (int i = 0; i < 3; i++)
            places[corner][i] = (float)corners[corner][i];
        places[corner][3] = (float)exitance[corner]; /* a channel in each */
    }
    for (int i = 0; i < 3; i++)
        light->plane[i] = (float)normal[i];
    light->plane[3] = (float)(0.5 * sqrt(dot(across, across)));
}

/* An equilateral triangle of that area around a point, with a side along the normal's cross product
 * with the axis that it has least of. */
static void set_texel_light(light_data *light, const double point[3], const double normal[3],
                            double area, const double exitance[3])
{
    int least = 0;
    for (int i = 1; i < 3; i++)
        if (fabs(normal[i]) < fabs(normal[least]))
            least = i;
    double axis[3] = {0, 0, 0}, s[3], t[3];
    axis[least] = 1;
    cross(axis, normal, s);
    double length = sqrt(dot(s, s));
    for (int i = 0; i < 3; i++)
        s[i] /= length;
    cross(normal, s, t);
    double radius = sqrt(area * 4 / (3 * sqrt(3.0))); /* of the circle through the corners */
    static const double around[3][2] = {
        {-0.86602540378443864676, -0.5}, {0.86602540378443864676, -0.5}, {0, 1}};
    double corners[3][3];
    for (int corner = 0; corner < 3; corner++)
        for (int i = 0; i < 3; i++)
            corners[corner][i] =
                point[i] + radius * (around[corner][0] * s[i] + around[corner][1] * t[i]);
    set_light(light, corners, normal, exitance);
}

static uint32_t add_area_light(light_data *lights, const render_area_light *area)
{
    double side[2][3], normal[3];
    uint32_t count = 0;
    for (int i = 2; i < area->corner_count; i++) {
        double corners[3][3];
        memcpy(corners[0], area->corners[0], sizeof corners[0]);
        memcpy(corners[1], area->corners[i - 1], sizeof corners[1]);
        memcpy(corners[2], area->corners[i], sizeof corners[2]);
        for (int k = 0; k < 3; k++) {
            side[0][k] = corners[1][k] - corners[0][k];
            side[1][k] = corners[2][k] - corners[0][k];
        }
        cross(side[0], side[1], normal);
        double length = sqrt(dot(normal, normal));
        if (!(length > 0))
            continue;
        for (int k = 0; k < 3; k++)
            normal[k] /= length;
        set_light(&lights[count++], corners, normal, area->exitance);
    }
    return count;
}

/* ---- The reflective shadow map ------------------------------------------------------- */

/* Solid angle of the rectangle from (0, 0) to (x, y) in the plane at distance 1. */
static double corner_angle(double x, double y)
{
    return atan(x * y / sqrt(x * x + y * y + 1));
}

/* Below this cosine a texel's area no longer grows: beyond, one texel on a wall that the light only
 * grazes would be a light of many square metres. Its flux is right all the same. */
static const double least_cosine = 0.05;

static bool add_texel(light_data *light, const render_spot *spot, const float position[4],
                      uint32_t face, const uint8_t albedo[4], double solid_angle)
{
    if (!(position[3] > 0))
        return false;
    double to_spot[3], point[3], normal[3], exitance[3];
    float unpacked[3];
    unpack_normal(face, unpacked);
    for (int i = 0; i < 3; i++) {
        point[i] = (double)position[i];
        to_spot[i] = spot->position[i] - point[i];
        normal[i] = (double)unpacked[i];
    }
    double square = dot(to_spot, to_spot);
    double cosine = dot(to_spot, normal) / sqrt(square);
    double area = solid_angle * square / (cosine > least_cosine ? cosine : least_cosine);
    for (int i = 0; i < 3; i++)
        exitance[i] = albedo[i] / 255.0 * spot->intensity[i] * solid_angle / area;
    set_texel_light(light, point, normal, area, exitance);
    return true;
}

static gpu_status read_map(render_frame *frame, const gbuffer *map, light_data *lights)
{
    const render_spot *spot = &frame->scene->spot;
    int size = frame->scene->rsm_size;
    size_t texels = (size_t)size * (size_t)size;
    float *positions = base_allocate(texels * 4 * sizeof *positions);
    uint32_t *normals = base_allocate(texels * 2 * sizeof *normals);
    uint8_t *albedos = base_allocate(texels * 4);
    gpu_status status = gpu_image_read(map->position, positions);
    if (status == GPU_OK)
        status = gpu_image_read(map->normal, normals);
    if (status == GPU_OK)
        status = gpu_image_read(map->albedo, albedos);
    double slope = tan(0.5 * spot->angle_deg * 3.14159265358979323846 / 180);
    for (size_t i = 0; status == GPU_OK && i < texels; i++) {
        double x[2], y[2];
        for (int side = 0; side < 2; side++) {
            x[side] = slope * (2 * ((double)(i % (size_t)size) + side) / size - 1);
            y[side] = slope * (2 * ((double)(i / (size_t)size) + side) / size - 1);
        }
        double solid_angle = corner_angle(x[1], y[1]) - corner_angle(x[0], y[1]) -
                             corner_angle(x[1], y[0]) + corner_angle(x[0], y[0]);
        frame->light_count += add_texel(&lights[frame->light_count], spot, positions + 4 * i,
                                        normals[2 * i + 1], albedos + 4 * i, solid_angle);
    }
    free(positions);
    free(normals);
    free(albedos);
    return status;
}

float render_closest(const render_frame *frame)
{
    const render_scene *scene = frame->scene;
    double side = 0;
    for (int i = 0; scene && i < 3; i++)
        side = fmax(side, scene->high[i] - scene->low[i]);
    return side > 0 && side < 1 ? (float)(0.002 * side) : 0;
}

/* As far as the farthest corner of the scene's bounds. */
static double reach(const render_scene *scene)
{
    double square = 0;
    for (int i = 0; i < 3; i++) {
        double low = fabs(scene->low[i] - scene->spot.position[i]);
        double high = fabs(scene->high[i] - scene->spot.position[i]);
        square += low > high ? low * low : high * high;
    }
    double far = sqrt(square);
    return 1.01 * far + (far > 0 ? fmin(1e-3 * far, 1e-3) : 1e-3);
}

static gpu_status draw_map(render_frame *frame, const geometry *geometry, light_data *lights,
                           double *ms)
{
    const render_scene *scene = frame->scene;
    uint32_t size = (uint32_t)scene->rsm_size;
    render_camera camera = {.fov_y_deg = scene->spot.angle_deg, .far = reach(scene)};
    camera.near = 1e-3 * camera.far;
    memcpy(camera.eye, scene->spot.position, sizeof camera.eye);
    memcpy(camera.target, scene->spot.target, sizeof camera.target);
    double along[3] = {0, 0, 0};
    for (int i = 0; i < 3; i++)
        along[i] = camera.target[i] - camera.eye[i];
    /* up is y unless the light shines up or down */
    bool steep = fabs(along[1]) > 0.99 * sqrt(dot(along, along));
    camera.up[steep ? 2 : 1] = 1;
    gbuffer map;
    gpu_buffer *view = NULL;
    gpu_status status = gbuffer_create(frame->device, size, size, &map);
    if (status == GPU_OK)
        status = gpu_buffer_create(frame->device, sizeof(view_data), &view);
    if (status == GPU_OK) {
        view_fill(&camera, size, size, gpu_buffer_map(view));
        status = geometry_draw(geometry, view, &map, false, frame->options.runs, ms);
    }
    if (status == GPU_OK)
        status = read_map(frame, &map, lights);
    gpu_buffer_destroy(view);
    gbuffer_destroy(&map);
    return status;
}

/* Triangles: software devices end a shader that goes around its loops 65,535 times without a word,
 * and ground truth goes around 193 times for 64 lights. */
enum { MOST_LIGHTS = 20000 };

gpu_status lights_create(render_frame *frame, const geometry *geometry, double *ms)
{
    const render_scene *scene = frame->scene;
    *ms = 0;
    size_t most = scene->has_spot ? (size_t)scene->rsm_size * (size_t)scene->rsm_size : 0;
    for (size_t i = 0; i < scene->area_light_count; i++)
        most += (size_t)scene->area_lights[i].corner_count - 2;
    if (most > MOST_LIGHTS)
        return gpu_fail(GPU_UNSUPPORTED, "the scene has up to %zu lights, more than %d", most,
                        MOST_LIGHTS);
    size_t bytes = (most ? most : 1) * sizeof(light_data);
    gpu_needs needs = {.buffer_bytes = bytes};
    gpu_status status = gpu_check(frame->device, &needs);
    if (status == GPU_OK)
        status = gpu_buffer_create(frame->device, bytes, &frame->lights);
    if (status != GPU_OK)
        return status;
    light_data *lights = gpu_buffer_map(frame->lights);
    memset(lights, 0, bytes);
    if (scene->has_spot)
        status = draw_map(frame, geometry, lights, ms);
    frame->texel_count = frame->light_count;
    for (size_t i = 0; status == GPU_OK && i < scene->area_light_count; i++)
        frame->light_count += add_area_light(lights + frame->light_count, &scene->area_lights[i]);
    return status;
}
