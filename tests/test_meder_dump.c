/* The pictures of the pipeline `meder`. */
#include "meder_fixture.h"

#include <unistd.h>

#include "base/file.h"
#include "workspace.h"

static const struct {
    const char *name;
    bool
        downsampled; /* of the size of the downsampled depth, or of the plan; else of the image's */
} pictures[] = {
    {"downsampling.png", true}, {"segments.png", true},        {"boxes.png", true},
    {"quads.png", false},       {"vertices_before.png", true}, {"vertices_after.png", true},
    {"sharpness.png", false},   {"axis.png", false},           {"ownership.png", false}};
enum { PICTURES = sizeof pictures / sizeof *pictures };

static uint32_t big_endian(const unsigned char *at)
{
    return (uint32_t)at[0] << 24 | (uint32_t)at[1] << 16 | (uint32_t)at[2] << 8 | at[3];
}

/* Checks width and height, removes the file and returns its size. */
static size_t take(const char *folder, const char *name, uint32_t width, uint32_t height)
{
    char *path = base_join(folder, name);
    assert_non_null(path);
    size_t size;
    char *bytes = base_read_file(path, &size);
    assert_non_null(bytes);
    assert_true(size > 24);
    assert_memory_equal(bytes, "\x89PNG", 4);
    assert_int_equal(big_endian((unsigned char *)bytes + 16), width);
    assert_int_equal(big_endian((unsigned char *)bytes + 20), height);
    free(bytes);
    unlink(path);
    free(path);
    return size;
}

static void a_picture_of_every_stage(void **state)
{
    (void)state;
    workspace at;
    workspace_open(&at);
    const char *folder = at.folder;
    render_frame frame;
    open_frame(&frame, 320, 200);
    float *depth = random_depth(320, 200, 4);
    meder *m = run_on(&frame, depth);
    assert_true(meder_dump(&frame, m, folder));
    size_t full[PICTURES];
    for (int i = 0; i < PICTURES; i++) {
        uint32_t side = MEDER_SIDE;
        full[i] = take(folder, pictures[i].name, pictures[i].downsampled ? side : 320,
                       pictures[i].downsampled ? side : 200);
    }
    /* and of nothing: all of it black, and so smaller */
    for (int i = 0; i < 320 * 200; i++)
        depth[i] = 1;
    meder_pipeline.destroy(m);
    m = run_on(&frame, depth);
    assert_true(meder_dump(&frame, m, folder));
    for (int i = 0; i < PICTURES; i++)
        assert_true(4 * take(folder, pictures[i].name, pictures[i].downsampled ? MEDER_SIDE : 320,
                             pictures[i].downsampled ? MEDER_SIDE : 200) <
                    full[i]);
    assert_int_equal(rmdir(folder), 0);
    /* a folder that cannot be */
    assert_false(meder_dump(&frame, m, "/dev/null/folder"));
    free(depth);
    meder_pipeline.destroy(m);
    close_frame(&frame);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(a_picture_of_every_stage)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
