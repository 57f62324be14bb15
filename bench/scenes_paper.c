/* scenes_paper.c: the paper's figures 2, 3 and 4: the stages of its pipeline, and what becomes of
 * the picture where the cosine is taken as constant or as a lobe. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/buffer.h"
#include "base/file.h"
#include "base/progress.h"
#include "base/text.h"
#include "render/output.h"
#include "scenes.h"

static const char *const methods[] = {"meder_2018", "constant_cosine", "tokuyoshi_2016",
                                      "standard"};
enum { METHODS = sizeof methods / sizeof *methods };

typedef struct album {
    const char *folder, *method;
} album;

static bool look(void *context, render_frame *frame, const scenes_row *row, const float *light,
                 const float *truth, const float *errors)
{
    const album *a = context;
    (void)light;
    if (strcmp(row->pipeline, "exact") == 0)
        return scenes_write_image(a->folder, "truth", row, frame);
    char name[3 * SCENES_NAME];
    snprintf(name, sizeof name, "%s_%s_errors.png", row->scene, a->method);
    char *path = base_join(a->folder, name);
    bool good = scenes_write_image(a->folder, a->method, row, frame) &&
                scenes_write_errors(path, row->width, row->height, errors, truth);
    free(path);
    return good;
}

/* Figures 3 and 4: the same hull, integrated in different ways. */
static bool integrals(const scenes_plan *plan, const render_scene *scene, uint32_t width,
                      uint32_t height, const char *folder, scenes_table *table)
{
    static const char *const pipelines[] = {"meder", NULL};
    scenes_truth truth = {.light = NULL};
    bool good = true;
    for (int i = 0; i < METHODS && good; i++) {
        album a = {folder, methods[i]};
        scenes_view view = {.device = plan->device,
                            .scene = scene,
                            .name = scene->name,
                            .width = width,
                            .height = height,
                            .method = methods[i],
                            .known = &truth};
        good = scenes_measure(&view, pipelines, look, &a, table);
    }
    free(truth.light);
    return good;
}

/* Figure 2. */
static bool stages(const scenes_plan *plan, const render_scene *scene, uint32_t width,
                   uint32_t height, const char *folder)
{
    const render_pipeline *meder = render_pipeline_find("meder");
    render_frame frame;
    render_options options = {.width = width, .height = height, .runs = 1};
    render_statistics statistics;
    void *state = NULL;
    if (render_frame_create(plan->device, scene, &options, &frame) != GPU_OK) {
        base_error("bench: %s: %s", scene->name, gpu_last_error());
        return false;
    }
    bool made = meder->create(&frame, &state) == GPU_OK;
    bool good = made && render_frame_run(&frame, meder, state, &statistics) == GPU_OK;
    if (!good)
        base_error("bench: %s: %s", scene->name, gpu_last_error());
    good = good && meder->dump(&frame, state, folder);
    if (made)
        meder->destroy(state);
    render_frame_destroy(&frame);
    return good;
}

static bool one_scene(const scenes_plan *plan, const char *path, const char *folder,
                      scenes_table *table)
{
    render_scene scene;
    uint32_t width = plan->quick ? 480 : 1280, height = plan->quick ? 270 : 720;
    if (!render_scene_read(path, plan->folder, &scene))
        return false;
    char *stage_folder = base_join(plan->out, "stages");
    char *own = base_join(stage_folder, scene.name);
    bool good = base_make_directory(own) && stages(plan, &scene, width, height, own) &&
                integrals(plan, &scene, width, height, folder, table);
    free(own);
    free(stage_folder);
    render_scene_free(&scene);
    return good;
}

/* Its rows are the same for every method. */
static void leave_out_truth(scenes_table *table)
{
    size_t kept = 0;
    for (size_t i = 0; i < table->count; i++)
        if (strcmp(table->rows[i].pipeline, "exact") != 0)
            table->rows[kept++] = table->rows[i];
    table->count = kept;
}

bool scenes_paper(const scenes_plan *plan)
{
    char **paths;
    size_t count;
    if (!scenes_list(plan, false, &paths, &count))
        return false;
    scenes_table table = {0};
    char *folder = base_join(plan->out, "paper"), *csv = base_join(plan->out, "paper.csv");
    bool good = base_make_directory(folder);
    base_progress *progress = base_progress_begin("the paper's figures", count);
    for (size_t i = 0; i < count && good; i++) {
        if (scenes_is_first_view(paths[i]))
            good = one_scene(plan, paths[i], folder, &table);
        base_progress_step(progress, paths[i]);
    }
    base_progress_end(progress);
    leave_out_truth(&table);
    good = good && scenes_write_csv(&table, csv);
    free(folder);
    free(csv);
    scenes_table_free(&table);
    base_list_free(paths, count);
    return good;
}
