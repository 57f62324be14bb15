/* published_formulas.h: the eight published approximations once more, in long double and without a
 * line from shaders/forms: what the registry is checked against. They are written for accuracy
 * (stable exponents, series next to 0), not as printed. */
#ifndef TESTS_PUBLISHED_FORMULAS_H
#define TESTS_PUBLISHED_FORMULAS_H

#include <stddef.h>

typedef struct published_formula {
    const char *id;
    long double (*L)(long double lambda, long double z); /* lambda > 0, z in [-1, 1] */
    long double lambda_min;                              /* from where on the model is meant */
} published_formula;

extern const published_formula published_formulas[];
extern const size_t published_formula_count;

#endif
