/* figures_curves.c: Meder and Bruederlin's figures 5a and 5b: the normalised curves c and s over
 * the angle, from the reference and from the published and refitted models. */
#include <math.h>
#include <stdio.h>

#include "html.h"
#include "plot.h"
#include "report.h"

enum { SHARPNESSES = 7, ANGLES = 181 };

static const double pi = 3.14159265358979323846;
static const double sharpness[SHARPNESSES] = {1e-5, 1.0, 3.0, 10.0, 30.0, 100.0, 700.0};
static const char *const names[] = {"beta", "1e-5", "1", "3", "10", "30", "100", "700", NULL};
static const char *const pairs[] = {
    "beta",       "1e-5",    "1",       "3",        "10",       "30",        "100",       "700",
    "model_1e-5", "model_1", "model_3", "model_10", "model_30", "model_100", "model_700", NULL};
static const char *const legends[SHARPNESSES] = {"λ = 1e-5", "1", "3", "10", "30", "100", "700"};
static const char angle_tics[] = "set xtics (\"0\" 0, \"π/4\" 0.785398, \"π/2\" 1.570796, "
                                 "\"3π/4\" 2.356194, \"π\" 3.141593)";

static int scale_colour(int i)
{
    return PLOT_SCALE + i * (PLOT_SCALE_STEPS - 1) / (SHARPNESSES - 1);
}

static plot over_angle(const char *id, const char *title, const char *y_label)
{
    return (plot){.id = id,
                  .title = title,
                  .x_label = "angle β between lobe and normal",
                  .y_label = y_label,
                  .x_range = {0.0, pi},
                  .setup = angle_tics};
}

static bool panel_c(page *page)
{
    data_table *data = data_new(names);
    for (int j = 0; j < ANGLES; j++) {
        double row[1 + SHARPNESSES] = {pi * j / (ANGLES - 1)};
        for (int i = 0; i < SHARPNESSES; i++)
            row[1 + i] = sg_c(sharpness[i], row[0]);
        data_row(data, row);
    }
    plot_series series[SHARPNESSES];
    for (int i = 0; i < SHARPNESSES; i++)
        series[i] = (plot_series){legends[i], 1 + i, scale_colour(i), PLOT_LINE, 0.0};
    plot p = over_angle("meder_5a", "c, from the reference", "c(λ, β)");
    p.y_range[1] = 1.0;
    p.data = data;
    p.series = series;
    p.series_count = SHARPNESSES;
    bool done = figure_panel(page, &p);
    data_free(data);
    return done;
}

static bool panel_c_error(page *page, const report_model *model, double *worst)
{
    char id[128], title[128], label[64];
    *worst = 0.0;
    data_table *data = data_new(names);
    for (int j = 0; j < ANGLES; j++) {
        double row[1 + SHARPNESSES] = {pi * j / (ANGLES - 1)};
        for (int i = 0; i < SHARPNESSES; i++) {
            row[1 + i] =
                report_c(model->method, sharpness[i], cos(row[0])) - sg_c(sharpness[i], row[0]);
            *worst = fmax(*worst, fabs(row[1 + i]));
        }
        data_row(data, row);
    }
    plot_series series[SHARPNESSES];
    for (int i = 0; i < SHARPNESSES; i++)
        series[i] = (plot_series){legends[i], 1 + i, scale_colour(i), PLOT_LINE, 0.0};
    snprintf(id, sizeof id, "meder_5a_%s", report_label(model, label));
    snprintf(title, sizeof title, "error of c: %s", label);
    plot p = over_angle(id, title, "c of the model − c");
    p.y_range[0] = -0.008;
    p.y_range[1] = 0.008;
    p.data = data;
    p.series = series;
    p.series_count = SHARPNESSES;
    bool done = figure_panel(page, &p);
    data_free(data);
    return done;
}

static bool panel_s(page *page, const report_model *model)
{
    char id[128], title[160], label[64];
    data_table *data = data_new(pairs);
    for (int j = 1; j + 1 < ANGLES; j++) {
        double row[1 + 2 * SHARPNESSES] = {pi * j / (ANGLES - 1)};
        for (int i = 0; i < SHARPNESSES; i++) {
            row[1 + i] = sg_s(sharpness[i], row[0]);
            row[1 + SHARPNESSES + i] = report_s(model->method, sharpness[i], cos(row[0]));
        }
        data_row(data, row);
    }
    plot_series series[2 * SHARPNESSES];
    for (int i = 0; i < SHARPNESSES; i++) {
        series[i] = (plot_series){legends[i], 1 + i, scale_colour(i), PLOT_LINE, 1.3};
        series[SHARPNESSES + i] =
            (plot_series){i ? NULL : "the model, dashed", 1 + SHARPNESSES + i,
                          i ? scale_colour(i) : scale_colour(0), PLOT_DASHED, 2.2};
    }
    snprintf(id, sizeof id, "meder_5b_%s", report_label(model, label));
    snprintf(title, sizeof title, "s, and %s", label);
    plot p = over_angle(id, title, "s(λ, β)");
    p.y_range[1] = 1.02;
    p.data = data;
    p.series = series;
    p.series_count = 2 * SHARPNESSES;
    bool done = figure_panel(page, &p);
    data_free(data);
    return done;
}

bool report_curves(report *report)
{
    report_model models[REPORT_MODELS_MAX];
    size_t count = report_selection(report, "meder_2018", models);
    char text[2][HTML_NUMBER_SIZE];
    double worst[REPORT_MODELS_MAX] = {0.0};
    page *page = report->page;

    figure_begin(page, "meder-5a");
    bool done = panel_c(page);
    for (size_t i = 0; i < count && done; i++)
        done = panel_c_error(page, &models[i], &worst[i]);
    double best = INFINITY;
    for (size_t i = 1; i < count; i++)
        best = fmin(best, worst[i]);
    if (count > 1)
        figure_end(page,
                   "Meder and Brüderlin's figure 5a. As λ grows from 1e-5 to 700, A_h between its "
                   "values at the poles goes from the normalised to the clamped cosine. The "
                   "published constants miss these curves by up to %s, the best fit of ours by %s.",
                   html_number(worst[0], 2, text[0]), html_number(best, 2, text[1]));
    else
        figure_end(page,
                   "Meder and Brüderlin's figure 5a. As λ grows from 1e-5 to 700, A_h between its "
                   "values at the poles goes from the normalised to the clamped cosine.");
    if (!done)
        return false;

    figure_begin(page, "meder-5b");
    for (size_t i = 0; i < count && done; i++)
        done = panel_s(page, &models[i]);
    figure_end(page, "Meder and Brüderlin's figure 5b. s, solved from the reference without the "
                     "cancellation of eq. 16 (solid), and the logistic curve that stands for it "
                     "(dashed), with the published constants and with ours.");
    return done;
}
