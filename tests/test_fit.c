/* The solvers on problems whose answers are known. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "capture.h"
#include "fit/error_bound.h"
#include "fit/problem.h"
#include "fit/solve.h"
#include "sg.h"

static const fit_options options = {1e-11, 2000, 1};

/* ---- Problems ------------------------------------------------------------------------------ */

/* k0 e^(-k1 x) + k2 */
static void decay(const void *context, const double *k, size_t count, const double *x,
                  const double *unused, double *values)
{
    (void)context;
    (void)unused;
    for (size_t i = 0; i < count; i++)
        values[i] = k[0] * exp(-k[1] * x[i]) + k[2];
}

static void polynomial(const void *context, const double *k, size_t count, const double *x,
                       const double *unused, double *values)
{
    size_t terms = *(const size_t *)context;
    (void)unused;
    for (size_t i = 0; i < count; i++) {
        values[i] = 0.0;
        for (size_t j = terms; j-- > 0;)
            values[i] = values[i] * x[i] + k[j];
    }
}

static fit_problem problem_on(double from, double to, size_t count, double (*target)(double),
                              fit_model model, const void *context, size_t parameters)
{
    fit_problem p = {.parameter_count = parameters, .model = model, .context = context};
    assert_true(fit_problem_allocate(&p, count));
    for (size_t i = 0; i < count; i++) {
        p.lambda[i] = from + (to - from) * (double)i / (double)(count - 1);
        p.cos_theta[i] = 0.0;
        p.target[i] = target(p.lambda[i]);
        p.scale[i] = 1.0;
    }
    for (size_t j = 0; j < parameters; j++) {
        p.start[j] = 1.0;
        p.lower[j] = -INFINITY;
        p.upper[j] = INFINITY;
    }
    return p;
}

static double decaying(double x)
{
    return 2.5 * exp(-0.7 * x) + 0.3;
}

static double wavy(double x)
{
    return decaying(x) + 0.05 * sin(13.0 * x);
}

static double exponential(double x)
{
    return exp(x);
}

/* ---- Least squares ------------------------------------------------------------------------- */

static void both_solvers_recover_exact_data(void **state)
{
    (void)state;
    fit_problem p = problem_on(0.0, 5.0, 200, decaying, decay, NULL, 3);
    fit_result ceres, nlopt;
    fit_solve_ceres(&p, &options, &ceres);
    fit_solve_nlopt(&p, &options, &nlopt);
    const double truth[3] = {2.5, 0.7, 0.3};
    assert_true(ceres.usable && nlopt.usable);
    assert_true(fit_disagreement(3, ceres.parameters, truth) < 1e-9);
    assert_true(fit_disagreement(3, nlopt.parameters, truth) < 1e-7);
    fit_problem_free(&p);
}

static void solvers_agree_where_residuals_remain(void **state)
{
    (void)state;
    fit_problem p = problem_on(0.0, 5.0, 333, wavy, decay, NULL, 3);
    fit_problem_normalise(&p);
    fit_result ceres, nlopt;
    fit_solve_ceres(&p, &options, &ceres);
    fit_solve_nlopt(&p, &options, &nlopt);
    assert_true(fit_disagreement(3, ceres.parameters, nlopt.parameters) < 1e-7);
    assert_true(fabs(ceres.objective - nlopt.objective) < 1e-12 * ceres.objective);
    assert_true(ceres.objective > 1e-4); /* there is something left to agree about */
    fit_problem_free(&p);
}

/* A line through x^2 on [0, 1] by least squares: x - 1/6, for dense samples. */
static double square(double x)
{
    return x * x;
}

static void least_squares_line_through_a_parabola(void **state)
{
    (void)state;
    size_t terms = 2;
    fit_problem p = problem_on(0.0, 1.0, 20001, square, polynomial, &terms, 2);
    fit_result result;
    fit_solve_ceres(&p, &options, &result);
    assert_true(fabs(result.parameters[0] + 1.0 / 6.0) < 1e-4);
    assert_true(fabs(result.parameters[1] - 1.0) < 1e-4);
    fit_problem_free(&p);
}

