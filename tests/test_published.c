/* The published approximations: that the registry's are those of the papers, that their errors are
 * the ones that this project's notes give, that float does to them what is said of it, and that
 * the stable variants are the same models. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include <cmocka.h>

#include "fit/score.h"
#include "published_formulas.h"
#include "sg.h"

static const double pi = 3.14159265358979323846;

static const sg_method *method(const char *id)
{
    const sg_method *found = sg_method_find(id);
    if (!found)
        fail_msg("no method %s", id);
    return found;
}

static const sg_method *stable(const char *id)
{
    char name[64];
    snprintf(name, sizeof name, "%s_stable", id);
    return method(name);
}

/* Errors of L on the common grid, three digits. The row of meder_2018_hg is that of the offset
 * 31.7003; 31.703 has its own test below. */
static void errors_are_the_known_ones(void **state)
{
    (void)state;
    static const struct {
        const char *id;
        double max_abs, lambda, beta, rmse;
    } rows[] = {{"constant_cosine", 0.750, 1e-3, 0, 0.256},
                {"tokuyoshi_2016", 0.153, 1e4, 0.86, 0.0537},
                {"wang_2009", 0.170, 1e4, 0, 0.0492},
                {"pettineo_hill_2016", 0.0367, 1.27, 0, 5.28e-3},
                {"meder_2018", 5.28e-3, 2.34, pi / 2, 7.98e-4},
                {"meder_2018_hg", 1.108e-2, 10.0, 1.12, 2.974e-3},
                {"tokuyoshi_2022", 3.69e-3, 5.91, 0.95, 5.57e-4},
                {"tokuyoshi_2024", 1.28e-3, 5.91, 2.26, 1.94e-4}};
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        score_result found;
        score_method(method(rows[i].id), SCORE_F64, &found);
        print_message("%-20s max %.4g at (%.4g, %.4g), RMSE %.4g\n", rows[i].id, found.max_abs,
                      found.max_abs_lambda, found.max_abs_beta, found.rmse);
        assert_int_equal(found.not_finite, 0);
        assert_true(fabs(found.max_abs / rows[i].max_abs - 1) < 5e-3);
        assert_true(fabs(found.rmse / rows[i].rmse - 1) < 5e-3);
        assert_true(fabs(found.max_abs_lambda / rows[i].lambda - 1) < 0.01);
        /* where the error is in the even part of L, it is the same at z and -z but for rounding */
        double beta = found.max_abs_beta;
        assert_true(fabs(beta - rows[i].beta) < 0.01 || fabs(pi - beta - rows[i].beta) < 0.01);
    }
}

static void another_offset_costs_accuracy(void **state)
{
    (void)state;
    const sg_form *form = method("meder_2018_hg")->form;
    double coefficients[16];
    int offset = -1;
    for (int i = 0; i < form->coefficient_count; i++) {
        coefficients[i] = method("meder_2018_hg")->coefficients[i];
        if (strcmp(form->coefficient_names[i], "cosine_offset") == 0)
            offset = i;
    }
    assert_true(offset >= 0);
    assert_true(coefficients[offset] == 31.7003);
    coefficients[offset] = 31.703;
    score_result found;
    score_form(form, coefficients, 0, INFINITY, SCORE_F64, &found);
    print_message("meder_2018_hg with 31.703: max %.4g at (%.4g, %.4g), RMSE %.4g\n", found.max_abs,
                  found.max_abs_lambda, found.max_abs_beta, found.rmse);
    assert_true(fabs(found.max_abs / 1.353e-2 - 1) < 5e-3);
    assert_true(fabs(found.rmse / 3.584e-3 - 1) < 5e-3);
}

/* Double cancels in some of the published texts; 1e-10 is what that leaves on this range. */
static void published_texts_are_the_published_formulas(void **state)
{
    (void)state;
    for (size_t i = 0; i < published_formula_count; i++) {
        const published_formula *formula = &published_formulas[i];
        double worst = 0;
        for (int a = 0; a <= 140; a++) {
            double lambda = pow(10, -3 + 0.05 * a);
            if ((long double)lambda < formula->lambda_min)
                continue;
            for (int b = 0; b <= 100; b++) {
                double z = cos(pi * b / 100);
                double found = method(formula->id)->L_f64(lambda, z);
                double error = fabs(found - (double)formula->L((long double)lambda, z));
                if (!(error < 1e-10))
                    fail_msg("%s(%.17g, %.17g) = %.17g", formula->id, lambda, z, found);
                worst = fmax(worst, error);
            }
        }
        print_message("%-20s differs by %.1e at most\n", formula->id, worst);
    }
}

static void stable_variants_are_the_same_models(void **state)
{
    (void)state;
    for (size_t i = 0; i < published_formula_count; i++) {
        const published_formula *formula = &published_formulas[i];
        const sg_method *variant = stable(formula->id);
        double worst = 0;
        for (int a = 0; a <= 320; a++) {
            double lambda = pow(10, -6 + 0.05 * a);
            if ((long double)lambda < formula->lambda_min)
                continue;
            for (int b = 0; b <= 200; b++) {
                /* every other direction next to the horizon, in units of the lobe's width */
                double z = cos(pi * b / 200) / (b % 2 ? 1 + sqrt(lambda) : 1);
                /* cut where the model leaves what the integral can be */
                double expected = fmin(fmax((double)formula->L((long double)lambda, z), 0), 1);
                double error = fabs(variant->L_f64(lambda, z) - expected);
                if (!(error < 1e-9))
                    fail_msg("%s(%.17g, %.17g) is off by %g", variant->id, lambda, z, error);
                worst = fmax(worst, error);
            }
        }
        print_message("%-28s differs by %.1e at most\n", variant->id, worst);
    }
}

