/* sgfit methods: the registry, for people and as JSON. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/json.h"
#include "base/options.h"
#include "base/text.h"
#include "fit/eval.h"
#include "sg.h"

static bool add_method(cJSON *array, const sg_method *method)
{
    cJSON *object = cJSON_CreateObject();
    if (!cJSON_AddItemToArray(array, object))
        return false;
    cJSON_AddStringToObject(object, "id", method->id);
    cJSON_AddStringToObject(object, "title", method->title);
    base_json_add_f64(object, "year", method->year);
    cJSON_AddStringToObject(object, "source", method->source);
    cJSON_AddStringToObject(object, "variant", method->variant);
    cJSON *range = cJSON_AddArrayToObject(cJSON_AddObjectToObject(object, "domain"), "lambda");
    cJSON_AddItemToArray(range, base_json_number(method->lambda_min));
    cJSON_AddItemToArray(range, base_json_number(method->lambda_max));
    const sg_form *form = method->form;
    cJSON_AddStringToObject(object, "form", form->id);
    cJSON_AddStringToObject(object, "native", form->native == SG_A_H ? "A_h" : "L");
    cJSON *coefficients = cJSON_AddObjectToObject(object, "coefficients");
    for (int i = 0; i < form->coefficient_count; i++)
        base_json_add_f64(coefficients, form->coefficient_names[i], method->coefficients[i]);
    return true;
}

static int print_json(void)
{
    cJSON *array = cJSON_CreateArray();
    bool good = array != NULL;
    for (size_t i = 0; good && i < sg_method_count(); i++)
        good = add_method(array, sg_method_at(i));
    char *text = good ? base_json_print(array) : NULL;
    cJSON_Delete(array);
    if (!text) {
        base_error("methods: out of memory");
        return BASE_FAILED;
    }
    fputs(text, stdout);
    free(text);
    return BASE_DONE;
}

static int width_of_ids(void)
{
    int width = 2;
    for (size_t i = 0; i < sg_method_count(); i++) {
        int length = (int)strlen(sg_method_at(i)->id);
        width = length > width ? length : width;
    }
    return width;
}

static void print_table(void)
{
    int width = width_of_ids();
    printf("%-*s  year  variant    sharpness      what it is\n", width, "id");
    for (size_t i = 0; i < sg_method_count(); i++) {
        const sg_method *method = sg_method_at(i);
        char low[BASE_NUMBER_SIZE], high[BASE_NUMBER_SIZE], domain[2 * BASE_NUMBER_SIZE + 4];
        base_shortest_f64(method->lambda_min, low);
        base_shortest_f64(method->lambda_max, high);
        snprintf(domain, sizeof domain, "%s to %s", low, high);
        printf("%-*s  %4d  %-9s  %-13s  %s\n", width, method->id, method->year, method->variant,
               domain, method->title);
    }
}

int methods_command(int argc, char **argv)
{
    bool json = false;
    const base_usage usage = {
        .command = "methods",
        .synopsis = "[options]",
        .text = "Lists the approximations of the registry: those published, as published and made "
                "stable, and those of our own. sgfit eval evaluates them by their id.",
    };
    const base_option options[] = {
        {"json", BASE_FLAG, &json, NULL,
         "an array of objects with id, title, year, source, variant, domain, form, "
         "the quantity that the form computes natively, and coefficients",
         NULL},
    };
    int status =
        base_parse_options(argc, argv, &usage, options, sizeof options / sizeof *options, NULL);
    if (status >= 0)
        return status;
    if (json)
        return print_json();
    print_table();
    return BASE_DONE;
}
