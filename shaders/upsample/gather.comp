#version 450
#extension GL_GOOGLE_include_directive : require
// gather.comp: irradiance of every light at one pixel of each block.
#define COUNTERS_BINDING 2
#define COUNTERS_SHARED
#include "../common/frame.glsl"
#include "../common/counters.glsl"
#include "sample.glsl"

layout(set = 0, binding = 3) uniform sampler2D position_image;
layout(set = 0, binding = 4) uniform usampler2D normal_image;
layout(set = 0, binding = 5, rgba32ui) writeonly uniform uimage2D sample_light; // w: normal
layout(set = 0, binding = 6, rgba32f) writeonly uniform image2D sample_position;

bool read_place(uvec2 block, out vec3 x, out vec3 n)
{
    vec4 position = vec4(0.0);
    n = vec3(0.0);
    if (all(lessThan(block, uvec2(blocks_x, blocks_y)))) {
        ivec2 pixel = block_pixel(ivec2(block), position_image, position);
        n = unpack_normal(texelFetch(normal_image, pixel, 0).x);
    }
    x = position.xyz;
    return position.w > 0.0;
}

void write_place(uvec2 block, bool surface, vec3 irradiance)
{
    if (any(greaterThanEqual(block, uvec2(blocks_x, blocks_y))))
        return;
    vec4 position;
    ivec2 pixel = block_pixel(ivec2(block), position_image, position);
    uint packed = surface ? texelFetch(normal_image, pixel, 0).x : 0u;
    imageStore(sample_light, ivec2(block), uvec4(floatBitsToUint(irradiance), packed));
    imageStore(sample_position, ivec2(block), position);
}

#include "../exact/four.glsl"
