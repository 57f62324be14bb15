/* One diffuse bounce by tracing paths. */
#include "bounce.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/buffer.h"
#include "base/random.h"
#include "shadows.h"

void bounce_free(bounce *result)
{
    free(result->irradiance);
    free(result->variance);
    *result = (bounce){0};
}

#ifdef HAVE_EMBREE

#include <embree3/rtcore.h>
#include <pthread.h>
#include <stdatomic.h>
#include <unistd.h>

#include "internal.h"

static const double pi = 3.14159265358979323846;

typedef struct work {
    const render_scene *scene;
    RTCDevice device;
    RTCScene tree;
    bounce_options options;
    const render_area_light *lights;
    uint32_t width;
    float *position;   /* of the frame */
    uint32_t *normals; /* likewise */
    bounce *result;
    atomic_uint row;
} work;

static double dot(const double a[3], const double b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/* ---- Rays ----------------------------------------------------------------------------- */

static struct RTCRay ray_of(const double origin[3], const double along[3], double far)
{
    return (struct RTCRay){.org_x = (float)origin[0],
                           .org_y = (float)origin[1],
                           .org_z = (float)origin[2],
                           .dir_x = (float)along[0],
                           .dir_y = (float)along[1],
                           .dir_z = (float)along[2],
                           .tfar = (float)far,
                           .mask = UINT32_MAX};
}

static bool is_blocked(const work *w, const double origin[3], const double end[3])
{
    double along[3] = {end[0] - origin[0], end[1] - origin[1], end[2] - origin[2]};
    struct RTCRay ray = ray_of(origin, along, 1);
    struct RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    rtcOccluded1(w->tree, &context, &ray);
    return ray.tfar < 0;
}

/* Above a surface, as far as the shaders begin their rays (shaders/shadows/area.glsl). */
static void lift(const double position[3], const double face[3], double origin[3])
{
    double size = fmax(fabs(position[0]), fmax(fabs(position[1]), fabs(position[2])));
    for (int k = 0; k < 3; k++)
        origin[k] = position[k] + 1e-4 * size * face[k];
}

typedef struct hit {
    double position[3], normal[3], face[3];
    const float *albedo;
} hit;

/* What a ray meets first; both normals on the side that it comes from. */
static bool trace(const work *w, const double origin[3], const double along[3], hit *found)
{
    struct RTCRayHit query = {.ray = ray_of(origin, along, INFINITY),
                              .hit = {.geomID = RTC_INVALID_GEOMETRY_ID}};
    struct RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    rtcIntersect1(w->tree, &context, &query);
    if (query.hit.geomID == RTC_INVALID_GEOMETRY_ID)
        return false;
    const render_scene *s = w->scene;
    size_t triangle = query.hit.primID;
    double weights[3] = {1 - (double)query.hit.u - (double)query.hit.v, (double)query.hit.u,
                         (double)query.hit.v};
    double face[3] = {(double)query.hit.Ng_x, (double)query.hit.Ng_y, (double)query.hit.Ng_z};
    double size = sqrt(dot(face, face)), normal[3] = {0, 0, 0};
    size = dot(face, along) > 0 ? -size : size;
    for (size_t k = 0; k < 3; k++) {
        found->face[k] = face[k] / size;
        found->position[k] = 0;
        for (size_t i = 0; i < 3; i++) {
            size_t vertex = 3 * (size_t)s->indices[3 * triangle + i] + k;
            normal[k] += weights[i] * (double)s->normals[vertex];
            found->position[k] += weights[i] * (double)s->positions[vertex];
        }
    }
    size = sqrt(dot(normal, normal));
    size = dot(normal, found->face) < 0 ? -size : size;
    for (int k = 0; k < 3; k++)
        found->normal[k] = fabs(size) > 0.5 ? normal[k] / size : found->face[k];
    found->albedo = s->albedos + 3 * (size_t)s->materials[triangle];
    return true;
}

/* ---- Light ---------------------------------------------------------------------------- */

/* Adds albedo times the irradiance by one point of each light, from part number `part` of 16. */
static void add_reflected(const work *w, const hit *at, uint32_t part, uint64_t *random,
                          double sum[3])
{
    double origin[3];
    lift(at->position, at->face, origin);
    for (size_t l = 0; l < w->scene->area_light_count; l++) {
        const render_area_light *light = &w->scene->area_lights[l];
        double n[3], p[3], d[3], x = (part % 4 + base_uniform(random)) / 4,
                                 y = (part / 4 % 4 + base_uniform(random)) / 4;
        shadows_normal(light, n); /* times the area */
        shadows_point(light, x, y, p);
        for (int k = 0; k < 3; k++)
            d[k] = p[k] - at->position[k];
        double square = dot(d, d), facing = -dot(d, n), above = dot(d, at->normal);
        if (!(facing > 0 && above > 0 && dot(d, at->face) > 0))
            continue;
        double size = fmax(fabs(p[0]), fmax(fabs(p[1]), fabs(p[2])));
        for (int k = 0; k < 3; k++) /* a little in front of the light, which may be a surface too */
            p[k] += 1e-4 * size * n[k] / sqrt(dot(n, n));
        if (is_blocked(w, origin, p))
            continue;
        double factor = facing * above / (pi * square * square);
        for (int k = 0; k < 3; k++)
            sum[k] += (double)at->albedo[k] * light->exitance[k] * factor;
    }
}

/* With the density of the clamped cosine about n; x, y: of the unit square. */
static void cosine_direction(const double n[3], double x, double y, double along[3])
{
    double sign = n[2] < 0 ? -1 : 1, a = -1 / (sign + n[2]), b = n[0] * n[1] * a;
    const double s[3] = {1 + sign * n[0] * n[0] * a, sign * b, -sign * n[0]};
    const double t[3] = {b, sign + n[1] * n[1] * a, -n[1]};
    double radius = sqrt(x), c = radius * cos(2 * pi * y), d = radius * sin(2 * pi * y);
    for (int k = 0; k < 3; k++)
        along[k] = c * s[k] + d * t[k] + sqrt(fmax(1 - x, 0)) * n[k];
}

static void place(const work *w, size_t pixel, size_t at)
{
    double position[3], normal[3], face[3], origin[3], sum[3] = {0, 0, 0}, squares[3] = {0, 0, 0};
    float unpacked[2][3];
    const float *p = w->position + 4 * pixel;
    if (!(p[3] > 0))
        return;
    unpack_normal(w->normals[2 * pixel], unpacked[0]);
    unpack_normal(w->normals[2 * pixel + 1], unpacked[1]);
    for (int k = 0; k < 3; k++) {
        position[k] = (double)p[k];
        normal[k] = (double)unpacked[0][k];
        face[k] = (double)unpacked[1][k];
    }
    lift(position, face, origin);
    uint32_t paths = w->options.paths;
    uint64_t random = (uint64_t)at << 32;
    double turn[2] = {base_uniform(&random), base_uniform(&random)}, whole;
    for (uint32_t i = 0; i < paths; i++) {
        double along[3], one[3] = {0, 0, 0};
        hit found;
        /* even over the square, a sequence shifted from place to place */
        double x = modf(turn[0] + 0.75487766624669276 * i, &whole);
        double y = modf(turn[1] + 0.56984029099805327 * i, &whole);
        cosine_direction(normal, x, y, along);
        if (dot(along, face) > 0 && trace(w, origin, along, &found))
            add_reflected(w, &found, i, &random, one);
        for (int k = 0; k < 3; k++) {
            sum[k] += one[k];
            squares[k] += one[k] * one[k];
        }
    }
    for (size_t k = 0; k < 3; k++) {
        double mean = sum[k] / paths;
        w->result->irradiance[4 * at + k] = (float)mean;
        w->result->variance[3 * at + k] =
            (float)(fmax(squares[k] / paths - mean * mean, 0) / (paths - 1));
    }
    w->result->irradiance[4 * at + 3] = 1;
}

static void *rows(void *context)
{
    work *w = context;
    uint32_t step = w->options.step, y;
    while ((y = atomic_fetch_add(&w->row, 1)) < w->result->height)
        for (uint32_t x = 0; x < w->result->width; x++)
            place(w, (size_t)(y * step + step / 2) * w->width + x * step + step / 2,
                  (size_t)y * w->result->width + x);
    return NULL;
}

/* ---- All of it ------------------------------------------------------------------------ */

static void build(work *w)
{
    const render_scene *s = w->scene;
    w->device = rtcNewDevice("threads=1");
    w->tree = rtcNewScene(w->device);
    rtcSetSceneFlags(w->tree, RTC_SCENE_FLAG_ROBUST);
    RTCGeometry geometry = rtcNewGeometry(w->device, RTC_GEOMETRY_TYPE_TRIANGLE);
    void *positions = rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0,
                                              RTC_FORMAT_FLOAT3, 12, s->vertex_count);
    void *indices = rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                            12, s->triangle_count);
    if (positions && indices && s->triangle_count > 0) {
        memcpy(positions, s->positions, 12 * s->vertex_count);
        memcpy(indices, s->indices, 12 * s->triangle_count);
    }
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(w->tree, geometry);
    rtcReleaseGeometry(geometry);
    rtcCommitScene(w->tree);
}

