#version 450
#extension GL_GOOGLE_include_directive : require
// claim.comp: vertices for the new quads of a level: an invocation for the centre and for each
// corner. Components whose vertices find no room are left to be lit exactly.
#include "../common/frame.glsl"
#include "hull.glsl"
#include "control.glsl"

layout(local_size_x = 64) in;

layout(set = 0, binding = 2, std430) readonly buffer Links
{
    uvec4 links[];
};
layout(set = 0, binding = 3, std430) readonly buffer Masks
{
    uint masks[];
};
layout(set = 0, binding = 4, std430) buffer Map
{
    uint map[]; // a pixel: 0 no vertex, else 1 more than its place in the list
};
layout(set = 0, binding = 5, std430) buffer EvenMap
{
    uint even_map[];
};
layout(set = 0, binding = 6, std430) writeonly buffer VertexPixels
{
    uint vertex_pixels[];
};
layout(set = 0, binding = 7, std430) buffer Quads
{
    Quad quads[];
};

layout(set = 0, binding = 8, std430) buffer Arguments
{
    uint exact_groups[3];
    uint exact_count;
};
layout(set = 0, binding = 9, std430) writeonly buffer Exact
{
    uint exact_pixels[];
};
layout(set = 0, binding = 10, std430) writeonly buffer Shares
{
    uint shares[]; // see blend.glsl
};

#include "member.glsl"
#include "leave.glsl"

void main()
{
    uint index = gl_GlobalInvocationID.x / 5u, which = gl_GlobalInvocationID.x % 5u;
    if (index >= quad_count[level])
        return;
    index += quad_first[level];
    uint component = quads[index].component, corner = which - 1u;
    if (level == 0u && unpack_rank(quads[index].size) < least_rank) {
        if (which == 0u) {
            leave_to_exact(component, ivec2(0), ivec2(TILE));
            quads[index].component = NONE;
        }
        return;
    }
    ivec2 p = unpack_pixel(quads[index].origin) - tile_origin(component);
    ivec2 size = unpack_size(quads[index].size);
    // a component that is short in one direction needs no more than one vertex across
    bvec2 one = lessThanEqual(size, ivec2(level == 0u ? ONE_VERTEX : 0));
    ivec2 place = size * ivec2(corner & 1u, corner >> 1);
    p += mix(place, size / 2, which == 0u ? bvec2(true) : one);
    uint pixel = claim_vertex(component, p, is_even(quads[index]));
    if (which == 0u)
        quads[index].centre = pixel;
    else
        quads[index].corners[corner] = pixel;
}
