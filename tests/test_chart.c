/* test_chart.c: the chart of error against cost, its page and its picture. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include <math.h>

#include "base/file.h"
#include "base/json.h"
#include "chart.h"
#include "program.h"
#include "report.h"
#include "work.h"

static char *read_there(const char *name)
{
    char *text = base_read_file(workspace_path(&work, name), NULL);
    assert_non_null(text);
    return text;
}

/* The page with the committed figures, as the report has them. */
static char *committed_page(void)
{
    static char *text;
    if (text)
        return text;
    report report = {.page = page_new("chart", "a test")};
    page_section(report.page, "cost", "cost");
    assert_true(report_cost(&report));
    assert_true(page_write(report.page, work.folder, "index.html"));
    page_free(report.page);
    return text = read_there("index.html");
}

static cJSON *embedded(const char *page)
{
    const char *begin = strstr(page, "id=\"chart-data\">");
    assert_non_null(begin);
    begin += strlen("id=\"chart-data\">");
    cJSON *root = cJSON_ParseWithLength(begin, (size_t)(strstr(begin, "</script>") - begin));
    assert_non_null(root);
    return root;
}

static const cJSON *point_of(const cJSON *root, const char *id)
{
    const cJSON *point, *found = NULL;
    cJSON_ArrayForEach(point, cJSON_GetObjectItemCaseSensitive(root, "points"))
    {
        const char *method = cJSON_GetObjectItemCaseSensitive(point, "method")->valuestring;
        if (strcmp(method, id) == 0) {
            assert_null(found);
            found = point;
        }
    }
    return found;
}

static double number_of(const cJSON *point, const char *key)
{
    const cJSON *item = cJSON_GetObjectItemCaseSensitive(point, key);
    assert_non_null(item);
    return cJSON_IsString(item)   ? strtod(item->valuestring, NULL)
           : cJSON_IsNumber(item) ? item->valuedouble
                                  : (double)NAN;
}

static void every_method_and_table_is_a_point(void **state)
{
    (void)state;
    cJSON *root = embedded(committed_page());
    int count = cJSON_GetArraySize(cJSON_GetObjectItemCaseSensitive(root, "points"));
    assert_int_equal(count, (int)sg_method_count() + 3);
    for (size_t i = 0; i < sg_method_count(); i++) {
        const cJSON *point = point_of(root, sg_method_at(i)->id);
        if (!point)
            fail_msg("%s is no point of the chart", sg_method_at(i)->id);
        assert_string_equal(cJSON_GetObjectItemCaseSensitive(point, "kind")->valuestring,
                            sg_method_at(i)->variant);
        double max = number_of(point, "max_abs_f32"), rmse = number_of(point, "rmse_f32");
        assert_true(max > 0.0 && rmse > 0.0 && rmse <= max);
    }
    /* as published: the largest error of the paper's own constants, and no number in float */
    assert_true(fabs(number_of(point_of(root, "tokuyoshi_2024"), "max_abs_f32") - 1.28e-3) < 5e-6);
    assert_true(isinf(number_of(point_of(root, "meder_2018"), "max_abs_f32")));
    assert_true(number_of(point_of(root, "meder_2018"), "gpu_instructions") > 10.0);
    assert_string_equal(
        cJSON_GetObjectItemCaseSensitive(point_of(root, "table_2d"), "kind")->valuestring, "table");
    cJSON_Delete(root);
}

static void the_page_loads_nothing(void **state)
{
    (void)state;
    static const char *const forbidden[] = {"http:",   "https:", "//cdn", "@import",
                                            "<iframe", "<link",  "src=",  NULL};
    const char *page = committed_page();
    for (int i = 0; forbidden[i]; i++)
        if (strstr(page, forbidden[i]))
            fail_msg("the page holds %s: %.80s", forbidden[i], strstr(page, forbidden[i]));
    /* the chart is drawn by the page's own script, or the page says that it is not */
    bool library = strstr(page, "Chart.js v3") != NULL;
    assert_true(library == (strstr(page, "was built without Chart.js") == NULL));
    assert_true(library == (strstr(page, "new Chart(") != NULL));
    if (library)
        assert_non_null(strstr(page, "MIT License"));
}

static void the_picture_names_every_method(void **state)
{
    (void)state;
    const char *page = committed_page();
    char *file = read_there("figures/chart.svg");
    const char *inside = strstr(page, "<svg");
    assert_non_null(inside);
    assert_non_null(strstr(file, "</svg>"));
    for (size_t i = 0; i < sg_method_count(); i++) {
        char name[96];
        snprintf(name, sizeof name, ">%s", sg_method_at(i)->id);
        if (!strstr(file, name) || !strstr(inside, name))
            fail_msg("%s is not in the picture", name);
    }
    free(file);
}

