#version 450
#extension GL_GOOGLE_include_directive : require
// gbuffer.vert: a corner of a triangle, pulled from the scene's buffers. Also drawn from the
// spotlight, for the reflective shadow map.
#include "../common/frame.glsl"

layout(set = 0, binding = 1, std430) readonly buffer Positions { float positions[]; };
layout(set = 0, binding = 2, std430) readonly buffer Normals { float normals[]; };
layout(set = 0, binding = 3, std430) readonly buffer Indices { uint indices[]; };
layout(set = 0, binding = 4, std430) readonly buffer Materials { uint materials[]; };
layout(set = 0, binding = 5, std430) readonly buffer Albedos { float albedos[]; };

layout(location = 0) out vec3 position;
layout(location = 1) out vec3 normal;
layout(location = 2) flat out vec3 face_normal; // of length 1, or 0 for a triangle without area
layout(location = 3) flat out vec3 albedo;

vec3 corner(uint vertex)
{
    return vec3(positions[3u * vertex], positions[3u * vertex + 1u], positions[3u * vertex + 2u]);
}

void main()
{
    uint triangle = uint(gl_VertexIndex) / 3u;
    uint own = indices[gl_VertexIndex];
    vec3 a = corner(indices[3u * triangle]);
    vec3 b = corner(indices[3u * triangle + 1u]);
    vec3 c = corner(indices[3u * triangle + 2u]);
    position = corner(own);
    normal = vec3(normals[3u * own], normals[3u * own + 1u], normals[3u * own + 2u]);
    vec3 across = cross(b - a, c - a);
    float size = length(across);
    face_normal = size > 0.0 ? across / size : vec3(0.0);
    uint material = materials[triangle];
    albedo = vec3(albedos[3u * material], albedos[3u * material + 1u], albedos[3u * material + 2u]);
    gl_Position = view.clip_from_world * vec4(position, 1.0);
    // not a number or infinite: all of the triangle outside
    if (!(size < 1e30))
        gl_Position = vec4(0.0, 0.0, -1.0, 1.0);
}
