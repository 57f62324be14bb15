/* report_fits.c: what the recipes of `sgfit fit` gave, as tables/constants records it: published
 * constants regenerated, what was tried where that failed, and new constants beside the old. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/text.h"
#include "html.h"
#include "report.h"
#include "report_constants.h"

/* "least_squares, λ 0.25 to 10000, log × cos_theta, uniform" */
static void describe(const cJSON *entry, char *text, size_t size)
{
    const cJSON *lambda = cJSON_GetObjectItemCaseSensitive(
        cJSON_GetObjectItemCaseSensitive(entry, "domain"), "lambda");
    const cJSON *grid = cJSON_GetObjectItemCaseSensitive(entry, "grid");
    const cJSON *weights = cJSON_GetObjectItemCaseSensitive(entry, "weights");
    const char *spacing =
        report_constants_text(cJSON_GetObjectItemCaseSensitive(grid, "lambda"), "spacing");
    const cJSON *low = cJSON_GetArrayItem(lambda, 0), *high = cJSON_GetArrayItem(lambda, 1);
    double by_lambda = report_constants_number(weights, "lambda");
    double by_value = report_constants_number(weights, "value");
    char power[64] = "";
    if (fabs(by_lambda) > 0.0)
        snprintf(power, sizeof power, ", weight λ^%g", by_lambda);
    else if (fabs(by_value) > 0.0)
        snprintf(power, sizeof power, ", weight value^%g", by_value);
    snprintf(text, size, "%s; λ from %g to %g%s%s%s", report_constants_text(entry, "objective"),
             cJSON_IsNumber(low) ? low->valuedouble : (double)NAN,
             cJSON_IsNumber(high) ? high->valuedouble : (double)INFINITY,
             *spacing ? ", spacing " : "", spacing, power);
    for (char *c = text; *c; c++)
        *c = *c == '_' ? ' ' : *c;
}

/* ---- Published constants, regenerated ------------------------------------------------------- */

typedef struct tally {
    size_t constants, met;
} tally;

static void write_constant(page *page, FILE *csv, const char *method, const cJSON *recipe,
                           const cJSON *constant, bool first, tally *tally)
{
    char text[5][BASE_NUMBER_SIZE], how[200];
    double published = report_constants_number(constant, "published"),
           ours = report_constants_number(constant, "ours");
    double relative = report_constants_number(constant, "relative"),
           bar = report_constants_number(constant, "bar");
    bool met = !(relative > bar);
    describe(recipe, how, sizeof how);
    base_shortest_f64(published, text[0]);
    base_shortest_f64(ours, text[1]);
    fprintf(csv, "%s,%s,%s,%s,%s,%s,%s\n", method, recipe->string, constant->string, text[0],
            text[1], base_shortest_f64(relative, text[2]), base_shortest_f64(bar, text[3]));
    html_row_begin(page, first ? "group" : NULL);
    html_cell_code(page, first ? method : "");
    html_cell_code(page, constant->string);
    html_cell(page, text[0]);
    html_cell(page, text[1]);
    html_cell_marked(page, relative, 2, met ? "good" : "bad", NULL);
    if (isnan(bar))
        html_cell(page, "");
    else
        html_cell_number(page, bar, 2);
    html_cell_wrap(page, first ? how : "");
    html_row_end(page);
    tally->constants++;
    tally->met += met && !isnan(bar);
}

static tally write_regenerated(report *report, const report_constants *c)
{
    static const char *const columns[] = {
        "method", "constant", "published", "ours", "#relative difference", "#allowed", "how", NULL};
    page *page = report->page;
    tally tally = {0, 0};
    FILE *csv = page_file_begin(page, "data/fits.csv");
    fputs("method,recipe,constant,published,ours,relative_difference,allowed\n", csv);
    html_table_begin(page, "Published constants, regenerated from the integral.", columns);
    for (size_t i = 0; i < c->count; i++) {
        const cJSON *recipe, *constant;
        cJSON_ArrayForEach(recipe, cJSON_GetObjectItemCaseSensitive(c->files[i], "regenerated"))
        {
            bool first = true;
            cJSON_ArrayForEach(constant, cJSON_GetObjectItemCaseSensitive(recipe, "constants"))
            {
                write_constant(page, csv, report_constants_text(c->files[i], "id"), recipe,
                               constant, first, &tally);
                first = false;
            }
        }
    }
    page_file_end(page);
    html_table_end(page, "data/fits.csv");
    return tally;
}

/* ---- What was tried -------------------------------------------------------------------------- */

static void write_attempt(page *page, const cJSON *recipe, const cJSON *attempt, bool first)
{
    char list[512] = "", how[200], number[HTML_NUMBER_SIZE];
    size_t used = 0;
    const cJSON *constant;
    cJSON_ArrayForEach(constant, cJSON_GetObjectItemCaseSensitive(attempt, "constants"))
    {
        if (used < sizeof list)
            used += (size_t)snprintf(
                list + used, sizeof list - used, "%s%s = %s", used ? ", " : "", constant->string,
                html_number(cJSON_IsNumber(constant) ? constant->valuedouble : (double)NAN, 5,
                            number));
    }
    describe(attempt, how, sizeof how);
    html_row_begin(page, first ? "group" : NULL);
    html_cell_code(page, first ? recipe->string : "");
    html_cell_wrap(page, report_constants_text(attempt, "what"));
    html_cell_wrap(page, list);
    html_cell_number(page, report_constants_number(attempt, "rms"), 2);
    html_cell_wrap(page, how);
    html_row_end(page);
}

