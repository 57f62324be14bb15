/* problem.h: one fitting problem, as every solver sees it.
 *
 * Samples are a plain list, in no particular order and on no particular grid: arguments (lambda,
 * cos_theta), the value wanted there and a scale. The model has free parameters. Residual i is
 *     scale[i] (model(lambda[i], cos_theta[i]; parameters) - target[i]);
 * least squares makes the sum of their squares small, minimax the largest of their magnitudes. */
#ifndef FIT_PROBLEM_H
#define FIT_PROBLEM_H

#include <stdbool.h>
#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

enum { FIT_MOST_PARAMETERS = 64 };

/* Values of the model at count samples. Must be re-entrant. */
typedef void (*fit_model)(const void *context, const double *parameters, size_t count,
                          const double *lambda, const double *cos_theta, double *values);

typedef struct fit_problem {
    size_t sample_count;
    double *lambda, *cos_theta, *target, *scale;
    size_t parameter_count; /* at most FIT_MOST_PARAMETERS */
    double start[FIT_MOST_PARAMETERS];
    double lower[FIT_MOST_PARAMETERS], upper[FIT_MOST_PARAMETERS]; /* infinite where free */
    /* Above 2: residuals are raised, sign kept, so that least squares makes the sum of
     * |residual / unit|^power small, which between least squares and minimax leads from the one to
     * the other. 0: as they are. */
    double power, unit;
    fit_model model;
    const void *context;
} fit_problem;

/* Arrays for that many samples, unfilled; false where there is no memory for them. */
bool fit_problem_allocate(fit_problem *problem, size_t sample_count);
void fit_problem_free(fit_problem *problem); /* the arrays; zeroes allowed */

/* The weights of a least-squares problem, made to add up to 1 over all samples: the sum of squares
 * is then the weighted mean square, whatever the number of samples. */
void fit_problem_normalise(fit_problem *problem);

/* Residuals at the parameters, sample_count of them. False if any is not finite. */
bool fit_residuals(const fit_problem *problem, const double *parameters, double *residuals);

/* Derivatives of the residuals by central differences, one column of sample_count after another.
 * work holds 2 sample_count doubles. Steps are about 6e-6 of a parameter, which leaves a relative
 * error of about 1e-10: that moves a least-squares solution by less than that. */
bool fit_jacobian(const fit_problem *problem, const double *parameters, double *jacobian,
                  double *work);

double fit_sum_of_squares(const fit_problem *problem, const double *residuals);
/* The largest magnitude, its sample in *place (may be NULL). */
double fit_largest(const fit_problem *problem, const double *residuals, size_t *place);

/* Largest difference of two parameter vectors, relative to the larger magnitude of each. */
double fit_disagreement(size_t count, const double *a, const double *b);

#ifdef __cplusplus
}
#endif

#endif
