/* The stages of the pipeline `meder` against the same in C. */
#include "meder_fixture.h"

#include <math.h>

static const uint32_t sizes[][2] = {{1, 1}, {33, 17}, {320, 200}, {4096, 16}};
enum { SIZES = sizeof sizes / sizeof *sizes };

static void segments_and_boxes_are_those_of_algorithm_1(void **state)
{
    (void)state;
    for (uint32_t s = 0; s < SIZES; s++) {
        render_frame frame;
        open_frame(&frame, sizes[s][0], sizes[s][1]);
        float *depth = random_depth(sizes[s][0], sizes[s][1], s + 1);
        meder *m = run_on(&frame, depth);
        static reference r; /* 8 MB */
        reference_segment(&r, depth, frame.width, frame.height, m->threshold);
        float *downsampled = malloc(sizeof r.depth);
        uint32_t *labels = malloc(sizeof r.labels);
        assert_non_null(downsampled);
        assert_non_null(labels);
        must(gpu_image_read(m->downsampled, downsampled));
        must(gpu_image_read(m->labels, labels));
        assert_memory_equal(downsampled, r.depth, sizeof r.depth);
        assert_memory_equal(labels, r.labels, sizeof r.labels);
        const meder_box *boxes = gpu_buffer_map(m->boxes);
        const uint32_t *quads = gpu_buffer_map(m->quads);
        assert_int_equal(meder_quad_count(m), r.count);
        assert_true(s == 0 || r.count > 1000); /* there is something to compare */
        for (uint32_t i = 0; i < r.count; i++)
            assert_memory_equal(&boxes[quads[i]], &r.boxes[i],
                                sizeof *boxes - sizeof boxes->unused);
        free(downsampled);
        free(labels);
        free(depth);
        reference_free(&r);
        meder_pipeline.destroy(m);
        close_frame(&frame);
    }
}

/* Positions and moments of every corner. */
static void corners_are_those_of_the_reference(void **state)
{
    (void)state;
    render_frame frame;
    open_frame(&frame, 320, 200);
    float *depth = random_depth(320, 200, 9);
    meder *m = run_on(&frame, depth);
    meder_record *records;
    must(meder_record_corners(&frame, m, &records, NULL));
    const meder_box *boxes = gpu_buffer_map(m->boxes);
    const uint32_t *quads = gpu_buffer_map(m->quads);
    int corrected = 0, kept = 0;
    double worst = 0;
    for (uint32_t i = 0; i < 4 * meder_quad_count(m); i++) {
        const meder_record *r = &records[i];
        double position[3];
        if (r->corrected > 0)
            reference_middle(gpu_buffer_map(frame.view), &boxes[quads[i / 4]], i % 4, position);
        for (int k = 0; k < 3; k++)
            assert_true(r->corrected > 0 ? fabs((double)r->after[k] - position[k]) < 1e-3
                                         : memcmp(&r->after[k], &r->before[k], sizeof(float)) == 0);
        corrected += r->corrected > 0;
        kept += !(r->corrected > 0);
        worst = fmax(worst, reference_lobe_difference(gpu_buffer_map(frame.lights), LIGHTS, r));
    }
    print_message("%d corners kept, %d corrected, lobes at most %.2g off\n", kept, corrected,
                  worst);
    assert_true(kept > 100 && corrected > 100);
    assert_true(worst < 2e-4);
    const uint32_t *counters = gpu_buffer_map(frame.counters);
    assert_int_equal(counters[8], meder_quad_count(m));
    /* twice: once lit, once recorded; a driver may shade a shared corner again */
    assert_true(counters[10] >= 8 * meder_quad_count(m));
    assert_true(counters[10] < 9 * meder_quad_count(m));
    assert_int_equal(counters[0], counters[10] * LIGHTS);
    free(records);
    free(depth);
    meder_pipeline.destroy(m);
    close_frame(&frame);
}

