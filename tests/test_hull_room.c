/* The hull where its lists have too little room: nothing is left dark, and what is chosen for the
 * room that there is does not depend on the order in which a device happens to do its work. */
#include "render_fixture.h"

#include "render/hull_private.h"

enum { WIDTH = 320, HEIGHT = 180, RUNS = 4 };
static const size_t values = (size_t)4 * WIDTH * HEIGHT;

typedef struct outcome {
    uint32_t quads, vertices, exact_pixels;
    double rel;
} outcome;

/* Lights the frame some times, and checks that no pixel is left out and that every time is like the
 * first. */
static outcome light_alike(render_frame *frame, const hull_settings *settings, const float *truth,
                           float *light)
{
    static float again[4 * WIDTH * HEIGHT];
    void *state;
    check(hull_create(frame, settings, &state));
    const hull *h = state;
    for (int run = 0; run < RUNS; run++) {
        render_statistics statistics = {0};
        float *to = run == 0 ? light : again;
        check(hull_run(frame, state, &statistics));
        check(gpu_image_read(frame->light, to));
        assert_memory_equal(light, to, values * sizeof *light);
    }
    for (size_t i = 3; i < values; i += 4)
        assert_true((light[i] > 0) == (truth[i] > 0));
    const uint32_t *control = gpu_buffer_map(h->buffers[HULL_B_CONTROL]),
                   *exact = gpu_buffer_map(h->buffers[HULL_B_ARGUMENTS]);
    render_comparison comparison;
    render_compare(values / 4, light, truth, NULL, &comparison);
    outcome o = {control[HULL_LEAF_COUNT], control[HULL_VERTEX_COUNT] + control[HULL_EVEN_COUNT],
                 exact[3] - 1, comparison.rel};
    hull_destroy(state);
    return o;
}

static void what_finds_room_does_not_depend_on_the_order(void **state)
{
    fixture f;
    fixture_make(&f);
    render_frame frame;
    make_frame(state, &f, (render_options){.width = WIDTH, .height = HEIGHT}, &frame);
    static float light[4 * WIDTH * HEIGHT], truth[4 * WIDTH * HEIGHT], roomy[4 * WIDTH * HEIGHT];
    render_statistics statistics;
    light_with(&frame, "exact", &statistics, truth);
    hull_settings settings = hull_standard;
    settings.split = 0.02F;
    outcome with_room = light_alike(&frame, &settings, truth, roomy);
    uint32_t quads = with_room.quads, vertices = with_room.vertices;
    const struct {
        uint32_t vertices, quads, corners;
        double more; /* rel, at most, than with room */
        bool splits_less, more_exact;
    } tight[] = {
        {.vertices = vertices - vertices / 4, .more = 0.03, .splits_less = true},
        {.vertices = vertices / 3, .more = 0.05, .splits_less = true, .more_exact = true},
        {.vertices = 1, .more = 0, .splits_less = true, .more_exact = true},
        {.quads = quads / 8, .more = 0.03, .splits_less = true},
        {.quads = 1, .more = 0.05, .splits_less = true},
        {.corners = 6 * quads, .more = 0.03}, /* two triangles each */
    };
    for (size_t i = 0; i < sizeof tight / sizeof *tight; i++) {
        settings.most_vertices = tight[i].vertices;
        settings.most_quads = tight[i].quads;
        settings.most_corners = tight[i].corners;
        outcome o = light_alike(&frame, &settings, truth, light);
        if (!(o.rel <= with_room.rel + tight[i].more))
            fail_msg("case %zu: rel %g, with room %g", i, o.rel, with_room.rel);
        if (tight[i].vertices)
            assert_in_range(o.vertices, 0, tight[i].vertices);
        assert_int_equal(o.quads < quads, tight[i].splits_less);
        assert_int_equal(o.exact_pixels > with_room.exact_pixels, tight[i].more_exact);
        assert_memory_not_equal(light, roomy, sizeof roomy);
    }
    render_frame_destroy(&frame);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(what_finds_room_does_not_depend_on_the_order),
    };
    return cmocka_run_group_tests(tests, open_device, close_device);
}
