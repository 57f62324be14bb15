/* Frames that are out of the ordinary: odd sizes, nothing to see, nothing that shines, cameras in
 * walls, vertices that are no numbers, more work than one dispatch takes. */
#include "render_reference.h"

typedef struct picture {
    size_t pixels;
    float *positions, *light;
    uint32_t *normals;
    render_statistics statistics;
} picture;

static void take(render_frame *frame, picture *p)
{
    p->pixels = (size_t)frame->width * frame->height;
    p->positions = malloc(p->pixels * 4 * sizeof(float));
    p->light = malloc(p->pixels * 4 * sizeof(float));
    p->normals = malloc(p->pixels * 2 * sizeof(uint32_t));
    light_with(frame, "exact", &p->statistics, p->light);
    check(gpu_image_read(frame->position, p->positions));
    check(gpu_image_read(frame->normal, p->normals));
}

static void drop(picture *p)
{
    free(p->positions);
    free(p->light);
    free(p->normals);
}

/* Every step-th pixel against the sum of form factors, and the counts of all. */
static void check_picture(render_frame *frame, const picture *p, size_t step)
{
    uint64_t surfaces = 0;
    for (size_t i = 0; i < p->pixels; i++) {
        bool surface = p->positions[4 * i + 3] > 0;
        surfaces += surface;
        assert_true(p->light[4 * i + 3] == (surface ? 1.0F : 0.0F));
    }
    assert_int_equal(p->statistics.pixels_covered, surfaces);
    assert_int_equal(p->statistics.pixels_uncovered, 0);
    assert_int_equal(p->statistics.light_evaluations, surfaces * frame->light_count);
    for (size_t i = 0; i < p->pixels; i += step) {
        double sum[3] = {0, 0, 0};
        if (p->positions[4 * i + 3] > 0)
            fixture_irradiance(gpu_buffer_map(frame->lights), frame->light_count,
                               p->positions + 4 * i, p->normals[2 * i], sum);
        for (size_t k = 0; k < 3; k++)
            assert_near((double)p->light[4 * i + k], sum[k], 1e-3 * sum[k] + 1e-4);
    }
}

static void odd_sizes_are_lit_completely(void **state)
{
    static const uint32_t sizes[][2] = {{1, 1}, {33, 17}, {7, 129}, {4096, 16}};
    fixture f;
    fixture_make(&f);
    for (size_t i = 0; i < sizeof sizes / sizeof *sizes; i++) {
        render_frame frame;
        picture p;
        make_frame(state, &f, (render_options){.width = sizes[i][0], .height = sizes[i][1]},
                   &frame);
        take(&frame, &p);
        check_picture(&frame, &p, p.pixels / 100 + 1);
        assert_true(p.statistics.pixels_covered > 0);
        drop(&p);
        render_frame_destroy(&frame);
    }
}

static void many_lights_take_several_dispatches(void **state)
{
    fixture f;
    fixture_make(&f);
    f.scene.rsm_size = 64;
    render_frame frame;
    picture p;
    make_frame(state, &f, (render_options){.width = 160, .height = 56}, &frame);
    assert_true(frame.light_count > 3500);
    take(&frame, &p);
    check_picture(&frame, &p, 331);
    drop(&p);
    render_frame_destroy(&frame);
}

static void a_scene_without_triangles_is_empty(void **state)
{
    fixture f;
    fixture_make(&f);
    f.scene.triangle_count = f.scene.vertex_count = f.scene.material_count = 0;
    render_frame frame;
    picture p;
    make_frame(state, &f, (render_options){.width = 20, .height = 12}, &frame);
    assert_int_equal(frame.light_count, 2); /* the area light */
    take(&frame, &p);
    check_picture(&frame, &p, 1);
    assert_int_equal(p.statistics.pixels_covered, 0);
    assert_true(frame.gain == 1);
    drop(&p);
    render_frame_destroy(&frame);
}

static void without_lights_all_is_black(void **state)
{
    fixture f;
    for (int which = 0; which < 2; which++) {
        fixture_make(&f);
        f.scene.area_light_count = 0;
        f.scene.has_spot = which == 0;
        if (which == 0) /* it shines away from everything */
            for (int i = 0; i < 3; i++)
                f.scene.spot.target[i] = 2 * f.scene.spot.position[i] - f.scene.spot.target[i];
        render_frame frame;
        picture p;
        make_frame(state, &f, (render_options){.width = 20, .height = 12}, &frame);
        assert_int_equal(frame.light_count, 0);
        take(&frame, &p);
        check_picture(&frame, &p, 1);
        assert_true(p.statistics.pixels_covered > 0);
        drop(&p);
        render_frame_destroy(&frame);
    }
}