static void derived_coefficients_are_derived(void **state)
{
    (void)state;
    const sg_method *hg = stable("meder_2018_hg"), *erf_2022 = method("tokuyoshi_2022");
    double scale = 32.708 * exp(-0.0315);
    assert_true(hg->coefficients[0] == 0.0315);
    assert_true(fabs(hg->coefficients[1] - scale) < 1e-14 * scale);
    assert_true(fabs(hg->coefficients[2] - (scale - 31.7003)) < 1e-13);
    double c = erf_2022->coefficients[0];
    double rest = c * c * (0.5 + c / 6 + c * c / 24 + c * c * c / 120); /* e^c - 1 - c */
    assert_true(fabs(erf_2022->coefficients[1] / (0.5 * c / rest) - 1) < 1e-13);
}

static void float_does_what_is_said_of_it(void **state)
{
    (void)state;
    score_result found;
    const sg_method *meder = method("meder_2018");
    assert_true(isfinite(meder->L_f32(88.5f, 0.5f)));
    assert_true(isnan(meder->L_f32(88.8f, 0.5f)));
    double worst = 0; /* A_u cancels: the error jumps from one float to the next */
    for (float lambda = 1e-3f; lambda < 2e-3f; lambda += 1e-6f)
        worst = fmax(worst, fabs((double)meder->L_f32(lambda, 1) - sg_L_cos((double)lambda, 1)));
    print_message("meder_2018 is off by %.3g below 2e-3\n", worst);
    assert_true(worst > 1e-2);
    const sg_method *hg = method("meder_2018_hg");
    assert_true(isnan(hg->L_f32(9e-6f, 0.5f)));
    score_method(hg, SCORE_F32, &found);
    print_message("meder_2018_hg rounds by %.3g at %.4g\n", found.rounding, found.rounding_lambda);
    assert_true(found.rounding > 0.02 && found.rounding < 0.04 && found.rounding_lambda > 1e3);
    score_method(method("tokuyoshi_2022"), SCORE_F32, &found);
    print_message("tokuyoshi_2022 rounds by %.3g\n", found.rounding);
    assert_true(found.rounding > 3e-4 && found.rounding < 6e-4);
    score_method(method("tokuyoshi_2024"), SCORE_F32, &found);
    print_message("tokuyoshi_2024 rounds by %.3g\n", found.rounding);
    assert_true(found.rounding < 3.5e-7);
    const sg_method *hill = method("pettineo_hill_2016");
    assert_true(hill->L_f32(0.6f, 1.0f) > 0.0f);
    assert_true(hill->L_f32(0.56f, 1.0f) < 0.0f);
    static const char *const nan_at_0[] = {"constant_cosine", "pettineo_hill_2016",
                                           "meder_2018",      "meder_2018_hg",
                                           "tokuyoshi_2022",  "tokuyoshi_2024"};
    for (size_t i = 0; i < sizeof nan_at_0 / sizeof nan_at_0[0]; i++) {
        assert_true(isnan(method(nan_at_0[i])->A_h_f64(0, 0.5)));
        assert_true(isnan(method(nan_at_0[i])->A_h_f32(0, 0.5f)));
    }
}

/* Continuous, with a continuous slope, at lambda = 1; exact at 0. */
static void the_continuation_joins(void **state)
{
    (void)state;
    const sg_method *hill = stable("pettineo_hill_2016");
    double worst = 0, worst_lambda = 0, h = 1e-5;
    for (int b = 0; b <= 100; b++) {
        double z = cos(pi * b / 100), at = hill->L_f64(1, z);
        assert_true(fabs(at - (double)published_formulas[3].L(1, z)) < 1e-14);
        double before = (at - hill->L_f64(1 - h, z)) / h, after = (hill->L_f64(1 + h, z) - at) / h;
        assert_true(fabs(before - after) < 1e-4);
        assert_true(hill->L_f64(0, z) == 0.25);
        for (int a = 0; a <= 100; a++) {
            double error = fabs(hill->L_f64(a / 100.0, z) - sg_L_cos(a / 100.0, z));
            worst_lambda = error > worst ? a / 100.0 : worst_lambda;
            worst = fmax(worst, error);
        }
    }
    print_message("continuation: %.3g at %.3g\n", worst, worst_lambda);
    assert_true(worst < 0.02);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(errors_are_the_known_ones),
        cmocka_unit_test(another_offset_costs_accuracy),
        cmocka_unit_test(published_texts_are_the_published_formulas),
        cmocka_unit_test(stable_variants_are_the_same_models),
        cmocka_unit_test(derived_coefficients_are_derived),
        cmocka_unit_test(float_does_what_is_said_of_it),
        cmocka_unit_test(the_continuation_joins),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
