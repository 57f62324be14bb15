/* stability_run.c: the scan of everything. Methods in C go side by side on all cores; the device
 * has its turn afterwards. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/file.h"
#include "base/progress.h"
#include "base/text.h"
#include "stability_private.h"

/* A method at a precision. */
typedef struct job {
    const sg_method *method;
    stability_precision precision;
    stability_table table;
    bool done, good;
} job;

typedef struct run {
    const stability_options *options;
    stability_grid *grids[STABILITY_PRECISIONS];
    job *jobs;
    size_t count;
    base_progress *progress;
} run;

void stability_table_free(stability_table *table)
{
    free(table->rows);
    *table = (stability_table){0};
}

void stability_add(stability_table *table, const stability_row *row)
{
    if (table->count == table->capacity) {
        table->capacity = table->capacity ? 2 * table->capacity : 32;
        table->rows = realloc(table->rows, table->capacity * sizeof *table->rows);
        if (!table->rows)
            abort();
    }
    table->rows[table->count++] = *row;
}

static bool draw(const run *r, const stability_subject *subject)
{
    if (!r->options->out)
        return true;
    char name[300];
    snprintf(name, sizeof name, "maps/%s_%s", subject->id,
             stability_precision_name(subject->precision));
    char *path = base_join(r->options->out, name);
    stability_map *map = stability_allocate(sizeof *map);
    bool good = stability_map_make(subject, map) && stability_map_write(map, path);
    free(map);
    free(path);
    return good;
}

static bool scan(run *r, job *job, const stability_subject *subject)
{
    stability_seams seams = {0};
    stability_seams_in_values(job->method->L_f64, job->precision, &seams);
    bool good =
        stability_scan(subject, r->grids[job->precision], &seams, &job->table) && draw(r, subject);
    stability_seams_free(&seams);
    base_progress_step(r->progress, subject->id);
    return good;
}

static void scan_job(void *context, size_t index)
{
    run *r = context;
    job *job = &r->jobs[index];
    stability_subject subject;
    if (job->precision == STABILITY_DEVICE)
        return;
    job->done = true;
    job->good =
        !stability_method_subject(job->method, job->precision, &subject) || scan(r, job, &subject);
}

static bool scan_device(run *r, stability_result *result)
{
    if (!r->options->device)
        return true;
    stability_device *device = stability_device_open(r->options->device, result->no_device);
    if (!device)
        return true;
    snprintf(result->device, sizeof result->device, "%s", stability_device_name(device));
    bool good = true;
    for (size_t i = 0; good && i < r->count; i++) {
        stability_subject subject;
        if (r->jobs[i].precision != STABILITY_DEVICE)
            continue;
        good = stability_device_subject(device, r->jobs[i].method, &subject) &&
               scan(r, &r->jobs[i], &subject);
        stability_device_forget(device);
    }
    stability_device_close(device);
    return good;
}

static void make_jobs(run *r)
{
    r->jobs = calloc(sg_method_count() * STABILITY_PRECISIONS, sizeof *r->jobs);
    if (!r->jobs)
        abort();
    for (size_t i = 0; i < sg_method_count(); i++)
        for (int p = 0; p < STABILITY_PRECISIONS; p++)
            if (!r->options->only || strcmp(r->options->only, sg_method_at(i)->id) == 0)
                r->jobs[r->count++] =
                    (job){.method = sg_method_at(i), .precision = (stability_precision)p};
}

/* Rows in the order of the jobs, whatever the order in which they ended. */
static bool collect(run *r, stability_result *result)
{
    bool good = true;
    for (size_t i = 0; i < r->count; i++) {
        const stability_table *found = &r->jobs[i].table;
        good = good && (r->jobs[i].good || r->jobs[i].precision == STABILITY_DEVICE);
        for (size_t k = 0; k < found->count; k++)
            stability_add(&result->failures, &found->rows[k]);
    }
    return good;
}

static bool make_folders(const char *out)
{
    if (!out)
        return true;
    char *maps = base_join(out, "maps");
    bool good = base_can_fill(maps) && base_make_directory(maps);
    free(maps);
    return good;
}

bool stability_run(const stability_options *options, stability_result *result)
{
    *result = (stability_result){0};
    if (!make_folders(options->out))
        return false;
    run r = {.options = options};
    make_jobs(&r);
    r.progress = base_progress_begin("stability", r.count);
    for (int p = 0; p < STABILITY_DEVICE; p++)
        r.grids[p] = stability_grid_new((stability_precision)p, options->quick);
    r.grids[STABILITY_DEVICE] = r.grids[STABILITY_F32];
    base_parallel(r.count, scan_job, &r);
    bool good = scan_device(&r, result);
    good = collect(&r, result) && good;
    if (good && !options->only)
        good = stability_operations(&result->failures);
    base_progress_end(r.progress);
    for (size_t i = 0; i < r.count; i++)
        stability_table_free(&r.jobs[i].table);
    for (int p = 0; p < STABILITY_DEVICE; p++)
        stability_grid_free(r.grids[p]);
    free(r.jobs);
    good = good && (!options->out || stability_write(options, result));
    if (!good)
        stability_result_free(result);
    return good;
}

void stability_result_free(stability_result *result)
{
    stability_table_free(&result->failures);
}
