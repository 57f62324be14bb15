#version 450
#extension GL_GOOGLE_include_directive : require
// shadows.comp: ground truth of area lights with shadows: every pixel, all 64 rays to some of the
// lights.
#include "full.glsl"

layout(local_size_x = 16, local_size_y = 8) in;

layout(push_constant) uniform Push
{
    uint first_row, first_light, last_light; // of this dispatch
};
layout(set = 0, binding = 9, rgba32f) uniform image2D light_image;

void main()
{
    ivec2 pixel = ivec2(gl_GlobalInvocationID.x, gl_GlobalInvocationID.y + first_row);
    Surface s = surface_at(pixel);
    uint rays = 0u;
    vec3 irradiance = full_irradiance(s, first_light, last_light, rays);
    if (s.there) {
        vec3 before = first_light > 0u ? imageLoad(light_image, pixel).rgb : vec3(0.0);
        imageStore(light_image, pixel, vec4(before + irradiance, 1.0));
    }
    counter_add_group(COUNT_EVALUATIONS, s.there ? last_light - first_light : 0u);
    counter_add_group(COUNT_SAMPLES, s.there && first_light == 0u ? 1u : 0u);
    count_rays(rays);
}
