#version 450
#extension GL_GOOGLE_include_directive : require
// limit.comp: reads the G-buffer and writes the light buffer, nothing else: the least that a pass
// over all pixels can cost.
#include "../common/frame.glsl"

layout(local_size_x = 16, local_size_y = 8) in;

layout(set = 0, binding = 1) uniform sampler2D position_image;
layout(set = 0, binding = 2) uniform usampler2D normal_image;
layout(set = 0, binding = 3, rgba32f) writeonly uniform image2D light_image;

void main()
{
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(gl_GlobalInvocationID.xy, view.size.xy)))
        return;
    vec4 position = texelFetch(position_image, pixel, 0);
    uint normal = texelFetch(normal_image, pixel, 0).x;
    // both are used, or a compiler would leave them unread
    if (position.w > 0.0)
        imageStore(light_image, pixel, vec4(position.xyz * uintBitsToFloat(normal & 1u), 1.0));
}
