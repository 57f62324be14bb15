#version 450
#extension GL_GOOGLE_include_directive : require
// mean_sum.comp: the mean of the samples of mean.comp, in their order; one invocation.
#include "../common/frame.glsl"
#include "control.glsl"

layout(local_size_x = 1) in;

layout(set = 0, binding = 2, std430) readonly buffer Samples
{
    vec2 samples[];
};

void main()
{
    vec2 sum = vec2(1e-20);
    for (uint i = 0u; i < uint(samples.length()); i++)
        sum += samples[i];
    mean = max(sum.x / sum.y, 1e-20);
}
