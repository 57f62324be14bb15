/* report_scenes.c: the section "What it is worth in a picture", of what `sgfit bench --scenes`
 * wrote.
 */
#define _POSIX_C_SOURCE 200809L
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "base/buffer.h"
#include "base/csv.h"
#include "base/file.h"
#include "base/text.h"
#include "html.h"
#include "plot.h"
#include "report.h"

bool report_has_scenes(const report *report)
{
    return report->scenes != NULL;
}

/* ---- Pictures ---------------------------------------------------------------------------------
 */

static bool picture(report *report, const char *group, const char *file)
{
    char *inside = base_join(group, file), *path = base_join(report->scenes, inside);
    size_t size;
    char *bytes = base_read_file(path, &size);
    if (bytes) {
        FILE *out = page_html(report->page);
        int stem = (int)(strlen(file) - strlen(".png"));
        page_file(report->page, inside, bytes, size);
        fprintf(out,
                "<figure><a href=\"%s\"><img loading=\"lazy\" src=\"%s\" alt=\"%.*s\"></a>"
                "<figcaption><code>%.*s</code></figcaption></figure>\n",
                inside, inside, stem, file, stem, file);
    }
    free(path);
    free(inside);
    free(bytes);
    return bytes != NULL;
}

/* All pictures of a folder beside the tables; the folder's name is that in the page, too. */
static bool gallery(report *report, const char *group, const char *text)
{
    char *folder = base_join(report->scenes, group), **names;
    size_t count;
    bool good = base_list(folder, ".png", &names, &count);
    if (good) {
        html_paragraph(report->page, "%s", text);
        fputs("<div class=\"gallery\">\n", page_html(report->page));
        for (size_t i = 0; i < count && good; i++)
            good = picture(report, group, names[i]);
        fputs("</div>\n", page_html(report->page));
        base_list_free(names, count);
    }
    free(folder);
    return good;
}

/* ---- Tables -----------------------------------------------------------------------------------
 */

/* A CSV that `sgfit bench --scenes` wrote, its columns found by name. False after one line. */
typedef struct reader {
    char *path;
    FILE *stream;
    base_csv csv;
} reader;

