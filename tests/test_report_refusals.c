/* test_report_refusals.c: `sgfit report` where its report cannot be written or drawn: one line that
 * names the place, the exit status, and an earlier report as it was. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include <signal.h>
#include <sys/resource.h>
#include <sys/stat.h>

#include "base/file.h"
#include "program.h"
#include "work.h"

static void a_folder_that_cannot_be_written_is_named(void **state)
{
    (void)state;
    char file[400], below[500];
    snprintf(file, sizeof file, "%s/a_file", work.folder);
    assert_true(base_write_file(file, "kept", 4));
    snprintf(below, sizeof below, "%s/report", file);
    program_refuses((const char *[]){"report", "--out", below, NULL}, 1, "a_file");
    program_refuses((const char *[]){"report", "--out", file, NULL}, 1, "a_file");
    char *kept = base_read_file(file, &(size_t){0});
    assert_string_equal(kept, "kept");
    free(kept);
    program_refuses((const char *[]){"report", NULL}, 2, "--out");
    program_refuses((const char *[]){"report", "--out", file, "--colour", NULL}, 2, "--colour");
}

/* The page is larger than files may be here; what was begun before it is taken back. */
static void where_the_disk_is_full_an_earlier_report_stays(void **state)
{
    (void)state;
    char target[400], path[500];
    snprintf(target, sizeof target, "%s/full", work.folder);
    snprintf(path, sizeof path, "%s/accuracy.csv", target);
    assert_true(base_make_directory(target) && base_write_file(path, "kept", 4));
    struct rlimit limit, small;
    getrlimit(RLIMIT_FSIZE, &limit);
    small = limit;
    small.rlim_cur = 256 * 1024;
    signal(SIGXFSZ, SIG_IGN);
    setrlimit(RLIMIT_FSIZE, &small);
    run r = program_run((const char *[]){"report", "--out", target, NULL}, NULL);
    setrlimit(RLIMIT_FSIZE, &limit);
    signal(SIGXFSZ, SIG_DFL);
    assert_int_equal(r.status, 1);
    const char *end = strchr(r.error, '\n');
    if (!end || end[1] || !strstr(r.error, "index.html"))
        fail_msg("expected one line that names index.html: %s", r.error);
    run_free(&r);
    char *kept = base_read_file(path, &(size_t){0});
    assert_string_equal(kept, "kept");
    free(kept);
    char **names;
    size_t count;
    char data[500];
    snprintf(data, sizeof data, "%s/data", target);
    assert_true(base_list(data, "", &names, &count));
    assert_int_equal(count, 0);
    base_list_free(names, count);
}

static void without_gnuplot_nothing_is_written(void **state)
{
    (void)state;
    char bare[400];
    snprintf(bare, sizeof bare, "%s/bare", work.folder);
    char *path = strdup(getenv("PATH"));
    setenv("PATH", work.folder, 1);
    program_refuses((const char *[]){"report", "--out", bare, NULL}, 1, "gnuplot");
    setenv("PATH", path, 1);
    free(path);
    rmdir(bare); /* made or not, it is empty */
    struct stat about;
    assert_int_not_equal(stat(bare, &about), 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_folder_that_cannot_be_written_is_named),
        cmocka_unit_test(where_the_disk_is_full_an_earlier_report_stays),
        cmocka_unit_test(without_gnuplot_nothing_is_written),
    };
    return cmocka_run_group_tests(tests, open_work, close_work);
}
