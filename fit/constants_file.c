#include "fit/constants_file.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "base/file.h"
#include "base/text.h"

/* ---- Reading ------------------------------------------------------------------------------- */

/* Takes the file; it replaces one of the same id. */
static bool put_file(constants_set *set, const char *id, size_t length, cJSON *file)
{
    size_t i = 0;
    while (i < set->count &&
           (strlen(set->ids[i]) != length || strncmp(set->ids[i], id, length) != 0))
        i++;
    if (i < set->count) {
        cJSON_Delete(set->files[i]);
        set->files[i] = file;
        return true;
    }
    char **ids = realloc(set->ids, sizeof *ids * (set->count + 1));
    set->ids = ids ? ids : set->ids;
    cJSON **files = realloc(set->files, sizeof *files * (set->count + 1));
    set->files = files ? files : set->files;
    char *copy = malloc(length + 1);
    if (!ids || !files || !copy) {
        cJSON_Delete(file);
        free(copy);
        return false;
    }
    memcpy(copy, id, length);
    copy[length] = '\0';
    set->ids[set->count] = copy;
    set->files[set->count++] = file;
    return true;
}

static bool add_file(constants_set *set, const char *folder, const char *name)
{
    char *path = base_join(folder, name);
    cJSON *json = path ? base_json_read(path) : NULL;
    free(path);
    return json && put_file(set, name, strlen(name) - strlen(".json"), json);
}

static bool add_folder(constants_set *set, const char *folder)
{
    char **names;
    size_t count;
    if (!base_list(folder, ".json", &names, &count))
        return false;
    bool good = true;
    for (size_t i = 0; good && i < count; i++)
        good = add_file(set, folder, names[i]);
    base_list_free(names, count);
    return good;
}

bool constants_set_read(constants_set *set, const char *out_folder)
{
    *set = (constants_set){0};
    char *source = base_join(base_source_root(), "tables/constants");
    bool same = source && strcmp(source, out_folder) == 0;
    bool good = source && add_folder(set, source);
    if (good && !same && access(out_folder, F_OK) == 0)
        good = add_folder(set, out_folder);
    free(source);
    if (!good)
        constants_set_free(set);
    return good;
}

void constants_set_free(constants_set *set)
{
    for (size_t i = 0; i < set->count; i++) {
        free(set->ids[i]);
        cJSON_Delete(set->files[i]);
    }
    free(set->ids);
    free(set->files);
    *set = (constants_set){0};
}

cJSON *constants_set_find(const constants_set *set, const char *id)
{
    for (size_t i = 0; id && i < set->count; i++)
        if (strcmp(set->ids[i], id) == 0)
            return set->files[i];
    return NULL;
}

bool constants_published(const constants_set *set, const char *id, const char *coefficient,
                         double *value)
{
    const cJSON *file = constants_set_find(set, id);
    const cJSON *list = cJSON_GetObjectItemCaseSensitive(file, "coefficients");
    return cJSON_GetObjectItemCaseSensitive(list, coefficient) != NULL &&
           base_json_f64(list, id, coefficient, value);
}

bool constants_coefficients(const constants_set *set, const cJSON *file, const sg_form *form,
                            double *coefficients)
{
    const cJSON *from = cJSON_GetObjectItemCaseSensitive(file, "coefficients_from");
    if (cJSON_IsString(from))
        file = constants_set_find(set, from->valuestring);
    const cJSON *list = cJSON_GetObjectItemCaseSensitive(file, "coefficients");
    for (int i = 0; i < form->coefficient_count; i++)
        if (!cJSON_GetObjectItemCaseSensitive(list, form->coefficient_names[i]) ||
            !base_json_f64(list, "tables/constants", form->coefficient_names[i], &coefficients[i]))
            return false;
    return true;
}

/* ---- Recording ----------------------------------------------------------------------------- */

static cJSON *new_file(const recipe *r, const recipe_result *result)
{
    cJSON *file = cJSON_CreateObject();
    char source[160];
    snprintf(source, sizeof source, "sgfit fit %s (fit/recipes/%s.json)", r->id, r->id);
    cJSON_AddStringToObject(file, "id", r->writes);
    cJSON_AddStringToObject(file, "title", r->writes_title);
    cJSON_AddStringToObject(file, "variant", r->writes_variant);
    base_json_add_f64(file, "year", (double)r->writes_year);
    cJSON_AddStringToObject(file, "source", source);
    cJSON_AddStringToObject(file, "form", r->form->id);
    cJSON *domain = cJSON_AddObjectToObject(file, "domain");
    cJSON *lambda = cJSON_AddArrayToObject(domain, "lambda");
    cJSON_AddItemToArray(lambda, base_json_number(0.0));
    cJSON_AddItemToArray(lambda, cJSON_CreateString("inf"));
    cJSON *coefficients = cJSON_AddObjectToObject(file, "coefficients");
    for (size_t i = 0; i < r->way.coefficient_count; i++)
        base_json_add_f64(coefficients, r->way.coefficients[i].name, result->own.coefficients[i]);
    return file;
}

