/* The renderer's ground truth on the device against one that shares nothing with it: rays by Embree
 * and form factors in double; live, and as stored in tests/data/box_truth.exr, which is written by
 *     write_truth tests/scenes/box.json 63 48 tests/data/box_truth.exr */
#include <math.h>
#include <string.h>

#include "base/exr.h"
#include "base/file.h"
#include "gpu_fixture.h"
#include "render/render.h"
#ifdef HAVE_EMBREE
#include "reference_render.h"
#endif

/* What one frame gave, on the host. */
typedef struct picture {
    int width, height;
    size_t pixels;
    float *position, *light; /* 4 a pixel */
    float *lights; /* 16 each: three corners with a channel of the exitance, normal, area */
    size_t light_count;
} picture;

static render_scene read_scene(const char *name)
{
    char *path = base_join(getenv("SGFIT_ROOT"), name);
    render_scene scene;
    assert_true(render_scene_read(path, NULL, &scene));
    free(path);
    return scene;
}

static picture take_picture(const render_scene *scene, int width, int height)
{
    gpu_device *device = open_software_device();
    const render_options options = {.width = (uint32_t)width, .height = (uint32_t)height};
    render_frame frame;
    render_statistics statistics;
    picture made = {width, height, (size_t)width * (size_t)height, NULL, NULL, NULL, 0};
    if (render_frame_create(device, scene, &options, &frame) != GPU_OK ||
        render_frame_light(&frame, render_pipeline_find("exact"), &statistics) != GPU_OK)
        fail_msg("%s", gpu_last_error());
    made.position = malloc(made.pixels * 16);
    made.light = malloc(made.pixels * 16);
    made.light_count = frame.light_count;
    made.lights = malloc(made.light_count * 64 + 1);
    assert_int_equal(gpu_image_read(frame.position, made.position), GPU_OK);
    assert_int_equal(gpu_image_read(frame.light, made.light), GPU_OK);
    memcpy(made.lights, gpu_buffer_map(frame.lights), made.light_count * 64);
    render_frame_destroy(&frame);
    close_clean(device);
    return made;
}

static void forget(picture *made)
{
    free(made->position);
    free(made->light);
    free(made->lights);
}

/* Root mean square of the difference over the mean of the truth, both over the pixels that agree
 * about the surface they see; the others must be few. depth: 0 without a surface. (Sizes are odd by
 * even: no pixel's centre is on the diagonals, which the box's edges are on.) */
typedef struct agreement {
    double rel, worst;
    size_t compared, different;
} agreement;

static agreement compare(const picture *made, const double *depths, const double (*truth)[3])
{
    agreement a = {0};
    double squares = 0, sum = 0, worst = 0;
    for (size_t i = 0; i < made->pixels; i++) {
        double depth = (double)made->position[4 * i + 3], expected = depths[i];
        if (fabs(depth - expected) > 1e-4 * fmax(depth, expected)) {
            a.different++;
            continue;
        }
        assert_true((made->light[4 * i + 3] == 1) == (expected > 0));
        if (!(expected > 0))
            continue;
        a.compared++;
        for (size_t c = 0; c < 3; c++) {
            double difference = (double)made->light[4 * i + c] - truth[i][c];
            squares += difference * difference;
            sum += truth[i][c];
            worst = fmax(worst, fabs(difference));
        }
    }
    assert_true(a.compared > 0 && sum > 0);
    double mean = sum / (3 * (double)a.compared);
    a.rel = sqrt(squares / (3 * (double)a.compared)) / mean;
    a.worst = worst / mean;
    print_message("rel %.2e, worst %.2e over %zu pixels, %zu see something else\n", a.rel, a.worst,
                  a.compared, a.different);
    assert_true(a.different * 100 < made->pixels);
    return a;
}

