/* report_scene_bars.c: what is asked of the renderer and what is reached, computed from what
 * `sgfit bench --scenes` wrote: one row for each demand, then one for each view. */
#define _POSIX_C_SOURCE 200809L
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/file.h"
#include "base/text.h"
#include "html.h"
#include "report_scenes.h"

enum { PLACE = SCENES_PLACE, MOST_FIELDS = SCENES_FIELDS };

static bool passes(double reached, double asked, bool at_least)
{
    return at_least ? reached >= asked : reached <= asked;
}

void scenes_note(scenes_bars *all, const char *what, double asked, bool at_least, double reached,
                 const char *where)
{
    size_t i = 0;
    while (i < all->count && strcmp(all->of[i].what, what) != 0)
        i++;
    if (i == SCENES_BARS)
        return;
    scenes_bar *b = &all->of[i];
    if (i == all->count) {
        *b = (scenes_bar){.what = what, .asked = asked, .at_least = at_least};
        all->count++;
    }
    bool worse = b->count == 0 || (at_least ? reached < b->worst : reached > b->worst);
    b->count++;
    b->passed += passes(reached, asked, at_least);
    if (worse) {
        b->worst = reached;
        snprintf(b->where, sizeof b->where, "%s", where);
    }
}

/* ---- Rows of the files ------------------------------------------------------------------------
 */

bool scenes_each_row(report *report, const char *file, const char *const *names,
                     scenes_row_work work, void *context)
{
    scenes_reader r;
    int columns[MOST_FIELDS], more = 0;
    if (!scenes_are_there(report, file))
        return true;
    if (!scenes_reader_open(&r, report, file))
        return false;
    bool good = scenes_find_columns(&r, names, columns);
    while (good && (more = base_csv_next(&r.csv)) > 0) {
        scenes_fields f;
        for (size_t i = 0; names[i]; i++) {
            f.text[i] = r.csv.fields[columns[i]];
            if (!base_parse_f64(f.text[i], r.csv.lengths[columns[i]], &f.number[i]))
                f.number[i] = (double)NAN;
        }
        work(context, &f);
    }
    scenes_reader_close(&r);
    return good && more == 0;
}

/* ---- Views ------------------------------------------------------------------------------------
 */

/* Columns of bars.csv after the five that name the row; asked: on smooth normals and on detailed
 * ones, 0 and smaller: not asked. */
static const struct {
    const char *column, *title, *what, *pipeline;
    double smooth, detailed;
    bool at_least;
} demands[] = {
    {"pixels_uncovered_or_wrong", "#bad pixels", "pixels uncovered or wrongly owned", "hull", 0, 0,
     false},
    {"evaluations_percent", "#evaluations %", "light evaluations, % of ground truth's", "hull", 1.6,
     1.6, false},
    {"rel", "#rel", "rel", "hull", .05, .06, false},
    {"p50", "#median", "median error, smooth normals", "hull", .005, -1, false},
    {"p99", "#p99", "99th percentile of errors, smooth normals", "hull", .20, -1, false},
    {"rel_lower_percent", "#rel lower by %",
     "rel, % lower than the best upsampling at equal lighting time", "hull", 50, 50, true},
    {"p99_lower_percent", "#p99 lower by %",
     "p99, % lower than the best upsampling at equal lighting time", "hull", 50, 50, true},
    {"rel_lower_than_split_percent", "#than the split",
     "rel, % lower than near lights exact and the far ones upsampled", "hull", 10, 10, true},
    {"integration_over_limit", "#integration", "integration, times the limit's pass", "hull", 2, 2,
     false},
    {"rel", "#rel, lobes", "rel with lobes alone for the far lights", "hull_lobe", .08, .08, false},
};
enum { DEMANDS = sizeof demands / sizeof *demands };

/* rel is asked differently on the two kinds of normals: two bars. */
static const char *bar_name(size_t d, bool detailed)
{
    return strcmp(demands[d].what, "rel") != 0 ? demands[d].what
           : detailed                          ? "rel, detailed normals"
                                               : "rel, smooth normals";
}

typedef struct view_rows {
    report *report; /* NULL: only noted, not written */
    scenes_bars *all;
    char place[PLACE];       /* of the row that is open; "" : none */
    double reached[DEMANDS]; /* in it; NaN: not measured */
    bool detailed;
} view_rows;

