/* The textbook routes: right where they are known to be right, wrong where they are known to fail,
 * and honest or not about it. A route that is repaired by accident fails here: it is kept to show
 * what goes wrong without care. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include <cmocka.h>

#include "sg.h"

static const double pi = 3.14159265358979312;

typedef struct outcome {
    double error;   /* relative */
    double claimed; /* relative */
    sg_quadrature raw;
} outcome;

static outcome run(const char *id, double lambda, double beta)
{
    const sg_route *route = sg_route_find(id);
    assert_non_null(route);
    outcome o;
    sg_status status = route->A_h(lambda, beta, &o.raw);
    assert_true(status == SG_OK || status == SG_NO_CONVERGENCE);
    double truth = sg_A_h(lambda, beta);
    o.error = fabs(o.raw.value - truth) / truth;
    o.claimed = o.raw.claimed_error / truth;
    return o;
}

static void expect(const char *id, double lambda, double beta, double least, double most)
{
    outcome o = run(id, lambda, beta);
    if (!(o.error >= least && o.error <= most))
        fail_msg("%s(%g, %g): relative error %.3g, expected %.2g to %.2g", id, lambda, beta,
                 o.error, least, most);
}

static void table(void **state)
{
    (void)state;
    static const char *const ids[] = {"gauss_2d_64", "gauss_2d_256", "adaptive_2d",
                                      "bessel_1d",   "ode_forward",  "zonal_harmonics"};
    assert_int_equal(sg_route_count(), 6);
    for (size_t i = 0; i < 6; i++) {
        const sg_route *route = sg_route_at(i);
        assert_string_equal(route->id, ids[i]);
        assert_ptr_equal(sg_route_find(ids[i]), route);
        assert_true(strlen(route->title) > 20);
    }
    assert_null(sg_route_at(6));
    assert_null(sg_route_find("gauss"));
    assert_null(sg_route_find(NULL));
}

/* Broad lobes are easy for all of them. */
static void right_where_easy(void **state)
{
    (void)state;
    static const double lambda[] = {0.0, 1e-300, 1e-5, 0.3, 1.0, 5.0};
    for (size_t r = 0; r < sg_route_count(); r++)
        for (size_t i = 0; i < sizeof lambda / sizeof *lambda; i++)
            for (int k = 0; k <= 8; k++) {
                double beta = k == 8 ? pi : pi * k / 8.0;
                const char *id = sg_route_at(r)->id;
                double most = lambda[i] > 1.0 && strcmp(id, "adaptive_2d") == 0 ? 1e-6 : 1e-9;
                expect(id, lambda[i], beta, 0.0, lambda[i] < 0.5 ? 1e-11 : most);
                /* to rounding: a wrong digit in a node or weight would show */
                if (lambda[i] < 0.5 && strcmp(id, "ode_forward") != 0)
                    expect(id, lambda[i], beta, 0.0, 2e-14);
            }
}

static void fixed_rules_fail_for_sharp_lobes(void **state)
{
    (void)state;
    expect("gauss_2d_64", 100.0, 0.5, 0.0, 1e-12);
    expect("gauss_2d_64", 100.0, 1.2, 1e-6, 1e-4);
    expect("gauss_2d_64", 1e3, 1.2, 1e-3, 0.1);
    expect("gauss_2d_64", 1e4, 1.2, 0.5, 2.0);
    expect("gauss_2d_256", 1e3, 1.2, 0.0, 1e-8);
    expect("gauss_2d_256", 1e4, 1.2, 1e-4, 1e-2);
    expect("gauss_2d_256", 1e5, 1.2, 0.5, 2.0);
    expect("bessel_1d", 100.0, 2.2, 0.0, 1e-13);
    expect("bessel_1d", 1e3, 1.2, 1e-9, 1e-6);
    expect("bessel_1d", 1e4, 1.2, 0.1, 1.0);
    /* and what they claim where no node meets the lobe is as wrong as the value */
    outcome o = run("gauss_2d_64", 1e6, 1.2);
    assert_true(o.error > 0.99 && o.claimed < 1e-100);
}

static void adaptive_misses_the_peak(void **state)
{
    (void)state;
    outcome o = run("adaptive_2d", 1e6, 1.2);
    assert_true(o.raw.value == 0.0 && o.raw.claimed_error == 0.0 && o.error == 1.0);
    o = run("adaptive_2d", 1e4, 1.7);
    assert_true(o.error > 0.5 && o.claimed < 0.1 * o.error);
    /* where it sees the peak it does what it was asked to, and knows it */
    o = run("adaptive_2d", 100.0, 0.5);
    assert_true(o.error <= o.claimed && o.raw.claimed_error <= 1.5e-8);
}

/* Forward from beta = 0 what is left of A_u cos(beta) drowns everything beyond the horizon. */
static void forward_fails_beyond_the_horizon(void **state)
{
    (void)state;
    for (double lambda = 1.0; lambda < 2e4; lambda *= 10.0)
        expect("ode_forward", lambda, 1.2, 0.0, 1e-8);
    expect("ode_forward", 100.0, 2.2, 0.01, 10.0);
    expect("ode_forward", 100.0, pi, 1e20, 1e40);
}

/* Degree 64 is exact for broad lobes; for sharp ones the series of the clamped cosine is cut short,
 * by about what the route claims in front and by everything behind. */
static void harmonics_fail_behind(void **state)
{
    (void)state;
    expect("zonal_harmonics", 30.0, 1.2, 0.0, 1e-13);
    outcome front = run("zonal_harmonics", 1e4, 0.8), behind = run("zonal_harmonics", 1e3, 1.7);
    assert_true(front.error > 1e-6 && front.error < front.claimed && front.claimed < 1e-2);
    assert_true(behind.error > 10.0 && behind.claimed > behind.error);
    expect("zonal_harmonics", 1e300, 0.8, 1e-6, 1e-2);
}

static void domain(void **state)
{
    (void)state;
    static const double bad[][2] = {{-1.0, 1.0},  {NAN, 1.0},  {INFINITY, 1.0},
                                    {1.0, -1e-9}, {1.0, 3.15}, {1.0, NAN}};
    for (size_t r = 0; r < sg_route_count(); r++) {
        sg_quadrature q;
        for (size_t i = 0; i < sizeof bad / sizeof *bad; i++) {
            assert_int_equal(sg_route_at(r)->A_h(bad[i][0], bad[i][1], &q), SG_DOMAIN);
            assert_true(isnan(q.value) && q.evaluations == 0);
        }
        assert_int_equal(sg_route_at(r)->A_h(1.0, 1.0, &q), SG_OK);
        assert_true(q.evaluations > 0 && q.claimed_error >= 0.0);
    }
}

static void status_strings(void **state)
{
    (void)state;
    for (int i = SG_OK; i <= SG_UNKNOWN; i++)
        for (int j = SG_OK; j < i; j++)
            assert_string_not_equal(sg_status_string((sg_status)i), sg_status_string((sg_status)j));
    assert_string_equal(sg_status_string((sg_status)99), "unknown status");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(table),
        cmocka_unit_test(right_where_easy),
        cmocka_unit_test(fixed_rules_fail_for_sharp_lobes),
        cmocka_unit_test(adaptive_misses_the_peak),
        cmocka_unit_test(forward_fails_beyond_the_horizon),
        cmocka_unit_test(harmonics_fail_behind),
        cmocka_unit_test(domain),
        cmocka_unit_test(status_strings),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
