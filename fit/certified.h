/* certified.h: rigorous enclosures of the integrals, by ball arithmetic (FLINT/Arb), computed from
 * the definition and not by the route of lib/sg, so that they can be held against it.
 *
 * Compiled only where HAVE_ARB is defined. The doubles given are taken as exact numbers; pi in the
 * integrals is pi. Each function sets lower and upper so that the true value lies in
 * [lower, upper], both rounded outwards, and returns true; or returns false where the argument is
 * outside the domain (lambda finite and >= 0, beta in [0, pi] or cos_theta in [-1, 1]) or where
 * no enclosure tighter than 1e-15 relative was reached (then the bounds are still valid if the
 * argument is inside the domain). */
#ifndef SGFIT_CERTIFIED_H
#define SGFIT_CERTIFIED_H

#include <stdbool.h>

#ifdef __cplusplus
extern "C" {
#endif

bool sgfit_certified_A_h(double lambda, double beta, double *lower, double *upper);
bool sgfit_certified_A_h_cos(double lambda, double cos_theta, double *lower, double *upper);
bool sgfit_certified_H(double lambda, double beta, double *lower, double *upper);
bool sgfit_certified_H_cos(double lambda, double cos_theta, double *lower, double *upper);

/* L = A_h/A and Meder's c and s, from the enclosure of A_h. Of c the domain is lambda > 0, of s
 * also |cos_theta| < 1: elsewhere their definitions read 0/0. Where min(lambda, 1) (1 -
 * |cos_theta|) is below 1e-60 no enclosure is tried: they return false with what holds everywhere,
 * c in [0, 1] and s in [0, 2]. */
bool sgfit_certified_L(double lambda, double beta, double *lower, double *upper);
bool sgfit_certified_L_cos(double lambda, double cos_theta, double *lower, double *upper);
bool sgfit_certified_c(double lambda, double beta, double *lower, double *upper);
bool sgfit_certified_c_cos(double lambda, double cos_theta, double *lower, double *upper);
bool sgfit_certified_s(double lambda, double beta, double *lower, double *upper);
bool sgfit_certified_s_cos(double lambda, double cos_theta, double *lower, double *upper);

#ifdef __cplusplus
}
#endif

#endif
