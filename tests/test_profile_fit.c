/* test_profile_fit.c: `sgfit fit --profile`: what it chooses, and what it refuses. */
#include <setjmp.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include <cjson/cJSON.h>
#include <cmocka.h>
#include <math.h>

#include "program.h"
#include "sg.h"
#include "workspace.h"

enum { ROWS = 60 };

/* Lights of sharpness 5 to 50 at any angle. */
static void write_profile(workspace *at)
{
    char text[ROWS * 64 + 64], *end = text;
    end += sprintf(end, "lambda,cos_theta,weight\n");
    for (int i = 0; i < ROWS; i++)
        end += sprintf(end, "%.9g,%.9g,%d\n", 5.0 * pow(10.0, (i * 7 % ROWS) / (ROWS - 1.0)),
                       -1.0 + 2.0 * i / (ROWS - 1.0), 1 + i % 3);
    workspace_write(at, "profile.csv", text);
}

/* RMSE in float by the weights of that profile, or the largest error. */
static double error_of(const sg_form *form, const float *k, bool by_max)
{
    double squares = 0.0, weights = 0.0, largest = 0.0;
    for (int i = 0; i < ROWS; i++) {
        float lambda = (float)(5.0 * pow(10.0, (i * 7 % ROWS) / (ROWS - 1.0)));
        float z = (float)(-1.0 + 2.0 * i / (ROWS - 1.0));
        double miss = (double)form->f32(lambda, z, k) - sg_L_cos((double)lambda, (double)z);
        squares += (1 + i % 3) * miss * miss;
        weights += 1 + i % 3;
        largest = fmax(largest, fabs(miss));
    }
    return by_max ? largest : sqrt(squares / weights);
}

/* Instructions in the row of that role, its fifth column; NaN where there is none. */
static double instructions(const char *out, const char *role)
{
    char start[32];
    snprintf(start, sizeof start, "\n%s,", role);
    const char *row = strstr(out, start);
    for (int i = 0; row && i < 4; i++)
        row = strchr(row + 1, ',');
    return row ? strtod(row + 1, NULL) : (double)NAN;
}

/* The constants written are the form with them as it stands in the registry: error and safety. */
static void check_constants(const char *text, bool by_max, double most)
{
    cJSON *root = cJSON_Parse(text);
    assert_non_null(root);
    const sg_form *form = sg_form_find(cJSON_GetObjectItem(root, "form")->valuestring);
    assert_non_null(form);
    const cJSON *list = cJSON_GetObjectItem(root, "coefficients");
    float k[64];
    int zeros = 0;
    for (int i = 0; i < form->coefficient_count; i++) {
        double value = cJSON_GetNumberValue(cJSON_GetObjectItem(list, form->coefficient_names[i]));
        k[i] = (float)value;
        zeros += value == 0.0;
    }
    const cJSON *provenance = cJSON_GetObjectItem(root, "provenance");
    assert_int_equal(zeros, cJSON_GetArraySize(cJSON_GetObjectItem(provenance, "dropped")));
    double error = error_of(form, k, by_max);
    assert_true(error <= most);
    const cJSON *told = cJSON_GetObjectItem(provenance, "on_profile");
    double said =
        cJSON_GetNumberValue(cJSON_GetObjectItem(told, by_max ? "max_abs_f32" : "rmse_f32"));
    assert_true(fabs(said - error) <= 1e-9 * error);
    for (int i = 0; i <= 400; i++)
        for (int j = -10; j <= 10; j++) {
            float value =
                form->f32((float)(i ? pow(10.0, i * 0.05 - 5.0) : 0.0), 0.1f * (float)j, k);
            assert_true(value >= 0.0f && value <= 1.0f);
        }
    cJSON_Delete(root);
}

static void fewest_instructions(const char *metric, const char *most)
{
    workspace at;
    workspace_open(&at);
    write_profile(&at);
    char profile[1024], out[1024], glsl[1024];
    snprintf(profile, sizeof profile, "%s", workspace_path(&at, "profile.csv"));
    snprintf(out, sizeof out, "%s", workspace_path(&at, "profile.json"));
    snprintf(glsl, sizeof glsl, "%s", workspace_path(&at, "profile.glsl"));
    run r = RUN(NULL, "fit", "--profile", profile, "--metric", metric, "--max-error", most, "--out",
                out, "--emit", glsl);
    assert_int_equal(r.status, 0);
    double chosen = instructions(r.out, "chosen"), general = instructions(r.out, "general");
    assert_true(chosen > 0.0 && chosen <= general);
    size_t size;
    char *text = workspace_read_path(out, &size), *shader = workspace_read_path(glsl, &size);
    assert_non_null(text);
    assert_non_null(shader);
    check_constants(text, strcmp(metric, "max") == 0, strtod(most, NULL));
    assert_non_null(strstr(shader, "float sg_L_profile(float lambda, float cos_theta)"));
    assert_non_null(strstr(shader, "float sg_A_h_profile(float lambda, float cos_theta)"));
    assert_null(strstr(text, profile));
    assert_null(strstr(shader, profile));
    free(text);
    free(shader);
    run_free(&r);
    workspace_close(&at);
}

static void the_fewest_instructions_under_an_error(void **state)
{
    (void)state;
    fewest_instructions("rmse", "1e-3");
}

static void the_fewest_instructions_under_a_largest_error(void **state)
{
    (void)state;
    fewest_instructions("max", "2e-3");
}

static void a_budget_is_kept(void **state)
{
    (void)state;
    workspace at;
    workspace_open(&at);
    write_profile(&at);
    const char *profile = workspace_path(&at, "profile.csv");
    run r = RUN(NULL, "fit", "--profile", profile, "--budget", "22", "--max-error", "0.02");
    assert_int_equal(r.status, 0);
    assert_true(instructions(r.out, "chosen") <= 22.0);
    run_free(&r);
    r = RUN(NULL, "fit", "--profile", profile, "--budget", "3", "--max-error", "1e-3");
    assert_int_equal(r.status, 1);
    assert_non_null(strstr(r.error, "no candidate"));
    assert_int_equal(r.out_size, 0);
    run_free(&r);
    workspace_close(&at);
}

static void wrong_wishes_are_refused(void **state)
{
    (void)state;
    workspace at;
    workspace_open(&at);
    workspace_write(&at, "bad.csv", "lambda,cos_theta,weight\n1,0.5,1\n1,7,1\n");
    const char *bad = workspace_path(&at, "bad.csv");
    program_refuses((const char *[]){"fit", "--profile", "/nowhere.csv", NULL}, 2, "/nowhere.csv");
    program_refuses((const char *[]){"fit", "--profile", bad, NULL}, 2, "line 3");
    program_refuses((const char *[]){"fit", "--profile", bad, "--budget", "0", NULL}, 2,
                    "--budget");
    program_refuses((const char *[]){"fit", "--profile", bad, "--max-error", "-1", NULL}, 2,
                    "--max-error");
    program_refuses((const char *[]){"fit", "--profile", bad, "--metric", "mean", NULL}, 2, "mean");
    program_refuses((const char *[]){"fit", "--profile", bad, "--list", NULL}, 2, "--list");
    program_refuses((const char *[]){"fit", "--profile", bad, "quick", NULL}, 2, "recipes");
    program_refuses((const char *[]){"fit", "--budget", "20", NULL}, 2, "--profile");
    workspace_close(&at);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_fewest_instructions_under_an_error),
        cmocka_unit_test(the_fewest_instructions_under_a_largest_error),
        cmocka_unit_test(a_budget_is_kept),
        cmocka_unit_test(wrong_wishes_are_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
