/* Scene descriptions: what they mean, what is not given, what is refused. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "base/buffer.h"
#include "capture.h"
#include "mesh_files.h"
#include "render/scene.h"
#include "work.h"

static render_scene read_text(const char *text)
{
    render_scene scene;
    workspace_write(&work, "scene.json", text);
    assert_true(render_scene_read(workspace_path(&work, "scene.json"), NULL, &scene));
    return scene;
}

static void assert_near(double value, double expected)
{
    if (!(fabs(value - expected) <= 2e-6 * fmax(1, fabs(expected))))
        fail_msg("%.9g, expected %.9g", value, expected);
}

/* Scale first, then x, y, z rotations about fixed axes, then the translation: vertex (1, 0, 0). */
static void test_transform(void **state)
{
    (void)state;
    workspace_write(&work, "one.obj", "v 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 2 3\n");
    static const struct {
        const char *keys;
        double low[3], high[3];
    } cases[] = {
        {"", {0, 0, 0}, {1, 1, 1}},
        {",\"scale\": 2", {0, 0, 0}, {2, 2, 2}},
        {",\"scale\": [2, 3, -4], \"translate\": [10, 20, 30]", {10, 20, 26}, {12, 23, 30}},
        {",\"rotate_deg\": [90, 0, 0]", {0, -1, 0}, {1, 0, 1}},   /* y to z, z to -y */
        {",\"rotate_deg\": [0, 90, 0]", {0, 0, -1}, {1, 1, 0}},   /* z to x, x to -z */
        {",\"rotate_deg\": [0, 0, -270]", {-1, 0, 0}, {0, 1, 1}}, /* x to y, y to -x */
        {",\"rotate_deg\": [90, 90, 0]", {0, -1, -1}, {1, 0, 0}}, /* y to z to x; z to -y */
        {",\"rotate_deg\": [0, 0, 30], \"scale\": [2, 1, 1]",
         {-0.5, 0, 0},
         {1.7320508075688772, 1, 1}}};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        char text[256];
        snprintf(text, sizeof text, "{\"meshes\": [{\"file\": \"one.obj\"%s}]}", cases[i].keys);
        render_scene scene = read_text(text);
        assert_int_equal(scene.triangle_count, 1);
        for (int k = 0; k < 3; k++) {
            assert_near(scene.low[k], cases[i].low[k]);
            assert_near(scene.high[k], cases[i].high[k]);
        }
        /* the normal made for it is that of its plane and its corners run about it */
        double p[3][3], n[3];
        for (size_t v = 0; v < 3; v++)
            for (size_t k = 0; k < 3; k++)
                p[v][k] = (double)scene.positions[3 * scene.indices[v] + k];
        for (int k = 0; k < 3; k++) {
            int a = (k + 1) % 3, b = (k + 2) % 3;
            n[k] = (p[1][a] - p[0][a]) * (p[2][b] - p[0][b]) -
                   (p[1][b] - p[0][b]) * (p[2][a] - p[0][a]);
        }
        double length = sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
        for (int k = 0; k < 3; k++)
            assert_near((double)scene.normals[k], n[k] / length);
        render_scene_free(&scene);
    }
}

/* A mirroring scale turns corners so that the outside stays outside. */
static void test_mirror(void **state)
{
    (void)state;
    workspace_write(&work, "t.obj", mesh_file_obj);
    static const char *const scales[] = {"1", "-1", "[1, -2, 1]", "[-1, -1, 3]"};
    for (size_t i = 0; i < 4; i++) {
        char text[256];
        snprintf(text, sizeof text, "{\"meshes\": [{\"file\": \"t.obj\", \"scale\": %s}]}",
                 scales[i]);
        render_scene scene = read_text(text);
        double volume = 0;
        for (size_t t = 0; t < 4; t++) {
            const float *p[3];
            for (size_t k = 0; k < 3; k++)
                p[k] = &scene.positions[3 * scene.indices[3 * t + k]];
            volume += (double)(p[0][0] * (p[1][1] * p[2][2] - p[1][2] * p[2][1]) +
                               p[0][1] * (p[1][2] * p[2][0] - p[1][0] * p[2][2]) +
                               p[0][2] * (p[1][0] * p[2][1] - p[1][1] * p[2][0]));
        }
        assert_true(volume > 0.9);
        assert_int_equal(scene.vertex_count, 12); /* hard edges */
        render_scene_free(&scene);
    }
}

