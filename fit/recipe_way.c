/* recipe_way.c: the part of a recipe that may be tried in several ways. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/text.h"
#include "fit/recipe.h"

static const char *const spacing_names[] = {"log",  "sqrt",      "linear",    "shifted_log",
                                            "beta", "cos_theta", "terminator"};
static const char *const objective_names[] = {"least_squares", "minimax", "root"};

const char *recipe_spacing_name(recipe_spacing spacing)
{
    return spacing_names[spacing];
}

const char *recipe_objective_name(recipe_objective objective)
{
    return objective_names[objective];
}

static const cJSON *get(const cJSON *object, const char *key)
{
    return cJSON_GetObjectItemCaseSensitive(object, key);
}

/* The place of text among names[from..to), -1 after one line. */
static int choose(const char *path, const char *key, const char *text, const char *const *names,
                  int from, int to)
{
    char allowed[128] = "";
    for (int i = from; i < to; i++) {
        if (strcmp(names[i], text) == 0)
            return i;
        snprintf(allowed + strlen(allowed), sizeof allowed - strlen(allowed), "%s\"%s\"",
                 i == from ? "" : (i + 1 < to ? ", " : " or "), names[i]);
    }
    base_error("%s: key \"%s\": expected %s, found \"%.60s\"", path, key, allowed, text);
    return -1;
}

/* ---- Domain and grid ----------------------------------------------------------------------- */

static bool read_range(const char *path, const cJSON *domain, const char *key, double least,
                       double most, recipe_axis *axis)
{
    const cJSON *range = get(domain, key);
    const cJSON *from = cJSON_GetArrayItem(range, 0), *to = cJSON_GetArrayItem(range, 1);
    if (!cJSON_IsArray(range) || cJSON_GetArraySize(range) != 2 || !cJSON_IsNumber(from) ||
        !cJSON_IsNumber(to)) {
        base_error("%s: key \"domain.%s\": expected two numbers [from, to]", path, key);
        return false;
    }
    axis->from = from->valuedouble;
    axis->to = to->valuedouble;
    if (axis->from >= least && axis->to <= most && axis->from < axis->to)
        return true;
    base_error("%s: key \"domain.%s\": expected a domain that is not empty, %g <= from < to <= %g, "
               "found [%g, %g]",
               path, key, least, most, axis->from, axis->to);
    return false;
}

static bool read_domain(const recipe *r, const cJSON *domain, recipe_way *way)
{
    static const char *const keys[] = {"lambda", "beta", NULL};
    static const char *const root_keys[] = {"lambda", NULL};
    bool root = r->kind == RECIPE_ROOT;
    return recipe_object(r, "domain", domain, root ? root_keys : keys) &&
           read_range(r->path, domain, "lambda", 1e-12, 1e12, &way->lambda) &&
           (root || read_range(r->path, domain, "beta", 0.0, 180.0, &way->angle));
}

static bool read_axis(const recipe *r, const cJSON *grid, const char *key, int first, int end,
                      recipe_axis *axis)
{
    static const char *const keys[] = {"spacing", "count", NULL};
    const cJSON *object;
    const char *spacing;
    double count;
    if (!base_json_object(grid, r->path, key, &object) || !recipe_object(r, key, object, keys) ||
        !base_json_string(object, r->path, "spacing", &spacing) ||
        !base_json_f64(object, r->path, "count", &count))
        return false;
    int chosen = choose(r->path, "spacing", spacing, spacing_names, first, end);
    if (chosen < 0)
        return false;
    if (!(count >= 2.0 && count <= 20000.0) || count != floor(count)) {
        base_error("%s: key \"grid.%s.count\": expected a whole number from 2 to 20000, found %g",
                   r->path, key, count);
        return false;
    }
    axis->spacing = (recipe_spacing)chosen;
    axis->count = (size_t)count;
    return true;
}

static bool read_grid(const recipe *r, const cJSON *grid, recipe_way *way)
{
    static const char *const keys[] = {"lambda", "angle", NULL};
    if (!recipe_object(r, "grid", grid, keys) ||
        !read_axis(r, grid, "lambda", SPACING_LOG, SPACING_BETA, &way->lambda) ||
        !read_axis(r, grid, "angle", SPACING_BETA, SPACING_TERMINATOR + (r->form ? 1 : 0),
                   &way->angle))
        return false;
    if (way->angle.spacing == SPACING_TERMINATOR &&
        (way->angle.from != 0.0 || way->angle.to != 180.0)) {
        base_error("%s: key \"grid.angle.spacing\": expected \"terminator\" only with "
                   "\"domain.beta\" [0, 180]",
                   r->path);
        return false;
    }
    if ((double)way->lambda.count * (double)way->angle.count <= 2e6)
        return true;
    base_error("%s: key \"grid\": expected at most 2e6 samples, found %zu times %zu", r->path,
               way->lambda.count, way->angle.count);
    return false;
}

