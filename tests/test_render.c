/* Lighting a small scene: lights against formulas, ground truth against form factors in double
 * precision, counts, resolve. */
#include "render_reference.h"

enum { WIDTH = 60, HEIGHT = 34, PIXELS = WIDTH * HEIGHT };

static const render_options small = {.width = WIDTH, .height = HEIGHT};

/* ---- Lights -------------------------------------------------------------------------- */

static void shadow_map_texels_become_lights(void **state)
{
    fixture f;
    fixture_make(&f);
    render_frame frame;
    make_frame(state, &f, small, &frame);
    const light_data *lights = gpu_buffer_map(frame.lights);
    const render_spot *spot = &f.scene.spot;
    render_camera camera = {.fov_y_deg = spot->angle_deg, .up = {0, 1, 0}};
    memcpy(camera.eye, spot->position, sizeof camera.eye);
    memcpy(camera.target, spot->target, sizeof camera.target);
    int size = f.scene.rsm_size, at = 0, checked = 0;
    for (int i = 0; i < size * size; i++) {
        double along[3], distance, edge;
        ray_of_pixel(&camera, i % size, i / size, size, size, along);
        int triangle = fixture_trace(&f, spot->position, along, &distance, &edge);
        if (triangle < 0)
            continue;
        const light_data *light = &lights[at++];
        double corners[3][3], area = light_corners(light, corners);
        assert_near(area, (double)light->plane[3], 1e-5 * area);
        if (edge < 1e-3)
            continue;
        checked++;
        double normal[3], centre[3], length = sqrt(fixture_dot(along, along));
        fixture_face(&f, (size_t)triangle, normal);
        double cosine = fabs(fixture_dot(normal, along)) / length;
        /* solid angle of a texel: side^2 cos^3 of the angle to the axis, for small ones */
        double side = 2 * tan(spot->angle_deg * pi / 360) / size;
        double solid_angle = side * side / (length * length * length);
        double square = distance * distance * length * length;
        assert_near(area, solid_angle * square / cosine, 0.01 * area);
        for (int k = 0; k < 3; k++) {
            centre[k] = (corners[0][k] + corners[1][k] + corners[2][k]) / 3;
            assert_near(centre[k], spot->position[k] + distance * along[k], 1e-4);
            double turned = fixture_dot(normal, along) > 0 ? -1 : 1;
            assert_near((double)light->plane[k], turned * normal[k], 1e-4);
            const float *const channels[3] = {light->a, light->b, light->c};
            double albedo = (double)f.albedos[3 * f.materials[triangle] + (uint32_t)k];
            double expected = albedo * spot->intensity[k] * cosine / square;
            double rounding = 0.51 / 255 * spot->intensity[k] * cosine / square;
            assert_near((double)channels[k][3], expected, 0.01 * expected + rounding);
        }
    }
    assert_true(checked > size * size * 8 / 10);
    /* then the area light, as a fan of two */
    assert_int_equal(frame.light_count, at + 2);
    for (int i = 0; i < 2; i++) {
        double corners[3][3];
        assert_near(light_corners(&lights[at + i], corners), 0.5, 1e-6);
        assert_near((double)lights[at + i].plane[1], -1, 1e-6);
        assert_near((double)lights[at + i].a[3], 2, 0);
        assert_near((double)lights[at + i].b[3], 3, 0);
        assert_near((double)lights[at + i].c[3], 4, 0);
    }
    render_frame_destroy(&frame);
}

/* ---- Ground truth -------------------------------------------------------------------- */

static void exact_is_the_sum_of_form_factors(void **state)
{
    fixture f;
    fixture_make(&f);
    render_frame frame;
    make_frame(state, &f, small, &frame);
    static float positions[4 * PIXELS], light[4 * PIXELS], image[4 * PIXELS];
    static uint32_t normals[2 * PIXELS];
    static uint8_t albedos[4 * PIXELS];
    render_statistics statistics;
    light_with(&frame, "exact", &statistics, light);
    check(gpu_image_read(frame.position, positions));
    check(gpu_image_read(frame.normal, normals));
    check(gpu_image_read(frame.albedo, albedos));
    check(gpu_image_read(frame.image, image));
    const light_data *lights = gpu_buffer_map(frame.lights);
    uint64_t surfaces = 0;
    double worst = 0, brightest = 0;
    for (int i = 0; i < PIXELS; i++) {
        if (!(positions[4 * i + 3] > 0)) {
            for (int k = 0; k < 4; k++)
                assert_true(light[4 * i + k] == 0 && image[4 * i + k] == 0);
            continue;
        }
        surfaces++;
        assert_true(light[4 * i + 3] == 1);
        double sum[3];
        fixture_irradiance(lights, frame.light_count, positions + 4 * i, normals[2 * i], sum);
        for (int k = 0; k < 3; k++) {
            worst = fmax(worst, fabs((double)light[4 * i + k] - sum[k]));
            brightest = fmax(brightest, sum[k]);
            double radiance = albedos[4 * i + k] / 255.0 * (double)light[4 * i + k] / pi;
            assert_near((double)image[4 * i + k], radiance, 1e-5 * radiance);
        }
    }
    if (!(worst < 2e-4 * brightest) || !(brightest > 0))
        fail_msg("off by %g where the brightest is %g", worst, brightest);
    assert_int_equal(statistics.pixels_covered, surfaces);
    assert_int_equal(statistics.pixels_uncovered, 0);
    assert_int_equal(statistics.pixels_wrong, 0);
    assert_int_equal(statistics.lights, frame.light_count);
    assert_int_equal(statistics.triangles, f.scene.triangle_count);
    assert_int_equal(statistics.light_evaluations, surfaces * frame.light_count);
    assert_int_equal(statistics.ground_truth_evaluations, surfaces * frame.light_count);
    render_frame_destroy(&frame);
}

