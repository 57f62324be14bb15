/* curve.h: what the published steepness curves were fitted to.
 *
 * The papers fit in two stages: for each sharpness the steepness t of a sigmoid that follows the
 * exact integral best, then a curve through these t. A curve here is the second stage's formula,
 * with the coefficient names of the form that contains it (tests hold the two against each other);
 * its shape is the sigmoid of the first stage. */
#ifndef FIT_CURVE_H
#define FIT_CURVE_H

#include <stdbool.h>
#include <stddef.h>

typedef struct fit_shape {
    const char *id;
    const char *what; /* one line: the sigmoid and what it stands for */
    /* The exact value that the sigmoid follows. */
    double (*target)(double lambda, double cos_theta);
    double (*value)(double t, double cos_theta);
    /* u of the shape u(t) value(t, z): NULL where there is none, else by tied coefficients */
    double (*scale)(double t, const double *tied);
    bool free_scale; /* the best u for each t instead */
} fit_shape;

typedef struct fit_curve {
    const char *id;
    const char *form; /* whose coefficients these are */
    const fit_shape *shape;
    size_t count;
    const char *names[6];
    size_t tied_count; /* coefficients that the shape needs, held fixed */
    const char *tied_names[2];
    double (*value)(double x, const double *k); /* t at x = lambda, or 1/u at x = t */
    bool inverse_scale;                         /* the curve is 1/u over t */
} fit_curve;

const fit_curve *fit_curve_find(const char *id); /* NULL where there is none */
const fit_curve *fit_curve_at(size_t index);     /* NULL after the last */

/* The best t at one sharpness: least squares over the given angles, unweighted, between 1e-8 and
 * 1e4, to about 1e-8 relative (a sum of squares does not tell more). *u: the scale that goes with
 * it, 1 where the shape has none. work holds count doubles. */
double fit_steepness(const fit_shape *shape, const double *tied, double lambda, size_t count,
                     const double *cos_theta, double *work, double *u);

#endif
