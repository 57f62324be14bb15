/* `sgfit fit` as users run it: what it writes, what it refuses, and that every constant of the tree
 * comes out again. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>
#include <math.h>

#include "capture.h"
#include "program.h"
#include "workspace.h"

#include "base/json.h"

/* A recipe that takes milliseconds; @ stands where a test changes it. */
static const char *const parts[][2] = {
    {"id", "\"small\""},
    {"title", "\"a small fit\""},
    {"kind", "\"form\""},
    {"form", "\"logistic_limits\""},
    {"quantity", "\"L\""},
    {"domain", "{\"lambda\": [0.01, 1000], \"beta\": [0, 180]}"},
    {"grid",
     "{\"lambda\": {\"spacing\": \"log\", \"count\": 20}, \"angle\": {\"spacing\": \"beta\", "
     "\"count\": 21}}"},
    {"weights", "\"uniform\""},
    {"objective", "\"least_squares\""},
    {"start", "{\"u_1\": 0.2, \"u_infinity\": 1.5}"},
    {"fixed", "{\"t_infinity\": 2.1583, \"p_1\": 13.7, \"q_1\": 11.5, "
              "\"q_2\": -27.5, \"q_3\": 470}"},
    {"seed", "1"},
    {"iterations", "200"},
    {"tolerance", "{\"solver\": 1e-10, \"agreement\": 1e-6, \"repeat\": 1e-6}"},
    {"writes", "{\"id\": \"small_refit\", \"title\": \"small\", \"year\": 2026}"},
    {"bars", "{\"max_abs\": 1e-2}"},
};
enum { PARTS = sizeof parts / sizeof *parts };

/* The recipe with one key's value replaced (NULL: left out), and more text before the end. */
static void write_recipe(workspace *at, const char *key, const char *value, const char *more)
{
    char text[4096] = "{\n";
    for (size_t i = 0; i < PARTS; i++) {
        const char *is = key && strcmp(parts[i][0], key) == 0 ? value : parts[i][1];
        if (is)
            snprintf(text + strlen(text), sizeof text - strlen(text), "%s\"%s\": %s",
                     strlen(text) > 2 ? ",\n" : "", parts[i][0], is);
    }
    snprintf(text + strlen(text), sizeof text - strlen(text), "%s\n}\n", more ? more : "");
    workspace_write(at, "small.json", text);
}

static run run_recipe(workspace *at)
{
    char recipe[1100], out[1100];
    snprintf(recipe, sizeof recipe, "%s/small.json", at->folder);
    snprintf(out, sizeof out, "%s/out", at->folder);
    return RUN(NULL, "fit", "--out", out, recipe);
}

static char *written(workspace *at, const char *id)
{
    char name[128];
    snprintf(name, sizeof name, "out/%s.json", id);
    return workspace_read_path(workspace_path(at, name), NULL);
}

/* ---- What is written ----------------------------------------------------------------------- */

static void a_recipe_writes_its_constants_twice_alike(void **state)
{
    (void)state;
    workspace at;
    workspace_open(&at);
    write_recipe(&at, NULL, NULL, NULL);
    run first = run_recipe(&at);
    if (first.status != 0)
        print_message("%s", first.error);
    assert_int_equal(first.status, 0);
    char *once = written(&at, "small_refit");
    assert_non_null(once);
    run second = run_recipe(&at);
    char *twice = written(&at, "small_refit");
    assert_string_equal(once, twice);
    assert_string_equal(first.out, second.out);
    static const char *const keys[] = {"\"form\": \"logistic_limits\"",
                                       "\"coefficients\"",
                                       "\"objective\": \"least_squares\"",
                                       "\"domain\"",
                                       "\"grid\"",
                                       "\"weights\": \"uniform\"",
                                       "\"seed\": 1",
                                       "\"tolerance\"",
                                       "\"iterations\"",
                                       "\"status\"",
                                       "Ceres",
                                       "NLopt",
                                       "\"rmse\"",
                                       "\"max_abs_lambda\"",
                                       "\"command\": \"sgfit fit small\"",
                                       "\"measured\"",
                                       "\"f64\"",
                                       "\"f32\""};
    for (size_t i = 0; i < sizeof keys / sizeof *keys; i++)
        assert_non_null(strstr(once, keys[i]));
    /* nothing of this machine */
    assert_null(strstr(once, at.folder));
    free(once);
    free(twice);
    run_free(&first);
    run_free(&second);
    workspace_close(&at);
}

