/* Scene descriptions that are refused: each in one line that names the file and the key. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "capture.h"
#include "mesh_files.h"
#include "mutate.h"
#include "render/scene.h"
#include "workspace.h"

static workspace work;

static void test_refusals(void **state)
{
    (void)state;
    static const char *const cases[][2] = {
        {"{}", "\"meshes\""},
        {"[]", "object"},
        {"{\"meshes\": {}}", "\"meshes\""},
        {"{\"meshes\": [], \"lights\": []}", "\"lights\""},
        {"{\"meshes\": [], \"meshes\": []}", "\"meshes\""},
        {"{\"meshes\": [3]}", "meshes[0]"},
        {"{\"meshes\": [{}]}", "meshes[0].file"},
        {"{\"meshes\": [{\"file\": \"\"}]}", "meshes[0].file"},
        {"{\"meshes\": [{\"file\": \"t.obj\", \"color\": 1}]}", "\"color\""},
        {"{\"meshes\": [{\"file\": \"t.obj\", \"scale\": 0}]}", "meshes[0].scale"},
        {"{\"meshes\": [{\"file\": \"t.obj\", \"scale\": [1, 2]}]}", "meshes[0].scale"},
        {"{\"meshes\": [{\"file\": \"t.obj\", \"scale\": [1, 0, 2]}]}", "meshes[0].scale"},
        {"{\"meshes\": [{\"file\": \"t.obj\", \"scale\": \"1\"}]}", "meshes[0].scale"},
        {"{\"meshes\": [{\"file\": \"t.obj\", \"scale\": \"nan\"}]}", "meshes[0].scale"},
        {"{\"meshes\": [{\"file\": \"t.obj\", \"scale\": 1e300}]}", "meshes[0].scale"},
        {"{\"meshes\": [{\"file\": \"t.obj\"}, {\"file\": \"t.obj\", \"rotate_deg\": 90}]}",
         "meshes[1].rotate_deg"},
        {"{\"meshes\": [{\"file\": \"t.obj\", \"translate\": [0, 1, null]}]}",
         "meshes[0].translate"},
        {"{\"meshes\": [{\"file\": \"t.obj\", \"albedo\": 1.5}]}", "meshes[0].albedo"},
        {"{\"meshes\": [{\"file\": \"t.obj\", \"albedo\": [0.5, -0.1, 0]}]}", "meshes[0].albedo"},
        {"{\"meshes\": [], \"camera\": []}", "\"camera\""},
        {"{\"meshes\": [], \"camera\": null}", "\"camera\""},
        {"{\"meshes\": [], \"camera\": {\"fov\": 45}}", "\"fov\""},
        {"{\"meshes\": [], \"camera\": {\"eye\": [1, 2]}}", "camera.eye"},
        {"{\"meshes\": [], \"camera\": {\"eye\": [1, 2, \"inf\"]}}", "camera.eye"},
        {"{\"meshes\": [], \"camera\": {\"eye\": [1, 2, 3], \"target\": [1, 2, 3]}}",
         "camera.target"},
        {"{\"meshes\": [], \"camera\": {\"up\": [0, 0, 0]}}", "camera.up"},
        {"{\"meshes\": [], \"camera\": {\"eye\": [0, 3, 0], \"up\": [0, 1, 0]}}", "camera.up"},
        {"{\"meshes\": [], \"camera\": {\"fov_y_deg\": 0}}", "camera.fov_y_deg"},
        {"{\"meshes\": [], \"camera\": {\"fov_y_deg\": 180}}", "camera.fov_y_deg"},
        {"{\"meshes\": [], \"camera\": {\"near\": 0}}", "camera.near"},
        {"{\"meshes\": [], \"camera\": {\"near\": 5, \"far\": 5}}", "camera.near"},
        {"{\"meshes\": [], \"camera\": {\"far\": -1}}", "camera.far"},
        {"{\"meshes\": [], \"spot\": 1}", "\"spot\""},
        {"{\"meshes\": [], \"spot\": {\"power\": 1}}", "\"power\""},
        {"{\"meshes\": [], \"spot\": {\"position\": [1, 1, 1], \"target\": [1, 1, 1]}}",
         "spot.target"},
        {"{\"meshes\": [], \"spot\": {\"angle_deg\": 0}}", "spot.angle_deg"},
        {"{\"meshes\": [], \"spot\": {\"angle_deg\": 180}}", "spot.angle_deg"},
        {"{\"meshes\": [], \"spot\": {\"intensity\": -1}}", "spot.intensity"},
        {"{\"meshes\": [], \"spot\": {\"intensity\": [1, 2, 3, 4]}}", "spot.intensity"},
        {"{\"meshes\": [], \"rsm_size\": 0}", "\"rsm_size\""},
        {"{\"meshes\": [], \"rsm_size\": 129}", "\"rsm_size\""},
        {"{\"meshes\": [], \"rsm_size\": 16.5}", "\"rsm_size\""},
        {"{\"meshes\": [], \"rsm_size\": true}", "\"rsm_size\""},
        {"{\"meshes\": [], \"area_lights\": {}}", "\"area_lights\""},
        {"{\"meshes\": [], \"area_lights\": [1]}", "area_lights[0]"},
        {"{\"meshes\": [], \"area_lights\": [{\"exitance\": 1}]}", "area_lights[0].vertices"},
        {"{\"meshes\": [", "line 1"},
        {"", "line 1"},
    };
    workspace_write(&work, "t.obj", mesh_file_obj);
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        render_scene scene;
        capture c;
        workspace_write(&work, "scene.json", cases[i][0]);
        capture_begin(&c);
        bool good = render_scene_read(workspace_path(&work, "scene.json"), NULL, &scene);
        const char *text = capture_end(&c);
        if (good || !is_one_line(text, (const char *const[]){"scene.json", cases[i][1], NULL}))
            fail_msg("%s", cases[i][0]);
        assert_null(scene.positions);
        assert_null(scene.area_lights);
    }
}

/* Polygons: each of these is not flat, not convex, without area, or no polygon. */
static void test_polygons(void **state)
{
    (void)state;
    static const struct {
        const char *vertices;
        bool good;
    } cases[] = {
        {"[[0,0,0],[1,0,0],[0,1,0]]", true},
        {"[[0,0,0],[1e-6,0,0],[0,1e-6,0]]", true},
        {"[[5,5,5],[6,5,5],[6,5,6],[5.5,5,7],[5,5,6]]", true},
        {"[[0,0,0],[1,0,0],[2,0,0],[0,1,0]]", true}, /* a corner on an edge */
        {"[[0,0,0],[1,0,0]]", false},
        {"[[0,0,0],[1,0,0],[2,0,0]]", false},
        {"[[0,0,0],[0,0,0],[0,0,0]]", false},
        {"[[0,0,0],[1,0,0],[1,0,0],[0,1,0]]", false},
        {"[[0,0,0],[1,0,0],[1,1,0.1],[0,1,0]]", false},               /* bent */
        {"[[0,0,0],[1,0,0],[0.2,0.2,0],[0,1,0]]", false},             /* concave */
        {"[[0,0,0],[1,1,0],[1,0,0],[0,1,0]]", false},                 /* a bow */
        {"[[0,0,0],[1,0,0],[0,1,0],[0,0,0],[1,0,0],[0,1,0]]", false}, /* twice round */
        {"[[0,1,0],[-0.59,-0.81,0],[0.95,0.31,0],[-0.95,0.31,0],[0.59,-0.81,0]]", false},
        {"[[0,0,0],[1,0,0],[2,0,0],[2,1,0],[2,2,0],[1,2,0],[0,2,0],[0,1,0],[0,0.5,0]]", false},
        {"[[0,0,0],[1,0,0],[0,1]]", false},
        {"[[0,0,0],[1,0,0],[0,1,\"0\"]]", false},
        {"[[0,0,0],[1,0,0],[0,1e200,0]]", false}};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        char text[512];
        render_scene scene;
        capture c;
        snprintf(text, sizeof text,
                 "{\"meshes\": [], \"area_lights\": [{\"vertices\": [[0,0,0],[1,0,0],[0,1,0]], "
                 "\"exitance\": 0}, {\"vertices\": %s, \"exitance\": 1}]}",
                 cases[i].vertices);
        workspace_write(&work, "scene.json", text);
        capture_begin(&c);
        bool good = render_scene_read(workspace_path(&work, "scene.json"), NULL, &scene);
        const char *said = capture_end(&c);
        if (good != cases[i].good)
            fail_msg("%s is %s", cases[i].vertices, good ? "taken" : said);
        if (!good)
            assert_one_line(said, "scene.json", "area_lights[1].vertices");
        render_scene_free(&scene);
    }
}

