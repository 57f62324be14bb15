#version 450
#extension GL_GOOGLE_include_directive : require
#extension GL_KHR_shader_subgroup_arithmetic : require
// count.comp: what was lit, after the frame. A pixel with a surface that no pass has written a
// light value for is uncovered, and marked so.
#define COUNTERS_BINDING 1
#define COUNTERS_SUBGROUP
#include "../common/frame.glsl"
#include "../common/counters.glsl"

layout(local_size_x = 16, local_size_y = 8) in;

layout(set = 0, binding = 2) uniform sampler2D position_image;
layout(set = 0, binding = 3, rgba32f) uniform image2D light_image;

void main()
{
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    float state = 0.0; // as in the light buffer's fourth channel
    if (all(lessThan(gl_GlobalInvocationID.xy, view.size.xy))) {
        vec4 light = imageLoad(light_image, pixel);
        bool surface = texelFetch(position_image, pixel, 0).w > 0.0;
        state = !surface ? 0.0 : light.w == 0.0 ? -1.0 : light.w;
        imageStore(light_image, pixel, vec4(light.rgb, state));
    }
    counter_add_subgroup(COUNT_COVERED, state == 0.0 || state == -1.0 ? 0u : 1u);
    counter_add_subgroup(COUNT_UNCOVERED, state == -1.0 ? 1u : 0u);
    counter_add_subgroup(COUNT_WRONG, state == -2.0 ? 1u : 0u);
}
