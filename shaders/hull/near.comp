#version 450
#extension GL_GOOGLE_include_directive : require
// near.comp: adds the near light to the pixels of the blocks that have any. A group is a block, an
// invocation does four of its pixels, so that a light is read once for them.
#define COUNTERS_BINDING 2
#define COUNTERS_SHARED
#define CONTROL_BINDING 3
#include "../common/frame.glsl"
#include "../common/counters.glsl"
#include "../common/form_factor.glsl"
#include "hull.glsl"
#include "control.glsl"
#include "window.glsl"
#include "near.glsl"

layout(local_size_x = 16) in;

layout(set = 0, binding = 4) uniform sampler2D position_image;
layout(set = 0, binding = 5) uniform usampler2D normal_image;
layout(set = 0, binding = 6, rgba32f) uniform image2D light_image;
layout(set = 0, binding = 7, std430) readonly buffer TileLists
{
    uint tile_lists[];
};
layout(set = 0, binding = 8, std430) readonly buffer NearLists
{
    uint near_lists[];
};
layout(set = 0, binding = 9, std430) readonly buffer NearBlocks
{
    uint near_blocks[];
};

void main()
{
    uint block = near_blocks[gl_WorkGroupID.x], tile = block / uint(ACROSS * ACROSS);
    uint place = block % uint(ACROSS * ACROSS), list = block * (MOST_NEAR + 1u);
    ivec2 pixel = TILE * ivec2(tile % tiles_x, tile / tiles_x)
        + BLOCK * ivec2(place % uint(ACROSS), place / uint(ACROSS))
        + ivec2(gl_LocalInvocationIndex & 7u, gl_LocalInvocationIndex >> 3);
    uint count = near_lists[list];
    bool own = count <= MOST_NEAR;
    if (!own) {
        list = tile * (view.size.z + 1u);
        count = tile_lists[list];
    }

    vec4 positions[4];
    vec3 normals[4], sums[4];
    uint lit = 0u;
    for (int i = 0; i < 4; i++) {
        ivec2 p = pixel + ivec2(0, 2 * i);
        bool inside = all(lessThan(p, ivec2(view.size.xy)));
        positions[i] = inside ? texelFetch(position_image, p, 0) : vec4(0.0);
        normals[i] = unpack_normal(inside ? texelFetch(normal_image, p, 0).x : 0u);
        sums[i] = vec3(0.0);
        lit += positions[i].w > 0.0 ? 1u : 0u;
    }
    for (uint j = 1u; j <= count; j++) {
        Light l = lights[own ? near_lists[list + j] : tile_lists[list + j]];
        for (int i = 0; i < 4; i++) {
            vec3 gradient;
            float weight = near_weight(l, positions[i].xyz, positions[i].w, mean, gradient);
            sums[i] += light_exitance(l) * (weight * form_factor(l, positions[i].xyz, normals[i]));
        }
    }
    for (int i = 0; i < 4; i++) {
        ivec2 p = pixel + ivec2(0, 2 * i);
        if (positions[i].w > 0.0) {
            vec4 light = imageLoad(light_image, p);
            if (light.w > 0.0) // not those that are lit exactly
                imageStore(light_image, p, vec4(light.rgb + sums[i], light.w));
        }
    }
    counter_add_group(COUNT_EVALUATIONS, lit * count);
}
