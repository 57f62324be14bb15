/* scene_lights.c: the spotlight and the area lights of a description. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/json.h"
#include "base/text.h"
#include "scene_private.h"

static const double pi = 3.14159265358979323846, longest = 1e15;
static const char power_text[] = "a number or 3, none of them negative, of at most 1e15";

/* The cone from position that holds the sphere of the bounds, within reason. */
static double angle_round(const double position[3], const double centre[3], double radius)
{
    double away[3] = {centre[0] - position[0], centre[1] - position[1], centre[2] - position[2]};
    double d = sqrt(scene_dot(away, away));
    return d > 1.05 * radius ? fmax(2 * asin(radius / d) * 180 / pi, 1) : 120;
}

bool scene_read_spot(const cJSON *object, const char *path, render_scene *scene)
{
    static const char *const keys[] = {"position", "target", "angle_deg", "intensity", NULL};
    static const double from[3] = {0.4, 0.8, 0.44721359549995793}; /* of length 1 */
    scene_where where = {path, ""};
    scene->has_spot = object ? !cJSON_IsNull(object) : scene->area_light_count == 0;
    if (!scene->has_spot)
        return true;
    if (object && !cJSON_IsObject(object))
        return scene_refuse(&where, "spot", "an object or null", object);
    if (object && !base_json_only(object, path, keys))
        return false;
    where = (scene_where){path, "spot."};
    render_spot *spot = &scene->spot;
    double centre[3], radius, along[3];
    scene_sphere(scene, centre, &radius);
    for (int i = 0; i < 3; i++) {
        spot->target[i] = centre[i];
        spot->position[i] = centre[i] + 2.5 * radius * from[i];
    }
    if (!scene_point(object, &where, "position", scene, spot->position) ||
        !scene_point(object, &where, "target", scene, spot->target))
        return false;
    for (int i = 0; i < 3; i++)
        along[i] = spot->target[i] - spot->position[i];
    if (!scene_has(object, "target") && scene_dot(along, along) == 0)
        along[1] = -radius, spot->target[1] -= radius;
    if (!(scene_dot(along, along) > 1e-18))
        return scene_refuse(&where, "target", "another place than the position",
                            cJSON_GetObjectItemCaseSensitive(object, "target"));
    spot->angle_deg = angle_round(spot->position, centre, radius);
    for (int i = 0; i < 3; i++)
        spot->intensity[i] = 10 * scene_dot(along, along);
    return scene_number(object, &where, "angle_deg", "an angle above 0 and below 180 degrees", 1e-3,
                        179.999, &spot->angle_deg) &&
           scene_three(object, &where, "intensity", power_text, true, 0, longest, spot->intensity);
}

/* Flat, convex and running round once: every turn goes to the left of the mean normal, and the
 * turns add up to one. */
static bool is_convex(const render_area_light *light)
{
    int n = light->corner_count;
    double normal[3] = {0}, turned = 0, size = 0, edge[RENDER_MOST_CORNERS][3];
    for (int i = 0; i < n; i++)
        for (int k = 0; k < 3; k++) {
            edge[i][k] = light->corners[(i + 1) % n][k] - light->corners[i][k];
            size = fmax(size, fabs(light->corners[i][k] - light->corners[0][k]));
        }
    for (int i = 1; i + 1 < n; i++) {
        double a[3], b[3], twice[3];
        for (int k = 0; k < 3; k++) {
            a[k] = light->corners[i][k] - light->corners[0][k];
            b[k] = light->corners[i + 1][k] - light->corners[0][k];
        }
        scene_cross(a, b, twice);
        for (int k = 0; k < 3; k++)
            normal[k] += twice[k];
    }
    double area = sqrt(scene_dot(normal, normal));
    if (!(area > 1e-9 * size * size) || !(area > 1e-30))
        return false;
    for (int i = 0; i < n; i++) {
        const double *before = edge[i], *after = edge[(i + 1) % n];
        double turn[3];
        scene_cross(before, after, turn);
        double sine = scene_dot(turn, normal) / area, cosine = scene_dot(before, after),
               scale = sqrt(scene_dot(before, before) * scene_dot(after, after));
        if (!(scale > 0) || sine < -1e-6 * scale ||
            fabs(scene_dot(before, normal)) > 1e-4 * area * size)
            return false;
        turned += atan2(sine, cosine);
    }
    return fabs(turned - 2 * pi) < 1e-3;
}

static bool read_corners(const cJSON *list, const scene_where *where, render_area_light *light)
{
    static const char expected[] = "3 to 8 corners, 3 numbers each, of a flat convex polygon";
    int count = cJSON_IsArray(list) ? cJSON_GetArraySize(list) : 0, i = 0;
    if (count < 3 || count > RENDER_MOST_CORNERS)
        return scene_refuse(where, "vertices", expected, list);
    light->corner_count = count;
    for (const cJSON *corner = list->child; corner; corner = corner->next, i++) {
        if (!cJSON_IsArray(corner) || cJSON_GetArraySize(corner) != 3)
            return scene_refuse(where, "vertices", expected, corner);
        int k = 0;
        for (const cJSON *number = corner->child; number; number = number->next, k++) {
            if (!cJSON_IsNumber(number) || !(fabs(number->valuedouble) <= longest))
                return scene_refuse(where, "vertices", expected, corner);
            light->corners[i][k] = number->valuedouble;
        }
    }
    return is_convex(light) || scene_refuse(where, "vertices", expected, list);
}

static bool read_area_light(const cJSON *item, const scene_where *where, render_area_light *light)
{
    static const char *const keys[] = {"vertices", "exitance", NULL};
    if (!cJSON_IsObject(item))
        return scene_refuse(where, "", "an object", item);
    if (!base_json_only(item, where->path, keys) ||
        !read_corners(cJSON_GetObjectItemCaseSensitive(item, "vertices"), where, light))
        return false;
    if (!scene_has(item, "exitance"))
        return scene_refuse(where, "exitance", power_text, NULL);
    return scene_three(item, where, "exitance", power_text, true, 0, longest, light->exitance);
}

bool scene_read_area_lights(const cJSON *list, const char *path, render_scene *scene)
{
    scene_where where = {path, ""};
    if (!list)
        return true;
    if (!cJSON_IsArray(list))
        return scene_refuse(&where, "area_lights", "a list of lights", list);
    size_t count = (size_t)cJSON_GetArraySize(list), index = 0;
    scene->area_lights = calloc(count + 1, sizeof *scene->area_lights);
    if (!scene->area_lights) {
        base_error("%s: out of memory", path);
        return false;
    }
    scene->area_light_count = count;
    for (const cJSON *item = list->child; item; item = item->next, index++) {
        snprintf(where.prefix, sizeof where.prefix, "area_lights[%zu].", index);
        if (!read_area_light(item, &where, &scene->area_lights[index]))
            return false;
    }
    return true;
}
