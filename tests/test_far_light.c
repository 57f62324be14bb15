/* Far light, whatever the number of lights: no pixel is lit by what rounding made of a light that
 * is seen edge-on, and few or many lights cost no accuracy. */
#include "render_fixture.h"

#include <stdlib.h>

#include "base/file.h"

enum { WIDTH = 200, HEIGHT = 120 };

/* On the built-in scene with a map of that size. */
static void hold(void **state, int rsm_size)
{
    static const char *const ids[] = {"hull", "hull_lobe", "upsample_far"};
    static float light[4 * WIDTH * HEIGHT], truth[4 * WIDTH * HEIGHT], errors[WIDTH * HEIGHT];
    if (!*state)
        skip();
    render_scene scene;
    char *path = render_scene_default();
    assert_true(render_scene_read(path, NULL, &scene));
    free(path);
    scene.rsm_size = rsm_size;
    render_frame frame;
    check(render_frame_create(*state, &scene, &(render_options){.width = WIDTH, .height = HEIGHT},
                              &frame));
    render_statistics statistics;
    light_with(&frame, "exact", &statistics, truth);
    for (size_t i = 0; i < sizeof ids / sizeof *ids; i++) {
        render_comparison found;
        float worst = 0;
        light_with(&frame, ids[i], &statistics, light);
        render_compare(WIDTH * HEIGHT, light, truth, errors, &found);
        for (int k = 0; k < WIDTH * HEIGHT; k++)
            worst = errors[k] > worst ? errors[k] : worst;
        print_message("%s, %d lights: rel %.4f, worst %.2f\n", ids[i], (int)frame.light_count,
                      found.rel, (double)worst);
        if (!(found.rel < 0.15) || !(worst < 3))
            fail_msg("expected rel below 0.15 and no error above 3");
    }
    render_frame_destroy(&frame);
    render_scene_free(&scene);
}

static void one_light(void **state)
{
    hold(state, 1);
}

static void few_lights(void **state)
{
    hold(state, 2);
    hold(state, 5);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(one_light),
        cmocka_unit_test(few_lights),
    };
    return cmocka_run_group_tests(tests, open_device, close_device);
}