/* Where the optimum is one, the way there does not matter: but the constants say how. */
static void coefficients_may_join_later(void **state)
{
    (void)state;
    static const char *const more[] = {"", ",\n\"later\": [\"u_infinity\"]"};
    double u[2], limit[2];
    workspace at;
    workspace_open(&at);
    for (int staged = 0; staged < 2; staged++) {
        write_recipe(&at, NULL, NULL, more[staged]);
        run result = run_recipe(&at);
        if (result.status != 0)
            print_message("%s", result.error);
        assert_int_equal(result.status, 0);
        run_free(&result);
        cJSON *file = base_json_read(workspace_path(&at, "out/small_refit.json"));
        const cJSON *fitted = cJSON_GetObjectItemCaseSensitive(file, "coefficients");
        const cJSON *made = cJSON_GetObjectItemCaseSensitive(file, "provenance");
        assert_true(base_json_f64(fitted, "small_refit", "u_1", &u[staged]));
        assert_true(base_json_f64(fitted, "small_refit", "u_infinity", &limit[staged]));
        assert_int_equal(cJSON_GetArraySize(cJSON_GetObjectItemCaseSensitive(made, "later")),
                         staged);
        cJSON_Delete(file);
    }
    assert_true(fabs(u[0] - u[1]) < 1e-6 * fabs(u[0]));
    assert_true(fabs(limit[0] - limit[1]) < 1e-6 * fabs(limit[0]));
    workspace_close(&at);
}

static void published_constants_get_what_was_regenerated(void **state)
{
    (void)state;
    workspace at;
    workspace_open(&at);
    char out[1100];
    snprintf(out, sizeof out, "%s/out", at.folder);
    run result = RUN(NULL, "fit", "--out", out, "tokuyoshi_2022_bound");
    assert_int_equal(result.status, 0);
    assert_non_null(
        strstr(result.out, "recipe,constant,published,ours,difference,relative,bar,how"));
    cJSON *file = base_json_read(workspace_path(&at, "out/tokuyoshi_2022.json"));
    const cJSON *entry = cJSON_GetObjectItemCaseSensitive(file, "regenerated");
    entry = cJSON_GetObjectItemCaseSensitive(entry, "tokuyoshi_2022_bound");
    entry = cJSON_GetObjectItemCaseSensitive(entry, "constants");
    double relative;
    static const char *const names[] = {"cosine_sharpness", "alpha"};
    for (size_t i = 0; i < 2; i++) {
        const cJSON *one = cJSON_GetObjectItemCaseSensitive(entry, names[i]);
        assert_true(base_json_f64(one, "regenerated", "relative", &relative));
        assert_true(relative <= 1e-12);
    }
    cJSON_Delete(file);
    run_free(&result);
    workspace_close(&at);
}

static void list_names_every_recipe(void **state)
{
    (void)state;
    run result = RUN(NULL, "fit", "--list");
    assert_int_equal(result.status, 0);
    static const char *const ids[] = {
        "meder_2018_t,",         "meder_2018_u,",     "meder_2018_hg_t,",
        "meder_2018_hg_cosine,", "tokuyoshi_2022_t,", "tokuyoshi_2022_bound,",
        "tokuyoshi_2024_t,",     "logistic_refit,",   "logistic_minimax,"};
    for (size_t i = 0; i < sizeof ids / sizeof *ids; i++)
        assert_non_null(strstr(result.out, ids[i]));
    run_free(&result);
}

/* ---- What is refused ----------------------------------------------------------------------- */

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

/* ---- The constants of the tree ------------------------------------------------------------- */

static void all_constants_come_out_again(void **state)
{
    (void)state;
#if defined(__SANITIZE_ADDRESS__)
    /* sanitized, the large ones take minutes and tell nothing that the small ones do not */
    run result = RUN(NULL, "fit", "--check", "tokuyoshi_2022_bound", "meder_2018_t");
#else
    run result = RUN(NULL, "fit", "--check");
#endif
    if (result.status != 0)
        print_message("%s", result.error);
    assert_int_equal(result.status, 0);
    assert_string_equal(result.error, "");
    run_free(&result);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_recipe_writes_its_constants_twice_alike),
        cmocka_unit_test(coefficients_may_join_later),
        cmocka_unit_test(published_constants_get_what_was_regenerated),
        cmocka_unit_test(list_names_every_recipe),
        cmocka_unit_test(bad_recipes_are_refused_by_one_line),
        cmocka_unit_test(a_recipe_that_misses_its_bar_fails_and_writes_nothing),
        cmocka_unit_test(unwritable_places_end_with_one_line),
        cmocka_unit_test(all_constants_come_out_again),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