/* What lies below the horizon takes from the sum without a clip: never more, at many pixels about
 * the same (in the open), at many less. */
static void unclipped_differs_only_at_the_horizon(void **state)
{
    fixture f;
    fixture_make(&f);
    render_frame frame;
    make_frame(state, &f, small, &frame);
    static float clipped[4 * PIXELS], unclipped[4 * PIXELS];
    render_statistics statistics;
    light_with(&frame, "exact", &statistics, clipped);
    light_with(&frame, "exact_unclipped", &statistics, unclipped);
    int same = 0, less = 0;
    for (int i = 0; i < 4 * PIXELS; i++) {
        assert_true(unclipped[i] <= clipped[i] * 1.0001F + 1e-5F);
        same += i % 4 < 3 && clipped[i] > 0 && unclipped[i] > clipped[i] * 0.99F;
        less += unclipped[i] < clipped[i] * 0.98F;
    }
    if (!(same > PIXELS / 4 && less > PIXELS / 8))
        fail_msg("of %d values %d are the same and %d less", 3 * PIXELS, same, less);
    render_frame_destroy(&frame);
}

/* ---- Running ------------------------------------------------------------------------- */

static void the_same_input_gives_the_same_pixels(void **state)
{
    fixture f;
    fixture_make(&f);
    static float first[4 * PIXELS], second[4 * PIXELS];
    for (int run = 0; run < 2; run++) {
        render_frame frame;
        render_options options = small;
        options.runs = 3;
        make_frame(state, &f, options, &frame);
        render_statistics statistics;
        light_with(&frame, "exact", &statistics, run ? second : first);
        /* counted once, however many runs; every pass has its time */
        assert_int_equal(statistics.light_evaluations, statistics.ground_truth_evaluations);
        static const char *const names[] = {"gbuffer", "rsm", "exact", "resolve"};
        assert_int_equal(statistics.time_count, 4);
        for (int i = 0; i < 4; i++) {
            assert_string_equal(statistics.times[i].name, names[i]);
            assert_true(statistics.times[i].ms > 0);
        }
        render_frame_destroy(&frame);
    }
    assert_memory_equal(first, second, sizeof first);
}

static gpu_status create_nothing(render_frame *frame, void **state)
{
    (void)frame;
    *state = NULL;
    return GPU_OK;
}

static gpu_status light_upper_half(render_frame *frame, void *state, render_statistics *statistics)
{
    (void)state;
    (void)statistics;
    static float light[4 * PIXELS];
    memset(light, 0, sizeof light);
    for (int i = 0; i < PIXELS / 2; i++) {
        light[4 * i] = 1;
        light[4 * i + 3] = i % WIDTH == 0 ? -2 : 1;
    }
    return gpu_image_write(frame->light, light);
}

static void destroy_nothing(void *state)
{
    (void)state;
}

static void resolve_counts_what_was_lit(void **state)
{
    static const render_pipeline half = {.id = "half",
                                         .create = create_nothing,
                                         .run = light_upper_half,
                                         .destroy = destroy_nothing};
    fixture f;
    fixture_make(&f);
    render_frame frame;
    make_frame(state, &f, small, &frame);
    render_statistics statistics;
    check(render_frame_light(&frame, &half, &statistics));
    static float positions[4 * PIXELS], light[4 * PIXELS];
    check(gpu_image_read(frame.position, positions));
    check(gpu_image_read(frame.light, light));
    uint64_t counts[3] = {0, 0, 0};
    for (int i = 0; i < PIXELS; i++) {
        bool surface = positions[4 * i + 3] > 0, lit = i < PIXELS / 2, wrong = i % WIDTH == 0;
        counts[0] += surface && lit;
        counts[1] += surface && !lit;
        counts[2] += surface && lit && wrong;
        float state_of_pixel = !surface ? 0 : !lit ? -1 : wrong ? -2 : 1;
        assert_true(light[4 * i + 3] == state_of_pixel);
    }
    assert_true(counts[0] > 0 && counts[1] > 0 && counts[2] > 0);
    assert_int_equal(statistics.pixels_covered, counts[0]);
    assert_int_equal(statistics.pixels_uncovered, counts[1]);
    assert_int_equal(statistics.pixels_wrong, counts[2]);
    render_frame_destroy(&frame);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(shadow_map_texels_become_lights),
        cmocka_unit_test(exact_is_the_sum_of_form_factors),
        cmocka_unit_test(unclipped_differs_only_at_the_horizon),
        cmocka_unit_test(the_same_input_gives_the_same_pixels),
        cmocka_unit_test(resolve_counts_what_was_lit),
    };
    return cmocka_run_group_tests(tests, open_device, close_device);
}
