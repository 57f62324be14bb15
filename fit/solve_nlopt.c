/* solve_nlopt.c: the only file that knows NLopt. SLSQP does both objectives. */
#include "solve.h"

#include <math.h>
#include <nlopt.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "whiten.h"

typedef struct run {
    const fit_problem *problem;
    fit_whitening white;
    double unit;       /* the objective is measured in this */
    double *residuals; /* n */
    double *jacobian;  /* n m */
    double *work;      /* 2 n */
    int evaluations;
} run;

const char *fit_nlopt_version(void)
{
    static _Thread_local char text[32];
    int major, minor, fix;
    nlopt_version(&major, &minor, &fix);
    snprintf(text, sizeof text, "%d.%d.%d", major, minor, fix);
    return text;
}

static bool run_begin(run *r, const fit_problem *problem)
{
    size_t n = problem->sample_count, m = problem->parameter_count;
    memset(r, 0, sizeof *r);
    r->problem = problem;
    r->residuals = malloc(sizeof(double) * n * (m + 3));
    if (!r->residuals)
        return false;
    r->jacobian = r->residuals + n;
    r->work = r->jacobian + n * m;
    return true;
}

static bool is_bounded(const fit_problem *problem)
{
    for (size_t j = 0; j < problem->parameter_count; j++)
        if (isfinite(problem->lower[j]) || isfinite(problem->upper[j]))
            return true;
    return false;
}

/* Bounds of y: those of the parameters, for a diagonal change of variables, and the trust box. */
static void set_bounds(nlopt_opt solver, const run *r, size_t variables, double trust)
{
    double lower[FIT_MOST_PARAMETERS + 1], upper[FIT_MOST_PARAMETERS + 1];
    for (size_t j = 0; j < variables; j++) {
        lower[j] = j < r->problem->parameter_count ? -trust : -HUGE_VAL;
        upper[j] = -lower[j];
    }
    for (size_t j = 0; j < r->problem->parameter_count && r->white.diagonal; j++) {
        double unit = r->white.transform[j][j];
        lower[j] = fmax(lower[j], (r->problem->lower[j] - r->white.centre[j]) / unit);
        upper[j] = fmin(upper[j], (r->problem->upper[j] - r->white.centre[j]) / unit);
    }
    nlopt_set_lower_bounds(solver, lower);
    nlopt_set_upper_bounds(solver, upper);
}

static void keep_status(fit_result *result, nlopt_result status)
{
    const char *text = nlopt_result_to_string(status);
    snprintf(result->status, sizeof result->status, "%s", text ? text : "UNKNOWN");
}

/* ---- Least squares ------------------------------------------------------------------------- */

static double mean_square(unsigned count, const double *y, double *gradient, void *context)
{
    run *r = context;
    const fit_problem *p = r->problem;
    double parameters[FIT_MOST_PARAMETERS], slope[FIT_MOST_PARAMETERS];
    (void)count;
    r->evaluations++;
    fit_unwhiten(&r->white, y, parameters);
    if (!fit_residuals(p, parameters, r->residuals))
        return HUGE_VAL;
    if (gradient) {
        if (!fit_jacobian(p, parameters, r->jacobian, r->work))
            return HUGE_VAL;
        for (size_t j = 0; j < p->parameter_count; j++) {
            double sum = 0.0;
            for (size_t i = 0; i < p->sample_count; i++)
                sum += r->jacobian[j * p->sample_count + i] * r->residuals[i];
            slope[j] = 2.0 * sum / r->unit;
        }
        fit_whiten_gradient(&r->white, slope, gradient);
    }
    return fit_sum_of_squares(p, r->residuals) / r->unit;
}

/* One run from centre, which is replaced by the better of the two ends. */
static bool improve_squares(run *r, const fit_options *options, double *centre, fit_result *result)
{
    const fit_problem *p = r->problem;
    unsigned m = (unsigned)p->parameter_count;
    double y[FIT_MOST_PARAMETERS] = {0}, value, moved[FIT_MOST_PARAMETERS];
    if (!fit_residuals(p, centre, r->residuals) || !fit_jacobian(p, centre, r->jacobian, r->work))
        return false;
    double before = fit_sum_of_squares(p, r->residuals);
    result->objective = before;
    r->unit = before > 0.0 ? before : 1.0;
    fit_whiten(&r->white, p->sample_count, m, centre, r->jacobian, sqrt(r->unit), is_bounded(p));
    nlopt_opt solver = nlopt_create(NLOPT_LD_SLSQP, m);
    if (!solver)
        return false;
    nlopt_set_min_objective(solver, mean_square, r);
    set_bounds(solver, r, m, HUGE_VAL);
    nlopt_set_xtol_abs1(solver, 1e-2 * options->tolerance);
    nlopt_set_maxeval(solver, options->most_iterations);
    keep_status(result, nlopt_optimize(solver, y, &value));
    nlopt_destroy(solver);
    /* Whatever the status says, the residuals decide. */
    fit_unwhiten(&r->white, y, moved);
    if (!fit_residuals(p, moved, r->residuals))
        return false;
    double after = fit_sum_of_squares(p, r->residuals);
    if (!(after <= before * (1.0 + 1e-14)))
        return false;
    bool more = fit_disagreement(m, centre, moved) > options->tolerance;
    memcpy(centre, moved, sizeof(double) * m);
    result->objective = after;
    return more;
}

