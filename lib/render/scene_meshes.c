/* scene_meshes.c: the "meshes" of a description. */
#include <float.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "base/buffer.h"
#include "base/file.h"
#include "base/json.h"
#include "base/text.h"
#include "scene_private.h"

/* Lengths beyond these are mistakes; float squares stay finite within. */
static const double longest = 1e15, shortest_scale = 1e-15;

/* The first of folder/name and scene_dir/name that is there, malloc'ed; NULL after one line. */
static char *find_file(const char *name, const scene_where *where, const char *scene_dir)
{
    if (name[0] == '/')
        return base_copy(name, strlen(name));
    const char *slash = strrchr(where->path, '/');
    buffer beside = {0};
    buffer_add_n(&beside, where->path, slash ? (size_t)(slash + 1 - where->path) : 0);
    buffer_add(&beside, name);
    if (access(beside.text, F_OK) == 0)
        return beside.text;
    buffer_free(&beside);
    char *elsewhere = scene_dir ? base_join(scene_dir, name) : NULL;
    if (elsewhere && access(elsewhere, F_OK) == 0)
        return elsewhere;
    free(elsewhere);
    if (scene_dir)
        base_error("%s: key \"%sfile\": %.200s is neither beside the description nor in %s",
                   where->path, where->prefix, name, scene_dir);
    else
        base_error(
            "%s: key \"%sfile\": %.200s is not beside the description; a folder of scenes is "
            "given by --scene-dir or SGFIT_SCENES",
            where->path, where->prefix, name);
    return NULL;
}

bool scene_has_meshes(const cJSON *list, const char *path, const char *scene_dir)
{
    scene_where where = {.path = path};
    size_t index = 0;
    for (const cJSON *item = list ? list->child : NULL; item; item = item->next) {
        const cJSON *file = cJSON_GetObjectItemCaseSensitive(item, "file");
        snprintf(where.prefix, sizeof where.prefix, "meshes[%zu].", index++);
        char *found = cJSON_IsString(file) ? find_file(file->valuestring, &where, scene_dir) : NULL;
        if (cJSON_IsString(file) && !found)
            return false;
        free(found);
    }
    return true;
}

static bool read_transform(const cJSON *item, const scene_where *where, scene_transform *transform)
{
    *transform = (scene_transform){.scale = {1, 1, 1}};
    static const char scale_text[] = "a number or 3, none of them 0, of at most 1e15";
    double degrees[3] = {0};
    if (!scene_three(item, where, "scale", scale_text, true, -longest, longest, transform->scale))
        return false;
    for (int i = 0; i < 3; i++)
        if (fabs(transform->scale[i]) < shortest_scale)
            return scene_refuse(where, "scale", scale_text,
                                cJSON_GetObjectItemCaseSensitive(item, "scale"));
    if (!scene_three(item, where, "rotate_deg", "3 angles in degrees", false, -1e6, 1e6, degrees))
        return false;
    scene_rotation(degrees, transform->rotation);
    return scene_three(item, where, "translate", "3 numbers of at most 1e15", false, -longest,
                       longest, transform->translation);
}

static bool read_mesh(const cJSON *item, const scene_where *where, const char *scene_dir,
                      scene_part *part)
{
    static const char *const keys[] = {"file", "scale", "rotate_deg", "translate", "albedo", NULL};
    if (!cJSON_IsObject(item))
        return scene_refuse(where, "", "an object", item);
    if (!base_json_only(item, where->path, keys))
        return false;
    const cJSON *file = cJSON_GetObjectItemCaseSensitive(item, "file");
    if (!cJSON_IsString(file) || !file->valuestring[0])
        return scene_refuse(where, "file", "the name of a mesh file", file);
    if (!read_transform(item, where, &part->transform) ||
        !scene_three(item, where, "albedo", "a number or 3, in [0, 1]", true, 0, 1, part->albedo))
        return false;
    char *path = find_file(file->valuestring, where, scene_dir);
    if (!path)
        return false;
    bool good = mesh_read(path, NULL, &part->from);
    part->has_albedo = scene_has(item, "albedo");
    free(path);
    return good;
}

static void find_bounds(render_scene *scene)
{
    for (int i = 0; i < 3; i++) {
        scene->low[i] = scene->vertex_count ? DBL_MAX : 0;
        scene->high[i] = scene->vertex_count ? -DBL_MAX : 0;
    }
    for (size_t i = 0; i < 3 * scene->vertex_count; i++) {
        scene->low[i % 3] = fmin(scene->low[i % 3], (double)scene->positions[i]);
        scene->high[i % 3] = fmax(scene->high[i % 3], (double)scene->positions[i]);
    }
}

/* The description bounds what it holds itself; this is for the files' coordinates as placed. Beyond
 * these radii the fourth powers of distances that the shaders meet leave the range of floats. */
static bool is_within(const render_scene *scene, const char *path)
{
    static const double smallest = 1e-6, largest = 2e9;
    double most = 0, centre[3], radius;
    for (int i = 0; i < 3; i++)
        most = fmax(most, fmax(fabs(scene->low[i] + scene->origin[i]),
                               fabs(scene->high[i] + scene->origin[i])));
    scene_sphere(scene, centre, &radius);
    if (!(most <= longest))
        base_error("%s: key \"meshes\": expected coordinates of at most %g m as placed in the "
                   "scene, found %.3g",
                   path, longest, most);
    else if (!(radius >= smallest && radius <= largest))
        base_error("%s: key \"meshes\": expected a scene that reaches %g to %g m from its middle "
                   "(\"scale\" changes that), found %.3g",
                   path, smallest, largest, radius);
    else
        return true;
    return false;
}

/* From their places in the description to those from the origin on. */
static bool add_all(scene_part *parts, size_t count, render_scene *scene)
{
    bool good = true;
    scene_find_origin(parts, count, scene->origin);
    for (size_t i = 0; i < scene->area_light_count; i++)
        for (int corner = 0; corner < scene->area_lights[i].corner_count; corner++)
            for (int k = 0; k < 3; k++)
                scene->area_lights[i].corners[corner][k] -= scene->origin[k];
    for (size_t i = 0; good && i < count; i++) {
        scene_part *part = &parts[i];
        for (int k = 0; k < 3; k++)
            part->transform.translation[k] -= scene->origin[k];
        good = scene_add_mesh(scene, &part->from, &part->transform,
                              part->has_albedo ? part->albedo : NULL);
        mesh_free(&part->from);
    }
    return good;
}

bool scene_read_meshes(const cJSON *list, const char *path, const char *scene_dir,
                       render_scene *scene)
{
    scene_where where = {.path = path};
    if (!cJSON_IsArray(list))
        return scene_refuse(&where, "meshes", "a list of meshes, which may be empty", list);
    size_t count = 0, most = (size_t)cJSON_GetArraySize(list);
    scene_part *parts = calloc(most + 1, sizeof *parts);
    bool good = parts != NULL;
    if (!parts)
        base_error("%s: out of memory", path);
    for (const cJSON *item = list->child; good && item; item = item->next) {
        snprintf(where.prefix, sizeof where.prefix, "meshes[%zu].", count);
        good = read_mesh(item, &where, scene_dir, &parts[count++]);
    }
    good = good && add_all(parts, count, scene);
    for (size_t i = 0; i < count; i++)
        mesh_free(&parts[i].from);
    free(parts);
    find_bounds(scene);
    return good && is_within(scene, path);
}
