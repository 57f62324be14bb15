/* report_headline.c: the few figures that say what the rest of the report is about. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "html.h"
#include "report.h"

/* On the page, and as a line on standard output. */
static void tile(page *page, const char *figure, const char *text)
{
    FILE *out = page_html(page);
    printf("%-14s %s\n", figure, text);
    fputs("<li><b>", out);
    html_text(out, figure);
    fputs("</b><span>", out);
    html_text(out, text);
    fputs("</span></li>\n", out);
}

/* The method of the wanted kinds with the least value in double; methods that are declared for a
 * part of the grid are left out. NULL where there is none. */
static const sg_method *least(const report *report, bool published, bool by_rmse, double *value)
{
    const sg_method *best = NULL;
    *value = (double)INFINITY;
    for (size_t i = 0; i < report->methods; i++) {
        const sg_method *m = sg_method_at(i);
        const score_result *r = &report->scores[i][SCORE_F64];
        bool is_published = strcmp(m->variant, "published") == 0;
        if (is_published != published || strcmp(m->variant, "stable") == 0 ||
            r->points < (size_t)SCORE_LAMBDAS * SCORE_ANGLES)
            continue;
        double error = by_rmse ? r->rmse : r->max_abs;
        if (error < *value) {
            *value = error;
            best = m;
        }
    }
    return best;
}

static void best_tile(report *report, bool published, bool by_rmse, const char *what)
{
    char figure[HTML_NUMBER_SIZE], text[200];
    double value;
    const sg_method *best = least(report, published, by_rmse, &value);
    if (!best)
        return;
    snprintf(text, sizeof text, "%s: `%s`", what, best->id);
    tile(report->page, html_number(value, 3, figure), text);
}

bool report_headline(report *report)
{
    page *page = report->page;
    char figure[HTML_NUMBER_SIZE], text[200];
    size_t broken = 0, published = 0, constants, met;
    if (!report_fit_tally(&constants, &met))
        return false;
    for (size_t i = 0; i < report->methods; i++) {
        if (strcmp(sg_method_at(i)->variant, "published") != 0)
            continue;
        published++;
        const score_result *r = &report->scores[i][SCORE_F32];
        broken += !(r->rounding < 1e-3) || r->not_finite > 0;
    }
    fputs("<ul class=\"headline\">\n", page_html(page));
    snprintf(figure, sizeof figure, "%zu methods", report->methods);
    snprintf(text, sizeof text, "each measured at %d points, in double, float and half",
             SCORE_LAMBDAS * SCORE_ANGLES);
    tile(page, figure, text);
    snprintf(figure, sizeof figure, "%zu of %zu", met, constants);
    tile(page, figure,
         "published constants regenerated from the integral as closely as their recipes promise");
    best_tile(report, true, false, "smallest maximum error of L among the published methods");
    best_tile(report, false, false, "smallest maximum error of L with constants fitted here");
    best_tile(report, true, true, "smallest RMSE of L among the published methods");
    best_tile(report, false, true, "smallest RMSE of L with constants fitted here");
    snprintf(figure, sizeof figure, "%zu of %zu", broken, published);
    tile(page, figure,
         "published methods lose more than 1e-3, or all, to float when typed as printed");
    if (report->batch_speed_up > 0.0) {
        snprintf(text, sizeof text,
                 "times as fast: the reference in batches of 4096 points, "
                 "against single calls");
        tile(page, html_number(report->batch_speed_up, 2, figure), text);
    }
    fputs("</ul>\n", page_html(page));
    html_paragraph(
        page, "A spherical Gaussian of sharpness λ, G = exp(λ(cos − 1)), lights a surface "
              "whose normal stands at the angle β to its axis. A_h is its integral over the "
              "hemisphere against the clamped cosine; it has no closed form, and the methods "
              "here approximate it. All errors are those of L = A_h/A, the same integral for a "
              "lobe that integrates to 1, so that 1 is the brightest a surface can be. All "
              "numbers were computed when this page was written; each table and plot links to "
              "the file behind it.");
    return true;
}
