#version 450
#extension GL_GOOGLE_include_directive : require
// dump.vert: lighting.vert that also writes down what it made, for pictures and tests.
#include "vertex.glsl"

layout(set = 0, binding = 9, std430) writeonly buffer Records { vec4 records[]; }; // 6 a vertex

void main()
{
    Corner c = corner_of(gl_VertexIndex);
    Lobes lobes = light_corner(c);
    uint first = 6u * uint(gl_VertexIndex);
    records[first] = c.before;
    records[first + 1u] = vec4(c.position, c.corrected ? 1.0 : 0.0);
    for (int i = 0; i < 3; i++)
        records[first + 2u + uint(i)] = vec4(lobes.axis[i], lobes.sharpness[i]);
    records[first + 5u] = vec4(lobes.amplitude, 1.0);
}