static void lit_pixels_say_who_owns_them(void **state)
{
    (void)state;
    render_frame frame;
    open_frame(&frame, 320, 200);
    float *depth = random_depth(320, 200, 3);
    meder *m = run_on(&frame, depth);
    const uint32_t count = 320 * 200;
    float(*light)[4] = malloc(count * sizeof *light), (*again)[4] = malloc(count * sizeof *again);
    assert_non_null(light);
    assert_non_null(again);
    must(gpu_image_read(frame.light, light));
    int own = 0, foreign = 0, none = 0;
    for (uint32_t i = 0; i < count; i++) {
        for (int c = 0; c < 3; c++)
            assert_true(isfinite(light[i][c]) && light[i][c] >= 0);
        if (depth[i] >= 1) {
            assert_true(light[i][3] == 0);
            continue;
        }
        assert_true(light[i][3] == 1 || light[i][3] == -2 || light[i][3] == 0);
        own += light[i][3] == 1;
        foreign += light[i][3] == -2;
        none += light[i][3] == 0;
    }
    /* every pixel of this size is a texel's, so that its own box holds it: none is uncovered, and
     * some are under another quad that is drawn later */
    assert_int_equal(none, 0);
    double sum = 0;
    for (uint32_t i = 0; i < count; i++)
        sum += (double)light[i][0];
    assert_true(sum > 0);
    assert_true(own > 10000 && foreign > 100);
    gpu_step steps[MEDER_STEPS];
    meder_steps(&frame, m, steps);
    must(gpu_run(frame.device, steps, MEDER_STEPS, NULL));
    must(gpu_image_read(frame.light, again));
    assert_memory_equal(light, again, count * sizeof *light);
    free(light);
    free(again);
    free(depth);
    meder_pipeline.destroy(m);
    close_frame(&frame);
}

static void nothing_there_is_nothing_drawn(void **state)
{
    (void)state;
    render_frame frame;
    open_frame(&frame, 33, 17);
    float depth[33 * 17], light[33 * 17][4];
    for (int i = 0; i < 33 * 17; i++)
        depth[i] = 1;
    meder *m = run_on(&frame, depth);
    assert_int_equal(meder_quad_count(m), 0);
    must(gpu_image_read(frame.light, light));
    for (int i = 0; i < 33 * 17; i++)
        assert_true(light[i][0] == 0 && light[i][3] == 0);
    const uint32_t *counters = gpu_buffer_map(frame.counters);
    for (int i = 0; i < 12; i++)
        assert_int_equal(counters[i], 0);
    meder_pipeline.destroy(m);
    close_frame(&frame);
}

static void another_method_is_another_picture(void **state)
{
    (void)state;
    static const char *const methods[] = {NULL, "standard", "constant_cosine_stable",
                                          "constant_cosine"};
    float light[4][33 * 17][4];
    for (int i = 0; i < 4; i++) {
        render_frame frame;
        open_frame(&frame, 33, 17);
        frame.options.method = methods[i];
        light_data *lights = gpu_buffer_map(frame.lights);
        for (int l = 0; l < LIGHTS; l++)
            lights[l].b[3] = 0; /* nothing green: lobes of sharpness 0 */
        float *depth = random_depth(33, 17, 5);
        meder *m = run_on(&frame, depth);
        must(gpu_image_read(frame.light, light[i]));
        free(depth);
        meder_pipeline.destroy(m);
        close_frame(&frame);
    }
    for (int i = 0; i < 33 * 17; i++)
        for (int c = 0; c < 3; c++)
            assert_true(isfinite(light[3][i][c])); /* though as published it fails at sharpness 0 */
    assert_memory_equal(light[0], light[1], sizeof light[0]);
    assert_memory_not_equal(light[0], light[2], sizeof light[0]);
    assert_memory_not_equal(light[0], light[3], sizeof light[0]);
    render_frame frame;
    open_frame(&frame, 33, 17);
    frame.options.method = "no_such_method";
    void *none = &frame;
    refused(meder_pipeline.create(&frame, &none), GPU_BAD_SHADER, "no_such_method");
    assert_null(none);
    close_frame(&frame);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(segments_and_boxes_are_those_of_algorithm_1),
        cmocka_unit_test(corners_are_those_of_the_reference),
        cmocka_unit_test(lit_pixels_say_who_owns_them),
        cmocka_unit_test(nothing_there_is_nothing_drawn),
        cmocka_unit_test(another_method_is_another_picture),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
