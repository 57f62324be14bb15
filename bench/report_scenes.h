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

/* report_scene_charts.c: errors over time, time over triangles and lights. */
bool report_scene_charts(report *report);

#endif
