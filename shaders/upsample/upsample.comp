#version 450
#extension GL_GOOGLE_include_directive : require
// upsample.comp: joint bilateral upsampling. A pixel takes the irradiance of the four samples about
// it, weighted bilinearly, by their distance from its plane and by the cosine of the normals. What
// finds no sample goes to a list and is lit exactly. An invocation does a column of the pixels that
// have the same four samples.
#include "../common/frame.glsl"
#include "sample.glsl"
#include "likeness.glsl"

layout(local_size_x = 64) in;

layout(set = 0, binding = 1) uniform sampler2D position_image;
layout(set = 0, binding = 2) uniform usampler2D normal_image;
layout(set = 0, binding = 3) uniform usampler2D sample_light;
layout(set = 0, binding = 4) uniform sampler2D sample_position;
layout(set = 0, binding = 5, rgba32f) writeonly uniform image2D light_image;
layout(set = 0, binding = 6, std430) buffer Arguments
{
    uint exact_groups[3];
    uint exact_count; // 1 more than there are
};
layout(set = 0, binding = 7, std430) writeonly buffer Exact
{
    uint exact_pixels[];
};

void main()
{
    int x = int(gl_GlobalInvocationID.x);
    if (x >= int(view.size.x))
        return;
    int half_block = int(factor) / 2;
    vec2 across = vec2(float(x - half_block) / float(factor), 0.0);
    ivec2 low = ivec2(int(floor(across.x)), int(gl_WorkGroupID.y) - 1);
    ivec2 most = ivec2(blocks_x, blocks_y) - 1;
    vec4 positions[4];
    vec3 normals[4], lights[4];
    for (int i = 0; i < 4; i++) {
        ivec2 block = clamp(low + ivec2(i & 1, i >> 1), ivec2(0), most);
        uvec4 light = texelFetch(sample_light, block, 0);
        positions[i] = texelFetch(sample_position, block, 0);
        lights[i] = uintBitsToFloat(light.xyz);
        normals[i] = unpack_normal(light.w);
    }
    float fx = across.x - floor(across.x);
    int first = low.y * int(factor) + half_block;
    int last = min(first + int(factor), int(view.size.y));
    for (int y = max(first, 0); y < last; y++) {
        vec4 position = texelFetch(position_image, ivec2(x, y), 0);
        vec3 n = unpack_normal(texelFetch(normal_image, ivec2(x, y), 0).x);
        float fy = float(y - first) / float(factor);
        float scale = 1.0 / (plane * block_size(position.w));
        vec4 sum = vec4(0.0);
        for (int i = 0; i < 4; i++) {
            float off = dot(n, positions[i].xyz - position.xyz) * scale;
            float weight = ((i & 1) != 0 ? fx : 1.0 - fx) * (i > 1 ? fy : 1.0 - fy);
            weight *= sample_likeness(off, dot(n, normals[i]));
            weight = positions[i].w > 0.0 ? weight : 0.0;
            sum += weight * vec4(lights[i], 1.0);
        }
        if (position.w > 0.0) {
            if (sum.w >= least) {
                imageStore(light_image, ivec2(x, y), vec4(sum.rgb / sum.w, 1.0));
            } else {
                uint slot = atomicAdd(exact_count, 1u) - 1u;
                exact_pixels[slot] = uint(y) * view.size.x + uint(x);
                atomicMax(exact_groups[0], slot / 64u + 1u);
            }
        }
    }
}
