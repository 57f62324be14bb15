/* scene.h: what is rendered: triangles with a base colour each, a camera, a spotlight, area lights.
 *
 * Lengths are metres, colours linear, y is up where nothing else is said; rows of pixels run from
 * the top. */
#ifndef RENDER_SCENE_H
#define RENDER_SCENE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

typedef struct render_camera {
    double eye[3], target[3], up[3];
    double fov_y_deg, near, far;
} render_camera;

/* A point light that shines into a cone; its light reaches the surfaces through the reflective
 * shadow map only. */
typedef struct render_spot {
    double position[3], target[3];
    double angle_deg;    /* of the whole cone */
    double intensity[3]; /* W/sr */
} render_spot;

/* A flat convex polygon that emits to the side from which its vertices run counter-clockwise. */
enum { RENDER_MOST_CORNERS = 8 };
typedef struct render_area_light {
    int corner_count; /* 3 to RENDER_MOST_CORNERS */
    double corners[RENDER_MOST_CORNERS][3];
    double exitance[3]; /* W/m^2 */
} render_area_light;

typedef struct render_scene {
    char *name; /* of the description's file, without folder and ending */
    size_t vertex_count, triangle_count, material_count;
    size_t dropped_triangles; /* left out: without area, or with a corner that is not finite */
    float *positions;         /* 3 a vertex */
    float *normals;           /* 3 a vertex, of length 1 */
    uint32_t *indices;        /* 3 a triangle, below vertex_count */
    uint32_t *materials;      /* 1 a triangle, below material_count */
    float *albedos;           /* 3 a material, each in [0, 1] */
    double low[3], high[3];   /* bounds; 0 where there is no vertex */
    /* Everything here, and what is rendered of it, counts from this point of the description's
     * coordinates. 0 unless the middle of the bounds is more than 16 times as far away as they
     * reach from it (half their diagonal): the devices' floats would not do there. */
    double origin[3];
    render_camera camera;
    bool has_spot;
    render_spot spot;
    size_t area_light_count;
    render_area_light *area_lights;
    int rsm_size; /* texels a side of the reflective shadow map */
} render_scene;

/* Reads a description (JSON, see README). Meshes are read by a child process with a time limit, so
 * that a damaged file cannot take this process with it. scene_dir: searched for meshes that are
 * not beside the description; NULL: the environment's SGFIT_SCENES, or nowhere. False after one
 * line that names the file and what was expected; scene is then empty. */
bool render_scene_read(const char *path, const char *scene_dir, render_scene *scene);
void render_scene_free(render_scene *scene);

/* Whether every mesh that the description names is there, without reading any. False after one
 * line. */
bool render_scene_is_there(const char *path, const char *scene_dir);

/* The description that is used where none is given: tests/scenes/box.json; malloc'ed. */
char *render_scene_default(void);

/* Row-major matrices for column vectors; Vulkan's clip space (y down, depth 0 to 1). */
void render_camera_matrix(const render_camera *camera, double aspect, double matrix[4][4]);

#endif
