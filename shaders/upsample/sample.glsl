// sample.glsl: what the upsampling passes share. The image is cut into blocks of factor x factor
// pixels; one pixel of each is lit, and stands for the block's middle.
#ifndef SAMPLE_GLSL
#define SAMPLE_GLSL

layout(push_constant) uniform Push
{
    uint factor;
    uint blocks_x, blocks_y;
    float plane;    // distance from the pixel's plane, in blocks, at which a sample counts 1/e
    float power;    // of the cosine between both normals, see likeness.glsl
    float least;    // sum of weights below which a pixel is lit exactly
#ifdef SAMPLE_LIGHTS
    uint first_light, last_light; // of this dispatch, without the last
#endif
};

#include "block.glsl"

#endif
