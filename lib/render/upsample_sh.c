/* Upsampling of samples that know the light for every normal, by the passes that hull.c lists: of
 * all lights, and of the far ones alone beside near lights at every pixel. */
#include "hull.h"

/* Weights chosen by bench/rivals_tried.md; everything else, near lights above all, as the hull has
 * it. tau 0: there are no near lights. */
#define UPSAMPLE(NAME, TITLE, ...)                                                                 \
    static gpu_status create_##NAME(render_frame *frame, void **state)                             \
    {                                                                                              \
        hull_settings s = hull_standard;                                                           \
        s.kind = HULL_UPSAMPLE;                                                                    \
        __VA_ARGS__;                                                                               \
        return hull_create(frame, &s, state);                                                      \
    }                                                                                              \
    HULL_PIPELINE(NAME, TITLE, NULL)

UPSAMPLE(upsample_sh2,
         "half resolution, joint bilateral upsampling of light by moments up to order 2", s.tau = 0,
         s.factor = 2, s.plane = 0.5F, s.power = 2, s.least = 0.3F)
UPSAMPLE(upsample_sh4,
         "quarter resolution, joint bilateral upsampling of light by moments up to order 2",
         s.tau = 0, s.factor = 4, s.plane = 0.5F, s.power = 2, s.least = 0.3F)
UPSAMPLE(
    upsample_sh8,
    "an eighth of the resolution, joint bilateral upsampling of light by moments up to order 2",
    s.tau = 0, s.factor = 8, s.plane = 1, s.power = 2, s.least = 0.1F)
UPSAMPLE(upsample_far,
         "near lights at every pixel, joint bilateral upsampling of the far light by moments",
         s.factor = 10, s.plane = 1, s.power = 2, s.least = 1e-3F)
UPSAMPLE(upsample_far6, "the same with samples every six pixels", s.factor = 6, s.plane = 0.5F,
         s.power = 2, s.least = 1e-3F)
UPSAMPLE(upsample_far4, "the same with samples every four pixels", s.factor = 4, s.plane = 0.5F,
         s.power = 2, s.least = 0.1F)