/* The sphere's normals are smooth, the mean of its faces': within the angle of a face. */
static void test_smooth_normals(void **state)
{
    (void)state;
    char path[1024];
    snprintf(path, sizeof path, "{\"meshes\": [{\"file\": \"%s/tests/scenes/sphere.obj\"}]}",
             getenv("SGFIT_ROOT"));
    render_scene scene = read_text(path);
    assert_int_equal(scene.triangle_count, 5120);
    assert_int_equal(scene.vertex_count, 2562); /* each shared by all its faces */
    for (size_t v = 0; v < scene.vertex_count; v++) {
        const float *p = &scene.positions[3 * v], *n = &scene.normals[3 * v];
        assert_true(p[0] * n[0] + p[1] * n[1] + p[2] * n[2] > 0.9995F);
    }
    render_scene_free(&scene);
}

/* Triangles that cannot be drawn are left out and counted, with the vertices that only they use. */
static void test_dropped(void **state)
{
    (void)state;
    workspace_write(&work, "bad.ply",
                    "ply\nformat ascii 1.0\nelement vertex 7\nproperty float x\nproperty float y\n"
                    "property float z\nelement face 6\nproperty list uchar int vertex_indices\n"
                    "end_header\n0 0 0\n1 0 0\n0 1 0\nnan 0 0\ninf 1 1\n2 0 0\n-1e38 1e38 3e38\n"
                    "3 0 1 2\n3 0 1 3\n3 1 2 4\n3 0 1 5\n3 1 1 2\n3 0 1 2\n");
    render_scene scene = read_text("{\"meshes\": [{\"file\": \"bad.ply\"}]}");
    assert_int_equal(scene.triangle_count, 2);
    assert_int_equal(scene.dropped_triangles, 4);
    assert_int_equal(scene.vertex_count, 3);
    assert_near(scene.high[0], 1);
    assert_near(scene.low[2], 0);
    for (size_t i = 0; i < 9; i++)
        assert_true(isfinite(scene.positions[i]) && isfinite(scene.normals[i]));
    render_scene_free(&scene);
}

/* In the unit cube of clip space: x and y in [-1, 1], depth in [0, 1]. */
static bool is_seen(const render_camera *camera, const double p[3])
{
    double m[4][4], clip[4];
    render_camera_matrix(camera, 1, m);
    for (int i = 0; i < 4; i++)
        clip[i] = m[i][0] * p[0] + m[i][1] * p[1] + m[i][2] * p[2] + m[i][3];
    return clip[3] > 0 && fabs(clip[0]) <= clip[3] && fabs(clip[1]) <= clip[3] && clip[2] >= 0 &&
           clip[2] <= clip[3];
}

/* Camera and spot that are not given see every corner of the bounds. */
static void test_defaults(void **state)
{
    (void)state;
    workspace_write(&work, "one.obj", "v 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 2 3\n");
    static const char *const keys[] = {
        "", ", \"translate\": [100, -20, 5]", ", \"scale\": [0.001, 0.0005, 0.01]",
        ", \"scale\": [1e-6, 30, 1e-6]", ", \"scale\": 1e4, \"rotate_deg\": [10, 20, 30]"};
    for (size_t i = 0; i < sizeof keys / sizeof *keys; i++) {
        char text[256];
        snprintf(text, sizeof text, "{\"meshes\": [{\"file\": \"one.obj\"%s}]}", keys[i]);
        render_scene scene = read_text(text);
        assert_int_equal(scene.rsm_size, 16);
        assert_string_equal(scene.name, "scene");
        assert_true(scene.has_spot);
        const render_spot *spot = &scene.spot;
        double along[3], squared = 0;
        for (int k = 0; k < 3; k++) {
            along[k] = spot->target[k] - spot->position[k];
            squared += along[k] * along[k];
        }
        assert_near(spot->intensity[1] / squared, 10);
        for (int corner = 0; corner < 8; corner++) {
            double p[3], dot = 0, length = 0;
            for (int k = 0; k < 3; k++) {
                p[k] = corner >> k & 1 ? scene.high[k] : scene.low[k];
                dot += (p[k] - spot->position[k]) * along[k];
                length += (p[k] - spot->position[k]) * (p[k] - spot->position[k]);
            }
            assert_true(is_seen(&scene.camera, p));
            double angle = acos(dot / sqrt(length * squared)) * 180 / acos(-1);
            assert_true(angle <= spot->angle_deg / 2 + 1e-6);
        }
        render_scene_free(&scene);
    }
    render_scene empty = read_text("{\"meshes\": []}");
    assert_int_equal(empty.triangle_count, 0);
    assert_true(is_seen(&empty.camera, (const double[3]){0, 0, 0}));
    render_scene_free(&empty);
}

