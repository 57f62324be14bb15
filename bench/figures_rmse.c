/* figures_rmse.c: Meder and Bruederlin's figure 7: the root mean square error of the methods over
 * sharpness, as in the paper (A_h) and normalised (L, all methods of the registry's families). */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "html.h"
#include "plot.h"
#include "report.h"

enum { METHODS_MAX = 24 };

typedef struct profile {
    const char *label;
    int colour;
    plot_style style;
    double width;
    double rmse[SCORE_LAMBDAS]; /* of L */
} profile;

static void measure(const report_model *model, profile *out)
{
    static score_row rows[SCORE_LAMBDAS];
    score_subject subject = score_method_subject(model->method, SCORE_F64);
    score_rows(&subject, SCORE_F64, rows);
    for (size_t i = 0; i < SCORE_LAMBDAS; i++)
        out->rmse[i] = rows[i].rmse;
    out->label = model->method->id;
}

static bool panel(page *page, const plot *frame, const profile *profiles, size_t count, bool of_A_h)
{
    const char *names[METHODS_MAX + 2] = {"lambda"};
    plot_series series[METHODS_MAX];
    for (size_t m = 0; m < count; m++) {
        names[1 + m] = profiles[m].label;
        series[m] = (plot_series){profiles[m].label, 1 + (int)m, profiles[m].colour,
                                  profiles[m].style, profiles[m].width};
    }
    data_table *data = data_new(names);
    for (size_t i = 0; i < SCORE_LAMBDAS; i++) {
        double row[METHODS_MAX + 1] = {score_lambda(i)};
        for (size_t m = 0; m < count; m++)
            row[1 + m] = profiles[m].rmse[i] * (of_A_h ? sg_A(row[0]) : 1.0);
        data_row(data, row);
    }
    plot p = *frame;
    p.data = data;
    p.series = series;
    p.series_count = count;
    bool done = figure_panel(page, &p);
    data_free(data);
    return done;
}

/* The methods that the paper compares, then the refits of its own. */
static size_t of_the_paper(profile *profiles)
{
    static const char *const others[] = {"constant_cosine", "tokuyoshi_2016"};
    size_t count = 0;
    for (size_t i = 0; i < 2; i++) {
        report_model model = {sg_method_find(others[i]), false};
        if (!model.method)
            continue;
        measure(&model, &profiles[count]);
        profiles[count].style = PLOT_DASHED;
        profiles[count].width = 2.0;
        profiles[count].colour = (int)(5 - 2 * i); /* not among ours */
        count++;
    }
    report_model models[REPORT_MODELS_MAX];
    size_t family = report_family("meder_2018", models);
    if (family && sg_method_find("meder_2018"))
        models[0].method = sg_method_find("meder_2018");
    for (size_t i = 0; i < family; i++, count++) {
        measure(&models[i], &profiles[count]);
        profiles[count].style = i ? PLOT_LINE : PLOT_DASHED;
        profiles[count].colour = i ? report_our_colour(i - 1) : 2;
        profiles[count].width = i ? 2.2 : 2.4;
    }
    return count;
}

/* Every published method. */
static size_t published(profile *profiles)
{
    size_t count = 0;
    for (size_t i = 0; i < sg_method_count() && count < 9; i++) {
        report_model model = {sg_method_at(i), false};
        if (strcmp(model.method->variant, "published") != 0)
            continue;
        measure(&model, &profiles[count]);
        profiles[count].colour = 1 + (int)count;
        profiles[count].style = PLOT_LINE;
        profiles[count].width = 1.8;
        count++;
    }
    return count;
}

/* Our methods of one variant, and the best published one. */
static size_t of_ours(const char *variant, profile *profiles)
{
    size_t count = 0, ours = 0;
    for (size_t i = 0; i < sg_method_count() && count < 12; i++) {
        report_model model = {sg_method_at(i), true};
        if (strcmp(model.method->variant, variant) != 0)
            continue;
        measure(&model, &profiles[count]);
        profiles[count].colour = report_our_colour(ours);
        profiles[count].style = ours < 6 ? PLOT_LINE : PLOT_DOTTED;
        profiles[count].width = 2.0;
        count++;
        ours++;
    }
    report_model best = {sg_method_find("tokuyoshi_2024"), false};
    if (best.method && count) {
        measure(&best, &profiles[count]);
        profiles[count].colour = PLOT_INK;
        profiles[count].style = PLOT_DASHED;
        profiles[count++].width = 2.0;
    }
    return count;
}

bool report_rmse(report *report)
{
    profile *profiles = calloc(METHODS_MAX, sizeof *profiles);
    if (!profiles)
        return false;
    plot frames[] = {{.id = "meder_7",
                      .title = "of A_h, as in the paper",
                      .y_label = "RMSE of A_h",
                      .y_range = {1e-9, 10.0}},
                     {.id = "meder_7_L",
                      .title = "of L, every published method",
                      .y_label = "RMSE of L",
                      .y_range = {1e-6, 1.0}},
                     {.id = "meder_7_ours",
                      .title = "of L, published forms refitted",
                      .y_label = "RMSE of L",
                      .y_range = {1e-7, 1e-2}},
                     {.id = "meder_7_tiers",
                      .title = "of L, forms of our own",
                      .y_label = "RMSE of L",
                      .y_range = {1e-9, 1e-2}}};
    for (int i = 0; i < 4; i++) {
        frames[i].x_label = "sharpness λ";
        frames[i].x_log = frames[i].y_log = true;
        frames[i].x_range[0] = 1e-3;
        frames[i].x_range[1] = 1e4;
    }
    figure_begin(report->page, "meder-7");
    size_t count = of_the_paper(profiles);
    bool done = panel(report->page, &frames[0], profiles, count, true);
    count = published(profiles);
    done = done && panel(report->page, &frames[1], profiles, count, false);
    double constant = NAN;
    for (size_t m = 0; m < count; m++)
        if (strcmp(profiles[m].label, "constant_cosine") == 0)
            constant = profiles[m].rmse[0] * sg_A(score_lambda(0));
    for (int i = 0; i < 2; i++) {
        count = of_ours(i ? "tier" : "refit", profiles);
        done = done && (count == 0 || panel(report->page, &frames[2 + i], profiles, count, false));
    }
    char text[HTML_NUMBER_SIZE];
    figure_end(report->page,
               "Meder and Brüderlin's figure 7: root mean square error over %d angles at each "
               "sharpness, in double. Their picture crops the constant cosine, which reaches %s "
               "as λ goes to 0; on a logarithmic axis nothing needs cropping, and A_h, which "
               "falls like 1/λ, no longer hides the errors of L at high sharpness (second panel).",
               SCORE_ANGLES, html_number(constant, 2, text));
    free(profiles);
    return done;
}
