/* lib/base/file: files that appear whole or not at all, folders. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

#include <cmocka.h>

#include "base/file.h"
#include "capture.h"
#include "work.h"

static void assert_only_file(const char *name)
{
    char **names;
    size_t count;
    assert_true(base_list(work.folder, "", &names, &count));
    for (size_t i = 0; i < count; i++)
        assert_null(strstr(names[i], ".part"));
    bool found = false;
    for (size_t i = 0; i < count; i++)
        found = found || strcmp(names[i], name) == 0;
    assert_true(found);
    base_list_free(names, count);
}

static void a_discarded_output_leaves_what_was_there(void **state)
{
    (void)state;
    char *path = workspace_file(&work, "kept.txt", "before");
    base_output output;
    assert_true(base_output_open(&output, path));
    fputs("half of ", output.stream);
    base_output_discard(&output);
    char *text = base_read_file(path, NULL);
    assert_string_equal(text, "before");
    free(text);
    assert_true(base_output_open(&output, path));
    fputs("after", output.stream);
    assert_true(base_output_close(&output));
    text = base_read_file(path, NULL);
    assert_string_equal(text, "after");
    free(text);
    assert_only_file("kept.txt");
    free(path);
}

static void a_link_and_a_device_stay_what_they_are(void **state)
{
    (void)state;
    char *path = workspace_file(&work, "target.txt", "before"),
         *link = workspace_file(&work, "link.txt", NULL);
    assert_int_equal(symlink("target.txt", link), 0);
    assert_true(base_write_file(link, "after", 5));
    struct stat status;
    assert_int_equal(lstat(link, &status), 0);
    assert_true(S_ISLNK(status.st_mode));
    char *text = base_read_file(path, NULL);
    assert_string_equal(text, "after");
    free(text);
    free(link);
    free(path);

    capture c;
    capture_begin(&c);
    bool good = base_write_file("/dev/full", "x", 1);
    assert_one_line(capture_end(&c), "/dev/full", "No space left");
    assert_false(good);
    assert_int_equal(stat("/dev/full", &status), 0);
    assert_true(S_ISCHR(status.st_mode));
}

static void what_cannot_be_written_or_read_is_named(void **state)
{
    (void)state;
    capture c;
    capture_begin(&c);
    bool good = base_write_file("/no/such/folder/x", "x", 1);
    assert_one_line(capture_end(&c), "/no/such/folder/x", "No such file");
    assert_false(good);
    capture_begin(&c);
    good = base_write_file(work.folder, "x", 1);
    assert_one_line(capture_end(&c), work.folder, "directory");
    assert_false(good);
    capture_begin(&c);
    char *text = base_read_file(work.folder, NULL);
    assert_one_line(capture_end(&c), work.folder, "directory");
    assert_null(text);
    char *path = workspace_file(&work, "file", "x"), *below = base_join(path, "below");
    capture_begin(&c);
    good = base_make_directory(below);
    assert_one_line(capture_end(&c), below, "Not a directory");
    assert_false(good);
    free(below);
    free(path);
}

/* Whether outputs can be written is told without writing any. */
static void outputs_are_tried_without_a_trace(void **state)
{
    (void)state;
    char *file = workspace_file(&work, "tried", "kept"), *below = base_join(file, "below"),
         *coming = base_join(work.folder, "coming/soon/"), *link = base_join(work.folder, "loose");
    assert_int_equal(symlink("nowhere/at/all", link), 0);
    assert_true(base_can_write(file) && base_can_write("/dev/null"));
    assert_true(base_can_fill(work.folder) && base_can_fill(coming) && base_can_fill("."));
    static const char *const words[] = {"directory", "No such file", "Not a directory"};
    const char *const files[] = {work.folder, "/no/such/folder/x", below};
    const char *const folders[] = {"", file, below, link};
    capture c;
    for (size_t i = 0; i < 3; i++) {
        capture_begin(&c);
        bool good = base_can_write(files[i]);
        assert_one_line(capture_end(&c), files[i], words[i]);
        assert_false(good);
    }
    for (size_t i = 0; i < 4; i++) {
        capture_begin(&c);
        bool good = base_can_fill(folders[i]);
        assert_one_line(capture_end(&c), folders[i], i ? "Not a directory" : "No such file");
        assert_false(good);
    }
    char *text = base_read_file(file, NULL);
    assert_string_equal(text, "kept");
    assert_only_file("tried");
    assert_int_equal(unlink(link), 0);
    coming[strlen(coming) - strlen("/soon/")] = '\0';
    assert_int_equal(access(coming, F_OK), -1);
    free(text);
    free(link);
    free(coming);
    free(below);
    free(file);
}

static void folders_are_made_and_listed_in_order(void **state)
{
    (void)state;
    char *deep = base_join(work.folder, "one//two/three/");
    assert_true(base_make_directory(deep));
    assert_true(base_make_directory(deep));
    const char *names_made[] = {"b.json", "a.json", "B.json", "a.txt", ".hidden.json"};
    for (size_t i = 0; i < 5; i++) {
        char *path = base_join(deep, names_made[i]);
        assert_true(base_write_file(path, "", 0));
        free(path);
    }
    char **names;
    size_t count;
    assert_true(base_list(deep, ".json", &names, &count));
    assert_int_equal(count, 3);
    assert_string_equal(names[0], "B.json");
    assert_string_equal(names[1], "a.json");
    assert_string_equal(names[2], "b.json");
    base_list_free(names, count);
    free(deep);
}

static void names_of_one_file_are_known(void **state)
{
    (void)state;
    char *file = workspace_file(&work, "single", "x"),
         *link = base_join(work.folder, "link_to_single");
    char *dotted = base_join(work.folder, "./single"), *coming = base_join(work.folder, "coming");
    char *dotted_coming = base_join(work.folder, "./coming");
    assert_int_equal(symlink(file, link), 0);
    assert_true(base_same_file(file, file));
    assert_true(base_same_file(file, link));
    assert_true(base_same_file(dotted, file));
    assert_true(base_same_file(coming, dotted_coming));
    assert_true(base_same_file("coming", "./coming"));
    assert_false(base_same_file(file, coming));
    assert_false(base_same_file("/no/such/folder/x", "/no/such/folder/x"));
    assert_false(base_same_file("/dev/null", "/dev/null"));
    free(dotted_coming);
    free(coming);
    free(dotted);
    free(link);
    free(file);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_discarded_output_leaves_what_was_there),
        cmocka_unit_test(a_link_and_a_device_stay_what_they_are),
        cmocka_unit_test(what_cannot_be_written_or_read_is_named),
        cmocka_unit_test(outputs_are_tried_without_a_trace),
        cmocka_unit_test(folders_are_made_and_listed_in_order),
        cmocka_unit_test(names_of_one_file_are_known),
    };
    return cmocka_run_group_tests(tests, open_work, close_work);
}
