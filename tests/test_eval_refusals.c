/* sgfit eval, run as users run it: what it refuses, and how. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "capture.h"
#include "program.h"

static void bad_input_is_one_line_that_names_the_place(void **state)
{
    (void)state;
    static const struct {
        const char *input, *place, *expected;
    } bad[] = {
        {"", "standard input", "header"},
        {"lambda\n1\n", "line 1", "beta or cos_theta"},
        {"beta,cos_theta\n1,1\n", "line 1", "no lambda"},
        {"Lambda,beta\n1,1\n", "line 1", "no lambda"},
        {"lambda,beta,lambda\n1,1,1\n", "line 1", "twice"},
        {"lambda,beta,value\n1,1,1\n", "line 1", "--column"},
        {"lambda,beta\n1,1\n1\n", "line 3", "expected 2 fields"},
        {"lambda,beta\n1,1,1\n", "line 2", "expected 2 fields"},
        {"lambda,beta\n1,\n", "line 2, column beta", "number, found \"\""},
        {"lambda,beta\n\n\nx,1\n", "line 4, column lambda", "number, found \"x\""},
        {"lambda,beta\n0x10,1\n", "line 2, column lambda", "number"},
        {"lambda,beta\n1;1,1\n", "line 2, column lambda", "number"},
        {"lambda,beta\nnan,1\n", "line 2, column lambda", "finite"},
        {"lambda,beta\n1,NaN\n", "line 2, column beta", "finite"},
        {"lambda,beta\ninf,1\n", "line 2, column lambda", "finite"},
        {"lambda,beta\n1e400,1\n", "line 2, column lambda", "finite"},
        {"lambda,beta\n-1e-300,1\n", "line 2, column lambda", "at least 0"},
        {"lambda,beta\n1,-1e-9\n", "line 2, column beta", "[0, pi]"},
        {"lambda,beta\n1,3.1416\n", "line 2, column beta", "[0, pi]"},
        {"lambda,beta\n1,3.1415926535897936\n", "line 2, column beta", "[0, pi]"},
        {"cos_theta,lambda\n1.00001,1\n", "line 2, column cos_theta", "[-1, 1]"},
        {"cos_theta,lambda\n-2,1\n", "line 2, column cos_theta", "[-1, 1]"},
        {"lambda,beta\n1,\"1\n", "line 2", "closing quote"},
    };
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++) {
        const run_options input = {.input = bad[i].input};
        run r = RUN(&input, "eval");
        assert_one_line(r.error, bad[i].place, bad[i].expected);
        assert_int_equal(r.status, 2);
        run_free(&r);
    }
}

static void rows_before_a_bad_one_are_written(void **state)
{
    (void)state;
    const run_options input = {.input = "lambda,beta\n0,1\n0,2\n0,x\n0,3\n"};
    run r = RUN(&input, "eval");
    assert_string_equal(r.out, "lambda,beta,value\n0,1,3.141592653589793\n0,2,3.141592653589793\n");
    assert_int_equal(r.status, 2);
    run_free(&r);
}

static void wrong_arguments_are_one_line(void **state)
{
    (void)state;
    static const char *const bad[][8] = {
        {"--method", "no_such"},
        {"--method", ""},
        {"--method"},
        {"--quantity", "A"},
        {"--precision", "f8"},
        {"--precision", "f32"},
        {"--method", "meder_2018", "--quantity", "H"},
        {"--method", "bessel_1d", "--quantity", "c"},
        {"--method", "bessel_1d", "--precision", "f32"},
        {"--method", "meder_2018", "--certified"},
        {"--lambda", "1"},
        {"--beta", "1"},
        {"--lambda", "1", "--beta", "1", "--cos-theta", "1"},
        {"--lambda", "-1", "--beta", "1"},
        {"--lambda", "inf", "--beta", "1"},
        {"--lambda", "nan", "--beta", "1"},
        {"--lambda", "1", "--beta", "3.15"},
        {"--lambda", "1", "--cos-theta", "1.1"},
        {"--column", "a,b"},
        {"points.csv"},
        {"--lamda", "1"},
    };
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++) {
        const char *arguments[10] = {"eval"};
        for (int k = 0; k < 8 && bad[i][k]; k++)
            arguments[k + 1] = bad[i][k];
        const run_options input = {.input = "lambda,beta\n1,1\n"};
        run r = program_run(arguments, &input);
        assert_one_line(r.error, "eval: ", "expect");
        assert_string_equal(r.out, "");
        assert_int_equal(r.status, 2);
        run_free(&r);
    }
}

static void a_full_disk_is_a_failure(void **state)
{
    (void)state;
    const run_options point = {.out_path = "/dev/full"};
    run r = RUN(&point, "eval", "--lambda", "1", "--beta", "1");
    assert_one_line(r.error, "standard output", "No space left");
    assert_int_equal(r.status, 1);
    run_free(&r);
    char *rows = malloc(1 << 20);
    size_t used = (size_t)sprintf(rows, "lambda,beta\n");
    while (used < 900000)
        used += (size_t)sprintf(rows + used, "0,1\n");
    const run_options many = {.input = rows, .out_path = "/dev/full"};
    r = RUN(&many, "eval");
    assert_one_line(r.error, "standard output", "No space left");
    assert_int_equal(r.status, 1);
    run_free(&r);
    free(rows);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(bad_input_is_one_line_that_names_the_place),
        cmocka_unit_test(rows_before_a_bad_one_are_written),
        cmocka_unit_test(wrong_arguments_are_one_line),
        cmocka_unit_test(a_full_disk_is_a_failure),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
