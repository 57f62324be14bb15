#version 450
#extension GL_GOOGLE_include_directive : require
// shadows.comp: ground truth of area lights with shadows: every pixel, every light, all 64 rays.
#include "full.glsl"

layout(local_size_x = 16, local_size_y = 8) in;

layout(push_constant) uniform Push
{
    uint first_row; // of this dispatch
};
layout(set = 0, binding = 9, rgba32f) writeonly uniform image2D light_image;

void main()
{
    ivec2 pixel = ivec2(gl_GlobalInvocationID.x, gl_GlobalInvocationID.y + first_row);
    Surface s = surface_at(pixel);
    uint rays = 0u;
    vec3 irradiance = full_irradiance(s, rays);
    if (s.there)
        imageStore(light_image, pixel, vec4(irradiance, 1.0));
    counter_add_group(COUNT_EVALUATIONS, s.there ? light_count : 0u);
    counter_add_group(COUNT_RAYS, rays);
    counter_add_group(COUNT_SAMPLES, s.there ? 1u : 0u);
}
