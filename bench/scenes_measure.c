/* scenes_measure.c: one view by several pipelines, interleaved, against ground truth. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/buffer.h"
#include "base/order.h"
#include "base/text.h"
#include "scenes.h"

enum { MOST_PIPELINES = 32, MOST_RUNS = 15 };

/* A pipeline at work: its state and the time of each run. */
typedef struct job {
    const render_pipeline *pipeline;
    void *state;
    bool left_out; /* the device cannot do it */
    bool done;     /* no run remains */
    scenes_row row;
    double ms[MOST_RUNS];
    size_t runs; /* so far */
} job;

static bool failed(const scenes_view *view, const char *id)
{
    base_error("%s at %ux%u, pipeline %s: %s", view->name, view->width, view->height, id,
               gpu_last_error());
    return false;
}

/* What a device cannot do is told in a line and left out; false where nothing else will run there
 * either. */
static bool goes_on(const scenes_view *view, job *j, gpu_status status)
{
    if (status == GPU_OK)
        return true;
    j->left_out = true;
    failed(view, j->row.pipeline);
    return status != GPU_DEVICE_LOST && status != GPU_NO_DEVICE;
}

/* Of the passes that every pipeline shares, or of its own. */
static double sum_of_times(const render_statistics *statistics, bool shared)
{
    static const char *const names[] = {"gbuffer", "rsm", "resolve"};
    double sum = 0.0;
    for (int i = 0; i < statistics->time_count; i++) {
        bool found = false;
        for (size_t n = 0; n < sizeof names / sizeof *names; n++)
            found = found || strcmp(statistics->times[i].name, names[n]) == 0;
        sum += found == shared ? statistics->times[i].ms : 0.0;
    }
    return sum;
}

static bool run_once(render_frame *frame, const scenes_view *view, job *j)
{
    gpu_status status = render_frame_run(frame, j->pipeline, j->state, &j->row.statistics);
    if (status != GPU_OK)
        return goes_on(view, j, status);
    j->ms[j->runs++] = sum_of_times(&j->row.statistics, false);
    j->row.frame_ms = sum_of_times(&j->row.statistics, true);
    return true;
}

/* Signed error of a pixel relative to the mean of the truth, over the three channels. */
static double signed_error(const float *light, const float *truth, double mean)
{
    double sum = 0.0;
    for (int c = 0; c < 3; c++)
        sum += (double)light[c] - (double)truth[c];
    return mean > 0.0 ? sum / (3.0 * mean) : 0.0;
}

static double jump_p99(const scenes_view *view, const float *light, const float *truth)
{
    size_t pixels = (size_t)view->width * view->height, count = 0;
    double sum = 0.0, covered = 0.0;
    for (size_t i = 0; i < pixels; i++)
        if (truth[4 * i + 3] != 0.0f) {
            sum += (double)truth[4 * i] + (double)truth[4 * i + 1] + (double)truth[4 * i + 2];
            covered += 3.0;
        }
    double mean = covered > 0.0 ? sum / covered : 0.0;
    double *jumps = base_allocate((pixels + 1) * sizeof *jumps);
    for (size_t i = 0; i + 1 < pixels; i++) {
        if ((i + 1) % view->width == 0 || truth[4 * i + 3] == 0.0f || truth[4 * i + 7] == 0.0f)
            continue;
        jumps[count++] = fabs(signed_error(light + 4 * i + 4, truth + 4 * i + 4, mean) -
                              signed_error(light + 4 * i, truth + 4 * i, mean));
    }
    double found = count ? base_select(jumps, count, (size_t)(0.99 * (double)(count - 1))) : 0.0;
    free(jumps);
    return found;
}

static void add_row(scenes_table *table, const scenes_row *row)
{
    table->rows = base_reallocate(table->rows, (table->count + 1) * sizeof *table->rows);
    table->rows[table->count++] = *row;
}

