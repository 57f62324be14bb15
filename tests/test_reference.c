/* The form factor of the tests' own ground truth: in closed form and by summing points. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "reference_render.h"

/* The reference itself: a rectangle in front in closed form, and many triangles by summing points.
 */
static void test_form_factor(void **state)
{
    (void)state;
    static const double origin[3] = {0}, up[3] = {0, 0, 1};
    const double w = 0.7, d = 1.3, h = 0.4;
    const reference_light half[2] = {{{{-w, -d, h}, {-w, d, h}, {w, -d, h}}, {0, 0, -1}, {1, 1, 1}},
                                     {{{w, d, h}, {w, -d, h}, {-w, d, h}}, {0, 0, -1}, {1, 1, 1}}};
    double x = w / h, y = d / h, sx = sqrt(1 + x * x), sy = sqrt(1 + y * y);
    double closed = 4 * (x / sx * atan(y / sx) + y / sy * atan(x / sy)) / (2 * acos(-1));
    double sum =
        reference_form_factor(&half[0], origin, up) + reference_form_factor(&half[1], origin, up);
    assert_true(fabs(sum - closed) < 1e-12);
    const reference_light behind = {{{-w, -d, h}, {w, -d, h}, {-w, d, h}}, {0, 0, 1}, {1, 1, 1}};
    assert_true(reference_form_factor(&behind, origin, up) == 0);

    uint64_t random = 88172645463325252u;
    for (int i = 0; i < 60; i++) {
        reference_light light = {0};
        double a[3], b[3], n[3], length = 0, size = 0;
        for (int k = 0; k < 12; k++) {
            random = random * 6364136223846793005u + 1442695040888963407u;
            double value = (double)(random >> 11) * 0x1p-53 * 2 - 1;
            *(k < 9 ? &light.corners[k / 3][k % 3] : &n[k - 9]) = value;
        }
        for (int k = 0; k < 3; k++) {
            light.corners[0][k] += k == 0 ? 2 : 0; /* at some distance */
            light.corners[1][k] += k == 0 ? 2 : 0;
            light.corners[2][k] += k == 0 ? 2 : 0;
            a[k] = light.corners[1][k] - light.corners[0][k];
            b[k] = light.corners[2][k] - light.corners[0][k];
            length += n[k] * n[k];
        }
        for (int k = 0; k < 3; k++) {
            n[k] /= sqrt(length);
            light.normal[k] = a[(k + 1) % 3] * b[(k + 2) % 3] - a[(k + 2) % 3] * b[(k + 1) % 3];
            size += light.normal[k] * light.normal[k];
        }
        for (int k = 0; k < 3; k++)
            light.normal[k] /= sqrt(size);
        enum { STEPS = 600 };
        double points = 0;
        for (int s = 0; s < STEPS; s++)
            for (int t = 0; t < STEPS; t++) {
                double u = (s + 0.5) / STEPS, v = (t + 0.5) / STEPS;
                double p[3], square = 0, above = 0, before = 0;
                if (u + v > 1) /* the other half of the parallelogram folds onto this one */
                    u = 1 - u, v = 1 - v;
                for (int k = 0; k < 3; k++) {
                    p[k] = light.corners[0][k] + u * a[k] + v * b[k];
                    square += p[k] * p[k];
                    above += p[k] * n[k];
                    before -= p[k] * light.normal[k];
                }
                points += fmax(above, 0) * fmax(before, 0) / (square * square);
            }
        points *= 0.5 * sqrt(size) / (acos(-1) * STEPS * STEPS);
        double factor = reference_form_factor(&light, origin, n);
        if (!(fabs(factor - points) < 2e-4 * (points + 0.1)))
            fail_msg("triangle %d: %.9g, by points %.9g", i, factor, points);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_form_factor)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
