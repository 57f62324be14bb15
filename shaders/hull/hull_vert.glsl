// hull_vert.glsl: a corner of a triangle of the hull, on the grid of pixels, with its vertex.
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

layout(location = 0) noperspective out Vertex vertex;
layout(location = VERTEX_VECTORS) flat out uint component;

void main()
{
    uvec4 corner = corners[gl_VertexIndex];
    vertex = vertices[corner.x];
    component = corner.z;
    gl_Position = hull_position(corner.y);
}
