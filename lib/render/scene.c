/* scene.c: a description as a whole. */
#include "scene.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/buffer.h"
#include "base/file.h"
#include "base/json.h"
#include "scene_private.h"

static char *name_of(const char *path)
{
    const char *slash = strrchr(path, '/'), *base = slash ? slash + 1 : path;
    const char *dot = strrchr(base, '.');
    return base_copy(base, dot && dot > base ? (size_t)(dot - base) : strlen(base));
}

static bool read_description(const cJSON *root, const char *path, const char *scene_dir,
                             render_scene *scene)
{
    static const char *const keys[] = {"meshes", "camera", "spot", "area_lights", "rsm_size", NULL};
    const scene_where where = {path, ""};
    static const char size_text[] = "a whole number from 1 to 128";
    double size = 16;
    if (!base_json_only(root, path, keys) ||
        !scene_number(root, &where, "rsm_size", size_text, 1, 128, &size))
        return false;
    if (size != floor(size))
        return scene_refuse(&where, "rsm_size", size_text,
                            cJSON_GetObjectItemCaseSensitive(root, "rsm_size"));
    scene->rsm_size = (int)size;
    return scene_read_area_lights(cJSON_GetObjectItemCaseSensitive(root, "area_lights"), path,
                                  scene) &&
           scene_read_meshes(cJSON_GetObjectItemCaseSensitive(root, "meshes"), path, scene_dir,
                             scene) &&
           scene_read_camera(cJSON_GetObjectItemCaseSensitive(root, "camera"), path, scene) &&
           scene_read_spot(cJSON_GetObjectItemCaseSensitive(root, "spot"), path, scene);
}

/* Where meshes are that are not beside the description; NULL: nowhere. */
static const char *folder_of(const char *scene_dir)
{
    if (!scene_dir || !scene_dir[0])
        scene_dir = getenv("SGFIT_SCENES");
    return scene_dir && scene_dir[0] ? scene_dir : NULL;
}

bool render_scene_is_there(const char *path, const char *scene_dir)
{
    cJSON *root = base_json_read(path);
    bool good = root && scene_has_meshes(cJSON_GetObjectItemCaseSensitive(root, "meshes"), path,
                                         folder_of(scene_dir));
    cJSON_Delete(root);
    return good;
}

bool render_scene_read(const char *path, const char *scene_dir, render_scene *scene)
{
    *scene = (render_scene){0};
    scene_dir = folder_of(scene_dir);
    cJSON *root = base_json_read(path);
    bool good = root && read_description(root, path, scene_dir, scene);
    cJSON_Delete(root);
    if (good)
        scene->name = name_of(path);
    else
        render_scene_free(scene);
    return good;
}

void render_scene_free(render_scene *scene)
{
    free(scene->name);
    free(scene->positions);
    free(scene->normals);
    free(scene->indices);
    free(scene->materials);
    free(scene->albedos);
    free(scene->area_lights);
    *scene = (render_scene){0};
}

char *render_scene_default(void)
{
    return base_join(base_source_root(), "tests/scenes/box.json");
}
