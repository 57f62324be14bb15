/* test_score.c: the score finds errors that are known, at their places, and shows again the
 * published methods' measured errors. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include <math.h>
#include <string.h>

#include "fit/score.h"

static const double pi = 3.14159265358979323846;

static double with_planted_error(const void *context, double lambda, double cos_theta)
{
    (void)context;
    return sg_L_cos(lambda, cos_theta) + 0.01 * cos_theta * cos_theta;
}

static double with_one_defect(const void *context, double lambda, double cos_theta)
{
    double from = *(const double *)context;
    return lambda > from && cos_theta < -0.5 ? (double)NAN : sg_L_cos(lambda, cos_theta);
}

static double in_float(const void *context, double lambda, double cos_theta)
{
    (void)context;
    return (double)(float)sg_L_cos(lambda, cos_theta);
}

static double exact(const void *context, double lambda, double cos_theta)
{
    (void)context;
    return sg_L_cos(lambda, cos_theta);
}

static void a_planted_error_is_found_at_its_place(void **state)
{
    (void)state;
    score_subject subject = {with_planted_error, NULL, NULL, 0.0, (double)INFINITY};
    score_result r;
    score_run(&subject, SCORE_F64, &r);
    assert_int_equal(r.points, SCORE_LAMBDAS * SCORE_ANGLES);
    assert_int_equal(r.not_finite, 0);
    assert_true(fabs(r.max_abs - 0.01) < 1e-12);
    assert_true(r.max_abs_beta == 0.0 || r.max_abs_beta == pi);
    double sum = 0.0;
    for (size_t j = 0; j < SCORE_ANGLES; j++)
        sum += pow(0.01 * pow(cos(score_beta(j)), 2.0), 2.0);
    assert_true(fabs(r.rmse - sqrt(sum / SCORE_ANGLES)) < 1e-12);
    /* error/truth is largest where the truth just passes the bound */
    assert_true(r.max_rel_1e_2 > 0.1 && r.max_rel_1e_2 < 1.0);
    assert_true(r.max_rel_1e_4 > r.max_rel_1e_2 && r.max_rel_1e_4 < 100.0);
}

static void a_result_that_is_not_finite_is_an_infinite_error_at_its_first_place(void **state)
{
    (void)state;
    double from = 50.0;
    score_subject subject = {with_one_defect, exact, &from, 0.0, (double)INFINITY};
    score_result r;
    score_run(&subject, SCORE_F64, &r);
    size_t first = 0;
    while (score_lambda(first) <= from)
        first++;
    size_t angle = 0;
    while (cos(score_beta(angle)) >= -0.5)
        angle++;
    assert_true(isinf(r.max_abs) && isinf(r.rmse) && isinf(r.rounding));
    assert_true(r.max_abs_lambda == score_lambda(first));
    assert_true(r.max_abs_beta == score_beta(angle));
    assert_int_equal(r.not_finite, (SCORE_LAMBDAS - first) * (SCORE_ANGLES - angle));
    score_row rows[SCORE_LAMBDAS];
    score_rows(&subject, SCORE_F64, rows);
    assert_true(rows[first - 1].max_abs < 1e-13 && isinf(rows[first].max_abs));
}

static void only_the_declared_domain_counts(void **state)
{
    (void)state;
    double from = 50.0;
    score_subject subject = {with_one_defect, NULL, &from, 1.0, 50.0};
    score_result r;
    score_run(&subject, SCORE_F64, &r);
    size_t inside = 0;
    for (size_t i = 0; i < SCORE_LAMBDAS; i++)
        inside += score_lambda(i) >= 1.0 && score_lambda(i) <= 50.0;
    assert_int_equal(r.points, inside * SCORE_ANGLES);
    assert_true(r.max_abs < 1e-13);
    /* 1 lies on the grid: a method that is declared from there on is measured there */
    assert_true(score_lambda(171) == 1.0);
    subject.lambda_min = 2e4;
    subject.lambda_max = 3e4;
    score_run(&subject, SCORE_F64, &r);
    assert_int_equal(r.points, 0);
    assert_true(isnan(r.max_abs) && isnan(r.rmse));
}

static void rounding_of_arguments_is_not_counted(void **state)
{
    (void)state;
    score_subject subject = {in_float, exact, NULL, 0.0, (double)INFINITY};
    score_result r;
    score_run(&subject, SCORE_F32, &r);
    assert_true(r.max_abs > 1e-9 && r.max_abs <= ldexp(1.0, -25)); /* half a unit below 1 */
    assert_true(r.rounding <= r.max_abs + 1e-15 && r.rounding > 0.0);
    subject.value = exact;
    score_run(&subject, SCORE_F16, &r);
    assert_true(r.max_abs < 1e-13);
}

