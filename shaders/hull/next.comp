#version 450
#extension GL_GOOGLE_include_directive : require
// next.comp: turns counts into numbers of work groups; one invocation.
#define COUNTERS_BINDING 2
#include "../common/frame.glsl"
#include "../common/counters.glsl"
#include "hull.glsl"
#include "control.glsl"

layout(local_size_x = 1) in;

void main()
{
    claim_groups[0] = (5u * min(quad_count[level], quad_first[min(level + 1u, LEVELS)] - quad_first[min(level, LEVELS)]) + 63u) / 64u;
    leaf_groups[0] = (leaf_count + 63u) / 64u;
    gather_first = gather_end;
    gather_end = min(vertex_count, vertex_capacity);
    gather_groups[0] = (gather_end - gather_first + 63u) / 64u;
    split_groups[0] = (quad_count[level] + 63u) / 64u;
    near_groups[0] = near_count;
    claim_groups[1] = claim_groups[2] = gather_groups[1] = gather_groups[2] = 1u;
    split_groups[1] = split_groups[2] = leaf_groups[1] = leaf_groups[2] = 1u;
    near_groups[1] = near_groups[2] = 1u;
    draw_instances = even_instances = 1u;
    if (level == LEVELS) { // the last time
        counter_add(COUNT_QUADS, leaf_count);
        counter_add(COUNT_VERTICES, gather_end);
    }
}
