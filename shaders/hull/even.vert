#version 450
#extension GL_GOOGLE_include_directive : require
// even.vert: as hull_vert.glsl for quads with one normal all over, whose vertices know the light at that normal
// alone: four vectors are all that a pixel interpolates.
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
layout(location = 0) noperspective out vec3 place;       // x_v/2
layout(location = 1) noperspective out vec4 gradients[3]; // of each colour; w: its value there
layout(location = 4) flat out uint component;

void main()
{
    uvec4 corner = corners[gl_VertexIndex];
    vec4 x = vertices[corner.x].place; // one by one: every word that is read costs
    vec4 red = vertices[corner.x].gradient0, green = vertices[corner.x].gradient1;
    place = x.xyz;
    gradients[0] = vec4(red.xyz, x.w);
    gradients[1] = vec4(green.xyz, red.w);
    gradients[2] = vec4(vertices[corner.x].gradient2.xyz, green.w);
    component = corner.z;
    gl_Position = hull_position(corner.y);
}
