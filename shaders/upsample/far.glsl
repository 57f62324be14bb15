// far.glsl: samples that know the light for every normal: its moments up to order 2, and what these
// miss at the sample's own normal. With tau = 0 of all lights, else of the far ones alone.
#ifndef FAR_GLSL
#define FAR_GLSL

struct Sample {
    vec4 red0, green0, blue0; // as in hull/vertex.glsl
    vec4 red1, green1, blue1;
    vec4 b;                   // w: 0
    vec4 c;                   // w: 0
    vec4 normal;              // for which c holds; w: 0
    vec4 position;            // w: view depth, 0 where there is no surface
};

vec3 sample_irradiance(Sample s, vec3 n)
{
    vec4 s0 = vec4(n * n, 2.0 * n.x * n.y), s1 = vec4(2.0 * n.xy * n.z, n.xy);
    return vec3(dot(s.red0, s0) + dot(s.red1, s1), dot(s.green0, s0) + dot(s.green1, s1),
                dot(s.blue0, s0) + dot(s.blue1, s1))
        + s.b.xyz * n.z;
}

#endif
