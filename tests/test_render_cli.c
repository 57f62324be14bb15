/* sgfit render as users run it: what it writes, what it refuses, and that it leaves nothing behind.
 */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cjson/cJSON.h>
#include <cmocka.h>

#include "base/exr.h"
#include "base/json.h"
#include "capture.h"
#include "program.h"
#include "workspace.h"

static workspace work;

/* A path in the folder; four of them at a time. */
static const char *at(const char *name)
{
    static char paths[4][1100];
    static int next;
    char *path = paths[next++ % 4];
    snprintf(path, sizeof paths[0], "%s/%s", work.folder, name);
    return path;
}

static void skip_without_device(const run *result)
{
    if (result->status != 0 && strstr(result->error, "Vulkan") && !getenv("CI")) {
        fprintf(stderr, "skipped: %s\n", result->error);
        skip();
    }
}

static void succeed(run result)
{
    skip_without_device(&result);
    if (result.status != 0 || result.error[0])
        fail_msg("status %d: %s", result.status, result.error);
    run_free(&result);
}

static void assert_refused(run result, int status, const char *word)
{
    if (result.status != status || result.out[0] ||
        !is_one_line(result.error, (const char *const[]){word, NULL}))
        fail_msg("status %d, expected %d with \"%s\": %s%s", result.status, status, word,
                 result.out, result.error);
    run_free(&result);
}

static void assert_same_file(const char *a, const char *b)
{
    size_t sizes[2];
    char *first = workspace_read_path(a, &sizes[0]), *second = workspace_read_path(b, &sizes[1]);
    assert_non_null(first);
    assert_non_null(second);
    assert_int_equal(sizes[0], sizes[1]);
    assert_memory_equal(first, second, sizes[0]);
    free(first);
    free(second);
}

static void test_outputs(void **state)
{
    (void)state;
    static const char *const keys[] = {"pixels_covered",
                                       "pixels_uncovered",
                                       "pixels_wrong",
                                       "quads",
                                       "vertices",
                                       "light_evaluations",
                                       "triangles",
                                       "lights",
                                       "rel",
                                       "p50",
                                       "p95",
                                       "p99",
                                       "p999",
                                       "bias",
                                       "ground_truth_evaluations"};
    static const char *const channels[] = {"R", "G", "B"};
    succeed(RUN(NULL, "render", "--pipeline", "exact", "--size", "33x17", "--compare", "exact",
                "--out", at("a.exr"), "--png", at("a.png"), "--stats", at("a.json")));
    cJSON *json = base_json_read(at("a.json"));
    assert_non_null(json);
    double value;
    for (size_t i = 0; i < sizeof keys / sizeof *keys; i++) {
        assert_true(base_json_f64(json, "a.json", keys[i], &value));
        assert_true(isfinite(value));
    }
    /* ground truth against itself */
    assert_true(base_json_f64(json, "a.json", "rel", &value) && value == 0);
    const cJSON *times;
    assert_true(base_json_object(json, "a.json", "times_ms", &times));
    assert_true(base_json_f64(times, "a.json", "exact", &value) && value > 0);
    assert_true(base_json_f64(times, "a.json", "gbuffer", &value) && value > 0);
    cJSON_Delete(json);
    double sum = 0;
    for (int c = 0; c < 3; c++) {
        int width, height;
        float *pixels = exr_read(at("a.exr"), channels[c], &width, &height);
        assert_non_null(pixels);
        assert_int_equal(width, 33);
        assert_int_equal(height, 17);
        for (int i = 0; i < 33 * 17; i++) {
            assert_true(pixels[i] >= 0 && isfinite(pixels[i]));
            sum += (double)pixels[i];
        }
        free(pixels);
    }
    assert_true(sum > 0);
    size_t size;
    char *png = workspace_read_path(at("a.png"), &size);
    assert_true(png && size > 100 && memcmp(png, "\x89PNG\r\n\x1a\n", 8) == 0);
    free(png);
}

/* Statistics alone go to standard output, as JSON. */
static void test_standard_output(void **state)
{
    (void)state;
    run result = RUN(NULL, "render", "--pipeline", "exact", "--size", "8x8");
    skip_without_device(&result);
    assert_int_equal(result.status, 0);
    cJSON *json = cJSON_Parse(result.out);
    double value;
    assert_non_null(json);
    assert_true(base_json_f64(json, "standard output", "triangles", &value) && value == 5200);
    cJSON_Delete(json);
    run_free(&result);
}

/* The default pipeline and ground truth, with and without layers: the same bytes again. */
static void test_same_bytes(void **state)
{
    (void)state;
    static const char *const names[2][2] = {{"1.exr", "1.png"}, {"2.exr", "2.png"}};
    for (int pipeline = 0; pipeline < 2; pipeline++) {
        for (int i = 0; i < 2; i++)
            succeed(pipeline ? RUN(NULL, "render", "--size", "65x37", "--out", at(names[i][0]),
                                   "--layers", "--png", at(names[i][1]), "--stats", at("s.json"))
                             : RUN(NULL, "render", "--size", "65x37", "--out", at(names[i][0]),
                                   "--pipeline", "exact", "--png", at(names[i][1]), "--stats",
                                   at("s.json"), "--detailed-normals"));
        assert_same_file(at("1.exr"), at("2.exr"));
        assert_same_file(at("1.png"), at("2.png"));
    }
}

