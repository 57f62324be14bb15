/* tiers_points.h: where the tiers are held to their bars, and what is true there. */
#ifndef TESTS_TIERS_POINTS_H
#define TESTS_TIERS_POINTS_H

#include <math.h>
#include <stdlib.h>

#include "sg.h"

enum { POINTS = 200000, FAR_POINTS = 100000 };
static const double pi = 3.14159265358979323846;

typedef struct points {
    size_t count;
    float *pairs; /* lambda, cos_theta by turns */
    double *truth;
} points;

static inline points new_points(size_t count)
{
    points p = {count, malloc(count * 2 * sizeof(float)), malloc(count * sizeof(double))};
    assert_true(p.pairs && p.truth);
    return p;
}

static inline void free_points(points *p)
{
    free(p->pairs);
    free(p->truth);
}

static inline void set(points *p, size_t i, double lambda, double cos_theta)
{
    p->pairs[2 * i] = (float)lambda;
    p->pairs[2 * i + 1] = (float)cos_theta;
    p->truth[i] = sg_L_cos((double)p->pairs[2 * i], (double)p->pairs[2 * i + 1]);
}

static inline points even_points(void)
{
    points p = new_points(POINTS);
    double x = 0.31, y = 0.77;
    for (size_t i = 0; i < p.count; i++) {
        x = fmod(x + 0.7548776662466927, 1);
        y = fmod(y + 0.5698402909980532, 1);
        set(&p, i, pow(10, -3 + 7 * x), cos(pi * y));
    }
    return p;
}

/* Behind the terminator, down to where float ends: e^-87 of the front, with sharpnesses to 1e20. */
static inline points far_points(void)
{
    points p = new_points(FAR_POINTS);
    double x = 0.13, y = 0.59;
    for (size_t i = 0; i < p.count; i++) {
        x = fmod(x + 0.7548776662466927, 1);
        y = fmod(y + 0.5698402909980532, 1);
        double lambda = pow(10, i % 2 ? 7 * x - 3 : 23 * x - 3);
        double depth = y * fmin(1, 88 / lambda);
        set(&p, i, lambda, -sqrt(depth * (2 - depth)));
    }
    return p;
}

#endif
