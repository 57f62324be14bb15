/* Upsampling of samples that know the light for every normal, by the passes that hull.c lists: of
 * all lights, and of the far ones alone beside near lights at every pixel. */
#include "hull.h"

const hull_settings hull_far_standard = {
    .kind = HULL_UPSAMPLE,
    .tau = 0.2F,
    .tau_width = 3,
    .near_pixels = 16,
    .factor = 10,
    .plane = 0.5F,
    .power = 4,
    .least = 1e-3F,
};
const hull_settings hull_sh_standard = {
    .kind = HULL_UPSAMPLE,
    .factor = 8,
    .plane = 0.5F,
    .power = 4,
    .least = 1e-3F,
};

#define UPSAMPLE(NAME, BASE, FACTOR, TITLE)                                                        \
    static gpu_status create_##NAME(render_frame *frame, void **state)                             \
    {                                                                                              \
        hull_settings settings = BASE;                                                             \
        settings.factor = FACTOR;                                                                  \
        return hull_create(frame, &settings, state);                                               \
    }                                                                                              \
    const render_pipeline NAME##_pipeline = {                                                      \
        .id = #NAME,                                                                               \
        .title = TITLE,                                                                            \
        .create = create_##NAME,                                                                   \
        .run = hull_run,                                                                           \
        .dump = hull_dump,                                                                         \
        .destroy = hull_destroy,                                                                   \
    };

UPSAMPLE(upsample_sh2, hull_sh_standard, 2,
         "half resolution, joint bilateral upsampling of light by moments up to order 2")
UPSAMPLE(upsample_sh4, hull_sh_standard, 4,
         "quarter resolution, joint bilateral upsampling of light by moments up to order 2")
UPSAMPLE(
    upsample_sh8, hull_sh_standard, 8,
    "an eighth of the resolution, joint bilateral upsampling of light by moments up to order 2")
UPSAMPLE(upsample_far, hull_far_standard, hull_far_standard.factor,
         "near lights at every pixel, joint bilateral upsampling of the far light by moments")