static void test_lights(void **state)
{
    (void)state;
    static const char area[] = "{\"meshes\": [], \"area_lights\": [{\"vertices\": "
                               "[[0,1,0],[1,1,0],[1,1,1],[0,1,1]], \"exitance\": [1,2,3]}]%s}";
    char text[512];
    snprintf(text, sizeof text, area, "");
    render_scene scene = read_text(text);
    assert_false(scene.has_spot);
    assert_int_equal(scene.area_light_count, 1);
    assert_int_equal(scene.area_lights[0].corner_count, 4);
    assert_true(scene.area_lights[0].corners[2][2] == 1 && scene.area_lights[0].exitance[2] == 3);
    render_scene_free(&scene);
    snprintf(text, sizeof text, area, ", \"spot\": {\"angle_deg\": 30, \"intensity\": 7}");
    scene = read_text(text);
    assert_true(scene.has_spot && scene.spot.angle_deg == 30 && scene.spot.intensity[2] == 7);
    render_scene_free(&scene);
    scene = read_text("{\"meshes\": [], \"spot\": null}");
    assert_false(scene.has_spot);
    render_scene_free(&scene);

    buffer many = {0};
    buffer_add(&many, "{\"meshes\": [], \"area_lights\": [");
    for (int i = 0; i < 5000; i++)
        buffer_print(&many, "%s{\"vertices\": [[%d,0,0],[%d,1,0],[%d,0,1]], \"exitance\": 1}",
                     i ? "," : "", i, i, i);
    buffer_add(&many, "]}");
    scene = read_text(many.text);
    assert_int_equal(scene.area_light_count, 5000);
    assert_true(scene.area_lights[4999].corners[1][0] == 4999);
    render_scene_free(&scene);
    buffer_free(&many);
}

/* Row-major, Vulkan's clip space: right is +x, up is -y, near is depth 0, far is depth 1. */
static void test_camera_matrix(void **state)
{
    (void)state;
    const render_camera camera = {.eye = {1, 2, 3},
                                  .target = {1, 2, -7},
                                  .up = {0, 5, 0},
                                  .fov_y_deg = 90,
                                  .near = 0.5,
                                  .far = 20};
    static const double points[][3] = {{1, 2, 2.5}, {1, 2, -17}, {5, 2, 1}, {1, 4, 1}};
    static const double expected[][3] = {{0, 0, 0}, {0, 0, 1}, {1, 0, NAN}, {0, -1, NAN}};
    double m[4][4];
    render_camera_matrix(&camera, 2, m);
    for (int i = 0; i < 4; i++) {
        double clip[4];
        for (int k = 0; k < 4; k++)
            clip[k] =
                m[k][0] * points[i][0] + m[k][1] * points[i][1] + m[k][2] * points[i][2] + m[k][3];
        for (int k = 0; k < 3; k++)
            if (!isnan(expected[i][k]))
                assert_near(clip[k] / clip[3], expected[i][k]);
    }
}

/* Every description of the project that needs no mesh from elsewhere, and the default one. */
static void test_built_in(void **state)
{
    (void)state;
    char *path = render_scene_default();
    render_scene scene;
    assert_true(render_scene_read(path, NULL, &scene));
    assert_string_equal(scene.name, "box");
    assert_true(scene.triangle_count > 5000 && scene.dropped_triangles == 0 && scene.has_spot);
    assert_near(scene.high[1], 2);
    /* the red wall is red */
    size_t red = 0;
    for (size_t t = 0; t < scene.triangle_count; t++)
        red += scene.albedos[3 * scene.materials[t]] == 0.63F;
    assert_int_equal(red, 2);
    render_scene_free(&scene);
    free(path);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_transform),      cmocka_unit_test(test_mirror),
        cmocka_unit_test(test_smooth_normals), cmocka_unit_test(test_dropped),
        cmocka_unit_test(test_defaults),       cmocka_unit_test(test_lights),
        cmocka_unit_test(test_camera_matrix),  cmocka_unit_test(test_built_in)};
    return cmocka_run_group_tests(tests, open_work, close_work);
}