/* What the frame shows now, compared. */
static bool look_at(render_frame *frame, const scenes_view *view, job *j, float *light,
                    const float *truth, float *errors, scenes_look look, void *context)
{
    size_t pixels = (size_t)view->width * view->height;
    if (gpu_image_read(frame->light, light) != GPU_OK)
        return failed(view, j->pipeline->id);
    render_compare(pixels, light, truth, errors, &j->row.error);
    j->row.jump_p99 = jump_p99(view, light, truth);
    j->row.state = j->state;
    bool good = !look || look(context, frame, &j->row, light, truth, errors);
    j->row.state = NULL;
    return good;
}

static bool keep_truth(render_frame *frame, const scenes_view *view, float *truth)
{
    return gpu_image_read(frame->light, truth) == GPU_OK || failed(view, "truth");
}

static bool is_warm(const scenes_warmth *warm, const render_pipeline *pipeline)
{
    for (size_t i = 0; warm && i < warm->count; i++)
        if (warm->of[i] == pipeline)
            return true;
    return false;
}

/* A driver compiles at the first use: a round that does not count. */
static bool warm_up(render_frame *frame, const scenes_view *view, job *jobs, size_t first,
                    size_t count)
{
    scenes_warmth *warm = view->warm;
    for (size_t i = first; i < count; i++) {
        const render_pipeline *pipeline = jobs[i].pipeline;
        if (jobs[i].left_out || jobs[i].done || is_warm(warm, pipeline))
            continue;
        if (!run_once(frame, view, &jobs[i]))
            return false;
        jobs[i].runs = 0;
        if (warm && warm->count < sizeof warm->of / sizeof *warm->of)
            warm->of[warm->count++] = pipeline;
    }
    return true;
}

/* The truth from a former measurement, as far as there is one. */
static void recall_truth(const scenes_view *view, job *truth, float *light)
{
    const scenes_truth *known = view->known;
    if (!known || !known->light)
        return;
    truth->row = known->row;
    truth->ms[truth->runs++] = known->row.lighting_ms;
    truth->done = true;
    memcpy(light, known->light, (size_t)view->width * view->height * 4 * sizeof *light);
}

static void remember_truth(const scenes_view *view, const job *truth, const float *light)
{
    size_t bytes = (size_t)view->width * view->height * 4 * sizeof *light;
    if (!view->known || view->known->light)
        return;
    view->known->row = truth->row;
    view->known->light = memcpy(base_allocate(bytes + 1), light, bytes);
}

/* After the last of the runs, or after one that took long enough to be sure of: not the first, in
 * which a driver may have compiled: shaders made of text for each frame, others for another size.
 */
static bool has_run_enough(const scenes_view *view, const job *j, bool truth)
{
    return (int)j->runs >= view->runs || j->runs == MOST_RUNS ||
           (view->enough_ms > 0.0 && j->ms[j->runs - 1] >= view->enough_ms &&
            (truth || j->runs > 1));
}

/* The first round keeps the truth; each pipeline is looked at after its last run, while the frame
 * holds what it made. */
