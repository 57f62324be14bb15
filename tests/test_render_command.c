/* sgfit render as users run it: files, statistics, refusals. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include <math.h>

#include "base/exr.h"
#include "base/json.h"
#include "capture.h"
#include "program.h"
#include "work.h"

/* Skips where the driver is missing, unless CI is set. */
static run render_or_skip(const char *const *arguments)
{
    run r = program_run(arguments, NULL);
    if (r.status == 1 && strstr(r.error, "no Vulkan") && !getenv("CI")) {
        fprintf(stderr, "skipped: %s", r.error);
        skip();
    }
    return r;
}

static double number(const cJSON *object, const char *key)
{
    const cJSON *item = cJSON_GetObjectItemCaseSensitive(object, key);
    if (!cJSON_IsNumber(item))
        fail_msg("no number \"%s\"", key);
    return item->valuedouble;
}

static void statistics_have_every_key(void **state)
{
    (void)state;
    run r = render_or_skip((const char *const[]){"render", "--size", "64x36", "--pipeline", "exact",
                                                 "--compare", "exact", NULL});
    if (r.status != 0 || r.error[0])
        fail_msg("status %d: %s", r.status, r.error);
    cJSON *json = cJSON_Parse(r.out);
    assert_non_null(json);
    static const char *const positive[] = {"triangles",
                                           "lights",
                                           "pixels_covered",
                                           "light_evaluations",
                                           "ground_truth_evaluations",
                                           "frame_ms",
                                           "lighting_ms",
                                           "ground_truth_ms",
                                           "gain"};
    for (size_t i = 0; i < sizeof positive / sizeof *positive; i++)
        assert_true(number(json, positive[i]) > 0);
    static const char *const zero[] = {"pixels_uncovered",
                                       "pixels_wrong",
                                       "quads",
                                       "vertices",
                                       "rel",
                                       "p50",
                                       "p95",
                                       "p99",
                                       "p999",
                                       "bias"};
    for (size_t i = 0; i < sizeof zero / sizeof *zero; i++)
        assert_true(number(json, zero[i]) == 0);
    assert_true(number(json, "triangles") == 5200); /* of the built-in scene */
    assert_true(number(json, "light_evaluations") ==
                number(json, "pixels_covered") * number(json, "lights"));
    const cJSON *times = cJSON_GetObjectItemCaseSensitive(json, "times_ms");
    assert_true(number(times, "gbuffer") > 0 && number(times, "exact") > 0);
    static const char *const texts[] = {"scene", "pipeline", "method", "device", "driver"};
    for (size_t i = 0; i < sizeof texts / sizeof *texts; i++)
        assert_true(cJSON_IsString(cJSON_GetObjectItemCaseSensitive(json, texts[i])));
    cJSON_Delete(json);
    run_free(&r);
}

/* The layers belong together: radiance is albedo over pi times irradiance, the depth is that of the
 * position, and two runs write the same bytes. */
static void files_hold_the_frame(void **state)
{
    (void)state;
    char first[1100], second[1100], picture[1100], stats[1100];
    snprintf(first, sizeof first, "%s", workspace_path(&work, "first.exr"));
    snprintf(second, sizeof second, "%s", workspace_path(&work, "second.exr"));
    snprintf(picture, sizeof picture, "%s", workspace_path(&work, "picture.png"));
    snprintf(stats, sizeof stats, "%s", workspace_path(&work, "stats.json"));
    const char *const *both[] = {(const char *const[]){"render", "--size", "48x27", "--pipeline",
                                                       "exact", "--layers", "--out", first, "--png",
                                                       picture, "--stats", stats, NULL},
                                 (const char *const[]){"render", "--size", "48x27", "--pipeline",
                                                       "exact", "--layers", "--out", second, NULL}};
    for (int i = 0; i < 2; i++) {
        run r = render_or_skip(both[i]);
        if (r.status != 0 || r.error[0])
            fail_msg("status %d: %s", r.status, r.error);
        assert_true((r.out[0] == 0) == (i == 0)); /* statistics went into their file */
        run_free(&r);
    }
    size_t sizes[2];
    char *bytes[2] = {workspace_read_path(first, &sizes[0]),
                      workspace_read_path(second, &sizes[1])};
    assert_int_equal(sizes[0], sizes[1]);
    assert_memory_equal(bytes[0], bytes[1], sizes[0]);
    free(bytes[0]);
    free(bytes[1]);
    static const char *const names[] = {"R",       "irradiance.R",      "albedo.R",
                                        "state.Y", "position.X",        "normal.Z",
                                        "depth.Z", "geometric_normal.Y"};
    float *layers[8];
    for (int i = 0; i < 8; i++) {
        int width, height;
        layers[i] = exr_read(first, names[i], &width, &height);
        assert_non_null(layers[i]);
        assert_int_equal(width, 48);
        assert_int_equal(height, 27);
    }
    float *colours[3] = {layers[0], exr_read(first, "G", &(int){0}, &(int){0}),
                         exr_read(first, "B", &(int){0}, &(int){0})};
    assert_true(colours[1] && colours[2]);
    int lit = 0;
    for (int i = 0; i < 48 * 27; i++) {
        double radiance = (double)layers[2][i] * (double)layers[1][i] / 3.14159265358979323846;
        assert_true(fabs((double)layers[0][i] - radiance) <= 1e-5 * radiance);
        assert_true((layers[3][i] == 1) == (layers[6][i] > 0));
        lit += layers[0][i] > 0;
        for (int c = 0; c < 3; c++)
            assert_true(colours[c][i] >= 0 && isfinite(colours[c][i]));
    }
    assert_true(lit > 300);
    for (int i = 0; i < 8; i++)
        free(layers[i]);
    free(colours[1]);
    free(colours[2]);
    size_t size;
    char *png = workspace_read_path(picture, &size);
    assert_non_null(png);
    assert_memory_equal(png + 1, "PNG", 3);
    free(png);
    cJSON *json = base_json_read(stats);
    assert_non_null(json);
    cJSON_Delete(json);
}

