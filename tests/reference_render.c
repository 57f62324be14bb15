/* Rays by Embree, and what they hit. */
#include "reference_render.h"

#include <embree3/rtcore.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/progress.h"
#include "reference_vectors.h"

static const double pi = 3.14159265358979323846;

struct reference {
    const render_scene *scene;
    RTCDevice device;
    RTCScene tree;
};

/* ---- Rays ---------------------------------------------------------------------------------------
 */

reference *reference_open(const render_scene *scene)
{
    reference *from = calloc(1, sizeof *from);
    if (!from)
        return NULL;
    from->scene = scene;
    from->device = rtcNewDevice("threads=1");
    from->tree = rtcNewScene(from->device);
    rtcSetSceneFlags(from->tree, RTC_SCENE_FLAG_ROBUST);
    rtcSetSceneBuildQuality(from->tree, RTC_BUILD_QUALITY_HIGH);
    if (scene->triangle_count > 0) {
        RTCGeometry shape = rtcNewGeometry(from->device, RTC_GEOMETRY_TYPE_TRIANGLE);
        void *vertices = rtcSetNewGeometryBuffer(shape, RTC_BUFFER_TYPE_VERTEX, 0,
                                                 RTC_FORMAT_FLOAT3, 12, scene->vertex_count);
        void *indices = rtcSetNewGeometryBuffer(shape, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                                12, scene->triangle_count);
        memcpy(vertices, scene->positions, 12 * scene->vertex_count);
        memcpy(indices, scene->indices, 12 * scene->triangle_count);
        rtcCommitGeometry(shape);
        rtcAttachGeometry(from->tree, shape);
        rtcReleaseGeometry(shape);
    }
    rtcCommitScene(from->tree);
    return from;
}

void reference_close(reference *from)
{
    if (from) {
        rtcReleaseScene(from->tree);
        rtcReleaseDevice(from->device);
    }
    free(from);
}

/* The triangle that a ray meets first between two parameters, SIZE_MAX: none. */
static size_t first_hit(const reference *from, const double eye[3], const double along[3],
                        double near, double far)
{
    struct RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    struct RTCRayHit ray = {.ray = {.org_x = (float)eye[0],
                                    .org_y = (float)eye[1],
                                    .org_z = (float)eye[2],
                                    .dir_x = (float)along[0],
                                    .dir_y = (float)along[1],
                                    .dir_z = (float)along[2],
                                    .tnear = (float)near,
                                    .tfar = (float)far,
                                    .mask = ~0u},
                            .hit = {.geomID = RTC_INVALID_GEOMETRY_ID}};
    rtcIntersect1(from->tree, &context, &ray);
    return ray.hit.geomID == RTC_INVALID_GEOMETRY_ID ? SIZE_MAX : ray.hit.primID;
}

/* The hit in double: the ray meets the plane of the triangle that Embree named. */
static void describe_hit(const render_scene *scene, size_t triangle, const double eye[3],
                         const double along[3], reference_pixel *pixel)
{
    double p[3][3], n[3][3], side[2][3], weights[3], part[3];
    for (size_t k = 0; k < 3; k++)
        for (size_t i = 0; i < 3; i++) {
            size_t at = 3 * (size_t)scene->indices[3 * triangle + k] + i;
            p[k][i] = (double)scene->positions[at];
            n[k][i] = (double)scene->normals[at];
        }
    subtract(p[1], p[0], side[0]);
    subtract(p[2], p[0], side[1]);
    cross(side[0], side[1], pixel->face);
    double area = normalise(pixel->face), to_plane[3];
    subtract(p[0], eye, to_plane);
    pixel->depth = dot(to_plane, pixel->face) / dot(along, pixel->face);
    for (int i = 0; i < 3; i++)
        pixel->position[i] = eye[i] + pixel->depth * along[i];
    for (int k = 0; k < 3; k++) { /* areas of the three parts, signed */
        double a[3], b[3];
        subtract(p[(k + 1) % 3], pixel->position, a);
        subtract(p[(k + 2) % 3], pixel->position, b);
        cross(a, b, part);
        weights[k] = dot(part, pixel->face) / area;
    }
    for (int i = 0; i < 3; i++)
        pixel->normal[i] = weights[0] * n[0][i] + weights[1] * n[1][i] + weights[2] * n[2][i];
    normalise(pixel->normal);
    double behind = dot(pixel->face, along) > 0 ? -1 : 1;
    double same_side = behind * dot(pixel->normal, pixel->face) < 0 ? -1 : 1;
    for (int i = 0; i < 3; i++) {
        pixel->face[i] *= behind;
        pixel->normal[i] *= same_side;
        pixel->albedo[i] = scene->albedos[3 * (size_t)scene->materials[triangle] + (size_t)i];
    }
}

typedef struct view_job {
    const reference *from;
    const render_camera *camera;
    int width, height;
    double forward[3], right[3], up[3], steep;
    reference_pixel *pixels;
} view_job;

static void view_row(void *context, size_t row)
{
    const view_job *job = context;
    for (int x = 0; x < job->width; x++) {
        reference_pixel *pixel = &job->pixels[row * (size_t)job->width + (size_t)x];
        double along[3]; /* of length 1 along the view axis: its parameter is the depth */
        double s = (2 * (x + 0.5) / job->width - 1) * job->steep * job->width / job->height,
               t = (1 - 2 * ((double)row + 0.5) / job->height) * job->steep;
        for (int i = 0; i < 3; i++)
            along[i] = job->forward[i] + s * job->right[i] + t * job->up[i];
        *pixel = (reference_pixel){0};
        size_t triangle =
            first_hit(job->from, job->camera->eye, along, job->camera->near, job->camera->far);
        if (triangle != SIZE_MAX)
            describe_hit(job->from->scene, triangle, job->camera->eye, along, pixel);
    }
}

void reference_view(reference *from, const render_camera *camera, int width, int height,
                    reference_pixel *pixels)
{
    view_job job = {.from = from,
                    .camera = camera,
                    .width = width,
                    .height = height,
                    .steep = tan(camera->fov_y_deg / 2 * pi / 180),
                    .pixels = pixels};
    subtract(camera->target, camera->eye, job.forward);
    normalise(job.forward);
    cross(job.forward, camera->up, job.right);
    normalise(job.right);
    cross(job.right, job.forward, job.up);
    base_parallel((size_t)height, view_row, &job);
}

const render_scene *reference_scene(const reference *from)
{
    return from->scene;
}
