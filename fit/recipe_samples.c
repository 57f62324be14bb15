/* recipe_samples.c: grids, targets and models of a recipe. */
#include <math.h>
#include <stdlib.h>

#include "fit/recipe_run.h"

static const double pi = 3.14159265358979323846;

static const double shift = 1.0; /* of "shifted_log" */

double recipe_axis_at(const recipe_axis *axis, size_t index)
{
    double part = (double)index / (double)(axis->count - 1), from = axis->from, to = axis->to;
    double ends[2] = {from, to};
    /* The ends come out exactly as they were given. */
    if (index == 0 || index == axis->count - 1)
        return axis->spacing < SPACING_BETA ? ends[index > 0] : ends[index > 0] / 180.0 * pi;
    switch (axis->spacing) {
    case SPACING_LOG:
        return from * pow(to / from, part);
    case SPACING_SQRT: {
        double root = sqrt(from) + (sqrt(to) - sqrt(from)) * part;
        return root * root;
    }
    case SPACING_LINEAR:
        return from + (to - from) * part;
    case SPACING_SHIFTED:
        return (from + shift) * pow((to + shift) / (from + shift), part) - shift;
    case SPACING_BETA:
        return (from + (to - from) * part) / 180.0 * pi;
    default: {
        double start = cos(from / 180.0 * pi), end = cos(to / 180.0 * pi);
        return acos(start + (end - start) * part);
    }
    }
}

/* Beyond 5.5/sqrt(lambda) from the terminator L is max(cos_theta, 0) (1 - 1/lambda) to 1e-7. */
static double near_terminator(const recipe_axis *axis, size_t index, double lambda)
{
    double part = 2.0 * (double)index / (double)(axis->count - 1) - 1.0, away = fabs(part);
    if (index == 0 || index == axis->count - 1)
        return -part;
    double blend = 0.5 * away + 0.25 * (1.0 - cos(pi * away));
    return -copysign(fmin(1.0, 5.5 / sqrt(lambda)) * blend, part);
}

/* Exact at right angles, where the rounding of pi would leave 6e-17. */
static double cosine_at(const recipe_axis *axis, size_t index, double lambda)
{
    if (axis->spacing == SPACING_TERMINATOR)
        return near_terminator(axis, index, lambda);
    if (axis->spacing == SPACING_COS) {
        double start = cos(axis->from / 180.0 * pi), end = cos(axis->to / 180.0 * pi);
        return start + (end - start) * (double)index / (double)(axis->count - 1);
    }
    double beta = recipe_axis_at(axis, index);
    return fabs(beta - 0.5 * pi) < 1e-15 ? 0.0 : cos(beta);
}

/* ---- Models -------------------------------------------------------------------------------- */

static void assemble(const way_context *c, const double *parameters, double *coefficients)
{
    size_t next = 0;
    for (size_t i = 0; i < c->way->coefficient_count; i++)
        coefficients[i] =
            c->way->coefficients[i].free ? parameters[next++] : c->way->coefficients[i].value;
}

static void form_values(const void *context, const double *parameters, size_t count,
                        const double *lambda, const double *cos_theta, double *values)
{
    const way_context *c = context;
    double k[FIT_MOST_PARAMETERS];
    assemble(c, parameters, k);
    for (size_t i = 0; i < count; i++)
        values[i] = c->recipe->form->f64(lambda[i], cos_theta[i], k);
}

static void curve_values(const void *context, const double *parameters, size_t count,
                         const double *x, const double *unused, double *values)
{
    const way_context *c = context;
    double k[FIT_MOST_PARAMETERS];
    (void)unused;
    assemble(c, parameters, k);
    for (size_t i = 0; i < count; i++)
        values[i] = c->recipe->curve->value(x[i], k);
}

/* ---- Samples ------------------------------------------------------------------------------- */

static double weight(const recipe_way *way, double lambda, double value)
{
    if (way->absolute > 0.0)
        return value > way->down_to ? 1.0 / fmin(way->absolute, way->relative * value) : 0.0;
    return pow(lambda, way->weight_lambda) *
           (way->weight_value == 0.0 ? 1.0 : pow(value, way->weight_value));
}

