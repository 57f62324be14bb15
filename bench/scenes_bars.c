/* scenes_bars.c: each view's figures beside what is asked of them: how far below the best rival the
 * errors lie at equal lighting time, and what the integration costs over reading and writing. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/file.h"
#include "base/text.h"
#include "scenes.h"

enum { MOST_RIVALS = 8 };

/* What people use instead, by families in the order of their times; each is asked at equal time. */
static const char *const families[][MOST_RIVALS] = {
    {"upsample8", "upsample4", "upsample2", NULL},
    {"upsample_sh8", "upsample_sh4", "upsample_sh2", NULL},
};
static const char *const split[MOST_RIVALS] = {"upsample_far", "upsample_far6", "upsample_far4",
                                               NULL};
static const char *const ours[] = {"hull", "hull_lobe"};

static bool same_view(const scenes_row *a, const scenes_row *b)
{
    return strcmp(a->scene, b->scene) == 0 && a->width == b->width && a->height == b->height &&
           a->detailed == b->detailed;
}

static const scenes_row *find(const scenes_table *table, const scenes_row *view, const char *id)
{
    for (size_t i = 0; i < table->count; i++)
        if (same_view(&table->rows[i], view) && strcmp(table->rows[i].pipeline, id) == 0)
            return &table->rows[i];
    return NULL;
}

static double error_of(const scenes_row *row, bool p99)
{
    return p99 ? row->error.p99 : row->error.rel;
}

/* Error of a family at a time: between two of its members logarithmically, beyond its ends that of
 * the nearest one. NaN where none of them ran. */
static double at_equal_time(const scenes_table *table, const scenes_row *view,
                            const char *const *family, bool p99)
{
    const scenes_row *below = NULL, *above = NULL;
    for (size_t i = 0; family[i]; i++) {
        const scenes_row *row = find(table, view, family[i]);
        if (!row)
            continue;
        if (row->lighting_ms <= view->lighting_ms) {
            if (!below || row->lighting_ms > below->lighting_ms)
                below = row;
        } else if (!above || row->lighting_ms < above->lighting_ms) {
            above = row;
        }
    }
    if (!below || !above)
        return below ? error_of(below, p99) : above ? error_of(above, p99) : (double)NAN;
    double t =
        log(view->lighting_ms / below->lighting_ms) / log(above->lighting_ms / below->lighting_ms);
    return exp((1.0 - t) * log(error_of(below, p99)) + t * log(error_of(above, p99)));
}

static double best_rival(const scenes_table *table, const scenes_row *view, bool p99)
{
    double best = (double)NAN;
    for (size_t f = 0; f < sizeof families / sizeof *families; f++)
        best = fmin(best, at_equal_time(table, view, families[f], p99));
    return best;
}

static double lower_percent(double ours_error, double rival)
{
    return 100.0 * (1.0 - ours_error / rival);
}

/* Time of a pass, 0 where there is none of that name. */
static double pass_ms(const scenes_row *row, const char *name)
{
    for (int i = 0; i < row->statistics.time_count; i++)
        if (strcmp(row->statistics.times[i].name, name) == 0)
            return row->statistics.times[i].ms;
    return 0.0;
}

static void write_row(FILE *out, const scenes_table *table, const scenes_row *row)
{
    const scenes_row *limit = find(table, row, "limit");
    double pairs = (double)row->statistics.ground_truth_evaluations;
    double integration = pass_ms(row, "integrate");
    const double numbers[] = {
        100.0 * (double)row->statistics.light_evaluations / (pairs > 0.0 ? pairs : 1.0),
        row->error.rel,
        row->error.p50,
        row->error.p99,
        row->lighting_ms,
        lower_percent(row->error.rel, best_rival(table, row, false)),
        lower_percent(row->error.p99, best_rival(table, row, true)),
        lower_percent(row->error.rel, at_equal_time(table, row, split, false)),
        limit ? integration / limit->lighting_ms : (double)NAN,
        (double)(row->statistics.pixels_uncovered + row->statistics.pixels_wrong),
        integration};
    fprintf(out, "%s,%u,%u,%s,%s", row->scene, row->width, row->height,
            row->detailed ? "detailed" : "smooth", row->pipeline);
    for (size_t i = 0; i < sizeof numbers / sizeof *numbers; i++) {
        char text[BASE_NUMBER_SIZE];
        fprintf(out, ",%s", isnan(numbers[i]) ? "" : base_shortest_f64(numbers[i], text));
    }
    fputc('\n', out);
}

bool scenes_write_bars(const scenes_table *table, const char *path)
{
    base_output output;
    if (!base_output_open(&output, path))
        return false;
    fputs("scene,width,height,normals,pipeline,evaluations_percent,rel,p50,p99,lighting_ms,"
          "rel_lower_percent,p99_lower_percent,rel_lower_than_split_percent,"
          "integration_over_limit,pixels_uncovered_or_wrong,integrate_ms\n",
          output.stream);
    for (size_t i = 0; i < table->count; i++)
        for (size_t p = 0; p < sizeof ours / sizeof *ours; p++)
            if (strcmp(table->rows[i].pipeline, ours[p]) == 0)
                write_row(output.stream, table, &table->rows[i]);
    return base_output_close(&output);
}
