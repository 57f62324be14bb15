/* Every pipeline on odd sizes and odd scenes: light is finite and not negative, every pixel with a
 * surface is accounted for, and the validation layer has nothing to say. */
#include <math.h>
#include <string.h>

#include "base/file.h"
#include "gpu_fixture.h"
#include "render/render.h"
#include "work.h"

/* One for all scenes: pipelines are compiled once for it. */
static gpu_device *device;

/* Of a frame. */
typedef struct seen {
    uint64_t surface; /* pixels */
    double sum;       /* of irradiance */
} seen;

static seen look(render_frame *frame, const render_pipeline *pipeline, const char *name)
{
    size_t pixels = (size_t)frame->width * frame->height;
    float *light = malloc(pixels * 16), *position = malloc(pixels * 16),
          *image = malloc(pixels * 16);
    render_statistics statistics;
    gpu_status status = render_frame_light(frame, pipeline, &statistics);
    if (status == GPU_UNSUPPORTED && frame->scene->area_light_count == 0) {
        /* pipelines for area lights alone say so */
        free(light);
        free(position);
        free(image);
        return (seen){0};
    }
    if (status != GPU_OK)
        fail_msg("%s, %s: %s", name, pipeline->id, gpu_last_error());
    assert_int_equal(gpu_image_read(frame->light, light), GPU_OK);
    assert_int_equal(gpu_image_read(frame->position, position), GPU_OK);
    assert_int_equal(gpu_image_read(frame->image, image), GPU_OK);
    seen s = {0};
    for (size_t i = 0; i < pixels; i++) {
        bool surface = position[4 * i + 3] > 0;
        float state = light[4 * i + 3];
        s.surface += surface;
        if (surface ? state != 1 && state != -1 && state != -2 : state != 0)
            fail_msg("%s, %s: pixel %zu %s a surface has the state %g", name, pipeline->id, i,
                     surface ? "with" : "without", (double)state);
        for (size_t c = 0; c < 3; c++) {
            /* not even the limit, which writes what it reads, may be truly negative */
            if (!(light[4 * i + c] >= -1e-30F) || !isfinite(light[4 * i + c]) ||
                !isfinite(image[4 * i + c]) || !isfinite(position[4 * i + c]))
                fail_msg("%s, %s: pixel %zu: %g", name, pipeline->id, i, (double)light[4 * i + c]);
            s.sum += surface ? (double)light[4 * i + c] : 0;
        }
    }
    if (statistics.pixels_covered + statistics.pixels_uncovered != s.surface ||
        statistics.triangles != frame->scene->triangle_count ||
        statistics.lights != frame->light_count)
        fail_msg("%s, %s: %llu pixels covered and %llu not, of %llu", name, pipeline->id,
                 (unsigned long long)statistics.pixels_covered,
                 (unsigned long long)statistics.pixels_uncovered, (unsigned long long)s.surface);
    free(light);
    free(position);
    free(image);
    return s;
}

/* Pipelines that run the shaders of another one with other sizes or signs. */
static bool is_variant(const char *id)
{
    static const char *const ids[] = {"exact_unclipped", "upsample2", "upsample8", "multires_same",
                                      "multires_apart"};
    for (size_t i = 0; i < sizeof ids / sizeof *ids; i++)
        if (strcmp(id, ids[i]) == 0)
            return true;
    return false;
}

/* One scene by all pipelines; every: by the variants too, and with detailed normals. What ground
 * truth saw. */
static seen look_by_all(const char *path, const char *name, uint32_t width, uint32_t height,
                        bool every)
{
    if (!device)
        device = open_software_device();
    render_scene scene;
    assert_true(render_scene_read(path, NULL, &scene));
    seen s = {0};
    const render_options options = {.width = width, .height = height, .detailed_normals = every};
    render_frame frame;
    if (render_frame_create(device, &scene, &options, &frame) != GPU_OK)
        fail_msg("%s: %s", name, gpu_last_error());
    for (int p = 0; render_pipelines[p]; p++) {
        bool truth = strcmp(render_pipelines[p]->id, "exact") == 0;
        if (every || !is_variant(render_pipelines[p]->id)) {
            seen one = look(&frame, render_pipelines[p], name);
            s = truth ? one : s;
        }
    }
    render_frame_destroy(&frame);
    render_scene_free(&scene);
    return s;
}

static seen look_at_text(const char *text, const char *name)
{
    workspace_write(&work, "scene.json", text);
    return look_by_all(workspace_path(&work, "scene.json"), name, 33, 17, false);
}

