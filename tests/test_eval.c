/* sgfit eval, run as users run it: values, columns, precisions. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "base/text.h"
#include "capture.h"
#include "program.h"
#include "sg.h"

static const double pi = 3.14159265358979311600;

/* The last field of the given line of a CSV, line 0 being the header. */
static const char *last_field(const char *csv, int line, char *field, size_t size)
{
    while (line-- > 0 && csv)
        csv = strchr(csv, '\n') ? strchr(csv, '\n') + 1 : NULL;
    field[0] = '\0';
    if (!csv)
        return field;
    size_t length = strcspn(csv, "\n"), start = length;
    while (start > 0 && csv[start - 1] != ',')
        start--;
    snprintf(field, size, "%.*s", (int)(length - start), csv + start);
    return field;
}

static void assert_value(const char *csv, int line, double expected)
{
    char field[64], text[BASE_NUMBER_SIZE];
    base_shortest_f64(expected, text);
    assert_string_equal(last_field(csv, line, field, sizeof field), text);
}

static void keeps_rows_and_columns_as_they_are(void **state)
{
    (void)state;
    const run_options input = {.input = "name,beta, lambda ,note\r\n"
                                        "\"a,b\",0.5,2,\"say \"\"hi\"\"\"\n"
                                        "\n"
                                        " c ,1e0, +3.50 ,\r\n"
                                        "d,0,0,last"};
    run r = RUN(&input, "eval");
    char expected[512], a[BASE_NUMBER_SIZE], b[BASE_NUMBER_SIZE], c[BASE_NUMBER_SIZE];
    snprintf(expected, sizeof expected,
             "name,beta, lambda ,note,value\n\"a,b\",0.5,2,\"say \"\"hi\"\"\",%s\n"
             " c ,1e0, +3.50 ,,%s\nd,0,0,last,%s\n",
             base_shortest_f64(sg_A_h(2, 0.5), a), base_shortest_f64(sg_A_h(3.5, 1), b),
             base_shortest_f64(pi, c));
    assert_string_equal(r.out, expected);
    assert_string_equal(r.error, "");
    assert_int_equal(r.status, 0);
    run_free(&r);
}

static void every_quantity_of_the_reference_is_the_library_s(void **state)
{
    (void)state;
    static const struct {
        const char *quantity;
        double (*by_beta)(double, double), (*by_cosine)(double, double);
    } rows[] = {{"A_h", sg_A_h, sg_A_h_cos},
                {"H", sg_H, sg_H_cos},
                {"L", sg_L, sg_L_cos},
                {"c", sg_c, sg_c_cos},
                {"s", sg_s, sg_s_cos}};
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        run_options input = {.input = "lambda,beta\n0.1,0.25\n20,2\n1e300,1\n1e-300,3\n"};
        run r = RUN(&input, "eval", "--method", "reference", "--quantity", rows[i].quantity);
        assert_int_equal(r.status, 0);
        assert_value(r.out, 1, rows[i].by_beta(0.1, 0.25));
        assert_value(r.out, 2, rows[i].by_beta(20, 2));
        assert_value(r.out, 3, rows[i].by_beta(1e300, 1));
        assert_value(r.out, 4, rows[i].by_beta(1e-300, 3));
        run_free(&r);
        input.input = "cos_theta,lambda\n0.25,0.1\n-0.5,20\n";
        r = RUN(&input, "eval", "--quantity", rows[i].quantity);
        assert_int_equal(r.status, 0);
        assert_value(r.out, 1, rows[i].by_cosine(0.1, 0.25));
        assert_value(r.out, 2, rows[i].by_cosine(20, -0.5));
        run_free(&r);
    }
}

static void ends_of_the_domain_are_inside(void **state)
{
    (void)state;
    const run_options input = {.input = "lambda,beta\n0,0\n-0,1.5707963267948966\n"
                                        "4.9e-324,3.141592653589793\n1.7976931348623157e308,0\n"
                                        "1e300,3.141592653589793\n"};
    run r = RUN(&input, "eval");
    assert_string_equal(r.error, "");
    assert_value(r.out, 1, pi);
    assert_value(r.out, 2, sg_A_h(0, pi / 2));
    assert_value(r.out, 3, pi);
    assert_value(r.out, 4, sg_A_h(1.7976931348623157e308, 0));
    assert_value(r.out, 5, 0);
    run_free(&r);
    const run_options cosines = {.input = "lambda,cos_theta\n5,1.0000001\n5,-1.0000009\n"};
    r = RUN(&cosines, "eval");
    assert_string_equal(r.error, "");
    assert_value(r.out, 1, sg_A_u(5));
    assert_value(r.out, 2, sg_A_b(5));
    run_free(&r);
}

static void assert_method(const sg_method *method, const char *quantity, const char *precision)
{
    const run_options input = {.input = "lambda,beta\n1.7,0.3\n40.25,1.9\n"};
    static const double lambda[] = {1.7, 40.25}, beta[] = {0.3, 1.9};
    run r = RUN(&input, "eval", "--method", method->id, "--quantity", quantity, "--precision",
                precision);
    bool integral = strcmp(quantity, "A_h") == 0;
    if (precision[1] == '1' && !method->L_f16) {
        assert_one_line(r.error, "half floats");
        assert_int_equal(r.status, 2);
        run_free(&r);
        return;
    }
    assert_string_equal(r.error, "");
    assert_int_equal(r.status, 0);
    for (int i = 0; i < 2; i++) {
        double z = cos(beta[i]);
        char field[64], text[BASE_NUMBER_SIZE];
        if (precision[1] == '6') {
            assert_value(r.out, i + 1, (integral ? method->A_h_f64 : method->L_f64)(lambda[i], z));
            continue;
        }
        float (*f)(float, float) = precision[1] == '3'
                                       ? (integral ? method->A_h_f32 : method->L_f32)
                                       : (integral ? method->A_h_f16 : method->L_f16);
        base_shortest_f32(f((float)lambda[i], (float)z), text);
        assert_string_equal(last_field(r.out, i + 1, field, sizeof field), text);
    }
    run_free(&r);
}

