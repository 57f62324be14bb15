#version 450
#extension GL_GOOGLE_include_directive : require
// gather.comp: irradiance of every light at one pixel of each block.
#define COUNTERS_BINDING 2
#define COUNTERS_SHARED
#include "../common/frame.glsl"
#include "../common/counters.glsl"
#include "../common/form_factor.glsl"
#include "sample.glsl"

layout(local_size_x = 64) in;

layout(set = 0, binding = 3) uniform sampler2D position_image;
layout(set = 0, binding = 4) uniform usampler2D normal_image;
layout(set = 0, binding = 5, rgba32ui) writeonly uniform uimage2D sample_light; // w: normal
layout(set = 0, binding = 6, rgba32f) writeonly uniform image2D sample_position;

shared Light staged[64];

void main()
{
    uint index = gl_GlobalInvocationID.x, count = view.size.z;
    ivec2 block = ivec2(index % blocks_x, index / blocks_x);
    bool inside = index < blocks_x * blocks_y;
    vec4 position = vec4(0.0);
    ivec2 pixel = ivec2(0);
    if (inside)
        pixel = block_pixel(block, position_image, position);
    bool surface = position.w > 0.0;
    uint packed = surface ? texelFetch(normal_image, pixel, 0).x : 0u;
    vec3 n = unpack_normal(packed), irradiance = vec3(0.0);
    for (uint first = 0u; first < count; first += 64u) {
        uint mine = first + gl_LocalInvocationIndex;
        if (mine < count)
            staged[gl_LocalInvocationIndex] = lights[mine];
        barrier();
        uint last = surface ? min(64u, count - first) : 0u;
        for (uint i = 0u; i < last; i++)
            irradiance += light_exitance(staged[i]) * form_factor(staged[i], position.xyz, n);
        barrier();
    }
    if (inside) {
        imageStore(sample_light, block, uvec4(floatBitsToUint(irradiance), packed));
        imageStore(sample_position, block, position);
    }
    counter_add_group(COUNT_EVALUATIONS, surface ? count : 0u);
}
