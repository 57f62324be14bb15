/* report_area.c: area lights with shadows in the report's section on scenes: what is asked of
 * fragments of several resolutions, the paper's figures and table 1, charts. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "html.h"
#include "plot.h"
#include "report_scenes.h"

/* ---- Bars ------------------------------------------------------------------------------------ */

enum { LEAST_WIDTH = 1024 /* the bars are of images this wide */ };

/* Our row of a view, until that of the rival comes. */
typedef struct pairs {
    scenes_bars *all;
    bool ours_there;
    scenes_fields ours;
    char place[SCENES_PLACE];
} pairs;

enum { SCENE, WIDTH, PIPELINE, REL, P99, SHARE, RATIO, RIVAL_RATIO, MS, SSIM };
static const char *const pair_columns[] = {"scene",
                                           "width",
                                           "pipeline",
                                           "rel",
                                           "p99",
                                           "percent_of_nichols",
                                           "times_faster_than_shadows",
                                           "times_faster_than_nichols",
                                           "lighting_ms",
                                           "ssim",
                                           NULL};

static void against_nichols(const pairs *p, const scenes_fields *rival)
{
    const double *ours = p->ours.number, *theirs = rival->number;
    const char *place = p->place;
    scenes_note(p->all, "multires: fragments, % of Nichols'", 53, false, ours[SHARE], place);
    scenes_note(p->all, "multires: fragments, % of Nichols' (aim)", 40, false, ours[SHARE], place);
    scenes_note(p->all, "multires: rel over Nichols'", 1, false, ours[REL] / theirs[REL], place);
    scenes_note(p->all, "multires: p99 over Nichols'", 1, false, ours[P99] / theirs[P99], place);
    scenes_note(p->all, "multires: structural dissimilarity over Nichols'", 1, false,
                (1 - ours[SSIM]) / (1 - theirs[SSIM]), place);
    scenes_note(p->all, "multires: times faster than every pixel", 4.3, true, ours[RATIO], place);
    scenes_note(p->all, "multires: times faster than Nichols", 2, true, ours[RIVAL_RATIO], place);
}

/* The rows of a view follow each other, upsampling before ours, ours before Nichols'. */
static void add_pair(void *context, const scenes_fields *f)
{
    pairs *p = context;
    if (!(f->number[WIDTH] >= LEAST_WIDTH))
        return;
    if (strcmp(f->text[PIPELINE], "multires") == 0) {
        p->ours = *f;
        p->ours_there = true;
        snprintf(p->place, sizeof p->place, "%s, %s", f->text[SCENE], f->text[WIDTH]);
    } else if (p->ours_there && strcmp(f->text[PIPELINE], "nichols") == 0) {
        against_nichols(p, f);
        p->ours_there = false;
    }
}

bool report_area_bars(report *report, scenes_bars *all)
{
    pairs p = {.all = all};
    return scenes_each_row(report, "shadows.csv", pair_columns, add_pair, &p);
}

/* ---- Charts ---------------------------------------------------------------------------------- */

/* A colour each. */
static const char *const pipelines[] = {"multires",      "multires_same", "multires_apart",
                                        "multires_lobe", "nichols",       "shadows2",
                                        "shadows4"};
enum { PIPELINES = sizeof pipelines / sizeof *pipelines };

typedef struct points {
    data_table *data;
    bool there[PIPELINES];
} points;

static void add_point(void *context, const scenes_fields *f)
{
    points *to = context;
    double row[PIPELINES + 1];
    int found = -1;
    for (int i = 0; i < PIPELINES; i++) {
        row[i + 1] = (double)NAN;
        if (strcmp(f->text[2], pipelines[i]) == 0)
            found = i;
    }
    if (found < 0 || !(f->number[0] > 0) || !(f->number[1] > 0))
        return;
    row[0] = f->number[0];
    row[found + 1] = f->number[1];
    to->there[found] = true;
    data_row(to->data, row);
}

static bool chart(report *report, const char *file, const char *x, const char *y, plot *p)
{
    static const char *const columns[] = {"x",
                                          "multires",
                                          "multires_same",
                                          "multires_apart",
                                          "multires_lobe",
                                          "nichols",
                                          "shadows2",
                                          "shadows4",
                                          NULL};
    const char *const names[] = {x, y, "pipeline", NULL};
    points all = {.data = data_new(columns)};
    bool good = scenes_each_row(report, file, names, add_point, &all);
    plot_series series[PIPELINES];
    for (int i = 0; i < PIPELINES; i++)
        if (all.there[i])
            series[p->series_count++] = (plot_series){pipelines[i], 1 + i, 1 + i, PLOT_MARKS, 2};
    p->data = all.data;
    p->series = series;
    p->x_log = p->y_log = true;
    p->x_label = x;
    p->y_label = y;
    good = good && (p->series_count == 0 || figure_panel(report->page, p));
    data_free(all.data);
    return good;
}

static bool charts(report *report)
{
    plot time = {.id = "area_time", .title = "error and time"};
    plot time_p99 = {.id = "area_time_p99", .title = "99th percentile and time"};
    plot fragments = {.id = "area_fragments", .title = "error and fragments"};
    plot rays = {.id = "area_rays", .title = "error and rays"};
    figure_begin(report->page, "area");
    bool good = chart(report, "shadows.csv", "lighting_ms", "rel", &time) &&
                chart(report, "shadows.csv", "lighting_ms", "p99", &time_p99);
    figure_end(report->page, "Area lights with shadows, every scene and size a point. "
                             "`multires_lobe` takes lights without shadow as spherical Gaussians, "
                             "integrated by `standard`.");
    figure_begin(report->page, "area_refinement");
    good = good && chart(report, "area_refinement.csv", "fragments", "rel", &fragments) &&
           chart(report, "area_refinement.csv", "visibility_rays", "rel", &rays);
    figure_end(report->page, "The built-in scene, fragments split where 1, 2, 4, 8 bits of "
                             "visibility differ: of 16 inside of a fragment (`multires`, "
                             "`multires_same`), of 64 between neighbours (`nichols`).");
    return good;
}

