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
// of length 1; 0: a triangle without area; not a number: one that is not to be drawn
layout(set = 0, binding = 6, std430) readonly buffer Faces { float faces[]; };

layout(location = 0) out vec3 position;
layout(location = 1) out vec3 normal;
layout(location = 2) flat out vec3 face_normal; // of length 1, or 0 for a triangle without area
layout(location = 3) flat out vec3 albedo;

void main()
{
    uint triangle = uint(gl_VertexIndex) / 3u;
    uint own = 3u * indices[gl_VertexIndex];
    position = vec3(positions[own], positions[own + 1u], positions[own + 2u]);
    normal = vec3(normals[own], normals[own + 1u], normals[own + 2u]);
    face_normal = vec3(faces[3u * triangle], faces[3u * triangle + 1u], faces[3u * triangle + 2u]);
    uint material = 3u * materials[triangle];
    albedo = vec3(albedos[material], albedos[material + 1u], albedos[material + 2u]);
    gl_Position = isnan(face_normal.x) ? vec4(0.0, 0.0, -1.0, 1.0)
                                       : view.clip_from_world * vec4(position, 1.0);
}
