/* The built-in shaders: each is there as SPIR-V, its text with everything spliced in compiles
 * again, and a pass that integrates lobes does so for every method of the registry. */
#include "gpu_fixture.h"

#include <string.h>

#include "render/render.h"
#include "render/shaders.h"
#include "sg.h"

static bool ends_in(const char *path, const char *ending)
{
    size_t length = strlen(path), wanted = strlen(ending);
    return length > wanted && strcmp(path + length - wanted, ending) == 0;
}

static void every_shader_is_built_in(void **state)
{
    (void)state;
    int shaders = 0;
    for (int i = 0; render_shader_path(i); i++) {
        gpu_shader shader = render_shader(render_shader_path(i));
        if (ends_in(render_shader_path(i), ".glsl")) {
            assert_null(shader.words);
            continue;
        }
        assert_non_null(shader.words);
        assert_true(shader.word_count > 5);
        assert_int_equal(shader.words[0], 0x07230203);
        shaders++;
    }
    assert_true(shaders > 0);
}

static void unknown_paths_have_no_words(void **state)
{
    (void)state;
    gpu_shader shader = render_shader("resolve/resolve");
    assert_null(shader.words);
    assert_null(shader.source);
    assert_int_equal(render_shader_method("resolve/resolve", NULL, &shader), GPU_BAD_SHADER);
    assert_non_null(strstr(gpu_last_error(), "resolve/resolve"));
    assert_null(shader.source);
}

static void check_method(const char *path, const char *method)
{
    gpu_shader shader;
    assert_int_equal(render_shader_method(path, method, &shader), GPU_OK);
    assert_null(strstr(shader.source, "#include \""));
    uint32_t *words;
    size_t count;
    if (gpu_compile(path, shader.source, &words, &count) != GPU_OK)
        fail_msg("%s with %s: %s", path, method, gpu_last_error());
    free(words);
    free((char *)shader.source);
}

static void spliced_texts_compile_for_every_method(void **state)
{
    (void)state;
    for (int i = 0; render_shader_path(i); i++) {
        const char *path = render_shader_path(i);
        if (!ends_in(path, ".comp"))
            continue;
        check_method(path, "standard");
        gpu_shader shader;
        assert_int_equal(render_shader_method(path, NULL, &shader), GPU_OK);
        bool integrates = strstr(shader.source, "SG_METHOD_A_h(") != NULL ||
                          strstr(shader.source, "SG_METHOD_L(") != NULL;
        free((char *)shader.source);
        for (size_t m = 0; integrates && m < sg_method_count(); m++)
            check_method(path, sg_method_at(m)->id);
    }
}

/* The name that no function has must be what the compiler complains about. */
static void the_method_reaches_the_text(void **state)
{
    (void)state;
    gpu_shader shader;
    assert_int_equal(render_shader_method("resolve/resolve.comp", "of_nobody", &shader), GPU_OK);
    const char *line = strstr(shader.source, "#define SG_METHOD_A_h sg_A_h_of_nobody\n"
                                             "#define SG_METHOD_L sg_L_of_nobody\n");
    assert_non_null(line);
    assert_ptr_equal(strchr(shader.source, '\n') + 1, line);
    free((char *)shader.source);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_shader_is_built_in),
        cmocka_unit_test(unknown_paths_have_no_words),
        cmocka_unit_test(spliced_texts_compile_for_every_method),
        cmocka_unit_test(the_method_reaches_the_text),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