/* Against the definition, point by point. */
static void nothing_beats_the_front(void **state)
{
    (void)state;
    chart chart;
    assert_true(chart_committed(&chart));
    for (int error = CHART_MAX; error <= CHART_RMSE; error++)
        for (int cost = CHART_INSTRUCTIONS; cost <= CHART_SLOPE; cost++) {
            size_t front[256],
                count = chart_front(&chart, (chart_figure)error, (chart_figure)cost, front);
            assert_in_range(count, 4, chart.count);
            for (size_t i = 0; i < chart.count; i++) {
                const double *p = chart.points[i].figure;
                bool on = false, beaten = false;
                for (size_t f = 0; f < count; f++) {
                    const double *q = chart.points[front[f]].figure;
                    on |= front[f] == i;
                    beaten |= front[f] != i && q[error] <= p[error] && q[cost] <= p[cost];
                }
                if (isfinite(p[error]) && chart_competes(&chart.points[i], (chart_figure)cost))
                    assert_true(on != beaten);
                else
                    assert_false(on);
            }
            for (size_t f = 1; f < count; f++) {
                const double *a = chart.points[front[f - 1]].figure;
                const double *b = chart.points[front[f]].figure;
                assert_true(a[cost] < b[cost] && a[error] > b[error]);
            }
        }
    chart_free(&chart);
}

static void bench_writes_its_page_whole(void **state)
{
    (void)state;
    char folder[300];
    snprintf(folder, sizeof folder, "%s/bench", work.folder);
    run r = RUN(NULL, "bench", "--out", folder, "--method", "quick", "--quick");
    if (r.status != 0)
        fail_msg("%s", r.error);
    run_free(&r);
    char *page = read_there("bench/index.html");
    size_t length = strlen(page);
    assert_string_equal(page + length - strlen("</body>\n</html>\n"), "</body>\n</html>\n");
    cJSON *root = embedded(page);
    const cJSON *point = point_of(root, "quick");
    assert_non_null(point);
    assert_int_equal(cJSON_GetArraySize(cJSON_GetObjectItemCaseSensitive(root, "points")), 1);
    assert_true(number_of(point, "cpu_batch_ns_f32") > 0.0);
    assert_true(number_of(point, "max_abs_f32") < 2e-3);
    static const char *const files[] = {"cost.csv", "cost.json", "data/chart.csv",
                                        "figures/chart.svg"};
    for (size_t i = 0; i < sizeof files / sizeof *files; i++) {
        char name[64];
        snprintf(name, sizeof name, "bench/%s", files[i]);
        char *text = read_there(name);
        assert_true(strlen(text) > 100);
        free(text);
        snprintf(name, sizeof name, "href=\"%s\"", files[i]);
        assert_non_null(strstr(page, name));
    }
    cJSON_Delete(root);
    free(page);
}

/* A time of a run is shown, a count of it is not: those of the source tree hold. */
static void the_report_takes_times_from_a_run(void **state)
{
    (void)state;
    workspace_write(&work, "cost.csv",
                    "method,quantity,max_abs_f32,gpu_instructions,cpu_batch_ns_f32,device_ratio\n"
                    "quick,L,0.5,999,1.25,2.5\nquick,A_h,0.5,999,77,78\nunknown,L,1,1,1,1\n");
    report report = {.page = page_new("chart", "a test"), .bench = work.folder};
    page_section(report.page, "cost", "cost");
    assert_true(report_cost(&report));
    FILE *out = page_html(report.page);
    fflush(out);
    assert_true(page_write(report.page, work.folder, "timed.html"));
    page_free(report.page);
    char *page = read_there("timed.html");
    cJSON *root = embedded(page);
    const cJSON *point = point_of(root, "quick");
    assert_true(number_of(point, "cpu_batch_ns_f32") == 1.25);
    assert_true(number_of(point, "device_ratio") == 2.5);
    assert_true(number_of(point, "gpu_instructions") < 100.0);
    assert_true(number_of(point, "max_abs_f32") < 2e-3);
    assert_null(point_of(root, "unknown"));
    cJSON_Delete(root);
    free(page);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_method_and_table_is_a_point),
        cmocka_unit_test(the_page_loads_nothing),
        cmocka_unit_test(the_picture_names_every_method),
        cmocka_unit_test(nothing_beats_the_front),
        cmocka_unit_test(bench_writes_its_page_whole),
        cmocka_unit_test(the_report_takes_times_from_a_run),
    };
    base_set_source_root(getenv("SGFIT_ROOT"));
    return cmocka_run_group_tests(tests, open_work, close_work);
}
