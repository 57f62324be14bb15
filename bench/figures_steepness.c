/* figures_steepness.c: Meder and Bruederlin's figure 6: steepness t and height u of the logistic
 * curve over sharpness: the best at each sharpness, as published, and as refitted. */
#include <math.h>
#include <stdio.h>

#include "base/progress.h"
#include "html.h"
#include "plot.h"
#include "report.h"

enum { POINTS = 121, ANGLES = 201 };

static const double pi = 3.14159265358979323846;

/* The sum of squared errors of L over uniform angles for a given t, with the u that makes it
 * least: L is linear in u. */
typedef struct curve {
    double high, low; /* (A_u - A_b)/A and A_b/A */
    double truth[ANGLES];
} curve;

static double squares(const curve *c, double t, double *u)
{
    double gg = 0.0, gr = 0.0, rr = 0.0;
    for (int j = 0; j < ANGLES; j++) {
        double z = cos(pi * j / (ANGLES - 1)), side = fabs(z);
        double g = 0.5 * (1.0 - side) * c->high / (exp(side * t) + 1.0);
        double r = c->truth[j] - c->low - (z > 0.0 ? z : 0.0) * c->high;
        gg += g * g;
        gr += g * r;
        rr += r * r;
    }
    *u = gr / gg;
    return rr - gr * gr / gg;
}

/* The best t lies within a factor of 4 of the two limits' blend; golden section in log t. */
static void best_logistic(double lambda, double *t, double *u)
{
    curve c = {
        (sg_A_u(lambda) - sg_A_b(lambda)) / sg_A(lambda), sg_A_b(lambda) / sg_A(lambda), {0}};
    for (int j = 0; j < ANGLES; j++)
        c.truth[j] = sg_L(lambda, pi * j / (ANGLES - 1));
    double middle = log(2.1583 * lambda / (sqrt(lambda) + 2.1583 / 0.375));
    const double golden = 0.61803398874989485;
    double a = middle - 1.4, b = middle + 1.4, x = b - golden * (b - a), y = a + golden * (b - a);
    double at_x = squares(&c, exp(x), u), at_y = squares(&c, exp(y), u);
    for (int i = 0; i < 60; i++) {
        if (at_x < at_y) {
            b = y;
            y = x;
            at_y = at_x;
            x = b - golden * (b - a);
            at_x = squares(&c, exp(x), u);
        } else {
            a = x;
            x = y;
            at_x = at_y;
            y = a + golden * (b - a);
            at_y = squares(&c, exp(y), u);
        }
    }
    *t = exp(0.5 * (a + b));
    squares(&c, *t, u);
}

typedef struct job {
    double low, high;
    bool linear;
    double lambda[POINTS], t[POINTS], u[POINTS];
} job;

static void one(void *context, size_t i)
{
    job *j = context;
    double part = (double)i / (POINTS - 1);
    j->lambda[i] = j->linear ? j->low + (j->high - j->low) * part * part
                             : report_logarithmic(j->low, j->high, i, POINTS);
    best_logistic(j->lambda[i], &j->t[i], &j->u[i]);
}

/* Columns: lambda, the best, then each model; what: 't' or 'u'. */
static bool panel(page *page, const plot *frame, const job *job, char what,
                  const report_model *models, size_t count)
{
    char labels[REPORT_MODELS_MAX][64];
    const char *names[3 + REPORT_MODELS_MAX] = {"lambda", "best"};
    plot_series series[1 + REPORT_MODELS_MAX];
    for (size_t m = 0; m < count; m++) {
        names[2 + m] = report_label(&models[m], labels[m]);
        series[m] =
            (plot_series){labels[m], 2 + (int)m, models[m].ours ? report_our_colour(m - 1) : 2,
                          m ? PLOT_LINE : PLOT_DASHED, m ? 1.8 : 2.2};
    }
    names[2 + count] = NULL;
    series[count] = (plot_series){"best at each λ", 1, PLOT_INK, PLOT_POINTS, 0.0};
    data_table *data = data_new(names);
    for (size_t i = 0; i < POINTS; i++) {
        double row[2 + REPORT_MODELS_MAX] = {job->lambda[i], what == 't' ? job->t[i] : job->u[i]};
        for (size_t m = 0; m < count; m++) {
            double t, u;
            report_logistic(models[m].method, job->lambda[i], &t, &u);
            row[2 + m] = what == 't' ? t : u;
        }
        data_row(data, row);
    }
    plot p = *frame;
    p.data = data;
    p.series = series;
    p.series_count = count + 1;
    bool done = figure_panel(page, &p);
    data_free(data);
    return done;
}

bool report_steepness(report *report)
{
    report_model models[REPORT_MODELS_MAX];
    size_t count = report_family("meder_2018", models);
    job as_printed = {.low = 1e-5, .high = 700.0, .linear = true};
    job wide = {.low = 1e-3, .high = 1e4};
    base_parallel(POINTS, one, &as_printed);
    base_parallel(POINTS, one, &wide);
    plot frames[] = {{.id = "meder_6", .title = "t(λ), as in the paper", .y_label = "steepness t"},
                     {.id = "meder_6_log", .title = "t(λ), logarithmic", .y_label = "steepness t"},
                     {.id = "meder_6_u", .title = "u(λ)", .y_label = "height u"}};
    for (int i = 0; i < 3; i++)
        frames[i].x_label = "sharpness λ";
    frames[1].x_log = frames[1].y_log = frames[2].x_log = frames[2].y_log = true;
    figure_begin(report->page, "meder-6");
    bool done = panel(report->page, &frames[0], &as_printed, 't', models, count) &&
                panel(report->page, &frames[1], &wide, 't', models, count) &&
                panel(report->page, &frames[2], &wide, 'u', models, count);
    if (!done)
        return false;
    double published_t = NAN, published_u = NAN;
    char text[4][HTML_NUMBER_SIZE];
    if (count)
        report_logistic(models[0].method, wide.lambda[0], &published_t, &published_u);
    figure_end(report->page,
               "Meder and Brüderlin's figure 6. The t and u that fit the reference best at each λ "
               "by itself (points; least squares over L at %d angles), and the functions of λ that "
               "stand for them. On the paper's axes the published t follows the points; on "
               "logarithmic ones it leaves them as λ falls: at λ = %s it is %s instead of %s.",
               ANGLES, html_number(wide.lambda[0], 1, text[0]),
               html_number(published_t, 2, text[1]), html_number(wide.t[0], 2, text[2]));
    return true;
}
