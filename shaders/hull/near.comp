#version 450
#extension GL_GOOGLE_include_directive : require
// near.comp: adds the near light to the pixels of the blocks that have any. A group is a block of
// 8 x 8 pixels, an invocation does 4 x 2 of them: it tests the block's lights against the bounds of
// its own pixels, 32 at a time into the bits of a word, then evaluates those that are left.
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

layout(local_size_x = 8) in;

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

const int PIXELS = 8;

void main()
{
    uint block = near_blocks[gl_WorkGroupID.x], tile = block / uint(ACROSS * ACROSS);
    uint place = block % uint(ACROSS * ACROSS), list = block * (MOST_NEAR + 1u);
    ivec2 pixel = TILE * ivec2(tile % tiles_x, tile / tiles_x)
        + BLOCK * ivec2(place % uint(ACROSS), place / uint(ACROSS))
        + ivec2(4u * (gl_LocalInvocationIndex & 1u), 2u * (gl_LocalInvocationIndex >> 1));
    uint count = near_lists[list];
    bool own = count <= MOST_NEAR;
    if (!own) {
        list = tile * (view.size.z + 1u);
        count = tile_lists[list];
    }

    vec4 positions[PIXELS];
    vec3 normals[PIXELS], sums[PIXELS];
    Bounds bounds = Bounds(vec4(3e38, 3e38, 3e38, 0.0), vec4(-3e38));
    uint surfaces = 0u, done = 0u;
    for (int i = 0; i < PIXELS; i++) {
        ivec2 p = pixel + ivec2(i & 3, i >> 2);
        bool inside = all(lessThan(p, ivec2(view.size.xy)));
        vec4 position = inside ? texelFetch(position_image, p, 0) : vec4(0.0);
        normals[i] = unpack_normal(inside ? texelFetch(normal_image, p, 0).x : 0u);
        positions[i] = position;
        sums[i] = vec3(0.0);
        if (position.w > 0.0) {
            bounds.low = vec4(min(bounds.low.xyz, position.xyz), max(bounds.low.w, position.w));
            bounds.high.xyz = max(bounds.high.xyz, position.xyz);
            surfaces++;
        }
    }
    count = surfaces > 0u ? count : 0u;
    for (uint first = 1u; first <= count; first += 32u) {
        uint some = min(32u, count + 1u - first), hits = 0u;
        for (uint j = 0u; j < some; j++) {
            uint light = own ? near_lists[list + first + j] : tile_lists[list + first + j];
            hits |= may_be_near(lights[light], bounds, mean) ? 1u << j : 0u;
        }
        done += some + surfaces * uint(bitCount(hits));
        for (; hits != 0u; hits &= hits - 1u) {
            uint at = list + first + uint(findLSB(hits));
            Light l = lights[own ? near_lists[at] : tile_lists[at]];
            for (int i = 0; i < PIXELS; i++) {
                vec3 gradient;
                float weight = near_weight(l, positions[i].xyz, positions[i].w, mean, gradient);
                sums[i] += light_exitance(l) * (weight * form_factor(l, positions[i].xyz, normals[i]));
            }
        }
    }
    for (int i = 0; i < PIXELS; i++) {
        ivec2 p = pixel + ivec2(i & 3, i >> 2);
        if (positions[i].w > 0.0) {
            vec4 light = imageLoad(light_image, p);
            if (light.w > 0.0) // not those that are lit exactly
                imageStore(light_image, p, vec4(light.rgb + sums[i], light.w));
        }
    }
    counter_add_group(COUNT_EVALUATIONS, done);
}
