#version 450
#extension GL_GOOGLE_include_directive : require
// arguments.comp: what a method is asked at every pixel for one light: sharpness, cosine and the
// amplitude's factor, so that the integral can be taken exactly elsewhere.
#include "../common/frame.glsl"
#include "lobes.glsl"

layout(local_size_x = 16, local_size_y = 8) in;

layout(set = 0, binding = 2) uniform sampler2D position_image;
layout(set = 0, binding = 3) uniform usampler2D normal_image;
layout(set = 0, binding = 4, rgba32f) writeonly uniform image2D arguments_image;

layout(push_constant) uniform Push
{
    int light;
};

void main()
{
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(gl_GlobalInvocationID.xy, view.size.xy)))
        return;
    vec4 position = texelFetch(position_image, pixel, 0);
    vec3 normal = unpack_normal(texelFetch(normal_image, pixel, 0).x);
    Incoming incoming = lobe_incoming(lobes[light], position.xyz);
    float strongest = max(max(lobes[light].intensity.r, lobes[light].intensity.g),
                          max(lobes[light].intensity.b, 1e-30));
    float factor = max(max(incoming.amplitude.r, incoming.amplitude.g), incoming.amplitude.b);
    imageStore(arguments_image, pixel,
               vec4(incoming.sharpness, dot(incoming.axis, normal), factor / strongest,
                    position.w > 0.0 ? 1.0 : 0.0));
}