/* ---- Flicker ------------------------------------------------------------------------------- */

/* A row for each pipeline: its place on the axis, then flicker as the camera and the light move. */
typedef struct films {
    double own[PIPELINES][2];
    bool there[PIPELINES];
} films;

static void add_film(void *context, const scenes_fields *f)
{
    films *to = context;
    for (int i = 0; i < PIPELINES; i++)
        if (strcmp(f->text[1], pipelines[i]) == 0 && f->number[2] > 0) {
            to->own[i][strcmp(f->text[0], "light") == 0] = f->number[2];
            to->there[i] = true;
        }
}

static bool flicker(report *report)
{
    static const char *const names[] = {"moving", "pipeline", "own_rms", NULL};
    static const char *const columns[] = {"pipeline", "camera", "light", NULL};
    static const plot_series series[] = {{"the camera moves", 1, 1, PLOT_MARKS, 2},
                                         {"the lights move", 2, 2, PLOT_MARKS, 2}};
    films all = {.there = {false}};
    if (!scenes_are_there(report, "area_flicker.csv"))
        return true;
    bool good = scenes_each_row(report, "area_flicker.csv", names, add_film, &all);
    data_table *data = data_new(columns);
    char setup[512] = "set xtics noenhanced; set xtics (";
    int count = 0;
    for (int i = 0; i < PIPELINES; i++) {
        if (!all.there[i])
            continue;
        size_t used = strlen(setup);
        snprintf(setup + used, sizeof setup - used, "%s'%s' %d", count > 0 ? ", " : "",
                 pipelines[i], count + 1);
        data_row(data, (const double[]){++count, all.own[i][0], all.own[i][1]});
    }
    strcat(setup, ")");
    plot p = {.id = "area_flicker",
              .title = "flicker",
              .x_label = "pipeline",
              .y_label = "root mean square",
              .x_range = {0.5, count + 0.5},
              .setup = setup,
              .data = data,
              .series = series,
              .series_count = 2};
    if (good && count > 0) {
        figure_begin(report->page, "area_flicker");
        good = figure_panel(report->page, &p);
        figure_end(report->page,
                   "Flicker of area lights with shadows against every pixel with 64 rays, which "
                   "has none: root mean square, over pixels and frames, of the second difference "
                   "in time of the error, relative to the mean irradiance.");
    }
    data_free(data);
    return good;
}

/* ---- The section ----------------------------------------------------------------------------- */

bool report_area(report *report)
{
    static const char *const names[] = {"scene",
                                        "width",
                                        "height",
                                        "pipeline",
                                        "rel",
                                        "p99",
                                        "ssim",
                                        "fragments",
                                        "fragments_percent",
                                        "percent_of_nichols",
                                        "visibility_rays",
                                        "visibility_ms",
                                        "rays_per_second",
                                        "lighting_ms",
                                        "times_faster_than_shadows",
                                        "times_faster_than_nichols",
                                        NULL};
    static const char *const titles[] = {
        "scene",   "#width",     "#height",       "pipeline",       "#rel",  "#p99",
        "#SSIM",   "#fragments", "#% of pixels",  "#% of Nichols'", "#rays", "#tracing, ms",
        "#rays/s", "#all, ms",   "#times faster", "#than Nichols",  NULL};
    static const char *const film_names[] = {"moving", "pipeline", "own_rms", "ratio_to_truth",
                                             NULL};
    static const char *const film_titles[] = {"moving", "pipeline", "#own", "#ratio to truth",
                                              NULL};
    return report_scene_gallery(
               report, "shadows",
               "Area lights with shadows, after Koa and Johan's figures 3, 4 and 6: every pixel "
               "with 64 rays to each light (`shadows`), fragments of several resolutions "
               "(`multires`) with upsampling in a single pass, Nichols and Wyman's refinement "
               "(`nichols`) with upsampling from level to level; the fragments of both, of 1, 2, "
               "4, 8 and 16 pixels a side in red, orange, yellow, green and blue; and the errors "
               "of irradiance, relative to the image's mean and times four.") &&
           report_scene_table(
               report, "shadows.csv", names, titles,
               "Koa and Johan's table 1 on these scenes: fragments, time of tracing and "
               "refinement, time of all, beside the rivals. The paper has, for one scene of "
               "1024 x 768 pixels, 186,031 fragments in 72 ms, Nichols' 352,085 in 144 ms, and "
               "every pixel in 314 ms. A fragment is a place with 64 rays to each light: a square "
               "whose four parts trace 16, or a pixel that traces all; additional samples count. "
               "Errors and structural similarity are against every pixel with 64 rays; times are "
               "of interleaved runs on the device.") &&
           charts(report) && flicker(report) &&
           report_scene_table(report, "area_flicker.csv", film_names, film_titles,
                              "Flicker while the camera or the lights move: root mean square, over "
                              "pixels, of the second difference in time: of the error, and of the "
                              "irradiance against that of every pixel with 64 rays.");
}
