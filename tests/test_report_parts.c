/* bench/report: the section on failures, and README.md's figures. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "base/file.h"
#include "program.h"
#include "report.h"
#include "work.h"

static char *read_there(const char *name)
{
    char *text = base_read_file(workspace_path(&work, name), NULL);
    assert_non_null(text);
    return text;
}

static void failures_and_maps_are_in_the_report(void **state)
{
    (void)state;
    workspace_write(
        &work, "failures.csv",
        "method,precision,kind,lambda_from,lambda_to,worst,worst_lambda,worst_cos_theta\n"
        "meder_2018,f32,nan,1.5e20,inf,nan,1e21,0.5\n"
        "meder_2018_stable,f16,error_1e-2,3,4,0.02,3.5,-1\n");
    assert_true(base_make_directory(workspace_path(&work, "maps")));
    workspace_write(&work, "maps/meder_2018_f32.png", "abcd");
    report report = {.page = page_new("failures", "a test"),
                     .methods = sg_method_count(),
                     .stability = work.folder};
    assert_true(report_has_stability(&report));
    page_section(report.page, "stability", "stability");
    assert_true(report_stability(&report));
    assert_true(page_write(report.page, work.folder, "failures.html"));
    page_free(report.page);
    char *page = read_there("failures.html");
    assert_non_null(strstr(page, "NaN <small>λ from 1.50e20</small>"));
    assert_non_null(strstr(page, "data:image/png;base64,YWJjZA==\""));
    for (size_t i = 0; i < sg_method_count(); i++)
        assert_non_null(strstr(page, sg_method_at(i)->id));
    const char *row = strstr(page, "<code>meder_2018_stable</code><br><small>stable</small>");
    assert_non_null(row);
    for (int none = 0; none < 4; none++) /* a model's own error is no failure */
        assert_non_null(row = strstr(row + 1, ">none<"));
    free(page);
    /* a file that is something else is refused */
    workspace_write(&work, "failures.csv", "method,precision\nx,y\n");
    report.page = page_new("failures", "a test");
    page_section(report.page, "stability", "stability");
    assert_false(report_stability(&report));
    page_free(report.page);
}

static void readme_has_the_current_figures(void **state)
{
    (void)state;
    char *path = base_join(getenv("SGFIT_ROOT"), "README.md"), *now = base_read_file(path, NULL);
    free(path);
    assert_non_null(now);
    assert_non_null(strstr(now, "](tables/out/chart.svg)"));
    workspace_write(&work, "README.md", now);
    char copy[300];
    snprintf(copy, sizeof copy, "%s/README.md", work.folder);
    run r = RUN(NULL, "report", "--readme", copy);
    assert_int_equal(r.status, 0);
    run_free(&r);
    char *written = read_there("README.md"), *picture = read_there("tables/out/chart.svg");
    assert_string_equal(written, now);
    /* what stood in the block does not matter, what stands around it stays */
    char *from = strstr(now, "<!-- figures:"), *to = strstr(now, "<!-- /figures -->");
    assert_true(from && to);
    size_t line = strcspn(from, "\n") + 1;
    memmove(from + line, to, strlen(to) + 1);
    workspace_write(&work, "README.md", now);
    r = RUN(NULL, "report", "--readme", copy);
    assert_int_equal(r.status, 0);
    run_free(&r);
    char *again = read_there("README.md"), *picture_again = read_there("tables/out/chart.svg");
    assert_string_equal(again, written);
    assert_string_equal(picture_again, picture);
    workspace_write(&work, "README.md", "no figures here\n");
    r = RUN(NULL, "report", "--readme", copy);
    assert_int_equal(r.status, 1);
    assert_non_null(strstr(r.error, "README.md: expected the lines"));
    run_free(&r);
    free(again);
    free(picture_again);
    free(picture);
    free(written);
    free(now);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(failures_and_maps_are_in_the_report),
        cmocka_unit_test(readme_has_the_current_figures),
    };
    base_set_source_root(getenv("SGFIT_ROOT"));
    return cmocka_run_group_tests(tests, open_work, close_work);
}
