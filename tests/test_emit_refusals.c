/* sgfit emit: what it cannot read or write it refuses in one line that names file and line, and
 * leaves earlier output as it was. */
#include <setjmp.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>

#include <cmocka.h>

#include "base/file.h"
#include "capture.h"
#include "emit_sources.h"
#include "program.h"
#include "work.h"

static void refused(const char *file, const char *text, const char *place, const char *expected)
{
    workspace_write(&work, "shaders/forms/test_form.glsl", new_form);
    workspace_write(&work, "tables/constants/test_method.json", new_method);
    workspace_write(&work, file, text);
    workspace_write(&work, "shaders/sg.glsl", "earlier");
    run emitted = emit_copy(&work);
    if (emitted.status != 2 || !strstr(emitted.error, place) || !strstr(emitted.error, expected))
        print_message("expected \"%s ... %s\", found status %d: %s\n", place, expected,
                      emitted.status, emitted.error);
    assert_int_equal(emitted.status, 2);
    assert_one_line(emitted.error, place, expected);
    run_free(&emitted);
    char *earlier = workspace_read_path(workspace_path(&work, "shaders/sg.glsl"), NULL);
    assert_string_equal(earlier, "earlier");
    free(earlier);
}

/* A form whose fifth line and later are the body given. */
static void form_refused(const char *body, const char *place, const char *expected)
{
    char text[2048], where[64];
    snprintf(text, sizeof text,
             "// test_form: for the test.\n// computes: L\n// coefficients: gain\n"
             "real sg_form(real lambda, real cos_theta)\n{\n%s}\n",
             body);
    snprintf(where, sizeof where, "test_form.glsl:%s:", place);
    refused("shaders/forms/test_form.glsl", text, where, expected);
}

static void test_bad_forms_are_refused(void **state)
{
    (void)state;
    static const struct {
        const char *body, *line, *expected;
    } cases[] = {
        {"    return 1.5 * gain;\n", "6", "every literal inside K(...), found '1.5'"},
        {"    return gain *\n        2;\n", "7", "every literal inside K(...), found '2'"},
        {"    return K(2) * gain;\n", "6", "a literal with a point or an exponent"},
        {"    return K(1.5f) * gain;\n", "6", "a literal with a point or an exponent"},
        {"    return K(1e60) * gain;\n", "6", "a literal that float can hold"},
        {"    return gian;\n", "6", "a variable declared above, a parameter or a coefficient"},
        {"    return expm1(lambda);\n", "6", "a built-in function or a helper"},
        {"    return max(lambda);\n", "6", "expected 2 arguments of max, found 1"},
        {"    return exp(lambda > K(1.0));\n", "6", "an argument of type real"},
        {"    real x = lambda;\n    if (x > K(1.0)) x = K(1.0);\n    return x;\n", "7", "use ?:"},
        {"    float x = lambda;\n    return x;\n", "6", "a declaration"},
        {"    real exp = lambda;\n    return exp;\n", "6", "a name that is not taken yet"},
        {"    real gain = lambda;\n    return gain;\n", "6", "a name that is not taken yet"},
        {"    real half = lambda;\n    return half;\n", "6", "a name that is not taken yet"},
        {"    real x = x + lambda;\n    return x;\n", "6", "a variable declared above"},
        {"    const real x = lambda;\n    x = gain;\n    return x;\n", "7", "that is not const"},
        {"    return lambda ? gain : lambda;\n", "6", "a condition of type bool"},
        {"    return lambda > K(1.0) ? gain : lambda < gain;\n", "6", "the type that the other"},
        {"    return lambda > gain;\n", "6", "a value of type real"},
        {"    bool b = lambda;\n    return gain;\n", "6", "a value of type bool"},
        {"    return lambda + (gain > lambda);\n", "6", "an operand of type real"},
        {"    return gain\n", "7", "';', found '}'"},
        {"    return (gain;\n", "6", "')', found ';'"},
        {"    return gain; /* no end\n", "6", "expected */"},
        {"    gain = lambda;\n    return gain;\n", "6", "a declaration"},
        {"    return lambda % gain;\n", "6", "';', found '%'"},
        {"    return --lambda;\n", "6", "an expression"},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++)
        form_refused(cases[i].body, cases[i].line, cases[i].expected);
    refused("shaders/forms/test_form.glsl", "// test_form: it.\nreal sg_form(real a, real b) {}\n",
            "test_form.glsl:1:", "// computes:");
    refused("shaders/forms/test_form.glsl", "no comment", "test_form.glsl:1:", "// test_form:");
    refused("shaders/forms/helpers/sg_test.glsl",
            "// sg_test: calls itself.\nreal sg_test(real x)\n{\n    return sg_test(x);\n}\n",
            "sg_test.glsl:", "no helper that calls itself");
    remove(workspace_path(&work, "shaders/forms/helpers/sg_test.glsl"));
}

static void method_refused(const char *from, const char *to, const char *place,
                           const char *expected)
{
    char text[2048];
    const char *at = strstr(new_method, from);
    assert_non_null(at);
    snprintf(text, sizeof text, "%.*s%s%s", (int)(at - new_method), new_method, to,
             at + strlen(from));
    refused("tables/constants/test_method.json", text, place, expected);
}