static void write_view(const view_rows *v)
{
    page *page = v->report->page;
    html_row_begin(page, NULL);
    html_cell_code(page, v->place);
    for (size_t d = 0; d < DEMANDS; d++) {
        double asked = v->detailed ? demands[d].detailed : demands[d].smooth;
        bool good = passes(v->reached[d], asked, demands[d].at_least);
        const char *mark = asked < 0 ? NULL : good ? "good" : "bad";
        if (isnan(v->reached[d]))
            html_cell(page, "");
        else
            html_cell_marked(page, v->reached[d], 3, mark, good ? NULL : "missed");
    }
    html_row_end(page);
}

static void close_view(const view_rows *v)
{
    if (v->place[0] == '\0')
        return;
    if (v->report)
        write_view(v);
    for (size_t d = 0; d < DEMANDS && v->all; d++) {
        double asked = v->detailed ? demands[d].detailed : demands[d].smooth;
        if (asked >= 0 && !isnan(v->reached[d]))
            scenes_note(v->all, bar_name(d, v->detailed), asked, demands[d].at_least, v->reached[d],
                        v->place);
    }
}

/* The rows of a view's pipelines follow each other. */
static void add_view(void *context, const scenes_fields *f)
{
    view_rows *v = context;
    char place[PLACE];
    snprintf(place, sizeof place, "%s %sx%s %s", f->text[0], f->text[1], f->text[2], f->text[3]);
    if (strcmp(place, v->place) != 0) {
        close_view(v);
        memcpy(v->place, place, sizeof place);
        v->detailed = strcmp(f->text[3], "detailed") == 0;
        for (size_t d = 0; d < DEMANDS; d++)
            v->reached[d] = (double)NAN;
    }
    for (size_t d = 0; d < DEMANDS; d++)
        if (strcmp(f->text[4], demands[d].pipeline) == 0)
            v->reached[d] = f->number[5 + d];
}

static bool read_views(report *report, view_rows *v)
{
    const char *names[MOST_FIELDS] = {"scene", "width", "height", "normals", "pipeline"};
    for (size_t d = 0; d < DEMANDS; d++)
        names[5 + d] = demands[d].column;
    bool good = scenes_each_row(report, "bars.csv", names, add_view, v);
    close_view(v);
    return good;
}

static bool views_table(report *report)
{
    const char *titles[DEMANDS + 2] = {"view"};
    for (size_t d = 0; d < DEMANDS; d++)
        titles[1 + d] = demands[d].title;
    html_table_begin(report->page,
                     "Every view against what is asked of it, with misses in red. The last column "
                     "is `hull_lobe`; on detailed normals neither median nor p99 is asked for.",
                     titles);
    view_rows v = {.report = report};
    bool good = read_views(report, &v);
    html_table_end(report->page, NULL);
    return good && scenes_link_file(report, "bars.csv");
}

/* ---- All of them ------------------------------------------------------------------------------
 */

static void summary(report *report, const scenes_bars *all)
{
    static const char *const titles[] = {
        "bar", "#asked", "#reached where it is worst", "where", "cases passed", "passed", NULL};
    page *page = report->page;
    html_table_begin(page, "What is asked of `hull`, one setting for all scenes, and what it does.",
                     titles);
    for (size_t i = 0; i < all->count; i++) {
        const scenes_bar *b = &all->of[i];
        bool good = b->passed == b->count;
        char asked[64], number[HTML_NUMBER_SIZE];
        snprintf(asked, sizeof asked, "%s %s", b->at_least ? "at least" : "at most",
                 html_number(b->asked, 3, number));
        html_row_begin(page, NULL);
        html_cell_wrap(page, b->what);
        html_cell(page, asked);
        html_cell_marked(page, b->worst, 3, good ? "good" : "bad", NULL);
        html_cell(page, b->where);
        char cases[64];
        snprintf(cases, sizeof cases, "%zu of %zu", b->passed, b->count);
        html_cell(page, cases);
        html_cell(page, good ? "passed" : "MISSED");
        html_row_end(page);
    }
    html_table_end(page, NULL);
}

bool report_scene_bars(report *report)
{
    scenes_bars all = {.count = 0};
    view_rows noted = {.all = &all};
    if (!read_views(report, &noted) || !scenes_note_others(report, &all))
        return false;
    summary(report, &all);
    return !scenes_are_there(report, "bars.csv") || views_table(report);
}
