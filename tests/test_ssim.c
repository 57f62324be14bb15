/* Structural similarity: against its definition, window by window in double, and where its value is
 * known. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include <math.h>
#include <stdlib.h>

#include "render/render.h"

enum { WIDTH = 40, HEIGHT = 30, PIXELS = WIDTH * HEIGHT };

static float light[4 * PIXELS], truth[4 * PIXELS];

static double seen(const float *image, int x, int y)
{
    x = x < 0 ? 0 : x >= WIDTH ? WIDTH - 1 : x;
    y = y < 0 ? 0 : y >= HEIGHT ? HEIGHT - 1 : y;
    const float *p = image + 4 * (y * WIDTH + x);
    double luminance = 0.2126 * (double)p[0] + 0.7152 * (double)p[1] + 0.0722 * (double)p[2];
    return truth[4 * (y * WIDTH + x) + 3] > 0
               ? (double)render_tone(2, (float)(luminance / 3.14159265358979))
               : 0;
}

static double expect_at(int x, int y)
{
    double all = 0, a = 0, b = 0, aa = 0, bb = 0, ab = 0;
    for (int j = -5; j <= 5; j++)
        for (int i = -5; i <= 5; i++) {
            double w = exp(-(i * i + j * j) / 4.5);
            double p = seen(light, x + i, y + j), q = seen(truth, x + i, y + j);
            all += w, a += w * p, b += w * q;
            aa += w * p * p, bb += w * q * q, ab += w * p * q;
        }
    a /= all, b /= all;
    return (2 * a * b + 1e-4) * (2 * (ab / all - a * b) + 9e-4) /
           ((a * a + b * b + 1e-4) * (aa / all - a * a + bb / all - b * b + 9e-4));
}

static void fill(float noise)
{
    srand(3);
    for (int i = 0; i < PIXELS; i++) {
        bool there = i % 7 != 0 && i % WIDTH > 3;
        for (int c = 0; c < 3; c++) {
            truth[4 * i + c] = 1 + sinf(0.3F * (float)(i % WIDTH + c)) + (float)(i / WIDTH > 12);
            light[4 * i + c] =
                fmaxf(truth[4 * i + c] + noise * ((float)rand() / (float)RAND_MAX - 0.5F), 0);
        }
        truth[4 * i + 3] = light[4 * i + 3] = there ? 1 : 0;
    }
}

static void it_is_what_its_definition_says(void **state)
{
    (void)state;
    double before = 1;
    for (int step = 1; step <= 3; step++) {
        fill(0.5F * (float)step);
        double sum = 0;
        int count = 0;
        for (int y = 0; y < HEIGHT; y++)
            for (int x = 0; x < WIDTH; x++)
                if (truth[4 * (y * WIDTH + x) + 3] > 0) {
                    sum += expect_at(x, y);
                    count++;
                }
        double found = render_ssim(WIDTH, HEIGHT, 2, light, truth);
        assert_true(fabs(found - sum / count) < 1e-4);
        assert_true(found < before - 0.01); /* more noise, less similar */
        before = found;
    }
}

static void the_same_is_one(void **state)
{
    (void)state;
    fill(0);
    assert_true(fabs(render_ssim(WIDTH, HEIGHT, 2, light, truth) - 1) < 1e-6);
    for (int i = 0; i < 4 * PIXELS; i++)
        truth[i] = light[i] = 0; /* no surface */
    assert_true(render_ssim(WIDTH, HEIGHT, 2, light, truth) == 1);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(it_is_what_its_definition_says),
        cmocka_unit_test(the_same_is_one),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
