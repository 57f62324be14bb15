/* report_stability.c: the section "Where methods fail", of what `sgfit stability --out DIR` wrote.
 */
#define _POSIX_C_SOURCE 200809L
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "base/csv.h"
#include "base/file.h"
#include "base/text.h"
#include "html.h"
#include "report.h"
#include "stability.h"

typedef struct failure {
    char method[64], precision[16], kind[32];
    double from, to, worst, lambda, cos_theta;
} failure;

typedef struct failures {
    failure *rows;
    size_t count;
} failures;

bool report_has_stability(const report *report)
{
    return report->stability != NULL;
}

static bool read_row(const base_csv *csv, const int columns[8], failure *row)
{
    snprintf(row->method, sizeof row->method, "%s", csv->fields[columns[0]]);
    snprintf(row->precision, sizeof row->precision, "%s", csv->fields[columns[1]]);
    snprintf(row->kind, sizeof row->kind, "%s", csv->fields[columns[2]]);
    double *const numbers[] = {&row->from, &row->to, &row->worst, &row->lambda, &row->cos_theta};
    for (int i = 0; i < 5; i++)
        if (!base_parse_f64(csv->fields[columns[i + 3]], csv->lengths[columns[i + 3]],
                            numbers[i])) {
            base_csv_error(csv, columns[i + 3], "a number");
            return false;
        }
    return true;
}

static bool read_failures(const char *path, failures *all)
{
    static const char *const names[8] = {"method",       "precision",      "kind",
                                         "lambda_from",  "lambda_to",      "worst",
                                         "worst_lambda", "worst_cos_theta"};
    FILE *stream = fopen(path, "rb");
    if (!stream) {
        base_error("%s: cannot be read, expected what sgfit stability --out writes", path);
        return false;
    }
    base_csv csv;
    int columns[8], more = 0;
    bool good = base_csv_open(&csv, stream, path);
    for (int i = 0; i < 8 && good; i++) {
        columns[i] = base_csv_column(&csv, names[i]);
        good = columns[i] >= 0;
        if (!good)
            base_error("%s: expected a column %s", path, names[i]);
    }
    while (good && (more = base_csv_next(&csv)) > 0) {
        failure *grown = realloc(all->rows, (all->count + 1) * sizeof *grown);
        good = grown != NULL;
        if (grown) {
            all->rows = grown;
            good = read_row(&csv, columns, &grown[all->count++]);
        }
    }
    base_csv_close(&csv);
    fclose(stream);
    return good && more == 0;
}

/* What of a kind is told in the overview; errors of the model are not failures. */
static const char *const told[][2] = {
    {"nan", "NaN"},
    {"infinite", "∞"},
    {"negative", "negative"},
    {"above_one", "above 1"},
    {"A_h_nan", "A_h NaN"},
    {"A_h_infinite", "A_h ∞"},
    {"A_h_negative", "A_h negative"},
    {"rounding_1e-3", "rounding > 1e-3"},
    {"rounding_1e-6", "rounding > 1e-6"},
    {"flushed", "denormals matter"},
    {"limit_at_infinity", "wrong at infinite λ"},
    {"nan_input", "NaN goes unnoticed"},
};

static void overview_cell(report *report, const failures *all, const char *method,
                          const char *precision)
{
    FILE *out = page_html(report->page);
    bool any = false, coarse = false;
    fputs("<td class=\"kinds\">", out);
    for (size_t k = 0; k < sizeof told / sizeof *told; k++) {
        double from = (double)NAN;
        for (size_t i = 0; i < all->count; i++) {
            const failure *f = &all->rows[i];
            if (strcmp(f->method, method) == 0 && strcmp(f->precision, precision) == 0 &&
                strcmp(f->kind, told[k][0]) == 0)
                from = fmin(from, f->from);
        }
        if (isnan(from) || (coarse && strcmp(told[k][0], "rounding_1e-6") == 0))
            continue;
        coarse |= strcmp(told[k][0], "rounding_1e-3") == 0;
        char number[HTML_NUMBER_SIZE];
        fputs(any ? "<br>" : "", out);
        html_text(out, told[k][1]);
        if (strstr(told[k][0], "input") == NULL && strstr(told[k][0], "limit") == NULL)
            fprintf(out, " <small>λ from %s</small>", html_number(from, 3, number));
        any = true;
    }
    fputs(any ? "</td>" : "<span class=\"sound\">none</span></td>", out);
}

