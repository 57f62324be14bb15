/* Order statistics. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "base/order.h"

static void test_sorts(void **state)
{
    (void)state;
    double values[] = {3, -1e300, 0.5, 3, 1e-300, 0};
    base_sort(values, 6);
    for (int i = 1; i < 6; i++)
        assert_true(values[i - 1] <= values[i]);
    assert_true(values[0] == -1e300 && values[5] == 3);
    base_sort(values, 0);
}

static void test_medians(void **state)
{
    (void)state;
    assert_true(base_median((double[]){7}, 1) == 7);
    assert_true(base_median((double[]){9, 1, 5}, 3) == 5);
    assert_true(base_median((double[]){9, 1, 5, 4}, 4) == 4.5);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_sorts),
        cmocka_unit_test(test_medians),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
