/* What hull_lobe says that it integrates is what it integrates. */
#include "render_fixture.h"

#include "render/hull_private.h"
#include "sg.h"

enum { WIDTH = 96, HEIGHT = 64, PIXELS = WIDTH * HEIGHT };

/* Pixels that no lobe was integrated for are none of the sum. */
static void leave_out_those_lit_exactly(const hull *h, float light[4 * PIXELS])
{
    const uint32_t *arguments = gpu_buffer_map(h->buffers[HULL_B_ARGUMENTS]),
                   *pixels = gpu_buffer_map(h->buffers[HULL_B_EXACT]);
    uint32_t count = arguments[3] - 1; /* after three numbers of groups, 1 more than there are */
    assert_true(count < PIXELS / 4);
    for (uint32_t i = 0; i < count; i++)
        memset(light + 4 * (size_t)pixels[i], 0, 4 * sizeof *light);
}

/* Without near lights the lobes, integrated by the reference, are the image's irradiance but for
 * what corrects them at the vertices, which is small and of either sign. */
static void points_are_those_of_the_image(void **state)
{
    fixture f;
    fixture_make(&f);
    render_frame frame;
    make_frame(state, &f, (render_options){.width = WIDTH, .height = HEIGHT}, &frame);
    hull_settings settings = hull_standard;
    settings.kind = HULL_LOBES;
    settings.tau = 1e9F;
    void *hull_state;
    check(hull_create(&frame, &settings, &hull_state));
    render_statistics statistics = {0};
    check(hull_run(&frame, hull_state, &statistics));
    static float light[4 * PIXELS];
    check(gpu_image_read(frame.light, light));
    leave_out_those_lit_exactly(hull_state, light);
    double expected = 0.0, found = 0.0;
    for (size_t i = 0; i < PIXELS; i++)
        expected += 0.2126 * (double)light[4 * i] + 0.7152 * (double)light[4 * i + 1] +
                    0.0722 * (double)light[4 * i + 2];
    float *points;
    size_t count;
    check(hull_lobe_pipeline.profile(&frame, hull_state, &points, &count));
    assert_true(count > PIXELS / 2 && count <= HULL_LOBE_COUNT * PIXELS);
    for (size_t i = 0; i < count; i++) {
        double lambda = (double)points[3 * i], cos_theta = (double)points[3 * i + 1];
        double flux = sqrt((double)points[3 * i + 2]);
        assert_true(lambda > 0.0 && cos_theta >= -1.0 && cos_theta <= 1.0 && flux > 0.0);
        found += flux * sg_L_cos(lambda, cos_theta);
    }
    assert_true(expected > 0.0);
    assert_near(found / expected, 1.0, 0.05);
    assert_null(hull_pipeline.profile); /* integrates no lobes */
    free(points);
    hull_destroy(hull_state);
    render_frame_destroy(&frame);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(points_are_those_of_the_image)};
    return cmocka_run_group_tests(tests, open_device, close_device);
}