static bool reader_open(reader *r, const report *report, const char *name)
{
    *r = (reader){.path = base_join(report->scenes, name)};
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

static void reader_close(reader *r)
{
    base_csv_close(&r->csv);
    fclose(r->stream);
    free(r->path);
}

static bool find_columns(const reader *r, const char *const *names, int *columns)
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

enum { MOST_COLUMNS = 16 };

/* The columns of those names as a table, titled by titles. The file itself is linked below. */
static bool table(report *report, const char *name, const char *const *names,
                  const char *const *titles, const char *caption)
{
    reader r;
    int columns[MOST_COLUMNS], more = 0;
    if (!reader_open(&r, report, name))
        return false;
    bool good = find_columns(&r, names, columns);
    if (good)
        html_table_begin(report->page, caption, titles);
    while (good && (more = base_csv_next(&r.csv)) > 0) {
        html_row_begin(report->page, NULL);
        for (size_t i = 0; names[i]; i++) {
            double value;
            const char *field = r.csv.fields[columns[i]];
            if (base_parse_f64(field, r.csv.lengths[columns[i]], &value))
                html_cell_number(report->page, value, 3);
            else
                html_cell_code(report->page, field);
        }
        html_row_end(report->page);
    }
    reader_close(&r);
    if (!good || more < 0)
        return false;
    char *path = base_join(report->scenes, name), *inside = base_join("data", name);
    size_t size;
    char *bytes = base_read_file(path, &size);
    if (bytes)
        page_file(report->page, inside, bytes, size);
    html_table_end(report->page, inside);
    free(path);
    free(inside);
    free(bytes);
    return bytes != NULL;
}

/* ---- Charts -----------------------------------------------------------------------------------
 */

enum { MOST_SERIES = 9 };

typedef struct chart {
    const char *file, *x, *y;
    const char *filter, *value; /* rows whose column filter is value; NULL: all */
} chart;

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
    reader r;
    int columns[4], more = 0;
    if (!reader_open(&r, report, c->file))
        return false;
    bool good = find_columns(&r, wanted, columns);
    while (good && (more = base_csv_next(&r.csv)) > 0) {
        double row[MOST_SERIES + 1], x, y;
        const char *pipeline = r.csv.fields[columns[2]];
        if ((c->filter && strcmp(r.csv.fields[columns[3]], c->value) != 0) ||
            strcmp(pipeline, "exact") == 0 || strcmp(pipeline, "limit") == 0 ||
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
    reader_close(&r);
    return good && more == 0;
}

static bool draw_chart(report *report, const chart *c, plot *p)
{
    static const char *const columns[] = {"x",  "s1", "s2", "s3", "s4", "s5",
                                          "s6", "s7", "s8", "s9", NULL};
    char names[MOST_SERIES][64];
    int count = 0;
    data_table *data = data_new(columns);
    bool good = read_chart(report, c, data, names, &count);
    plot_series series[MOST_SERIES];
    for (int i = 0; i < count; i++)
        series[i] = (plot_series){names[i], 1 + i, 1 + i, PLOT_POINTS, 2};
    p->data = data;
    p->series = series;
    p->series_count = (size_t)count;
    p->x_log = p->y_log = true;
    good = good && (count == 0 || figure_panel(report->page, p));
    data_free(data);
    return good;
}

static bool charts(report *report)
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

bool report_scenes(report *report)
{
    static const char *const view_names[] = {"scene",
                                             "width",
                                             "height",
                                             "normals",
                                             "pipeline",
                                             "rel",
                                             "p50",
                                             "p99",
                                             "jump_p99",
                                             "pixels_uncovered",
                                             "pixels_wrong",
                                             "evaluations_percent",
                                             "lighting_ms",
                                             "times_faster_than_exact",
                                             NULL};
    static const char *const view_titles[] = {
        "scene",  "#width",         "#height", "normals",       "pipeline",
        "#rel",   "#median",        "#p99",    "#jump",         "#uncovered",
        "#wrong", "#evaluations %", "#ms",     "#times faster", NULL};
    static const char *const rate_names[] = {
        "scene",       "width",       "height", "pipeline", "lighting_ratio",
        "frame_ratio", "paper_ratio", "rel",    NULL};
    static const char *const rate_titles[] = {
        "scene", "#width", "#height", "pipeline", "#lighting", "#frame", "#paper", "#rel", NULL};
    static const char *const flicker_names[] = {"moving", "pipeline", "own_rms", "ratio_to_truth",
                                                NULL};
    static const char *const flicker_titles[] = {"moving", "pipeline", "#own", "#ratio to truth",
                                                 NULL};
    static const char *const lobe_names[] = {
        "figure",        "method",       "smape",      "smape_p99",
        "largest_error", "black_pixels", "time_ratio", NULL};
    static const char *const lobe_titles[] = {"figure",   "method", "#SMAPE", "#99 %",
                                              "#largest", "#black", "#time",  NULL};
    return gallery(report, "pictures",
                   "Pictures by the ground truth (`exact`), the paper as printed (`meder`), ours "
                   "and a rival, all of one view with the same exposure; and their errors of "
                   "irradiance, relative to the image mean and times four, from green to red.") &&
           charts(report) &&
           table(report, "views.csv", view_names, view_titles,
                 "Every view. Errors of irradiance against ground truth, relative to the image's "
                 "mean; light evaluations as the shaders counted them; time of all lighting passes "
                 "on the device, for comparison within this table only.") &&
           table(report, "rates.csv", rate_names, rate_titles,
                 "How many times as fast as ground truth: lighting alone, the whole frame, and "
                 "what the paper's table 1 says (0: it does not have this scene).") &&
           table(report, "flicker.csv", flicker_names, flicker_titles,
                 "Flicker: root mean square, over pixels, of the second difference in time: of the "
                 "error, and of the irradiance against that of ground truth.") &&
           gallery(report, "lobes",
                   "One surface after another lit by spherical Gaussians alone, as in Tokuyoshi's "
                   "figures 1 and 4: a sharp light close to a wall, and the light that the scene "
                   "reflects as two broad ones. Symmetric mean absolute percentage errors against "
                   "the exact integral, times four.") &&
           table(report, "lobes.csv", lobe_names, lobe_titles,
                 "Every method of the registry on these two: mean error and 99th percentile, the "
                 "largest error relative to the image's mean, pixels that are black where light "
                 "falls, and the time of the pass relative to one without the integral.");
}
