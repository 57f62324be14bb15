#version 450
#extension GL_GOOGLE_include_directive : require
// dump.frag: the interpolated lobe of the green channel as it is integrated: axis and sharpness.
#include "fragment.glsl"

layout(location = 0) out vec4 lobe;

void main()
{
    if (!in_depth_bounds(ivec2(gl_FragCoord.xy)))
        discard;
    lobe = vec4(green_axis * inversesqrt(max(dot(green_axis, green_axis), 1e-30)), sharpness.g);
}
