/* scene_json.c: single values of a description. */
#include <math.h>
#include <stdlib.h>

#include "base/text.h"
#include "scene_private.h"

bool scene_refuse(const scene_where *where, const char *key, const char *expected,
                  const cJSON *found)
{
    char *text = found ? cJSON_PrintUnformatted(found) : NULL;
    base_error("%s: key \"%s%s\": expected %s, found %.60s", where->path, where->prefix, key,
               expected, text ? text : "nothing");
    free(text);
    return false;
}

bool scene_has(const cJSON *object, const char *key)
{
    return cJSON_GetObjectItemCaseSensitive(object, key) != NULL;
}

static bool is_number_in(const cJSON *item, double low, double high)
{
    return cJSON_IsNumber(item) && item->valuedouble >= low && item->valuedouble <= high;
}

bool scene_number(const cJSON *object, const scene_where *where, const char *key,
                  const char *expected, double low, double high, double *value)
{
    const cJSON *item = cJSON_GetObjectItemCaseSensitive(object, key);
    if (!item)
        return true;
    if (!is_number_in(item, low, high))
        return scene_refuse(where, key, expected, item);
    *value = item->valuedouble;
    return true;
}

bool scene_three(const cJSON *object, const scene_where *where, const char *key,
                 const char *expected, bool alone, double low, double high, double value[3])
{
    const cJSON *item = cJSON_GetObjectItemCaseSensitive(object, key);
    if (!item)
        return true;
    if (alone && is_number_in(item, low, high)) {
        value[0] = value[1] = value[2] = item->valuedouble;
        return true;
    }
    if (!cJSON_IsArray(item) || cJSON_GetArraySize(item) != 3)
        return scene_refuse(where, key, expected, item);
    for (int i = 0; i < 3; i++) {
        const cJSON *number = cJSON_GetArrayItem(item, i);
        if (!is_number_in(number, low, high))
            return scene_refuse(where, key, expected, item);
        value[i] = number->valuedouble;
    }
    return true;
}

bool scene_point(const cJSON *object, const scene_where *where, const char *key,
                 const render_scene *scene, double value[3])
{
    static const double longest = 1e15;
    if (!scene_has(object, key))
        return true;
    if (!scene_three(object, where, key, "3 numbers of at most 1e15", false, -longest, longest,
                     value))
        return false;
    for (int i = 0; i < 3; i++)
        value[i] -= scene->origin[i];
    return true;
}