static void write_tried(report *report, const report_constants *c)
{
    static const char *const columns[] = {"recipe",        "other way", "gives",
                                          "#rms residual", "how",       NULL};
    page *page = report->page;
    bool any = false;
    for (size_t i = 0; i < c->count; i++) {
        const cJSON *recipe, *attempt;
        cJSON_ArrayForEach(recipe, cJSON_GetObjectItemCaseSensitive(c->files[i], "regenerated"))
        {
            bool first = true;
            cJSON_ArrayForEach(attempt, cJSON_GetObjectItemCaseSensitive(recipe, "tried"))
            {
                if (!any)
                    fputs("<details>\n<summary>Other ways that were tried</summary>\n",
                          page_html(page));
                if (!any)
                    html_table_begin(page,
                                     "Other ways that were tried to reach the published "
                                     "constants, and what they give.",
                                     columns);
                any = true;
                write_attempt(page, recipe, attempt, first);
                first = false;
            }
        }
    }
    if (any) {
        html_table_end(page, NULL);
        fputs("</details>\n", page_html(page));
    }
    for (size_t i = 0; i < c->count; i++) {
        const cJSON *recipe;
        cJSON_ArrayForEach(recipe, cJSON_GetObjectItemCaseSensitive(c->files[i], "regenerated"))
        {
            if (*report_constants_text(recipe, "note"))
                html_paragraph(page, "`%s`: %s", recipe->string,
                               report_constants_text(recipe, "note"));
        }
    }
}

/* ---- New constants --------------------------------------------------------------------------- */

static size_t index_of(const sg_method *method)
{
    size_t i = 0;
    while (i < sg_method_count() && sg_method_at(i) != method)
        i++;
    return i;
}

static const cJSON *provenance_of(const report_constants *c, const char *id)
{
    for (size_t i = 0; i < c->count; i++)
        if (strcmp(report_constants_text(c->files[i], "id"), id) == 0)
            return cJSON_GetObjectItemCaseSensitive(c->files[i], "provenance");
    return NULL;
}

static void write_refit(report *report, const report_constants *c, size_t index, FILE *csv)
{
    page *page = report->page;
    const sg_method *method = sg_method_at(index), *old = report_published(method);
    const score_result *now = &report->scores[index][SCORE_F64];
    const score_result *before = old ? &report->scores[index_of(old)][SCORE_F64] : NULL;
    char how[200] = "", text[4][BASE_NUMBER_SIZE];
    const cJSON *provenance = provenance_of(c, method->id);
    if (provenance)
        describe(provenance, how, sizeof how);
    html_row_begin(page, NULL);
    html_cell_code(page, method->id);
    html_cell_code(page, method->form->id);
    html_cell_number(page, before ? before->max_abs : (double)NAN, 3);
    html_cell_number(page, now->max_abs, 3);
    html_cell_number(page, before ? before->rmse : (double)NAN, 3);
    html_cell_number(page, now->rmse, 3);
    html_cell_wrap(page, how);
    html_row_end(page);
    fprintf(csv, "%s,%s,%s,%s,%s,%s,%s\n", method->id, method->form->id, old ? old->id : "",
            base_shortest_f64(before ? before->max_abs : (double)NAN, text[0]),
            base_shortest_f64(now->max_abs, text[1]),
            base_shortest_f64(before ? before->rmse : (double)NAN, text[2]),
            base_shortest_f64(now->rmse, text[3]));
}

static void write_refits(report *report, const report_constants *c)
{
    static const char *const columns[] = {"method",
                                          "form",
                                          "#max |error| as published",
                                          "#refitted",
                                          "#RMSE as published",
                                          "#refitted",
                                          "how",
                                          NULL};
    FILE *csv = page_file_begin(report->page, "data/refits.csv");
    fputs("method,form,published,max_abs_published,max_abs,rmse_published,rmse\n", csv);
    html_table_begin(report->page, "New constants, beside the published ones (L in double).",
                     columns);
    for (size_t i = 0; i < report->methods; i++) {
        const char *variant = sg_method_at(i)->variant;
        if (strcmp(variant, "refit") == 0)
            write_refit(report, c, i, csv);
    }
    page_file_end(report->page);
    html_table_end(report->page, "data/refits.csv");
}

bool report_fits(report *report)
{
    report_constants c;
    bool done = report_constants_read(&c);
    if (done) {
        html_paragraph(
            report->page,
            "The recipes in `fit/recipes` start from nothing but the integral. Each fit "
            "is solved by Ceres and by NLopt, which must agree; the result is scored with "
            "the reference. “Allowed” is the relative difference that a recipe promises "
            "at most.");
        tally tally = write_regenerated(report, &c);
        html_paragraph(report->page,
                       "%zu published constants were fitted again; %zu lie within "
                       "what their recipe promises.",
                       tally.constants, tally.met);
        write_tried(report, &c);
        write_refits(report, &c);
    }
    report_constants_free(&c);
    return done;
}
