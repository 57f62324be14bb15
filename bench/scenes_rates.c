/* scenes_rates.c: the paper's table 1 at its four resolutions. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/file.h"
#include "base/progress.h"
#include "base/text.h"
#include "scenes.h"

/* Frame rates of Meder and Bruederlin 2018, table 1 (GeForce GTX 970): ground truth and hull. */
enum { SIZES = 4 };
static const uint32_t sizes[SIZES][2] = {{1280, 720}, {1920, 1080}, {2560, 1600}, {3840, 2400}};
static const struct {
    const char *scene;
    double truth[SIZES], hull[SIZES];
} paper[] = {
    {"bunny_sphere_dragon", {30.45, 11.37, 6.27, 2.71}, {179.34, 172.51, 130.16, 80.48}},
    {"sponza", {28.38, 10.59, 6.10, 2.44}, {142.26, 100.36, 72.71, 40.98}},
    {"conference", {28.55, 10.67, 6.22, 2.52}, {170.42, 145.11, 103.10, 63.23}},
};

static const char *const pipelines[] = {"hull", "hull_lobe", "meder", "limit", NULL};

/* Paper's ratio for the scene at that size; 0: the paper does not have it. */
static double paper_ratio(const char *scene, int size)
{
    for (size_t i = 0; i < sizeof paper / sizeof *paper; i++)
        if (strcmp(paper[i].scene, scene) == 0)
            return paper[i].hull[size] / paper[i].truth[size];
    return 0.0;
}

static bool write_rates(const scenes_table *table, const char *path)
{
    base_output output;
    if (!base_output_open(&output, path))
        return false;
    fputs("scene,width,height,pipeline,lighting_ms,exact_lighting_ms,lighting_ratio,frame_ms,"
          "exact_frame_ms,frame_ratio,paper_ratio,rel\n",
          output.stream);
    for (size_t i = 0; i < table->count; i++) {
        const scenes_row *row = &table->rows[i];
        int size = 0;
        while (size < SIZES - 1 && sizes[size][0] != row->width)
            size++;
        double rest = row->frame_ms;
        const double numbers[] = {row->lighting_ms,
                                  row->truth_ms,
                                  row->truth_ms / row->lighting_ms,
                                  row->lighting_ms + rest,
                                  row->truth_ms + rest,
                                  (row->truth_ms + rest) / (row->lighting_ms + rest),
                                  paper_ratio(row->scene, size),
                                  row->error.rel};
        fprintf(output.stream, "%s,%u,%u,%s", row->scene, row->width, row->height, row->pipeline);
        for (size_t n = 0; n < sizeof numbers / sizeof *numbers; n++) {
            char text[BASE_NUMBER_SIZE];
            fprintf(output.stream, ",%s", base_shortest_f64(numbers[n], text));
        }
        fputc('\n', output.stream);
    }
    return base_output_close(&output);
}

static bool one_scene(const scenes_plan *plan, const char *path, int size_count,
                      scenes_table *table, base_progress *progress)
{
    render_scene scene;
    if (!render_scene_read(path, plan->folder, &scene))
        return false;
    bool good = true;
    bool wanted = !plan->folder || paper_ratio(scene.name, 0) > 0.0;
    for (int s = 0; s < size_count && good; s++) {
        scenes_view view = {.device = plan->device,
                            .scene = &scene,
                            .name = scene.name,
                            .width = sizes[s][0],
                            .height = sizes[s][1],
                            .runs = plan->quick ? 1 : 3,
                            .enough_ms = 5000.0,
                            .warm = plan->warm};
        if (wanted)
            good = scenes_measure(&view, pipelines, NULL, NULL, table);
        base_progress_step(progress, scene.name);
    }
    render_scene_free(&scene);
    return good;
}

bool scenes_rates(const scenes_plan *plan)
{
    char **paths;
    size_t count;
    if (!scenes_list(plan, false, &paths, &count))
        return false;
    scenes_table table = {0};
    int size_count = !plan->folder || plan->quick ? 1 : SIZES;
    bool good = true;
    base_progress *progress = base_progress_begin("rates", count * (size_t)size_count);
    for (size_t i = 0; i < count && good; i++)
        good = one_scene(plan, paths[i], size_count, &table, progress);
    base_progress_end(progress);
    char *csv = base_join(plan->out, "rates.csv");
    good = good && write_rates(&table, csv);
    free(csv);
    scenes_table_free(&table);
    base_list_free(paths, count);
    return good;
}
