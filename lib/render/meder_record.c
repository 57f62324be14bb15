/* The last run's quads once more, with shaders that write down what they make. */
#include "internal.h"
#include "meder.h"

#include <stdlib.h>
#include <string.h>

static gpu_status create_draw(render_frame *frame, gpu_draw **draw)
{
    gpu_draw_options options = {.name = "meder/dump",
                                .vertex = render_shader("meder/dump.vert"),
                                .fragment = render_shader("meder/dump.frag"),
                                .binding_count = MEDER_DRAW_BINDINGS + 1,
                                .target_count = 1,
                                .targets = {GPU_RGBA32F},
                                .constant = render_closest(frame)};
    meder_draw_bindings(options.bindings);
    return gpu_draw_create(frame->device, &options, draw);
}

/* What draws, and what it draws into. */
typedef struct recording {
    gpu_draw *draw;
    gpu_image *target;
    gpu_buffer *records;
} recording;

static gpu_status open_recording(render_frame *frame, uint32_t quads, recording *r)
{
    gpu_status status = create_draw(frame, &r->draw);
    if (status == GPU_OK)
        status =
            gpu_image_create(frame->device, GPU_RGBA32F, frame->width, frame->height, &r->target);
    if (status == GPU_OK)
        status =
            gpu_buffer_create(frame->device, (size_t)4 * quads * sizeof(meder_record), &r->records);
    return status;
}

static gpu_status draw(render_frame *frame, meder *m, const recording *r)
{
    gpu_step step = {.name = "dump",
                     .draw = r->draw,
                     .indices = m->indices,
                     .indirect = m->indirect,
                     .targets = {r->target}};
    meder_draw_resources(frame, m, step.resources);
    step.resources[MEDER_DRAW_BINDINGS] = r->records;
    return gpu_run(frame->device, &step, 1, NULL);
}

/* malloc'ed copies. */
static gpu_status copy(render_frame *frame, const recording *r, meder_record **records,
                       float **lobes)
{
    size_t size = gpu_buffer_size(r->records);
    *records = malloc(size);
    if (lobes)
        *lobes = malloc((size_t)frame->width * frame->height * 4 * sizeof(float));
    if (!*records || (lobes && !*lobes))
        return gpu_fail(GPU_OUT_OF_MEMORY, "meder: out of host memory");
    memcpy(*records, gpu_buffer_map(r->records), size);
    return lobes ? gpu_image_read(r->target, *lobes) : GPU_OK;
}

gpu_status meder_record_corners(render_frame *frame, meder *m, meder_record **records,
                                float **lobes)
{
    *records = NULL;
    if (lobes)
        *lobes = NULL;
    recording r = {NULL, NULL, NULL};
    gpu_status status = open_recording(frame, meder_quad_count(m), &r);
    if (status == GPU_OK)
        status = draw(frame, m, &r);
    if (status == GPU_OK)
        status = copy(frame, &r, records, lobes);
    gpu_draw_destroy(r.draw);
    gpu_image_destroy(r.target);
    gpu_buffer_destroy(r.records);
    if (status != GPU_OK) {
        free(*records);
        *records = NULL;
        if (lobes) {
            free(*lobes);
            *lobes = NULL;
        }
    }
    return status;
}
