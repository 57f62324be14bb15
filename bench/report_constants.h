/* report_constants.h: the files of tables/constants, as the report reads them. */
#ifndef BENCH_REPORT_CONSTANTS_H
#define BENCH_REPORT_CONSTANTS_H

#include <stdbool.h>
#include <stddef.h>

#include <cjson/cJSON.h>

typedef struct report_constants {
    size_t count;
    char **names; /* "ID.json", sorted */
    cJSON **files;
} report_constants;

/* All files of the source tree's tables/constants; false after one line. To be freed either way. */
bool report_constants_read(report_constants *c);
void report_constants_free(report_constants *c);

/* A member's text, "" where there is none; its number ("inf" is one), NaN where there is none. */
const char *report_constants_text(const cJSON *object, const char *key);
double report_constants_number(const cJSON *object, const char *key);

#endif
