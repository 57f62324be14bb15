/* scene_camera.c: the camera of a description, and its matrix. */
#include <math.h>
#include <string.h>

#include "base/json.h"
#include "scene_private.h"

static const double pi = 3.14159265358979323846, longest = 1e15;

void scene_sphere(const render_scene *scene, double centre[3], double *radius)
{
    double square = 0;
    for (int i = 0; i < 3; i++) {
        centre[i] = (scene->low[i] + scene->high[i]) / 2;
        square += pow((scene->high[i] - scene->low[i]) / 2, 2);
    }
    *radius = square > 0 ? sqrt(square) : 1;
}

static double distance(const double a[3], const double b[3])
{
    return sqrt(pow(a[0] - b[0], 2) + pow(a[1] - b[1], 2) + pow(a[2] - b[2], 2));
}

/* Whether up leaves the direction of the picture's upper side open. */
static bool is_along(const double up[3], const render_camera *camera)
{
    double view[3], across[3];
    for (int i = 0; i < 3; i++)
        view[i] = camera->target[i] - camera->eye[i];
    scene_cross(view, up, across);
    return !(scene_dot(across, across) > 1e-12 * scene_dot(view, view) * scene_dot(up, up));
}

/* Where the camera stands: eye and target that are not given follow from the bounds. */
static bool place(const cJSON *object, const scene_where *where, const render_scene *scene,
                  render_camera *camera)
{
    static const double from[3] = {0, 0.35, 0.93674969975975972}; /* of length 1 */
    double centre[3], radius;
    scene_sphere(scene, centre, &radius);
    double away = 1.1 * radius / sin(camera->fov_y_deg * pi / 360);
    memcpy(camera->target, centre, sizeof centre);
    if (!scene_point(object, where, "target", scene, camera->target))
        return false;
    for (int i = 0; i < 3; i++)
        camera->eye[i] = camera->target[i] + away * from[i];
    if (!scene_point(object, where, "eye", scene, camera->eye))
        return false;
    if (!scene_has(object, "target") && distance(camera->eye, camera->target) == 0)
        camera->target[2] -= radius;
    if (!(distance(camera->eye, camera->target) > 1e-9))
        return scene_refuse(
            where, "target",
            "another place than the eye, more than 1e-9 m away (smaller scenes are not taken)",
            cJSON_GetObjectItemCaseSensitive(object, "target"));
    double up[3] = {0, 1, 0};
    if (!scene_has(object, "up") && is_along(up, camera))
        up[1] = 0, up[2] = -1;
    if (!scene_three(object, where, "up", "3 numbers", false, -longest, longest, up))
        return false;
    if (is_along(up, camera))
        return scene_refuse(where, "up", "a direction that is not the one of sight",
                            cJSON_GetObjectItemCaseSensitive(object, "up"));
    memcpy(camera->up, up, sizeof up);
    return true;
}

bool scene_read_camera(const cJSON *object, const char *path, render_scene *scene)
{
    static const char *const keys[] = {"eye", "target", "up", "fov_y_deg", "near", "far", NULL};
    scene_where where = {path, ""};
    render_camera *camera = &scene->camera;
    *camera = (render_camera){.fov_y_deg = 45};
    if (object && !cJSON_IsObject(object))
        return scene_refuse(&where, "camera", "an object", object);
    if (object && !base_json_only(object, path, keys))
        return false;
    where = (scene_where){path, "camera."};
    if (!scene_number(object, &where, "fov_y_deg", "an angle above 0 and below 180 degrees", 1e-3,
                      179.999, &camera->fov_y_deg) ||
        !place(object, &where, scene, camera))
        return false;
    double centre[3], radius;
    scene_sphere(scene, centre, &radius);
    bool has_near = scene_has(object, "near"), has_far = scene_has(object, "far");
    camera->far = 1.05 * (distance(camera->eye, centre) + radius);
    if (!scene_number(object, &where, "far", "a distance above 0", 1e-9, longest, &camera->far))
        return false;
    camera->near = camera->far / 1000;
    if (!scene_number(object, &where, "near", "a distance above 0", 1e-9, longest, &camera->near))
        return false;
    if (has_near && !has_far && camera->far <= camera->near)
        camera->far = 1000 * camera->near; /* nothing is that far away */
    if (!(camera->near < camera->far))
        return scene_refuse(&where, "near", "a distance below that of \"far\"",
                            cJSON_GetObjectItemCaseSensitive(object, "near"));
    return true;
}

void render_camera_matrix(const render_camera *camera, double aspect, double matrix[4][4])
{
    double forward[3], right[3], up[3];
    for (int i = 0; i < 3; i++)
        forward[i] = camera->target[i] - camera->eye[i];
    scene_cross(forward, camera->up, right);
    double view = sqrt(scene_dot(forward, forward)), across = sqrt(scene_dot(right, right));
    for (int i = 0; i < 3; i++) {
        forward[i] /= view;
        right[i] /= across;
    }
    scene_cross(right, forward, up);
    double steep = tan(camera->fov_y_deg * pi / 360), far = camera->far,
           depth = far / (far - camera->near);
    for (int i = 0; i < 3; i++) {
        matrix[0][i] = right[i] / (steep * aspect);
        matrix[1][i] = -up[i] / steep;
        matrix[2][i] = depth * forward[i];
        matrix[3][i] = forward[i];
    }
    for (int i = 0; i < 4; i++)
        matrix[i][3] = -scene_dot(matrix[i], camera->eye);
    matrix[2][3] -= depth * camera->near;
}
