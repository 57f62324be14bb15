/* test_choose.c: `sgfit choose` against a brute-force answer, and what it refuses. */
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

/* Instructions of L in tables/cost.csv, found without the program's own CSV reader; NaN if none. */
static double counted(const char *id)
{
    char path[1024];
    snprintf(path, sizeof path, "%s/tables/cost.csv", getenv("SGFIT_ROOT"));
    FILE *file = fopen(path, "r");
    assert_non_null(file);
    char line[2048], start[128];
    snprintf(start, sizeof start, "%s,L,", id);
    int column = -1;
    double found = (double)NAN;
    while (fgets(line, sizeof line, file)) {
        bool header = strncmp(line, "method,", 7) == 0;
        if (!header && strncmp(line, start, strlen(start)) != 0)
            continue;
        int at = 0;
        for (char *field = line; field; at++) {
            char *comma = strchr(field, ',');
            if (comma)
                *comma = '\0';
            if (header && strcmp(field, "gpu_include_instructions") == 0)
                column = at;
            else if (!header && at == column && *field)
                found = strtod(field, NULL);
            field = comma ? comma + 1 : NULL;
        }
    }
    fclose(file);
    return found;
}

/* Points of a domain as the shader gets them. */
typedef struct points {
    float lambda[4000], cos_theta[4000];
    double weight[4000];
    int count;
} points;

static double error_at(const sg_method *method, const points *p, bool rmse)
{
    double worst = 0.0, squares = 0.0, weights = 0.0;
    for (int i = 0; i < p->count; i++) {
        float value = method->L_f32(p->lambda[i], p->cos_theta[i]);
        double miss = fabs((double)value - sg_L_cos((double)p->lambda[i], (double)p->cos_theta[i]));
        worst = isfinite(value) ? fmax(worst, miss) : (double)INFINITY;
        squares += p->weight[i] * miss * miss;
        weights += p->weight[i];
        if (!isfinite(value))
            return (double)INFINITY;
    }
    return rmse ? sqrt(squares / weights) : worst;
}

/* The least cost of a method that is declared for the points and stays under `most` there. */
static double least_cost(const points *p, double most, bool rmse)
{
    double least = (double)INFINITY, low = (double)INFINITY, high = 0.0;
    for (int i = 0; i < p->count; i++) {
        low = fmin(low, (double)p->lambda[i]);
        high = fmax(high, (double)p->lambda[i]);
    }
    for (size_t m = 0; m < sg_method_count(); m++) {
        const sg_method *method = sg_method_at(m);
        if (low >= method->lambda_min && high <= method->lambda_max &&
            error_at(method, p, rmse) <= most)
            least = fmin(least, counted(method->id));
    }
    return least;
}

static void write_profile(workspace *at, const points *p)
{
    char *text = malloc(128 * (size_t)p->count + 64), *end = text;
    assert_non_null(text);
    end += sprintf(end, "weight,lambda,note,cos_theta\n");
    for (int i = 0; i < p->count; i++)
        end += sprintf(end, "%.17g,%.9g,x,%.9g\n", p->weight[i], (double)p->lambda[i],
                       (double)p->cos_theta[i]);
    workspace_write(at, "profile.csv", text);
    free(text);
}

/* Asks the program and compares its answer with brute force on the same points. */
static void check_answer(workspace *at, const points *p, double most, bool rmse)
{
    char bound[64], path[1024];
    snprintf(bound, sizeof bound, "%.17g", most);
    snprintf(path, sizeof path, "%s", workspace_path(at, "profile.csv"));
    run r = program_run((const char *[]){"choose", "--max-error", bound, "--profile", path,
                                         "--metric", rmse ? "rmse" : "max", "--json", NULL},
                        NULL);
    double least = least_cost(p, most, rmse);
    if (isinf(least)) {
        assert_int_equal(r.status, 1);
        assert_non_null(strstr(r.error, "no method"));
        run_free(&r);
        return;
    }
    assert_int_equal(r.status, 0);
    cJSON *root = cJSON_Parse(r.out);
    const cJSON *chosen = cJSON_GetObjectItem(root, "chosen");
    const char *id = cJSON_GetStringValue(cJSON_GetObjectItem(chosen, "method"));
    assert_non_null(id);
    const sg_method *method = sg_method_find(id);
    assert_non_null(method);
    assert_float_equal(cJSON_GetNumberValue(cJSON_GetObjectItem(chosen, "cost")), least, 0.0);
    assert_true(error_at(method, p, rmse) <= most);
    /* What is cheaper misses, what is better costs more. */
    const cJSON *cheaper = cJSON_GetObjectItem(root, "next_cheaper");
    const cJSON *better = cJSON_GetObjectItem(root, "next_better");
    const char *error = rmse ? "rmse" : "max_abs";
    if (cJSON_IsObject(cheaper))
        assert_true(cJSON_GetNumberValue(cJSON_GetObjectItem(cheaper, error)) > most);
    if (cJSON_IsObject(better))
        assert_true(cJSON_GetNumberValue(cJSON_GetObjectItem(better, "cost")) > least);
    cJSON_Delete(root);
    run_free(&r);
}

