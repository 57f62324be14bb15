/* profile_search.c: candidates by backward elimination. */
#include "profile_fit.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/progress.h"
#include "base/text.h"
#include "fit/solve.h"

enum { TRIED = 3, QUICK_STEPS = 15, STEPS = 60 };

typedef struct model {
    const sg_form *form;
    size_t place[FIT_MOST_PARAMETERS]; /* of each parameter among the coefficients */
    size_t free;
} model;

typedef struct search {
    const choose_domain *domain;
    bool by_max;
    double most;
    fit_problem problem; /* samples alone */
    const sg_method *tiers[64];
    profile_list ladders[64];
    size_t count;
    base_progress *progress;
} search;

double profile_error(const profile_candidate *candidate, bool by_max)
{
    return by_max ? candidate->max_abs : candidate->rmse;
}

/* ---- Measuring ----------------------------------------------------------------------------- */

static bool safe(const sg_form *form, const float *k)
{
    for (int i = -1; i <= 140; i++) {
        float lambda = i < 0 ? 0.0f : i == 140 ? INFINITY : (float)pow(10.0, i * 0.1 - 4.0);
        lambda = i >= 120 && i < 140 ? lambda * 1e20f : lambda;
        for (int j = 0; j <= 64; j++) {
            float value = form->f32(lambda, (float)(j - 32) / 32.0f, k);
            if (!(value >= 0.0f && value <= 1.0f))
                return false;
        }
    }
    return true;
}

void profile_measure(const choose_domain *domain, profile_candidate *c)
{
    const sg_form *form = c->tier->form;
    float k[FIT_MOST_PARAMETERS];
    for (int i = 0; i < form->coefficient_count; i++)
        k[i] = (float)c->coefficients[i];
    double squares = 0.0, weights = 0.0;
    c->max_abs = 0.0;
    for (size_t i = 0; i < domain->count; i++) {
        double value = (double)form->f32(domain->lambda[i], domain->cos_theta[i], k);
        double miss = isfinite(value) ? fabs(value - domain->truth[i]) : (double)INFINITY;
        squares += domain->weight[i] * miss * miss;
        weights += domain->weight[i];
        c->max_abs = fmax(c->max_abs, miss);
    }
    c->rmse = sqrt(squares / weights);
    c->safe = safe(form, k);
}

/* ---- Fitting ------------------------------------------------------------------------------- */

static void values(const void *context, const double *parameters, size_t count,
                   const double *lambda, const double *cos_theta, double *out)
{
    const model *m = context;
    double k[FIT_MOST_PARAMETERS] = {0.0};
    for (size_t j = 0; j < m->free; j++)
        k[m->place[j]] = parameters[j];
    for (size_t i = 0; i < count; i++)
        out[i] = m->form->f64(lambda[i], cos_theta[i], k);
}

/* The search's samples with the candidate as model and start. */
static fit_problem problem_of(const search *s, const profile_candidate *c, model *m)
{
    fit_problem problem = s->problem;
    *m = (model){.form = c->tier->form};
    for (size_t i = 0; i < (size_t)m->form->coefficient_count; i++) {
        if (c->dropped[i])
            continue;
        m->place[m->free] = i;
        problem.start[m->free] = c->coefficients[i];
        problem.lower[m->free] = (double)-INFINITY;
        problem.upper[m->free++] = (double)INFINITY;
    }
    problem.parameter_count = m->free;
    problem.model = values;
    problem.context = m;
    return problem;
}

/* Fits what is not dropped; what a fit makes worse, or breaks, stays as it was. */
static void refit(const search *s, profile_candidate *c, int steps, bool minimax)
{
    model m;
    fit_problem problem = problem_of(s, c, &m);
    fit_options options = {1e-8, steps, 1};
    fit_result result = {0};
    profile_candidate other = *c;
    profile_measure(s->domain, c);
    if (minimax)
        fit_solve_minimax(&problem, &options, &result);
    else
        fit_solve_ceres(&problem, &options, &result);
    for (size_t j = 0; j < m.free; j++)
        other.coefficients[m.place[j]] = result.parameters[j];
    profile_measure(s->domain, &other);
    bool by_max = minimax && s->by_max;
    if (profile_error(&other, by_max) < profile_error(c, by_max) && (other.safe || !c->safe))
        *c = other;
}

/* ---- Elimination --------------------------------------------------------------------------- */

static void push(profile_list *to, const profile_candidate *candidate)
{
    to->list = base_reallocate(to->list, (to->count + 1) * sizeof *to->list);
    to->list[to->count++] = *candidate;
}

static size_t least(const double *worth, size_t count)
{
    size_t at = 0;
    for (size_t i = 1; i < count; i++)
        if (worth[i] < worth[at])
            at = i;
    return at;
}