void fit_solve_nlopt(const fit_problem *problem, const fit_options *options, fit_result *result)
{
    run r;
    memset(result, 0, sizeof *result);
    snprintf(result->solver, sizeof result->solver, "NLopt %s SLSQP, restarted",
             fit_nlopt_version());
    snprintf(result->status, sizeof result->status, "FAILURE");
    memcpy(result->parameters, problem->start, sizeof(double) * problem->parameter_count);
    result->objective = HUGE_VAL;
    if (!run_begin(&r, problem))
        return;
    nlopt_srand((unsigned long)options->seed);
    for (int restart = 0; restart < 40; restart++)
        if (!improve_squares(&r, options, result->parameters, result))
            break;
    result->iterations = r.evaluations;
    result->usable = isfinite(result->objective);
    free(r.residuals);
}

/* ---- Minimax over few samples -------------------------------------------------------------- */

/* Variables: y, then the bound h in the unit. */
static double bound_itself(unsigned count, const double *y, double *gradient, void *context)
{
    (void)context;
    if (gradient) {
        memset(gradient, 0, sizeof(double) * count);
        gradient[count - 1] = 1.0;
    }
    return y[count - 1];
}

/* residual - h and -residual - h, for every sample, all at most 0 */
static void within_bound(unsigned rows, double *values, unsigned count, const double *y,
                         double *gradient, void *context)
{
    run *r = context;
    const fit_problem *p = r->problem;
    size_t n = p->sample_count, m = p->parameter_count;
    double parameters[FIT_MOST_PARAMETERS], slope[FIT_MOST_PARAMETERS], by_y[FIT_MOST_PARAMETERS];
    r->evaluations++;
    fit_unwhiten(&r->white, y, parameters);
    bool finite = fit_residuals(p, parameters, r->residuals) &&
                  (!gradient || fit_jacobian(p, parameters, r->jacobian, r->work));
    for (size_t i = 0; i < n; i++) {
        double value = finite ? r->residuals[i] / r->unit : 1e3;
        values[i] = value - y[m];
        values[n + i] = -value - y[m];
        if (!gradient)
            continue;
        for (size_t j = 0; j < m; j++)
            slope[j] = finite ? r->jacobian[j * n + i] / r->unit : 0.0;
        fit_whiten_gradient(&r->white, slope, by_y);
        double *above = gradient + i * count, *below = gradient + (n + i) * count;
        for (size_t j = 0; j < m; j++) {
            above[j] = by_y[j];
            below[j] = -by_y[j];
        }
        above[m] = below[m] = -1.0;
    }
    (void)rows;
}

static nlopt_result lower_bound(run *r, const fit_options *options, double trust, double *y)
{
    unsigned m = (unsigned)r->problem->parameter_count;
    unsigned rows = 2 * (unsigned)r->problem->sample_count;
    double *slack = malloc(sizeof(double) * rows), value;
    nlopt_opt solver = nlopt_create(NLOPT_LD_SLSQP, m + 1);
    nlopt_result status = NLOPT_OUT_OF_MEMORY;
    if (slack && solver) {
        for (unsigned i = 0; i < rows; i++)
            slack[i] = 1e-9;
        nlopt_set_min_objective(solver, bound_itself, NULL);
        nlopt_add_inequality_mconstraint(solver, rows, within_bound, r, slack);
        set_bounds(solver, r, m + 1, trust);
        nlopt_set_xtol_abs1(solver, 1e-10);
        nlopt_set_maxeval(solver, options->most_iterations);
        status = nlopt_optimize(solver, y, &value);
    }
    nlopt_destroy(solver);
    free(slack);
    return status;
}

void fit_solve_nlopt_minimax(const fit_problem *problem, const fit_options *options, double trust,
                             fit_result *result)
{
    run r;
    size_t n = problem->sample_count, m = problem->parameter_count;
    double y[FIT_MOST_PARAMETERS + 1] = {0}, moved[FIT_MOST_PARAMETERS];
    memset(result, 0, sizeof *result);
    snprintf(result->solver, sizeof result->solver, "NLopt %s SLSQP", fit_nlopt_version());
    snprintf(result->status, sizeof result->status, "FAILURE");
    memcpy(result->parameters, problem->start, sizeof(double) * m);
    result->objective = HUGE_VAL;
    if (!run_begin(&r, problem))
        return;
    if (fit_residuals(problem, problem->start, r.residuals) &&
        fit_jacobian(problem, problem->start, r.jacobian, r.work)) {
        result->objective = fit_largest(problem, r.residuals, NULL);
        r.unit = result->objective > 0.0 ? result->objective : 1.0;
        fit_whiten(&r.white, n, m, problem->start, r.jacobian, r.unit * sqrt((double)n),
                   is_bounded(problem));
        y[m] = 1.0;
        nlopt_srand((unsigned long)options->seed);
        keep_status(result, lower_bound(&r, options, trust, y));
        fit_unwhiten(&r.white, y, moved);
        if (fit_residuals(problem, moved, r.residuals)) {
            double after = fit_largest(problem, r.residuals, NULL);
            if (after < result->objective) {
                result->objective = after;
                memcpy(result->parameters, moved, sizeof(double) * m);
            }
        }
    }
    result->iterations = r.evaluations;
    result->usable = isfinite(result->objective);
    free(r.residuals);
}
