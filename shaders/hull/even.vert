#version 450
#extension GL_GOOGLE_include_directive : require
// even.vert: as hull_vert.glsl for quads with one normal all over: the moments are integrated for it
// here, so that four vectors are all that a pixel interpolates.
#include "../common/frame.glsl"
#include "vertex_kind.glsl"
#include "position.glsl"

layout(set = 0, binding = 1, std430) readonly buffer Corners
{
    uvec4 corners[];
};
layout(set = 0, binding = 2, std430) readonly buffer Vertices
{
    Vertex vertices[];
};
layout(set = 0, binding = 4) uniform usampler2D normal_image;

layout(location = 0) noperspective out vec3 place;       // x_v/2
layout(location = 1) noperspective out vec4 gradients[3]; // of each colour; w: its value there
layout(location = 4) flat out uint component;

void main()
{
    uvec4 corner = corners[gl_VertexIndex];
    ivec2 centre = ivec2(corner.w & 0xffffu, corner.w >> 16);
    Vertex v = vertices[corner.x];
    place = v.place.xyz;
    vec3 here = vertex_irradiance(v, place, unpack_normal(texelFetch(normal_image, centre, 0).x));
    gradients[0] = vec4(v.gradient0.xyz, here.r);
    gradients[1] = vec4(v.gradient1.xyz, here.g);
    gradients[2] = vec4(v.gradient2.xyz, here.b);
    component = corner.z;
    gl_Position = hull_position(corner.y);
}
