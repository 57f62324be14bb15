/* report_scenes.c: the section "What it is worth in a picture", of what `sgfit bench --scenes`
 * wrote.
 */
#define _POSIX_C_SOURCE 200809L
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "base/file.h"
#include "base/text.h"
#include "html.h"
#include "report_scenes.h"

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
bool report_scene_gallery(report *report, const char *group, const char *text)
{
    char *folder = base_join(report->scenes, group), **names;
    size_t count;
    if (!scenes_are_there(report, group)) {
        free(folder);
        return true;
    }
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

/* Every folder below `stages` is of one scene. */
static bool stage_galleries(report *report)
{
    char *folder = base_join(report->scenes, "stages"), **names;
    size_t count;
    if (!scenes_are_there(report, "stages")) {
        free(folder);
        return true;
    }
    bool good = base_list(folder, "", &names, &count);
    if (good) {
        for (size_t i = 0; i < count && good; i++) {
            char *group = base_join("stages", names[i]);
            good = report_scene_gallery(report, group,
                                        i ? "The same."
                                          : "The stages of the paper's pipeline, its figure 2.");
            free(group);
        }
        base_list_free(names, count);
    }
    free(folder);
    return good;
}

/* ---- Tables -----------------------------------------------------------------------------------
 */

enum { MOST_COLUMNS = 16 };

bool scenes_link_file(report *report, const char *name)
{
    char *path = base_join(report->scenes, name), *inside = base_join("data", name);
    size_t size;
    char *bytes = base_read_file(path, &size);
    if (bytes) {
        page_file(report->page, inside, bytes, size);
        fprintf(page_html(report->page), "<p class=\"source\"><a href=\"%s\">%s</a></p>\n", inside,
                inside);
    }
    free(path);
    free(inside);
    free(bytes);
    return bytes != NULL;
}

/* The columns of those names as a table, titled by titles. The file itself is linked below. */
bool report_scene_table(report *report, const char *name, const char *const *names,
                        const char *const *titles, const char *caption)
{
    scenes_reader r;
    int columns[MOST_COLUMNS], more = 0;
    if (!scenes_are_there(report, name)) {
        html_paragraph(report->page, "`%s` was not measured: its part of the bench did not run.",
                       name);
        return true;
    }
    if (!scenes_reader_open(&r, report, name))
        return false;
    bool good = scenes_find_columns(&r, names, columns);
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
    scenes_reader_close(&r);
    if (!good || more < 0)
        return false;
    html_table_end(report->page, NULL);
    return scenes_link_file(report, name);
}

static bool views(report *report)
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
    return report_scene_gallery(
               report, "pictures",
               "Pictures by the ground truth (`exact`), the paper as printed (`meder`), ours "
               "and a rival, all of one view with the same exposure; and their errors of "
               "irradiance, relative to the image mean and times four, from green to red.") &&
           report_scene_table(
               report, "views.csv", view_names, view_titles,
               "Every view. Errors of irradiance against ground truth, relative to the image's "
               "mean; light evaluations as the shaders counted them; time of all lighting passes "
               "on the device, for comparison within this table only.");
}

static bool rates_and_flicker(report *report)
{
    static const char *const rate_names[] = {
        "scene",       "width",       "height", "pipeline", "lighting_ratio",
        "frame_ratio", "paper_ratio", "rel",    NULL};
    static const char *const rate_titles[] = {
        "scene", "#width", "#height", "pipeline", "#lighting", "#frame", "#paper", "#rel", NULL};
    static const char *const flicker_names[] = {"moving", "pipeline", "own_rms", "ratio_to_truth",
                                                NULL};
    static const char *const flicker_titles[] = {"moving", "pipeline", "#own", "#ratio to truth",
                                                 NULL};
    return report_scene_table(
               report, "rates.csv", rate_names, rate_titles,
               "How many times as fast as ground truth: lighting alone, the whole frame, and "
               "what the paper's table 1 says (0: it does not have this scene).") &&
           report_scene_table(
               report, "flicker.csv", flicker_names, flicker_titles,
               "Flicker: root mean square, over pixels, of the second difference in time: of the "
               "error, and of the irradiance against that of ground truth.");
}

static bool paper_and_choice(report *report)
{
    static const char *const paper_names[] = {"scene", "pipeline", "method", "rel",
                                              "p50",   "p99",      "bias",   NULL};
    static const char *const paper_titles[] = {"scene",   "pipeline", "method", "#rel",
                                               "#median", "#p99",     "#bias",  NULL};
    static const char *const choice_names[] = {
        "scene", "pipeline", "max_rmse", "method", "instructions", "rmse", "largest_change_of_255",
        NULL};
    static const char *const choice_titles[] = {
        "scene", "pipeline", "#asked", "method", "#instructions", "#RMSE", "#change of 255", NULL};
    return report_scene_gallery(
               report, "paper",
               "The paper's figures 3, 4 and 8: its pipeline as printed, with the cosine "
               "integrated by its own curve (`meder_2018`), taken as constant, taken as a lobe "
               "(`tokuyoshi_2016`), and by `standard`; errors as above.") &&
           report_scene_table(report, "paper.csv", paper_names, paper_titles,
                              "The same in numbers: errors of irradiance against ground truth.") &&
           report_scene_table(
               report, "choice.csv", choice_names, choice_titles,
               "No more than a scene needs: the cheapest method that stays under an error on "
               "what the frame integrates, and the largest change of its tone-mapped picture "
               "against the method `fine`, in steps of 1/255.");
}

static bool lobes(report *report)
{
    static const char *const lobe_names[] = {
        "figure",        "method",       "smape",      "smape_p99",
        "largest_error", "black_pixels", "time_ratio", NULL};
    static const char *const lobe_titles[] = {"figure",   "method", "#SMAPE", "#99 %",
                                              "#largest", "#black", "#time",  NULL};
    return report_scene_gallery(
               report, "lobes",
               "One surface after another lit by spherical Gaussians alone, as in Tokuyoshi's "
               "figures 1 and 4: a sharp light close to a wall, and the light that the scene "
               "reflects as two broad ones. Symmetric mean absolute percentage errors against "
               "the exact integral, times four.") &&
           report_scene_table(
               report, "lobes.csv", lobe_names, lobe_titles,
               "Every method of the registry on these two: mean error and 99th percentile, the "
               "largest error relative to the image's mean, pixels that are black where light "
               "falls, and the time of the pass relative to one without the integral.");
}

bool report_scenes(report *report)
{
    return report_scene_bars(report) && report_scene_charts(report) && views(report) &&
           rates_and_flicker(report) && stage_galleries(report) && paper_and_choice(report) &&
           report_area(report) && report_indirect(report) && lobes(report);
}
