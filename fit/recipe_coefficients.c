/* recipe_coefficients.c: which coefficients of a form or curve a recipe fits, from where, and how.
 */
#include <math.h>
#include <string.h>

#include "base/text.h"
#include "fit/recipe.h"

static const cJSON *get(const cJSON *object, const char *key)
{
    return cJSON_GetObjectItemCaseSensitive(object, key);
}

static recipe_coefficient *find(recipe_way *way, const char *name)
{
    for (size_t i = 0; i < way->coefficient_count; i++)
        if (strcmp(way->coefficients[i].name, name) == 0)
            return &way->coefficients[i];
    return NULL;
}

static bool read_values(const recipe *r, const cJSON *object, const char *key, bool is_free,
                        recipe_way *way)
{
    if (!cJSON_IsObject(object)) {
        base_error("%s: key \"%s\": expected an object of coefficients", r->path, key);
        return false;
    }
    for (const cJSON *item = object->child; item; item = item->next) {
        recipe_coefficient *c = find(way, item->string);
        if (!c) {
            base_error("%s: key \"%s.%.60s\": expected a coefficient of %s", r->path, key,
                       item->string, r->form ? r->form->id : r->curve->id);
            return false;
        }
        if (!base_json_f64(object, r->path, item->string, &c->value))
            return false;
        if (!isfinite(c->value)) {
            base_error("%s: key \"%s.%s\": expected a finite number", r->path, key, item->string);
            return false;
        }
        c->free = is_free;
    }
    return true;
}

static bool read_bounds(const recipe *r, const cJSON *bounds, recipe_way *way)
{
    if (!cJSON_IsObject(bounds)) {
        base_error("%s: key \"bounds\": expected an object of [low, high]", r->path);
        return false;
    }
    for (const cJSON *item = bounds->child; item; item = item->next) {
        recipe_coefficient *c = find(way, item->string);
        const cJSON *low = cJSON_GetArrayItem(item, 0), *high = cJSON_GetArrayItem(item, 1);
        if (!c || !c->free || cJSON_GetArraySize(item) != 2 || !cJSON_IsNumber(low) ||
            !cJSON_IsNumber(high) || !(low->valuedouble < high->valuedouble) ||
            c->value < low->valuedouble || c->value > high->valuedouble) {
            base_error(
                "%s: key \"bounds.%.60s\": expected [low, high] around the start of a fitted "
                "coefficient",
                r->path, item->string);
            return false;
        }
        c->lower = low->valuedouble;
        c->upper = high->valuedouble;
    }
    return true;
}

/* What joins late must leave something to begin with. */
static bool read_later(const recipe *r, const cJSON *later, recipe_way *way)
{
    const cJSON *item;
    size_t left = 0;
    bool good = cJSON_IsArray(later);
    cJSON_ArrayForEach(item, later)
    {
        recipe_coefficient *c = cJSON_IsString(item) ? find(way, item->valuestring) : NULL;
        if (c && c->free && !c->later)
            c->later = true;
        else
            good = false;
    }
    for (size_t i = 0; i < way->coefficient_count; i++)
        left += way->coefficients[i].free && !way->coefficients[i].later;
    if (good && left > 0)
        return true;
    base_error(
        "%s: key \"later\": expected an array with some of the fitted coefficients, not all, "
        "each once",
        r->path);
    return false;
}

static bool check_coefficients(const recipe *r, const recipe_way *way)
{
    size_t free_count = 0;
    for (size_t i = 0; i < way->coefficient_count; i++) {
        if (isnan(way->coefficients[i].value)) {
            base_error("%s: key \"start\": expected the coefficient \"%s\" here or in \"fixed\"",
                       r->path, way->coefficients[i].name);
            return false;
        }
        free_count += way->coefficients[i].free;
    }
    if (free_count == 0)
        base_error("%s: key \"start\": expected at least one coefficient", r->path);
    return free_count > 0;
}

void recipe_name_coefficients(const recipe *r, recipe_way *way)
{
    size_t own = r->form ? (size_t)r->form->coefficient_count : r->curve->count;
    size_t count = own + (r->form ? 0 : r->curve->tied_count);
    way->coefficient_count = count;
    for (size_t i = 0; i < count; i++) {
        const char *name = r->form   ? r->form->coefficient_names[i]
                           : i < own ? r->curve->names[i]
                                     : r->curve->tied_names[i - own];
        way->coefficients[i] =
            (recipe_coefficient){name, false, NAN, false, -INFINITY, INFINITY, NAN, NAN, NULL};
    }
}

bool recipe_read_coefficients(const recipe *r, const cJSON *object, recipe_way *way)
{
    const cJSON *start = get(object, "start"), *fixed = get(object, "fixed");
    const cJSON *bounds = get(object, "bounds"), *later = get(object, "later");
    return (!start || read_values(r, start, "start", true, way)) &&
           (!fixed || read_values(r, fixed, "fixed", false, way)) &&
           (!bounds || read_bounds(r, bounds, way)) && (!later || read_later(r, later, way)) &&
           check_coefficients(r, way);
}
