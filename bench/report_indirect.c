/* report_indirect.c: one bounce by the light propagation volume against traced paths. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "html.h"
#include "plot.h"
#include "report_scenes.h"

enum { MOST_SCENES = 8 };

typedef struct points {
    data_table *data;
    char scenes[MOST_SCENES][64];
    int count;
} points;

/* A row for each setting: time, volume, steps and the error in its scene's column. */
static void add_point(void *context, const scenes_fields *f)
{
    points *p = context;
    double row[3 + MOST_SCENES];
    int scene = 0;
    while (scene < p->count && strcmp(p->scenes[scene], f->text[0]) != 0)
        scene++;
    if (scene == MOST_SCENES || strcmp(f->text[1], "ours") != 0)
        return;
    if (scene == p->count)
        snprintf(p->scenes[p->count++], sizeof p->scenes[0], "%s", f->text[0]);
    for (int i = 0; i < 3; i++)
        row[i] = f->number[2 + i];
    for (int i = 0; i < MOST_SCENES; i++)
        row[3 + i] = i == scene ? f->number[5] : (double)NAN;
    data_row(p->data, row);
}

static bool panels(report *report, const points *p)
{
    static const char *const ids[] = {"indirect_ms", "indirect_volume", "indirect_steps"};
    static const char *const labels[] = {"indirect light, ms", "voxels along the longest side",
                                         "steps"};
    plot_series series[MOST_SCENES];
    for (int i = 0; i < p->count; i++)
        series[i] = (plot_series){p->scenes[i], 3 + i, 1 + i, PLOT_MARKS, 2};
    bool good = true;
    for (int i = 0; i < 3 && good; i++) {
        plot one = {.id = ids[i],
                    .title = "one bounce",
                    .x_label = labels[i],
                    .y_label = "rel",
                    .x = i,
                    .x_log = true,
                    .y_log = true,
                    .data = p->data,
                    .series = series,
                    .series_count = (size_t)p->count};
        good = figure_panel(report->page, &one);
    }
    return good;
}

bool report_indirect(report *report)
{
    static const char *const chart_names[] = {"scene", "propagation", "ms", "volume",
                                              "steps", "rel",         NULL};
    static const char *const columns[] = {"ms", "volume", "steps", "s1", "s2", "s3",
                                          "s4", "s5",     "s6",    "s7", "s8", NULL};
    static const char *const names[] = {
        "scene", "propagation",     "volume", "steps", "volume_samples", "voxels",
        "rel",   "reference_noise", "bias",   "ms",    "frame_percent",  NULL};
    static const char *const titles[] = {"scene",    "propagation", "#volume",     "#steps",
                                         "#samples", "#voxels",     "#rel",        "#noise",
                                         "#bias",    "#ms",         "#% of frame", NULL};
    if (!scenes_are_there(report, "indirect.csv")) {
        html_paragraph(report->page, "`indirect.csv` was not measured: its part of the bench did "
                                     "not run.");
        return true;
    }
    points p = {.data = data_new(columns)};
    bool good = scenes_each_row(report, "indirect.csv", chart_names, add_point, &p);
    if (good && p.count > 0) {
        figure_begin(report->page, "indirect");
        good = panels(report, &p);
        figure_end(report->page,
                   "Indirect light: error against traced paths over time, over the volume's "
                   "resolution and over the number of steps.");
    }
    data_free(p.data);
    return good &&
           report_scene_gallery(
               report, "indirect",
               "One diffuse bounce of area lights by a light propagation volume (`render "
               "--indirect lpv`): direct light (multires) and indirect light with one exposure, "
               "the bounce as Embree traces it, and the error relative to the reference's mean, "
               "from green to red (as much as the mean, or more). A volume as coarse as this one "
               "gets the amount and "
               "the colour of the light, not its detail: edges of what is lit blur over two "
               "voxels, light leaks past walls that a voxel holds both sides of, a surface that "
               "shines gets a part of its own light back where its truth is dark, lobes of four "
               "coefficients are too flat for the light of a small bright place, and objects much "
               "smaller than a voxel are lit alike on all sides.") &&
           report_scene_table(
               report, "indirect.csv", names, titles,
               "Indirect irradiance against the traced bounce: root mean square of the difference "
               "over the reference's mean, with the reference's own noise (its standard error "
               "beside it) still in it; the passes' time, and its share in a frame of multires "
               "with "
               "it (asked: at most 15 % at 1024 x 768). First the default, then other resolutions "
               "and steps, last the propagation as Kaplanyan and Dachsbacher print it.");
}
