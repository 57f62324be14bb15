/* Vertices come gradually: while the error that splits a quad falls in small steps, quads are
 * split, and no pixel jumps when they are. */
#include "render_fixture.h"

#include <math.h>

#include "render/hull_private.h"

enum { WIDTH = 160, HEIGHT = 96, STEPS = 80 };
static const size_t values = (size_t)4 * WIDTH * HEIGHT;

static uint32_t light_with_split(render_frame *frame, float split, float *light)
{
    hull_settings settings = hull_standard;
    settings.split = split;
    settings.tau = 0.2F; /* fewer near lights than usual leave more to split */
    settings.tau_width = 3;
    render_statistics statistics = {0};
    void *state;
    check(hull_create(frame, &settings, &state));
    check(hull_run(frame, state, &statistics));
    check(gpu_image_read(frame->light, light));
    uint32_t quads = ((const uint32_t *)gpu_buffer_map(
        ((hull *)state)->buffers[HULL_B_CONTROL]))[HULL_LEAF_COUNT];
    hull_destroy(state);
    return quads;
}

/* Over the mean of the first. */
static double largest_change(const float *a, const float *b)
{
    double most = 0, sum = 0, count = 0;
    for (size_t i = 0; i < values; i++) {
        if (i % 4 == 3 || a[i - i % 4 + 3] == 0)
            continue;
        most = fmax(most, fabs((double)a[i] - (double)b[i]));
        sum += (double)a[i];
        count++;
    }
    return most * count / sum;
}

/* Only the floor is seen, from above, so that every vertex lies where its quad wants it. */
static void floor_before_a_wall(fixture *f)
{
    fixture_make(f);
    f->scene.triangle_count = 4;
    f->scene.vertex_count = 12;
    f->scene.area_light_count = 0;
    f->scene.camera = (render_camera){.eye = {0, 2, -1},
                                      .target = {0, 0, -1},
                                      .up = {0, 0, -1},
                                      .fov_y_deg = 50,
                                      .near = 0.1,
                                      .far = 20};
}

static void no_pixel_jumps(void **state)
{
    static float light[2][4 * WIDTH * HEIGHT];
    fixture f;
    floor_before_a_wall(&f);
    render_frame frame;
    make_frame(state, &f, (render_options){.width = WIDTH, .height = HEIGHT}, &frame);
    const float first = 0.1F;
    uint32_t least = light_with_split(&frame, first, light[0]), most = least;
    double worst = 0;
    for (int i = 1; i <= STEPS; i++) {
        most = light_with_split(&frame, first * powf(0.5F, (float)i / STEPS), light[i & 1]);
        worst = fmax(worst, largest_change(light[0], light[1]));
    }
    print_message("%u to %u quads, largest change %g of the mean\n", least, most, worst);
    assert_true(most > least + 20);
    assert_true(worst < 0.03);
    render_frame_destroy(&frame);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(no_pixel_jumps),
    };
    return cmocka_run_group_tests(tests, open_device, close_device);
}