/* Drops the coefficient, of the few that seem worth least, without which a fit is best. */
static bool step_down(const search *s, profile_candidate *c)
{
    size_t count = (size_t)c->tier->form->coefficient_count;
    double worth[FIT_MOST_PARAMETERS];
    for (size_t i = 0; i < count; i++)
        worth[i] = (double)INFINITY;
    model m;
    fit_problem problem = problem_of(s, c, &m);
    if (!profile_worths(&problem, m.place, worth))
        return false;
    profile_candidate best = {.max_abs = (double)INFINITY, .rmse = (double)INFINITY};
    for (int t = 0; t < TRIED; t++) {
        size_t at = least(worth, count);
        profile_candidate one = *c;
        if (isinf(worth[at]))
            break;
        one.dropped[at] = true;
        one.coefficients[at] = 0.0;
        bool free_of_charge = worth[at] == 0.0;
        worth[at] = (double)INFINITY;
        refit(s, &one, QUICK_STEPS, false);
        if (t == 0 || (one.safe && !best.safe) ||
            (one.safe == best.safe &&
             profile_error(&one, s->by_max) < profile_error(&best, s->by_max)))
            best = one;
        if (free_of_charge)
            break;
    }
    if (!best.tier)
        return false;
    *c = best;
    refit(s, c, STEPS, false);
    return isfinite(c->rmse);
}

static void climb(void *context, size_t index)
{
    search *s = context;
    const sg_method *tier = s->tiers[index];
    profile_candidate c = {.tier = tier, .fitted = true, .instructions = (double)NAN};
    memcpy(c.coefficients, tier->coefficients,
           sizeof(double) * (size_t)tier->form->coefficient_count);
    refit(s, &c, STEPS, false);
    /* Least squares leads the way down; the largest error of a rung may be a few times less. */
    double slack = s->by_max ? 3.0 : 1.0;
    do {
        profile_candidate rung = c;
        if (s->by_max)
            refit(s, &rung, STEPS, true);
        push(&s->ladders[index], &rung);
    } while (profile_error(&c, s->by_max) <= slack * s->most && step_down(s, &c));
    base_progress_step(s->progress, tier->id);
}

/* ---- All of it ----------------------------------------------------------------------------- */

static bool samples(const choose_domain *domain, bool by_max, fit_problem *problem)
{
    if (!fit_problem_allocate(problem, domain->count)) {
        base_error("fit: no memory for %zu points", domain->count);
        return false;
    }
    for (size_t i = 0; i < domain->count; i++) {
        problem->lambda[i] = (double)domain->lambda[i];
        problem->cos_theta[i] = (double)domain->cos_theta[i];
        problem->target[i] = domain->truth[i];
        problem->scale[i] = by_max ? 1.0 : sqrt(domain->weight[i]);
    }
    if (!by_max)
        fit_problem_normalise(problem);
    return true;
}

bool profile_tiers(const choose_domain *domain, profile_list *found)
{
    *found = (profile_list){0};
    for (size_t i = 0; i < sg_method_count(); i++) {
        const sg_method *method = sg_method_at(i);
        profile_candidate c = {.tier = method, .instructions = (double)NAN};
        if (strcmp(method->variant, "tier") != 0 ||
            method->form->coefficient_count > FIT_MOST_PARAMETERS || method->form->native != SG_L)
            continue;
        memcpy(c.coefficients, method->coefficients,
               sizeof(double) * (size_t)method->form->coefficient_count);
        profile_measure(domain, &c);
        push(found, &c);
    }
    if (found->count == 0)
        base_error("fit: expected at least one tier in this program's registry");
    return found->count > 0;
}

bool profile_ladders(const choose_domain *domain, bool by_max, double most, profile_list *found)
{
    search s = {.domain = domain, .by_max = by_max, .most = most};
    profile_list tiers;
    *found = (profile_list){0};
    if (!samples(domain, by_max, &s.problem))
        return false;
    if (!profile_tiers(domain, &tiers)) {
        fit_problem_free(&s.problem);
        return false;
    }
    for (size_t i = 0; i < tiers.count && s.count < 64; i++) {
        size_t j = 0;
        while (j < s.count && s.tiers[j]->form != tiers.list[i].tier->form)
            j++;
        if (j == s.count)
            s.tiers[s.count++] = tiers.list[i].tier;
    }
    s.progress = base_progress_begin("fitting", s.count);
    base_parallel(s.count, climb, &s);
    base_progress_end(s.progress);
    for (size_t i = 0; i < s.count; i++) {
        for (size_t j = 0; j < s.ladders[i].count; j++)
            push(found, &s.ladders[i].list[j]);
        free(s.ladders[i].list);
    }
    free(tiers.list);
    fit_problem_free(&s.problem);
    return true;
}
