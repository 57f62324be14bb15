#include "pass_fixture.h"

static const char vertex_source[] =
    "#version 450\n"
    "layout(binding = 0) readonly buffer V { vec4 corner[]; };\n" /* x, y, depth, value */
    "layout(location = 0) flat out float value;\n"
    "void main() { vec4 c = corner[gl_VertexIndex]; value = c.w + float(gl_InstanceIndex);\n"
    "    gl_Position = vec4(c.xyz, 1); }\n";
static const char fragment_source[] =
    "#version 450\n"
    "layout(location = 0) flat in float value;\n"
    "layout(location = 0) out float first;\n"
    "layout(location = 1) out uvec4 second;\n"
    "void main() { first = value; second = uvec4(gl_FragCoord.xy, uint(value), 9); }\n";

enum { SIDE = 8 };

/* Two triangles, one pixel's worth of each expected place being far from an edge: the first covers
 * the upper left half at depth 0.5, the second the whole at 0.75. Three more vertices: the first
 * triangle again with another value, which equality must not let through. */
static const float corners[9][4] = {{-1, -1, 0.5F, 1},  {0.98F, -1, 0.5F, 1}, {-1, 0.98F, 0.5F, 1},
                                    {-1, -1, 0.75F, 2}, {3, -1, 0.75F, 2},    {-1, 3, 0.75F, 2},
                                    {-1, -1, 0.5F, 3},  {0.98F, -1, 0.5F, 3}, {-1, 0.98F, 0.5F, 3}};

typedef struct stage {
    gpu_device *device;
    gpu_draw *draw;
    gpu_buffer *vertices;
    gpu_image *first, *second, *depth;
} stage;

static gpu_draw_options draw_options(void)
{
    return (gpu_draw_options){.name = "triangles",
                              .vertex = {.source = vertex_source},
                              .fragment = {.source = fragment_source},
                              .binding_count = 1,
                              .target_count = 2,
                              .targets = {GPU_R32F, GPU_RGBA32U},
                              .depth = true};
}

static stage open_stage(void)
{
    stage s = {.device = open_software_device()};
    gpu_draw_options options = draw_options();
    must(gpu_draw_create(s.device, &options, &s.draw));
    s.vertices = make_buffer(s.device, sizeof corners);
    memcpy(gpu_buffer_map(s.vertices), corners, sizeof corners);
    s.first = make_image(s.device, GPU_R32F, SIDE, SIDE);
    s.second = make_image(s.device, GPU_RGBA32U, SIDE, SIDE);
    s.depth = make_image(s.device, GPU_DEPTH32, SIDE, SIDE);
    return s;
}

static void close_stage(stage *s)
{
    gpu_draw_destroy(s->draw);
    gpu_buffer_destroy(s->vertices);
    gpu_image_destroy(s->first);
    gpu_image_destroy(s->second);
    gpu_image_destroy(s->depth);
    close_clean(s->device);
}

static gpu_step draw_step(const stage *s, uint32_t vertex_count)
{
    return (gpu_step){.name = "triangles",
                      .draw = s->draw,
                      .resources = {s->vertices},
                      .vertex_count = vertex_count,
                      .targets = {s->first, s->second},
                      .depth = s->depth,
                      .clear_bits = {8, 8, 8, 8}};
}

/* upper: the value where the first triangle is, lower: elsewhere. Both float targets were cleared
 * to 0, integer ones to 8, depth to 1. */
static void expect(const stage *s, float upper, float lower)
{
    float first[SIDE][SIDE], depth[SIDE][SIDE];
    uint32_t second[SIDE][SIDE][4];
    must(gpu_image_read(s->first, first));
    must(gpu_image_read(s->second, second));
    must(gpu_image_read(s->depth, depth));
    for (uint32_t y = 0; y < SIDE; y++)
        for (uint32_t x = 0; x < SIDE; x++) {
            /* the diagonal passes just short of the pixels' centres */
            bool inside = x + y < SIDE - 1;
            float value = inside ? upper : lower;
            assert_true(first[y][x] == value);
            const uint32_t drawn[4] = {x, y, (uint32_t)value, 9}, cleared[4] = {8, 8, 8, 8};
            assert_memory_equal(second[y][x], value > 0 ? drawn : cleared, 16);
            assert_true(depth[y][x] == (inside && upper > 0 ? 0.5F : lower > 0 ? 0.75F : 1.0F));
        }
}

