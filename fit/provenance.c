/* provenance.c: how a constant came to be, as JSON without paths, dates or hosts. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "fit/constants_file.h"

static cJSON *pair(double a, double b)
{
    cJSON *array = cJSON_CreateArray();
    cJSON_AddItemToArray(array, base_json_number(a));
    cJSON_AddItemToArray(array, base_json_number(b));
    return array;
}

static void add_axis(cJSON *object, const char *key, const recipe_axis *axis)
{
    cJSON *grid = cJSON_AddObjectToObject(object, key);
    cJSON_AddStringToObject(grid, "spacing", recipe_spacing_name(axis->spacing));
    base_json_add_f64(grid, "count", (double)axis->count);
}

static void add_domain(cJSON *object, const recipe *r, const recipe_way *way)
{
    cJSON *domain = cJSON_AddObjectToObject(object, "domain");
    cJSON_AddItemToObject(domain, "lambda", pair(way->lambda.from, way->lambda.to));
    if (r->kind == RECIPE_ROOT)
        return;
    cJSON_AddItemToObject(domain, "beta", pair(way->angle.from, way->angle.to));
    cJSON *grid = cJSON_AddObjectToObject(object, "grid");
    add_axis(grid, "lambda", &way->lambda);
    add_axis(grid, "angle", &way->angle);
    if (way->weight_lambda == 0.0 && way->weight_value == 0.0 && way->absolute == 0.0) {
        cJSON_AddStringToObject(object, "weights", "uniform");
        return;
    }
    cJSON *weights = cJSON_AddObjectToObject(object, "weights");
    if (way->absolute > 0.0) {
        base_json_add_f64(weights, "absolute", way->absolute);
        base_json_add_f64(weights, "relative", way->relative);
        base_json_add_f64(weights, "down_to", way->down_to);
        return;
    }
    base_json_add_f64(weights, "lambda", way->weight_lambda);
    base_json_add_f64(weights, "value", way->weight_value);
}

static void add_coefficients(cJSON *object, const char *key, const recipe_way *way, bool is_free)
{
    cJSON *list = NULL;
    for (size_t i = 0; i < way->coefficient_count; i++) {
        const recipe_coefficient *c = &way->coefficients[i];
        if (c->free != is_free)
            continue;
        if (!list)
            list = cJSON_AddObjectToObject(object, key);
        base_json_add_f64(list, c->name, c->value);
    }
}

static void add_later(cJSON *object, const recipe_way *way)
{
    cJSON *list = NULL;
    for (size_t i = 0; i < way->coefficient_count; i++) {
        if (!way->coefficients[i].later)
            continue;
        if (!list)
            list = cJSON_AddArrayToObject(object, "later");
        cJSON_AddItemToArray(list, cJSON_CreateString(way->coefficients[i].name));
    }
}

static void add_solvers(cJSON *object, const recipe_way *way, const way_result *result)
{
    cJSON *list = cJSON_AddArrayToObject(object, "solvers");
    for (int i = 0; i < result->solver_count; i++) {
        const fit_result *s = &result->solvers[i];
        cJSON *one = cJSON_CreateObject();
        cJSON_AddItemToArray(list, one);
        cJSON_AddStringToObject(one, "solver", s->solver);
        cJSON_AddStringToObject(one, "status", s->status);
        base_json_add_f64(one, "iterations", (double)s->iterations);
        if (way->objective != RECIPE_SOLVE)
            base_json_add_f64(one, way->objective == RECIPE_MINIMAX ? "largest" : "mean_square",
                              s->objective);
    }
    if (result->solver_count > 1)
        base_json_add_f64(object, "disagreement", result->disagreement);
}

static void add_score(cJSON *object, const score_result *score)
{
    base_json_add_f64(object, "rmse", score->rmse);
    base_json_add_f64(object, "max_abs", score->max_abs);
    base_json_add_f64(object, "max_abs_lambda", score->max_abs_lambda);
    base_json_add_f64(object, "max_abs_beta", score->max_abs_beta);
}

/* What is compared with what was published, fitted coefficients only. */
static cJSON *comparison(const constants_set *set, const recipe *r, const recipe_result *whole)
{
    const way_result *result = &whole->own;
    cJSON *list = cJSON_CreateObject();
    for (size_t i = 0; i < r->way.coefficient_count; i++) {
        const recipe_coefficient *c = &r->way.coefficients[i];
        double published, ours = result->coefficients[i];
        if (!c->free || !constants_published(set, r->published, c->name, &published))
            continue;
        cJSON *one = cJSON_AddObjectToObject(list, c->name);
        base_json_add_f64(one, "published", published);
        base_json_add_f64(one, "ours", ours);
        base_json_add_f64(one, "difference", ours - published);
        base_json_add_f64(one, "relative", fabs(ours - published) / fabs(published));
        if (!isnan(c->bar))
            base_json_add_f64(one, "bar", c->bar);
        if (!c->where || !whole->has_beside)
            continue;
        cJSON *beside = cJSON_AddObjectToObject(one, "beside");
        base_json_add_f64(beside, "value", c->beside);
        cJSON_AddStringToObject(beside, "where", c->where);
        base_json_add_f64(beside, "max_abs", whole->score_beside.max_abs);
        base_json_add_f64(beside, "max_abs_published", whole->score_published.max_abs);
    }
    return list;
}

