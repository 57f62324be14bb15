/* bench --scenes: what it measures of a view, what it writes, and what it refuses. */
#include <math.h>
#include <string.h>

#include "base/png.h"
#include "bench/scenes.h"
#include "bench/scenes_lobes.h"
#include "gpu_fixture.h"
#include "program.h"
#include "render/upsample.h"
#include "sg.h"
#include "workspace.h"

enum { WIDTH = 64, HEIGHT = 36 };

static void box(render_scene *scene)
{
    char *path = render_scene_default();
    assert_true(render_scene_read(path, NULL, scene));
    free(path);
}

static scenes_view view_of(gpu_device *device, const render_scene *scene)
{
    return (scenes_view){.device = device,
                         .scene = scene,
                         .name = "box",
                         .width = WIDTH,
                         .height = HEIGHT,
                         .runs = 3};
}

/* What a look saw: calls, and the order of the pipelines. */
typedef struct seen {
    int calls;
    char order[256];
    double worst;
} seen;

static bool see(void *context, render_frame *frame, const scenes_row *row, const float *light,
                const float *truth, const float *errors)
{
    seen *s = context;
    (void)frame;
    s->calls++;
    strcat(strcat(s->order, row->pipeline), " ");
    for (int i = 0; i < WIDTH * HEIGHT; i++) {
        double off = 0;
        for (int c = 0; c < 3; c++)
            off = fmax(off, fabs((double)light[4 * i + c] - (double)truth[4 * i + c]));
        if (strcmp(row->pipeline, "exact") == 0)
            s->worst = fmax(s->worst, fmax(off, (double)errors[i]));
    }
    return true;
}

static gpu_status create_upsample(render_frame *frame, const void *settings, void **state)
{
    return upsample_create(frame, settings, state);
}

/* The same view with the truth known: only the others run, a variant among them. */
static void test_again(scenes_view *view, scenes_table *table)
{
    static const char *const pipelines[] = {"upsample2", NULL};
    static const upsample_settings settings = {.factor = 2, .plane = 1, .power = 1, .least = 2};
    scenes_variant all_exact = {"all_exact", &upsample2_pipeline, create_upsample, &settings};
    scenes_row exact = table->rows[0], half = table->rows[2];
    seen s = {0};
    view->variants = &all_exact;
    view->variant_count = 1;
    scenes_table_free(table);
    assert_true(scenes_measure(view, pipelines, see, &s, table));
    assert_int_equal(table->count, 3);
    assert_string_equal(s.order, "upsample2 all_exact ");
    assert_true(table->rows[0].lighting_ms == exact.lighting_ms);
    assert_true(table->rows[1].error.rel == half.error.rel);
    assert_true(table->rows[1].truth_ms == exact.lighting_ms);
    assert_true(table->rows[2].error.rel < 1e-5);
}

static void test_a_view(void **state)
{
    (void)state;
    static const char *const pipelines[] = {"limit", "upsample2", NULL};
    gpu_device *device = open_software_device();
    render_scene scene;
    box(&scene);
    scenes_table table = {0};
    seen s = {0};
    scenes_truth known = {.light = NULL};
    scenes_view view = view_of(device, &scene);
    view.known = &known;
    assert_true(scenes_measure(&view, pipelines, see, &s, &table));
    assert_int_equal(table.count, 3);
    assert_int_equal(s.calls, 3);
    assert_string_equal(s.order, "exact limit upsample2 ");
    assert_true(s.worst == 0);
    const scenes_row *exact = &table.rows[0], *limit = &table.rows[1], *half = &table.rows[2];
    assert_true(exact->error.rel == 0 && exact->jump_p99 == 0);
    assert_int_equal(exact->statistics.light_evaluations,
                     exact->statistics.ground_truth_evaluations);
    assert_true(limit->error.rel > 0.5); /* it lights nothing */
    assert_true(half->error.rel > 0 && half->error.rel < limit->error.rel);
    assert_true(half->jump_p99 > 0);
    assert_true(half->lighting_ms > 0 && half->truth_ms == exact->lighting_ms);
    assert_true(half->frame_ms > 0);
    test_again(&view, &table);
    free(known.light);
    scenes_table_free(&table);
    render_scene_free(&scene);
    close_clean(device);
}

static int counted_runs;

static gpu_status count_run(render_frame *frame, void *state, render_statistics *statistics)
{
    counted_runs++;
    return upsample8_pipeline.run(frame, state, statistics);
}

/* Runs of a pipeline that count and the one before them, by what is long enough to be the last. */
static void test_runs(void **state)
{
    (void)state;
    static const char *const none[] = {NULL};
    static const struct {
        double enough_ms;
        int runs;
    } cases[] = {{0, 4}, {1e9, 4}, {1e-6, 3}};
    static const upsample_settings settings = {.factor = 8, .plane = 1, .power = 1, .least = 2};
    render_pipeline counted = upsample8_pipeline;
    counted.run = count_run;
    scenes_variant variant = {"counted", &counted, create_upsample, &settings};
    gpu_device *device = open_software_device();
    render_scene scene;
    box(&scene);
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        scenes_table table = {0};
        scenes_view view = view_of(device, &scene);
        view.enough_ms = cases[i].enough_ms;
        view.variants = &variant;
        view.variant_count = 1;
        counted_runs = 0;
        assert_true(scenes_measure(&view, none, NULL, NULL, &table));
        assert_int_equal(counted_runs, cases[i].runs);
        assert_int_equal(table.count, 2);
        assert_true(table.rows[1].lighting_ms > 0 && table.rows[1].error.rel > 0);
        scenes_table_free(&table);
    }
    render_scene_free(&scene);
    close_clean(device);
}

