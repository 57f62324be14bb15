/* smoothness.h: how smooth a method is: jumps of L and of its first derivatives, and whether it
 * rises with cos_theta. */
#ifndef BENCH_SMOOTHNESS_H
#define BENCH_SMOOTHNESS_H

#include <stdbool.h>
#include <stddef.h>

#include "sg.h"

/* An amount and where it was found. */
typedef struct smoothness_place {
    double amount, lambda, cos_theta;
} smoothness_place;

/* Found in double, with sharpnesses from 1e-4 to 1e4 that lie in the method's domain; all amounts
 * are positive, 0 where there is nothing. */
typedef struct smoothness {
    smoothness_place slope_z;      /* largest jump of dL/dz, z = cos_theta in [-1, 1] */
    smoothness_place slope_lambda; /* of dL/dlambda */
    smoothness_place step;         /* of L itself */
    /* Largest fall of L as z rises from -1 to 1; the place is where it has fallen most. */
    smoothness_place fall;
    smoothness_place fall_f32; /* in float: about 1e-7 is rounding */
} smoothness;

void smoothness_of(const sg_method *method, smoothness *found);

/* smoothness.csv: a row for each method of the registry, or for that one alone. Works on all cores.
 * False after one line. */
bool smoothness_write(const char *only, const char *path);

#endif