static void bounds_hold_in_both_solvers(void **state)
{
    (void)state;
    fit_problem p = problem_on(0.0, 5.0, 200, decaying, decay, NULL, 3);
    p.upper[1] = 0.5; /* the free solution has 0.7 */
    p.start[1] = 0.4;
    fit_result ceres, nlopt;
    fit_solve_ceres(&p, &options, &ceres);
    fit_solve_nlopt(&p, &options, &nlopt);
    assert_true(ceres.parameters[1] <= 0.5 && ceres.parameters[1] > 0.4999);
    assert_true(nlopt.parameters[1] <= 0.5 + 1e-12 && nlopt.parameters[1] > 0.4999);
    assert_true(fit_disagreement(3, ceres.parameters, nlopt.parameters) < 1e-4);
    fit_problem_free(&p);
}

/* Weights, as scales of the residuals, decide between two targets. */
static void scales_weigh_samples(void **state)
{
    (void)state;
    size_t terms = 1;
    fit_problem p = problem_on(0.0, 1.0, 2, square, polynomial, &terms, 1);
    p.scale[1] = 3.0; /* weight 9 for the target 1, weight 1 for 0 */
    fit_result result;
    fit_solve_nlopt(&p, &options, &result);
    assert_true(fabs(result.parameters[0] - 0.9) < 1e-9);
    fit_problem_free(&p);
}

static void broken(const void *context, const double *k, size_t count, const double *x,
                   const double *unused, double *values)
{
    (void)context;
    (void)k;
    (void)x;
    (void)unused;
    for (size_t i = 0; i < count; i++)
        values[i] = NAN;
}

static void a_model_that_breaks_is_reported_and_silent(void **state)
{
    (void)state;
    fit_problem p = problem_on(0.0, 1.0, 10, square, broken, NULL, 1);
    fit_result ceres, nlopt, minimax;
    capture c;
    capture_begin(&c);
    fit_solve_ceres(&p, &options, &ceres);
    fit_solve_nlopt(&p, &options, &nlopt);
    fit_solve_minimax(&p, &options, &minimax);
    const char *printed = capture_end(&c);
    assert_string_equal(printed, "");
    assert_false(ceres.usable || nlopt.usable || minimax.usable);
    fit_problem_free(&p);
}

/* ---- Minimax ------------------------------------------------------------------------------- */

/* The best line for e^x on [0, 1] is known: slope e - 1, largest error
 * (1 - (e - 1) (1 - ln(e - 1)))/2 in magnitude. */
static void minimax_line_for_the_exponential(void **state)
{
    (void)state;
    size_t terms = 2;
    fit_problem p = problem_on(0.0, 1.0, 5001, exponential, polynomial, &terms, 2);
    fit_result result;
    fit_solve_minimax(&p, &options, &result);
    double slope = exp(1.0) - 1.0;
    double error = 0.5 * fabs(1.0 - slope + slope * log(slope));
    assert_true(result.usable);
    assert_true(fabs(result.parameters[1] - slope) < 1e-5);
    assert_true(fabs(result.objective - error) < 1e-6);
    fit_problem_free(&p);
}

/* Chebyshev: the best cubic's error reaches its bound with alternating sign five times. */
static void minimax_cubic_alternates(void **state)
{
    (void)state;
    size_t terms = 4;
    fit_problem p = problem_on(-1.0, 1.0, 4001, exponential, polynomial, &terms, 4);
    fit_result result;
    fit_solve_minimax(&p, &options, &result);
    double *residuals = malloc(sizeof(double) * p.sample_count);
    assert_true(fit_residuals(&p, result.parameters, residuals));
    int alternations = 0, sign = 0;
    for (size_t i = 0; i < p.sample_count; i++) {
        int side = residuals[i] > 0.0 ? 1 : -1;
        if (fabs(residuals[i]) > 0.999 * result.objective && side != sign) {
            alternations++;
            sign = side;
        }
    }
    assert_int_equal(alternations, 5);
    free(residuals);
    fit_problem_free(&p);
}

