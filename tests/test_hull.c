/* The hull: its components label by label, and that it covers every pixel, run after run alike. */
#include "render_fixture.h"

#include "render/hull_private.h"

static double uniform(uint32_t *seed)
{
    *seed = *seed * 1664525U + 1013904223U;
    return (double)(*seed >> 8) / 16777216.0;
}

/* ---- Components ---------------------------------------------------------------------------------
 */

enum { WIDTH = 100, HEIGHT = 70 };

/* Facing walls at depths 1 to kinds - 1, none for 0. */
static void random_image(int kind, uint32_t *seed, uint8_t *image)
{
    for (int y = 0; y < HEIGHT; y++)
        for (int x = 0; x < WIDTH; x++) {
            double r = uniform(seed);
            uint8_t *p = &image[y * WIDTH + x];
            switch (kind) {
            case 0: /* noise, mostly of one kind */
                *p = r < 0.6 ? 1 : r < 0.8 ? 2 : 0;
                break;
            case 1: /* snakes: thin lines that fold back */
                *p = y % 2 == 0 || x == (y % 4 == 1 ? 0 : WIDTH - 1) ? 1 : r < 0.1 ? 0 : 2;
                break;
            case 2: /* large shapes with holes */
                *p = (uint8_t)((x / 13 + y / 9) % 3 + (r < 0.03 ? 1 : 0));
                break;
            case 3: /* more components than a tile may have */
                *p = (uint8_t)(1 + (x / 2 + y / 2) % 2 + 2 * (r < 0.05));
                break;
            default: /* one surface */
                *p = 1;
            }
        }
}

static void write_image(render_frame *frame, const uint8_t *image)
{
    static float position[4 * WIDTH * HEIGHT];
    static uint32_t normal[2 * WIDTH * HEIGHT];
    memset(position, 0, sizeof position);
    for (int i = 0; i < WIDTH * HEIGHT; i++) {
        /* octahedral (0, 0): along z */
        normal[2 * i] = normal[2 * i + 1] = 0;
        if (image[i] == 0)
            continue;
        position[4 * i] = 0.01F * (float)(i % WIDTH);
        position[4 * i + 1] = -0.01F * (float)(i / WIDTH);
        position[4 * i + 2] = -(float)image[i];
        position[4 * i + 3] = (float)image[i];
    }
    check(gpu_image_write(frame->position, position));
    check(gpu_image_write(frame->normal, normal));
}

/* Labels of one tile by flood fill: the component's first pixel plus 1; 0 without a surface. */
static void flood_tile(const uint8_t *image, int left, int top, uint32_t *labels)
{
    static int stack[HULL_TILE * HULL_TILE * 4];
    for (int y = top; y < top + HULL_TILE && y < HEIGHT; y++)
        for (int x = left; x < left + HULL_TILE && x < WIDTH; x++) {
            uint32_t label = (uint32_t)(y * WIDTH + x) + 1;
            if (!image[label - 1] || labels[label - 1])
                continue;
            int count = 0;
            stack[count++] = (int)label - 1;
            labels[label - 1] = label;
            while (count > 0) {
                int at = stack[--count], ax = at % WIDTH, ay = at / WIDTH;
                const int next[4][2] = {{ax - 1, ay}, {ax + 1, ay}, {ax, ay - 1}, {ax, ay + 1}};
                for (int i = 0; i < 4; i++) {
                    int nx = next[i][0], ny = next[i][1], to = ny * WIDTH + nx;
                    if (nx < left || ny < top || nx >= left + HULL_TILE || ny >= top + HULL_TILE ||
                        nx >= WIDTH || ny >= HEIGHT || image[to] != image[at] || labels[to])
                        continue;
                    labels[to] = label;
                    stack[count++] = to;
                }
            }
        }
}

/* Components that the shaders found, as labels; pixels left to be lit exactly stay 0. */
static void found_labels(const hull *h, uint32_t *labels)
{
    const uint32_t *masks = gpu_buffer_map(h->buffers[HULL_B_MASKS]);
    const uint32_t *components = gpu_buffer_map(h->buffers[HULL_B_COMPONENTS]);
    for (uint32_t c = 0; c < h->tiles * HULL_MOST_COMPONENTS; c++) {
        if (components[2 * c + 1] == 0)
            continue;
        uint32_t tile = c / HULL_MOST_COMPONENTS, pixels = 0;
        for (uint32_t y = 0; y < HULL_TILE; y++)
            for (uint32_t x = 0; x < HULL_TILE; x++)
                if (masks[c * HULL_TILE + y] >> x & 1) {
                    uint32_t py = tile / h->push.tiles_x * HULL_TILE + y;
                    uint32_t px = tile % h->push.tiles_x * HULL_TILE + x;
                    assert_true(px < WIDTH && py < HEIGHT);
                    assert_int_equal(labels[py * WIDTH + px], 0); /* one owner */
                    labels[py * WIDTH + px] = components[2 * c] + 1;
                    pixels++;
                }
        assert_int_equal(pixels, components[2 * c + 1]);
    }
}

