#include "problem.h"

#include <math.h>
#include <stdlib.h>

bool fit_problem_allocate(fit_problem *problem, size_t sample_count)
{
    double *block = malloc(sizeof(double) * 4 * (sample_count + 1));
    if (!block)
        return false;
    problem->sample_count = sample_count;
    problem->lambda = block;
    problem->cos_theta = block + (sample_count + 1);
    problem->target = block + 2 * (sample_count + 1);
    problem->scale = block + 3 * (sample_count + 1);
    return true;
}

void fit_problem_free(fit_problem *problem)
{
    free(problem->lambda);
    problem->lambda = problem->cos_theta = problem->target = problem->scale = NULL;
    problem->sample_count = 0;
}

void fit_problem_normalise(fit_problem *problem)
{
    double sum = 0.0;
    for (size_t i = 0; i < problem->sample_count; i++)
        sum += problem->scale[i] * problem->scale[i];
    if (!(sum > 0.0))
        return;
    double factor = 1.0 / sqrt(sum);
    for (size_t i = 0; i < problem->sample_count; i++)
        problem->scale[i] *= factor;
}

/* The raised residual; *slope, where wanted, what a derivative of the residual is multiplied by. */
static double raised(const fit_problem *problem, double residual, double *slope)
{
    double half = 0.5 * problem->power, part = fabs(residual) / problem->unit;
    double below = pow(part, half - 1.0);
    if (slope)
        *slope = half * below / problem->unit;
    return copysign(below * part, residual);
}

bool fit_residuals(const fit_problem *problem, const double *parameters, double *residuals)
{
    problem->model(problem->context, parameters, problem->sample_count, problem->lambda,
                   problem->cos_theta, residuals);
    bool finite = true;
    for (size_t i = 0; i < problem->sample_count; i++) {
        residuals[i] = problem->scale[i] * (residuals[i] - problem->target[i]);
        if (problem->power > 2.0)
            residuals[i] = raised(problem, residuals[i], NULL);
        finite = finite && isfinite(residuals[i]);
    }
    return finite;
}

/* The columns of plain residuals become those of raised ones. */
static void raise_jacobian(const fit_problem *problem, const double *parameters, double *jacobian,
                           double *work)
{
    size_t n = problem->sample_count;
    problem->model(problem->context, parameters, n, problem->lambda, problem->cos_theta, work);
    for (size_t i = 0; i < n; i++) {
        double slope;
        raised(problem, problem->scale[i] * (work[i] - problem->target[i]), &slope);
        for (size_t j = 0; j < problem->parameter_count; j++)
            jacobian[j * n + i] *= slope;
    }
}

bool fit_jacobian(const fit_problem *problem, const double *parameters, double *jacobian,
                  double *work)
{
    size_t n = problem->sample_count;
    double moved[FIT_MOST_PARAMETERS];
    for (size_t j = 0; j < problem->parameter_count; j++)
        moved[j] = parameters[j];
    bool finite = true;
    for (size_t j = 0; j < problem->parameter_count; j++) {
        double magnitude = fmax(fabs(parameters[j]), 1e-3 * fabs(problem->start[j]));
        double step = 6e-6 * (magnitude > 0.0 ? magnitude : 1.0);
        moved[j] = parameters[j] + step;
        double above = moved[j];
        problem->model(problem->context, moved, n, problem->lambda, problem->cos_theta, work);
        moved[j] = parameters[j] - step;
        double below = moved[j];
        problem->model(problem->context, moved, n, problem->lambda, problem->cos_theta, work + n);
        moved[j] = parameters[j];
        double *column = jacobian + j * n;
        for (size_t i = 0; i < n; i++) {
            column[i] = problem->scale[i] * (work[i] - work[n + i]) / (above - below);
            finite = finite && isfinite(column[i]);
        }
    }
    if (problem->power > 2.0)
        raise_jacobian(problem, parameters, jacobian, work);
    return finite;
}

double fit_sum_of_squares(const fit_problem *problem, const double *residuals)
{
    double sum = 0.0;
    for (size_t i = 0; i < problem->sample_count; i++)
        sum += residuals[i] * residuals[i];
    return sum;
}

double fit_largest(const fit_problem *problem, const double *residuals, size_t *place)
{
    double largest = -1.0;
    for (size_t i = 0; i < problem->sample_count; i++) {
        if (fabs(residuals[i]) > largest) {
            largest = fabs(residuals[i]);
            if (place)
                *place = i;
        }
    }
    return largest;
}

double fit_disagreement(size_t count, const double *a, const double *b)
{
    double worst = 0.0;
    for (size_t j = 0; j < count; j++) {
        double size = fmax(fabs(a[j]), fabs(b[j]));
        double difference = fabs(a[j] - b[j]);
        worst = fmax(worst, size > 0.0 ? difference / size : difference);
    }
    return worst;
}
