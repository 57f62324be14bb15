/* The shader includes as text: they compile for each of the three targets, alone, included twice,
 * all together and one method at a time, and hold nothing that a host shader could trip over. */
#include <ctype.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "program.h"
#include "sg.h"
#include "work.h"

typedef struct target {
    const char *name, *head, *output, *option;
} target;

static const target targets[] = {
    {"450 for Vulkan", "#version 450\n", "layout(location = 0) out vec4 colour;\n",
     "-V -o /dev/null"},
    {"330 core", "#version 330 core\n", "out vec4 colour;\n", ""},
    {"300 es", "#version 300 es\nprecision highp float;\nprecision highp int;\n",
     "out vec4 colour;\n", ""},
};
enum { TARGETS = sizeof targets / sizeof *targets };

static char *committed(const char *name)
{
    char path[1024];
    snprintf(path, sizeof path, "%s/shaders/%s", getenv("SGFIT_ROOT"), name);
    char *text = workspace_read_path(path, NULL);
    assert_non_null(text);
    return text;
}

/* Compiles the texts one after the other with `body` in main. */
static void compile(const target *to, const char *const *texts, const char *globals,
                    const char *body)
{
    FILE *file = fopen(workspace_path(&work, "test.frag"), "wb");
    assert_non_null(file);
    fputs(to->head, file);
    for (; *texts; texts++)
        fputs(*texts, file);
    fprintf(file, "%s%svoid main()\n{\n%s}\n", globals, to->output, body);
    fclose(file);
    int status = shell("glslangValidator %s '%s/test.frag' >'%s/log' 2>&1", to->option, work.folder,
                       work.folder);
    if (status != 0) {
        print_message("%s:\n", to->name);
        shell("cat '%s/log' >&2", work.folder);
    }
    assert_int_equal(status, 0);
}

static const char no_globals[] = "";
static const char irradiance_call[] =
    "    colour = vec4(sg_irradiance(vec3(1.0), vec3(0.0, 0.0, 1.0), 2.0, vec3(1.0, 0.0, 0.0)), "
    "1.0);\n";

static void test_compiles_alone_and_twice(void **state)
{
    (void)state;
    char *sg = committed("sg.glsl");
    for (int t = 0; t < TARGETS; t++) {
        compile(&targets[t], (const char *const[]){sg, NULL}, no_globals, irradiance_call);
        compile(&targets[t], (const char *const[]){sg, sg, NULL}, no_globals, irradiance_call);
    }
    free(sg);
}

/* Every function is called, so that nothing is left out as unused. */
static void test_every_method_together(void **state)
{
    (void)state;
    char *sg = committed("sg.glsl"), *body = malloc(sg_method_count() * 256 + 1), *end = body;
    end += sprintf(end, "    float sum = 0.0;\n");
    for (size_t i = 0; i < sg_method_count(); i++) {
        const char *id = sg_method_at(i)->id;
        end += sprintf(end, "    sum += sg_L_%s(2.0, 0.5) + sg_A_h_%s(2.0, 0.5);\n", id, id);
    }
    sprintf(end, "    colour = vec4(sum);\n");
    for (int t = 0; t < TARGETS; t++)
        compile(&targets[t], (const char *const[]){sg, NULL}, no_globals, body);
    free(body);
    free(sg);
}

static void test_the_table_with_and_without(void **state)
{
    (void)state;
    static const char body[] =
        "    colour = vec4(sg_L_table(table, 2.0, 0.5) + sg_A_h_table(table, "
        "2.0, 0.5));\n";
    char *sg = committed("sg.glsl"), *table = committed("sg_table.glsl");
    for (int t = 0; t < TARGETS; t++) {
        const char *global = t == 0 ? "layout(binding = 0) uniform sampler2D table;\n"
                                    : "uniform highp sampler2D table;\n";
        compile(&targets[t], (const char *const[]){table, NULL}, global, body);
        compile(&targets[t], (const char *const[]){table, sg, table, sg, NULL}, global, body);
    }
    free(table);
    free(sg);
}

