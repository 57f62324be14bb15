/* scenes_shadows.c: area lights with shadows: the paper's pipeline and its rivals against 64 rays
 * to each light at every pixel. */
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/buffer.h"
#include "base/file.h"
#include "base/progress.h"
#include "base/text.h"
#include "scenes_area.h"
#include "scenes_gallery.h"

/* Structural similarity of a picture. Pictures are seen in the order in which their runs end. */
typedef struct similarity {
    char scene[SCENES_NAME], pipeline[SCENES_NAME];
    uint32_t width;
    double ssim;
} similarity;

typedef struct measured {
    scenes_table table;
    similarity *ssim;
    size_t ssim_count;
    char *pictures; /* NULL: none of this view */
} measured;

uint64_t scenes_fragments(const render_statistics *statistics)
{
    uint64_t sum = 0;
    for (int level = 0; level < RENDER_LEVELS; level++)
        sum += statistics->fragments_by_level[level];
    return sum;
}

/* ---- The table ------------------------------------------------------------------------------- */

static double share(double part, double whole)
{
    return whole > 0.0 ? part / whole : 0.0;
}

/* The row of the same view by nichols; the row itself where there is none. */
static const scenes_row *nichols_of(const scenes_table *table, const scenes_row *row)
{
    for (size_t i = 0; i < table->count; i++) {
        const scenes_row *other = &table->rows[i];
        if (strcmp(other->scene, row->scene) == 0 && other->width == row->width &&
            strcmp(other->pipeline, "nichols") == 0)
            return other;
    }
    return row;
}

static double similarity_of(const measured *m, const scenes_row *row)
{
    for (size_t i = 0; i < m->ssim_count; i++) {
        const similarity *s = &m->ssim[i];
        if (strcmp(s->scene, row->scene) == 0 && s->width == row->width &&
            strcmp(s->pipeline, row->pipeline) == 0)
            return s->ssim;
    }
    return 1.0;
}

/* Of the passes that trace rays and refine. */
static double visibility_ms(const render_statistics *s)
{
    static const char *const words[] = {"visibility", "refinement", "shadows", "gather", "rays"};
    double sum = 0.0;
    for (int t = 0; t < s->time_count; t++) {
        bool found = false;
        for (size_t w = 0; w < sizeof words / sizeof *words; w++)
            found = found || strstr(s->times[t].name, words[w]) != NULL;
        if (strncmp(s->times[t].name, "reset", 5) != 0 && found)
            sum += s->times[t].ms;
    }
    return sum;
}

static void write_row(FILE *out, const measured *m, size_t i)
{
    const scenes_row *row = &m->table.rows[i], *rival = nichols_of(&m->table, row);
    const render_statistics *s = &row->statistics;
    double fragments = (double)scenes_fragments(s),
           theirs = (double)scenes_fragments(&rival->statistics),
           covered = (double)(s->pixels_covered + s->pixels_uncovered);
    const double numbers[] = {row->error.rel,
                              row->error.p50,
                              row->error.p99,
                              row->error.bias,
                              similarity_of(m, row),
                              fragments,
                              100.0 * share(fragments, covered),
                              100.0 * share(fragments, theirs),
                              (double)s->samples,
                              (double)s->visibility_rays,
                              visibility_ms(s),
                              1e3 * share((double)s->visibility_rays, visibility_ms(s)),
                              row->lighting_ms,
                              share(row->truth_ms, row->lighting_ms),
                              share(rival->lighting_ms, row->lighting_ms)};
    fprintf(out, "%s,%" PRIu32 ",%" PRIu32 ",%s", row->scene, row->width, row->height,
            row->pipeline);
    for (size_t n = 0; n < sizeof numbers / sizeof *numbers; n++) {
        char text[BASE_NUMBER_SIZE];
        fprintf(out, ",%s", base_shortest_f64(numbers[n], text));
    }
    fputc('\n', out);
}

static bool write_csv(const measured *m, const char *path)
{
    base_output output;
    if (!base_output_open(&output, path))
        return false;
    fputs("scene,width,height,pipeline,rel,p50,p99,bias,ssim,fragments,fragments_percent,"
          "percent_of_nichols,samples,visibility_rays,visibility_ms,rays_per_second,lighting_ms,"
          "times_faster_than_shadows,times_faster_than_nichols\n",
          output.stream);
    for (size_t i = 0; i < m->table.count; i++)
        write_row(output.stream, m, i);
    return base_output_close(&output);
}

