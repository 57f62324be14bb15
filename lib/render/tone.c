/* From radiance to pictures: one exposure for a scene and a view, whatever the pipeline. */
#include "internal.h"

#include <math.h>

enum { GRID_ROWS = 36, GRID_SIZE = 64 * GRID_ROWS };

float render_tone(double gain, float radiance)
{
    double x = gain * (double)radiance;
    if (!(x > 0))
        return 0;
    double y = x * (1 + x / 16) / (1 + x);
    return (float)(y < 1 ? y : 1);
}

/* What is dark counts as a tenth of the mean, so that a black background does not decide. */
static double gain_of(const float *luminances)
{
    double sum = 0, logs = 0;
    int count = 0;
    for (int i = 0; i < GRID_SIZE; i++)
        if (luminances[i] >= 0) {
            sum += (double)luminances[i];
            count++;
        }
    if (!(sum > 0) || isinf(sum))
        return 1;
    double least = 0.1 * sum / count;
    for (int i = 0; i < GRID_SIZE; i++)
        if (luminances[i] >= 0)
            logs += log((double)luminances[i] + least);
    return 0.18 / exp(logs / count);
}

gpu_status tone_measure(render_frame *frame)
{
    static const gpu_binding bindings[] = {GPU_STORAGE_BUFFER, GPU_STORAGE_BUFFER,
                                           GPU_FETCHED,        GPU_FETCHED,
                                           GPU_FETCHED,        GPU_STORAGE_BUFFER};
    gpu_buffer *luminances = NULL;
    gpu_compute *compute = NULL;
    gpu_status status = render_compute(frame, "tone/tone.comp", false, bindings, 6, 0, &compute);
    if (status == GPU_OK)
        status = gpu_buffer_create(frame->device, GRID_SIZE * sizeof(float), &luminances);
    if (status == GPU_OK) {
        gpu_step step = {.name = "tone",
                         .compute = compute,
                         .resources = {frame->view, frame->lights, frame->position, frame->normal,
                                       frame->albedo, luminances},
                         .groups = {GRID_ROWS, 1, 1}};
        status = gpu_run(frame->device, &step, 1, NULL);
    }
    if (status == GPU_OK)
        frame->gain = gain_of(gpu_buffer_map(luminances));
    gpu_buffer_destroy(luminances);
    gpu_compute_destroy(compute);
    return status;
}
