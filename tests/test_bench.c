/* The cost harness: that it sees a planted slow-down, on each of its three scales. */
#include "gpu_fixture.h"

#include <math.h>
#include <string.h>

#include "cost.h"

static const char method_id[] = "meder_2018_stable";

/* The method's text with f called three times, at different arguments, for one. */
static char *planted(const char *glsl)
{
    static const char slow[] = "float slow(float lambda, float cos_theta)\n{\n"
                               "    return f(lambda, cos_theta) + f(lambda + 1.0, cos_theta) + "
                               "f(lambda, -cos_theta);\n}\n";
    size_t size = strlen(glsl) + sizeof slow + 100;
    char *text = malloc(size);
    assert_non_null(text);
    snprintf(text, size, "%s%s#define f slow\n", glsl, slow);
    return text;
}

static cost_count counted(cost_counter *counter, const char *glsl)
{
    cost_count count;
    assert_true(cost_counter_run(counter, "planted", glsl, &count));
    return count;
}

static void instructions_see_a_planted_slow_down(void **state)
{
    (void)state;
    char reason[256];
    cost_subjects subjects;
    assert_true(cost_subjects_read(&subjects, method_id));
    assert_int_equal(subjects.count, 2);
    char *slow_text = planted(subjects.list[0].glsl);
    for (int family = 0; family < COST_FAMILIES; family++) {
        cost_counter *counter = cost_counter_open(cost_families[family], reason);
        if (!counter && getenv("CI"))
            fail_msg("%s", reason);
        if (!counter)
            skip();
        cost_count fast = counted(counter, subjects.list[0].glsl);
        cost_count again = counted(counter, subjects.list[0].glsl);
        cost_count slow = counted(counter, slow_text);
        assert_memory_equal(&fast, &again, sizeof fast);
        assert_true(fast.instructions > 10);
        assert_true(slow.instructions > 1.5 * fast.instructions);
        assert_true(slow.slope > 1.5 * fast.slope);
        assert_true(slow.pixel_instructions > fast.pixel_instructions);
        assert_true(fast.pixel_instructions < fast.instructions);
        cost_counter_close(counter);
    }
    free(slow_text);
    cost_subjects_free(&subjects);
}

static float work_f32(float lambda, float cos_theta)
{
    return expf(-lambda) * cos_theta + sqrtf(lambda);
}

static float slow_f32(float lambda, float cos_theta)
{
    float sum = 0;
    for (int i = 0; i < 8; i++)
        sum += work_f32(lambda + (float)i, cos_theta);
    return sum;
}

static double work_f64(double lambda, double cos_theta)
{
    return exp(-lambda) * cos_theta + sqrt(lambda);
}

static double slow_f64(double lambda, double cos_theta)
{
    double sum = 0;
    for (int i = 0; i < 8; i++)
        sum += work_f64(lambda + i, cos_theta);
    return sum;
}

static void work_batch_f32(size_t n, const float *lambda, const float *cos_theta, float *out)
{
    for (size_t i = 0; i < n; i++)
        out[i] = work_f32(lambda[i], cos_theta[i]);
}

static void slow_batch_f32(size_t n, const float *lambda, const float *cos_theta, float *out)
{
    for (size_t i = 0; i < n; i++)
        out[i] = slow_f32(lambda[i], cos_theta[i]);
}

static void work_batch_f64(size_t n, const double *lambda, const double *cos_theta, double *out)
{
    for (size_t i = 0; i < n; i++)
        out[i] = work_f64(lambda[i], cos_theta[i]);
}

static void slow_batch_f64(size_t n, const double *lambda, const double *cos_theta, double *out)
{
    for (size_t i = 0; i < n; i++)
        out[i] = slow_f64(lambda[i], cos_theta[i]);
}

static void check_times(cost_time fast, cost_time slow)
{
    assert_true(fast.best > 0.1 && fast.best <= fast.median);
    assert_true(slow.best <= slow.median);
    assert_true(slow.best > 2 * fast.best);
}

