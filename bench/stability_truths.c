/* stability_truths.c: what the lobe operations should give, in long double and without
 * cancellation. */
#include <math.h>

#include "stability_cores.h"

static long double inside(double cos_theta)
{
    return fminl(fmaxl((long double)cos_theta, -1), 1);
}

double truth_product_sharpness(double lambda, double cos_theta)
{
    (void)lambda;
    return (double)sqrtl(0.5L * (1 + inside(cos_theta)));
}

/* |l v + l w| - 2 l = -l |v - w|^2/(1 + |v + w|/2) with |v + w| = 2 s */
double truth_product_amplitude(double lambda, double cos_theta)
{
    long double z = inside(cos_theta), s = sqrtl(0.5L * (1 + z));
    return z == 1 ? 1 : (double)expl(-(long double)lambda * (1 - z) / (1 + s));
}

double truth_product_axis(double lambda, double cos_theta)
{
    (void)lambda;
    return (double)sqrtl(0.5L * (1 + inside(cos_theta)));
}

/* (1 - e^-2x)/x */
static long double share(long double x)
{
    return x > 0 ? -expm1l(-2 * x) / x : 2;
}

double truth_product_integral(double lambda, double cos_theta)
{
    long double l = (long double)lambda, s = sqrtl(0.5L * (1 + inside(cos_theta)));
    long double amplitude = (long double)truth_product_amplitude(lambda, cos_theta);
    if (isinf(lambda))
        return inside(cos_theta) < 1 ? 0 : 0.5;
    return (double)(amplitude * share(2 * l * s) / share(l));
}

double truth_one(double lambda, double cos_theta)
{
    (void)lambda;
    (void)cos_theta;
    return 1;
}
