/* What a frame of the pipeline `meder` asks the fitted form: its last quads drawn once more for
 * each channel. */
#include "internal.h"
#include "meder.h"

static gpu_status create_draw(render_frame *frame, gpu_draw **draw)
{
    gpu_draw_options options = {.name = "meder/profile",
                                .vertex = render_shader("meder/lighting.vert"),
                                .fragment = render_shader("meder/profile.frag"),
                                .binding_count = MEDER_DRAW_BINDINGS,
                                .push_size = sizeof(int32_t),
                                .target_count = 1,
                                .targets = {GPU_RGBA32F},
                                .constant = render_closest(frame)};
    meder_draw_bindings(options.bindings);
    return gpu_draw_create(frame->device, &options, draw);
}

gpu_status meder_profile(render_frame *frame, void *state, float **points, size_t *count)
{
    enum { CHANNELS = 3 };
    meder *m = state;
    gpu_draw *draw;
    gpu_status status = create_draw(frame, &draw);
    if (status != GPU_OK)
        return status;
    gpu_step step = {
        .name = "profile", .draw = draw, .indices = m->indices, .indirect = m->indirect};
    meder_draw_resources(frame, m, step.resources);
    status = profile_draw(frame, step, CHANNELS, points, count);
    gpu_draw_destroy(draw);
    return status;
}
