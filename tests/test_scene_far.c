/* Scenes far from the origin, like maps: what is read and rendered is the scene near it. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "base/exr.h"
#include "base/file.h"
#include "capture.h"
#include "program.h"
#include "render/scene.h"
#include "work.h"

/* Eighths and whole numbers: a double holds them at 1e7 too. */
static void write_scene(const char *name, double x, double y, double z, bool placed)
{
    char text[4096], lights[2048] = "";
    const char *root = base_source_root();
    if (placed)
        snprintf(lights, sizeof lights,
                 ", \"camera\": {\"eye\": [%.17g, %.17g, %.17g], \"target\": [%.17g, %.17g, %.17g],"
                 " \"near\": 0.0625, \"far\": 16}, \"spot\": {\"position\": [%.17g, %.17g, %.17g],"
                 " \"target\": [%.17g, %.17g, %.17g], \"angle_deg\": 60, \"intensity\": 20},"
                 " \"area_lights\": [{\"exitance\": 5, \"vertices\": [[%.17g, %.17g, %.17g],"
                 " [%.17g, %.17g, %.17g], [%.17g, %.17g, %.17g]]}]",
                 x, y + 1, z + 3.375, x, y + 1, z, x + 0.5, y + 1.75, z + 0.875, x - 0.625, y,
                 z - 0.5, x, y + 1.875, z, x + 0.5, y + 1.875, z, x, y + 1.875, z + 0.5);
    snprintf(text, sizeof text,
             "{\"meshes\": [{\"file\": \"%s/tests/scenes/room.obj\", \"translate\": "
             "[%.17g, %.17g, %.17g]}, {\"file\": \"%s/tests/scenes/room.obj\", \"scale\": 0.35, "
             "\"translate\": [%.17g, %.17g, %.17g], \"albedo\": 0.75}]%s}",
             root, x, y, z, root, x - 0.5, y + 0.375, z + 0.25, lights);
    workspace_write(&work, name, text);
}

static render_scene read_at(double x, double y, double z, bool placed)
{
    render_scene scene;
    write_scene("scene.json", x, y, z, placed);
    assert_true(render_scene_read(workspace_path(&work, "scene.json"), NULL, &scene));
    return scene;
}

static void assert_same(const render_scene *found, const render_scene *expected)
{
    assert_int_equal(found->vertex_count, expected->vertex_count);
    assert_int_equal(found->triangle_count, expected->triangle_count);
    assert_memory_equal(found->positions, expected->positions, 12 * expected->vertex_count);
    assert_memory_equal(found->normals, expected->normals, 12 * expected->vertex_count);
    assert_memory_equal(found->indices, expected->indices, 12 * expected->triangle_count);
    assert_memory_equal(found->low, expected->low, sizeof found->low);
    assert_memory_equal(found->high, expected->high, sizeof found->high);
    assert_memory_equal(&found->camera, &expected->camera, sizeof found->camera);
    assert_memory_equal(&found->spot, &expected->spot, sizeof found->spot);
    assert_int_equal(found->area_light_count, expected->area_light_count);
    if (found->area_light_count)
        assert_memory_equal(found->area_lights, expected->area_lights, sizeof *found->area_lights);
}

/* Moved by any round distance nothing but the origin differs, to the bit: what the description
 * places, and camera and spot that follow from the bounds. */
static void test_moved(void **state)
{
    (void)state;
    static const double offsets[][3] = {{1e3, 1e5, -1e3}, {1e6, 1e6, -1e6}, {-1e7, 50, 1e7}};
    for (int placed = 0; placed < 2; placed++) {
        render_scene near = read_at(0, 0, 0, placed);
        for (size_t i = 0; i < sizeof offsets / sizeof *offsets; i++) {
            const double *o = offsets[i];
            render_scene far = read_at(o[0], o[1], o[2], placed);
            for (int k = 0; k < 3; k++)
                assert_true(near.origin[k] == 0 && far.origin[k] == o[k]);
            assert_same(&far, &near);
            render_scene_free(&far);
        }
        render_scene_free(&near);
    }
}

/* Up to 16 radii, here of the square root of 3, coordinates stay the description's. */
static void test_near(void **state)
{
    (void)state;
    static const double away[] = {27, 29, -29};
    for (size_t i = 0; i < sizeof away / sizeof *away; i++) {
        render_scene scene = read_at(away[i], 0, 0, true);
        bool moved = fabs(away[i]) > 16 * sqrt(3);
        assert_true(scene.origin[0] == (moved ? copysign(30, away[i]) : 0));
        assert_true(scene.origin[1] == 0 && scene.origin[2] == 0);
        assert_true(scene.low[0] == away[i] - 1 - scene.origin[0]);
        assert_true(scene.camera.eye[0] == away[i] - scene.origin[0]);
        assert_true(scene.area_lights[0].corners[1][0] == away[i] + 0.5 - scene.origin[0]);
        render_scene_free(&scene);
    }
}

/* Coordinates of the mesh's file itself; sizes from a tenth of a millimetre to 2000 km; scenes that
 * have none. */
