#version 450
#extension GL_GOOGLE_include_directive : require
// lobes.comp: irradiance of every pixel from all virtual spherical Gaussian lights by one method.
#include "../common/frame.glsl"
#include "../common/method.glsl"
#include "lobes.glsl"

layout(local_size_x = 16, local_size_y = 8) in;

layout(set = 0, binding = 2) uniform sampler2D position_image;
layout(set = 0, binding = 3) uniform usampler2D normal_image;
layout(set = 0, binding = 4, rgba32f) writeonly uniform image2D light_image;

// The cost of everything but a method, as a method of that name.
float sg_A_h_nothing(float lambda, float cos_theta)
{
    return lambda + cos_theta;
}

void main()
{
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(gl_GlobalInvocationID.xy, view.size.xy)))
        return;
    vec4 position = texelFetch(position_image, pixel, 0);
    vec3 normal = unpack_normal(texelFetch(normal_image, pixel, 0).x);
    vec3 sum = vec3(0.0);
    for (int i = 0; i < lobes.length(); i++) {
        Incoming incoming = lobe_incoming(lobes[i], position.xyz);
        sum += incoming.amplitude
            * SG_METHOD_A_h(incoming.sharpness, dot(incoming.axis, normal));
    }
    imageStore(light_image, pixel, position.w > 0.0 ? vec4(sum, 1.0) : vec4(0.0));
}