static void test_bad_constants_are_refused(void **state)
{
    (void)state;
    static const struct {
        const char *from, *to, *place, *expected;
    } cases[] = {
        {"\"test_form\"", "\"no_form\"", "test_method.json:2:", "\"form\" to name a file"},
        {"{\"gain\": 2}", "{}", "test_method.json:4:", "coefficient \"gain\" of form test_form"},
        {"{\"gain\": 2}", "{\"gain\": 2,\n\"loss\": 1}",
         "test_method.json:5:", "expected no coefficient \"loss\""},
        {"{\"gain\": 2}", "{\"gain\": \"two\"}", "test_method.json", "gain"},
        {"{\"gain\": 2}", "{\"gain\": 1e300}", "test_method.json:4:", "that float can hold"},
        {"\"source\"", "\"sauce\"", "test_method.json", "sauce"},
        {"\"coefficients\": {\"gain\": 2}", "\"coefficients_from\": \"nobody\"",
         "test_method.json:4:", "to name a method with coefficients"},
        {"[0.5, 10]", "[10, 0.5]", "test_method.json:3:", "low < high"},
        {"[0.5, 10]", "[0.5]", "test_method.json:3:", "[low, high]"},
        {"\"tier\"", "\"other\"", "test_method.json:1:", "published, stable, refit or tier"},
        {"\"test_method\"", "\"test_Method\"", "test_method.json:1:", "the file's name"},
        {"2001", "20.5", "test_method.json:2:", "a whole number"},
        {"}}", "}", "test_method.json", "expected"},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++)
        method_refused(cases[i].from, cases[i].to, cases[i].place, cases[i].expected);
}

/* The plain GLSL texts, from which the lobe operations and the table's look-up come. */
static void test_bad_plain_texts_are_refused(void **state)
{
    (void)state;
    refused("shaders/forms/lobe.glsl", "// no method\n", "lobe.glsl:1:", "// method: ID");
    refused("shaders/forms/lobe.glsl", "// method: no_such_method\n",
            "lobe.glsl:1:", "that names a method");
    refused("shaders/forms/lobe.glsl", "// method: test_method\n\nfloat x; /* no end\n",
            "lobe.glsl:3:", "expected */");
    copy_sources(&work);
    refused("shaders/forms/table.glsl", "\n/* no end\n", "table.glsl:2:", "expected */");
    copy_sources(&work);
}

static void test_bad_arguments_are_refused(void **state)
{
    (void)state;
    static const char *const cases[][6] = {
        {"--method", "no_such_method", "--out", "x.glsl", NULL, "no_such_method"},
        {"--method", "meder_2018", NULL, NULL, NULL, "--out"},
        {"--out", "x.glsl", "--all-to", "folder", NULL, "not both"},
        {"--root", "/nonexistent", NULL, NULL, NULL, "/nonexistent/shaders/forms"},
        {"--nonsense", NULL, NULL, NULL, NULL, "--nonsense"},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        const char *arguments[8] = {"emit"};
        for (int j = 0; j < 4; j++)
            arguments[j + 1] = cases[i][j];
        run emitted = program_run(arguments, NULL);
        assert_int_equal(emitted.status, 2);
        assert_one_line(emitted.error, cases[i][5]);
        run_free(&emitted);
    }
}

static void test_failed_writes(void **state)
{
    (void)state;
    run emitted = RUN(NULL, "emit", "--out", "/dev/full");
    assert_int_equal(emitted.status, 1);
    assert_one_line(emitted.error, "/dev/full");
    run_free(&emitted);
    emitted = RUN(NULL, "emit", "--out", "/nonexistent/sg.glsl");
    assert_int_equal(emitted.status, 1);
    assert_one_line(emitted.error, "/nonexistent/sg.glsl");
    run_free(&emitted);
    emitted = RUN(NULL, "emit", "--all-to", "/dev/null/folder");
    assert_int_equal(emitted.status, 1);
    assert_one_line(emitted.error, "/dev/null/folder");
    run_free(&emitted);
}

/* The limit's signal would end the program without a word and leave a part of the file. */
static void test_a_limit_on_files_is_told(void **state)
{
    (void)state;
    struct rlimit usual, low;
    assert_int_equal(getrlimit(RLIMIT_FSIZE, &usual), 0);
    low = usual;
    low.rlim_cur = 2048;
    char *folder = base_join(work.folder, "limited"), *path = base_join(folder, "sg.glsl");
    assert_true(base_make_directory(folder));
    assert_int_equal(setrlimit(RLIMIT_FSIZE, &low), 0);
    run emitted = RUN(NULL, "emit", "--method", "standard", "--out", path);
    assert_int_equal(setrlimit(RLIMIT_FSIZE, &usual), 0);
    assert_int_equal(emitted.status, 1);
    assert_one_line(emitted.error, "sg.glsl", "File too large");
    run_free(&emitted);
    char **names;
    size_t count;
    assert_true(base_list(folder, "", &names, &count));
    assert_int_equal(count, 0);
    base_list_free(names, count);
    free(path);
    free(folder);
}

static int open_workspace(void **state)
{
    (void)state;
    workspace_open(&work);
    copy_sources(&work);
    return 0;
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_bad_forms_are_refused),
        cmocka_unit_test(test_bad_constants_are_refused),
        cmocka_unit_test(test_bad_plain_texts_are_refused),
        cmocka_unit_test(test_bad_arguments_are_refused),
        cmocka_unit_test(test_failed_writes),
        cmocka_unit_test(test_a_limit_on_files_is_told),
    };
    return cmocka_run_group_tests(tests, open_workspace, close_work);
}
