#include "fit/fit_table.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/text.h"

/* ---- Scoring ------------------------------------------------------------------------------- */

/* All coefficients of the form that the recipe's constants belong to: ours where fitted. */
static const sg_form *complete(const constants_set *set, const recipe *r, const way_result *own,
                               double *k)
{
    const sg_form *form = r->form;
    const cJSON *file = constants_set_find(set, r->published);
    if (!form) {
        const cJSON *id = cJSON_GetObjectItemCaseSensitive(file, "form");
        form = cJSON_IsString(id) ? sg_form_find(id->valuestring) : NULL;
        if (!form || form->coefficient_count > FIT_MOST_PARAMETERS ||
            !constants_coefficients(set, file, form, k))
            return NULL;
    }
    for (int i = 0; i < form->coefficient_count; i++)
        for (size_t j = 0; j < r->way.coefficient_count; j++)
            if (strcmp(form->coefficient_names[i], r->way.coefficients[j].name) == 0)
                k[i] = own->coefficients[j];
    return form;
}

/* What the other print of a constant costs. */
static void score_beside(const constants_set *set, const recipe *r, recipe_result *result)
{
    const cJSON *file = constants_set_find(set, r->published);
    const cJSON *id = cJSON_GetObjectItemCaseSensitive(file, "form");
    const sg_form *form = cJSON_IsString(id) ? sg_form_find(id->valuestring) : NULL;
    double k[FIT_MOST_PARAMETERS], infinity = (double)INFINITY;
    bool any = false;
    if (!form || form->coefficient_count > FIT_MOST_PARAMETERS ||
        !constants_coefficients(set, file, form, k))
        return;
    score_form(form, k, 0.0, infinity, SCORE_F64, &result->score_published);
    for (size_t i = 0; i < r->way.coefficient_count; i++) {
        const recipe_coefficient *c = &r->way.coefficients[i];
        for (int j = 0; c->where && j < form->coefficient_count; j++) {
            if (strcmp(form->coefficient_names[j], c->name) == 0) {
                k[j] = c->beside;
                any = true;
            }
        }
    }
    if (any)
        score_form(form, k, 0.0, infinity, SCORE_F64, &result->score_beside);
    result->has_beside = any;
}

static void hold(const recipe *r, recipe_result *result, const char *what, double value, double bar)
{
    if (!(value <= bar))
        recipe_fail(result, "%s: %s is %.4g, expected at most %.4g", r->id, what, value, bar);
}

void fit_score_recipe(const constants_set *set, const recipe *r, recipe_result *result)
{
    double k[FIT_MOST_PARAMETERS];
    if (!result->own.usable)
        return;
    for (size_t i = 0; i < r->way.coefficient_count; i++)
        if (r->way.coefficients[i].where && !result->has_beside)
            score_beside(set, r, result);
    const sg_form *form = complete(set, r, &result->own, k);
    if (form) {
        double infinity = (double)INFINITY;
        score_form(form, k, 0.0, infinity, SCORE_F64, &result->score_f64);
        score_form(form, k, 0.0, infinity, SCORE_F32, &result->score_f32);
        result->scored = true;
        hold(r, result, "RMSE of L", result->score_f64.rmse, r->bar_rmse);
        hold(r, result, "maximum error of L", result->score_f64.max_abs, r->bar_max);
        hold(r, result, "RMSE of L in float", result->score_f32.rmse, r->bar_rmse_f32);
        hold(r, result, "maximum error of L in float", result->score_f32.max_abs, r->bar_max_f32);
    }
    for (size_t i = 0; i < r->way.coefficient_count; i++) {
        const recipe_coefficient *c = &r->way.coefficients[i];
        double published;
        if (isnan(c->bar) || !constants_published(set, r->published, c->name, &published))
            continue;
        double relative = fabs(result->own.coefficients[i] - published) / fabs(published);
        if (!(relative <= c->bar))
            recipe_fail(result,
                        "%s: %s differs from the published one by %.3g, expected at most "
                        "%.3g",
                        r->id, c->name, relative, c->bar);
    }
}

