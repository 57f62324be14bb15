/* scenes_views.c: every view at every size, on smooth and on detailed normals. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/file.h"
#include "base/progress.h"
#include "base/text.h"
#include "scenes.h"
#include "scenes_gallery.h"

enum { MOST_PIPELINES = 32 };

/* Without all, but those that take as long as ground truth and are no rivals at equal time. */
static void pipelines_of(bool all, const char *ids[MOST_PIPELINES])
{
    static const char *const slow[] = {"exact_unclipped", "upsample_sh2"};
    size_t count = 0;
    for (size_t i = 0; render_pipelines[i] && count + 1 < MOST_PIPELINES; i++) {
        bool wanted = !render_pipelines[i]->shadows;
        for (size_t k = 0; k < sizeof slow / sizeof *slow; k++)
            wanted = wanted && (all || strcmp(render_pipelines[i]->id, slow[k]) != 0);
        if (wanted)
            ids[count++] = render_pipelines[i]->id;
    }
    ids[count] = NULL;
}

/* As many as five minutes for all leave room for. */
static int runs_of(const scenes_plan *plan, bool detailed)
{
    return plan->quick && detailed ? 1 : plan->quick ? 2 : 3;
}

static bool one_scene(const scenes_plan *plan, const char *path, char *pictures,
                      scenes_table *table, base_progress *progress)
{
    static const uint32_t full[][2] = {{1280, 720}, {2560, 1440}}, quick[][2] = {{640, 360}};
    const uint32_t(*sizes)[2] = plan->quick ? quick : full;
    const char *ids[MOST_PIPELINES];
    render_scene scene;
    if (!render_scene_read(path, plan->folder, &scene))
        return false;
    int size_count = plan->quick ? 1 : 2;
    bool good = true;
    for (int s = 0; s < size_count && good; s++)
        for (int detailed = 0; detailed < 2 && good; detailed++) {
            /* an hour for all: large pictures of further views on smooth normals alone */
            bool brief = s > 0 && !scenes_is_first_view(path);
            base_progress_step(progress, scene.name);
            if (brief && detailed)
                continue;
            bool shows = s == 0 && !detailed;
            pipelines_of(shows && scenes_is_first_view(path), ids);
            scenes_view view = {.device = plan->device,
                                .scene = &scene,
                                .name = scene.name,
                                .width = sizes[s][0],
                                .height = sizes[s][1],
                                .detailed = detailed != 0,
                                .runs = runs_of(plan, detailed != 0),
                                .enough_ms = 1000.0,
                                .warm = plan->warm};
            good = scenes_measure(&view, ids, scenes_gallery, shows ? pictures : NULL, table);
        }
    render_scene_free(&scene);
    return good;
}

bool scenes_views(const scenes_plan *plan)
{
    char **paths;
    size_t count;
    if (!scenes_list(plan, false, &paths, &count))
        return false;
    scenes_table table = {0};
    char *pictures = base_join(plan->out, "pictures"), *csv = base_join(plan->out, "views.csv"),
         *passes = base_join(plan->out, "passes.csv"), *bars = base_join(plan->out, "bars.csv");
    bool good = base_make_directory(pictures);
    base_progress *progress = base_progress_begin("views", count * (plan->quick ? 2 : 4));
    for (size_t i = 0; i < count && good; i++)
        good = one_scene(plan, paths[i], pictures, &table, progress);
    base_progress_end(progress);
    good = good && scenes_write_csv(&table, csv) && scenes_write_passes(&table, passes) &&
           scenes_write_bars(&table, bars);
    free(pictures);
    free(csv);
    free(passes);
    free(bars);
    scenes_table_free(&table);
    base_list_free(paths, count);
    return good;
}
