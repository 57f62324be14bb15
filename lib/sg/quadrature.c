/* quadrature.c: the table of textbook routes, and those with a fixed Gauss-Legendre rule. */
#include "quadrature.h"

#include <math.h>
#include <string.h>

#include "kernel.h"

static const sg_route routes[] = {
    {"gauss_2d_64", "Gauss-Legendre on eq. 12, 64 x 64 nodes; claims the change from 32 x 32",
     sg_route_gauss_2d_64},
    {"gauss_2d_256", "Gauss-Legendre on eq. 12, 256 x 256 nodes; claims the change from 128 x 128",
     sg_route_gauss_2d_256},
    {"adaptive_2d",
     "adaptive Gauss-Kronrod 10-21 on eq. 12, nested, tolerances 1.49e-8; claims as QUADPACK does",
     sg_route_adaptive_2d},
    {"bessel_1d",
     "Gauss-Legendre on the form with scaled I0, 64 nodes on [0, pi/2]; claims the change from 32",
     sg_route_bessel_1d},
    {"ode_forward",
     "A'' + A = g forward from beta = 0, Dormand-Prince 5(4), tolerance 1e-12; claims the sum of "
     "its local estimates",
     sg_route_ode_forward},
    {"zonal_harmonics",
     "zonal harmonics of lobe and clamped cosine up to degree 64; claims its first neglected term",
     sg_route_zonal_harmonics},
};

size_t sg_route_count(void)
{
    return sizeof routes / sizeof *routes;
}

const sg_route *sg_route_at(size_t index)
{
    return index < sg_route_count() ? &routes[index] : NULL;
}

const sg_route *sg_route_find(const char *id)
{
    for (size_t i = 0; id && i < sg_route_count(); i++)
        if (strcmp(routes[i].id, id) == 0)
            return &routes[i];
    return NULL;
}

int sg_route_begin(double lambda, double beta, sg_quadrature *result)
{
    *result = (sg_quadrature){(double)NAN, (double)NAN, 0};
    return lambda >= 0.0 && !isinf(lambda) && beta >= 0.0 && beta <= SG_PI_HI;
}

enum { max_nodes = 256 };

typedef struct rule {
    int count;
    double node[max_nodes], weight[max_nodes]; /* on [-1, 1] */
} rule;

/* Roots of the Legendre polynomial by Newton's method from the usual cosine. */
static void make_rule(rule *r, int count)
{
    r->count = count;
    for (int k = 0; k < (count + 1) / 2; k++) {
        double x = cos(SG_PI * (k + 0.75) / (count + 0.5)), slope = 1.0;
        for (int iteration = 0; iteration < 10; iteration++) {
            double before = 1.0, value = x;
            for (int l = 2; l <= count; l++) {
                double next = ((2 * l - 1) * x * value - (l - 1) * before) / l;
                before = value;
                value = next;
            }
            slope = count * (x * value - before) / (x * x - 1.0);
            double step = value / slope;
            x -= step;
            if (fabs(step) < 1e-15)
                break;
        }
        r->node[k] = -x;
        r->node[count - 1 - k] = x;
        r->weight[k] = r->weight[count - 1 - k] = 2.0 / ((1.0 - x * x) * slope * slope);
    }
}

/* Eq. 12 as printed, phi over [0, 2 pi], theta over [0, pi/2]. */
static double gauss_2d(double lambda, double beta, const rule *r)
{
    double sine_phi[max_nodes], sum = 0.0, cos_beta = cos(beta), sin_beta = sin(beta);
    for (int j = 0; j < r->count; j++)
        sine_phi[j] = sin(SG_PI * (1.0 + r->node[j]));
    for (int i = 0; i < r->count; i++) {
        double theta = 0.25 * SG_PI * (1.0 + r->node[i]), c = cos(theta), s = sin(theta);
        double row = 0.0;
        for (int j = 0; j < r->count; j++)
            row += r->weight[j] * exp(lambda * (cos_beta * c - sin_beta * sine_phi[j] * s - 1.0));
        sum += r->weight[i] * row * c * s;
    }
    return 0.25 * SG_PI * SG_PI * sum;
}

/* A_h = 2 pi int exp(lambda (cos(beta - theta) - 1)) e^-x I0(x) cos(theta) sin(theta), with
 * e^-x I0(x) put together from the two functions that the reference tabulates. */
static double bessel_1d(double lambda, double beta, const rule *r)
{
    double sum = 0.0;
    for (int i = 0; i < r->count; i++) {
        double theta = 0.25 * SG_PI * (1.0 + r->node[i]), c = cos(theta), s = sin(theta);
        double x = lambda * sin(beta) * s;
        sum +=
            r->weight[i] * exp(lambda * (cos(beta - theta) - 1.0)) * sg_bessel_i0_scaled(x) * c * s;
    }
    return 0.5 * SG_PI * SG_PI * sum;
}

typedef double (*integration)(double lambda, double beta, const rule *r);

static sg_status by_rule(integration integrate, int count, int evaluations, double lambda,
                         double beta, sg_quadrature *result)
{
    if (!sg_route_begin(lambda, beta, result))
        return SG_DOMAIN;
    rule r;
    make_rule(&r, count / 2);
    double coarse = integrate(lambda, beta, &r);
    make_rule(&r, count);
    result->value = integrate(lambda, beta, &r);
    result->claimed_error = fabs(result->value - coarse);
    result->evaluations = evaluations;
    return SG_OK;
}

sg_status sg_route_gauss_2d_64(double lambda, double beta, sg_quadrature *result)
{
    return by_rule(gauss_2d, 64, 64 * 64 + 32 * 32, lambda, beta, result);
}

sg_status sg_route_gauss_2d_256(double lambda, double beta, sg_quadrature *result)
{
    return by_rule(gauss_2d, 256, 256 * 256 + 128 * 128, lambda, beta, result);
}

sg_status sg_route_bessel_1d(double lambda, double beta, sg_quadrature *result)
{
    return by_rule(bessel_1d, 64, 64 + 32, lambda, beta, result);
}
