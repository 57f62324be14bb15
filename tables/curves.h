/* curves.h: tables of Meder's curves. */
#ifndef TABLES_CURVES_H
#define TABLES_CURVES_H

#include <stdbool.h>

#include "base/buffer.h"

/* CSV lambda,beta,c,s and CSV lambda,t,u. */
void curves_c_s(buffer *out);
bool curves_t_u(buffer *out); /* false after one line: no convergence */

/* t and u for which u/(e^(t |cos_theta|) + 1) follows s best at one sharpness above 0: unweighted
 * least squares over CURVES_POINTS values of |cos_theta|, uniform from 0 to
 * min(1, 6/sqrt(lambda + 2)). Starts from *t and *u. False where it does not converge. */
enum { CURVES_POINTS = 401 };
bool curves_logistic(double lambda, double *t, double *u);

#endif
