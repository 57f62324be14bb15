/* profile_write.c: a fit to a profile as a constants file. */
#include "profile_fit.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/file.h"
#include "base/json.h"
#include "fit/solve.h"

static void add_domain(cJSON *root, double low, double high)
{
    cJSON *lambda = cJSON_AddArrayToObject(cJSON_AddObjectToObject(root, "domain"), "lambda");
    cJSON_AddItemToArray(lambda, base_json_number(low));
    cJSON_AddItemToArray(lambda, base_json_number(high > low ? high : low * 1.000001 + 1e-6));
}

/* What the profile is, without where it lies. */
static void add_profile(cJSON *root, const choose_domain *domain)
{
    double weights = 0.0, lambda = 0.0, cos_theta = 0.0, low = 1.0, high = -1.0;
    for (size_t i = 0; i < domain->count; i++) {
        double cosine = (double)domain->cos_theta[i];
        weights += domain->weight[i];
        lambda += domain->weight[i] * (double)domain->lambda[i];
        cos_theta += domain->weight[i] * cosine;
        low = fmin(low, cosine);
        high = fmax(high, cosine);
    }
    cJSON *profile = cJSON_AddObjectToObject(root, "profile");
    base_json_add_f64(profile, "points", (double)domain->count);
    base_json_add_f64(profile, "lambda_min", domain->lambda_min);
    base_json_add_f64(profile, "lambda_max", domain->lambda_max);
    base_json_add_f64(profile, "lambda_mean", lambda / weights);
    base_json_add_f64(profile, "cos_theta_min", low);
    base_json_add_f64(profile, "cos_theta_max", high);
    base_json_add_f64(profile, "cos_theta_mean", cos_theta / weights);
}

static void add_cost(cJSON *root, const char *key, const profile_candidate *c)
{
    cJSON *object = cJSON_AddObjectToObject(root, key);
    if (!c->fitted)
        cJSON_AddStringToObject(object, "tier", c->tier->id);
    base_json_add_f64(object, "instructions", c->instructions);
    base_json_add_f64(object, "max_abs_f32", c->max_abs);
    base_json_add_f64(object, "rmse_f32", c->rmse);
}

static void add_provenance(cJSON *root, const fit_profile_request *request,
                           const choose_domain *domain, const profile_counter *counter,
                           const profile_candidate *chosen, const profile_candidate *general)
{
    char solver[128];
    cJSON *object = cJSON_AddObjectToObject(root, "provenance");
    cJSON_AddStringToObject(object, "objective", request->by_max ? "minimax" : "least_squares");
    cJSON_AddStringToObject(object, "quantity", "L");
    cJSON_AddStringToObject(object, "start", chosen->tier->id);
    snprintf(solver, sizeof solver, request->by_max ? "Ceres %s and NLopt %s" : "Ceres %s",
             fit_ceres_version(), fit_nlopt_version());
    cJSON_AddStringToObject(object, "solver", solver);
    add_profile(object, domain);
    cJSON *dropped = cJSON_AddArrayToObject(object, "dropped");
    for (int i = 0; i < chosen->tier->form->coefficient_count; i++)
        if (chosen->dropped[i])
            cJSON_AddItemToArray(dropped,
                                 cJSON_CreateString(chosen->tier->form->coefficient_names[i]));
    cJSON_AddStringToObject(object, "counted", profile_counter_name(counter));
    add_cost(object, "on_profile", chosen);
    if (general)
        add_cost(object, "general", general);
}

bool profile_write(const fit_profile_request *request, const choose_domain *domain,
                   const profile_counter *counter, const profile_candidate *chosen,
                   const profile_candidate *general)
{
    cJSON *root = cJSON_CreateObject();
    cJSON_AddStringToObject(root, "id", "profile");
    cJSON_AddStringToObject(root, "title", "Fitted to a profile of lights");
    cJSON_AddStringToObject(root, "variant", "refit");
    cJSON_AddNumberToObject(root, "year", chosen->tier->year);
    cJSON_AddStringToObject(root, "source", "sgfit fit --profile");
    cJSON_AddStringToObject(root, "form", chosen->tier->form->id);
    add_domain(root, domain->lambda_min, domain->lambda_max);
    cJSON *list = cJSON_AddObjectToObject(root, "coefficients");
    for (int i = 0; i < chosen->tier->form->coefficient_count; i++)
        base_json_add_f64(list, chosen->tier->form->coefficient_names[i], chosen->coefficients[i]);
    add_provenance(root, request, domain, counter, chosen, general);
    char *text = base_json_print(root);
    bool good = text && base_write_file(request->out, text, strlen(text));
    free(text);
    cJSON_Delete(root);
    return good;
}
