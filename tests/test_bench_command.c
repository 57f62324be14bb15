/* What `sgfit bench` writes, and that the committed costs are what it writes now. */
#include "gpu_fixture.h"

#include <math.h>
#include <string.h>
#include <unistd.h>

#include "base/csv.h"
#include "base/file.h"
#include "cost.h"
#include "program.h"
#include "workspace.h"

static const char method_id[] = "meder_2018_stable";

/* What stands in a CSV of costs for one quantity of a method. */
static double field(const char *path, const char *method, const char *quantity, const char *column)
{
    FILE *stream = fopen(path, "r");
    assert_non_null(stream);
    base_csv csv;
    assert_true(base_csv_open(&csv, stream, path));
    int id = base_csv_column(&csv, "method"), which = base_csv_column(&csv, "quantity");
    int wanted = base_csv_column(&csv, column);
    assert_true(id == 0 && which == 1);
    if (wanted < 0)
        fail_msg("%s has no column %s", path, column);
    double value = (double)NAN;
    while (base_csv_next(&csv) > 0)
        if (strcmp(csv.fields[id], method) == 0 && strcmp(csv.fields[which], quantity) == 0 &&
            csv.lengths[wanted] > 0)
            value = strtod(csv.fields[wanted], NULL);
    base_csv_close(&csv);
    fclose(stream);
    return value;
}

static void program_writes_the_columns_that_others_rely_on(void **state)
{
    (void)state;
    workspace work;
    workspace_open(&work);
    const char *arguments[] = {"bench",   "--out",   work.folder, "--method",
                               method_id, "--quick", NULL};
    run result = program_run(arguments, NULL);
    if (result.status != 0)
        fail_msg("%s", result.error);
    char *csv = workspace_file(&work, "cost.csv", NULL);
    char *json = workspace_file(&work, "cost.json", NULL);
    static const char *const columns[] = {
        "max_abs_f32", "rmse_f32",   "gpu_instructions", "gpu_inverse_throughput",
        "gpu_slope",   "cpu_ns_f32", "cpu_batch_ns_f32", "cpu_batch_ns_f64",
        "device_ratio"};
    bool device = getenv("CI") || result.error[0] == '\0';
    for (size_t i = 0; i < sizeof columns / sizeof *columns; i++) {
        bool software = strncmp(columns[i], "gpu", 3) != 0 && strncmp(columns[i], "device", 6) != 0;
        double L = field(csv, method_id, "L", columns[i]);
        double A_h = field(csv, method_id, "A_h", columns[i]);
        if (software || device)
            assert_true(L > 0 && A_h > 0);
    }
    assert_true(fabs(field(csv, method_id, "L", "max_abs_f32") - 5.28e-3) < 1e-4);
    char *text = base_read_file(json, NULL);
    assert_non_null(text);
    assert_non_null(strstr(text, "\"processor\""));
    assert_non_null(strstr(text, "\"compiler\""));
    assert_non_null(strstr(text, "\"lambda\": [0.01, 10000]"));
    free(text);
    workspace_close(&work); /* with the page */
    free(csv);
    free(json);
    run_free(&result);
}

static void bad_usage_is_one_line(void **state)
{
    (void)state;
    static const char *const wrong[][6] = {{"bench", NULL},
                                           {"bench", "--out", ".", "--method", "nothing", NULL},
                                           {"bench", "--wrong", NULL}};
    for (size_t i = 0; i < sizeof wrong / sizeof *wrong; i++) {
        run result = program_run(wrong[i], NULL);
        assert_int_equal(result.status, 2);
        assert_string_equal(result.out, "");
        char *end = strchr(result.error, '\n');
        assert_true(end && end[1] == '\0');
        run_free(&result);
    }
}

static cost_count counted(cost_counter *counter, const cost_subject *subject)
{
    cost_count count;
    assert_true(cost_counter_run(counter, subject->id, subject->glsl, &count));
    return count;
}

/* tables/cost.csv, which stands in the comments of sg.glsl, is what this compiler counts; with
 * another Mesa there is nothing to compare. */
static void committed_counts_are_current(void **state)
{
    (void)state;
    char reason[256];
    cost_counter *counter = cost_counter_open(cost_families[0], reason);
    if (!counter && getenv("CI"))
        fail_msg("%s", reason);
    if (!counter)
        skip();
    char *path = base_join(getenv("SGFIT_ROOT"), "tables/cost.csv");
    char *text = base_read_file(path, NULL);
    assert_non_null(text);
    char *driver = strstr(text, cost_counter_driver(counter));
    free(text);
    if (!driver) {
        cost_counter_close(counter);
        free(path);
        skip();
    }
    cost_subjects subjects;
    assert_true(cost_subjects_read(&subjects, NULL));
    bool good = true;
    for (size_t i = 0; i < subjects.count; i++) {
        const cost_subject *subject = &subjects.list[i];
        cost_count count = counted(counter, subject);
        const char *quantity = cost_quantity_name(subject->quantity);
        double committed = field(path, subject->id, quantity, "gpu_instructions");
        if (committed != count.instructions) {
            print_message("FAIL %s %s: tables/cost.csv has %g instructions, now %g (sgfit bench "
                          "--counts tables/cost.csv)\n",
                          subject->id, quantity, committed, count.instructions);
            good = false;
        }
    }
    assert_true(good);
    cost_subjects_free(&subjects);
    cost_counter_close(counter);
    free(path);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(program_writes_the_columns_that_others_rely_on),
        cmocka_unit_test(bad_usage_is_one_line),
        cmocka_unit_test(committed_counts_are_current),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