static void test_stored(void **state)
{
    (void)state;
    static const char *const names[] = {"R", "G", "B", "Z"};
    char *path = base_join(getenv("SGFIT_ROOT"), "tests/data/box_truth.exr");
    enum { WIDTH = 63, HEIGHT = 48, PIXELS = WIDTH * HEIGHT };
    static double depths[PIXELS], truth[PIXELS][3];
    for (int c = 0; c < 4; c++) {
        int width, height;
        float *plane = exr_read(path, names[c], &width, &height);
        assert_true(plane && width == WIDTH && height == HEIGHT);
        for (int i = 0; i < PIXELS; i++)
            *(c < 3 ? &truth[i][c] : &depths[i]) = (double)plane[i];
        free(plane);
    }
    free(path);
    render_scene scene = read_scene("tests/scenes/box.json");
    picture made = take_picture(&scene, WIDTH, HEIGHT);
    assert_true(compare(&made, depths, truth).rel < 1e-4);
    forget(&made);
    render_scene_free(&scene);
}

#ifdef HAVE_EMBREE

/* The seen surfaces, the lights and the irradiance of the reference for one view. */
typedef struct expected {
    reference_pixel *view;
    double *depths, (*rgb)[3];
    reference_light *lights;
    size_t light_count;
} expected;

static expected expect(const render_scene *scene, int width, int height)
{
    size_t pixels = (size_t)width * (size_t)height;
    expected e = {.view = calloc(pixels, sizeof *e.view),
                  .depths = calloc(pixels, sizeof *e.depths),
                  .rgb = calloc(pixels, sizeof *e.rgb)};
    reference *from = reference_open(scene);
    e.lights = reference_lights(from, &e.light_count);
    reference_view(from, &scene->camera, width, height, e.view);
    reference_irradiance(e.view, pixels, e.lights, e.light_count, e.rgb);
    for (size_t i = 0; i < pixels; i++)
        e.depths[i] = e.view[i].depth;
    reference_close(from);
    return e;
}

static void forget_expected(expected *e)
{
    free(e->view);
    free(e->depths);
    free(e->rgb);
    free(e->lights);
}

static void test_stored_is_reproduced(void **state)
{
    (void)state;
    char *path = base_join(getenv("SGFIT_ROOT"), "tests/data/box_truth.exr");
    render_scene scene = read_scene("tests/scenes/box.json");
    expected e = expect(&scene, 63, 48);
    int width, height, other = 0;
    float *green = exr_read(path, "G", &width, &height);
    assert_non_null(green);
    for (int i = 0; i < width * height; i++) /* another processor may see past another edge */
        other += !(fabs((double)green[i] - e.rgb[i][1]) <= 1e-5 * (e.rgb[i][1] + 1e-3));
    assert_in_range(other, 0, 3);
    free(green);
    free(path);
    forget_expected(&e);
    render_scene_free(&scene);
}

/* Lights of the device's reflective shadow map, one by one: place, area, normal, exitance. */
static void compare_lights(const picture *made, const expected *e)
{
    assert_int_equal(made->light_count, e->light_count);
    size_t different = 0;
    for (size_t i = 0; i < e->light_count; i++) {
        const float *light = &made->lights[16 * i];
        const reference_light *truth = &e->lights[i];
        double away = 0, turned = 0, area, a[3], b[3], across[3], channel = 0;
        for (int k = 0; k < 3; k++) {
            double centre = ((double)light[k] + (double)light[4 + k] + (double)light[8 + k]) / 3;
            double expected_centre =
                (truth->corners[0][k] + truth->corners[1][k] + truth->corners[2][k]) / 3;
            away = fmax(away, fabs(centre - expected_centre));
            turned = fmax(turned, fabs((double)light[12 + k] - truth->normal[k]));
            channel = fmax(channel, fabs((double)light[4 * k + 3] - truth->exitance[k]));
            a[k] = truth->corners[1][k] - truth->corners[0][k];
            b[k] = truth->corners[2][k] - truth->corners[0][k];
        }
        for (int k = 0; k < 3; k++)
            across[k] = a[(k + 1) % 3] * b[(k + 2) % 3] - a[(k + 2) % 3] * b[(k + 1) % 3];
        area = 0.5 * sqrt(across[0] * across[0] + across[1] * across[1] + across[2] * across[2]);
        double most = fmax(truth->exitance[0], fmax(truth->exitance[1], truth->exitance[2]));
        /* normals are stored in 16 bits a side */
        different += !(away < 1e-4 && turned < 1e-4 && channel <= 2e-4 * (1 + most) &&
                       fabs((double)light[15] - area) <= 5e-4 * area);
    }
    print_message("%zu of %zu lights are different\n", different, e->light_count);
    assert_true(different * 100 <= e->light_count);
}

