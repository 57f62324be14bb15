/* The G-buffer of a small scene against rays through the pixels. */
#include "render_reference.h"

enum { WIDTH = 60, HEIGHT = 34, PIXELS = WIDTH * HEIGHT };

static const render_options small = {.width = WIDTH, .height = HEIGHT};

static void the_gbuffer_agrees_with_rays(void **state)
{
    fixture f;
    fixture_make(&f);
    render_frame frame;
    make_frame(state, &f, small, &frame);
    static float positions[4 * PIXELS];
    static uint32_t normals[2 * PIXELS];
    static uint8_t albedos[4 * PIXELS];
    check(gpu_image_read(frame.position, positions));
    check(gpu_image_read(frame.normal, normals));
    check(gpu_image_read(frame.albedo, albedos));
    int checked = 0, seen[FIXTURE_MOST] = {0}, empty = 0;
    for (int i = 0; i < PIXELS; i++) {
        double along[3], depth, edge;
        ray_of_pixel(&f.scene.camera, i % WIDTH, i / WIDTH, WIDTH, HEIGHT, along);
        int triangle = fixture_trace(&f, f.scene.camera.eye, along, &depth, &edge);
        if (edge < 1e-3)
            continue;
        checked++;
        const float *position = positions + 4 * i;
        if (triangle < 0) {
            assert_true(position[3] == 0);
            empty++;
            continue;
        }
        seen[triangle] = 1;
        assert_near((double)position[3], depth, 2e-5 * depth);
        for (int k = 0; k < 3; k++) {
            double expected = f.scene.camera.eye[k] + depth * along[k];
            assert_near((double)position[k], expected, 2e-5 * depth);
            double albedo = (double)f.albedos[3 * f.materials[triangle] + (uint32_t)k];
            assert_near(albedos[4 * i + k] / 255.0, albedo, 0.51 / 255);
        }
        double normal[3];
        fixture_face(&f, (size_t)triangle, normal);
        double turned = fixture_dot(normal, along) > 0 ? -1 : 1;
        for (int which = 0; which < 2; which++) {
            float n[3];
            unpack_normal(normals[2 * i + which], n);
            for (int k = 0; k < 3; k++)
                assert_near((double)n[k], turned * normal[k], 1e-4);
        }
    }
    assert_true(checked > PIXELS * 8 / 10);
    assert_true(empty > 0);
    for (size_t t = 0; t < f.scene.triangle_count; t++)
        assert_true(seen[t]);
    render_frame_destroy(&frame);
}

/* The leaning triangle with one smooth normal that is the same everywhere. */
static void shading_normals_are_the_meshs(void **state)
{
    fixture f;
    fixture_make(&f);
    double wanted[3] = {0.1, 0.3, 1};
    fixture_unit(wanted);
    size_t last = f.scene.triangle_count - 1;
    for (size_t i = 0; i < 9; i++)
        f.normals[9 * last + i] = -3 * (float)wanted[i % 3]; /* neither unit nor turned */
    render_frame frame;
    make_frame(state, &f, small, &frame);
    static uint8_t albedos[4 * PIXELS];
    static uint32_t normals[2 * PIXELS];
    check(gpu_image_read(frame.albedo, albedos));
    check(gpu_image_read(frame.normal, normals));
    int count = 0;
    double face[3];
    fixture_face(&f, last, face);
    for (int i = 0; i < PIXELS; i++) {
        float shading[3], geometric[3];
        unpack_normal(normals[2 * i], shading);
        unpack_normal(normals[2 * i + 1], geometric);
        double other[3] = {(double)geometric[0], (double)geometric[1], (double)geometric[2]};
        if (albedos[4 * i] != 255 || fabs(fabs(fixture_dot(face, other)) - 1) > 1e-6)
            continue;
        count++;
        for (int k = 0; k < 3; k++)
            assert_near((double)shading[k], wanted[k], 1e-4);
    }
    assert_true(count > 50);
    render_frame_destroy(&frame);
}

static void detail_tilts_shading_normals_only(void **state)
{
    fixture f;
    fixture_make(&f);
    render_frame frame;
    render_options options = small;
    options.detailed_normals = true;
    make_frame(state, &f, options, &frame);
    static float positions[4 * PIXELS];
    static uint32_t normals[2 * PIXELS];
    check(gpu_image_read(frame.position, positions));
    check(gpu_image_read(frame.normal, normals));
    double squares = 0;
    int count = 0;
    for (int i = 0; i < PIXELS; i++) {
        if (!(positions[4 * i + 3] > 0))
            continue;
        float n[3], face[3];
        unpack_normal(normals[2 * i], n);
        unpack_normal(normals[2 * i + 1], face);
        double cosine = (double)(n[0] * face[0] + n[1] * face[1] + n[2] * face[2]);
        assert_true(cosine > 0.3);
        squares += pow(acos(fmin(cosine, 1)) * 180 / pi, 2);
        count++;
    }
    double tilt = sqrt(squares / count);
    if (!(tilt > 18 && tilt < 27))
        fail_msg("normals are tilted by %g degrees", tilt);
    render_frame_destroy(&frame);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_gbuffer_agrees_with_rays),
        cmocka_unit_test(shading_normals_are_the_meshs),
        cmocka_unit_test(detail_tilts_shading_normals_only),
    };
    return cmocka_run_group_tests(tests, open_device, close_device);
}
