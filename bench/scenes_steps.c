/* scenes_steps.c: what every refinement between the paper's hull and ours buys: error and time of
 * each step on the first view of every scene. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/file.h"
#include "base/progress.h"
#include "render/hull.h"
#include "scenes.h"

static gpu_status create_hull(render_frame *frame, const void *settings, void **state)
{
    return hull_create(frame, settings, state);
}

enum { STEPS = 6 };
static const float never = 1e9F;

/* Lobes from the polygons' exact moments, or the moments themselves (spherical harmonics
 * of order 2 and gradients); quads split where the light bends; near lights exact. With both of
 * these they are `hull_lobe` and `hull`. */
static void make_steps(hull_settings settings[STEPS], scenes_variant steps[STEPS])
{
    static const struct {
        const char *id;
        hull_kind kind;
        bool splits, near;
    } of[STEPS] = {
        {"lobes", HULL_LOBES, false, false},          {"lobes_split", HULL_LOBES, true, false},
        {"lobes_near", HULL_LOBES, false, true},      {"moments", HULL_MOMENTS, false, false},
        {"moments_split", HULL_MOMENTS, true, false}, {"moments_near", HULL_MOMENTS, false, true},
    };
    for (int i = 0; i < STEPS; i++) {
        settings[i] = of[i].kind == HULL_LOBES ? hull_lobe_standard : hull_standard;
        if (!of[i].splits)
            settings[i].split = never;
        if (!of[i].near)
            settings[i].tau = never; /* no light is so near */
        steps[i] = (scenes_variant){.like = of[i].kind == HULL_LOBES ? &hull_lobe_pipeline
                                                                     : &hull_pipeline,
                                    .create = create_hull,
                                    .settings = &settings[i]};
        snprintf(steps[i].id, sizeof steps[i].id, "%s", of[i].id);
    }
}

static bool one_scene(const scenes_plan *plan, const char *path, scenes_table *table)
{
    static const char *const pipelines[] = {"meder", "hull_lobe", "hull", NULL};
    hull_settings settings[STEPS];
    scenes_variant steps[STEPS];
    render_scene scene;
    if (!render_scene_read(path, plan->folder, &scene))
        return false;
    make_steps(settings, steps);
    scenes_view view = {.device = plan->device,
                        .scene = &scene,
                        .name = scene.name,
                        .width = plan->quick ? 480 : 1280,
                        .height = plan->quick ? 270 : 720,
                        .runs = plan->quick ? 2 : 3,
                        .enough_ms = 2000.0,
                        .warm = plan->warm,
                        .variants = steps,
                        .variant_count = STEPS};
    bool good = scenes_measure(&view, pipelines, NULL, NULL, table);
    render_scene_free(&scene);
    return good;
}

bool scenes_steps(const scenes_plan *plan)
{
    char **paths;
    size_t count;
    if (!scenes_list(plan, false, &paths, &count))
        return false;
    scenes_table table = {0};
    bool good = true;
    base_progress *progress = base_progress_begin("steps", count);
    for (size_t i = 0; i < count && good; i++) {
        if (scenes_is_first_view(paths[i]))
            good = one_scene(plan, paths[i], &table);
        base_progress_step(progress, paths[i]);
    }
    base_progress_end(progress);
    char *csv = base_join(plan->out, "steps.csv");
    good = good && scenes_write_csv(&table, csv);
    free(csv);
    scenes_table_free(&table);
    base_list_free(paths, count);
    return good;
}