/* Residuals are wanted in the way's quantity, the form computes its own: the scale converts. */
static bool form_samples(const recipe *r, const recipe_way *way, fit_problem *problem)
{
    size_t angles = way->angle.count, count = way->lambda.count * angles;
    double *beta = malloc(sizeof(double) * angles), *row = malloc(sizeof(double) * angles);
    bool good = beta && row && fit_problem_allocate(problem, count);
    for (size_t i = 0; good && i < way->lambda.count; i++) {
        double lambda = recipe_axis_at(&way->lambda, i), area = sg_A(lambda);
        double *target = problem->target + i * angles;
        for (size_t j = 0; j < angles; j++) {
            row[j] = lambda;
            beta[j] = way->angle.spacing == SPACING_TERMINATOR
                          ? acos(near_terminator(&way->angle, j, lambda))
                          : recipe_axis_at(&way->angle, j);
        }
        sg_A_h_batch(angles, row, beta, target);
        for (size_t j = 0; j < angles; j++) {
            size_t k = i * angles + j;
            double native = r->form->native == SG_L ? area : 1.0;
            double wanted = way->quantity == SG_L ? area : 1.0;
            double value = target[j] / wanted;
            target[j] /= native;
            problem->lambda[k] = lambda;
            problem->cos_theta[k] = cosine_at(&way->angle, j, lambda);
            problem->scale[k] = native / wanted * weight(way, lambda, value);
        }
    }
    free(beta);
    free(row);
    return good;
}

bool recipe_steepness(const recipe *r, const recipe_way *way, double *lambda, double *t, double *u)
{
    size_t angles = way->angle.count;
    double *cosines = malloc(sizeof(double) * 2 * angles), tied[2] = {0.0, 0.0}, scale;
    if (!cosines)
        return false;
    for (size_t j = 0; j < angles; j++)
        cosines[j] = cosine_at(&way->angle, j, 0.0);
    for (size_t j = 0; j < r->curve->tied_count; j++)
        tied[j] = way->coefficients[r->curve->count + j].value;
    for (size_t i = 0; i < way->lambda.count; i++) {
        lambda[i] = recipe_axis_at(&way->lambda, i);
        t[i] = fit_steepness(r->curve->shape, tied, lambda[i], angles, cosines, cosines + angles,
                             &scale);
        if (u)
            u[i] = scale;
    }
    free(cosines);
    return true;
}

static bool curve_samples(const recipe *r, const recipe_way *way, fit_problem *problem)
{
    size_t count = way->lambda.count;
    double *u = malloc(sizeof(double) * count);
    bool good = u && fit_problem_allocate(problem, count) &&
                recipe_steepness(r, way, problem->lambda, problem->target, u);
    for (size_t i = 0; good && i < count; i++) {
        double lambda = problem->lambda[i];
        if (r->curve->inverse_scale) {
            problem->lambda[i] = problem->target[i];
            problem->target[i] = 1.0 / u[i];
        }
        problem->cos_theta[i] = 0.0;
        problem->scale[i] =
            pow(lambda, way->weight_lambda) * pow(problem->target[i], way->weight_value);
    }
    free(u);
    return good;
}

bool recipe_samples(const recipe *r, const recipe_way *way, way_context *context,
                    fit_problem *problem)
{
    *problem = (fit_problem){0};
    *context = (way_context){.recipe = r, .way = way};
    for (size_t i = 0; i < way->coefficient_count; i++) {
        const recipe_coefficient *c = &way->coefficients[i];
        if (!c->free)
            continue;
        size_t j = problem->parameter_count++;
        context->free_index[j] = i;
        problem->start[j] = c->value;
        problem->lower[j] = c->lower;
        problem->upper[j] = c->upper;
    }
    problem->context = context;
    problem->model = r->form ? form_values : curve_values;
    return r->form ? form_samples(r, way, problem) : curve_samples(r, way, problem);
}
