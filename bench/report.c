/* report.c: `sgfit report`: the table of the page's sections, and the command. */
#include "report.h"

#include <stdlib.h>
#include <string.h>

#include "base/file.h"
#include "base/options.h"
#include "base/progress.h"
#include "base/text.h"
#include "gnuplot.h"
#include "page_css.h"
#include "report_speed.h"

/* The page in its order. A section that another command contributes is one more row. */
static const report_section sections[] = {
    {"headline", "Headline figures", report_headline, NULL},
    {"accuracy", "Accuracy", report_accuracy, NULL},
    {"cost", "Speed against accuracy", report_cost, NULL},
    {"profiles", "No more than a scene needs", report_profile, report_has_profile},
    {"float", "What float breaks", report_float, NULL},
    {"stability", "Where methods fail", report_stability, report_has_stability},
    {"curves", "The curves c and s", report_curves, NULL},
    {"steepness", "Steepness", report_steepness, NULL},
    {"rmse", "Error over sharpness", report_rmse, NULL},
    {"cosine", "The cosine as a lobe", report_cosine, NULL},
    {"hemisphere", "The hemisphere's integral", report_hemisphere, NULL},
    {"scenes", "What it is worth in a picture", report_scenes, report_has_scenes},
    {"fits", "Fits against published constants", report_fits, NULL},
    {"tried", "What was tried", report_tried, report_has_tried},
    {"routes", "Quadrature", report_routes, NULL},
    {"formulas", "Formulas as printed", report_formulas, NULL},
    {"machine", "Machine and versions", report_machine, NULL},
};
enum { SECTIONS = sizeof sections / sizeof *sections };

static bool score_all(report *report, base_progress *progress)
{
    report->methods = sg_method_count();
    report->scores = calloc(report->methods + 1, sizeof *report->scores);
    if (!report->scores) {
        base_error("report: out of memory");
        return false;
    }
    for (size_t i = 0; i < report->methods; i++) {
        for (int p = 0; p < SCORE_PRECISIONS; p++)
            score_method(sg_method_at(i), (score_precision)p, &report->scores[i][p]);
        base_progress_step(progress, sg_method_at(i)->id);
    }
    return true;
}

static bool write_report(const char *folder, const char *bench, const char *stability,
                         const char *scenes)
{
    report report = {.bench = bench, .stability = stability, .scenes = scenes};
    report.page = page_new("Clamped cosine and spherical Gaussians: the error report",
                           "How far every published approximation, and every fit of this project, "
                           "is from the exact integral; computed from nothing but the integral.");
    page_style(report.page, (const char *)page_css, sizeof page_css);
    base_progress *progress = base_progress_begin("report", sg_method_count() + SECTIONS);
    report_speeds speeds = report_speed(); /* before anything else heats the machine */
    report.batch_speed_up = speeds.batch / speeds.single;
    bool done = score_all(&report, progress);
    for (size_t i = 0; i < SECTIONS && done; i++) {
        if (sections[i].there && !sections[i].there(&report))
            continue;
        page_section(report.page, sections[i].id, sections[i].title);
        done = sections[i].write(&report);
        base_progress_step(progress, sections[i].title);
    }
    base_progress_end(progress);
    done = done && page_write(report.page, folder, "index.html");
    free(report.scores);
    page_free(report.page);
    return done;
}

int report_command(int argc, char **argv)
{
    const char *out = NULL, *root = NULL, *bench = NULL, *stability = NULL, *scenes = NULL,
               *readme = NULL;
    const base_option options[] = {
        {"out", BASE_STRING, &out, "DIR", "the folder to write index.html and its data into", NULL},
        {"bench", BASE_STRING, &bench, "DIR",
         "what sgfit bench --out wrote: adds times to the chart of speed against accuracy", NULL},
        {"stability", BASE_STRING, &stability, "DIR",
         "what sgfit stability --out wrote: adds the section on where methods fail", NULL},
        {"scenes", BASE_STRING, &scenes, "DIR",
         "what sgfit bench --scenes wrote: adds what the fits are worth in a picture", NULL},
        {"readme", BASE_STRING, &readme, "FILE",
         "rewrite the block of figures in FILE, and the pictures in tables/out beside it", NULL},
        {"root", BASE_STRING, &root, "DIR", "the source tree, for tables/constants", NULL},
    };
    static const base_usage usage = {
        "report", "--out DIR [options]",
        "Writes the error report: DIR/index.html, one page that needs nothing else, "
        "DIR/accuracy.csv with the errors of every method, and a CSV behind every plot and table. "
        "Figures are drawn by gnuplot."};
    int status =
        base_parse_options(argc, argv, &usage, options, sizeof options / sizeof *options, NULL);
    if (status >= 0)
        return status;
    if (!out && !readme) {
        base_error("report: expected --out DIR, the folder to write into");
        return BASE_USAGE;
    }
    if (root)
        base_set_source_root(root);
    /* Work is not begun for a folder that cannot be written, or without the means to draw. */
    if (!gnuplot_there() || (out && !base_can_fill(out)) || (readme && !base_can_write(readme)))
        return BASE_FAILED;
    if (readme && !report_readme(readme, scenes))
        return BASE_FAILED;
    if (!out)
        return BASE_DONE;
    if (!base_make_directory(out))
        return BASE_FAILED;
    return write_report(out, bench, stability, scenes) ? BASE_DONE : BASE_FAILED;
}
