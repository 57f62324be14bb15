#version 450
#extension GL_GOOGLE_include_directive : require
// cull.comp: for each block the lights that may be near to it, of those of its tile.
#define COUNTERS_BINDING 2
#define COUNTERS_SHARED
#define CONTROL_BINDING 3
#include "../common/frame.glsl"
#include "../common/counters.glsl"
#include "hull.glsl"
#include "control.glsl"
#include "tree.glsl"
#include "near.glsl"

layout(local_size_x = 64) in;

layout(set = 0, binding = 4, std430) readonly buffer BlockBounds
{
    Bounds block_bounds[];
};
layout(set = 0, binding = 5, std430) readonly buffer TileLists
{
    uint tile_lists[];
};
layout(set = 0, binding = 6, std430) writeonly buffer NearLists
{
    uint near_lists[]; // MOST_NEAR + 1 each: how many there are, then the first of them
};
layout(set = 0, binding = 7, std430) writeonly buffer NearBlocks
{
    uint near_blocks[]; // those with a list that is not empty
};

void main()
{
    uint index = gl_GlobalInvocationID.x, tile = index / uint(ACROSS * ACROSS), tested = 0u;
    if (tile < tiles_x * tiles_y && block_bounds[index].low.w > 0.0) {
        Bounds b = block_bounds[index];
        uint from = tile * (MOST_TILE + 1u), list = index * (MOST_NEAR + 1u), listed = 0u;
        uint end = tile_lists[from];
        bool own = end <= MOST_TILE; // else from the tree
        end = own ? end : nodes_end;
        for (uint at = 0u; at < end && listed <= MOST_NEAR; tested++) {
            uint which = own ? tile_lists[from + 1u + at] : at;
            Node node = read_node(which);
            bool near = may_be_near(node, b, mean);
            if (near && node.leaf) {
                listed++;
                if (listed <= MOST_NEAR)
                    near_lists[list + listed] = which;
            }
            at = own || near ? at + 1u : node.skip;
        }
        near_lists[list] = listed;
        if (listed > 0u)
            near_blocks[atomicAdd(near_count, 1u)] = index;
    }
    counter_add_group(COUNT_EVALUATIONS, tested);
}
