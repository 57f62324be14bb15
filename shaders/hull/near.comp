#version 450
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_control_flow_attributes : require
// near.comp: adds the near light to the pixels of the blocks that have any. A group is a block of
// 8 x 8 pixels, an invocation does 4 x 2 of them: it tests the block's lights against the bounds of
// its own pixels, then evaluates those that are left, some at a time.
#define COUNTERS_BINDING 2
#define COUNTERS_SHARED
#define CONTROL_BINDING 3
#include "../common/frame.glsl"
#include "../common/counters.glsl"
#include "hull.glsl"
#include "control.glsl"
#include "tree.glsl"
#include "../common/form_factor.glsl"
#include "near.glsl"

layout(local_size_x = 8) in;

layout(set = 0, binding = 4) uniform sampler2D position_image;
layout(set = 0, binding = 5) uniform usampler2D normal_image;
layout(set = 0, binding = 6, rgba32f) uniform image2D light_image;
layout(set = 0, binding = 7, std430) readonly buffer NearLists
{
    uint near_lists[];
};
layout(set = 0, binding = 8, std430) readonly buffer NearBlocks
{
    uint near_blocks[];
};

const int PIXELS = 8;
const uint MOST_FOUND = 32u; // lights at once
uint found[MOST_FOUND];

void main()
{
    uint block = near_blocks[gl_WorkGroupID.x], tile = block / uint(ACROSS * ACROSS);
    uint place = block % uint(ACROSS * ACROSS), list = block * (MOST_NEAR + 1u);
    ivec2 pixel = TILE * ivec2(tile % tiles_x, tile / tiles_x)
        + BLOCK * ivec2(place % uint(ACROSS), place / uint(ACROSS))
        + ivec2(4u * (gl_LocalInvocationIndex & 1u), 2u * (gl_LocalInvocationIndex >> 1));
    uint end = near_lists[list];
    bool own = end <= MOST_NEAR; // else from the tree
    end = own ? end : nodes_end;

    vec4 positions[PIXELS];
    vec3 normals[PIXELS], sums[PIXELS];
    Bounds bounds = Bounds(vec4(3e38, 3e38, 3e38, 0.0), vec4(-3e38));
    uint surfaces = 0u, done = 0u;
    [[unroll]] for (int i = 0; i < PIXELS; i++) {
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
    // lavapipe ends a loop one round after its last invocation, unless the test comes last
    uint at = 0u;
    if (surfaces > 0u && end > 0u)
        do {
            uint count = 0u;
            do {
                uint which = own ? near_lists[list + 1u + at] : at;
                Node node = read_node(which);
                bool near = may_be_near(node, bounds, mean);
                found[count] = which;
                count += near && node.leaf ? 1u : 0u;
                at = own || near ? at + 1u : node.skip;
                done++;
            } while (at < end && count < MOST_FOUND);
            done += surfaces * count;
            uint j = 0u;
            if (count > 0u)
                do {
                    Light l = node_light(found[j]);
                    vec3 e = light_exitance(l);
                    [[unroll]] for (int i = 0; i < PIXELS; i++) {
                        vec3 x = positions[i].xyz, gradient;
                        float weight = near_weight(l, x, positions[i].w, mean, gradient);
                        sums[i] += e * (weight * form_factor(l, x, normals[i]));
                    }
                } while (++j < count);
        } while (at < end);
    [[unroll]] for (int i = 0; i < PIXELS; i++) {
        ivec2 p = pixel + ivec2(i & 3, i >> 2);
        if (positions[i].w > 0.0) {
            vec4 light = imageLoad(light_image, p);
            if (light.w > 0.0) // not those that are lit exactly
                imageStore(light_image, p, vec4(light.rgb + sums[i], light.w));
        }
    }
    counter_add_group(COUNT_EVALUATIONS, done);
}
