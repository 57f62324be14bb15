#version 450
#extension GL_GOOGLE_include_directive : require
// part.comp: splits the quads of a level that split.glsl chose and that find room; the others are
// leaves, or lit exactly.
#include "../common/frame.glsl"
#include "hull.glsl"
#include "control.glsl"

layout(local_size_x = 64) in;

layout(set = 0, binding = 2, std430) buffer Quads
{
    Quad quads[];
};
layout(set = 0, binding = 3, std430) writeonly buffer Leaves
{
    uint leaves[];
};
layout(set = 0, binding = 4, std430) readonly buffer Masks
{
    uint masks[];
};
layout(set = 0, binding = 5, std430) buffer Arguments
{
    uint exact_groups[3];
    uint exact_count;
};
layout(set = 0, binding = 6, std430) writeonly buffer Exact
{
    uint exact_pixels[];
};

#include "leave.glsl"

void main()
{
    uint index = gl_GlobalInvocationID.x;
    if (index >= quad_count[level])
        return;
    index += quad_first[level];
    Quad q = quads[index];
    if (q.component == NONE)
        return;
    ivec2 size = unpack_size(q.size);
    uint children = unpack_rank(q.size) < least_rank ? 0u : q.size >> 24 & 0xfu;
    if (children == 0u) {
        if ((q.size & EXACT_BIT) != 0u) {
            leave_to_exact(q.component, unpack_pixel(q.origin) - tile_origin(q.component), size);
            return;
        }
        leaves[atomicAdd(leaf_count, 1u)] = index;
        return;
    }
    uint at = quad_first[level + 1u] + atomicAdd(quad_count[level + 1u], uint(bitCount(children)));
    for (int i = 0; i < 4; i++)
        if ((children >> i & 1u) != 0u) {
            ivec2 part = ivec2(i & 1, i >> 1);
            quads[at].component = q.component;
            quads[at].parent = index;
            quads[at].origin = pack_pixel(unpack_pixel(q.origin) + part * first_part(size));
            quads[at++].size = pack_pixel(part_size(size, part)) | (q.size & EVEN_BIT);
        }
}
