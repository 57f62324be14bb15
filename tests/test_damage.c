/* The texts that people write by hand, damaged at random: forms, constants, costs, recipes. Each is
 * taken, or refused in one line; a form text that is taken can be written out. */
#include <setjmp.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>

#include <cmocka.h>

#include "base/file.h"
#include "capture.h"
#include "fit/recipe.h"
#include "mutate.h"
#include "tables/emit.h"
#include "work.h"

static char *in_tree(const char *name)
{
    return base_join(getenv("SGFIT_ROOT"), name);
}

static char *in_folder(const char *name)
{
    return workspace_file(&work, name, NULL);
}

static void copy_folder(const char *from, const char *to, const char *suffix)
{
    char **names;
    size_t count;
    assert_true(base_make_directory(to));
    assert_true(base_list(from, suffix, &names, &count));
    assert_true(count > 0);
    for (size_t i = 0; i < count; i++) {
        char *source = base_join(from, names[i]), *target = base_join(to, names[i]);
        size_t size;
        char *text = base_read_file(source, &size);
        assert_true(text && base_write_file(target, text, size));
        free(text);
        free(target);
        free(source);
    }
    base_list_free(names, count);
}

/* Not base_write_file, which waits for the disk. */
static void write_quickly(const char *path, const char *bytes, size_t size)
{
    FILE *file = fopen(path, "w");
    assert_non_null(file);
    assert_int_equal(fwrite(bytes, 1, size, file), size);
    fclose(file);
}

typedef bool (*reader)(const char *path);

/* Damages each file of a folder `rounds` times, one at a time; counts lines and refusals. */
static void damage(const char *directory, const char *suffix, int rounds, reader read)
{
    char **names;
    size_t count;
    int refused = 0, taken = 0, lines = 0;
    assert_true(base_list(directory, suffix, &names, &count));
    random_state = 0x94d049bb133111ebu;
    capture c;
    capture_begin(&c);
    for (size_t i = 0; i < count; i++) {
        char *path = base_join(directory, names[i]);
        size_t size;
        char *text = base_read_file(path, &size);
        for (int k = 0; k < rounds; k++) {
            static char bytes[MOST];
            write_quickly(path, bytes, mutate(text, bytes));
            if (read(path))
                taken++;
            else
                refused++;
        }
        write_quickly(path, text, size);
        free(text);
        free(path);
    }
    base_list_free(names, count);
    fflush(stderr);
    rewind(c.file);
    for (int ch; (ch = getc(c.file)) != EOF;)
        lines += ch == '\n';
    capture_end(&c);
    assert_int_equal(lines, refused);
    assert_true(refused > taken / 100); /* the damage is noticed */
}

static char *forms_folder, *constants_folder;

static bool read_forms(const char *path)
{
    (void)path;
    form_list forms;
    buffer out = {0};
    bool good = forms_read(&forms, forms_folder);
    if (good)
        emit_forms_inc(&out, &forms);
    buffer_free(&out);
    forms_free(&forms);
    return good;
}

static void damaged_forms(void **state)
{
    (void)state;
    char *helpers = base_join(forms_folder, "helpers");
    damage(forms_folder, ".glsl", 20, read_forms);
    damage(helpers, ".glsl", 20, read_forms);
    free(helpers);
}

static form_list intact;

static bool read_constants(const char *path)
{
    (void)path;
    method_list methods;
    buffer out = {0};
    bool good = methods_read(&methods, constants_folder, &intact);
    if (good) {
        emit_methods_inc(&out, &methods);
        emit_registry_inc(&out, &intact, &methods);
    }
    buffer_free(&out);
    methods_free(&methods);
    return good;
}

static void damaged_constants(void **state)
{
    (void)state;
    assert_true(forms_read(&intact, forms_folder));
    damage(constants_folder, ".json", 40, read_constants);
    forms_free(&intact);
}

static bool read_recipe(const char *path)
{
    recipe r;
    if (!recipe_read(&r, path))
        return false;
    recipe_free(&r);
    return true;
}

static void damaged_recipes(void **state)
{
    (void)state;
    char *recipes = in_folder("recipes");
    damage(recipes, ".json", 40, read_recipe);
    free(recipes);
}

static int copy_tree(void **state)
{
    (void)state;
    workspace_open(&work);
    static const char *const copies[][3] = {{"shaders/forms", "forms", ".glsl"},
                                            {"shaders/forms/helpers", "forms/helpers", ".glsl"},
                                            {"tables/constants", "constants", ".json"},
                                            {"fit/recipes", "recipes", ".json"}};
    for (size_t i = 0; i < sizeof copies / sizeof *copies; i++) {
        char *from = in_tree(copies[i][0]), *to = in_folder(copies[i][1]);
        copy_folder(from, to, copies[i][2]);
        free(from);
        free(to);
    }
    forms_folder = in_folder("forms");
    constants_folder = in_folder("constants");
    return 0;
}

static int remove_folder(void **state)
{
    (void)state;
    free(forms_folder);
    free(constants_folder);
    workspace_close(&work);
    return 0;
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(damaged_forms),
        cmocka_unit_test(damaged_constants),
        cmocka_unit_test(damaged_recipes),
    };
    return cmocka_run_group_tests(tests, copy_tree, remove_folder);
}
