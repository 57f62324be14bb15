#include "gpu_fixture.h"

#include <math.h>
#include <string.h>

static const char scale_source[] =
    "#version 450\n"
    "layout(local_size_x = 64) in;\n"
    "layout(std430, binding = 0) readonly buffer A { float a[]; };\n"
    "layout(std430, binding = 1) buffer B { float b[]; };\n"
    "layout(push_constant) uniform P { float scale; uint count; };\n"
    "void main() { uint i = gl_GlobalInvocationID.x; if (i < count) b[i] += scale * a[i]; }\n";

static void names_what_is_missing(void **state)
{
    (void)state;
    gpu_device *device = (gpu_device *)1;
    gpu_status status = gpu_device_open(&(gpu_device_options){.device = "no such thing"}, &device);
    assert_int_equal(status, GPU_NO_DEVICE);
    assert_null(device);
    assert_non_null(strstr(gpu_last_error(), "no such thing"));
    assert_null(strchr(gpu_last_error(), '\n'));
    gpu_device_close(NULL);
}

static void opens_by_name_in_any_case(void **state)
{
    (void)state;
    gpu_device *device;
    if (gpu_device_open(&(gpu_device_options){.device = "LLVMpipe"}, &device) == GPU_NO_DEVICE)
        skip_or_fail();
    const gpu_device_info *info = gpu_device_about(device);
    assert_non_null(strstr(info->name, "llvmpipe"));
    assert_true(strlen(info->driver) > 0 && strlen(info->version) > 0 && strlen(info->api) > 0);
    assert_true(info->software && !info->compile_only);
    char list[4096];
    assert_int_equal(gpu_device_list(list, sizeof list), GPU_OK);
    assert_non_null(strstr(list, info->name));
    gpu_device_close(device);
}

static void dispatches_with_push_constants_and_repeats(void **state)
{
    (void)state;
    enum { COUNT = 1000 };
    gpu_device *device = open_software_device();
    gpu_buffer *a, *b;
    assert_int_equal(gpu_buffer_create(device, COUNT * sizeof(float), &a), GPU_OK);
    assert_int_equal(gpu_buffer_create(device, COUNT * sizeof(float), &b), GPU_OK);
    assert_int_equal(gpu_buffer_size(b), COUNT * sizeof(float));
    float *in = gpu_buffer_map(a), *out = gpu_buffer_map(b);
    for (int i = 0; i < COUNT; i++) {
        in[i] = (float)i;
        out[i] = 1;
    }
    gpu_compute *compute;
    assert_int_equal(gpu_compute_create(device,
                                        &(gpu_compute_options){.name = "scale",
                                                               .source = scale_source,
                                                               .binding_count = 2,
                                                               .push_size = 8},
                                        &compute),
                     GPU_OK);
    struct {
        float scale;
        uint32_t count;
    } push = {2, COUNT - 1};
    double seconds = -1;
    gpu_dispatch dispatch = {.compute = compute,
                             .resources = {a, b},
                             .groups = {(COUNT + 63) / 64},
                             .push = &push,
                             .repeat = 3,
                             .seconds = &seconds};
    assert_int_equal(gpu_dispatch_run(device, &dispatch), GPU_OK);
    for (int i = 0; i < COUNT - 1; i++)
        assert_true(out[i] == 1 + 6 * (float)i);
    assert_true(out[COUNT - 1] == 1);
    assert_true(seconds > 0 && seconds < 60);
    gpu_compute_destroy(compute);
    gpu_buffer_destroy(a);
    gpu_buffer_destroy(b);
    close_clean(device);
}

