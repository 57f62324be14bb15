/* The reference of one diffuse bounce: a lit wall above a floor, against the sum of the form
 * factors of the wall's tiles. */
#include "render_reference.h"

#include "render/bounce.h"

enum { WIDTH = 24, HEIGHT = 16, PIXELS = WIDTH * HEIGHT, TILES = 24 };

/* A floor before a wall of 2 x 1 m, and a light that faces down. */
static void make_corner(fixture *f)
{
    fixture_make(f);
    f->scene.triangle_count = f->scene.vertex_count = 0;
    fixture_quad(f, (float[]){-1, 0, 1, 1, 0, 1, 1, 0, -1, -1, 0, -1}, 0);
    fixture_quad(f, (float[]){-1, 0, -1, 1, 0, -1, 1, 1, -1, -1, 1, -1}, 1);
    f->area =
        (render_area_light){.corner_count = 4,
                            .corners = {{0.5, 2, 0.6}, {-0.5, 2, 0.6}, {-0.5, 2, 0}, {0.5, 2, 0}},
                            .exitance = {2, 3, 4}};
    f->scene.camera = (render_camera){.eye = {0.1, 3, 2},
                                      .target = {0, 0, 0.1},
                                      .up = {0, 1, 0},
                                      .fov_y_deg = 35,
                                      .near = 0.1,
                                      .far = 20};
    f->scene.has_spot = false;
}

/* Form factor of a flat quadrilateral. */
static double factor_of(double c[4][3], const double x[3], const double n[3])
{
    double half[3][3];
    memcpy(half, c, sizeof half);
    double sum = fixture_form_factor(half, x, n);
    memcpy(half[1], c[2], sizeof half[1]);
    memcpy(half[2], c[3], sizeof half[2]);
    return sum + fixture_form_factor(half, x, n);
}

static void expect(const fixture *f, const float position[3], double sum[3])
{
    static const double up[3] = {0, 1, 0}, forth[3] = {0, 0, 1};
    double x[3] = {(double)position[0], (double)position[1], (double)position[2]}, light[4][3];
    memcpy(light, f->area.corners, sizeof light);
    sum[0] = sum[1] = sum[2] = 0;
    for (int i = 0; i < 2 * TILES; i++)
        for (int j = 0; j < TILES; j++) {
            double a = -1 + i / (double)TILES, b = j / (double)TILES, s = 1.0 / TILES;
            double tile[4][3] = {{a, b, -1}, {a + s, b, -1}, {a + s, b + s, -1}, {a, b + s, -1}};
            const double centre[3] = {a + s / 2, b + s / 2, -1};
            double both = factor_of(light, centre, forth) * factor_of(tile, x, up);
            for (int k = 0; k < 3; k++)
                sum[k] += (double)f->albedos[3 + k] * f->area.exitance[k] * both;
        }
}

static void paths_find_the_form_factors(void **state)
{
    fixture f;
    make_corner(&f);
    render_frame frame;
    make_frame(state, &f, (render_options){.width = WIDTH, .height = HEIGHT}, &frame);
    float *position = malloc(PIXELS * 16);
    check(gpu_image_read(frame.position, position));
    bounce b;
    check(bounce_render(&frame, &(bounce_options){.paths = 1024}, &b));
    assert_true(b.width == WIDTH && b.height == HEIGHT);
    double squares = 0, off = 0, mean = 0;
    int floor = 0;
    for (size_t i = 0; i < PIXELS; i++) {
        assert_true((b.irradiance[4 * i + 3] == 1) == (position[4 * i + 3] > 0));
        if (!(position[4 * i + 3] > 0) || fabs((double)position[4 * i + 1]) > 1e-4)
            continue;
        double sum[3];
        expect(&f, position + 4 * i, sum);
        for (size_t k = 0; k < 3; k++) {
            double difference = (double)b.irradiance[4 * i + k] - sum[k];
            double variance = (double)b.variance[3 * i + k];
            assert_near((double)b.irradiance[4 * i + k], sum[k],
                        0.01 * sum[k] + 5 * sqrt(variance));
            squares += variance > 0 ? difference * difference / variance : 0;
            off += difference;
            mean += sum[k];
        }
        floor++;
    }
    printf("%d places on the floor: mean off by %.2e of it, %.2f of the standard error\n", floor,
           off / mean, sqrt(squares / (3 * floor)));
    assert_true(floor > 100 && fabs(off) < 0.01 * mean);
    assert_true(squares < 3 * floor * 1.5); /* the standard error is no less than it says */
    bounce_free(&b);
    free(position);
    render_frame_destroy(&frame);
}

static void threads_change_nothing(void **state)
{
    fixture f;
    make_corner(&f);
    render_frame frame;
    make_frame(state, &f, (render_options){.width = WIDTH, .height = HEIGHT}, &frame);
    bounce one, three;
    check(bounce_render(&frame, &(bounce_options){.paths = 32, .step = 3, .threads = 1}, &one));
    check(bounce_render(&frame, &(bounce_options){.paths = 32, .step = 3, .threads = 3}, &three));
    assert_true(one.width == WIDTH / 3 && one.height == HEIGHT / 3);
    assert_memory_equal(one.irradiance, three.irradiance, (WIDTH / 3) * (HEIGHT / 3) * 16);
    assert_memory_equal(one.variance, three.variance, (WIDTH / 3) * (HEIGHT / 3) * 12);
    bounce_free(&one);
    bounce_free(&three);
    render_frame_destroy(&frame);
}

/* Differences of known size. */
static void comparisons_are_relative_to_the_mean(void **state)
{
    (void)state;
    float truth[8] = {2, 2, 2, 1, 9, 9, 9, 0}, variance[6] = {0.36F, 0.36F, 0.36F, 9, 9, 9};
    /* two places of a frame of 4 x 2 pixels, every second one */
    float light[32] = {0};
    for (int k = 0; k < 3; k++)
        light[4 * 5 + k] = 3;
    bounce b = {.width = 2, .height = 1, .irradiance = truth, .variance = variance};
    bounce_comparison c;
    bounce_compare(&b, light, 4, 2, &c);
    assert_near(c.mean, 2, 1e-6);
    assert_near(c.bias, 0.5, 1e-6);
    assert_near(c.noise, 0.3, 1e-6);
    assert_near(c.rel, 0.5, 1e-6);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(paths_find_the_form_factors),
        cmocka_unit_test(threads_change_nothing),
        cmocka_unit_test(comparisons_are_relative_to_the_mean),
    };
    return cmocka_run_group_tests(tests, open_device, close_device);
}
