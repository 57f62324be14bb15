/* Points that a pipeline integrates: its draw once more with a shader that writes its arguments. */
#include "internal.h"

#include <stdlib.h>

enum { FLOATS = 3 };

/* Those pixels that a lobe of any light was integrated for. */
static size_t collect(const float *pixels, size_t pixel_count, float *points)
{
    size_t count = 0;
    for (size_t i = 0; i < pixel_count; i++) {
        const float *p = pixels + 4 * i;
        if (p[3] == 0.0F || !(p[2] > 0.0F))
            continue;
        for (size_t c = 0; c < FLOATS; c++)
            points[FLOATS * count + c] = p[c];
        count++;
    }
    return count;
}

gpu_status profile_draw(render_frame *frame, gpu_step step, int32_t layers, float **points,
                        size_t *count)
{
    size_t pixel_count = (size_t)frame->width * frame->height;
    float *pixels = malloc(4 * pixel_count * sizeof *pixels);
    float *found = malloc((size_t)layers * FLOATS * pixel_count * sizeof *found);
    gpu_image *target = NULL;
    gpu_status status = GPU_OK;
    *points = NULL;
    *count = 0;
    if (!pixels || !found)
        status = gpu_fail(GPU_OUT_OF_MEMORY, "a profile: out of host memory");
    if (status == GPU_OK)
        status = gpu_image_create(frame->device, GPU_RGBA32F, frame->width, frame->height, &target);
    step.targets[0] = target;
    for (int32_t layer = 0; layer < layers && status == GPU_OK; layer++) {
        step.push = &layer;
        status = gpu_run(frame->device, &step, 1, NULL);
        if (status == GPU_OK)
            status = gpu_image_read(target, pixels);
        if (status == GPU_OK)
            *count += collect(pixels, pixel_count, found + FLOATS * *count);
    }
    gpu_image_destroy(target);
    free(pixels);
    if (status == GPU_OK)
        *points = found;
    else
        free(found);
    return status;
}
