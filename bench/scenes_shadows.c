/* scenes_shadows.c: area lights with shadows: every pipeline of theirs against 64 rays to each
 * light at every pixel. */
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/file.h"
#include "base/progress.h"
#include "base/text.h"
#include "scenes.h"
#include "scenes_gallery.h"

enum { MOST_PIPELINES = 32 };

static uint64_t fragments_of(const render_statistics *statistics)
{
    uint64_t sum = 0;
    for (int level = 0; level < RENDER_LEVELS; level++)
        sum += statistics->fragments_by_level[level];
    return sum;
}

static bool write_csv(const scenes_table *table, const char *path)
{
    base_output output;
    if (!base_output_open(&output, path))
        return false;
    fputs("scene,width,height,pipeline,rel,p50,p99,bias,fragments,fragments_percent,samples,"
          "visibility_rays,lighting_ms,times_faster_than_shadows\n",
          output.stream);
    for (size_t i = 0; i < table->count; i++) {
        const scenes_row *row = &table->rows[i];
        const render_statistics *s = &row->statistics;
        uint64_t fragments = fragments_of(s);
        double covered = (double)(s->pixels_covered + s->pixels_uncovered);
        char text[8][BASE_NUMBER_SIZE];
        fprintf(
            output.stream, "%s,%u,%u,%s,%s,%s,%s,%s,%" PRIu64 ",%s,%" PRIu64 ",%" PRIu64 ",%s,%s\n",
            row->scene, row->width, row->height, row->pipeline,
            base_shortest_f64(row->error.rel, text[0]), base_shortest_f64(row->error.p50, text[1]),
            base_shortest_f64(row->error.p99, text[2]), base_shortest_f64(row->error.bias, text[3]),
            fragments,
            base_shortest_f64(covered > 0.0 ? 100.0 * (double)fragments / covered : 0.0, text[4]),
            s->samples, s->visibility_rays, base_shortest_f64(row->lighting_ms, text[5]),
            base_shortest_f64(row->truth_ms / row->lighting_ms, text[6]));
    }
    return base_output_close(&output);
}

static void pipelines_with_shadows(const char *ids[MOST_PIPELINES])
{
    size_t count = 0;
    for (size_t i = 0; render_pipelines[i] && count + 1 < MOST_PIPELINES; i++)
        if (render_pipelines[i]->shadows)
            ids[count++] = render_pipelines[i]->id;
    ids[count] = NULL;
}

static bool one_scene(const scenes_plan *plan, const char *path, char *pictures,
                      scenes_table *table, base_progress *progress)
{
    static const uint32_t full[][2] = {{1024, 768}, {1920, 1080}}, quick[][2] = {{640, 480}};
    const uint32_t(*sizes)[2] = plan->quick ? quick : full;
    const char *ids[MOST_PIPELINES];
    pipelines_with_shadows(ids);
    render_scene scene;
    if (!render_scene_read(path, plan->folder, &scene))
        return false;
    bool good = true;
    for (int s = 0; s < (plan->quick ? 1 : 2) && good; s++) {
        scenes_view view = {.device = plan->device,
                            .scene = &scene,
                            .name = scene.name,
                            .width = sizes[s][0],
                            .height = sizes[s][1],
                            .truth = "shadows",
                            .runs = plan->quick ? 1 : 3};
        good = scenes_measure(&view, ids, scenes_gallery, s == 0 ? pictures : NULL, table);
        base_progress_step(progress, scene.name);
    }
    render_scene_free(&scene);
    return good;
}

bool scenes_shadows(const scenes_plan *plan)
{
    char **paths;
    size_t count;
    if (!render_pipeline_find("shadows"))
        return true;
    if (!scenes_list(plan, true, &paths, &count))
        return false;
    scenes_table table = {0};
    char *pictures = base_join(plan->out, "shadows"), *csv = base_join(plan->out, "shadows.csv");
    bool good = base_make_directory(pictures);
    base_progress *progress = base_progress_begin("shadows", count * (plan->quick ? 1 : 2));
    for (size_t i = 0; i < count && good; i++)
        good = one_scene(plan, paths[i], pictures, &table, progress);
    base_progress_end(progress);
    good = good && write_csv(&table, csv);
    free(pictures);
    free(csv);
    scenes_table_free(&table);
    base_list_free(paths, count);
    return good;
}
