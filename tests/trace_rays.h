/* trace_rays.h: what the tests of tracing share: rays on the device, random triangles, rays that
 * are hard to decide, and whether a ray is one. */
#ifndef TRACE_RAYS_H
#define TRACE_RAYS_H

#include "pass_fixture.h"

#include <math.h>

#include "render/render.h"
#include "render/trace.h"

enum { RAYS = 100000 };

typedef struct ray_data {
    float origin[3], far, direction[3], zero;
} ray_data;

typedef struct hit_data {
    uint32_t triangle;
    float at;
} hit_data;

static uint64_t seed = 1;

static inline float uniform(void) /* 0 to 1 */
{
    seed = seed * 6364136223846793005u + 1442695040888963407u;
    return (float)(seed >> 40) * 0x1p-24f;
}

static inline void direction(float d[3])
{
    float z = 2 * uniform() - 1, angle = 6.2831853f * uniform(), r = sqrtf(1 - z * z);
    d[0] = r * cosf(angle);
    d[1] = r * sinf(angle);
    d[2] = z;
}

/* ---- On the device ------------------------------------------------------------------- */

typedef struct fixture {
    gpu_device *device;
    gpu_compute *compute;
} fixture;

static inline fixture open_fixture(void)
{
    static const gpu_binding bindings[] = {GPU_STORAGE_BUFFER, GPU_STORAGE_BUFFER,
                                           GPU_STORAGE_BUFFER, GPU_STORAGE_BUFFER};
    fixture f = {.device = open_software_device()};
    render_frame frame = {.device = f.device};
    must(render_compute(&frame, "trace/rays.comp", false, bindings, 4, 12, &f.compute));
    return f;
}

static inline void close_fixture(fixture *f)
{
    gpu_compute_destroy(f->compute);
    close_clean(f->device);
}

static inline double trace(fixture *f, const render_tracer *tracer, const ray_data *rays,
                           uint32_t count, bool any, hit_data *hits)
{
    gpu_buffer *in = make_buffer(f->device, count * sizeof *rays),
               *out = make_buffer(f->device, count * sizeof *hits);
    memcpy(gpu_buffer_map(in), rays, count * sizeof *rays);
    uint32_t push[3] = {tracer->root, count, any};
    double seconds;
    gpu_step step = {.name = "rays",
                     .compute = f->compute,
                     .resources = {tracer->nodes, tracer->triangles, in, out},
                     .push = push,
                     .groups = {(count + 63) / 64, 1, 1}};
    must(gpu_run(f->device, &step, 1, &seconds));
    memcpy(hits, gpu_buffer_map(out), count * sizeof *hits);
    gpu_buffer_destroy(in);
    gpu_buffer_destroy(out);
    return seconds;
}

/* ---- Scenes -------------------------------------------------------------------------- */

static inline render_scene soup(size_t triangles, float size)
{
    render_scene scene = {.vertex_count = 3 * triangles, .triangle_count = triangles};
    scene.positions = malloc(9 * triangles * sizeof(float) + 1);
    scene.indices = malloc(3 * triangles * sizeof(uint32_t) + 1);
    for (size_t t = 0; t < triangles; t++) {
        float centre[3] = {uniform(), uniform(), uniform()};
        float *p = scene.positions + 9 * t;
        for (int i = 0; i < 9; i++)
            p[i] = centre[i % 3] + size * (uniform() - 0.5f);
        if (t % 16 == 1) /* a line, a point, one seen twice, one in an axis' plane */
            memcpy(p + 6, p + 3, 12);
        if (t % 64 == 2)
            memcpy(p + 3, p, 12), memcpy(p + 6, p, 12);
        if (t % 32 == 3)
            memcpy(p, p - 9, 36);
        if (t % 8 == 4)
            p[1] = p[4] = p[7] = centre[1];
        for (uint32_t i = 0; i < 3; i++)
            scene.indices[3 * t + i] = (uint32_t)(3 * t) + i;
    }
    return scene;
}

static inline render_scene read_scene(const char *name)
{
    char path[1000];
    const char *root = getenv("SGFIT_ROOT");
    snprintf(path, sizeof path, "%s/tests/scenes/%s.json", root ? root : ".", name);
    render_scene scene;
    assert_true(render_scene_read(path, NULL, &scene));
    return scene;
}

static inline void corner(const render_scene *scene, size_t triangle, int i, float p[3])
{
    memcpy(p, scene->positions + 3 * scene->indices[3 * triangle + (size_t)i % 3], 12);
}

static inline double size_of(const render_scene *scene)
{
    double most = 0;
    for (size_t i = 0; i < 3 * scene->vertex_count; i++)
        most = fmax(most, fabs((double)scene->positions[i]));
    return most;
}

/* ---- Rays ---------------------------------------------------------------------------- */

static inline void weigh(const render_scene *scene, size_t t, const float weights[3], float p[3])
{
    float c[3];
    memset(p, 0, 12);
    for (int i = 0; i < 3; i++) {
        corner(scene, t, i, c);
        for (int k = 0; k < 3; k++)
            p[k] += weights[i] * c[k];
    }
}

static inline void inside(const render_scene *scene, size_t t, float p[3])
{
    float a = uniform(), b = uniform() * (1 - a);
    weigh(scene, t, (float[3]){a, b, 1 - a - b}, p);
}

static inline void towards(ray_data *ray, const float target[3])
{
    for (int k = 0; k < 3; k++)
        ray->direction[k] = target[k] - ray->origin[k];
}

