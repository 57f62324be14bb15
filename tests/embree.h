/* embree.h: Embree's own tracer over a scene's triangles, for comparison. */
#ifndef TEST_EMBREE_H
#define TEST_EMBREE_H

#include <embree3/rtcore.h>
#include <stdbool.h>
#include <stdint.h>
#include <string.h>

#include "render/scene.h"

typedef struct embree_scene {
    RTCDevice device;
    RTCScene scene;
} embree_scene;

static inline embree_scene embree_open(const render_scene *triangles)
{
    embree_scene e = {.device = rtcNewDevice("threads=1")};
    e.scene = rtcNewScene(e.device);
    rtcSetSceneFlags(e.scene, RTC_SCENE_FLAG_ROBUST);
    RTCGeometry geometry = rtcNewGeometry(e.device, RTC_GEOMETRY_TYPE_TRIANGLE);
    size_t corners = 3 * triangles->vertex_count, indices = 3 * triangles->triangle_count;
    void *positions =
        rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                3 * sizeof(float), triangles->vertex_count);
    void *words = rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                          3 * sizeof(uint32_t), triangles->triangle_count);
    if (corners)
        memcpy(positions, triangles->positions, corners * sizeof(float));
    if (indices)
        memcpy(words, triangles->indices, indices * sizeof(uint32_t));
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(e.scene, geometry);
    rtcReleaseGeometry(geometry);
    rtcCommitScene(e.scene);
    return e;
}

static inline void embree_close(embree_scene *e)
{
    rtcReleaseScene(e->scene);
    rtcReleaseDevice(e->device);
}

/* The nearest triangle between 0 and far (in lengths of the direction), or UINT32_MAX; *at: how
 * far. */
static inline uint32_t embree_closest(const embree_scene *e, const float origin[3],
                                      const float direction[3], float far, float *at)
{
    struct RTCRayHit hit = {.ray = {.org_x = origin[0],
                                    .org_y = origin[1],
                                    .org_z = origin[2],
                                    .dir_x = direction[0],
                                    .dir_y = direction[1],
                                    .dir_z = direction[2],
                                    .tfar = far,
                                    .mask = UINT32_MAX},
                            .hit = {.geomID = RTC_INVALID_GEOMETRY_ID}};
    struct RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    rtcIntersect1(e->scene, &context, &hit);
    *at = hit.ray.tfar;
    return hit.hit.geomID == RTC_INVALID_GEOMETRY_ID ? UINT32_MAX : hit.hit.primID;
}

/* Nothing between two points, but for what the shaders skip (AREA_SKIPPED in
 * shaders/shadows/area.glsl). */
static inline bool embree_is_open(const embree_scene *e, const float origin[3], const float to[3])
{
    float from[3], along[3], at;
    for (int k = 0; k < 3; k++) {
        from[k] = origin[k] + 1e-4F * (to[k] - origin[k]);
        along[k] = (1 - 1e-4F) * (to[k] - origin[k]);
    }
    return embree_closest(e, from, along, 1, &at) == UINT32_MAX;
}

#endif
