/* `sgfit fit` as users run it: what it writes, and that every constant of the tree comes out again.
 */
#include "recipe_fixture.h"

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
        cmocka_unit_test(all_constants_come_out_again),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
