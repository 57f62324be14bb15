#include "whiten.h"

#include <math.h>
#include <string.h>

/* Upper Cholesky factor of the Gram matrix of the columns scaled to length 1. */
static void factor(size_t rows, size_t m, const double *jacobian, const double *length,
                   double r[FIT_MOST_PARAMETERS][FIT_MOST_PARAMETERS])
{
    for (size_t a = 0; a < m; a++) {
        for (size_t b = a; b < m; b++) {
            double sum = 0.0;
            for (size_t i = 0; i < rows; i++)
                sum += jacobian[a * rows + i] * jacobian[b * rows + i];
            r[a][b] = sum / (length[a] * length[b]);
        }
        r[a][a] += 1e-13; /* keeps the factor alive where parameters are not told apart */
    }
    for (size_t a = 0; a < m; a++) {
        for (size_t b = a; b < m; b++) {
            double sum = r[a][b];
            for (size_t k = 0; k < a; k++)
                sum -= r[k][a] * r[k][b];
            r[a][b] = b == a ? sqrt(fmax(sum, 1e-14)) : sum / r[a][a];
        }
    }
}

void fit_whiten(fit_whitening *w, size_t rows, size_t count, const double *centre,
                const double *jacobian, double size, bool diagonal)
{
    double length[FIT_MOST_PARAMETERS];
    double r[FIT_MOST_PARAMETERS][FIT_MOST_PARAMETERS];
    memset(w, 0, sizeof *w);
    w->count = count;
    w->diagonal = diagonal;
    memcpy(w->centre, centre, sizeof(double) * count);
    for (size_t j = 0; j < count; j++) {
        double sum = 0.0;
        for (size_t i = 0; i < rows; i++)
            sum += jacobian[j * rows + i] * jacobian[j * rows + i];
        length[j] = sum > 0.0 ? sqrt(sum) : 1.0;
    }
    if (diagonal) {
        for (size_t j = 0; j < count; j++)
            w->transform[j][j] = size / length[j];
        return;
    }
    factor(rows, count, jacobian, length, r);
    /* transform = size D R^-1, column by column from R x = e */
    for (size_t b = 0; b < count; b++) {
        for (size_t a = b + 1; a-- > 0;) {
            double sum = a == b ? 1.0 : 0.0;
            for (size_t k = a + 1; k <= b; k++)
                sum -= r[a][k] * w->transform[k][b];
            w->transform[a][b] = sum / r[a][a];
        }
    }
    for (size_t a = 0; a < count; a++)
        for (size_t b = 0; b < count; b++)
            w->transform[a][b] *= size / length[a];
}

void fit_unwhiten(const fit_whitening *w, const double *y, double *parameters)
{
    for (size_t a = 0; a < w->count; a++) {
        double sum = 0.0;
        for (size_t b = a; b < w->count; b++)
            sum += w->transform[a][b] * y[b];
        parameters[a] = w->centre[a] + sum;
    }
}

void fit_whiten_gradient(const fit_whitening *w, const double *gradient, double *by_y)
{
    for (size_t b = 0; b < w->count; b++) {
        by_y[b] = 0.0;
        for (size_t a = 0; a <= b; a++)
            by_y[b] += w->transform[a][b] * gradient[a];
    }
}