/* Found beside the description, in the given folder, in SGFIT_SCENES, or named in the refusal. */
static void test_search(void **state)
{
    (void)state;
    char folder[1024];
    snprintf(folder, sizeof folder, "%s", workspace_path(&work, "meshes"));
    assert_int_equal(shell("mkdir -p '%s/sub'", folder), 0);
    workspace_write(&work, "meshes/sub/far.obj", mesh_file_obj);
    workspace_write(&work, "far.json", "{\"meshes\": [{\"file\": \"sub/far.obj\"}]}");
    render_scene scene;
    const char *path = workspace_path(&work, "far.json");
    capture c;
    unsetenv("SGFIT_SCENES");
    capture_begin(&c);
    assert_false(render_scene_read(path, NULL, &scene));
    assert_one_line(capture_end(&c), "far.json", "meshes[0].file", "sub/far.obj", "SGFIT_SCENES");
    assert_true(render_scene_read(path, folder, &scene));
    render_scene_free(&scene);
    setenv("SGFIT_SCENES", folder, 1);
    assert_true(render_scene_read(path, NULL, &scene));
    assert_int_equal(scene.triangle_count, 4);
    render_scene_free(&scene);
    capture_begin(&c);
    assert_false(render_scene_read(path, "/nonexistent", &scene));
    assert_one_line(capture_end(&c), "sub/far.obj", "/nonexistent");
    unsetenv("SGFIT_SCENES");
}