static inline void adversary(const render_scene *scene, int kind, float size, ray_data *ray)
{
    size_t t = (size_t)((float)scene->triangle_count * uniform() * 0.999999f),
           other = (size_t)((float)scene->triangle_count * uniform() * 0.999999f);
    float a = uniform(), target[3], b[3], c[3];
    switch (kind) {
    case 1: /* through a point of an edge */
        weigh(scene, t, (float[3]){a, 1 - a, 0}, target);
        towards(ray, target);
        break;
    case 2: /* through a corner */
        corner(scene, t, 1, target);
        towards(ray, target);
        break;
    case 3: /* along an edge, from before it */
        corner(scene, t, 0, b);
        corner(scene, t, 1, c);
        for (int k = 0; k < 3; k++)
            ray->origin[k] = b[k] - a * (c[k] - b[k]), ray->direction[k] = c[k] - b[k];
        break;
    case 4: /* in a triangle's plane */
        inside(scene, t, ray->origin);
        inside(scene, t, target);
        towards(ray, target);
        break;
    case 5: /* from a surface anywhere */
        inside(scene, t, ray->origin);
        direction(ray->direction);
        break;
    case 6: /* from surface to surface, not beyond */
        inside(scene, t, ray->origin);
        inside(scene, other, target);
        towards(ray, target);
        ray->far = 0.999f;
        break;
    case 7: /* along an axis, from a corner's coordinates */
        corner(scene, t, 0, ray->origin);
        memset(ray->direction, 0, sizeof ray->direction);
        ray->direction[other % 3] = other % 2 ? 1 : -1;
        ray->origin[other % 3] -= ray->direction[other % 3] * 3 * size;
        break;
    default:
        break;
    }
    if (ray->direction[0] == 0 && ray->direction[1] == 0 && ray->direction[2] == 0)
        ray->direction[kind % 3] = 1;
}

static inline ray_data *make_rays(const render_scene *scene)
{
    ray_data *rays = calloc(RAYS, sizeof *rays);
    float size = (float)size_of(scene);
    for (int i = 0; i < RAYS; i++) {
        for (int k = 0; k < 3; k++)
            rays[i].origin[k] = size * 1.2f * (2 * uniform() - 1);
        direction(rays[i].direction);
        rays[i].far = i % 3 ? 1e30f : size * uniform();
        if (i % 2)
            adversary(scene, i / 2 % 8, size, &rays[i]);
    }
    return rays;
}

/* ---- Telling where the two may differ -------------------------------------------------- */

static inline double length_of(const double v[3])
{
    return sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
}

static inline void cross_of(const double a[3], const double b[3], double c[3])
{
    c[0] = a[1] * b[2] - a[2] * b[1];
    c[1] = a[2] * b[0] - a[0] * b[2];
    c[2] = a[0] * b[1] - a[1] * b[0];
}

static inline double dot_of(const double a[3], const double b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/* Distance between the ray's line and the line piece from p to q, from below: of a piece that
 * runs along the ray, that of its ends. */
static inline double edge_distance(const ray_data *ray, const float p[3], const float q[3])
{
    double d[3], e[3], w[3], least = INFINITY;
    for (int k = 0; k < 3; k++) {
        d[k] = (double)ray->direction[k];
        e[k] = (double)q[k] - (double)p[k];
        w[k] = (double)p[k] - (double)ray->origin[k];
    }
    double dd = dot_of(d, d), ee = dot_of(e, e), de = dot_of(d, e), across = dd * ee - de * de;
    double along[3] = {0, 1, 0};
    if (across > 0)
        along[2] = fmin(fmax((de * dot_of(d, w) - dd * dot_of(e, w)) / across, 0), 1);
    for (int i = 0; i < 3; i++) {
        double from[3], side[3];
        for (int k = 0; k < 3; k++)
            from[k] = w[k] + along[i] * e[k];
        cross_of(from, d, side);
        least = fmin(least, length_of(side) / sqrt(dd));
    }
    return least;
}

/* The ray meets the triangle within a tolerance of its start or end, or runs along its plane. */
static inline bool at_an_end(const render_scene *scene, size_t t, const ray_data *ray,
                             double tolerance)
{
    float c[3][3];
    double e[2][3], n[3], d[3], w[3];
    for (int i = 0; i < 3; i++)
        corner(scene, t, i, c[i]);
    for (int k = 0; k < 3; k++) {
        e[0][k] = (double)c[1][k] - (double)c[0][k];
        e[1][k] = (double)c[2][k] - (double)c[0][k];
        d[k] = (double)ray->direction[k];
        w[k] = (double)c[0][k] - (double)ray->origin[k];
    }
    cross_of(e[0], e[1], n);
    double size = length_of(n), step = length_of(d);
    if (!(size > 0))
        return false; /* a line: then an edge is near where anything is */
    double slope = dot_of(n, d) / size, height = dot_of(n, w) / size;
    if (fabs(slope) < 1e-5 * step && fabs(height) < tolerance)
        return true;
    return fabs(height) < tolerance ||
           (ray->far < 1e29f && fabs(height - slope * (double)ray->far) < tolerance);
}

static inline bool excused(const render_scene *scene, const ray_data *ray, double tolerance)
{
    for (size_t t = 0; t < scene->triangle_count; t++) {
        for (int i = 0; i < 3; i++) {
            float p[3], q[3];
            corner(scene, t, i, p);
            corner(scene, t, i + 1, q);
            if (edge_distance(ray, p, q) < tolerance)
                return true;
        }
        if (at_an_end(scene, t, ray, tolerance))
            return true;
    }
    return false;
}

#endif
