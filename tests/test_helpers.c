/* The helper texts of shaders/forms/helpers as float compiles them, against the C library in
 * double: the accuracy that the forms build on, which no test of a method shows alone. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

#include <cmocka.h>

#define SG_PRECISION 32
#include "lib/sg/real.h"

#include "lib/sg/methods.h"

#include "tables/out/forms.inc"

static void expm1_keeps_its_relative_error(void **state)
{
    (void)state;
    double worst = 0;
    for (int i = -400; i <= 400; i++) {
        for (int sign = -1; sign <= 1; sign += 2) {
            float x = (float)sign * powf(10, 0.0475f * (float)i / 10);
            if (x > 80 || fabsf(x) < 1e-35f)
                continue;
            worst = fmax(worst, fabs((double)sg_expm1_f32(x) / expm1((double)x) - 1));
        }
    }
    print_message("expm1: relative %.2e\n", worst);
    assert_true(worst < 2.5e-7);
    assert_true(sg_expm1_f32(0) == 0);
    assert_true(sg_expm1_f32(-INFINITY) == -1);
}

static void erf_and_erfc_are_accurate_to_float(void **state)
{
    (void)state;
    double erf_worst = 0, small = 0, tail = 0, absolute = 0;
    for (int i = -9000; i <= 9000; i++) {
        float x = (float)i / 1000;
        double d = (double)x, e = erf(d), c = erfc(d);
        erf_worst = fmax(erf_worst, fabs((double)sg_erf_f32(x) - e));
        absolute = fmax(absolute, fabs((double)sg_erfc_f32(x) - c));
        /* x^2 rounds by 6e-8 of itself, and that is an error of the exponent */
        tail = fmax(tail, fabs((double)sg_erfc_f32(x) / c - 1) / (1 + fmax(0, d) * d));
        if (i != 0)
            small = fmax(small, fabs((double)sg_erf_f32(x * 1e-6f) / erf((double)(x * 1e-6f)) - 1));
    }
    print_message("erf: absolute %.2e, relative next to 0 %.2e\n", erf_worst, small);
    print_message("erfc: absolute %.2e, relative %.2e times 1 + x^2\n", absolute, tail);
    assert_true(erf_worst < 1.2e-7);
    assert_true(small < 2e-7);
    assert_true(absolute < 1.8e-7); /* an ulp and a half of values in [1, 2] */
    assert_true(tail < 2.5e-7);
    assert_true(sg_erf_f32(INFINITY) == 1 && sg_erf_f32(-INFINITY) == -1 && sg_erf_f32(0) == 0);
    assert_true(sg_erfc_f32(INFINITY) == 0 && sg_erfc_f32(-INFINITY) == 2);
    assert_true(isnan(sg_erf_f32(NAN)) && isnan(sg_erfc_f32(NAN)) && isnan(sg_expm1_f32(NAN)));
}

static void integrals_keep_their_relative_error(void **state)
{
    (void)state;
    double area = 0, mean = 0, pole = 0;
    for (int i = -300; i <= 300; i++) {
        float lambda = powf(10, (float)i / 10);
        double l = (double)lambda, L_b = sg_A_b(l) / sg_A(l);
        area = fmax(area, fabs((double)sg_integral_f32(lambda) / sg_A(l) - 1));
        mean = fmax(mean, fabs((double)sg_mean_f32(lambda) / sg_mean_from_sharpness(l) - 1));
        pole = fmax(pole, fabs((double)sg_L_b_f32(lambda) - L_b));
    }
    print_message("A: relative %.2e; mean: relative %.2e; L_b: absolute %.2e\n", area, mean, pole);
    assert_true(area < 4e-7);
    assert_true(mean < 1e-6);
    assert_true(pole < 1e-7);
    assert_true(fabs((double)sg_integral_f32(0) - 12.566370614359172) < 1e-6);
    assert_true(sg_mean_f32(0) == 0 && sg_L_b_f32(0) == 0.25f);
    assert_true(sg_integral_f32(INFINITY) == 0 && sg_mean_f32(INFINITY) == 1);
}

static void lobe_cores_do_not_cancel(void **state)
{
    (void)state;
    /* axes 1e-3 apart, one lobe a million times as sharp as the other */
    float apart = 1e-6f, a = 1e7f, b = 10;
    double la = (double)a, lb = (double)b, q = (double)apart;
    double sharpness = sqrt((la - lb) * (la - lb) + la * lb * (4 - q));
    float found = sg_product_sharpness_f32(a, b, 4 - apart);
    assert_true(fabs((double)found / sharpness - 1) < 3e-7);
    double loss = -la * lb * q / (la + lb + sharpness);
    assert_true(fabs((double)sg_product_log_amplitude_f32(a, b, found, apart) / loss - 1) < 5e-7);
    /* opposite axes: the difference of the sharpnesses, all of it */
    assert_true(sg_product_sharpness_f32(3, 3, 0) == 0);
    assert_true(fabsf(sg_product_sharpness_f32(3.0001f, 3, 0) - (3.0001f - 3)) < 1e-9f);
    assert_true(sg_product_sharpness_f32(0, 0, 4) == 0);
    assert_true(sg_product_log_amplitude_f32(0, 0, 0, 4) == 0);
    assert_true(isfinite(sg_product_sharpness_f32(1e37f, 1e37f, 4)));
    /* next to the axis of a sharp lobe */
    assert_true(fabs((double)sg_evaluate_near_f32(1e7f, 1e-8f) - exp(-0.05)) < 1e-6);
    assert_true(sg_evaluate_f32(5, 1) == 1);
    assert_true(fabs((double)sg_evaluate_f32(5, -1) - exp(-10)) < 1e-10);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(expm1_keeps_its_relative_error),
        cmocka_unit_test(erf_and_erfc_are_accurate_to_float),
        cmocka_unit_test(integrals_keep_their_relative_error),
        cmocka_unit_test(lobe_cores_do_not_cancel),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
