/* The reference integral: known values, exact relations, limits, and the ends of the domain. Its
 * accuracy is proven point by point in test_certified.c. */
#include <float.h>
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>

#include <cmocka.h>

#include "sg.h"

static const double pi = 3.14159265358979312; /* the double, below the number */
static const double half_pi = 1.57079632679489656;

/* The stated relative error of a value of this size. */
static double stated(double value)
{
    return value > 1e-20 ? 2e-14 : 2e-13;
}

static void close_to(const char *what, double lambda, double direction, double found,
                     double expected, double relative)
{
    if (!(fabs(found - expected) <= relative * fabs(expected)))
        fail_msg("%s(%.17g, %.17g) = %.17g, expected %.17g within %.2g of it", what, lambda,
                 direction, found, expected, relative);
}

static void known_values(void **state)
{
    (void)state;
    /* lower bounds printed by sgfit eval --certified, which are at most 2.1e-16 below the truth */
    static const struct {
        double lambda, beta, A_h, H;
    } known[] = {
        {1e-300, 1.0, 3.1415926535897931, 6.2831853071795862},
        {1e-08, 3.0, 3.1415926014395126, 6.2831852132462025},
        {0.5, 0.3, 2.6430490225554122, 4.901870471359743},
        {1.0, 1.5707963267948966, 1.3063396669348932, 2.7164243220021569},
        {2.5, 3.1415926535897931, 0.05881281019924918, 0.18936779508333154},
        {10.0, 2.0, 0.0093029897448311371, 0.061640385312150138},
        {40.0, 1.5707963267948966, 0.0098146855920090929, 0.078539816339744842},
        {100.0, 2.2, 3.6426971716148714e-13, 2.2373216208214044e-11},
        {100.0, 3.1, 3.0314130827996734e-46, 3.0309835428932631e-44},
        {1000.0, 1.7, 9.8881227985195519e-10, 1.406337606430263e-07},
        {10000.0, 1.2, 0.00022765332427785364, 0.00062831853071795862},
        {10000.0, 1.7, 9.4164483766601455e-45, 1.2275023081411991e-41},
        {1e6, 1.5707963267948966, 2.5066273346452957e-09, 3.1415926535899466e-06},
        {1e12, 1.5708, 1.8200745062011634e-22, 7.524964891158902e-16},
        {1e30, 1.5707963267948966, 2.7036930516418477e-45, 3.2949835083334798e-30},
    };
    for (size_t i = 0; i < sizeof known / sizeof *known; i++) {
        double lambda = known[i].lambda, beta = known[i].beta;
        close_to("A_h", lambda, beta, sg_A_h(lambda, beta), known[i].A_h, stated(known[i].A_h));
        close_to("H", lambda, beta, sg_H(lambda, beta), known[i].H, stated(known[i].H));
    }
}

/* The closed forms in long double, where that carries them: from lambda = 1 on. */
static void closed_forms(void **state)
{
    (void)state;
    const long double two_pi = 6.28318530717958647692528676655900577L;
    for (double lambda = 1.0; lambda < 560.0; lambda *= 1.07) {
        long double l = lambda, e = expl(-l);
        close_to("A", lambda, 0.0, sg_A(lambda), (double)(two_pi * (1 - e * e) / l), 4e-15);
        close_to("A_u", lambda, 0.0, sg_A_u(lambda), (double)(two_pi * (e - 1 + l) / (l * l)),
                 4e-15);
        close_to("A_b", lambda, 0.0, sg_A_b(lambda),
                 (double)(two_pi * e * (1 - e - l * e) / (l * l)), 4e-15);
    }
    /* and below 1 by two terms of their series, where the third is out of sight */
    for (double lambda = 1e-6; lambda > 1e-300; lambda *= 0.07) {
        close_to("A", lambda, 0.0, sg_A(lambda), 4.0 * pi * (1.0 - lambda), 1e-11);
        close_to("A_u", lambda, 0.0, sg_A_u(lambda), pi * (1.0 - lambda / 3.0), 1e-11);
        close_to("A_b", lambda, 0.0, sg_A_b(lambda), pi * (1.0 - 5.0 / 3.0 * lambda), 1e-11);
    }
    assert_true(sg_A(0.0) == 4.0 * pi && sg_A_u(0.0) == pi && sg_A_b(0.0) == pi);
    assert_true(sg_A((double)INFINITY) == 0.0 && sg_A_u((double)INFINITY) == 0.0 &&
                sg_A_b((double)INFINITY) == 0.0);
    assert_true(isnan(sg_A(-1.0)) && isnan(sg_A_u(-1e-300)) && isnan(sg_A_b((double)NAN)));
}

/* The poles are the closed forms; pi as a double is 1.2e-16 short of the lower one, which does not
 * show there because the derivative vanishes. */
