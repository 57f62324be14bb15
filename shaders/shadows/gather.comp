#version 450
#extension GL_GOOGLE_include_directive : require
// gather.comp: irradiance with shadows at one pixel of each block, for upsample/upsample.comp.
#include "full.glsl"
#include "../upsample/sample.glsl"

layout(local_size_x = 64) in;

layout(set = 0, binding = 9, rgba32ui) writeonly uniform uimage2D sample_light; // w: normal
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
    vec3 irradiance = full_irradiance(s, 0u, light_count, rays);
    uint packed = s.there ? texelFetch(normal_image, pixel, 0).x : 0u;
    if (inside) {
        imageStore(sample_light, block, uvec4(floatBitsToUint(irradiance), packed));
        imageStore(sample_position, block, position);
    }
    counter_add_group(COUNT_EVALUATIONS, s.there ? light_count : 0u);
    counter_add_group(COUNT_SAMPLES, s.there ? 1u : 0u);
    count_rays(rays);
}
