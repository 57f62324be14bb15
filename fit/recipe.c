#include "fit/recipe.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/file.h"
#include "base/text.h"

static const cJSON *get(const recipe *r, const char *key)
{
    return cJSON_GetObjectItemCaseSensitive(r->json, key);
}

bool recipe_object(const recipe *r, const char *key, const cJSON *value, const char *const *names)
{
    if (cJSON_IsObject(value))
        return base_json_only(value, r->path, names);
    base_error("%s: key \"%s\": expected an object", r->path, key);
    return false;
}

static bool read_kind(recipe *r)
{
    static const char *const common[] = {
        "id",   "title",      "kind",      "form",      "quantity", "domain",
        "grid", "weights",    "objective", "start",     "fixed",    "bounds",
        "seed", "iterations", "tolerance", "published", "tried",    "writes",
        "bars", "note",       "later",     NULL};
    static const char *const curve[] = {"id",     "title",   "kind",       "curve",     "domain",
                                        "grid",   "weights", "objective",  "start",     "fixed",
                                        "bounds", "seed",    "iterations", "tolerance", "published",
                                        "tried",  "note",    NULL};
    static const char *const root[] = {"id",      "title",     "kind",      "domain", "objective",
                                       "epsilon", "tolerance", "published", "note",   NULL};
    const char *kind, *name;
    if (!base_json_string(r->json, r->path, "kind", &kind))
        return false;
    if (strcmp(kind, "form") == 0) {
        r->kind = RECIPE_FORM;
        if (!base_json_only(r->json, r->path, common) ||
            !base_json_string(r->json, r->path, "form", &name))
            return false;
        r->form = sg_form_find(name);
        if (!r->form)
            base_error("%s: key \"form\": expected a form of shaders/forms, found \"%.60s\"",
                       r->path, name);
        return r->form != NULL;
    }
    if (strcmp(kind, "curve") == 0) {
        r->kind = RECIPE_CURVE;
        if (!base_json_only(r->json, r->path, curve) ||
            !base_json_string(r->json, r->path, "curve", &name))
            return false;
        r->curve = fit_curve_find(name);
        if (!r->curve)
            base_error("%s: key \"curve\": expected a curve of fit/curve.c, found \"%.60s\"",
                       r->path, name);
        return r->curve != NULL;
    }
    if (strcmp(kind, "root") == 0) {
        r->kind = RECIPE_ROOT;
        return base_json_only(r->json, r->path, root);
    }
    base_error("%s: key \"kind\": expected \"form\", \"curve\" or \"root\", found \"%.60s\"",
               r->path, kind);
    return false;
}

/* The file's name is the recipe's id, so that a command line names both. */
static bool read_names(recipe *r)
{
    if (!base_json_string(r->json, r->path, "id", &r->id) ||
        !base_json_string(r->json, r->path, "title", &r->title) ||
        (get(r, "note") && !base_json_string(r->json, r->path, "note", &r->note)))
        return false;
    const char *slash = strrchr(r->path, '/');
    const char *name = slash ? slash + 1 : r->path;
    size_t length = strlen(r->id);
    if (length > 0 && strncmp(name, r->id, length) == 0 && strcmp(name + length, ".json") == 0)
        return true;
    base_error("%s: key \"id\": expected the file's name without .json, found \"%.60s\"", r->path,
               r->id);
    return false;
}

static bool whole_number(const recipe *r, const char *key, double low, double high, double *value)
{
    if (!base_json_f64(r->json, r->path, key, value))
        return false;
    if (*value >= low && *value <= high && *value == floor(*value))
        return true;
    base_error("%s: key \"%s\": expected a whole number from %g to %g, found %g", r->path, key, low,
               high, *value);
    return false;
}

static bool positive(const recipe *r, const cJSON *object, const char *key, double *value)
{
    if (!base_json_f64(object, r->path, key, value))
        return false;
    if (*value > 0.0 && isfinite(*value))
        return true;
    base_error("%s: key \"%s\": expected a number above 0, found %g", r->path, key, *value);
    return false;
}

static bool read_tolerance(recipe *r)
{
    static const char *const keys[] = {"solver", "agreement", "repeat", NULL};
    static const char *const root_keys[] = {"repeat", NULL};
    const cJSON *tolerance;
    double seed = 0.0, iterations = 0.0;
    bool root = r->kind == RECIPE_ROOT;
    if (!base_json_object(r->json, r->path, "tolerance", &tolerance) ||
        !base_json_only(tolerance, r->path, root ? root_keys : keys) ||
        !positive(r, tolerance, "repeat", &r->repeat))
        return false;
    if (root)
        return positive(r, r->json, "epsilon", &r->epsilon);
    if (!positive(r, tolerance, "solver", &r->solver_tolerance) ||
        !positive(r, tolerance, "agreement", &r->agreement) ||
        !whole_number(r, "seed", 0.0, 4294967295.0, &seed) ||
        !whole_number(r, "iterations", 1.0, 1e6, &iterations))
        return false;
    r->seed = (uint64_t)seed;
    r->iterations = (int)iterations;
    return true;
}

static recipe_coefficient *fitted(recipe *r, const char *key, const char *name)
{
    for (size_t i = 0; i < r->way.coefficient_count; i++)
        if (strcmp(r->way.coefficients[i].name, name) == 0 && r->way.coefficients[i].free)
            return &r->way.coefficients[i];
    base_error("%s: key \"published.%s.%.60s\": expected a fitted coefficient", r->path, key, name);
    return NULL;
}