static void half_rounds_as_ieee_does(void **state)
{
    (void)state;
    const double pairs[][2] = {{1.0, 1.0},
                               {0.1, 0.0999755859375},
                               {65504.0, 65504.0},
                               {65519.0, 65504.0},
                               {-65520.0, (double)-INFINITY},
                               {5.9604644775390625e-8, 5.9604644775390625e-8},
                               {2.9e-8, 0.0},
                               {1.00048828125, 1.0}, /* halfway: to even */
                               {1.00146484375, 1.001953125}};
    for (size_t i = 0; i < sizeof pairs / sizeof *pairs; i++)
        assert_true(score_rounded(SCORE_F16, pairs[i][0]) == pairs[i][1]);
    assert_true(isnan(score_rounded(SCORE_F16, (double)NAN)));
    assert_true(score_rounded(SCORE_F32, 0.1) == (double)0.1f);
    assert_true(score_rounded(SCORE_F64, 0.1) == 0.1);
}

/* Measured once by other code than this project's, to the digits given. */
static const struct {
    const char *id;
    double max_abs, lambda, beta, rmse;
} known[] = {{"constant_cosine", 0.750, 1e-3, 0.0, 0.256},
             {"tokuyoshi_2016", 0.153, 1e4, 0.86, 0.0537},
             {"wang_2009", 0.170, 1e4, 0.0, 0.0492},
             {"pettineo_hill_2016", 0.0367, (double)NAN, (double)NAN, 5.3e-3},
             {"meder_2018", 5.28e-3, 2.34, 1.5708, 7.98e-4},
             {"tokuyoshi_2022", 3.69e-3, 5.91, 0.95, 5.57e-4},
             {"tokuyoshi_2024", 1.28e-3, 5.91, 2.26, 1.94e-4}};

static void assert_near(double value, double expected, double relative)
{
    if (!(fabs(value - expected) <= relative * fabs(expected) + 1e-12))
        fail_msg("%.6g instead of %.6g", value, expected);
}

static void published_methods_score_as_known(void **state)
{
    (void)state;
    for (size_t i = 0; i < sizeof known / sizeof *known; i++) {
        const sg_method *method = sg_method_find(known[i].id);
        assert_non_null(method);
        score_result r;
        score_method(method, SCORE_F64, &r);
        assert_near(r.max_abs, known[i].max_abs, 5e-3);
        assert_near(r.rmse, known[i].rmse, 5e-3);
        if (!isnan(known[i].lambda))
            assert_near(r.max_abs_lambda, known[i].lambda, 5e-3);
        if (!isnan(known[i].beta))
            assert_near(r.max_abs_beta, known[i].beta, 1e-2);
    }
}

static void a_form_with_a_methods_coefficients_scores_as_the_method(void **state)
{
    (void)state;
    for (size_t i = 0; i < sg_method_count(); i++) {
        const sg_method *m = sg_method_at(i);
        score_result a, b;
        score_method(m, SCORE_F64, &a);
        score_form(m->form, m->coefficients, m->lambda_min, m->lambda_max, SCORE_F64, &b);
        assert_int_equal(a.points, b.points);
        assert_near(b.max_abs, a.max_abs, 1e-9);
        assert_near(b.rmse, a.rmse, 1e-9);
    }
}

/* The poster's constant for meder_2018_hg: what known code measured with it. */
static void a_changed_coefficient_changes_the_score(void **state)
{
    (void)state;
    const sg_method *m = sg_method_find("meder_2018_hg");
    assert_non_null(m);
    double k[16];
    assert_in_range(m->form->coefficient_count, 1, 16);
    memcpy(k, m->coefficients, (size_t)m->form->coefficient_count * sizeof *k);
    for (int i = 0; i < m->form->coefficient_count; i++)
        if (strcmp(m->form->coefficient_names[i], "cosine_offset") == 0)
            k[i] = 31.703;
    score_result r;
    score_form(m->form, k, m->lambda_min, m->lambda_max, SCORE_F64, &r);
    assert_near(r.max_abs, 1.35e-2, 5e-3);
    assert_near(r.max_abs_lambda, 10.4, 5e-3);
    assert_near(r.max_abs_beta, 1.13, 1e-2);
    assert_near(r.rmse, 3.6e-3, 1e-2);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_planted_error_is_found_at_its_place),
        cmocka_unit_test(a_result_that_is_not_finite_is_an_infinite_error_at_its_first_place),
        cmocka_unit_test(only_the_declared_domain_counts),
        cmocka_unit_test(rounding_of_arguments_is_not_counted),
        cmocka_unit_test(half_rounds_as_ieee_does),
        cmocka_unit_test(published_methods_score_as_known),
        cmocka_unit_test(a_form_with_a_methods_coefficients_scores_as_the_method),
        cmocka_unit_test(a_changed_coefficient_changes_the_score),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
