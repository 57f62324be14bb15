/* lib/base/json: numbers that survive, layout, and what is refused. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "base/file.h"
#include "base/json.h"
#include "base/text.h"
#include "capture.h"
#include "work.h"

static void json_numbers_survive_a_round_trip(void **state)
{
    (void)state;
    static const double values[] = {0.1, 1.0 / 3.0, 5e-324, 1.7976931348623157e308,
                                    76.087896272360737};
    cJSON *root = cJSON_CreateObject();
    cJSON *array = cJSON_AddArrayToObject(root, "values");
    for (size_t i = 0; i < 5; i++)
        cJSON_AddItemToArray(array, base_json_number(values[i]));
    base_json_add_f64(root, "top", (double)INFINITY);
    base_json_add_f64(root, "third", 1.0 / 3.0);
    cJSON_AddStringToObject(root, "text", "a \"quote\",\n\ttab and \x01");
    char *text = base_json_print(root);
    char *path = workspace_file(&work, "round.json", text);
    cJSON *back = base_json_read(path);
    assert_non_null(back);
    for (int i = 0; i < 5; i++)
        assert_true(cJSON_GetArrayItem(cJSON_GetObjectItem(back, "values"), i)->valuedouble ==
                    values[i]);
    double value;
    assert_true(base_json_f64(back, path, "top", &value) && isinf(value));
    assert_true(base_json_f64(root, path, "third", &value) && value == 1.0 / 3.0);
    const char *string;
    assert_true(base_json_string(back, path, "text", &string));
    assert_string_equal(string, "a \"quote\",\n\ttab and \x01");
    char *again = base_json_print(back);
    assert_string_equal(again, text);
    free(again);
    free(text);
    free(path);
    cJSON_Delete(root);
    cJSON_Delete(back);
}

static void json_layout(void **state)
{
    (void)state;
    cJSON *root = cJSON_Parse("{\"a\":[1,2.5,\"x\"],\"b\":{\"c\":[[1],[2]]},\"d\":[],\"e\":{}}");
    char *text = base_json_print(root);
    assert_string_equal(text, "{\n  \"a\": [1, 2.5, \"x\"],\n  \"b\": {\n    \"c\": [\n      [1],\n"
                              "      [2]\n    ]\n  },\n  \"d\": [],\n  \"e\": {}\n}\n");
    free(text);
    cJSON_Delete(root);
}

static void text_that_is_no_utf_8_is_marked(void **state)
{
    (void)state;
    char *text =
        base_json_quote("\xc3\xa9 \xe2\x82\xac \xf0\x9f\x99\x82 \xe9t\xe9 \xc0\xaf \xed\xa0\x80");
#define MARK "\xef\xbf\xbd"
    assert_string_equal(text, "\"\xc3\xa9 \xe2\x82\xac \xf0\x9f\x99\x82 " MARK "t" MARK
                              " " MARK MARK " " MARK MARK MARK "\"");
    free(text);
}

static void bad_json_names_the_place(void **state)
{
    (void)state;
    static const struct {
        const char *text, *word;
    } bad[] = {{"", "line 1"},
               {"{\n\"a\": 1,\n}",
                "line 3, column 1: expected another key in double quotes after the "
                "comma, found \"}\""},
               {"{\"a\": [1, 2,]}", "line 1, column 13: expected another value after the comma"},
               {"{\"\xc3\xa9\": 1 2}", "line 1, column 9: expected a comma or }"},
               {"{\"a\": [1\n 2]}", "line 2, column 2: expected a comma or ]"},
               {"{\"a\"\n1}", "line 2, column 1: expected a colon"},
               {"{a: 1}", "column 2: expected a key in double quotes"},
               {"{'a': 1}", "column 2: expected a key in double quotes"},
               {"[1, // one\n2]", "column 5: expected a value"},
               {"{\"a\": True}", "column 7: expected a value"},
               {"{\"a\": }", "column 7: expected a value"},
               {"[\"\\x\"]", "column 3: expected a character after \\"},
               {"[\"\\ud800\"]", "column 3: expected a character after \\"},
               {"[\"\\u0000\"]", "column 3: expected a character after \\"},
               {"[\"abc", "column 6: expected a closing quote, found the end of the file"},
               {"[1]\n]", "line 2, column 1: expected nothing after the value"},
               {"{\n\"a\": 01}", "line 2"},
               {"{\"a\": 1.}", "number"},
               {"{\"a\": +1}", "number"},
               {"{\"a\": 1e999}", "number"},
               {"{\"a\": NaN}", "line 1"},
               {"{} x", "line 1"},
               {"{\"a\":\n\n\"x\ny\"}", "line 3"},
               {"[1,\n2", "line 2"}};
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++) {
        char *path = workspace_file(&work, "bad.json", bad[i].text);
        capture c;
        capture_begin(&c);
        cJSON *root = base_json_read(path);
        assert_one_line(capture_end(&c), "bad.json", bad[i].word);
        assert_null(root);
        free(path);
    }
}

static void good_json_is_read(void **state)
{
    (void)state;
    static const char *const good[] = {"\xef\xbb\xbf{}",
                                       " [ ] ",
                                       "{ \"a\" : [ { } , [ ] , null ] , \"b\" : -0.5e-3 }\r\n",
                                       "\"\\ud83d\\ude42 \\u00e9 \\/ \\\" \\\\\"",
                                       "true",
                                       "[1E5,0,-0,0.0]"};
    for (size_t i = 0; i < sizeof good / sizeof *good; i++) {
        char *path = workspace_file(&work, "good.json", good[i]);
        cJSON *root = base_json_read(path);
        assert_non_null(root);
        cJSON_Delete(root);
        free(path);
    }
    enum { DEEP = 100000 };
    char *deep = malloc(DEEP + 1);
    memset(deep, '[', DEEP);
    deep[DEEP] = '\0';
    const char *expected;
    assert_ptr_equal(base_json_fault(deep, &expected), deep + 1000);
    free(deep);
}

static void json_fields_are_checked(void **state)
{
    (void)state;
    cJSON *root = cJSON_Parse("{\"a\":1,\"b\":\"x\",\"a\":2}");
    capture c;
    capture_begin(&c);
    bool good = base_json_only(root, "f.json", (const char *const[]){"a", NULL});
    assert_one_line(capture_end(&c), "f.json", "unknown key \"b\"", "expected \"a\"");
    assert_false(good);
    capture_begin(&c);
    good = base_json_only(root, "f.json", (const char *const[]){"a", "b", NULL});
    assert_one_line(capture_end(&c), "f.json", "\"a\"", "twice");
    assert_false(good);
    double value;
    const char *text;
    const cJSON *object;
    capture_begin(&c);
    good = base_json_f64(root, "f.json", "b", &value);
    assert_one_line(capture_end(&c), "f.json", "\"b\"", "a number", "a string");
    assert_false(good);
    capture_begin(&c);
    good = base_json_string(root, "f.json", "a", &text);
    assert_one_line(capture_end(&c), "f.json", "\"a\"", "a string", "a number");
    assert_false(good);
    capture_begin(&c);
    good = base_json_object(root, "f.json", "z", &object);
    assert_one_line(capture_end(&c), "f.json", "\"z\"", "an object", "nothing");
    assert_false(good);
    cJSON_Delete(root);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(json_numbers_survive_a_round_trip),
        cmocka_unit_test(json_layout),
        cmocka_unit_test(text_that_is_no_utf_8_is_marked),
        cmocka_unit_test(bad_json_names_the_place),
        cmocka_unit_test(good_json_is_read),
        cmocka_unit_test(json_fields_are_checked),
    };
    return cmocka_run_group_tests(tests, open_work, close_work);
}
