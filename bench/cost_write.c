/* cost_write.c: what was measured, as CSV and JSON. */
#include "cost.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/file.h"
#include "base/json.h"
#include "base/text.h"
#include "machine.h"

/* One column: its name, its value, and whether it is the same in every run with the same Mesa. */
typedef struct column {
    const char *name;
    double (*value)(const cost_row *row);
    bool deterministic;
} column;

#define COLUMN(name, expression)                                                                   \
    static double name(const cost_row *row)                                                        \
    {                                                                                              \
        return expression;                                                                         \
    }
COLUMN(max_abs_f32, row->max_abs_f32)
COLUMN(rmse_f32, row->rmse_f32)
COLUMN(gpu_instructions, row->counts[0].instructions)
COLUMN(gpu_inverse_throughput, row->counts[0].inverse_throughput)
COLUMN(gpu_slope, row->counts[0].slope)
COLUMN(gpu_include_instructions, row->include.instructions)
COLUMN(gpu_include_inverse_throughput, row->include.inverse_throughput)
COLUMN(gpu_include_slope, row->include.slope)
COLUMN(gpu_slope_instructions, row->counts[0].slope_instructions)
COLUMN(gpu_vgprs, row->counts[0].vgprs)
COLUMN(gpu_fetches, (double)row->subject->fetches)
COLUMN(gpu_pixel_instructions, row->counts[0].pixel_instructions)
COLUMN(gpu_pixel_slope, row->counts[0].pixel_slope)
COLUMN(gpu_light_instructions, row->counts[0].instructions - row->counts[0].pixel_instructions)
COLUMN(gpu_light_slope, row->counts[0].slope - row->counts[0].pixel_slope)
COLUMN(gfx1100_instructions, row->counts[1].instructions)
COLUMN(gfx1100_slope, row->counts[1].slope)
COLUMN(vega10_instructions, row->counts[2].instructions)
COLUMN(vega10_slope, row->counts[2].slope)
COLUMN(cpu_ns_f32, row->f32.best)
COLUMN(cpu_ns_f64, row->f64.best)
COLUMN(cpu_batch_ns_f32, row->batch_f32.best)
COLUMN(cpu_batch_ns_f64, row->batch_f64.best)
COLUMN(cpu_ns_f32_median, row->f32.median)
COLUMN(cpu_ns_f64_median, row->f64.median)
COLUMN(cpu_batch_ns_f32_median, row->batch_f32.median)
COLUMN(cpu_batch_ns_f64_median, row->batch_f64.median)
COLUMN(device_ratio, row->device_ratio)

#define ROW(name, deterministic)                                                                   \
    {                                                                                              \
#name, name, deterministic                                                                 \
    }
static const column columns[] = {
    ROW(max_abs_f32, true),
    ROW(rmse_f32, true),
    ROW(gpu_instructions, true),
    ROW(gpu_inverse_throughput, true),
    ROW(gpu_slope, true),
    ROW(cpu_ns_f32, false),
    ROW(cpu_batch_ns_f32, false),
    ROW(cpu_batch_ns_f64, false),
    ROW(device_ratio, false),
    ROW(gpu_include_instructions, true),
    ROW(gpu_include_inverse_throughput, true),
    ROW(gpu_include_slope, true),
    ROW(gpu_slope_instructions, true),
    ROW(gpu_vgprs, true),
    ROW(gpu_fetches, true),
    ROW(gpu_pixel_instructions, true),
    ROW(gpu_pixel_slope, true),
    ROW(gpu_light_instructions, true),
    ROW(gpu_light_slope, true),
    ROW(gfx1100_instructions, true),
    ROW(gfx1100_slope, true),
    ROW(vega10_instructions, true),
    ROW(vega10_slope, true),
    ROW(cpu_ns_f64, false),
    ROW(cpu_ns_f32_median, false),
    ROW(cpu_ns_f64_median, false),
    ROW(cpu_batch_ns_f32_median, false),
    ROW(cpu_batch_ns_f64_median, false),
};
enum { COLUMNS = sizeof columns / sizeof *columns };

