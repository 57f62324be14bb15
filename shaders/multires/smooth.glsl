// smooth.glsl: half shadow that squares of pixels share, each square one value of it, made smooth.
#ifndef SMOOTH_GLSL
#define SMOOTH_GLSL

// An edge lies between values that differ by more than both of
const float SMOOTH_RANGE = 0.5; // of their sum,
const float SMOOTH_STEP = 0.25; // of what the lights in half shadow would give without

// What is known of a pixel, as it is; w: 0 where that is nothing.
vec4 raw_light(ivec2 pixel)
{
    vec4 value = vec4(0.0);
    for (uint l = 0u; l <= TOP && value.w == NOTHING; l++)
        value = illumination[fragment_index(l, uvec2(pixel) >> l)];
    return value;
}

// Mean of the pixels around, weighted by a tent as wide as two squares: between the middles of
// squares, what bilinear interpolation gives. Only pixels of the same surface, and on the same side
// of a shadow's edge. Bounded by what it is the mean of.
vec3 smooth_light(ivec2 pixel, int radius, vec4 position, vec4 own)
{
    uvec2 packed = texelFetch(normal_image, pixel, 0).xy;
    vec3 n = unpack_normal(packed.x), face = unpack_normal(packed.y);
    float size = view.eye.w * position.w * plane_limit * float(radius);
    float own_sum = own.r + own.g + own.b;
    vec4 sum = vec4(0.0);
    for (int j = -radius; j <= radius; j++)
        for (int i = -radius; i <= radius; i++) {
            ivec2 other = pixel + ivec2(i, j);
            if (any(greaterThanEqual(uvec2(other), view.size.xy)))
                continue;
            vec4 there = texelFetch(position_image, other, 0);
            vec3 m = unpack_normal(texelFetch(normal_image, other, 0).x);
            vec4 value = raw_light(other);
            float value_sum = value.r + value.g + value.b;
            bool joins = there.w > 0.0 && value.w != NOTHING && distance(n, m) <= normal_limit
                         && abs(dot(there.xyz - position.xyz, face)) <= size
                         && abs(value_sum - own_sum) <= max(SMOOTH_RANGE * (value_sum + own_sum),
                                                         -SMOOTH_STEP * own.w);
            float weight = float((radius + 1 - abs(i)) * (radius + 1 - abs(j)));
            sum += joins ? weight * vec4(value.rgb, 1.0) : vec4(0.0);
        }
    return sum.rgb / sum.w;
}

#endif
