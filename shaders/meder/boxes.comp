#version 450
#extension GL_GOOGLE_include_directive : require
// boxes.comp: the bounding box of each segment. Each texel takes its label as an index into the
// tile's list and widens that box; then the boxes that are not empty move together, in the order of
// their labels. Texels without a surface, which have a depth of 1 and the labels of no others, are
// left out.
#include "../common/frame.glsl"
#include "meder.glsl"

layout(local_size_x = 32, local_size_y = 32) in;

layout(set = 0, binding = 1) uniform sampler2D downsampled_image;
layout(set = 0, binding = 2) uniform usampler2D label_image;
layout(set = 0, binding = 3, std430) writeonly buffer Boxes { Box boxes[]; }; // TEXELS a tile
layout(set = 0, binding = 4, std430) writeonly buffer Counts { uint counts[]; }; // one a tile

shared uint x_low[TEXELS], y_low[TEXELS], z_low[TEXELS];
shared uint x_high[TEXELS], y_high[TEXELS], z_high[TEXELS];
shared uint filled[32];  // a bit for each label
shared uint earlier[32]; // how many bits stand before each word

void main()
{
    uint i = gl_LocalInvocationIndex;
    ivec2 texel = ivec2(gl_GlobalInvocationID.xy);
    x_low[i] = y_low[i] = z_low[i] = 0xffffffffu;
    x_high[i] = y_high[i] = z_high[i] = 0u;
    if (i < 32u)
        filled[i] = 0u;
    barrier();
    float depth = texelFetch(downsampled_image, texel, 0).x;
    uint label = texelFetch(label_image, texel, 0).x;
    if (depth < 1.0) {
        atomicMin(x_low[label], uint(texel.x));
        atomicMin(y_low[label], uint(texel.y));
        atomicMin(z_low[label], floatBitsToUint(depth));
        atomicMax(x_high[label], uint(texel.x));
        atomicMax(y_high[label], uint(texel.y));
        atomicMax(z_high[label], floatBitsToUint(depth));
    }
    barrier();
    bool mine = x_low[i] <= x_high[i];
    if (mine)
        atomicOr(filled[i / 32u], 1u << (i % 32u));
    barrier();
    uint sum = 0u;
    for (uint word = 0u; word < (i < 32u ? i : 0u); word++)
        sum += uint(bitCount(filled[word]));
    if (i < 32u)
        earlier[i] = sum;
    barrier();
    uint before = earlier[i / 32u] + uint(bitCount(filled[i / 32u] & ((1u << (i % 32u)) - 1u)));
    uint tile = tile_of_texel(texel);
    if (mine)
        boxes[tile * TEXELS + before] = Box(uvec2(x_low[i], y_low[i]), uvec2(x_high[i], y_high[i]),
                                            z_low[i], z_high[i], tile * TEXELS + i, 0u);
    if (i == TEXELS - 1u)
        counts[tile] = before + (mine ? 1u : 0u);
}
