/* reference_vectors.h: three doubles at a time. */
#ifndef TESTS_REFERENCE_VECTORS_H
#define TESTS_REFERENCE_VECTORS_H

#include <math.h>
#include <string.h>

static inline double dot(const double a[3], const double b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static inline void cross(const double a[3], const double b[3], double result[3])
{
    double c[3] = {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
    memcpy(result, c, sizeof c);
}

static inline void subtract(const double a[3], const double b[3], double result[3])
{
    for (int i = 0; i < 3; i++)
        result[i] = a[i] - b[i];
}

static inline double normalise(double v[3])
{
    double length = sqrt(dot(v, v));
    for (int i = 0; i < 3; i++)
        v[i] /= length;
    return length;
}

#endif