static bool run_all(render_frame *frame, const scenes_view *view, job *jobs, size_t count,
                    scenes_look look, void *context)
{
    size_t pixels = (size_t)view->width * view->height;
    float *truth = base_allocate((pixels + 1) * 4 * sizeof *truth),
          *light = base_allocate((pixels + 1) * 4 * sizeof *light),
          *errors = base_allocate((pixels + 1) * sizeof *errors);
    recall_truth(view, &jobs[0], truth);
    /* one run: of what is too long for two, the truth the longest */
    bool good = view->runs < 1 || warm_up(frame, view, jobs, view->runs > 1 ? 0 : 1, count);
    bool remain = true;
    while (remain && good) {
        remain = false;
        for (size_t i = 0; i < count && good && !jobs[0].left_out; i++) {
            job *j = &jobs[i];
            if (j->done || j->left_out)
                continue;
            good = run_once(frame, view, j);
            if (!good || j->left_out)
                continue;
            if (i == 0 && j->runs == 1)
                good = keep_truth(frame, view, truth);
            j->done = has_run_enough(view, j, i == 0);
            remain = remain || !j->done;
            if (good && j->done)
                good = look_at(frame, view, j, light, truth, errors, look, context);
        }
    }
    for (size_t i = 0; i < count && good; i++) {
        job *j = &jobs[i];
        /* of two the lesser: a scene may be the first to draw what a driver has to compile yet */
        j->row.lighting_ms = j->runs > 0 ? base_select(j->ms, j->runs, (j->runs - 1) / 2) : 0.0;
        j->row.truth_ms = jobs[0].row.lighting_ms;
    }
    if (good && !jobs[0].left_out)
        remember_truth(view, &jobs[0], truth);
    free(truth);
    free(light);
    free(errors);
    return good;
}

static void name_row(const scenes_view *view, const char *id, scenes_row *row)
{
    snprintf(row->scene, sizeof row->scene, "%s", view->name);
    snprintf(row->pipeline, sizeof row->pipeline, "%s", id);
    snprintf(row->method, sizeof row->method, "%s", view->method ? view->method : "standard");
    row->width = view->width;
    row->height = view->height;
    row->detailed = view->detailed;
}

static bool start(render_frame *frame, const scenes_view *view, const char *id, job *j)
{
    *j = (job){.pipeline = render_pipeline_find(id)};
    if (!j->pipeline) {
        base_error("bench: there is no pipeline \"%s\"", id);
        return false;
    }
    name_row(view, id, &j->row);
    return goes_on(view, j, j->pipeline->create(frame, &j->state));
}

static bool start_variant(render_frame *frame, const scenes_view *view,
                          const scenes_variant *variant, job *j)
{
    *j = (job){.pipeline = variant->like};
    name_row(view, variant->id, &j->row);
    return goes_on(view, j, variant->create(frame, variant->settings, &j->state));
}

/* The truth, then the others. */
static bool start_all(render_frame *frame, const scenes_view *view, const char *truth,
                      const char *const *pipelines, job *jobs, size_t *count)
{
    bool good = start(frame, view, truth, &jobs[(*count)++]);
    for (; good && *pipelines && *count < MOST_PIPELINES; pipelines++)
        if (strcmp(*pipelines, truth) != 0 && render_pipeline_find(*pipelines))
            good = start(frame, view, *pipelines, &jobs[(*count)++]);
    for (size_t i = 0; good && i < view->variant_count && *count < MOST_PIPELINES; i++)
        good = start_variant(frame, view, &view->variants[i], &jobs[(*count)++]);
    return good;
}

bool scenes_measure(const scenes_view *view, const char *const *pipelines, scenes_look look,
                    void *context, scenes_table *table)
{
    const char *truth = view->truth ? view->truth : "exact";
    render_frame frame;
    render_options options = {.width = view->width,
                              .height = view->height,
                              .method = view->method,
                              .detailed_normals = view->detailed,
                              .runs = 1};
    if (render_frame_create(view->device, view->scene, &options, &frame) != GPU_OK)
        return failed(view, truth);
    job *jobs = base_allocate(MOST_PIPELINES * sizeof *jobs);
    size_t count = 0;
    bool good = start_all(&frame, view, truth, pipelines, jobs, &count) &&
                run_all(&frame, view, jobs, count, look, context);
    for (size_t i = 0; i < count; i++) {
        if (good && !jobs[0].left_out && !jobs[i].left_out)
            add_row(table, &jobs[i].row);
        if (jobs[i].state)
            jobs[i].pipeline->destroy(jobs[i].state);
    }
    free(jobs);
    render_frame_destroy(&frame);
    return good;
}

void scenes_table_free(scenes_table *table)
{
    free(table->rows);
    *table = (scenes_table){0};
}
