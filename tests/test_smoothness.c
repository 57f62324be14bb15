/* bench/kinks, bench/smoothness: jumps of value and slope are found and measured; the tiers have no
 * step, hardly a kink, and rise with the cosine. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include <math.h>
#include <string.h>

#include "bench/kinks.h"
#include "bench/smoothness.h"

static double with_a_kink(const void *context, double t)
{
    (void)context;
    return sin(3 * t) + (t > 0.3123 ? 1e-4 * (t - 0.3123) : 0) + (t > 0.7 ? 1e-7 : 0) +
           (t > -0.4 ? 1e-3 * (t + 0.4) * (t + 0.4) : 0); /* only the curvature jumps there */
}

static void kinks_and_steps_are_measured(void **state)
{
    (void)state;
    kink found[8];
    size_t n = kinks_find(with_a_kink, NULL, -1, 1, 513, found, 8);
    assert_int_equal(n, 2);
    assert_true(fabs(found[0].at - 0.3123) < 1e-9 && fabs(found[0].slope - 1e-4) < 1e-8);
    assert_true(found[0].step == 0);
    assert_true(fabs(found[1].at - 0.7) < 1e-9 && fabs(found[1].step - 1e-7) < 1e-12);
}

static void smoothness_of_known_methods(void **state)
{
    (void)state;
    smoothness found;
    smoothness_of(sg_method_find("constant_cosine_stable"), &found); /* max(z, 0) */
    assert_true(fabs(found.slope_z.amount - 1) < 1e-6 && fabs(found.slope_z.cos_theta) < 1e-6);
    assert_true(found.slope_lambda.amount == 0 && found.fall.amount == 0);
    smoothness_of(sg_method_find("tokuyoshi_2024_stable"), &found); /* analytic */
    assert_true(found.slope_z.amount == 0 && found.slope_lambda.amount == 0);
    assert_true(found.step.amount == 0);
}

/* The largest jump of a first derivative that a tier may have, and how far L may fall as cos_theta
 * rises. quick, positive and split never touch 0, and have no jump at all; the others pass through
 * it once, far behind a lobe of sharpness about 10 to 20, where L is less than their error. */
static bool is_smooth(const sg_method *method, double most_jump)
{
    smoothness s;
    smoothness_of(method, &s);
    bool good = s.slope_z.amount <= most_jump && s.slope_lambda.amount <= most_jump &&
                s.step.amount == 0 && s.fall.amount <= 1e-8 && s.fall_f32.amount <= 6e-8;
    print_message("%s: dL/dz jumps by %.2g at (%.4g, %.4g), dL/dlambda by %.2g, L by %.2g; L falls "
                  "by %.2g in double, %.2g in float\n",
                  method->id, s.slope_z.amount, s.slope_z.lambda, s.slope_z.cos_theta,
                  s.slope_lambda.amount, s.step.amount, s.fall.amount, s.fall_f32.amount);
    return good;
}

static void tiers_are_smooth_and_rise_with_the_cosine(void **state)
{
    (void)state;
    size_t tiers = 0;
    bool good = true;
    for (size_t m = 0; m < sg_method_count(); m++) {
        const sg_method *method = sg_method_at(m);
        if (strcmp(method->variant, "tier") != 0)
            continue;
        bool none = strcmp(method->id, "quick") == 0 || strcmp(method->id, "positive") == 0 ||
                    strcmp(method->id, "split") == 0;
        good = is_smooth(method, none ? 0 : 1e-3) && good;
        tiers++;
    }
    assert_true(tiers >= 7);
    assert_true(good);
    /* and what has a crease at the terminator, or falls, is seen */
    assert_false(is_smooth(sg_method_find("meder_2018_stable"), 1e-3));
    assert_false(is_smooth(sg_method_find("meder_2018_hg_stable"), (double)INFINITY));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(kinks_and_steps_are_measured),
        cmocka_unit_test(smoothness_of_known_methods),
        cmocka_unit_test(tiers_are_smooth_and_rise_with_the_cosine),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
