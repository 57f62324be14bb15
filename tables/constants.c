/* constants.c: reading tables/constants. */
#include "constants.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/file.h"
#include "base/json.h"
#include "base/text.h"

/* The line on which a key stands in the file: cJSON keeps none. 1 where it is not found. */
static int line_of(const char *path, const char *key)
{
    char *text = base_read_file(path, NULL), *quoted = base_allocate(strlen(key) + 3);
    quoted[0] = '"';
    strcpy(quoted + 1, key);
    strcat(quoted, "\"");
    const char *found = text ? strstr(text, quoted) : NULL;
    int line = 1;
    for (const char *at = text; found && at < found; at++)
        line += *at == '\n';
    free(quoted);
    free(text);
    return line;
}

static bool refuse(const method *method, const char *key, const char *expected)
{
    base_error("%s:%d: expected %s", method->path, line_of(method->path, key), expected);
    return false;
}

static bool read_coefficients(method *method, const cJSON *given, const char *given_path)
{
    const form *form = method->form;
    for (const cJSON *item = given->child; item; item = item->next) {
        size_t i = 0;
        while (i < form->coefficient_count && strcmp(form->coefficients[i], item->string) != 0)
            i++;
        if (i == form->coefficient_count) {
            base_error("%s:%d: expected no coefficient \"%s\": form %s has none of that name",
                       given_path, line_of(given_path, item->string), item->string, form->id);
            return false;
        }
    }
    for (size_t i = 0; i < form->coefficient_count; i++) {
        const char *name = form->coefficients[i];
        if (!cJSON_GetObjectItemCaseSensitive(given, name)) {
            base_error("%s:%d: expected coefficient \"%s\" of form %s", given_path,
                       line_of(given_path, "coefficients"), name, form->id);
            return false;
        }
        double value;
        if (!base_json_f64(given, given_path, name, &value))
            return false;
        if (!isfinite(value) || fabs(value) > (double)FLT_MAX ||
            (value != 0 && fabs(value) < (double)FLT_MIN)) {
            base_error("%s:%d: expected \"%s\" as a finite number that float can hold", given_path,
                       line_of(given_path, name), name);
            return false;
        }
        method->coefficients[i] = value;
    }
    return true;
}

static bool read_domain(method *method)
{
    static const char *const keys[] = {"lambda", NULL};
    const cJSON *domain;
    if (!base_json_object(method->json, method->path, "domain", &domain) ||
        !base_json_only(domain, method->path, keys))
        return false;
    const cJSON *lambda = cJSON_GetObjectItemCaseSensitive(domain, "lambda");
    const cJSON *low = cJSON_GetArrayItem(lambda, 0), *high = cJSON_GetArrayItem(lambda, 1);
    bool infinite = cJSON_IsString(high) && strcmp(high->valuestring, "inf") == 0;
    if (cJSON_GetArraySize(lambda) != 2 || !cJSON_IsNumber(low) ||
        !(cJSON_IsNumber(high) || infinite))
        return refuse(method, "lambda", "\"lambda\": [low, high], high a number or \"inf\"");
    method->lambda_min = low->valuedouble;
    method->lambda_max = infinite ? (double)INFINITY : high->valuedouble;
    if (!(method->lambda_min >= 0 && method->lambda_min < method->lambda_max))
        return refuse(method, "lambda", "a domain of lambda with 0 <= low < high");
    return true;
}

static bool read_measured(const method *method, const char *precision, measured *out)
{
    const cJSON *all = cJSON_GetObjectItemCaseSensitive(method->json, "measured");
    const cJSON *one = cJSON_GetObjectItemCaseSensitive(all, precision);
    *out = (measured){0};
    if (!one)
        return true;
    out->given = true;
    return base_json_f64(one, method->path, "max_abs", &out->max_abs) &&
           base_json_f64(one, method->path, "max_abs_lambda", &out->max_abs_lambda) &&
           base_json_f64(one, method->path, "max_abs_beta", &out->max_abs_beta) &&
           base_json_f64(one, method->path, "rmse", &out->rmse);
}

/* Ids become names in C and GLSL. */
static bool valid_id(const method *method, const char *file)
{
    size_t length = strlen(method->id);
    bool good = length + strlen(".json") == strlen(file) &&
                strncmp(method->id, file, length) == 0 &&
                strspn(method->id, "abcdefghijklmnopqrstuvwxyz0123456789_") == length &&
                !strstr(method->id, "__") && length > 0;
    return good || refuse(method, "id",
                          "\"id\" to be the file's name without .json: small letters, digits, "
                          "single underscores");
}

static bool one_line(const char *text)
{
    return !strpbrk(text, "\n\r\\") && *text;
}

