/* Lobe algebra in its corners: next to the axis, opposite and equal and extreme lobes, one light
 * alone, and more of them than directions allow. */
#include <float.h>
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

#include <cmocka.h>

#include "sg.h"

static const double pi = 3.14159265358979312;
static uint64_t seed = 11;

static double uniform(void)
{
    seed = seed * 6364136223846793005u + 1442695040888963407u;
    return (double)(seed >> 11) * 0x1p-53;
}

static void direction(double z, double azimuth, double out[3])
{
    double r = sqrt((1.0 - z) * (1.0 + z));
    out[0] = r * cos(azimuth), out[1] = r * sin(azimuth), out[2] = z;
}

static double dot(const double a[3], const double b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static void close_to(const char *what, double at, double found, double expected, double relative)
{
    if (!(fabs(found - expected) <= relative * fabs(expected)))
        fail_msg("%s at %.17g: %.17g, expected %.17g within %.2g of it", what, at, found, expected,
                 relative);
}

/* A direction at the small angle t from the axis has the value exp(-2 lambda sin^2(t/2)): the
 * printed exp(lambda (w.v - 1)) is 1 for all t below 1e-8. */
static void evaluation_near_the_axis(void **state)
{
    (void)state;
    for (double t = 1e-12; t < 3.0; t *= 7.0) {
        sg_lobe lobe = {{0.0, 0.0, 1.0}, 1.0 / (t * t), 3.0};
        double w[3] = {sin(t), 0.0, cos(t)}, half = sin(0.5 * t);
        close_to("evaluate", t, sg_lobe_evaluate(&lobe, w), 3.0 * exp(-2.0 * half * half / (t * t)),
                 1e-14);
    }
    sg_lobe sharp = {{0.6, 0.0, 0.8}, 1e300, 5.0};
    assert_true(sg_lobe_evaluate(&sharp, sharp.axis) == 5.0);
    assert_true(sg_lobe_evaluate(&sharp, (double[3]){0.8, 0.0, 0.6}) == 0.0);
    sharp.sharpness = (double)INFINITY;
    assert_true(sg_lobe_evaluate(&sharp, sharp.axis) == 5.0);
    sharp.sharpness = 0.0;
    assert_true(sg_lobe_evaluate(&sharp, (double[3]){0.0, -1.0, 0.0}) == 5.0);
    sharp.sharpness = 2.0;
    close_to("opposite", 2.0, sg_lobe_evaluate(&sharp, (double[3]){-0.6, 0.0, -0.8}),
             5.0 * exp(-4.0), 1e-15);
}

static void integrals(void **state)
{
    (void)state;
    sg_lobe lobe = {{0.0, 0.6, 0.8}, 4.0, 0.5};
    close_to("integral", 4.0, sg_lobe_integral(&lobe), 0.25 * pi * -expm1(-8.0), 1e-15);
    /* normals next to the horizon of the axis: the dot product cancels there */
    for (double t = 1e-14; t < 1.0; t *= 10.0) {
        double normal[3] = {cos(t), -0.8 * sin(t), 0.6 * sin(t)};
        double z = fma(0.6, normal[1], 0.8 * normal[2]);
        close_to("irradiance", t, sg_lobe_irradiance(&lobe, normal), 0.5 * sg_A_h_cos(4.0, z),
                 1e-15);
    }
    /* the products of this dot product round to opposite numbers; -2^-62 is what they drop, and
     * decides for a lobe so sharp */
    sg_lobe sharp = {{0.5 + 0x1p-31, 0.5, 0.7}, 0x1p130, 1.0};
    double normal[3] = {0.5 - 0x1p-31, -0.5, 0.0};
    close_to("irradiance", 0x1p130, sg_lobe_irradiance(&sharp, normal),
             sg_A_h_cos(0x1p130, -0x1p-62), 1e-15);
    assert_true(sg_A_h_cos(0x1p130, -0x1p-62) < 1e-6 * sg_A_h_cos(0x1p130, 0.0));
}

/* The product of two lobes is the lobe that has everywhere the product of their values. */
static void product_is_pointwise(void **state)
{
    (void)state;
    for (int i = 0; i < 20000; i++) {
        sg_lobe a = {.sharpness = pow(10.0, -6.0 + 8.0 * uniform()), .amplitude = 2.0};
        sg_lobe b = {.sharpness = i % 3 ? pow(10.0, -6.0 + 8.0 * uniform()) : a.sharpness,
                     .amplitude = 0.25};
        double w[3], z = 2.0 * uniform() - 1.0;
        direction(z, 6.28 * uniform(), a.axis);
        direction(2.0 * uniform() - 1.0, 6.28 * uniform(), b.axis);
        direction(2.0 * uniform() - 1.0, 6.28 * uniform(), w);
        if (i % 5 == 0) /* nearly opposite axes */
            direction(-z, atan2(-a.axis[1], -a.axis[0]) + 1e-9 * uniform(), b.axis);
        sg_lobe p = sg_lobe_product(&a, &b);
        assert_true(fabs(dot(p.axis, p.axis) - 1.0) <= 1e-15);
        assert_true(p.sharpness <= (a.sharpness + b.sharpness) * (1.0 + 1e-15));
        double expected = sg_lobe_evaluate(&a, w) * sg_lobe_evaluate(&b, w);
        double lost = 1e-15 * (4.0 + a.sharpness + b.sharpness);
        close_to("product", a.sharpness, sg_lobe_evaluate(&p, w), expected, lost);
    }
}

static void product_in_the_corners(void **state)
{
    (void)state;
    sg_lobe a = {{0.0, 0.6, 0.8}, 1e3, 2.0}, b = {{0.0, -0.6, -0.8}, 1e3, 3.0};
    sg_lobe p = sg_lobe_product(&a, &b); /* opposite and equal: constant */
    assert_true(p.sharpness == 0.0 && p.amplitude == 6.0 * exp(-2e3));
    assert_true(fabs(dot(p.axis, p.axis) - 1.0) < 1e-15 && fabs(dot(p.axis, a.axis)) < 1e-15);

    b.sharpness = nextafter(1e3, 2e3); /* one bit sharper wins */
    p = sg_lobe_product(&a, &b);
    close_to("sharpness", 1e3, p.sharpness, b.sharpness - 1e3, 1e-12);
    assert_true(dot(p.axis, b.axis) > 1.0 - 1e-15);

    b.sharpness = 0.0; /* a constant only scales */
    p = sg_lobe_product(&b, &a);
    assert_true(p.sharpness == 1e3 && p.amplitude == 6.0 && p.axis[2] == 0.8);
    a.sharpness = 0.0;
    p = sg_lobe_product(&a, &b);
    assert_true(p.sharpness == 0.0 && p.amplitude == 6.0);

    a.sharpness = 1e300, b.sharpness = 1e-300;
    p = sg_lobe_product(&a, &b);
    assert_true(p.sharpness == 1e300 && p.amplitude == 6.0);
    b.sharpness = 1e300; /* 1 - v.w = 2^-1 1e-300 is not to be seen in any dot product */
    b.axis[0] = 1e-150, b.axis[1] = 0.6, b.axis[2] = 0.8;
    p = sg_lobe_product(&a, &b);
    close_to("sharpness", 1e300, p.sharpness, 2e300, 1e-15);
    close_to("amplitude", 1e300, p.amplitude, 6.0 * exp(-0.25), 1e-15);
    a.sharpness = b.sharpness = DBL_MAX;
    p = sg_lobe_product(&a, &a);
    assert_true(p.sharpness == DBL_MAX && p.amplitude == 4.0);

    /* l3 - l1 - l2 of the papers, 1e5 (cos(1e-6) - 1) here, is lost in 2e5 */
    sg_lobe c = {{0.0, 0.0, 1.0}, 1e5, 1.0}, d = {{sin(2e-6), 0.0, cos(2e-6)}, 1e5, 1.0};
    p = sg_lobe_product(&c, &d);
    close_to("amplitude", 1e5, log(p.amplitude), -4e5 * sin(0.5e-6) * sin(0.5e-6), 1e-8);
    c.amplitude = d.amplitude = 1e200;
    c.axis[2] = -1.0;
    p = sg_lobe_product(&c, &d);
    assert_true(p.amplitude == 0.0);
}

static void moments_exact(void **state)
{
    (void)state;
    double before = 0.0;
    for (double lambda = 1e-300; lambda < 1e13; lambda *= 1.7) {
        double r = sg_mean_from_sharpness(lambda);
        assert_true(r > before);
        before = r;
        if (lambda < 1e-5)
            close_to("mean", lambda, r, lambda / 3.0, 1e-11);
        if (lambda > 30.0)
            close_to("mean", lambda, r, 1.0 - 1.0 / lambda, 1e-15);
        if (lambda > 0.5 && lambda < 30.0)
            close_to("mean", lambda, r, 1.0 / tanh(lambda) - 1.0 / lambda, 3e-15);
        /* what the rounding of r takes away is the condition of the inverse */
        close_to("there and back", lambda, sg_sharpness_from_mean(r), lambda,
                 4e-15 + 2e-16 / (1.0 - r));
    }
    for (double q = 1e-16; q < 1e-2; q *= 1.9) {
        double r = 1.0 - q;
        close_to("sharpness", r, sg_sharpness_from_mean(r), 1.0 / (1.0 - r), 1e-15);
    }
    for (double r = 5e-324; r < 1e-6; r *= 1e3)
        close_to("sharpness", r, sg_sharpness_from_mean(r), 3.0 * r, 1e-11);
    /* the exact inverse is no worse in the middle: r is where a root must be */
    for (double r = 0.01; r < 0.99; r += 0.003) {
        double lambda = sg_sharpness_from_mean(r);
        close_to("back and there", r, sg_mean_from_sharpness(lambda), r, 1.5e-15);
    }
}

static void moments_of_the_papers(void **state)
{
    (void)state;
    for (double r = 0x1p-40; 1.0 - r > 1e-15; r = r < 0.5 ? r * 1.5 : 1.0 - 0.6 * (1.0 - r)) {
        double toksvig = sg_sharpness_from_mean_toksvig(r);
        double banerjee = sg_sharpness_from_mean_banerjee(r);
        close_to("toksvig", r, toksvig, r / (1.0 - r), 0.0);
        close_to("toksvig back", r, sg_mean_from_sharpness_toksvig(toksvig), r, 1e-15);
        close_to("banerjee", r, banerjee, r * (3.0 - r * r) / (1.0 - r * r),
                 1e-14 + 2e-16 / (1.0 - r));
        close_to("banerjee back", r, sg_mean_from_sharpness_banerjee(banerjee), r, 2e-15);
    }
    for (double lambda = 1e-300; lambda < 1e300; lambda *= 1e3) {
        double r = sg_mean_from_sharpness_banerjee(lambda);
        assert_true(r > 0.0 && r <= 1.0);
    }
}

typedef double (*rule)(double);

static void moments_in_the_corners(void **state)
{
    (void)state;
    static const rule inverse[] = {sg_sharpness_from_mean, sg_sharpness_from_mean_toksvig,
                                   sg_sharpness_from_mean_banerjee};
    static const rule forward[] = {sg_mean_from_sharpness, sg_mean_from_sharpness_toksvig,
                                   sg_mean_from_sharpness_banerjee};
    for (int i = 0; i < 3; i++) {
        assert_true(inverse[i](0.0) == 0.0 && inverse[i](-1e-17) == 0.0);
        assert_true(isinf(inverse[i](1.0)) && isinf(inverse[i](1.0 + 1e-15)));
        assert_true(isinf(inverse[i]((double)INFINITY)) && isnan(inverse[i]((double)NAN)));
        assert_true(isfinite(inverse[i](1.0 - 0x1p-53)));
        assert_true(forward[i](0.0) == 0.0 && forward[i]((double)INFINITY) == 1.0);
        assert_true(forward[i](DBL_MAX) == 1.0);
        assert_true(isnan(forward[i](-1.0)) && isnan(forward[i]((double)NAN)));
    }
}

static void lobe_from_lights(void **state)
{
    (void)state;
    /* ten lights around +x: the lobe has their integral and their mean */
    double sum[3] = {0.0, 0.0, 0.0}, weights = 0.0;
    for (int i = 0; i < 10; i++) {
        double weight = 1.0 + i, light[3];
        direction(0.1 * (i - 4), 0.05 * i, light);
        for (int k = 0; k < 3; k++)
            sum[k] += weight * light[k];
        weights += weight;
    }
    sg_lobe lobe = sg_lobe_from_moments(sum, weights, NULL, 0.0);
    double size = sqrt(dot(sum, sum));
    close_to("integral", 0.0, sg_lobe_integral(&lobe), weights, 1e-15);
    close_to("mean", 0.0, sg_mean_from_sharpness(lobe.sharpness) * weights, size, 2e-15);
    close_to("axis", 0.0, dot(lobe.axis, sum), size, 1e-15);

    /* one light alone, and one that rounding makes longer than its weight */
    for (double stretch = 1.0; stretch < 1.0 + 1e-14; stretch += 0x1p-52) {
        double alone[3] = {0.0, 0.0, -2.0 * stretch};
        lobe = sg_lobe_from_moments(alone, 2.0, sg_sharpness_from_mean_toksvig, 1e6);
        assert_true(lobe.sharpness == 1e6 && lobe.axis[2] == -1.0);
        close_to("one light", stretch, sg_lobe_integral(&lobe), 2.0, 1e-15);
        lobe = sg_lobe_from_moments(alone, 2.0, sg_sharpness_from_mean_toksvig, 0.0);
        assert_true(isinf(lobe.sharpness));
    }
    double none[3] = {0.0, 0.0, 0.0};
    lobe = sg_lobe_from_moments(none, 3.0, sg_sharpness_from_mean, 0.0);
    assert_true(lobe.sharpness == 0.0 && lobe.axis[2] == 1.0);
    close_to("no direction", 0.0, sg_lobe_integral(&lobe), 3.0, 1e-15);
    lobe = sg_lobe_from_moments(none, 0.0, sg_sharpness_from_mean, 0.0);
    assert_true(lobe.sharpness == 0.0 && lobe.amplitude == 0.0);
}

/* a b - c d where both products round to the same double: the truth is in what they dropped. */
static void difference_of_products(void **state)
{
    (void)state;
    double a = 1.0 + 0x1p-30, b = 1.0 - 0x1p-30;
    assert_true(sg_difference_of_products(a, b, 1.0, 1.0) == -0x1p-60);
    assert_true(a * b - 1.0 == 0.0);
    for (int i = 0; i < 100000; i++) {
        double x = uniform(), y = uniform(), z = x * (1.0 + 1e-14 * uniform());
        double w = y * (1.0 - 1e-14 * uniform());
        long double exact = (long double)x * y - (long double)z * w;
        /* the 64 bits of long double keep both products to 2^-64 */
        double slack = 2e-16 * (double)fabsl(exact) + 0x1p-63 * x * y;
        assert_true(fabs(sg_difference_of_products(x, y, z, w) - (double)exact) <= slack);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(evaluation_near_the_axis),
        cmocka_unit_test(integrals),
        cmocka_unit_test(product_is_pointwise),
        cmocka_unit_test(product_in_the_corners),
        cmocka_unit_test(moments_exact),
        cmocka_unit_test(moments_of_the_papers),
        cmocka_unit_test(moments_in_the_corners),
        cmocka_unit_test(lobe_from_lights),
        cmocka_unit_test(difference_of_products),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
