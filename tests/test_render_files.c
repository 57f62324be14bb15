/* sgfit render: the same bytes again, scenes that it refuses, nothing left of what failed. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "capture.h"
#include "program.h"
#include "work.h"

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

static void test_refused_scenes(void **state)
{
    (void)state;
    assert_refused(RUN(NULL, "render", "--scene", at("absent.json")), 2, "absent.json");
    assert_refused(RUN(NULL, "render", "--compare", "shadows", "--device", "no such"), 1,
                   "\"box\" has none");
    workspace_write(&work, "bad.json", "{\"meshes\": [], \"sun\": 1}");
    assert_refused(RUN(NULL, "render", "--scene", at("bad.json")), 2, "\"sun\"");
    workspace_write(&work, "far.json", "{\"meshes\": [{\"file\": \"absent.obj\"}]}");
    assert_refused(RUN(NULL, "render", "--scene", at("far.json"), "--scene-dir", work.folder), 2,
                   "absent.obj");
    workspace_write(&work, "cut.ply", "ply\nformat ascii 1.0\nelement vertex 3\n");
    workspace_write(&work, "cut.json", "{\"meshes\": [{\"file\": \"cut.ply\"}]}");
    assert_refused(RUN(NULL, "render", "--scene", at("cut.json")), 2, "cut.ply");
}

/* A file that cannot be written is named; neither it nor a part of anything is left. */
static void test_unwritable(void **state)
{
    (void)state;
    static const char *const options[] = {"--out", "--png", "--stats", "--profile"};
    assert_int_equal(shell("mkdir '%s/out'", work.folder), 0);
    /* told before the device is looked for, even before the scene is read */
    for (size_t i = 0; i < 4; i++) {
        run result = RUN(NULL, "render", "--pipeline", "meder", "--scene", at("absent.json"),
                         options[i], at("out/no/such.file"));
        assert_refused(result, 1, "out/no/such.file");
        result = RUN(NULL, "render", "--pipeline", "meder", "--device", "no such", options[i],
                     at("out"));
        assert_refused(result, 1, "directory");
    }
    workspace_write(&work, "file", "");
    run result = RUN(NULL, "render", "--device", "no such", "--dump", at("file/dump"));
    assert_refused(result, 1, "file/dump");
    assert_refused(RUN(NULL, "render", "--dump", at("one"), "--png", at("one")), 2, "--dump");
    assert_refused(RUN(NULL, "bench", "--counts", at("out/no/such.file")), 1, "out/no/such.file");
    assert_refused(RUN(NULL, "bench", "--out", at("file/bench")), 1, "file/bench");
    assert_refused(RUN(NULL, "bench", "--scenes", "built-in", "--out", at("file/bench")), 1,
                   "file/bench");
    assert_refused(RUN(NULL, "choose", "--max-error", "1e-3", "--emit", at("out/no/such.file")), 1,
                   "out/no/such.file");
    assert_int_equal(shell("test -z \"$(ls -A '%s/out')\"", work.folder), 0);
    assert_int_equal(shell("test -z \"$(ls '%s' | grep '[.]part$')\"", work.folder), 0);
    /* a folder that the dump makes takes other files too */
    succeed(RUN(NULL, "render", "--pipeline", "exact", "--size", "5x3", "--dump", at("new/er"),
                "--png", at("new/er/image.png"), "--stats", at("new/er/image.json")));
    result = RUN(&(run_options){.out_path = "/dev/full"}, "render", "--pipeline", "exact", "--size",
                 "5x3");
    skip_without_device(&result);
    assert_int_equal(result.status, 1);
    run_free(&result);
}

/* Where memory is limited the program ends by itself, with a line, though the driver may crash. */
static void test_little_memory(void **state)
{
    (void)state;
#ifdef __SANITIZE_ADDRESS__
    skip(); /* needs terabytes of addresses */
#endif
    static const int limits[] = {200000, 500000};
    for (size_t i = 0; i < 2; i++) {
        int end = shell("cd '%s'; ulimit -c 0; ulimit -v %d; \"$SGFIT\" render --size 33x17 "
                        ">answer 2>error; test $? -le 1",
                        work.folder, limits[i]);
        assert_int_equal(end, 0);
        assert_int_equal(
            shell("cd '%s'; test -s answer || tail -n 1 error | grep -q '^sgfit: '", work.folder),
            0);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {

        cmocka_unit_test(test_same_bytes), cmocka_unit_test(test_refused_scenes),
        cmocka_unit_test(test_unwritable), cmocka_unit_test(test_little_memory)};
    return cmocka_run_group_tests(tests, open_work, close_work);
}