static void poles(void **state)
{
    (void)state;
    for (double lambda = 1e-300; lambda < 500.0;
         lambda = lambda < 1e-3 ? lambda * 1e7 : lambda * 1.3) {
        close_to("A_h", lambda, 0.0, sg_A_h(lambda, 0.0), sg_A_u(lambda), 4e-15);
        close_to("A_h", lambda, pi, sg_A_h(lambda, pi), sg_A_b(lambda), 4e-15);
        close_to("A_h_cos", lambda, 1.0, sg_A_h_cos(lambda, 1.0), sg_A_u(lambda), 4e-15);
        close_to("A_h_cos", lambda, -1.0, sg_A_h_cos(lambda, -1.0), sg_A_b(lambda), 4e-15);
        close_to("H", lambda, 0.0, sg_H(lambda, 0.0) + sg_H(lambda, pi), sg_A(lambda), 4e-15);
    }
}

/* On the horizon H is half of A, and for large lambda the planar Gaussian gives
 * L = (2 pi lambda)^-1/2. */
static void horizon(void **state)
{
    (void)state;
    for (double lambda = 1e-300; lambda < 2e300; lambda *= 37.0)
        close_to("H_cos", lambda, 0.0, sg_H_cos(lambda, 0.0), 0.5 * sg_A(lambda), 4e-15);
    for (double lambda = 1e17; lambda < 2e300; lambda *= 37.0)
        close_to("L_cos", lambda, 0.0, sg_L_cos(lambda, 0.0), 1.0 / sqrt(2.0 * pi) / sqrt(lambda),
                 4e-15);
}

/* An independent route, good to this where lambda is moderate and the value not tiny. */
static void against_quadrature(void **state)
{
    (void)state;
    const sg_route *route = sg_route_find("bessel_1d");
    for (double lambda = 1e-4; lambda < 150.0; lambda *= 1.9)
        for (int k = 0; k <= 60; k++) {
            sg_quadrature quadrature;
            double beta = k == 60 ? pi : pi * k / 60.0;
            assert_int_equal(route->A_h(lambda, beta, &quadrature), SG_OK);
            close_to("A_h", lambda, beta, sg_A_h(lambda, beta), quadrature.value, 2e-13);
        }
}

static void flat_and_infinitely_sharp(void **state)
{
    (void)state;
    const double inf = (double)INFINITY, tiny[] = {0.0, DBL_TRUE_MIN, 1e-310, DBL_MIN, 1e-300};
    for (int k = 0; k <= 40; k++) {
        double beta = k == 40 ? pi : pi * k / 40.0, z = cos(beta), lit = z > 0.0 ? z : 0.0;
        for (size_t i = 0; i < sizeof tiny / sizeof *tiny; i++) {
            double lambda = tiny[i];
            close_to("A_h", lambda, beta, sg_A_h(lambda, beta), pi, 1e-15);
            close_to("H", lambda, beta, sg_H(lambda, beta), 2.0 * pi, 1e-15);
            close_to("L", lambda, beta, sg_L(lambda, beta), 0.25, 1e-15);
            close_to("c_cos", lambda, z, sg_c_cos(lambda, z), 0.5 * (1.0 + z), 1e-15);
            close_to("s", lambda, beta, sg_s(lambda, beta), 1.0, 1e-15);
        }
        close_to("L_cos", inf, z, sg_L_cos(inf, z), lit, 0.0);
        close_to("c_cos", inf, z, sg_c_cos(inf, z), lit, 0.0);
        close_to("s_cos", inf, z, sg_s_cos(inf, z), 0.0, 0.0);
        close_to("A_h", inf, beta, sg_A_h(inf, beta), 0.0, 0.0);
        close_to("H", inf, beta, sg_H(inf, beta), 0.0, 0.0);
        if (z > 1e-3) {
            close_to("L_cos", 1e300, z, sg_L_cos(1e300, z), z, 1e-15);
            close_to("A_h_cos", 1e300, z, sg_A_h_cos(1e300, z), 2.0 * pi * z / 1e300, 1e-15);
        }
    }
}

/* Eq. 15 and 16 with the curves put back in; c next to the lower pole, where as printed it is the
 * difference of equal numbers. */