static void draws_with_depth_and_two_targets(void **state)
{
    (void)state;
    stage s = open_stage();
    gpu_step step = draw_step(&s, 3);
    must(gpu_run(s.device, &step, 1, NULL));
    expect(&s, 1, 0);
    step.vertex_count = 9;
    double seconds = -1;
    must(gpu_run(s.device, &step, 1, &seconds));
    expect(&s, 1, 2);
    assert_true(seconds > 0 && seconds < 60);
    /* kept: nothing new is nearer */
    step.keep = true;
    step.instance_count = 4;
    must(gpu_run(s.device, &step, 1, NULL));
    expect(&s, 1, 2);
    step.keep = false;
    step.vertex_count = 0;
    must(gpu_run(s.device, &step, 1, NULL));
    expect(&s, 0, 0);
    close_stage(&s);
}

static void draws_indexed_and_indirect(void **state)
{
    (void)state;
    stage s = open_stage();
    gpu_buffer *indices = make_buffer(s.device, 6 * 4), *arguments = make_buffer(s.device, 9 * 4);
    memcpy(gpu_buffer_map(indices), (uint32_t[]){3, 4, 5, 6, 7, 8}, 24);
    /* four words: six vertices from the third on; then five: three indices from the third on,
     * 6 subtracted from each */
    memcpy(gpu_buffer_map(arguments), (uint32_t[]){6, 1, 3, 0, 3, 1, 3, (uint32_t)-6, 0}, 36);
    gpu_step step = draw_step(&s, 6);
    step.indices = indices;
    must(gpu_run(s.device, &step, 1, NULL));
    expect(&s, 3, 2);
    step.vertex_count = 7;
    refused(gpu_run(s.device, &step, 1, NULL), GPU_FAILED, "7 indices");
    step.indirect = arguments;
    step.indirect_offset = 16;
    must(gpu_run(s.device, &step, 1, NULL));
    expect(&s, 1, 0);
    step.indices = NULL;
    step.indirect_offset = 0;
    must(gpu_run(s.device, &step, 1, NULL));
    expect(&s, 3, 2);
    gpu_buffer_destroy(indices);
    gpu_buffer_destroy(arguments);
    close_stage(&s);
}

/* Draw, read what was drawn by a compute step, draw over it: all in one list. */
static void drawing_and_computing_alternate(void **state)
{
    (void)state;
    static const char source[] =
        "#version 450\n"
        "layout(local_size_x = 8, local_size_y = 8) in;\n"
        "layout(binding = 0, r32f) uniform image2D first;\n"
        "layout(binding = 1) uniform sampler2D depth;\n"
        "layout(binding = 2) uniform usampler2D second;\n"
        "void main() { ivec2 at = ivec2(gl_LocalInvocationID.xy);\n"
        "    imageStore(first, at, imageLoad(first, at) + 10 * texelFetch(depth, at, 0)\n"
        "        + 100 * float(texelFetch(second, at, 0).z)); }\n";
    stage s = open_stage();
    gpu_compute *add = make_compute(
        s.device,
        &(gpu_compute_options){.name = "add",
                               .source = source,
                               .binding_count = 3,
                               .bindings = {GPU_STORAGE_IMAGE, GPU_FETCHED, GPU_FETCHED}});
    gpu_step steps[] = {draw_step(&s, 6),
                        {.compute = add, .resources = {s.first, s.depth, s.second}},
                        {.clear = s.depth, .clear_value = {0.6F}},
                        draw_step(&s, 3)};
    steps[3].keep = true;
    float first[SIDE][SIDE];
    uint8_t earlier[sizeof first];
    for (int repeat = 0; repeat < 3; repeat++) {
        must(gpu_run(s.device, steps, 4, NULL));
        must(gpu_image_read(s.first, first));
        for (int y = 0; y < SIDE; y++)
            for (int x = 0; x < SIDE; x++)
                assert_true(first[y][x] == (x + y < SIDE - 1 ? 1.0F : 2 + 7.5F + 200));
        if (repeat > 0)
            assert_memory_equal(first, earlier, sizeof first);
        memcpy(earlier, first, sizeof first);
    }
    gpu_compute_destroy(add);
    close_stage(&s);
}

