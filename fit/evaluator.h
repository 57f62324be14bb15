/* evaluator.h: what `sgfit eval` evaluates: the reference, a method of the registry or a textbook
 * quadrature route, one quantity of it in one precision, at blocks of points. */
#ifndef FIT_EVALUATOR_H
#define FIT_EVALUATOR_H

#include <stdbool.h>
#include <stddef.h>

#include "sg.h"

typedef enum evaluator_kind { EVALUATE_REFERENCE, EVALUATE_METHOD, EVALUATE_ROUTE } evaluator_kind;

typedef struct evaluator {
    evaluator_kind kind;
    const sg_method *method;
    const sg_route *route;
    const char *quantity;  /* "A_h", "H", "L", "c" or "s" */
    const char *precision; /* "f64", "f32" or "f16" */
    bool certified;        /* enclosures by rigorous integration beside the reference */
    bool by_beta;          /* angles are beta in radians, else cos_theta */
} evaluator;

/* Columns that come before the value. */
enum { EVALUATOR_EXTRAS = 2 };

/* Chooses by id; false after one line where there is no such id or it does not answer that
 * quantity in that precision. */
bool evaluator_choose(evaluator *evaluator, const char *id, const char *quantity,
                      const char *precision, bool certified);

/* Number and names of the columns before the value: claimed_error of a route, lower and upper of
 * an enclosure. */
size_t evaluator_extras(const evaluator *evaluator, const char *names[EVALUATOR_EXTRAS]);

/* One point: angle is beta or cos_theta, inside the domain. Returns the value. */
double evaluator_value(const evaluator *evaluator, double lambda, double angle,
                       double extras[EVALUATOR_EXTRAS]);

/* Whether lambda and the angle are in the domain: NULL, or what was expected of them. */
const char *evaluator_check_lambda(double *lambda);
const char *evaluator_check_angle(const evaluator *evaluator, double *angle);

#endif