static bool read_one(method *method, const char *folder, const char *file, const form_list *forms)
{
    static const char *const keys[] = {
        "id",     "title",        "variant",           "year",       "source",      "form",
        "domain", "coefficients", "coefficients_from", "provenance", "regenerated", "measured",
        NULL};
    static const char *const variants[] = {"published", "stable", "refit", "tier"};
    *method = (struct method){.path = base_join(folder, file)};
    const char *path = method->path, *form_id;
    double year;
    method->json = base_json_read(path);
    if (!method->json || !base_json_only(method->json, path, keys) ||
        !base_json_string(method->json, path, "id", &method->id) || !valid_id(method, file) ||
        !base_json_string(method->json, path, "title", &method->title) ||
        !base_json_string(method->json, path, "variant", &method->variant) ||
        !base_json_f64(method->json, path, "year", &year) ||
        !base_json_string(method->json, path, "source", &method->source) ||
        !base_json_string(method->json, path, "form", &form_id) || !read_domain(method) ||
        !read_measured(method, "f64", &method->f64) || !read_measured(method, "f32", &method->f32))
        return false;
    size_t variant = 0;
    while (variant < 4 && strcmp(variants[variant], method->variant) != 0)
        variant++;
    if (variant == 4)
        return refuse(method, "variant", "\"variant\" published, stable, refit or tier");
    if (!(year >= 1900 && year <= 9999 && floor(year) == year))
        return refuse(method, "year", "\"year\" as a whole number");
    method->year = (int)year;
    if (!one_line(method->title))
        return refuse(method, "title", "\"title\" as one line of text without backslashes");
    if (!one_line(method->source))
        return refuse(method, "source", "\"source\" as one line of text without backslashes");
    method->form = forms_find(forms, form_id);
    if (!method->form)
        return refuse(method, "form", "\"form\" to name a file of shaders/forms");
    const cJSON *provenance = cJSON_GetObjectItemCaseSensitive(method->json, "provenance");
    const cJSON *command = cJSON_GetObjectItemCaseSensitive(provenance, "command");
    method->command = cJSON_IsString(command) ? command->valuestring : NULL;
    method->coefficients =
        base_allocate((method->form->coefficient_count + 1) * sizeof *method->coefficients);
    return true;
}

/* A method's own coefficients, or those of the method that it names. */
static bool resolve(method *method, const method_list *list)
{
    const cJSON *own = cJSON_GetObjectItemCaseSensitive(method->json, "coefficients");
    const cJSON *from = cJSON_GetObjectItemCaseSensitive(method->json, "coefficients_from");
    if (own && from)
        return refuse(method, "coefficients_from",
                      "either \"coefficients\" or \"coefficients_from\"");
    if (!from && !cJSON_IsObject(own))
        return refuse(method, "coefficients", "\"coefficients\": {...}");
    if (!from)
        return read_coefficients(method, own, method->path);
    const struct method *other =
        cJSON_IsString(from) ? methods_find(list, from->valuestring) : NULL;
    own = other ? cJSON_GetObjectItemCaseSensitive(other->json, "coefficients") : NULL;
    if (!cJSON_IsObject(own))
        return refuse(method, "coefficients_from",
                      "\"coefficients_from\" to name a method with coefficients of its own");
    return read_coefficients(method, own, other->path);
}

static int by_year(const void *a, const void *b)
{
    const method *x = a, *y = b;
    return x->year != y->year ? (x->year > y->year) - (x->year < y->year) : strcmp(x->id, y->id);
}

bool methods_read(method_list *list, const char *folder, const form_list *forms)
{
    char **names;
    size_t count;
    *list = (method_list){0};
    if (!base_list(folder, ".json", &names, &count))
        return false;
    bool good = true;
    list->methods = base_allocate((count + 1) * sizeof *list->methods);
    for (size_t i = 0; good && i < count; i++)
        good = read_one(&list->methods[list->count++], folder, names[i], forms);
    base_list_free(names, count);
    for (size_t i = 0; good && i < list->count; i++)
        good = resolve(&list->methods[i], list);
    if (good)
        qsort(list->methods, list->count, sizeof *list->methods, by_year);
    return good;
}

void methods_free(method_list *list)
{
    for (size_t i = 0; i < list->count; i++) {
        free(list->methods[i].path);
        free(list->methods[i].coefficients);
        free(list->methods[i].cost);
        free(list->methods[i].instructions);
        cJSON_Delete(list->methods[i].json);
    }
    free(list->methods);
    *list = (method_list){0};
}

const method *methods_find(const method_list *list, const char *id)
{
    for (size_t i = 0; i < list->count; i++) {
        if (strcmp(list->methods[i].id, id) == 0)
            return &list->methods[i];
    }
    return NULL;
}
