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

enum { MOST_SERIES = 9 };

typedef struct chart {
    const char *file, *x, *y;
    const char *filter, *value; /* rows whose column filter is value; NULL: all */
} chart;

/* Colours are those of this order, so that a pipeline has one colour in all charts. */
static const char *const known[] = {"hull",      "hull_lobe", "meder",        "upsample2",
                                    "upsample4", "upsample8", "upsample_sh8", "upsample_far"};
enum { KNOWN = sizeof known / sizeof *known };

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
    static const char *const columns[] = {"x",  "s1", "s2", "s3", "s4", "s5",
                                          "s6", "s7", "s8", "s9", NULL};
    char names[MOST_SERIES][64];
    int count = 0, drawn = 0;
    while (count < KNOWN)
        series_of(names, &count, known[count]);
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

bool report_scene_charts(report *report)
{
    page *page = report->page;
    figure_begin(page, "scene_errors");
    plot error = {.id = "scene_errors",
                  .title = "all views, smooth normals",
                  .x_label = "lighting, ms",
                  .y_label = "rel"};
    bool good = draw_chart(report, &(chart){"views.csv", "lighting_ms", "rel", "normals", "smooth"},
                           &error);
    plot detailed = {.id = "scene_errors_detailed",
                     .title = "all views, detailed normals",
                     .x_label = "lighting, ms",
                     .y_label = "rel"};
    good = good &&
           draw_chart(report, &(chart){"views.csv", "lighting_ms", "rel", "normals", "detailed"},
                      &detailed);
    figure_end(page, "Error against time on the device, every view and size a point.");
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
           draw_chart(report, &(chart){"growth.csv", "amount", "lighting_ms", "what", "triangles"},
                      &triangles);
    good = good &&
           draw_chart(report, &(chart){"growth.csv", "amount", "lighting_ms", "what", "lights"},
                      &lights);
    figure_end(page, "Lighting time over triangles and over lights.");
    return good;
}
