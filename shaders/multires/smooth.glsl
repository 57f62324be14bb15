// smooth.glsl: light that squares of pixels share, each square one value of it, made smooth.
#ifndef SMOOTH_GLSL
#define SMOOTH_GLSL

// An edge lies between values that differ by more than both of
const float SMOOTH_RANGE = 0.5; // of their sum,
const float SMOOTH_STEP = 0.5;  // of what the lights in half shadow would give without
const float SMOOTH_LIT = 0.2;   // of the sum, where no light is in half shadow

// What is known of a pixel, as it is; w: 0 where that is nothing. of: the level that knows it.
vec4 raw_light(ivec2 pixel, out uint of)
{
    vec4 value = vec4(0.0);
    of = 0u;
    for (uint l = 0u; l <= TOP && value.w == NOTHING; l++) {
        value = illumination[fragment_index(l, uvec2(pixel) >> l)];
        of = l;
    }
    return value;
}

// Of the other pixel, by a tent around this one: from pixel to pixel, or between the sampled pixels
// of squares of 2 x 2, the last of each. A square's value is met once for each of its pixels.
float tent(ivec2 pixel, ivec2 other, bool sampled)
{
    vec2 d = abs(vec2(sampled ? (other | 1) - pixel : other - pixel));
    return max(2.0 - d.x, 0.0) * max(2.0 - d.y, 0.0);
}

// Mean of the pixels around, weighted by a tent as wide as two squares: between the middles of
// squares of level 0 and the sampled pixels of those of level 1, what bilinear interpolation gives.
// Only pixels of the same surface, and on the same side of a shadow's edge. Bounded by what it is
// the mean of.
vec3 smooth_light(ivec2 pixel, uint l, vec4 position, vec4 own)
{
    uvec2 packed = texelFetch(normal_image, pixel, 0).xy;
    vec3 n = unpack_normal(packed.x), face = unpack_normal(packed.y);
    int radius = 1 << l;
    float size = view.eye.w * position.w * plane_limit * float(radius);
    float own_sum = own.r + own.g + own.b, range = own.w < 0.0 ? SMOOTH_RANGE : SMOOTH_LIT;
    vec4 sum = vec4(0.0);
    for (int j = -radius; j <= radius; j++)
        for (int i = -radius; i <= radius; i++) {
            ivec2 other = pixel + ivec2(i, j);
            if (any(greaterThanEqual(uvec2(other), view.size.xy)))
                continue;
            vec4 there = texelFetch(position_image, other, 0);
            vec3 m = unpack_normal(texelFetch(normal_image, other, 0).x);
            uint of;
            vec4 value = raw_light(other, of);
            float value_sum = value.r + value.g + value.b;
            bool joins = there.w > 0.0 && value.w != NOTHING && distance(n, m) <= normal_limit
                         && abs(dot(there.xyz - position.xyz, face)) <= size
                         && abs(value_sum - own_sum) <= max(range * (value_sum + own_sum),
                                                            -SMOOTH_STEP * own.w);
            float weight = tent(pixel, other, l == 1u && of == 1u);
            sum += joins ? weight * vec4(value.rgb, 1.0) : vec4(0.0);
        }
    return sum.rgb / sum.w;
}

#endif
