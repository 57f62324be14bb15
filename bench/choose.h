/* choose.h: the cheapest method that is good enough on a domain. Private to bench. */
#ifndef BENCH_CHOOSE_H
#define BENCH_CHOOSE_H

#include <stdbool.h>
#include <stddef.h>

#include "sg.h"

/* ---- choose_domain.c: where methods are measured ----------------------------------------------
 */

/* Points as a shader gets them: floats, with the reference there and a weight. */
typedef struct choose_domain {
    size_t count;
    float *lambda, *cos_theta;
    double *truth; /* L, at the floats */
    double *weight;
    double lambda_min, lambda_max;
} choose_domain;

/* 400 sharpnesses, logarithmic from low (0: from 1e-3, and 0 itself) to high, times 1001 angles
 * uniform on [0, pi]; all weights are 1. With 1e-3 and 1e4 it is the grid of fit/score.h. */
bool choose_range(choose_domain *domain, double low, double high);
/* "MIN:MAX"; false after one line. */
bool choose_parse_range(const char *text, double *low, double *high);
/* CSV with columns lambda, cos_theta and weight (others are ignored). Rows of weight 0 are left
 * out. False after one line that names file and line. */
bool choose_profile(choose_domain *domain, const char *path);
void choose_domain_free(choose_domain *domain);

typedef struct choose_error {
    double max_abs, lambda, cos_theta; /* and where */
    double rmse;                       /* weighted */
} choose_error;

/* Errors of L in float; not finite counts as infinite. False where there is no memory. */
bool choose_measure(const choose_domain *domain, const sg_method *method, choose_error *error);

/* ---- choose_cost.c: what methods cost ---------------------------------------------------------
 */

typedef enum choose_unit { CHOOSE_GPU, CHOOSE_GPU_PIXEL, CHOOSE_CPU, CHOOSE_DEVICE } choose_unit;

const char *choose_unit_name(choose_unit unit); /* "instructions", ... */

/* costs[i] of method i of the registry for one evaluation of L: instructions (tables/cost.csv, and
 * counted on the spot for methods that are not in it), instructions once a pixel where lambda is
 * prepared once a light, nanoseconds in the batch call, or device time over an empty shader's. NaN
 * where that cannot be told here. False after one line. */
bool choose_costs(choose_unit unit, const char *device, double *costs);

/* ---- choose.c ---------------------------------------------------------------------------------
 */

/* `sgfit choose`. */
int choose_command(int argc, char **argv);

#endif
