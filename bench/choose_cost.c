/* choose_cost.c: costs of all methods in one unit. */
#include "choose.h"

#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/csv.h"
#include "base/file.h"
#include "base/text.h"
#include "cost.h"

const char *choose_unit_name(choose_unit unit)
{
    static const char *const names[] = {"instructions", "instructions a pixel", "nanoseconds",
                                        "times an empty shader"};
    return names[unit];
}

static size_t method_index(const char *id)
{
    size_t i = 0;
    while (i < sg_method_count() && strcmp(sg_method_at(i)->id, id) != 0)
        i++;
    return i;
}

/* A column of tables/cost.csv for the rows of L; a missing file leaves the costs as they are. */
static bool read_counts(const char *column, double *costs)
{
    char *folder = base_join(base_source_root(), "tables"), *path = base_join(folder, "cost.csv");
    free(folder);
    FILE *stream = fopen(path, "r");
    bool good = stream != NULL || errno == ENOENT;
    if (!good)
        base_error("%s: %s", path, strerror(errno));
    base_csv csv;
    if (stream && (good = base_csv_open(&csv, stream, path))) {
        int id = base_csv_column(&csv, "method"), quantity = base_csv_column(&csv, "quantity");
        int value = base_csv_column(&csv, column);
        if (id < 0 || quantity < 0 || value < 0) {
            base_error("%s:1: expected columns method, quantity and %s", path, column);
            good = false;
        }
        int row = 0;
        while (good && (row = base_csv_next(&csv)) > 0) {
            size_t method = method_index(csv.fields[id]);
            if (method < sg_method_count() && strcmp(csv.fields[quantity], "L") == 0 &&
                csv.lengths[value] > 0)
                good = base_csv_f64(&csv, value, &costs[method]);
        }
        good = good && row == 0;
        base_csv_close(&csv);
    }
    if (stream)
        fclose(stream);
    free(path);
    return good;
}

/* Counts the methods that have no cost yet, where RADV is there; else leaves them. */
static bool count_missing(bool pixel, double *costs)
{
    cost_counter *counter = NULL;
    bool good = true;
    for (size_t i = 0; i < sg_method_count() && good; i++) {
        char reason[256];
        if (!isnan(costs[i]))
            continue;
        if (!counter && !(counter = cost_counter_open(cost_families[0], reason)))
            return true;
        cost_subjects subjects;
        good = cost_subjects_read(&subjects, sg_method_at(i)->id);
        for (size_t s = 0; good && s < subjects.count; s++) {
            cost_count count;
            if (subjects.list[s].quantity != SG_L)
                continue;
            good = cost_counter_run(counter, subjects.list[s].id, subjects.list[s].glsl, &count);
            costs[i] = pixel ? count.pixel_instructions : count.instructions;
        }
        if (good)
            cost_subjects_free(&subjects);
    }
    cost_counter_close(counter);
    return good;
}

static bool measure_times(choose_unit unit, const char *device, double *costs)
{
    cost_points *points = malloc(sizeof *points);
    if (!points)
        abort();
    cost_points_fill(points);
    bool good = true;
    if (unit == CHOOSE_CPU) {
        for (size_t i = 0; i < sg_method_count(); i++)
            costs[i] = cost_time_batch_f32(points, sg_method_at(i)->L_batch_f32, COST_SAMPLES).best;
    } else {
        char reason[256];
        cost_device *opened = cost_device_open(device, points, reason);
        cost_subjects subjects = {0};
        good = opened && cost_subjects_read(&subjects, NULL);
        if (!opened)
            base_error("choose: the device cannot be measured: %s", reason);
        for (size_t i = 0; good && i < subjects.count; i++)
            if (subjects.list[i].method && subjects.list[i].quantity == SG_L)
                good = cost_device_run(opened, &subjects.list[i], COST_QUICK_SAMPLES,
                                       &costs[method_index(subjects.list[i].id)]);
        cost_subjects_free(&subjects);
        cost_device_close(opened);
    }
    free(points);
    return good;
}

bool choose_costs(choose_unit unit, const char *device, double *costs)
{
    for (size_t i = 0; i < sg_method_count(); i++)
        costs[i] = (double)NAN;
    if (unit == CHOOSE_CPU || unit == CHOOSE_DEVICE)
        return measure_times(unit, device, costs);
    bool pixel = unit == CHOOSE_GPU_PIXEL;
    return read_counts(pixel ? "gpu_pixel_instructions" : "gpu_include_instructions", costs) &&
           count_missing(pixel, costs);
}
