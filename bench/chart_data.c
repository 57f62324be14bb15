/* chart_data.c: what the chart shows: figures read from cost.csv and tables/constants. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/csv.h"
#include "base/file.h"
#include "base/json.h"
#include "base/text.h"
#include "chart.h"
#include "cost.h"
#include "report_constants.h"
#include "score.h"

const char *const chart_columns[CHART_FIGURES] = {
    "max_abs_f32", "rmse_f32", "gpu_instructions", "gpu_slope", "cpu_batch_ns_f32", "device_ratio",
};

static chart_point *add(chart *chart, const char *id, chart_kind kind)
{
    chart_point *grown = realloc(chart->points, (chart->count + 1) * sizeof *grown);
    if (!grown) {
        base_error("out of memory while collecting the chart");
        abort();
    }
    chart->points = grown;
    chart_point *point = &grown[chart->count++];
    *point = (chart_point){.kind = kind};
    snprintf(point->id, sizeof point->id, "%s", id);
    for (int f = 0; f < CHART_FIGURES; f++)
        point->figure[f] = (double)NAN;
    return point;
}

static void add_method(chart *chart, const sg_method *method)
{
    static const char *const variants[] = {"published", "stable", "refit", "tier"};
    int kind = CHART_PUBLISHED;
    while (kind < CHART_TIER && strcmp(variants[kind], method->variant) != 0)
        kind++;
    add(chart, method->id, (chart_kind)kind)->lambda_min = method->lambda_min;
}

void chart_registry(chart *chart)
{
    *chart = (struct chart){0};
    for (size_t i = 0; i < sg_method_count(); i++)
        add_method(chart, sg_method_at(i));
}

static chart_point *find(chart *chart, const char *id, bool new_rows)
{
    for (size_t i = 0; i < chart->count; i++)
        if (strcmp(chart->points[i].id, id) == 0)
            return &chart->points[i];
    if (!new_rows)
        return NULL;
    const sg_method *method = sg_method_find(id);
    if (method) {
        add_method(chart, method);
        return &chart->points[chart->count - 1];
    }
    for (size_t i = 0; i < cost_table_count(); i++)
        if (strcmp(cost_table_id(i), id) == 0)
            return add(chart, id, CHART_TABLE);
    return NULL; /* a file from before a method was renamed */
}

static bool number(const base_csv *csv, int column, double *value)
{
    if (column < 0 || csv->lengths[column] == 0)
        return true;
    if (base_parse_f64(csv->fields[column], csv->lengths[column], value))
        return true; /* "inf" is one */
    base_csv_error(csv, column, "a number");
    return false;
}

static bool read_row(chart *chart, const base_csv *csv, chart_figure first, bool new_rows)
{
    int id = base_csv_column(csv, "method"), quantity = base_csv_column(csv, "quantity");
    if (id < 0 || quantity < 0) {
        base_error("%s: expected the columns method and quantity", csv->name);
        return false;
    }
    if (strcmp(csv->fields[quantity], "L") != 0)
        return true;
    chart_point *point = find(chart, csv->fields[id], new_rows);
    bool good = true;
    for (int f = (int)first; point && good && f < CHART_FIGURES; f++)
        good = number(csv, base_csv_column(csv, chart_columns[f]), &point->figure[f]);
    return good && (!point || number(csv, base_csv_column(csv, "gpu_fetches"), &point->fetches));
}

bool chart_read_costs(chart *chart, const char *path, chart_figure first, bool new_rows)
{
    FILE *stream = fopen(path, "rb");
    if (!stream) {
        base_error("%s: cannot be read, expected costs as sgfit bench writes them", path);
        return false;
    }
    base_csv csv;
    bool good = base_csv_open(&csv, stream, path);
    int more = 0;
    while (good && (more = base_csv_next(&csv)) > 0)
        good = read_row(chart, &csv, first, new_rows);
    base_csv_close(&csv);
    fclose(stream);
    return good && more == 0;
}

bool chart_read_errors(chart *chart)
{
    report_constants constants;
    bool done = report_constants_read(&constants);
    for (size_t i = 0; done && i < constants.count; i++) {
        const cJSON *file = constants.files[i];
        chart_point *point = find(chart, report_constants_text(file, "id"), false);
        const cJSON *measured = cJSON_GetObjectItemCaseSensitive(file, "measured");
        const cJSON *single = cJSON_GetObjectItemCaseSensitive(measured, "f32");
        if (point && single) {
            point->figure[CHART_MAX] = report_constants_number(single, "max_abs");
            point->figure[CHART_RMSE] = report_constants_number(single, "rmse");
        }
    }
    report_constants_free(&constants);
    return done;
}

bool chart_committed(chart *chart)
{
    chart_registry(chart);
    char *path = base_join(base_source_root(), "tables/cost.csv");
    bool done = chart_read_costs(chart, path, CHART_MAX, true) && chart_read_errors(chart);
    free(path);
    return done;
}

void chart_free(chart *chart)
{
    free(chart->points);
    *chart = (struct chart){0};
}

bool chart_competes(const chart_point *point, chart_figure cost)
{
    return point->lambda_min <= 1e-3 && (point->fetches == 0.0 || cost == CHART_DEVICE);
}

size_t chart_front(const chart *chart, chart_figure error, chart_figure cost, size_t *front)
{
    size_t count = 0;
    for (size_t i = 0; i < chart->count; i++) {
        const double *a = chart->points[i].figure;
        bool beaten =
            !isfinite(a[error]) || !isfinite(a[cost]) || !chart_competes(&chart->points[i], cost);
        for (size_t j = 0; j < chart->count && !beaten; j++) {
            const double *b = chart->points[j].figure;
            bool less = b[error] < a[error] || b[cost] < a[cost] || j < i;
            beaten = j != i && less && b[error] <= a[error] && b[cost] <= a[cost] &&
                     chart_competes(&chart->points[j], cost);
        }
        if (beaten)
            continue;
        size_t at = count++;
        for (; at > 0 && chart->points[front[at - 1]].figure[cost] > a[cost]; at--)
            front[at] = front[at - 1];
        front[at] = i;
    }
    return count;
}
