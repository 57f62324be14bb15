/* report_constants.c: see report_constants.h. */
#include "report_constants.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/file.h"
#include "base/json.h"
#include "base/text.h"
#include "report.h"

void report_constants_free(report_constants *c)
{
    for (size_t i = 0; c->files && i < c->count; i++)
        cJSON_Delete(c->files[i]);
    free(c->files);
    base_list_free(c->names, c->count);
}

bool report_constants_read(report_constants *c)
{
    *c = (report_constants){0};
    char *folder = base_join(base_source_root(), "tables/constants");
    bool done = base_list(folder, ".json", &c->names, &c->count);
    c->files = done ? calloc(c->count + 1, sizeof *c->files) : NULL;
    for (size_t i = 0; c->files && i < c->count && done; i++) {
        char *path = base_join(folder, c->names[i]);
        c->files[i] = base_json_read(path);
        done = c->files[i] != NULL;
        free(path);
    }
    free(folder);
    return done && c->files;
}

const char *report_constants_text(const cJSON *object, const char *key)
{
    const cJSON *item = cJSON_GetObjectItemCaseSensitive(object, key);
    return cJSON_IsString(item) ? item->valuestring : "";
}

double report_constants_number(const cJSON *object, const char *key)
{
    const cJSON *item = cJSON_GetObjectItemCaseSensitive(object, key);
    double value;
    if (cJSON_IsString(item) &&
        base_parse_f64(item->valuestring, strlen(item->valuestring), &value))
        return value;
    return cJSON_IsNumber(item) ? item->valuedouble : (double)NAN;
}

bool report_fit_tally(size_t *count, size_t *met)
{
    *count = *met = 0;
    report_constants c;
    bool done = report_constants_read(&c);
    for (size_t i = 0; done && i < c.count; i++) {
        const cJSON *recipe, *constant;
        cJSON_ArrayForEach(recipe, cJSON_GetObjectItemCaseSensitive(c.files[i], "regenerated"))
        {
            cJSON_ArrayForEach(constant, cJSON_GetObjectItemCaseSensitive(recipe, "constants"))
            {
                *count += 1;
                *met += report_constants_number(constant, "relative") <=
                        report_constants_number(constant, "bar");
            }
        }
    }
    report_constants_free(&c);
    return done;
}