/* Four significant digits: more is noise, for times, or differs between C libraries, for errors. */
static double rounded(double value)
{
    char text[40];
    snprintf(text, sizeof text, "%.4g", value);
    return strtod(text, NULL);
}

bool cost_write_csv(const cost_table *table, const char *path, bool deterministic)
{
    base_output output;
    if (!base_output_open(&output, path))
        return false;
    fprintf(output.stream, "method,quantity");
    for (int c = 0; c < COLUMNS; c++)
        if (!deterministic || columns[c].deterministic)
            fprintf(output.stream, ",%s", columns[c].name);
    fprintf(output.stream, ",gpu_driver\n");
    for (size_t i = 0; i < table->subjects.count; i++) {
        const cost_row *row = &table->rows[i];
        fprintf(output.stream, "%s,%s", row->subject->id,
                cost_quantity_name(row->subject->quantity));
        for (int c = 0; c < COLUMNS; c++) {
            if (deterministic && !columns[c].deterministic)
                continue;
            char text[BASE_NUMBER_SIZE];
            double value = columns[c].value(row);
            fprintf(output.stream, ",%s",
                    isnan(value) ? "" : base_shortest_f64(rounded(value), text));
        }
        fprintf(output.stream, ",%s\n", table->counted ? table->counter_driver : "");
    }
    return base_output_close(&output);
}

static void add_rows(cJSON *root, const cost_table *table)
{
    cJSON *rows = cJSON_AddArrayToObject(root, "rows");
    for (size_t i = 0; i < table->subjects.count; i++) {
        const cost_row *row = &table->rows[i];
        cJSON *object = cJSON_CreateObject();
        cJSON_AddStringToObject(object, "method", row->subject->id);
        cJSON_AddStringToObject(object, "quantity", cost_quantity_name(row->subject->quantity));
        for (int c = 0; c < COLUMNS; c++) {
            double value = columns[c].value(row);
            if (isnan(value))
                cJSON_AddNullToObject(object, columns[c].name);
            else
                base_json_add_f64(object, columns[c].name, rounded(value));
        }
        cJSON_AddItemToArray(rows, object);
    }
}

static void add_conditions(cJSON *root, const cost_table *table)
{
    cJSON *cpu = cJSON_AddObjectToObject(root, "cpu");
    cJSON *lambda = cJSON_AddArrayToObject(cpu, "lambda");
    cJSON_AddItemToArray(lambda, base_json_number(cost_lambda_min));
    cJSON_AddItemToArray(lambda, base_json_number(cost_lambda_max));
    cJSON_AddStringToObject(cpu, "lambda_distribution", "logarithmic");
    cJSON *cosine = cJSON_AddArrayToObject(cpu, "cos_theta");
    cJSON_AddItemToArray(cosine, base_json_number(-1));
    cJSON_AddItemToArray(cosine, base_json_number(1));
    cJSON_AddStringToObject(cpu, "cos_theta_distribution", "uniform");
    base_json_add_f64(cpu, "points", COST_POINTS);
    base_json_add_f64(cpu, "samples", table->samples);
    if (!isnan(table->call_overhead))
        base_json_add_f64(cpu, "empty_call_ns_f32", rounded(table->call_overhead));
    cJSON *gpu = cJSON_AddObjectToObject(root, "gpu");
    cJSON_AddStringToObject(gpu, "driver", table->counter_driver);
    cJSON *families = cJSON_AddArrayToObject(gpu, "families");
    for (int i = 0; i < COST_FAMILIES; i++)
        cJSON_AddItemToArray(families, cJSON_CreateString(cost_families[i]));
    cJSON *device = cJSON_AddObjectToObject(root, "device");
    cJSON_AddStringToObject(device, "name", table->device_name);
    cJSON_AddStringToObject(device, "driver", table->device_driver);
}

bool cost_write_json(const cost_table *table, const char *path)
{
    cJSON *root = cJSON_CreateObject();
    machine_add_json(cJSON_AddObjectToObject(root, "machine"));
    add_conditions(root, table);
    add_rows(root, table);
    char *text = base_json_print(root);
    cJSON_Delete(root);
    bool good = text && base_write_file(path, text, strlen(text));
    free(text);
    return good;
}
