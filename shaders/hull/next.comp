#version 450
#extension GL_GOOGLE_include_directive : require
// next.comp: turns counts into numbers of work groups; one invocation.
#define COUNTERS_BINDING 2
#include "../common/frame.glsl"
#include "../common/counters.glsl"
#include "hull.glsl"
#include "control.glsl"

layout(local_size_x = 1) in;

// The least rank such that it and all above find room for what they want.
void share_room()
{
    uint child = min(level + 1u, LEVELS - 1u);
    uint quads = quad_first[child + 1u] - quad_first[child], vertices = vertex_capacity - vertex_count - even_count;
    bool room = true;
    least_rank = 0u;
    for (uint rank = RANKS; rank-- > 0u;) {
        room = room && wanted_quads[rank] <= quads && wanted_vertices[rank] <= vertices;
        quads -= room ? wanted_quads[rank] : 0u;
        vertices -= room ? wanted_vertices[rank] : 0u;
        least_rank = room ? least_rank : max(least_rank, rank + 1u);
        wanted_quads[rank] = wanted_vertices[rank] = 0u;
    }
}

void main()
{
    if (level > LEVELS) { // after emit.comp: did its fans find room?
        bool room = max(draw_vertices, even_vertices) <= corner_capacity;
        plain_groups[0] = room ? 0u : leaf_groups[0];
        plain_groups[1] = plain_groups[2] = 1u;
        draw_vertices = room ? draw_vertices : 0u;
        even_vertices = room ? even_vertices : 0u;
        return;
    }
    share_room();
    claim_groups[0] = (5u * quad_count[level] + 63u) / 64u;
    leaf_groups[0] = (leaf_count + 63u) / 64u;
    gather_first = gather_end;
    gather_end = vertex_count;
    gather_groups[0] = (gather_end - gather_first + 63u) / 64u;
    even_gather_first = even_gather_end;
    even_gather_end = even_count;
    even_groups[0] = (even_gather_end - even_gather_first + 63u) / 64u;
    split_groups[0] = (quad_count[level] + 63u) / 64u;
    near_groups[0] = near_count;
    claim_groups[1] = claim_groups[2] = gather_groups[1] = gather_groups[2] = even_groups[1] = even_groups[2] = 1u;
    split_groups[1] = split_groups[2] = leaf_groups[1] = leaf_groups[2] = 1u;
    near_groups[1] = near_groups[2] = 1u;
    draw_instances = even_instances = 1u;
    if (level == LEVELS) { // the last time
        counter_add(COUNT_QUADS, leaf_count);
        counter_add(COUNT_VERTICES, gather_end + even_gather_end);
    }
}