/* Bars go to the coefficients of the form or curve; the root has two of its own. */
static bool read_published(recipe *r)
{
    static const char *const keys[] = {"method", "bars", "beside", NULL};
    static const char *const beside_keys[] = {"value", "where", NULL};
    static const char *const root_names[] = {"cosine_sharpness", "alpha"};
    const cJSON *published = get(r, "published"), *bars;
    recipe_way *way = &r->way;
    if (r->kind == RECIPE_ROOT) {
        way->coefficient_count = 2;
        for (size_t i = 0; i < 2; i++)
            way->coefficients[i] = (recipe_coefficient){root_names[i], true, NAN, false, -INFINITY,
                                                        INFINITY,      NAN,  NAN, NULL};
    }
    if (!published)
        return true;
    if (!recipe_object(r, "published", published, keys) ||
        !base_json_string(published, r->path, "method", &r->published) ||
        !base_json_object(published, r->path, "bars", &bars))
        return false;
    for (const cJSON *item = bars->child; item; item = item->next) {
        recipe_coefficient *c = fitted(r, "bars", item->string);
        if (!c || !positive(r, bars, item->string, &c->bar))
            return false;
    }
    const cJSON *beside = cJSON_GetObjectItemCaseSensitive(published, "beside");
    for (const cJSON *item = beside ? beside->child : NULL; item; item = item->next) {
        recipe_coefficient *c = fitted(r, "beside", item->string);
        if (!c || !recipe_object(r, "published.beside", item, beside_keys) ||
            !base_json_f64(item, r->path, "value", &c->beside) ||
            !base_json_string(item, r->path, "where", &c->where))
            return false;
    }
    return true;
}

static bool read_writes(recipe *r)
{
    static const char *const keys[] = {"id", "title", "year", "variant", NULL};
    const cJSON *writes = get(r, "writes");
    double year;
    if (!writes)
        return true;
    if (!recipe_object(r, "writes", writes, keys) ||
        !base_json_string(writes, r->path, "id", &r->writes) ||
        !base_json_string(writes, r->path, "title", &r->writes_title) ||
        !base_json_f64(writes, r->path, "year", &year))
        return false;
    r->writes_year = (int)year;
    r->writes_variant = "refit";
    if (cJSON_GetObjectItemCaseSensitive(writes, "variant") &&
        !base_json_string(writes, r->path, "variant", &r->writes_variant))
        return false;
    if (strcmp(r->writes_variant, "refit") != 0 && strcmp(r->writes_variant, "tier") != 0) {
        base_error("%s: key \"writes.variant\": expected \"refit\" or \"tier\", found \"%.60s\"",
                   r->path, r->writes_variant);
        return false;
    }
    if (strspn(r->writes, "abcdefghijklmnopqrstuvwxyz0123456789_") != strlen(r->writes) ||
        !*r->writes) {
        base_error("%s: key \"writes.id\": expected small letters, digits and _, found \"%.60s\"",
                   r->path, r->writes);
        return false;
    }
    return true;
}

static bool read_bars(recipe *r)
{
    static const char *const keys[] = {"rmse", "max_abs", "rmse_f32", "max_abs_f32", NULL};
    double *const values[] = {&r->bar_rmse, &r->bar_max, &r->bar_rmse_f32, &r->bar_max_f32};
    const cJSON *bars = get(r, "bars");
    for (size_t i = 0; i < 4; i++)
        *values[i] = INFINITY;
    if (!bars)
        return true;
    if (!recipe_object(r, "bars", bars, keys))
        return false;
    for (size_t i = 0; i < 4; i++)
        if (cJSON_GetObjectItemCaseSensitive(bars, keys[i]) &&
            !positive(r, bars, keys[i], values[i]))
            return false;
    return true;
}

static bool read_tried(recipe *r)
{
    static const char *const keys[] = {"what",     "domain", "grid",  "weights", "objective",
                                       "quantity", "start",  "fixed", NULL};
    static const char *const curve_keys[] = {"what",      "domain", "grid",  "weights",
                                             "objective", "start",  "fixed", NULL};
    const cJSON *tried = get(r, "tried"), *item;
    if (!tried)
        return true;
    if (!cJSON_IsArray(tried)) {
        base_error("%s: key \"tried\": expected an array", r->path);
        return false;
    }
    r->tried = calloc((size_t)cJSON_GetArraySize(tried) + 1, sizeof *r->tried);
    if (!r->tried)
        return false;
    cJSON_ArrayForEach(item, tried)
    {
        recipe_way *way = &r->tried[r->tried_count++];
        *way = r->way;
        if (!recipe_object(r, "tried", item, r->form ? keys : curve_keys) ||
            !base_json_string(item, r->path, "what", &way->what) ||
            !recipe_read_way(r, item, way, false))
            return false;
    }
    return true;
}

bool recipe_read(recipe *r, const char *path)
{
    memset(r, 0, sizeof *r);
    r->path = malloc(strlen(path) + 1);
    if (!r->path)
        return false;
    memcpy(r->path, path, strlen(path) + 1);
    r->json = base_json_read(path);
    bool good = r->json && read_kind(r) && read_names(r) && read_tolerance(r) &&
                recipe_read_way(r, r->json, &r->way, true) && read_published(r) && read_writes(r) &&
                read_bars(r) && read_tried(r);
    if (!good)
        recipe_free(r);
    return good;
}

void recipe_free(recipe *r)
{
    free(r->tried);
    cJSON_Delete(r->json);
    free(r->path);
    memset(r, 0, sizeof *r);
}
