/* whiten.h: a change of variables that makes a fit look round.
 *
 * Rational functions have coefficients that nearly cancel each other. In variables y with
 *     parameters = centre + T y,   (J T)^T (J T) = size^2 I
 * at the centre, a quasi-Newton method that starts from the identity starts right. */
#ifndef FIT_WHITEN_H
#define FIT_WHITEN_H

#include "problem.h"

typedef struct fit_whitening {
    size_t count;
    double centre[FIT_MOST_PARAMETERS];
    double transform[FIT_MOST_PARAMETERS][FIT_MOST_PARAMETERS]; /* upper triangular */
    bool diagonal;
} fit_whitening;

/* From the Jacobian at centre (columns of rows doubles). diagonal: only the scales, so that bounds
 * of the parameters stay bounds of y. size: what one unit of y changes the residuals by, in norm.
 */
void fit_whiten(fit_whitening *w, size_t rows, size_t count, const double *centre,
                const double *jacobian, double size, bool diagonal);
void fit_unwhiten(const fit_whitening *w, const double *y, double *parameters);
/* gradient with respect to y from that with respect to the parameters */
void fit_whiten_gradient(const fit_whitening *w, const double *gradient, double *by_y);

#endif
