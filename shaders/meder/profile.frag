#version 450
#extension GL_GOOGLE_include_directive : require
// profile.frag: what lighting.frag asks the fitted form for one channel: sharpness, cosine, and the
// square of the luminance of the lobe's flux.
#include "fragment.glsl"
#include "../sg.glsl"

layout(push_constant) uniform Push
{
    int channel;
};

layout(location = 0) out vec4 point; // w: 1

void main()
{
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    if (!in_depth_bounds(pixel))
        discard;
    vec3 n = unpack_normal(texelFetch(normal_image, pixel, 0).x);
    vec3 axis = channel == 0 ? red_axis : channel == 1 ? green_axis : blue_axis;
    float cos_theta = dot(axis, n) * inversesqrt(max(dot(axis, axis), 1e-30));
    float luminance = vec3(0.2126, 0.7152, 0.0722)[channel];
    float flux = luminance * amplitude[channel] * sg_integral(sharpness[channel]);
    point = vec4(sharpness[channel], clamp(cos_theta, -1.0, 1.0), flux * flux, 1.0);
}
