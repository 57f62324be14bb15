/* constants.h: tables/constants, one method a file, read and matched to the forms. */
#ifndef TABLES_CONSTANTS_H
#define TABLES_CONSTANTS_H

#include <cjson/cJSON.h>

#include "form.h"

/* Errors of L against the reference, as `sgfit fit` wrote them. */
typedef struct measured {
    bool given;
    double max_abs, max_abs_lambda, max_abs_beta, rmse;
} measured;

typedef struct method {
    char *path;
    cJSON *json; /* owns the strings below */
    const char *id, *title, *source, *variant;
    int year;
    const form *form;
    double lambda_min, lambda_max;
    double *coefficients; /* in the form's order */
    measured f64, f32;
    const char *command; /* that makes the constants again, or NULL */
    char *cost;          /* from cost.csv, one line, or NULL */
    char *instructions;  /* of A_h, from there, or NULL */
} method;

typedef struct method_list {
    method *methods; /* sorted by year, then id */
    size_t count;
} method_list;

/* Reads FOLDER/ID.json, every one. False after one line that names file and line. */
bool methods_read(method_list *list, const char *folder, const form_list *forms);
void methods_free(method_list *list);
const method *methods_find(const method_list *list, const char *id);

/* Joins the costs in a CSV (tables/cost.csv) to the methods; a file that is not there is no error.
 */
bool methods_read_costs(method_list *list, const char *path);

#endif