static bool read_allowed(const recipe *r, const cJSON *weights, recipe_way *way)
{
    if (!base_json_f64(weights, r->path, "absolute", &way->absolute) ||
        !base_json_f64(weights, r->path, "relative", &way->relative) ||
        !base_json_f64(weights, r->path, "down_to", &way->down_to))
        return false;
    if (r->form && way->absolute > 0.0 && way->relative > 0.0 && way->down_to >= 0.0)
        return true;
    base_error("%s: key \"weights\": expected \"absolute\", \"relative\" and \"down_to\" above 0, "
               "in a recipe of kind \"form\"",
               r->path);
    return false;
}

static bool read_weights(const recipe *r, const cJSON *weights, recipe_way *way)
{
    static const char *const keys[] = {"lambda", "value", "absolute", "relative", "down_to", NULL};
    way->weight_lambda = way->weight_value = way->absolute = way->relative = way->down_to = 0.0;
    if (cJSON_IsString(weights) && strcmp(weights->valuestring, "uniform") == 0)
        return true;
    if (!cJSON_IsObject(weights)) {
        base_error("%s: key \"weights\": expected \"uniform\" or an object with the powers "
                   "\"lambda\" and \"value\"",
                   r->path);
        return false;
    }
    return recipe_object(r, "weights", weights, keys) &&
           (!get(weights, "lambda") ||
            base_json_f64(weights, r->path, "lambda", &way->weight_lambda)) &&
           (!get(weights, "value") ||
            base_json_f64(weights, r->path, "value", &way->weight_value)) &&
           (!get(weights, "absolute") || read_allowed(r, weights, way));
}

/* ---- All of it ----------------------------------------------------------------------------- */

static bool read_objective(const recipe *r, const cJSON *object, recipe_way *way)
{
    const char *text;
    if (!base_json_string(object, r->path, "objective", &text))
        return false;
    bool root = r->kind == RECIPE_ROOT;
    int chosen = choose(r->path, "objective", text, objective_names, root ? RECIPE_SOLVE : 0,
                        root ? RECIPE_SOLVE + 1 : RECIPE_SOLVE);
    way->objective = (recipe_objective)chosen;
    return chosen >= 0;
}

static bool read_quantity(const recipe *r, const cJSON *object, recipe_way *way)
{
    static const char *const names[] = {"A_h", "L"};
    const char *text;
    if (!base_json_string(object, r->path, "quantity", &text))
        return false;
    int chosen = choose(r->path, "quantity", text, names, 0, 2);
    way->quantity = chosen == 0 ? SG_A_H : SG_L;
    return chosen >= 0;
}

/* A part that is missing is an error in a whole way only. */
static bool part(const recipe *r, const cJSON *object, const char *key, bool is_whole,
                 const cJSON **value)
{
    *value = get(object, key);
    if (*value || !is_whole)
        return true;
    base_error("%s: key \"%s\": expected it to be there", r->path, key);
    return false;
}

bool recipe_read_way(recipe *r, const cJSON *object, recipe_way *way, bool is_whole)
{
    const cJSON *item;
    bool root = r->kind == RECIPE_ROOT;
    if (is_whole && !root)
        recipe_name_coefficients(r, way);
    if (!part(r, object, "domain", is_whole, &item) || (item && !read_domain(r, item, way)) ||
        !part(r, object, "objective", is_whole, &item) || (item && !read_objective(r, object, way)))
        return false;
    if (root)
        return true;
    if (!part(r, object, "grid", is_whole, &item) || (item && !read_grid(r, item, way)) ||
        !part(r, object, "weights", is_whole, &item) || (item && !read_weights(r, item, way)) ||
        !part(r, object, "quantity", is_whole && r->form, &item) ||
        (item && !read_quantity(r, object, way)) || !part(r, object, "start", is_whole, &item))
        return false;
    return recipe_read_coefficients(r, object, way);
}
