/* figures_hemisphere.c: Tokuyoshi's figure 3: the normalised hemispherical integral by a logistic
 * curve and by an error function, against the reference H, over sharpness. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "html.h"
#include "plot.h"
#include "report.h"

enum { POINTS = 141, ANGLES = 401, CURVES_MAX = 8 };

static const double pi = 3.14159265358979323846;

typedef struct sigmoid {
    char label[64];
    const sg_method *method;
    bool logistic;
    int colour;
    plot_style style;
    double rmse[POINTS];
} sigmoid;

/* The forms compute the whole of A_h, of which this is one factor: the two steepnesses and the two
 * curves of the papers stand here once more because the factor is what this figure is about. */
static double steepness(const sigmoid *s, double l)
{
    const sg_method *m = s->method;
    if (s->logistic)
        return sqrt(l) *
               (report_coefficient(m, "t_cubic") * l + report_coefficient(m, "t_square")) * l /
               (l * l + report_coefficient(m, "t_linear") * l +
                report_coefficient(m, "t_constant"));
    return l * sqrt((0.5 * l + report_coefficient(m, "t_0")) /
                    (l * l + report_coefficient(m, "t_1") * l + report_coefficient(m, "t_2")));
}

static double value(bool logistic, double t, double z)
{
    /* (a b - 1)/((a - 1)(b + 1)) with a = e^t, b = e^(t z), halved into tanh: nothing overflows */
    return logistic ? 0.5 + 0.5 * tanh(0.5 * t * z) / tanh(0.5 * t)
                    : 0.5 + 0.5 * erf(t * z) / erf(t);
}

static double rmse(bool logistic, double t, const double truth[ANGLES])
{
    double sum = 0.0;
    for (int j = 0; j < ANGLES; j++) {
        double difference = value(logistic, t, cos(pi * j / (ANGLES - 1))) - truth[j];
        sum += difference * difference;
    }
    return sqrt(sum / ANGLES);
}

/* The least that one steepness can reach at this sharpness; golden section in log t. */
static double best_rmse(bool logistic, double near, const double truth[ANGLES])
{
    const double golden = 0.61803398874989485;
    double a = log(near) - 1.2, b = log(near) + 1.2;
    for (int i = 0; i < 44; i++) {
        double x = b - golden * (b - a), y = a + golden * (b - a);
        if (rmse(logistic, exp(x), truth) < rmse(logistic, exp(y), truth))
            b = y;
        else
            a = x;
    }
    return rmse(logistic, exp(0.5 * (a + b)), truth);
}

static size_t add_family(const char *published, bool logistic, sigmoid *curves, size_t count)
{
    report_model models[REPORT_MODELS_MAX];
    size_t family = report_family(published, models);
    for (size_t i = 0; i < family && count < CURVES_MAX; i++) {
        sigmoid *s = &curves[count];
        *s = (sigmoid){.method = models[i].method, .logistic = logistic};
        if (!isfinite(steepness(s, 1.0)))
            continue;
        report_label(&models[i], s->label);
        s->colour = (logistic ? 2 : 1) + 2 * (int)i;
        s->style = models[i].ours ? PLOT_LINE : PLOT_DASHED;
        count++;
    }
    return count;
}

bool report_hemisphere(report *report)
{
    sigmoid curves[CURVES_MAX];
    size_t count = add_family("meder_2018_hg", true, curves, 0);
    count = add_family("tokuyoshi_2022", false, curves, count);
    const char *names[CURVES_MAX + 4] = {"lambda"};
    plot_series series[CURVES_MAX + 2];
    for (size_t i = 0; i < count; i++) {
        names[1 + i] = curves[i].label;
        series[i] =
            (plot_series){curves[i].label, 1 + (int)i, curves[i].colour, curves[i].style, 0.0};
    }
    names[1 + count] = "best_logistic";
    names[2 + count] = "best_erf";
    series[count] =
        (plot_series){"best logistic curve at each λ", 1 + (int)count, 2, PLOT_POINTS, 0};
    series[count + 1] =
        (plot_series){"best error function at each λ", 2 + (int)count, 1, PLOT_POINTS, 0};
    data_table *data = data_new(names);
    double first[2] = {0.0, 0.0};
    for (size_t i = 0; i < POINTS; i++) {
        double row[CURVES_MAX + 3] = {report_logarithmic(1e-3, 1e4, i, POINTS)}, truth[ANGLES];
        double low = sg_H(row[0], pi), high = sg_H(row[0], 0.0);
        for (int j = 0; j < ANGLES; j++)
            truth[j] = (sg_H(row[0], pi * j / (ANGLES - 1)) - low) / (high - low);
        for (size_t c = 0; c < count; c++)
            row[1 + c] = rmse(curves[c].logistic, steepness(&curves[c], row[0]), truth);
        /* the limits of t: 0.75 lambda^1/2 ... sqrt(lambda/2); twice as steep for the logistic */
        double near = sqrt(0.5 * row[0]) * sqrt(row[0] / (row[0] + 5.0));
        row[1 + count] = best_rmse(true, 2.4 * near, truth);
        row[2 + count] = best_rmse(false, near, truth);
        first[0] = row[1 + count];
        first[1] = row[2 + count];
        data_row(data, row);
    }
    plot p = {.id = "tokuyoshi_3",
              .title = "normalised hemispherical integral",
              .x_label = "sharpness λ",
              .y_label = "RMSE of (H − H_b)/(H_u − H_b)",
              .x_log = true,
              .y_log = true,
              .x_range = {1e-3, 1e4},
              .y_range = {1e-8, 1e-1},
              .data = data,
              .series = series,
              .series_count = count + 2};
    figure_begin(report->page, "tokuyoshi-3");
    bool done = figure_panel(report->page, &p);
    data_free(data);
    char text[2][HTML_NUMBER_SIZE];
    figure_end(
        report->page,
        "Tokuyoshi's figure 3: root mean square error over %d angles of the hemispherical "
        "integral between its values at the poles, by a logistic curve and by an error "
        "function. Points: the best that either curve can do with a steepness of its own at "
        "each λ. At λ = 1e4 that is %s for the logistic curve and %s for the error function, "
        "which is the integral's limit.",
        ANGLES, html_number(first[0], 2, text[0]), html_number(first[1], 2, text[1]));
    return done;
}
