/* report_formulas.c: the papers' closed formulas evaluated as they are printed, in double and in
 * float, against the reference: how much of each is left, and where. */
#include <math.h>
#include <stdio.h>

#include "base/text.h"
#include "html.h"
#include "report.h"

/* Every operation rounds to the type, as in a program that takes the formula from the paper. */
static double A_u_f64(double l)
{
    return 2.0 * 3.14159265358979323846 / (l * l) * (exp(-l) - 1.0 + l);
}
static double A_u_f32(double l)
{
    float x = (float)l;
    return (double)(2.0f * 3.14159265f / (x * x) * (expf(-x) - 1.0f + x));
}
static double A_b_f64(double l)
{
    return 2.0 * 3.14159265358979323846 / (l * l) * exp(-2.0 * l) * (exp(l) - 1.0 - l);
}
static double A_b_f32(double l)
{
    float x = (float)l;
    return (double)(2.0f * 3.14159265f / (x * x) * expf(-2.0f * x) * (expf(x) - 1.0f - x));
}

/* s solved from eq. 16 and c from eq. 15, with A_h, A_u and A_b exact to the last bit or two; next
 * to a pole, where it is worst. */
static double s_printed(double l)
{
    double beta = 0.005, z = cos(beta), clamped = z > 0.0 ? z : 0.0;
    double c = (sg_A_h(l, beta) - sg_A_b(l)) / (sg_A_u(l) - sg_A_b(l));
    return (c - clamped) / (0.5 * z + 0.5 - clamped);
}
static double s_truth(double l)
{
    return sg_s(l, 0.005);
}

/* The product of a lobe of sharpness l with one of sharpness 2 whose axis stands at 60 degrees, its
 * amplitude as printed, exp(l3 - l1 - l2), and with the difference taken before the root. */
static double product_truth(double l)
{
    double l3 = sqrt(l * l + 2.0 * l + 4.0);
    return exp(-2.0 * l / (l3 + l + 2.0));
}
static double product_f32(double l)
{
    float x = (float)l;
    return (double)expf(sqrtf(x * x + 2.0f * x + 4.0f) - x - 2.0f);
}
static double product_f64(double l)
{
    return exp(sqrt(l * l + 2.0 * l + 4.0) - l - 2.0);
}

typedef struct formula {
    const char *name, *precision;
    double (*printed)(double lambda);
    double (*truth)(double lambda);
    double lambda[4];
} formula;

static const formula formulas[] = {
    {"A_u as printed (eq. 9)", "double", A_u_f64, sg_A_u, {1e-3, 1e-5, 1e-8, 1e-9}},
    {"A_u as printed (eq. 9)", "float", A_u_f32, sg_A_u, {1e-1, 1e-3, 1e-4, 1e-5}},
    {"A_b as printed (eq. 10)", "double", A_b_f64, sg_A_b, {1e-5, 300.0, 400.0, 800.0}},
    {"A_b as printed (eq. 10)", "float", A_b_f32, sg_A_b, {1e-3, 50.0, 88.0, 89.0}},
    {"s solved from eq. 16, β = 0.005", "double", s_printed, s_truth, {1e-3, 1e-5, 1e-7, 1e-8}},
    {"product's amplitude (eq. 3), at 60° to sharpness 2",
     "double",
     product_f64,
     product_truth,
     {1e2, 1e4, 1e8, 1e16}},
    {"product's amplitude (eq. 3), at 60° to sharpness 2",
     "float",
     product_f32,
     product_truth,
     {1e2, 1e3, 1e4, 1e8}},
};

typedef struct sample {
    double value, truth, error;
} sample;

/* The worst of 65 sharpnesses within a tenth of lambda: at a single one the rounding errors of a
 * cancellation may cancel as well. */
static sample worst_near(const formula *f, double lambda)
{
    sample worst = {0.0, 0.0, -1.0};
    for (int i = -32; i <= 32; i++) {
        double near = lambda * (1.0 + i / 320.0);
        sample s = {f->printed(near), f->truth(near), 0.0};
        s.error = fabs(s.value - s.truth) / fabs(s.truth);
        if (isnan(s.value))
            s.error = (double)INFINITY;
        if (s.error > worst.error)
            worst = s;
    }
    return worst;
}

bool report_formulas(report *report)
{
    static const char *const columns[] = {"formula",         "in", "#λ", "#as printed", "#truth",
                                          "#relative error", NULL};
    page *page = report->page;
    html_paragraph(page,
                   "Closed formulas are exact on paper only. These are the papers' own, typed "
                   "as printed; `libsg` has each without the cancellation.");
    FILE *out = page_file_begin(page, "data/formulas.csv");
    fputs("formula,precision,lambda,printed,truth,relative_error\n", out);
    html_table_begin(page,
                     "The papers' closed formulas as printed: the worst of 65 sharpnesses "
                     "within a tenth of λ.",
                     columns);
    for (size_t i = 0; i < sizeof formulas / sizeof *formulas; i++) {
        const formula *f = &formulas[i];
        for (int j = 0; j < 4; j++) {
            double lambda = f->lambda[j];
            sample s = worst_near(f, lambda);
            char text[4][BASE_NUMBER_SIZE];
            fprintf(out, "\"%s\",%s,%s,%s,%s,%s\n", f->name, f->precision,
                    base_shortest_f64(lambda, text[0]), base_shortest_f64(s.value, text[1]),
                    base_shortest_f64(s.truth, text[2]), base_shortest_f64(s.error, text[3]));
            html_row_begin(page, j ? NULL : "group");
            html_cell(page, j ? "" : f->name);
            html_cell(page, j ? "" : f->precision);
            html_cell_number(page, lambda, 1);
            html_cell_number(page, s.value, 4);
            html_cell_number(page, s.truth, 4);
            html_cell_marked(page, s.error, 2, s.error < 1e-3 ? "good" : "bad", NULL);
            html_row_end(page);
        }
    }
    page_file_end(page);
    html_table_end(page, "data/formulas.csv");
    double r = 1.0;
    char text[2][HTML_NUMBER_SIZE];
    html_paragraph(
        page,
        "Two more break without a cancellation. Two lobes of equal sharpness and "
        "opposite axes have a product of sharpness 0, whose axis eq. 3 divides by zero. "
        "And r/(1 − r), the sharpness of the moments' mean length r, is %s for one light "
        "alone (r = 1); Banerjee's rule gives %s there too, which is why the library "
        "takes a largest sharpness.",
        html_number(sg_sharpness_from_mean_toksvig(r), 2, text[0]),
        html_number(sg_sharpness_from_mean_banerjee(r), 2, text[1]));
    return true;
}
