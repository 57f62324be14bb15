/* pass_fixture.h: what the tests of images, drawing and lists of steps share. */
#ifndef PASS_FIXTURE_H
#define PASS_FIXTURE_H

#include "gpu_fixture.h"

#include <string.h>

#include "pass.h"

static inline void must(gpu_status status)
{
    if (status != GPU_OK)
        fail_msg("%s", gpu_last_error());
}

static inline gpu_image *make_image(gpu_device *device, gpu_format format, uint32_t width,
                                    uint32_t height)
{
    gpu_image *image;
    must(gpu_image_create(device, format, width, height, &image));
    return image;
}

static inline gpu_buffer *make_buffer(gpu_device *device, size_t size)
{
    gpu_buffer *buffer;
    must(gpu_buffer_create(device, size, &buffer));
    return buffer;
}

static inline gpu_compute *make_compute(gpu_device *device, const gpu_compute_options *options)
{
    gpu_compute *compute;
    must(gpu_compute_create(device, options, &compute));
    return compute;
}

static inline void refused(gpu_status status, gpu_status expected, const char *part)
{
    assert_int_equal(status, expected);
    if (!strstr(gpu_last_error(), part) || strchr(gpu_last_error(), '\n'))
        fail_msg("'%s' does not say '%s' in one line", gpu_last_error(), part);
}

/* Adds 1 to a word for each invocation. */
static const char count_source[] = "#version 450\n"
                                   "layout(local_size_x = 4) in;\n"
                                   "layout(binding = 0) buffer B { uint n[]; };\n"
                                   "void main() { atomicAdd(n[gl_WorkGroupID.y], 1); }\n";

#endif
