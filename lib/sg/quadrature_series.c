/* quadrature_series.c: the differential equation forward from beta = 0, and zonal harmonics. */
#include "quadrature.h"

#include <math.h>

#include "kernel.h"

/* g = 2 pi e^-lambda (I0(x) - I1(x)/x), x = lambda sin(beta) */
static double source(double lambda, double beta)
{
    double x = fmax(lambda * sin(beta), 0.0); /* the last stage may round to beyond pi */
    return SG_TWO_PI * exp(x - lambda) * sg_bessel_even_scaled(x);
}

typedef struct state {
    double value, slope;
} state;

static state derivative(double lambda, double beta, state y)
{
    return (state){y.slope, source(lambda, beta) - y.value};
}

enum { stages = 7, step_limit = 100000 };

/* One step of Dormand and Prince (1980): the result of order 5, and its difference from the one
 * of order 4. */
static state step(double lambda, double beta, double h, state y, state *difference)
{
    static const double at[stages] = {0.0, 1.0 / 5.0, 3.0 / 10.0, 4.0 / 5.0, 8.0 / 9.0, 1.0, 1.0};
    static const double a[stages][stages - 1] = {
        {0.0},
        {1.0 / 5.0},
        {3.0 / 40.0, 9.0 / 40.0},
        {44.0 / 45.0, -56.0 / 15.0, 32.0 / 9.0},
        {19372.0 / 6561.0, -25360.0 / 2187.0, 64448.0 / 6561.0, -212.0 / 729.0},
        {9017.0 / 3168.0, -355.0 / 33.0, 46732.0 / 5247.0, 49.0 / 176.0, -5103.0 / 18656.0},
        {35.0 / 384.0, 0.0, 500.0 / 1113.0, 125.0 / 192.0, -2187.0 / 6784.0, 11.0 / 84.0}};
    static const double error[stages] = {
        71.0 / 57600.0,      0.0,          -71.0 / 16695.0, 71.0 / 1920.0,
        -17253.0 / 339200.0, 22.0 / 525.0, -1.0 / 40.0};
    state k[stages], end = y;
    *difference = (state){0.0, 0.0};
    for (int i = 0; i < stages; i++) {
        end = y;
        for (int j = 0; j < i; j++) {
            end.value += h * a[i][j] * k[j].value;
            end.slope += h * a[i][j] * k[j].slope;
        }
        k[i] = derivative(lambda, beta + at[i] * h, end);
        difference->value += h * error[i] * k[i].value;
        difference->slope += h * error[i] * k[i].slope;
    }
    return end; /* the last stage is the result */
}

sg_status sg_route_ode_forward(double lambda, double beta, sg_quadrature *result)
{
    if (!sg_route_begin(lambda, beta, result))
        return SG_DOMAIN;
    const double tolerance = 1e-12;
    state y = {sg_A_u(lambda), 0.0};
    double at = 0.0, h = 0.01, claimed = 0.0;
    int steps = 0;
    for (; at < beta && steps < step_limit; steps++) {
        h = fmin(h, beta - at);
        state difference, next = step(lambda, at, h, y, &difference);
        double size = tolerance * (1.0 + fmax(fabs(y.value), fabs(y.slope)));
        double ratio = fmax(fabs(difference.value), fabs(difference.slope)) / size;
        if (ratio <= 1.0) {
            at += h;
            y = next;
            claimed += fabs(difference.value) + fabs(difference.slope);
        }
        h *= fmin(5.0, fmax(0.2, 0.9 * pow(fmax(ratio, 1e-10), -0.2)));
        if (at + h <= at)
            break;
    }
    result->value = y.value;
    result->claimed_error = claimed;
    result->evaluations = (long)stages * steps;
    return at < beta ? SG_NO_CONVERGENCE : SG_OK;
}

enum { top_degree = 64, spare_degrees = 2000 };

/* i_{l+1}/i_l of the modified spherical Bessel functions for l = 0 .. top_degree + 1, by the
 * backward recurrence, begun where Amos's bounds (1974) leave nothing to be seen below. */
static void bessel_ratios(double lambda, double ratio[top_degree + 2])
{
    double order = top_degree + spare_degrees;
    double r = lambda / (order + 1.0 + hypot(lambda, order + 2.0));
    for (int l = top_degree + spare_degrees; l >= 1; l--) {
        if (l <= top_degree + 1)
            ratio[l] = r;
        r = lambda / ((2.0 * l + 1.0) + lambda * r);
    }
    ratio[0] = r;
}

/* A_h = sum over l of (2l + 1)/(4 pi) g_l f_l P_l(z), g_l = 4 pi e^-lambda i_l(lambda) and f_l
 * those of the clamped cosine: pi, 2 pi/3, and for even l (Ramamoorthi and Hanrahan 2001)
 * 2 pi (-1)^(l/2 - 1) l!/((l + 2)(l - 1) 2^l ((l/2)!)^2). */
sg_status sg_route_zonal_harmonics(double lambda, double beta, sg_quadrature *result)
{
    if (!sg_route_begin(lambda, beta, result))
        return SG_DOMAIN;
    double ratio[top_degree + 2], z = cos(beta);
    bessel_ratios(lambda, ratio);
    double lobe = sg_A(lambda), before = 1.0, legendre = z;
    double sum = 0.25 * lobe;
    lobe *= ratio[0];
    sum += 0.5 * lobe * z;
    double binomial = 1.0; /* l!/(2^l ((l/2)!)^2) */
    for (int l = 2; l <= top_degree + 2; l++) {
        double next = ((2 * l - 1) * z * legendre - (l - 1) * before) / l;
        before = legendre, legendre = next;
        lobe *= ratio[l - 1];
        if (l % 2)
            continue;
        binomial *= (double)(l - 1) / l;
        double cosine = (l % 4 == 2 ? 0.5 : -0.5) * binomial / ((l + 2.0) * (l - 1.0));
        double term = (2 * l + 1) * lobe * cosine;
        if (l <= top_degree)
            sum += term * legendre;
        else
            result->claimed_error = fabs(term); /* |P_l| <= 1 */
    }
    result->value = sum;
    result->evaluations = top_degree / 2 + 2;
    return SG_OK;
}
