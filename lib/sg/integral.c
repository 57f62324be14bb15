/* integral.c: the reference. The mathematics is told in kernel.h. */
#include "kernel.h"
#include "sg.h"

/* Values at the nodes first, then their sum: the first loop vectorises, and the order of the
 * second is the same wherever the library runs. */
static double even_integral(const sg_sharpness *s, const sg_direction *d)
{
    double end = sg_cut(s->lambda, d), value[SG_GAUSS_NODES], sum = 0.0;
    for (int k = 0; k < SG_GAUSS_NODES; k++)
        value[k] = sg_gauss_weight[k] *
                   sg_even_node(s->lambda, d->sine, d->cosine, end * sg_gauss_node[k]);
    for (int k = 0; k < SG_GAUSS_NODES; k++)
        sum += value[k];
    return 4.0 * (s->kappa * end) * sum;
}

static double odd_integral(const sg_sharpness *s, const sg_direction *d)
{
    double end = sg_cut(s->lambda, d), value[SG_GAUSS_NODES], sum = 0.0;
    for (int k = 0; k < SG_GAUSS_NODES; k++)
        value[k] =
            sg_gauss_weight[k] * sg_odd_node(s->lambda, d->sine, d->cosine, end * sg_gauss_node[k]);
    for (int k = 0; k < SG_GAUSS_NODES; k++)
        sum += value[k];
    return 2.0 * (s->kappa * end) * sum;
}

/* kappa D/2 pi */
static double excess(const sg_sharpness *s, const sg_direction *d)
{
    return s->rise * d->one_minus_sine + sg_horizon_factor(s->lambda, d) * even_integral(s, d);
}

/* kappa A_h/2 pi */
static double scaled_A_h(const sg_sharpness *s, const sg_direction *d)
{
    double below = s->pole + excess(s, d);
    return d->z > 0.0 ? s->odd * d->z + below : below;
}

static int is_sharpness(double lambda)
{
    return lambda >= 0.0;
}

static int is_angle(double beta)
{
    return beta >= 0.0 && beta <= SG_PI_HI;
}

static double positive_part(double z)
{
    return z > 0.0 ? z : 0.0;
}

static double value_A_h(double lambda, const sg_direction *d)
{
    if (isinf(lambda))
        return 0.0;
    sg_sharpness s = sg_sharpness_of(lambda);
    return SG_TWO_PI * (scaled_A_h(&s, d) / s.kappa);
}

static double value_H(double lambda, const sg_direction *d)
{
    if (isinf(lambda))
        return 0.0;
    sg_sharpness s = sg_sharpness_of(lambda);
    double below = s.dark + sg_horizon_factor(lambda, d) * odd_integral(&s, d);
    return SG_TWO_PI * ((d->z > 0.0 ? s.all - below : below) / s.kappa);
}

static double value_L(double lambda, const sg_direction *d)
{
    if (isinf(lambda))
        return positive_part(d->z);
    sg_sharpness s = sg_sharpness_of(lambda);
    return scaled_A_h(&s, d) / s.all;
}

/* D/(A_u - A_b), and that over its value (1 - |z|)/2 for the normalised cosine. Below 1e-17 both
 * are at their limits for lambda = 0. */
static double value_c(double lambda, const sg_direction *d)
{
    if (isinf(lambda))
        return positive_part(d->z);
    if (lambda < 1e-17)
        return positive_part(d->z) + 0.5 * d->one_minus_sine;
    sg_sharpness s = sg_sharpness_of(lambda);
    return positive_part(d->z) + excess(&s, d) / s.odd;
}

static double value_s(double lambda, const sg_direction *d)
{
    if (isinf(lambda))
        return 0.0;
    if (lambda < 1e-17)
        return 1.0;
    sg_sharpness sharpness = sg_sharpness_of(lambda);
    /* next to a pole the integral falls like delta^4 and 1 - |z| like delta^2 */
    double around = 0.0;
    if (d->cosine > 1e-20)
        around = sg_horizon_factor(lambda, d) * even_integral(&sharpness, d) / d->one_minus_sine;
    return 2.0 * (sharpness.rise + around) / sharpness.odd;
}

double sg_A(double lambda)
{
    if (!is_sharpness(lambda))
        return (double)NAN;
    if (isinf(lambda))
        return 0.0;
    sg_sharpness of = sg_sharpness_of(lambda);
    return SG_TWO_PI * (of.all / of.kappa);
}

double sg_A_u(double lambda)
{
    if (!is_sharpness(lambda))
        return (double)NAN;
    if (isinf(lambda))
        return 0.0;
    sg_sharpness of = sg_sharpness_of(lambda);
    return SG_TWO_PI * ((of.pole + of.odd) / of.kappa);
}

double sg_A_b(double lambda)
{
    if (!is_sharpness(lambda))
        return (double)NAN;
    if (isinf(lambda))
        return 0.0;
    sg_sharpness of = sg_sharpness_of(lambda);
    return SG_TWO_PI * (of.pole / of.kappa);
}

/* The two entry points of each quantity: by angle and by cosine. NaN fails every comparison. */
#define ENTRY(name)                                                                                \
    double sg_##name(double lambda, double beta)                                                   \
    {                                                                                              \
        if (!is_sharpness(lambda) || !is_angle(beta))                                              \
            return (double)NAN;                                                                    \
        sg_direction d = sg_direction_of_angle(beta);                                              \
        return value_##name(lambda, &d);                                                           \
    }                                                                                              \
    double sg_##name##_cos(double lambda, double cos_theta)                                        \
    {                                                                                              \
        if (!is_sharpness(lambda) || isnan(cos_theta))                                             \
            return (double)NAN;                                                                    \
        sg_direction d = sg_direction_of_cosine(cos_theta);                                        \
        return value_##name(lambda, &d);                                                           \
    }

ENTRY(A_h)
ENTRY(H)
ENTRY(L)
ENTRY(c)
ENTRY(s)