static void test_refused_arguments(void **state)
{
    (void)state;
    assert_refused(RUN(NULL, "render", "--pipeline", "raster"), 2, "--pipeline");
    assert_refused(RUN(NULL, "render", "--method", "no_such"), 2, "--method");
    assert_refused(RUN(NULL, "render", "--compare", "meder"), 2, "--compare");
    assert_refused(RUN(NULL, "render", "--runs", "0"), 2, "--runs");
    assert_refused(RUN(NULL, "render", "--layers"), 2, "--layers");
    assert_refused(RUN(NULL, "render", "--window"), 2, "--window");
    static const char *const sizes[] = {"0x10",  "10x0",   "10",    "x",
                                        "10x",   "-1x5",   "1e9x5", "5x99999999999999999999",
                                        "5x5x5", "20000x1"};
    for (size_t i = 0; i < sizeof sizes / sizeof *sizes; i++)
        assert_refused(RUN(NULL, "render", "--size", sizes[i]), 2, "--size");
}

static void test_refused_scenes(void **state)
{
    (void)state;
    assert_refused(RUN(NULL, "render", "--scene", at("absent.json")), 2, "absent.json");
    workspace_write(&work, "bad.json", "{\"meshes\": [], \"sun\": 1}");
    assert_refused(RUN(NULL, "render", "--scene", at("bad.json")), 2, "\"sun\"");
    workspace_write(&work, "far.json", "{\"meshes\": [{\"file\": \"absent.obj\"}]}");
    assert_refused(RUN(NULL, "render", "--scene", at("far.json"), "--scene-dir", work.folder), 2,
                   "absent.obj");
    workspace_write(&work, "cut.ply", "ply\nformat ascii 1.0\nelement vertex 3\n");
    workspace_write(&work, "cut.json", "{\"meshes\": [{\"file\": \"cut.ply\"}]}");
    assert_refused(RUN(NULL, "render", "--scene", at("cut.json")), 2, "cut.ply");
}

/* A driver that is not there: one line, nothing written. */
static void test_no_device(void **state)
{
    (void)state;
    const char *before = getenv("VK_ICD_FILENAMES");
    char *saved = before ? strdup(before) : NULL;
    setenv("VK_ICD_FILENAMES", "/nonexistent/icd.json", 1);
    setenv("VK_DRIVER_FILES", "/nonexistent/icd.json", 1);
    run result = RUN(NULL, "render", "--pipeline", "exact", "--size", "4x4", "--out", at("n.exr"));
    if (saved)
        setenv("VK_ICD_FILENAMES", saved, 1);
    else
        unsetenv("VK_ICD_FILENAMES");
    unsetenv("VK_DRIVER_FILES");
    free(saved);
    assert_refused(result, 1, "Vulkan");
    assert_int_equal(access(at("n.exr"), F_OK), -1);
    result = RUN(NULL, "render", "--pipeline", "exact", "--size", "4x4", "--device", "nonesuch");
    assert_refused(result, 1, "nonesuch");
}

/* A file that cannot be written is named; neither it nor a part of anything is left. */
static void test_unwritable(void **state)
{
    (void)state;
    static const char *const options[] = {"--out", "--png", "--stats"};
    assert_int_equal(shell("mkdir '%s/out'", work.folder), 0);
    for (size_t i = 0; i < 3; i++) {
        run result = RUN(NULL, "render", "--pipeline", "exact", "--size", "5x3", options[i],
                         at("out/no/such.file"));
        skip_without_device(&result);
        assert_refused(result, 1, "out/no/such.file");
        result = RUN(NULL, "render", "--pipeline", "exact", "--size", "5x3", options[i], at("out"));
        assert_refused(result, 1, "directory");
    }
    workspace_write(&work, "file", "");
    run result =
        RUN(NULL, "render", "--pipeline", "exact", "--size", "5x3", "--dump", at("file/dump"));
    assert_refused(result, 1, "file/dump");
    assert_int_equal(shell("test -z \"$(ls -A '%s/out')\"", work.folder), 0);
    assert_int_equal(shell("test -z \"$(ls '%s' | grep '[.]part$')\"", work.folder), 0);
    result = RUN(&(run_options){.out_path = "/dev/full"}, "render", "--pipeline", "exact", "--size",
                 "5x3");
    assert_int_equal(result.status, 1);
    run_free(&result);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_outputs),        cmocka_unit_test(test_standard_output),
        cmocka_unit_test(test_same_bytes),     cmocka_unit_test(test_refused_arguments),
        cmocka_unit_test(test_refused_scenes), cmocka_unit_test(test_no_device),
        cmocka_unit_test(test_unwritable)};
    workspace_open(&work);
    int failed = cmocka_run_group_tests(tests, NULL, NULL);
    workspace_close(&work);
    return failed;
}
