/* scenes_tune.c: the rivals' settings: every weighting of their samples on every scene, for the
 * choice that bench/rivals_tried.md explains. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/file.h"
#include "base/progress.h"
#include "base/text.h"
#include "render/hull.h"
#include "render/upsample.h"
#include "scenes.h"

/* ---- Settings that are tried ------------------------------------------------------------------
 */

enum { MOST = 512, BATCH = 16, GRID = 3 };

/* What is tried of a family: lists that end with 0. */
typedef struct grid {
    const char *family;
    uint32_t factors[GRID + 1];
    float planes[GRID + 1], powers[GRID + 1], leasts[GRID + 1];
} grid;
static const grid grids[] = {
    {"upsample", {2, 4, 8}, {0.25F, 1}, {8, 32}, {0.01F, 0.1F, 0.3F}},
    {"sh", {4, 8}, {0.5F, 1}, {2, 8}, {0.01F, 0.1F, 0.3F}},
    {"far", {4, 6, 10}, {0.5F, 1}, {2, 8}, {0.001F, 0.1F}},
};

typedef struct trial {
    const char *family;
    hull_settings hull;
    upsample_settings upsample;
} trial;

static gpu_status create_trial(render_frame *frame, const void *settings, void **state)
{
    const trial *t = settings;
    return t->family[0] == 'u' ? upsample_create(frame, &t->upsample, state)
                               : hull_create(frame, &t->hull, state);
}

static const render_pipeline *pipeline_of(const trial *t)
{
    return t->family[0] == 'u' ? &upsample4_pipeline : &upsample_sh4_pipeline;
}

static trial make_trial(const grid *g, int factor, int plane, int power, int least)
{
    trial t = {.family = g->family, .hull = hull_standard};
    t.hull.kind = HULL_UPSAMPLE;
    if (g->family[0] == 's')
        t.hull.tau = 0;
    t.hull.factor = t.upsample.factor = g->factors[factor];
    t.hull.plane = t.upsample.plane = g->planes[plane];
    t.hull.power = t.upsample.power = g->powers[power];
    t.hull.least = t.upsample.least = g->leasts[least];
    return t;
}

static size_t list_trials(trial trials[MOST])
{
    size_t count = 0;
    for (size_t i = 0; i < sizeof grids / sizeof *grids; i++) {
        const grid *g = &grids[i];
        for (int f = 0; g->factors[f]; f++)
            for (int p = 0; g->planes[p] > 0; p++)
                for (int n = 0; g->powers[n] > 0; n++)
                    for (int l = 0; g->leasts[l] > 0 && count < MOST; l++)
                        trials[count++] = make_trial(g, f, p, n, l);
    }
    return count;
}

/* ---- Measuring --------------------------------------------------------------------------------
 */

static void write_rows(FILE *out, const scenes_table *table, const trial *trials)
{
    for (size_t i = 0; i < table->count; i++) {
        const scenes_row *row = &table->rows[i];
        const render_statistics *s = &row->statistics;
        const trial *t = &trials[i];
        bool up = t->family[0] == 'u';
        const double numbers[] = {(double)(up ? t->upsample.factor : t->hull.factor),
                                  (double)t->hull.plane,
                                  (double)t->hull.power,
                                  (double)t->hull.least,
                                  100.0 * (double)s->light_evaluations /
                                      (double)s->ground_truth_evaluations,
                                  row->error.rel,
                                  row->error.p99,
                                  row->lighting_ms};
        fprintf(out, "%s,%s,%s", row->scene, row->detailed ? "detailed" : "smooth", t->family);
        for (size_t n = 0; n < sizeof numbers / sizeof *numbers; n++) {
            char text[BASE_NUMBER_SIZE];
            fprintf(out, ",%s", base_shortest_f64(numbers[n], text));
        }
        fputc('\n', out);
    }
}

static bool one_view(scenes_view *view, const trial *trials, size_t count, FILE *out)
{
    static const char *const none[] = {NULL};
    scenes_truth truth = {.light = NULL};
    scenes_variant variants[BATCH];
    bool good = true;
    view->known = &truth;
    view->variants = variants;
    for (size_t at = 0; at < count && good; at += BATCH) {
        size_t length = count - at < BATCH ? count - at : BATCH;
        for (size_t i = 0; i < length; i++) {
            const trial *t = &trials[at + i];
            variants[i] = (scenes_variant){"trial", pipeline_of(t), create_trial, t};
        }
        view->variant_count = length;
        scenes_table table = {0};
        good = scenes_measure(view, none, NULL, NULL, &table);
        if (good && table.count == length + 1) { /* none was left out */
            scenes_table tail = {table.rows + 1, length};
            write_rows(out, &tail, trials + at);
        }
        scenes_table_free(&table);
    }
    free(truth.light);
    return good;
}

static bool one_scene(const scenes_plan *plan, const char *path, const trial *trials, size_t count,
                      FILE *out, base_progress *progress)
{
    render_scene scene;
    if (!render_scene_read(path, plan->folder, &scene))
        return false;
    bool good = true;
    for (int detailed = 0; detailed < 2 && good; detailed++) {
        scenes_view view = {.device = plan->device,
                            .scene = &scene,
                            .name = scene.name,
                            .width = plan->quick ? 640 : 1280,
                            .height = plan->quick ? 360 : 720,
                            .detailed = detailed != 0,
                            .runs = 1,
                            .warm = plan->warm};
        good = one_view(&view, trials, count, out);
        base_progress_step(progress, scene.name);
    }
    render_scene_free(&scene);
    return good;
}

bool scenes_tune(const scenes_plan *plan)
{
    char **paths;
    size_t count, trial_count;
    if (!scenes_list(plan, false, &paths, &count))
        return false;
    char *csv = base_join(plan->out, "tune.csv");
    trial *trials = malloc(MOST * sizeof *trials);
    base_output output;
    bool good = trials != NULL && base_output_open(&output, csv);
    if (good) {
        trial_count = list_trials(trials);
        fputs("scene,normals,family,factor,plane,power,least,evaluations_percent,rel,p99,"
              "lighting_ms\n",
              output.stream);
        base_progress *progress = base_progress_begin("tune", 2 * count);
        for (size_t i = 0; i < count && good; i++)
            if (scenes_is_first_view(paths[i]))
                good = one_scene(plan, paths[i], trials, trial_count, output.stream, progress);
        base_progress_end(progress);
        if (good)
            good = base_output_close(&output);
        else
            base_output_discard(&output);
    }
    free(trials);
    free(csv);
    base_list_free(paths, count);
    return good;
}
