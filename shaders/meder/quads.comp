#version 450
#extension GL_GOOGLE_include_directive : require
// quads.comp: a quad for each segment: the list of all boxes, tile after tile, and how many indices
// are to be drawn. A work group is a tile, and adds up what the tiles before it have.
#define COUNTERS_BINDING 1
#include "../common/frame.glsl"
#include "../common/counters.glsl"
#include "meder.glsl"

layout(local_size_x = 64) in;

layout(set = 0, binding = 2, std430) readonly buffer Counts { uint counts[]; };
layout(set = 0, binding = 3, std430) writeonly buffer Quads { uint quads[]; }; // indices of boxes
layout(set = 0, binding = 4, std430) writeonly buffer Indirect { uint indirect[5]; };

shared uint first;

void main()
{
    uint tile = gl_WorkGroupID.x;
    if (gl_LocalInvocationIndex == 0u)
        first = 0u;
    barrier();
    uint sum = 0u;
    for (uint i = gl_LocalInvocationIndex; i < tile; i += 64u)
        sum += counts[i];
    atomicAdd(first, sum);
    barrier();
    for (uint i = gl_LocalInvocationIndex; i < counts[tile]; i += 64u)
        quads[first + i] = tile * TEXELS + i;
    if (tile == TILES * TILES - 1u && gl_LocalInvocationIndex == 0u) {
        uint count = first + counts[tile];
        indirect[0] = 6u * count;
        indirect[1] = 1u;
        indirect[2] = indirect[3] = indirect[4] = 0u;
        counter_add(COUNT_QUADS, count);
    }
}
