/* render_compare on arrays made by hand, the curve of the pictures, and the file of what a frame
 * integrates. */
#include "render_fixture.h"
#include "workspace.h"

#include "base/csv.h"
#include "render/output.h"

static void one_pixel_is_its_error_over_the_mean(void **state)
{
    (void)state;
    const float truth[4] = {1, 2, 3, 1}, light[4] = {1, 2, 6, 1}; /* mean 2 */
    float error;
    render_comparison result;
    render_compare(1, light, truth, &error, &result);
    double expected = sqrt(9.0 / 3) / 2;
    assert_near((double)error, expected, 1e-6);
    assert_near(result.rel, expected, 1e-12);
    assert_near(result.p50, expected, 1e-6);
    assert_near(result.p999, expected, 1e-6);
    assert_near(result.bias, 0.5, 1e-12);
}

/* Errors 0.001 to 1 in steps of 0.001, in disorder: each percentile is the least error that is not
 * below its share. */
static void percentiles_are_of_the_errors_in_order(void **state)
{
    (void)state;
    enum { COUNT = 1000 };
    static float truth[4 * COUNT], light[4 * COUNT];
    double squares = 0, sum = 0;
    for (int i = 0; i < COUNT; i++) {
        int place = i * 7 % COUNT + 1;
        for (int c = 0; c < 4; c++)
            truth[4 * i + c] = light[4 * i + c] = 1;
        for (int c = 0; c < 3; c++)
            light[4 * i + c] += (float)place / COUNT * (i % 2 ? 1 : -1);
        squares += pow((double)place / COUNT, 2);
        sum += (double)place / COUNT * (i % 2 ? 1 : -1);
    }
    render_comparison result;
    render_compare(COUNT, light, truth, NULL, &result);
    assert_near(result.p50, 0.5, 1e-6);
    assert_near(result.p95, 0.95, 1e-6);
    assert_near(result.p99, 0.99, 1e-6);
    assert_near(result.p999, 0.999, 1e-6);
    assert_near(result.rel, sqrt(squares / COUNT), 1e-6);
    assert_near(result.bias, sum / COUNT, 1e-6);
}

static void only_covered_pixels_count(void **state)
{
    (void)state;
    /* lit, without a surface, uncovered, wrongly owned */
    const float truth[16] = {1, 1, 1, 1, 9, 9, 9, 0, 7, 7, 7, 1, 3, 3, 3, 1};
    const float light[16] = {1, 1, 1, 1, 0, 0, 0, 0, 0, 0, 0, -1, 5, 5, 5, -2};
    float errors[4];
    render_comparison result;
    render_compare(4, light, truth, errors, &result);
    /* the mean is that of the first and the last */
    const double expected[4] = {0, 0, 0, 1};
    for (int i = 0; i < 4; i++)
        assert_near((double)errors[i], expected[i], 1e-6);
    assert_near(result.rel, sqrt(0.5), 1e-6);
    assert_near(result.bias, 0.5, 1e-6);
}

static void nothing_and_darkness_are_no_error(void **state)
{
    (void)state;
    render_comparison result;
    render_compare(0, NULL, NULL, NULL, &result);
    assert_true(result.rel == 0 && result.p999 == 0 && result.bias == 0);
    const float black[8] = {0, 0, 0, 1, 0, 0, 0, 0};
    render_compare(2, black, black, NULL, &result);
    assert_true(result.rel == 0 && result.p999 == 0 && result.bias == 0);
    const float lit[8] = {1, 0, 0, 1, 0, 0, 0, 0};
    render_compare(2, lit, black, NULL, &result);
    assert_true(isinf(result.rel) && isinf(result.p50) && isinf(result.bias));
}

static void the_curve_rises_from_black_to_white(void **state)
{
    (void)state;
    assert_true(render_tone(2, 0) == 0);
    assert_true(render_tone(2, -1) == 0);
    assert_true(render_tone(2, NAN) == 0);
    assert_near((double)render_tone(2, 0.5F), 17.0 / 32, 1e-6);
    assert_near((double)render_tone(2, 2), 1, 1e-6);
    assert_true(render_tone(2, INFINITY) == 1);
    for (float x = 0; x < 4; x += 0.01F)
        assert_true(render_tone(1, x) < render_tone(1, x + 0.01F) || x > 3.98F);
}

/* Two points of one cell become their weighted mean, others stay as they are, and what cannot be
 * integrated is left out; weights become shares. */
static void profiles_merge_what_is_close(void **state)
{
    (void)state;
    static const float points[] = {10, 0.5F,  3,  10.1F,    0.501F, 1, 200, -1,    4,
                                   0,  0,     1,  1,        NAN,    1, 1,   0.25F, 0,
                                   1,  0.25F, -1, INFINITY, 0,      1, NAN, 0,     1};
    workspace at;
    workspace_open(&at);
    const char *path = workspace_path(&at, "profile.csv");
    assert_true(output_profile(path, points, sizeof points / sizeof *points / 3));
    FILE *file = fopen(path, "rb");
    assert_non_null(file);
    base_csv csv;
    assert_true(base_csv_open(&csv, file, path));
    const double expected[2][3] = {{10.0249, 0.50025, 0.5}, {200, -1, 0.5}};
    for (int row = 0; row < 2; row++) {
        assert_int_equal(base_csv_next(&csv), 1);
        static const char *const names[3] = {"lambda", "cos_theta", "weight"};
        for (int i = 0; i < 3; i++) {
            double value;
            assert_true(base_csv_f64(&csv, base_csv_column(&csv, names[i]), &value));
            assert_near(value, expected[row][i], 1e-4 * fabs(expected[row][i]));
        }
    }
    assert_int_equal(base_csv_next(&csv), 0);
    base_csv_close(&csv);
    fclose(file);
    workspace_close(&at);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(one_pixel_is_its_error_over_the_mean),
        cmocka_unit_test(percentiles_are_of_the_errors_in_order),
        cmocka_unit_test(only_covered_pixels_count),
        cmocka_unit_test(nothing_and_darkness_are_no_error),
        cmocka_unit_test(the_curve_rises_from_black_to_white),
        cmocka_unit_test(profiles_merge_what_is_close),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
