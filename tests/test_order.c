/* Order statistics. */
#include <math.h>
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

static void test_selects(void **state)
{
    (void)state;
    enum { COUNT = 997 };
    double values[COUNT], sorted[COUNT];
    for (size_t rank = 0; rank < COUNT; rank += 83)
        for (int kind = 0; kind < 4; kind++) { /* mixed, many equal, rising, falling */
            for (int i = 0; i < COUNT; i++)
                sorted[i] = values[i] = kind == 0   ? (i * 7919) % COUNT
                                        : kind == 1 ? (i * 31) % 3
                                        : kind == 2 ? i
                                                    : -i;
            base_sort(sorted, COUNT);
            assert_true(base_select(values, COUNT, rank) == sorted[rank]);
            for (size_t i = 0; i < COUNT; i++)
                assert_true(i < rank ? values[i] <= sorted[rank] : values[i] >= sorted[rank]);
        }
    double strange[] = {2, NAN, 1, NAN, NAN, 3};
    for (size_t rank = 0; rank < 6; rank++)
        base_select(strange, 6, rank); /* ends */
    assert_true(base_select((double[]){5}, 1, 0) == 5);
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
        cmocka_unit_test(test_selects),
        cmocka_unit_test(test_medians),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
