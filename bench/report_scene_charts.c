/* report_scene_charts.c: the charts of the section on scenes, and reading the CSVs behind them. */
#define _POSIX_C_SOURCE 200809L
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "base/file.h"
#include "base/text.h"
#include "plot.h"
#include "report_scenes.h"

bool scenes_are_there(const report *report, const char *name)
{
    char *path = base_join(report->scenes, name);
    bool there = access(path, R_OK) == 0;
    free(path);
    return there;
}

bool scenes_reader_open(scenes_reader *r, const report *report, const char *name)
{
    *r = (scenes_reader){.path = base_join(report->scenes, name)};
    r->stream = fopen(r->path, "rb");
    if (!r->stream)
        base_error("%s: cannot be read, expected what sgfit bench --scenes writes", r->path);
    if (r->stream && base_csv_open(&r->csv, r->stream, r->path))
        return true;
    if (r->stream)
        fclose(r->stream);
    free(r->path);
    return false;
}

void scenes_reader_close(scenes_reader *r)
{
    base_csv_close(&r->csv);
    fclose(r->stream);
    free(r->path);
}

bool scenes_find_columns(const scenes_reader *r, const char *const *names, int *columns)
{
    for (size_t i = 0; names[i]; i++) {
        columns[i] = base_csv_column(&r->csv, names[i]);
        if (columns[i] < 0) {
            base_error("%s: expected a column %s", r->path, names[i]);
            return false;
        }
    }
    return true;
}

/* ---- Charts -----------------------------------------------------------------------------------
 */

enum { MOST_SERIES = 14 };

typedef struct chart {
    const char *file, *x, *y;
    const char *filter, *value; /* rows whose column filter is value; NULL: all */
    const char *const *order;   /* of the series; NULL: known */
} chart;

/* Colours are those of this order, so that a pipeline has one colour in all charts. */
static const char *const known[] = {
    "hull",         "hull_lobe",    "meder",        "upsample2",    "upsample4", "upsample8",
    "upsample_sh8", "upsample_far", "upsample_sh4", "upsample_sh2", NULL};

static int series_of(char names[MOST_SERIES][64], int *count, const char *pipeline)
{
    for (int i = 0; i < *count; i++)
        if (strcmp(names[i], pipeline) == 0)
            return i;
    if (*count == MOST_SERIES)
        return -1;
    snprintf(names[*count], sizeof names[0], "%s", pipeline);
    return (*count)++;
}

/* A row for each row of the file: x, then y in the column of its pipeline and NaN in the others. */
static bool read_chart(report *report, const chart *c, data_table *data,
                       char names[MOST_SERIES][64], int *count)
{
    const char *const wanted[] = {c->x, c->y, "pipeline", c->filter ? c->filter : c->x, NULL};
    if (!scenes_are_there(report, c->file))
        return true;
    scenes_reader r;
    int columns[4], more = 0;
    if (!scenes_reader_open(&r, report, c->file))
        return false;
    bool good = scenes_find_columns(&r, wanted, columns);
    while (good && (more = base_csv_next(&r.csv)) > 0) {
        double row[MOST_SERIES + 1], x, y;
        const char *pipeline = r.csv.fields[columns[2]];
        if ((c->filter && strcmp(r.csv.fields[columns[3]], c->value) != 0) ||
            strncmp(pipeline, "exact", 5) == 0 || strcmp(pipeline, "limit") == 0 ||
            !base_parse_f64(r.csv.fields[columns[0]], r.csv.lengths[columns[0]], &x) ||
            !base_parse_f64(r.csv.fields[columns[1]], r.csv.lengths[columns[1]], &y) || !(y > 0.0))
            continue;
        int series = series_of(names, count, pipeline);
        for (int i = 0; i < MOST_SERIES + 1; i++)
            row[i] = (double)NAN;
        row[0] = x;
        if (series >= 0)
            row[1 + series] = y;
        data_row(data, row);
    }
    scenes_reader_close(&r);
    return good && more == 0;
}

static bool has_any(const data_table *data, size_t column)
{
    for (size_t r = 0; r < data->rows; r++)
        if (!isnan(data_at(data, r, column)))
            return true;
    return false;
}