/* Entries of one list stand in the order of their keys, whatever order the recipes ran in. */
static void put_in_order(cJSON *object, const char *key, cJSON *value)
{
    cJSON *item;
    cJSON_DeleteItemFromObjectCaseSensitive(object, key);
    int place = 0;
    cJSON_ArrayForEach(item, object)
    {
        if (strcmp(item->string, key) < 0)
            place++;
    }
    /* cJSON inserts at a place in arrays only, and there without a key: give it the key first. */
    cJSON_AddItemToObject(object, key, value);
    cJSON_InsertItemInArray(object, place, cJSON_DetachItemFromObjectCaseSensitive(object, key));
}

bool constants_record(constants_set *set, const recipe *r, const recipe_result *result)
{
    cJSON *provenance = provenance_of(set, r, result);
    if (r->writes) {
        cJSON *file = new_file(r, result);
        cJSON_AddItemToObject(file, "provenance", provenance);
        return put_file(set, r->writes, strlen(r->writes), file);
    }
    cJSON *file = constants_set_find(set, r->published);
    if (!file) {
        cJSON_Delete(provenance);
        return true;
    }
    cJSON *regenerated = cJSON_GetObjectItemCaseSensitive(file, "regenerated");
    if (!regenerated) {
        /* "measured" stays last */
        cJSON *measured = cJSON_DetachItemFromObjectCaseSensitive(file, "measured");
        regenerated = cJSON_AddObjectToObject(file, "regenerated");
        if (measured)
            cJSON_AddItemToObject(file, "measured", measured);
    }
    put_in_order(regenerated, r->id, provenance);
    return true;
}

/* ---- Measuring and writing ----------------------------------------------------------------- */

static void add_measured(cJSON *object, score_precision precision, const score_result *score)
{
    cJSON *one = cJSON_AddObjectToObject(object, score_precision_name(precision));
    base_json_add_f64(one, "max_abs", score->max_abs);
    base_json_add_f64(one, "max_abs_lambda", score->max_abs_lambda);
    base_json_add_f64(one, "max_abs_beta", score->max_abs_beta);
    base_json_add_f64(one, "rmse", score->rmse);
}

/* The compiled instance where it has just these coefficients, for it is what ships; else the form.
 */
static void score_file(const cJSON *file, const sg_form *form, const sg_method *method,
                       const double *k, cJSON *measured)
{
    const cJSON *domain = cJSON_GetObjectItemCaseSensitive(file, "domain");
    const cJSON *lambda = cJSON_GetObjectItemCaseSensitive(domain, "lambda");
    const cJSON *low = cJSON_GetArrayItem(lambda, 0), *high = cJSON_GetArrayItem(lambda, 1);
    double from = cJSON_IsNumber(low) ? low->valuedouble : 0.0;
    double to = cJSON_IsNumber(high) ? high->valuedouble : (double)INFINITY;
    bool compiled =
        method && method->form == form && method->lambda_min == from && method->lambda_max == to &&
        memcmp(method->coefficients, k, sizeof *k * (size_t)form->coefficient_count) == 0;
    for (int p = 0; p < SCORE_PRECISIONS; p++) {
        score_result score;
        if (p == SCORE_F16 && !form->f16)
            continue;
        if (compiled)
            score_method(method, (score_precision)p, &score);
        else
            score_form(form, k, from, to, (score_precision)p, &score);
        add_measured(measured, (score_precision)p, &score);
    }
}

bool constants_measure(constants_set *set, base_progress *progress)
{
    for (size_t i = 0; i < set->count; i++) {
        cJSON *file = set->files[i];
        const cJSON *id = cJSON_GetObjectItemCaseSensitive(file, "form");
        const sg_form *form = cJSON_IsString(id) ? sg_form_find(id->valuestring) : NULL;
        double k[FIT_MOST_PARAMETERS];
        base_progress_step(progress, set->ids[i]);
        if (!form || form->coefficient_count > FIT_MOST_PARAMETERS ||
            !constants_coefficients(set, file, form, k)) {
            base_error("tables/constants/%s.json: expected a form of this build with all of its "
                       "coefficients",
                       set->ids[i]);
            return false;
        }
        cJSON_DeleteItemFromObjectCaseSensitive(file, "measured");
        score_file(file, form, sg_method_find(set->ids[i]), k,
                   cJSON_AddObjectToObject(file, "measured"));
    }
    return true;
}

bool constants_set_write(const constants_set *set, const char *out_folder)
{
    for (size_t i = 0; i < set->count; i++) {
        char name[128];
        snprintf(name, sizeof name, "%s.json", set->ids[i]);
        char *path = base_join(out_folder, name), *text = base_json_print(set->files[i]);
        bool good = path && text && base_write_file(path, text, strlen(text));
        free(path);
        free(text);
        if (!good)
            return false;
    }
    return true;
}
