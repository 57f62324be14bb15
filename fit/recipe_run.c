#include "fit/recipe_run.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "fit/error_bound.h"

void recipe_fail(recipe_result *result, const char *format, ...)
{
    if (result->failed)
        return;
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(result->why, sizeof result->why, format, arguments);
    va_end(arguments);
    result->failed = true;
}

/* ---- One way ------------------------------------------------------------------------------- */

static bool measure(const fit_problem *problem, const double *parameters, way_result *out)
{
    double *residuals = malloc(sizeof(double) * (problem->sample_count + 1));
    bool good = residuals && fit_residuals(problem, parameters, residuals);
    if (good) {
        out->rms = sqrt(fit_sum_of_squares(problem, residuals) / (double)problem->sample_count);
        out->largest = fit_largest(problem, residuals, NULL);
    }
    free(residuals);
    return good;
}

/* Scales of sum 1 change no solution, but make the solvers' own numbers mean squares. */
static void solve_squares(const recipe *r, fit_problem *problem, bool both, way_result *out)
{
    fit_options options = {r->solver_tolerance, r->iterations, r->seed};
    size_t n = problem->sample_count;
    double *raw = malloc(sizeof(double) * (n + 1));
    if (!raw)
        return;
    memcpy(raw, problem->scale, sizeof(double) * n);
    fit_problem_normalise(problem);
    fit_solve_ceres(problem, &options, &out->solvers[0]);
    out->solver_count = 1;
    if (both) {
        fit_solve_nlopt(problem, &options, &out->solvers[1]);
        out->solver_count = 2;
        out->disagreement = fit_disagreement(problem->parameter_count, out->solvers[0].parameters,
                                             out->solvers[1].parameters);
    }
    memcpy(problem->scale, raw, sizeof(double) * n);
    free(raw);
}

/* The first fit of a way some of whose coefficients join later: its result becomes the problem's
 * start. False where there is no finite one. */
static bool begin_with_fewer(const recipe *r, const recipe_way *way, fit_problem *problem,
                             fit_result *first)
{
    recipe_way fewer = *way;
    way_context context;
    fit_problem small;
    fit_options options = {r->solver_tolerance, r->iterations, r->seed};
    for (size_t i = 0; i < fewer.coefficient_count; i++)
        fewer.coefficients[i].free = fewer.coefficients[i].free && !fewer.coefficients[i].later;
    bool good = recipe_samples(r, &fewer, &context, &small);
    if (good) {
        fit_solve_ceres(&small, &options, first);
        good = first->usable;
        size_t from = 0, to = 0;
        for (size_t i = 0; i < way->coefficient_count; i++) {
            if (fewer.coefficients[i].free)
                problem->start[to] = first->parameters[from++];
            to += way->coefficients[i].free;
        }
    }
    fit_problem_free(&small);
    return good;
}

static void run_way(const recipe *r, const recipe_way *way, bool both, way_result *out)
{
    way_context context;
    fit_problem problem;
    fit_options options = {r->solver_tolerance, r->iterations, r->seed};
    bool staged = false;
    for (size_t i = 0; i < way->coefficient_count; i++)
        staged = staged || way->coefficients[i].later;
    if (recipe_samples(r, way, &context, &problem) &&
        (!staged || begin_with_fewer(r, way, &problem, &out->solvers[0]))) {
        out->samples = problem.sample_count;
        if (way->objective == RECIPE_MINIMAX) {
            fit_solve_minimax(&problem, &options, &out->solvers[0]);
            out->solver_count = 1;
        } else {
            solve_squares(r, &problem, both, out);
        }
        out->usable = out->solver_count > 0 && out->solvers[0].usable &&
                      (out->solver_count == 1 || out->solvers[1].usable) &&
                      measure(&problem, out->solvers[0].parameters, out);
        for (size_t i = 0; i < way->coefficient_count; i++)
            out->coefficients[i] = way->coefficients[i].value;
        for (size_t j = 0; j < problem.parameter_count; j++)
            out->coefficients[context.free_index[j]] = out->solvers[0].parameters[j];
    }
    fit_problem_free(&problem);
}

static void run_root(const recipe *r, recipe_result *result)
{
    way_result *out = &result->own;
    fit_result *solver = &out->solvers[0];
    double root = NAN;
    bool found = fit_error_bound_root(r->epsilon, r->way.lambda.from, r->way.lambda.to, &root,
                                      &solver->iterations);
    out->solver_count = 1;
    snprintf(solver->solver, sizeof solver->solver, "bisection in long double, series");
    snprintf(solver->status, sizeof solver->status, "%s", found ? "CONVERGENCE" : "NO_ROOT");
    out->usable = solver->usable = found;
    out->coefficients[0] = root;
    out->coefficients[1] = fit_cosine_normalisation(root);
}

/* ---- The recipe ---------------------------------------------------------------------------- */

static void judge(const recipe *r, recipe_result *result)
{
    const way_result *own = &result->own;
    for (int i = 0; i < own->solver_count; i++)
        if (!own->solvers[i].usable)
            recipe_fail(result, "%s: %s ended with %s", r->id, own->solvers[i].solver,
                        own->solvers[i].status);
    if (!own->usable)
        recipe_fail(result, "%s: no finite result", r->id);
    if (own->disagreement > r->agreement)
        recipe_fail(result, "%s: the solvers differ by %.2g, expected at most %.2g", r->id,
                    own->disagreement, r->agreement);
}

void recipe_run(const recipe *r, recipe_result *result)
{
    memset(result, 0, sizeof *result);
    if (r->kind == RECIPE_ROOT) {
        run_root(r, result);
    } else {
        run_way(r, &r->way, true, &result->own);
        result->tried = calloc(r->tried_count + 1, sizeof *result->tried);
        for (size_t i = 0; result->tried && i < r->tried_count; i++)
            run_way(r, &r->tried[i], false, &result->tried[i]);
    }
    judge(r, result);
}

void recipe_result_free(recipe_result *result)
{
    free(result->tried);
    result->tried = NULL;
}
