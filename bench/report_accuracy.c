/* report_accuracy.c: the error table of all methods: accuracy.csv and its three tables. */
#include <math.h>
#include <stdio.h>

#include "base/text.h"
#include "html.h"
#include "report.h"

static void csv_numbers(FILE *out, const double *values, size_t count)
{
    char text[BASE_NUMBER_SIZE];
    for (size_t i = 0; i < count; i++)
        fprintf(out, ",%s", base_shortest_f64(values[i], text));
}

static void write_csv(report *report)
{
    FILE *out = page_file_begin(report->page, "accuracy.csv");
    fputs("method,precision,max_abs,max_abs_lambda,max_abs_beta,rmse,max_rel_1e-2,max_rel_1e-4\n",
          out);
    for (size_t i = 0; i < report->methods; i++)
        for (int p = 0; p < SCORE_PRECISIONS; p++) {
            const score_result *r = &report->scores[i][p];
            fprintf(out, "%s,%s", sg_method_at(i)->id, score_precision_name((score_precision)p));
            csv_numbers(out,
                        (double[]){r->max_abs, r->max_abs_lambda, r->max_abs_beta, r->rmse,
                                   r->max_rel_1e_2, r->max_rel_1e_4},
                        6);
            fputc('\n', out);
        }
    page_file_end(report->page);

    out = page_file_begin(report->page, "data/rounding.csv");
    fputs("method,precision,rounding,rounding_lambda,rounding_beta,not_finite,points,low,high\n",
          out);
    for (size_t i = 0; i < report->methods; i++)
        for (int p = SCORE_F32; p < SCORE_PRECISIONS; p++) {
            const score_result *r = &report->scores[i][p];
            fprintf(out, "%s,%s", sg_method_at(i)->id, score_precision_name((score_precision)p));
            csv_numbers(out,
                        (double[]){r->rounding, r->rounding_lambda, r->rounding_beta,
                                   (double)r->not_finite, (double)r->points, r->low, r->high},
                        7);
            fputc('\n', out);
        }
    page_file_end(report->page);
}

static void cell_error(page *page, double value)
{
    html_cell_marked(page, value, 3, isfinite(value) ? NULL : "bad", NULL);
}

static void write_row(report *report, size_t index, score_precision precision)
{
    page *page = report->page;
    const sg_method *method = sg_method_at(index);
    const score_result *r = &report->scores[index][precision];
    html_row_begin(page, NULL);
    html_cell_code(page, method->id);
    html_cell(page, method->variant);
    cell_error(page, r->max_abs);
    html_cell_number(page, r->max_abs_lambda, 3);
    html_cell_number(page, r->max_abs_beta, 3);
    cell_error(page, r->rmse);
    cell_error(page, r->max_rel_1e_2);
    cell_error(page, r->max_rel_1e_4);
    if (precision != SCORE_F64) {
        cell_error(page, r->rounding);
        html_cell_number(page, r->rounding_lambda, 3);
        html_cell_number(page, r->rounding_beta, 3);
    }
    html_row_end(page);
}

bool report_accuracy(report *report)
{
    static const char *const captions[SCORE_PRECISIONS] = {
        "In double: the error of the model itself.",
        "In float: the model, and what rounding adds to it.",
        "In half, at every step: what remains of each method where only 11 bits are to be had."};
    static const char *const wide[] = {"method",
                                       "variant",
                                       "#max |error|",
                                       "#at λ",
                                       "#at β",
                                       "#RMSE",
                                       "#max relative where L > 1e-2",
                                       "#where L > 1e-4",
                                       NULL};
    static const char *const narrow[] = {"method",
                                         "variant",
                                         "#max |error|",
                                         "#at λ",
                                         "#at β",
                                         "#RMSE",
                                         "#max relative where L > 1e-2",
                                         "#where L > 1e-4",
                                         "#rounding alone",
                                         "#at λ",
                                         "#at β",
                                         NULL};
    write_csv(report);
    html_paragraph(report->page,
                   "Errors of L = A_h/A against the reference, at %d sharpnesses, logarithmic on "
                   "[1e-3, 1e4], times %d angles, uniform on [0, π]; a method that is declared "
                   "for fewer sharpnesses is measured on those. In float and half the truth is "
                   "taken at the rounded arguments. ∞ means a result that was not finite, first "
                   "met at the place given. “Rounding alone” is the difference from double of the "
                   "same formula.",
                   SCORE_LAMBDAS, SCORE_ANGLES);
    for (int p = 0; p < SCORE_PRECISIONS; p++) {
        html_table_begin(report->page, captions[p], p == SCORE_F64 ? wide : narrow);
        for (size_t i = 0; i < report->methods; i++)
            write_row(report, i, (score_precision)p);
        html_table_end(report->page, p == SCORE_F64 ? "accuracy.csv" : "data/rounding.csv");
    }
    return true;
}
