#include "pass_fixture.h"

#include "internal.h"

static void images_keep_what_is_written(void **state)
{
    (void)state;
    static const struct {
        gpu_format format;
        size_t texel;
    } formats[] = {{GPU_RGBA8, 4},   {GPU_R32F, 4},     {GPU_RG32F, 8},
                   {GPU_RGBA16F, 8}, {GPU_RGBA32F, 16}, {GPU_R32U, 4},
                   {GPU_RG32U, 8},   {GPU_RGBA32U, 16}, {GPU_DEPTH32, 4}};
    static const uint32_t sizes[][2] = {{1, 1}, {33, 17}, {4096, 16}};
    gpu_device *device = open_software_device();
    for (size_t f = 0; f < sizeof formats / sizeof *formats; f++)
        for (size_t s = 0; s < 3; s++) {
            gpu_image *image = make_image(device, formats[f].format, sizes[s][0], sizes[s][1]);
            assert_int_equal(gpu_image_width(image), sizes[s][0]);
            assert_int_equal(gpu_image_height(image), sizes[s][1]);
            assert_int_equal(gpu_image_texel(image), formats[f].texel);
            size_t count = (size_t)sizes[s][0] * sizes[s][1] * formats[f].texel / 4;
            uint32_t *in = malloc(count * 4), *out = calloc(count, 4);
            assert_non_null(in);
            assert_non_null(out);
            /* finite floats and halves within [0, 1) as well as any bits for the others */
            for (size_t i = 0; i < count; i++)
                in[i] = 0x38003800U | ((uint32_t)(i * 2654435761U) & 0x03ff03ffU);
            must(gpu_image_write(image, in));
            must(gpu_image_read(image, out));
            assert_memory_equal(in, out, count * 4);
            free(in);
            free(out);
            gpu_image_destroy(image);
        }
    close_clean(device);
}

static void clears_and_fills(void **state)
{
    (void)state;
    gpu_device *device = open_software_device();
    gpu_image *colour = make_image(device, GPU_RGBA8, 5, 3);
    gpu_image *bits = make_image(device, GPU_RG32U, 5, 3);
    gpu_image *depth = make_image(device, GPU_DEPTH32, 5, 3);
    gpu_buffer *buffer = make_buffer(device, 28);
    const gpu_step steps[] = {{.clear = colour, .clear_value = {0, 1, 0.2F, 0.4F}},
                              {.clear = bits, .clear_bits = {0xdeadbeef, 7}},
                              {.clear = depth, .clear_value = {0.25F}},
                              {.fill = buffer, .clear_bits = {0x12345678}}};
    double seconds[4] = {-1, -1, -1, -1};
    must(gpu_run(device, steps, 4, seconds));
    uint8_t c[15][4];
    uint32_t b[15][2];
    float d[15];
    must(gpu_image_read(colour, c));
    must(gpu_image_read(bits, b));
    must(gpu_image_read(depth, d));
    for (int i = 0; i < 15; i++) {
        assert_memory_equal(c[i], ((uint8_t[]){0, 255, 51, 102}), 4);
        assert_true(b[i][0] == 0xdeadbeef && b[i][1] == 7);
        assert_true(d[i] == 0.25F);
    }
    const uint32_t *words = gpu_buffer_map(buffer);
    for (int i = 0; i < 7; i++)
        assert_int_equal(words[i], 0x12345678);
    for (int i = 0; i < 4; i++)
        assert_true(seconds[i] >= 0 && seconds[i] < 60);
    must(gpu_run(device, steps, 0, NULL));
    gpu_image_destroy(colour);
    gpu_image_destroy(bits);
    gpu_image_destroy(depth);
    gpu_buffer_destroy(buffer);
    close_clean(device);
}

static const char shift_source[] =
    "#version 450\n"
    "layout(local_size_x = 8, local_size_y = 8) in;\n"
    "layout(binding = 0) uniform sampler2D before;\n"
    "layout(binding = 1, rgba32f) uniform writeonly image2D after;\n"
    "layout(push_constant) uniform P { ivec2 by; };\n"
    "void main() { ivec2 at = ivec2(gl_GlobalInvocationID.xy), size = imageSize(after);\n"
    "    if (at.x < size.x && at.y < size.y)\n"
    "        imageStore(after, at, texelFetch(before, (at + by) % size, 0)); }\n";

enum { WIDE = 33, HIGH = 17 };

