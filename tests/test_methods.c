/* The registry: records complete, forms and methods agree, batches give what single calls give. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>
#include <time.h>

#include <cmocka.h>

#include "sg.h"

static void test_records_are_complete(void **state)
{
    (void)state;
    static const char *const variants[] = {"published", "stable", "refit", "tier"};
    assert_true(sg_method_count() >= 8); /* the published ones */
    for (size_t i = 0; i < sg_method_count(); i++) {
        const sg_method *method = sg_method_at(i);
        assert_ptr_equal(sg_method_find(method->id), method);
        assert_true(strlen(method->title) > 0 && strlen(method->source) > 0);
        assert_in_range(method->year, 2000, 2100);
        size_t variant = 0;
        while (variant < 4 && strcmp(variants[variant], method->variant) != 0)
            variant++;
        assert_true(variant < 4);
        assert_true(method->lambda_min >= 0 && method->lambda_min < method->lambda_max);
        assert_ptr_equal(sg_form_find(method->form->id), method->form);
        assert_non_null(method->coefficients);
        assert_true((method->A_h_f16 == NULL) == (method->form->f16 == NULL));
        assert_true((method->L_f16 == NULL) == (method->form->f16 == NULL));
    }
}

static void test_unknown_names_are_not_found(void **state)
{
    (void)state;
    assert_null(sg_method_find("no_such_method"));
    assert_null(sg_method_find(""));
    assert_null(sg_method_find(NULL));
    assert_null(sg_method_at(sg_method_count()));
    assert_null(sg_form_find("no_such_form"));
    assert_null(sg_form_find(NULL));
    assert_null(sg_form_at(sg_form_count()));
}

static void test_forms_name_their_coefficients(void **state)
{
    (void)state;
    for (size_t i = 0; i < sg_form_count(); i++) {
        const sg_form *form = sg_form_at(i);
        assert_ptr_equal(sg_form_find(form->id), form);
        for (int j = 0; j < form->coefficient_count; j++) {
            assert_true(strlen(form->coefficient_names[j]) > 0);
            for (int k = 0; k < j; k++)
                assert_string_not_equal(form->coefficient_names[j], form->coefficient_names[k]);
        }
    }
}

/* One text: the form with the method's coefficients is the method, to the bit. */
static void test_a_method_is_its_form_with_its_coefficients(void **state)
{
    (void)state;
    for (size_t i = 0; i < sg_method_count(); i++) {
        const sg_method *method = sg_method_at(i);
        const sg_form *form = method->form;
        float coefficients[64];
        assert_true(form->coefficient_count <= 64);
        for (int j = 0; j < form->coefficient_count; j++)
            coefficients[j] = (float)method->coefficients[j];
        for (double lambda = 0.011; lambda < 2000; lambda *= 3) {
            for (double z = -1; z <= 1; z += 0.25) {
                bool L = form->native == SG_L;
                double f64 = (L ? method->L_f64 : method->A_h_f64)(lambda, z);
                float f32 = (L ? method->L_f32 : method->A_h_f32)((float)lambda, (float)z);
                double from_form = form->f64(lambda, z, method->coefficients);
                float from_form_f32 = form->f32((float)lambda, (float)z, coefficients);
                assert_memory_equal(&f64, &from_form, sizeof f64);
                /* published texts may be NaN in float, whose sign bit nothing defines */
                assert_true(f32 == from_form_f32 || (isnan(f32) && isnan(from_form_f32)));
                if (form->f16) {
                    float f16 = (L ? method->L_f16 : method->A_h_f16)((float)lambda, (float)z);
                    float again = form->f16((float)lambda, (float)z, coefficients);
                    assert_true(f16 == again || (isnan(f16) && isnan(again)));
                }
            }
        }
    }
}

/* A half has 11 significant bits: what half returns must survive being cut to them. */
static void test_half_returns_halves(void **state)
{
    (void)state;
    size_t different = 0;
    for (size_t i = 0; i < sg_method_count(); i++) {
        const sg_method *method = sg_method_at(i);
        if (!method->L_f16)
            skip();
        for (float lambda = 1; lambda < 100; lambda *= 1.7F) {
            float value = method->L_f16(lambda, 0.4F);
            int exponent;
            float fraction = frexpf(value, &exponent);
            assert_true(!isfinite(value) || fabsf(value) < 6.1e-5F ||
                        rintf(fraction * 2048) == fraction * 2048);
            different += fabsf(value - method->L_f32(lambda, 0.4F)) > 1e-5F;
        }
    }
    assert_true(different > 0); /* it is not float's result rounded once */
}

enum { POINTS = 1000 };

static void make_points(double *lambda, double *cos_theta)
{
    for (int i = 0; i < POINTS; i++) {
        lambda[i] = pow(10, -3 + 7.0 * ((i * 389) % POINTS) / (POINTS - 1));
        cos_theta[i] = -1 + 2.0 * i / (POINTS - 1);
    }
}

/* In L the vector functions differ from the scalar ones by units in the last place. Published
 * texts may cancel, which multiplies that: theirs are wider bounds. */