static void cpu_times_see_a_planted_slow_down(void **state)
{
    (void)state;
    cost_points *points = malloc(sizeof *points);
    assert_non_null(points);
    cost_points_fill(points);
    check_times(cost_time_f32(points, work_f32, 9), cost_time_f32(points, slow_f32, 9));
    check_times(cost_time_f64(points, work_f64, 9), cost_time_f64(points, slow_f64, 9));
    check_times(cost_time_batch_f32(points, work_batch_f32, 9),
                cost_time_batch_f32(points, slow_batch_f32, 9));
    check_times(cost_time_batch_f64(points, work_batch_f64, 9),
                cost_time_batch_f64(points, slow_batch_f64, 9));
    free(points);
}

static void arguments_cover_their_ranges(void **state)
{
    (void)state;
    cost_points *points = malloc(sizeof *points);
    assert_non_null(points);
    cost_points_fill(points);
    int decades[6] = {0}, sides[2] = {0};
    for (int i = 0; i < COST_POINTS; i++) {
        assert_in_range((int)floor(log10(points->lambda[i]) + 2), 0, 5);
        decades[(int)floor(log10(points->lambda[i]) + 2)]++;
        sides[points->cos_theta[i] > 0]++;
        assert_true(fabs(points->cos_theta[i]) <= 1);
        assert_true(points->lambda_f32[i] == (float)points->lambda[i]);
    }
    for (int i = 0; i < 6; i++)
        assert_in_range(decades[i], COST_POINTS / 6 - 20, COST_POINTS / 6 + 20);
    assert_in_range(sides[0], COST_POINTS / 2 - 20, COST_POINTS / 2 + 20);
    free(points);
}

static void device_ratio_sees_a_planted_slow_down(void **state)
{
    (void)state;
    char reason[256];
    cost_points *points = malloc(sizeof *points);
    assert_non_null(points);
    cost_points_fill(points);
    assert_null(cost_device_open("no such device", points, reason));
    assert_non_null(strstr(reason, "no such device"));
    cost_device *device = cost_device_open("llvmpipe", points, reason);
    if (!device && getenv("CI"))
        fail_msg("%s", reason);
    if (!device)
        skip();
    cost_subjects subjects;
    assert_true(cost_subjects_read(&subjects, method_id));
    cost_subject slow = subjects.list[0];
    slow.glsl = planted(slow.glsl);
    double fast_ratio, slow_ratio;
    assert_true(cost_device_run(device, &subjects.list[0], 9, &fast_ratio));
    assert_true(cost_device_run(device, &slow, 9, &slow_ratio));
    assert_true(fast_ratio > 0.9);
    assert_true(slow_ratio > 1.2 * fast_ratio);
    free(slow.glsl);
    cost_subjects_free(&subjects);
    cost_device_close(device);
    free(points);
}

/* A table's text on the device gives what the table is for. */
static void tables_look_up_L(void **state)
{
    (void)state;
    char reason[256];
    cost_points *points = malloc(sizeof *points);
    assert_non_null(points);
    cost_points_fill(points);
    cost_device *device = cost_device_open("llvmpipe", points, reason);
    if (!device && getenv("CI"))
        fail_msg("%s", reason);
    if (!device)
        skip();
    static const double bars[] = {3e-4, 3e-4, 2e-3};
    for (size_t i = 0; i < cost_table_count(); i++) {
        cost_subjects subjects;
        assert_true(cost_subjects_read(&subjects, cost_table_id(i)));
        float pairs[] = {0, 0.5F, 0, -1, 1, 1, 7, -0.2F, 300, 0, 1e4F, 0.7F, 1e30F, 1, 1e30F, -1};
        float values[8];
        assert_true(cost_device_values(device, &subjects.list[0], 8, pairs, values));
        for (int j = 0; j < 8; j++)
            assert_true(fabs((double)values[j] -
                             sg_L_cos((double)pairs[2 * j], (double)pairs[2 * j + 1])) < bars[i]);
        cost_subjects_free(&subjects);
    }
    cost_device_close(device);
    free(points);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(instructions_see_a_planted_slow_down),
        cmocka_unit_test(cpu_times_see_a_planted_slow_down),
        cmocka_unit_test(arguments_cover_their_ranges),
        cmocka_unit_test(device_ratio_sees_a_planted_slow_down),
        cmocka_unit_test(tables_look_up_L),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
