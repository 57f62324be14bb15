// trace.glsl: rays against the scene's triangles: down a tree of boxes (lib/render/bvh.h), all rays
// of a subgroup together: where one of them has to go all go. Each invocation reads a word of a
// node, and all have them from each other: on llvmpipe a word read costs as much as a box tested,
// and what a branch skips as what it does. In subgroups of 4 each reads two. Before including it:
//     #define TRACE_NODES_BINDING 5, #define TRACE_TRIANGLES_BINDING 6
#ifndef TRACE_GLSL
#define TRACE_GLSL

#extension GL_KHR_shader_subgroup_arithmetic : require
#extension GL_KHR_shader_subgroup_shuffle : require

#include "ray.glsl"

layout(set = 0, binding = TRACE_NODES_BINDING, std430) readonly buffer TraceNodes
{
    uint trace_nodes[]; // eight a node
};
layout(set = 0, binding = TRACE_TRIANGLES_BINDING, std430) readonly buffer TraceTriangles
{
    float trace_triangles[]; // twelve a triangle
};

const uint TRACE_EMPTY = 0x7fffffffu;
const uint TRACE_LEAF = 0x80000000u;
const uint TRACE_NONE = 0xffffffffu;
const uint TRACE_STACK = 64u;

// Drivers may end loops that run long (llvmpipe does after 65,535 turns of all loops of an
// invocation together): true where a ray was not followed to its end.
bool trace_gave_up = false;

// Where the invocations have eight values: a the first of them, or all, b the last four.
#define TRACE_BY_FOUR (gl_SubgroupSize < 8u)
#define TRACE_FROM(a, b, k) subgroupShuffle(TRACE_BY_FOUR && k > 3u ? b : a, TRACE_BY_FOUR ? k & 3u : k)
#define TRACE_POINT(a, b, k) \
    vec3(TRACE_FROM(a, b, k), TRACE_FROM(a, b, (k + 1u)), TRACE_FROM(a, b, (k + 2u)))

// The bits of all rays.
uint trace_or(uint bits)
{
    if (gl_SubgroupSize == 8u) {
        bits |= subgroupShuffle(bits, gl_SubgroupInvocationID ^ 4u);
        bits |= subgroupShuffle(bits, gl_SubgroupInvocationID ^ 2u);
        return bits | subgroupShuffle(bits, gl_SubgroupInvocationID ^ 1u);
    }
    return subgroupOr(bits);
}

bool trace_any(bool here) // in the subgroup
{
    return trace_or(here ? 1u : 0u) != 0u;
}

float trace_axis(vec3 v, uint axis)
{
    return axis == 0u ? v.x : axis == 1u ? v.y : v.z;
}

// The number of a triangle hit, in the order of the leaves, ray.far where; TRACE_NONE: none. any:
// the first one found, else the nearest. All invocations of the subgroup call it together; those
// without a ray have a far below 0.
uint trace_scene(inout Ray ray, uint root, bool any)
{
    uint lane = gl_SubgroupInvocationID & (TRACE_BY_FOUR ? 3u : 7u), next = TRACE_BY_FOUR ? 4u : 0u;
    uvec2 axis = uvec2(lane, lane + next) % 3u;
    // origin and step of the boxes' corners
    vec2 grid = vec2(uintBitsToFloat(trace_nodes[lane]), uintBitsToFloat(trace_nodes[lane + next]));
    vec3 origin = TRACE_POINT(grid.x, grid.y, 0u), steps = TRACE_POINT(grid.x, grid.y, 3u);
    vec2 base = vec2(trace_axis(origin, axis.x), trace_axis(origin, axis.y));
    vec2 stride = vec2(trace_axis(steps, axis.x), trace_axis(steps, axis.y));
    uint stack[TRACE_STACK];
    stack[0] = TRACE_EMPTY;
    uint top = 1u, node = root, found = TRACE_NONE;
    do {
        do {
            uvec2 word = uvec2(trace_nodes[8u * node + lane], 0u);
            word.y = TRACE_BY_FOUR ? trace_nodes[8u * node + lane + next] : word.x;
            vec2 low = base + stride * vec2(word & 0xffffu);
            vec2 high = base + stride * vec2(word >> 16);
            float first = trace_box(ray, TRACE_POINT(low.x, low.y, 0u), TRACE_POINT(high.x, high.y, 0u));
            float second = trace_box(ray, TRACE_POINT(low.x, low.y, 3u), TRACE_POINT(high.x, high.y, 3u));
            uint here = TRACE_FROM(word.x, word.y, 6u), there = TRACE_FROM(word.x, word.y, 7u);
            uint hits = trace_or((first < 3e38 ? 1u : 0u) | (second < 3e38 ? 2u : 0u)
                                 | (second < first && first < 3e38 ? 4u : 0u));
            bool swap = hits == 2u || hits == 7u, both = (hits & 3u) == 3u;
            stack[top] = swap ? here : there;
            node = (hits & 3u) == 0u ? stack[top - 1u] : swap ? there : here;
            top = both ? top + 1u : (hits & 3u) == 0u ? top - 1u : top;
        } while (node < TRACE_EMPTY);
        uint t = (node & 0x7fffffffu) >> 3, last = t + (node & 7u);
        while (node > TRACE_EMPTY) {
            float some = trace_triangles[12u * t + lane];
            float more = TRACE_BY_FOUR ? trace_triangles[12u * t + lane + next] : some;
            float rest = trace_triangles[12u * t + 8u + (lane & 3u)];
            if (trace_triangle(ray, TRACE_POINT(some, more, 0u), TRACE_POINT(some, more, 4u),
                               TRACE_POINT(rest, rest, 0u)))
                found = t;
            t++;
            if (t > last) {
                ray.far = any && found != TRACE_NONE ? -1.0 : ray.far;
                top--;
                node = trace_any(ray.far >= 0.0) ? stack[top] : TRACE_EMPTY;
                t = (node & 0x7fffffffu) >> 3;
                last = t + (node & 7u);
            }
        }
    } while (node != TRACE_EMPTY);
    trace_gave_up = trace_gave_up || node != TRACE_EMPTY;
    return found;
}

#endif