bool fit_committed(const constants_set *set, const recipe *r, const char *coefficient,
                   double *value)
{
    if (r->writes)
        return constants_published(set, r->writes, coefficient, value);
    const cJSON *file = constants_set_find(set, r->published);
    const cJSON *item = cJSON_GetObjectItemCaseSensitive(file, "regenerated");
    item = cJSON_GetObjectItemCaseSensitive(item, r->id);
    item = cJSON_GetObjectItemCaseSensitive(item, "constants");
    item = cJSON_GetObjectItemCaseSensitive(item, coefficient);
    return item && base_json_f64(item, r->published, "ours", value);
}

/* ---- The table ----------------------------------------------------------------------------- */

static void number(double value, bool is_short)
{
    char text[BASE_NUMBER_SIZE];
    if (isnan(value))
        putchar(',');
    else if (is_short)
        printf(",%.3g", value);
    else
        printf(",%s", base_shortest_f64(value, text));
}

static void row(const recipe *r, const char *constant, double published, double ours, double bar,
                const char *how, const char *more)
{
    printf("%s,%s", r->id, constant);
    number(published, false);
    number(ours, false);
    number(ours - published, true);
    number(fabs(ours - published) / fabs(published), true);
    number(bar, true);
    printf(",\"%s%s\"\n", how, more);
}

static void constant_rows(const constants_set *set, const recipe *r, const recipe_result *result,
                          const char *how)
{
    for (size_t i = 0; i < r->way.coefficient_count; i++) {
        const recipe_coefficient *c = &r->way.coefficients[i];
        double published = NAN;
        if (!c->free)
            continue;
        if (r->published && !constants_published(set, r->published, c->name, &published))
            published = NAN;
        row(r, c->name, published, result->own.coefficients[i], c->bar, how, "");
        if (c->where && result->has_beside) {
            char cost[160];
            snprintf(cost, sizeof cost,
                     "%s; with it the method's maximum error of L is %.3g instead of %.3g",
                     c->where, result->score_beside.max_abs, result->score_published.max_abs);
            row(r, c->name, c->beside, result->own.coefficients[i], NAN, "as printed in ", cost);
        }
        for (size_t t = 0; t < r->tried_count && !isnan(published); t++)
            if (r->tried[t].coefficients[i].free)
                row(r, c->name, published, result->tried[t].coefficients[i], NAN,
                    "tried: ", r->tried[t].what);
    }
}

void fit_print_table(const constants_set *set, const recipe *recipes, const recipe_result *results,
                     size_t count)
{
    puts("recipe,constant,published,ours,difference,relative,bar,how");
    for (size_t i = 0; i < count; i++) {
        const recipe *r = &recipes[i];
        const recipe_result *result = &results[i];
        char how[256];
        if (!result->own.usable)
            continue;
        if (result->own.solver_count > 1)
            snprintf(how, sizeof how, "%s by Ceres and NLopt (agree to %.1g)",
                     recipe_objective_name(r->way.objective), result->own.disagreement);
        else
            snprintf(how, sizeof how, "%s by %s", recipe_objective_name(r->way.objective),
                     result->own.solvers[0].solver);
        constant_rows(set, r, result, how);
        if (!result->scored)
            continue;
        double finite[4] = {r->bar_rmse, r->bar_max, r->bar_rmse_f32, r->bar_max_f32};
        for (int b = 0; b < 4; b++)
            finite[b] = isfinite(finite[b]) ? finite[b] : (double)NAN;
        row(r, "rmse", NAN, result->score_f64.rmse, finite[0], "errors of L, double", "");
        row(r, "max_abs", NAN, result->score_f64.max_abs, finite[1], "errors of L, double", "");
        row(r, "rmse_f32", NAN, result->score_f32.rmse, finite[2], "errors of L, float", "");
        row(r, "max_abs_f32", NAN, result->score_f32.max_abs, finite[3], "errors of L, float", "");
    }
}
