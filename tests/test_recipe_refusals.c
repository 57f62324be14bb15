/* `sgfit fit` with a recipe that is wrong, misses its bar or cannot be written. */
#include "recipe_fixture.h"

/* Status and one line that names the file and the words; what was written before stays. */
static void expect_refusal(workspace *at, int status, const char *word, const char *other)
{
    char *before = written(at, "small_refit");
    run result = run_recipe(at);
    if (result.status != status)
        print_message("expected status %d for %s, found %d: %s", status, word, result.status,
                      result.error);
    assert_int_equal(result.status, status);
    assert_one_line(result.error, word, other);
    char *after = written(at, "small_refit");
    assert_true((before == NULL) == (after == NULL));
    if (before)
        assert_string_equal(before, after);
    free(before);
    free(after);
    run_free(&result);
}

static void bad_recipes_are_refused_by_one_line(void **state)
{
    (void)state;
    static const struct {
        const char *key, *value, *word;
    } bad[] = {
        {"form", NULL, "\"form\""},
        {"form", "\"no_such_form\"", "\"form\""},
        {"form", "3", "\"form\""},
        {"kind", "\"guess\"", "\"kind\""},
        {"quantity", "\"luminance\"", "\"quantity\""},
        {"objective", "\"most_squares\"", "\"objective\""},
        {"domain", "{\"lambda\": [10, 10], \"beta\": [0, 180]}", "domain.lambda"},
        {"domain", "{\"lambda\": [10, 1], \"beta\": [0, 180]}", "domain.lambda"},
        {"domain", "{\"lambda\": [1, 10], \"beta\": [90, 90]}", "domain.beta"},
        {"domain", "{\"lambda\": [1, 10], \"beta\": [0, 181]}", "domain.beta"},
        {"domain", "{\"lambda\": \"all\", \"beta\": [0, 180]}", "domain.lambda"},
        {"domain", "{\"lambda\": [1, 10], \"beta\": [0, 180], \"phi\": [0, 1]}", "\"phi\""},
        {"domain", "7", "\"domain\""},
        {"grid",
         "{\"lambda\": {\"spacing\": \"log\", \"count\": 0}, \"angle\": {\"spacing\": \"beta\", "
         "\"count\": 9}}",
         "grid.lambda.count"},
        {"grid",
         "{\"lambda\": {\"spacing\": \"log\", \"count\": 9}, \"angle\": {\"spacing\": \"log\", "
         "\"count\": 9}}",
         "\"spacing\""},
        {"grid",
         "{\"lambda\": {\"spacing\": \"log\", \"count\": 2.5}, \"angle\": {\"spacing\": \"beta\", "
         "\"count\": 9}}",
         "grid.lambda.count"},
        {"weights", "\"heavy\"", "\"weights\""},
        {"weights", "{\"mass\": 1}", "\"mass\""},
        {"start", "{}", "\"start\""},
        {"start", "{\"u_7\": 1}", "start.u_7"},
        {"start", "{\"u_1\": \"one\"}", "\"u_1\""},
        {"start", "{\"u_1\": \"inf\"}", "start.u_1"},
        {"fixed", "{\"p_1\": 1}", "\"start\""},
        {"seed", "-1", "\"seed\""},
        {"seed", "\"x\"", "\"seed\""},
        {"iterations", "0", "\"iterations\""},
        {"tolerance", "{\"solver\": 0, \"agreement\": 1e-6, \"repeat\": 1e-6}", "\"solver\""},
        {"tolerance", "{\"solver\": 1e-9, \"repeat\": 1e-6}", "\"agreement\""},
        {"writes", "{\"id\": \"../x\", \"title\": \"x\", \"year\": 2026}", "writes.id"},
        {"bars", "{\"max_abs\": \"small\"}", "\"max_abs\""},
        {"bars", "{\"mean\": 1}", "\"mean\""},
        {"id", "\"other\"", "\"id\""},
        {"title", NULL, "\"title\""},
    };
    workspace at;
    workspace_open(&at);
    write_recipe(&at, NULL, NULL, NULL);
    run good = run_recipe(&at);
    assert_int_equal(good.status, 0);
    run_free(&good);
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++) {
        write_recipe(&at, bad[i].key, bad[i].value, NULL);
        expect_refusal(&at, 2, bad[i].word, "small.json");
    }
    static const char *const more[][2] = {
        {",\n\"colour\": \"red\"", "\"colour\""},
        {",\n\"seed\": 2", "\"seed\""},
        {",\n\"bounds\": {\"u_1\": [1, 2]}", "bounds.u_1"},
        {",\n\"later\": \"u_1\"", "\"later\""},
        {",\n\"later\": [\"u_9\"]", "\"later\""},
        {",\n\"later\": [\"u_1\", \"u_1\"]", "\"later\""},
        {",\n\"later\": [1]", "\"later\""},
        {",\n\"later\": [\"u_1\", \"u_infinity\"]", "\"later\""},
        {",\n\"tried\": [{\"what\": \"x\", \"domain\": {\"lambda\": [1, 10], \"beta\": [0, 90]}, "
         "\"grid\": {\"lambda\": {\"spacing\": \"shifted_log\", \"count\": 9}, \"angle\": "
         "{\"spacing\": \"terminator\", \"count\": 9}}}]",
         "grid.angle.spacing"},
        {",\n\"published\": {\"method\": \"nobody_1900\", \"bars\": {}}", "published.method"},
        {",\n\"published\": {\"method\": \"meder_2018\", \"bars\": {\"u_1\": 1}}",
         "published.bars.u_1"},
        {",\n\"tried\": [{\"what\": \"x\", \"grid\": 1}]", "\"grid\""},
        {",\n\"tried\": [7]", "\"tried\""},
    };
    for (size_t i = 0; i < sizeof more / sizeof *more; i++) {
        write_recipe(&at, NULL, NULL, more[i][0]);
        expect_refusal(&at, 2, more[i][1], "small.json");
    }
    workspace_close(&at);
}

static void a_recipe_that_misses_its_bar_fails_and_writes_nothing(void **state)
{
    (void)state;
    workspace at;
    workspace_open(&at);
    write_recipe(&at, "bars", "{\"max_abs\": 1e-9}", NULL);
    expect_refusal(&at, 1, "maximum error", "small");
    write_recipe(&at, "bars", "{\"rmse_f32\": 1e-9}", NULL);
    expect_refusal(&at, 1, "RMSE", "small");
    /* one step cannot get there, and the two solvers' single steps are not alike */
    write_recipe(&at, "iterations", "1", NULL);
    expect_refusal(&at, 1, "small", "differ");
    workspace_close(&at);
}

static void unwritable_places_end_with_one_line(void **state)
{
    (void)state;
    workspace at;
    workspace_open(&at);
    workspace_write(&at, "file", "in the way\n");
    char out[1100];
    snprintf(out, sizeof out, "%s/file/sub", at.folder);
    run result = RUN(NULL, "fit", "--out", out, "tokuyoshi_2022_bound");
    assert_int_equal(result.status, 1);
    assert_one_line(result.error, "file");
    run_free(&result);
    result = RUN(NULL, "fit", "no_such_recipe");
    assert_int_equal(result.status, 2);
    assert_one_line(result.error, "no_such_recipe");
    run_free(&result);
    workspace_close(&at);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(bad_recipes_are_refused_by_one_line),
        cmocka_unit_test(a_recipe_that_misses_its_bar_fails_and_writes_nothing),
        cmocka_unit_test(unwritable_places_end_with_one_line),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