static void overview(report *report, const failures *all)
{
    static const char *const columns[] = {"method", "double", "float", "half", "device", NULL};
    static const char *const variants[] = {"published", "stable", "refit", "tier"};
    html_table_begin(report->page,
                     "What fails, and from which sharpness on: no model's own error, but values "
                     "that are no light, and digits lost to rounding.",
                     columns);
    for (size_t v = 0; v < sizeof variants / sizeof *variants; v++)
        for (size_t i = 0, first = 1; i < report->methods; i++) {
            const sg_method *m = sg_method_at(i);
            if (strcmp(m->variant, variants[v]) != 0)
                continue;
            html_row_begin(report->page, first ? "group" : NULL);
            first = 0;
            fprintf(page_html(report->page), "<td><code>%s</code><br><small>%s</small></td>", m->id,
                    m->variant);
            for (int p = 0; p < STABILITY_PRECISIONS; p++)
                overview_cell(report, all, m->id, stability_precision_name((stability_precision)p));
            html_row_end(report->page);
        }
    html_table_end(report->page, NULL);
}

static void whole_list(report *report, const failures *all)
{
    static const char *const columns[] = {"method", "precision", "what",      "#λ from", "#to",
                                          "#worst", "#at λ",     "#at cos θ", NULL};
    page *page = report->page;
    fputs("<details><summary>Every failure and its boundaries</summary>\n", page_html(page));
    html_table_begin(page,
                     "Found by scanning and bisection. error: of the model and of rounding, "
                     "against the reference; rounding: against the same formula, wider.",
                     columns);
    FILE *csv = page_file_begin(page, "data/failures.csv");
    fputs("method,precision,kind,lambda_from,lambda_to,worst,worst_lambda,worst_cos_theta\n", csv);
    for (size_t i = 0; i < all->count; i++) {
        const failure *f = &all->rows[i];
        const double numbers[] = {f->from, f->to, f->worst, f->lambda, f->cos_theta};
        html_row_begin(page, NULL);
        html_cell_code(page, f->method);
        html_cell(page, f->precision);
        html_cell(page, f->kind);
        fprintf(csv, "%s,%s,%s", f->method, f->precision, f->kind);
        for (int n = 0; n < 5; n++) {
            char text[BASE_NUMBER_SIZE];
            html_cell_number(page, numbers[n], 4);
            fprintf(csv, ",%s", base_shortest_f64(numbers[n], text));
        }
        fputc('\n', csv);
        html_row_end(page);
    }
    page_file_end(page);
    html_table_end(page, "data/failures.csv");
    fputs("</details>\n", page_html(page));
}

bool report_stability(report *report)
{
    failures all = {0};
    char *path = base_join(report->stability, "failures.csv");
    bool done = read_failures(path, &all);
    free(path);
    if (done) {
        html_paragraph(
            report->page,
            "`sgfit stability` scans sharpnesses from 0 through the denormals to infinity and "
            "cosines in and slightly outside [−1, 1], and NaN, and bisects where values turn "
            "negative, exceed 1, or are no numbers. A published formula typed as printed is beside "
            "its stable variant and our own forms.");
        overview(report, &all);
        whole_list(report, &all);
        report_csv_table(report, "half.csv", "Half: how far a method may be used in it.");
        report_csv_table(report, "smoothness.csv",
                         "Smoothness: the largest jump of the first derivative, and monotony.");
        done = report_maps(report);
    }
    free(all.rows);
    return done;
}
