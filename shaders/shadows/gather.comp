#version 450
#extension GL_GOOGLE_include_directive : require
// gather.comp: irradiance with shadows at one pixel of each block, for upsample/upsample.comp. A
// dispatch does some of the lights.
#include "full.glsl"
#define SAMPLE_LIGHTS
#include "../upsample/sample.glsl"

layout(local_size_x = 64) in;

layout(set = 0, binding = 9, rgba32ui) uniform uimage2D sample_light; // w: normal
layout(set = 0, binding = 10, rgba32f) writeonly uniform image2D sample_position;

void main()
{
    uint index = gl_GlobalInvocationID.x, rays = 0u;
    ivec2 block = ivec2(index % blocks_x, index / blocks_x), pixel = ivec2(0);
    bool inside = index < blocks_x * blocks_y;
    vec4 position = vec4(0.0);
    if (inside)
        pixel = block_pixel(block, position_image, position);
    Surface s = surface_at(pixel);
    s.there = inside && position.w > 0.0;
    vec3 irradiance = full_irradiance(s, first_light, last_light, rays);
    uint packed = s.there ? texelFetch(normal_image, pixel, 0).x : 0u;
    if (inside) {
        if (first_light > 0u)
            irradiance = uintBitsToFloat(imageLoad(sample_light, block).rgb) + irradiance;
        imageStore(sample_light, block, uvec4(floatBitsToUint(irradiance), packed));
        imageStore(sample_position, block, position);
    }
    counter_add_group(COUNT_EVALUATIONS, s.there ? last_light - first_light : 0u);
    counter_add_group(COUNT_SAMPLES, s.there && first_light == 0u ? 1u : 0u);
    count_rays(rays);
}