/* A damaged description ends in a scene or in one line. */
static void test_damage(void **state)
{
    (void)state;
    static const char text[] =
        "{\"meshes\": [],\n \"camera\": {\"eye\": [0, 1, 3], \"target\": [0, 1, 0], \"up\": [0, 1, "
        "0],"
        "\n \"fov_y_deg\": 45, \"near\": 0.1, \"far\": 100},\n \"spot\": {\"position\": [1, 2, 3], "
        "\"target\": [0, 0, 0], \"angle_deg\": 60,\n \"intensity\": [1, 2, 3]}, \"area_lights\": "
        "[{\"vertices\": [[0, 0, 0], [1, 0, 0], [0, 1, 0]], \"exitance\": 4}], \"rsm_size\": 8}\n";
    static char bytes[MOST];
    random_state = 0xd1b54a32d192ed03u;
    int taken = 0;
    for (int i = 0; i < 1000; i++) {
        size_t size = mutate(text, bytes);
        const char *path = workspace_path(&work, "scene.json");
        FILE *file = fopen(path, "wb");
        assert_non_null(file);
        fwrite(bytes, 1, size, file);
        fclose(file);
        render_scene scene;
        capture c;
        capture_begin(&c);
        bool good = render_scene_read(path, NULL, &scene);
        const char *said = capture_end(&c);
        if (!good)
            assert_one_line(said, "scene.json");
        taken += good;
        render_scene_free(&scene);
    }
    assert_in_range(taken, 1, 999);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_refusals), cmocka_unit_test(test_polygons),
        cmocka_unit_test(test_search), cmocka_unit_test(test_damage)};
    workspace_open(&work);
    int failed = cmocka_run_group_tests(tests, NULL, NULL);
    workspace_close(&work);
    return failed;
}