static void test_views(void **state)
{
    (void)state;
    static const char *const names[] = {"tests/scenes/box.json", "tests/scenes/box_2.json",
                                        "tests/scenes/box_3.json"};
    enum { WIDTH = 97, HEIGHT = 64 };
    for (int n = 0; n < 3; n++) {
        render_scene scene = read_scene(names[n]);
        picture made = take_picture(&scene, WIDTH, HEIGHT);
        expected e = expect(&scene, WIDTH, HEIGHT);
        compare_lights(&made, &e);
        assert_true(compare(&made, e.depths, e.rgb).rel < 1e-4);
        for (size_t i = 0; i < made.pixels; i++) /* the same places, not only depths */
            for (size_t k = 0; e.depths[i] > 0 && k < 3; k++)
                if (fabs((double)made.position[4 * i + 3] - e.depths[i]) <= 1e-4 * e.depths[i])
                    assert_true(fabs((double)made.position[4 * i + k] - e.view[i].position[k]) <
                                2e-4 * e.depths[i]);
        forget(&made);
        forget_expected(&e);
        render_scene_free(&scene);
    }
}

/* Polygons of light that the horizon cuts, that stand close to surfaces and that face away. */
static void test_area_lights(void **state)
{
    (void)state;
    render_scene scene = read_scene("tests/scenes/box.json");
    render_area_light lights[] = {
        {4,
         {{-0.9, 1.99, -0.5}, {0.2, 1.99, -0.5}, {0.2, 1.99, 0.5}, {-0.9, 1.99, 0.5}},
         {3, 2, 1}},
        {3, {{-0.99, 0.1, 0.2}, {-0.99, 0.1, -0.9}, {-0.99, 1.2, -0.5}}, {1, 4, 2}},
        {5,
         {{0.2, 0.01, 0.5},
          {0.6, 0.01, 0.5},
          {0.7, 0.01, 0.7},
          {0.4, 0.01, 0.9},
          {0.15, 0.01, 0.7}},
         {9, 9, 9}},
        {3, {{5, 5, 5}, {6, 5, 5}, {5, 6, 5}}, {7, 7, 7}},            /* away from everything */
        {3, {{0, 0.5, 0.6}, {0, 0.9, 0.6}, {0, 0.5, 0.2}}, {2, 2, 8}} /* in mid-air */
    };
    free(scene.area_lights);
    scene.area_light_count = sizeof lights / sizeof *lights;
    scene.area_lights = malloc(sizeof lights);
    memcpy(scene.area_lights, lights, sizeof lights);
    scene.has_spot = false;
    picture made = take_picture(&scene, 81, 60);
    expected e = expect(&scene, 81, 60);
    assert_int_equal(e.light_count, 2 + 1 + 3 + 1 + 1);
    compare_lights(&made, &e);
    assert_true(compare(&made, e.depths, (const double(*)[3])e.rgb).rel < 1e-4);
    forget(&made);
    forget_expected(&e);
    render_scene_free(&scene);
}

#endif

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_stored),
#ifdef HAVE_EMBREE
        cmocka_unit_test(test_stored_is_reproduced),
        cmocka_unit_test(test_views),
        cmocka_unit_test(test_area_lights),
#endif
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
