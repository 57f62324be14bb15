/* The report's table of bars: what is reached is compared with what is asked, and a miss says so.
 */
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <setjmp.h>

#include <cmocka.h>

#include "base/file.h"
#include "bench/report_scenes.h"
#include "workspace.h"

static char *table_of(workspace *at)
{
    report r = {.page = page_new("t", "l"), .scenes = at->folder};
    assert_true(report_scene_bars(&r));
    assert_true(page_write(r.page, at->folder, "index.html"));
    page_free(r.page);
    char *html = base_read_file(workspace_path(at, "index.html"), NULL);
    assert_non_null(html);
    return html;
}

/* The row of the summary that begins with a bar's name, as text. */
static const char *row_of(const char *html, const char *bar)
{
    const char *row = strstr(html, bar);
    if (!row)
        fail_msg("no row of \"%s\"", bar);
    static char text[2048];
    snprintf(text, sizeof text, "%.*s", (int)strcspn(row, "\n"), row);
    return text;
}

static void test_bars(void **state)
{
    (void)state;
    workspace at;
    workspace_open(&at);
    workspace_write(&at, "bars.csv",
                    "scene,width,height,normals,pipeline,evaluations_percent,rel,p50,p99,"
                    "lighting_ms,rel_lower_percent,p99_lower_percent,rel_lower_than_split_percent,"
                    "integration_over_limit,pixels_uncovered_or_wrong,integrate_ms\n"
                    "a,10,10,smooth,hull,1.5,.04,.001,.1,5,60,40,20,1.5,0,1\n"
                    "a,10,10,smooth,hull_lobe,1.5,.07,.001,.1,5,60,40,20,1.5,0,1\n"
                    "b,10,10,detailed,hull,1.5,.055,.9,.9,5,60,,20,1.5,1,1\n"
                    "a,20,20,smooth,hull,1.5,.055,.001,.1,12,60,60,20,1.5,0,3\n");
    workspace_write(&at, "flicker.csv",
                    "moving,pipeline,own_rms\ncamera,hull,2\n"
                    "camera,upsample2,4\ncamera,upsample8,3\n");
    workspace_write(&at, "choice.csv",
                    "scene,pipeline,largest_change_of_255\n"
                    "a,meder,7\na,meder,.5\na,meder,.1\n");
    char *html = table_of(&at);
    const char *row = row_of(html, "pixels uncovered");
    assert_non_null(strstr(row, "2 of 3") && strstr(row, "MISSED") ? row : NULL);
    assert_non_null(strstr(row, "b 10x10 detailed"));
    assert_non_null(strstr(row_of(html, "light evaluations, %"), "3 of 3"));
    assert_non_null(strstr(row_of(html, "rel, smooth normals"), "a 20x20 smooth"));
    assert_non_null(strstr(row_of(html, "rel, smooth normals"), "MISSED"));
    assert_non_null(strstr(row_of(html, "rel, detailed normals"), "1 of 1"));
    assert_non_null(strstr(row_of(html, "median error, smooth"), "2 of 2")); /* not of detailed */
    assert_non_null(strstr(row_of(html, "p99, % lower"), "1 of 2")); /* one was not measured */
    assert_non_null(strstr(row_of(html, "rel with lobes"), "1 of 1"));
    row = row_of(html, "growth of lighting time with pixels"); /* 12/5 of 3/1 */
    assert_non_null(strstr(row, "0.800") && strstr(row, ">passed<") ? row : NULL);
    assert_non_null(strstr(row_of(html, "flicker, times"), "0.667")); /* of the better rival */
    assert_non_null(strstr(row_of(html, "change of the picture"), "0.500")); /* cheapest below 1 */
    assert_null(strstr(html, "the paper&#39;s")); /* rates.csv is not there */
    free(html);
    workspace_close(&at);
}

static void test_growth(void **state)
{
    (void)state;
    workspace at;
    workspace_open(&at);
    workspace_write(&at, "growth.csv",
                    "what,amount,pipeline,lighting_ms,rel\n"
                    "triangles,1000,hull,10,.01\ntriangles,9000,hull,15,.01\n"
                    "lights,16,hull,10,.01\nlights,64,hull,99,.02\n"
                    "lights,160,hull,50,.01\n");
    workspace_write(&at, "rates.csv",
                    "scene,width,height,pipeline,lighting_ratio,paper_ratio\n"
                    "a,10,10,hull,5,10\na,10,10,meder,99,10\nbox,1,1,hull,5,0\n");
    char *html = table_of(&at);
    assert_non_null(strstr(row_of(html, "lighting time from the fewest"), "MISSED"));
    assert_non_null(strstr(row_of(html, "growth of lighting time over"), "0.500"));
    assert_non_null(strstr(row_of(html, "rel at every number"), "0.0200"));
    assert_non_null(strstr(row_of(html, "speed-up over ground truth"), "0 of 1"));
    free(html);
    workspace_close(&at);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_bars),
        cmocka_unit_test(test_growth),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
