#version 450
#extension GL_GOOGLE_include_directive : require
// cull_tile.comp: bounds of blocks from those that links.comp noted; for each tile, one invocation, the lights that
// may be near to it, in the order of the tree.
#define COUNTERS_BINDING 2
#define COUNTERS_SHARED
#define CONTROL_BINDING 3
#include "../common/frame.glsl"
#include "../common/counters.glsl"
#include "hull.glsl"
#include "control.glsl"
#include "tree.glsl"
#include "near.glsl"

layout(local_size_x = 8) in;

layout(set = 0, binding = 4, std430) readonly buffer RowBounds
{
    Bounds row_bounds[];
};
layout(set = 0, binding = 5, std430) writeonly buffer BlockBounds
{
    Bounds block_bounds[];
};
layout(set = 0, binding = 6, std430) writeonly buffer TileLists
{
    uint tile_lists[]; // MOST_TILE + 1 each: how many there are, then the first of them
};

void main()
{
    uint tile = gl_GlobalInvocationID.x, evaluations = 0u;
    bool inside = tile < tiles_x * tiles_y;
    Bounds whole = Bounds(vec4(3e38, 3e38, 3e38, 0.0), vec4(-3e38));
    for (int i = 0; i < ACROSS * ACROSS; i++) {
        if (inside) {
            Bounds b = Bounds(vec4(3e38, 3e38, 3e38, 0.0), vec4(-3e38));
            uint row = (tile * uint(TILE) + uint(BLOCK * (i / ACROSS))) / uint(ROWS);
            for (uint y = 0u; y < uint(BLOCK / ROWS); y++) {
                Bounds r = row_bounds[uint(ACROSS) * (row + y) + uint(i % ACROSS)];
                b.low = vec4(min(b.low.xyz, r.low.xyz), max(b.low.w, r.low.w));
                b.high = max(b.high, r.high);
            }
            block_bounds[tile * uint(ACROSS * ACROSS) + uint(i)] = b;
            whole.low = vec4(min(whole.low.xyz, b.low.xyz), max(whole.low.w, b.low.w));
            whole.high = max(whole.high, b.high);
        }
    }
    if (inside && whole.low.w > 0.0) {
        uint list = tile * (MOST_TILE + 1u), listed = 0u;
        for (uint at = 0u; at < nodes_end && listed <= MOST_TILE; evaluations++) {
            Node node = read_node(at);
            bool near = may_be_near(node, whole, mean);
            if (near && node.leaf) {
                listed++;
                if (listed <= MOST_TILE)
                    tile_lists[list + listed] = at;
            }
            at = near ? at + 1u : node.skip;
        }
        tile_lists[list] = listed;
    }
    counter_add_group(COUNT_EVALUATIONS, evaluations);
}
