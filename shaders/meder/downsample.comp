#version 450
#extension GL_GOOGLE_include_directive : require
// downsample.comp: depth of the G-buffer at 1024 x 1024. The pixel at each texel's centre is taken:
// a mean of depths would lie on no surface.
#include "../common/frame.glsl"
#include "meder.glsl"

layout(local_size_x = 16, local_size_y = 8) in;

layout(set = 0, binding = 1) uniform sampler2D depth_image;
layout(set = 0, binding = 2, r32f) writeonly uniform image2D downsampled_image;

void main()
{
    ivec2 texel = ivec2(gl_GlobalInvocationID.xy);
    float depth = texelFetch(depth_image, pixel_of_texel(texel, view.size.xy), 0).x;
    imageStore(downsampled_image, texel, vec4(depth));
}
