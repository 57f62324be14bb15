/* bench_command.c: sgfit bench. */
#include "bench_command.h"

#include <stdlib.h>
#include <string.h>

#include "base/file.h"
#include "base/options.h"
#include "base/text.h"
#include "chart.h"
#include "cost.h"
#include "scenes_command.h"

static int write_all(const cost_table *table, const char *out, const char *counts)
{
    bool good = true;
    if (counts && !table->counted) {
        base_error("bench: %s stays as it is, because nothing could be counted", counts);
        good = false;
    } else if (counts) {
        good = cost_write_csv(table, counts, true);
    }
    if (good && out) {
        char *csv = base_join(out, "cost.csv"), *json = base_join(out, "cost.json");
        good = base_make_directory(out) && cost_write_csv(table, csv, false) &&
               cost_write_json(table, json) && chart_bench_page(out);
        free(csv);
        free(json);
    }
    return good ? BASE_DONE : BASE_FAILED;
}

static bool is_subject(const char *id)
{
    for (size_t i = 0; i < cost_table_count(); i++)
        if (strcmp(cost_table_id(i), id) == 0)
            return true;
    return sg_method_find(id) != NULL;
}

/* False after one line. */
static bool is_usage(const char *out, const char *counts, const char *scenes, const char *view,
                     const char *parts, const char *only)
{
    if (!out && !counts)
        base_error("bench: expected --out DIR or --counts FILE");
    else if (scenes)
        base_error("bench: expected --out DIR with --scenes");
    else if (view || parts)
        base_error("bench: expected %s only together with --scenes", view ? "--view" : "--part");
    else if (only && !is_subject(only))
        base_error("bench: expected --method to name a method (see sgfit methods) or a table "
                   "(table_2d, table_2d_pair, table_1d), found %s",
                   only);
    else
        return true;
    return false;
}

#define PART_NAME(NAME) " " #NAME

int bench_command(int argc, char **argv)
{
    const char *out = NULL, *counts = NULL, *device = "llvmpipe", *only = NULL, *root = NULL,
               *scenes = NULL, *view = NULL, *parts = NULL;
    bool quick = false;
    const base_usage usage = {
        "bench", "--out DIR [options]",
        "Measures what every method costs: GPU instructions (RADV compiles for hardware that need "
        "not be there), nanoseconds on this CPU, time on a Vulkan device as a ratio to an empty "
        "shader; writes DIR/cost.csv, DIR/cost.json and DIR/index.html, a chart of error against "
        "cost."};
    const base_option options[] = {
        {"out", BASE_STRING, &out, "DIR", "where cost.csv, cost.json and index.html go", NULL},
        {"counts", BASE_STRING, &counts, "FILE",
         "write errors and instruction counts alone, which are the same in every run, to FILE "
         "(tables/cost.csv is made with this)",
         NULL},
        {"method", BASE_STRING, &only, "ID", "this method alone", NULL},
        {"device", BASE_STRING, &device, "NAME",
         "part of the Vulkan device's name (default: llvmpipe, the software driver)", NULL},
        {"root", BASE_STRING, &root, "DIR", "the source tree, for the texts that are counted",
         NULL},
        {"scenes", BASE_STRING, &scenes, "DIR",
         "measure the renderer instead, on the scenes of tests/scenes, their meshes in DIR; "
         "\"built-in\": on those that need none",
         NULL},
        {"view", BASE_STRING, &view, "NAME", "with --scenes: those alone whose name begins so",
         NULL},
        {"part", BASE_STRING, &parts, "NAME[,NAME...]",
         "with --scenes: these alone:" SCENES_PARTS(
             PART_NAME) "; only where named:" SCENES_EXTRA_PARTS(PART_NAME),
         NULL},
        {"quick", BASE_FLAG, &quick, NULL,
         "fewer samples; with --scenes: fewer views, smaller pictures, five minutes in all", NULL}};
    int status =
        base_parse_options(argc, argv, &usage, options, sizeof options / sizeof *options, NULL);
    if (status >= 0)
        return status;
    if (root)
        base_set_source_root(root);
    if (scenes && (counts || only)) {
        base_error("bench: expected --scenes without %s", counts ? "--counts" : "--method");
        return BASE_USAGE;
    }
    if (scenes && out)
        return scenes_command(&(scenes_request){scenes, view, parts, device, out, quick});
    if (!is_usage(out, counts, scenes, view, parts, only))
        return BASE_USAGE;
    if ((out && !base_can_fill(out)) || (counts && !base_can_write(counts)))
        return BASE_FAILED;
    cost_table table;
    if (!cost_measure(&table, &(cost_options){device, only, quick, out == NULL}))
        return BASE_FAILED;
    status = write_all(&table, out, counts);
    cost_table_free(&table);
    return status;
}
