#include "fit/error_bound.h"

#include <math.h>

/* sum of l^k/(k + first)! : (e^l - 1)/l for first = 1, (e^l - 1 - l)/l^2 for 2 */
static long double exponential_tail(long double l, int first)
{
    long double term = 1.0L, sum = 0.0L;
    for (int k = 2; k <= first; k++)
        term /= k;
    for (int k = 1; k < 60; k++) {
        sum += term;
        term *= l / (k + first);
    }
    return sum;
}

/* The numerator's derivative times the denominator less the other way round, the factor 2 (1 + e)
 * left out. With q = e^l - 1 = l q1 and p = q - l = l^2 p2:
 *     ((1 + e) q + 2 e + l (1 + e)(1 + q)) p - l ((1 + e) q + 2 e) q
 * Of order l^3 it is (1 + e)(l^3 - l^3): that part is taken out by hand. Divided by l^2:
 *     (1 + e) l (q1 p2 + (1 + q) p2 - q1^2) + 2 e (p2 - q1)
 * and q1 p2 + p2 + l q1 p2 - q1^2, of order l, with q1 = 1 + l p2 and p2 = 1/2 + l p3. */
long double fit_error_bound_slope(long double l, long double e)
{
    long double p3 = exponential_tail(l, 3), p2 = 0.5L + l * p3, q1 = 1.0L + l * p2;
    /* (2 p2 - 1) + l p2 (p2 + q1 - 2) - l^2 p2^2, with 2 p2 - 1 = 2 l p3 */
    long double curved = 2.0L * p3 + p2 * (p2 + q1 - 2.0L) - l * p2 * p2;
    return (1.0L + e) * l * l * curved + 2.0L * e * (p2 - q1);
}

long double fit_error_bound(long double l, long double e)
{
    long double q = l * exponential_tail(l, 1), p = l * l * exponential_tail(l, 2);
    return (1.0L + e) * l * ((1.0L + e) * q + 2.0L * e) / (2.0L * p) - 1.0L;
}

bool fit_error_bound_root(double epsilon, double low, double high, double *root, int *iterations)
{
    long double e = 0.5L * epsilon, a = low, b = high;
    bool rising = fit_error_bound_slope(b, e) > 0.0L;
    *iterations = 0;
    if ((fit_error_bound_slope(a, e) > 0.0L) == rising)
        return false;
    for (; *iterations < 200 && b - a > 1e-19L * b; ++*iterations) {
        long double middle = 0.5L * (a + b);
        if ((fit_error_bound_slope(middle, e) > 0.0L) == rising)
            b = middle;
        else
            a = middle;
    }
    *root = (double)(0.5L * (a + b));
    return true;
}

double fit_cosine_normalisation(double l)
{
    return (double)(0.5L / ((long double)l * exponential_tail((long double)l, 2)));
}