/* Values of f at the given coordinates, through a texture at binding 2. */
static void look_up(gpu_device *device, const char *sampler, const gpu_texture_options *options,
                    int count, const float *coordinates, float *values)
{
    char source[1000];
    snprintf(source, sizeof source,
             "#version 450\n"
             "layout(local_size_x = 1) in;\n"
             "layout(std430, binding = 0) readonly buffer A { vec2 a[]; };\n"
             "layout(std430, binding = 1) writeonly buffer B { float b[]; };\n"
             "layout(binding = 2) uniform %s table;\n"
             "void main() { uint i = gl_GlobalInvocationID.x; b[i] = textureLod(table, a[i]%s, "
             "0.0).x; }\n",
             sampler, options->height ? "" : ".x");
    gpu_buffer *a, *b;
    gpu_texture *texture;
    gpu_compute *compute;
    assert_int_equal(gpu_buffer_create(device, (size_t)count * 2 * sizeof(float), &a), GPU_OK);
    assert_int_equal(gpu_buffer_create(device, (size_t)count * sizeof(float), &b), GPU_OK);
    assert_int_equal(gpu_texture_create(device, options, &texture), GPU_OK);
    gpu_compute_options create = {
        .name = "look-up",
        .source = source,
        .binding_count = 3,
        .bindings = {GPU_STORAGE_BUFFER, GPU_STORAGE_BUFFER, GPU_SAMPLED}};
    assert_int_equal(gpu_compute_create(device, &create, &compute), GPU_OK);
    memcpy(gpu_buffer_map(a), coordinates, (size_t)count * 2 * sizeof(float));
    gpu_dispatch dispatch = {
        .compute = compute, .resources = {a, b, texture}, .groups = {(uint32_t)count}};
    assert_int_equal(gpu_dispatch_run(device, &dispatch), GPU_OK);
    memcpy(values, gpu_buffer_map(b), (size_t)count * sizeof(float));
    gpu_compute_destroy(compute);
    gpu_texture_destroy(texture);
    gpu_buffer_destroy(a);
    gpu_buffer_destroy(b);
}

static void looks_up_between_texels_and_beyond_edges(void **state)
{
    (void)state;
    gpu_device *device = open_software_device();
    const float texels[6] = {0, 1, 2, 4, 5, 6};
    const float at[] = {0.5F / 3, 0.25F, 1.0F / 3, 0.25F, 0.5F, 0.5F, -1, -1, 2, 2};
    const float expected[] = {0, 0.5F, 3, 0, 6};
    float values[5];
    look_up(device, "sampler2D", &(gpu_texture_options){3, 2, 1, false, texels}, 5, at, values);
    for (int i = 0; i < 5; i++)
        assert_true(fabsf(values[i] - expected[i]) < 0.02F); /* 8 bits of filter weight */
    close_clean(device);
}

static void looks_up_one_dimension_in_half(void **state)
{
    (void)state;
    gpu_device *device = open_software_device();
    /* 1 + 2^-11 is a tie and rounds to even, 1 + 3 2^-11 up, 2^-25 to zero, 3 2^-26 to 2^-24 */
    const float texels[] = {1.00048828125F, 1.00146484375F, 0x1p-25F, 0x3p-26F,
                            -65504,         0x1p-14F,       0x3p-24F, 1e-30F};
    const float expected[] = {1, 1.001953125F, 0, 0x1p-24F, -65504, 0x1p-14F, 0x3p-24F, 0};
    float at[16] = {0}, values[8];
    for (int i = 0; i < 8; i++)
        at[2 * i] = ((float)i + 0.5F) / 8;
    look_up(device, "sampler1D", &(gpu_texture_options){8, 0, 1, true, texels}, 8, at, values);
    for (int i = 0; i < 8; i++)
        assert_true(values[i] == expected[i]);
    close_clean(device);
}

static void looks_up_several_channels(void **state)
{
    (void)state;
    gpu_device *device = open_software_device();
    const float texels[] = {1, 10, 2, 20, 3, 30};
    const float at[] = {0.5F / 3, 0, 0.5F, 0, 2.5F / 3, 0};
    float values[3];
    look_up(device, "sampler1D", &(gpu_texture_options){3, 0, 2, false, texels}, 3, at, values);
    for (int i = 0; i < 3; i++)
        assert_true(values[i] == (float)(i + 1));
    gpu_texture *texture;
    assert_int_equal(
        gpu_texture_create(device, &(gpu_texture_options){2, 0, 3, false, texels}, &texture),
        GPU_UNSUPPORTED);
    close_clean(device);
}

static void bad_shader_names_its_line(void **state)
{
    (void)state;
    uint32_t *words;
    size_t count;
    assert_int_equal(gpu_compile("bad.comp", "#version 450\nvoid main()\n{\n    wrong = 1;\n}\n",
                                 &words, &count),
                     GPU_BAD_SHADER);
    assert_null(words);
    assert_non_null(strstr(gpu_last_error(), "bad.comp:4:"));
    assert_non_null(strstr(gpu_last_error(), "wrong"));
    assert_null(strchr(gpu_last_error(), '\n'));
}

