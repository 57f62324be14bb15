/* What every method of the registry promises. Walks the registry, so that a new method is held to
 * it without a line here.
 *
 * Methods as published promise nothing beyond their declared error inside their own domain. All
 * others promise that L is finite and not negative for every sharpness from 0 to infinity and every
 * cosine, slightly outside [-1, 1] too, in double, float and (but for the tiers) half, on
 * processors that flush denormals as on those that do not; that the limit at 0 is within the
 * declared error and that at infinity is max(cos_theta, 0); that L is at most 1; that NaN stays
 * NaN; and that float rounds L by at most 1e-6. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "base/json.h"
#include "fit/score.h"
#include "sg.h"

#if defined(__SSE__)
#include <xmmintrin.h>
/* Flush results and treat operands as zero, as graphics hardware does. */
static void flush_denormals(bool on)
{
    _mm_setcsr((_mm_getcsr() & ~0x8040u) | (on ? 0x8040u : 0u));
}
enum { FLUSH_MODES = 2 };
#else
static void flush_denormals(bool on)
{
    (void)on;
}
enum { FLUSH_MODES = 1 };
#endif

static const double lambdas[] = {
    0,     1e-45, 1e-40, 1e-38,  1e-30,  1e-20,  1e-10, 1e-7,  1e-5,    1e-4,  8.456e-4,
    1e-3,  1e-2,  0.03,  0.0315, 0.04,   0.1,    0.5,   0.999, 1,       1.001, 2,
    2.133, 3,     10,    88,     89,     104,    500,   710,   1e3,     1e4,   65504,
    1e5,   1e6,   1e7,   1e8,    1e10,   1e12,   1e15,  1e18,  1.8e19,  1e20,  1e25,
    1e30,  1e35,  1e37,  8e37,   1.8e38, 3.4e38, 1e100, 1e300, INFINITY};
static const double cosines[] = {-1.0000001, -1,     -0.9999999, -0.999,    -0.5,  -1e-3,    -1e-7,
                                 -1e-30,     -1e-40, 0,          1e-45,     1e-40, 1e-30,    1e-7,
                                 1e-3,       0.5,    0.999,      0.9999999, 1,     1.0000001};
enum { LAMBDAS = sizeof lambdas / sizeof *lambdas, COSINES = sizeof cosines / sizeof *cosines };

static bool promises(const sg_method *method)
{
    return strcmp(method->variant, "published") != 0;
}

/* The largest error of L that the method's constants file states. */
static double declared_error(const sg_method *method, const char *precision)
{
    char path[1024];
    snprintf(path, sizeof path, "%s/tables/constants/%s.json", getenv("SGFIT_ROOT"), method->id);
    cJSON *json = base_json_read(path);
    assert_non_null(json);
    const cJSON *measured, *row;
    double value;
    if (!base_json_object(json, path, "measured", &measured) ||
        !base_json_object(measured, path, precision, &row) ||
        !base_json_f64(row, path, "max_abs", &value))
        fail_msg("%s declares no error in %s: run sgfit fit", method->id, precision);
    cJSON_Delete(json);
    return value;
}

static void check_value(const sg_method *method, const char *precision, double lambda, double z,
                        double value, double limit)
{
    if (!(value >= 0 && value <= limit))
        fail_msg("%s, %s: (lambda %.9g, cos_theta %.9g) gives %.9g, expected 0 to %.9g", method->id,
                 precision, lambda, z, value, limit);
}