/* The same pipeline twice, there and back, so that an order that is not kept shows. */
static void steps_follow_each_other(void **state)
{
    (void)state;
    gpu_device *device = open_software_device();
    gpu_image *a = make_image(device, GPU_RGBA32F, WIDE, HIGH);
    gpu_image *b = make_image(device, GPU_RGBA32F, WIDE, HIGH);
    gpu_compute *shift =
        make_compute(device, &(gpu_compute_options){.name = "shift",
                                                    .source = shift_source,
                                                    .binding_count = 2,
                                                    .bindings = {GPU_FETCHED, GPU_STORAGE_IMAGE},
                                                    .push_size = 8});
    static float in[WIDE * HIGH][4], out[WIDE * HIGH][4];
    for (int i = 0; i < WIDE * HIGH; i++)
        for (int c = 0; c < 4; c++)
            in[i][c] = (float)(4 * i + c);
    must(gpu_image_write(a, in));
    const int32_t by[2] = {5, 3};
    gpu_step steps[20];
    for (int i = 0; i < 20; i++)
        steps[i] = (gpu_step){.name = "shift",
                              .compute = shift,
                              .resources = {i % 2 ? b : a, i % 2 ? a : b},
                              .groups = {(WIDE + 7) / 8, (HIGH + 7) / 8},
                              .push = by};
    double seconds[20];
    must(gpu_run(device, steps, 20, seconds));
    must(gpu_image_read(a, out));
    for (int y = 0; y < HIGH; y++)
        for (int x = 0; x < WIDE; x++)
            assert_memory_equal(out[y * WIDE + x],
                                in[(y + 20 * 3) % HIGH * WIDE + (x + 20 * 5) % WIDE], 16);
    for (int i = 0; i < 20; i++)
        assert_true(seconds[i] > 0 && seconds[i] < 60);
    gpu_compute_destroy(shift);
    gpu_image_destroy(a);
    gpu_image_destroy(b);
    close_clean(device);
}

/* One format of storage images after the other: adds 1 to what is there. */
static void storage_images_of_each_format(void **state)
{
    (void)state;
    static const struct {
        gpu_format format;
        const char *name;
        const char *type;
        uint32_t words[4], expected[4];
    } cases[] = {{GPU_RGBA8, "rgba8", "", {0x00000000}, {0xffffffff}},
                 {GPU_R32F, "r32f", "", {0x40000000}, {0x40400000}},
                 {GPU_RG32F, "rg32f", "", {0x40000000, 0}, {0x40400000, 0x3f800000}},
                 {GPU_RGBA16F, "rgba16f", "", {0x00003c00, 0}, {0x3c004000, 0x3c003c00}},
                 {GPU_RGBA32F,
                  "rgba32f",
                  "",
                  {0, 0, 0, 0x40000000},
                  {0x3f800000, 0x3f800000, 0x3f800000, 0x40400000}},
                 {GPU_R32U, "r32ui", "u", {41}, {42}},
                 {GPU_RG32U, "rg32ui", "u", {41, 0xffffffff}, {42, 0}},
                 {GPU_RGBA32U, "rgba32ui", "u", {1, 2, 3, 4}, {2, 3, 4, 5}}};
    gpu_device *device = open_software_device();
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        char source[400];
        snprintf(source, sizeof source,
                 "#version 450\nlayout(local_size_x = 1) in;\n"
                 "layout(binding = 0, %s) uniform %simage2D i;\n"
                 "void main() { imageStore(i, ivec2(0), imageLoad(i, ivec2(0)) + %svec4(1)); }\n",
                 cases[i].name, cases[i].type, cases[i].type);
        gpu_compute *add =
            make_compute(device, &(gpu_compute_options){.name = cases[i].name,
                                                        .source = source,
                                                        .binding_count = 1,
                                                        .bindings = {GPU_STORAGE_IMAGE}});
        gpu_image *image = make_image(device, cases[i].format, 1, 1);
        must(gpu_image_write(image, cases[i].words));
        must(gpu_dispatch_run(device, &(gpu_dispatch){.compute = add, .resources = {image}}));
        uint32_t out[4];
        must(gpu_image_read(image, out));
        assert_memory_equal(out, cases[i].expected, gpu_image_texel(image));
        gpu_image_destroy(image);
        gpu_compute_destroy(add);
    }
    close_clean(device);
}

/* The group counts are written by an earlier step of the same list. */
static void indirect_dispatch_from_words(void **state)
{
    (void)state;
    gpu_device *device = open_software_device();
    uint32_t *words;
    size_t word_count;
    must(gpu_compile("count", count_source, &words, &word_count));
    gpu_compute *count = make_compute(
        device, &(gpu_compute_options){
                    .name = "count", .words = words, .word_count = word_count, .binding_count = 1});
    free(words);
    gpu_buffer *n = make_buffer(device, 12), *groups = make_buffer(device, 24);
    gpu_step steps[] = {{.fill = n},
                        {.fill = groups, .clear_bits = {3}},
                        {.name = "count",
                         .compute = count,
                         .resources = {n},
                         .indirect = groups,
                         .indirect_offset = 12}};
    must(gpu_run(device, steps, 3, NULL));
    for (int i = 0; i < 3; i++)
        assert_int_equal(((uint32_t *)gpu_buffer_map(n))[i], 3 * 3 * 4);
    steps[2].indirect_offset = 16;
    refused(gpu_run(device, steps, 3, NULL), GPU_FAILED, "count: no 3 indirect words");
    gpu_compute_destroy(count);
    gpu_buffer_destroy(n);
    gpu_buffer_destroy(groups);
    close_clean(device);
}

