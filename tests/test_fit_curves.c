/* What the recipes of curves are made of: parts of the forms, and steepnesses that are found. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>
#include <math.h>
#include <string.h>

#include "fit/curve.h"
#include "sg.h"

static const double pi = 3.14159265358979323846;

/* A curve holds a part of a form's formula: they must be the same. */
static double hemisphere(const fit_curve *curve, const double *k, double lambda, double z)
{
    double upper = -2.0 * pi * expm1(-lambda) / lambda, lower = exp(-lambda) * upper;
    return lower + curve->shape->value(curve->value(lambda, k), z) * (upper - lower);
}

static double by_curve(const fit_curve *curve, const double *k, const double *rest, double l,
                       double z)
{
    double t = curve->value(l, k), below = sg_A_b(l), above = sg_A_u(l);
    if (strcmp(curve->id, "cosine_erf_t") == 0)
        return below + curve->shape->value(t, z) * (above - below);
    if (strcmp(curve->id, "meder_t") == 0) {
        double s = curve->shape->scale(t, rest) * curve->shape->value(t, z);
        double clamped = z > 0.0 ? z : 0.0;
        return below + (s * 0.5 * (1.0 + z) + (1.0 - s) * clamped) * (above - below);
    }
    /* rest: amplitude, sharpness and offset of the lobe for the cosine */
    double l3 = sqrt(l * l + rest[1] * rest[1] + 2.0 * l * rest[1] * z);
    return rest[0] * exp(l3 - l - rest[1]) * hemisphere(curve, k, l3, (l * z + rest[1]) / l3) -
           rest[2] * hemisphere(curve, k, l, z);
}

static void hold_curve_to_form(const char *id, const double *k, const double *rest,
                               const double *all)
{
    const fit_curve *curve = fit_curve_find(id);
    assert_non_null(curve);
    const sg_form *form = sg_form_find(curve->form);
    assert_non_null(form);
    for (double l = 0.05; l < 300.0; l *= 1.7) {
        for (double z = -0.99; z < 1.0; z += 0.11) {
            double ours = by_curve(curve, k, rest, l, z), theirs = form->f64(l, z, all);
            if (form->native == SG_L)
                theirs *= sg_A(l);
            if (theirs > 0.0) /* the published text cuts at 0 */
                assert_true(fabs(ours - theirs) < 1e-9);
        }
    }
}

static void curves_are_parts_of_their_forms(void **state)
{
    (void)state;
    const double t24[] = {2.7, 17.0, 4.0, 15.2, 76.1};
    hold_curve_to_form("cosine_erf_t", t24, NULL, t24);
    const double meder[] = {2.1007, 4.4653, 0.2958, 0.5033};
    hold_curve_to_form("meder_t", meder, meder + 2, meder);
    const double hg[] = {32.708, 0.0315, 31.7003, 1.6988, 10.8438, 6.2201, 10.2415};
    hold_curve_to_form("hemisphere_logistic_t", hg + 3, hg, hg);
    const double t22[] = {0.01, 98.0, 0.65, 1.34, 7.22};
    const double lobe[] = {98.0 * exp(0.01), 0.01, 98.0};
    hold_curve_to_form("hemisphere_erf_t", t22 + 2, lobe, t22);
}

/* The first stage finds a steepness that is planted. */
static double planted(double lambda, double z)
{
    return 1.25 / (exp(0.4 * lambda * fabs(z)) + 1.0);
}

static void the_best_steepness_is_found(void **state)
{
    (void)state;
    double z[101], work[101], u;
    for (int i = 0; i <= 100; i++)
        z[i] = -1.0 + 0.02 * i;
    fit_shape shape = *fit_curve_find("meder_u")->shape;
    shape.target = planted;
    for (double lambda = 1e-2; lambda < 2e3; lambda *= 7.0) {
        double t = fit_steepness(&shape, NULL, lambda, 101, z, work, &u);
        assert_true(fabs(t / (0.4 * lambda) - 1.0) < 1e-5);
        assert_true(fabs(u - 1.25) < 1e-5);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(curves_are_parts_of_their_forms),
        cmocka_unit_test(the_best_steepness_is_found),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
