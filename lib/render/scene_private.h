/* scene_private.h: between the files that read scenes. */
#ifndef RENDER_SCENE_PRIVATE_H
#define RENDER_SCENE_PRIVATE_H

#include <cjson/cJSON.h>

#include "mesh.h"
#include "scene.h"

/* ---- Values of the description ------------------------------------------------------------------
 */

/* Where in which file a value stands: prefix is "", "camera." or "meshes[2].". */
typedef struct scene_where {
    const char *path;
    char prefix[48];
} scene_where;

/* One line: `PATH: key "PREFIXKEY": expected EXPECTED, found VALUE`; returns false. */
bool scene_refuse(const scene_where *where, const char *key, const char *expected,
                  const cJSON *found);

/* An absent key leaves the value as it is; False after one line where it is anything but a number
 * in [low, high]. */
bool scene_number(const cJSON *object, const scene_where *where, const char *key,
                  const char *expected, double low, double high, double *value);

/* Three numbers, each in [low, high]; with alone, one number stands for all three. */
bool scene_three(const cJSON *object, const scene_where *where, const char *key,
                 const char *expected, bool alone, double low, double high, double value[3]);

/* A point of at most 1e15, from the scene's origin on. */
bool scene_point(const cJSON *object, const scene_where *where, const char *key,
                 const render_scene *scene, double value[3]);

bool scene_has(const cJSON *object, const char *key);

/* ---- Parts --------------------------------------------------------------------------------------
 */

/* Reads the meshes of the list, finds the origin, moves the area lights there and adds triangles.
 */
bool scene_read_meshes(const cJSON *list, const char *path, const char *scene_dir,
                       render_scene *scene);

/* Whether the files of that list are there. False after one line. */
bool scene_has_meshes(const cJSON *list, const char *path, const char *scene_dir);

/* This goes before scene_read_meshes; corners are the description's. */
bool scene_read_area_lights(const cJSON *list, const char *path, render_scene *scene);

/* These follow scene_read_meshes: what is not given follows from the bounds. object: NULL where the
 * key is absent. */
bool scene_read_camera(const cJSON *object, const char *path, render_scene *scene);
bool scene_read_spot(const cJSON *object, const char *path, render_scene *scene);

/* Centre and radius of a sphere round the bounds; 0 and 1 for an empty scene. */
void scene_sphere(const render_scene *scene, double centre[3], double *radius);

/* ---- Building -----------------------------------------------------------------------------------
 */

/* p' = rotation * (scale * p) + translation */
typedef struct scene_transform {
    double scale[3], rotation[3][3], translation[3];
} scene_transform;

/* A mesh that is read, and how it comes into the scene. */
typedef struct scene_part {
    mesh from;
    scene_transform transform;
    bool has_albedo; /* in place of the materials' */
    double albedo[3];
} scene_part;

/* The place of a vertex by the transform. */
void scene_move(const scene_transform *transform, const float from[3], double to[3]);

/* render_scene.origin for these meshes: the middle of their bounds where it is far away, rounded to
 * a power of ten that is not below their radius, so that whole numbers stay whole and a scene that
 * was moved by a round number comes out as it was. */
void scene_find_origin(const scene_part *parts, size_t count, double origin[3]);

void scene_rotation(const double degrees[3], double rotation[3][3]);

/* Adds a mesh, transformed; albedo: NULL, or instead of the materials'. Triangles without area or
 * with a corner that is not finite are left out and counted. Vertices that no triangle uses are
 * left out. Vertices without a normal get smooth ones, the mean of their triangles' weighted by
 * area, with edges where triangles meet at more than 60 degrees. */
bool scene_add_mesh(render_scene *scene, const mesh *from, const scene_transform *transform,
                    const double *albedo);

/* A mesh on its way: transformed, its triangles chosen. */
typedef struct made_vertex {
    uint32_t vertex; /* whose position this is */
    float normal[3];
} made_vertex;

typedef struct moved_mesh {
    size_t vertex_count, triangle_count, made_count;
    float *positions, *normals;    /* of vertex_count; normals of length 1, or 0: none */
    uint32_t *corners, *materials; /* of the triangles that stay, below vertex_count */
    uint32_t *indices;             /* of the same corners, below made_count */
    made_vertex *made;             /* room for one a corner */
} moved_mesh;

/* Fills made and indices. False without memory. */
bool scene_make_vertices(moved_mesh *m);

/* Twice the area, as a vector; false where the triangle is none that can be drawn. */
bool scene_triangle_area(const float *positions, const uint32_t corners[3], double area[3]);

/* ---- Vectors ------------------------------------------------------------------------------------
 */

static inline double scene_dot(const double a[3], const double b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static inline void scene_cross(const double a[3], const double b[3], double result[3])
{
    result[0] = a[1] * b[2] - a[2] * b[1];
    result[1] = a[2] * b[0] - a[0] * b[2];
    result[2] = a[0] * b[1] - a[1] * b[0];
}

#endif
