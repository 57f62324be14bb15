/* sgfit fit: a recipe that says something wrong is refused in one line that names file and key,
 * before anything is fitted or written. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "base/file.h"
#include "capture.h"
#include "program.h"
#include "work.h"

/* A recipe of the tree with one piece of its text replaced, as a file of the same name. */
static char *changed_recipe(const char *from, const char *to)
{
    char *source = base_join(getenv("SGFIT_ROOT"), "fit/recipes/meder_2018_t.json");
    char *text = base_read_file(source, NULL);
    assert_non_null(text);
    char *place = strstr(text, from);
    if (!place)
        fail_msg("the recipe has no \"%s\"", from);
    char *path = base_join(work.folder, "meder_2018_t.json");
    FILE *file = fopen(path, "w");
    assert_non_null(file);
    fprintf(file, "%.*s%s%s", (int)(place - text), text, to, place + strlen(from));
    fclose(file);
    free(text);
    free(source);
    return path;
}

static char *earlier_constants;

/* The folder for the constants, which holds one earlier file. */
static char *make_out(void)
{
    char *out = base_join(work.folder, "out"), *earlier = base_join(out, "meder_2018.json");
    assert_true(base_make_directory(out));
    assert_true(base_write_file(earlier, earlier_constants, strlen(earlier_constants)));
    free(earlier);
    return out;
}

static void assert_untouched(const char *out)
{
    char **names;
    size_t count;
    assert_true(base_list(out, "", &names, &count));
    assert_int_equal(count, 1);
    char *path = base_join(out, names[0]), *text = base_read_file(path, NULL);
    assert_string_equal(text, earlier_constants);
    free(text);
    free(path);
    base_list_free(names, count);
}

static void assert_refused(const char *from, const char *to, const char *key)
{
    char *path = changed_recipe(from, to), *out = make_out();
    run r = RUN(NULL, "fit", "--out", out, path);
    if (r.status != 2)
        fail_msg("\"%s\" instead of \"%s\": status %d", to, from, r.status);
    assert_one_line(r.error, "meder_2018_t.json", key, "expected");
    assert_string_equal(r.out, "");
    assert_untouched(out);
    run_free(&r);
    free(out);
    free(path);
}

static void a_bad_recipe_is_one_line(void **state)
{
    (void)state;
    static const struct {
        const char *from, *to, *key;
    } bad[] = {
        {"\"seed\": 1", "\"sead\": 1", "sead"},
        {"\"seed\": 1", "\"seed\": -1", "seed"},
        {"\"seed\": 1", "\"seed\": \"one\"", "seed"},
        {"\"seed\": 1", "\"seed\": 1, \"seed\": 2", "seed"},
        {"\"seed\": 1,", "\"seed\": 1", "line"},
        {"[1e-05, 700]", "[700, 1e-05]", "domain"},
        {"[1e-05, 700]", "[700, 700]", "domain"},
        {"[1e-05, 700]", "[-1, 700]", "domain"},
        {"[1e-05, 700]", "[1e-05]", "domain"},
        {"[1e-05, 700]", "[1e-05, \"inf\"]", "domain"},
        {"[1e-05, 700]", "[1e-05, \"nan\"]", "domain"},
        {"[0, 180]", "[90, 90]", "domain"},
        {"[0, 180]", "[0, 181]", "domain"},
        {"\"count\": 401", "\"count\": 0", "count"},
        {"\"count\": 401", "\"count\": 1.5", "count"},
        {"\"count\": 401", "\"count\": 1e9", "count"},
        {"\"spacing\": \"sqrt\"", "\"spacing\": \"cube\"", "spacing"},
        {"\"cos_theta\"", "\"terminator\"", "spacing"},
        {"\"seed\": 1", "\"seed\": 1, \"later\": [\"t_shift\"]", "later"},
        {"\"least_squares\"", "\"least\"", "objective"},
        {"\"uniform\"", "\"even\"", "weights"},
        {"\"uniform\"", "{\"lamda\": 1}", "lamda"},
        {"\"meder_t\"", "\"no_such_curve\"", "curve"},
        {"\"kind\": \"curve\"", "\"kind\": \"arc\"", "kind"},
        {"\"t_shift\": 4", "\"t_shaft\": 4", "t_sh"},
        {"\"t_shift\": 4", "\"t_shift\": \"nan\"", "t_shift"},
        {"\"solver\": 1e-11", "\"solver\": 0", "solver"},
        {"\"iterations\": 1000", "\"iterations\": 0", "iterations"},
        {"\"method\": \"meder_2018\"", "\"method\": \"meder_2081\"", "method"},
        {"\"id\": \"meder_2018_t\"", "\"id\": \"other\"", "id"},
    };
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++)
        assert_refused(bad[i].from, bad[i].to, bad[i].key);
}

static void a_recipe_that_is_not_there_is_one_line(void **state)
{
    (void)state;
    static const char *const bad[] = {"no_such_recipe", "/no/such/recipe.json", "/", ""};
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++) {
        char *out = make_out();
        run r = RUN(NULL, "fit", "--out", out, bad[i]);
        assert_one_line(r.error, bad[i]);
        assert_int_equal(r.status, 2);
        assert_untouched(out);
        run_free(&r);
        free(out);
    }
}

static void a_folder_that_cannot_be_written_is_told_before_the_work(void **state)
{
    (void)state;
    run r = RUN(NULL, "fit", "--out", "/dev/null/constants", "tokuyoshi_2022_bound");
    assert_one_line(r.error, "/dev/null/constants", "Not a directory");
    assert_int_equal(r.status, 1);
    run_free(&r);
}

static int make_folder(void **state)
{
    (void)state;
    char *path = base_join(getenv("SGFIT_ROOT"), "tables/constants/meder_2018.json");
    earlier_constants = base_read_file(path, NULL);
    free(path);
    workspace_open(&work);
    return earlier_constants ? 0 : -1;
}

static int remove_folder(void **state)
{
    (void)state;
    free(earlier_constants);
    workspace_close(&work);
    return 0;
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_bad_recipe_is_one_line),
        cmocka_unit_test(a_recipe_that_is_not_there_is_one_line),
        cmocka_unit_test(a_folder_that_cannot_be_written_is_told_before_the_work),
    };
    return cmocka_run_group_tests(tests, make_folder, remove_folder);
}
