/* report_scenes.h: what the parts of the report's section on scenes share. */
#ifndef BENCH_REPORT_SCENES_H
#define BENCH_REPORT_SCENES_H

#include <stdio.h>

#include "base/csv.h"
#include "report.h"

/* A CSV that `sgfit bench --scenes` wrote, its columns found by name. False after one line. */
typedef struct scenes_reader {
    char *path;
    FILE *stream;
    base_csv csv;
} scenes_reader;

bool scenes_reader_open(scenes_reader *r, const report *report, const char *name);
void scenes_reader_close(scenes_reader *r);

/* columns[i]: place of names[i], NULL-ended. False after one line where one is missing. */
bool scenes_find_columns(const scenes_reader *r, const char *const *names, int *columns);

/* Whether the part of the bench that writes the file ran. */
bool scenes_are_there(const report *report, const char *name);

/* Keeps a file of the bench among those of the page, with a link to it. False after one line. */
bool scenes_link_file(report *report, const char *name);

/* ---- report_scene_bars.c: what is asked, and what is reached ----------------------------------
 */

enum { SCENES_BARS = 32, SCENES_PLACE = 96, SCENES_FIELDS = 16 };

typedef struct scenes_bar {
    const char *what;
    double asked;
    bool at_least; /* else at most */
    size_t count, passed;
    double worst;
    char where[SCENES_PLACE]; /* it is worst */
} scenes_bar;

typedef struct scenes_bars {
    scenes_bar of[SCENES_BARS];
    size_t count;
} scenes_bars;

/* Another case of a bar, which is the one of that name. */
void scenes_note(scenes_bars *all, const char *what, double asked, bool at_least, double reached,
                 const char *where);

typedef struct scenes_fields {
    const char *text[SCENES_FIELDS];
    double number[SCENES_FIELDS]; /* NaN where the field is none */
} scenes_fields;
typedef void (*scenes_row_work)(void *context, const scenes_fields *fields);

/* Columns by their names, NULL-ended. A file that is not there has no rows. False after one line.
 */
bool scenes_each_row(report *report, const char *file, const char *const *names,
                     scenes_row_work work, void *context);

/* report_scene_demands.c: the bars that are not of one view. */
bool scenes_note_others(report *report, scenes_bars *all);

/* The table of all bars, then that of all views. */
bool report_scene_bars(report *report);

/* report_indirect.c: one bounce against traced paths. */
bool report_indirect(report *report);

/* report_scene_charts.c: errors over time, time over triangles and lights. */
bool report_scene_charts(report *report);

/* ---- report_scenes.c ------------------------------------------------------------------------- */

/* All pictures of a folder beside the tables, under a text; the folder's name is that in the page,
 * too. */
bool report_scene_gallery(report *report, const char *group, const char *text);

/* The columns of those names as a table, titled by titles (NULL-ended; # before those of numbers).
 * A paragraph where the file is not there. */
bool report_scene_table(report *report, const char *name, const char *const *names,
                        const char *const *titles, const char *caption);

/* ---- report_area.c: area lights with shadows ------------------------------------------------- */

bool report_area_bars(report *report, scenes_bars *all);
bool report_area(report *report);

#endif
