/* Area lights that are hard to treat: lights that reach nothing, lights in parts, many of them. */
#include "multires_fixture.h"

enum { WIDTH = 96, HEIGHT = 70 };

/* Sum of what a pipeline makes of the scene's lights. */
static double sum_light(fixture *f, const render_pipeline *pipeline, render_statistics *statistics)
{
    float *light = fixture_light(f, pipeline, statistics);
    size_t pixels = (size_t)f->frame.width * f->frame.height;
    double sum = 0;
    for (size_t i = 0; i < pixels; i++) {
        float expected = f->position[4 * i + 3] > 0 ? 1 : 0;
        if (light[4 * i + 3] != expected)
            fail_msg("%s, pixel %zu: state %g", pipeline->id, i, (double)light[4 * i + 3]);
        for (size_t k = 0; k < 3; k++) {
            assert_true(isfinite(light[4 * i + k]) && light[4 * i + k] >= 0);
            sum += (double)light[4 * i + k];
        }
    }
    free(light);
    return sum;
}

static void lights_that_reach_nothing_are_dark(void **state)
{
    (void)state;
    static const struct {
        const char *what;
        double corners[3][3];
    } lights[] = {
        {"without area", {{0, 1, 0}, {0.5, 1, 0}, {0.5, 1, 0}}},
        {"inside the tall box", {{0.45, 0.6, -0.4}, {0.5, 0.6, -0.4}, {0.45, 0.6, -0.35}}},
        {"behind everything, turned away", {{0, 1, -3}, {0, 2, -3}, {1, 1, -3}}},
        {"behind everything, through the wall", {{0, 1, -3}, {1, 1, -3}, {0, 2, -3}}},
    };
    enum { LIGHTS = sizeof lights / sizeof *lights };
    static const render_pipeline *const some[] = {&shadows_pipeline, &multires_pipeline,
                                                  &nichols_pipeline};
    fixture f;
    fixture_open(&f, "box_area", WIDTH, HEIGHT);
    render_area_light *own = f.scene.area_lights, dark[LIGHTS];
    for (size_t l = 0; l < LIGHTS; l++) {
        dark[l] = (render_area_light){.corner_count = 3, .exitance = {5, 5, 5}};
        memcpy(dark[l].corners, lights[l].corners, sizeof lights[l].corners);
    }
    f.scene.area_lights = dark;
    f.scene.area_light_count = LIGHTS;
    for (int i = 0; i < 3; i++) {
        render_statistics statistics;
        double sum = sum_light(&f, some[i], &statistics);
        for (size_t l = 0; l < LIGHTS && sum > 0; l++)
            print_message("one of these reaches something: a light %s\n", lights[l].what);
        assert_true(sum == 0);
    }
    f.scene.area_lights = own;
    f.scene.area_light_count = 2;
    fixture_close(&f);
}

/* A light cut in 256 gives what it gives in one piece. */
static void hundreds_of_lights_are_one(void **state)
{
    (void)state;
    enum { SIDE = 16 };
    fixture f;
    fixture_open(&f, "box_area", 12, 8);
    render_area_light *own = f.scene.area_lights;
    render_area_light *many = calloc(SIDE * SIDE, sizeof *many);
    for (int i = 0; i < SIDE * SIDE; i++) {
        many[i] = (render_area_light){.corner_count = 4, .exitance = {20, 19, 17}};
        for (int c = 0; c < 4; c++) {
            many[i].corners[c][0] = -0.3 + 0.6 * (i % SIDE + (c == 1 || c == 2)) / SIDE;
            many[i].corners[c][1] = 1.99;
            many[i].corners[c][2] = -0.1 + 0.6 * (i / SIDE + (c > 1)) / SIDE;
        }
    }
    render_statistics statistics;
    f.scene.area_light_count = 1;
    double one = sum_light(&f, &shadows_pipeline, &statistics);
    f.scene.area_lights = many;
    f.scene.area_light_count = SIDE * SIDE;
    double sum = sum_light(&f, &shadows_pipeline, &statistics);
    assert_true(one > 0);
    assert_true(fabs(sum - one) < 0.01 * one);
    assert_true(fabs(sum_light(&f, &multires_pipeline, &statistics) - one) < 0.05 * one);
    f.scene.area_lights = own;
    f.scene.area_light_count = 2;
    free(many);
    fixture_close(&f);
}

