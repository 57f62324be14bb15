/* lib/base/csv: rows and fields, and what is refused. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

#include "base/csv.h"
#include "capture.h"

static FILE *text_stream(const char *text, size_t size)
{
    FILE *stream = tmpfile();
    fwrite(text, 1, size, stream);
    rewind(stream);
    return stream;
}

static void csv_reads_quotes_and_line_ends(void **state)
{
    (void)state;
    const char *text = "\xef\xbb\xbf"
                       "a, b ,\"c\"\"d\"\r\n\n1,\"x,\"\"y\n\",3\r\n5\" nail, 2,";
    base_csv csv;
    FILE *stream = text_stream(text, strlen(text));
    assert_true(base_csv_open(&csv, stream, "test"));
    assert_int_equal(csv.columns, 3);
    assert_int_equal(base_csv_column(&csv, "b"), 1);
    assert_int_equal(base_csv_column(&csv, "c\"d"), 2);
    assert_int_equal(base_csv_column(&csv, "none"), -1);
    assert_int_equal(base_csv_next(&csv), 1);
    assert_int_equal(csv.line, 3);
    assert_string_equal(csv.row, "1,\"x,\"\"y\n\",3");
    assert_string_equal(csv.fields[1], "x,\"y\n");
    double value;
    assert_true(base_csv_f64(&csv, 2, &value) && value == 3.0);
    assert_int_equal(base_csv_next(&csv), 1);
    assert_int_equal(csv.line, 5);
    assert_string_equal(csv.fields[0], "5\" nail");
    assert_int_equal(csv.lengths[2], 0);
    assert_int_equal(base_csv_next(&csv), 0);
    base_csv_close(&csv);
    fclose(stream);
}

static void csv_names_the_line_of_what_is_wrong(void **state)
{
    (void)state;
    static const struct {
        const char *text;
        size_t size;
        const char *word;
    } bad[] = {{"", 0, "header"},
               {"\n \n", 3, "header"},
               {"a,a\n", 4, "twice"},
               {"a,b\n1,2\n1\n", 10, "line 3"},
               {"a,b\n1,2,3\n", 10, "line 2"},
               {"a,b\n1,\"2\n", 9, "closing quote"},
               {"a,b\n\"1\"x,2\n", 11, "comma"},
               {"a,b\n1,\0"
                "2\n",
                9, "NUL"},
               {"a\nx\n", 4, "line 2, column a: expected a finite number, found \"x\""},
               {"a\n\"\"\n", 5, "line 2, column a"},
               {"a\nnan\n", 6, "line 2, column a"},
               {"a\n-inf\n", 7, "line 2, column a"}};
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++) {
        FILE *stream = text_stream(bad[i].text, bad[i].size);
        capture c;
        base_csv csv;
        double value;
        capture_begin(&c);
        bool good = base_csv_open(&csv, stream, "test");
        int status = 1;
        while (good && (status = base_csv_next(&csv)) == 1 && csv.columns > 1)
            ;
        if (good && csv.columns == 1)
            good = status == 1 && base_csv_f64(&csv, 0, &value);
        else
            good = good && status == 0;
        base_csv_close(&csv);
        fclose(stream);
        assert_one_line(capture_end(&c), "test", bad[i].word);
        assert_false(good);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(csv_reads_quotes_and_line_ends),
        cmocka_unit_test(csv_names_the_line_of_what_is_wrong),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