static void curves(void **state)
{
    (void)state;
    for (double lambda = 1e-9; lambda < 1e9; lambda *= 7.3)
        for (int k = -100; k <= 100; k++) {
            double z = k / 100.0, c = sg_c_cos(lambda, z), s = sg_s_cos(lambda, z);
            double lit = z > 0.0 ? z : 0.0, size = sg_A_u(lambda);
            double A_h = c * size + (1.0 - c) * sg_A_b(lambda);
            assert_true(c >= 0.0 && c <= 1.0 + 2e-16 && s >= 0.0 && s <= 1.0 + 1e-15);
            assert_true(fabs(A_h - sg_A_h_cos(lambda, z)) <= 1e-14 * size);
            assert_true(fabs(s * 0.5 * (1.0 + z) + (1.0 - s) * lit - c) <= 1e-15);
        }
    /* c -> (1 + z)/2 s(pole) there, s being flat: it changes by 3/16 of lambda over the quadrant */
    for (double gap = 1e-3; gap > 1e-15; gap *= 0.1)
        for (double lambda = 1e-9; lambda < 20.0; lambda *= 11.0) {
            double z = -1.0 + gap, pole = sg_s_cos(lambda, -1.0);
            double change = 1e-15 + 0.3 * gap * lambda * (1.0 + lambda);
            close_to("c_cos", lambda, z, sg_c_cos(lambda, z), 0.5 * (1.0 + z) * pole, change);
            close_to("s", lambda, sqrt(gap), sg_s(lambda, sqrt(gap)), pole, change);
        }
    /* for small lambda 1 - 3/8 lambda at the poles and 1 - 3/16 lambda on the horizon */
    for (double lambda = 1e-16; lambda < 1e-4; lambda *= 10.0) {
        double term = 0.375 * lambda, rest = lambda * lambda + 1e-15;
        assert_true(fabs(sg_s(lambda, 0.0) - (1.0 - term)) <= rest);
        assert_true(fabs(sg_s(lambda, pi) - (1.0 - term)) <= rest);
        assert_true(fabs(sg_s_cos(lambda, 0.0) - (1.0 - 0.5 * term)) <= rest);
    }
}

static void falls_with_the_angle(void **state)
{
    (void)state;
    for (double lambda = 1e-3; lambda < 1e8; lambda *= 9.0) {
        double before = (double)INFINITY;
        for (int k = 0; k <= 2000; k++) {
            double value = sg_L(lambda, k == 2000 ? pi : pi * k / 2000.0);
            assert_true(value >= 0.0 && value <= 1.0 && value <= before * (1.0 + 4e-15));
            before = value;
        }
    }
}

typedef double (*quantity)(double lambda, double direction);

static void domain(void **state)
{
    (void)state;
    static const quantity by_angle[] = {sg_A_h, sg_H, sg_L, sg_c, sg_s};
    static const quantity by_cosine[] = {sg_A_h_cos, sg_H_cos, sg_L_cos, sg_c_cos, sg_s_cos};
    const double nan = (double)NAN, inf = (double)INFINITY;
    for (int i = 0; i < 5; i++) {
        assert_true(isnan(by_angle[i](-1e-300, 1.0)) && isnan(by_angle[i](nan, 1.0)));
        assert_true(isnan(by_angle[i](1.0, -1e-300)) && isnan(by_angle[i](1.0, nan)));
        assert_true(isnan(by_angle[i](1.0, nextafter(pi, 4.0))) && isnan(by_angle[i](inf, inf)));
        assert_true(isnan(by_cosine[i](-1.0, 0.5)) && isnan(by_cosine[i](nan, 0.5)));
        assert_true(isnan(by_cosine[i](1.0, nan)) && isnan(by_cosine[i](inf, nan)));
        for (double lambda = 1e-5; lambda < 1e5; lambda *= 10.0) {
            assert_true(by_cosine[i](lambda, 1.0 + 1e-15) == by_cosine[i](lambda, 1.0));
            assert_true(by_cosine[i](lambda, -3.0) == by_cosine[i](lambda, -1.0));
            assert_true(by_cosine[i](lambda, inf) == by_cosine[i](lambda, 1.0));
        }
        /* every finite lambda is inside */
        for (double lambda = DBL_TRUE_MIN; lambda <= DBL_MAX / 33.0; lambda *= 33.0)
            for (int k = -4; k <= 4; k++) {
                double value = by_cosine[i](lambda, 0.25 * k);
                assert_true(value >= 0.0 && value <= 7.0);
            }
        assert_true(by_cosine[i](DBL_MAX, 0.5) >= 0.0 && by_angle[i](DBL_MAX, half_pi) >= 0.0);
    }
}

/* Points from a file, where SGFIT_AH_POINTS names one: CSV of lambda, beta, A_h. */
static void points_from_outside(void **state)
{
    (void)state;
    const char *path = getenv("SGFIT_AH_POINTS");
    if (!path)
        skip();
    FILE *file = fopen(path, "r");
    assert_non_null(file);
    char line[256];
    int count = 0;
    while (fgets(line, sizeof line, file)) {
        double lambda, beta, A_h;
        if (sscanf(line, "%lf,%lf,%lf", &lambda, &beta, &A_h) != 3)
            continue;
        close_to("A_h", lambda, beta, sg_A_h(lambda, beta), A_h, stated(A_h));
        count++;
    }
    fclose(file);
    assert_true(count > 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(known_values),
        cmocka_unit_test(closed_forms),
        cmocka_unit_test(poles),
        cmocka_unit_test(horizon),
        cmocka_unit_test(against_quadrature),
        cmocka_unit_test(flat_and_infinitely_sharp),
        cmocka_unit_test(curves),
        cmocka_unit_test(falls_with_the_angle),
        cmocka_unit_test(domain),
        cmocka_unit_test(points_from_outside),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
