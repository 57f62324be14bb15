#version 450
#extension GL_GOOGLE_include_directive : require
// upsample.comp: single-pass upsampling by radial basis functions (3.1.5). Levels 0 to 2 are
// copied; level 2, and where four share what they see of a half shadow, made smooth. A pixel of a
// larger fragment lies in a triangle of samples: the middle of the sub-fragment that it is in, and
// two neighbours of the 3 x 3 places on a grid from the fragment's top left to the bottom right, the
// right and the lower ones being samples of the fragments there.
#include "fragments.glsl"
#include "radial.glsl"
#include "smooth.glsl"

layout(local_size_x = 16, local_size_y = 8) in;

layout(set = 0, binding = 13, rgba32f) writeonly uniform image2D light_image;

// What is known about a pixel of another fragment; w: 0 where that is nothing. Of another surface
// than s: nothing.
vec4 known(ivec2 pixel, vec4 position, vec3 n)
{
    if (any(greaterThanEqual(uvec2(pixel), view.size.xy)))
        return vec4(0.0);
    vec4 there = texelFetch(position_image, pixel, 0);
    vec3 other = unpack_normal(texelFetch(normal_image, pixel, 0).x);
    float off = abs(dot(there.xyz - position.xyz, n)) / (view.eye.w * position.w);
    if (there.w <= 0.0 || off > 4.0 * plane_limit || distance(n, other) > 2.0 * normal_limit)
        return vec4(0.0);
    vec4 value = vec4(0.0);
    for (uint l = 0u; l <= TOP && value.w == 0.0; l++) {
        value = illumination[fragment_index(l, uvec2(pixel) >> l)];
        value.w = l <= 1u || value.w == DARK ? value.w : 0.0;
    }
    return value;
}

vec3 in_fragment(uint l, ivec2 pixel, vec4 position, vec3 n)
{
    int width = 1 << l, h = width / 2;
    uvec2 fragment = uvec2(pixel) >> l;
    ivec2 first = ivec2(fragment << l), local = pixel - first;
    ivec2 part = local / h;
    vec2 p = vec2(local), at[3], d = p - vec2(part * h + h / 2);
    vec3 values[3];
    at[0] = vec2(part * h + h / 2);
    values[0] = illumination[fragment_index(l - 1u, fragment * 2u + uvec2(part))].rgb;
    bool across = abs(d.x) >= abs(d.y);
    ivec2 side = across ? ivec2(d.x > 0.0, 0) : ivec2(0, d.y > 0.0);
    int count = 1;
    for (int i = 0; i < 2; i++) {
        ivec2 grid = part + side + i * ivec2(!across, across);
        vec4 value = grid == ivec2(1) ? illumination[fragment_index(l, fragment)]
                                      : known(first + grid * h, position, n);
        if (value.w != NOTHING) {
            at[count] = vec2(grid * h);
            values[count++] = value.rgb;
        }
    }
    if (count == 3)
        return radial_three(p, at, values, float(width));
    return count == 2 ? radial_two(p, at[0], at[1], values[0], values[1], float(width)) : values[0];
}

void main()
{
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(gl_GlobalInvocationID.xy, view.size.xy)))
        return;
    vec4 position = texelFetch(position_image, pixel, 0);
    if (position.w <= 0.0)
        return;
    vec4 value = vec4(0.0);
    bool found = false;
    uint l = 0u;
    for (uint i = 0u; i <= TOP && !found; i++) {
        l = i;
        value = illumination[fragment_index(l, uvec2(pixel) >> l)];
        found = value.w == DARK || value.w == FINAL || (l <= 1u && value.w != NOTHING);
    }
    if (value.w == FINAL && l >= 3u) {
        vec3 n = unpack_normal(texelFetch(normal_image, pixel, 0).x);
        value.rgb = in_fragment(l, pixel, position, n);
    }
    if (value.w < 0.0 || (l == 1u && value.w == PART && points == POINTS_BOTH))
        value.rgb = smooth_light(pixel, l, position, value);
    if (found)
        imageStore(light_image, pixel, vec4(value.rgb, 1.0));
}