static bool draw_chart(report *report, const chart *c, plot *p)
{
    static const char *const columns[] = {"x",  "s1", "s2",  "s3",  "s4",  "s5",  "s6",  "s7",
                                          "s8", "s9", "s10", "s11", "s12", "s13", "s14", NULL};
    char names[MOST_SERIES][64];
    int count = 0, drawn = 0;
    const char *const *order = c->order ? c->order : known;
    while (order[count])
        series_of(names, &count, order[count]);
    data_table *data = data_new(columns);
    bool good = read_chart(report, c, data, names, &count);
    plot_series series[MOST_SERIES];
    for (int i = 0; i < count; i++)
        if (has_any(data, (size_t)i + 1))
            series[drawn++] = (plot_series){names[i], 1 + i, 1 + i, PLOT_MARKS, 2};
    p->data = data;
    p->series = series;
    p->series_count = (size_t)drawn;
    p->x_log = p->y_log = true;
    good = good && (drawn == 0 || figure_panel(report->page, p));
    data_free(data);
    return good;
}

/* ---- Steps ------------------------------------------------------------------------------------
 */

typedef struct scene_names {
    char of[16][64];
    int count;
} scene_names;

static void add_scene(void *context, const scenes_fields *f)
{
    scene_names *s = context;
    if (s->count == 0 || strcmp(s->of[s->count - 1], f->text[0]) != 0) {
        if (s->count < 16)
            snprintf(s->of[s->count++], sizeof s->of[0], "%s", f->text[0]);
    }
}

/* A panel a scene. */
static bool step_charts(report *report)
{
    static const char *const order[] = {"hull",         "hull_lobe",  "meder",   "lobes",
                                        "lobes_split",  "lobes_near", "moments", "moments_split",
                                        "moments_near", NULL};
    static const char *const columns[] = {"scene", NULL};
    scene_names scenes = {.count = 0};
    if (!scenes_each_row(report, "steps.csv", columns, add_scene, &scenes))
        return false;
    if (scenes.count == 0)
        return true;
    bool good = true;
    figure_begin(report->page, "scene_steps");
    for (int i = 0; i < scenes.count && good; i++) {
        char id[96];
        snprintf(id, sizeof id, "scene_steps_%s", scenes.of[i]);
        plot steps = {.id = id, .title = scenes.of[i], .x_label = "lighting, ms", .y_label = "rel"};
        chart c = {"steps.csv", "lighting_ms", "rel", "scene", scenes.of[i], order};
        good = draw_chart(report, &c, &steps);
    }
    figure_end(report->page,
               "What every refinement buys: from the paper's hull (`meder`) over lobes with exact "
               "moments (`lobes`) and moments up to order 2 with gradients and order 4 of the "
               "luminance (`moments`), each with quads split where light bends, with near lights "
               "exact, or with both (`hull_lobe`, `hull`).");
    return good;
}

bool report_scene_charts(report *report)
{
    page *page = report->page;
    figure_begin(page, "scene_errors");
    plot error = {.id = "scene_errors",
                  .title = "all views, smooth normals",
                  .x_label = "lighting, ms",
                  .y_label = "rel"};
    bool good = draw_chart(
        report, &(chart){"views.csv", "lighting_ms", "rel", "normals", "smooth", NULL}, &error);
    plot detailed = {.id = "scene_errors_detailed",
                     .title = "all views, detailed normals",
                     .x_label = "lighting, ms",
                     .y_label = "rel"};
    good =
        good &&
        draw_chart(report, &(chart){"views.csv", "lighting_ms", "rel", "normals", "detailed", NULL},
                   &detailed);
    figure_end(page, "Error against time on the device, every view and size a point.");
    good = good && step_charts(report);
    figure_begin(page, "scene_growth");
    plot triangles = {.id = "scene_triangles",
                      .title = "the same hills, finer",
                      .x_label = "triangles",
                      .y_label = "lighting, ms"};
    plot lights = {.id = "scene_lights",
                   .title = "finer reflective shadow maps",
                   .x_label = "lights",
                   .y_label = "lighting, ms"};
    good = good &&
           draw_chart(report,
                      &(chart){"growth.csv", "amount", "lighting_ms", "what", "triangles", NULL},
                      &triangles);
    good =
        good &&
        draw_chart(report, &(chart){"growth.csv", "amount", "lighting_ms", "what", "lights", NULL},
                   &lights);
    static const char *const of_lights[][2] = {{"evaluations", "light evaluations"},
                                               {"rel", "rel"}};
    for (size_t i = 0; i < sizeof of_lights / sizeof *of_lights; i++) {
        plot more = {.id = i == 0 ? "scene_lights_evaluations" : "scene_lights_rel",
                     .title = "finer reflective shadow maps",
                     .x_label = "lights",
                     .y_label = of_lights[i][1]};
        good = good &&
               draw_chart(report,
                          &(chart){"growth.csv", "amount", of_lights[i][0], "what", "lights", NULL},
                          &more);
    }
    figure_end(page,
               "Lighting time over triangles and over lights; evaluations and error over lights.");
    return good;
}
