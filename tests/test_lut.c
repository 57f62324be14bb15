/* The look-up table, through the very look-up that a shader makes: the committed EXR files, float
 * arithmetic, texture coordinates with half texels, bilinear filter, clamped to the edge. */
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

#include "base/exr.h"
#include "base/file.h"
#include "sg.h"

typedef struct texture {
    float *texels;
    int width, height;
    float weight_steps; /* devices keep 8 bits of a filter weight: 256; 0: exact */
} texture;

static texture load(const char *name)
{
    char path[1024];
    snprintf(path, sizeof path, "%s/tables/out/%s", getenv("SGFIT_ROOT"), name);
    texture loaded = {0};
    loaded.texels = exr_read(path, NULL, &loaded.width, &loaded.height);
    assert_non_null(loaded.texels);
    assert_int_equal(loaded.width, 32);
    assert_int_equal(loaded.height, 32);
    return loaded;
}

static float texel(const texture *from, float x, float y)
{
    int i = (int)fmaxf(0, fminf(x, (float)(from->width - 1)));
    int j = (int)fmaxf(0, fminf(y, (float)(from->height - 1)));
    return from->texels[j * from->width + i];
}

/* textureLod(table, vec2(s, t), 0.0) with a linear filter and clamping to the edge. */
static float sample(const texture *from, float s, float t)
{
    float x = s * (float)from->width - 0.5F, y = t * (float)from->height - 0.5F;
    float i = floorf(x), j = floorf(y), a = x - i, b = y - j;
    if (from->weight_steps > 0) {
        a = roundf(a * from->weight_steps) / from->weight_steps;
        b = roundf(b * from->weight_steps) / from->weight_steps;
    }
    float above = texel(from, i, j) + a * (texel(from, i + 1, j) - texel(from, i, j));
    float below = texel(from, i, j + 1) + a * (texel(from, i + 1, j + 1) - texel(from, i, j + 1));
    return above + b * (below - above);
}

/* shaders/forms/table.glsl, line by line; the odd part in double, which is not what is tested. */
static float L_table(const texture *table, float lambda, float cos_theta)
{
    float root = sqrtf(fminf(lambda, 1e30F) + 2.0F);
    float u = 1.0F - 2.0F / (root * root);
    float v = fminf(fabsf(cos_theta) * root / 4.5F, 1.0F);
    float tail = sample(table, (31.0F * u + 0.5F) / 32.0F, (31.0F * v + 0.5F) / 32.0F) / root;
    return (float)(sg_mean_from_sharpness((double)lambda) * (double)fmaxf(cos_theta, 0)) + tail;
}

static double worst_error(const texture *table)
{
    double worst = 0, worst_lambda = 0, worst_cosine = 0;
    for (int i = 0; i < 400; i++) {
        float lambda = (float)pow(10, -3 + 7.0 * i / 399);
        for (int j = 0; j <= 1000; j++) {
            float z = (float)cos(3.14159265358979323846 * j / 1000);
            double error =
                fabs((double)L_table(table, lambda, z) - sg_L_cos((double)lambda, (double)z));
            if (error > worst) {
                worst = error;
                worst_lambda = (double)lambda;
                worst_cosine = (double)z;
            }
        }
    }
    print_message("largest error %.3g at lambda %.4g, cos_theta %.4g\n", worst, worst_lambda,
                  worst_cosine);
    return worst;
}

static void test_error_stays_below_the_bound(void **state)
{
    (void)state;
    static const char *const names[] = {"tail_32_float.exr", "tail_32_half.exr"};
    for (int i = 0; i < 2; i++) {
        texture table = load(names[i]);
        assert_true(worst_error(&table) < 3e-4);
        table.weight_steps = 256;
        assert_true(worst_error(&table) < 3e-4);
        free(table.texels);
    }
}

static void test_edges_and_limits(void **state)
{
    (void)state;
    texture table = load("tail_32_float.exr");
    static const float lambdas[] = {0, 1e-45F, 1e-30F, 1e-8F, 1e6F, 1e30F, 3e38F, INFINITY};
    static const float cosines[] = {-1.0000001F, -1, -0.5F, -1e-6F, 0, 1e-6F, 0.5F, 1, 1.0000001F};
    for (size_t i = 0; i < sizeof lambdas / sizeof *lambdas; i++) {
        for (size_t j = 0; j < sizeof cosines / sizeof *cosines; j++) {
            double value = (double)L_table(&table, lambdas[i], cosines[j]);
            assert_true(value >= 0);
            assert_true(fabs(value - sg_L_cos((double)lambdas[i], (double)cosines[j])) < 3e-4);
        }
    }
    free(table.texels);
}

