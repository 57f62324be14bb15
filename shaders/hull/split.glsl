// split.glsl: splits quads of a level whose corners do not predict their centre; the others are
// leaves. The error is that of four corners; with the centre a leaf keeps about a quarter of it.
#include "../common/frame.glsl"
#include "hull.glsl"
#include "control.glsl"
#include "vertex_kind.glsl"

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
layout(set = 0, binding = 5, std430) buffer Quads
{
    Quad quads[];
};
layout(set = 0, binding = 6, std430) readonly buffer Vertices
{
    Vertex vertices[];
};
layout(set = 0, binding = 7, std430) writeonly buffer Leaves
{
    uint leaves[];
};
layout(set = 0, binding = 8) uniform sampler2D position_image;
layout(set = 0, binding = 9) uniform usampler2D normal_image;

#define MEMBER_READ_ONLY
#include "member.glsl"

float split_error(Quad q)
{
    uint centre = vertex_slot(q.centre);
    if (centre == NONE)
        return 0.0;
    ivec2 pixel = unpack_pixel(q.centre);
    vec3 x = texelFetch(position_image, pixel, 0).xyz;
    uvec2 normals = texelFetch(normal_image, pixel, 0).xy;
    vec3 n = unpack_normal(normals.x), face = unpack_normal(normals.y);
    n = dot(n, face) > 0.97 ? n : face;
    Vertex middle = vertex_zero();
    for (int i = 0; i < 4; i++) {
        uint corner = vertex_slot(q.corners[i]);
        if (corner == NONE)
            return 0.0;
        vertex_add(middle, 0.25, vertices[corner]);
    }
    vec3 error = vertex_irradiance(vertices[centre], x, n) - vertex_irradiance(middle, x, n);
    return length(error) * inversesqrt(3.0);
}

void main()
{
    uint index = gl_GlobalInvocationID.x;
    if (index >= quad_count[level])
        return;
    index += quad_first[level];
    Quad q = quads[index];
    if (q.component == NONE)
        return;
    ivec2 size = unpack_pixel(q.size), p = unpack_pixel(q.origin) - tile_origin(q.component);
    ivec2 first = (size / 2 + STEP - 1) / STEP * STEP; // of the two parts, across and down
    uint children = 0u, count = 0u, at = 0u;
    float error = split_error(q);
    if (error < FLAT * split * mean)
        quads[index].size |= FLAT_BIT;
    if (level + 1u < LEVELS && error > split * mean) {
        for (int i = 0; i < 4; i++) {
            ivec2 part = ivec2(i & 1, i >> 1), extent = mix(first, size - first, equal(part, ivec2(1)));
            if (all(greaterThan(extent, ivec2(0)))
                && has_members(q.component, p + part * first, extent))
                children |= 1u << i;
        }
        children = size == first ? 0u : children; // too small for parts
        count = uint(bitCount(children));
        at = atomicAdd(quad_count[level + 1u], count);
        at += quad_first[level + 1u];
        if (at + count > quad_first[level + 2u]) { // no room: it stays as it is
            for (; at < quad_first[level + 2u]; at++)
                quads[at].component = NONE;
            children = 0u;
        }
    }
    if (children == 0u)
        leaves[atomicAdd(leaf_count, 1u)] = index;
    for (int i = 0; i < 4; i++)
        if (bit(children, i)) {
            ivec2 part = ivec2(i & 1, i >> 1);
            quads[at].component = q.component;
            quads[at].origin = pack_pixel(unpack_pixel(q.origin) + part * first);
            quads[at++].size = pack_pixel(mix(first, size - first, equal(part, ivec2(1))));
        }
}