static void test_batches_are_single_calls(void **state)
{
    (void)state;
    static double lambda[POINTS], z[POINTS], A_h[POINTS], L[POINTS];
    static float lambda_f[POINTS], z_f[POINTS], A_h_f[POINTS], L_f[POINTS];
    make_points(lambda, z);
    for (int i = 0; i < POINTS; i++) {
        lambda_f[i] = (float)lambda[i];
        z_f[i] = (float)z[i];
    }
    for (size_t m = 0; m < sg_method_count(); m++) {
        const sg_method *method = sg_method_at(m);
        bool published = strcmp(method->variant, "published") == 0;
        double bound = published ? 1e-9 : 1e-14, bound_f = published ? 2e-3 : 1e-6;
        double worst = 0, worst_f = 0;
        method->A_h_batch_f64(POINTS, lambda, z, A_h);
        method->L_batch_f64(POINTS, lambda, z, L);
        method->A_h_batch_f32(POINTS, lambda_f, z_f, A_h_f);
        method->L_batch_f32(POINTS, lambda_f, z_f, L_f);
        for (int i = 0; i < POINTS; i++) {
            double single = method->L_f64(lambda[i], z[i]);
            double area = sg_A(lambda[i]);
            float single_f = method->L_f32(lambda_f[i], z_f[i]);
            float single_A_h = method->A_h_f32(lambda_f[i], z_f[i]);
            assert_true(isfinite(single) == isfinite(L[i]));
            assert_true(isfinite(single_f) == isfinite(L_f[i]));
            if (isfinite(single))
                worst = fmax(worst, fmax(fabs(L[i] - single),
                                         fabs(A_h[i] - method->A_h_f64(lambda[i], z[i])) / area));
            if (isfinite(single_f))
                worst_f = fmax(worst_f, fmax(fabs((double)L_f[i] - (double)single_f),
                                             fabs((double)A_h_f[i] - (double)single_A_h) / area));
        }
        print_message("%-28s double %.1e, float %.1e\n", method->id, worst, worst_f);
        assert_true(worst <= bound);
        assert_true(worst_f <= bound_f);
    }
}

/* Any count and any alignment: nothing before or behind the output is touched. */
static void test_batches_of_every_length(void **state)
{
    (void)state;
    enum { LONGEST = 70, MARGIN = 3 };
    double lambda[LONGEST + MARGIN], z[LONGEST + MARGIN], out[LONGEST + 2 * MARGIN];
    for (int i = 0; i < LONGEST + MARGIN; i++) {
        lambda[i] = 0.5 + i;
        z[i] = 0.9 - 0.02 * i;
    }
    const sg_method *method = sg_method_at(0);
    for (size_t n = 0; n <= LONGEST; n++) {
        for (size_t shift = 0; shift < MARGIN; shift++) {
            for (size_t i = 0; i < LONGEST + 2 * MARGIN; i++)
                out[i] = -7;
            method->L_batch_f64(n, lambda + shift, z + shift, out + shift + 1);
            for (size_t i = 0; i < LONGEST + 2 * MARGIN; i++) {
                if (i < shift + 1 || i >= shift + 1 + n)
                    assert_true(out[i] == -7);
                else
                    assert_true(fabs(out[i] - method->L_f64(lambda[i - 1], z[i - 1])) < 1e-13);
            }
        }
    }
}

#if defined(__x86_64__) && defined(__GLIBC__) && !defined(__clang__) && defined(__OPTIMIZE__) &&   \
    !defined(__SANITIZE_ADDRESS__)
/* Nanoseconds of the fastest of many runs, which other load on the machine hardly touches. */
static double fastest(const sg_method *method, bool batch, const float *lambda, const float *z,
                      float *out)
{
    double best = 1e9;
    for (int run = 0; run < 60; run++) {
        struct timespec from, to;
        clock_gettime(CLOCK_MONOTONIC, &from);
        if (batch) {
            method->L_batch_f32(POINTS, lambda, z, out);
        } else {
            for (int i = 0; i < POINTS; i++)
                out[i] = method->L_f32(lambda[i], z[i]);
        }
        clock_gettime(CLOCK_MONOTONIC, &to);
        best = fmin(best,
                    1e9 * (double)(to.tv_sec - from.tv_sec) + (double)(to.tv_nsec - from.tv_nsec));
    }
    return best;
}

/* Over sharp lobes too, where exponentials vanish: there the vector functions must not be left. */
static void test_batches_are_faster(void **state)
{
    (void)state;
    static double lambda[POINTS], z[POINTS];
    static float lambda_f[POINTS], z_f[POINTS], out[POINTS];
    double single = 0, batch = 0;
    make_points(lambda, z);
    for (int i = 0; i < POINTS; i++) {
        lambda_f[i] = (float)lambda[i];
        z_f[i] = (float)z[i];
    }
    for (size_t m = 0; m < sg_method_count(); m++) {
        if (strcmp(sg_method_at(m)->variant, "published") == 0)
            continue;
        single += fastest(sg_method_at(m), false, lambda_f, z_f, out);
        batch += fastest(sg_method_at(m), true, lambda_f, z_f, out);
    }
    print_message("in batches %.1f times as fast\n", single / batch);
    assert_true(single > 2 * batch);
}
#else
static void test_batches_are_faster(void **state)
{
    (void)state;
    skip(); /* no vector functions, or slowed by the sanitizer */
}
#endif

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_records_are_complete),
        cmocka_unit_test(test_unknown_names_are_not_found),
        cmocka_unit_test(test_forms_name_their_coefficients),
        cmocka_unit_test(test_a_method_is_its_form_with_its_coefficients),
        cmocka_unit_test(test_half_returns_halves),
        cmocka_unit_test(test_batches_are_single_calls),
        cmocka_unit_test(test_batches_of_every_length),
        cmocka_unit_test(test_batches_are_faster),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
