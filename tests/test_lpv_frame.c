/* Indirect light in a frame: the look-up against the host, what a frame gains by it, reruns, odd
 * volumes and scenes, and the reference of one bounce. */
#include "multires_fixture.h"

#include "render/bounce.h"
#include "render/lpv.h"

enum { WIDTH = 48, HEIGHT = 36, PIXELS = WIDTH * HEIGHT };

/* struct Passed of shaders/lpv/volume.glsl. */
typedef struct passed_data {
    float by[6][4];
} passed_data;

/* One device for all: drivers compile for it once. */
static fixture opened;

static fixture *scene_of_all(void)
{
    if (!opened.device)
        fixture_open(&opened, "box_area", WIDTH, HEIGHT);
    return &opened;
}

static void again(fixture *f, render_options options)
{
    fixture_close_frame(f);
    options.width = WIDTH;
    options.height = HEIGHT;
    must(render_frame_create(f->device, &f->scene, &options, &f->frame));
    fixture_read(f);
}

static float *light_of(fixture *f, const char *pipeline, render_statistics *statistics)
{
    return fixture_light(f, render_pipeline_find(pipeline), statistics);
}

/* ---- Look-up -------------------------------------------------------------------------- */

/* Interpolated in each dimension, beyond the outer centres their value; the three directions that
 * the normal points to, by the squares of its coordinates. */
static double host_look_up(const fixture *f, const lpv *l, size_t pixel, int colour)
{
    const passed_data *sums = gpu_buffer_map(l->sums);
    uint32_t place[2][3];
    double part[3], sum = 0;
    for (int k = 0; k < 3; k++) {
        double x = ((double)f->position[4 * pixel + (size_t)k] - (double)l->push.low[k]) /
                       (double)l->push.side +
                   (double)(l->push.lift * f->face[pixel][k]) - 0.5;
        x = fmin(fmax(x, 0), l->push.size[k] - 1);
        place[0][k] = (uint32_t)x;
        place[1][k] = place[0][k] + 1 < l->push.size[k] ? place[0][k] + 1 : place[0][k];
        part[k] = x - place[0][k];
    }
    for (int i = 0; i < 8; i++) {
        int far[3] = {i & 1, i >> 1 & 1, i >> 2 & 1};
        double weight = 1, here = 0;
        for (int k = 0; k < 3; k++)
            weight *= far[k] ? part[k] : 1 - part[k];
        size_t voxel =
            place[far[0]][0] +
            l->push.size[0] * (place[far[1]][1] + (size_t)l->push.size[1] * place[far[2]][2]);
        for (int k = 0; k < 3; k++) {
            double n = (double)f->normal[pixel][k];
            here += n * n * (double)sums[voxel].by[2 * k + (n > 0)][colour];
        }
        sum += weight * here;
    }
    return sum / ((double)l->push.side * (double)l->push.side);
}

static void the_look_up_is_the_hosts(void **state)
{
    (void)state;
    fixture *f = scene_of_all();
    render_statistics statistics;
    again(f, (render_options){.runs = 1});
    float *direct = light_of(f, "shadows", &statistics);
    assert_int_equal(statistics.voxels, 0);
    uint64_t before = statistics.samples;
    again(f, (render_options){.indirect = RENDER_INDIRECT_LPV, .volume = 7, .steps = 9});
    float *all = light_of(f, "shadows", &statistics);
    assert_int_equal(statistics.volume_samples, f->frame.lpv->samples);
    assert_int_equal(statistics.samples, before + statistics.volume_samples);
    assert_in_range(statistics.voxels, 200, 343);
    double added = 0, shone = 0;
    for (size_t i = 0; i < PIXELS; i++)
        for (int k = 0; k < 3; k++) {
            double sum = f->position[4 * i + 3] > 0 ? host_look_up(f, f->frame.lpv, i, k) : 0;
            double found = (double)all[4 * i + (size_t)k] - (double)direct[4 * i + (size_t)k];
            if (fabs(found - sum) > 1e-4 * (1 + (double)direct[4 * i + (size_t)k]))
                fail_msg("pixel %zu: %g, expected %g", i, found, sum);
            assert_true(all[4 * i + 3] == direct[4 * i + 3]);
            added += sum;
            shone += (double)direct[4 * i + (size_t)k];
        }
    assert_true(added > 0.05 * shone && added < shone);
    free(direct);
    free(all);
}

/* ---- Frames --------------------------------------------------------------------------- */

/* A list that runs three times, and another frame, bring the same pixels. */
static void reruns_are_identical(void **state)
{
    (void)state;
    fixture *f = scene_of_all();
    again(f, (render_options){.indirect = RENDER_INDIRECT_LPV});
    render_statistics statistics;
    float *first = light_of(f, "multires", &statistics),
          *second = light_of(f, "multires", &statistics);
    assert_memory_equal(first, second, PIXELS * 16);
    again(f, (render_options){.indirect = RENDER_INDIRECT_LPV, .runs = 3});
    float *third = light_of(f, "multires", &statistics);
    assert_memory_equal(first, third, PIXELS * 16);
    static const char *const passes[] = {"lpv gathering", "lpv deposit", "lpv propagation",
                                         "lpv look-up"};
    for (size_t i = 0; i < 4; i++) {
        int found = 0;
        for (int t = 0; t < statistics.time_count; t++)
            found += strcmp(statistics.times[t].name, passes[i]) == 0;
        assert_int_equal(found, 1);
    }
    free(first);
    free(second);
    free(third);
}

