/* The program's frame: help, version, what every command does with a wrong argument, the registry
 * as `sgfit methods` lists it. */
#include <setjmp.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include <cjson/cJSON.h>
#include <cmocka.h>

#include "base/file.h"
#include "capture.h"
#include "program.h"
#include "sg.h"

/* The commands that `sgfit --help` lists. */
typedef struct commands {
    char names[16][32];
    int count;
} commands;

static commands list_commands(void)
{
    commands list = {0};
    run r = RUN(NULL, "--help");
    assert_int_equal(r.status, 0);
    assert_string_equal(r.error, "");
    const char *line = strstr(r.out, "\ncommands:\n");
    assert_non_null(line);
    line += strlen("\ncommands:\n");
    while (line[0] == ' ') {
        assert_true(list.count < 16);
        assert_int_equal(sscanf(line, "%31s", list.names[list.count++]), 1);
        line = strchr(line, '\n') + 1;
    }
    run_free(&r);
    return list;
}

static void help_lists_the_commands(void **state)
{
    (void)state;
    static const char *const expected[] = {"methods", "eval", "fit", "emit", "report"};
    commands list = list_commands();
    for (size_t i = 0; i < sizeof expected / sizeof *expected; i++) {
        bool found = false;
        for (int k = 0; k < list.count; k++)
            found = found || strcmp(list.names[k], expected[i]) == 0;
        if (!found)
            fail_msg("sgfit --help does not list %s", expected[i]);
    }
}

static void every_command_has_help(void **state)
{
    (void)state;
    commands list = list_commands();
    for (int k = 0; k < list.count; k++) {
        char usage[64];
        snprintf(usage, sizeof usage, "usage: sgfit %s", list.names[k]);
        run r = RUN(NULL, list.names[k], "--help");
        assert_int_equal(r.status, 0);
        assert_string_equal(r.error, "");
        assert_int_equal(strncmp(r.out, usage, strlen(usage)), 0);
        run_free(&r);
    }
}

static void every_command_refuses_unknown_options(void **state)
{
    (void)state;
    commands list = list_commands();
    for (int k = 0; k < list.count; k++) {
        run r = RUN(NULL, list.names[k], "--no-such-option");
        assert_one_line(r.error, list.names[k], "--no-such-option");
        assert_string_equal(r.out, "");
        assert_int_equal(r.status, 2);
        run_free(&r);
    }
}

/* Each line of the README that runs the program: its command and options are there, and so are the
 * recipes that it names. */
static void the_readme_runs_what_there_is(void **state)
{
    (void)state;
    static const char program[] = "    build/sgfit ";
    char *readme = base_join(getenv("SGFIT_ROOT"), "README.md"),
         *text = base_read_file(readme, NULL);
    assert_non_null(text);
    int found = 0;
    for (char *line = strtok(text, "\n"), *rest; line; line = strtok(NULL, "\n")) {
        if (strncmp(line, program, strlen(program)) != 0)
            continue;
        line[strcspn(line, "#&|<>")] = '\0';
        char *command = strtok_r(line + strlen(program), " ", &rest);
        run help = RUN(NULL, command, "--help");
        assert_int_equal(help.status, 0);
        bool option = false;
        for (char *word; (word = strtok_r(NULL, " ", &rest)) != NULL;) {
            char shown[64];
            snprintf(shown, sizeof shown, "\n  %s ", word);
            bool is_option = word[0] == '-';
            if (is_option && !strstr(help.out, shown))
                fail_msg("README: %s has no %s", command, word);
            if (!is_option && !option && strcmp(command, "fit") == 0) {
                run list = RUN(NULL, "fit", "--list");
                snprintf(shown, sizeof shown, "\n%s,", word);
                if (!strstr(list.out, shown))
                    fail_msg("README: there is no recipe %s", word);
                run_free(&list);
            }
            option = is_option;
        }
        run_free(&help);
        found++;
    }
    assert_true(found >= 11);
    free(text);
    free(readme);
}

static void a_wrong_command_is_one_line(void **state)
{
    (void)state;
    static const char *const bad[] = {NULL, "", "Eval", "--verbose", "evaluate\n"};
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++) {
        run r = program_run((const char *const[]){bad[i], NULL}, NULL);
        assert_one_line(r.error, "sgfit --help");
        assert_string_equal(r.out, "");
        assert_int_equal(r.status, 2);
        run_free(&r);
    }
}

