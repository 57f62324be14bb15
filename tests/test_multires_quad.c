/* Pixels of the multiresolution pipeline that look at lights alone, and the boards of points that
 * tell them where to look. */
#include "multires_fixture.h"

enum { WIDTH = 152, HEIGHT = 98 };

/* ---- Pixels that look alone ------------------------------------------------------------- */

/* One point in 64 of a light is worth more than a twentieth of the mean irradiance. */
static bool is_bright(const fixture *f, double mean, uint32_t x, uint32_t y)
{
    for (size_t l = 0; l < f->scene.area_light_count; l++) {
        const render_area_light *light = &f->scene.area_lights[l];
        if (exitance(light) * form_factor(f, light, x, y) > 3.2 * mean)
            return true;
    }
    return false;
}

/* They take from the others of their quad only what is not beside a change: nearly the truth. */
static void pixels_alone_are_true(void **state)
{
    (void)state;
    fixture f;
    fixture_open(&f, "box_area", WIDTH * 2, HEIGHT * 2);
    render_statistics statistics;
    float *truth = fixture_light(&f, &shadows_pipeline, &statistics);
    multires m;
    run_first(&f, &m);
    gpu_buffer *between;
    gpu_compute *test = compile_test(&f, &between), *quads = compile_quads(&f);
    for (int l = 4; l > 0; l--) {
        gpu_compute *pass = l > 1 ? test : quads;
        gpu_step step = multires_list_step(&f.frame, &m, "test", pass, l, l, between);
        must(gpu_run(f.device, &step, 1, NULL));
    }
    double mean = mean_of(&m);
    int alone = 0, same = 0, near = 0, shared = 0, bright = 0;
    for (uint32_t y = 0; y < f.frame.height; y++)
        for (uint32_t x = 0; x < f.frame.width; x++) {
            int s = state_of(&m, 0, x, y);
            size_t at = (size_t)y * f.frame.width + x;
            double off = fabs((double)(illumination(&m, 0, x, y)[0] - truth[4 * at])) / mean;
            alone += s == STATE_FINAL;
            same += s == STATE_FINAL && off < 1e-4;
            near += s == STATE_FINAL && off < 0.04;
            shared += s == STATE_SHARED;
            if ((s == STATE_FINAL || s == STATE_PART) && (double)truth[4 * at] > 2.9 * mean &&
                discontinuity(&m, 1, x / 2, y / 2) <= 1 && is_bright(&f, mean, x, y)) {
                bright++;
                assert_int_equal(s, STATE_FINAL);
            }
        }
    printf(
        "%d pixels alone, %d as by all points, %d within 0.04 of the mean; %d share; %d bright\n",
        alone, same, near, shared, bright);
    assert_true(alone > 1000 && shared > 200 && bright > 5);
    assert_true(same > alone * 3 / 4 && near > alone - alone / 100);
    gpu_compute_destroy(test);
    gpu_compute_destroy(quads);
    gpu_buffer_destroy(between);
    multires_destroy(&m);
    free(truth);
    fixture_close(&f);
}

static const char changes_main[] =
    "layout(local_size_x = 64) in;\n"
    "layout(binding = 0) readonly buffer In { uvec2 x[]; };\n"
    "layout(binding = 1) writeonly buffer Out { uvec4 y[]; };\n"
    "void main() {\n"
    "    uint i = gl_GlobalInvocationID.x;\n"
    "    y[i] = uvec4(beside_changes(x[i]), point_on(i & 63u), squares_of(i & 3u).x);\n"
    "}\n";

static bool is_set(const uint32_t board[2], int x, int y)
{
    return board[y / 4] >> (8 * (y % 4) + x) & 1;
}

static uint32_t beside(const uint32_t board[2], int word)
{
    uint32_t found = 0;
    for (int i = 0; i < 32; i++) {
        int x = i % 8, y = 4 * word + i / 8;
        bool differs = false;
        for (int k = 0; k < 9; k++) {
            int column = x + k % 3 - 1, row = y + k / 3 - 1;
            if (column >= 0 && row >= 0 && column < 8 && row < 8)
                differs = differs || is_set(board, column, row) != is_set(board, x, y);
        }
        found |= differs ? 1u << i : 0;
    }
    return found;
}

static void boards_hold_the_points_and_their_changes(void **state)
{
    (void)state;
    enum { COUNT = 1024 };
    gpu_device *device = open_software_device();
    gpu_shader text;
    must(render_shader_method("multires/changes.glsl", NULL, &text));
    char *source = malloc(strlen(text.source) + sizeof changes_main + 100);
    sprintf(source, "#version 450\n%s%s", strstr(text.source, "#ifndef CHANGES_GLSL"),
            changes_main);
    gpu_compute *compute = make_compute(
        device, &(gpu_compute_options){.name = "changes",
                                       .source = source,
                                       .binding_count = 2,
                                       .bindings = {GPU_STORAGE_BUFFER, GPU_STORAGE_BUFFER}});
    gpu_buffer *in = make_buffer(device, COUNT * 8), *out = make_buffer(device, COUNT * 16);
    uint32_t(*boards)[2] = gpu_buffer_map(in), (*y)[4] = gpu_buffer_map(out);
    srand(7);
    for (int i = 0; i < COUNT; i++)
        for (int k = 0; k < 2; k++) /* few, half, many, none, all */
            boards[i][k] = i % 5 == 3   ? 0
                           : i % 5 == 4 ? UINT32_MAX
                           : i % 5 == 0 ? 1u << rand() % 32
                                        : (uint32_t)rand() * 2u + (uint32_t)rand() % 2;
    must(gpu_dispatch_run(
        device,
        &(gpu_dispatch){.compute = compute, .resources = {in, out}, .groups = {COUNT / 64, 1, 1}}));
    render_area_light square = {.corner_count = 4,
                                .corners = {{0, 0, 0}, {8, 0, 0}, {8, 8, 0}, {0, 8, 0}}};
    float points[SHADOWS_POINTS][4];
    shadows_points(&square, 0, points);
    for (int i = 0; i < COUNT; i++) {
        assert_int_equal(y[i][0], beside(boards[i], 0));
        assert_int_equal(y[i][1], beside(boards[i], 1));
        const float *point = points[y[i][2]];
        assert_int_equal((int)point[0], i % 8);
        assert_int_equal((int)point[1], i % 64 / 8);
        for (int k = 0; k < 32; k++)
            assert_int_equal(y[i][3] >> k & 1, y[k][2] / 16 == (uint32_t)i % 4);
    }
    gpu_buffer_destroy(in);
    gpu_buffer_destroy(out);
    gpu_compute_destroy(compute);
    free(source);
    free((char *)text.source);
    close_clean(device);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(pixels_alone_are_true),
        cmocka_unit_test(boards_hold_the_points_and_their_changes),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
