// visibility.glsl: what a light is worth at a place, and what its points weigh there.
#ifndef VISIBILITY_GLSL
#define VISIBILITY_GLSL

#include "changes.glsl"

const float BRIGHT = 0.3; // worth above which a light is looked at by all points

// What may differ where the irradiance is `local` of the image's mean, in parts of what may differ
// where it is the mean or more: pictures show ratios, and noise in shadow like noise in light. dim:
// what counts as dark, over the mean.
float allowance(float local, float dim)
{
    return min((dim + local) / (dim + 1.0), 1.0);
}

const float DIM = 0.02; // for what may differ in a fragment

// Of the points on some squares, those that give a surface light. weight: of all of them together.
uvec2 facing(uint light, Surface s, uvec2 squares, out float weight)
{
    uvec2 left = squares, faced = uvec2(0u);
    weight = 0.0;
    while (any(notEqual(left, uvec2(0u)))) {
        uint square = first_square(left);
        uvec2 rest = without_first(left);
        float one = area_weight(light, point_on(square), s);
        weight += one;
        faced |= one > 0.0 ? left & ~rest : uvec2(0u);
        left = rest;
    }
    trace_gave_up = trace_gave_up || any(notEqual(left, uvec2(0u)));
    return faced;
}

// Weights of the points on a board, and of all.
vec2 weigh(uint light, Surface s, uvec2 board)
{
    vec2 weights = vec2(0.0);
    for (uint i = 0u; i < AREA_POINTS; i++) {
        float one = area_weight(light, point_on(i), s);
        weights += (board[i >> 5] >> (i & 31u) & 1u) != 0u ? vec2(one) : vec2(0.0, one);
    }
    return weights;
}

float over_mean(float value) // the image's mean irradiance
{
    float mean = uintBitsToFloat(work[MEAN].groups[0]);
    return mean > 0.0 ? value / mean : value > 0.0 ? 1e9 : 0.0;
}

// What a light gives without shadow, the mean of the channels over the image's mean irradiance.
float worth_of(uint light, float form)
{
    vec3 open = areas[light].exitance.rgb * form;
    return over_mean((open.r + open.g + open.b) / 3.0);
}

#endif
