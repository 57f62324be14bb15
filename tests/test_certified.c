/* The reference against rigorous enclosures of the integrals (FLINT/Arb): it must lie inside them,
 * widened by the error that sg.h states. The enclosures come from the definition, not from the
 * formula of lib/sg. Prints the largest error found of each quantity and where it was. */
#include <float.h>
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

#include <cmocka.h>

#include "fit/certified.h"
#include "sg.h"

static const double pi = 3.14159265358979312, half_pi = 1.57079632679489656;
static uint64_t seed = 20181;

static double uniform(void)
{
    seed = seed * 6364136223846793005u + 1442695040888963407u;
    return (double)(seed >> 11) * 0x1p-53;
}

/* Sharpness logarithmic over everything, over what renderers use, or in between. */
static double any_sharpness(void)
{
    double u = uniform(), kind = uniform();
    return pow(10.0, kind < 0.2   ? -300.0 + 600.0 * u
                     : kind < 0.7 ? -3.0 + 8.0 * u
                                  : -8.0 + 16.0 * u);
}

/* Angles uniform, next to the poles and the horizon down to the last bit, across the width of the
 * lobe around the horizon, through all values down to 1e-250, and where the integral is cut. */
static double any_angle(double lambda)
{
    static const double special[] = {
        0.0, 1e-300, half_pi, 1.5707963267948963, 1.5707963267948968, 3.1415926535897927, pi};
    double u = uniform(), beta = 0.0;
    switch ((int)(8.0 * uniform())) {
    case 0:
        beta = pi * u;
        break;
    case 1:
        beta = half_pi + (uniform() - 0.5) * pow(10.0, -16.0 * u);
        break;
    case 2:
        beta = pow(10.0, -20.0 * u);
        break;
    case 3:
        beta = pi - pow(10.0, -16.0 * u);
        break;
    case 4:
        beta = half_pi + u * sqrt(80.0 / lambda);
        break;
    case 5:
        beta = half_pi + asin(sqrt(fmin(1.0, 1150.0 * u / lambda)));
        break;
    case 6:
        beta = half_pi + asin(1.0 - u * fmin(1.0, 40.0 / lambda));
        break;
    default:
        beta = special[(int)(7.0 * u)];
    }
    return fmax(0.0, fmin(beta, pi));
}

typedef double (*reference)(double lambda, double direction);
typedef bool (*certified)(double lambda, double direction, double *lower, double *upper);

typedef struct quantity {
    const char *name;
    reference value;
    certified enclose;
    bool by_cosine;
    int count;
    bool absolute; /* judged by 1e-12, where all others are relative */
} quantity;

/* Enclosures down to exp(-575), below which sg.h states nothing. */
static bool worth_checking(double lambda, double z)
{
    return z >= 0.0 || lambda * (z * z / (1.0 + sqrt(1.0 - z * z))) < 575.0;
}

static void check(const quantity *q)
{
    double worst = 0.0, worst_lambda = 0.0, worst_direction = 0.0;
    int checked = 0;
    for (int tries = 0; checked < q->count; tries++) {
        assert_true(tries < 10 * q->count);
        double lambda = any_sharpness(), beta = any_angle(lambda), lower, upper;
        double z = cos(beta);
        if (q->by_cosine && uniform() < 0.1)
            z = copysign(pow(10.0, -300.0 * uniform()), uniform() - 0.5);
        double direction = q->by_cosine ? z : beta;
        if (!worth_checking(lambda, z))
            continue;
        /* c and s have no enclosure where their definitions leave nothing, see certified.h */
        if (!q->enclose(lambda, direction, &lower, &upper)) {
            assert_true(q->enclose == sgfit_certified_c || q->enclose == sgfit_certified_c_cos ||
                        q->absolute);
            continue;
        }
        if (lower < 1e-250)
            continue;
        double value = q->value(lambda, direction);
        double scale = q->absolute ? 1.0 : lower;
        double stated = q->absolute ? 1e-12 : lower > 1e-20 ? 2e-14 : 2e-13;
        double error = fmax(0.0, fmax(lower - value, value - upper)) / scale;
        if (!(error <= stated))
            fail_msg("%s(%.17g, %.17g) = %.17g is %.2g outside of [%.17g, %.17g]", q->name, lambda,
                     direction, value, error, lower, upper);
        if (error > worst)
            worst = error, worst_lambda = lambda, worst_direction = direction;
        checked++;
    }
    print_message("%-7s %4d enclosures, outside by at most %.2e at (%.17g, %.17g)\n", q->name,
                  checked, worst, worst_lambda, worst_direction);
}