static void test_one_method_files(void **state)
{
    (void)state;
    for (size_t i = 0; i < sg_method_count(); i++) {
        const char *id = sg_method_at(i)->id;
        char path[1024], body[512];
        snprintf(path, sizeof path, "%s/one.glsl", work.folder);
        run emitted = RUN(NULL, "emit", "--method", id, "--out", path);
        assert_int_equal(emitted.status, 0);
        assert_string_equal(emitted.error, "");
        run_free(&emitted);
        char *one = workspace_read_path(path, NULL);
        assert_non_null(one);
        snprintf(body, sizeof body,
                 "%s    colour += vec4(sg_L_%s(2.0, 0.5) + sg_A_h_%s(2.0, 0.5));\n",
                 irradiance_call, id, id);
        for (int t = 0; t < TARGETS; t++)
            compile(&targets[t], (const char *const[]){one, one, NULL}, no_globals, body);
        /* sg_irradiance uses this method, and no other is there. */
        char call[256];
        snprintf(call, sizeof call, "amplitude * sg_A_h_%s(", id);
        assert_non_null(strstr(one, call));
        for (size_t j = 0; j < sg_method_count(); j++) {
            snprintf(call, sizeof call, "float sg_L_%s(", sg_method_at(j)->id);
            assert_true((strstr(one, call) != NULL) == (j == i));
        }
        free(one);
    }
}

/* Outside of comments: directives are the guard alone; what is declared at the top is a function or
 * struct named sg_; nothing of the forms' own language is left. */
static void check_text(char *text, const char *guard)
{
    char ifndef[128], define[128];
    snprintf(ifndef, sizeof ifndef, "#ifndef %s", guard);
    snprintf(define, sizeof define, "#define %s", guard);
    int depth = 0, directives = 0, declared = 0;
    for (char *line = strtok(text, "\n"); line; line = strtok(NULL, "\n")) {
        char *comment = strstr(line, "//");
        if (comment)
            *comment = '\0';
        if (line[strspn(line, " ")] == '#') {
            directives++;
            assert_true(strcmp(line, ifndef) == 0 || strcmp(line, define) == 0 ||
                        strcmp(line, "#endif") == 0);
            continue;
        }
        assert_null(strstr(line, "K("));
        assert_null(strstr(line, "real "));
        assert_null(strchr(line, '@'));
        if (depth == 0 && isalpha((unsigned char)line[0])) {
            declared++;
            const char *name = line + strcspn(line, " ") + 1;
            assert_true(strncmp(name, "sg_", 3) == 0);
            assert_null(strchr(line, '=')); /* no global */
        }
        for (const char *c = line; *c; c++)
            depth += (*c == '{') - (*c == '}');
    }
    assert_int_equal(directives, 3);
    assert_int_equal(depth, 0);
    assert_true(declared > 3);
}

static void test_nothing_to_trip_over(void **state)
{
    (void)state;
    char *sg = committed("sg.glsl"), *table = committed("sg_table.glsl");
    check_text(sg, "SG_GLSL");
    check_text(table, "SG_TABLE_GLSL");
    free(table);
    free(sg);
}

/* Above each method: the two measured errors and the source, as the registry and JSON have them. */
static void test_every_method_states_its_error_and_source(void **state)
{
    (void)state;
    char *sg = committed("sg.glsl");
    for (size_t i = 0; i < sg_method_count(); i++) {
        const sg_method *method = sg_method_at(i);
        char head[256], function[256];
        snprintf(head, sizeof head, "\n// %s: ", method->id);
        snprintf(function, sizeof function, "\nfloat sg_%s_%s(",
                 method->form->native == SG_L ? "L" : "A_h", method->id);
        char *from = strstr(sg, head), *to = strstr(sg, function);
        assert_true(from && to && from < to);
        *to = '\0';
        static const char *const parts[] = {"returns",     "Domain: lambda in", "Error of L:",
                                            "//   float ", "//   double ",      "Source: "};
        for (size_t p = 0; p < sizeof parts / sizeof *parts; p++) {
            if (!strstr(from, parts[p]))
                print_message("%s: no \"%s\"\n", method->id, parts[p]);
            assert_non_null(strstr(from, parts[p]));
        }
        *to = '\n';
    }
    free(sg);
}

static int open_workspace(void **state)
{
    (void)state;
    workspace_open(&work);
    return shell("glslangValidator --version >/dev/null");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_compiles_alone_and_twice),
        cmocka_unit_test(test_every_method_together),
        cmocka_unit_test(test_the_table_with_and_without),
        cmocka_unit_test(test_one_method_files),
        cmocka_unit_test(test_nothing_to_trip_over),
        cmocka_unit_test(test_every_method_states_its_error_and_source),
    };
    return cmocka_run_group_tests(tests, open_workspace, close_work);
}
