/* lib/base: command lines and work spread over the cores. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "base/options.h"
#include "base/progress.h"
#include "capture.h"

typedef struct option_values {
    bool flag, given;
    const char *text, *choice;
    double number;
    long whole;
} option_values;

static int parse(option_values *v, int *positional, int argc, char **argv)
{
    const base_usage usage = {"try", "", ""};
    const base_option options[] = {{"flag", BASE_FLAG, &v->flag, NULL, "", NULL},
                                   {"text", BASE_STRING, &v->text, "NAME", "", NULL},
                                   {"number", BASE_F64, &v->number, "X", "", &v->given},
                                   {"whole", BASE_LONG, &v->whole, "N", "", NULL},
                                   {"choice", BASE_CHOICE, &v->choice, "a|bc", "", NULL}};
    return base_parse_options(argc, argv, &usage, options, 5, positional);
}

static void options_are_taken_in_both_spellings(void **state)
{
    (void)state;
    option_values v = {0};
    int positional;
    char *argv[] = {"try",      "one", "--flag",  "--number", "-1.5", "--text=a=b", "-",
                    "--choice", "bc",  "--whole", "7",        "--",   "--two"};
    assert_int_equal(parse(&v, &positional, 13, argv), -1);
    assert_true(v.flag && v.given && v.number == -1.5 && v.whole == 7);
    assert_string_equal(v.text, "a=b");
    assert_string_equal(v.choice, "bc");
    assert_int_equal(positional, 3);
    assert_string_equal(argv[1], "one");
    assert_string_equal(argv[2], "-");
    assert_string_equal(argv[3], "--two");
}

static void wrong_options_are_one_line(void **state)
{
    (void)state;
    static char *bad[][4] = {{"try", "--other"},          {"try", "-x"},
                             {"try", "--number", "x"},    {"try", "--number"},
                             {"try", "--number", "nan"},  {"try", "--text", "--flag"},
                             {"try", "--text="},          {"try", "--flag=1"},
                             {"try", "--choice", "b"},    {"try", "--whole", "1.5"},
                             {"try", "--flag", "--flag"}, {"try", "positional"}};
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++) {
        option_values v = {0};
        int argc = 0;
        while (argc < 4 && bad[i][argc])
            argc++;
        capture c;
        capture_begin(&c);
        int status = parse(&v, NULL, argc, bad[i]);
        assert_one_line(capture_end(&c), "try: ", argc > 2 ? "expect" : "");
        assert_int_equal(status, BASE_USAGE);
    }
}

static void help_is_wrapped_below_itself(void **state)
{
    (void)state;
    static const char text[] =
        "A line that is longer than ninety-eight characters, which is where help is broken at a "
        "blank, goes on.\n"
        "  NAME  a line of a list that is longer than ninety-eight characters goes on below where "
        "its text begins\n"
        "and the next one at its own begin";
    const base_usage usage = {"try", "", text};
    const base_option option = {"flag", BASE_FLAG, &(bool){false}, NULL, "", NULL};
    FILE *file = tmpfile();
    char out[1024];
    fflush(stdout);
    int saved = dup(STDOUT_FILENO);
    dup2(fileno(file), STDOUT_FILENO);
    int status = base_parse_options(2, (char *[]){"try", "--help", NULL}, &usage, &option, 1, NULL);
    fflush(stdout);
    dup2(saved, STDOUT_FILENO);
    close(saved);
    rewind(file);
    out[fread(out, 1, sizeof out - 1, file)] = '\0';
    fclose(file);
    assert_int_equal(status, BASE_DONE);
    assert_non_null(strstr(out, "blank, goes\non.\n  NAME  a line"));
    assert_non_null(strstr(out, "\n        begins\nand the next"));
}

static void count_up(void *context, size_t index)
{
    ((int *)context)[index]++;
}

static void parallel_work_is_done_once_each(void **state)
{
    (void)state;
    static int done[10000];
    base_parallel(10000, count_up, done);
    for (size_t i = 0; i < 10000; i++)
        assert_int_equal(done[i], 1);
    base_parallel(0, count_up, NULL);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(options_are_taken_in_both_spellings),
        cmocka_unit_test(wrong_options_are_one_line),
        cmocka_unit_test(help_is_wrapped_below_itself),
        cmocka_unit_test(parallel_work_is_done_once_each),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
