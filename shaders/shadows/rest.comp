#version 450
#extension GL_GOOGLE_include_directive : require
// rest.comp: the pixels that upsample/upsample.comp found no sample for, by all rays. A work
// group does 64 of them, one after the other.
#include "full.glsl"

layout(local_size_x = 64) in;

layout(set = 0, binding = 9, rgba32f) writeonly uniform image2D light_image;
layout(set = 0, binding = 10, std430) readonly buffer Arguments
{
    uint exact_groups[3];
    uint exact_count; // 1 more than there are
};
layout(set = 0, binding = 11, std430) readonly buffer Exact { uint exact_pixels[]; };

void main()
{
    uint first = gl_WorkGroupID.x * 64u, last = min(first + 64u, exact_count - 1u), rays = 0u;
    uint at = first;
    for (; at < last; at++) {
        ivec2 pixel = ivec2(exact_pixels[at] % view.size.x, exact_pixels[at] / view.size.x);
        vec3 irradiance = full_irradiance(surface_at(pixel), 0u, light_count, rays);
        if (gl_LocalInvocationIndex == 0u) {
            imageStore(light_image, pixel, vec4(irradiance, 1.0));
            counter_add(COUNT_EVALUATIONS, light_count);
            counter_add(COUNT_SAMPLES, 1u);
        }
    }
    trace_gave_up = trace_gave_up || at < last;
    count_rays(rays);
}