static void every_method_answers_A_h_and_L_in_every_precision(void **state)
{
    (void)state;
    static const char *const precisions[] = {"f64", "f32", "f16"};
    assert_true(sg_method_count() > 0);
    for (size_t i = 0; i < sg_method_count(); i++) {
        for (size_t p = 0; p < 3; p++) {
            assert_method(sg_method_at(i), "A_h", precisions[p]);
            assert_method(sg_method_at(i), "L", precisions[p]);
        }
    }
}

static void routes_tell_the_error_they_claim(void **state)
{
    (void)state;
    assert_true(sg_route_count() > 0);
    for (size_t i = 0; i < sg_route_count(); i++) {
        const sg_route *route = sg_route_at(i);
        sg_quadrature q;
        route->A_h(3.0, 1.0, &q);
        char expected[256], claimed[BASE_NUMBER_SIZE], value[BASE_NUMBER_SIZE];
        snprintf(expected, sizeof expected, "lambda,beta,claimed_error,value\n3,1,%s,%s\n",
                 base_shortest_f64(q.claimed_error, claimed), base_shortest_f64(q.value, value));
        run r = RUN(NULL, "eval", "--method", route->id, "--lambda", "3", "--beta", "1");
        assert_string_equal(r.error, "");
        assert_string_equal(r.out, expected);
        run_free(&r);
    }
}

static void an_enclosure_holds_the_reference(void **state)
{
    (void)state;
    const run_options input = {.input = "lambda,beta\n3,1\n1e-5,0.1\n900,2\n0,0\n"};
    run r = RUN(&input, "eval", "--certified");
    if (r.status != 0) { /* built without */
        assert_int_equal(r.status, 2);
        assert_one_line(r.error, "Arb");
        run_free(&r);
        skip();
    }
    assert_memory_equal(r.out, "lambda,beta,lower,upper,value\n", 30);
    int rows = 0;
    for (const char *line = strchr(r.out, '\n') + 1; *line; line = strchr(line, '\n') + 1) {
        double lambda, beta, lower, upper, value;
        assert_int_equal(
            sscanf(line, "%lf,%lf,%lf,%lf,%lf", &lambda, &beta, &lower, &upper, &value), 5);
        assert_true(lower <= upper && upper - lower <= 1e-14 * upper);
        /* The reference at its stated error; the values here are above 1e-20. */
        assert_true(value >= lower * (1 - 2e-14) && value <= upper * (1 + 2e-14));
        rows++;
    }
    assert_int_equal(rows, 4);
    run_free(&r);
}

static void one_point_and_json(void **state)
{
    (void)state;
    run r = RUN(NULL, "eval", "--lambda=0", "--cos-theta", "-0.5", "--column", "A");
    assert_string_equal(r.out, "lambda,cos_theta,A\n0,-0.5,3.141592653589793\n");
    run_free(&r);
    r = RUN(NULL, "eval", "--lambda", "0", "--beta", "1", "--json");
    assert_string_equal(r.out,
                        "[\n  {\"lambda\": 0, \"beta\": 1, \"value\": 3.141592653589793}\n]\n");
    run_free(&r);
    const run_options input = {.input = "lambda,beta,\"na\"\"me\"\n0,1,\"a\"\"\"\n0,2,7.50\n"};
    r = RUN(&input, "eval", "--json");
    assert_string_equal(
        r.out,
        "[\n  {\"lambda\": 0, \"beta\": 1, \"na\\\"me\": \"a\\\"\", \"value\": "
        "3.141592653589793},\n"
        "  {\"lambda\": 0, \"beta\": 2, \"na\\\"me\": 7.5, \"value\": 3.141592653589793}\n]\n");
    assert_int_equal(r.status, 0);
    run_free(&r);
    const run_options no_rows = {.input = "lambda,beta\n"};
    r = RUN(&no_rows, "eval", "--json");
    assert_string_equal(r.out, "[\n]\n");
    run_free(&r);
}

static void beta_is_taken_where_there_are_both(void **state)
{
    (void)state;
    const run_options input = {.input = "lambda,cos_theta,beta\n2,0.1,3\n"};
    run r = RUN(&input, "eval");
    assert_value(r.out, 1, sg_A_h(2, 3));
    run_free(&r);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(keeps_rows_and_columns_as_they_are),
        cmocka_unit_test(every_quantity_of_the_reference_is_the_library_s),
        cmocka_unit_test(ends_of_the_domain_are_inside),
        cmocka_unit_test(every_method_answers_A_h_and_L_in_every_precision),
        cmocka_unit_test(routes_tell_the_error_they_claim),
        cmocka_unit_test(an_enclosure_holds_the_reference),
        cmocka_unit_test(one_point_and_json),
        cmocka_unit_test(beta_is_taken_where_there_are_both),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