/* Just in front of the back wall, looking through it; then in the middle of the leaning triangle,
 * looking along it. */
static void a_camera_inside_geometry_sees_something(void **state)
{
    static const double eyes[2][2][3] = {{{0, 1, -1.95}, {0, 1, -4}},
                                         {{0, 0, 0}, {0.2, 1.2, -0.1}}};
    fixture f;
    for (int which = 0; which < 2; which++) {
        fixture_make(&f);
        memcpy(f.scene.camera.eye, eyes[which][0], sizeof eyes[which][0]);
        memcpy(f.scene.camera.target, eyes[which][1], sizeof eyes[which][1]);
        render_frame frame;
        picture p;
        make_frame(state, &f, (render_options){.width = 40, .height = 24}, &frame);
        take(&frame, &p);
        check_picture(&frame, &p, 7);
        drop(&p);
        render_frame_destroy(&frame);
    }
}

static void broken_triangles_are_not_there(void **state)
{
    fixture f;
    fixture_make(&f);
    picture whole, broken;
    render_frame frame;
    render_options options = {.width = 40, .height = 24};
    make_frame(state, &f, options, &frame);
    take(&frame, &whole);
    render_frame_destroy(&frame);
    fixture_add(&f, (float[]){0, 1, 0, 1, 1, 1, NAN, 2, 0}, 0);
    fixture_add(&f, (float[]){0, 1, 1, 1, INFINITY, 1, 0, 2, 0}, 0);
    fixture_add(&f, (float[]){0, 1, 2, 1, 1, 2, 2, 1, 2}, 0); /* a line */
    fixture_add(&f, (float[]){1, 1, 2, 1, 1, 2, 1, 1, 2}, 0); /* a point */
    make_frame(state, &f, options, &frame);
    take(&frame, &broken);
    render_frame_destroy(&frame);
    assert_memory_equal(whole.positions, broken.positions, whole.pixels * 16);
    assert_memory_equal(whole.light, broken.light, whole.pixels * 16);
    drop(&whole);
    drop(&broken);
}

static void images_beyond_the_device_are_refused(void **state)
{
    fixture f;
    fixture_make(&f);
    if (!*state)
        skip();
    render_frame frame;
    render_options options = {.width = 1 << 20, .height = 1};
    assert_int_equal(render_frame_create(*state, &f.scene, &options, &frame), GPU_UNSUPPORTED);
    assert_non_null(strstr(gpu_last_error(), "1048576"));
    assert_null(frame.position);
}

/* A device may end a shader that goes around its loops too often, and no pipeline says so. */
static void as_many_lights_as_there_may_be_are_all_counted(void **state)
{
    enum { MOST = 20000 };
    fixture f;
    fixture_make(&f);
    if (!*state)
        skip();
    static render_area_light lights[MOST / 2 + 1];
    for (int i = 0; i <= MOST / 2; i++)
        lights[i] = f.area;
    f.scene.has_spot = false;
    f.scene.area_lights = lights;
    f.scene.area_light_count = MOST / 2;
    render_frame frame;
    picture p;
    render_options options = {.width = 12, .height = 8};
    make_frame(state, &f, options, &frame);
    assert_int_equal(frame.light_count, MOST);
    take(&frame, &p);
    check_picture(&frame, &p, 7);
    static float hull[4 * 12 * 8];
    render_statistics statistics;
    light_with(&frame, "hull", &statistics, hull);
    render_comparison comparison;
    render_compare(p.pixels, hull, p.light, NULL, &comparison);
    if (!(comparison.rel < 0.2 && fabs(comparison.bias) < 0.02))
        fail_msg("hull: rel %g, bias %g", comparison.rel, comparison.bias);
    drop(&p);
    render_frame_destroy(&frame);
    f.scene.area_light_count = MOST / 2 + 1;
    assert_int_equal(render_frame_create(*state, &f.scene, &options, &frame), GPU_UNSUPPORTED);
    assert_non_null(strstr(gpu_last_error(), "20002 lights, more than 20000"));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(odd_sizes_are_lit_completely),
        cmocka_unit_test(many_lights_take_several_dispatches),
        cmocka_unit_test(a_scene_without_triangles_is_empty),
        cmocka_unit_test(without_lights_all_is_black),
        cmocka_unit_test(a_camera_inside_geometry_sees_something),
        cmocka_unit_test(broken_triangles_are_not_there),
        cmocka_unit_test(images_beyond_the_device_are_refused),
        cmocka_unit_test(as_many_lights_as_there_may_be_are_all_counted),
    };
    return cmocka_run_group_tests(tests, open_device, close_device);
}
