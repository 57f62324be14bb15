/* The bars of area lights with shadows: ours against Nichols' of the same view, on large images
 * alone. */
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <setjmp.h>

#include <cmocka.h>
#include <math.h>
#include <string.h>

#include "bench/report_scenes.h"
#include "workspace.h"

static const scenes_bar *bar_of(const scenes_bars *all, const char *what)
{
    for (size_t i = 0; i < all->count; i++)
        if (strcmp(all->of[i].what, what) == 0)
            return &all->of[i];
    fail_msg("no bar \"%s\"", what);
    return NULL;
}

static void ours_is_compared_with_nichols(void **state)
{
    (void)state;
    workspace at;
    workspace_open(&at);
    workspace_write(
        &at, "shadows.csv",
        "scene,width,pipeline,rel,p99,percent_of_nichols,times_faster_than_shadows,"
        "times_faster_than_nichols,lighting_ms,ssim\n"
        "a,256,multires,9,9,99,1,1,5,.1\na,256,nichols,1,1,100,1,1,5,.9\n" /* too small */
        "a,1024,multires,.01,.3,30,5,3,5,.99\na,1024,multires_same,1,1,1,1,1,1,1\n"
        "a,1024,nichols,.02,.1,100,2,1,9,.98\n"
        "b,1920,multires,.03,.1,45,4,2.5,5,.97\nb,1920,nichols,.04,.2,100,2,1,9,.96\n"
        "c,1920,multires,7,7,7,7,7,7,.7\n"); /* without a rival */
    report r = {.page = page_new("t", "l"), .scenes = at.folder};
    scenes_bars all = {.count = 0};
    assert_true(report_area_bars(&r, &all));
    const scenes_bar *bar = bar_of(&all, "multires: fragments, % of Nichols'");
    assert_int_equal(bar->count, 2);
    assert_int_equal(bar->passed, 2);
    bar = bar_of(&all, "multires: fragments, % of Nichols' (aim)");
    assert_int_equal(bar->passed, 1);
    assert_true(bar->worst == 45 && strcmp(bar->where, "b, 1920") == 0);
    assert_int_equal(bar_of(&all, "multires: rel over Nichols'")->passed, 2);
    bar = bar_of(&all, "multires: p99 over Nichols'");
    assert_int_equal(bar->passed, 1);
    assert_true(fabs(bar->worst - 3) < 1e-9 && strcmp(bar->where, "a, 1024") == 0);
    assert_int_equal(bar_of(&all, "multires: structural dissimilarity over Nichols'")->passed, 2);
    bar = bar_of(&all, "multires: times faster than every pixel");
    assert_true(bar->passed == 1 && bar->worst == 4);
    assert_int_equal(bar_of(&all, "multires: times faster than Nichols")->passed, 2);
    page_free(r.page);
    workspace_close(&at);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(ours_is_compared_with_nichols),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
