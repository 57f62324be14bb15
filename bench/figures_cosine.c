/* figures_cosine.c: Tokuyoshi's figure 2: the clamped cosine as a lobe less a constant, and how far
 * each set of constants is from it. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "html.h"
#include "plot.h"
#include "report.h"

enum { POINTS = 201, CURVES_MAX = 8 };

/* scale (exp(sharpness z) - 1) + rest, z = cos of the angle to the normal: a lobe of amplitude
 * scale e^sharpness less the constant scale - rest. */
typedef struct lobe_cosine {
    char label[80];
    double sharpness, scale, rest;
    int colour;
    plot_style style;
} lobe_cosine;

static double error_at(const lobe_cosine *c, double z)
{
    return c->scale * expm1(c->sharpness * z) + c->rest - z;
}

/* The forms write it in three ways. */
static bool read_cosine(const sg_method *m, lobe_cosine *c)
{
    double amplitude = report_coefficient(m, "cosine_amplitude");
    double alpha = report_coefficient(m, "alpha");
    c->sharpness = report_coefficient(m, "cosine_sharpness");
    c->scale = report_coefficient(m, "cosine_scale");
    c->rest = report_coefficient(m, "cosine_rest");
    if (isfinite(amplitude)) {
        c->scale = amplitude * exp(-c->sharpness);
        c->rest = c->scale - report_coefficient(m, "cosine_offset");
    } else if (isfinite(alpha)) {
        c->scale = alpha;
        c->rest = 0.0;
    }
    return isfinite(c->sharpness + c->scale + c->rest);
}

static size_t add_family(const char *published, lobe_cosine *curves, size_t count)
{
    report_model models[REPORT_MODELS_MAX];
    size_t family = report_family(published, models);
    for (size_t i = 0; i < family && count < CURVES_MAX; i++) {
        const sg_method *m = models[i].method;
        char label[64];
        lobe_cosine c = {0};
        bool known = !read_cosine(m, &c); /* a refit of the steepness alone has the same cosine */
        for (size_t j = 0; j < count; j++)
            known = known || (curves[j].sharpness == c.sharpness && curves[j].scale == c.scale);
        if (known)
            continue;
        snprintf(c.label, sizeof c.label, "%s", report_label(&models[i], label));
        c.colour = 1 + (int)count;
        c.style = models[i].ours ? PLOT_LINE : PLOT_DASHED;
        curves[count++] = c;
    }
    return count;
}

static void caption(page *page, const lobe_cosine *curves, const double *worst, size_t count)
{
    char text[2048] = "", number[2][HTML_NUMBER_SIZE];
    size_t used = 0;
    double largest = 0.0;
    for (size_t i = 0; i < count && used < sizeof text; i++) {
        used += (size_t)snprintf(text + used, sizeof text - used, "%s`%s` %s", i ? ", " : "",
                                 curves[i].label, html_number(worst[i], 2, number[0]));
        largest = fmax(largest, curves[i].scale * exp(curves[i].sharpness));
    }
    figure_end(page,
               "Tokuyoshi's figure 2: a lobe less a constant against the clamped cosine, over the "
               "upper hemisphere. Largest differences: %s. A smaller sharpness comes closer to the "
               "cosine, and pays for it in float: the two numbers whose difference is taken grow "
               "to %s.",
               text, html_number(largest, 3, number[1]));
}

/* What the poster's misprint costs in L, on the grid of the accuracy table. */
static void misprint(page *page)
{
    const sg_method *m = sg_method_find("meder_2018_hg");
    int offset = -1;
    for (int i = 0; m && i < m->form->coefficient_count; i++)
        if (strcmp(m->form->coefficient_names[i], "cosine_offset") == 0)
            offset = i;
    if (offset < 0 || m->form->coefficient_count > 16)
        return;
    double k[16];
    memcpy(k, m->coefficients, (size_t)m->form->coefficient_count * sizeof *k);
    score_result right, wrong;
    score_form(m->form, k, m->lambda_min, m->lambda_max, SCORE_F64, &right);
    double kept = k[offset];
    k[offset] = 31.703;
    score_form(m->form, k, m->lambda_min, m->lambda_max, SCORE_F64, &wrong);
    char text[7][HTML_NUMBER_SIZE];
    html_paragraph(
        page,
        "The poster prints the constant of `meder_2018_hg` as 31.703. With it the error "
        "of L grows from %s to %s (at λ = %s, β = %s), its RMSE from %s to %s. Implementations "
        "in public use carry %s.",
        html_number(right.max_abs, 3, text[0]), html_number(wrong.max_abs, 3, text[1]),
        html_number(wrong.max_abs_lambda, 3, text[2]), html_number(wrong.max_abs_beta, 3, text[3]),
        html_number(right.rmse, 2, text[4]), html_number(wrong.rmse, 2, text[5]),
        html_number(kept, 6, text[6]));
}

bool report_cosine(report *report)
{
    lobe_cosine curves[CURVES_MAX];
    size_t count = add_family("meder_2018_hg", curves, 0);
    if (count) { /* the poster's misprint, beside what it misprints */
        curves[count] = curves[0];
        curves[count].rest = curves[count].scale - 31.703;
        curves[count].colour = 8;
        curves[count].style = PLOT_DOTTED;
        snprintf(curves[count].label, sizeof curves[count].label,
                 "meder_2018_hg with the poster's 31.703");
        count++;
    }
    count = add_family("tokuyoshi_2022", curves, count);
    const char *names[CURVES_MAX + 2] = {"cos_theta"};
    plot_series series[CURVES_MAX];
    for (size_t i = 0; i < count; i++) {
        names[1 + i] = curves[i].label;
        series[i] =
            (plot_series){curves[i].label, 1 + (int)i, curves[i].colour, curves[i].style, 0};
    }
    data_table *data = data_new(names), *sizes = data_new(names);
    double worst[CURVES_MAX] = {0.0};
    for (int j = 0; j < POINTS; j++) {
        double z = (double)j / (POINTS - 1), row[CURVES_MAX + 1] = {z};
        for (size_t i = 0; i < count; i++) {
            row[1 + i] = error_at(&curves[i], z);
            worst[i] = fmax(worst[i], fabs(row[1 + i]));
        }
        data_row(data, row);
        for (size_t i = 0; i < count; i++)
            row[1 + i] = fabs(row[1 + i]) > 1e-9 ? fabs(row[1 + i]) : (double)NAN;
        data_row(sizes, row);
    }
    plot p = {.id = "tokuyoshi_2",
              .title = "difference from the clamped cosine",
              .x_label = "cosine of the angle to the normal",
              .y_label = "approximation − cosine",
              .x_range = {0.0, 1.0},
              .data = data,
              .series = series,
              .series_count = count};
    figure_begin(report->page, "tokuyoshi-2");
    bool done = count == 0 || figure_panel(report->page, &p);
    p.id = "tokuyoshi_2_log";
    p.title = "its size, logarithmic";
    p.y_label = "|approximation − cosine|";
    p.y_log = true;
    p.y_range[0] = 1e-6;
    p.y_range[1] = 1e-1;
    p.data = sizes;
    done = done && (count == 0 || figure_panel(report->page, &p));
    data_free(data);
    data_free(sizes);
    caption(report->page, curves, worst, count);
    misprint(report->page);
    return done;
}
