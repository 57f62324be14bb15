/* solve.h: solvers of a fit_problem. Each is single-threaded and deterministic. */
#ifndef FIT_SOLVE_H
#define FIT_SOLVE_H

#include <stdbool.h>
#include <stdint.h>

#include "problem.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef struct fit_options {
    double tolerance; /* relative change of the parameters at which a solver may stop */
    int most_iterations;
    uint64_t seed; /* of the solvers that draw numbers */
} fit_options;

typedef struct fit_result {
    bool usable; /* finite, and the solver claims no outright failure */
    double parameters[FIT_MOST_PARAMETERS];
    double objective; /* by the residuals at the parameters: sum of squares, or largest */
    int iterations;
    char solver[64]; /* "Ceres 2.1.0 trust region, dense QR" */
    char status[64]; /* the solver's own word: "CONVERGENCE", "ROUNDOFF_LIMITED" */
} fit_result;

/* Least squares, from problem->start. */
void fit_solve_ceres(const fit_problem *problem, const fit_options *options, fit_result *result);
void fit_solve_nlopt(const fit_problem *problem, const fit_options *options, fit_result *result);

/* Minimax (solve_minimax.c): a least-squares solution first, then powers 4 to 256 of the residuals
 * by the same solver (fit_problem.power), then rounds of exchange: NLopt's SLSQP minimises the
 * largest residual over a small set of samples, and the samples where the result is still worse
 * than that join the set. Ends when none is, by more than 1e-6 of it. */
void fit_solve_minimax(const fit_problem *problem, const fit_options *options, fit_result *result);

/* One round of it: the largest magnitude over the problem's own samples, few, from start. No
 * combination of parameters may move further than would change the residuals by trust times the
 * largest of them (root mean square over the samples, to first order). */
void fit_solve_nlopt_minimax(const fit_problem *problem, const fit_options *options, double trust,
                             fit_result *result);

const char *fit_ceres_version(void);
const char *fit_nlopt_version(void);

#ifdef __cplusplus
}
#endif

#endif
