/* The hull along a floor and a wall that are seen edge-on: from one pixel to the next lie metres,
 * and the light of a lamp may fall between the vertices of the smallest quad. */
#include "render_fixture.h"

enum { WIDTH = 320, HEIGHT = 180, LAMPS = 8 };
static const size_t values = (size_t)4 * WIDTH * HEIGHT;

/* A square of the ceiling, seen from below, every 5 m. */
static void add_lamps(fixture *f, render_area_light lamps[LAMPS])
{
    for (int i = 0; i < LAMPS; i++) {
        double z = -5.0 * i;
        lamps[i] = (render_area_light){.corner_count = 4,
                                       .corners = {{-0.1, 0.99, z - 0.1},
                                                   {0.1, 0.99, z - 0.1},
                                                   {0.1, 0.99, z + 0.1},
                                                   {-0.1, 0.99, z + 0.1}},
                                       .exitance = {9, 9, 9}};
    }
    f->scene.area_light_count = LAMPS;
    f->scene.area_lights = lamps;
}

/* 43 m long, 1 m wide and high, without end walls. */
static void corridor(fixture *f, render_area_light lamps[LAMPS])
{
    fixture_make(f);
    f->scene.triangle_count = f->scene.vertex_count = 0;
    f->scene.has_spot = false;
    fixture_quad(f, (float[]){-0.5F, 0, 3, 0.5F, 0, 3, 0.5F, 0, -40, -0.5F, 0, -40}, 0);
    fixture_quad(f, (float[]){0.5F, 0, 3, 0.5F, 1, 3, 0.5F, 1, -40, 0.5F, 0, -40}, 1);
    fixture_quad(f, (float[]){-0.5F, 0, -40, -0.5F, 1, -40, -0.5F, 1, 3, -0.5F, 0, 3}, 2);
    add_lamps(f, lamps);
    const float low[3] = {-0.5F, 0, -40}, high[3] = {0.5F, 1, 3};
    for (int i = 0; i < 3; i++) {
        f->scene.low[i] = low[i];
        f->scene.high[i] = high[i];
    }
    f->scene.camera = (render_camera){.eye = {0.45, 0.05, 2.5},
                                      .target = {0.4, 0.1, -20},
                                      .up = {0, 1, 0},
                                      .fov_y_deg = 30,
                                      .near = 0.01,
                                      .far = 60};
}

static void light_between_vertices_is_found(void **state)
{
    static float light[4 * WIDTH * HEIGHT], truth[4 * WIDTH * HEIGHT];
    fixture f;
    render_area_light lamps[LAMPS];
    corridor(&f, lamps);
    render_frame frame;
    make_frame(state, &f, (render_options){.width = WIDTH, .height = HEIGHT}, &frame);
    render_statistics statistics = {0};
    light_with(&frame, "exact", &statistics, truth);
    light_with(&frame, "hull", &statistics, light);
    for (size_t i = 3; i < values; i += 4)
        assert_true((light[i] > 0) == (truth[i] > 0));
    render_comparison comparison;
    render_compare(values / 4, light, truth, NULL, &comparison);
    print_message("rel %g, p99 %g\n", comparison.rel, comparison.p99);
    assert_true(comparison.rel < 0.05);
    assert_true(comparison.p99 < 0.2);
    render_frame_destroy(&frame);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(light_between_vertices_is_found),
    };
    return cmocka_run_group_tests(tests, open_device, close_device);
}
