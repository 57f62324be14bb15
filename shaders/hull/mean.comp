#version 450
#extension GL_GOOGLE_include_directive : require
// mean.comp: the irradiance at a few hundred pixels on a grid, of which mean_sum.comp takes the mean.
#define COUNTERS_BINDING 2
#define COUNTERS_SHARED
#include "../common/frame.glsl"
#include "../common/counters.glsl"
#include "../common/form_factor.glsl"

layout(local_size_x = 32) in; // and as many groups as the grid has rows

layout(set = 0, binding = 3) uniform sampler2D position_image;
layout(set = 0, binding = 4) uniform usampler2D normal_image;
layout(set = 0, binding = 5, std430) writeonly buffer Samples
{
    vec2 samples[]; // irradiance; 1, or 0 without a surface
};

void main()
{
    uvec2 grid = uvec2(32u, gl_NumWorkGroups.x);
    uvec2 place = uvec2(gl_LocalInvocationIndex, gl_WorkGroupID.x);
    ivec2 pixel = ivec2((2u * place + 1u) * view.size.xy / (2u * grid));
    vec4 position = texelFetch(position_image, pixel, 0);
    vec3 n = unpack_normal(texelFetch(normal_image, pixel, 0).x), sum = vec3(0.0);
    uint count = position.w > 0.0 ? view.size.z : 0u;
    for (uint i = 0u; i < count; i++)
        sum += light_exitance(lights[i]) * form_factor(lights[i], position.xyz, n);
    samples[place.y * grid.x + place.x] = vec2((sum.r + sum.g + sum.b) / 3.0, count > 0u ? 1.0 : 0.0);
    counter_add_group(COUNT_EVALUATIONS, count);
}