/* The same words with the same bindings are one pipeline, as long as the device lives; with others
 * it is another. */
static void pipelines_of_words_are_kept(void **state)
{
    (void)state;
    static const char source[] = "#version 450\n"
                                 "layout(local_size_x = 1) in;\n"
                                 "layout(set = 0, binding = 0) buffer B { uint n; };\n"
                                 "void main() { n += 1u; }\n";
    gpu_device *device = open_software_device();
    uint32_t *words;
    size_t word_count;
    must(gpu_compile("kept", source, &words, &word_count));
    gpu_compute_options options = {.name = "kept",
                                   .words = words,
                                   .word_count = word_count,
                                   .binding_count = 1,
                                   .bindings = {GPU_STORAGE_BUFFER}};
    gpu_compute *first, *second, *other, *from_source;
    must(gpu_compute_create(device, &options, &first));
    gpu_compute_destroy(first);
    must(gpu_compute_create(device, &options, &second));
    assert_ptr_equal(first, second);
    options.push_size = 4;
    must(gpu_compute_create(device, &options, &other));
    assert_ptr_not_equal(first, other);
    options = (gpu_compute_options){
        .name = "kept", .source = source, .binding_count = 1, .bindings = {GPU_STORAGE_BUFFER}};
    must(gpu_compute_create(device, &options, &from_source));
    assert_ptr_not_equal(first, from_source);
    gpu_compute_destroy(from_source);
    gpu_buffer *buffer = make_buffer(device, 4);
    *(uint32_t *)gpu_buffer_map(buffer) = 40;
    const gpu_step steps[] = {{.compute = first, .resources = {buffer}},
                              {.compute = second, .resources = {buffer}}};
    must(gpu_run(device, steps, 2, NULL));
    assert_int_equal(*(uint32_t *)gpu_buffer_map(buffer), 42);
    gpu_buffer_destroy(buffer);
    free(words);
    close_clean(device);
}

static void refuses_impossible_images(void **state)
{
    (void)state;
    gpu_device *device = open_software_device();
    gpu_image *image = (gpu_image *)1;
    refused(gpu_image_create(device, GPU_R32F, 0, 5, &image), GPU_UNSUPPORTED, "0 x 5");
    assert_null(image);
    refused(gpu_image_create(device, GPU_R32F, 5, 0, &image), GPU_UNSUPPORTED, "5 x 0");
    refused(gpu_image_create(device, GPU_R32F, 1000000, 1, &image), GPU_UNSUPPORTED, "1000000 x 1");
    refused(gpu_image_create(device, GPU_R32F, 1, 1000000, &image), GPU_UNSUPPORTED, "1 x 1000000");
    gpu_image_destroy(NULL);
    close_clean(device);
}

static void names_the_limit_that_is_missing(void **state)
{
    (void)state;
    gpu_device *device = open_software_device();
    must(gpu_check(device, &(gpu_needs){1024, 16384, 4096, (size_t)1 << 27, 4}));
    refused(gpu_check(device, &(gpu_needs){.group_invocations = 1 << 20}), GPU_UNSUPPORTED,
            "invocations in a work group");
    refused(gpu_check(device, &(gpu_needs){.shared_bytes = 1 << 30}), GPU_UNSUPPORTED, "shared");
    refused(gpu_check(device, &(gpu_needs){.image_side = 1 << 30}), GPU_UNSUPPORTED, "image");
    refused(gpu_check(device, &(gpu_needs){.buffer_bytes = (size_t)1 << 40}), GPU_UNSUPPORTED,
            "storage buffer");
    refused(gpu_check(device, &(gpu_needs){.subgroup_invocations = 1000}), GPU_UNSUPPORTED,
            "subgroup");
    close_clean(device);
}

/* No driver here loses its device on demand: what its results become is checked by themselves. */
static void failures_of_the_device_are_said(void **state)
{
    (void)state;
    refused(gpu_vk(VK_ERROR_DEVICE_LOST, "drawing"), GPU_DEVICE_LOST,
            "drawing: the device was lost");
    refused(gpu_vk(VK_ERROR_OUT_OF_DEVICE_MEMORY, "an image"), GPU_OUT_OF_MEMORY,
            "an image: out of device memory");
    refused(gpu_vk(VK_ERROR_OUT_OF_HOST_MEMORY, "an image"), GPU_OUT_OF_MEMORY,
            "an image: out of host memory");
    refused(gpu_vk(VK_ERROR_OUT_OF_POOL_MEMORY, "sets"), GPU_OUT_OF_MEMORY, "sets: out of");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(images_keep_what_is_written),
        cmocka_unit_test(clears_and_fills),
        cmocka_unit_test(steps_follow_each_other),
        cmocka_unit_test(storage_images_of_each_format),
        cmocka_unit_test(indirect_dispatch_from_words),
        cmocka_unit_test(pipelines_of_words_are_kept),
        cmocka_unit_test(refuses_impossible_images),
        cmocka_unit_test(names_the_limit_that_is_missing),
        cmocka_unit_test(failures_of_the_device_are_said),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
