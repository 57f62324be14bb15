/* The batch call of the reference integral: the bits of the single calls, and its speed. */
#include <float.h>
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>
#include <time.h>

#include <cmocka.h>

#include "sg.h"

static const double pi = 3.14159265358979312, half_pi = 1.57079632679489656;

static double uniform(uint64_t *seed)
{
    *seed = *seed * 6364136223846793005u + 1442695040888963407u;
    return (double)(*seed >> 11) * 0x1p-53;
}

static bool same_bits(double a, double b)
{
    return memcmp(&a, &b, sizeof a) == 0 || (isnan(a) && isnan(b));
}

/* To the bit what the single calls answer, whatever the length, and nothing beyond it written. */
static void batch(void **state)
{
    (void)state;
    enum { most = 1500 };
    static double lambda[most], beta[most], z[most], out[most + 1];
    const double odd[] = {0.0, -0.0, DBL_TRUE_MIN, 1e300, DBL_MAX, INFINITY, -1.0, NAN, 1.0, 3.2};
    uint64_t seed = 7;
    for (int i = 0; i < most; i++) {
        lambda[i] = pow(10.0, -12.0 + 26.0 * uniform(&seed));
        beta[i] = i % 3 ? pi * uniform(&seed)
                        : fmin(pi, half_pi + sqrt(fmin(1.0, 100.0 * uniform(&seed) / lambda[i])));
        z[i] = i % 3 ? cos(beta[i]) : -sqrt(fmin(1.0, 100.0 * uniform(&seed) / lambda[i]));
        if (i % 7 == 0)
            lambda[i] = odd[(size_t)(10.0 * uniform(&seed))];
        if (i % 5 == 0)
            beta[i] = z[i] = odd[(size_t)(10.0 * uniform(&seed))];
    }
    static const size_t lengths[] = {0, 1, 2, 31, 32, 33, 64, 100, most};
    for (size_t k = 0; k < sizeof lengths / sizeof *lengths; k++) {
        size_t n = lengths[k];
        for (int which = 0; which < 3; which++) {
            out[n] = -7.0;
            (which == 0   ? sg_A_h_batch
             : which == 1 ? sg_A_h_cos_batch
                          : sg_L_cos_batch)(n, lambda, which ? z : beta, out);
            assert_true(out[n] == -7.0);
            for (size_t i = 0; i < n; i++) {
                double single = which == 0   ? sg_A_h(lambda[i], beta[i])
                                : which == 1 ? sg_A_h_cos(lambda[i], z[i])
                                             : sg_L_cos(lambda[i], z[i]);
                if (!same_bits(out[i], single))
                    fail_msg("batch %d at (%.17g, %.17g): %.17g, single call: %.17g", which,
                             lambda[i], which ? z[i] : beta[i], out[i], single);
            }
        }
    }
}

static double seconds(void)
{
    struct timespec now;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

/* The rate over lambda in [1e-3, 1e4]; the bound is a quarter of what libsg promises, because the
 * machines that run tests are busy. */
static void speed(void **state)
{
    (void)state;
#if defined(__SANITIZE_ADDRESS__)
    skip();
#endif
    enum { n = 20000, repeats = 5 };
    static double lambda[n], beta[n], out[n];
    uint64_t seed = 3;
    for (int i = 0; i < n; i++) {
        lambda[i] = pow(10.0, -3.0 + 7.0 * uniform(&seed));
        beta[i] = pi * uniform(&seed);
    }
    double single = 0.0, batched = 0.0;
    for (int repeat = 0; repeat < repeats; repeat++) {
        double start = seconds();
        for (int i = 0; i < n; i++)
            out[i] = sg_A_h(lambda[i], beta[i]);
        double middle = seconds();
        sg_A_h_batch(n, lambda, beta, out);
        double end = seconds();
        single = fmax(single, n / (middle - start));
        batched = fmax(batched, n / (end - middle));
    }
    print_message("A_h: %.3g a second, in batches %.3g (%.2f times)\n", single, batched,
                  batched / single);
    assert_true(single >= 1e5);
    assert_true(batched >= 0.9 * single);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(batch),
        cmocka_unit_test(speed),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
