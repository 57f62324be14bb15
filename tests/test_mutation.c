/* Damaged input: CSV and JSON with random bytes changed, cut, repeated. Whatever comes in, a reader
 * takes it or says one line; it neither crashes nor loops. Seeds are fixed. */
#include <setjmp.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <sys/stat.h>

#include <cmocka.h>

#include "base/csv.h"
#include "base/file.h"
#include "base/json.h"
#include "base/text.h"
#include "capture.h"
#include "mutate.h"
#include "program.h"
#include "workspace.h"

static const char *const csv_seeds[] = {
    "lambda,beta\n1,0.5\n2.5e3,3.14159\n0,0\n",
    "name,\"la\"\"mbda\",lambda,cos_theta\r\n\"a,b\",\"x\ny\",1,-0.25\r\n,,7,1\r\n",
    "\xef\xbb\xbf"
    "cos_theta,lambda,value2\n0.1, 1e-300 ,\n\n-1,1e300,\"\"\n"};

/* Reads all rows; whether the input was taken. Checks what a caller relies on. */
static bool read_csv(const char *bytes, size_t size)
{
    FILE *stream = fmemopen((void *)(uintptr_t)bytes, size, "r");
    base_csv csv;
    bool good = base_csv_open(&csv, stream, "damaged");
    int status = 0;
    while (good && (status = base_csv_next(&csv)) == 1) {
        size_t total = 0;
        for (size_t i = 0; i < csv.columns; i++) {
            assert_int_equal(strlen(csv.fields[i]), csv.lengths[i]);
            total += csv.lengths[i] + 1;
        }
        assert_true(total <= csv.row_length + 1);
        assert_int_equal(strlen(csv.row), csv.row_length);
    }
    base_csv_close(&csv);
    fclose(stream);
    return good && status == 0;
}

static int count_lines(FILE *file)
{
    int lines = 0;
    rewind(file);
    for (int c; (c = getc(file)) != EOF;)
        lines += c == '\n';
    return lines;
}

static void damaged_csv_is_taken_or_told_in_one_line(void **state)
{
    (void)state;
    capture c;
    int taken = 0, refused = 0;
    random_state = 0x9e3779b97f4a7c15u;
    capture_begin(&c);
    for (int i = 0; i < 30000; i++) {
        char bytes[MOST];
        size_t size = mutate(csv_seeds[i % 3], bytes);
        if (size == 0)
            continue;
        if (read_csv(bytes, size))
            taken++;
        else
            refused++;
    }
    fflush(stderr);
    int lines = count_lines(c.file);
    capture_end(&c);
    assert_int_equal(lines, refused);
    assert_true(taken > 1000 && refused > 1000); /* the mutations reach both sides */
}

static const char json_seed[] =
    "{\n  \"id\": \"x\\u00e9\\n\",\n  \"domain\": {\"lambda\": [0, \"inf\"]},\n"
    "  \"coefficients\": {\"a\": -1.5e-7, \"b\": 2},\n  \"list\": [[1, 2], [], {}, true, "
    "null]\n}\n";

static void damaged_json_is_taken_or_told_in_one_line(void **state)
{
    (void)state;
    workspace work;
    workspace_open(&work);
    char *path = workspace_file(&work, "mutated.json", NULL);
    capture c;
    int taken = 0, refused = 0;
    random_state = 0xd1b54a32d192ed03u;
    capture_begin(&c);
    for (int i = 0; i < 3000; i++) {
        char bytes[MOST];
        size_t size = mutate(json_seed, bytes);
        FILE *file = fopen(path, "w");
        fwrite(bytes, 1, size, file);
        fclose(file);
        cJSON *root = base_json_read(path);
        if (!root) {
            refused++;
            continue;
        }
        taken++;
        /* What was read is printed as something that reads as the same. */
        char *text = base_json_print(root);
        cJSON *again = cJSON_ParseWithOpts(text, NULL, true);
        assert_non_null(again);
        char *text_again = base_json_print(again);
        assert_string_equal(text_again, text);
        free(text_again);
        free(text);
        cJSON_Delete(again);
        cJSON_Delete(root);
    }
    fflush(stderr);
    int lines = count_lines(c.file);
    capture_end(&c);
    workspace_close(&work);
    free(path);
    assert_int_equal(lines, refused);
    assert_true(taken > 50 && refused > 500);
}

static void deep_json_is_refused(void **state)
{
    (void)state;
    workspace work;
    workspace_open(&work);
    char *path = workspace_file(&work, "mutated.json", NULL);
    enum { DEPTH = 200000 };
    char *deep = malloc(DEPTH);
    memset(deep, '[', DEPTH);
    FILE *file = fopen(path, "w");
    fwrite(deep, 1, DEPTH, file);
    fclose(file);
    free(deep);
    capture c;
    capture_begin(&c);
    cJSON *root = base_json_read(path);
    assert_one_line(capture_end(&c), "line 1");
    assert_null(root);
    workspace_close(&work);
    free(path);
}

static void the_program_takes_damaged_rows_or_tells_one_line(void **state)
{
    (void)state;
    random_state = 0xbf58476d1ce4e5b9u;
    for (int i = 0; i < 60; i++) {
        char bytes[MOST];
        size_t size = mutate(csv_seeds[i % 3], bytes);
        if (size == 0)
            continue;
        const run_options input = {.input = bytes, .input_size = size};
        run r = RUN(&input, "eval", i % 2 ? "--json" : "--quantity=L");
        if (r.status == 0)
            assert_string_equal(r.error, "");
        else
            assert_one_line(r.error, "standard input");
        assert_true(r.status == 0 || r.status == 2);
        if (r.status == 0 && i % 2) {
            cJSON *root = cJSON_ParseWithOpts(r.out, NULL, true);
            assert_non_null(root);
            cJSON_Delete(root);
        }
        run_free(&r);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(damaged_csv_is_taken_or_told_in_one_line),
        cmocka_unit_test(damaged_json_is_taken_or_told_in_one_line),
        cmocka_unit_test(deep_json_is_refused),
        cmocka_unit_test(the_program_takes_damaged_rows_or_tells_one_line),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
