/* score.c: see score.h. Rows are independent and are added up in order, so that a score does not
 * depend on the number of cores. */
#define _POSIX_C_SOURCE 200809L
#include "score.h"

#include <math.h>
#include <pthread.h>
#include <stdbool.h>
#include <stdlib.h>

#include "base/progress.h"

static const double pi = 3.14159265358979323846;
static const double infinity = (double)INFINITY;

const char *score_precision_name(score_precision precision)
{
    static const char *const names[SCORE_PRECISIONS] = {"f64", "f32", "f16"};
    return names[precision];
}

double score_lambda(size_t index)
{
    /* The exponent is formed so that the decades that lie on the grid come out exact: 1 is the
     * lower end of a published domain. */
    return pow(10.0, 7.0 * (double)index / (SCORE_LAMBDAS - 1) - 3.0);
}

double score_beta(size_t index)
{
    return pi * (double)index / (SCORE_ANGLES - 1);
}

static double rounded_to_half(double value)
{
    if (value == 0.0 || !isfinite(value))
        return value;
    int exponent = ilogb(value);
    double step = ldexp(1.0, (exponent < -14 ? -14 : exponent) - 10);
    double rounded = nearbyint(value / step) * step;
    return fabs(rounded) > 65504.0 ? copysign(INFINITY, value) : rounded;
}

double score_rounded(score_precision precision, double value)
{
    switch (precision) {
    case SCORE_F32:
        return (double)(float)value;
    case SCORE_F16:
        return rounded_to_half(value);
    default:
        return value;
    }
}

/* ---- The reference tables ------------------------------------------------------------------ */

static double *truths[SCORE_PRECISIONS];
static double cosines[SCORE_ANGLES];

static void fill_truth_row(void *context, size_t index)
{
    (void)context;
    size_t row = index % SCORE_LAMBDAS;
    score_precision precision = (score_precision)(index / SCORE_LAMBDAS);
    double lambda = score_rounded(precision, score_lambda(row));
    double *out = truths[precision] + row * SCORE_ANGLES;
    for (size_t j = 0; j < SCORE_ANGLES; j++)
        out[j] = precision == SCORE_F64 ? sg_L(lambda, score_beta(j))
                                        : sg_L_cos(lambda, score_rounded(precision, cosines[j]));
}

static void fill_truths(void)
{
    for (int p = 0; p < SCORE_PRECISIONS; p++) {
        truths[p] = malloc(sizeof(double) * SCORE_LAMBDAS * SCORE_ANGLES);
        if (!truths[p])
            abort(); /* 3 MB: nothing sensible can follow */
    }
    for (size_t j = 0; j < SCORE_ANGLES; j++)
        cosines[j] = cos(score_beta(j));
    base_parallel((size_t)SCORE_PRECISIONS * SCORE_LAMBDAS, fill_truth_row, NULL);
}

const double *score_truth(score_precision precision)
{
    static pthread_once_t once = PTHREAD_ONCE_INIT;
    pthread_once(&once, fill_truths);
    return truths[precision];
}

/* ---- Scoring --------------------------------------------------------------------------------*/

typedef struct row_job {
    const score_subject *subject;
    score_precision precision;
    const double *truth;
    score_row *rows;
} row_job;

static const score_result nothing = {.max_abs = -1.0,
                                     .max_rel_1e_2 = -1.0,
                                     .max_rel_1e_4 = -1.0,
                                     .rounding = -1.0,
                                     .low = INFINITY,
                                     .high = -INFINITY};

/* rmse holds the sum of squares until finish(). */
static void add_point(score_result *sum, const score_result *point)
{
    if (point->max_abs > sum->max_abs) {
        sum->max_abs = point->max_abs;
        sum->max_abs_lambda = point->max_abs_lambda;
        sum->max_abs_beta = point->max_abs_beta;
    }
    if (point->rounding > sum->rounding) {
        sum->rounding = point->rounding;
        sum->rounding_lambda = point->rounding_lambda;
        sum->rounding_beta = point->rounding_beta;
    }
    sum->max_rel_1e_2 = fmax(sum->max_rel_1e_2, point->max_rel_1e_2);
    sum->max_rel_1e_4 = fmax(sum->max_rel_1e_4, point->max_rel_1e_4);
    sum->low = fmin(sum->low, point->low);
    sum->high = fmax(sum->high, point->high);
    sum->rmse += point->rmse;
    sum->points += point->points;
    sum->not_finite += point->not_finite;
}

static void finish(score_result *sum)
{
    if (sum->points == 0) {
        *sum = (score_result){NAN, NAN, NAN, NAN, NAN, NAN, NAN, NAN, NAN, 0, 0, NAN, NAN};
        return;
    }
    sum->rmse = sqrt(sum->rmse / (double)sum->points);
    sum->max_rel_1e_2 = fmax(sum->max_rel_1e_2, 0.0);
    sum->max_rel_1e_4 = fmax(sum->max_rel_1e_4, 0.0);
}

