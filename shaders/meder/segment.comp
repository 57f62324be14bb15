#version 450
#extension GL_GOOGLE_include_directive : require
// segment.comp: local region segmentation, the paper's Algorithm 1. A work group is a tile, an
// invocation a texel; the four propagations are done by 32 invocations each, a line each.
#include "../common/frame.glsl"
#include "meder.glsl"

layout(local_size_x = 32, local_size_y = 32) in;

layout(set = 0, binding = 1) uniform sampler2D downsampled_image;
layout(set = 0, binding = 2, r32ui) writeonly uniform uimage2D label_image;

layout(push_constant) uniform Push
{
    float threshold; // the paper's t
};

shared float depth[32][32];
shared uint label[32][32];

// Both are passed on from texel to texel, as the pseudocode passes them by reference.
void swap_label(ivec2 at, inout float current, inout uint carried)
{
    float next = depth[at.y][at.x];
    if (abs(current - next) > threshold * (1.0 - current))
        carried = label[at.y][at.x];
    else
        label[at.y][at.x] = carried;
    current = next;
}

// texels is 0 for invocations without a line. They could as well stay outside of a condition, but
// compilers that execute both sides of one (lavapipe's) would make them go along the whole line.
void propagate(ivec2 at, ivec2 onward, int texels)
{
    float current = depth[at.y][at.x];
    uint carried = label[at.y][at.x];
    for (int i = 0; i < texels; i++) {
        swap_label(at, current, carried);
        at += onward;
    }
}

void main()
{
    ivec2 local = ivec2(gl_LocalInvocationID.xy);
    ivec2 texel = ivec2(gl_GlobalInvocationID.xy);
    depth[local.y][local.x] = texelFetch(downsampled_image, texel, 0).x;
    label[local.y][local.x] = gl_LocalInvocationIndex;
    int line = int(gl_LocalInvocationIndex) % 32;
    int texels = gl_LocalInvocationIndex < 32u ? 32 : 0;
    barrier();
    propagate(ivec2(0, line), ivec2(1, 0), texels); // right
    barrier();
    propagate(ivec2(line, 0), ivec2(0, 1), texels); // down
    barrier();
    propagate(ivec2(31, line), ivec2(-1, 0), texels); // left
    barrier();
    propagate(ivec2(line, 31), ivec2(0, -1), texels); // up
    barrier();
    imageStore(label_image, texel, uvec4(label[local.y][local.x]));
}