/* Some of the lights in each dispatch: the same to the bit as all of them in one. */
static void lights_in_parts_are_the_same(void **state)
{
    (void)state;
    enum { PARTS = 6 };
    fixture f;
    fixture_open(&f, "box_area", WIDTH, HEIGHT);
    render_area_light *own = f.scene.area_lights, many[PARTS], all[2] = {own[0], own[1]};
    for (int i = 0; i < PARTS; i++) {
        many[i] = all[i % 2];
        for (int c = 0; c < many[i].corner_count; c++)
            many[i].corners[c][i % 2 ? 2 : 0] += 0.1 * (i / 2);
    }
    render_statistics statistics[2];
    float *light[2];
    f.scene.area_lights = many;
    f.scene.area_light_count = PARTS;
    for (size_t i = 0; i < 2; i++) {
        multires_settings settings = multires_default;
        settings.at_once = i ? 4 * PARTS : 2;
        void *made;
        must(multires_create_state(&f.frame, &settings, &made));
        must(render_frame_run(&f.frame, &multires_pipeline, made, &statistics[i]));
        light[i] = malloc((size_t)WIDTH * HEIGHT * 16);
        must(gpu_image_read(f.frame.light, light[i]));
        multires_pipeline.destroy(made);
    }
    assert_memory_equal(light[0], light[1], (size_t)WIDTH * HEIGHT * 16);
    assert_true(statistics[0].visibility_rays == statistics[1].visibility_rays);
    free(light[0]);
    free(light[1]);
    f.scene.area_lights = own;
    f.scene.area_light_count = 2;
    fixture_close(&f);
}

static void scale_points(double (*points)[3], int count, double by)
{
    for (int i = 0; i < count; i++)
        for (int k = 0; k < 3; k++)
            points[i][k] *= by;
}

static void scale_scene(render_scene *scene, double by)
{
    for (size_t i = 0; i < 3 * scene->vertex_count; i++)
        scene->positions[i] *= (float)by;
    scale_points(&scene->low, 1, by);
    scale_points(&scene->high, 1, by);
    scale_points(&scene->camera.eye, 1, by);
    scale_points(&scene->camera.target, 1, by);
    scale_points(&scene->spot.position, 1, by);
    scale_points(&scene->spot.target, 1, by);
    for (int i = 0; i < 3; i++)
        scene->spot.intensity[i] *= by * by;
    scene->camera.near *= by;
    scene->camera.far *= by;
    for (size_t l = 0; l < scene->area_light_count; l++)
        scale_points(scene->area_lights[l].corners, scene->area_lights[l].corner_count, by);
}

/* A room of a quarter of a millimetre, its lights and camera with it, is as bright as one of 2 m.
 */
static void a_small_room_is_as_bright(void **state)
{
    (void)state;
    static const render_pipeline *const some[] = {&exact_pipeline, &shadows_pipeline};
    fixture f;
    double sums[2][2];
    fixture_open(&f, "box_area", 24, 16);
    f.scene.has_spot = false;
    for (int small = 0; small < 2; small++) {
        fixture_close_frame(&f);
        scale_scene(&f.scene, small ? 0x1p-13 : 1);
        fixture_frame(&f, 24, 16);
        for (int i = 0; i < 2; i++) {
            render_statistics statistics;
            sums[small][i] = sum_light(&f, some[i], &statistics);
        }
    }
    for (int i = 0; i < 2; i++) {
        assert_true(sums[0][i] > 0);
        if (!(fabs(sums[1][i] - sums[0][i]) < 0.005 * sums[0][i]))
            fail_msg("%s: %g, large %g", some[i]->id, sums[1][i], sums[0][i]);
    }
    fixture_close(&f);
}

/* So is one of a micrometre by its spotlight, whose map begins nearer than that. */
static void a_spotlight_in_a_small_room_is_as_bright(void **state)
{
    (void)state;
    fixture f;
    double sums[2];
    fixture_open(&f, "box", 24, 16);
    for (int small = 0; small < 2; small++) {
        render_statistics statistics;
        fixture_close_frame(&f);
        scale_scene(&f.scene, small ? 0x1p-21 : 1);
        fixture_frame(&f, 24, 16);
        sums[small] = sum_light(&f, &exact_pipeline, &statistics);
    }
    assert_true(sums[0] > 0);
    if (!(fabs(sums[1] - sums[0]) < 0.01 * sums[0]))
        fail_msg("%g, large %g", sums[1], sums[0]);
    fixture_close(&f);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(lights_that_reach_nothing_are_dark),
        cmocka_unit_test(lights_in_parts_are_the_same),
        cmocka_unit_test(a_small_room_is_as_bright),
        cmocka_unit_test(a_spotlight_in_a_small_room_is_as_bright),
        cmocka_unit_test(hundreds_of_lights_are_one),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