/* ---- Repetition ---------------------------------------------------------------------------- */

static void solving_again_gives_the_same_bits(void **state)
{
    (void)state;
    fit_problem p = problem_on(0.0, 5.0, 333, wavy, decay, NULL, 3);
    void (*const solvers[])(const fit_problem *, const fit_options *,
                            fit_result *) = {fit_solve_ceres, fit_solve_nlopt, fit_solve_minimax};
    for (size_t s = 0; s < 3; s++) {
        fit_result first, second;
        solvers[s](&p, &options, &first);
        solvers[s](&p, &options, &second);
        assert_memory_equal(first.parameters, second.parameters, 3 * sizeof(double));
        assert_int_equal(first.iterations, second.iterations);
        assert_string_equal(first.status, second.status);
    }
    fit_problem_free(&p);
}

static void derivatives_are_accurate(void **state)
{
    (void)state;
    fit_problem p = problem_on(0.0, 5.0, 50, decaying, decay, NULL, 3);
    double k[3] = {2.0, 0.5, 0.1}, jacobian[150], work[100];
    assert_true(fit_jacobian(&p, k, jacobian, work));
    for (size_t i = 0; i < 50; i++) {
        double x = p.lambda[i], e = exp(-k[1] * x);
        assert_true(fabs(jacobian[i] - e) < 1e-9);
        assert_true(fabs(jacobian[50 + i] + k[0] * x * e) < 1e-9);
        assert_true(fabs(jacobian[100 + i] - 1.0) < 1e-9);
    }
    fit_problem_free(&p);
}

/* ---- The error bound ----------------------------------------------------------------------- */

static void the_root_is_the_minimum_of_the_bound(void **state)
{
    (void)state;
    double root;
    int iterations;
    double epsilon = ldexp(1.0, -23);
    assert_true(fit_error_bound_root(epsilon, 1e-5, 0.1, &root, &iterations));
    assert_true(fabs(root / 0.00084560872241480124 - 1.0) < 1e-12);
    assert_true(fabs(fit_cosine_normalisation(root) / 1182.2467339678153 - 1.0) < 1e-12);
    long double e = 0.5L * (long double)epsilon, at = fit_error_bound(root, e);
    assert_true(fit_error_bound(root * 1.01L, e) > at);
    assert_true(fit_error_bound(root * 0.99L, e) > at);
    /* the slope is the derivative: 2 p^2/((1 + e) l^2) of it, p = e^l - 1 - l */
    long double l = 3e-3L, h = 1e-5L * l, p = expm1l(l) - l;
    long double slope = (fit_error_bound(l + h, e) - fit_error_bound(l - h, e)) / (2.0L * h);
    long double claimed = fit_error_bound_slope(l, e) * l * l * (1.0L + e) / (2.0L * p * p);
    assert_true(fabsl(slope / claimed - 1.0L) < 1e-7L);
    assert_false(fit_error_bound_root(epsilon, 1e-2, 0.1, &root, &iterations));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(both_solvers_recover_exact_data),
        cmocka_unit_test(solvers_agree_where_residuals_remain),
        cmocka_unit_test(least_squares_line_through_a_parabola),
        cmocka_unit_test(bounds_hold_in_both_solvers),
        cmocka_unit_test(scales_weigh_samples),
        cmocka_unit_test(a_model_that_breaks_is_reported_and_silent),
        cmocka_unit_test(minimax_line_for_the_exponential),
        cmocka_unit_test(minimax_cubic_alternates),
        cmocka_unit_test(solving_again_gives_the_same_bits),
        cmocka_unit_test(derivatives_are_accurate),
        cmocka_unit_test(the_root_is_the_minimum_of_the_bound),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
