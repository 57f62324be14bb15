#version 450
#extension GL_GOOGLE_include_directive : require
// lighting.frag: integration of the interpolated lobes over the pixel's own hemisphere.
#include "fragment.glsl"
#include "../common/method.glsl"

layout(location = 0) out vec4 light; // irradiance; w: 1, or -2 where a foreign segment lights it

float integrate(vec3 axis, float lambda, float mu, vec3 n)
{
    // interpolation shortens the axis
    float cos_theta = dot(axis, n) * inversesqrt(max(dot(axis, axis), 1e-30));
    // only where no light arrives at any corner is the sharpness 0, which some published forms do
    // not bear
    return mu > 0.0 ? mu * SG_METHOD_A_h(lambda, clamp(cos_theta, -1.0, 1.0)) : 0.0;
}

void main()
{
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    if (!in_depth_bounds(pixel))
        discard;
    vec3 n = unpack_normal(texelFetch(normal_image, pixel, 0).x);
    light = vec4(integrate(red_axis, sharpness.r, amplitude.r, n),
                 integrate(green_axis, sharpness.g, amplitude.g, n),
                 integrate(blue_axis, sharpness.b, amplitude.b, n), owned(pixel) ? 1.0 : -2.0);
}