static void score_row_job(void *context, size_t index)
{
    const row_job *job = context;
    const score_subject *subject = job->subject;
    score_row *row = &job->rows[index];
    *row = nothing;
    double grid_lambda = score_lambda(index);
    double lambda = score_rounded(job->precision, grid_lambda);
    if (lambda < subject->lambda_min || lambda > subject->lambda_max)
        return;
    for (size_t j = 0; j < SCORE_ANGLES; j++) {
        double z = score_rounded(job->precision, cosines[j]);
        double truth = job->truth[index * SCORE_ANGLES + j];
        double value = subject->value(subject->context, lambda, z);
        double twin = subject->twin ? subject->twin(subject->context, lambda, z) : value;
        bool finite = isfinite(value);
        double error = finite ? fabs(value - truth) : infinity;
        /* Where the double breaks as well it is not rounding that broke it. */
        double rounding = !subject->twin || !isfinite(twin) ? 0.0
                          : finite                          ? fabs(value - twin)
                                                            : infinity;
        score_result point = {error,
                              grid_lambda,
                              score_beta(j),
                              error * error,
                              truth > 1e-2 ? error / truth : -1.0,
                              truth > 1e-4 ? error / truth : -1.0,
                              rounding,
                              grid_lambda,
                              score_beta(j),
                              1,
                              finite ? 0 : 1,
                              finite ? value : infinity,
                              finite ? value : -infinity};
        add_point(row, &point);
    }
}

static void raw_rows(const score_subject *subject, score_precision precision,
                     score_row rows[SCORE_LAMBDAS])
{
    row_job job = {subject, precision, score_truth(precision), rows};
    base_parallel(SCORE_LAMBDAS, score_row_job, &job);
}

void score_rows(const score_subject *subject, score_precision precision,
                score_row rows[SCORE_LAMBDAS])
{
    raw_rows(subject, precision, rows);
    for (size_t i = 0; i < SCORE_LAMBDAS; i++)
        finish(&rows[i]);
}

static void score_nothing(score_result *result)
{
    *result = nothing;
    finish(result);
}

void score_run(const score_subject *subject, score_precision precision, score_result *result)
{
    score_row rows[SCORE_LAMBDAS];
    raw_rows(subject, precision, rows);
    *result = nothing;
    for (size_t i = 0; i < SCORE_LAMBDAS; i++)
        add_point(result, &rows[i]);
    finish(result);
}

/* ---- Methods and forms --------------------------------------------------------------------- */

static double method_f64(const void *context, double lambda, double cos_theta)
{
    return ((const sg_method *)context)->L_f64(lambda, cos_theta);
}

static double method_f32(const void *context, double lambda, double cos_theta)
{
    return (double)((const sg_method *)context)->L_f32((float)lambda, (float)cos_theta);
}

static double method_f16(const void *context, double lambda, double cos_theta)
{
    return (double)((const sg_method *)context)->L_f16((float)lambda, (float)cos_theta);
}

score_subject score_method_subject(const sg_method *method, score_precision precision)
{
    static const score_function functions[SCORE_PRECISIONS] = {method_f64, method_f32, method_f16};
    return (score_subject){functions[precision], precision == SCORE_F64 ? NULL : method_f64, method,
                           method->lambda_min, method->lambda_max};
}

void score_method(const sg_method *method, score_precision precision, score_result *result)
{
    score_subject subject = score_method_subject(method, precision);
    if (precision == SCORE_F16 && !method->L_f16)
        score_nothing(result); /* a compiler without half */
    else
        score_run(&subject, precision, result);
}

typedef struct free_form {
    const sg_form *form;
    const double *coefficients;
    const float *narrow;
    score_precision precision;
} free_form;

static double form_f64(const void *context, double lambda, double cos_theta)
{
    const free_form *f = context;
    double value = f->form->f64(lambda, cos_theta, f->coefficients);
    return f->form->native == SG_L ? value : value / sg_A(lambda);
}

static double form_narrow(const void *context, double lambda, double cos_theta)
{
    const free_form *f = context;
    float (*evaluate)(float, float, const float *) =
        f->precision == SCORE_F32 ? f->form->f32 : f->form->f16;
    double value = (double)evaluate((float)lambda, (float)cos_theta, f->narrow);
    if (f->form->native == SG_L)
        return value;
    return score_rounded(f->precision, value / score_rounded(f->precision, sg_A(lambda)));
}

void score_form(const sg_form *form, const double *coefficients, double lambda_min,
                double lambda_max, score_precision precision, score_result *result)
{
    if (precision == SCORE_F16 && !form->f16) {
        score_nothing(result);
        return;
    }
    size_t count = (size_t)form->coefficient_count;
    float *narrow = malloc(sizeof(float) * (count + 1));
    if (!narrow)
        abort();
    for (size_t i = 0; i < count; i++)
        narrow[i] = (float)coefficients[i];
    free_form f = {form, coefficients, narrow, precision};
    bool wide = precision == SCORE_F64;
    score_subject subject = {wide ? form_f64 : form_narrow, wide ? NULL : form_f64, &f, lambda_min,
                             lambda_max};
    score_run(&subject, precision, result);
    free(narrow);
}
