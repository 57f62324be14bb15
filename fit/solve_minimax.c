/* solve_minimax.c: the largest residual over many samples, made small by exchange.
 *
 * Least squares, then (with more than a few parameters) its powers 4 to 256, then exchange. Only
 * the few samples where the error peaks shape a minimax fit. The reference set starts with the
 * peaks of the least-squares solution; NLopt makes the largest residual on it small; the peaks of
 * that fit over all samples join; and so on, until no sample is worse than the set says. The value
 * on the set is a lower bound of what any (local) fit reaches, so the end is an optimum. */
#include "solve.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { FEW_PARAMETERS = 5, ROUNDS = 80, BUCKET = 16, MOST_REFERENCE = 600 };
static const double PEAK = 0.6; /* of the largest: what counts as a peak */

typedef struct reference {
    fit_problem few;
    size_t *index; /* into the full problem */
    bool *taken;   /* for every sample of the full problem */
} reference;

static bool reference_begin(reference *set, const fit_problem *problem)
{
    set->few = *problem;
    set->index = malloc(sizeof(size_t) * MOST_REFERENCE);
    set->taken = calloc(problem->sample_count + 1, sizeof(bool));
    bool allocated = fit_problem_allocate(&set->few, MOST_REFERENCE);
    set->few.sample_count = 0;
    return allocated && set->index && set->taken;
}

static void reference_end(reference *set)
{
    if (set->few.lambda)
        fit_problem_free(&set->few);
    free(set->index);
    free(set->taken);
}

static void take(reference *set, const fit_problem *problem, size_t i)
{
    size_t k = set->few.sample_count;
    if (k == MOST_REFERENCE || set->taken[i])
        return;
    set->taken[i] = true;
    set->index[k] = i;
    set->few.lambda[k] = problem->lambda[i];
    set->few.cos_theta[k] = problem->cos_theta[i];
    set->few.target[k] = problem->target[i];
    set->few.scale[k] = problem->scale[i];
    set->few.sample_count = k + 1;
}

/* The worst of every run of BUCKET neighbours, where it is above the level. */
static void take_peaks(reference *set, const fit_problem *problem, const double *residuals,
                       double level)
{
    for (size_t first = 0; first < problem->sample_count; first += BUCKET) {
        size_t end =
            first + BUCKET < problem->sample_count ? first + BUCKET : problem->sample_count;
        size_t worst = first;
        for (size_t i = first + 1; i < end; i++)
            if (fabs(residuals[i]) > fabs(residuals[worst]))
                worst = i;
        if (fabs(residuals[worst]) > level)
            take(set, problem, worst);
    }
}

/* Samples that are far below the bound at the current fit no longer hold anything back. */
static void drop_idle(reference *set, const double *residuals, double level)
{
    size_t kept = 0;
    for (size_t k = 0; k < set->few.sample_count; k++) {
        size_t i = set->index[k];
        if (fabs(residuals[i]) < level) {
            set->taken[i] = false;
            continue;
        }
        set->index[kept] = i;
        set->few.lambda[kept] = set->few.lambda[k];
        set->few.cos_theta[kept] = set->few.cos_theta[k];
        set->few.target[kept] = set->few.target[k];
        set->few.scale[kept] = set->few.scale[k];
        kept++;
    }
    set->few.sample_count = kept;
}

/* Peaks join from wherever a round ended, but the next round starts from the best fit so far; a
 * round that went astray (or left the model's domain) makes the next one more careful. */
static void exchange(const fit_problem *problem, const fit_options *options, reference *set,
                     double *residuals, fit_result *result)
{
    size_t m = problem->parameter_count;
    double trust = 0.5;
    if (!fit_residuals(problem, result->parameters, residuals))
        return;
    result->objective = fit_largest(problem, residuals, NULL);
    take_peaks(set, problem, residuals, PEAK * result->objective);
    for (int round = 1; round <= ROUNDS && trust > 1e-9; round++) {
        fit_result inner;
        memcpy(set->few.start, result->parameters, sizeof(double) * m);
        fit_solve_nlopt_minimax(&set->few, options, trust, &inner);
        result->iterations += inner.iterations;
        snprintf(result->status, sizeof result->status, "%.32s, exchange round %d", inner.status,
                 round);
        if (!fit_residuals(problem, inner.parameters, residuals)) {
            trust *= 0.25;
            continue;
        }
        double worst = fit_largest(problem, residuals, NULL), before = result->objective;
        if (set->few.sample_count > MOST_REFERENCE / 2)
            drop_idle(set, residuals, PEAK * worst);
        take_peaks(set, problem, residuals, PEAK * worst);
        if (worst < result->objective) {
            result->objective = worst;
            memcpy(result->parameters, inner.parameters, sizeof(double) * m);
            trust = fmin(2.0 * trust, 4.0);
        } else {
            trust *= 0.5;
        }
        /* On the set it cannot be done better, and the trust box did not hold the round back. */
        if (worst <= inner.objective * (1.0 + 1e-6) && before - worst < 1e-7 * before)
            return;
    }
}

/* From least squares towards minimax, by powers of the residuals that double: each is a small step
 * from the one before, and Ceres finds it where rounds of exchange would not find their way, with
 * many parameters above all. What is worse by the largest residual is not taken. */
static void climb(const fit_problem *problem, const fit_options *options, double *residuals,
                  fit_result *result)
{
    size_t m = problem->parameter_count;
    fit_options each = *options;
    if (!fit_residuals(problem, result->parameters, residuals))
        return;
    double best = fit_largest(problem, residuals, NULL), unit = best;
    fit_problem power = *problem;
    memcpy(power.start, result->parameters, sizeof(double) * m);
    each.most_iterations = options->most_iterations < 60 ? options->most_iterations : 60;
    for (power.power = 4.0; power.power <= 256.0; power.power *= 2.0) {
        fit_result step;
        power.unit = unit;
        fit_solve_ceres(&power, &each, &step);
        result->iterations += step.iterations;
        if (!fit_residuals(problem, step.parameters, residuals))
            break;
        memcpy(power.start, step.parameters, sizeof(double) * m);
        unit = fit_largest(problem, residuals, NULL);
        if (unit < best) {
            best = unit;
            memcpy(result->parameters, step.parameters, sizeof(double) * m);
        }
    }
}

void fit_solve_minimax(const fit_problem *problem, const fit_options *options, fit_result *result)
{
    reference set;
    double *residuals = malloc(sizeof(double) * (problem->sample_count + 1));
    /* With few parameters exchange finds its way alone, and the powers would take most of the time.
     */
    bool many = problem->parameter_count > FEW_PARAMETERS;
    fit_solve_ceres(problem, options, result);
    snprintf(result->solver, sizeof result->solver, "NLopt %s SLSQP with exchange, after Ceres%s",
             fit_nlopt_version(), many ? " and its powers" : "");
    if (residuals && result->usable && many)
        climb(problem, options, residuals, result);
    if (reference_begin(&set, problem) && residuals && result->usable)
        exchange(problem, options, &set, residuals, result);
    else
        result->usable = false;
    reference_end(&set);
    free(residuals);
}