static void too_much_memory_is_said(void **state)
{
    (void)state;
    gpu_device *device;
    if (gpu_device_open(&(gpu_device_options){.device = "llvmpipe"}, &device) == GPU_NO_DEVICE)
        skip_or_fail();
    gpu_buffer *buffer = (gpu_buffer *)1;
    assert_int_equal(gpu_buffer_create(device, (size_t)1 << 60, &buffer), GPU_OUT_OF_MEMORY);
    assert_null(buffer);
    assert_non_null(strstr(gpu_last_error(), "memory"));
    gpu_device_close(device);
}

/* That the collecting of messages works at all. */
static void validation_catches_a_planted_mistake(void **state)
{
    (void)state;
    gpu_device *device = open_software_device();
    gpu_compute *compute;
    gpu_status status =
        gpu_compute_create(device,
                           &(gpu_compute_options){.name = "scale",
                                                  .source = scale_source,
                                                  .binding_count = 1, /* it uses two */
                                                  .push_size = 8},
                           &compute);
    assert_true(gpu_message_count(device) > 0);
    assert_true(strlen(gpu_messages(device)) > 0);
    if (status == GPU_OK)
        gpu_compute_destroy(compute);
    gpu_device_close(device);
}

static gpu_cost count(gpu_counter *counter, const char *body)
{
    char source[400];
    snprintf(source, sizeof source, "float f(float lambda, float cos_theta) { return %s; }", body);
    gpu_cost cost;
    if (gpu_count(counter, body, source, &cost) != GPU_OK)
        fail_msg("%s", gpu_last_error());
    return cost;
}

static void counts_what_a_function_costs(void **state)
{
    (void)state;
    const char *const families[] = {"navi21", "gfx1100", "vega10"};
    for (int i = 0; i < 3; i++) {
        gpu_counter *counter;
        if (gpu_counter_open(families[i], &counter) == GPU_NO_DEVICE)
            skip_or_fail();
        assert_true(gpu_counter_about(counter)->compile_only);
        gpu_cost sum = count(counter, "lambda + cos_theta");
        assert_true(sum.one.instructions == 1);
        assert_true(sum.one.inverse_throughput == 0);
        assert_true(sum.slope.inverse_throughput > 0);
        gpu_cost product = count(counter, "lambda * cos_theta * cos_theta * cos_theta");
        assert_true(product.one.instructions == 3);
        gpu_cost root = count(counter, "exp2(lambda) * exp2(cos_theta)");
        assert_true(root.slope.inverse_throughput > product.slope.inverse_throughput);
        gpu_cost split = count(counter, "exp2(exp2(exp2(lambda))) * cos_theta");
        assert_true(split.pixel.instructions < split.one.instructions);
        assert_true(split.pixel_slope.inverse_throughput < split.slope.inverse_throughput);
        gpu_cost again = count(counter, "exp2(exp2(exp2(lambda))) * cos_theta");
        assert_memory_equal(&split, &again, sizeof split);
        gpu_cost bad;
        assert_int_equal(gpu_count(counter, "bad", "float f(float a, float b)\n{ oh }", &bad),
                         GPU_BAD_SHADER);
        assert_non_null(strstr(gpu_last_error(), "bad:2:"));
        gpu_counter_close(counter);
    }
}

static void compile_only_device_refuses_memory(void **state)
{
    (void)state;
    gpu_device *device;
    if (gpu_device_open(&(gpu_device_options){.compile_for = "navi21"}, &device) == GPU_NO_DEVICE)
        skip_or_fail();
    gpu_buffer *buffer;
    assert_int_equal(gpu_buffer_create(device, 16, &buffer), GPU_UNSUPPORTED);
    gpu_device_close(device);
}

static void unknown_family_is_said(void **state)
{
    (void)state;
    gpu_counter *counter = (gpu_counter *)1;
    assert_int_equal(gpu_counter_open("no_such_family", &counter), GPU_NO_DEVICE);
    assert_null(counter);
    assert_non_null(strstr(gpu_last_error(), "no_such_family"));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(names_what_is_missing),
        cmocka_unit_test(opens_by_name_in_any_case),
        cmocka_unit_test(dispatches_with_push_constants_and_repeats),
        cmocka_unit_test(looks_up_between_texels_and_beyond_edges),
        cmocka_unit_test(looks_up_one_dimension_in_half),
        cmocka_unit_test(looks_up_several_channels),
        cmocka_unit_test(bad_shader_names_its_line),
        cmocka_unit_test(too_much_memory_is_said),
        cmocka_unit_test(validation_catches_a_planted_mistake),
        cmocka_unit_test(counts_what_a_function_costs),
        cmocka_unit_test(compile_only_device_refuses_memory),
        cmocka_unit_test(unknown_family_is_said),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