static void A_h_and_H(void **state)
{
    (void)state;
    static const quantity all[] = {
        {"A_h", sg_A_h, sgfit_certified_A_h, false, 1000, false},
        {"A_h_cos", sg_A_h_cos, sgfit_certified_A_h_cos, true, 200, false},
        {"H", sg_H, sgfit_certified_H, false, 1000, false},
        {"H_cos", sg_H_cos, sgfit_certified_H_cos, true, 200, false},
    };
    for (size_t i = 0; i < sizeof all / sizeof *all; i++)
        check(&all[i]);
}

static void what_follows_from_them(void **state)
{
    (void)state;
    static const quantity all[] = {
        {"L", sg_L, sgfit_certified_L, false, 60, false},
        {"L_cos", sg_L_cos, sgfit_certified_L_cos, true, 60, false},
        {"c", sg_c, sgfit_certified_c, false, 60, false},
        {"c_cos", sg_c_cos, sgfit_certified_c_cos, true, 60, false},
        {"s", sg_s, sgfit_certified_s, false, 60, true},
        {"s_cos", sg_s_cos, sgfit_certified_s_cos, true, 60, true},
    };
    for (size_t i = 0; i < sizeof all / sizeof *all; i++)
        check(&all[i]);
}

/* The enclosures themselves: tight, and around values that are known exactly. */
static void enclosures(void **state)
{
    (void)state;
    double lower, upper;
    assert_true(sgfit_certified_A_h(0.0, 1.0, &lower, &upper));
    assert_true(lower <= pi && nextafter(pi, 4.0) >= upper && lower < upper);
    assert_true(sgfit_certified_L_cos(0.0, 0.3, &lower, &upper));
    assert_true(lower <= 0.25 && 0.25 <= upper && upper - lower < 1e-15);
    /* half of A, 2 pi (1 - e^-2)/1 = 5.43285... */
    assert_true(sgfit_certified_H_cos(1.0, 0.0, &lower, &upper));
    double half = pi * -expm1(-2.0);
    assert_true(fabs(lower - half) < 1e-15 && fabs(upper - half) < 1e-15 && lower < upper);
    for (double lambda = 1e-30; lambda < 1e30; lambda *= 1e4) {
        assert_true(sgfit_certified_A_h_cos(lambda, 1.0, &lower, &upper));
        assert_true(lower <= sg_A_u(lambda) * (1.0 + 1e-15) &&
                    upper >= sg_A_u(lambda) * (1.0 - 1e-15));
        assert_true(upper <= lower * (1.0 + 3.0 * DBL_EPSILON));
    }
    /* where c and s read 0/0 in any precision within reach, bounds that hold all the same */
    assert_false(sgfit_certified_c_cos(1e-70, -0.5, &lower, &upper));
    assert_true(lower >= 0.0 && upper <= 1.0 && lower <= sg_c_cos(1e-70, -0.5) &&
                sg_c_cos(1e-70, -0.5) <= upper);
    assert_false(sgfit_certified_s_cos(1e-70, -0.5, &lower, &upper));
    assert_true(lower >= 0.0 && upper <= 2.0 && lower <= sg_s_cos(1e-70, -0.5) &&
                sg_s_cos(1e-70, -0.5) <= upper);
    assert_false(sgfit_certified_A_h(-1.0, 1.0, &lower, &upper));
    assert_false(sgfit_certified_A_h(1.0, 3.2, &lower, &upper));
    assert_false(sgfit_certified_H_cos(1.0, 1.0000001, &lower, &upper));
    assert_false(sgfit_certified_H(INFINITY, 1.0, &lower, &upper));
    assert_false(sgfit_certified_A_h_cos(1.0, NAN, &lower, &upper));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(enclosures),
        cmocka_unit_test(A_h_and_H),
        cmocka_unit_test(what_follows_from_them),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
