/* EXR and PNG: what is written reads back, channel by channel, and nothing is left of a failure. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "base/buffer.h"
#include "base/exr.h"
#include "base/png.h"
#include "capture.h"
#include "work.h"

enum { WIDTH = 33, HEIGHT = 17, PIXELS = WIDTH * HEIGHT };

static float value_of(int channel, int i)
{
    return (float)(channel + 1) * (float)i / 8;
}

/* Layers' names in no order, interleaved and plain pixels, float and half in one file. */
static void test_named_channels(void **state)
{
    (void)state;
    static const char *const names[] = {"position.Z", "R",  "position.X", "A.very.deep_layer",
                                        "position.Y", "id", "G",          "normal.X"};
    enum { CHANNELS = sizeof names / sizeof names[0] };
    static float interleaved[PIXELS][3], plain[CHANNELS][PIXELS];
    exr_channel channels[CHANNELS];
    for (int c = 0; c < CHANNELS; c++) {
        for (int i = 0; i < PIXELS; i++)
            *(c < 3 ? &interleaved[i][c] : &plain[c][i]) = value_of(c, i);
        channels[c] = (exr_channel){.name = names[c],
                                    .pixels = c < 3 ? &interleaved[0][c] : plain[c],
                                    .stride = c < 3 ? 3 : 0,
                                    .half = c == 6};
    }
    for (int compressed = 0; compressed < 2; compressed++) {
        const exr_image image = {.width = WIDTH,
                                 .height = HEIGHT,
                                 .channels = channels,
                                 .channel_count = CHANNELS,
                                 .compressed = compressed};
        assert_true(exr_write(workspace_path(&work, "many.exr"), &image));
        for (int c = 0; c < CHANNELS; c++) {
            int width = 0, height = 0;
            float *pixels = exr_read(workspace_path(&work, "many.exr"), names[c], &width, &height);
            assert_non_null(pixels);
            assert_int_equal(width, WIDTH);
            assert_int_equal(height, HEIGHT);
            for (int i = 0; i < PIXELS; i++)
                if (!(fabsf(pixels[i] - value_of(c, i)) <= (c == 6 ? 0.25F : 0)))
                    fail_msg("%s, pixel %d: %g", names[c], i, (double)pixels[i]);
            free(pixels);
        }
    }
}

static void test_missing_channel(void **state)
{
    (void)state;
    static const float pixel[1] = {1};
    const exr_channel channel = {.name = "Y", .pixels = pixel};
    const exr_image image = {.width = 1, .height = 1, .channels = &channel, .channel_count = 1};
    assert_true(exr_write(workspace_path(&work, "one.exr"), &image));
    capture c;
    int width, height;
    capture_begin(&c);
    float *none = exr_read(workspace_path(&work, "one.exr"), "Z", &width, &height);
    const char *text = capture_end(&c);
    assert_null(none);
    assert_one_line(text, "one.exr", "channel Z");
}

/* The same name twice cannot be stored: one line, and no file. */
static void test_duplicate_channel(void **state)
{
    (void)state;
    static const float pixel[1] = {1};
    const exr_channel channels[] = {{.name = "Y", .pixels = pixel}, {.name = "Y", .pixels = pixel}};
    const exr_image image = {.width = 1, .height = 1, .channels = channels, .channel_count = 2};
    capture c;
    capture_begin(&c);
    bool good = exr_write(workspace_path(&work, "twice.exr"), &image);
    const char *text = capture_end(&c);
    assert_false(good);
    assert_one_line(text, "EXR");
    assert_int_equal(access(workspace_path(&work, "twice.exr"), F_OK), -1);
}

static void test_png(void **state)
{
    (void)state;
    static const float linear[][4] = {
        {0, 0.5F, 1, 9}, {-1, 2, NAN, 9}, {0.001F, 0.21404114F, INFINITY, 9}};
    assert_true(png_write_linear(workspace_path(&work, "p.png"), 3, 1, &linear[0][0], 4, 1));
    size_t size;
    char *bytes = workspace_read_path(workspace_path(&work, "p.png"), &size);
    assert_true(size > 50 && memcmp(bytes, "\x89PNG\r\n\x1a\n", 8) == 0);
    /* The same picture from bytes: sRGB of 0.5 is 188, of 0.21404 is 128, of 0.001 is 3. */
    static const uint8_t rgb[] = {0, 188, 255, 0, 255, 0, 3, 128, 255};
    assert_true(png_write(workspace_path(&work, "q.png"), 3, 1, rgb));
    size_t again;
    char *same = workspace_read_path(workspace_path(&work, "q.png"), &again);
    assert_int_equal(size, again);
    assert_memory_equal(bytes, same, size);
    free(bytes);
    free(same);
}

static void test_unwritable(void **state)
{
    (void)state;
    static const uint8_t rgb[3] = {0};
    capture c;
    capture_begin(&c);
    bool good = png_write(workspace_path(&work, "no/such/p.png"), 1, 1, rgb);
    const char *text = capture_end(&c);
    assert_false(good);
    assert_one_line(text, "no/such/p.png");
    capture_begin(&c);
    good = png_write(workspace_path(&work, "empty.png"), 0, 1, rgb);
    text = capture_end(&c);
    assert_false(good);
    assert_one_line(text, "empty.png");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_named_channels), cmocka_unit_test(test_missing_channel),
        cmocka_unit_test(test_duplicate_channel), cmocka_unit_test(test_png),
        cmocka_unit_test(test_unwritable)};
    return cmocka_run_group_tests(tests, open_work, close_work);
}
