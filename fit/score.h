/* score.h: how far an approximation of L is from the reference, on the one grid that every figure
 * of this project is measured on.
 *
 * The grid: SCORE_LAMBDAS sharpnesses, logarithmic on [1e-3, 1e4], times SCORE_ANGLES angles,
 * uniform on [0, pi], both ends included. Only sharpnesses inside the method's own domain count.
 *
 * Precision: for float and half, lambda and cos_theta are rounded to the type first, and the truth
 * is the reference at those rounded arguments, so that what is measured is the method and not the
 * rounding of its arguments. A result that is not finite counts as an infinite error at its place.
 *
 * Where the compiler has no half, scores in half have points == 0 and errors of NaN.
 *
 * The reference tables (one for each precision) are computed at first use, on all cores, and
 * kept for the life of the process. Everything here may be called from several threads. */
#ifndef FIT_SCORE_H
#define FIT_SCORE_H

#include <stddef.h>

#include "sg.h"

enum { SCORE_LAMBDAS = 400, SCORE_ANGLES = 1001 };

typedef enum score_precision { SCORE_F64, SCORE_F32, SCORE_F16, SCORE_PRECISIONS } score_precision;

const char *score_precision_name(score_precision precision); /* "f64", "f32", "f16" */

/* The grid, before any rounding; lambda index < SCORE_LAMBDAS, beta index < SCORE_ANGLES. */
double score_lambda(size_t index);
double score_beta(size_t index);
/* A number as the precision holds it: unchanged, or rounded to float or to IEEE half. */
double score_rounded(score_precision precision, double value);
/* The reference L at [lambda index * SCORE_ANGLES + beta index], at the rounded arguments. */
const double *score_truth(score_precision precision);

/* What is scored: value(context, lambda, cos_theta), called with arguments already rounded. */
typedef double (*score_function)(const void *context, double lambda, double cos_theta);

typedef struct score_subject {
    score_function value;
    score_function twin; /* the same text in double, to tell rounding error apart; may be NULL */
    const void *context;
    double lambda_min, lambda_max; /* domain; lambda_max may be infinite */
} score_subject;

typedef struct score_result {
    double max_abs, max_abs_lambda, max_abs_beta; /* places are grid points, unrounded */
    double rmse;
    double max_rel_1e_2, max_rel_1e_4; /* relative, where the truth is above 1e-2 and 1e-4 */
    /* Largest difference from the twin, and where; 0 without a twin. */
    double rounding, rounding_lambda, rounding_beta;
    size_t points;     /* grid points inside the domain */
    size_t not_finite; /* of which not finite */
    double low, high;  /* smallest and largest finite value */
} score_result;

/* The error of one sharpness over all angles. */
typedef score_result score_row;

/* One row for each sharpness of the grid; rows outside the domain have points == 0. */
void score_rows(const score_subject *subject, score_precision precision,
                score_row rows[SCORE_LAMBDAS]);
/* All rows together. A domain without a grid point gives points == 0 and errors of NaN. */
void score_run(const score_subject *subject, score_precision precision, score_result *result);

/* A method of the registry: its L in that precision; the twin is its own double. */
void score_method(const sg_method *method, score_precision precision, score_result *result);
score_subject score_method_subject(const sg_method *method, score_precision precision);

/* A form with coefficients that are not compiled in (fit uses this). Coefficients are rounded to
 * float for SCORE_F32 and SCORE_F16, as in the compiled methods. Where the form computes A_h, it
 * is divided by the integral A, taken from the reference and rounded to the precision. */
void score_form(const sg_form *form, const double *coefficients, double lambda_min,
                double lambda_max, score_precision precision, score_result *result);

#endif