static void finite_and_not_negative(void **state)
{
    (void)state;
    const double pi = 3.14159265358979323846;
    for (size_t m = 0; m < sg_method_count(); m++) {
        const sg_method *method = sg_method_at(m);
        if (!promises(method))
            continue;
        const double top = 1;
        for (int flush = 0; flush < FLUSH_MODES; flush++) {
            flush_denormals(flush);
            for (int a = 0; a < LAMBDAS; a++) {
                for (int b = 0; b < COSINES; b++) {
                    double lambda = lambdas[a], z = cosines[b];
                    float l = lambda > 3.4028234e38 ? INFINITY : (float)lambda, c = (float)z;
                    check_value(method, "f64", lambda, z, method->L_f64(lambda, z), top);
                    check_value(method, "f64 A_h", lambda, z, method->A_h_f64(lambda, z),
                                4 * pi * top);
                    check_value(method, "f32", lambda, z, (double)method->L_f32(l, c), top);
                    check_value(method, "f32 A_h", lambda, z, (double)method->A_h_f32(l, c),
                                4 * pi * top * (1 + 1e-6));
                    /* the tiers are for float: they square lambda, or carry powers of 2 */
                    if (!method->L_f16 || strcmp(method->variant, "tier") == 0)
                        continue;
                    check_value(method, "f16", lambda, z, (double)method->L_f16(l, c), top);
                    check_value(method, "f16 A_h", lambda, z, (double)method->A_h_f16(l, c),
                                4 * pi * top * (1 + 1e-3));
                }
            }
        }
        flush_denormals(false);
    }
}

static void limits_are_met(void **state)
{
    (void)state;
    for (size_t m = 0; m < sg_method_count(); m++) {
        const sg_method *method = sg_method_at(m);
        if (!promises(method))
            continue;
        double error = declared_error(method, "f64") * 1.001 + 1e-6;
        for (int b = 0; b <= 200; b++) {
            double z = -1 + b / 100.0;
            double at_0 = fabs(method->L_f64(0, z) - 0.25);
            double limit = fmax(z, 0);
            if (method->lambda_min == 0 && !(at_0 <= error))
                fail_msg("%s: L(0, %g) is off by %g", method->id, z, at_0);
            /* right at infinity; where the large sharpnesses lead about within the declared error,
             * which is that up to 1e4 */
            double at_infinity = fabs(method->L_f64(INFINITY, z) - limit);
            double at_1e30 = fabs(method->L_f64(1e30, z) - limit);
            double in_float = fabs((double)method->L_f32(INFINITY, (float)z) - limit);
            if (isinf(method->lambda_max) &&
                !(at_infinity < 1e-6 && in_float < 1e-6 && at_1e30 <= 1.05 * error))
                fail_msg("%s: L(inf, %g) is off by %g, in float by %g, L(1e30, %g) by %g",
                         method->id, z, at_infinity, in_float, z, at_1e30);
        }
    }
}

static void cosines_outside_count_as_1(void **state)
{
    (void)state;
    for (size_t m = 0; m < sg_method_count(); m++) {
        const sg_method *method = sg_method_at(m);
        if (!promises(method))
            continue;
        for (int a = 0; a < LAMBDAS; a++) {
            double lambda = lambdas[a];
            for (int sign = -1; sign <= 1; sign += 2) {
                double inside = method->L_f64(lambda, sign), outside = 1.0000001 * sign;
                if (!(fabs(method->L_f64(lambda, outside) - inside) < 1e-6))
                    fail_msg("%s: (%g, %.9g) differs from its neighbour at %d", method->id, lambda,
                             outside, sign);
            }
        }
    }
}

static void nan_stays_nan(void **state)
{
    (void)state;
    for (size_t m = 0; m < sg_method_count(); m++) {
        const sg_method *method = sg_method_at(m);
        if (!promises(method))
            continue;
        if (!isnan(method->L_f64(NAN, 0.5)) || !isnan(method->L_f64(2, NAN)) ||
            !isnan(method->L_f32(NAN, 0.5f)) || !isnan(method->L_f32(2, NAN)) ||
            !isnan(method->A_h_f64(NAN, 0.5)) || !isnan(method->A_h_f32(2, NAN)))
            fail_msg("%s turns NaN into a number", method->id);
    }
}

