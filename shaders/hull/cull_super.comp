#version 450
#extension GL_GOOGLE_include_directive : require
// cull_super.comp: bounds of blocks from those of rows; for each square of 4 x 4 blocks, one
// invocation, the lights that may be near to it, in their order.
#define COUNTERS_BINDING 2
#define COUNTERS_SHARED
#define CONTROL_BINDING 3
#include "../common/frame.glsl"
#include "../common/counters.glsl"
#include "../common/lights.glsl"
#include "hull.glsl"
#include "control.glsl"
#include "window.glsl"
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
layout(set = 0, binding = 6, std430) writeonly buffer SuperLists
{
    uint super_lists[]; // light_count + 1 each: how many, then which
};

void main()
{
    uint supers_x = (tiles_x + 1u) / 2u, supers = supers_x * ((tiles_y + 1u) / 2u);
    uint index = gl_GlobalInvocationID.x, count = view.size.z, evaluations = 0u;
    ivec2 first = SUPER * ivec2(index % supers_x, index / supers_x);
    ivec2 blocks = 2 * ivec2(tiles_x, tiles_y);
    Bounds all_of_it = Bounds(vec4(3e38, 3e38, 3e38, 0.0), vec4(-3e38));
    for (int i = 0; i < SUPER * SUPER; i++) {
        ivec2 block = first + ivec2(i % SUPER, i / SUPER);
        if (index < supers && all(lessThan(block, blocks))) {
            Bounds b = Bounds(vec4(3e38, 3e38, 3e38, 0.0), vec4(-3e38));
            uint tile = uint(block.y / 2) * tiles_x + uint(block.x / 2);
            uint row = tile * uint(TILE) + uint(BLOCK * (block.y & 1));
            for (uint y = 0u; y < uint(BLOCK); y++) {
                Bounds r = row_bounds[2u * (row + y) + uint(block.x & 1)];
                b.low = vec4(min(b.low.xyz, r.low.xyz), max(b.low.w, r.low.w));
                b.high = max(b.high, r.high);
            }
            block_bounds[block.y * blocks.x + block.x] = b;
            all_of_it.low = vec4(min(all_of_it.low.xyz, b.low.xyz), max(all_of_it.low.w, b.low.w));
            all_of_it.high = max(all_of_it.high, b.high);
        }
    }
    if (index < supers && all_of_it.low.w > 0.0) {
        uint at = index * (count + 1u), listed = 0u;
        for (uint i = 0u; i < count; i++)
            if (may_be_near(lights[i], all_of_it, mean))
                super_lists[at + ++listed] = i;
        super_lists[at] = listed;
        evaluations = count;
    }
    counter_add_group(COUNT_EVALUATIONS, evaluations);
}