static void fill(points *p, double low, double high)
{
    p->count = 0;
    for (int i = 0; i < 60; i++)
        for (int j = 0; j < 60; j++) {
            p->lambda[p->count] = (float)(low * pow(high / low, i / 59.0));
            p->cos_theta[p->count] = (float)cos(3.14159265358979 * j / 59.0);
            p->weight[p->count++] = 1.0 + (double)(i * j % 7);
        }
}

static void the_answer_is_that_of_brute_force(void **state)
{
    (void)state;
    static const double domains[][2] = {{1e-3, 1e4}, {1e-2, 2.0}, {50.0, 5e3}};
    static const double bounds[] = {0.2, 0.03, 4e-3, 1e-3, 1e-4, 1e-9};
    workspace at;
    points *p = malloc(sizeof *p);
    assert_non_null(p);
    workspace_open(&at);
    for (size_t d = 0; d < sizeof domains / sizeof *domains; d++) {
        fill(p, domains[d][0], domains[d][1]);
        write_profile(&at, p);
        for (size_t b = 0; b < sizeof bounds / sizeof *bounds; b++)
            check_answer(&at, p, bounds[b], b % 2 == 1);
    }
    workspace_close(&at);
    free(p);
}

/* The choice written as an include has that method and no other. */
static void the_include_has_just_that(void **state)
{
    (void)state;
    workspace at;
    workspace_open(&at);
    char path[1024];
    snprintf(path, sizeof path, "%s", workspace_path(&at, "just.glsl"));
    run r =
        RUN(NULL, "choose", "--max-error", "0.01", "--lambda", "1:100", "--emit", path, "--json");
    assert_int_equal(r.status, 0);
    cJSON *root = cJSON_Parse(r.out);
    const char *id =
        cJSON_GetStringValue(cJSON_GetObjectItem(cJSON_GetObjectItem(root, "chosen"), "method"));
    size_t size;
    char *text = workspace_read_path(path, &size);
    assert_non_null(text);
    for (size_t m = 0; m < sg_method_count(); m++) {
        char function[128];
        snprintf(function, sizeof function, "float sg_L_%s(", sg_method_at(m)->id);
        assert_int_equal(strstr(text, function) != NULL, strcmp(sg_method_at(m)->id, id) == 0);
    }
    free(text);
    cJSON_Delete(root);
    run_free(&r);
    workspace_close(&at);
}

static void wrong_wishes_are_refused(void **state)
{
    (void)state;
    workspace at;
    workspace_open(&at);
    program_refuses((const char *[]){"choose", NULL}, 2, "--max-error");
    program_refuses((const char *[]){"choose", "--max-error", "0", NULL}, 2, "above 0");
    program_refuses((const char *[]){"choose", "--max-error", "1", "--lambda", "5:1", NULL}, 2,
                    "5:1");
    program_refuses((const char *[]){"choose", "--max-error", "1", "--lambda", "-1:1", NULL}, 2,
                    "-1:1");
    program_refuses((const char *[]){"choose", "--max-error", "1", "--metric", "mean", NULL}, 2,
                    "mean");
    program_refuses(
        (const char *[]){"choose", "--max-error", "1", "--cost", "cpu", "--rate", "split", NULL}, 2,
        "--rate split");
    program_refuses(
        (const char *[]){"choose", "--max-error", "1", "--profile", "/nowhere.csv", NULL}, 2,
        "/nowhere.csv");
    static const struct {
        const char *text, *names;
    } profiles[] = {{"lambda,cos_theta\n1,1\n", "weight"},
                    {"lambda,cos_theta,weight\n", "at least one row"},
                    {"lambda,cos_theta,weight\n1,0.5,0\n", "at least one row"},
                    {"lambda,cos_theta,weight\n1,0.5,1\n-1,0.5,1\n", "line 3"},
                    {"lambda,cos_theta,weight\n1,2,1\n", "cos_theta"},
                    {"lambda,cos_theta,weight\n1,nan,1\n", "line 2"},
                    {"lambda,cos_theta,weight\n1,0.5,-1\n", "weight"}};
    for (size_t i = 0; i < sizeof profiles / sizeof *profiles; i++) {
        workspace_write(&at, "bad.csv", profiles[i].text);
        program_refuses((const char *[]){"choose", "--max-error", "1", "--profile",
                                         workspace_path(&at, "bad.csv"), NULL},
                        2, profiles[i].names);
    }
    workspace_close(&at);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_answer_is_that_of_brute_force),
        cmocka_unit_test(the_include_has_just_that),
        cmocka_unit_test(wrong_wishes_are_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
