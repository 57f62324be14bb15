#version 450
#extension GL_GOOGLE_include_directive : require
// mean.comp: the irradiance at a few hundred pixels on a grid, of which mean_sum.comp takes the mean,
// from lights that are taken together as soon as each sees them as a small thing.
#define COUNTERS_BINDING 2
#define COUNTERS_SHARED
#include "../common/frame.glsl"
#include "../common/counters.glsl"
#include "hull.glsl"
#include "tree.glsl"
#include "../common/form_factor.glsl"

layout(local_size_x = 32) in; // and as many groups as the grid has rows

layout(set = 0, binding = 3) uniform sampler2D position_image;
layout(set = 0, binding = 4) uniform usampler2D normal_image;
layout(set = 0, binding = 5, std430) writeonly buffer Samples
{
    vec2 samples[]; // irradiance; 1, or 0 without a surface
};

const float ROUGH = 0.05; // error of a light that stands for many, over its own contribution

void main()
{
    uvec2 grid = uvec2(32u, gl_NumWorkGroups.x);
    uvec2 place = uvec2(gl_LocalInvocationIndex, gl_WorkGroupID.x);
    ivec2 pixel = ivec2((2u * place + 1u) * view.size.xy / (2u * grid));
    vec4 position = texelFetch(position_image, pixel, 0);
    vec3 n = unpack_normal(texelFetch(normal_image, pixel, 0).x), sum = vec3(0.0);
    bool surface = position.w > 0.0;
    uint done = 0u;
    for (uint at = surface ? 0u : nodes_end; at < nodes_end; done++) {
        float d2;
        Node node = read_node(at);
        Light l = node_light(at);
        bool take = stand_error(node, position.xyz, d2) <= ROUGH;
        vec3 e = take ? light_exitance(l) : vec3(0.0);
        sum += e * form_factor(l, position.xyz, n);
        at = take ? node.skip : at + 1u;
    }
    samples[place.y * grid.x + place.x] = vec2((sum.r + sum.g + sum.b) / 3.0, surface ? 1.0 : 0.0);
    counter_add_group(COUNT_EVALUATIONS, done);
}
