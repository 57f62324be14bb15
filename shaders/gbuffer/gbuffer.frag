#version 450
#extension GL_GOOGLE_include_directive : require
// gbuffer.frag: position, both normals turned to the viewer, albedo.
#include "../common/frame.glsl"

layout(push_constant) uniform Push
{
    uint detailed; // not 0: bumps on the shading normal
};

layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) flat in vec3 face_normal;
layout(location = 3) flat in vec3 albedo;

layout(location = 0) out vec4 position_target; // w: distance along the view axis
layout(location = 1) out uvec2 normal_target;
layout(location = 2) out vec4 albedo_target;

// Slope of a wave over space; wave: direction and 2 pi over the length in metres.
vec3 slope(vec3 wave)
{
    return normalize(wave) * cos(dot(wave, position));
}

// Tilts a normal as a height field of four waves does, 3 to 4 cm long, whatever the surface:
// 22 degrees in the root mean square.
vec3 detailed_normal(vec3 n)
{
    vec3 sum = slope(vec3(104.0, 113.0, 97.0)) + slope(vec3(-121.0, 91.0, -108.0))
        + slope(vec3(118.0, -87.0, -131.0)) + slope(vec3(-93.0, -127.0, 114.0));
    vec3 tangent = sum - dot(sum, n) * n;
    return normalize(n - 0.35 * tangent);
}

void main()
{
    vec3 to_eye = normalize(view.eye.xyz - position);
    float size = length(normal);
    vec3 smooth_normal = size > 0.5 ? normal / size : face_normal;
    vec3 face = dot(face_normal, face_normal) > 0.5 ? face_normal : smooth_normal;
    face = dot(face, face) > 0.5 ? face : to_eye;
    face = dot(face, to_eye) < 0.0 ? -face : face;
    vec3 shading = dot(smooth_normal, smooth_normal) > 0.5 ? smooth_normal : face;
    // to the side of the face that is seen, not simply to the eye: at a silhouette a smooth normal
    // may lean a little away from the eye
    shading = dot(shading, face) < 0.0 ? -shading : shading;
    if (detailed != 0u)
        shading = detailed_normal(shading);
    position_target = vec4(position, dot(position - view.eye.xyz, view.forward.xyz));
    normal_target = uvec2(pack_normal(shading), pack_normal(face));
    albedo_target = vec4(albedo, 1.0);
}
