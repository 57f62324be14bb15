/* profile_worth.c: what each coefficient of a fit is worth, without fitting again. */
#include "profile_fit.h"

#include <math.h>
#include <stdlib.h>

static double product(size_t n, const double *a, const double *b)
{
    double sum = 0.0;
    for (size_t i = 0; i < n; i++)
        sum += a[i] * b[i];
    return sum;
}

/* Diagonal of the inverse of a positive definite matrix, n by n, which is destroyed. */
static void inverse_diagonal(double *a, size_t n, double *diagonal)
{
    for (size_t k = 0; k < n; k++) { /* Gauss-Jordan in place; no pivoting is needed */
        double pivot = 1.0 / a[k * n + k];
        a[k * n + k] = 1.0;
        for (size_t j = 0; j < n; j++)
            a[k * n + j] *= pivot;
        for (size_t i = 0; i < n; i++) {
            double factor = a[i * n + k];
            if (i == k)
                continue;
            a[i * n + k] = 0.0;
            for (size_t j = 0; j < n; j++)
                a[i * n + j] -= factor * a[k * n + j];
        }
    }
    for (size_t k = 0; k < n; k++)
        diagonal[k] = a[k * n + k];
}

bool profile_worths(const fit_problem *problem, const size_t *place, double *worth)
{
    size_t n = problem->sample_count, f = problem->parameter_count;
    double *jacobian = malloc(sizeof(double) * (n * (f + 2) + f * f + 1));
    if (!jacobian)
        return false;
    double *normal = jacobian + n * f, *work = normal + f * f, norm[FIT_MOST_PARAMETERS],
           diagonal[FIT_MOST_PARAMETERS];
    bool good = f > 0 && fit_jacobian(problem, problem->start, jacobian, work);
    for (size_t j = 0; good && j < f; j++)
        norm[j] = sqrt(product(n, jacobian + j * n, jacobian + j * n));
    for (size_t a = 0; good && a < f; a++)
        for (size_t b = 0; b <= a; b++) {
            double scale = norm[a] * norm[b];
            double sum = product(n, jacobian + a * n, jacobian + b * n);
            normal[a * f + b] = normal[b * f + a] = a == b        ? 1.0 + 1e-11
                                                    : scale > 0.0 ? sum / scale
                                                                  : 0.0;
        }
    if (good)
        inverse_diagonal(normal, f, diagonal);
    for (size_t j = 0; good && j < f; j++) {
        double x = problem->start[j] * norm[j];
        worth[place[j]] = x * x / fmax(diagonal[j], 1.0);
    }
    free(jacobian);
    return good;
}