static void stages_are_dumped_as_pictures(void **state)
{
    (void)state;
    char folder[1100];
    snprintf(folder, sizeof folder, "%s", workspace_path(&work, "deep/stages"));
    run r = render_or_skip((const char *const[]){"render", "--size", "40x24", "--pipeline", "exact",
                                                 "--compare", "exact", "--dump", folder, NULL});
    assert_int_equal(r.status, 0);
    run_free(&r);
    static const char *const names[] = {"depth",  "normal",       "geometric_normal",
                                        "albedo", "irradiance",   "coverage",
                                        "truth",  "error_times_4"};
    for (size_t i = 0; i < sizeof names / sizeof *names; i++) {
        char name[100];
        snprintf(name, sizeof name, "deep/stages/%s.png", names[i]);
        char *bytes = workspace_read_path(workspace_path(&work, name), NULL);
        if (!bytes)
            fail_msg("%s is missing", name);
        free(bytes);
    }
}

static void wrong_input_is_refused_in_one_line(void **state)
{
    (void)state;
    static const struct {
        const char *option, *value, *told;
    } cases[] = {
        {"--size", "0x4", "--size"},
        {"--indirect", "gi", "none|lpv"},
        {"--volume", "0", "from 1 to 96"},
        {"--volume", "97", "from 1 to 96"},
        {"--volume", "8", "--indirect lpv"},
        {"--steps", "-1", "from 1 to 1024"},
        {"--steps", "9", "--indirect lpv"},
        {"--size", "10x0", "--size"},
        {"--size", "10x", "--size"},
        {"--size", "1e9x5", "--size"},
        {"--size", "5x99999999999999999999", "--size"},
        {"--size", "5x5x5", "--size"},
        {"--size", "12", "--size"},
        {"--size", "x", "--size"},
        {"--size", "4x-4", "--size"},
        {"--size", "20000x1", "16384"},
        {"--pipeline", "nope", "exact"},
        {"--method", "nope", "methods"},
        {"--runs", "0", "--runs"},
        {"--runs", "1001", "1000"},
        {"--compare", "limit", "exact"},
        {"--compare", "meder", "--compare"},
        {"--window", NULL, "--window"},
        {"--scene", "/nonexistent/scene.json", "/nonexistent/scene.json"},
        {"--layers", NULL, "--out"},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        run r = RUN(NULL, "render", cases[i].option, cases[i].value);
        assert_int_equal(r.status, 2);
        assert_string_equal(r.out, "");
        assert_one_line(r.error, cases[i].told);
        run_free(&r);
    }
    run r = RUN(NULL, "render", "--pipeline", "exact", "--profile", "p.csv");
    assert_int_equal(r.status, 2);
    assert_one_line(r.error, "exact");
    run_free(&r);
    /* One file for two outputs: the second would silently replace the first. */
    r = RUN(NULL, "render", "--size", "8x8", "--out", "twice", "--stats", "./twice");
    assert_int_equal(r.status, 2);
    assert_one_line(r.error, "--stats: expected a file of its own, found that of --out");
    run_free(&r);
}

static void a_missing_device_is_one_line(void **state)
{
    (void)state;
    run r = RUN(NULL, "render", "--device", "no such device", "--size", "8x8");
    assert_int_equal(r.status, 1);
    assert_one_line(r.error, "no such device");
    run_free(&r);
    const char *before = getenv("VK_ICD_FILENAMES");
    char *kept = before ? strdup(before) : NULL;
    setenv("VK_ICD_FILENAMES", "/nonexistent.json", 1);
    const char *picture = workspace_path(&work, "never.exr");
    r = RUN(NULL, "render", "--size", "8x8", "--out", picture);
    assert_int_equal(r.status, 1);
    assert_one_line(r.error, "Vulkan");
    assert_string_equal(r.out, "");
    assert_int_equal(access(picture, F_OK), -1);
    run_free(&r);
    if (kept)
        setenv("VK_ICD_FILENAMES", kept, 1);
    else
        unsetenv("VK_ICD_FILENAMES");
    free(kept);
}

static void nothing_is_left_of_a_failed_output(void **state)
{
    (void)state;
    char stats[1100];
    snprintf(stats, sizeof stats, "%s", workspace_path(&work, "late.json"));
    run r = render_or_skip((const char *const[]){"render", "--size", "8x8", "--pipeline", "limit",
                                                 "--out", "/nonexistent/folder/a.exr", "--stats",
                                                 stats, NULL});
    assert_int_equal(r.status, 1);
    assert_one_line(r.error, "/nonexistent/folder/a.exr");
    assert_null(workspace_read_path(stats, NULL));
    run_free(&r);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(statistics_have_every_key),
        cmocka_unit_test(files_hold_the_frame),
        cmocka_unit_test(stages_are_dumped_as_pictures),
        cmocka_unit_test(wrong_input_is_refused_in_one_line),
        cmocka_unit_test(a_missing_device_is_one_line),
        cmocka_unit_test(nothing_is_left_of_a_failed_output),
    };
    return cmocka_run_group_tests(tests, open_work, close_work);
}