/* ---- Pictures -------------------------------------------------------------------------------- */

/* The fragments of multires and nichols. */
static bool fragment_map(const measured *m, render_frame *frame, const scenes_row *row)
{
    bool wanted = strcmp(row->pipeline, "multires") == 0 || strcmp(row->pipeline, "nichols") == 0;
    if (!m->pictures || !wanted)
        return true;
    char name[3 * SCENES_NAME];
    snprintf(name, sizeof name, "%s_%s_fragments.png", row->scene, row->pipeline);
    char *path = base_join(m->pictures, name), *made = base_join(m->pictures, "fragments.png");
    bool good = render_pipeline_find(row->pipeline)->dump(frame, row->state, m->pictures);
    if (good && rename(made, path) != 0) {
        base_error("%s: cannot be written", path);
        good = false;
    }
    free(path);
    free(made);
    return good;
}

/* ---- Measuring ------------------------------------------------------------------------------- */

static bool look(void *context, render_frame *frame, const scenes_row *row, const float *light,
                 const float *truth, const float *errors)
{
    measured *m = context;
    m->ssim = base_reallocate(m->ssim, (m->ssim_count + 1) * sizeof *m->ssim);
    similarity *s = &m->ssim[m->ssim_count++];
    snprintf(s->scene, sizeof s->scene, "%s", row->scene);
    snprintf(s->pipeline, sizeof s->pipeline, "%s", row->pipeline);
    s->width = row->width;
    s->ssim = render_ssim(row->width, row->height, frame->gain, light, truth);
    return scenes_gallery(m->pictures, frame, row, light, truth, errors) &&
           fragment_map(m, frame, row);
}

/* At 1920 x 1080 what the bars need. Every variant where it is the first scene. */
static bool one_scene(const scenes_plan *plan, const char *path, bool first, char *pictures,
                      measured *m, base_progress *progress)
{
    static const uint32_t full[][2] = {{1024, 768}, {1920, 1080}}, quick[][2] = {{256, 192}};
    static const char *const every[] = {
        "multires", "multires_same", "multires_apart", "multires_lobe",
        "shadows2", "shadows4",      "nichols",        NULL};
    static const char *const rivals[] = {"multires", "shadows2", "nichols", NULL};
    static const char *const bars[] = {"multires", "nichols", NULL};
    const uint32_t(*sizes)[2] = plan->quick ? quick : full;
    int size_count = plan->quick ? 1 : 2;
    render_scene scene;
    if (!render_scene_read(path, plan->folder, &scene))
        return false;
    bool good = true;
    for (int s = 0; s < size_count && good; s++) {
        scenes_view view = {.device = plan->device,
                            .scene = &scene,
                            .name = scene.name,
                            .width = sizes[s][0],
                            .height = sizes[s][1],
                            .truth = "shadows",
                            .warm = plan->warm,
                            .runs = plan->quick ? 1 : 3,
                            .enough_ms = 3000.0};
        m->pictures = s == 0 ? pictures : NULL;
        good = scenes_measure(&view, s > 0 ? bars : first ? every : rivals, look, m, &m->table);
        base_progress_step(progress, scene.name);
    }
    render_scene_free(&scene);
    return good;
}

bool scenes_shadows(const scenes_plan *plan)
{
    /* quick: the first ones by name, whose trees are not deep */
    enum { FEW = 2 };
    char **paths;
    size_t count;
    if (!render_pipeline_find("shadows"))
        return true;
    if (!scenes_list(plan, true, &paths, &count))
        return false;
    size_t used = plan->quick && count > FEW ? FEW : count;
    measured m = {.ssim = NULL};
    char *pictures = base_join(plan->out, "shadows"), *csv = base_join(plan->out, "shadows.csv");
    bool good = base_make_directory(pictures);
    base_progress *progress = base_progress_begin("shadows", plan->quick ? used : 2 * used);
    for (size_t i = 0; i < used && good; i++)
        good = one_scene(plan, paths[i], i == 0, pictures, &m, progress);
    base_progress_end(progress);
    good = good && write_csv(&m, csv);
    free(pictures);
    free(csv);
    free(m.ssim);
    scenes_table_free(&m.table);
    base_list_free(paths, count);
    return good;
}
