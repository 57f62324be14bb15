/* lib/base/text: numbers as text and back; one-line diagnostics. */
#include <limits.h>
#include <locale.h>
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "base/text.h"
#include "capture.h"

static void assert_text(double value, const char *expected)
{
    char text[BASE_NUMBER_SIZE];
    assert_string_equal(base_shortest_f64(value, text), expected);
}

static void shortest_text_of_known_doubles(void **state)
{
    (void)state;
    assert_text(0.0, "0");
    assert_text(-0.0, "-0");
    assert_text(0.1, "0.1");
    assert_text(1.0 / 3.0, "0.3333333333333333");
    assert_text(-2.5, "-2.5");
    assert_text(100.0, "100");
    assert_text(2024.0, "2024");
    assert_text(1e22, "1e22");
    assert_text(1.5e-9, "1.5e-9");
    assert_text(123456.75, "123456.75");
    assert_text(5e-324, "5e-324");
    assert_text(2.2250738585072014e-308, "2.2250738585072014e-308");
    assert_text(1.7976931348623157e308, "1.7976931348623157e308");
    assert_text(0x1p-44,
                "5.684341886080802e-14"); /* where the nearest 16 digits do not read back */
    assert_text(9007199254740993.0, "9007199254740992");
    assert_text((double)INFINITY, "inf");
    assert_text(-(double)INFINITY, "-inf");
    assert_text((double)NAN, "nan");
    char text[BASE_NUMBER_SIZE];
    assert_string_equal(base_shortest_f32(0.1f, text), "0.1");
    assert_string_equal(base_shortest_f32(16777216.0f, text), "16777216");
    assert_string_equal(base_shortest_f32(1e-45f, text), "1e-45");
}

static uint64_t next_random(uint64_t *x)
{
    *x ^= *x << 13;
    *x ^= *x >> 7;
    *x ^= *x << 17;
    return *x;
}

static int significant_digits(const char *text)
{
    int digits = 0, zeros = 0;
    bool point = false;
    for (const char *p = text; *p && *p != 'e'; p++) {
        point = point || *p == '.';
        if (*p < '0' || *p > '9' || (*p == '0' && digits == 0))
            continue;
        digits++;
        zeros = *p == '0' ? zeros + 1 : 0;
    }
    return point ? digits : digits - zeros;
}

/* Reads back, with as few digits as printf can do it. */
static void shortest_text_of_random_bits_reads_back(void **state)
{
    (void)state;
    uint64_t x = 88172645463325252u;
    for (int i = 0; i < 20000; i++) {
        uint64_t bits = next_random(&x);
        double value, back;
        memcpy(&value, &bits, sizeof value);
        if (!isfinite(value))
            continue;
        char text[BASE_NUMBER_SIZE], tried[BASE_NUMBER_SIZE];
        base_shortest_f64(value, text);
        assert_true(base_parse_f64(text, strlen(text), &back) && back == value);
        int digits = 0;
        do
            snprintf(tried, sizeof tried, "%.*e", digits++, value);
        while (strtod(tried, NULL) != value);
        assert_true(significant_digits(text) <= digits);
        uint32_t half = (uint32_t)bits;
        float single;
        memcpy(&single, &half, sizeof single);
        if (isfinite(single))
            assert_true(strtof(base_shortest_f32(single, text), NULL) == single);
    }
}

static void numbers_do_not_follow_the_locale(void **state)
{
    (void)state;
    const char *names[] = {"de_DE.UTF-8", "de_DE.utf8", "fr_FR.UTF-8"};
    bool found = false;
    for (size_t i = 0; i < 3 && !found; i++)
        found = setlocale(LC_ALL, names[i]) != NULL;
    if (!found)
        skip(); /* no such locale on this machine */
    double value;
    assert_text(0.5, "0.5");
    assert_true(base_parse_f64("0.12345678901234567", 19, &value));
    setlocale(LC_ALL, "C");
    assert_true(value == 0.12345678901234567);
}

static void parsing_takes_whole_numbers_only(void **state)
{
    (void)state;
    static const struct {
        const char *text;
        double value;
    } good[] = {{"1", 1},
                {" 1.5\t", 1.5},
                {"-.5", -0.5},
                {"1.", 1},
                {"+3e2", 300},
                {"1E-3", 1e-3},
                {"1e400", HUGE_VAL},
                {"inf", HUGE_VAL},
                {"-Infinity", -HUGE_VAL},
                {"1e-400", 0},
                {"123456789012345678901234567890", 123456789012345678901234567890.0},
                {"0.1000000000000000055511151231257827021181583404541015625", 0.1},
                {"9007199254740993", 9007199254740992.0},
                {"4.35", 4.35},
                {"1e23", 1e23}};
    static const char *const bad[] = {"",   " ",    "1x",  "1 2",  "0x10", "1e",
                                      "e1", ".",    "--1", "1,5",  "+",    "1e+",
                                      "n",  "nane", "in",  "1..2", "\n1",  "1_000"};
    double value;
    for (size_t i = 0; i < sizeof good / sizeof *good; i++) {
        assert_true(base_parse_f64(good[i].text, strlen(good[i].text), &value));
        assert_true(value == good[i].value);
    }
    assert_true(base_parse_f64("NaN", 3, &value) && isnan(value));
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++)
        assert_false(base_parse_f64(bad[i], strlen(bad[i]), &value));
    long whole;
    assert_true(base_parse_long("-9223372036854775808", &whole) && whole == LONG_MIN);
    assert_false(base_parse_long("9223372036854775808", &whole));
    assert_false(base_parse_long("1.0", &whole));
    assert_false(base_parse_long("", &whole));
}

static void an_error_is_one_line_whatever_it_names(void **state)
{
    (void)state;
    capture c;
    capture_begin(&c);
    base_error("cannot read %s", "a\nb\r\033[31mc");
    assert_string_equal(capture_end(&c), "sgfit: cannot read a?b??[31mc\n");
    char longest[5000];
    memset(longest, 'x', sizeof longest - 1);
    longest[sizeof longest - 1] = '\0';
    capture_begin(&c);
    base_error("%s", longest);
    assert_one_line(capture_end(&c), "xxx");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(shortest_text_of_known_doubles),
        cmocka_unit_test(shortest_text_of_random_bits_reads_back),
        cmocka_unit_test(numbers_do_not_follow_the_locale),
        cmocka_unit_test(parsing_takes_whole_numbers_only),
        cmocka_unit_test(an_error_is_one_line_whatever_it_names),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
