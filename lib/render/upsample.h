/* upsample.h: lighting at a low resolution, brought to the pixels by joint bilateral upsampling. */
#ifndef RENDER_UPSAMPLE_H
#define RENDER_UPSAMPLE_H

#include "render.h"

/* Push constants of the shaders in shaders/upsample; see sample.glsl. */
typedef struct upsample_settings {
    uint32_t factor, blocks_x, blocks_y; /* the blocks follow from the frame */
    float plane, power, least;
} upsample_settings;

gpu_status upsample_create(render_frame *frame, const upsample_settings *settings, void **state);

extern const render_pipeline upsample2_pipeline, upsample4_pipeline, upsample8_pipeline;

#endif
