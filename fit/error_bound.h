/* error_bound.h: the sharpness of the lobe that stands for the clamped cosine in Tokuyoshi 2022.
 *
 * Approximation and rounding error together are largest along the normal. With e half of the
 * machine epsilon, the corrected bound there is E(l) = (1 + e) l ((1 + e) e^l - 1 + e)/(2 e^l - 2 -
 * 2 l) - 1; the poster prints the denominator as 2 e^l - 2 - l, whose E has no such minimum. */
#ifndef FIT_ERROR_BOUND_H
#define FIT_ERROR_BOUND_H

#include <stdbool.h>

/* The numerator of dE/dl up to a positive factor, divided by l^2, in series that do not cancel. */
long double fit_error_bound_slope(long double l, long double e);
/* E itself. */
long double fit_error_bound(long double l, long double e);

/* The root of the slope in [low, high], by bisection to the last bit of a double; false where the
 * slope has the same sign at both. */
bool fit_error_bound_root(double epsilon, double low, double high, double *root, int *iterations);

/* alpha = l/(2 e^l - 2 - 2 l) */
double fit_cosine_normalisation(double l);

#endif
