/* Every function of shaders/sg.glsl, run on the software device, against the C float version of
 * the same text. Agreement is no accuracy: that both are right is tested elsewhere.
 *
 * The tolerance. Both sides evaluate the same expression in IEEE float; they may differ by
 *   - the built-in functions: GLSL allows exp an error of 3 + 2|x| ulp (lavapipe computes it as a
 *     polynomial exp2 of x/ln 2, whose argument carries |x| half ulps), inversesqrt 2 ulp, division
 *     2.5 ulp, log2 3 ulp; C's are within 1 ulp. exp enters as e^-x and e^-x^2 with a factor that
 *     is at most 1, and x e^-x <= 0.37: a few ulps of 1 at most;
 *   - contraction: the compiler of the device may fuse a*b + c, C here does not: half an ulp each;
 *   - flushing: a device may treat numbers below FLT_MIN as 0.
 * So L, which lies in [0, 1], is held to 1e-6 (8 ulps of 1; the worst that was seen is 4e-7), and
 * A_h to 1e-6 A(lambda), with twice FLT_MIN on top. Methods as published cancel in float at small
 * or large sharpness, and amplify all this; for these the table below adds what the cancellation
 * does to a rounding, and they are compared up to where that has grown to 1 %.  */
#include "device_bench.h"

#include "sg.h"

static const double given_up = 1e-2;

/* Adds flat + large lambda + small/lambda^power to the tolerance of L. Forms in this table break
 * in float: where C gives no finite value there is nothing to compare. */
typedef struct amplification {
    const char *form;
    double flat, large, small, power;
} amplification;

static const amplification amplifications[] = {
    /* exponents sharpness3 - lambda - c, of which both terms grow with lambda; 1 - e^-x over x */
    {"lobe_product", 0, 1e-6, 1e-6, 1},
    {"constant_cosine", 0, 0, 1e-6, 1},
    /* scale and bias are differences of terms 1/lambda, their product is divided by lambda */
    {"pettineo_hill", 0, 0, 1e-6, 2},
    /* (e^-lambda - 1 + lambda)/lambda^2 */
    {"meder_logistic", 0, 0, 1e-6, 2},
    /* 32.708 p - 31.7003 q, exponents as for the products of lobes; e^t over e^t - 1 */
    {"hemisphere_logistic", 1e-5, 4e-6, 1e-5, 1},
    /* 1182 (p - q) */
    {"hemisphere_erf", 1e-3, 0, 0, 1},
    /* 0/0 at 0 */
    {"cosine_erf", 0, 0, 0, 1},
};

static const amplification *amplification_of(const sg_method *method)
{
    for (size_t i = 0; i < sizeof amplifications / sizeof *amplifications; i++)
        if (strcmp(amplifications[i].form, method->form->id) == 0)
            return &amplifications[i];
    return NULL;
}

static double allowed(const amplification *a, double lambda)
{
    return a ? tolerance + a->flat + a->large * lambda + a->small / pow(lambda, a->power)
             : tolerance;
}

static void every_method_agrees_with_c_float(void **state)
{
    (void)state;
    bench b = open_bench();
    const float *pairs = gpu_buffer_map(b.in), *out = gpu_buffer_map(b.out);
    bool good = sg_method_count() > 0;
    for (size_t m = 0; m < sg_method_count(); m++) {
        const sg_method *method = sg_method_at(m);
        char expression[200];
        snprintf(expression, sizeof expression, "vec2(sg_L_%s(p.x, p.y), sg_A_h_%s(p.x, p.y))",
                 method->id, method->id);
        run(&b, method->id, "", expression);
        const amplification *breaks = amplification_of(method);
        worst L = {0}, A_h = {0};
        for (size_t i = 0; i < b.points; i++) {
            float lambda = pairs[2 * i], z = pairs[2 * i + 1];
            double bound = allowed(breaks, (double)lambda);
            float host_L = method->L_f32(lambda, z), host_A_h = method->A_h_f32(lambda, z);
            if (bound > given_up || (breaks && !(isfinite(host_L) && isfinite(host_A_h))))
                continue;
            compare(&L, out[2 * i], host_L, bound, lambda, z);
            compare(&A_h, out[2 * i + 1], host_A_h, bound * sg_A((double)lambda), lambda, z);
        }
        good = report(method->id, "L", &L) && good;
        good = report(method->id, "A_h", &A_h) && good;
    }
    assert_true(good);
    close_bench(&b);
}

/* That the comparison can fail at all. */
static void a_planted_difference_is_caught(void **state)
{
    (void)state;
    bench b = open_bench();
    const float *pairs = gpu_buffer_map(b.in), *out = gpu_buffer_map(b.out);
    const sg_method *method = sg_method_find("tokuyoshi_2024_stable");
    assert_non_null(method);
    run(&b, "planted", "", "vec2(sg_L_tokuyoshi_2024_stable(p.x, p.y) + 3e-6, 0.0 / (p.x - p.x))");
    worst moved = {0}, nan = {0};
    for (size_t i = 0; i < b.points; i++) {
        float lambda = pairs[2 * i], z = pairs[2 * i + 1];
        compare(&moved, out[2 * i], method->L_f32(lambda, z), tolerance, lambda, z);
        compare(&nan, out[2 * i + 1], 0, tolerance, lambda, z);
    }
    assert_true(moved.ratio > 2);
    assert_true(nan.ratio > 1);
    close_bench(&b);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_method_agrees_with_c_float),
        cmocka_unit_test(a_planted_difference_is_caught),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
