// fragment.glsl: a pixel of a segment's quad: the interpolated lobes, and whether the pixel belongs
// to the segment.
#include "../common/frame.glsl"
#include "meder.glsl"

layout(set = 0, binding = 6) uniform sampler2D depth_image;
layout(set = 0, binding = 7) uniform usampler2D normal_image;
layout(set = 0, binding = 8) uniform usampler2D label_image;

layout(location = 0) in vec3 red_axis;
layout(location = 1) in vec3 green_axis;
layout(location = 2) in vec3 blue_axis;
layout(location = 3) in vec3 sharpness;
layout(location = 4) in vec3 amplitude;
layout(location = 5) flat in uvec3 segment;

// The depth bounds test: fragments whose pixel has a depth outside the segment's are discarded.
// Where the quads of several segments pass it, the one drawn last remains.
bool in_depth_bounds(ivec2 pixel)
{
    float depth = texelFetch(depth_image, pixel, 0).x;
    return depth >= uintBitsToFloat(segment.x) && depth <= uintBitsToFloat(segment.y);
}

// A pixel is part of the segment whose label its texel of the downsampled depth has.
bool owned(ivec2 pixel)
{
    ivec2 texel = texel_of_pixel(pixel, view.size.xy);
    uint label = texelFetch(label_image, texel, 0).x;
    return tile_of_texel(texel) * TEXELS + label == segment.z;
}
