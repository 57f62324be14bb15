// far.glsl: samples that know the light for every normal: its moments up to order 2, order 4 of its luminance,
// and what these miss at the sample's own normal. With tau = 0 of all lights, else of the far ones alone.
#ifndef FAR_GLSL
#define FAR_GLSL

#include "../hull/moments.glsl"

struct Sample {
    vec4 red0, green0, blue0; // as in hull/vertex.glsl
    vec4 red1, green1, blue1;
    vec4 b;                   // w: Fourth.c
    vec4 c;                   // w: spot_of the mean of the colours
    vec4 normal;              // for which c holds; w: 0
    vec4 fourth_a, fourth_b;  // Fourth of the mean of the colours
    vec4 position;            // w: view depth, 0 where there is no surface
};

// Samples are kept of one band of blocks at a time: of this row and those below it; `level` is the band's number,
// count what there is room for. A band upsamples between as many pairs of rows as it has rows, but one.
int band_first(uint count)
{
    return int(level * (count / blocks_x - 1u)) - 1;
}

vec3 sample_axis(Sample s)
{
    return vec3(s.red1.zw + s.green1.zw + s.blue1.zw, s.b.x + s.b.y + s.b.z);
}

vec3 sample_irradiance(Sample s, vec3 n)
{
    vec4 s0 = vec4(n * n, 2.0 * n.x * n.y), s1 = vec4(2.0 * n.xy * n.z, n.xy);
    vec3 moments = vec3(dot(s.red0, s0) + dot(s.red1, s1), dot(s.green0, s0) + dot(s.green1, s1),
                        dot(s.blue0, s0) + dot(s.blue1, s1))
        + s.b.xyz * n.z;
    vec3 color = color_of(vec3(s.red0.x + s.red0.y + s.red0.z, s.green0.x + s.green0.y + s.green0.z,
                               s.blue0.x + s.blue0.y + s.blue0.z));
    return moments
        + color * (fourth_order(Fourth(s.fourth_a, s.fourth_b, s.b.w), n)
                   + higher_orders(s.c.w, sample_axis(s), n));
}

#endif
