/* The lobes of hull_lobe: moved so that they give the irradiance at normals around the vertex's
 * own, not only what their moments say. */
#include "render_fixture.h"

#include "render/hull_private.h"
#include "sg.h"

enum { WIDTH = 192, HEIGHT = 128 };

/* Of a vertex at a pixel of these two, as vertex_normal in shaders/hull/vertex_kind.glsl. */
static void vertex_normal(const uint32_t both[2], double n[3])
{
    float shading[3], face[3];
    unpack_normal(both[0], shading);
    unpack_normal(both[1], face);
    bool alike = shading[0] * face[0] + shading[1] * face[1] + shading[2] * face[2] > 0.97F;
    for (int i = 0; i < 3; i++)
        n[i] = (double)(alike ? shading : face)[i];
}

/* The four normals of shaders/hull/tilted.glsl. */
static void tilted_normals(const double n[3], double tilted[4][3])
{
    const double tilt = 0.5;
    double up[3] = {0, 1, 0}, right[3] = {1, 0, 0}, side[2][3];
    fixture_cross(fabs(n[1]) < 0.8 ? up : right, n, side[0]);
    fixture_unit(side[0]);
    fixture_cross(n, side[0], side[1]);
    for (int j = 0; j < 4; j++)
        for (int i = 0; i < 3; i++)
            tilted[j][i] =
                sqrt(1 - tilt * tilt) * n[i] + (j % 2 == 0 ? tilt : -tilt) * side[j / 2][i];
}

/* What the lobes of a vertex (struct Vertex in shaders/hull/vertex_lobe.glsl) give at n, mean of
 * the colours, by the reference. */
static double lobes_at(const float *vertex, const double n[3])
{
    double sum = 0;
    for (int k = 0; k < HULL_LOBE_COUNT; k++) {
        const float *first = vertex + 4 * k;
        const float *rest = vertex + 4 * HULL_LOBE_COUNT + 2 * k;
        double flux = ((double)first[3] + (double)rest[0] + (double)rest[1]) / 3;
        double axis[3] = {(double)first[0], (double)first[1], (double)first[2]};
        double size = sqrt(fixture_dot(axis, axis)), r = fmin(size / flux, 0.9999);
        if (!(flux > 0 && size > 0))
            continue;
        sum += flux * sg_L_cos(r * (3 - r * r) / (1 - r * r), fixture_dot(axis, n) / size);
    }
    return sum;
}

/* What the vertices miss of the irradiance at the normals around, over that. */
static double missed(const hull *h, const uint32_t *normals)
{
    uint32_t count =
        ((const uint32_t *)gpu_buffer_map(h->buffers[HULL_B_CONTROL]))[HULL_VERTEX_COUNT];
    const uint32_t *pixels = gpu_buffer_map(h->buffers[HULL_B_VERTEX_PIXELS]);
    const float *vertices = gpu_buffer_map(h->buffers[HULL_B_VERTICES]);
    const float *wanted = gpu_buffer_map(h->buffers[HULL_B_TILTED]);
    double square = 0, all = 0;
    assert_true(count > 50);
    for (uint32_t i = 0; i < count; i++) {
        double n[3], tilted[4][3];
        vertex_normal(normals + 2 * ((pixels[i] >> 16) * WIDTH + (pixels[i] & 0xffffU)), n);
        tilted_normals(n, tilted);
        for (uint32_t j = 0; j < 4; j++) {
            double w = (double)wanted[4 * i + j],
                   d = lobes_at(vertices + (size_t)i * HULL_VERTEX_BYTES / 4, tilted[j]) - w;
            square += d * d;
            all += w * w;
        }
    }
    assert_true(all > 0);
    return sqrt(square / all);
}

static void lobes_give_the_irradiance_around(void **state)
{
    static uint32_t normals[2 * WIDTH * HEIGHT];
    fixture f;
    fixture_make(&f);
    render_frame frame;
    make_frame(state, &f,
               (render_options){.width = WIDTH, .height = HEIGHT, .detailed_normals = true},
               &frame);
    render_statistics statistics = {0};
    hull_settings settings = hull_lobe_standard;
    settings.split = 1e9F; /* one level: nothing is blended */
    void *hull_state;
    check(hull_create(&frame, &settings, &hull_state));
    check(hull_run(&frame, hull_state, &statistics));
    check(gpu_image_read(frame.normal, normals));
    double around = missed(hull_state, normals);
    if (!(around < 0.01)) /* 0.015 by their moments alone */
        fail_msg("lobes miss %g of the irradiance around", around);
    hull_destroy(hull_state);
    render_frame_destroy(&frame);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(lobes_give_the_irradiance_around)};
    return cmocka_run_group_tests(tests, open_device, close_device);
}
