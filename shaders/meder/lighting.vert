#version 450
#extension GL_GOOGLE_include_directive : require
// lighting.vert: light gathering in the vertex stage.
#include "vertex.glsl"

void main()
{
    light_corner(corner_of(gl_VertexIndex));
}
