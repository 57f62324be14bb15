#version 450
#extension GL_GOOGLE_include_directive : require
// rest.comp: the pixels that upsample/upsample.comp found no sample for, by all rays to some
// of the lights.
#include "full.glsl"

layout(local_size_x = 64) in;

layout(push_constant) uniform Push
{
    uint first_light, last_light; // of this dispatch, without the last
};
layout(set = 0, binding = 9, rgba32f) uniform image2D light_image;
layout(set = 0, binding = 10, std430) readonly buffer Arguments
{
    uint exact_groups[3];
    uint exact_count; // 1 more than there are
};
layout(set = 0, binding = 11, std430) readonly buffer Exact { uint exact_pixels[]; };

void main()
{
    bool inside = gl_GlobalInvocationID.x < exact_count - 1u;
    uint index = inside ? exact_pixels[gl_GlobalInvocationID.x] : 0u, rays = 0u;
    ivec2 pixel = ivec2(index % view.size.x, index / view.size.x);
    Surface s = surface_at(pixel);
    s.there = s.there && inside;
    vec3 irradiance = full_irradiance(s, first_light, last_light, rays);
    if (s.there) {
        vec3 before = first_light > 0u ? imageLoad(light_image, pixel).rgb : vec3(0.0);
        imageStore(light_image, pixel, vec4(before + irradiance, 1.0));
    }
    counter_add_group(COUNT_EVALUATIONS, s.there ? last_light - first_light : 0u);
    counter_add_group(COUNT_SAMPLES, s.there && first_light == 0u ? 1u : 0u);
    count_rays(rays);
}