static void test_sizes(void **state)
{
    (void)state;
    static const uint32_t sizes[][2] = {{33, 17}, {1, 1}, {4096, 16}};
    char *path = render_scene_default();
    for (size_t i = 0; i < sizeof sizes / sizeof *sizes; i++) {
        char name[32];
        snprintf(name, sizeof name, "%ux%u", sizes[i][0], sizes[i][1]);
        seen s = look_by_all(path, name, sizes[i][0], sizes[i][1], i == 0);
        assert_true(s.surface > 0 && s.sum > 0);
    }
    free(path);
}

static void test_empty(void **state)
{
    (void)state;
    seen s = look_at_text("{\"meshes\": []}", "empty");
    assert_int_equal(s.surface, 0);
}

static void test_one_triangle(void **state)
{
    (void)state;
    workspace_write(&work, "one.obj", "v -1 0 0\nv 1 0 0\nv 0 1.5 0\nf 1 2 3\n");
    seen s =
        look_at_text("{\"meshes\": [{\"file\": \"one.obj\"}], \"area_lights\": [{\"vertices\": "
                     "[[-9,-9,1],[-9,9,1],[9,9,1],[9,-9,1]], \"exitance\": 2}]}",
                     "one triangle before a light");
    assert_true(fabs(s.sum / (3 * (double)s.surface) - 2) < 0.05);
}

/* A spotlight that shines on nothing: no light at all. */
static void test_light_behind(void **state)
{
    (void)state;
    char *box = render_scene_default(), *slash = strrchr(box, '/');
    char text[4096];
    *slash = '\0';
    snprintf(text, sizeof text,
             "{\"meshes\": [{\"file\": \"%s/room.obj\"}], \"camera\": {\"eye\": [0, 1, 3.4], "
             "\"target\": [0, 1, 0]}, \"spot\": {\"position\": [0, 1, 3], \"target\": [0, 1, 9], "
             "\"angle_deg\": 60}}",
             box);
    seen s = look_at_text(text, "spot turned away");
    assert_true(s.surface > 0 && s.sum == 0);
    free(box);
}

/* The eye in the sphere, and a tenth of a millimetre above the floor. */
static void test_camera_inside(void **state)
{
    (void)state;
    static const char *const cameras[] = {
        "\"eye\": [-0.45, 0.35, 0.3], \"target\": [0, 0.5, 0]",
        "\"eye\": [0, 1e-4, 0], \"target\": [1, 1e-4, 0.3], \"near\": 1e-5"};
    char *box = render_scene_default(), *slash = strrchr(box, '/');
    *slash = '\0';
    for (size_t i = 0; i < sizeof cameras / sizeof *cameras; i++) {
        char text[4096];
        snprintf(text, sizeof text,
                 "{\"meshes\": [{\"file\": \"%s/room.obj\"}, {\"file\": \"%s/sphere.obj\", "
                 "\"scale\": 0.35, \"translate\": [-0.45, 0.35, 0.3]}], \"camera\": {%s}, "
                 "\"spot\": {\"position\": [0.5, 1.8, 0.9], \"target\": [-0.6, 0, -0.5], "
                 "\"angle_deg\": 60, \"intensity\": 20}}",
                 box, box, cameras[i]);
        seen s = look_at_text(text, cameras[i]);
        assert_true(s.surface > 0);
    }
    free(box);
}

/* Corners that are no numbers, triangles without area; what remains is rendered. */
static void test_damaged_geometry(void **state)
{
    (void)state;
    workspace_write(&work, "bad.ply",
                    "ply\nformat ascii 1.0\nelement vertex 8\nproperty float x\nproperty float y\n"
                    "property float z\nelement face 6\nproperty list uchar int vertex_indices\n"
                    "end_header\n-1 0 0\n1 0 0\n0 1.5 0\nnan 0 0\ninf 1 1\n2 0 0\n1 1 nan\n0 0 1\n"
                    "3 0 1 2\n3 0 1 3\n3 1 2 4\n3 0 1 1\n3 6 1 2\n3 0 7 1\n");
    seen s = look_at_text("{\"meshes\": [{\"file\": \"bad.ply\"}]}", "NaN and infinite corners");
    assert_true(s.surface > 0);
}

static void test_no_message(void **state)
{
    (void)state;
    if (device)
        close_clean(device);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_sizes),         cmocka_unit_test(test_empty),
        cmocka_unit_test(test_one_triangle),  cmocka_unit_test(test_light_behind),
        cmocka_unit_test(test_camera_inside), cmocka_unit_test(test_damaged_geometry),
        cmocka_unit_test(test_no_message)};
    return cmocka_run_group_tests(tests, open_work, close_work);
}