static void declared_errors_are_met(void **state)
{
    (void)state;
    for (size_t m = 0; m < sg_method_count(); m++) {
        const sg_method *method = sg_method_at(m);
        double declared = declared_error(method, "f64");
        score_result found;
        score_method(method, SCORE_F64, &found);
        print_message("%-28s f64 %.4g at (%.4g, %.4g)\n", method->id, found.max_abs,
                      found.max_abs_lambda, found.max_abs_beta);
        assert_true(found.points > 0);
        /* libm differs between processors by its last bits, cancelling texts by a few more */
        if (!(fabs(found.max_abs - declared) <= 1e-9 + 1e-6 * declared))
            fail_msg("%s: declared %.17g, found %.17g", method->id, declared, found.max_abs);
        if (!promises(method))
            continue;
        declared = declared_error(method, "f32");
        score_method(method, SCORE_F32, &found);
        if (!(found.max_abs <= declared + 1e-6))
            fail_msg("%s in float: declared %.9g, found %.9g at (%.4g, %.4g)", method->id, declared,
                     found.max_abs, found.max_abs_lambda, found.max_abs_beta);
    }
}

static uint64_t random_state;

/* In [0, 1); splitmix64. */
static double random_unit(void)
{
    uint64_t x = random_state += 0x9e3779b97f4a7c15u;
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
    x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
    return (double)((x ^ (x >> 31)) >> 11) * 0x1p-53;
}

/* Places that hurt: the horizon in units of the lobe's width, sharpnesses near to those that stand
 * for the cosine (their product then vanishes against the normal), the poles, anything. */
static void random_point(int kind, float *lambda, float *z)
{
    static const double special[] = {0.00084560872241480124, 0.0315, 2, 2.133, 1, 0.126};
    double l = pow(10, -8 + 18 * random_unit()), c = cos(3.141592653589793 * random_unit());
    if (kind == 1)
        c = (random_unit() - 0.5) / sqrt(1 + l) * 4;
    if (kind == 2 || kind == 3)
        l = special[(int)(6 * random_unit())] *
            (1 + (random_unit() - 0.5) * pow(10, -7 * random_unit()));
    if (kind == 3 || kind == 4)
        c = (random_unit() < 0.5 ? -1 : 1) * (1 - pow(10, -8 * random_unit()));
    if (kind == 5)
        l = pow(10, -2 + 4 * random_unit());
    *lambda = (float)l;
    *z = (float)fmax(-1, fmin(1, c));
}

static void float_rounds_by_1e_6_at_most(void **state)
{
    (void)state;
    for (size_t m = 0; m < sg_method_count(); m++) {
        const sg_method *method = sg_method_at(m);
        if (!promises(method))
            continue;
        double worst = 0;
        float worst_lambda = 0, worst_z = 0;
        random_state = 1;
        for (int i = 0; i < 300000; i++) {
            float lambda, z;
            random_point(i % 6, &lambda, &z);
            double error =
                fabs((double)method->L_f32(lambda, z) - method->L_f64((double)lambda, (double)z));
            if (!(error <= worst)) {
                worst = error;
                worst_lambda = lambda;
                worst_z = z;
            }
        }
        print_message("%-28s rounds by %.2e at (%.9g, %.9g)\n", method->id, worst,
                      (double)worst_lambda, (double)worst_z);
        assert_true(worst <= 1e-6);
    }
}

static void every_published_method_has_a_stable_one(void **state)
{
    (void)state;
    int count = 0;
    for (size_t m = 0; m < sg_method_count(); m++) {
        const sg_method *method = sg_method_at(m);
        char id[128];
        if (promises(method))
            continue;
        count++;
        snprintf(id, sizeof id, "%s_stable", method->id);
        if (!sg_method_find(id))
            fail_msg("%s has no stable variant", method->id);
        assert_string_equal(sg_method_find(id)->variant, "stable");
        assert_true(sg_method_find(id)->lambda_min == 0 && isinf(sg_method_find(id)->lambda_max));
    }
    assert_true(count >= 8);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(finite_and_not_negative),
        cmocka_unit_test(limits_are_met),
        cmocka_unit_test(cosines_outside_count_as_1),
        cmocka_unit_test(nan_stays_nan),
        cmocka_unit_test(declared_errors_are_met),
        cmocka_unit_test(float_rounds_by_1e_6_at_most),
        cmocka_unit_test(every_published_method_has_a_stable_one),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