static void check_finite(const fixture *f, const float *light)
{
    for (size_t i = 0; i < PIXELS; i++)
        for (size_t k = 0; k < 3; k++)
            assert_true(isfinite(light[4 * i + k]) && light[4 * i + k] >= 0 &&
                        light[4 * i + 3] == (f->position[4 * i + 3] > 0 ? 1.0F : 0.0F));
}

static void odd_volumes_give_images(void **state)
{
    (void)state;
    fixture *f = scene_of_all();
    static const uint32_t odd[][2] = {{1, 1}, {1, 40}, {2, 3}, {40, 1}, {13, 5}};
    for (size_t i = 0; i < sizeof odd / sizeof *odd; i++) {
        again(f, (render_options){
                     .indirect = RENDER_INDIRECT_LPV, .volume = odd[i][0], .steps = odd[i][1]});
        render_statistics statistics;
        float *light = light_of(f, "exact", &statistics);
        check_finite(f, light);
        assert_in_range(statistics.voxels, 1, odd[i][0] * odd[i][0] * odd[i][0]);
        free(light);
    }
}

/* Texels of the shadow map shine for pipelines that show them, and for those alone. */
static void a_spotlight_bounces_too(void **state)
{
    (void)state;
    fixture *f = scene_of_all();
    size_t lights = f->scene.area_light_count;
    f->scene.area_light_count = 0;
    f->scene.has_spot = true;
    f->scene.spot = (render_spot){.position = {0.6, 1.7, 0.8},
                                  .target = {-0.4, 0, -0.5},
                                  .angle_deg = 70,
                                  .intensity = {9, 9, 9}};
    render_statistics statistics;
    again(f, (render_options){.runs = 1});
    float *direct = light_of(f, "exact", &statistics);
    again(f, (render_options){.indirect = RENDER_INDIRECT_LPV});
    float *all = light_of(f, "exact", &statistics);
    double sums[2] = {0, 0};
    for (size_t i = 0; i < PIXELS; i++)
        for (size_t k = 0; k < 3; k++) {
            assert_true(all[4 * i + k] >= direct[4 * i + k]);
            sums[0] += (double)direct[4 * i + k];
            sums[1] += (double)all[4 * i + k] - (double)direct[4 * i + k];
        }
    printf("a further bounce of the texels: %.3f of what they bring\n", sums[1] / sums[0]);
    assert_true(sums[1] > 0.1 * sums[0] && sums[1] < 0.9 * sums[0]);
    f->scene.has_spot = false;
    f->scene.area_light_count = lights;
    free(direct);
    free(all);
}

/* No surface, no light, a light of no area: what the pipeline lights, and nothing else. */
static void nothing_to_bounce_changes_nothing(void **state)
{
    (void)state;
    fixture *f = scene_of_all();
    size_t triangles = f->scene.triangle_count, lights = f->scene.area_light_count;
    render_area_light first = f->scene.area_lights[0];
    for (int odd = 0; odd < 3; odd++) {
        f->scene.triangle_count = odd == 0 ? 0 : triangles;
        f->scene.area_light_count = odd == 1 ? 0 : 1;
        for (int i = 0; odd == 2 && i < first.corner_count; i++)
            memcpy(f->scene.area_lights[0].corners[i], first.corners[0], 24);
        again(f, (render_options){.indirect = RENDER_INDIRECT_LPV});
        render_statistics statistics;
        float *light = light_of(f, "exact", &statistics);
        assert_int_equal(statistics.volume_samples > 0, odd > 0);
        for (size_t i = 0; i < PIXELS; i++)
            for (size_t k = 0; k < 3; k++)
                assert_true(light[4 * i + k] == 0);
        free(light);
        f->scene.area_lights[0] = first;
    }
    f->scene.triangle_count = triangles;
    f->scene.area_light_count = lights;
}

static int close_scene(void **state)
{
    (void)state;
    if (!opened.device)
        return 0;
    fixture_close_frame(&opened);
    render_scene_free(&opened.scene);
    int messages = gpu_message_count(opened.device);
    if (messages)
        fprintf(stderr, "validation: %s\n", gpu_messages(opened.device));
    gpu_device_close(opened.device);
    return messages != 0;
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_look_up_is_the_hosts),
        cmocka_unit_test(reruns_are_identical),
        cmocka_unit_test(odd_volumes_give_images),
        cmocka_unit_test(a_spotlight_bounces_too),
        cmocka_unit_test(nothing_to_bounce_changes_nothing),
    };
    return cmocka_run_group_tests(tests, NULL, close_scene);
}