static cJSON *tried(const constants_set *set, const recipe *r, const recipe_result *result)
{
    cJSON *list = cJSON_CreateArray();
    for (size_t i = 0; i < r->tried_count; i++) {
        const recipe_way *way = &r->tried[i];
        cJSON *one = cJSON_CreateObject();
        cJSON_AddItemToArray(list, one);
        cJSON_AddStringToObject(one, "what", way->what);
        add_domain(one, r, way);
        cJSON_AddStringToObject(one, "objective", recipe_objective_name(way->objective));
        add_coefficients(one, "fixed", way, false);
        add_solvers(one, way, &result->tried[i]);
        cJSON *constants = cJSON_AddObjectToObject(one, "constants");
        for (size_t k = 0; k < way->coefficient_count; k++) {
            double published;
            if (!way->coefficients[k].free ||
                !constants_published(set, r->published, way->coefficients[k].name, &published))
                continue;
            base_json_add_f64(constants, way->coefficients[k].name,
                              result->tried[i].coefficients[k]);
        }
        base_json_add_f64(one, "rms", result->tried[i].rms);
    }
    return list;
}

cJSON *provenance_of(const constants_set *set, const recipe *r, const recipe_result *result)
{
    cJSON *p = cJSON_CreateObject();
    char command[128];
    snprintf(command, sizeof command, "sgfit fit %s", r->id);
    cJSON_AddStringToObject(p, "recipe", r->id);
    cJSON_AddStringToObject(p, "command", command);
    if (r->form)
        cJSON_AddStringToObject(p, "form", r->form->id);
    if (r->curve) {
        cJSON_AddStringToObject(p, "curve", r->curve->id);
        cJSON_AddStringToObject(p, "shape", r->curve->shape->what);
    }
    cJSON_AddStringToObject(p, "objective", recipe_objective_name(r->way.objective));
    if (r->form)
        cJSON_AddStringToObject(p, "quantity", r->way.quantity == SG_L ? "L" : "A_h");
    add_domain(p, r, &r->way);
    if (r->kind == RECIPE_ROOT) {
        base_json_add_f64(p, "epsilon", r->epsilon);
    } else {
        add_coefficients(p, "start", &r->way, true);
        add_coefficients(p, "fixed", &r->way, false);
        add_later(p, &r->way);
        base_json_add_f64(p, "seed", (double)r->seed);
        base_json_add_f64(p, "samples", (double)result->own.samples);
    }
    cJSON *tolerance = cJSON_AddObjectToObject(p, "tolerance");
    if (r->kind != RECIPE_ROOT) {
        base_json_add_f64(tolerance, "solver", r->solver_tolerance);
        base_json_add_f64(tolerance, "agreement", r->agreement);
    }
    base_json_add_f64(tolerance, "repeat", r->repeat);
    add_solvers(p, &r->way, &result->own);
    if (r->kind != RECIPE_ROOT) {
        base_json_add_f64(p, "residual_rms", result->own.rms);
        base_json_add_f64(p, "residual_max", result->own.largest);
    }
    if (r->published)
        cJSON_AddItemToObject(p, "constants", comparison(set, r, result));
    if (result->scored)
        add_score(p, &result->score_f64);
    if (r->tried_count > 0)
        cJSON_AddItemToObject(p, "tried", tried(set, r, result));
    if (r->note)
        cJSON_AddStringToObject(p, "note", r->note);
    return p;
}
