/* sgfit emit: what is committed is what it writes; a text file and a constants file are a method.
 */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "base/exr.h"
#include "base/text.h"
#include "emit_sources.h"
#include "program.h"
#include "sg.h"
#include "work.h"

static char *read_both(const char *name, char **committed, size_t *size, size_t *committed_size)
{
    char path[1024];
    snprintf(path, sizeof path, "%s/%s", getenv("SGFIT_ROOT"), name);
    *committed = workspace_read_path(path, committed_size);
    char *emitted = workspace_read_path(workspace_path(&work, name), size);
    if (!*committed || !emitted)
        print_message("missing: %s\n", name);
    assert_non_null(*committed);
    assert_non_null(emitted);
    return emitted;
}

static void test_texts_equal_what_is_committed(void **state)
{
    (void)state;
    static const char *const names[] = {"tables/out/forms.inc", "tables/out/methods.inc",
                                        "tables/out/registry.inc", "shaders/sg.glsl",
                                        "shaders/sg_table.glsl"};
    shell("rm -rf '%s'/*", work.folder);
    run emitted = RUN(NULL, "emit", "--all-to", work.folder);
    assert_int_equal(emitted.status, 0);
    assert_string_equal(emitted.error, "");
    assert_int_equal(emitted.out_size, 0);
    run_free(&emitted);
    for (size_t i = 0; i < sizeof names / sizeof *names; i++) {
        char *committed;
        size_t size, committed_size;
        char *text = read_both(names[i], &committed, &size, &committed_size);
        if (size != committed_size || memcmp(text, committed, size) != 0)
            print_message("%s differs: run `sgfit emit` and commit\n", names[i]);
        assert_int_equal(size, committed_size);
        assert_memory_equal(text, committed, size);
        free(text);
        free(committed);
    }
}

/* Numbers may differ by the given tolerance, everything else not at all. */
static void compare_csv(const char *name, double absolute, double relative)
{
    char *committed;
    size_t size, committed_size, numbers = 0;
    char *text = read_both(name, &committed, &size, &committed_size);
    const char *a = text, *b = committed;
    while (*a && *b) {
        size_t n = strcspn(a, ",\n"), m = strcspn(b, ",\n");
        double x, y;
        if (base_parse_f64(a, n, &x) && base_parse_f64(b, m, &y)) {
            assert_true(fabs(x - y) <= absolute + relative * fabs(y));
            numbers++;
        } else {
            assert_int_equal(n, m);
            assert_memory_equal(a, b, n);
        }
        assert_int_equal(a[n], b[m]);
        a += n + (a[n] != '\0');
        b += m + (b[m] != '\0');
    }
    assert_true(*a == *b);
    assert_true(numbers > 100);
    free(text);
    free(committed);
}

static void compare_exr(const char *name, float absolute, float relative)
{
    char path[1024];
    int width, height, committed_width, committed_height;
    snprintf(path, sizeof path, "%s/%s", getenv("SGFIT_ROOT"), name);
    float *committed = exr_read(path, NULL, &committed_width, &committed_height);
    float *emitted = exr_read(workspace_path(&work, name), NULL, &width, &height);
    assert_true(committed && emitted);
    assert_true(width == committed_width && height == committed_height);
    for (int i = 0; i < width * height; i++)
        assert_true(fabsf(emitted[i] - committed[i]) <= absolute + relative * fabsf(committed[i]));
    free(committed);
    free(emitted);
}

/* As tables/out/README.md states the tolerances; the same machine gives the same bytes. */
static void test_tables_equal_what_is_committed(void **state)
{
    (void)state;
    shell("rm -rf '%s'/*", work.folder);
    run emitted = RUN(NULL, "emit", "--all-to", work.folder);
    assert_int_equal(emitted.status, 0);
    run_free(&emitted);
    compare_csv("tables/out/curves_c_s.csv", 2e-10, 0);
    compare_csv("tables/out/curves_t_u.csv", 0, 2e-6);
    compare_exr("tables/out/tail_32_float.exr", 2e-6F, 0);
    compare_exr("tables/out/tail_32_half.exr", 6e-8F, 1.0F / 1024);
    assert_int_equal(shell("cp -r '%s/tables/out' '%s/first'", work.folder, work.folder), 0);
    emitted = RUN(NULL, "emit", "--all-to", work.folder);
    assert_int_equal(emitted.status, 0);
    run_free(&emitted);
    assert_int_equal(shell("diff -r '%s/tables/out' '%s/first'", work.folder, work.folder), 0);
}

/* ---- A method more: one text file and one constants file ------------------------------------ */

static void test_a_method_more(void **state)
{
    (void)state;
    copy_sources(&work);
    workspace_write(&work, "shaders/forms/test_form.glsl", new_form);
    workspace_write(&work, "tables/constants/test_method.json", new_method);
    run emitted = emit_copy(&work);
    assert_string_equal(emitted.error, "");
    assert_int_equal(emitted.status, 0);
    run_free(&emitted);
    char *shader = workspace_read_path(workspace_path(&work, "shaders/sg.glsl"), NULL);
    assert_non_null(strstr(shader, "    const float gain = 2.0;\n"));
    assert_non_null(strstr(shader, "return lit ? gain * cos_theta - (-0.5) : sg_mean(lambda);"));
    assert_non_null(strstr(shader, "float sg_A_h_test_method(float lambda, float cos_theta)"));
    free(shader);
    /* The library built from the emitted instances has it, at each precision. */
    const char *root = getenv("SGFIT_ROOT");
    workspace_write(
        &work, "main.c",
        "#include <sg.h>\n"
        "#include <string.h>\n"
        "int main(void)\n"
        "{\n"
        "    const sg_method *m = sg_method_find(\"test_method\");\n"
        "    double z = 0.25, lambda = 1, L = 0;\n"
        "    if (!m || strcmp(m->title, \"A \\\"test\\\"\") != 0 || m->lambda_max != 10)\n"
        "        return 1;\n"
        "    m->L_batch_f64(1, &lambda, &z, &L);\n"
        "    return !(m->L_f64(1, 0.25) == 1.0 && m->L_f32(1, 0.25f) == 1.0f && L == 1.0);\n"
        "}\n");
    assert_int_equal(shell("cd '%s' && mkdir -p lib && cp -r '%s/lib/sg' lib && cc -std=c11 -O1 "
                           "-Ilib/sg -o main main.c lib/sg/method.c lib/sg/methods_*.c "
                           "lib/sg/integral*.c -lm && ./main",
                           work.folder, root),
                     0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_texts_equal_what_is_committed),
        cmocka_unit_test(test_tables_equal_what_is_committed),
        cmocka_unit_test(test_a_method_more),
    };
    return cmocka_run_group_tests(tests, open_work, close_work);
}