/* Half texels: the centre of a texel gives that texel, half a texel outside gives it too. */
static void test_texel_centres(void **state)
{
    (void)state;
    texture table = load("tail_32_float.exr");
    for (int j = 0; j < 32; j++) {
        for (int i = 0; i < 32; i++) {
            float s = ((float)i + 0.5F) / 32, t = ((float)j + 0.5F) / 32;
            assert_true(sample(&table, s, t) == table.texels[32 * j + i]);
            if (i == 31)
                assert_true(sample(&table, 1, t) == table.texels[32 * j + i]);
            if (j == 0)
                assert_true(sample(&table, s, 0) == table.texels[i]);
        }
    }
    free(table.texels);
}

/* Nothing negative; the largest value stands at the terminator, 0.4413 at lambda 2.8. */
static void test_texels_are_a_tail(void **state)
{
    (void)state;
    static const char *const names[] = {"tail_32_float.exr", "tail_32_half.exr"};
    for (int f = 0; f < 2; f++) {
        texture table = load(names[f]);
        for (int i = 0; i < 32 * 32; i++)
            assert_true(table.texels[i] >= 0 && table.texels[i] < 0.45F);
        /* the last row is inside the domain (c <= 1) from lambda = 18.25 on */
        for (int i = 28; i < 32; i++)
            assert_true(table.texels[31 * 32 + i] < 1e-3F * table.texels[i]);
        free(table.texels);
    }
}

/* The half file is the float file rounded. */
static void test_half_is_the_float_rounded(void **state)
{
    (void)state;
    texture a = load("tail_32_float.exr"), b = load("tail_32_half.exr");
    size_t different = 0;
    for (int i = 0; i < 32 * 32; i++) {
        assert_true(fabsf(a.texels[i] - b.texels[i]) <= fabsf(a.texels[i]) / 2048 + 3e-8F);
        different += a.texels[i] != b.texels[i];
    }
    assert_true(different > 500);
    free(a.texels);
    free(b.texels);
}

static void test_the_mapping_is_inside(void **state)
{
    (void)state;
    static const char *const names[] = {"tail_32_float.exr", "tail_32_half.exr"};
    static const char *const texts[] = {"mapping\0string", "u = lambda/(lambda + 2) = i/31",
                                        "v = c sqrt(lambda + 2)/4.5 = j/31",
                                        "((31 u + 0.5)/32, (31 v + 0.5)/32)"};
    static const size_t lengths[] = {14, 30, 33, 34};
    for (int f = 0; f < 2; f++) {
        char path[1024];
        size_t size;
        snprintf(path, sizeof path, "%s/tables/out/%s", getenv("SGFIT_ROOT"), names[f]);
        char *bytes = base_read_file(path, &size);
        assert_non_null(bytes);
        for (int t = 0; t < 4; t++) {
            size_t at = 0;
            while (at + lengths[t] <= size && memcmp(bytes + at, texts[t], lengths[t]) != 0)
                at++;
            assert_true(at + lengths[t] <= size);
        }
        free(bytes);
    }
}

static void test_unreadable_images_are_refused(void **state)
{
    (void)state;
    int width, height;
    char path[1024];
    snprintf(path, sizeof path, "%s/tables/out/forms.inc", getenv("SGFIT_ROOT"));
    assert_null(exr_read(path, NULL, &width, &height));
    assert_null(exr_read("/nonexistent.exr", NULL, &width, &height));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_error_stays_below_the_bound),
        cmocka_unit_test(test_edges_and_limits),
        cmocka_unit_test(test_texel_centres),
        cmocka_unit_test(test_texels_are_a_tail),
        cmocka_unit_test(test_half_is_the_float_rounded),
        cmocka_unit_test(test_the_mapping_is_inside),
        cmocka_unit_test(test_unreadable_images_are_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
