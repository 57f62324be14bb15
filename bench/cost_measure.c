/* cost_measure.c: every subject through every harness, in one run. */
#include "cost.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/progress.h"
#include "base/text.h"
#include "score.h"

static const cost_time unknown_time = {(double)NAN, (double)NAN};

/* A_h is scored as L is, after division by the exact integral, so that the two compare. */
static double A_h_f32(const void *context, double lambda, double cos_theta)
{
    const sg_method *method = context;
    return (double)method->A_h_f32((float)lambda, (float)cos_theta) / sg_A(lambda);
}

static void score(cost_row *row)
{
    const sg_method *method = row->subject->method;
    if (!method)
        return;
    score_result result;
    if (row->subject->quantity == SG_L)
        score_method(method, SCORE_F32, &result);
    else
        score_run(&(score_subject){A_h_f32, NULL, method, method->lambda_min, method->lambda_max},
                  SCORE_F32, &result);
    row->max_abs_f32 = result.max_abs;
    row->rmse_f32 = result.rmse;
}

/* A table's errors are those of the device: only there is its text run. */
static bool score_tables(cost_table *table, cost_device *device)
{
    const size_t count = (size_t)SCORE_LAMBDAS * SCORE_ANGLES;
    float *pairs = malloc(2 * count * sizeof *pairs), *values = malloc(count * sizeof *values);
    if (!pairs || !values)
        abort();
    for (size_t i = 0; i < count; i++) {
        pairs[2 * i] = (float)score_lambda(i / SCORE_ANGLES);
        pairs[2 * i + 1] = (float)cos(score_beta(i % SCORE_ANGLES));
    }
    const double *truth = score_truth(SCORE_F32);
    bool good = true;
    for (size_t s = 0; s < table->subjects.count && good; s++) {
        cost_row *row = &table->rows[s];
        if (row->subject->method)
            continue;
        good = cost_device_values(device, row->subject, count, pairs, values);
        double largest = 0, sum = 0;
        for (size_t i = 0; i < count && good; i++) {
            double scale = row->subject->quantity == SG_L ? 1 : sg_A((double)pairs[2 * i]);
            double error = fabs((double)values[i] / scale - truth[i]);
            largest = fmax(largest, error);
            sum += error * error;
        }
        row->max_abs_f32 = largest;
        row->rmse_f32 = sqrt(sum / (double)count);
    }
    free(pairs);
    free(values);
    return good;
}

static void time_cpu(cost_row *row, const cost_points *points, int samples)
{
    const sg_method *m = row->subject->method;
    if (!m)
        return;
    bool L = row->subject->quantity == SG_L;
    row->f32 = cost_time_f32(points, L ? m->L_f32 : m->A_h_f32, samples);
    row->f64 = cost_time_f64(points, L ? m->L_f64 : m->A_h_f64, samples);
    row->batch_f32 = cost_time_batch_f32(points, L ? m->L_batch_f32 : m->A_h_batch_f32, samples);
    row->batch_f64 = cost_time_batch_f64(points, L ? m->L_batch_f64 : m->A_h_batch_f64, samples);
}

static bool count_all(cost_table *table, base_progress *progress)
{
    bool good = true;
    for (int family = 0; family < COST_FAMILIES && good; family++) {
        char reason[256];
        cost_counter *counter = cost_counter_open(cost_families[family], reason);
        if (!counter) {
            base_error("instructions are not counted: %s", reason);
            if (!table->counter_driver[0])
                snprintf(table->counter_driver, sizeof table->counter_driver, "%s", reason);
            continue;
        }
        table->counted = true;
        snprintf(table->counter_driver, sizeof table->counter_driver, "%s",
                 cost_counter_driver(counter));
        for (size_t i = 0; i < table->subjects.count && good; i++) {
            const cost_subject *subject = &table->subjects.list[i];
            base_progress_step(progress, subject->id);
            cost_row *row = &table->rows[i];
            good = cost_counter_run(counter, subject->id, subject->glsl, &row->counts[family]);
            if (family == 0)
                row->include = row->counts[0];
            if (good && family == 0 && subject->include)
                good = cost_counter_run(counter, subject->id, subject->include, &row->include);
        }
        cost_counter_close(counter);
    }
    return good;
}

static bool run_device(cost_table *table, const cost_points *points, base_progress *progress)
{
    char reason[256];
    cost_device *device = cost_device_open(table->options.device, points, reason);
    if (!device) {
        base_error("the device is not measured: %s", reason);
        snprintf(table->device_driver, sizeof table->device_driver, "%s", reason);
        return true;
    }
    snprintf(table->device_name, sizeof table->device_name, "%s", cost_device_name(device));
    snprintf(table->device_driver, sizeof table->device_driver, "%s", cost_device_driver(device));
    bool good = score_tables(table, device);
    for (size_t i = 0; i < table->subjects.count && good && !table->options.counts_only; i++) {
        base_progress_step(progress, table->subjects.list[i].id);
        good = cost_device_run(device, &table->subjects.list[i], table->samples,
                               &table->rows[i].device_ratio);
    }
    cost_device_close(device);
    return good;
}

static float nothing(float lambda, float cos_theta)
{
    return lambda + cos_theta;
}

static bool time_all(cost_table *table, base_progress *progress)
{
    cost_points *points = malloc(sizeof *points);
    if (!points)
        abort();
    cost_points_fill(points);
    if (!table->options.counts_only)
        table->call_overhead = cost_time_f32(points, nothing, table->samples).best;
    for (size_t i = 0; i < table->subjects.count && !table->options.counts_only; i++) {
        base_progress_step(progress, table->subjects.list[i].id);
        time_cpu(&table->rows[i], points, table->samples);
    }
    bool good = !table->options.device || run_device(table, points, progress);
    free(points);
    return good;
}

bool cost_measure(cost_table *table, const cost_options *options)
{
    *table = (cost_table){.options = *options,
                          .samples = options->quick ? COST_QUICK_SAMPLES : COST_SAMPLES,
                          .call_overhead = (double)NAN};
    if (!cost_subjects_read(&table->subjects, options->only))
        return false;
    size_t count = table->subjects.count;
    table->rows = calloc(count, sizeof *table->rows);
    if (!table->rows)
        abort();
    for (size_t i = 0; i < count; i++) {
        cost_row *row = &table->rows[i];
        *row = (cost_row){.subject = &table->subjects.list[i],
                          .max_abs_f32 = (double)NAN,
                          .rmse_f32 = (double)NAN,
                          .f32 = unknown_time,
                          .f64 = unknown_time,
                          .batch_f32 = unknown_time,
                          .batch_f64 = unknown_time,
                          .device_ratio = (double)NAN};
        row->include = cost_unknown;
        for (int family = 0; family < COST_FAMILIES; family++)
            row->counts[family] = cost_unknown;
    }
    size_t passes = options->counts_only ? 1 : options->device ? 3 : 2;
    base_progress *progress = base_progress_begin("bench", count * (COST_FAMILIES + passes));
    for (size_t i = 0; i < count; i++) {
        base_progress_step(progress, table->subjects.list[i].id);
        score(&table->rows[i]);
    }
    bool good = count_all(table, progress) && time_all(table, progress);
    base_progress_end(progress);
    if (!good)
        cost_table_free(table);
    return good;
}

void cost_table_free(cost_table *table)
{
    cost_subjects_free(&table->subjects);
    free(table->rows);
    table->rows = NULL;
}