static void components_are_those_of_a_flood_fill(void **state)
{
    fixture f;
    fixture_make(&f);
    render_frame frame;
    make_frame(state, &f, (render_options){.width = WIDTH, .height = HEIGHT}, &frame);
    void *hull_state;
    check(hull_create(&frame, &hull_standard, &hull_state));
    const hull *h = hull_state;
    uint32_t seed = 7, left_over = 0;
    for (int run = 0; run < 10; run++) {
        static uint8_t image[WIDTH * HEIGHT];
        static uint32_t expected[WIDTH * HEIGHT], found[WIDTH * HEIGHT];
        memset(expected, 0, sizeof expected);
        memset(found, 0, sizeof found);
        random_image(run % 5, &seed, image);
        write_image(&frame, image);
        render_statistics statistics = {0};
        check(hull_run(&frame, hull_state, &statistics));
        for (int y = 0; y < HEIGHT; y += HULL_TILE)
            for (int x = 0; x < WIDTH; x += HULL_TILE)
                flood_tile(image, x, y, expected);
        found_labels(h, found);
        const uint32_t *arguments = gpu_buffer_map(h->buffers[HULL_B_ARGUMENTS]);
        const uint32_t *exact = gpu_buffer_map(h->buffers[HULL_B_EXACT]);
        for (uint32_t i = 0; i + 1 < arguments[3]; i++) { /* in no component */
            assert_true(exact[i] < WIDTH * HEIGHT);
            assert_int_equal(found[exact[i]], 0);
            found[exact[i]] = expected[exact[i]];
            left_over++;
        }
        for (int i = 0; i < WIDTH * HEIGHT; i++)
            if (found[i] != expected[i])
                fail_msg("image %d, pixel %d, %d: label %u, expected %u", run, i % WIDTH, i / WIDTH,
                         found[i], expected[i]);
    }
    assert_true(left_over > 0);
    hull_destroy(hull_state);
    render_frame_destroy(&frame);
}

/* ---- The whole pipeline -------------------------------------------------------------------------
 */

static void every_pixel_is_covered_and_alike(void **state)
{
    static const uint32_t sizes[][2] = {{1, 1}, {33, 17}, {4096, 16}, {320, 180}};
    static const char *const ids[] = {"hull", "hull_lobe", "upsample_far", "upsample_sh8"};
    for (size_t s = 0; s < sizeof sizes / sizeof *sizes; s++) {
        fixture f;
        fixture_make(&f);
        render_frame frame;
        make_frame(state, &f,
                   (render_options){
                       .width = sizes[s][0], .height = sizes[s][1], .detailed_normals = s == 1},
                   &frame);
        size_t count = (size_t)4 * sizes[s][0] * sizes[s][1];
        float *light = calloc(count, sizeof *light), *again = calloc(count, sizeof *again),
              *truth = calloc(count, sizeof *truth);
        render_statistics statistics;
        light_with(&frame, "exact", &statistics, truth);
        uint64_t surface = statistics.pixels_covered;
        for (size_t i = 0; i < sizeof ids / sizeof *ids; i++) {
            light_with(&frame, ids[i], &statistics, light);
            if (statistics.pixels_uncovered || statistics.pixels_wrong ||
                statistics.pixels_covered != surface)
                fail_msg("%s, %u x %u: %llu covered of %llu", ids[i], sizes[s][0], sizes[s][1],
                         (unsigned long long)statistics.pixels_covered,
                         (unsigned long long)surface);
            light_with(&frame, ids[i], &statistics, again);
            assert_memory_equal(light, again, count * sizeof *light);
            render_comparison comparison;
            render_compare(count / 4, light, truth, NULL, &comparison);
            /* detailed normals on few pixels are noise, and 16 rows are few for a whole view */
            static const double most[4][4] = {{1e-4, 1e-4, 1e-4, 1e-4},
                                              {0.15, 0.15, 1, 1},
                                              {0.2, 0.2, 1, 1},
                                              {0.04, 0.08, 0.2, 0.2}};
            if (!(comparison.rel <= most[s][i]))
                fail_msg("%s, %u x %u: rel %g", ids[i], sizes[s][0], sizes[s][1], comparison.rel);
        }
        free(light);
        free(again);
        free(truth);
        render_frame_destroy(&frame);
    }
}

/* However the lights are divided into near and far, they add up; with all of them near it is the
 * ground truth. */
static void near_and_far_add_up(void **state)
{
    fixture f;
    fixture_make(&f);
    render_frame frame;
    make_frame(state, &f, (render_options){.width = 96, .height = 64}, &frame);
    static float light[4 * 96 * 64], truth[4 * 96 * 64];
    render_statistics statistics;
    render_comparison comparison;
    light_with(&frame, "exact", &statistics, truth);
    static const float taus[] = {1e-9F, 1e-3F, 0.2F};
    for (size_t i = 0; i < sizeof taus / sizeof *taus; i++) {
        hull_settings settings = hull_standard;
        void *hull_state;
        settings.tau = taus[i];
        settings.split = 0;
        check(hull_create(&frame, &settings, &hull_state));
        render_statistics counts = {0};
        check(hull_run(&frame, hull_state, &counts));
        check(gpu_image_read(frame.light, light));
        hull_destroy(hull_state);
        render_compare(96 * 64, light, truth, NULL, &comparison);
        double most = i == 0 ? 1e-5 : i == 1 ? 5e-3 : 0.05;
        if (!(comparison.rel <= most))
            fail_msg("tau %g: rel %g", (double)taus[i], comparison.rel);
    }
    render_frame_destroy(&frame);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(components_are_those_of_a_flood_fill),
        cmocka_unit_test(every_pixel_is_covered_and_alike),
        cmocka_unit_test(near_and_far_add_up),
    };
    return cmocka_run_group_tests(tests, open_device, close_device);
}
