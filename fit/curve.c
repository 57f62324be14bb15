#include "fit/curve.h"

#include <math.h>
#include <string.h>

#include "sg.h"

static const double pi = 3.14159265358979323846;

/* ---- Shapes -------------------------------------------------------------------------------- */

/* (H - lower)/(upper - lower), with lower = e^-lambda upper */
static double hemisphere_target(double lambda, double z)
{
    double upper = -2.0 * pi * expm1(-lambda) / lambda;
    return (sg_H_cos(lambda, z) - exp(-lambda) * upper) / (-expm1(-lambda) * upper);
}

/* (e^t e^tz - 1)/((e^t - 1)(e^tz + 1)), multiplied out so that nothing overflows */
static double normalised_logistic(double t, double z)
{
    double width = -expm1(-t);
    return z >= 0.0 ? -expm1(-t - t * z) / (width * (1.0 + exp(-t * z)))
                    : (exp(t * z) - exp(-t)) / (width * (exp(t * z) + 1.0));
}

static double normalised_erf(double t, double z)
{
    return 0.5 + erf(t * z) / (2.0 * erf(t));
}

static double planar_gaussian(double t, double z)
{
    return 0.5 * (z * erfc(-t * z) + erfc(t)) -
           exp(-t * t * z * z) * expm1(t * t * (z * z - 1.0)) / (2.0 * t * sqrt(pi));
}

static double logistic(double t, double z)
{
    return 1.0 / (exp(t * fabs(z)) + 1.0);
}

static double meder_u(double t, const double *tied)
{
    return 1.0 / (tied[0] * t + tied[1]);
}

static const fit_shape hemisphere_logistic = {
    "hemisphere_logistic",
    "normalised logistic function for the hemispherical integral",
    hemisphere_target,
    normalised_logistic,
    NULL,
    false};
static const fit_shape hemisphere_erf = {"hemisphere_erf",
                                         "normalised error function for the hemispherical integral",
                                         hemisphere_target,
                                         normalised_erf,
                                         NULL,
                                         false};
static const fit_shape cosine_erf = {
    "cosine_erf", "planar Gaussian times a clamped plane for Meder's c",
    sg_c_cos,     planar_gaussian,
    NULL,         false};
static const fit_shape meder_tied = {
    "meder_tied", "u/(e^(t |z|) + 1) for Meder's s, u = 1/(u_slope t + u_offset)",
    sg_s_cos,     logistic,
    meder_u,      false};
static const fit_shape meder_free = {
    "meder_free", "u/(e^(t |z|) + 1) for Meder's s, u free", sg_s_cos, logistic, NULL, true};

/* ---- Curves -------------------------------------------------------------------------------- */

static double meder_t(double l, const double *k)
{
    return k[0] * sqrt(l) * l / (l + k[1]);
}

static double line(double t, const double *k)
{
    return k[0] * t + k[1];
}

static double meder_hg_t(double l, const double *k)
{
    return sqrt(l) * (k[0] * l * l + k[1] * l) / (l * l + k[2] * l + k[3]);
}

static double tokuyoshi_2022_t(double l, const double *k)
{
    return l * sqrt((0.5 * l + k[0]) / (l * l + k[1] * l + k[2]));
}

static double tokuyoshi_2024_t(double l, const double *k)
{
    return l * sqrt(0.5 * (l * l + k[0] * l + k[1]) / (l * l * l + k[2] * l * l + k[3] * l + k[4]));
}

static const fit_curve curves[] = {
    {"meder_t",
     "meder_logistic",
     &meder_tied,
     2,
     {"t_scale", "t_shift"},
     2,
     {"u_slope", "u_offset"},
     meder_t,
     false},
    {"meder_u", "meder_logistic", &meder_free, 2, {"u_slope", "u_offset"}, 0, {0}, line, true},
    {"hemisphere_logistic_t",
     "hemisphere_logistic",
     &hemisphere_logistic,
     4,
     {"t_cubic", "t_square", "t_linear", "t_constant"},
     0,
     {0},
     meder_hg_t,
     false},
    {"hemisphere_erf_t",
     "hemisphere_erf",
     &hemisphere_erf,
     3,
     {"t_0", "t_1", "t_2"},
     0,
     {0},
     tokuyoshi_2022_t,
     false},
    {"cosine_erf_t",
     "cosine_erf",
     &cosine_erf,
     5,
     {"t_a", "t_b", "t_c", "t_d", "t_e"},
     0,
     {0},
     tokuyoshi_2024_t,
     false},
};

const fit_curve *fit_curve_at(size_t index)
{
    return index < sizeof curves / sizeof *curves ? &curves[index] : NULL;
}

const fit_curve *fit_curve_find(const char *id)
{
    for (size_t i = 0; fit_curve_at(i); i++)
        if (strcmp(curves[i].id, id) == 0)
            return &curves[i];
    return NULL;
}

/* ---- The first stage ----------------------------------------------------------------------- */

typedef struct sigmoid_fit {
    const fit_shape *shape;
    const double *tied, *cos_theta, *target;
    size_t count;
} sigmoid_fit;

static double misfit(const sigmoid_fit *f, double log_t, double *u)
{
    double t = exp(log_t), squares = 0.0;
    *u = f->shape->scale ? f->shape->scale(t, f->tied) : 1.0;
    if (f->shape->free_scale) {
        double product = 0.0, square = 0.0;
        for (size_t i = 0; i < f->count; i++) {
            double value = f->shape->value(t, f->cos_theta[i]);
            product += value * f->target[i];
            square += value * value;
        }
        *u = product / square;
    }
    for (size_t i = 0; i < f->count; i++) {
        double residual = *u * f->shape->value(t, f->cos_theta[i]) - f->target[i];
        squares += residual * residual;
    }
    return squares;
}

double fit_steepness(const fit_shape *shape, const double *tied, double lambda, size_t count,
                     const double *cos_theta, double *work, double *u)
{
    enum { SCAN = 56 };
    const double low = log(1e-8), high = log(1e4), step = (high - low) / SCAN;
    const double golden = 0.6180339887498949;
    sigmoid_fit f = {shape, tied, cos_theta, work, count};
    double ignored;
    for (size_t i = 0; i < count; i++)
        work[i] = shape->target(lambda, cos_theta[i]);
    size_t best = 0;
    double least = INFINITY;
    for (size_t i = 0; i <= SCAN; i++) {
        double value = misfit(&f, low + step * (double)i, &ignored);
        if (value < least) {
            least = value;
            best = i;
        }
    }
    double a = low + step * ((double)best - 1.0), b = low + step * ((double)best + 1.0);
    double c = b - golden * (b - a), d = a + golden * (b - a);
    double at_c = misfit(&f, c, &ignored), at_d = misfit(&f, d, &ignored);
    while (b - a > 1e-9) {
        if (at_c < at_d) {
            b = d;
            d = c;
            at_d = at_c;
            at_c = misfit(&f, c = b - golden * (b - a), &ignored);
        } else {
            a = c;
            c = d;
            at_c = at_d;
            at_d = misfit(&f, d = a + golden * (b - a), &ignored);
        }
    }
    misfit(&f, 0.5 * (a + b), u);
    return exp(0.5 * (a + b));
}
