/* report.c: `sgfit report`: the table of the page's sections, and the command. */
#include "report.h"

#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "file.h"
#include "gnuplot.h"
#include "options.h"
#include "page_css.h"
#include "progress.h"
#include "report_speed.h"
#include "text.h"

/* The page in its order. A section that another command contributes is one more row. */
static const report_section sections[] = {
    {"headline", "Headline figures", report_headline},
    {"accuracy", "Accuracy", report_accuracy},
    {"float", "What float breaks", report_float},
    {"curves", "The curves c and s", report_curves},
    {"steepness", "Steepness", report_steepness},
    {"rmse", "Error over sharpness", report_rmse},
    {"cosine", "The cosine as a lobe", report_cosine},
    {"hemisphere", "The hemisphere's integral", report_hemisphere},
    {"fits", "Fits against published constants", report_fits},
    {"routes", "Quadrature", report_routes},
    {"formulas", "Formulas as printed", report_formulas},
    {"machine", "Machine and versions", report_machine},
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

static bool write_report(const char *folder)
{
    report report = {0};
    report.page = page_new("Clamped cosine and spherical Gaussians: the error report",
                           "How far every published approximation, and every fit of this project, "
                           "is from the exact integral; computed from nothing but the integral.");
    page_style(report.page, (const char *)page_css, sizeof page_css);
    base_progress *progress = base_progress_begin("report", sg_method_count() + SECTIONS);
    report_speeds speeds = report_speed(); /* before anything else heats the machine */
    report.batch_speed_up = speeds.batch / speeds.single;
    bool done = score_all(&report, progress);
    for (size_t i = 0; i < SECTIONS && done; i++) {
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
    const char *out = NULL, *root = NULL;
    const base_option options[] = {
        {"out", BASE_STRING, &out, "DIR", "the folder to write index.html and its data into", NULL},
        {"root", BASE_STRING, &root, "DIR", "the source tree, for tables/constants", NULL},
    };
    static const base_usage usage = {
        "report", "--out DIR",
        "Writes the error report: DIR/index.html, one page that needs nothing else, "
        "DIR/accuracy.csv with the errors of every method, and a CSV behind every plot and table. "
        "Figures are drawn by gnuplot."};
    int status =
        base_parse_options(argc, argv, &usage, options, sizeof options / sizeof *options, NULL);
    if (status >= 0)
        return status;
    if (!out) {
        base_error("report: expected --out DIR, the folder to write into");
        return BASE_USAGE;
    }
    if (root)
        base_set_source_root(root);
    /* Work is not begun for a folder that cannot be written, or without the means to draw. */
    if (!gnuplot_there())
        return BASE_FAILED;
    if (!base_make_directory(out))
        return BASE_FAILED;
    if (access(out, W_OK) != 0) {
        base_error("report: %s: cannot be written, expected a folder of yours", out);
        return BASE_FAILED;
    }
    return write_report(out) ? BASE_DONE : BASE_FAILED;
}