static void test_the_files(void **state)
{
    (void)state;
    workspace at;
    workspace_open(&at);
    scenes_row row = {.scene = "box",
                      .pipeline = "hull",
                      .method = "standard",
                      .width = 8,
                      .height = 4,
                      .lighting_ms = 2,
                      .truth_ms = 9};
    row.error.rel = 0.25;
    row.statistics.light_evaluations = 16;
    row.statistics.ground_truth_evaluations = 64;
    scenes_table table = {&row, 1};
    assert_true(scenes_write_csv(&table, workspace_path(&at, "views.csv")));
    FILE *file = fopen(at.path, "r");
    char header[1024], line[1024];
    assert_non_null(fgets(header, sizeof header, file));
    assert_non_null(fgets(line, sizeof line, file));
    fclose(file);
    assert_non_null(strstr(header, "scene,width,height,normals,pipeline,method,rel,"));
    assert_non_null(strstr(line, "box,8,4,smooth,hull,standard,0.25,"));
    assert_non_null(strstr(line, ",16,64,"));
    assert_non_null(strstr(line, ",25,2,4.5\n"));
    workspace_close(&at);
}

/* Two clusters of lights far apart become two lights with the flux of each. */
static void test_lobes_of_clusters(void **state)
{
    (void)state;
    gpu_device *device = open_software_device();
    render_frame frame = {.device = device, .light_count = 4};
    assert_int_equal(gpu_buffer_create(device, 4 * 16 * sizeof(float), &frame.lights), GPU_OK);
    float *words = gpu_buffer_map(frame.lights);
    memset(words, 0, 4 * 16 * sizeof *words);
    for (int i = 0; i < 4; i++) {
        float *w = words + 16 * i;
        for (int corner = 0; corner < 3; corner++) {
            w[4 * corner] = (i < 2 ? -5.0f : 5.0f) + 0.1f * (float)(i % 2);
            w[4 * corner + 3] = i < 2 ? 1.0f : 2.0f; /* exitance */
        }
        w[13] = 1.0f; /* normal */
        w[15] = 0.5f; /* area */
    }
    lobe_light lights[LOBE_LIGHTS];
    assert_int_equal(lobe_lights_of(&frame, lights), 2);
    for (int k = 0; k < 2; k++) {
        double flux = (double)lights[k].intensity[0] * sg_A((double)lights[k].sharpness);
        double expected = lights[k].centre[0] < 0 ? 1.0 : 2.0;
        assert_true(fabs(flux - expected) < 1e-5);
        assert_true(fabs(fabs((double)lights[k].centre[0]) - 5.0) < 0.1);
        assert_true(fabs((double)lights[k].variance - 0.5 * 0.05 * 0.05) < 1e-6);
        assert_true(lights[k].axis[1] > 0.999f);
    }
    gpu_buffer_destroy(frame.lights);
    close_clean(device);
}

static void test_refusals(void **state)
{
    (void)state;
    program_refuses((const char *const[]){"bench", "--scenes", "built-in", NULL}, 2, "--out");
    program_refuses((const char *const[]){"bench", "--out", "x", "--view", "box", NULL}, 2,
                    "--scenes");
    program_refuses(
        (const char *const[]){"bench", "--scenes", "/nowhere/at/all", "--out", "x", NULL}, 2,
        "/nowhere/at/all");
    program_refuses((const char *const[]){"bench", "--scenes", "built-in", "--out", "x", "--part",
                                          "views,nothing", NULL},
                    2, "found \"nothing\"");
    program_refuses((const char *const[]){"bench", "--out", "x", "--part", "views", NULL}, 2,
                    "--part");
    program_refuses((const char *const[]){"bench", "--scenes", "built-in", "--out", "x", "--view",
                                          "nosuch", NULL},
                    2, "nosuch");
    program_refuses((const char *const[]){"bench", "--scenes", "built-in", "--out", "x", "--method",
                                          "standard", NULL},
                    2, "--method");
    /* a scene that a later part needs is missed at once */
    workspace at;
    workspace_open(&at);
    program_refuses((const char *const[]){"bench", "--scenes", at.folder, "--out", "x", "--device",
                                          "no such", NULL},
                    2, ".ply");
    workspace_close(&at);
}

static void test_one_part(void **state)
{
    (void)state;
    workspace at;
    workspace_open(&at);
    run r = program_run((const char *const[]){"bench", "--scenes", "built-in", "--out", at.folder,
                                              "--quick", "--part", "choice", NULL},
                        &(run_options){0});
    assert_int_equal(r.status, 0);
    run_free(&r);
    assert_true(access(workspace_path(&at, "choice.csv"), R_OK) == 0);
    assert_true(access(workspace_path(&at, "views.csv"), F_OK) != 0);
    workspace_close(&at);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_a_view),    cmocka_unit_test(test_runs),
        cmocka_unit_test(test_the_files), cmocka_unit_test(test_lobes_of_clusters),
        cmocka_unit_test(test_refusals),  cmocka_unit_test(test_one_part),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
