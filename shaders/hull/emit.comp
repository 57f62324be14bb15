#version 450
#extension GL_GOOGLE_include_directive : require
// emit.comp: the triangles of every leaf: a fan around its centre, whose rim takes in the vertices
// that smaller neighbours have on it, so that no seam opens between quads of different size. Where a
// component has one normal all over its quads go to a list of their own, for even.vert. Where the
// fans of all leaves found no room, the pass runs again and makes two triangles of each, which
// always do.
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
layout(set = 0, binding = 4, std430) readonly buffer Map
{
    uint map[];
};
layout(set = 0, binding = 5, std430) readonly buffer EvenMap
{
    uint even_map[];
};
layout(set = 0, binding = 6, std430) readonly buffer Quads
{
    Quad quads[];
};
layout(set = 0, binding = 7, std430) readonly buffer Leaves
{
    uint leaves[];
};
layout(set = 0, binding = 8, std430) writeonly buffer Corners
{
    uvec4 corners[]; // vertex, pixel, component; w: 0; three of them a triangle
};
layout(set = 0, binding = 9, std430) writeonly buffer EvenCorners
{
    uvec4 even_corners[];
};

#define MEMBER_READ_ONLY
#include "member.glsl"

const int MOST_STEPS = TILE / STEP;

void write_corner(bool even, uint at, uvec3 corner)
{
    if (even)
        even_corners[at] = uvec4(corner, 0u);
    else
        corners[at] = uvec4(corner, 0u);
}

void main()
{
    uint index = gl_GlobalInvocationID.x;
    if (index >= leaf_count)
        return;
    Quad q = quads[leaves[index]];
    bool flat_quad = (q.size & FLAT_BIT) != 0u, even = is_even(q);
    ivec2 size = unpack_size(q.size);
    ivec2 tile = tile_origin(q.component), p = unpack_pixel(q.origin) - tile;
    uint centre = vertex_slot(q.centre, even), slots[4];
    for (int i = 0; i < 4; i++)
        slots[i] = vertex_slot(q.corners[i], even);
    bool plain = level > LEVELS; // the second time

    // the rim, clockwise from the left top corner
    uint rim[4 * MOST_STEPS], at[4 * MOST_STEPS];
    uint count = 0u;
    for (int side = 0; side < 4; side++) {
        ivec2 from = ivec2(side == 1 || side == 2 ? size.x : 0, side > 1 ? size.y : 0);
        ivec2 along = ivec2(side == 0 ? 1 : side == 2 ? -1 : 0, side == 1 ? 1 : side == 3 ? -1 : 0);
        for (int i = 0; i < ((side & 1) == 0 ? size.x : size.y); i += STEP) {
            ivec2 r = p + from + i * along;
            ivec2 pixel = tile + r;
            uint slot = slots[side == 2 ? 3 : side == 3 ? 2 : side];
            if (i > 0) {
                slot = NONE;
                if (!plain && all(lessThan(pixel, ivec2(view.size.xy))) && is_member(q.component, r))
                    slot = vertex_slot(pack_pixel(pixel), even); // NONE where there is no vertex
            }
            if (i == 0 || slot != NONE) {
                rim[count] = slot;
                at[count++] = pack_pixel(pixel);
            }
        }
    }
    bool two = plain || (count == 4u && flat_quad); // triangles are enough
    uint needed = two ? 6u : 3u * count;
    uint first = even ? atomicAdd(even_vertices, needed) : atomicAdd(draw_vertices, needed);
    if (first + needed > corner_capacity)
        return; // next.comp sees it
    uint middle = pack_pixel(tile + p + size / 2);
    if (two) {
        for (uint i = 0u; i < 6u; i++) {
            uint corner = i < 3u ? i : i == 3u ? 0u : i - 2u;
            write_corner(even, first + i, uvec3(rim[corner], at[corner], q.component));
        }
        return;
    }
    for (uint i = 0u; i < count; i++) {
        uint j = i + 1u < count ? i + 1u : 0u;
        uint to = first + 3u * i;
        write_corner(even, to, uvec3(centre, middle, q.component));
        write_corner(even, to + 1u, uvec3(rim[i], at[i], q.component));
        write_corner(even, to + 2u, uvec3(rim[j], at[j], q.component));
    }
}
