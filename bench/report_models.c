/* report_models.c: which methods of the registry a figure shows, and curves read off them. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "report.h"

static bool is(const sg_method *method, const char *variant)
{
    return strcmp(method->variant, variant) == 0;
}

/* Forms of ours that keep the structure of a published model under another name. */
static const char *const continuations[][2] = {{"logistic_limits", "meder_2018"}};

/* The longest published id that the method's continues, so that meder_2018_hg_refit belongs to
 * meder_2018_hg and not to meder_2018. */
const sg_method *report_published(const sg_method *method)
{
    const sg_method *best = NULL;
    size_t length = 0;
    for (size_t i = 0; i < sg_method_count(); i++) {
        const sg_method *m = sg_method_at(i);
        size_t n = strlen(m->id);
        if (is(m, "published") && n > length && strncmp(method->id, m->id, n) == 0) {
            best = m;
            length = n;
        }
    }
    for (size_t i = 0; !best && i < sizeof continuations / sizeof *continuations; i++)
        if (strcmp(method->form->id, continuations[i][0]) == 0)
            best = sg_method_find(continuations[i][1]);
    return best;
}

size_t report_family(const char *published, report_model models[REPORT_MODELS_MAX])
{
    size_t count = 0;
    char stable[64];
    snprintf(stable, sizeof stable, "%s_stable", published);
    const sg_method *first = sg_method_find(stable);
    if (!first)
        first = sg_method_find(published);
    if (first)
        models[count++] = (report_model){first, false};
    for (size_t i = 0; i < sg_method_count() && count < REPORT_MODELS_MAX; i++) {
        const sg_method *m = sg_method_at(i);
        const sg_method *base = is(m, "refit") ? report_published(m) : NULL;
        if (base && strcmp(base->id, published) == 0)
            models[count++] = (report_model){m, true};
    }
    return count;
}

static size_t index_of(const sg_method *method)
{
    size_t i = 0;
    while (sg_method_at(i) != method)
        i++;
    return i;
}

size_t report_selection(const report *report, const char *published,
                        report_model models[REPORT_MODELS_MAX])
{
    size_t count = report_family(published, models);
    report_model by_rmse = {NULL, true}, by_max = {NULL, true};
    double rmse = (double)INFINITY, max_abs = (double)INFINITY;
    for (size_t i = 0; i < count; i++) {
        const score_result *r = &report->scores[index_of(models[i].method)][SCORE_F64];
        if (models[i].ours && r->rmse < rmse) {
            rmse = r->rmse;
            by_rmse = models[i];
        }
        if (models[i].ours && r->max_abs < max_abs) {
            max_abs = r->max_abs;
            by_max = models[i];
        }
    }
    count = count && !models[0].ours ? 1 : 0;
    if (by_rmse.method)
        models[count++] = by_rmse;
    if (by_max.method && by_max.method != by_rmse.method)
        models[count++] = by_max;
    return count;
}

int report_our_colour(size_t i)
{
    static const int colours[] = {1, 7, 4, 6, 9, 8};
    return colours[i % (sizeof colours / sizeof *colours)];
}

const char *report_label(const report_model *model, char text[64])
{
    snprintf(text, 64, "%s", model->method->id);
    char *end = strstr(text, "_stable");
    if (end && !model->ours)
        *end = '\0';
    return text;
}

double report_coefficient(const sg_method *method, const char *name)
{
    const sg_form *form = method->form;
    for (int i = 0; i < form->coefficient_count; i++)
        if (strcmp(form->coefficient_names[i], name) == 0)
            return method->coefficients[i];
    return (double)NAN;
}

double report_c(const sg_method *method, double lambda, double cos_theta)
{
    double low = sg_A_b(lambda), high = sg_A_u(lambda);
    return (method->A_h_f64(lambda, cos_theta) - low) / (high - low);
}

double report_s(const sg_method *method, double lambda, double cos_theta)
{
    double clamped = cos_theta > 0.0 ? cos_theta : 0.0;
    return (report_c(method, lambda, cos_theta) - clamped) / (0.5 * (1.0 - fabs(cos_theta)));
}

void report_logistic(const sg_method *method, double lambda, double *t, double *u)
{
    /* s = u/(e^(t |z|) + 1) at z = 0 and at one |z| where s is neither 1/2 nor nothing. */
    double z = fmin(0.5, 1.0 / (1.0 + 0.5 * sqrt(lambda)));
    double at_horizon = report_s(method, lambda, 0.0);
    *u = 2.0 * at_horizon;
    *t = log(2.0 * at_horizon / report_s(method, lambda, -z) - 1.0) / z;
}

double report_logarithmic(double low, double high, size_t i, size_t n)
{
    return low * pow(high / low, (double)i / (double)(n - 1));
}