static void run_threads(work *w)
{
    enum { MOST = 64 };
    long processors = w->options.threads ? (long)w->options.threads : sysconf(_SC_NPROCESSORS_ONLN);
    pthread_t threads[MOST];
    int started = 0;
    while (started + 1 < processors && started < MOST &&
           pthread_create(&threads[started], NULL, rows, w) == 0)
        started++;
    rows(w);
    for (int i = 0; i < started; i++)
        pthread_join(threads[i], NULL);
}

gpu_status bounce_render(render_frame *frame, const bounce_options *options, bounce *result)
{
    work w = {.scene = frame->scene, .options = *options, .width = frame->width, .result = result};
    size_t pixels = (size_t)frame->width * frame->height;
    w.options.step = options->step ? options->step : 1;
    w.options.paths = options->paths < 2 ? 2 : options->paths;
    *result =
        (bounce){.width = frame->width / w.options.step, .height = frame->height / w.options.step};
    size_t places = (size_t)result->width * result->height;
    w.position = base_allocate(pixels * 16);
    w.normals = base_allocate(pixels * 8);
    result->irradiance = base_allocate(places * 16 + 1);
    result->variance = base_allocate(places * 12 + 1);
    memset(result->irradiance, 0, places * 16);
    memset(result->variance, 0, places * 12);
    gpu_status status = gpu_image_read(frame->position, w.position);
    if (status == GPU_OK)
        status = gpu_image_read(frame->normal, w.normals);
    if (status == GPU_OK) {
        build(&w);
        run_threads(&w);
        rtcReleaseScene(w.tree);
        rtcReleaseDevice(w.device);
    } else {
        bounce_free(result);
    }
    free(w.position);
    free(w.normals);
    return status;
}

#else

gpu_status bounce_render(render_frame *frame, const bounce_options *options, bounce *result)
{
    (void)frame, (void)options;
    *result = (bounce){0};
    return gpu_fail(GPU_UNSUPPORTED,
                    "the reference of indirect light needs Embree, which this program was built "
                    "without");
}

#endif
