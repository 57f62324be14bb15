#version 450
#extension GL_GOOGLE_include_directive : require
// upsample_far.comp: as upsample.comp, with samples that answer for the pixel's own normal: their
// normals matter little for the weights.
#define CONTROL_BINDING 3
#include "../common/frame.glsl"
#include "../hull/hull.glsl"
#include "far.glsl"
#include "block.glsl"
#include "likeness.glsl"

layout(local_size_x = 64) in;

layout(set = 0, binding = 1) uniform sampler2D position_image;
layout(set = 0, binding = 2) uniform usampler2D normal_image;
layout(set = 0, binding = 3, rgba32f) writeonly uniform image2D light_image;
layout(set = 0, binding = 4, std430) readonly buffer Samples
{
    Sample samples[];
};
layout(set = 0, binding = 5, std430) buffer Arguments
{
    uint exact_groups[3];
    uint exact_count; // 1 more than there are
};
layout(set = 0, binding = 6, std430) writeonly buffer Exact
{
    uint exact_pixels[];
};

void main()
{
    int x = int(gl_GlobalInvocationID.x);
    if (x >= int(view.size.x))
        return;
    int half_block = int(factor) / 2;
    float across = float(x - half_block) / float(factor);
    int band = band_first(samples.length());
    ivec2 low = ivec2(int(floor(across)), int(gl_WorkGroupID.y) + band);
    if (low.y >= int(blocks_y))
        return;
    ivec2 most = ivec2(blocks_x, blocks_y) - 1;
    Sample near[4];
    for (int i = 0; i < 4; i++) {
        ivec2 block = clamp(low + ivec2(i & 1, i >> 1), ivec2(0), most);
        near[i] = samples[uint(block.y - band) * blocks_x + uint(block.x)];
    }
    float fx = across - floor(across);
    int first = low.y * int(factor) + half_block;
    int last = min(first + int(factor), int(view.size.y));
    for (int y = max(first, 0); y < last; y++) {
        vec4 position = texelFetch(position_image, ivec2(x, y), 0);
        vec3 n = unpack_normal(texelFetch(normal_image, ivec2(x, y), 0).x);
        float fy = float(y - first) / float(factor);
        float scale = 1.0 / (plane * block_size(position.w));
        vec4 sum = vec4(0.0);
        for (int i = 0; i < 4; i++) {
            float off = dot(near[i].normal.xyz, near[i].position.xyz - position.xyz) * scale;
            float along = dot(n, near[i].normal.xyz);
            float weight = ((i & 1) != 0 ? fx : 1.0 - fx) * (i > 1 ? fy : 1.0 - fy);
            weight *= sample_likeness(off, along);
            weight = near[i].position.w > 0.0 ? weight : 0.0;
            sum += weight * vec4(sample_irradiance(near[i], n)
                                     + smoothstep(0.2, 0.9, along) * near[i].c.xyz, 1.0);
        }
        if (position.w > 0.0) {
            if (sum.w >= least) {
                imageStore(light_image, ivec2(x, y), vec4(max(sum.rgb / sum.w, 0.0), 1.0));
            } else {
                // 0 again: left by an earlier run or not, near lights must not be added to it
                imageStore(light_image, ivec2(x, y), vec4(0.0));
                uint slot = atomicAdd(exact_count, 1u) - 1u;
                exact_pixels[slot] = uint(y) * view.size.x + uint(x);
                atomicMax(exact_groups[0], slot / 64u + 1u);
            }
        }
    }
}