static void test_extents(void **state)
{
    (void)state;
    static const struct {
        const char *keys;
        double low; /* of x in the description */
    } cases[] = {
        {"", 1e6},
        {", \"scale\": 0.0001", 100},
        {", \"scale\": [-1e6, 1e6, 1e6]", -1.000001e12},
        {", \"scale\": 0.0001, \"translate\": [1000, 0, 0]", 1100},
        {", \"translate\": [-1e6, 0, 0]", 0},
    };
    workspace_write(&work, "map.obj",
                    "v 1000000 0 0\nv 1000001 0 0\nv 1000000 1 0\nv nan 0 0\nf 1 2 3\nf 1 2 4\n");
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        char text[256];
        snprintf(text, sizeof text, "{\"meshes\": [{\"file\": \"map.obj\"%s}]}", cases[i].keys);
        render_scene scene;
        workspace_write(&work, "scene.json", text);
        assert_true(render_scene_read(workspace_path(&work, "scene.json"), NULL, &scene));
        assert_int_equal(scene.triangle_count, 1);
        double size = scene.high[0] - scene.low[0];
        /* near the origin, where it was, and not moved without need */
        if (!(fabs(scene.low[0]) <= 1.01 * size) ||
            !(fabs(scene.origin[0] + scene.low[0] - cases[i].low) <= 1e-6 * size) ||
            (cases[i].low == 0 && scene.origin[0] != 0))
            fail_msg("%s: origin %.17g, low %.9g", cases[i].keys, scene.origin[0], scene.low[0]);
        render_scene_free(&scene);
    }
    workspace_write(&work, "scene.json", "{\"meshes\": []}");
    render_scene empty;
    assert_true(render_scene_read(workspace_path(&work, "scene.json"), NULL, &empty));
    assert_true(empty.origin[0] == 0 && empty.high[0] == 0);
    render_scene_free(&empty);
}

/* What floats cannot compute with is refused, told with the length that is too much. */
static void test_beyond(void **state)
{
    (void)state;
    static const char *const cases[][2] = {{"1e20", "found 1e+20"},
                                           {"-3e15", "found 3e+15"},
                                           {"1e10", "found 7.07e+09"},
                                           {"1e-7", "found 7.07e-08"}};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        char text[256];
        snprintf(text, sizeof text, "v %s 0 0\nv 0 %s 0\nv 0 0 0\nf 1 2 3\n", cases[i][0],
                 cases[i][0]);
        workspace_write(&work, "beyond.obj", text);
        workspace_write(&work, "scene.json", "{\"meshes\": [{\"file\": \"beyond.obj\"}]}");
        render_scene scene;
        capture c;
        capture_begin(&c);
        bool good = render_scene_read(workspace_path(&work, "scene.json"), NULL, &scene);
        assert_one_line(capture_end(&c), "scene.json", "\"meshes\"", cases[i][1]);
        assert_false(good);
    }
    workspace_write(&work, "scene.json",
                    "{\"meshes\": [{\"file\": \"beyond.obj\", \"scale\": 1e7}]}");
    render_scene scene;
    assert_true(render_scene_read(workspace_path(&work, "scene.json"), NULL, &scene));
    render_scene_free(&scene);
}

/* Whether an EXR file has a text attribute of that name. */
static bool has_origin(const char *bytes, size_t size)
{
    static const char attribute[] = "origin\0string";
    for (size_t i = 0; i + sizeof attribute <= size; i++)
        if (memcmp(bytes + i, attribute, sizeof attribute) == 0)
            return true;
    return false;
}

/* Pictures are equal to the bit; files say from where positions count. */
static void test_pictures(void **state)
{
    (void)state;
    float *layers[2][2];
    char *bytes[2];
    size_t sizes[2];
    for (int far = 0; far < 2; far++) {
        char name[32], file[1100], description[1100];
        snprintf(name, sizeof name, "%d.exr", far);
        snprintf(file, sizeof file, "%s", workspace_path(&work, name));
        write_scene("scene.json", far * 1e5, 0, far * -1e5, true);
        snprintf(description, sizeof description, "%s", workspace_path(&work, "scene.json"));
        run r = program_run((const char *const[]){"render", "--scene", description, "--size",
                                                  "48x27", "--pipeline", "exact", "--layers",
                                                  "--out", file, NULL},
                            NULL);
        if (r.status == 1 && strstr(r.error, "no Vulkan") && !getenv("CI")) {
            fprintf(stderr, "skipped: %s", r.error);
            skip();
        }
        assert_int_equal(r.status, 0);
        const char *origin = strstr(r.out, "\"origin\": [");
        assert_non_null(origin);
        assert_true((strtod(strchr(origin, '[') + 1, NULL) == 1e5) == far);
        run_free(&r);
        layers[far][0] = exr_read(file, "R", &(int){0}, &(int){0});
        layers[far][1] = exr_read(file, "position.X", &(int){0}, &(int){0});
        bytes[far] = workspace_read_path(file, &sizes[far]);
    }
    int lit = 0;
    for (int i = 0; i < 48 * 27; i++)
        lit += layers[0][0][i] > 0;
    assert_true(lit > 500);
    for (int k = 0; k < 2; k++)
        assert_memory_equal(layers[1][k], layers[0][k], 48 * 27 * sizeof(float));
    assert_true(!has_origin(bytes[0], sizes[0]) && has_origin(bytes[1], sizes[1]));
    for (int far = 0; far < 2; far++) {
        free(layers[far][0]);
        free(layers[far][1]);
        free(bytes[far]);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_moved), cmocka_unit_test(test_near), cmocka_unit_test(test_extents),
        cmocka_unit_test(test_beyond), cmocka_unit_test(test_pictures)};
    return cmocka_run_group_tests(tests, open_work, close_work);
}
