#version 450
#extension GL_GOOGLE_include_directive : require
// seed.comp: a quad over its tile for every component.
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
layout(set = 0, binding = 4, std430) readonly buffer Seeds
{
    uint seeds[];
};
layout(set = 0, binding = 5, std430) buffer Map
{
    uint map[]; // a pixel: 0 no vertex, NONE one without a place, else 1 more than its place
};
layout(set = 0, binding = 6, std430) writeonly buffer VertexPixels
{
    uint vertex_pixels[];
};
layout(set = 0, binding = 7, std430) writeonly buffer Quads
{
    Quad quads[];
};

#include "member.glsl"

void main()
{
    uint index = gl_GlobalInvocationID.x;
    if (index >= seed_count)
        return;
    quads[index] = make_quad(seeds[index], ivec2(0), TILE);
    if (index == 0u)
        quad_count[0] = seed_count;
}