static void draws_lines(void **state)
{
    (void)state;
    stage s = open_stage();
    gpu_draw_options options = draw_options();
    options.lines = true;
    options.depth = false;
    gpu_draw *lines;
    must(gpu_draw_create(s.device, &options, &lines));
    /* along the middle of row 2 */
    const float ends[2][4] = {{-1, -0.375F, 0, 5}, {1, -0.375F, 0, 5}};
    memcpy(gpu_buffer_map(s.vertices), ends, sizeof ends);
    gpu_step step = draw_step(&s, 2);
    step.draw = lines;
    must(gpu_run(s.device, &step, 1, NULL));
    float first[SIDE][SIDE];
    must(gpu_image_read(s.first, first));
    for (int y = 0; y < SIDE; y++)
        for (int x = 1; x < SIDE - 1; x++)
            assert_true(first[y][x] == (y == 2 ? 5.0F : 0.0F));
    gpu_draw_destroy(lines);
    close_stage(&s);
}

static void refuses_bad_shaders(void **state)
{
    (void)state;
    static const char bad[] = "#version 450\nvoid main() {\n    wrong = 1;\n}\n";
    gpu_device *device = open_software_device();
    gpu_draw *draw = (gpu_draw *)1;
    gpu_draw_options options = draw_options();
    options.vertex.source = bad;
    refused(gpu_draw_create(device, &options, &draw), GPU_BAD_SHADER, "triangles:3:");
    assert_null(draw);
    options = draw_options();
    options.fragment.source = bad;
    refused(gpu_draw_create(device, &options, &draw), GPU_BAD_SHADER, "triangles:3:");
    options = draw_options();
    options.fragment.source = NULL;
    refused(gpu_draw_create(device, &options, &draw), GPU_BAD_SHADER, "no shader");
    const uint32_t noise[8] = {1, 2, 3};
    options.fragment = (gpu_shader){.words = noise, .word_count = 8};
    refused(gpu_draw_create(device, &options, &draw), GPU_BAD_SHADER, "not SPIR-V");
    options = draw_options();
    options.target_count = 0;
    options.depth = false;
    refused(gpu_draw_create(device, &options, &draw), GPU_UNSUPPORTED, "into nothing");
    gpu_compute *compute;
    refused(
        gpu_compute_create(device, &(gpu_compute_options){.name = "c", .source = bad}, &compute),
        GPU_BAD_SHADER, "c:3:");
    gpu_draw_destroy(NULL);
    close_clean(device);
}

static void refuses_incomplete_steps(void **state)
{
    (void)state;
    stage s = open_stage();
    gpu_image *small = make_image(s.device, GPU_RGBA32U, SIDE - 1, SIDE);
    gpu_step step = draw_step(&s, 3);
    step.targets[1] = NULL;
    refused(gpu_run(s.device, &step, 1, NULL), GPU_FAILED, "triangles: target 1 is missing");
    step.targets[1] = s.first;
    refused(gpu_run(s.device, &step, 1, NULL), GPU_FAILED, "target 1 is not of");
    step.targets[1] = small;
    refused(gpu_run(s.device, &step, 1, NULL), GPU_FAILED, "target 1 is 7 x 8");
    step = draw_step(&s, 3);
    step.depth = NULL;
    refused(gpu_run(s.device, &step, 1, NULL), GPU_FAILED, "the depth target is missing");
    step = draw_step(&s, 3);
    step.resources[0] = NULL;
    refused(gpu_run(s.device, &step, 1, NULL), GPU_FAILED, "nothing is given for binding 0");
    step = draw_step(&s, 3);
    step.fill = s.vertices;
    refused(gpu_run(s.device, &step, 1, NULL), GPU_FAILED, "one thing to do, got 2");
    refused(gpu_run(s.device, &(gpu_step){0}, 1, NULL), GPU_FAILED, "one thing to do, got 0");
    gpu_compute *count = make_compute(
        s.device, &(gpu_compute_options){
                      .name = "count", .source = count_source, .binding_count = 1, .push_size = 4});
    gpu_step compute = {.name = "count", .compute = count, .resources = {s.vertices}};
    refused(gpu_run(s.device, &compute, 1, NULL), GPU_FAILED, "push constants are missing");
    compute.push = &compute.vertex_count;
    compute.groups[1] = 0x7fffffff;
    refused(gpu_run(s.device, &compute, 1, NULL), GPU_UNSUPPORTED, "work groups along y");
    gpu_compute_destroy(count);
    gpu_image_destroy(small);
    close_stage(&s);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(draws_with_depth_and_two_targets),
        cmocka_unit_test(draws_indexed_and_indirect),
        cmocka_unit_test(drawing_and_computing_alternate),
        cmocka_unit_test(draws_lines),
        cmocka_unit_test(refuses_bad_shaders),
        cmocka_unit_test(refuses_incomplete_steps),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