static void version_is_the_library_s(void **state)
{
    (void)state;
    run r = RUN(NULL, "--version");
    assert_string_equal(r.out, "sgfit " SG_VERSION "\n");
    assert_int_equal(r.status, 0);
    run_free(&r);
}

static void text_to_a_full_disk_is_a_failure(void **state)
{
    (void)state;
    static const char *const texts[][2] = {
        {"--help"}, {"--version"}, {"methods"}, {"methods", "--json"}, {"eval", "--help"}};
    for (size_t i = 0; i < sizeof texts / sizeof *texts; i++) {
        const run_options full = {.out_path = "/dev/full"};
        run r = program_run((const char *const[]){texts[i][0], texts[i][1], NULL}, &full);
        assert_one_line(r.error, "standard output");
        assert_int_equal(r.status, 1);
        run_free(&r);
    }
}

static void methods_lists_the_registry(void **state)
{
    (void)state;
    run r = RUN(NULL, "methods");
    assert_int_equal(r.status, 0);
    for (size_t i = 0; i < sg_method_count(); i++)
        assert_non_null(strstr(r.out, sg_method_at(i)->id));
    run_free(&r);
}

static void assert_text_of(const cJSON *object, const char *key, const char *expected)
{
    const cJSON *item = cJSON_GetObjectItemCaseSensitive(object, key);
    assert_true(cJSON_IsString(item));
    assert_string_equal(item->valuestring, expected);
    assert_true(expected[0] != '\0');
}

static void methods_as_json_tells_the_registry(void **state)
{
    (void)state;
    run r = RUN(NULL, "methods", "--json");
    assert_int_equal(r.status, 0);
    cJSON *array = cJSON_ParseWithOpts(r.out, NULL, true);
    assert_true(cJSON_IsArray(array));
    assert_int_equal(cJSON_GetArraySize(array), sg_method_count());
    for (size_t i = 0; i < sg_method_count(); i++) {
        const sg_method *method = sg_method_at(i);
        const cJSON *object = cJSON_GetArrayItem(array, (int)i);
        assert_text_of(object, "id", method->id);
        assert_text_of(object, "title", method->title);
        assert_text_of(object, "source", method->source);
        assert_text_of(object, "variant", method->variant);
        assert_text_of(object, "form", method->form->id);
        const cJSON *year = cJSON_GetObjectItemCaseSensitive(object, "year");
        assert_true(cJSON_IsNumber(year) && year->valueint == method->year);
        const cJSON *range = cJSON_GetObjectItemCaseSensitive(
            cJSON_GetObjectItemCaseSensitive(object, "domain"), "lambda");
        assert_int_equal(cJSON_GetArraySize(range), 2);
        assert_true(cJSON_GetArrayItem(range, 0)->valuedouble == method->lambda_min);
        const cJSON *numbers = cJSON_GetObjectItemCaseSensitive(object, "coefficients");
        for (int k = 0; k < method->form->coefficient_count; k++) {
            const cJSON *number =
                cJSON_GetObjectItemCaseSensitive(numbers, method->form->coefficient_names[k]);
            assert_true(cJSON_IsNumber(number) && number->valuedouble == method->coefficients[k]);
        }
    }
    cJSON_Delete(array);
    run_free(&r);
}

static void all_published_approximations_are_there_with_a_stable_form_where_they_break(void **state)
{
    (void)state;
    static const char *const ids[] = {
        "constant_cosine",      "tokuyoshi_2016",       "wang_2009",
        "pettineo_hill_2016",   "meder_2018",           "meder_2018_hg",
        "tokuyoshi_2022",       "tokuyoshi_2024",       "pettineo_hill_2016_stable",
        "meder_2018_stable",    "meder_2018_hg_stable", "tokuyoshi_2022_stable",
        "tokuyoshi_2024_stable"};
    for (size_t i = 0; i < sizeof ids / sizeof *ids; i++)
        if (!sg_method_find(ids[i]))
            fail_msg("the registry has no %s", ids[i]);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(help_lists_the_commands),
        cmocka_unit_test(every_command_has_help),
        cmocka_unit_test(every_command_refuses_unknown_options),
        cmocka_unit_test(the_readme_runs_what_there_is),
        cmocka_unit_test(a_wrong_command_is_one_line),
        cmocka_unit_test(version_is_the_library_s),
        cmocka_unit_test(text_to_a_full_disk_is_a_failure),
        cmocka_unit_test(methods_lists_the_registry),
        cmocka_unit_test(methods_as_json_tells_the_registry),
        cmocka_unit_test(
            all_published_approximations_are_there_with_a_stable_form_where_they_break),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
