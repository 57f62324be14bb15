/* The tiers have no step, hardly a kink, and rise with the cosine: by the scan that the report
 * shows (bench/smoothness.h). */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include <math.h>
#include <string.h>

#include "bench/smoothness.h"

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
        cmocka_unit_test(tiers_are_smooth_and_rise_with_the_cosine),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
