/* constants_file.h: tables/constants/ID.json as the fits change them. */
#ifndef FIT_CONSTANTS_FILE_H
#define FIT_CONSTANTS_FILE_H

#include <stdbool.h>
#include <stddef.h>

#include "base/json.h"
#include "base/progress.h"
#include "fit/recipe_run.h"

/* All constants files of a run: those of the source tree, with what is in the output folder read
 * over them, in the order of their names. */
typedef struct constants_set {
    size_t count;
    char **ids;
    cJSON **files; /* owned */
} constants_set;

/* False after one line. */
bool constants_set_read(constants_set *set, const char *out_folder);
void constants_set_free(constants_set *set);
cJSON *constants_set_find(const constants_set *set, const char *id); /* NULL where there is none */

/* A coefficient of a method; false where the method or it is missing. */
bool constants_published(const constants_set *set, const char *id, const char *coefficient,
                         double *value);
/* All coefficients of a form, from the method's file or the one that it names. */
bool constants_coefficients(const constants_set *set, const cJSON *file, const sg_form *form,
                            double *coefficients);

/* Writes what a recipe found into the set: a new file for what it writes, an entry under
 * "regenerated" of the published method otherwise. False where memory is short. */
bool constants_record(constants_set *set, const recipe *r, const recipe_result *result);

/* "measured" of every file, by the score. */
bool constants_measure(constants_set *set, base_progress *progress);

/* Every file to the folder, as a whole each. False after one line. */
bool constants_set_write(const constants_set *set, const char *out_folder);

/* provenance.c: how a recipe got its result, as an object. published: the constants set, for the
 * differences. */
cJSON *provenance_of(const constants_set *set, const recipe *r, const recipe_result *result);

#endif
